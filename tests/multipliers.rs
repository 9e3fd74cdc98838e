//! Equation (23) with multipliers against the same structure with shared coordinates.
//!
//! Source: Peng et al. (2018), equation (23); index-3 numerics after Arnold and Brüls (2007). Goal: both forms are the same
//! motion with the same reactions, constraints are kept, and λ keeps its digits at small steps. Algebraically the forms are
//! equal step by step: constraints are linear in q, so that Z (coordinates that share) turns one equation into the other,
//! and what is left over are rounding and Newton's tolerance (10⁻¹⁰ of the largest force term).

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;

use ancf::integrators::{Counts, EquationOfMotion, State};
use ancf::internals::integrators::integrator;
use ancf::internals::linear::Bordered;
use ancf::internals::model::Scissors;
use ancf::internals::structure::{Instant, Structure};
use ancf::model::{Constraints, Direction, Method, Quantity, Scene, Support, ThermalModel};
use ancf::run::Run;
use common::evidence;
use common::motion::{farthest, force_on, longest, must_run, positions, probe, reactions};
use nalgebra::{DMatrix, DVector};

/// Bound of positions, m, and of forces relative to the largest.
const POSITION: f64 = 1e-8;
const FORCE: f64 = 1e-6;

/// Scissors by generalized-α, with probes on the points and forces that are compared.
fn scissors(count: usize, elements: usize, model: ThermalModel, step: f64, end: f64) -> Scene {
    let mut scene = Scissors { elements, model, ..Scissors::new(count) }.scene().unwrap();
    scene.time.method = Method::GeneralizedAlpha;
    (scene.time.step, scene.time.end, scene.output.energy) = (step, end, false);
    let last = format!("a{}", count + 1);
    scene.probes = vec![
        probe(&last, &[Quantity::Position]),
        probe("m1", &[Quantity::Position]),
        probe("a2", &[Quantity::Position]),
        probe("b1", &[Quantity::Reaction]),
        probe("a1", &[Quantity::Position, Quantity::Reaction]),
        force_on("m1", "a1b2"),
        force_on("a2", "b1a2"),
        force_on("a1", "a1b2"),
    ];
    scene
}

/// Largest distance of positions, m, and of forces relative to the largest force, of both forms.
fn distances(scene: &Scene) -> [f64; 2] {
    let run_as = |constraints| {
        let mut scene = scene.clone();
        scene.constraints = constraints;
        must_run(&scene)
    };
    let (condensed, multipliers) = (run_as(Constraints::Condensed), run_as(Constraints::Multipliers));
    let named = |quantity: Quantity| {
        let its = scene.probes.iter().filter(move |probe| probe.of.contains(&quantity));
        its.map(|probe| probe.name.as_str())
    };
    let worst = |quantity, path: fn(&Run, &str) -> Vec<[f64; 2]>| {
        named(quantity).map(|name| farthest(&path(&condensed, name), &path(&multipliers, name))).fold(0.0, f64::max)
    };
    let largest = named(Quantity::Reaction).map(|name| longest(&reactions(&condensed, name))).fold(0.0, f64::max);
    [worst(Quantity::Position, positions), worst(Quantity::Reaction, reactions) / largest]
}

#[track_caller]
fn assert_same(what: &str, scene: &Scene) {
    let [position, force] = distances(scene);
    println!("{what}: positions {position:.1e} m, forces {force:.1e} of the largest");
    assert!(position <= POSITION, "{what}: positions differ by {position:.1e} m");
    assert!(force <= FORCE, "{what}: forces differ by {force:.1e} of the largest");
}

/// The bar, at half the elements and four times the step of `scissors_release.rs`. Measured, here and below: 2e-14 to
/// 4e-13 m, 1e-10 to 1e-9 of the largest force.
#[test]
fn condensed_and_multipliers_are_the_same_motion() {
    assert_same("scissors-3, 4 elements, 3 s", &scissors(3, 4, ThermalModel::None, 1e-3, 3.0));
}

#[test]
fn condensed_and_multipliers_are_the_same_motion_in_changing_temperature() {
    for (model, end) in [(ThermalModel::TwoD, 1.5), (ThermalModel::OneD, 0.5)] {
        assert_same(&format!("scissors-3 {model:?}, 2 elements"), &scissors(3, 2, model, 1e-3, end));
    }
}

/// What else (23) has rows for: an oblique slide, a clamp, middles that are nodes of an element or of two, weight, a force
/// where two rods meet and one on a pivot, rods with heat and material of their own.
#[test]
fn condensed_and_multipliers_are_the_same_motion_on_any_support() {
    let mut scene = scissors(2, 3, ThermalModel::TwoD, 5e-4, 0.3);
    scene.material.nu = 0.3;
    scene.rods[1].elements = 2;
    scene.rods[2].elements = 1;
    scene.rods[3].elements = 4;
    scene.gravity = [1.0, -9.8];
    scene.rods[2].temperature = scene.temperature.clone().map(|mut heat| {
        (heat.model, heat.history) = (ThermalModel::OneD, vec![[0.0, 0.0], [0.1, -120.0]]);
        heat
    });
    scene.forces.push(ancf::model::Force { point: "a2".into(), force: [20.0, 5.0], history: None });
    scene.forces.push(ancf::model::Force {
        point: "m2".into(),
        force: [-5.0, 9.0],
        history: Some(vec![[0.0, 0.0], [0.2, 1.0]]),
    });
    scene.probes.retain(|probe| probe.name != "a1"); // No support holds it here.
    let free = |point: &str| Support { point: point.into(), fix: vec![], slide: None, clamp: None };
    let clamped = Support { fix: vec![Direction::X, Direction::Y], clamp: Some("b1a2".into()), ..free("b1") };
    let slide = Support { slide: Some([0.6, -3.0]), ..free("b3") };
    let on_pin = Support { slide: Some([1.0, 0.25]), ..free("b2") };
    scene.probes.extend([force_on("b2", "a1b2"), force_on("a2", "a2b3"), force_on("m2", "b2a3")]);

    let assert_same_with = |what: &str, first: Support, second: Support| {
        let mut scene = scene.clone();
        scene.probes.push(probe(&second.point, &[Quantity::Position, Quantity::Reaction]));
        scene.supports = vec![first, second];
        assert_same(what, &scene);
    };
    let hinge = scene.supports[0].clone();
    assert_same_with("an oblique slide", hinge.clone(), slide.clone());
    assert_same_with("an oblique slide where two rods meet", hinge, on_pin);
    assert_same_with("a clamp and an oblique slide", clamped, slide);
}

/// A state that can be moved on, of one structure.
struct Moving {
    scene: Scene,
    structure: Structure,
    state: State,
}

impl Moving {
    fn at_rest(scene: &Scene) -> Moving {
        let structure = Structure::new(scene).unwrap();
        let u = structure.start().clone();
        let state = State { step: 0, t: 0.0, load: 0.0, v: DVector::zeros(u.len()), u };
        Moving { scene: scene.clone(), structure, state }
    }

    /// Moves on by `count` steps from the equation of motion's own acceleration, and looks at each state with its λ.
    fn go(&mut self, step: f64, count: usize, mut look: impl FnMut(&Structure, &State, Instant)) {
        let Moving { scene, structure, state } = self;
        scene.time.step = step;
        let mut counts = Counts::default();
        let mut method =
            integrator(scene, &ancf::internals::model::Plan::of(scene), structure, state, &mut counts).unwrap();
        let mut motion = EquationOfMotion::new(structure, &mut counts).unwrap();
        let start = state.t;
        for n in 1..=count {
            let t = start + n as f64 * step;
            method.step(structure, state, t, &mut counts).unwrap();
            state.t = t;
            motion.accelerate(structure, &state.u, t, &mut counts);
            let mut a = motion.a.clone();
            structure.take_multipliers(&mut a);
            let none = DVector::zeros(structure.size());
            let multipliers = if structure.multiplier(0).is_some() { method.multipliers().unwrap() } else { &none };
            look(structure, state, Instant { u: &state.u, a: &a, t, multipliers });
        }
    }

    /// The same state with multipliers: what rods share is copied to each of them, what is held is zero.
    fn with_multipliers(&self) -> Moving {
        let mut scene = self.scene.clone();
        scene.constraints = Constraints::Multipliers;
        let mut moving = Moving::at_rest(&scene);
        for rod in &scene.rods {
            for (vector, component) in (0..5 * rod.elements + 2).flat_map(|v| [(v, 0), (v, 1)]) {
                let theirs = moving.structure.unknown(&rod.name, vector, component).unwrap();
                if let Some(ours) = self.structure.unknown(&rod.name, vector, component) {
                    moving.state.u[theirs] = self.state.u[ours];
                    moving.state.v[theirs] = self.state.v[ours];
                }
            }
        }
        moving.state.t = self.state.t;
        moving
    }
}

/// Φ and Φ_q v along the run : 1e-12 m and 1e-10 m/s at every step. Measured 2e-22 m and
/// 1e-19 m/s: the rows are those of the increment, which the equilibrated factors solve that closely.
#[test]
fn constraints_are_kept_along_the_run() {
    for (step, end) in [(1e-3, 3.0), (2.5e-4, 0.5)] {
        let mut scene = scissors(3, 2, ThermalModel::TwoD, step, end);
        scene.constraints = Constraints::Multipliers;
        let (mut moving, mut largest) = (Moving::at_rest(&scene), [0.0f64; 2]);
        moving.go(step, scene.steps(), |structure, state, _| {
            let residual = structure.constraint_residual(&state.u, &state.v);
            assert!(residual.iter().all(|r| r.is_finite()));
            largest = [0, 1].map(|i| largest[i].max(residual[i]));
        });
        println!("steps of {step:e} s until {end} s: Φ {:.1e} m, Φ_q v {:.1e} m/s", largest[0], largest[1]);
        evidence::at_most("multipliers.constraint", largest[0]);
        evidence::at_most("multipliers.constraint-rate", largest[1]);
        assert!(largest[0] <= 1e-12 && largest[1] <= 1e-10, "{step:e}: {largest:?}");
        // What is measured can be seen to fail.
        let Moving { structure, state, .. } = &mut moving;
        let pinned = structure.unknown("a1b2", 0, 0).unwrap();
        state.u[pinned] += 1e-11;
        state.v[pinned] += 1e-9;
        let [position, velocity] = structure.constraint_residual(&state.u, &state.v);
        assert!(
            (position - 1e-11).abs() < 1e-14 && (velocity - 1e-9).abs() < 1e-12,
            "{position:e} m, {velocity:e} m/s"
        );
    }
}

/// What Newton's iteration takes for rounding follows from displacements, whatever forces λ are: kilonewtons are no strain of a
/// thousand.
#[test]
fn multipliers_do_not_make_a_residual_look_like_rounding() {
    let structure = two_short_rods(7e10);
    let mut u = DVector::from_fn(structure.size(), |i, _| 0.1 * (1.7 * i as f64 + 0.3).sin());
    structure.take_multipliers(&mut u);
    // A unit strain of a rod is 2.8e7 N, ε_mach times 0.1 of it 6e-10 N.
    let of_size = |force: f64| {
        let mut residual = DVector::repeat(structure.size(), force);
        structure.take_multipliers(&mut residual);
        residual
    };
    let mut beside_forces = u.clone();
    (0..).map_while(|row| structure.multiplier(row)).for_each(|multiplier| beside_forces[multiplier] = 1e3);
    for u in [u, beside_forces] {
        assert!(structure.within_rounding(&of_size(1e-11), &u, &structure.thermal_strains(0.0), 8.0));
        assert!(!structure.within_rounding(&of_size(1e-7), &u, &structure.thermal_strains(0.0), 8.0));
    }
}

/// λ keeps its digits: from a state in full motion, where positions carry the rounding errors that usually spoil λ like
/// ε/Δt², 100 steps of each size give the forces of the condensed form from the same state. Measured: 5e-11 to 6e-10
/// of the largest.
#[test]
fn multipliers_keep_their_digits_at_small_steps() {
    let mut start = Moving::at_rest(&scissors(3, 2, ThermalModel::TwoD, 1e-3, 3.0));
    start.go(1e-3, 1000, |_, _, _| ());
    for step in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let forces = |moving: &mut Moving| {
            let mut rows: Vec<Vec<[f64; 2]>> = Vec::new();
            moving.go(step, 100, |structure, _, now| {
                let reactions = ["b1", "a1"].map(|point| structure.reaction(structure.point(point).unwrap(), now));
                let on_rods = [("m1", "a1b2"), ("m2", "b2a3"), ("a2", "b1a2"), ("b2", "a1b2"), ("a1", "a1b2")];
                rows.push(
                    [
                        &reactions[..],
                        &on_rods.map(|(point, rod)| {
                            structure.force_on_rod(structure.point(point).unwrap(), structure.rod(rod).unwrap(), now)
                        }),
                    ]
                    .concat(),
                );
            });
            rows
        };
        let mut condensed =
            Moving { scene: start.scene.clone(), structure: start.structure.clone(), state: start.state.clone() };
        let mut multipliers = start.with_multipliers();
        let (condensed, multipliers) = (forces(&mut condensed).concat(), forces(&mut multipliers).concat());
        let off = farthest(&condensed, &multipliers) / longest(&condensed);
        println!("step {step:e} s: forces differ by {off:.1e} of the largest, {:.2e} N", longest(&condensed));
        evidence::at_most("multipliers.step", off);
        assert!(off <= FORCE, "step {step:e} s: {off:.1e}");
    }
}

/// Two rods of one element, pinned at their middles, on a hinge and a slide: 28 coordinates and 5 multipliers.
fn two_short_rods(E: f64) -> Structure {
    let mut scene = Scissors { elements: 1, ..Scissors::new(1) }.scene().unwrap();
    (scene.material.youngs_modulus, scene.time.method) = (E, Method::GeneralizedAlpha);
    scene.constraints = Constraints::Multipliers;
    Structure::new(&scene).unwrap()
}

/// β of generalized-α with α_m, α_f at ρ∞ = 0.9.
fn parameters() -> [f64; 3] {
    let (alpha_m, alpha_f) = (0.8 / 1.9, 0.9 / 1.9);
    [0.25 * (1.0f64 - alpha_m + alpha_f).powi(2), alpha_m, alpha_f]
}

/// The iteration matrix of generalized-α at a disturbed state over 1 − α_f: (1 − α_m)/((1 − α_f) β Δt²) M + K beside Φ_qᵀ, and
/// Φ_q.
fn iteration_matrix(structure: &Structure, step: f64) -> Bordered {
    let [beta, alpha_m, alpha_f] = parameters();
    let mut u = DVector::from_fn(structure.size(), |i, _| 1e-3 * (1.7 * i as f64 + 0.3).sin());
    structure.take_multipliers(&mut u);
    let mut matrix = structure.tangent(&u, &structure.thermal_strains(0.0));
    matrix.add_scaled((1.0 - alpha_m) / ((1.0 - alpha_f) * beta * step * step), &structure.mass());
    structure.add_constraints(1.0, &mut matrix);
    matrix
}

/// Rows, then columns, divided by their largest entry.
fn equilibrated(mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    matrix.row_iter_mut().for_each(|mut row| row /= row.amax());
    matrix.column_iter_mut().for_each(|mut column| column /= column.amax());
    matrix
}

/// The equation of motion times β Δt², and λ in units that make up for it.
fn scaled_by_the_step(mut matrix: DMatrix<f64>, structure: &Structure, step: f64) -> DMatrix<f64> {
    let factor = parameters()[0] * step * step;
    let multipliers: Vec<usize> = (0..).map_while(|row| structure.multiplier(row)).collect();
    for i in 0..matrix.nrows() {
        if multipliers.contains(&i) {
            matrix.column_mut(i).scale_mut(1.0 / factor);
        } else {
            matrix.row_mut(i).scale_mut(factor);
        }
    }
    matrix
}

fn condition(matrix: DMatrix<f64>) -> f64 {
    let values = matrix.singular_values();
    values.max() / values.min()
}

const STEPS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// The iteration matrix: scaled by h² alone its condition grows 190 times as the step shrinks,
/// equilibrated it keeps within five times over five decades.
///
/// Measured here, by singular values. Rods so soft (7 MPa) that inertia outweighs stiffness at all of the steps: equilibrated
/// 17, 13, 6, 6, 6; by h² alone 900 … 4.7e5, 530 times. Aluminium: equilibrated 2.2e4 at 1e-2 s, where stiffness outweighs
/// inertia, 880, 17, 13, 6: it never grows. Unscaled it passes 1e14 at 1e-4 s.
#[test]
fn equilibration_keeps_the_condition_number() {
    for (E, range) in [(7e6, 5.0), (7e10, f64::INFINITY)] {
        let structure = two_short_rods(E);
        let conditions = |scaled: &dyn Fn(DMatrix<f64>, f64) -> DMatrix<f64>| {
            STEPS.map(|step| condition(scaled(iteration_matrix(&structure, step).dense(), step)))
        };
        let plain = conditions(&|matrix, _| matrix);
        let by_step = conditions(&|matrix, step| scaled_by_the_step(matrix, &structure, step));
        let both = conditions(&|matrix, _| equilibrated(matrix));
        for i in 0..STEPS.len() {
            let step = STEPS[i];
            println!(
                "E {E:e}, {step:e} s: {:.1e} plain, {:.1e} by h², {:.1e} equilibrated",
                plain[i], by_step[i], both[i]
            );
        }
        assert!(both.windows(2).all(|pair| pair[1] <= 1.01 * pair[0]), "it grows: {both:?}");
        assert!(both[2..].iter().all(|c| *c <= 20.0) && both[0] / both[4] <= range, "{both:?}");
        assert!(plain[2..].iter().all(|c| *c >= 1e14), "{plain:?}");
        let smallest = by_step.iter().fold(f64::INFINITY, |a, b| a.min(*b));
        assert!(by_step[4] >= 190.0 * smallest, "{by_step:?}");
    }
}

/// Elimination by blocks and border, plain and equilibrated, against a dense solver with full pivoting.
///
/// Residuals are compared with the terms that they are made of: measured 4e-16 equilibrated (the bound is the number of
/// unknowns, 33, times ε_mach), 1.4e-14 plain, at 1e-5 s. Solutions differ by what the condition makes of it: 1.3e-12 of an
/// entry at most.
#[test]
fn factors_solve_what_a_dense_solver_solves() {
    let structure = two_short_rods(7e10);
    for step in STEPS {
        let matrix = iteration_matrix(&structure, step);
        let dense = matrix.dense();
        let size = dense.nrows();
        assert_eq!(size, 33);
        let b = DVector::from_fn(size, |i, _| (2.3 * i as f64 + 0.7).cos());
        let expected = dense.clone().full_piv_lu().solve(&b).unwrap();
        let terms = dense.abs() * expected.abs() + b.abs();
        for (name, factors, bound) in [
            ("plain", matrix.clone().lu(), 1e-12),
            ("equilibrated", matrix.clone().equilibrated_lu(), size as f64 * f64::EPSILON),
        ] {
            let mut solution = b.clone();
            factors.unwrap().solve(&mut solution);
            let residual = common::worst_ratio((&dense * &solution).as_slice(), b.as_slice(), terms.as_slice());
            let off = common::worst_ratio(solution.as_slice(), expected.as_slice(), expected.abs().as_slice());
            println!("step {step:e} s, {name}: residual {residual:.1e}, solution {off:.1e}");
            assert!(residual <= bound, "step {step:e} s, {name}: residual {residual:.1e}");
            assert!(off <= 1e-11, "step {step:e} s, {name}: solution off by {off:.1e}");
        }
    }
}
