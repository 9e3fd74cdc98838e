//! Meshes from one element to thousands in one rod: convergence, down to the rounding floor that conditioning predicts.

use super::prelude::*;
use super::slender::{TIP, after_two_iterations, stiffened};
use crate::fixture::Certified;

pub const SMALL: Case = Case {
    name: "fine-mesh-small-load",
    parameter: "elements",
    unit: "relative",
    reference: "Timoshenko's cantilever (Euler's), which every mesh meets exactly",
    right: "error of the tip at most ρ² + (1.5n + 16) ε_mach, and the second order as in slenderness. ρ is the loss of one solution of the linear \
            equations, (50 + 4n²) ε_mach (L/h)², Euler–Bernoulli (50 + 4n²(1 + (h/l)²)): each element's force carries ε_mach EA u/l, n times that \
            of one element, and elimination adds up n of them with one sign, relative to P = 3EI u/L³. (An element shorter than high has a larger \
            stiffness across, 12 EI/l², than EA.) Newton's second iteration loses ρ of what the first has left; the rest is the floor of the \
            residual, (1.5n + 16) ε_mach, which errors reach to a tenth where ρ² is less.",
    trials: small,
};

pub const LARGE: Case = Case {
    name: "fine-mesh-large-bending",
    parameter: "elements",
    unit: "of L",
    reference: "fixtures/references.json, the limit of the element's own strains under a load that bends it far, agreed by two methods to 16 \
                digits (L/h = 20: l/h is 1/n of it, down to 0.007)",
    right: "order 4: at most a sixteenth of the error with half the elements, times 1 + |e(n/4)/(16 e(n/2)) − 1|, as the next halving is no farther \
            from its order than the last; plus the floor of the small load. One and two elements, 0.13 and 0.02 L off, have no two coarser meshes \
            to be judged by, and are no rows.",
    trials: large,
};

/// ρ² and the floor of the residual, relative to the tip; never more than ρ.
fn floor(element: Element, elements: usize, slenderness: f64) -> f64 {
    let n = elements as f64;
    // Elements shorter than high: 12 EI/l² is more than EA.
    let short = if element == Element::EulerBernoulli { (n / slenderness).powi(2) } else { 0.0 };
    after_two_iterations((50.0 + 4.0 * n * n * (1.0 + short)) * f64::EPSILON * slenderness.powi(2), elements)
}

fn trial(name: String, elements: usize, run: impl Fn() -> Result<Finding> + Send + Sync + 'static) -> Trial {
    Trial::new(name, elements as f64, run).expect(Expected::result_if(elements <= 3000))
}

fn small() -> Vec<Trial> {
    let meshes = [1, 2, 3, 10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000];
    let trial = |(element, slenderness, elements)| {
        let run = move || light(element, slenderness, elements);
        trial(format!("{element}, L/h = {slenderness}"), elements, run).fast(elements <= 1000)
    };
    iproduct!(ELEMENTS, [20.0, 1000.0], meshes).map(trial).collect()
}

fn light(element: Element, slenderness: f64, elements: usize) -> Result<Finding> {
    let own = run(light_cantilever(element, elements, slenderness, 0.0, TIP)?.newton(1e-15))?;
    let floor = floor(element, elements, slenderness);
    let second = stiffened(element, elements) * (TIP * slenderness).powi(2);
    let error = (-last_tip(&own)[1] / TIP - 1.0).abs();
    let why = format!("floor {floor:.1e}, second order {second:.1e}, l/h = {:.1e}", slenderness / elements as f64);
    Ok(Finding { error, bound: floor + second, why, rounding: floor, ..Finding::of(own) })
}

fn large() -> Vec<Trial> {
    let limits = [(Element::Ancf, "director-slender"), (Element::EulerBernoulli, "reissner-slender-shear-rigid")];
    let meshes = [4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 3000, 8192];
    let trial = |((element, id), elements)| {
        trial(format!("{element}, {id}"), elements, move || bent(element, id, elements)).fast(elements <= 256)
    };
    iproduct!(limits, meshes).map(trial).collect()
}

fn bent(element: Element, id: &'static str, elements: usize) -> Result<Finding> {
    let reference = Certified::load(id)?;
    let (error, own) = off(&reference, element, elements)?;
    let [half, quarter] = [off(&reference, element, elements / 2)?.0, off(&reference, element, elements / 4)?.0];
    let astray = (quarter / (16.0 * half) - 1.0).abs();
    let floor = floor(element, elements, reference.parameter("L")? / reference.parameter("h")?);
    let why = format!("half the elements {half:.1e}, a quarter {quarter:.1e}, floor {floor:.1e}");
    Ok(Finding { error, bound: half / 16.0 * (1.0 + astray) + floor, why, rounding: floor, ..Finding::of(own) })
}

/// Distance of the tip from the limit, relative to the length, and the run.
fn off(reference: &Certified, element: Element, elements: usize) -> Result<(f64, Run)> {
    let (length, tip) = (reference.parameter("L")?, reference.tip()?);
    let mut scene = cantilever(element, elements, reference.parameter("h")?)?.newton(1e-15);
    scene.points.insert("a".into(), [length, 0.0]);
    scene.section.width = reference.parameter("w")?;
    (scene.material.youngs_modulus, scene.material.nu) = (reference.parameter("E")?, 0.0);
    scene.time.load_steps = 4;
    scene.forces[0].force = [0.0, -reference.parameter("F")?];
    let own = run(&scene)?;
    Ok((distance(last_tip(&own), tip) / length, own))
}
