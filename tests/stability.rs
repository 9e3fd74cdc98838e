//! The table of stiff and extreme cases: its fast subset has no row that is WRONG, and each case has its rows.

#![cfg(feature = "cli")]

use ancf::study::stability::row::{Row, Verdict};
use ancf::study::stability::{Reach, measure, names};

#[test]
fn no_row_of_the_fast_subset_is_wrong() {
    let study = measure(&[], Reach::Fast).unwrap();
    let wrong: Vec<String> = study.wrong().map(Row::line).collect();
    assert!(wrong.is_empty(), "{} rows:\n{}", wrong.len(), wrong.join("\n"));
    for case in &study.cases {
        let name = case.case.name;
        println!("{name}: {} rows", case.rows.len());
        assert!(!case.rows.is_empty(), "{name} has no row");
        // Every bound has its derivation.
        assert!(case.case.right.len() > 40 && !case.case.reference.is_empty(), "{name}");
        assert!(
            case.rows.iter().all(|row| row.error.is_none() || !row.why.is_empty()),
            "{name}: a bound without a why"
        );
    }
    let count = |verdict| study.rows().filter(|row| row.verdict == verdict).count();
    let [right, warned, refused] = [Verdict::Right, Verdict::Warned, Verdict::Refused].map(count);
    println!("{right} right, {warned} right with warning, {refused} refused, in {:.1} s", study.wall_seconds);
    assert!(right > 100 && warned > 10 && refused > 30);
    assert_eq!(study.cases.len(), names().count());
}

#[test]
fn an_unknown_case_is_named() {
    let message = measure(&["slendernes".into()], Reach::Fast).unwrap_err().to_string();
    assert!(message.contains("slendernes") && message.contains("`slenderness`"), "{message}");
}
