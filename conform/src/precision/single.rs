//! Errors of a system's solution in single precision, from the kit's own elimination in it.
//!
//! Rounded inputs do not show them all: constraints that fix every coordinate give an acceleration of zero for any masses and loads,
//! while an elimination leaves a residue.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::internals::state::SystemState;
use nalgebra::{DMatrix, DVector};

use crate::suite::{Case, State};

/// Error of each entry of a solution of (23), the larger of two usual ways; `None` for other quantities.
pub fn errors(quantity: &str, case: &Case) -> Option<Vec<f64>> {
    let State::System(system) = &case.state else { return None };
    let right = &case.values.get(quantity)?.numbers;
    let mut errors = vec![0.0; right.len()];
    for (acceleration, lambda) in [at_once(system)?, one_after_the_other(system)?] {
        let value = match quantity {
            "23.acceleration" => acceleration,
            "23.lambda" => lambda,
            _ => return None,
        };
        for (error, (value, right)) in errors.iter_mut().zip(value.iter().zip(right)) {
            *error = f64::max(*error, (f64::from(*value) - right).abs());
        }
    }
    Some(errors)
}

/// Accelerations and multipliers.
type Solution = (DVector<f32>, DVector<f32>);

/// Elimination of the whole system.
fn at_once(SystemState { m, kq, Phi_q, f, .. }: &SystemState) -> Option<Solution> {
    let (n, c) = (m.nrows(), Phi_q.nrows());
    let mut matrix = DMatrix::<f32>::zeros(n + c, n + c);
    matrix.view_mut((0, 0), (n, n)).copy_from(&m.map(|number| number as f32));
    matrix.view_mut((0, n), (n, c)).copy_from(&Phi_q.transpose().map(|number| number as f32));
    matrix.view_mut((n, 0), (c, n)).copy_from(&Phi_q.map(|number| number as f32));
    let mut load = DVector::<f32>::zeros(n + c);
    load.rows_mut(0, n).copy_from(&loads(kq, f));
    let solution = matrix.lu().solve(&load)?;
    Some((solution.rows(0, n).into_owned(), solution.rows(n, c).into_owned()))
}

/// λ from Φ_q m⁻¹ Φ_qᵀ λ = Φ_q m⁻¹ (f − k q), then the accelerations.
fn one_after_the_other(SystemState { m, kq, Phi_q, f, .. }: &SystemState) -> Option<Solution> {
    let (m, Phi_q) = (m.map(|number| number as f32).lu(), Phi_q.map(|number| number as f32));
    let load = loads(kq, f);
    let by_constraints = m.solve(&Phi_q.transpose())?;
    let lambda = (&Phi_q * by_constraints).lu().solve(&(&Phi_q * m.solve(&load)?))?;
    Some((m.solve(&(load - Phi_q.tr_mul(&lambda)))?, lambda))
}

fn loads(kq: &DVector<f64>, f: &DVector<f64>) -> DVector<f32> {
    f.map(|number| number as f32) - kq.map(|number| number as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::Suite;

    #[test]
    fn constraints_that_fix_everything_leave_a_residue() {
        let suite = Suite::embedded().unwrap();
        let solved =
            |case: &&Case| matches!(case.state, State::System(_)) && case.values.contains_key("23.acceleration");
        for case in suite.cases.iter().filter(solved) {
            let reference = &case.values["23.acceleration"];
            let errors = errors("23.acceleration", case).unwrap();
            let worst = errors.iter().zip(reference.terms()).map(|(error, terms)| error / terms).fold(0.0, f64::max);
            assert!(worst > 0.0 && worst < 1e-3, "{}: {worst}", case.id);
        }
    }
}
