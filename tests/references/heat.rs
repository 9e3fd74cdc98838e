//! A straight heated rod: free, and between walls.

use ancf::internals::elements::Meaning;
use ancf::model::{Quantity, Scene, Support, Temperature, ThermalModel};
use ancf::run::run;

use crate::common::evidence;
use crate::common::motion::{Placing, probe, reactions};
use crate::common::references::{Kind, Reference, References, Shape, rod, solve};

/// Stretches are uniform, which one element has among its fields: exact but for rounding, of which Newton's
/// iteration leaves at most eight, and an entry of the force may hide as many in each of the rod's strains.
const UNIFORM: f64 = 1e-13;

/// What a reference on heat is for: kinds, thermal models, its entry. Euler and Bernoulli's rod has no section that
/// 2D heat could thicken.
fn cases<'a>(references: &'a References, tag: &str) -> Vec<(Kind, ThermalModel, Reference<'a>)> {
    let mut cases = Vec::new();
    for reference in references.tagged(&["thermal", tag, "element"], 6) {
        let model = match reference.text("model") {
            "1d" => ThermalModel::OneD,
            "2d" => ThermalModel::TwoD,
            "transverse" => ThermalModel::Transverse,
            other => panic!("no model {other}"),
        };
        cases.extend([Kind::Paper, Kind::Axis].map(|kind| (kind, model, reference)));
    }
    let [axial] = references.tagged(&["thermal", tag, "euler-bernoulli"], 1)[..] else { unreachable!() };
    cases.extend([ThermalModel::OneD, ThermalModel::TwoD].map(|model| (Kind::EulerBernoulli, model, axial)));
    cases
}

fn heated(kind: Kind, model: ThermalModel, reference: &Reference, elements: usize) -> Scene {
    let mut scene = rod(kind, reference, elements);
    scene.material.alpha = reference.parameter("alpha");
    let history = vec![[0.0, reference.parameter("dT")]];
    scene.temperature = Some(Temperature { model, start: Default::default(), history });
    scene
}

/// Largest distance of the stretches at the nodes, of a rod of 1 m along x, from the one along the axis; and, where it
/// has a section, from the thickness.
fn stretched(shape: &Shape, stretch: f64, thickness: Option<f64>) -> f64 {
    // Displacements of equally distant points, as many as the element has.
    let axis = shape.all(Meaning::Position);
    let pieces = (axis.len() - 1) as f64;
    let chords = axis.windows(2).map(|ends| 1.0 + pieces * (ends[1].x - ends[0].x));
    let slopes = shape.all(Meaning::SlopeX).into_iter().map(|slope| slope.x);
    let across = shape.all(Meaning::SlopeY).into_iter().map(|director| director.y - thickness.unwrap());
    chords.chain(slopes).map(|s| s - stretch).chain(across).fold(0.0, |far, off| far.max(off.abs()))
}

/// What heat makes of a rod that is free: √(1 + 2αΔT) in the heated directions of the paper's strain, in every
/// model, ν = 0 and 0.3: heat across thickens the rod and leaves its length, whatever ν is; 1 + αΔT of the strain |r_x| − 1.
#[test]
fn a_free_heated_rod_takes_the_stretches_without_stress() {
    let references = References::load();
    let cases = cases(&references, "free");
    let of_struts = cases.iter().filter(|(kind, ..)| *kind == Kind::Paper);
    let of_struts: Vec<_> = of_struts.map(|&(_, model, reference)| (Kind::Uniaxial, model, reference)).collect();
    for (kind, model, reference) in cases.into_iter().chain(of_struts) {
        for elements in [1, 4] {
            let shape = solve(&heated(kind, model, &reference, elements));
            let thickness = (kind != Kind::EulerBernoulli).then(|| reference.value("thickness"));
            let error = stretched(&shape, reference.value("stretch"), thickness);
            println!("{kind:?}, {model:?}, {}, {elements} elements: off by {error:.1e}", reference.id());
            evidence::at_most("references.free-heat", error);
            assert!(error <= UNIFORM, "{kind:?}, {model:?}, {}, {elements}: {error:.1e}", reference.id());
        }
    }
}

/// Between walls N = −EAαΔT/(1 − ν²) in the 1D and the 2D model, with the section free to thicken, −EAαΔT where it is free to
/// contract across, and nothing where heat strains the section alone, which thickens; 5 K are half of what buckles the rod. Straight and turned, clamped and pinned: a straight rod does
/// not feel the difference.
#[test]
fn a_heated_rod_between_walls_bears_the_force() {
    let references = References::load();
    for (kind, model, reference) in cases(&references, "clamped") {
        for (elements, clamped) in [(1, true), (4, true), (3, false)] {
            let mut scene = heated(kind, model, &reference, elements);
            let clamp = |support: &Support| support.clamp.clone().filter(|_| clamped);
            let wall = |point: &str| {
                let support = &scene.supports[0];
                Support { point: point.into(), clamp: clamp(support), ..support.clone() }
            };
            scene.supports = vec![wall("o"), wall("a")];
            scene.probes = ["o", "a"].map(|point| probe(point, &[Quantity::Reaction])).to_vec();
            let N = reference.value("N");
            // What heat along the rod would press with at ν = 0.
            let size = ["E", "h", "w", "alpha", "dT"].map(|name| reference.parameter(name)).iter().product::<f64>();
            let mut largest: f64 = 0.0;
            for angle in [0.0, 0.7, 2.0] {
                let placing = Placing { mirrored: false, angle, by: [0.0, 0.0] };
                let forces = run(placing.scene(&scene)).unwrap();
                for (point, sign) in [("o", -1.0), ("a", 1.0)] {
                    let [x, y] = *reactions(&forces, point).last().unwrap();
                    let [x_0, y_0] = placing.vector([sign * N, 0.0]);
                    let error = (x - x_0).hypot(y - y_0) / size;
                    assert!(error <= 1e-12, "{kind:?}, {}, {elements}, {angle}: {error:.1e} of EAαΔT", reference.id());
                    largest = largest.max(error);
                }
            }
            evidence::at_most("references.heat-between-walls", largest);
            let thickness = (kind != Kind::EulerBernoulli).then(|| reference.value("thickness"));
            let error = stretched(&solve(&scene), 1.0, thickness);
            println!(
                "{kind:?}, {model:?}, {}, {elements} elements, clamped {clamped}: N off by {largest:.1e} of EAαΔT, \
                 stretches by {error:.1e}",
                reference.id()
            );
            assert!(error <= UNIFORM, "{kind:?}, {}, {elements}: {error:.1e}", reference.id());
        }
    }
}
