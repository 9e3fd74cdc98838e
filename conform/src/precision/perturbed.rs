//! Effect of rounded inputs on a quantity, from the kit's own evaluation.

use ancf::internals::state::{SystemState, evaluate_system};
use ancf::state::{BeamState, evaluate, evaluate_cable};

use crate::suite::{Case, State};

/// Number of states that are tried.
const SAMPLES: u32 = 3;

/// Signs that look random and are the same in every run.
struct Signs(u32);

impl Signs {
    /// Multiplies a number by 1 ± `by`.
    fn perturb(&mut self, number: &mut f64, by: f64) {
        // Xorshift.
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        *number *= if self.0 & 0x1_0000 == 0 { 1.0 + by } else { 1.0 - by };
    }

    fn beam<const N: usize>(&mut self, state: &BeamState<N>, by: f64) -> BeamState<N> {
        let mut state = state.clone();
        let BeamState { l, h, w, theta, e0, e, edot, E, nu, rho, alpha, dT, points, gravity, model: _ } = &mut state;
        let numbers = [l, h, w, theta, E, nu, rho, alpha, dT].into_iter().chain(e0).chain(e).chain(edot).chain(gravity);
        numbers.chain(points.iter_mut().flatten()).for_each(|number| self.perturb(number, by));
        state
    }

    fn system(&mut self, state: &SystemState, by: f64) -> SystemState {
        let mut state = state.clone();
        let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = &mut state;
        let vectors = [q_ddot, kq, lambda, f].into_iter().flat_map(|vector| vector.iter_mut());
        m.iter_mut().chain(Phi_q.iter_mut()).chain(vectors).for_each(|number| self.perturb(number, by));
        state
    }
}

/// Largest change of each entry where the numbers of the state change by `by`, relative to each; `None` if the quantity has no value.
pub fn changes(quantity: &str, case: &Case, by: f64) -> Option<Vec<f64>> {
    let right = &case.values.get(quantity)?.numbers;
    let mut changes = vec![0.0; right.len()];
    for sample in 1..=SAMPLES {
        let mut signs = Signs(sample.wrapping_mul(0x9E37_79B9));
        let value = match &case.state {
            State::Element(state) => evaluate(quantity, &signs.beam(state, by)),
            State::Cable(state) => evaluate_cable(quantity, &signs.beam(state, by)),
            State::System(state) => evaluate_system(quantity, &signs.system(state, by)),
        }?;
        for (change, (perturbed, right)) in changes.iter_mut().zip(value.iter().zip(right)) {
            *change = f64::max(*change, (perturbed - right).abs());
        }
    }
    Some(changes)
}
