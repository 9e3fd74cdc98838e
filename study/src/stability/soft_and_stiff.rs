//! A stiff rod that carries a soft one.
//!
//! **Rigid limit.** Beside its chord, which joins two pins, a rod hangs like a simply supported beam under q(x) = ρA(g − a x/L), with the
//! parts of the weight and of its end's acceleration across it: its middle is 5L⁴/(384 EI) times the mean of q from the chord, 1 + 1.6
//! (h/L)² with shear, 1/(1 − N/N_cr) under an axial force N, N_cr = π²EI/L². It is longer or shorter by at most (P + R)L/EA, the forces
//! at its ends. Loads that come suddenly make twice of both.
//!
//! **Motion.** Where the two rods are, the ends of both, by another method on the same mesh: Gauss's collocation, whose distance from a
//! step of nothing is the series of three halved steps. It converges to a ratio of 1e4; from there on the motion goes to its limit as
//! 1/ratio, so that the ratios 1e2, 1e3, 1e4 are a series as well, each term at most the observed part of the last, or a tenth.
//!
//! **Balance.** The strain energy is a sum of strains that carry ε_mach |u|/l, |u| ≤ 2L: at most 2 · 8 N ε_mach L in a step, where N ≤ P + R,
//! once in the energy and once in the work; 2 ε_mach of the kinetic energy. Newton's iteration leaves its tolerance times the largest
//! force, N, in each unknown, which works over the way of the fastest point.

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, Path, builtin, columns, largest, positions};
use super::richardson::{self, Halving};
use crate::error::Result;
use crate::error_time::samples;
use ancf::model::plan::Plan;
use ancf::model::{Constraints, Element, Method, Probe, Quantity, Scene};
use ancf::run::{Run, run};
use ancf::structure::Structure;

pub const CASE: Case = Case {
    name: "soft-and-stiff",
    parameter: "ratio of the moduli",
    unit: "of L (balance: of the largest kinetic energy)",
    reference: "motion: `gauss` on the same mesh, with its series of halved steps (from a ratio of 1e4 on, its limit as 1/ratio); rigid limit: \
                a stiff rod is straight and keeps its length; balance: the energy of the start",
    right: "motion: both rods' ends at most the series of three runs with halved steps off, and the reference's, and the rounding EA ε_mach |u|/l \
            that acts like a load. Rigid limit: the stiff rod's middle from its chord at most twice (sudden) 5L⁴/(384 EI) ρA(g + ½a) with \
            the parts across the rod, × (1 + 1.6 (h/L)²)/(1 − N/N_cr); its length changes by at most twice (P + R)L/EA. Not at ratios \
            below 100, whose N is above the Euler load N_cr of the stiff rod: there is no such limit. Balance, energy–momentum only: \
            2n (ε_mach + 8 N ε_mach L/T), and 1e-14 N in each unknown over the way. No shift of the one without the other.",
    trials,
};

const RATIOS: [f64; 8] = [1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14];

/// Modulus of the soft rod, Pa.
const SOFT: f64 = 2e8;
/// Elements of each rod.
const ELEMENTS: usize = 4;
/// The largest ratio at which collocation converges with a step of 1e-3 s.
const COLLOCATED: f64 = 1e4;

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
            trials.push(Trial::new(name("motion"), ratio, move || motion(&make()?, element, ratio)).expect(expected));
            if ratio > 1.0 {
                let rigid = Trial::new(name("rigid limit"), ratio, move || rigid(&make()?, ratio));
                trials.push(rigid.fast(fast).expect(expected));
            }
            if method == Method::EnergyMomentum {
                let balance = Trial::new(name("balance"), ratio, move || balance(make()?));
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
    scene.rods.iter_mut().for_each(|rod| (rod.element, rod.elements) = (element, ELEMENTS));
    (scene.time.method, scene.constraints) = (method, constraints);
    (scene.time.step, scene.time.end, scene.time.newton_tolerance) = (1e-3, 1.0, 1e-12);
    scene.output.interval = None;
    scene.probes = vec![
        probe("a", Some("a"), None, None, &[Quantity::Position, Quantity::Acceleration]),
        probe("b", Some("b"), None, None, &[Quantity::Position]),
        probe("o", Some("o"), None, None, &[Quantity::Reaction]),
        probe("pin", Some("a"), Some("rod"), None, &[Quantity::Reaction]),
        probe("middle", None, Some("rod"), Some(0.5), &[Quantity::Deflection]),
    ];
    Ok(scene)
}

/// Modulus of the stiff rod, Pa.
fn stiff(scene: &Scene) -> f64 {
    scene.rods[0].material.as_ref().map_or(f64::NAN, |material| material.youngs_modulus)
}

/// The pin's place and the free end's, one after the other.
fn ends(run: &Run) -> Path {
    [positions(run, "a"), positions(run, "b")].concat()
}

fn motion(scene: &Scene, element: Element, ratio: f64) -> Result<Finding> {
    let mut scene = scene.clone();
    scene.time.newton_tolerance = 1e-10;
    let (own, step) = richardson::in_steps(&scene, 2, ends)?;
    let collocated = |ratio: f64| {
        let mut scene = self::scene(Method::Gauss, Constraints::Condensed, element, ratio)?;
        (scene.time.newton_tolerance, scene.output.interval) = (1e-10, None);
        richardson::in_steps(&scene, 4, ends)
    };
    let (reference, its) = collocated(ratio.min(COLLOCATED))?;
    let limit = if ratio > COLLOCATED {
        let [coarser, coarse] =
            [collocated(1e-2 * COLLOCATED)?.0, collocated(0.1 * COLLOCATED)?.0].map(|run| ends(&run));
        let series =
            Halving::with(samples::largest(&coarser, &coarse), samples::largest(&coarse, &ends(&reference)), 0.1);
        series.bound() - series.first - series.second
    } else {
        0.0
    };
    // What Newton may leave of the largest force, like a load, in both runs: 2 · ½ 1e-10 F/m t², F/m ≤ 3g.
    let newton = scene.time.newton_tolerance * 3.0 * 9.8 * scene.time.end.powi(2);
    // |u| ≤ 2L, l = L/4; the acceleration EA ε_mach |u|/(l m), as a load that does not change: ½ t².
    let rounding = 0.5 * scene.time.end.powi(2) * stiff(&scene) * EPS * 2.0 * ELEMENTS as f64 / scene.material.rho;
    Ok(Finding {
        error: samples::largest(&ends(&own), &ends(&reference)),
        bound: step.bound() + its.bound() + limit + newton + rounding,
        why: format!("step {step}, the reference's {its}, its limit {limit:.1e}, rounding {rounding:.1e}"),
        size: 1.0,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

/// The longest of a probe's vectors.
fn longest(run: &Run, probe: &str, suffixes: [&str; 2]) -> f64 {
    columns(run, probe, suffixes).into_iter().map(|[x, y]| x.hypot(y)).fold(0.0, f64::max)
}

/// The largest forces at the ends of the stiff rod together, N.
fn at_ends(run: &Run) -> f64 {
    longest(run, "pin", ["rx", "ry"]) + longest(run, "o", ["rx", "ry"])
}

fn rigid(scene: &Scene, ratio: f64) -> Result<Finding> {
    let own = run(scene)?;
    let (h, rho) = (scene.section.height, scene.material.rho);
    let (area, modulus) = (h * h, SOFT * ratio);
    let bending = modulus * h.powi(4) / 12.0;
    let chord = positions(&own, "a");
    // Of a vector, the largest part across the chord.
    let across = |vectors: &[[f64; 2]]| {
        let parts = vectors.iter().zip(&chord).map(|([vx, vy], [x, y])| (vy * x - vx * y).abs() / x.hypot(*y));
        parts.fold(0.0, f64::max)
    };
    let weight = across(&vec![scene.gravity; chord.len()]);
    let load = rho * area * (weight + 0.5 * across(&columns(&own, "a", ["ax", "ay"])));
    let ends = at_ends(&own);
    let euler = std::f64::consts::PI.powi(2) * bending;
    let bent = 2.0 * 5.0 * load / (384.0 * bending) * (1.0 + 1.6 * h * h) / (1.0 - ends / euler);
    let stretched = 2.0 * ends / (modulus * area);
    let length = chord.iter().map(|[x, y]| (x.hypot(*y) - 1.0).abs()).fold(0.0, f64::max);
    // Output rounds places to ε_mach.
    let rounding = 4.0 * EPS;
    Ok(Finding {
        error: largest(&own, "middle.w").max(length),
        // Above the Euler load there is no limit.
        bound: if ends < euler { bent.max(stretched) + rounding } else { f64::INFINITY },
        why: format!("bent {bent:.1e}, stretched {stretched:.1e}: {load:.0} N/m across, {ends:.0} N at the ends"),
        size: 1.0,
        rounding,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}

fn balance(mut scene: Scene) -> Result<Finding> {
    scene.time.newton_tolerance = 1e-14;
    let own = run(&scene)?;
    let (steps, kinetic, force) = (own.counts.steps as f64, largest(&own, "energy.kinetic"), at_ends(&own));
    let rounding = 2.0 * steps * EPS * (1.0 + 2.0 * ELEMENTS as f64 * force / kinetic);
    let unknowns = Structure::planned(&scene, &Plan::of(&scene))?.size() as f64;
    let fastest = positions(&own, "b");
    let way: f64 = fastest.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum();
    let newton = unknowns * scene.time.newton_tolerance * force * way / kinetic;
    Ok(Finding {
        error: largest(&own, "energy.balance") / kinetic,
        bound: rounding + newton,
        why: format!("rounding {rounding:.1e}, Newton {newton:.1e}: {force:.0} N, {way:.1} m"),
        size: 1.0,
        rounding: rounding + newton,
        counts: own.counts,
        warnings: own.warnings,
        beside: None,
    })
}
