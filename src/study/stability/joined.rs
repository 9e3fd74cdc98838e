//! A stiff rod that carries a soft one.

use super::case::{Case, Expected, Finding, Trial};
use super::tools::{EPS, builtin, columns, largest, positions};
use crate::error::Result;
use crate::run::{Run, run};
use crate::scene::{Constraints, Element, Method, Probe, Quantity, Scene};

pub const CASE: Case = Case {
    name: "soft-and-stiff",
    parameter: "ratio of the moduli",
    unit: "of L (balance: of the largest kinetic energy)",
    reference: "a stiff rod is straight and keeps its length; the energy of the start",
    right: "rigid limit: deflection of the stiff rod's middle and change of its length at most twice what its loads make: a force P at its end \
            and q = ρA(g + a) along it bend a hinged rod by at most (0.2 PL + qL²/20) L²/8EI and stretch it by at most (P + R)L/EA, with \
            the largest P, R and a of the run; twice, for its own vibration. Balance, energy–momentum only: at most 2 ε_mach a step, \
            Newton's 1e-12 of the largest force over the way, and the stiff rod's rounding EA ε_mach |u|/l over the way. No shift of the one without the other.",
    trials,
};

const RATIOS: [f64; 8] = [1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14];

/// Modulus of the soft rod, Pa.
const SOFT: f64 = 2e8;

fn trials() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for (method, constraints, element) in [
        (Method::EnergyMomentum, Constraints::Condensed, Element::Ancf),
        (Method::EnergyMomentum, Constraints::Condensed, Element::EulerBernoulli),
        (Method::GeneralizedAlpha, Constraints::Condensed, Element::Ancf),
        (Method::GeneralizedAlpha, Constraints::Multipliers, Element::Ancf),
    ] {
        for ratio in RATIOS {
            let expected = if ratio <= 1e8 { Expected::Result } else { Expected::ResultOrRefusal };
            let fast = method == Method::EnergyMomentum && element == Element::Ancf && (ratio == 1e4 || ratio == 1e8);
            let name = |what: &str| format!("{method}, {constraints}, {element}, {what}");
            let make = move || scene(method, constraints, element, ratio);
            let rigid = Trial::new(name("rigid limit"), ratio, move || rigid(&make()?, ratio));
            trials.push(rigid.fast(fast).expect(expected));
            if method == Method::EnergyMomentum {
                let balance = Trial::new(name("balance"), ratio, move || balance(&make()?));
                trials.push(balance.fast(fast).expect(expected));
            }
        }
    }
    Ok(trials)
}

fn probe(name: &str, point: Option<&str>, rod: Option<&str>, at: Option<f64>, of: &[Quantity]) -> Probe {
    let text = |name: &str| name.to_string();
    Probe { name: name.into(), point: point.map(text), rod: rod.map(text), at, of: of.to_vec() }
}

fn scene(method: Method, constraints: Constraints, element: Element, ratio: f64) -> Result<Scene> {
    let mut scene = builtin("pendulum-flexible")?;
    scene.points.insert("b".into(), [2.0, 0.0]);
    let mut soft = scene.rods[0].clone();
    (soft.name, soft.from, soft.to) = ("soft".into(), "a".into(), "b".into());
    let mut stiff = scene.material.clone();
    stiff.youngs_modulus = SOFT * ratio;
    scene.rods[0].material = Some(stiff);
    scene.rods.push(soft);
    scene.rods.iter_mut().for_each(|rod| (rod.element, rod.elements) = (element, 4));
    (scene.time.method, scene.constraints) = (method, constraints);
    (scene.time.step, scene.time.end, scene.time.newton_tolerance) = (1e-3, 1.0, 1e-12);
    scene.output.interval = None;
    scene.probes = vec![
        probe("a", Some("a"), None, None, &[Quantity::Position, Quantity::Acceleration]),
        probe("o", Some("o"), None, None, &[Quantity::Reaction]),
        probe("pin", Some("a"), Some("rod"), None, &[Quantity::Reaction]),
        probe("middle", None, Some("rod"), Some(0.5), &[Quantity::Deflection]),
    ];
    Ok(scene)
}

/// The longest of a probe's vectors.
fn longest(run: &Run, probe: &str, suffixes: [&str; 2]) -> f64 {
    columns(run, probe, suffixes).into_iter().map(|[x, y]| x.hypot(y)).fold(0.0, f64::max)
}

fn rigid(scene: &Scene, ratio: f64) -> Result<Finding> {
    let own = run(scene)?;
    let (h, rho) = (scene.section.height, scene.material.rho);
    let (area, modulus) = (h * h, SOFT * ratio);
    let bending = modulus * h.powi(4) / 12.0;
    let (pin, hinge) = (longest(&own, "pin", ["rx", "ry"]), longest(&own, "o", ["rx", "ry"]));
    let along = rho * area * (9.8 + longest(&own, "a", ["ax", "ay"]));
    let bent = 2.0 * (0.2 * pin + 0.05 * along) / (8.0 * bending);
    let stretched = 2.0 * (pin + hinge) / (modulus * area);
    let length = positions(&own, "a").into_iter().map(|[x, y]| (x.hypot(y) - 1.0).abs()).fold(0.0, f64::max);
    // Output rounds places to ε_mach.
    let rounding = 4.0 * EPS;
    Ok(Finding {
        error: largest(&own, "middle.w").max(length),
        bound: bent.max(stretched) + rounding,
        why: format!("bent {bent:.1e}, stretched {stretched:.1e}: pin {pin:.0} N, hinge {hinge:.0} N"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

fn balance(scene: &Scene) -> Result<Finding> {
    let own = run(scene)?;
    let rounding = 2.0 * EPS * own.counts.steps as f64;
    // Of a force that does work over the length: the weight, m g, of kinetic energies of the size m g L.
    let newton = 10.0 * scene.time.newton_tolerance;
    // The force EA ε_mach |u|/l of the stiff rod along all of the way, |u| ≤ 2L, over a kinetic energy of the size of m g L.
    let stiff = scene.rods[0].material.as_ref().map_or(0.0, |material| material.youngs_modulus);
    let stiffness = EPS * 8.0 * stiff / (scene.material.rho * 9.8);
    Ok(Finding {
        error: largest(&own, "energy.balance") / largest(&own, "energy.kinetic"),
        bound: rounding + newton + stiffness,
        why: format!("rounding {rounding:.1e}, Newton {newton:.1e}, rounding of the stiff rod's force {stiffness:.1e}"),
        size: None,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
