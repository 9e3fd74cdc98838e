//! What the cases share: scenes to change, paths to compare.

use crate::error::{Error, Result};
use ancf::integrators::counts::Counts;
use ancf::integrators::{State, integrator};
use ancf::model::plan::Plan;
use ancf::model::{Constraints, Element, Method, Scene};
use ancf::run::Run;
use ancf::structure::Structure;

/// Points over time.
pub type Path = Vec<[f64; 2]>;

/// A built-in scene.
pub fn builtin(name: &'static str) -> Result<Scene> {
    Scene::builtin(name).ok_or_else(|| Error::Fixture { name, reason: "there is no such scene".into() })
}

/// The two columns of a probe: `.x` and `.y`, or others.
pub fn columns(run: &Run, probe: &str, suffixes: [&str; 2]) -> Path {
    let column = |suffix: &str| run.trajectory.column(&format!("{probe}.{suffix}")).unwrap_or_default();
    let [x, y] = suffixes.map(column);
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

/// Positions of a probe.
pub fn positions(run: &Run, probe: &str) -> Path {
    columns(run, probe, ["x", "y"])
}

/// The last row of a column.
pub fn last(run: &Run, column: &str) -> f64 {
    run.trajectory.column(column).and_then(|values| values.last().copied()).unwrap_or(f64::NAN)
}

/// The largest |value| of a column; NaN where one is not a number or there is none.
pub fn largest(run: &Run, column: &str) -> f64 {
    let values = run.trajectory.column(column).unwrap_or_default();
    values.into_iter().map(f64::abs).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

/// Which method, with which constraints.
pub type How = (Method, Constraints);

/// All methods with a step of their own choice that no stability limit bounds.
pub const IMPLICIT: [How; 4] = [
    (Method::EnergyMomentum, Constraints::Condensed),
    (Method::GeneralizedAlpha, Constraints::Condensed),
    (Method::GeneralizedAlpha, Constraints::Multipliers),
    (Method::Gauss, Constraints::Condensed),
];

/// The words for a variant.
pub fn words((method, constraints): How, element: Element) -> String {
    let constraints = if constraints == Constraints::Multipliers { ", multipliers" } else { "" };
    let element = if element == Element::Ancf { String::new() } else { format!(", {element}") };
    format!("{method}{constraints}{element}")
}

/// ε_mach.
pub const EPS: f64 = f64::EPSILON;

/// The most Newton iterations that one step takes.
pub fn most_iterations(scene: &Scene) -> Result<usize> {
    let plan = Plan::of(scene);
    let structure = Structure::planned(scene, &plan)?;
    let (mut counts, mut most) = (Counts::default(), 0);
    let mut state = State::at_start(&structure);
    let mut method = integrator(scene, &plan, &structure, &state, &mut counts)?;
    for step in 1..=scene.steps() {
        let before = counts.newton_iterations;
        method.step(&structure, &mut state, scene.time_after(step), &mut counts)?;
        most = most.max(counts.newton_iterations - before);
    }
    Ok(most)
}
