//! The table as text.

use super::row::{Row, Verdict};
use super::{Study, Swept};

/// Longest sweep of a variant that is one line for each row; others say where they hold and where they end.
pub fn table(study: &Study) -> String {
    let mut text = String::from("Stiff and extreme cases\n");
    for Swept { case, rows } in &study.cases {
        text += &format!("\n{} ({})\n   from: {}\n   right: {}\n", case.name, case.unit, case.reference, case.right);
        for row in rows {
            text += &format!("{}\n", line(row));
        }
    }
    let count = |verdict| study.rows().filter(|row| row.verdict == verdict).count();
    let [right, warned, refused, wrong] =
        [Verdict::Right, Verdict::Warned, Verdict::Refused, Verdict::Wrong].map(count);
    text + &format!("\n{right} right, {warned} right with warning, {refused} refused, {wrong} WRONG\n")
}

fn line(row: &Row) -> String {
    let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
    let beside = row.beside.map_or(String::new(), |value| format!("  beside {value:.1e}"));
    let note = if row.note.is_empty() { String::new() } else { format!("  {}", row.note) };
    format!(
        "   {:44} {:>10.4e}  error {:>8}  bound {:>8}  {}{beside}{note}",
        row.variant,
        row.value,
        number(row.error),
        number(row.bound),
        row.verdict.word()
    )
}
