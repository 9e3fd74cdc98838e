//! The steps of a run, one by one.

use crate::error::Result;
use ancf::integrators::Counts;
use ancf::integrators::State;
use ancf::internals::integrators::integrator;
use ancf::internals::model::Plan;
use ancf::internals::structure::Structure;
use ancf::model::Scene;

/// Makes all steps of a scene. Calls `after` at the start, as step 0, and after each step, with the work up to there.
pub fn each_step(scene: &Scene, mut after: impl FnMut(&Structure, &State, usize, &Counts)) -> Result<Counts> {
    let plan = Plan::of(scene);
    let structure = Structure::planned(scene, &plan)?;
    let mut counts = Counts::default();
    let mut state = State::at_start(&structure);
    let mut method = integrator(scene, &plan, &structure, &state, &mut counts)?;
    after(&structure, &state, 0, &counts);
    for step in 1..=scene.steps() {
        method.step(&structure, &mut state, scene.time_after(step), &mut counts)?;
        after(&structure, &state, step, &counts);
    }
    Ok(counts)
}
