//! Tables of the study: all points, and the economies.

use super::economies::Economy;
use super::point::Point;
use super::wording::{ratio_of, timing};
use crate::table::{Table, cells};

const COLUMNS: &str = "program,scene,element,method,elements,step,tolerance,newton_tolerance,error_position,error_velocity,error_reaction,\
                       energy_balance,error_time,error_space,reference_uncertainty,time_median_s,time_min_s,time_max_s,runs,steps,rejected,\
                       newton_iterations,force_calls,tangent_calls,factorizations,solves,status,reason";

/// `error-time.csv`: a row for each point; fields are empty if a run has failed or a program does not count.
pub fn points<'a>(points: impl Iterator<Item = &'a Point>) -> Table {
    let cells = |point: &Point| {
        let (errors, time, counts) = (point.errors.as_ref(), point.time.as_ref(), &point.counts);
        [
            cells![&*point.program, &*point.scene, &*point.element, &*point.method, point.elements],
            cells![point.step, point.tolerance, point.newton_tolerance],
            cells![errors.map(|e| e.position), errors.and_then(|e| e.velocity), errors.and_then(|e| e.reaction)],
            cells![errors.and_then(|e| e.energy), errors.and_then(|e| e.time), errors.and_then(|e| e.space)],
            cells![point.reference_uncertainty, time.map(|t| t.median), time.map(|t| t.min), time.map(|t| t.max)],
            cells![time.map_or(0, |t| t.runs), counts.steps, point.rejected, counts.newton_iterations],
            cells![counts.force_calls, counts.tangent_calls, counts.factorizations, counts.solves],
            cells![point.status.word(), &*point.reason],
        ]
        .concat()
    };
    Table::new(&COLUMNS.replace(',', " | "), points.map(cells))
}

/// The economies: run times with and without each part, their ratio, and the change of the results.
pub fn economies(economies: &[Economy]) -> Table {
    let cells = |Economy { what, scene, pruned, full, difference }: &Economy| {
        cells![*what, ratio_of(full, pruned), timing(full), timing(pruned), *difference, &**scene]
    };
    Table::new(
        "left out | time with it over time without | with it | without | change, m :.0e | scene",
        economies.iter().map(cells),
    )
}
