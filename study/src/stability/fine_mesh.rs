//! Meshes, from one element to thousands in one rod: convergence, and then the floor that conditioning predicts.

use serde_json::Value;

use super::case::{Case, Expected, Finding, Trial};
use super::helpers::{EPS, builtin, positions};
use super::slender::{residual, stiffened};
use crate::error::{Error, Result};
use ancf::model::{Element, Scene};
use ancf::run::run;

pub const SMALL: Case = Case {
    name: "fine-mesh-small-load",
    parameter: "elements",
    unit: "relative",
    reference: "Timoshenko's cantilever (Euler's), which every mesh meets exactly",
    right: "tip off by at most ρ² + (1.5n + 16) ε_mach, and by the second order as in the case of slenderness. ρ is what one solution of the \
            linear equations loses, (50 + 4n²) ε_mach (L/h)², Euler–Bernoulli (50 + 4n²(1 + (h/l)²)): each element's force carries ε_mach \
            EA u/l, n times that of one element, and elimination adds up n of them with one sign, beside P = 3EI u/L³. (An end of an \
            element that is higher than long takes 12 EI/l² to move across, more than EA.) Newton's second iteration loses ρ of what the \
            first has left; the rest is the floor of the residual, (1.5n + 16) ε_mach, which errors reach to a tenth where ρ² is less.",
    trials: small,
};

pub const LARGE: Case = Case {
    name: "fine-mesh-large-bending",
    parameter: "elements",
    unit: "of L",
    reference: "fixtures/references.json, the limit of the element's own strains under a load that bends it far, agreed by two methods to 16 \
                digits (L/h = 20: l/h is 1/n of it, down to 0.007)",
    right: "order 4: at most a sixteenth of the error with half the elements, times 1 + |e(n/4)/(16 e(n/2)) − 1|, as the next halving is not \
            further from its order than the last; beside the floor of the small load. One and two elements, 0.13 and 0.02 L off, have no \
            two coarser meshes to be judged by, and are no rows.",
    trials: large,
};

/// ρ² and the floor of the residual, of the tip; never more than ρ.
fn floor(element: Element, elements: usize, slenderness: f64) -> f64 {
    let n = elements as f64;
    // Elements shorter than high: the bending stiffness of an end moved across, 12 EI/l², is more than EA.
    let short = if element == Element::EulerBernoulli { (n / slenderness).powi(2) } else { 0.0 };
    let solution = (50.0 + 4.0 * n * n * (1.0 + short)) * EPS * slenderness.powi(2);
    solution.min(solution.powi(2) + residual(elements))
}

fn small() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for (element, slenderness) in [
        (Element::Ancf, 20.0),
        (Element::Ancf, 1000.0),
        (Element::EulerBernoulli, 20.0),
        (Element::EulerBernoulli, 1000.0),
    ] {
        for elements in [1, 2, 3, 10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000] {
            let expected = if elements <= 3000 { Expected::Result } else { Expected::ResultOrRefusal };
            let trial = Trial::new(format!("{element}, L/h = {slenderness}"), elements as f64, move || {
                light(element, slenderness, elements)
            });
            trials.push(trial.fast(elements <= 1000).expect(expected));
        }
    }
    Ok(trials)
}

fn light(element: Element, slenderness: f64, elements: usize) -> Result<Finding> {
    const TIP: f64 = 1e-8;
    let mut scene = builtin("cantilever")?;
    let (h, modulus) = (1.0 / slenderness, scene.material.youngs_modulus);
    (scene.section.height, scene.section.width) = (h, h);
    (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
    scene.time.newton_tolerance = 1e-15;
    let shear = if element == Element::Ancf { 1.0 / (0.5 * modulus * h * h) } else { 0.0 };
    scene.forces[0].force = [0.0, -TIP / (1.0 / (3.0 * modulus * h.powi(4) / 12.0) + shear)];
    let run = run(&scene)?;
    let [_, y] = positions(&run, "tip").last().copied().unwrap_or([f64::NAN; 2]);
    let floor = floor(element, elements, slenderness);
    let second = stiffened(element, elements) * (TIP * slenderness).powi(2);
    Ok(Finding {
        error: (-y / TIP - 1.0).abs(),
        bound: floor + second,
        why: format!("floor {floor:.1e}, second order {second:.1e}, l/h = {:.1e}", slenderness / elements as f64),
        size: 1.0,
        rounding: floor,
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}

fn large() -> Result<Vec<Trial>> {
    let mut trials = Vec::new();
    for (element, id) in
        [(Element::Ancf, "director-slender"), (Element::EulerBernoulli, "reissner-slender-shear-rigid")]
    {
        for elements in [4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 3000, 8192] {
            let expected = if elements <= 3000 { Expected::Result } else { Expected::ResultOrRefusal };
            let trial = Trial::new(format!("{element}, {id}"), elements as f64, move || bent(element, id, elements));
            trials.push(trial.fast(elements <= 256).expect(expected));
        }
    }
    Ok(trials)
}

fn bent(element: Element, id: &'static str, elements: usize) -> Result<Finding> {
    let reference = Reference::load(id)?;
    let (own, run) = reference.off(element, elements)?;
    let [half, quarter] = [reference.off(element, elements / 2)?.0, reference.off(element, elements / 4)?.0];
    let astray = (quarter / (16.0 * half) - 1.0).abs();
    let floor = floor(element, elements, reference.length / reference.height);
    Ok(Finding {
        error: own,
        bound: half / 16.0 * (1.0 + astray) + floor,
        why: format!("half the elements {half:.1e}, a quarter {quarter:.1e}, floor {floor:.1e}"),
        size: 1.0,
        rounding: floor,
        counts: run.counts,
        warnings: run.warnings,
        beside: None,
    })
}

/// One entry of the fixture.
struct Reference {
    length: f64,
    height: f64,
    width: f64,
    modulus: f64,
    force: f64,
    tip: [f64; 2],
}

impl Reference {
    fn load(id: &str) -> Result<Reference> {
        let name = "references.json";
        let invalid = |reason: String| Error::Fixture { name, reason };
        let text = include_str!("../../../fixtures/references.json");
        let file: Value = serde_json::from_str(text).map_err(|reason| invalid(reason.to_string()))?;
        let mut entries = file["entries"].as_array().into_iter().flatten();
        let entry = entries.find(|entry| entry["id"] == id).ok_or_else(|| invalid(format!("there is no {id}")))?;
        let number = |value: &Value| value.as_f64().ok_or_else(|| invalid(format!("{id} lacks a number")));
        let parameter = |key: &str| number(&entry["parameters"][key]);
        let value = |key: &str| number(&entry["values"][key]["f64"]);
        Ok(Reference {
            length: parameter("L")?,
            height: parameter("h")?,
            width: parameter("w")?,
            modulus: parameter("E")?,
            force: parameter("F")?,
            tip: [value("tip.x")?, value("tip.y")?],
        })
    }

    /// Distance of the tip from the limit, of the length.
    fn off(&self, element: Element, elements: usize) -> Result<(f64, ancf::run::Run)> {
        let mut scene: Scene = builtin("cantilever")?;
        scene.points.insert("a".into(), [self.length, 0.0]);
        (scene.section.height, scene.section.width) = (self.height, self.width);
        (scene.rods[0].element, scene.rods[0].elements) = (element, elements);
        (scene.time.load_steps, scene.time.newton_tolerance) = (4, 1e-15);
        (scene.material.youngs_modulus, scene.material.nu) = (self.modulus, 0.0);
        scene.forces[0].force = [0.0, -self.force];
        let run = run(&scene)?;
        let [x, y] = positions(&run, "tip").last().copied().unwrap_or([f64::NAN; 2]);
        Ok(((x - self.tip[0]).hypot(y - self.tip[1]) / self.length, run))
    }
}
