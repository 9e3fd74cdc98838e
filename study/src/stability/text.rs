//! The table as text.

use super::row::Row;
use super::{Study, Swept};

pub fn table(study: &Study) -> String {
    let mut text = String::from("Stiff and extreme cases\n");
    for Swept { case, rows } in &study.cases {
        text += &format!(
            "\n{}: error, {}; swept: {}\n   from: {}\n   right: {}\n",
            case.name, case.unit, case.parameter, case.reference, case.right
        );
        for row in rows {
            text += &format!("{}\n", line(row));
        }
    }
    let [right, warned, refused, wrong] = counts(study.rows());
    let loose = study.rows().filter(|row| row.loose).count();
    text + &format!(
        "\n{right} right, {warned} right with warning, {refused} refused, {wrong} WRONG\nof the right ones {loose} are marked `~`: their \
         bound is more than a hundredth of what is measured, so that they show little\n"
    )
}

/// The verdicts of each case.
pub fn summary(study: &Study) -> String {
    let mut text = String::from("Stiff and extreme cases: the rows that take no time; `ancf stability` has all\n\n");
    text += &format!("   {:26} {:>6} {:>12} {:>8} {:>6}\n", "case", "right", "with warning", "refused", "WRONG");
    let line = |name: &str, [right, warned, refused, wrong]: [usize; 4]| {
        format!("   {name:26} {right:>6} {warned:>12} {refused:>8} {wrong:>6}\n")
    };
    for Swept { case, rows } in study.cases.iter().filter(|swept| !swept.rows.is_empty()) {
        text += &line(case.name, counts(rows.iter()));
    }
    text + &line("together", counts(study.rows())) + "\n"
}

/// Rows that are right, right with warning, refused and WRONG.
fn counts<'a>(rows: impl Iterator<Item = &'a Row>) -> [usize; 4] {
    let mut counts = [0; 4];
    for row in rows {
        counts[row.verdict as usize] += 1;
    }
    counts
}

fn line(row: &Row) -> String {
    let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
    let beside = row.beside.map_or(String::new(), |value| format!("  (in another form {value:.1e})"));
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
