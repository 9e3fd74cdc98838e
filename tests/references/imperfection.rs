//! Rods that are bowed without stress at the start, and buckle.

use ancf::model::{
    Force, Imperfection, Material, Method, Probe, Rod, Scene, Section, Support, Temperature, ThermalModel,
};
use ancf::run::run;
use nalgebra::Vector2;

use crate::common::references::{Reference, References};

/// A rod from a to b at an angle, 1 m long unless the reference says otherwise, in statics.
///
/// ```text
///                 ╭──── w ────╮
///   ▒ a ══════════           ══════════ b ▒ ← P
/// ```
fn rod_at(angle: f64, reference: &Reference, elements: usize) -> Scene {
    let number = |name| reference.parameter(name);
    let mut material = Material::new(number("E"), number("nu"), 2700.0);
    if reference.has_parameter("alpha") {
        material = material.alpha(number("alpha"));
    }
    let (t, mut rod) = (Vector2::new(angle.cos(), angle.sin()), Rod::new("rod", "a", "b"));
    rod.elements = elements;
    let mut scene = Scene::new(material, Section::new(number("h"), number("w")))
        .point("a", [0.0, 0.0])
        .point("b", (number("L") * t).into())
        .rod(rod)
        .probe(Probe::deflection("w", "rod", 0.5));
    scene.time.method = Method::Static;
    scene.imperfection = Some(Imperfection::of_rod("rod", number("a")));
    scene
}

fn deflection(scene: &Scene) -> f64 {
    *run(scene).unwrap().trajectory.column("w.w").unwrap().last().unwrap()
}

/// A pinned column at shares of its critical load. The model's own critical load differs from the reference's by the strain P/EA,
/// which (1 − P/P_cr) enlarges.
#[test]
fn an_imperfect_column_bows_by_its_amplitude_over_one_less_the_share() {
    let references = References::load();
    for reference in references.tagged(&["imperfection", "column"], 4) {
        for angle in [0.0, 1.0_f64] {
            let (P, a) = (reference.parameter("P"), reference.parameter("a"));
            let t = Vector2::new(angle.cos(), angle.sin());
            let mut scene = rod_at(angle, &reference, 4)
                .support(Support::pinned("a"))
                .support(Support::sliding("b", t.into()))
                .force(Force::new("b", (-P * t).into()));
            (scene.time.load_steps, scene.time.newton_tolerance) = (1, 1e-13);
            let expected = reference.value("middle.w");
            for imperfection in [Imperfection::of_rod("rod", a), Imperfection::of_mode(1, a)] {
                scene.imperfection = Some(imperfection);
                let w = deflection(&scene);
                let strain = P / (reference.parameter("E") * scene.section.height * scene.section.width);
                let allowed = 5.0 * strain * expected / a;
                println!("{}, {angle}: {:.1e} off, allowed {allowed:.1e}", reference.id(), w / expected - 1.0);
                assert!((w / expected - 1.0).abs() <= allowed, "{}, {angle}: {w:e} {expected:e}", reference.id());
            }
        }
    }
}

/// A clamped rod heated to three times its critical temperature, in twelve directions, bowed either way or in its first mode:
/// one answer, that of the closed form but for the shear strain, of the share π²h²/3L² · E/G ≈ 0.3 %, and the mesh.
#[test]
fn a_heated_rod_bows_alike_in_every_direction() {
    let references = References::load();
    for reference in references.tagged(&["imperfection", "heated"], 2) {
        let a = reference.parameter("a");
        let bow = |n: u32, imperfection: Imperfection| {
            let history = vec![[0.0, reference.parameter("dT")]];
            let mut scene = rod_at(f64::from(n) * std::f64::consts::FRAC_PI_6, &reference, 8)
                .support(Support::pinned("a").clamping("rod"))
                .support(Support::pinned("b").clamping("rod"))
                .temperature(Temperature { model: ThermalModel::TwoD, start: Default::default(), history });
            (scene.time.load_steps, scene.imperfection) = (50, Some(imperfection));
            deflection(&scene)
        };
        let directions =
            |imperfection: &Imperfection| (0..12).map(|n| bow(n, imperfection.clone())).collect::<Vec<f64>>();
        let [left, right, mode] =
            [Imperfection::of_rod("rod", a), Imperfection::of_rod("rod", -a), Imperfection::of_mode(1, a)]
                .map(|imperfection| directions(&imperfection));
        let spread = |bows: &[f64], of: f64| bows.iter().map(|w| (w / of - 1.0).abs()).fold(0.0, f64::max);
        let (alike, in_mode) = (spread(&left, left[0]), spread(&mode, left[0]));
        let expected = reference.value("middle.w");
        println!("{}: {:.5} m, {expected:.5} m; directions {alike:.1e}, mode {in_mode:.1e}", reference.id(), left[0]);
        assert!((left[0] / expected - 1.0).abs() <= 3e-3, "{}: {} {expected}", reference.id(), left[0]);
        // Rounding.
        assert!(
            alike.max(spread(&right, -left[0])).max(spread(&mode, mode[0])) <= 1e-10,
            "{left:?} {right:?} {mode:?}"
        );
        // The mode of vibration is no sin²: their parts in the mode of buckling differ by a hundredth of the amplitude or so.
        assert!(in_mode <= 0.02 * a / expected, "{}: {in_mode:.1e}", reference.id());
    }
}
