//! The table as text, HTML and CSV.

use super::row::StabilityRow;
use super::study::{StabilityStudy, Swept};
use crate::html::Html;
use crate::table::{Table, cells};

/// The whole table as text, with reference and bound of each case, and the counts.
pub fn text(study: &StabilityStudy) -> String {
    let mut text = String::from("Stiff and extreme cases\n");
    for Swept { case, rows } in &study.cases {
        let columns = format!(
            "variant | {} :.0 | error :.1e | bound :.1e |  | in another form :.1e | verdict | message",
            case.parameter
        );
        let cells = |row: &StabilityRow| {
            let (loose, verdict) = (if row.loose { "~" } else { "" }, row.verdict.word());
            cells![&*row.variant, row.shown(), row.error, row.bound, loose, row.beside, verdict, &*row.note]
        };
        text += &format!(
            "\n{}: error, {}; swept: {}\n   reference: {}\n   right: {}\n{}",
            case.name,
            case.unit,
            case.parameter,
            case.reference,
            case.right,
            Table::new(&columns, rows.iter().map(cells)).text()
        );
    }
    let [right, warned, refused, wrong] = counts(study.rows());
    let loose = study.rows().filter(|row| row.loose).count();
    text + &format!(
        "\n{right} right, {warned} right with warning, {refused} refused, {wrong} WRONG\n{loose} right rows are marked `~`: their bound is \
         more than a hundredth of the measured quantity, so that they show little\n"
    )
}

/// The verdicts of each case, counted.
pub fn counts_table(study: &StabilityStudy) -> Table {
    let columns = "case | right :.0 | with warning :.0 | refused :.0 | WRONG :.0";
    let cells = |name: &str, [right, warned, refused, wrong]: [usize; 4]| cells![name, right, warned, refused, wrong];
    let cases = study.cases.iter().filter(|swept| !swept.rows.is_empty());
    let rows = cases.map(|swept| cells(swept.case.name, counts(swept.rows.iter())));
    Table::new(columns, rows.chain([cells("together", counts(study.rows()))]))
}

/// Numbers of rows that are right, right with warning, refused and WRONG.
fn counts<'a>(rows: impl Iterator<Item = &'a StabilityRow>) -> [usize; 4] {
    let mut counts = [0; 4];
    rows.for_each(|row| counts[row.verdict as usize] += 1);
    counts
}

/// The page with the picture.
pub fn page(study: &StabilityStudy, svg: &str) -> String {
    let mut html = Html::default();
    html.paragraph(
        "Each case sweeps one parameter until the method breaks. A row is right (within a bound that is derived), refused with a reason, or \
         WRONG. A result is useless if rounding may exceed a hundredth of the measured quantity; the run has to warn of it. A row is marked \
         `~` if the step, the mesh or the theory makes the bound that large: such a row shows little. An energy balance that is kept makes no \
         other row right.",
    );
    html.svg(svg);
    for Swept { case, rows } in &study.cases {
        html.heading(case.name);
        html.paragraph(&format!("Reference: {}.", case.reference.trim_end_matches('.')));
        html.paragraph(&format!("Right: {}", case.right));
        let columns = format!(
            "variant | {} | error, {} :.1e | bound | parts of the bound | in another form :.1e | iterations :.0 | verdict | message",
            case.parameter, case.unit
        );
        let cells = |row: &StabilityRow| {
            let loose = if row.loose { " ~" } else { "" };
            let bound = row.bound.map(|bound| format!("{bound:.1e}{loose}"));
            let (iterations, verdict) = (row.counts.newton_iterations, row.verdict.word());
            cells![&*row.variant, row.shown(), row.error, bound, &*row.why, row.beside, iterations, verdict, &*row.note]
        };
        html.table(&Table::new(&columns, rows.iter().map(cells)));
    }
    html.page("Stiff and extreme cases")
}

/// `stability.csv`.
pub fn csv(study: &StabilityStudy) -> Table {
    const COLUMNS: &str = "case,variant,parameter,value,error,bound,unit,size,verdict,beside,steps,newton_iterations,force_calls,\
                           tangent_calls,factorizations,solves,why,note";
    let cells = |row: &StabilityRow| {
        let (counts, verdict) = (&row.counts, row.verdict.word());
        [
            cells![row.case, &*row.variant, row.parameter, row.value, row.error, row.bound, row.unit, row.size],
            cells![verdict, row.beside, counts.steps, counts.newton_iterations, counts.force_calls],
            cells![counts.tangent_calls, counts.factorizations, counts.solves, &*row.why, &*row.note],
        ]
        .concat()
    };
    Table::new(&COLUMNS.replace(',', " | "), study.rows().map(cells))
}
