//! `ancf conform` with programs that do what programs do: hang, crash, talk nonsense.
//!
//! They are shell scripts that answer λ = 0 of (17), which is right where ν = 0.

#![cfg(all(feature = "cli", unix))]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use ancf::conformance::examine::{Examination, Options, Refusal, examine};
use ancf::conformance::program::STARTS;
use ancf::conformance::suite::Suite;
use ancf::conformance::verdict::{Fault, Verdict};
use serde_json::Value;

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
    let options = Options { time_limit: Duration::from_secs_f64(limit), given: true };
    examine(&Suite::embedded().unwrap(), &command, options, |_| {}).unwrap()
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
    assert_eq!(cases.len(), 34);
    assert!(!examination.passes());
    assert_eq!(examination.blame.culprits[0].quantity, QUANTITY);
    faults
}

#[test]
fn a_program_that_hangs_is_ended_and_started_again() {
    let started = Instant::now();
    let examination = lambda("", "exec sleep 30", 0.5);
    assert_eq!(faults(&examination), [Fault::TimeLimit("0.5 s".into())]);
    assert_eq!(examination.starts, 2);
    assert!(started.elapsed() < Duration::from_secs(15), "{:?}", started.elapsed());
}

#[test]
fn a_program_that_crashes_is_started_again_and_quoted() {
    let examination = lambda("", "echo 'out of luck' >&2; exit 3", 10.0);
    let faults = faults(&examination);
    let [Fault::Crash(how)] = &faults[..] else { panic!("{faults:?}") };
    assert!(how.contains("exit status: 3") && how.contains("out of luck"), "{how}");
    assert_eq!(examination.starts, 2);
}

#[test]
fn garbage_nan_and_wrong_shapes_are_results() {
    for (second, expected) in [
        ("echo 'computing ...'", Fault::Garbage("computing ...".into())),
        (r#"printf '{"id":"%s","value":NaN}\n' "$id""#, Fault::NotFinite("1 of its entries".into())),
        (r#"printf '{"id":"%s","value":[[0],[0]]}\n' "$id""#, Fault::Shape("2 × 1; expected a number".into())),
        (r#"printf '{"id":"%s","error":"no idea"}\n' "$id""#, Fault::Error("no idea".into())),
        (r#"printf '{"id":"%s","value":' "$id"; exit 0"#, Fault::Garbage(r#"{"id":"12","value":"#.into())),
    ] {
        let examination = lambda("", second, 10.0);
        let found = faults(&examination);
        match (&found[0], &expected) {
            (Fault::Garbage(line), Fault::Garbage(start)) if second.contains("exit") => {
                assert_eq!(line.split(':').count(), start.split(':').count(), "{line}");
            }
            (found, expected) => assert_eq!(found, expected),
        }
    }
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
    assert_eq!((faults(&examination), examination.starts), (vec![], 1));
}

#[test]
fn a_program_that_closes_its_input_is_noticed() {
    let started = Instant::now();
    let examination = lambda("", &format!("exec <&-; {ANSWER}; exec sleep 20"), 10.0);
    let faults = faults(&examination);
    assert!(matches!(&faults[..], [Fault::Crash(how)] if how.contains("does not read")), "{faults:?}");
    assert!(started.elapsed() < Duration::from_secs(8), "{:?}", started.elapsed());
}

#[test]
fn a_program_that_always_crashes_is_given_up() {
    let folder = tempfile::tempdir().unwrap();
    let all: Vec<String> =
        ancf::conformance::graph::GRAPH.iter().map(|node| format!("\"{}\"", node.quantity)).collect();
    let command = script(folder.path(), &all.join(","), "", ":");
    fs::write(&command[1], fs::read_to_string(&command[1]).unwrap().replace("n=$((n+1))", "exit 1")).unwrap();
    let options = Options { time_limit: Duration::from_secs(5), given: true };
    let examination = examine(&Suite::embedded().unwrap(), &command, options, |_| {}).unwrap();
    assert_eq!(examination.starts, STARTS);
    let verdicts: Vec<&Verdict> =
        examination.verdicts.iter().flat_map(|(_, cases)| cases.iter().map(|c| &c.1)).collect();
    assert!(verdicts.iter().all(|verdict| verdict.fails()));
    let given_up = |why: &str| {
        verdicts.iter().any(|v| matches!(v, Verdict::Fault(Fault::NotAsked(reason)) if reason.contains(why)))
    };
    assert!(given_up("3 times before") && given_up(&format!("started {STARTS} times")));
}

#[test]
fn states_that_have_to_be_refused_are_asked_for_and_told() {
    let examination = lambda("", ANSWER, 10.0);
    let outcomes: Vec<&Refusal> = examination.refusals.iter().map(|(_, refusal)| refusal).collect();
    let suite = Suite::embedded().unwrap();
    for (invalid, outcome) in suite.invalid.iter().zip(outcomes) {
        let expected = if invalid.equation == QUANTITY { Refusal::Accepted } else { Refusal::NotImplemented };
        assert_eq!(*outcome, expected, "{}", invalid.id);
    }
    let text = ancf::conformance::report::markdown(&suite, &examination);
    assert!(text.contains("Not refused: `poisson-half`, asked for 17.lambda: a value was answered"), "{text}");
}

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn the_command_writes_a_report_and_ends_with_1() {
    let folder = tempfile::tempdir().unwrap();
    let command = script(folder.path(), "\"17.lambda\",\"17.mu\"", "", ANSWER);
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures");
    let output = ancf(folder.path(), &["conform", "--fixtures", fixtures, "--", &command[0], &command[1]]);
    let (text, message) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("the program does not conform: 0 quantities pass, 2 fail"), "{message}");
    for part in [
        "## Conformance of fake",
        "**First wrong equation: (17), `17.lambda`.** It depends on the state alone.",
        "ν in the wrong place (λ = 0)",
        "**Wrong by itself too: (17), `17.mu`.**",
        "Only in states tagged nu.",
        "| 17.lambda | **fail** | 12 / 34 | 0.8 | `rest-vertical`: 0e0 where 1.5e3 is right |",
        "| 1.r | not implemented | – | – |  |",
    ] {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
    let report: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out/conformance.json")).unwrap()).unwrap();
    assert_eq!(report["first_wrong"]["quantity"], "17.lambda");
    assert_eq!(report["culprits"].as_array().unwrap().len(), 2);
    assert_eq!(report["fixtures"]["equations.json"], "1.1");
    assert_eq!(report["tags"]["rest"]["pass"], 2);
}

#[test]
fn a_command_that_cannot_be_used_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let exits = folder.path().join("exits.sh");
    fs::write(&exits, "echo 'no licence' >&2; exit 4").unwrap();
    let exits = exits.display().to_string();
    for (arguments, code, part) in [
        (&["conform"][..], 2, "COMMAND"),
        (&["conform", "--", "./no-such-program"], 2, "cannot start the command `./no-such-program`"),
        (&["conform", "--fixtures", "nowhere", "--", "true"], 2, "cannot read nowhere/equations.json"),
        (&["conform", "--time-limit", "0", "--", "true"], 2, "allowed: a number over 0 and up to 3600"),
        (
            &["conform", "--", "sh", &exits],
            1,
            "did not answer hello: the program ended: exit status: 4; its last words: no licence",
        ),
        (&["conform", "--", "echo", "hello"], 1, "did not answer hello: no answer but hello"),
    ] {
        let output = ancf(folder.path(), arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {message}");
        assert!(message.contains(part), "no {part:?} in: {message}");
        assert!(!folder.path().join("out/conformance.json").exists());
    }
}

/// The adapter in another language: what it has is right, the rest it says that it does not have.
#[test]
fn the_partial_adapter_in_javascript_passes() {
    if Command::new("node").arg("--version").output().is_err() {
        eprintln!("skipped: node (JavaScript) is not installed");
        return;
    }
    let adapter = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/adapters/shape.mjs");
    let options = Options { time_limit: Duration::from_secs(20), given: true };
    let examination = examine(&Suite::embedded().unwrap(), &["node".into(), adapter.into()], options, |_| {}).unwrap();
    assert!(examination.passes(), "{:?}", examination.blame);
    assert_eq!(examination.implemented(), 8);
}
