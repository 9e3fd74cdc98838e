//! Heat that comes suddenly: waves that a step may not resolve, and a mesh may not either.
//!
//! The true error is taken at every row, 50 of them to 0.5 s, as the estimate is. The stored reference has two instants of them
//! (128 elements, two explicit methods agreed); between them it is 64 elements by `nystrom` at 2e-5 s, whose own distance from the limit
//! is known by a series of meshes (16, 32, 64 elements; each term at most the observed ratio of the last, or a quarter) and by half the
//! step, and which has to meet the stored one within both uncertainties.

use std::sync::OnceLock;

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{Path, builtin, positions};
use super::richardson::Halving;
use crate::error::{Error, Result};
use crate::error_time::case::Case as Timed;
use crate::error_time::reference::Reference;
use crate::error_time::samples::largest;
use ancf::model::{Element, Method, Scene};
use ancf::run::estimate::run_estimated;
use ancf::run::run;

pub const CASE: Case = Case {
    name: "heat-shock",
    parameter: "step, s (adaptive: tolerance, m)",
    unit: "m",
    reference: "the suddenly heated pendulum on 64 elements by `nystrom`, its distance from the limit by meshes of 16, 32, 64 and half the step, \
                within that of fixtures/converged/ at 0.25 and 0.5 s (128 elements, two explicit methods); the plane solid is at most \
                4.2e-4 m from it, the shear factor; largest over the 50 rows to 0.5 s",
    right: "with `--estimate`: a result only if the estimated error is at least the true one (with the reference's uncertainty); an error \
            where the estimate is over a tenth of the motion, a finer run fails, or the run itself does. Exudyn returns success with \
            the tip metres away at 1e-2 s and halved steps.",
    trials,
};

/// Steps (tolerances) that resolve the wave have to give a result: no method may make it easy by refusing all.
fn expected(method: Method, elements: usize, value: f64) -> Expected {
    let resolved = match method {
        Method::EnergyMomentum | Method::Gauss => 5e-4,
        Method::GeneralizedAlpha if elements <= 16 => 1e-4,
        // Its overshoot makes more of the shorter waves of a finer mesh.
        Method::GeneralizedAlpha => 0.0,
        _ => 1e-5,
    };
    if value <= resolved { Expected::Result } else { Expected::ResultOrRefusal }
}

const END: f64 = 0.5;
const INTERVAL: f64 = 0.01;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    let mut add = |method: Method, elements: usize, values: &[f64]| {
        for &value in values {
            let name = format!("{method}, {elements} elements");
            let trial = Trial::new(name, value, move || shock(method, elements, value));
            let exudyn = method == Method::GeneralizedAlpha && elements == 4 && value == 1e-2;
            // Those that are refused; the reference of others takes seconds.
            let fast = exudyn || (method == Method::EnergyMomentum && elements == 4 && value >= 5e-3);
            trials.push(trial.fast(fast).expect(expected(method, elements, value)));
        }
    };
    for elements in [4, 16, 64] {
        for method in [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Gauss] {
            add(method, elements, &[1e-2, 5e-3, 2.5e-3, 1e-3, 5e-4, 1e-4, 1e-5]);
        }
        for method in [Method::Explicit, Method::Nystrom] {
            add(method, elements, &[1e-2, 1e-3, 1e-4, 1e-5]);
        }
        for method in [Method::GaussAdaptive, Method::NystromAdaptive] {
            add(method, elements, &[1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
        }
    }
    Ok(trials)
}

fn scene(method: Method, elements: usize, value: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-2d")?;
    scene.rods[0].elements = elements;
    (scene.time.method, scene.time.end) = (method, END);
    if method.is_adaptive() {
        (scene.time.tolerance, scene.time.step) = (value, INTERVAL);
    } else {
        scene.time.step = value;
    }
    scene.output.interval = Some(INTERVAL);
    Ok(scene)
}

fn shock(method: Method, elements: usize, value: f64) -> Result<Finding> {
    let own = run_estimated(&scene(method, elements, value)?, |_| ())?;
    let Converged { path, uncertainty } = converged()?;
    let estimate = own.accuracy.total().unwrap_or(f64::NAN);
    Ok(Finding {
        error: largest(&positions(&own, "tip"), path),
        bound: estimate + uncertainty,
        why: format!("estimate {estimate:.1e}, the reference's uncertainty {uncertainty:.1e}"),
        size: 1.0,
        rounding: 0.0,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

/// The reference.
struct Converged {
    path: Path,
    uncertainty: f64,
}

/// Computed once.
fn converged() -> Result<&'static Converged> {
    static CONVERGED: OnceLock<std::result::Result<Converged, String>> = OnceLock::new();
    let found = CONVERGED.get_or_init(|| Converged::compute().map_err(|error| error.to_string()));
    found.as_ref().map_err(|reason| Error::Fixture { name: "heat-shock", reason: reason.clone() })
}

impl Converged {
    fn compute() -> Result<Converged> {
        let tip =
            |elements, step| -> Result<Path> { Ok(positions(&run(&scene(Method::Nystrom, elements, step)?)?, "tip")) };
        let (coarse, middle) = (tip(16, 2e-5)?, tip(32, 2e-5)?);
        let (path, finer) = (tip(64, 2e-5)?, tip(64, 1e-5)?);
        let meshes = Halving::new(largest(&coarse, &middle), largest(&middle, &path), 2);
        // What is left after the second term.
        let uncertainty = meshes.bound() - meshes.first - meshes.second + largest(&path, &finer);
        let case = Timed::named(&["pendulum-2d".into()])?[0];
        let stored = Reference::embedded(case, Element::Ancf)?;
        let row = |t: f64| path.get((t / INTERVAL).round() as usize).copied().unwrap_or([f64::NAN; 2]);
        let times: Vec<f64> = case.times().into_iter().filter(|t| *t <= END).collect();
        let own: Path = times.iter().map(|t| row(*t)).collect();
        let known = stored.solution().position.get(..times.len()).unwrap_or_default();
        let apart = largest(&own, known);
        if apart <= uncertainty + stored.converged.uncertainty {
            return Ok(Converged { path, uncertainty });
        }
        let reason = format!("64 elements ± {uncertainty:.1e} m are {apart:.1e} m from the stored reference");
        Err(Error::Fixture { name: "pendulum-2d-ancf.json", reason })
    }
}
