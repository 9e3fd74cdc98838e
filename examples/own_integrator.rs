//! A time-stepping method of one's own: symplectic Euler, for a pendulum.
//!
//! `cargo run --release --example own_integrator`

use ancf::error::Result;
use ancf::integrators::{Counts, EquationOfMotion, Integrator, State, check_end};
use ancf::internals::structure::Structure;
use ancf::model::Scene;
use ancf::run::Simulation;

/// v₁ = v₀ + Δt q̈(u₀, t₀), u₁ = u₀ + Δt v₁: of order one, stable up to Δt = 2/ω.
struct SymplecticEuler {
    step: f64,
    motion: EquationOfMotion,
}

impl Integrator for SymplecticEuler {
    fn step(&mut self, structure: &Structure, state: &mut State, t_1: f64, counts: &mut Counts) -> Result<()> {
        check_end(state.t, self.step, t_1)?;
        self.motion.accelerate(structure, &state.u, state.t, counts);
        state.v.axpy(self.step, &self.motion.a, 1.0);
        state.u.axpy(self.step, &state.v, 1.0);
        state.advance(t_1);
        counts.steps += 1;
        Ok(())
    }
}

/// Tip of the flexible pendulum after 0.5 s, m.
fn tip(step: f64) -> Result<[f64; 2]> {
    let mut scene = Scene::builtin("pendulum-flexible").expect("it is built in").until(0.5);
    scene.time.step = step;
    scene.output.interval = Some(0.1);
    let mut pendulum = Simulation::with_integrator(scene.build()?, |structure, _, counts| {
        let motion = EquationOfMotion::new(structure, counts)?;
        Ok(Box::new(SymplecticEuler { step, motion }))
    })?;
    pendulum.run_until(0.5)?;
    pendulum.position("a")
}

fn main() -> Result<()> {
    let mut before: Option<[f64; 2]> = None;
    for step in [4e-5, 2e-5, 1e-5] {
        let [x, y] = tip(step)?;
        let change = before
            .map_or(String::new(), |[x_0, y_0]| format!(", {:.1e} m from the one before", (x - x_0).hypot(y - y_0)));
        println!("step {step:e} s: tip at ({x:.6}, {y:.6}) m{change}");
        before = Some([x, y]);
    }
    Ok(())
}
