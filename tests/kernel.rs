//! `elements::Ancf` is the element of `equations`, consistent form, on the oracle's states and on random ones; and the forces of
//! an energy–momentum step, which only it has, do exactly the work that they must.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;
#[path = "common/side_by_side.rs"]
mod side_by_side;
#[path = "common/states.rs"]
mod states;

use ancf::equations::material::LameConstants;
use ancf::equations::shape::Vector14;
use ancf::equations::{axis, force, inertia, uniaxial};
use ancf::internals::elements::{Ancf, Beam, Ends, Law};
use ancf::model::Poisson;
use ancf::state::ThermalModel;
use common::evidence;
use common::scale::scale;
use common::{Equations, TOLERANCE, within, worst_ratio};
use nalgebra::{SMatrix, Vector3};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use side_by_side::{Four, TermSizes};
use states::{Sizes, State, assert_within, axes, cases, compared, five_point, rows, states, turned, uniform, unit};

/// Energy, force and tangent in every state of the fixtures. The oracle's numbers, the table's scales: nothing of
/// `equations` takes part.
#[test]
fn the_kernel_meets_the_oracle() {
    let mut failures = Vec::new();
    for case in Equations::load().cases() {
        let s = &case.state;
        let lame = LameConstants { lambda: case.scalar("17.lambda"), mu: case.scalar("17.mu") };
        let laws = [
            Law::PlaneStrain { lame, poisson: Poisson::Full },
            Law::PlaneStrain { lame, poisson: Poisson::Axis },
            Law::Uniaxial(s.moduli()),
        ];
        let [kernel, axis, uniaxial] = laws.map(|law| Ancf::new(s.l, s.h, s.w, s.theta, law));
        let heat = s.alpha * s.dT;
        let eps_T = match s.model {
            ThermalModel::TwoD => [heat, heat],
            ThermalModel::OneD => [heat, 0.0],
            _ => [0.0, 0.0],
        };
        let u = Vector14::from(s.e) - Vector14::from(s.e0);
        for (quantity, actual) in [
            ("18.U", vec![kernel.energy(&u, eps_T)]),
            ("19.Q_e", kernel.force(&u, eps_T).as_slice().to_vec()),
            ("tangent.dQ_e", rows(&kernel.tangent(&u, eps_T))),
            ("axis.U", vec![axis.energy(&u, eps_T)]),
            ("axis.Q_e", axis.force(&u, eps_T).as_slice().to_vec()),
            ("axis.tangent", rows(&axis.tangent(&u, eps_T))),
            ("uniaxial.U", vec![uniaxial.energy(&u, eps_T)]),
            ("uniaxial.Q_e", uniaxial.force(&u, eps_T).as_slice().to_vec()),
            ("uniaxial.tangent", rows(&uniaxial.tangent(&u, eps_T))),
        ] {
            let (expected, scale) = (case.value(quantity), scale(quantity, &case));
            if !within(TOLERANCE, &actual, &expected, &scale) {
                let ratio = worst_ratio(&actual, &expected, &scale);
                failures.push(format!("{quantity} {}: {ratio:.1e}", case.id));
            }
        }
    }
    assert!(failures.is_empty(), "{} values miss the oracle:\n{}", failures.len(), failures.join("\n"));
}

fn kernel(s: &State) -> Ancf {
    kernel_with(s, plane_strain(s, Poisson::Full))
}

fn kernel_with(s: &State, law: Law) -> Ancf {
    Ancf::new(s.l, s.h, s.w, s.theta, law)
}

fn plane_strain(s: &State, poisson: Poisson) -> Law {
    Law::PlaneStrain { lame: s.lame(), poisson }
}

/// Every law of the element.
fn laws(s: &State) -> [Law; 3] {
    [plane_strain(s, Poisson::Full), plane_strain(s, Poisson::Axis), Law::Uniaxial(s.moduli())]
}

/// A step with another displacement and another temperature at its end.
fn ends<'a>(s: &State, u: &'a [Vector14; 2]) -> Ends<'a, Vector14> {
    Ends { u_0: &u[0], u_1: &u[1], thermal_0: s.eps_T_own(0), thermal_1: s.eps_T_own(1) }
}

fn displacements(s: &State) -> [Vector14; 2] {
    s.u.map(|u| turned(&u, s.theta))
}

/// Sizes for the kernel: it subtracts no 1, so the gradient's terms are those of the unit vectors and of u alone.
fn sizes_of_displacements(s: &State) -> Sizes {
    let u = s.u[0].abs().sup(&s.u[1].abs());
    let heat = s.heat[0].abs().max(s.heat[1].abs());
    // The components of a turned vector are at most √2 times the larger of its own.
    Sizes::of(&s.element(), s.lame(), heat, &(2f64.sqrt() * u)).beyond(1.0)
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn the_kernel_is_the_equations_element(s in states()) {
        let (kernel, u, eps_T, e) = (kernel(&s), s.e(0) - s.element().e_0, s.eps_T_own(0), s.e(0));
        let sizes = s.sizes(&e);
        let tangent = force::tangent(&e, &s.eps_T(0), s.lame(), &s.element());
        assert_within("U", &[kernel.energy(&u, eps_T)], &[s.U(&e)], &[sizes.energy()]);
        assert_within("Q_e", kernel.force(&u, eps_T).as_slice(), s.Q_e(&e).as_slice(), &sizes.force());
        assert_within("∂Q_e/∂e", &rows(&kernel.tangent(&u, eps_T)), &rows(&tangent), &sizes.tangent());
    }

    /// Elements side by side are the elements one by one, whatever the law and the path: each lane has its own displacement and heat.
    #[test]
    fn elements_side_by_side_are_the_same(s in states()) {
        let (u, shares, sizes) = (displacements(&s), [1.0, -0.5, 0.25, 0.0], sizes_of_displacements(&s));
        let (mass, force) = (inertia::M(1.0, &s.element()), sizes.force());
        for kernel in laws(&s).map(|law| kernel_with(&s, law)) {
            let four = Four {
                beam: &kernel,
                mass: &mass,
                // A share of 1 − (−½) of the displacement at the end.
                u: [shares.map(|share| share * u[0]), shares.map(|share| (1.0 - share) * u[1])],
                eps_T: [0, 1].map(|end| shares.map(|share| s.eps_T_own(end).map(|strain| share * strain))),
            };
            // The displacements are up to 1.5 times as large: strains 2.25 times, energies five times.
            let force: Vec<f64> = force.iter().map(|force| 3.4 * force).collect();
            let gradient = 1.0 + 1.5 * sizes.D.iter().zip(&(u[0].abs().sup(&u[1].abs()))).map(|(d, u)| d * u).sum::<f64>();
            let energy = 5.1 * sizes.energy();
            four.assert_each_is_itself(&TermSizes { force: &force, energy, det_j: 2.0 * gradient * gradient });
        }
    }

    #[test]
    fn so_it_is_with_poisson_on_the_axis(s in states()) {
        let (kernel, u, eps_T, e) = (kernel_with(&s, plane_strain(&s, Poisson::Axis)), s.e(0) - s.element().e_0, s.eps_T_own(0), s.e(0));
        let (heat, element, sizes) = (Vector3::new(eps_T[0], eps_T[1], 0.0), s.element(), s.sizes(&e));
        // E* is no larger than λ + 2μ, so the terms are of the same sizes.
        assert_within("U", &[kernel.energy(&u, eps_T)], &[axis::U(&e, &heat, s.moduli(), &element)], &[sizes.energy()]);
        let Q = axis::Q_e(&e, &heat, s.moduli(), &element);
        assert_within("Q_e", kernel.force(&u, eps_T).as_slice(), Q.as_slice(), &sizes.force());
        let tangent = axis::tangent(&e, &heat, s.moduli(), &element);
        assert_within("∂Q_e/∂e", &rows(&kernel.tangent(&u, eps_T)), &rows(&tangent), &sizes.tangent());
    }

    #[test]
    fn so_it_is_with_the_uniaxial_law(s in states()) {
        let (kernel, u, eps_T, e) = (kernel_with(&s, Law::Uniaxial(s.moduli())), s.e(0) - s.element().e_0, s.eps_T_own(0), s.e(0));
        let (heat, element, sizes) = (Vector3::new(eps_T[0], eps_T[1], 0.0), s.element(), s.sizes(&e));
        // E is no larger than λ + 2μ, so the terms are of the same sizes.
        assert_within("U", &[kernel.energy(&u, eps_T)], &[uniaxial::U(&e, &heat, s.moduli(), &element)], &[sizes.energy()]);
        let Q = uniaxial::Q_e(&e, &heat, s.moduli(), &element);
        assert_within("Q_e", kernel.force(&u, eps_T).as_slice(), Q.as_slice(), &sizes.force());
        let tangent = uniaxial::tangent(&e, &heat, s.moduli(), &element);
        assert_within("∂Q_e/∂e", &rows(&kernel.tangent(&u, eps_T)), &rows(&tangent), &sizes.tangent());
    }

    /// At ν = 0 the uniaxial law is the paper's, to the last bit: the same moduli.
    #[test]
    fn without_poissons_ratio_the_uniaxial_law_is_the_papers(s in states()) {
        let s = State { nu: 0.0, ..s };
        let (u, eps_T) = (displacements(&s), s.eps_T_own(0));
        let [full, _, uniaxial] = laws(&s).map(|law| kernel_with(&s, law).force(&u[0], eps_T));
        prop_assert_eq!(full, uniaxial);
    }

    /// The tangent of the mixed iteration differs from the tangent only by what the step predicts: nothing, without a step.
    #[test]
    fn without_a_step_the_mixed_tangent_is_the_tangent(s in states()) {
        let ([u, _], eps_T) = (displacements(&s), s.eps_T_own(0));
        for kernel in laws(&s).map(|law| kernel_with(&s, law)) {
            prop_assert_eq!(kernel.mixed_tangent(&u, &u, eps_T), kernel.tangent(&u, eps_T));
        }
    }

    /// Stresses averaged over the ends, strain derivative in the middle. In (20) K holds the stresses of e and Ke is
    /// their force through the strain derivative at e, linear in either: Q̄ = ½ (K₀ + K₁) ½ (e₀ + e₁).
    #[test]
    fn the_mean_force_is_that_of_the_mean_stiffness(s in states()) {
        let (e_0, e_1, e_initial) = (s.e(0), s.e(1), s.element().e_0);
        let u = [e_0 - e_initial, e_1 - e_initial];
        let expected = 0.25 * (s.K(&e_0, 0) + s.K(&e_1, 1)) * (e_0 + e_1);
        let sizes = s.sizes(&e_0.abs().sup(&e_1.abs()));
        assert_within("Q̄", kernel(&s).mean_force(&ends(&s, &u)).as_slice(), expected.as_slice(), &sizes.force());
    }

    /// Q̄·(u₁ − u₀) + heating work = U₁ − U₀: the strains being quadratic in u, their change is the derivative in the
    /// middle times u₁ − u₀, and the energy being quadratic in the elastic strain ε, its change is σ̄ : (ε₁ − ε₀).
    #[test]
    fn the_mean_force_does_the_work_of_the_step(s in states()) {
        let u = displacements(&s);
        let ends = ends(&s, &u);
        for kernel in laws(&s).map(|law| kernel_with(&s, law)) {
            let work = kernel.mean_force(&ends).dot(&(u[1] - u[0]));
            let change = kernel.energy(&u[1], ends.thermal_1) - kernel.energy(&u[0], ends.thermal_0);
            // The work is a sum over both ends' displacements: four energies.
            let scale = 4.0 * sizes_of_displacements(&s).energy();
            assert_within("work", &[work + kernel.heating_work(&ends)], &[change], &[scale]);
        }
    }

    /// Q̄ is cubic in u₁, so the five-point difference is exact; see `properties.rs` for its rounding.
    #[test]
    fn the_mean_tangent_is_a_derivative(s in states()) {
        let (kernel, u) = (kernel(&s), displacements(&s));
        let Sizes { D, .. } = sizes_of_displacements(&s);
        let force = sizes_of_displacements(&s).beyond(2.0).force();
        let columns: [Vector14; 14] = std::array::from_fn(|i| {
            five_point(|step| kernel.mean_force(&ends(&s, &[u[0], u[1] + unit(i, step)])), 1.0 / D[i])
        });
        let scale: Vec<f64> = force.iter().flat_map(|f| D.map(|d| 1.5 * f * d)).collect();
        let tangent = kernel.mean_tangent(&ends(&s, &u));
        assert_within("∂Q̄/∂u₁", &rows(&tangent), &rows(&SMatrix::from_columns(&columns)), &scale);
    }

    /// With both ends equal Q̄ is Q_e, and as Q̄ treats its ends alike, each has half of the derivative. Halves are
    /// exact, so both hold to the last bit.
    #[test]
    fn a_step_of_nothing_is_the_element_itself(s in states()) {
        let (kernel, [u, _], eps_T) = (kernel(&s), displacements(&s), s.eps_T_own(0));
        let ends = Ends { u_0: &u, u_1: &u, thermal_0: eps_T, thermal_1: eps_T };
        prop_assert_eq!(kernel.mean_force(&ends), kernel.force(&u, eps_T));
        prop_assert_eq!(kernel.mean_tangent(&ends), 0.5 * kernel.tangent(&u, eps_T));
        prop_assert_eq!(kernel.heating_work(&ends), 0.0);
    }

    /// A stretch of 1 + s has the strain s + s²/2 and the axial force N = EA (s + s²/2)(1 + s), to 1e-13 of itself even
    /// at s = 1e-10: 1e-13 is a few hundred roundings of s, where the paper's form has some of 1.
    #[test]
    fn small_strains_keep_their_digits(theta in -3.2..3.2, exponent in -14.0..-1.0, sign in prop::bool::ANY) {
        let (l, h, w, E) = (2.0, 0.25, 0.5, 2e8);
        let stretch = if sign { 1.0 } else { -1.0 } * 10f64.powf(exponent);
        let (t, _) = axes(theta);
        let u = uniform(l, stretch * t, 0.0 * t);
        let kernel = Ancf::new(l, h, w, theta, Law::PlaneStrain { lame: LameConstants { lambda: 0.0, mu: E / 2.0 }, poisson: Poisson::Full });
        let Q = kernel.force(&u, [0.0, 0.0]);
        let N = E * h * w * (stretch + 0.5 * stretch * stretch) * (1.0 + stretch);
        let [at_i, at_k] = [0, 10].map(|row| Q[row] * t.x + Q[row + 1] * t.y);
        prop_assert!((at_k - N).abs() <= 1e-13 * N.abs(), "N at k is {at_k:e}, not {N:e}");
        prop_assert!((at_i + N).abs() <= 1e-13 * N.abs(), "N at i is {at_i:e}, not {:e}", -N);
    }
}

/// Forces and tangents of the paper's element, of ν = 0 and others, with every law, in 10,000
/// random states: within 1e-13 of the terms that are added up (measured 5.7e-18 and 5.8e-17), and within 1e-12 of the largest entry
/// (measured 2.5e-14 and 1.3e-14).
#[test]
fn ten_thousand_states() {
    let mut runner = TestRunner::deterministic();
    let mut worst = [0.0f64; 4];
    for number in 0..10_000 {
        let mut s = states().new_tree(&mut runner).unwrap().current();
        if number % 4 == 0 {
            s.nu = 0.0;
        }
        let (u, eps_T, e) = (s.e(0) - s.element().e_0, s.eps_T_own(0), s.e(0));
        let (sizes, element) = (s.sizes(&e), s.element());
        let heat = Vector3::new(eps_T[0], eps_T[1], 0.0);
        let full = (s.Q_e(&e), force::tangent(&e, &s.eps_T(0), s.lame(), &element));
        let axis = (axis::Q_e(&e, &heat, s.moduli(), &element), axis::tangent(&e, &heat, s.moduli(), &element));
        let uniaxial =
            (uniaxial::Q_e(&e, &heat, s.moduli(), &element), uniaxial::tangent(&e, &heat, s.moduli(), &element));
        for (law, (Q, K)) in laws(&s).into_iter().zip([full, axis, uniaxial]) {
            let kernel = kernel_with(&s, law);
            let (force, tangent) = (kernel.force(&u, eps_T), rows(&kernel.tangent(&u, eps_T)));
            let ratios =
                compared([force.as_slice(), &tangent], [Q.as_slice(), &rows(&K)], [&sizes.force(), &sizes.tangent()]);
            worst = std::array::from_fn(|n| worst[n].max(ratios[n]));
        }
    }
    let [force, tangent, force_entry, tangent_entry] = worst;
    for (name, value) in
        [("force", force), ("tangent", tangent), ("force-entry", force_entry), ("tangent-entry", tangent_entry)]
    {
        evidence::at_most(&format!("kernel.{name}"), value);
    }
    assert!(force_entry <= 1e-12 && tangent_entry <= 1e-12);
}
