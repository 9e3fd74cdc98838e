//! Statics against closed forms: the elastica, equilibrium in the deformed position, the rigid mechanism, heat; and which
//! structures have no equilibrium to look for.
//!
//! Source: statics by hand, derived beside each test; the elastica is integrated here. Goal: positions and reactions of held
//! structures are right, in few iterations, whatever the slenderness.

#![allow(non_snake_case)] // The symbols of mechanics are names here.

mod common;

use ancf::error::Error;
use ancf::internals::model::Scissors;
use ancf::internals::structure::Structure;
use ancf::model::{Direction, Force, Method, Quantity, Rod, Scene, Support, Temperature, ThermalModel};
use ancf::run::{Run, run};
use common::evidence;
use common::motion::{Placing, farthest, force_on, longest, must_run, positions, probe, reactions};

/// The last row of a path.
fn last(path: Vec<[f64; 2]>) -> [f64; 2] {
    *path.last().unwrap()
}

fn off([a_x, a_y]: [f64; 2], [b_x, b_y]: [f64; 2]) -> f64 {
    (a_x - b_x).hypot(a_y - b_y)
}

/// Tip (x, y)/L of the elastica clamped at o along x under the dead load P downwards, PL²/EI = 10.
///
/// With the slope φ downwards, φ₀ at the tip, EI φ'²/2 = P (sin φ₀ − sin φ). So √10 = ∫ dφ/√(2 (sin φ₀ − sin φ)) from 0 to φ₀,
/// which gives φ₀, and −y = 1/√10 ∫ sin φ dφ/√(…), x = √(2 sin φ₀/10). The substitution φ = φ₀ − s² takes out the root's
/// singularity: sin φ₀ − sin φ = 2 cos(φ₀ − s²/2) sin(s²/2). Simpson's rule, exact to 1e-13 with 4000 intervals.
fn elastica() -> [f64; 2] {
    let integral = |phi_0: f64, f: &dyn Fn(f64) -> f64| {
        let end = phi_0.sqrt();
        let value = |s: f64| {
            let half = 0.5 * s * s;
            let sine = if half == 0.0 { 1.0 } else { half.sin() / half };
            f(phi_0 - s * s) * (2.0 / ((phi_0 - half).cos() * sine)).sqrt()
        };
        let n = 4000;
        let sum: f64 = (0..=n)
            .map(|i| {
                let weight = if i == 0 || i == n {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                weight * value(end * i as f64 / n as f64)
            })
            .sum();
        sum * end / n as f64 / 3.0
    };
    let root = 10.0f64.sqrt();
    let (mut low, mut high) = (0.1, std::f64::consts::FRAC_PI_2 - 1e-9);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if integral(middle, &|_| 1.0) < root { low = middle } else { high = middle }
    }
    [(2.0 * low.sin() / 10.0).sqrt(), -integral(low, &f64::sin) / root]
}

#[test]
fn the_elastica_is_that_of_the_tables() {
    let [x, y] = elastica();
    println!("elastica: ({x:.10}, {y:.10})");
    // Bisshopp and Drucker (1945) and Mattiasson (1981), PL²/EI = 10: 1 − 0.55500, 0.81061.
    assert!((x - 0.44500).abs() < 5e-6 && (y + 0.81061).abs() < 5e-6, "({x}, {y})");
}

fn cantilever(height: f64, elements: usize, load_steps: usize) -> Scene {
    let mut scene = Scene::builtin("cantilever").unwrap();
    (scene.section.height, scene.section.width) = (height, height);
    scene.forces[0].force = [0.0, -10.0 * scene.material.youngs_modulus * height.powi(4) / 12.0];
    (scene.rods[0].elements, scene.time.load_steps) = (elements, load_steps);
    scene
}

/// The bar: at most 35 Newton iterations in all, in one load step, of which the step itself takes 8 or 9. The others are
/// those of its parts: the rod is ten times as stiff at the end, so that only four parts agree with the rates at their
/// ends. And errors of the deflection
/// 4.4e-2, 3.4e-3, 6e-4 at h/L = 10⁻³, 1.1e-2, 1.6e-3, 6e-5 at 10⁻², for 4, 8, 16 elements (M4). They are met within a
/// fifth, from above and from below: the element is the paper's, with its locking. Measured 4.0e-2, 3.2e-3, 5.9e-4 and 1.04e-2,
/// 1.44e-3, ….
#[test]
fn a_slender_cantilever_takes_few_iterations() {
    let exact = elastica();
    for (height, errors) in [(1e-3, [4.4e-2, 3.4e-3, 6e-4]), (1e-2, [1.1e-2, 1.6e-3, 6e-5])] {
        for (elements, known) in [4, 8, 16].into_iter().zip(errors) {
            let run = must_run(&cantilever(height, elements, 1));
            let tip = last(positions(&run, "tip"));
            let iterations = run.counts.newton_iterations;
            let error = [tip[0] - exact[0], tip[1] - exact[1]];
            println!(
                "h/L {height:e}, {elements} elements: {iterations} iterations, off by ({:.2e}, {:.2e})",
                error[0], error[1]
            );
            if height == 1e-3 {
                evidence::number(&format!("statics.iterations.{elements}"), iterations);
            }
            assert!(iterations <= 35, "h/L {height:e}, {elements} elements: {iterations} iterations");
            assert!((error[1].abs() / known - 1.0).abs() <= 0.2, "{elements}: {error:?}, known: {known:e}");
        }
    }
}

/// The result does not depend on the way to it.
#[test]
fn load_steps_do_not_change_the_result() {
    for elements in [4, 8, 16] {
        let [one, ten] = [1, 10].map(|load_steps| must_run(&cantilever(1e-3, elements, load_steps)));
        let difference = off(last(positions(&one, "tip")), last(positions(&ten, "tip")));
        println!(
            "{elements} elements: one and ten load steps differ by {difference:.1e} m, {} iterations",
            ten.counts.newton_iterations
        );
        assert!(difference <= 1e-9, "{elements} elements: {difference:.1e} m");
    }
}

/// Two rods pinned at their middles, on two feet, with loads; probes on all of it.
fn scissor(points: [(&str, [f64; 2]); 4], E: f64, forces: &[(&str, [f64; 2])]) -> Scene {
    let mut scene = Scene::builtin("scissor-static").unwrap();
    scene.points = points.into_iter().map(|(name, point)| (name.to_string(), point)).collect();
    scene.material.youngs_modulus = E;
    let force = |&(point, force): &(&str, [f64; 2])| Force { point: point.into(), force, history: None };
    scene.forces = forces.iter().map(force).collect();
    scene.probes = ["a1", "a2", "m1"].map(|point| probe(point, &[Quantity::Position])).to_vec();
    scene.probes.extend(["b1", "b2"].map(|point| probe(point, &[Quantity::Position, Quantity::Reaction])));
    scene
}

/// The built-in one, and one without any symmetry.
const UPRIGHT: [(&str, [f64; 2]); 4] =
    [("a1", [0.0, 1.7320508075688772]), ("a2", [1.0, 1.7320508075688772]), ("b1", [0.0, 0.0]), ("b2", [1.0, 0.0])];
const ASKEW: [(&str, [f64; 2]); 4] = [("a1", [0.1, 1.6]), ("a2", [1.2, 1.5]), ("b1", [0.0, 0.0]), ("b2", [1.1, -0.1])];

/// Sum of loads and reactions, and of their moments about the origin, in the computed positions; the largest of each row.
fn out_of_balance(scene: &Scene, run: &Run) -> f64 {
    let factors = run.trajectory.column("t").unwrap();
    let mut worst = 0.0f64;
    for (row, factor) in factors.iter().enumerate() {
        let mut sum = [0.0; 3];
        let mut add = |[x, y]: [f64; 2], [f_x, f_y]: [f64; 2]| {
            for (sum, value) in sum.iter_mut().zip([f_x, f_y, x * f_y - y * f_x]) {
                *sum += value;
            }
        };
        for force in &scene.forces {
            add(positions(run, &force.point)[row], force.force.map(|component| factor * component));
        }
        for support in &scene.supports {
            add(positions(run, &support.point)[row], reactions(run, &support.point)[row]);
        }
        worst =
            sum.iter().fold(worst, |worst, value| if value.is_nan() { f64::INFINITY } else { worst.max(value.abs()) });
    }
    worst
}

/// The issue's bar: global equilibrium within 1e-9 · (ΣF + 50 ε_mach EA), in N and, about the origin 1 m away, in N m; at
/// every load step.
#[test]
fn loads_and_reactions_are_in_equilibrium_in_the_deformed_position() {
    let oblique = [("a1", [20.0, -35.0]), ("a2", [-60.0, -10.0]), ("m1", [7.0, -3.0])];
    for (what, points, E, forces) in [
        ("upright", UPRIGHT, 7e10, &[("a1", [0.0, -50.0])][..]),
        ("upright, oblique forces", UPRIGHT, 7e10, &oblique),
        ("askew, oblique forces", ASKEW, 7e10, &oblique),
        ("askew, oblique forces, soft", ASKEW, 2e9, &oblique),
        ("a force on a foot too", ASKEW, 7e10, &[("a1", [20.0, -35.0]), ("b2", [8.0, -30.0])]),
    ] {
        let scene = scissor(points, E, forces);
        let run = must_run(&scene);
        let moved = off(last(positions(&run, "a1")), scene.points["a1"]);
        let loads: f64 = forces.iter().map(|(_, [x, y])| x.hypot(*y)).sum();
        let bound = 1e-9 * (loads + 50.0 * f64::EPSILON * E * 4e-4);
        let sum = out_of_balance(&scene, &run);
        println!("{what}: a1 moves by {moved:.1e} m, out of balance by {sum:.1e} of {bound:.1e} N");
        assert!(moved > 1e-4, "{what}: a1 hardly moves");
        evidence::at_most("statics.equilibrium", sum / loads);
        assert!(sum <= bound, "{what}: {sum:.1e} N, allowed {bound:.1e} N");
    }
}

/// By hand: with R₁ at b1, R₂ at b2 and F at a1, the rod b1–a2 bears R₁ and the pin's force at m only, so that R₁ is along it:
/// R₁ = k d, d = a2 − b1. The rod a1–b2 bears F, R₂ and the pin: about m, F and R₂ have arms opposite and alike, so that
/// (F − R₂) × e = 0, e = a1 − b2. With R₂ = −F − R₁ that is (2F + k d) × e = 0, k = −2 (F × e)/(d × e). Elastic rods approach it
/// as 1/E.
#[test]
fn reactions_approach_those_of_rigid_rods_as_one_over_e() {
    let F = [0.2, -0.5];
    for points in [UPRIGHT, ASKEW] {
        let [a1, a2, b1, b2] = points.map(|(_, point)| point);
        let (d, e) = ([a2[0] - b1[0], a2[1] - b1[1]], [a1[0] - b2[0], a1[1] - b2[1]]);
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        let k = -2.0 * cross(F, e) / cross(d, e);
        let R_1 = [k * d[0], k * d[1]];
        let R_2 = [-F[0] - R_1[0], -F[1] - R_1[1]];
        let errors = [1e9, 1e10, 1e11].map(|E| {
            let run = must_run(&scissor(points, E, &[("a1", F)]));
            off(last(reactions(&run, "b1")), R_1).max(off(last(reactions(&run, "b2")), R_2))
        });
        println!("R₁ {R_1:?}, R₂ {R_2:?} N, off by {:.2e}, {:.2e}, {:.2e} N", errors[0], errors[1], errors[2]);
        assert!(errors.windows(2).all(|pair| (pair[0] / pair[1] - 10.0).abs() <= 1.0), "{errors:?}");
        assert!(errors[2] <= 1e-3 * R_1[0].hypot(R_1[1]), "{errors:?}");
    }
}

/// The weight is borne, and by symmetry each foot bears half of it; at each load factor its share.
#[test]
fn the_weight_is_borne() {
    let mut scene = scissor(UPRIGHT, 7e10, &[]);
    scene.gravity = [0.0, -9.81];
    let run = must_run(&scene);
    let weight = 2.0 * 2.0 * 2750.0 * 4e-4 * 9.81;
    let (b1, b2) = (reactions(&run, "b1"), reactions(&run, "b2"));
    for ((factor, b1), b2) in run.trajectory.column("t").unwrap().into_iter().zip(b1).zip(b2) {
        // The bar of equilibrium.
        let bound = 1e-9 * (weight + 50.0 * f64::EPSILON * 7e10 * 4e-4);
        let expected = [b1[0], 0.5 * factor * weight];
        assert!(off(b1, expected) <= bound && off(b2, [-expected[0], expected[1]]) <= bound, "{factor}: {b1:?} {b2:?}");
    }
    // Each foot's force leans inwards.
    assert!(last(reactions(&run, "b1"))[0] > 1.0);
}

/// One rod from o to a = (1, 0), ν = 0.3, and its supports.
fn bar(supports: Vec<Support>) -> Scene {
    let mut scene = cantilever(0.02, 3, 2);
    (scene.material.nu, scene.material.youngs_modulus, scene.material.alpha) = (0.3, 2e8, 2.85e-5);
    (scene.forces, scene.supports) = (Vec::new(), supports);
    scene.probes = ["o", "a"].map(|point| probe(point, &[Quantity::Position])).to_vec();
    scene
}

fn free(point: &str) -> Support {
    Support { point: point.into(), fix: vec![], slide: None, clamp: None }
}

fn fixed(point: &str) -> Support {
    Support { fix: vec![Direction::X, Direction::Y], ..free(point) }
}

fn clamped(support: Support) -> Support {
    Support { clamp: Some("rod".into()), ..support }
}

fn slide(point: &str, direction: [f64; 2]) -> Support {
    Support { slide: Some(direction), ..free(point) }
}

fn heat(model: ThermalModel, dT: f64) -> Option<Temperature> {
    Some(Temperature { model, start: Default::default(), history: vec![[0.0, dT]] })
}

/// Held at both ends, straight: N = −EAαΔT/(1 − ν²), exactly in this strain measure, as the section is free to thicken; with
/// pins and with clamps, which hold the section's direction only. 5 K are half of what buckles it. By turned rods too.
#[test]
fn a_heated_rod_between_walls_is_pressed() {
    let force = 2e8 * 4e-4 * 2.85e-5 * 5.0 / (1.0 - 0.3 * 0.3);
    for model in [ThermalModel::TwoD, ThermalModel::OneD] {
        for supports in [vec![fixed("o"), fixed("a")], vec![clamped(fixed("o")), clamped(fixed("a"))]] {
            for angle in [0.0, 0.7] {
                let placing = Placing { mirrored: false, angle, by: [0.0, 0.0] };
                let mut scene = placing.scene(&bar(supports.clone()));
                scene.temperature = heat(model, 5.0);
                scene.probes = ["o", "a"].map(|point| probe(point, &[Quantity::Reaction])).to_vec();
                let run = must_run(&scene);
                for (point, sign) in [("o", 1.0), ("a", -1.0)] {
                    for (row, factor) in [0.0, 0.5, 1.0].into_iter().enumerate() {
                        let reaction = reactions(&run, point)[row];
                        let error = off(reaction, placing.vector([sign * factor * force, 0.0]));
                        assert!(error <= 1e-9 * force, "{model:?}, {angle}, {point}: {reaction:?} for {force}");
                    }
                }
            }
        }
    }
}

/// Free to expand: no force, and the stress-free stretch √(1 + 2αΔT), at half of the heat as well.
#[test]
fn a_heated_rod_that_is_free_to_expand_has_no_force() {
    for model in [ThermalModel::TwoD, ThermalModel::OneD] {
        for support in [fixed("o"), clamped(fixed("o"))] {
            let mut scene = bar(vec![support, slide("a", [1.0, 0.0])]);
            scene.temperature = heat(model, 200.0);
            scene.probes.push(probe("o", &[Quantity::Reaction]));
            scene.probes[2].name = "R_o".into();
            scene.probes.push(probe("a", &[Quantity::Reaction]));
            scene.probes[3].name = "R_a".into();
            let run = must_run(&scene);
            for (row, factor) in [0.0, 0.5, 1.0].into_iter().enumerate() {
                let a = positions(&run, "a")[row];
                let stretch = (1.0f64 + 2.0 * 2.85e-5 * 200.0 * factor).sqrt();
                assert!(off(a, [stretch, 0.0]) <= 1e-12, "{model:?}: {a:?}, not {stretch}");
            }
            // Of the force between walls.
            let largest = longest(&reactions(&run, "R_o")).max(longest(&reactions(&run, "R_a")));
            assert!(largest <= 1e-9 * 456.0, "{model:?}: {largest:.1e} N");
        }
    }
}

/// Two legs on two feet are statically determinate: heat, different in each rod, moves them without any force. The middle m is
/// where circles about the feet meet, half a rod's stress-free lengths away; heads are as far beyond it.
#[test]
fn heated_scissors_on_two_feet_move_without_force() {
    for points in [UPRIGHT, ASKEW] {
        let mut scene = scissor(points, 7e10, &[]);
        (scene.material.alpha, scene.material.nu) = (2.3e-5, 0.3);
        scene.rods[0].elements = 3;
        (scene.rods[0].temperature, scene.rods[1].temperature) =
            (heat(ThermalModel::TwoD, 150.0), heat(ThermalModel::OneD, -80.0));
        scene.probes.extend([force_on("m1", "a1b2"), force_on("m1", "b1a2")]);
        let run = must_run(&scene);

        let [a1, a2, b1, b2] = points.map(|(_, point)| point);
        let leg = |from: [f64; 2], to: [f64; 2], dT: f64| 0.5 * off(from, to) * (1.0 + 2.0 * 2.3e-5 * dT).sqrt();
        let (r_1, r_2, c) = (leg(b1, a2, -80.0), leg(b2, a1, 150.0), off(b1, b2));
        let (t, along) = ([(b2[0] - b1[0]) / c, (b2[1] - b1[1]) / c], (r_1 * r_1 - r_2 * r_2 + c * c) / (2.0 * c));
        let up = (r_1 * r_1 - along * along).sqrt();
        let m = [b1[0] + along * t[0] - up * t[1], b1[1] + along * t[1] + up * t[0]];
        let beyond = |foot: [f64; 2]| [2.0 * m[0] - foot[0], 2.0 * m[1] - foot[1]];
        for (point, expected) in [("m1", m), ("a1", beyond(b2)), ("a2", beyond(b1))] {
            let error = off(last(positions(&run, point)), expected);
            println!("{point}: off by {error:.1e} m");
            assert!(error <= 1e-10 && off(scene.position(point).unwrap(), expected) > 1e-3, "{point}: {error:.1e} m");
        }
        // Of EAαΔT, what walls would bear.
        let scale = 7e10 * 4e-4 * 2.3e-5 * 150.0;
        let forces = ["b1", "b2", "m1-a1b2", "m1-b1a2"].map(|name| longest(&reactions(&run, name)));
        assert!(forces.iter().all(|force| *force <= 1e-9 * scale), "{forces:?} N of {scale:.1e} N");
    }
}

/// A slide in an oblique direction is a slide along an axis, turned.
#[test]
fn an_oblique_slide_is_a_turned_one() {
    let mut scene = scissor(ASKEW, 7e9, &[("a1", [20.0, -35.0]), ("a2", [-30.0, -10.0])]);
    scene.supports = vec![
        fixed("b1"),
        Support { fix: vec![Direction::Y], ..free("b2") },
        Support { fix: vec![Direction::X], ..free("a2") },
    ];
    scene.probes[1].of.push(Quantity::Reaction);
    (scene.gravity, scene.temperature) = ([0.0, -9.81], heat(ThermalModel::TwoD, 60.0));
    scene.material.alpha = 2.3e-5;
    let straight = must_run(&scene);
    for placing in [
        Placing { mirrored: false, angle: 0.6, by: [0.0, 0.0] },
        Placing { mirrored: true, angle: 2.2, by: [-3.0, 7.0] },
    ] {
        let oblique = must_run(&placing.scene(&scene));
        for point in ["a1", "a2", "m1", "b2"] {
            let expected: Vec<_> = positions(&straight, point).into_iter().map(|r| placing.point(r)).collect();
            let error = farthest(&positions(&oblique, point), &expected);
            assert!(error <= 1e-10, "{placing:?}, {point}: {error:.1e} m");
        }
        for point in ["a2", "b1", "b2"] {
            let path = reactions(&straight, point);
            assert!(longest(&path) > 10.0, "{point} bears nothing");
            let expected: Vec<_> = path.into_iter().map(|force| placing.vector(force)).collect();
            let error = farthest(&reactions(&oblique, point), &expected);
            assert!(error <= 1e-7, "{placing:?}, {point}: {error:.1e} N");
        }
    }
}

fn refused(scene: &Scene) -> String {
    match run(scene) {
        Err(Error::Drifts { rods }) => rods,
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("{}: it was not refused, {:?}", scene.title, scene.supports),
    }
}

/// What can move without a strain is refused before the first step, and the rods that move are named.
#[test]
fn structures_that_drift_are_refused_by_name() {
    let held = |point: &str, fix| Support { fix: vec![fix], ..free(point) };
    for supports in [
        vec![],
        vec![fixed("o")],
        vec![clamped(free("o"))],
        vec![held("o", Direction::Y), held("a", Direction::Y)],
        vec![slide("o", [2.0, 1.0])],
        vec![clamped(slide("o", [2.0, 1.0]))],
        vec![held("o", Direction::X), slide("a", [0.0, 1.0])],
        // Both slides let it turn about where their normals meet: momentarily, at o.
        vec![slide("a", [0.0, 1.0]), slide("o", [1.0, 0.0])],
        vec![fixed("a"), slide("o", [0.0, 5.0])],
    ] {
        assert_eq!(refused(&bar(supports)), "`rod`");
    }

    let mut scene = scissor(UPRIGHT, 7e10, &[]);
    for supports in [
        vec![],
        vec![fixed("b1")],
        vec![fixed("b1"), held("b2", Direction::Y)],
        vec![fixed("m1")],
        // A wall at a1 does not stop it: as it folds, a1 sets out vertically.
        vec![fixed("b1"), held("b2", Direction::Y), held("a1", Direction::X)],
        vec![clamped(fixed("b1"))],
    ] {
        scene.supports = supports;
        scene.supports.iter_mut().for_each(|support| support.clamp = support.clamp.as_ref().map(|_| "b1a2".into()));
        scene.probes.clear();
        let rods = refused(&scene);
        let both = scene.supports.iter().all(|support| support.clamp.is_none());
        assert_eq!(rods, if both { "`a1b2`, `b1a2`" } else { "`a1b2`" });
    }
}

/// Rods between points, all of them pinned.
fn frame(points: &[(&str, [f64; 2])], rods: &[[&str; 2]], supports: Vec<Support>, load: (&str, [f64; 2])) -> Scene {
    let mut scene = scissor(UPRIGHT, 7e10, &[load]);
    scene.points = points.iter().map(|(name, point)| (name.to_string(), *point)).collect();
    let (element, poisson) = (scene.rods[0].element, scene.rods[0].poisson);
    let rod = |[from, to]: &[&str; 2]| {
        let mut rod = Rod::new(&format!("{from}{to}"), from, to).elements(element, 2);
        rod.poisson = poisson;
        rod
    };
    (scene.rods, scene.supports) = (rods.iter().map(rod).collect(), supports);
    let of = |point: &str| {
        let held = scene.supports.iter().any(|support| support.point == point);
        if held { vec![Quantity::Position, Quantity::Reaction] } else { vec![Quantity::Position] }
    };
    scene.probes = points.iter().map(|(name, _)| probe(name, &of(name))).collect();
    scene
}

/// What looks loose and is not is accepted, and in equilibrium: a triangle on a hinge and a slide, a shallow arch, a square
/// with a diagonal, a bar whose slides block one another.
#[test]
fn structures_that_only_look_loose_are_accepted() {
    let triangle = frame(
        &[("p", [0.0, 0.0]), ("q", [2.0, 0.0]), ("r", [0.7, 1.1])],
        &[["p", "q"], ["q", "r"], ["r", "p"]],
        vec![fixed("p"), slide("q", [1.0, 0.3])],
        ("r", [30.0, -80.0]),
    );
    let arch = frame(
        &[("p", [-1.0, 0.0]), ("top", [0.0, 0.05]), ("q", [1.0, 0.0])],
        &[["p", "top"], ["top", "q"]],
        vec![fixed("p"), fixed("q")],
        ("top", [1.0, -50.0]),
    );
    let square = frame(
        &[("p", [0.0, 0.0]), ("q", [1.0, 0.0]), ("r", [1.0, 1.0]), ("s", [0.0, 1.0])],
        &[["p", "q"], ["q", "r"], ["r", "s"], ["s", "p"], ["p", "r"]],
        vec![fixed("p"), slide("q", [1.0, 0.0])],
        ("s", [40.0, -10.0]),
    );
    for scene in [triangle, arch, square] {
        let loads: f64 = scene.forces.iter().map(|force| force.force[0].hypot(force.force[1])).sum();
        let bound = 1e-9 * (loads + 50.0 * f64::EPSILON * 7e10 * 4e-4);
        let sum = out_of_balance(&scene, &must_run(&scene));
        println!("out of balance by {sum:.1e} of {bound:.1e} N");
        assert!(sum <= bound, "{:?}: {sum:.1e} N, allowed {bound:.1e} N", scene.points);
    }
    for supports in [
        vec![fixed("o"), slide("a", [1.0, 0.0])],
        vec![fixed("o"), slide("a", [0.1, 1.0]), clamped(free("a"))],
        vec![slide("o", [1.0, 1.0]), clamped(slide("a", [1.0, -1.0]))],
        vec![clamped(fixed("o"))],
    ] {
        assert!(Structure::new(bar(supports.clone())).is_ok(), "{supports:?}");
    }
}

/// A square without a diagonal folds: all but the rod that is held still are named.
#[test]
fn a_square_without_a_diagonal_is_refused() {
    let square = frame(
        &[("p", [0.0, 0.0]), ("q", [1.0, 0.0]), ("r", [1.0, 1.0]), ("s", [0.0, 1.0])],
        &[["p", "q"], ["q", "r"], ["r", "s"], ["s", "p"]],
        vec![fixed("p"), slide("q", [1.0, 0.0])],
        ("s", [40.0, -10.0]),
    );
    assert_eq!(refused(&square), "`qr`, `rs`, `sp`");
}

/// Hundreds and thousands of scissors on the supports of a mechanism drift, whatever their angle, and are named; on two
/// feet they are held, and are not refused as drifting.
#[test]
fn long_structures_that_drift_are_refused() {
    for (count, angle) in [(70, 1.0), (100, 89.9), (1000, 80.0)] {
        let mut scene = Scissors { angle, elements: 1, ..Scissors::new(count) }.scene().unwrap();
        scene = scene.method(Method::Static, 1e-3).until(1.0);
        scene.output.interval = None;
        scene.probes.clear();
        let built = |scene: &Scene| Structure::new(scene).map(|structure| structure.size());
        assert!(matches!(built(&scene), Err(Error::Drifts { .. })), "{count} at {angle}: a mechanism is not found");
        scene.supports.clear();
        assert!(matches!(built(&scene), Err(Error::Drifts { .. })), "{count} at {angle}: nothing holds it");
        let foot = |point: &str| Support {
            point: point.into(),
            fix: vec![Direction::X, Direction::Y],
            slide: None,
            clamp: None,
        };
        scene.supports = vec![foot("b1"), foot("b2")];
        assert!(built(&scene).is_ok(), "{count} at {angle}: it is held");
    }
}

/// Thousands of rods at one point: the check of what drifts needs no more memory than the rods.
#[test]
fn many_rods_may_meet_at_one_point() {
    let mut scene = Scene::builtin("scissor-static").unwrap();
    let mut rod = scene.rods[0].clone();
    (rod.from, rod.pivot, rod.elements) = ("hub".into(), None, 1);
    scene.rods.clear();
    scene.points = [("hub".to_string(), [0.0, 0.0])].into();
    scene.supports.clear();
    for n in 0..6000 {
        let name = format!("p{n}");
        scene.points.insert(name.clone(), [f64::from(n).cos(), f64::from(n).sin()]);
        (rod.name, rod.to) = (format!("r{n}"), name.clone());
        scene.rods.push(rod.clone());
        let fix = vec![Direction::X, Direction::Y];
        scene.supports.push(Support { point: name, fix, slide: None, clamp: None });
    }
    scene.forces[0].point = "hub".into();
    scene.probes.clear();
    assert!(run(&scene).unwrap().counts.newton_iterations <= 5);
}

/// A rod that is fixed and clamped at its pivot is two cantilevers, each as stiff as one by itself. With an even number of
/// elements, whose pivot is a node between two, that holds but for the section's stretch there, which grows with the square
/// of the load; with an odd one, whose pivot is the middle of an element, as far as that element can bend on one side only.
#[test]
fn a_clamp_at_a_pivot_makes_two_cantilevers() {
    let tip = |elements: usize, from: [f64; 2], at: &str| {
        let mut scene = Scene::builtin("scissor-static").unwrap();
        scene.points = [("a", from), ("b", [1.0, 0.0]), ("c", [0.0, -1.0]), ("d", [0.0, 1.0])]
            .map(|(name, position)| (name.to_string(), position))
            .into();
        let pivot = (at == "m").then(|| "m".to_string());
        for (rod, [name, from, to]) in scene.rods.iter_mut().zip([["one", "a", "b"], ["two", "c", "d"]]) {
            (rod.name, rod.from, rod.to) = (name.into(), from.into(), to.into());
            (rod.elements, rod.pivot) = (elements, pivot.clone());
        }
        let hold = |point: &str, clamp: &str, fix: Vec<Direction>| Support {
            point: point.into(),
            fix,
            slide: None,
            clamp: Some(clamp.into()),
        };
        let both = || vec![Direction::X, Direction::Y];
        scene.supports = match at {
            "m" => vec![hold("m", "one", both()), hold("m", "two", Vec::new())],
            _ => vec![hold("a", "one", both()), hold("c", "two", both())],
        };
        (scene.forces[0].point, scene.forces[0].force) = ("b".into(), [0.0, -0.05]);
        scene.probes = vec![probe("b", &[Quantity::Position])];
        positions(&must_run(&scene), "b").pop().unwrap()
    };
    let one = tip(2, [0.0, 0.0], "a");
    assert!(one[1] < -1e-5, "it does not bend: {one:?}");
    for (elements, bound) in [(4, 1e-9), (9, 0.05), (19, 0.025)] {
        let two = tip(elements, [-1.0, 0.0], "m");
        let off = (two[1] - one[1]).abs() / one[1].abs();
        println!("{elements} elements: off by {off:.1e} of the deflection");
        evidence::number(&format!("statics.odd.{elements}"), off);
        assert!(off <= bound, "{elements} elements: {two:?}, by itself {one:?}");
    }
}
