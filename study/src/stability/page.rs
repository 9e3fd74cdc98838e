//! `stability.html`: the table with its derivations, and the pictures.

use super::row::Row;
use super::{Study, Swept};
use crate::html::Html;

/// The page.
pub fn page(study: &Study, svg: &str) -> String {
    let mut html = Html::default();
    html.paragraph(
        "Each case sweeps one parameter until the method breaks. A row is right within a bound that is derived; refused with a reason; or \
         WRONG. Rounding that may be above a hundredth of what is measured makes a result useless: the run has to warn of it. A bound \
         above a hundredth that comes from the step, the mesh or the theory is marked `~`: such a row shows little. A kept energy \
         balance alone makes no row right.",
    );
    html.svg(svg);
    for Swept { case, rows } in &study.cases {
        html.heading(case.name);
        html.paragraph(&format!("Reference: {}.", case.reference.trim_end_matches('.')));
        html.paragraph(&format!("Right: {}", case.right));
        let cells: Vec<Vec<String>> = rows.iter().map(cells).collect();
        let error = format!("error, {}", case.unit);
        html.table(
            &["variant", case.parameter, &error, "bound", "made of", "beside", "iterations", "verdict", "what it says"],
            &cells,
        );
    }
    html.page("Stiff and extreme cases")
}

fn cells(row: &Row) -> Vec<String> {
    let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
    vec![
        row.variant.clone(),
        row.shown(),
        number(row.error),
        format!("{}{}", number(row.bound), if row.loose { " ~" } else { "" }),
        row.why.clone(),
        number(row.beside),
        row.counts.newton_iterations.to_string(),
        row.verdict.word().into(),
        row.note.clone(),
    ]
}
