//! "The proposed beam element is free of locking" (Section 3 and conclusion 2), measured on cantilevers.

use serde::Serialize;

use crate::error::Result;
use crate::fixture::Certified;
use crate::path::{distance, last_tip};
use crate::scene::{Change, builtin, light_cantilever};
use ancf::model::{Element, Poisson};
use ancf::run::run;

const SLENDERNESSES: [f64; 4] = [2.0, 10.0, 100.0, 1000.0];
const ELEMENTS: [usize; 4] = [4, 8, 16, 32];

/// Largest relative difference of one element from Timoshenko's beam that is called free of locking.
const UNLOCKED: f64 = 1e-3;

/// Largest distance of eight elements from the elastica, over the length, that is called free of locking.
const CONVERGED: f64 = 1e-3;

/// One element under a small load: its tip over that of Timoshenko's beam in plane strain, by slenderness.
#[derive(Serialize)]
pub struct SmallLoad {
    pub nu: f64,
    pub poisson: Poisson,
    /// (L/h, tip over theory).
    pub ratios: Vec<(f64, f64)>,
}

/// The statement and its measured values.
#[derive(Serialize)]
pub struct Locking {
    pub statement: &'static str,
    pub small_load: Vec<SmallLoad>,
    /// PL²/EI = 10, h/L = 10⁻³: (elements, distance of the tip from the elastica's over L).
    pub large_bending: Vec<(usize, f64)>,
    pub verdict: String,
}

/// Measures the statement.
pub fn measure() -> Result<Locking> {
    let mut small_load = Vec::new();
    for (nu, poisson) in [(0.0, Poisson::Full), (0.3, Poisson::Full), (0.3, Poisson::Axis)] {
        let ratios = SLENDERNESSES.iter().map(|&slenderness| Ok((slenderness, tip_ratio(nu, poisson, slenderness)?)));
        small_load.push(SmallLoad { nu, poisson, ratios: ratios.collect::<Result<_>>()? });
    }
    let large_bending = ELEMENTS.iter().map(|&elements| Ok((elements, distance_from_elastica(elements)?)));
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

fn tip_ratio(nu: f64, poisson: Poisson, slenderness: f64) -> Result<f64> {
    // Relative to the length, which is 1 m.
    const TIP: f64 = 1e-8;
    let mut scene = light_cantilever(Element::Ancf, 1, slenderness, nu, TIP)?;
    scene.rods[0].poisson = poisson;
    Ok(-last_tip(&run(&scene)?)[1] / TIP)
}

fn distance_from_elastica(elements: usize) -> Result<f64> {
    let own = run(builtin("cantilever")?.meshed(Element::Ancf, elements))?;
    Ok(distance(last_tip(&own), Certified::load("elastica-10")?.tip()?))
}
