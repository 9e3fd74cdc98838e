//! The terms of (23) asked of a program that assembles structures: this test itself, started again as a subject.
//!
//! The subject reads scene, t and q from the question and assembles with `ancf`; nothing of `given` is used.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeSet;
use std::env;
use std::io::{self, BufRead, Write};
use std::time::Duration;

use ancf::internals::structure::Structure;
use ancf::model::Model;
use ancf_conform::{Examination, Options, Program, Suite, examine};
use nalgebra::{DVector, Vector2};
use serde_json::{Value, json};

/// Terms of (23), which are asked for where the case has a scene.
const TERMS: [&str; 5] = ["23.m", "23.Q_e", "23.f", "23.Phi", "23.Phi_q"];
/// Environment variable with the subject's mistake; the subject runs only where it is set.
const MISTAKE: &str = "ANCF_TEST_MISTAKE";

/// The terms in the fixture's coordinates and rows, from the state of a question.
fn term(equation: &str, state: &Value, mistake: &str) -> Option<Value> {
    let scene = Model::parse(&state["scene"].to_string(), "question").ok()?.into_scene();
    let structure = Structure::new(&scene).ok()?;
    let (mut coordinates, mut q_0) = (Vec::new(), Vec::new());
    for rod in &scene.rods {
        let [from, to] = [&rod.from, &rod.to].map(|point| Vector2::from(scene.points[point]));
        let t = (to - from).normalize();
        for vector in 0..5 * rod.elements + 2 {
            let along = (vector / 5) as f64 + if vector % 5 == 2 { 0.5 } else { 0.0 };
            let initial = match vector % 5 {
                0 | 2 => from + (to - from) * (along / rod.elements as f64),
                3 => t,
                _ => Vector2::new(-t.y, t.x),
            };
            for component in 0..2 {
                coordinates.push(structure.unknown(&rod.name, vector, component)?);
                q_0.push(initial[component]);
            }
        }
    }
    let rows: Vec<usize> = (0..).map_while(|row| structure.multiplier(row)).collect();
    assert_eq!(rows.len(), state["rows"].as_array()?.len());
    let mut u = DVector::zeros(structure.size());
    for ((unknown, q), q_0) in coordinates.iter().zip(state["q"].as_array()?).zip(&q_0) {
        u[*unknown] = q.as_f64()? - q_0;
    }
    let t = state["t"].as_f64()?;
    let picked = |vector: &DVector<f64>, places: &[usize]| json!(places.iter().map(|&n| vector[n]).collect::<Vec<_>>());
    Some(match equation {
        "23.m" => {
            let m = structure.mass().dense();
            // The blocks of neighbouring elements overlap at their common node, the vectors 5 and 6 of a rod.
            let once = |i: usize, j: usize| mistake == "once" && [i, j].iter().all(|n| (10..14).contains(n));
            let entry = |i, j| m[(coordinates[i], coordinates[j])] * if once(i, j) { 0.5 } else { 1.0 };
            let n = coordinates.len();
            json!((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect::<Vec<_>>()).collect::<Vec<_>>())
        }
        "23.Q_e" => {
            let mut force = DVector::zeros(structure.size());
            structure.force(&u, &structure.thermal_strains(t), &mut force);
            picked(&force, &coordinates)
        }
        "23.f" => picked(&structure.load(if mistake == "history" { 0.0 } else { t }), &coordinates),
        "23.Phi" => {
            let mut Phi = DVector::zeros(structure.size());
            structure.set_constraint_rows(&u, &mut Phi);
            picked(&Phi, &rows)
        }
        "23.Phi_q" => {
            let mut matrix = structure.mass();
            structure.add_constraints(1.0, &mut matrix);
            let dense = matrix.dense();
            json!(rows.iter().map(|&i| coordinates.iter().map(|&j| dense[(i, j)]).collect()).collect::<Vec<Vec<f64>>>())
        }
        _ => return None,
    })
}

#[test]
#[ignore = "the subject of the tests below, which start it"]
fn subject() {
    let Ok(mistake) = env::var(MISTAKE) else { return };
    let mut out = io::stdout();
    for line in io::stdin().lock().lines() {
        let question: Value = serde_json::from_str(&line.unwrap()).unwrap();
        let answer = match (&question["hello"], question["equation"].as_str()) {
            (Value::Null, Some(equation)) => {
                assert!(question["given"].is_null(), "nothing is given with {equation}");
                let value = term(equation, &question["state"], &mistake);
                value.map_or(
                    json!({"id": question["id"], "not_implemented": true}),
                    |value| json!({"id": question["id"], "value": value}),
                )
            }
            _ => json!({"hello": {"name": "assembler", "quantities": TERMS}}),
        };
        writeln!(out, "{answer}").unwrap();
    }
}

fn examined(mistake: &str) -> Examination {
    let this = env::current_exe().unwrap().display().to_string();
    let command = ["env", &format!("{MISTAKE}={mistake}"), &this, "--exact", "subject", "--ignored", "--nocapture"];
    let mut program = Program::start(&command.map(String::from), Duration::from_secs(20)).unwrap();
    examine(&Suite::embedded().unwrap(), &mut program, Options::default(), |_| {})
}

/// Quantities that fail in some case.
fn failing(examination: &Examination) -> BTreeSet<&str> {
    let failing = examination.verdicts.iter().filter(|(_, cases)| cases.iter().any(|(_, verdict)| verdict.fails()));
    failing.map(|(quantity, _)| *quantity).collect()
}

#[test]
fn a_program_that_assembles_structures_is_asked_for_every_term() {
    let examination = examined("none");
    for quantity in TERMS {
        let (_, cases) = examination.verdicts.iter().find(|(id, _)| *id == quantity).unwrap();
        assert!(cases.len() == 4 && cases.iter().all(|(_, verdict)| verdict.passes()), "{quantity}: {cases:?}");
    }
    assert_eq!(failing(&examination), BTreeSet::new());
}

#[test]
fn a_wrong_term_is_named() {
    for (mistake, quantity) in [("once", "23.m"), ("history", "23.f")] {
        let examination = examined(mistake);
        assert_eq!(failing(&examination), [quantity].into());
        let culprits: Vec<&str> = examination.blame.culprits.iter().map(|culprit| culprit.quantity).collect();
        assert_eq!(culprits, [quantity], "{mistake}");
    }
}
