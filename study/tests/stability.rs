//! The fast subset of the stiff and extreme cases: each case has the expected numbers of rows, and none is WRONG.

use std::sync::LazyLock;

use ancf_study::stability::{StabilityRow, StabilityStudy, Subset, Verdict, measure, names};

/// Rows of the fast subset that are right, right with warning, and refused.
const EXPECTED: [(&str, [usize; 3]); 22] = [
    ("stiff-limit", [1, 0, 0]),
    ("loads-that-move-nothing", [9, 3, 5]),
    ("slenderness", [32, 5, 11]),
    ("soft-and-stiff", [0, 4, 0]),
    ("heat-free", [28, 0, 8]),
    ("heat-clamped", [20, 8, 3]),
    ("heat-shock", [0, 0, 3]),
    ("explicit-with-a-hinge", [8, 0, 0]),
    ("estimate", [8, 0, 1]),
    ("poisson", [26, 0, 14]),
    ("rotation-free", [20, 0, 0]),
    ("rotation-over-the-top", [1, 0, 0]),
    ("far-from-origin", [9, 0, 1]),
    ("units", [20, 0, 10]),
    ("step-size", [20, 0, 0]),
    ("long-run", [4, 0, 0]),
    ("fine-mesh-small-load", [31, 1, 0]),
    ("fine-mesh-large-bending", [14, 0, 0]),
    ("singular-mechanism", [2, 0, 0]),
    ("bad-structure", [0, 0, 9]),
    ("collapsed-element", [5, 7, 18]),
    ("inclined-printed-shear", [28, 0, 0]),
];

/// The fast subset, computed once for all tests.
static STUDY: LazyLock<StabilityStudy> = LazyLock::new(|| measure(&[], Subset::Fast).unwrap());

#[test]
fn no_row_of_the_fast_subset_is_wrong() {
    let study = &*STUDY;
    let wrong: Vec<String> = study.wrong().map(StabilityRow::line).collect();
    assert!(wrong.is_empty(), "{} rows:\n{}", wrong.len(), wrong.join("\n"));
    let counted: Vec<(&str, [usize; 3])> = study
        .cases
        .iter()
        .map(|case| {
            let of = |verdict| case.rows.iter().filter(|row| row.verdict == verdict).count();
            (case.case.name, [Verdict::Right, Verdict::Warned, Verdict::Refused].map(of))
        })
        .collect();
    println!("{counted:?}, in {:.1} s", study.wall_seconds);
    assert_eq!(counted, EXPECTED);
    assert!(counted.iter().map(|(name, _)| *name).eq(names()));
}

#[test]
fn every_bound_has_its_parts_and_every_refusal_its_reason() {
    for row in STUDY.rows() {
        match row.verdict {
            Verdict::Refused => assert!(row.error.is_none() && row.note.len() > 20, "{}", row.line()),
            _ => assert!(!row.why.is_empty() && row.bound.is_some_and(|bound| bound > 0.0), "{}", row.line()),
        }
        // A mark for showing little follows from bound and size.
        let loose = row.bound.zip(row.size).is_some_and(|(bound, size)| bound > 1e-2 * size);
        assert_eq!(row.loose, loose, "{}", row.line());
    }
}

#[test]
fn values_near_a_limit_differ_from_it() {
    let study = measure(&["poisson".into()], Subset::Fast).unwrap();
    let full = study.rows().filter(|row| row.variant.contains("full"));
    let mut shown: Vec<String> = full.map(StabilityRow::shown).collect();
    let count = shown.len();
    shown.sort();
    shown.dedup();
    assert_eq!(shown.len(), count, "{shown:?}");
    assert!(shown.contains(&"0.4999999".to_string()) && shown.contains(&"0.5".to_string()));
}

#[test]
fn an_unknown_case_is_named() {
    let message = measure(&["slendernes".into()], Subset::Fast).unwrap_err().to_string();
    assert!(message.contains("slendernes") && message.contains("`slenderness`"), "{message}");
}
