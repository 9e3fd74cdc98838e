//! Tables of the study: all points, and the economies.

use super::economies::Economy;
use super::point::Point;
use super::wording::{ratio_of, timing};
use crate::table::{Table, cells};

const COLUMNS: &str = "program,scene,element,method,elements,step,tolerance,newton_tolerance,error_position,error_between,error_interpolation,\
                       error_velocity,error_reaction,energy_balance,error_time,error_space,error_solid,reference_uncertainty,error_bound,time_median_s,\
                       time_lower_s,time_upper_s,runs,disturbed,in_turns,steps,rejected,\
                       newton_iterations,force_calls,tangent_calls,factorizations,solves,status,reason";

/// `error-time.csv`: a row for each point; fields are empty if a run has failed or a program does not count.
pub fn points<'a>(points: impl Iterator<Item = &'a Point>) -> Table {
    let cells = |point: &Point| {
        let (errors, time, counts) = (point.errors.as_ref(), point.time.as_ref(), &point.counts);
        [
            cells![&*point.program, &*point.scene, &*point.element, &*point.method, point.elements],
            cells![point.step, point.tolerance, point.newton_tolerance],
            cells![errors.map(|e| e.position), errors.map(|e| e.between), errors.map(|e| e.interpolation)],
            cells![errors.and_then(|e| e.velocity), errors.and_then(|e| e.reaction)],
            cells![errors.and_then(|e| e.energy), errors.and_then(|e| e.time), errors.and_then(|e| e.space)],
            cells![errors.and_then(|e| e.solid)],
            cells![point.reference_uncertainty, point.bound()],
            cells![time.map(|t| t.median), time.map(|t| t.lower), time.map(|t| t.upper)],
            cells![time.map_or(0, |t| t.runs), time.map_or(0, |t| t.disturbed), point.in_turns().to_string()],
            cells![counts.steps, point.rejected, counts.newton_iterations],
            cells![counts.force_calls, counts.tangent_calls, counts.factorizations, counts.solves],
            cells![point.status.word(), &*point.reason],
        ]
        .concat()
    };
    Table::new(&COLUMNS.replace(',', " | "), points.map(cells))
}

/// The economies: run times with and without each part, their ratio, and the change of the results.
pub fn economies(economies: &[Economy]) -> Table {
    let cells = |Economy { what, scene, without, with, difference }: &Economy| {
        cells![*what, ratio_of(with, without), timing(with), timing(without), *difference, &**scene]
    };
    Table::new(
        "left out | time with it over time without | with it | without | change, m :.0e | scene",
        economies.iter().map(cells),
    )
}
