//! Programs whose answers depend on what was asked before, and programs that say they read `given`.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::state::{ElementState, evaluate};
use ancf_conform::{Answer, Asked, Fault, Hello, Options, Question, Report, Subject, Suite, examine};
use serde_json::Value;

/// A program: `answer` may keep what it likes in `Kept`, which a restart clears.
struct Remembering<K, F> {
    kept: K,
    answer: F,
    hello: Hello,
    starts: usize,
}

impl<K: Default, F: FnMut(&mut K, &Asked) -> Answer> Subject for Remembering<K, F> {
    fn hello(&mut self, _: &Question) -> Result<Hello, Fault> {
        Ok(self.hello.clone())
    }

    fn ask(&mut self, question: &Asked) -> Result<Answer, Fault> {
        Ok((self.answer)(&mut self.kept, question))
    }

    fn restart(&mut self) -> bool {
        self.kept = K::default();
        self.starts += 1;
        true
    }

    fn starts(&self) -> usize {
        self.starts
    }
}

/// Report on a program that answers some quantities.
fn report<K: Default>(quantities: &[&str], answer: impl FnMut(&mut K, &Asked) -> Answer) -> Report {
    report_with(quantities, false, answer)
}

fn report_with<K: Default>(quantities: &[&str], given: bool, answer: impl FnMut(&mut K, &Asked) -> Answer) -> Report {
    let quantities = Some(quantities.iter().map(|name| (*name).to_string()).collect());
    let hello = Hello { name: Some("mine".into()), given, quantities, ..Hello::default() };
    let mut subject = Remembering { kept: K::default(), answer, hello, starts: 1 };
    let suite = Suite::embedded().unwrap();
    let examination = examine(&suite, &mut subject, Options::default(), |_| {});
    Report::new(&suite, &examination)
}

/// State of a question; an error for one that must be refused.
fn state(question: &Asked) -> Result<ElementState, Answer> {
    ElementState::parse(&question.state.to_string(), "state").map_err(|error| Answer::Error(error.to_string()))
}

/// Value of the asked quantity with the shape that it has.
fn value(question: &Asked, state: &ElementState) -> Answer {
    let numbers = evaluate(question.equation, state).unwrap();
    let mut value: Vec<Value> = numbers.into_iter().map(Value::from).collect();
    let rows = |value: Vec<Value>, length: usize| value.chunks(length).map(|row| Value::from(row.to_vec())).collect();
    match question.equation {
        "7.M" | "20.K" | "21.K_1" | "tangent.dQ_e" | "16.D" => {
            let length = value.len().isqrt();
            value = rows(value, length);
        }
        "8.epsilon_T" | "19.Q_e" | "gravity.Q_w" => {}
        "1.r" => value = rows(value, 2),
        "3.S" | "3.S_x" => value = rows(value, 7),
        "12.epsilon_f" | "14.epsilon" => value = rows(value, 3),
        "17.lambda" | "17.mu" | "18.U" | "6.T" => return Answer::Value(value.remove(0)),
        other => panic!("{other} has no shape here"),
    }
    Answer::Value(value.into())
}

const ALL: [&str; 11] =
    ["3.S", "1.r", "7.M", "6.T", "8.epsilon_T", "12.epsilon_f", "14.epsilon", "17.mu", "18.U", "19.Q_e", "gravity.Q_w"];

/// Report on a program that computes with a state that `recall` may exchange with an earlier one.
fn recalling<K: Default>(recall: impl Fn(&mut K, &Asked, &mut ElementState)) -> Report {
    report(&ALL, move |kept: &mut K, question| match state(question) {
        Ok(mut state) => {
            recall(kept, question, &mut state);
            value(question, &state)
        }
        Err(refusal) => refusal,
    })
}

#[track_caller]
fn assert_remembers(report: &Report) {
    let memory = report.memory.as_ref().unwrap_or_else(|| panic!("no memory: {}", report.markdown()));
    assert!(!report.passes && !memory.random, "{memory:?}");
    assert!(report.first_wrong.is_none() && report.culprits.is_empty(), "{}", report.markdown());
    assert!(report.markdown().contains("**Your answers depend on what was asked before.**"));
    assert!(memory.changed[0].second_is_right, "{memory:?}");
    assert!(report.starts <= 16, "{} starts", report.starts);
}

#[test]
fn a_right_program_is_started_once_more_and_asked_little_more() {
    let report = recalling(|(): &mut (), _, _| {});
    assert!(report.passes && report.memory.is_none(), "{}", report.markdown());
    assert_eq!(report.starts, 2);
    assert!(report.questions <= 36 * ALL.len() + 26 + 64, "{} questions", report.questions);
}

#[test]
fn a_wrong_program_without_memory_has_none() {
    let report = recalling(|(): &mut (), _, state| state.rho *= 2.0);
    assert!(report.memory.is_none(), "{:?}", report.memory);
    assert_eq!(report.first_wrong.unwrap().blame.quantity, "7.M");
}

#[test]
fn the_mass_matrix_of_the_first_state_is_kept() {
    let report = recalling(|kept: &mut Option<ElementState>, question, state| {
        if question.equation == "7.M" {
            *state = kept.get_or_insert_with(|| state.clone()).clone();
        }
    });
    assert_remembers(&report);
    let memory = report.memory.unwrap();
    assert_eq!(memory.quantities, ["7.M"]);
    let after = memory.after.unwrap();
    assert_eq!((after.quantity, after.exact), ("7.M", true));
}

#[test]
fn an_initial_configuration_or_the_length_of_the_first_state_is_kept() {
    assert_remembers(&recalling(|kept: &mut Option<[f64; 14]>, _, state| {
        state.e0 = *kept.get_or_insert(state.e0);
    }));
    assert_remembers(&recalling(|kept: &mut Option<f64>, _, state| state.l = *kept.get_or_insert(state.l)));
}

#[test]
fn a_metric_is_kept_by_length_only() {
    let report =
        recalling(|kept: &mut Vec<(f64, [f64; 14])>, _, state| match kept.iter().find(|(l, _)| *l == state.l) {
            Some((_, e0)) => state.e0 = *e0,
            None => kept.push((state.l, state.e0)),
        });
    assert_remembers(&report);
}

#[test]
fn the_heat_of_the_state_before_is_used() {
    let report = recalling(|kept: &mut Option<f64>, _, state| {
        let now = state.dT;
        state.dT = kept.replace(now).unwrap_or(now);
    });
    assert_remembers(&report);
    assert_eq!(report.memory.unwrap().after.unwrap().questions_before, 1);
}

#[test]
fn a_program_that_turns_wrong_after_200_questions() {
    let report = recalling(|count: &mut usize, _, state| {
        *count += 1;
        if *count > 200 {
            state.E *= 2.0;
            state.rho *= 2.0;
        }
    });
    assert_remembers(&report);
}

#[test]
fn a_buffer_that_is_never_cleared() {
    let report = report(&ALL, |sum: &mut Vec<f64>, question| match (question.equation, state(question)) {
        ("19.Q_e", Ok(state)) => {
            sum.resize(14, 0.0);
            let force = evaluate("19.Q_e", &state).unwrap();
            sum.iter_mut().zip(force).for_each(|(sum, force)| *sum += force);
            Answer::value(sum)
        }
        (_, Ok(state)) => value(question, &state),
        (_, Err(refusal)) => refusal,
    });
    assert_remembers(&report);
    assert_eq!(report.memory.unwrap().quantities, ["19.Q_e"]);
}

#[test]
fn a_mistake_beside_memory_is_still_found() {
    let report = recalling(|kept: &mut Option<ElementState>, question, state| match question.equation {
        "7.M" => *state = kept.get_or_insert_with(|| state.clone()).clone(),
        "17.mu" => state.E *= 2.0,
        _ => {}
    });
    let culprits: Vec<&str> = report.culprits.iter().map(|culprit| culprit.blame.quantity).collect();
    assert_eq!((culprits, report.memory.unwrap().quantities), (vec!["17.mu"], vec!["7.M"]));
}

#[test]
fn random_numbers_are_told_from_memory() {
    let mut seed = 1_u64;
    let report = report(&["17.mu"], move |(): &mut (), question| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        match state(question) {
            Ok(state) => Answer::value(state.E * (1.0 + (seed >> 40) as f64)),
            Err(refusal) => refusal,
        }
    });
    assert!(report.memory.as_ref().unwrap().random, "{:?}", report.memory);
    assert!(report.markdown().contains("the question is equal") && report.first_wrong.is_none());
}

/// λ wrong, K_3 wrong; K reads K_1 to K_3 and computes λ itself, or reads all, or nothing.
fn with_given(reads: &'static [&'static str]) -> Report {
    let quantities = ["17.lambda", "17.mu", "21.K_1", "20.K"];
    report_with(&quantities, true, move |(): &mut (), question| {
        let mut state = match state(question) {
            Ok(state) => state,
            Err(refusal) => return refusal,
        };
        let given = |name: &str, numbers: Vec<f64>| -> Vec<f64> {
            let read = question.given.get(name).filter(|_| reads.contains(&name));
            let flat = |value: &Value| match value {
                Value::Array(rows) => rows.iter().flat_map(|row| row.as_array().unwrap()).map(number).collect(),
                other => vec![number(other)],
            };
            read.map_or(numbers, |value| flat(value))
        };
        let lambda = 3.0 * state.E;
        let numbers = match question.equation {
            "17.lambda" => return Answer::value(lambda),
            "20.K" => {
                let right = |name: &str| evaluate(name, &state).unwrap();
                let lambda = given("17.lambda", vec![lambda])[0];
                let mu = given("17.mu", right("17.mu"))[0];
                let K_1 = given("21.K_1", right("21.K_1").iter().map(|K| 2.0 * K).collect());
                let (K_2, K_3) = (given("21.K_2", right("21.K_2")), given("21.K_3", right("21.K_3")));
                (0..196).map(|n| (lambda + 2.0 * mu) * K_1[n] + lambda * K_2[n] + 4.0 * mu * K_3[n]).collect()
            }
            "21.K_1" => evaluate("21.K_1", &state).unwrap().iter().map(|K| 2.0 * K).collect(),
            _ => {
                state.points.truncate(1);
                return value(question, &state);
            }
        };
        let numbers: Vec<f64> = numbers;
        Answer::value(numbers.chunks(14).collect::<Vec<_>>())
    })
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
#[cfg_attr(debug_assertions, ignore = "half a minute; in release mode")]
fn a_value_that_is_computed_in_place_of_the_given_one_remains_an_excuse() {
    let culprits = |report: &Report| report.culprits.iter().map(|culprit| culprit.blame.quantity).collect::<Vec<_>>();
    let all = with_given(&["17.lambda", "17.mu", "21.K_1", "21.K_2", "21.K_3"]);
    // K_1 computes its heat where it needs it. That heat is right: nothing to be said.
    assert_eq!((culprits(&all), all.given_ignored), (vec!["17.lambda", "21.K_1"], vec![]));
    // K remains wrong with other numbers, because of λ.
    let partly = with_given(&["21.K_1", "21.K_2", "21.K_3"]);
    assert_eq!((culprits(&partly), &partly.given_ignored), (vec!["17.lambda", "21.K_1"], &vec![]));
    let none = with_given(&[]);
    assert_eq!((culprits(&none), &none.given_ignored), (vec!["17.lambda", "21.K_1"], &vec!["20.K"]));
    let words = "It says it reads `given`, but does not for `20.K`";
    assert!(none.markdown().contains(words), "{}", none.markdown());
}

#[test]
fn answers_without_numbers_say_nothing_of_given_values() {
    let quantities = ["17.lambda", "17.mu", "20.K", "19.Q_e"];
    let report = report_with(&quantities, true, |(): &mut (), _| Answer::Error("not today".into()));
    assert!(report.given_ignored.is_empty() && !report.passes, "{}", report.markdown());
}
