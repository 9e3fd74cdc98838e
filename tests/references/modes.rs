//! Modes and buckling of straight rods under an axial force or heat.

use ancf::model::{Force, Scene, Support, Temperature, ThermalModel};
use ancf::run::{About, Mode, buckling, modes};

use crate::common::references::{Kind, Reference, References, assert_stored, slender};

/// Elements of the meshes: the order is taken between the first two, where rounding is far, the error with the last.
const MESHES: [usize; 3] = [16, 32, 64];

/// Largest relative error with the last mesh.
const BAR: f64 = 1e-6;

/// Rounding of a slender rod's slowest modes: fields are admissible, and come from above but for this (Rayleigh).
const ROUNDING: f64 = 1e-9;

/// A rod from o = (0, 0) to a = (L, 0), simply supported or clamped. Under a force P its end slides; heated, it is held.
///
/// ```text
///   y
///   │  o ══════════════════════════════ a ◄── P     ▒o ═══════════════════ a▒  ΔT
///   └─ △              L, h × w          ○           ▒                       ▒
/// ```
fn scene(element: Kind, reference: &Reference, elements: usize) -> Scene {
    let of = |name| reference.parameter(name);
    let mut scene = slender(element, of("h"), elements);
    let material = &mut scene.material;
    (material.youngs_modulus, material.nu) = (of("E"), of("nu"));
    (material.rho, material.alpha) = (of("rho"), of("alpha"));
    scene.points.insert("a".into(), [of("L"), 0.0]);
    scene.time.load_steps = 4;
    let is_clamped = reference.id().contains("clamped");
    let clamped = |support: Support| if is_clamped { support.clamping("rod") } else { support };
    let end = if reference.has_parameter("dT") { Support::pinned("a") } else { Support::sliding("a", [1.0, 0.0]) };
    scene.supports = vec![clamped(Support::pinned("o")), clamped(end)];
    if reference.has_parameter("P") {
        scene.forces = vec![Force::new("a", [of("P"), 0.0])];
    }
    if reference.has_parameter("dT") {
        scene.temperature = Some(Temperature::new(ThermalModel::TwoD, vec![[0.0, of("dT")]]));
    }
    scene.probes.clear();
    scene
}

fn kind(reference: &Reference) -> Kind {
    if reference.id().ends_with("euler-bernoulli") { Kind::EulerBernoulli } else { Kind::Paper }
}

/// Modes across the rod: those along it have no displacement across.
fn across(modes: &[Mode]) -> Vec<f64> {
    let largest = |mode: &Mode| mode.shape[0].iter().map(|moved| moved[1].abs()).fold(0.0, f64::max);
    modes.iter().filter(|mode| largest(mode) > 0.5).map(|mode| mode.square.sqrt()).collect()
}

/// Source: `oracle/references/prestressed.py`, the theories' own rods. Goal: ω of the first three modes across, cold, under a force of
/// half the Euler load, and under heat of two fifths of what buckles the rod. The energy is of order 4 in the element length, and so is ω.
#[test]
fn frequencies_are_those_of_the_theory() {
    let references = References::load();
    for reference in references.tagged(&["modes"], 12) {
        let found = MESHES.map(|elements| {
            let model = scene(kind(&reference), &reference, elements).build();
            across(&modes(&model.unwrap(), About::Loaded, 5).unwrap().modes)
        });
        for n in 0..3 {
            let exact = reference.value(&format!("omega_{}", n + 1));
            let [e_16, e_32, e_64] = found.each_ref().map(|omega| omega[n] / exact - 1.0);
            let order = (e_16 / e_32).log2();
            let what = format!("{}, mode {}", reference.id(), n + 1);
            println!("{what}: {e_16:+.2e} {e_32:+.2e} {e_64:+.2e}, order {order:.2}");
            assert!((order - 4.0).abs() <= 0.05, "{what}: order {order:.2}");
            assert!((-ROUNDING..=BAR).contains(&e_64), "{what}: {e_64:.2e}");
        }
    }
}

/// Source: `oracle/references/prestressed.py`. Goal: the factor of the load or of the heat, linearised and on the path of equilibria.
/// The theory's own factors differ from Euler's by what is stored here: by shear, −π²EI/GAL² of the load (times 4 where
/// clamped), by the shortening of the rod, and by none of both for Euler and Bernoulli's heated rod.
#[test]
fn buckling_factors_are_those_of_the_theory() {
    let references = References::load();
    let from_euler = [
        ("buckling-supported-loaded-ancf", -1.314e-3),
        ("buckling-supported-heated-ancf", -3.289e-4),
        ("buckling-clamped-loaded-ancf", -5.239e-3),
        ("buckling-clamped-heated-ancf", -1.314e-3),
        ("buckling-supported-loaded-euler-bernoulli", 3.292e-4),
        ("buckling-supported-heated-euler-bernoulli", 0.0),
        ("buckling-clamped-loaded-euler-bernoulli", 1.319e-3),
        ("buckling-clamped-heated-euler-bernoulli", 0.0),
    ];
    assert_eq!(references.tagged(&["buckling"], 8).len(), from_euler.len());
    for (id, difference) in from_euler {
        let reference = references.entry(id);
        let about = if reference.has_parameter("dT") { About::Heated } else { About::Loaded };
        let found = MESHES.map(|elements| {
            let model = scene(kind(&reference), &reference, elements).build();
            let found = buckling(&model.unwrap(), about).unwrap();
            [found.linearised.unwrap(), found.factor.unwrap()]
        });
        for (n, name) in ["linearised", "factor"].into_iter().enumerate() {
            let [e_16, e_32, e_64] = found.map(|found| found[n] / reference.value(name) - 1.0);
            let order = (e_16 / e_32).log2();
            println!("{id}, {name}: {e_16:+.2e} {e_32:+.2e} {e_64:+.2e}, order {order:.2}");
            assert!((order - 4.0).abs() <= 0.1, "{id}, {name}: order {order:.2}");
            assert!(e_64.abs() <= BAR, "{id}, {name}: {e_64:.2e}");
        }
        let own = reference.value("factor") / reference.value("euler") - 1.0;
        if difference == 0.0 {
            assert!(own.abs() <= 1e-15, "{id}: {own:.1e}");
        } else {
            assert_stored(&format!("{id}, from Euler's"), own, difference);
        }
    }
}
