//! A stiff rod that carries a soft one.
//!
//! **Rigid limit.** Relative to its chord between two pins, a rod hangs like a simply supported beam under q(x) = ρA(g − a x/L), with the
//! components of the weight and of its end's acceleration across it. Its middle is 5L⁴/(384 EI) times the mean of q from the chord, times
//! 1 + 1.6 (h/L)² with shear, times 1/(1 − N/N_cr) under an axial force N, N_cr = π²EI/L². Its length changes by at most (P + R)L/EA, the
//! forces at its ends. Sudden loads double both.
//!
//! **Motion.** The ends of both rods, compared with another method on the same mesh: Gauss's collocation, with its own series of three
//! halved steps. It converges up to a ratio of 1e4. Beyond, the motion approaches its limit as 1/ratio, so that the ratios 1e2, 1e3, 1e4
//! are a series as well, each term at most the observed ratio of the last, or a tenth.
//!
//! **Balance.** The strain energy is a sum of strains that carry ε_mach |u|/l, |u| ≤ 2L: at most 2 · 8 N ε_mach L in a step, where
//! N ≤ P + R, once in the energy and once in the work; 2 ε_mach of the kinetic energy. Newton's iteration leaves its tolerance times the
//! largest force, N, in each unknown, which works over the way of the fastest point.

use super::prelude::*;
use super::richardson::{self, Series};
use super::stiff::rounding_as_load;
use ancf::internals::structure::Structure;

pub const CASE: Case = Case {
    name: "soft-and-stiff",
    parameter: "ratio of the moduli",
    unit: "of L (balance: of the largest kinetic energy)",
    reference: "motion: `gauss` on the same mesh, with its series of halved steps (beyond a ratio of 1e4, its limit as 1/ratio); rigid limit: a stiff \
                rod is straight and keeps its length; balance: the initial energy",
    right: "motion: error of both rods' ends at most the series of three runs with halved steps, that of the reference, and the rounding EA ε_mach \
            |u|/l, like a load. Rigid limit: the stiff rod's middle from its chord at most twice (sudden) 5L⁴/(384 EI) ρA(g + ½a) with the \
            components across the rod, × (1 + 1.6 (h/L)²)/(1 − N/N_cr); its length changes by at most twice (P + R)L/EA. At ratios below 100 N is \
            above the Euler load N_cr of the stiff rod, and there is no such limit. Balance, energy–momentum only: 2n (ε_mach + 8 N ε_mach L/T), and \
            1e-14 N in each unknown over the way.",
    trials,
};

const RATIOS: [f64; 8] = [1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14];

/// Modulus of the soft rod, Pa.
const SOFT: f64 = 2e8;
/// Elements of each rod.
const ELEMENTS: usize = 4;
/// The largest ratio at which collocation converges with a step of 1e-3 s.
const COLLOCATED: f64 = 1e4;

fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for (method, constraints, element) in [
        (Method::EnergyMomentum, Constraints::Condensed, Element::Ancf),
        (Method::EnergyMomentum, Constraints::Condensed, Element::EulerBernoulli),
        (Method::GeneralizedAlpha, Constraints::Condensed, Element::Ancf),
        (Method::GeneralizedAlpha, Constraints::Multipliers, Element::Ancf),
    ] {
        for ratio in RATIOS {
            let fast = method == Method::EnergyMomentum && element == Element::Ancf && (ratio == 1e4 || ratio == 1e8);
            let mut add = |what: &str, fast, measure: fn(Scene, Element, f64) -> Result<Finding>| {
                let name = format!("{method}, {constraints}, {element}, {what}");
                let run = move || measure(scene(method, constraints, element, ratio)?, element, ratio);
                trials.push(Trial::new(name, ratio, run).fast(fast).expect(Expected::result_if(ratio <= 1e8)));
            };
            add("motion", false, motion);
            if ratio > 1.0 {
                add("rigid limit", fast, rigid);
            }
            if method == Method::EnergyMomentum {
                add("balance", fast, balance);
            }
        }
    }
    trials
}

fn scene(method: Method, constraints: Constraints, element: Element, ratio: f64) -> Result<Scene> {
    let mut scene = pendulum(element, ELEMENTS)?.solved(method, 1e-3, 1.0).newton(1e-12);
    scene.points.insert("b".into(), [2.0, 0.0]);
    let mut soft = scene.rods[0].clone();
    (soft.name, soft.from, soft.to) = ("soft".into(), "a".into(), "b".into());
    let mut stiff = scene.material.clone();
    stiff.youngs_modulus = SOFT * ratio;
    scene.rods[0].material = Some(stiff);
    scene.rods.push(soft);
    (scene.constraints, scene.output.interval) = (constraints, None);
    let (rod, of) = (Some("rod".to_string()), vec![Quantity::Reaction]);
    let deflection = vec![Quantity::Deflection];
    scene.probes = vec![
        point_probe("a", &[Quantity::Position, Quantity::Acceleration]),
        point_probe("b", &[Quantity::Position]),
        point_probe("o", &[Quantity::Reaction]),
        Probe { name: "pin".into(), rod: rod.clone(), of, ..point_probe("a", &[]) },
        Probe { name: "middle".into(), point: None, rod, at: Some(0.5), of: deflection, mean: None },
    ];
    Ok(scene)
}

/// Positions of the pin and of the free end, one after the other.
fn ends(run: &Run) -> Path {
    [positions(run, "a"), positions(run, "b")].concat()
}

fn motion(scene: Scene, element: Element, ratio: f64) -> Result<Finding> {
    let scene = scene.newton(1e-10);
    let (own, step) = richardson::in_steps(&scene, ends)?;
    let collocated = |ratio: f64| {
        let scene = self::scene(Method::Gauss, Constraints::Condensed, element, ratio)?.newton(1e-10);
        richardson::in_steps(&scene, ends)
    };
    let (reference, its) = collocated(ratio.min(COLLOCATED))?;
    let limit = if ratio > COLLOCATED {
        let (coarser, coarse) = (ends(&collocated(1e-2 * COLLOCATED)?.0), ends(&collocated(0.1 * COLLOCATED)?.0));
        let changes = (largest_distance(&coarser, &coarse), largest_distance(&coarse, &ends(&reference)));
        Series::with(changes.0, changes.1, 0.1).rest()
    } else {
        0.0
    };
    // Newton may leave a part of the largest force, like a load, in both runs: 2 · ½ 1e-10 F/m t², F/m ≤ 3g.
    let newton = scene.time.newton_tolerance * 3.0 * 9.8 * scene.time.end.powi(2);
    let rounding = rounding_as_load(&scene, SOFT * ratio);
    let error = largest_distance(&ends(&own), &ends(&reference));
    let bound = step.bound() + its.bound() + limit + newton + rounding;
    let why = format!("step {step}, the reference's {its}, its limit {limit:.1e}, rounding {rounding:.1e}");
    Ok(Finding { error, bound, why, rounding, ..Finding::of(own) })
}

/// Sum of the largest forces at the two ends of the stiff rod, N.
fn at_ends(run: &Run) -> f64 {
    let longest = |probe| columns(run, probe, ["rx", "ry"]).into_iter().map(|[x, y]| x.hypot(y)).fold(0.0, f64::max);
    longest("pin") + longest("o")
}

fn rigid(scene: Scene, _: Element, ratio: f64) -> Result<Finding> {
    let own = run(&scene)?;
    let (h, rho) = (scene.section.height, scene.material.rho);
    let (area, modulus) = (h * h, SOFT * ratio);
    let bending = modulus * h.powi(4) / 12.0;
    let chord = positions(&own, "a");
    // Largest component of vectors across the chord.
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
    // The output rounds positions to ε_mach.
    let rounding = 4.0 * f64::EPSILON;
    let error = largest(&own, "middle.w").max(length);
    // Above the Euler load there is no limit.
    let bound = if ends < euler { bent.max(stretched) + rounding } else { f64::INFINITY };
    let why = format!("bent {bent:.1e}, stretched {stretched:.1e}: {load:.0} N/m across, {ends:.0} N at the ends");
    Ok(Finding { error, bound, why, rounding, ..Finding::of(own) })
}

fn balance(scene: Scene, _: Element, _: f64) -> Result<Finding> {
    let scene = scene.newton(1e-14);
    let own = run(&scene)?;
    let (steps, kinetic, force) = (own.counts.steps as f64, largest(&own, "energy.kinetic"), at_ends(&own));
    let rounding = 2.0 * steps * f64::EPSILON * (1.0 + 2.0 * ELEMENTS as f64 * force / kinetic);
    let unknowns = Structure::planned(&scene, &Plan::of(&scene))?.size() as f64;
    let way: f64 = positions(&own, "b").windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    let newton = unknowns * scene.time.newton_tolerance * force * way / kinetic;
    let error = largest(&own, "energy.balance") / kinetic;
    let why = format!("rounding {rounding:.1e}, Newton {newton:.1e}: {force:.0} N, {way:.1} m");
    Ok(Finding { error, bound: rounding + newton, why, rounding: rounding + newton, ..Finding::of(own) })
}
