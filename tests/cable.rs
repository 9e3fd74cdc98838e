//! `elements::Cable` is the element of `equations::cable` on random states; and the forces of an energy–momentum step, which only
//! it has, do exactly the work that they must, though its strains are no polynomials.

#![allow(non_snake_case)] // The symbols of the literature are names here.

mod common;
#[path = "common/side_by_side.rs"]
mod side_by_side;
#[path = "common/states.rs"]
mod states;

use ancf::equations::cable::{self, Matrix8, Vector8};
use ancf::internals::elements::{Beam, Cable, Ends};
use ancf::state::{CableState, ThermalModel};
use common::cable::{cables, scale};
use common::evidence;
use common::{TOLERANCE, within, worst_ratio};
use nalgebra::{Rotation2, SMatrix, Vector2};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use side_by_side::{Four, TermSizes};
use states::{assert_within, cases, compared};

/// Energy, force and tangent in every state of the fixture: nothing of `equations` takes part.
#[test]
fn the_kernel_meets_the_oracle() {
    let mut failures = Vec::new();
    for case in common::cases::<CableState>(&cables(), 20) {
        let s = &case.state;
        let kernel = Cable::new(s.l, s.theta, s.E * s.h * s.w, s.E * s.w * s.h.powi(3) / 12.0);
        let eps_T = [if s.model == ThermalModel::None { 0.0 } else { s.alpha * s.dT }, 0.0];
        let u = Vector8::from(s.e) - Vector8::from(s.e0);
        for (quantity, actual) in [
            ("cable.U", vec![kernel.energy(&u, eps_T)]),
            ("cable.Q_e", kernel.force(&u, eps_T).as_slice().to_vec()),
            ("cable.tangent", rows(&kernel.tangent(&u, eps_T))),
        ] {
            let (expected, scale) = (case.value(quantity), scale(quantity, &case));
            if !within(TOLERANCE, &actual, &expected, &scale) {
                failures.push(format!("{quantity} {}: {:.1e}", case.id, worst_ratio(&actual, &expected, &scale)));
            }
        }
    }
    assert!(failures.is_empty(), "{} values miss the oracle:\n{}", failures.len(), failures.join("\n"));
}

/// An element, two displacements a step apart, and their thermal strains.
#[derive(Clone, Debug)]
struct State {
    l: f64,
    theta: f64,
    EA: f64,
    EI: f64,
    u: [Vector8; 2],
    eps_T: [f64; 2],
}

/// Any inclination, stubby to slender; the axis is at least half as long as at first, so that curvature stays finite.
fn states() -> impl Strategy<Value = State> {
    let u = |l: f64| {
        prop::array::uniform8(-1.0..1.0).prop_map(move |unit: [f64; 8]| {
            // Positions 0 and 2 of the four nodal vectors. Hermite's derivatives sum up to |r_x − t| ≤ 3 · 0.05 + 2 · 0.12 …
            Vector8::from_fn(|row, _| unit[row] * if row % 4 < 2 { 0.05 * l } else { 0.12 })
        })
    };
    (0.1..5.0, -3.2..3.2, 1.0..1e9, 1.0..300.0).prop_flat_map(move |(l, theta, EA, slenderness)| {
        let EI = EA * f64::powi(l / slenderness, 2) / 12.0;
        ([u(l), u(l)], [-0.3..0.3, -0.3..0.3]).prop_map(move |(u, eps_T)| State { l, theta, EA, EI, u, eps_T })
    })
}

impl State {
    fn cable(&self) -> Cable {
        Cable::new(self.l, self.theta, self.EA, self.EI)
    }

    fn turned(&self, u: &Vector8) -> Vector8 {
        let R = Rotation2::new(self.theta);
        let vector = |n: usize| R * Vector2::new(u[2 * n], u[2 * n + 1]);
        Vector8::from_fn(|row, _| vector(row / 2)[row % 2])
    }

    fn u(&self, n: usize) -> Vector8 {
        self.turned(&self.u[n])
    }

    fn e_0(&self) -> Vector8 {
        self.turned(&Vector8::from([0.0, 0.0, 1.0, 0.0, self.l, 0.0, 1.0, 0.0]))
    }

    fn ends<'a>(&self, u: &'a [Vector8; 2]) -> Ends<'a, Vector8> {
        Ends { u_0: &u[0], u_1: &u[1], thermal_0: [self.eps_T[0], 0.0], thermal_1: [self.eps_T[1], 0.0] }
    }

    /// Largest energy of what the strain is made of: stretches of 2, curvatures of 50/l over the shortest axis.
    fn energy(&self) -> f64 {
        self.EA * self.l + 50f64.powi(2) * self.EI / self.l
    }

    /// … and forces: an energy over the length that a coordinate of 1 strains by 1.
    fn force(&self) -> [f64; 8] {
        std::array::from_fn(|row| 6.0 * self.energy() / if row % 4 < 2 { self.l } else { 1.0 })
    }

    fn tangent(&self) -> Vec<f64> {
        let force = self.force();
        force.iter().flat_map(|a| force.map(|b| a * b / self.energy())).collect()
    }
}

fn rows(matrix: &Matrix8) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn the_kernel_is_the_equations_cable(s in states()) {
        let State { l, EA, EI, eps_T: [eps_T, _], .. } = s;
        let (kernel, u, e) = (s.cable(), s.u(0), s.u(0) + s.e_0());
        assert_within("U", &[kernel.energy(&u, [eps_T, 0.0])], &[cable::U(&e, eps_T, EA, EI, l)], &[s.energy()]);
        let Q = cable::Q_e(&e, eps_T, EA, EI, l);
        assert_within("Q_e", kernel.force(&u, [eps_T, 0.0]).as_slice(), Q.as_slice(), &s.force());
        let K = cable::tangent(&e, eps_T, EA, EI, l);
        assert_within("∂Q_e/∂e", &rows(&kernel.tangent(&u, [eps_T, 0.0])), &rows(&K), &s.tangent());
    }

    /// Elements side by side are the elements one by one, on every path: each lane has its own displacement and heat.
    #[test]
    fn elements_side_by_side_are_the_same(s in states()) {
        let (kernel, shares, mass) = (s.cable(), [1.0, -0.5, 0.25, 0.0], cable::M(1.0, s.l));
        let four = Four {
            beam: &kernel,
            mass: &mass,
            u: [shares.map(|share| share * s.u(0)), shares.map(|share| 0.5 * (1.0 + share) * s.u(1))],
            eps_T: s.eps_T.map(|strain| shares.map(|share| [share * strain, 0.0])),
        };
        four.assert_each_is_itself(&TermSizes { force: &s.force(), energy: s.energy(), det_j: 50.0 });
    }

    /// Heat across the rod finds no section to thicken.
    #[test]
    fn only_axial_heat_counts(s in states(), across in -1.0..1.0) {
        let (kernel, u) = (s.cable(), s.u(0));
        prop_assert_eq!(kernel.force(&u, [s.eps_T[0], across]), kernel.force(&u, [s.eps_T[0], 0.0]));
    }

    /// Q̄·(u₁ − u₀) + heating work = U₁ − U₀.
    #[test]
    fn the_mean_force_does_the_work_of_the_step(s in states()) {
        let (kernel, u) = (s.cable(), [s.u(0), s.u(1)]);
        let ends = s.ends(&u);
        let work = kernel.mean_force(&ends).dot(&(u[1] - u[0]));
        let change = kernel.energy(&u[1], ends.thermal_1) - kernel.energy(&u[0], ends.thermal_0);
        assert_within("work", &[work + kernel.heating_work(&ends)], &[change], &[4.0 * s.energy()]);
    }

    /// The step's force turns with the element and does no work on a rigid turn of its middle: angular momentum is kept.
    #[test]
    fn the_mean_force_has_no_moment(s in states()) {
        let u = [s.u(0), s.u(1)];
        let Q = s.cable().mean_force(&s.ends(&u));
        let middle = 0.5 * (u[0] + u[1]) + s.e_0();
        let moments = (0..4).map(|n| middle[2 * n] * Q[2 * n + 1] - middle[2 * n + 1] * Q[2 * n]);
        assert_within("moment", &[moments.sum()], &[0.0], &[20.0 * s.energy()]);
    }

    /// Against differences, extrapolated until their own error is of order 1e-9.
    #[test]
    fn the_mean_tangent_is_a_derivative(s in states()) {
        let (kernel, u) = (s.cable(), [s.u(0), s.u(1)]);
        let difference = |column: usize, step: f64| {
            let at = |by: f64| {
                let mut moved = u;
                moved[1][column] += by;
                kernel.mean_force(&s.ends(&moved))
            };
            (at(step) - at(-step)) / (2.0 * step)
        };
        let columns: [Vector8; 8] = std::array::from_fn(|column| {
            let step = if column % 4 < 2 { 1e-3 * s.l } else { 1e-3 };
            let [d_1, d_2, d_4] = [1.0, 2.0, 4.0].map(|n| difference(column, n * step));
            // Errors of order step² and step⁴ removed (Richardson).
            let [e_1, e_2] = [(4.0 * d_1 - d_2) / 3.0, (4.0 * d_2 - d_4) / 3.0];
            (16.0 * e_1 - e_2) / 15.0
        });
        let (tangent, expected) = (kernel.mean_tangent(&s.ends(&u)), SMatrix::from_columns(&columns));
        for ((actual, expected), scale) in rows(&tangent).iter().zip(rows(&expected)).zip(s.tangent()) {
            prop_assert!((actual - expected).abs() <= 1e-10 * scale, "{actual:e} for {expected:e} of {scale:e}");
        }
    }

    /// With both ends equal Q̄ is Q_e, and each end has half of its derivative.
    #[test]
    fn a_step_of_nothing_is_the_element_itself(s in states()) {
        let (kernel, u, eps_T) = (s.cable(), s.u(0), [s.eps_T[0], 0.0]);
        let ends = Ends { u_0: &u, u_1: &u, thermal_0: eps_T, thermal_1: eps_T };
        let (Q, K) = (kernel.force(&u, eps_T), kernel.tangent(&u, eps_T));
        assert_within("Q̄", kernel.mean_force(&ends).as_slice(), Q.as_slice(), &s.force());
        assert_within("∂Q̄/∂u₁", &rows(&kernel.mean_tangent(&ends)), &rows(&(0.5 * K)), &s.tangent());
        prop_assert_eq!(kernel.heating_work(&ends), 0.0);
    }

    /// The force of a stretch of 1e-10 keeps its digits: N = EA s to 1e-13 of itself.
    #[test]
    fn small_strains_keep_their_digits(theta in -3.2..3.2, exponent in -14.0..-1.0) {
        let (l, EA) = (2.0, 2e6);
        let stretch = 10f64.powf(exponent);
        let t = Vector2::new(f64::cos(theta), f64::sin(theta));
        let [x, y] = (stretch * t).into();
        let u = Vector8::from([0.0, 0.0, x, y, l * x, l * y, x, y]);
        let Q = Cable::new(l, theta, EA, 1.0).force(&u, [0.0; 2]);
        let N = EA * stretch;
        prop_assert!((Q[4] * t.x + Q[5] * t.y - N).abs() <= 1e-13 * N);
        prop_assert!((Q[0] * t.x + Q[1] * t.y + N).abs() <= 1e-13 * N);
    }
}

/// Forces and tangents in 10,000 random states: within 1e-13 of the terms that are added up (measured 1.0e-16 and 4.6e-17), and
/// within 1e-12 of the largest entry (measured 7.8e-14 and 1.9e-15).
#[test]
fn ten_thousand_states() {
    let mut runner = TestRunner::deterministic();
    let mut worst = [0.0f64; 4];
    for _ in 0..10_000 {
        let s = states().new_tree(&mut runner).unwrap().current();
        let State { l, EA, EI, eps_T: [eps_T, _], .. } = s;
        let (kernel, u, e) = (s.cable(), s.u(0), s.u(0) + s.e_0());
        let Q = cable::Q_e(&e, eps_T, EA, EI, l);
        let K = cable::tangent(&e, eps_T, EA, EI, l);
        let (force, tangent) = (kernel.force(&u, [eps_T, 0.0]), rows(&kernel.tangent(&u, [eps_T, 0.0])));
        let ratios = compared([force.as_slice(), &tangent], [Q.as_slice(), &rows(&K)], [&s.force(), &s.tangent()]);
        worst = std::array::from_fn(|n| worst[n].max(ratios[n]));
    }
    let [force, tangent, force_entry, tangent_entry] = worst;
    for (name, value) in
        [("force", force), ("tangent", tangent), ("force-entry", force_entry), ("tangent-entry", tangent_entry)]
    {
        evidence::at_most(&format!("cable.{name}"), value);
    }
    assert!(force_entry <= 1e-12 && tangent_entry <= 1e-12);
}
