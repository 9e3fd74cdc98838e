//! Schemas of questions, answers and reports: `schema/` is up to date, and real lines and a real report are valid.

use std::fs;
use std::time::Duration;

use ancf_conform::{Options, Program, Report, Suite, examine, schemas};
use jsonschema::Validator;
use serde_json::{Value, json};

fn validator(file: &str) -> Validator {
    let (_, schema) = schemas().into_iter().find(|(name, _)| *name == file).unwrap();
    jsonschema::draft202012::new(schema.as_value()).unwrap()
}

#[track_caller]
fn assert_valid(validator: &Validator, instance: &Value) {
    let faults: Vec<String> =
        validator.iter_errors(instance).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn answers_of_the_protocol_are_valid() {
    let answers = validator("answer.schema.json");
    for answer in [
        json!({"hello": {"name": "mine"}}),
        json!({"hello": {"name": "mine", "conventions": {"matrices": "columns", "slopes": ["l/2", "h/2"]}}}),
        json!({"hello": {"name": "mine", "given": true, "quantities": ["1.r", "7.M"], "version": 2}}),
        json!({"id": "1", "value": 0.375}),
        json!({"id": "2", "value": [[0.375, 0.005]]}),
        json!({"id": "3", "not_implemented": true}),
        json!({"id": "4", "error": "l must be over 0"}),
    ] {
        assert_valid(&answers, &answer);
    }
    for other in [
        json!({"hello": {"name": 5}}),
        json!({"hello": {"quantities": "1.r"}}),
        json!({"id": 1, "value": 0.375}),
        json!({"id": "1"}),
        json!({"id": "1", "value": "0.375"}),
        json!({"id": "1", "not_implemented": false}),
        json!({"id": "1", "value": 1.0, "error": "both"}),
        json!({"value": 1.0}),
    ] {
        assert!(!answers.is_valid(&other), "{other} is valid");
    }
}

/// Examines a shell script that keeps all questions, answers zero everywhere, and fails in some ways.
#[cfg(unix)]
#[test]
fn the_questions_and_the_report_of_an_examination_are_valid() {
    let folder = tempfile::tempdir().unwrap();
    let questions = folder.path().join("questions");
    let script = format!(
        r#"echo ready
n=0
while IFS= read -r line; do
  printf '%s\n' "$line" >> '{}'
  case $line in
    *'"hello"'*) printf '%s\n' '{{"hello":{{"name":"zero","given":true,"quantities":["17.lambda","17.mu","16.D","7.M","23.residual","none"]}}}}' ;;
    *)
      id=${{line#*'"id":"'}}; id=${{id%%'"'*}}; n=$((n+1))
      case $n in
        3) printf '{{"id":"%s","value":[[0]]}}\n' "$id" ;;
        4) printf '{{"id":"%s","error":"no idea"}}\n' "$id" ;;
        5) printf '{{"id":"%s","not_implemented":true}}\n' "$id" ;;
        *) printf '{{"id":"%s","value":0.0}}\n' "$id" ;;
      esac ;;
  esac
done
"#,
        questions.display()
    );
    let suite = Suite::embedded().unwrap();
    let mut program = Program::start(&["sh".into(), "-c".into(), script], Duration::from_secs(10)).unwrap();
    let examination = examine(&suite, &mut program, Options::default(), |_| {});
    let report = serde_json::to_value(Report::new(&suite, &examination)).unwrap();
    assert_valid(&validator("report.schema.json"), &report);
    assert_eq!(report["first_wrong"]["quantity"], "17.lambda");
    assert!(report["quantities"].as_array().unwrap().iter().any(|row| !row["faults"].as_array().unwrap().is_empty()));

    let validator = validator("question.schema.json");
    let lines = fs::read_to_string(questions).unwrap();
    let lines: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert!(lines.len() > 100 && lines.iter().any(|line| line.get("given").is_some()), "{}", lines.len());
    lines.iter().for_each(|line| assert_valid(&validator, line));

    // The schemas are strict: nothing but what is described.
    let mut other = report.clone();
    other["verdict"] = json!("bad");
    assert!(!self::validator("report.schema.json").is_valid(&other));
    let mut other = report;
    other["quantities"][0]["digits"] = json!(17);
    assert!(!self::validator("report.schema.json").is_valid(&other));
}

/// A program without an answer to `hello` gets a valid report, too.
#[cfg(unix)]
#[test]
fn the_report_on_a_program_without_hello_is_valid() {
    let suite = Suite::embedded().unwrap();
    let mut program = Program::start(&["false".into()], Duration::from_secs(10)).unwrap();
    let examination = examine(&suite, &mut program, Options::default(), |_| {});
    assert_valid(&validator("report.schema.json"), &serde_json::to_value(Report::new(&suite, &examination)).unwrap());
}
