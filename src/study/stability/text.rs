//! The table as text.

use super::row::{Row, Verdict};
use super::{Study, Swept};

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
    let loose = study.rows().filter(|row| row.loose).count();
    text + &format!(
        "\n{right} right, {warned} right with warning, {refused} refused, {wrong} WRONG\nof the right ones {loose} are marked `~`: their \
         bound is more than a hundredth of what is measured, so that they show little\n"
    )
}

fn line(row: &Row) -> String {
    let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
    let beside = row.beside.map_or(String::new(), |value| format!("  beside {value:.1e}"));
    let note = if row.note.is_empty() { String::new() } else { format!("  {}", row.note) };
    format!(
        "   {:44} {:>14}  error {:>8}  bound {:>8}{} {}{beside}{note}",
        row.variant,
        row.shown(),
        number(row.error),
        number(row.bound),
        if row.loose { "~" } else { " " },
        row.verdict.word()
    )
}
