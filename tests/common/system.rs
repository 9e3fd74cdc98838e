//! `fixtures/structure.json`: the terms of (23), and the size of what is added up for its quantities.

use ancf::internals::state::SystemState;
use nalgebra::{DMatrix, DVector};
use serde_json::Value;

use super::{flatten, read};

/// The fixture.
pub fn systems() -> Value {
    read("structure.json")
}

/// One case: the oracle's terms of (23), and its values.
pub struct Terms<'a> {
    pub id: &'a str,
    pub case: &'a Value,
    pub state: SystemState,
}

impl Terms<'_> {
    pub fn read(case: &Value) -> Terms<'_> {
        let given = |name: &str| numbers(&case["state"][name]);
        let value = |name: &str| numbers(&case["values"][name]["f64"]);
        let q_ddot = DVector::from_vec(given("q_ddot"));
        let lambda = DVector::from_vec(given("lambda"));
        let (n, c) = (q_ddot.len(), lambda.len());
        let state = SystemState {
            m: DMatrix::from_row_slice(n, n, &value("23.m")),
            kq: DVector::from_vec(value("23.Q_e")),
            Phi_q: DMatrix::from_row_slice(c, n, &value("23.Phi_q")),
            f: DVector::from_vec(value("23.f")),
            q_ddot,
            lambda,
        };
        Terms { id: case["id"].as_str().unwrap(), case, state }
    }

    pub fn has(&self, quantity: &str) -> bool {
        !self.case["values"][quantity].is_null()
    }

    /// A quantity's numbers (nearest f64), row by row.
    pub fn value(&self, quantity: &str) -> Vec<f64> {
        numbers(&self.case["values"][quantity]["f64"])
    }

    /// Size of the terms that are added up for a quantity, entry by entry.
    pub fn scale(&self, quantity: &str) -> Vec<f64> {
        let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = &self.state;
        let force = Phi_q.abs().transpose() * lambda.abs();
        let inertia = m.abs() * q_ddot.abs();
        let printed = || Phi_q.abs() * lambda.abs();
        let sum = |force: DVector<f64>| inertia.clone() + kq.abs() + force + f.abs();
        let scale = match quantity {
            "23.constraint_force" => force,
            "23.constraint_force/printed" => printed(),
            "23.residual" => sum(force),
            "23.residual/printed" => sum(printed()),
            "23.acceleration" => self.solution_scale().rows(0, kq.len()).into_owned(),
            "23.lambda" => self.solution_scale().rows(kq.len(), lambda.len()).into_owned(),
            _ => panic!("no scale for {quantity}"),
        };
        // Where no term stands the value is exactly zero.
        scale.iter().map(|s| s.max(f64::MIN_POSITIVE)).collect()
    }

    /// N |A⁻¹| (|A| |x| + |b|): what rounding the matrix and the load of A x = b by one unit can change, once in each of the N
    /// eliminations; and for accelerations, which constraints may hold at zero, what they would be without constraints.
    pub fn solution_scale(&self) -> DVector<f64> {
        let SystemState { m, kq, Phi_q, f, .. } = &self.state;
        let (n, c) = (m.nrows(), Phi_q.nrows());
        let A = DMatrix::from_fn(n + c, n + c, |i, j| match (i < n, j < n) {
            (true, true) => m[(i, j)],
            (true, false) => Phi_q[(j - n, i)],
            (false, true) => Phi_q[(i - n, j)],
            (false, false) => 0.0,
        });
        let x = DVector::from_vec([self.value("23.acceleration"), self.value("23.lambda")].concat());
        let b = DVector::from_fn(n + c, |i, _| if i < n { kq[i].abs() + f[i].abs() } else { 0.0 });
        let mut scale = A.clone().try_inverse().unwrap().abs() * (A.abs() * x.abs() + b);
        let mut accelerations = scale.rows_mut(0, n);
        accelerations += m.clone().try_inverse().unwrap().abs() * (kq.abs() + f.abs());
        (n + c) as f64 * scale
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    let mut numbers = Vec::new();
    flatten(value, &mut numbers);
    numbers
}
