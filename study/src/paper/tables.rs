//! The main job's tables as text.

use std::fmt::Display;

use super::balance::Balance;
use super::claims_section3::{PendulumStatement, WindowFinding};
use super::claims_section4::StructureStatement;
use super::comparison::Comparison;
use super::locking::{Locking, SmallLoad};
use super::model_error::{ErrorRow, ShearRow};
use super::pendulum::{Mesh, Model, TIMES};
use super::reference_pendulum::Oracle;
use super::scissors::{DAMPED_RHO, DAMPED_STEP, ELEMENTS, STEP};
use super::section4::A4Row;
use crate::table::{Cell, Table, cells};

/// Our runs of the pendulum and the oracle's.
pub fn oracle(rows: &[Comparison]) -> String {
    compared("1. The same meshes by the oracle: strain energy alone, DOP853, t = 0 … 0.5 s", rows)
}

/// Our structures and the oracle's; stiff structures and rigid ones.
pub fn structures(rows: &[Comparison]) -> String {
    let title = "7. Two pinned rods at different temperatures by the oracle, in free coordinates, t = 0 … 0.5 s (named by their elements);\n   \
                 rigid-3: three scissors with E · 10⁴ and the rigid mechanism, t = 0 … 2.9 s";
    compared(title, rows)
}

/// Bounds of the distances from the plane solid.
pub fn bars(rows: &[Comparison]) -> String {
    compared("5. Bounds of the distance from the plane solid; the error is the solid's own", rows)
}

fn verdict(holds: bool) -> &'static str {
    if holds { "holds" } else { "FAILS" }
}

fn compared(title: &str, rows: &[Comparison]) -> String {
    let columns = "run | step, s :.1e | distance, m :.1e | oracle's error :.1e | bound :.1e | verdict";
    let cells = |row: &Comparison| {
        let Comparison { run, step, largest_distance, oracle_error, bound } = row;
        cells![&**run, *step, *largest_distance, *oracle_error, *bound, verdict(row.holds())]
    };
    format!("{title}\n\n{}\n", Table::new(columns, rows.iter().map(cells)).text())
}

fn time(t: f64) -> String {
    format!("t = {t} s")
}

/// Tip positions of all models, with the changes by another step and mesh.
pub fn tips(models: &[Model], oracle: &Oracle) -> String {
    let mut text = String::from(
        "2. Tip position, m, explicit; its changes by twice the step and twice the elements; and the oracle's position with four elements, if\n   \
         known (its distance is that of the mesh)\n",
    );
    for model in models {
        let Mesh { elements, step, other_elements } = model.kind.mesh;
        let columns = format!(" | x :.6 | y :.6 | 2 × step :.1e | {other_elements} elements :.1e | oracle, 4 elements");
        let known = oracle.find(model.kind.scene, model.kind.element, 4);
        let rows = model.rows().map(|row| {
            let [x, y] = row.tip;
            let known = known.map(|run| run.tip.at(row.t)).filter(|[x, _]| !x.is_nan());
            let known = known.map_or(String::new(), |[x, y]| format!("({x:.6}, {y:.6})"));
            cells![time(row.t), x, y, row.change_with_twice_the_step, row.change_with_the_other_mesh, known]
        });
        text += &format!("\n   {}, {elements} elements, step {step:.0e} s\n", model.kind.name);
        text += &Table::new(&columns, rows).text();
    }
    text + "\n"
}

/// Distances of the heated models' tips from the flexible one's, and from each other.
pub fn differences(models: &[Model]) -> String {
    let of = |id: &str| models.iter().find(|model| model.kind.id == id);
    let distance = |t: f64, a: &str, b: &str| match (of(a), of(b)) {
        (Some(a), Some(b)) => 1e3 * a.tip.distance(t, b.tip.at(t)),
        _ => f64::NAN,
    };
    let mut text = String::from(
        "3. Distance between the models' tips, mm (the paper's Figure 4; its 1D model is Euler–Bernoulli, EB; 1D: the paper's own element)\n",
    );
    for start in ["sudden", "relaxed"] {
        let [axis, plane, cable] = ["1d", "2d", "1d-eb"].map(|model| format!("{model}-{start}"));
        let columns = format!("{start} start | 1D–flexible :.3 | 2D–flexible :.3 | 2D–1D :.3 | 2D–1D EB :.3");
        let row = |t: f64| {
            let flexible = [&axis, &plane].map(|model| distance(t, model, "flexible"));
            let heated = [&axis, &cable].map(|model| distance(t, &plane, model));
            cells![time(t), flexible[0], flexible[1], heated[0], heated[1]]
        };
        text += &format!("\n{}", Table::new(&columns, TIMES.map(row)).text());
    }
    text + "\n"
}

/// Parts of the distance from the solid.
pub fn errors(rows: &[ErrorRow], shear: &[ShearRow]) -> String {
    let columns = "model |  | distance :.1e | space :.1e | time :.1e | solid's own :.1e | model, ≥ :.1e";
    let cells = |row: &ErrorRow| {
        let ErrorRow { model, window, distance, space, time, reference, model_error } = row;
        let model_error = Some(*model_error).filter(|error| *error > 0.0);
        cells![*model, window.to_string(), *distance, *space, *time, *reference, model_error]
    };
    let shear_columns = " | distance :.1e | with shear 5/6 :.1e";
    let shear_cells = |row: &ShearRow| cells![row.window.to_string(), row.distance, row.corrected];
    format!(
        "4. Largest distance of the tip from the plane solid with the same heat, m; its changes by twice the elements (space) and twice the\n   \
         step (time), the solid's uncertainty, and the remainder, at least the model's error\n\n{}\n   \
         The error of the flexible model is the shear correction that the element does not have. Its distance every 0.05 s, and the\n   \
         distance with the effect of a factor of 5/6 (oracle, 16 elements):\n{}\n",
        Table::new(columns, rows.iter().map(cells)).text(),
        Table::new(shear_columns, shear.iter().map(shear_cells)).text()
    )
}

/// A statement: its measure, lines of numbers, and the verdict.
fn statement(text: &str, measure: &str, lines: &[(&str, String)], verdict: &str) -> String {
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let lines: String = lines.iter().map(|(name, numbers)| format!("      {name:width$} {numbers}\n")).collect();
    format!("\n   {text}\n      {measure}\n{lines}      → {verdict}\n")
}

fn list(items: impl Iterator<Item = impl Display>) -> String {
    items.map(|item| item.to_string()).collect::<Vec<_>>().join(", ")
}

/// The paper's statements on the pendulum.
pub fn statements(rows: &[PendulumStatement], locking: &Locking) -> String {
    let small = |SmallLoad { nu, poisson, ratios }: &SmallLoad| {
        let ratios = list(ratios.iter().map(|(_, ratio)| format!("{ratio:.4}")));
        format!("      ν = {nu}, Poisson's terms \"{poisson}\": {ratios}\n")
    };
    let small: String = locking.small_load.iter().map(small).collect();
    let large = list(locking.large_bending.iter().map(|(elements, error)| format!("{error:.1e} ({elements})")));
    let mut text = format!(
        "6. The paper's statements on it, measured against the plane solid heated in 2D, in the windows of 4; ± uncertainty of the solid and\n   \
         our errors in space and time\n\n   {}\n      tip of one element under a small load over that of Timoshenko's beam, L/h = 2, 10, 100, 1000\n{small}      \
         PL²/EI = 10, h/L = 10⁻³: distance of the tip from the elastica's over L (elements): {large}\n      → {}\n",
        locking.statement, locking.verdict
    );
    for row in rows {
        let words = |f: &WindowFinding| format!("{:.2e} ± {:.1e}", f.value, f.uncertainty);
        let findings = [("sudden", &row.sudden), ("relaxed", &row.relaxed)];
        let lines = findings.map(|(name, findings)| (name, list(findings.iter().map(words))));
        text += &statement(row.statement, row.measure, &lines, &row.verdict);
    }
    text + "\n"
}

/// a4 over time, with the changes by another step and mesh.
pub fn a4(rows: &[A4Row]) -> String {
    let columns = "model |  | x :.6 | y :.6 | 2 × step :.1e | ½ elements :.1e";
    let cells = |row: &A4Row| {
        let [step, mesh] = [row.change_with_twice_the_step, row.change_with_half_the_elements].map(Cell::from);
        [cells![row.model, time(row.t), row.a4[0], row.a4[1]], vec![step, mesh]].concat()
    };
    format!(
        "8. Point a4, m: {ELEMENTS} elements a rod, energy–momentum, step {STEP:.0e} s; its changes by twice the step and half the elements\n\n{}\n",
        Table::new(columns, rows.iter().map(cells)).text()
    )
}

/// Energy balances.
pub fn energies(rows: &[Balance]) -> String {
    let lines: String = rows.iter().map(|row| format!("   {row}: {}\n", verdict(row.holds()))).collect();
    format!("9. Energy balance of these runs, every step\n\n{lines}\n")
}

/// The paper's statements on the structure.
pub fn claims(rows: &[StructureStatement]) -> String {
    let mut text = format!(
        "10. The paper's statements on it, measured under the assumptions of `ancf scene scissors-3-thermal`: undamped (energy–momentum), with\n   \
         half the elements, with twice the step, and damped (generalized-α, ρ∞ = {DAMPED_RHO}, step {DAMPED_STEP:.0e} s)\n"
    );
    for row in rows {
        let lines = [
            ("undamped", &row.undamped),
            ("½ elements", &row.half_the_elements),
            ("2 × step", &row.twice_the_step),
            ("damped", &row.damped),
        ];
        let lines = lines.map(|(name, finding)| (name, finding.numbers.clone()));
        text += &statement(row.statement, row.measure, &lines, &row.verdict);
    }
    text + "\n"
}
