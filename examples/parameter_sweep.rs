//! A parameter sweep on all cores: how far the hinge of a heated triangle of two rods rises over its height and temperature.
//!
//! `cargo run --release --example parameter_sweep`

use ancf::error::Result;
use ancf::model::{Material, Method, Rod, Scene, Section, Support, Temperature, ThermalModel};
use ancf::run::Simulation;
use rayon::prelude::*;

/// Rise of the hinge, m.
fn rise(height: f64, kelvin: f64) -> Result<f64> {
    let mut scene = Scene::new(Material::new(7e10, 0.0, 2750.0).alpha(2.3e-5), Section::new(0.02, 0.02))
        .point("left", [-1.0, 0.0])
        .point("hinge", [0.0, height])
        .point("right", [1.0, 0.0])
        .rod(Rod::new("left rod", "left", "hinge"))
        .rod(Rod::new("right rod", "hinge", "right"))
        .support(Support::pinned("left"))
        .support(Support::pinned("right"))
        .temperature(Temperature::new(ThermalModel::TwoD, vec![[0.0, kelvin]]));
    scene.time.method = Method::Static;
    let mut rods = Simulation::new(scene)?;
    rods.run_until(1.0)?;
    Ok(rods.position("hinge")?[1] - height)
}

fn main() {
    let heights = [0.02, 0.05, 0.1, 0.2];
    let temperatures: Vec<f64> = (1..=10).map(|n| 20.0 * f64::from(n)).collect();
    println!("ΔT, K {}", heights.map(|height| format!("{height:>10} m")).concat());
    // Each model is a value of its own: cores share nothing. A run that fails is a cell of the table, not the end of it.
    let rows: Vec<String> = temperatures
        .par_iter()
        .map(|&kelvin| {
            let cell = |height| match rise(height, kelvin) {
                Ok(rise) => format!("{rise:>12.6}"),
                Err(error) => {
                    eprintln!("height {height} m, {kelvin} K: {error}");
                    format!("{:>12}", "failed")
                }
            };
            format!("{kelvin:>5} {}", heights.map(cell).concat())
        })
        .collect();
    println!("{}", rows.join("\n"));
}
