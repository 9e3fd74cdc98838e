//! What must hold for every element in every state: invariance, balance, derivatives, exact integration.
//!
//! A tolerance is `TOLERANCE`, 45 roundings, times the size of the terms that were added up (`Sizes`).

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;
#[path = "common/states.rs"]
mod states;

use ancf::equations::element::{Element, Matrix14};
use ancf::equations::material::LameConstants;
use ancf::equations::shape::{self, Vector14};
use ancf::equations::{force, inertia, strain};
use ancf::internals::equations::volume;
use common::TOLERANCE;
use nalgebra::{Vector2, Vector3};
use proptest::prelude::*;
use states::{
    Energy, K, POSITIONS, Sizes, Stiffness, assert_within, cases, five_point, moved, rows, states, turned, uniform,
    unit,
};

/// Largest terms of S over the element by nodal vector, and so of r = Σ S e; by hand from (3).
fn sizes_of_S(element: &Element) -> [f64; 14] {
    let Element { l, h, .. } = *element;
    let N = [1.0, h / 2.0, 1.0, l, h / 2.0, 1.0, h / 2.0];
    std::array::from_fn(|i| N[i / 2])
}

type Tangent = fn(&Vector14, &Vector3<f64>, LameConstants, &Element) -> Matrix14;

/// Energy, stiffness and tangent that belong together: the consistent ones and those with the printed shear (E3).
const FORMS: [(Energy, Stiffness, Tangent); 2] =
    [(force::U, force::K, force::tangent), (force::U_printed, force::K_printed, force::tangent_printed)];

proptest! {
    #![proptest_config(cases(256))]

    /// A rigid motion of the deformed element changes no strain, so U stays and Q_e turns with the element.
    #[test]
    fn a_rigid_motion_keeps_the_energy_and_turns_the_forces(
        s in states(), angle in -3.2..3.2, by in (-1.0..1.0, -1.0..1.0),
    ) {
        let e = s.e(0);
        let e_moved = moved(&turned(&e, angle), &(s.l * Vector2::new(by.0, by.1)));
        let sizes = s.sizes(&e.sup(&e_moved.abs()));
        assert_within("U", &[s.U(&e_moved)], &[s.U(&e)], &[sizes.energy()]);
        assert_within("Q_e", s.Q_e(&e_moved).as_slice(), turned(&s.Q_e(&e), angle).as_slice(), &sizes.force());
    }

    /// Turning e₀, e and the thermal strain together is to look from elsewhere: U stays and Q_e turns. In the 1D model
    /// the thermal strain is a tensor along the rod and turns too.
    #[test]
    fn the_inclination_is_no_property_of_the_rod(s in states(), angle in -3.2..3.2) {
        let (e, other) = (s.e(0), s.turned(angle));
        let e_other = other.e(0);
        let sizes = s.sizes(&e.sup(&e_other.abs()));
        assert_within("U", &[other.U(&e_other)], &[s.U(&e)], &[sizes.energy()]);
        assert_within("Q_e", other.Q_e(&e_other).as_slice(), turned(&s.Q_e(&e), angle).as_slice(), &sizes.force());
    }

    /// Positions add up to 1, and every field c + x a + y b is reproduced with its slopes.
    #[test]
    fn linear_fields_are_reproduced(
        s in states(),
        at in (0.0..1.0, -0.5..0.5),
        [a, b, c] in [(-1.0..1.0, -1.0..1.0), (-1.0..1.0, -1.0..1.0), (-1.0..1.0, -1.0..1.0)],
    ) {
        let (x, y, element) = (at.0 * s.l, at.1 * s.h, s.element());
        let S_i = shape::S_i(x, y, s.l);
        assert_within("S₁ + S₃ + S₆", &[POSITIONS.iter().map(|&i| S_i[i]).sum()], &[1.0], &[3.0]);

        let [a, b, c] = [a, b, c].map(|(v_x, v_y)| Vector2::new(v_x, v_y));
        let e = moved(&uniform(s.l, a, b), &c);
        let sum = |terms: [f64; 14]| vec![terms.iter().zip(&e).map(|(t, e)| t * e.abs()).sum(); 2];
        let (r, field) = (shape::r(x, y, &e, s.l), c + x * a + y * b);
        assert_within("r", r.as_slice(), field.as_slice(), &sum(sizes_of_S(&element)));
        let D = s.sizes(&e).D;
        assert_within("r_x", (shape::S_x(x, y, s.l) * e).as_slice(), a.as_slice(), &sum(D));
        assert_within("r_y", (shape::S_y(x, y, s.l) * e).as_slice(), b.as_slice(), &sum(D));
    }

    /// M is symmetric and positive definite; moving with velocity 1 along either axis it carries the mass ρAl, and
    /// there is none between the axes.
    #[test]
    fn the_mass_matrix_carries_the_mass(s in states()) {
        let (M, element) = (inertia::M(s.rho, &s.element()), s.element());
        let (N, mass) = (sizes_of_S(&element), s.rho * s.l * s.h * s.w);
        let scale: Vec<f64> = N.iter().flat_map(|a| N.iter().map(move |b| mass * a * b)).collect();
        assert_within("M − Mᵀ", &rows(&M), &rows(&M.transpose()), &scale);
        prop_assert!(M.cholesky().is_some(), "not positive definite");

        let along = [Vector2::x(), Vector2::y()].map(|v| moved(&Vector14::zeros(), &v));
        let total = [(0, 0), (1, 1), (0, 1)].map(|(a, b): (usize, usize)| along[a].dot(&(M * along[b])));
        // Nine entries of at most the mass are added up.
        assert_within("mass", &total, &[mass, mass, 0.0], &[9.0 * mass; 3]);
    }

    /// (6): ½ ∫ ρ ṙᵀṙ dV = ½ ėᵀMė.
    #[test]
    fn both_forms_of_the_kinetic_energy_agree(s in states()) {
        let element = s.element();
        let speed: f64 = sizes_of_S(&element).iter().zip(&s.e_dot).map(|(n, v)| n * v.abs()).sum();
        let scale = 0.5 * s.rho * s.l * s.h * s.w * speed.powi(2);
        let T = inertia::T(&inertia::M(s.rho, &element), &s.e_dot);
        assert_within("T", &[inertia::T_integral(&s.e_dot, s.rho, &element)], &[T], &[scale]);
    }

    /// Elastic forces are internal: they have no resultant and no moment.
    ///
    /// U does not change when the positions move by v, so v·Σ Qₙ = 0 over the positions. It does not change when all
    /// seven vectors vₙ turn, v̇ₙ = k × vₙ, so Σ vₙ ∧ Qₙ = 0 over all of them, slopes too.
    #[test]
    fn elastic_forces_are_in_balance(s in states()) {
        let e = s.e(0);
        let (Q, sizes) = (s.Q_e(&e), s.sizes(&e));
        let vector = |v: &Vector14, n: usize| Vector2::new(v[2 * n], v[2 * n + 1]);
        let sum: Vector2<f64> = POSITIONS.iter().map(|&n| vector(&Q, n)).sum();
        let moment: f64 = (0..7).map(|n| vector(&e, n).perp(&vector(&Q, n))).sum();
        let force = sizes.force();
        let sum_of_sizes: f64 = POSITIONS.iter().map(|&n| force[2 * n]).sum();
        let moment_of_sizes: f64 = e.iter().zip(&force).map(|(e, f)| e.abs() * f).sum();
        assert_within("Σ Q", sum.as_slice(), &[0.0; 2], &[sum_of_sizes; 2]);
        assert_within("Σ v ∧ Q", &[moment], &[0.0], &[moment_of_sizes]);
    }

    /// (10) for any J₀ and the closed form (11) in θ.
    #[test]
    fn the_closed_form_in_the_inclination_is_the_general_one(s in states(), at in (0.0..1.0, -0.5..0.5)) {
        let (x, y) = (at.0 * s.l, at.1 * s.h);
        let (general, closed) = (strain::S_abc(x, y, &s.element()), strain::S_abc_theta(x, y, s.l, s.theta));
        // J₀ is itself a sum, of e₀ with the derivatives of S.
        let e_0 = s.element().e_0;
        let D = s.sizes(&e_0).D;
        let J_0: f64 = D.iter().zip(&e_0).map(|(d, e)| d * e.abs()).sum();
        let scale: Vec<f64> = D.iter().flat_map(|a| D.iter().map(move |b| J_0 * a * b)).collect();
        assert_within("S_a", &rows(&general.0), &rows(&closed.0), &scale);
        assert_within("S_b", &rows(&general.1), &rows(&closed.1), &scale);
        assert_within("S_c", &rows(&general.2), &rows(&closed.2), &scale);
    }
}

proptest! {
    #![proptest_config(cases(96))]

    /// Q_e = Ke is the derivative of U, and the tangent that of Q_e, in both forms; the tangent is symmetric.
    ///
    /// U is of degree four in e and Q_e of degree three, so five-point differences are exact but for rounding. A step
    /// of 1/D in a coordinate adds at most 2 to the terms of the gradient, and the difference has (8 + 8 + 1 + 1)/12
    /// times the rounding of what it is taken of.
    #[test]
    fn forces_and_tangent_are_derivatives(s in states()) {
        let (e, eps_T, element, lame) = (s.e(0), s.eps_T(0), s.element(), s.lame());
        let Sizes { D, .. } = s.sizes(&e);
        let sizes = s.sizes(&e).beyond(2.0);
        let force_scale = D.map(|d| 1.5 * sizes.energy() * d);
        let tangent_scale: Vec<f64> = sizes.force().iter().flat_map(|f| D.map(|d| 1.5 * f * d)).collect();

        for (form, (U, sum, tangent)) in ["consistent", "printed shear"].iter().zip(FORMS) {
            let Q_e = |e: &Vector14| force::Q_e(e, &K(sum, e, &eps_T, lame, &element));
            let dU: [f64; 14] = std::array::from_fn(|i| {
                five_point(|step| U(&(e + unit(i, step)), &eps_T, lame, &element), 1.0 / D[i])
            });
            assert_within(&format!("Q_e, {form}"), Q_e(&e).as_slice(), &dU, &force_scale);

            let columns: [Vector14; 14] =
                std::array::from_fn(|i| five_point(|step| Q_e(&(e + unit(i, step))), 1.0 / D[i]));
            let K_t = tangent(&e, &eps_T, lame, &element);
            let dQ = Matrix14::from_columns(&columns);
            assert_within(&format!("tangent, {form}"), &rows(&K_t), &rows(&dQ), &tangent_scale);
            assert_within(&format!("symmetry, {form}"), &rows(&K_t), &rows(&K_t.transpose()), &sizes.tangent());
        }
    }

    /// Five points integrate xᵐ to m = 9 and three yⁿ to n = 5, both at once; at m = 10 and n = 6 they no longer do.
    ///
    /// Gauss's rule with p points falls short of the integral of the first power it misses, 2p, by
    /// 2^(2p+1) (p!)⁴ / \[(2p + 1) ((2p)!)²\] on \[−1, 1\]: the remainder term, whose derivative (2p)! is constant.
    #[test]
    fn the_rule_is_exact_to_its_degree_and_not_beyond(s in states()) {
        let (l, half, w) = (s.l, s.h / 2.0, s.w);
        let rule = |m: i32, n: i32| -> f64 {
            volume::gauss_points(l, s.h, w).iter().map(|p| p.x.powi(m) * p.y.powi(n) * p.dV).sum()
        };
        let over_x = |m: i32| l.powi(m + 1) / f64::from(m + 1);
        let over_y = |n: i32| if n % 2 == 0 { 2.0 * half.powi(n + 1) / f64::from(n + 1) } else { 0.0 };
        // No point's term exceeds the volume times the largest monomial.
        let size = |m: i32, n: i32| 2.0 * l * half * w * l.powi(m) * half.powi(n);
        for m in 0..=9 {
            for n in 0..=5 {
                let what = format!("x^{m} y^{n}");
                assert_within(&what, &[rule(m, n)], &[w * over_x(m) * over_y(n)], &[size(m, n)]);
            }
        }
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        let missing = |p: i32| {
            2f64.powi(2 * p + 1) * factorial(p).powi(4) / (f64::from(2 * p + 1) * factorial(2 * p).powi(2))
        };
        let short_x = w * missing(5) * (l / 2.0).powi(11) * over_y(0);
        let short_y = w * missing(3) * half.powi(7) * over_x(0);
        assert_within("x^10", &[w * over_x(10) * over_y(0) - rule(10, 0)], &[short_x], &[size(10, 0)]);
        assert_within("y^6", &[w * over_x(0) * over_y(6) - rule(0, 6)], &[short_y], &[size(0, 6)]);
        prop_assert!(short_x > 1e3 * TOLERANCE * size(10, 0) && short_y > 1e3 * TOLERANCE * size(0, 6));
    }
}
