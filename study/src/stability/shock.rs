//! Sudden heat: waves that a step may not resolve, and a mesh may not either.
//!
//! The true error is taken at every row, 50 of them to 0.5 s, as the estimate is. The stored reference has only two of these instants (128
//! elements, two explicit methods agreed). In between, the reference is a run with 64 elements by `nystrom` at 2e-5 s. Its distance from
//! the limit is bounded by a series of meshes (16, 32, 64 elements; each term at most the observed ratio of the last, or a quarter) and by
//! half the step. It has to meet the stored reference within both uncertainties.

use std::sync::OnceLock;

use super::prelude::*;
use super::richardson::Series;
use crate::error_time::benchmarks::of;
use crate::error_time::reference::Reference;
use crate::paper::tip::Tip;
use ancf::run::run_estimated;

pub const CASE: Case = Case {
    name: "heat-shock",
    parameter: "step, s (adaptive: tolerance, m)",
    unit: "m",
    reference: "the suddenly heated pendulum on 64 elements by `nystrom`, its distance from the limit by meshes of 16, 32, 64 and half the step, \
                within that of fixtures/converged/ at 0.25 and 0.5 s (128 elements, two explicit methods); the plane solid is at most \
                4.2e-4 m from it, the shear factor; largest over the 50 rows to 0.5 s",
    right: "with `--estimate`: a result only if the estimated error is at least the true one (with the reference's uncertainty); an error if the \
            estimate is over a tenth of the motion, a finer run fails, or the run itself does. Exudyn returns success with the tip metres away at \
            1e-2 s and halved steps.",
    trials,
};

/// Steps (tolerances) that resolve the wave have to give a result: refusing all is not enough.
fn expected(method: Method, elements: usize, value: f64) -> Expected {
    let resolved = match method {
        Method::EnergyMomentum | Method::Gauss => 5e-4,
        Method::GeneralizedAlpha if elements <= 16 => 1e-4,
        // Its overshoot amplifies the shorter waves of a finer mesh.
        Method::GeneralizedAlpha => 0.0,
        _ => 1e-5,
    };
    Expected::result_if(value <= resolved)
}

const END: f64 = 0.5;
const INTERVAL: f64 = 0.01;

fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    let mut add = |method: Method, elements: usize, values: &[f64]| {
        for &value in values {
            let name = format!("{method}, {elements} elements");
            let trial = Trial::new(name, value, move || shock(method, elements, value));
            // Only refused ones: others need the reference, which takes seconds.
            let fast = elements == 4
                && (method == Method::GeneralizedAlpha && value == 1e-2
                    || method == Method::EnergyMomentum && value >= 5e-3);
            trials.push(trial.fast(fast).expect(expected(method, elements, value)));
        }
    };
    for elements in [4, 16, 64] {
        // An estimate is made of some six runs: 50,000 implicit steps of 64 elements, six times, would take minutes and are a tenth of the
        // step that the wave through an element asks for.
        let shortest = if elements < 64 { 1e-5 } else { 1e-4 };
        let steps = [1e-2, 5e-3, 2.5e-3, 1e-3, 5e-4, 1e-4, 1e-5];
        let steps = steps.iter().copied().filter(|step| *step >= shortest).collect::<Vec<_>>();
        for method in [Method::EnergyMomentum, Method::GeneralizedAlpha, Method::Gauss] {
            add(method, elements, &steps);
        }
        for method in [Method::Explicit, Method::Nystrom] {
            add(method, elements, &[1e-2, 1e-3, 1e-4, 1e-5]);
        }
        for method in [Method::GaussAdaptive, Method::NystromAdaptive] {
            add(method, elements, &[1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
        }
    }
    trials
}

fn scene(method: Method, elements: usize, value: f64) -> Result<Scene> {
    let step = if method.is_adaptive() { INTERVAL } else { value };
    let mut scene =
        builtin("pendulum-2d")?.meshed(Element::Ancf, elements).solved(method, step, END).rows_every(INTERVAL);
    if method.is_adaptive() {
        scene.time.tolerance = value;
    }
    Ok(scene)
}

fn shock(method: Method, elements: usize, value: f64) -> Result<Finding> {
    let own = run_estimated(&scene(method, elements, value)?, |_| ())?;
    let Converged { path, uncertainty } = converged()?;
    let estimate = own.accuracy.total().unwrap_or(f64::NAN);
    let error = largest_distance(&tip(&own), path);
    let why = format!("estimate {estimate:.1e}, uncertainty of the reference {uncertainty:.1e}");
    Ok(Finding { error, bound: estimate + uncertainty, why, ..Finding::of(own) })
}

/// The reference at every row.
struct Converged {
    path: Path,
    uncertainty: f64,
}

/// The reference, computed once.
fn converged() -> Result<&'static Converged> {
    static CONVERGED: OnceLock<std::result::Result<Converged, String>> = OnceLock::new();
    let found = CONVERGED.get_or_init(|| Converged::compute().map_err(|error| error.to_string()));
    found.as_ref().map_err(|reason| Error::fixture("heat-shock", reason))
}

impl Converged {
    fn compute() -> Result<Converged> {
        let run = |elements, step| Ok::<_, Error>(run(&scene(Method::Nystrom, elements, step)?)?);
        let (coarse, middle) = (tip(&run(16, 2e-5)?), tip(&run(32, 2e-5)?));
        let (finest, finer) = (run(64, 2e-5)?, tip(&run(64, 1e-5)?));
        let path = tip(&finest);
        let meshes = Series::new(largest_distance(&coarse, &middle), largest_distance(&middle, &path), 2);
        let uncertainty = meshes.rest() + largest_distance(&path, &finer);
        let benchmark = of("pendulum-2d")?;
        let stored = Reference::embedded(benchmark, Element::Ancf)?;
        let own = Tip::of(&finest);
        let instants = stored.rows(benchmark, stored.finest()).filter(|(t, _)| *t <= END);
        let (own, known): (Path, Path) = instants.map(|(t, known)| (own.at(t), known)).unzip();
        let apart = largest_distance(&own, &known);
        if apart <= uncertainty + stored.converged.uncertainty {
            return Ok(Converged { path, uncertainty });
        }
        let reason = format!("64 elements ± {uncertainty:.1e} m are {apart:.1e} m from the stored reference");
        Err(Error::fixture("pendulum-2d-ancf.json", reason))
    }
}
