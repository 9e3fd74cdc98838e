//! What a report says first, for programs that are wrong, right, or right in part.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf_conform::report::{Conclusion, RefusalVerdict, junit};
use ancf_conform::{Answer, Asked, Code, Options, Report, Selection, Suite, examine};
use serde_json::Value;

fn number(question: &Asked, key: &str) -> f64 {
    question.state[key].as_f64().unwrap_or(f64::NAN)
}

/// Our Lamé constants of (17).
fn lame(question: &Asked) -> Answer {
    let (E, nu) = (number(question, "E"), number(question, "nu"));
    match question.equation {
        "17.lambda" => Answer::value(E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))),
        "17.mu" => Answer::value(E / (2.0 * (1.0 + nu))),
        _ => Answer::NotImplemented,
    }
}

fn report(answer: impl FnMut(&Asked) -> Answer, options: Options) -> (Report, String) {
    let suite = Suite::embedded().unwrap();
    let examination = examine(&suite, &mut Code::new("mine", answer), options, |_| {});
    let report = Report::new(&suite, &examination);
    let xml = junit(&suite, &examination, &report, false);
    (report, xml)
}

/// Lines before the first table.
fn first_screen(report: &Report) -> Vec<String> {
    report.markdown().lines().take_while(|line| !line.starts_with('|')).map(String::from).collect()
}

#[test]
fn the_first_screen_names_equation_kind_evidence_and_formula() {
    let (report, _) = report(
        |question| match question.equation {
            "17.mu" => Answer::value(number(question, "E") / (1.0 + number(question, "nu"))),
            _ => lame(question),
        },
        Options::default(),
    );
    let lines = first_screen(&report);
    assert!(lines.len() <= 25, "{}", lines.join("\n"));
    assert!(lines[2].starts_with("**Wrong: (17), `17.mu` first"), "{}", lines[2]);
    for part in [
        "**First wrong equation: (17), `17.mu`.**",
        "or factor (all of it twice).",
        "Evidence: state `",
        ", ratio 2. Wrong in 36 of 36 states.",
        "Look at: μ = E/(2(1 + ν)).",
        "Invalid states: should refuse.",
        "Not implemented: 75 quantities: (4), ",
    ] {
        assert!(lines.join("\n").contains(part), "no {part:?} in:\n{}", lines.join("\n"));
    }
    // Text has the same without marks.
    let text = report.text();
    assert!(
        text.contains("* First wrong equation: (17), 17.mu.")
            && !text.contains(['`', '*'].map(|c| c.to_string()).concat().as_str())
    );
    assert!(text.contains("17.mu"), "{text}");
}

/// All that can go wrong at once still leaves the first screen a screen.
#[test]
fn the_first_screen_stays_one_if_everything_is_wrong() {
    let (report, _) = report(
        |question| match question.equation {
            "7.M" => Answer::Error("singular".into()),
            name if name.starts_with('A') => Answer::NotImplemented,
            _ => Answer::value(1.5),
        },
        Options::default(),
    );
    let lines = report.markdown();
    let lines: Vec<&str> = lines
        .lines()
        .take_while(|line| {
            line.starts_with("- ") || line.starts_with("**") || line.starts_with("##") || line.is_empty()
        })
        .collect();
    assert!(lines.len() <= 25, "{}", lines.join("\n"));
    assert_eq!(report.verdict, Conclusion::Wrong);
}

#[test]
fn right_equations_stay_right_if_invalid_states_are_accepted() {
    let (accepting, xml) = report(lame, Options::default());
    assert!(accepting.passes);
    assert_eq!((accepting.verdict, accepting.refusal.verdict), (Conclusion::Right, RefusalVerdict::ShouldRefuse));
    let refusal = &accepting.refusal;
    assert_eq!(
        accepting.headline(),
        format!("Right; should refuse {} of {} invalid states", refusal.accepted, refusal.of)
    );
    assert!(refusal.accepted > 0 && refusal.no_answer == 0);
    assert!(
        xml.contains("failures=\"0\"") && xml.contains("<skipped message=\"should refuse, but it answered a value"),
        "{xml}"
    );

    let (refusing, _) = report(
        |question| match !question.equation.starts_with("17.")
            || number(question, "E") > 0.0
                && (-1.0..0.5).contains(&number(question, "nu"))
                && number(question, "nu") > -1.0
        {
            true => lame(question),
            false => Answer::Error("E has to be over 0, nu between -1 and 0.5".into()),
        },
        Options::default(),
    );
    assert_eq!((refusing.headline().as_str(), refusing.refusal.verdict), ("Right", RefusalVerdict::Acceptable));
}

#[test]
fn a_program_without_inclined_states_is_partly_checked_and_says_which() {
    let (report, _) = report(
        |question| match number(question, "theta") == 0.0 {
            true => lame(question),
            false => Answer::NotImplemented,
        },
        Options::default(),
    );
    assert_eq!(report.verdict, Conclusion::PartlyChecked);
    let suite = Suite::embedded().unwrap();
    let inclined = |tag: &str| {
        let tagged =
            suite.cases.iter().filter(|case| case.tags.iter().any(|t| t == tag) && case.values.contains_key("17.mu"));
        tagged.map(|case| case.state_json["theta"] != 0.0).collect::<Vec<_>>()
    };
    assert!(!report.left_out.is_empty());
    for tag in &report.left_out {
        assert!(inclined(tag).iter().all(|inclined| *inclined), "{tag}");
    }
    assert!(report.left_out.contains(&"rotated".to_string()), "{:?}", report.left_out);
    assert!(
        report
            .headline()
            .starts_with("Partly checked: right where it answers, but it leaves out every state tagged rotated"),
        "{}",
        report.headline()
    );
    assert!(report.markdown().contains("| 17.mu | **partly checked** |"));
}

#[test]
fn a_part_is_asked_by_choice() {
    let suite = Suite::embedded().unwrap();
    let asked = Selection::new(&suite, &["17".into()], &["rest-vertical".into()]).unwrap();
    let (report, xml) = report(lame, Options { asked, ..Options::default() });
    // Two questions; both are asked again, for memory.
    assert_eq!((report.headline().as_str(), report.questions), ("Right, asked in part by your choice", 4));
    assert!(report.partly_checked.is_empty() && report.asked_in_part);
    assert_eq!(xml.matches("<testcase classname=\"17.").count(), 2, "{xml}");
}

/// Φ_q λ in place of Φ_qᵀ λ, as (23) is printed: it exists only for as many constraints as coordinates.
#[test]
fn e4_as_printed_is_named() {
    let numbers = |value: &Value| value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<f64>>();
    let (report, _) = report(
        |question| {
            if question.equation != "23.constraint_force" && question.equation != "23.residual" {
                return Answer::NotImplemented;
            }
            let rows: Vec<Vec<f64>> = question.given["23.Phi_q"].as_array().unwrap().iter().map(numbers).collect();
            let lambda = numbers(&question.state["lambda"]);
            if rows[0].len() != lambda.len() {
                return Answer::Error("matrix dimensions do not agree".into());
            }
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let force: Vec<f64> = rows.iter().map(|row| dot(row, &lambda)).collect();
            if question.equation == "23.constraint_force" {
                return Answer::value(force);
            }
            let q_ddot = numbers(&question.state["q_ddot"]);
            let m: Vec<Vec<f64>> = question.given["23.m"].as_array().unwrap().iter().map(numbers).collect();
            let (Q_e, f) = (numbers(question.given["23.Q_e"]), numbers(question.given["23.f"]));
            Answer::value((0..f.len()).map(|n| dot(&m[n], &q_ddot) + Q_e[n] + force[n] - f[n]).collect::<Vec<_>>())
        },
        Options::default(),
    );
    let first = report.first_wrong.as_ref().unwrap();
    assert_eq!(first.blame.quantity, "23.constraint_force");
    assert!(
        first.diagnosis.mistakes.iter().any(|mistake| mistake.what.starts_with("E4: Φ_q λ")),
        "{:?}",
        first.diagnosis
    );
    let lines = first_screen(&report).join("\n");
    assert!(lines.contains("E4: Φ_q λ for Φ_qᵀ λ") && lines.contains("where the paper prints Φ_q λ (E4)"), "{lines}");
}
