//! `--estimate` on the scenes of the study of error against run time: estimated errors beside true ones.

use super::case::{Case, Expected, Finding, Trial};
use crate::error::Result;
use crate::error_time::case::{CASES, Case as Timed, ELEMENTS};
use crate::error_time::reference::Reference;
use crate::error_time::samples::Samples;
use crate::error_time::technique::{Drive, Technique};
use crate::error_time::trial::{Record, Setting, Trial as Run};
use ancf::model::Element;
use ancf::run::estimate::run_estimated;

pub const CASE: Case = Case {
    name: "estimate",
    parameter: "elements of a rod",
    unit: "of what is allowed",
    reference: "fixtures/converged/: converged solutions of all scenes of `ancf error-time`, with their uncertainty",
    right: "estimate over true error between 1/2 and 20, the true one known to the reference's uncertainty. An estimate is twice what half \
            the step and twice the elements change: at least the error where both halve it, 8/3 of it at order 2 (twice 3/4, both ways \
            of being off at once: 20 leaves room for parts that cancel by luck). The true error is known at the rows, and an estimate is the largest \
            after any step: more than 20 counts what it is at the rows. Or an error: the estimate is over a tenth of the motion, or \
            a run fails.",
    trials,
};

/// Estimate over true error.
const LEAST: f64 = 0.5;
const MOST: f64 = 20.0;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for case in &CASES {
        for element in ELEMENTS {
            for technique in Technique::of_each_method().filter(|technique| technique.is_static() == case.is_static()) {
                for &elements in meshes(case) {
                    for setting in settings(case, technique) {
                        trials.push(trial(case, element, technique, elements, setting));
                    }
                }
            }
        }
    }
    Ok(trials)
}

fn meshes(case: &Timed) -> &'static [usize] {
    match case.scene {
        "cantilever" => &[4, 8, 16, 32, 64],
        "scissors-3" | "scissors-3-thermal" => &[2],
        _ => &[4, 8],
    }
}

/// Coarse and fine steps; `None` for an explicit method, whose limit depends on the mesh.
fn settings(case: &Timed, technique: &Technique) -> Vec<Option<Setting>> {
    let scissors = case.scene.starts_with("scissors");
    match technique.drive {
        // Waves in steel ask for millions of explicit steps, and a finer mesh for eight times as many.
        _ if scissors && technique.explicit => Vec::new(),
        Drive::LoadSteps => vec![Some(Setting::LoadSteps(2))],
        Drive::Tolerances(_) => [1e-4, 1e-6].map(|tolerance| Some(Setting::Tolerance(tolerance))).to_vec(),
        Drive::Steps if technique.explicit => vec![None],
        Drive::Steps if scissors => vec![Some(Setting::Steps(32 * case.coarsest))],
        Drive::Steps => [8, 64].map(|parts| Some(Setting::Steps(parts * case.coarsest))).to_vec(),
    }
}

fn trial(
    case: &'static Timed,
    element: Element,
    technique: &'static Technique,
    elements: usize,
    setting: Option<Setting>,
) -> Trial {
    let words = match setting {
        Some(Setting::Steps(parts)) => format!(", step {:.1e} s", case.interval / parts as f64),
        Some(Setting::Tolerance(tolerance)) => format!(", tolerance {tolerance:.0e} m"),
        _ => String::new(),
    };
    let name = format!("{}, {element}, {}{words}", case.scene, technique.method);
    let run = move || measure(case, element, technique, elements, setting);
    let pendulum = case.scene == "pendulum-flexible" && element == Element::Ancf && elements == 4;
    let fast =
        case.is_static() && elements <= 16 || pendulum && matches!(setting, Some(Setting::Steps(parts)) if parts == 64);
    Trial::new(name, elements as f64, run).fast(fast).expect(Expected::ResultOrRefusal)
}

fn measure(
    case: &'static Timed,
    element: Element,
    technique: &'static Technique,
    elements: usize,
    setting: Option<Setting>,
) -> Result<Finding> {
    let mut run = Run { case, element, elements, technique, setting: setting.unwrap_or(Setting::Steps(1)) };
    if setting.is_none() {
        run.setting = run.first_setting()?;
    }
    let mut scene = run.scene(Record::Position)?;
    // The study's tolerances are those that pay; here the step and the mesh are looked at.
    scene.time.newton_tolerance = 1e-10;
    let own = run_estimated(&scene, |_| ())?;
    let reference = Reference::embedded(case, element)?;
    let finest = reference.meshes.last().map(|mesh| mesh.samples.clone()).unwrap_or_default();
    let (off, doubt) = (Samples::of(case, &own).distance(&finest), reference.converged.uncertainty);
    let estimate = own.accuracy.total().unwrap_or(f64::NAN);
    let too_small = LEAST * (off - doubt) / estimate;
    let at_rows = own.accuracy.at_rows.unwrap_or(f64::NAN);
    let too_large = at_rows / (MOST * (off + doubt));
    // `f64::max` would drop a NaN.
    let error = if too_small.is_nan() || too_large.is_nan() { f64::NAN } else { too_small.max(too_large) };
    Ok(Finding {
        error,
        bound: 1.0,
        why: format!(
            "estimate {estimate:.1e} m, {at_rows:.1e} m at the rows, true {off:.1e} ± {doubt:.0e} m: {:.2} and {:.2} times",
            estimate / off,
            at_rows / off
        ),
        // A ratio between two limits has no size.
        size: f64::INFINITY,
        rounding: 0.0,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error_time::technique::TECHNIQUES;

    #[test]
    fn every_scene_of_the_study_is_there_with_every_method() {
        let names: Vec<String> = trials().unwrap().into_iter().map(|trial| trial.variant).collect();
        for case in &CASES {
            let scissors = case.scene.starts_with("scissors");
            let fitting =
                |technique: &&Technique| technique.is_static() == case.is_static() && !(scissors && technique.explicit);
            for technique in TECHNIQUES.iter().filter(fitting) {
                let its = |name: &&String| name.starts_with(case.scene) && name.contains(technique.method.word());
                assert!(names.iter().filter(its).count() >= 2, "{}, {}", case.scene, technique.method);
            }
        }
    }
}
