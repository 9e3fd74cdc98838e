//! "The proposed beam element is free of locking" (Section 3 and conclusion 2), measured on cantilevers.

use serde::Serialize;
use serde_json::Value;

use crate::error::{Error, Result};
use ancf::model::{Poisson, Scene};
use ancf::run::run;

/// Certified solutions; what is used of them is the elastica.
const REFERENCES: &str = ancf_fixtures::REFERENCES;
const ELASTICA: &str = "elastica-10";

const SLENDERNESSES: [f64; 4] = [2.0, 10.0, 100.0, 1000.0];
const ELEMENTS: [usize; 4] = [4, 8, 16, 32];

/// What one element may differ by from Timoshenko's beam and still be called free of locking.
const UNLOCKED: f64 = 1e-3;

/// What eight elements may differ by from the elastica, over the length, and still be called so.
const CONVERGED: f64 = 1e-3;

/// One element under a small load: its tip over that of Timoshenko's beam in plane strain, by slenderness.
#[derive(Serialize)]
pub struct SmallLoad {
    pub nu: f64,
    pub poisson: Poisson,
    /// (L/h, tip over theory).
    pub ratios: Vec<(f64, f64)>,
}

/// The statement with what was found.
#[derive(Serialize)]
pub struct Locking {
    pub statement: &'static str,
    pub small_load: Vec<SmallLoad>,
    /// PL²/EI = 10, h/L = 10⁻³: (elements, distance of the tip from the elastica's over L).
    pub large_bending: Vec<(usize, f64)>,
    pub verdict: String,
}

/// Measures it.
pub fn measure() -> Result<Locking> {
    let mut small_load = Vec::new();
    for (nu, poisson) in [(0.0, Poisson::Full), (0.3, Poisson::Full), (0.3, Poisson::Axis)] {
        let ratios = SLENDERNESSES.iter().map(|&slenderness| Ok((slenderness, tip_ratio(nu, poisson, slenderness)?)));
        small_load.push(SmallLoad { nu, poisson, ratios: ratios.collect::<Result<_>>()? });
    }
    let large_bending = ELEMENTS.iter().map(|&elements| Ok((elements, off_the_elastica(elements)?)));
    let large_bending: Vec<(usize, f64)> = large_bending.collect::<Result<_>>()?;

    let free = |nu: f64| {
        let mut of_the_paper = small_load.iter().filter(|case| case.nu == nu && case.poisson == Poisson::Full);
        of_the_paper.all(|case| case.ratios.iter().all(|(_, ratio)| (ratio - 1.0).abs() <= UNLOCKED))
    };
    let quick = large_bending.iter().any(|&(elements, error)| elements <= 8 && error <= CONVERGED);
    let small = match (free(0.0), free(0.3)) {
        (true, true) => "holds under small loads",
        (true, false) => "holds under small loads only where ν = 0",
        _ => "does not hold",
    };
    let large = if quick { "" } else { "; slender rods in large bending converge slowly" };
    let statement = "The proposed element is free of locking.";
    Ok(Locking { statement, small_load, large_bending, verdict: format!("{small}{large}") })
}

/// The built-in cantilever's tip at the full load.
fn tip(change: impl FnOnce(&mut Scene)) -> Result<[f64; 2]> {
    let missing = || Error::Fixture { name: "cantilever", reason: "there is no such scene".into() };
    let mut scene = Scene::builtin("cantilever").ok_or_else(missing)?;
    change(&mut scene);
    let trajectory = run(&scene)?.trajectory;
    Ok(["tip.x", "tip.y"].map(|name| trajectory.column(name).and_then(|x| x.last().copied()).unwrap_or(f64::NAN)))
}

fn tip_ratio(nu: f64, poisson: Poisson, slenderness: f64) -> Result<f64> {
    // Of the length, which is 1 m.
    const TIP: f64 = 1e-8;
    let [_, y] = tip(|scene| {
        let height = 1.0 / slenderness;
        scene.material.nu = nu;
        (scene.section.height, scene.section.width) = (height, height);
        (scene.rods[0].elements, scene.rods[0].poisson) = (1, poisson);
        let modulus = scene.material.youngs_modulus;
        let bending = modulus / (1.0 - nu * nu) * height.powi(4) / 12.0;
        let shear = modulus / (2.0 * (1.0 + nu)) * height.powi(2);
        scene.forces[0].force = [0.0, -TIP / (1.0 / (3.0 * bending) + 1.0 / shear)];
    })?;
    Ok(-y / TIP)
}

fn off_the_elastica(elements: usize) -> Result<f64> {
    let invalid = |reason: String| Error::Fixture { name: "references.json", reason };
    let references: Value = serde_json::from_str(REFERENCES).map_err(|reason| invalid(reason.to_string()))?;
    let mut entries = references["entries"].as_array().into_iter().flatten();
    let values = entries.find(|entry| entry["id"] == ELASTICA).map(|entry| &entry["values"]);
    let value = |name: &str| values.and_then(|values| values[name]["f64"].as_f64());
    let (Some(x), Some(y)) = (value("tip.x"), value("tip.y")) else {
        return Err(invalid(format!("there is no {ELASTICA}")));
    };
    let [own_x, own_y] = tip(|scene| scene.rods[0].elements = elements)?;
    Ok((own_x - x).hypot(own_y - y))
}
