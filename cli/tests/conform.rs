//! `ancf conform` with faulty programs: they hang, crash and print nonsense.
//!
//! They are shell scripts that answer λ = 0 for (17), which is right where ν = 0.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use ancf_conform::{
    Examination, Fault, GRAPH, InvalidOutcome, MOST_STARTS, Options, Program, Recorded, Reference, Report, Suite,
    Verdict, examine,
};
use serde_json::{Value, json};

const QUANTITY: &str = "17.lambda";
const ANSWER: &str = r#"printf '{"id":"%s","value":0.0}\n' "$id""#;

/// A program: `first` before it listens, `second` in place of its answer to the second question of all.
fn script(folder: &Path, quantities: &str, first: &str, second: &str) -> Vec<String> {
    let once = folder.join("once");
    let text = format!(
        r#"{first}
n=0
while IFS= read -r line; do
  case $line in
    *'"hello"'*) printf '%s\n' '{{"hello":{{"name":"fake","quantities":[{quantities}]}}}}' ;;
    *)
      id=${{line#*'"id":"'}}; id=${{id%%'"'*}}; n=$((n+1))
      if [ $n = 2 ] && [ ! -e '{once}' ]; then : > '{once}'; {second}; else {ANSWER}; fi ;;
  esac
done
"#,
        once = once.display()
    );
    let path = folder.join("program.sh");
    fs::write(&path, text).unwrap();
    vec!["sh".into(), path.display().to_string()]
}

fn lambda(first: &str, second: &str, limit: f64) -> Examination {
    let folder = tempfile::tempdir().unwrap();
    let command = script(folder.path(), &format!("\"{QUANTITY}\""), first, second);
    examined(&command, limit)
}

/// A program that does the same with every question: `answer` may use `$line` and `$id`.
fn always(answer: &str, limit: f64) -> Examination {
    let folder = tempfile::tempdir().unwrap();
    let command = script(folder.path(), &format!("\"{QUANTITY}\""), "", ":");
    let text = fs::read_to_string(&command[1]).unwrap();
    let start = text.find("if [ $n = 2 ]").unwrap();
    let end = text[start..].find("fi ;;").unwrap() + start;
    fs::write(&command[1], format!("{}{answer} {}", &text[..start], &text[end + 3..])).unwrap();
    examined(&command, limit)
}

fn examined(command: &[String], limit: f64) -> Examination {
    let mut program = Program::start(command, Duration::from_secs_f64(limit)).unwrap();
    examine(&Suite::embedded().unwrap(), &mut program, Options::default(), |_| {})
}

fn text_of(examination: &Examination) -> String {
    Report::new(&Suite::embedded().unwrap(), examination).markdown()
}

/// The faults of λ, after making sure that all other cases were asked and judged.
fn faults(examination: &Examination) -> Vec<Fault> {
    let (_, cases) = examination.verdicts.iter().find(|(quantity, _)| *quantity == QUANTITY).unwrap();
    let suite = Suite::embedded().unwrap();
    let mut faults = Vec::new();
    for (n, verdict) in cases {
        let right = suite.cases[*n].values[QUANTITY].numbers[0] == 0.0;
        match verdict {
            Verdict::Pass { .. } => assert!(right),
            Verdict::Wrong(_) => assert!(!right),
            Verdict::Fault(fault) => faults.push(fault.clone()),
            Verdict::NotImplemented => panic!("λ is implemented"),
        }
    }
    assert_eq!(cases.len(), 36);
    assert!(!examination.passes());
    let blame = &examination.blame;
    let first = blame.culprits.first().map(|culprit| culprit.quantity).or(blame.silent.first().copied());
    // A fault that comes once is memory, not a mistake of the equation.
    let is_acquitted = examination.memory.as_ref().is_some_and(|memory| memory.quantities.contains(&QUANTITY));
    assert!(first == Some(QUANTITY) || is_acquitted, "{blame:?}");
    faults
}

#[test]
fn a_program_that_hangs_is_ended_and_started_again() {
    let started = Instant::now();
    let examination = lambda("", "exec sleep 30", 0.5);
    assert_eq!(faults(&examination), [Fault::TimeLimit("0.5 s".into())]);
    assert_eq!(examination.starts, 3, "one more for memory");
    assert!(started.elapsed() < Duration::from_secs(15), "{:?}", started.elapsed());
}

#[test]
fn a_program_that_crashes_is_started_again_and_quoted() {
    let examination = lambda("", "echo 'out of luck' >&2; exit 3", 10.0);
    let faults = faults(&examination);
    let [Fault::Crash(how)] = &faults[..] else { panic!("{faults:?}") };
    assert!(how.contains("exit status: 3") && how.contains("out of luck"), "{how}");
    assert_eq!(examination.starts, 3, "one more for memory");
}

#[test]
fn garbage_nan_and_wrong_shapes_are_results() {
    for (second, expected) in [
        ("echo '{\"result\": 7}'", Fault::Garbage("{\"result\": 7}".into())),
        (r#"printf '{"id":"%s","value":NaN}\n' "$id""#, Fault::NotFinite("1 of its entries".into())),
        (r#"printf '{"id":"%s","value":[[0],[0]]}\n' "$id""#, Fault::Shape("2 × 1; expected a number".into())),
        (r#"printf '{"id":"%s","error":"no idea"}\n' "$id""#, Fault::Error("no idea".into())),
    ] {
        assert_eq!(faults(&lambda("", second, 10.0)), [expected]);
    }
    let faults = faults(&lambda("", r#"printf '{"id":"%s","value":' "$id"; exit 0"#, 10.0));
    let [Fault::Crash(how)] = &faults[..] else { panic!("{faults:?}") };
    assert!(how.contains("exit status: 0; it printed: {\"id\":"), "{how}");
}

#[test]
fn a_message_in_place_of_an_answer_is_shown() {
    let examination = lambda("", "echo 'computing ...'", 1.0);
    assert_eq!(faults(&examination), [Fault::Garbage("computing ...".into())]);
    assert_eq!(examination.starts, 2, "one more for memory");
}

#[test]
fn messages_between_answers_are_skipped_and_reported() {
    let examination = always(&format!("echo \"step $n\"; echo; {ANSWER};"), 5.0);
    assert_eq!((faults(&examination), examination.chatter.first.as_str()), (vec![], "step 1"));
    let text = text_of(&examination);
    assert!(text.contains("on standard output that are not JSON, the first: `step 1`"), "{text}");
    // A slow answer behind a message is waited for.
    assert_eq!(faults(&lambda("", &format!("echo 'computing ...'; sleep 1; {ANSWER}"), 5.0)), []);
}

#[test]
fn a_banner_before_hello_is_passed_over() {
    let examination = lambda("echo 'welcome to mine'; echo '[1, 2]'", ANSWER, 5.0);
    // Two lines at each of two starts.
    assert_eq!((faults(&examination), examination.chatter.lines), (vec![], 4));
}

#[test]
fn a_program_that_never_speaks_json_has_no_kind_of_mistake() {
    let started = Instant::now();
    let examination = always("printf \"id=%s, value=0.0\\n\" \"$id\";", 1.0);
    let faults = faults(&examination);
    assert_eq!(faults.len(), 36);
    assert!(faults.iter().all(|fault| matches!(fault, Fault::Garbage(line) if line.starts_with("id=17"))));
    // The first time it has all its time, then it is known.
    assert!(started.elapsed() < Duration::from_secs(10), "{:?}", started.elapsed());
    let text = text_of(&examination);
    assert!(
        text.contains("**It answers no numbers for `17.lambda`: no answer but another line.** The first: "),
        "{text}"
    );
    assert!(!text.contains("Explained by") && !text.contains("known mistake"), "{text}");
}

#[test]
fn crashes_are_no_evidence_of_a_kind_nor_against_one() {
    // λ = 0, and it ends at the second question.
    let examination = lambda("", "exit 9", 5.0);
    let diagnosis = &examination.diagnoses[QUANTITY];
    assert_eq!(diagnosis.without_numbers.iter().collect::<Vec<_>>(), [(&"ended", &1)]);
    assert_eq!(diagnosis.mistakes[0].what, "λ = 0");
    let text = text_of(&examination);
    assert!(
        text.contains("It answers no numbers in 1 of 25 failing cases: ended in 1. Explained by: ν in the"),
        "{text}"
    );
}

#[test]
fn a_hang_at_an_invalid_state_is_reported_separately() {
    let examination = always(&format!("case $line in *'\"nu\":0.5,'*) exec sleep 30 ;; esac; {ANSWER};"), 0.5);
    let text = text_of(&examination);
    for part in [
        "\nNeither refused nor answered: `poisson-half`, asked for 17.lambda: no answer within 0.5 s; `nu` is invalid",
        "\nNot refused: `poisson-beyond-half`, asked for 17.lambda: it answered a value; `nu` is invalid",
        "1 of 26 states that must be refused got a value. 1 of 26 states that must be refused got no answer.",
    ] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
}

/// A program with prepared answers to all questions: the first round, the invalid states, and the second round with given values, in which
/// everything is asked again. `answer` receives the quantity, its reference value, and whether it is the second round.
fn prepared(given: bool, answer: impl Fn(&str, &Reference, bool) -> Value) -> Examination {
    let suite = Suite::embedded().unwrap();
    let round = |again: bool| {
        let nodes = GRAPH.iter().filter(move |node| !again || !node.given.is_empty());
        let mut answers = Vec::new();
        for node in nodes {
            let behind = if again { "/given" } else { "" };
            let rights = suite.cases.iter().filter_map(|case| Some((&case.id, case.values.get(node.quantity)?)));
            answers.extend(rights.map(|(case, right)| {
                (format!("{}/{case}{behind}", node.quantity), answer(node.quantity, right, again))
            }));
        }
        answers
    };
    let mut answers = round(false);
    answers.extend(suite.invalid.iter().map(|case| (format!("{}/{}", case.equation, case.id), json!({"error": "no"}))));
    if given {
        answers.extend(round(true));
    }
    let mut text = format!("{}\n", json!({"hello": {"name": "prepared", "given": given}}));
    for (id, mut answer) in answers {
        answer["id"] = id.into();
        text += &format!("{answer}\n");
    }
    let mut recorded = Recorded::default();
    recorded.read(&suite, &text, "prepared").unwrap();
    examine(&suite, &mut recorded, Options::default(), |_| {})
}

/// Nested lists with every number changed.
fn mapped(value: &Value, change: &dyn Fn(f64) -> Value) -> Value {
    match value {
        Value::Array(items) => items.iter().map(|item| mapped(item, change)).collect(),
        number => change(number.as_f64().unwrap()),
    }
}

#[test]
fn a_program_that_is_wrong_everywhere_gets_its_report_at_once() {
    let started = Instant::now();
    let examination = prepared(true, |_, right, again| {
        let more = if again { 0.2 } else { 0.1 };
        json!({"value": mapped(&right.json, &|x| json!(2.0 * x + more))})
    });
    let text = text_of(&examination);
    assert!(examination.blame.culprits.len() > 40, "{}", examination.blame.culprits.len());
    assert!(text.contains("**First wrong equation: (4), `4.nodes`.**"), "{text}");
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
}

#[test]
fn errors_and_other_shapes_everywhere_are_no_equations_mistakes() {
    let flat = |right: &Reference| json!({"value": [right.numbers, vec![0.0; right.numbers.len()]]});
    let strings = |right: &Reference| json!({"value": mapped(&right.json, &|x| json!(x.to_string()))});
    type Answer<'a> = &'a dyn Fn(&Reference) -> Value;
    let answers: [(Answer, &str); 4] = [
        (
            &|_| json!({"error": "TypeError: oops"}),
            ": an error.** The first: `rest-horizontal`: error: TypeError: oops.",
        ),
        (&|_| json!({"value": []}), ": another shape.** The first:"),
        (&flat, ": another shape.** The first:"),
        (&strings, "not nested lists of numbers"),
    ];
    for (answer, part) in answers {
        let examination = prepared(false, |_, right, _| answer(right));
        let text = text_of(&examination);
        assert_eq!((examination.blame.culprits.len(), examination.blame.silent.len()), (0, GRAPH.len()), "{text}");
        assert!(examination.diagnoses.is_empty() && !examination.passes());
        assert!(text.contains("**It answers no numbers for any of 77 quantities: ") && text.contains(part), "{text}");
        assert!(!text.contains("Explained by") && !text.contains("wrong equation"), "{text}");
    }
}

#[test]
fn another_shape_of_one_quantity_excuses_no_other() {
    let examination = prepared(false, |quantity, right, _| match quantity {
        "20.K" => json!({"value": right.numbers}),
        "19.Q_e" => json!({"value": mapped(&right.json, &|x| json!(2.0 * x))}),
        _ => json!({"value": right.json}),
    });
    let text = text_of(&examination);
    for part in [
        "**It answers no numbers for `20.K`: another shape.** The first: ",
        "196; expected 14 × 14. Whether its equation is wrong is unknown.",
        "**First wrong equation: (19), `19.Q_e`.**",
        "so the mistake may be there: 20.K.",
    ] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
}

#[test]
fn a_line_without_an_end_is_not_read_again_and_again() {
    let started = Instant::now();
    let examination = always("exec tr '\\0' '[' < /dev/zero;", 20.0);
    let (_, cases) = examination.verdicts.iter().find(|(quantity, _)| *quantity == QUANTITY).unwrap();
    assert!(matches!(&cases[0].1, Verdict::Fault(Fault::Endless(_))), "{:?}", cases[0]);
    assert!(cases[1..].iter().all(|(_, verdict)| matches!(verdict, Verdict::Fault(Fault::NotAsked(_)))));
    assert!(started.elapsed() < Duration::from_secs(30), "{:?}", started.elapsed());
    let text = text_of(&examination);
    assert!(text.contains("`17.lambda`: a line without an end.** The first:"), "{text}");
}

#[test]
fn what_a_program_starts_ends_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("grandchild");
    lambda("", &format!("sleep 300 & echo $! > '{}'; wait", file.display()), 0.5);
    let id = fs::read_to_string(&file).unwrap();
    let status = fs::read_to_string(format!("/proc/{}/stat", id.trim())).unwrap_or_default();
    let runs = Command::new("kill").args(["-0", id.trim()]).output().unwrap().status.success();
    // Where nobody reaps orphans it stays as a zombie.
    assert!(!runs || status.contains(") Z "), "{id}: {status}");
}

#[test]
fn a_hundred_messages_before_an_answer_are_passed_over() {
    let lines = |n: usize| format!("i=0; while [ $i -lt {n} ]; do echo step; i=$((i+1)); done; {ANSWER}");
    assert_eq!(faults(&lambda("", &lines(100), 10.0)), []);
    assert_eq!(faults(&lambda("", &lines(101), 10.0)), [Fault::Garbage("step".into())]);
}

#[test]
fn unknown_names_in_hello_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let command = script(folder.path(), "\"17.lambda\",\"1.R\",\"99.zz\"", "", ANSWER);
    let examination = examined(&command, 10.0);
    let text = text_of(&examination);
    assert!(text.contains("Its hello lists names that are not asked for: `1.R`, `99.zz`."), "{text}");
    assert_eq!(Report::new(&Suite::embedded().unwrap(), &examination).program.unknown, ["1.R", "99.zz"]);
    let command = ["sh", "-c", "echo '{\"hello\": 5}'; cat"].map(String::from);
    let Err(Fault::Garbage(message)) = examined(&command, 10.0).hello else { panic!() };
    assert!(message.contains("`hello` must be an object"), "{message}");
}

#[test]
fn a_late_answer_and_a_second_one_are_passed_over() {
    // Twice the answer: the second copy comes when the next question waits.
    assert_eq!(faults(&lambda("", &format!("{ANSWER}; {ANSWER}"), 10.0)), []);
}

#[test]
fn a_slow_start_is_no_hang_and_standard_error_never_blocks() {
    let noise = "i=0; while [ $i -lt 3000 ]; do echo 'a line of a hundred bytes that says nothing at all, again and again and again, to whom it may' >&2; i=$((i+1)); done";
    assert_eq!(faults(&lambda(&format!("sleep 1; {noise}"), &format!("{noise}; {ANSWER}"), 5.0)), []);
    let examination = lambda("sleep 1", ANSWER, 0.9);
    assert_eq!((faults(&examination), examination.starts), (vec![], 2), "one more for memory");
}

#[test]
fn a_program_that_closes_its_input_is_noticed() {
    let started = Instant::now();
    let examination = lambda("", &format!("exec <&-; {ANSWER}; exec sleep 20"), 10.0);
    let faults = faults(&examination);
    assert!(matches!(&faults[..], [Fault::Crash(how)] if how.contains("no longer reads")), "{faults:?}");
    assert!(started.elapsed() < Duration::from_secs(8), "{:?}", started.elapsed());
}

#[test]
fn a_program_that_always_crashes_is_given_up() {
    let folder = tempfile::tempdir().unwrap();
    let all: Vec<String> = GRAPH.iter().map(|node| format!("\"{}\"", node.quantity)).collect();
    let command = script(folder.path(), &all.join(","), "", ":");
    fs::write(&command[1], fs::read_to_string(&command[1]).unwrap().replace("n=$((n+1))", "exit 1")).unwrap();
    let examination = examined(&command, 5.0);
    assert_eq!(examination.starts, MOST_STARTS);
    let verdicts: Vec<&Verdict> =
        examination.verdicts.iter().flat_map(|(_, cases)| cases.iter().map(|c| &c.1)).collect();
    assert!(verdicts.iter().all(|verdict| verdict.fails()));
    let given_up = |why: &str| {
        verdicts.iter().any(|v| matches!(v, Verdict::Fault(Fault::NotAsked(reason)) if reason.contains(why)))
    };
    assert!(given_up("3 times before") && given_up(&format!("started {MOST_STARTS} times")));
    let text = text_of(&examination);
    for part in ["`4.nodes`, ", ": ended.** The first: ", ": not asked any more.** The first: "] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
}

#[test]
fn invalid_states_are_asked_for_and_reported() {
    let examination = lambda("", ANSWER, 10.0);
    let suite = Suite::embedded().unwrap();
    for (invalid, verdict) in suite.invalid.iter().zip(&examination.invalid) {
        let asked = invalid.equation == QUANTITY;
        let expected = if asked { InvalidOutcome::Accepted } else { InvalidOutcome::NotImplemented };
        assert_eq!(verdict.outcome, expected, "{}", invalid.id);
    }
    let text = text_of(&examination);
    assert!(text.contains("Not refused: `poisson-half`, asked for 17.lambda: it answered a value"), "{text}");
}

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn the_command_writes_a_report_and_ends_with_1() {
    let folder = tempfile::tempdir().unwrap();
    let command = script(folder.path(), "\"17.lambda\",\"17.mu\"", "", ANSWER);
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures");
    let output = ancf(folder.path(), &["conform", "--fixtures", fixtures, "--", &command[0], &command[1]]);
    let (text, message) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("the program does not conform: 0 quantities pass, 2 fail"), "{message}");
    for part in [
        "## Conformance of fake",
        "**First wrong equation: (17), `17.lambda`.** It depends on the state alone.",
        "ν in the wrong place (λ = 0)",
        "**Also wrong by itself: (17), `17.mu`.**",
        "Only in states tagged nu.",
        "| 17.lambda | **fail** | 12 / 36 / 36 | 0.7 | `rest-vertical`: 0, expected 1500 |",
        "Not implemented: 75 quantities: (4), ",
    ] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
    let report: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out/conformance.json")).unwrap()).unwrap();
    assert_eq!(report["first_wrong"]["quantity"], "17.lambda");
    assert_eq!(report["culprits"].as_array().unwrap().len(), 2);
    assert_eq!(report["fixtures"]["equations.json"], "1.3");
    assert_eq!(report["tags"]["rest"]["pass"], 2);
}

#[test]
fn a_command_that_cannot_be_used_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, code, part) in [
        (&["conform"][..], 2, "COMMAND"),
        (&["conform", "--", "./no-such-program"], 2, "cannot start the command `./no-such-program`"),
        (&["conform", "--fixtures", "nowhere", "--", "true"], 2, "cannot read nowhere/equations.json"),
        (&["conform", "--time-limit", "0", "--", "true"], 2, "allowed: a number over 0 and up to 3600"),
        (&["conform", "--digits", "17", "--", "true"], 2, "17 is not in 1..=16"),
    ] {
        let output = ancf(folder.path(), arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {message}");
        assert!(message.contains(part), "no {part:?} in: {message}");
        assert!(!folder.path().join("out/conformance.json").exists());
    }
}

#[test]
fn a_program_without_hello_gets_a_report_in_which_everything_fails() {
    let folder = tempfile::tempdir().unwrap();
    let exits = folder.path().join("exits.sh");
    fs::write(&exits, "echo 'no licence' >&2; exit 4").unwrap();
    let exits = exits.display().to_string();
    for (arguments, part) in [
        (
            &["conform", "--", "sh", &exits][..],
            "did not answer hello: the program ended: exit status: 4; last line of standard error: no licence",
        ),
        (
            &["conform", "--", "echo", "good morning"],
            "did not answer hello: the program ended: exit status: 0; it printed: good morning",
        ),
    ] {
        let output = ancf(folder.path(), arguments);
        let (text, message) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {message}");
        assert!(message.contains(part) && text.contains(part), "no {part:?} in: {message}\n{text}");
        assert!(!text.contains("First wrong equation") && !text.contains("refused"), "{text}");
        let report = folder.path().join("out/conformance.json");
        let found: Value = serde_json::from_str(&fs::read_to_string(&report).unwrap()).unwrap();
        assert_eq!((found["passes"].clone(), found["first_wrong"].clone()), (Value::Bool(false), Value::Null));
        assert!(found["quantities"].as_array().unwrap().iter().all(|row| row["fail"].as_u64() > Some(0)));
        assert!(found["program"]["no_hello"].as_str().unwrap().contains("exit status"), "{}", found["program"]);
        fs::remove_file(report).unwrap();
    }
}

/// The adapter in another language: what it has is right, the rest it says that it does not have.
#[test]
fn the_partial_adapter_in_javascript_passes() {
    if Command::new("node").arg("--version").output().is_err() {
        eprintln!("skipped: node (JavaScript) is not installed");
        return;
    }
    let adapter = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures/adapters/shape.mjs");
    let examination = examined(&["node".into(), adapter.into()], 20.0);
    assert!(examination.passes(), "{:?}", examination.blame);
    assert_eq!(examination.implemented(), 8);
}

/// Whatever a program does in place of an answer: the time limit of the question ends it, and all others are asked.
#[test]
fn the_time_limit_holds_whatever_comes() {
    let behaviours = [
        ("bytes that dribble", "while :; do printf x; sleep 0.02; done"),
        ("a line that does not end", "exec tr '\\0' '[' < /dev/zero"),
        ("empty lines", "exec yes ''"),
        ("answers to another question", r#"exec yes '{"id":"0","value":1}'"#),
        ("messages", "exec yes step"),
        ("lines of errors", "exec yes >&2"),
        ("an endless line of errors", "exec tr '\\0' x < /dev/zero >&2"),
        ("a deaf ear", "exec sleep 60 < /dev/null"),
        ("a child that keeps its pipes", "sleep 60 & exit 0"),
        ("a child of its own session that keeps its pipes", "setsid sleep 20 & exit 0"),
    ];
    std::thread::scope(|scope| {
        for (what, second) in behaviours {
            scope.spawn(move || {
                let started = Instant::now();
                let found = faults(&lambda("", second, 0.4));
                println!("{what}: {:?}, {:?}", started.elapsed(), found.first());
                assert!(!found.is_empty(), "{what} is no answer");
                assert!(started.elapsed() < Duration::from_secs(15), "{what}: {:?}", started.elapsed());
            });
        }
    });
}

#[test]
fn a_program_that_answers_some_cases_only_is_partly_checked() {
    let folder = tempfile::tempdir().unwrap();
    let command = script(folder.path(), &format!("\"{QUANTITY}\""), "", ":");
    // λ = 0 is right where ν = 0; elsewhere it is "not implemented".
    let some = format!(
        r#"case $line in *'"nu":0.0'*) {ANSWER} ;; *) printf '{{"id":"%s","not_implemented":true}}\n' "$id" ;; esac ;;"#
    );
    let text = fs::read_to_string(&command[1]).unwrap();
    let (start, end) = (text.find("if [ $n = 2 ]").unwrap(), text.find("fi ;;").unwrap() + 5);
    fs::write(&command[1], format!("{}{some}{}", &text[..start], &text[end..])).unwrap();

    let output = ancf(folder.path(), &["conform", "--", &command[0], &command[1]]);
    let (text, message) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(3), "{message}");
    let headline = text.lines().nth(2).unwrap();
    assert!(headline.starts_with("**Partly checked: right where it answers"), "{headline}");
    assert!(headline.contains("1 quantities pass, 0 fail"), "{headline}");
    assert!(headline.contains("12 of 36 cases of `17.lambda`"), "{headline}");
    assert!(message.contains("only partly checked") && message.contains("`--allow-partial`"), "{message}");
    assert!(text.contains("| 17.lambda | **partly checked** | 12 / 12 / 36 |"), "{text}");
    let report: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out/conformance.json")).unwrap()).unwrap();
    assert_eq!(report["partly_checked"][0], json!({"quantity": "17.lambda", "checked": 12, "of": 36}));

    let output = ancf(folder.path(), &["conform", "--allow-partial", "--", &command[0], &command[1]]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn what_a_program_says_commands_no_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("program.sh");
    let name = r#"{"hello":{"name":"\u001b[2Jmine<script>\u202e","quantities":["\u001b]0;x\u0007"]}}"#;
    fs::write(&path, format!("read line; printf '%s\\n' '{name}'; printf '\\033[31mred\\n'; exec cat > /dev/null"))
        .unwrap();
    let output = ancf(folder.path(), &["conform", "--", "sh", &path.display().to_string()]);
    let report = fs::read_to_string(folder.path().join("out/conformance.md")).unwrap();
    for text in [String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap(), report] {
        assert!(!text.contains(['\u{1b}', '\u{7}', '\u{202e}']) && !text.contains("<script>"), "{text:?}");
    }
    // Nor does a word of the command line.
    let message = ancf(folder.path(), &["conform", "--", "\u{1b}[2Jprogram"]).stderr;
    assert!(String::from_utf8(message).unwrap().contains("cannot start the command `\\u{1b}[2Jprogram`"));
}

/// A program in a shell script of its own: `body` answers, and may use `$line` and `$id`.
fn program(folder: &Path, hello: &str, body: &str) -> [String; 2] {
    let text = format!(
        r#"while IFS= read -r line; do
  case $line in
    *'"hello"'*) {hello} ;;
    *) id=${{line#*'"id":"'}}; id=${{id%%'"'*}}; {body} ;;
  esac
done
"#
    );
    let path = folder.join("own.sh");
    fs::write(&path, text).unwrap();
    ["sh".into(), path.display().to_string()]
}

const HELLO: &str = r#"printf '{"hello":{"name":"own","quantities":["17.lambda"]}}\n'"#;

/// λ = 0, right where ν = 0, in spellings that are not JSON: right, with a remark.
#[test]
fn answers_that_are_almost_json_are_read_and_the_trouble_is_named() {
    let folder = tempfile::tempdir().unwrap();
    for (answer, what, advice) in [
        (r#"printf '{"id":"%s","value":0.0D+00}\n' "$id""#, "Fortran's exponents", "Write an E for the D"),
        (r#"printf '{"id":"%s","value":.0}\n' "$id""#, "a leading dot or a trailing dot", "0.5, 1.0"),
        (r#"printf '{"id":"%s","value":0.}\n' "$id""#, "a leading dot or a trailing dot", "0.5, 1.0"),
        (r#"printf '{"id":"%s","value":+0.0}\n' "$id""#, "numbers with a plus sign", "Leave the plus sign out"),
        (r#"printf '{"id":"%s","value":0.0,}\n' "$id""#, "a comma behind the last entry", "between entries only"),
        (r#"printf "{'id': '%s', 'value': 0.0}\n" "$id""#, "strings in single quotes", "json.dumps"),
        (r#"printf '{\n "id":"%s",\n "value":\n  0.0\n}\n' "$id""#, "answers over several lines", "on one line"),
        (r#"printf '{"id":"%s","value":0.0}{"id":"x","value":1}\n' "$id""#, "several answers on a line", "line feed"),
        (r#"printf '>> {"id":"%s","value":0.0}\n' "$id""#, "other text on the line of an answer", "standard error"),
        (r#"printf '\357\273\277{"id":"%s","value":0.0}\n' "$id""#, "a byte order mark", "without a byte order mark"),
    ] {
        let [sh, path] = program(folder.path(), HELLO, answer);
        let output = ancf(folder.path(), &["conform", "--state", "rest-horizontal", "--", &sh, &path]);
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(0), "{answer}: {}{text}", String::from_utf8_lossy(&output.stderr));
        assert!(text.contains(&format!("Form: {what}")) || text.contains(what), "no {what:?} in:\n{text}");
        assert!(text.contains(advice), "no {advice:?} in:\n{text}");
    }
    let [sh, path] = program(folder.path(), HELLO, r#"printf '{"id":"%s","value":0.0}\r\n' "$id""#);
    let text = ancf(folder.path(), &["conform", "--state", "rest-horizontal", "--", &sh, &path]).stdout;
    assert!(!String::from_utf8(text).unwrap().contains("Form:"));
}

/// All output comes when the input ends, as from a pipe that is buffered.
#[test]
fn a_program_that_does_not_flush_is_named_as_such() {
    let folder = tempfile::tempdir().unwrap();
    for (body, part) in [
        (r#"held="$held{\"id\":\"$id\",\"value\":0.0}\n""#, "it does not flush its output, or took"),
        (r#"printf '{"id":"%s","value":0.0}' "$id""#, "its line does not end"),
    ] {
        let [sh, path] = program(folder.path(), HELLO, body);
        let end = fs::read_to_string(&path).unwrap() + "printf \"$held\"\n";
        fs::write(&path, end).unwrap();
        let arguments = ["conform", "--state", "rest-horizontal", "--time-limit", "0.3", "--", &sh, &path];
        let output = ancf(folder.path(), &arguments);
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(1), "{text}");
        assert!(
            text.contains("no answer until its input was closed") && text.contains(part),
            "no {part:?} in:\n{text}"
        );
    }
}

#[test]
fn another_id_is_named_when_time_is_over() {
    let folder = tempfile::tempdir().unwrap();
    let [sh, path] = program(folder.path(), HELLO, r#"printf '{"id":"0","value":0.0}\n'"#);
    let arguments = ["conform", "--state", "rest-horizontal", "--time-limit", "0.3", "--", &sh, &path];
    let text = String::from_utf8(ancf(folder.path(), &arguments).stdout).unwrap();
    assert!(text.contains("but one with the id") && text.contains("letter by letter"), "{text}");
}

/// Nothing takes the place of a pipe or of a link.
#[cfg(unix)]
#[test]
fn questions_go_into_pipes_and_through_links() {
    use std::os::unix::fs::{FileTypeExt, symlink};

    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    let write = |name: &str| {
        let output = ancf(folder.path(), &["conform", "--only", "17.mu", "--questions", name]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    };
    assert!(std::process::Command::new("mkfifo").arg(place("pipe")).status().unwrap().success());
    let pipe = place("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    write("pipe");
    assert!(fs::symlink_metadata(place("pipe")).unwrap().file_type().is_fifo());
    assert!(reader.join().unwrap().lines().count() > 30);

    fs::write(place("target.jsonl"), "").unwrap();
    symlink("target.jsonl", place("link.jsonl")).unwrap();
    write("link.jsonl");
    assert!(fs::symlink_metadata(place("link.jsonl")).unwrap().is_symlink());
    assert!(fs::read_to_string(place("target.jsonl")).unwrap().lines().count() > 30);
}

#[test]
fn questions_are_written_and_answers_of_files_judged() {
    let folder = tempfile::tempdir().unwrap();
    let output = ancf(folder.path(), &["conform", "--only", "17", "--questions", "questions.jsonl"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let questions = fs::read_to_string(folder.path().join("questions.jsonl")).unwrap();
    let questions: Vec<Value> = questions.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert!(questions[0]["hello"]["quantities"]["21.K_3"]["from"][0] == "8.epsilon_T", "{}", questions[0]);
    assert!(questions[1..].iter().any(|question| question["id"] == "17.mu/rest-vertical"));
    let answer = |question: &Value| {
        let number = |key: &str| question["state"][key].as_f64().unwrap_or(f64::NAN);
        let (e, nu) = (number("E"), number("nu"));
        let value = match question["equation"].as_str().unwrap() {
            "17.mu" => e / (2.0 * (1.0 + nu)),
            _ => 2.0 * e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
        };
        json!({"id": question["id"], "value": value}).to_string() + "\n"
    };
    // Without the last question, from behind.
    let answers: String = questions[1..].iter().rev().map(answer).collect();
    fs::write(folder.path().join("answers.jsonl"), &answers).unwrap();
    let output = ancf(folder.path(), &["conform", "--only", "17", "--answers", "answers.jsonl"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("**First wrong equation: (17), `17.lambda`.**") && text.contains("ratio 2"), "{text}");
    assert!(text.contains("Conformance of answers.jsonl"), "{text}");

    let right = answers.lines().filter(|line| line.contains("17.mu/r")).map(|line| format!("{line}\n"));
    fs::write(folder.path().join("part.jsonl"), right.collect::<String>() + "{\"id\":\"18.mu/none\",\"value\":1}\n")
        .unwrap();
    let arguments = ["conform", "--only", "17.mu", "--answers", "part.jsonl", "--questions", "open.jsonl"];
    let output = ancf(folder.path(), &arguments);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(3), "{text}");
    for part in ["Form: questions without an answer", "Form: answers to questions that are not asked, 1 time(s)"] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
    let open = fs::read_to_string(folder.path().join("open.jsonl")).unwrap();
    assert!(open.lines().count() > 1 && !open.contains("17.mu/rest-vertical"), "{open}");

    fs::write(folder.path().join("old.jsonl"), r#"{"hello":{"fixtures":{"equations.json":"0.1"}}}"#).unwrap();
    for (arguments, part) in [
        (&["--answers", "old.jsonl"][..], "old.jsonl: the answers are of equations.json 0.1"),
        (&["--answers", "none.jsonl"], "cannot read none.jsonl"),
        (&["--answers", "part.jsonl", "--", "true"], "cannot be used with"),
        (&["--only", "21.K1", "--", "true"], "there is no quantity `21.K1`; nearest: `21.K_1`"),
        (&["--state", "rest-vertica", "--", "true"], "there is no state `rest-vertica`; nearest: `rest-vertical`"),
        (&["--format", "yaml", "--", "true"], "possible values: markdown, text, json, junit"),
    ] {
        let output = ancf(folder.path(), &[&["conform"], arguments].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

#[test]
fn formats_and_demands() {
    let folder = tempfile::tempdir().unwrap();
    // Right everywhere it is asked, and nothing is refused.
    let [sh, path] = program(folder.path(), HELLO, r#"printf '{"id":"%s","value":0.0}\n' "$id""#);
    let states = ["--state", "rest-horizontal", "poisson-half"];
    let run = |more: &[&str]| {
        let output = ancf(folder.path(), &[&["conform"], &states[..], more, &["--", &sh, &path]].concat());
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let (code, text, _) = run(&["--format", "text"]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("Right, asked in part by your choice; should refuse 1 of 26 invalid states."), "{text}");
    assert!(!text.contains("**") && !text.contains('`'), "{text}");
    let (_, text, _) = run(&["--format", "json"]);
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&json["verdict"], &json["refusal"]["accepted"]), (&json!("right"), &json!(1)));
    let (_, text, _) = run(&["--format", "junit"]);
    assert!(
        text.starts_with("<?xml") && text.contains("failures=\"0\"") && text.contains("name=\"poisson-half\"><skipped")
    );
    let (code, text, message) = run(&["--must-refuse", "--format", "junit"]);
    assert_eq!(code, Some(1), "{message}");
    assert!(
        message.contains("should refuse 1 more invalid state(s)") && text.contains("failures=\"1\""),
        "{message}{text}"
    );
    let out = fs::read_dir(folder.path().join("out")).unwrap().map(|entry| entry.unwrap().file_name());
    let mut out: Vec<_> = out.map(|name| name.into_string().unwrap()).filter(|name| !name.starts_with('.')).collect();
    out.sort();
    assert_eq!(out, ["conformance.json", "conformance.md"]);
}

/// Whatever ends the command, the answers so far are left, and make a report.
#[test]
fn a_run_that_is_killed_leaves_its_answers() {
    let folder = tempfile::tempdir().unwrap();
    // It hangs at the fifth question.
    let answer = format!("n=$((n+1)); if [ $n = 5 ]; then sleep 40; fi; {ANSWER}");
    let [sh, path] = program(folder.path(), HELLO, &answer);
    let mut run = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let run = run.args(["conform", "--time-limit", "50", "--", &sh, &path]).current_dir(folder.path());
    let mut run = run.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null()).spawn().unwrap();
    let partial = folder.path().join("out/conformance.partial.jsonl");
    let started = Instant::now();
    while fs::read_to_string(&partial).map_or(0, |text| text.lines().count()) < 5 {
        assert!(started.elapsed() < Duration::from_secs(60), "no answers");
        std::thread::sleep(Duration::from_millis(20));
    }
    run.kill().unwrap();
    run.wait().unwrap();
    // As if it had been killed within a line.
    fs::write(&partial, fs::read_to_string(&partial).unwrap() + r#"{"id":"17.lambda/"#).unwrap();
    assert!(!folder.path().join("out/conformance.json").exists());
    let output = ancf(folder.path(), &["conform", "--answers", "out/conformance.partial.jsonl"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("## Conformance of own") && text.contains(" / 4 / 36 |"), "{text}");
    assert!(text.contains("Form: a last line that is cut off"), "{text}");
    assert!(partial.exists(), "it is the user's until a program is asked again");
}
