//! The main job's tables: what each shows, and its rows.

use super::balance::Balance;
use super::comparison::Comparison;
use super::model_error::{ErrorRow, ShearRow};
use super::pendulum::{Mesh, Model, TIMES};
use super::reference_pendulum::Oracle;
use super::section4::A4Row;
use crate::table::{Cell, Table, cells};

/// Runs beside their references, with the bound of each distance.
pub fn compared(rows: &[Comparison]) -> Table {
    let columns = "run | step, s :.1e | distance, m :.1e | reference's error, m :.1e | bound, m :.1e | ";
    let cells = |row: &Comparison| {
        let Comparison { run, step, largest_distance, oracle_error, bound } = row;
        cells![&**run, *step, *largest_distance, *oracle_error, *bound, verdict(row.holds())]
    };
    Table::new(columns, rows.iter().map(cells))
}

fn verdict(holds: bool) -> &'static str {
    if holds { "holds" } else { "FAILS" }
}

/// Tip positions of a model, with the changes by another step and mesh, and the oracle's positions with four elements, if known.
pub fn tip(model: &Model, oracle: &Oracle) -> Table {
    let Mesh { other_elements, .. } = model.kind.mesh;
    let columns = format!(
        "t, s | x, m :.6 | y, m :.6 | twice the step :.1e | {other_elements} elements :.1e | oracle, 4 elements"
    );
    let known = oracle.find(model.kind.scene, model.kind.element, 4);
    let rows = model.rows().map(|row| {
        let [x, y] = row.tip;
        let known = known.map(|run| run.tip.at(row.t)).filter(|[x, _]| !x.is_nan());
        let known = known.map(|[x, y]| format!("({x:.6}, {y:.6})"));
        let changes = cells![row.change_with_twice_the_step, row.change_with_the_other_mesh];
        [cells![row.t.to_string(), x, y], changes, cells![known]].concat()
    });
    Table::new(&columns, rows)
}

/// Distances of the heated models' tips from the flexible one's, and from each other, of one start.
pub fn differences(models: &[Model], start: &str) -> Table {
    let of = |id: &str| models.iter().find(|model| model.kind.id == id);
    let distance = |t: f64, a: &str, b: &str| match (of(a), of(b)) {
        (Some(a), Some(b)) => 1e3 * a.tip.distance(t, b.tip.at(t)),
        _ => f64::NAN,
    };
    let [axis, plane, cable] = ["1d", "2d", "1d-eb"].map(|model| format!("{model}-{start}"));
    let row = |t: f64| {
        let flexible = [&axis, &plane].map(|model| distance(t, model, "flexible"));
        let heated = [&axis, &cable].map(|model| distance(t, &plane, model));
        cells![t.to_string(), flexible[0], flexible[1], heated[0], heated[1]]
    };
    Table::new("t, s | 1D–flexible :.3 | 2D–flexible :.3 | 2D–1D :.3 | 2D–1D Euler–Bernoulli :.3", TIMES.map(row))
}

/// Parts of the distance from the solid.
pub fn errors(rows: &[ErrorRow]) -> Table {
    let columns = "model | window | distance :.1e | space :.1e | time :.1e | solid's own :.1e | model, at least :.1e";
    let cells = |row: &ErrorRow| {
        let ErrorRow { model, window, distance, space, time, reference, model_error } = row;
        let model_error = Some(*model_error).filter(|error| *error > 0.0);
        cells![*model, window.to_string(), *distance, *space, *time, *reference, model_error]
    };
    Table::new(columns, rows.iter().map(cells))
}

/// The flexible tip's distance from the solid, without and with the effect of a shear correction factor.
pub fn shear(rows: &[ShearRow]) -> Table {
    let cells = |row: &ShearRow| cells![row.window.to_string(), row.distance, row.corrected];
    Table::new("window | distance :.1e | with a shear correction of 5/6 :.1e", rows.iter().map(cells))
}

/// a4 over time, with the changes by another step and mesh.
pub fn a4(rows: &[A4Row]) -> Table {
    let columns = "model | t, s | x, m :.6 | y, m :.6 | twice the step :.1e | half the elements :.1e";
    let cells = |row: &A4Row| {
        let changes = [row.change_with_twice_the_step, row.change_with_half_the_elements].map(Cell::from);
        [cells![row.model, row.t.to_string(), row.a4[0], row.a4[1]], changes.to_vec()].concat()
    };
    Table::new(columns, rows.iter().map(cells))
}

/// Energy balances, over the energy put in.
pub fn energies(rows: &[Balance]) -> Table {
    let cells = |row: &Balance| {
        let Balance { model, largest, input, bound } = row;
        cells![*model, *largest, *input, *bound, verdict(row.holds())]
    };
    let columns = "run | largest imbalance, J :.1e | energy put in, J :.1 | bound of their ratio :.0e | ";
    Table::new(columns, rows.iter().map(cells))
}
