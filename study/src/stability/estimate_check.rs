//! `--estimate` on the scenes of error against run time: estimated and true errors.

use super::prelude::*;
use crate::error_time::benchmark::Benchmark;
use crate::error_time::benchmarks::complete;
use crate::error_time::reference::Reference;
use crate::error_time::setup::{Record, Resolution, Setup};
use crate::error_time::technique::{Refinement, Technique};
use crate::path::{Path, column, largest_distance, positions};
use ancf::run::run_estimated;

pub const CASE: Case = Case {
    name: "estimate",
    parameter: "elements of a rod",
    unit: "of the allowed",
    reference: "fixtures/converged/: converged solutions of all scenes of `ancf error-time`, with their uncertainty",
    right: "estimate over true error between 1/2 and 20, the true one known to the reference's uncertainty. An estimate is twice the change by half \
            the step and twice the elements: at least the error if both halve it, 8/3 of it at order 2 (twice 3/4, for both parts at once; 20 \
            leaves room for parts that cancel by chance). The true error is known at the rows, and an estimate is the largest after any step: for \
            more than 20 its value at the rows counts. Or an error: the estimate is over a tenth of the motion, or a run fails.",
    trials,
};

/// Estimate over true error.
const LEAST: f64 = 0.5;
const MOST: f64 = 20.0;

fn trials() -> Vec<Trial> {
    let fits =
        |(benchmark, _, technique): &(&Benchmark, Element, &Technique)| technique.is_static() == benchmark.is_static();
    let solvers = iproduct!(complete(), ELEMENTS, Technique::of_each_method()).filter(fits);
    let trials = solvers.flat_map(|(benchmark, element, technique)| {
        iproduct!(meshes(benchmark), resolutions(benchmark, technique)).map(move |(&elements, resolution)| {
            let start = resolution.unwrap_or(Resolution::Steps(1));
            trial(Setup { benchmark, element, elements, technique, resolution: start }, resolution)
        })
    });
    trials.collect()
}

fn meshes(benchmark: &Benchmark) -> &'static [usize] {
    match benchmark.scene {
        "cantilever" => &[4, 8, 16, 32, 64],
        "scissors-3" | "scissors-3-thermal" => &[2],
        _ => &[4, 8],
    }
}

/// Coarse and fine steps; `None` for an explicit method, whose limit depends on the mesh.
fn resolutions(benchmark: &Benchmark, technique: &Technique) -> Vec<Option<Resolution>> {
    let scissors = benchmark.scene.starts_with("scissors");
    match technique.refinement {
        // Waves in steel need millions of explicit steps, and a finer mesh eight times as many.
        _ if scissors && technique.explicit => Vec::new(),
        Refinement::LoadSteps => vec![Some(Resolution::LoadSteps(2))],
        Refinement::Tolerance(_) => [1e-4, 1e-6].map(|tolerance| Some(Resolution::Tolerance(tolerance))).to_vec(),
        Refinement::Steps if technique.explicit => vec![None],
        Refinement::Steps if scissors => vec![Some(Resolution::Steps(32 * benchmark.coarsest))],
        Refinement::Steps => [8, 64].map(|parts| Some(Resolution::Steps(parts * benchmark.coarsest))).to_vec(),
    }
}

fn trial(setup: Setup, resolution: Option<Resolution>) -> Trial {
    let Setup { benchmark, element, elements, technique, .. } = setup;
    let words = match resolution {
        Some(Resolution::Steps(parts)) => format!(", step {:.1e} s", benchmark.interval / parts as f64),
        Some(Resolution::Tolerance(tolerance)) => format!(", tolerance {tolerance:.0e} m"),
        _ => String::new(),
    };
    let name = format!("{}, {element}, {}{words}", benchmark.scene, technique.method);
    let pendulum = benchmark.scene == "pendulum-flexible" && element == Element::Ancf && elements == 4;
    let fast = benchmark.is_static() && elements <= 16 || pendulum && resolution == Some(Resolution::Steps(64));
    let run = move || measure(setup, resolution.is_none());
    Trial::new(name, elements as f64, run).fast(fast).expect(Expected::ResultOrRefusal)
}

fn measure(mut setup: Setup, at_limit: bool) -> Result<Finding> {
    if at_limit {
        setup.resolution = setup.first_resolution()?;
    }
    // The study's tolerances are the economical ones; here only the errors of step and mesh count.
    let scene = setup.scene(Record::Position)?.newton(1e-10);
    let own = run_estimated(&scene, |_| ())?;
    let reference = Reference::embedded(setup.benchmark, setup.element)?;
    let uncertainty = reference.converged.uncertainty;
    // At the rows, all of which are instants of the reference.
    let times = setup.benchmark.times();
    let rows = column(&own, "t").into_iter().zip(positions(&own, setup.benchmark.probe)).filter(|(t, _)| *t > 0.0);
    let known = |t: f64| times.iter().position(|instant| (instant - t).abs() < 1e-9);
    let (known, its): (Path, Path) =
        rows.filter_map(|(t, position)| Some((reference.solution().position[known(t)?], position))).unzip();
    let true_error = largest_distance(&its, &known);
    let estimate = own.accuracy.total().unwrap_or(f64::NAN);
    let too_small = LEAST * (true_error - uncertainty) / estimate;
    let at_rows = own.accuracy.at_rows.unwrap_or(f64::NAN);
    let too_large = at_rows / (MOST * (true_error + uncertainty));
    // `f64::max` would drop a NaN.
    let error = if too_small.is_nan() || too_large.is_nan() { f64::NAN } else { too_small.max(too_large) };
    let why = format!(
        "estimate {estimate:.1e} m, {at_rows:.1e} m at the rows, true {true_error:.1e} ± {uncertainty:.0e} m: {:.2} and {:.2} times",
        estimate / true_error,
        at_rows / true_error
    );
    // A ratio between two limits has no size.
    let size = f64::INFINITY;
    Ok(Finding { error, bound: 1.0, why, size, ..Finding::of(own) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error_time::technique::TECHNIQUES;
    use ancf::internals::model::Words;

    #[test]
    fn every_scene_of_the_study_is_there_with_every_method() {
        let names: Vec<String> = trials().into_iter().map(|trial| trial.variant).collect();
        for benchmark in complete() {
            let scissors = benchmark.scene.starts_with("scissors");
            let fitting = |technique: &&Technique| {
                technique.is_static() == benchmark.is_static() && !(scissors && technique.explicit)
            };
            for technique in TECHNIQUES.iter().filter(fitting) {
                let its = |name: &&String| name.starts_with(benchmark.scene) && name.contains(technique.method.word());
                assert!(names.iter().filter(its).count() >= 2, "{}, {}", benchmark.scene, technique.method);
            }
        }
    }
}
