//! The heated pendulum of Table 1 of Peng et al. (2018), made in code, moved step by step and read.
//!
//! `cargo run --release --example pendulum`

use ancf::model::{Material, Method, Rod, Scene, Section, Support, Temperature, ThermalModel};
use ancf::run::Simulation;

fn main() -> ancf::error::Result<()> {
    let scene = Scene::new(Material::new(2e8, 0.0, 7750.0).alpha(2.85e-5), Section::new(0.02, 0.02))
        .point("pivot", [0.0, 0.0])
        .point("tip", [1.0, 0.0])
        .rod(Rod::new("rod", "pivot", "tip"))
        .support(Support::pinned("pivot"))
        .gravity([0.0, -9.8])
        .temperature(Temperature::new(ThermalModel::TwoD, vec![[0.0, 200.0]]).relaxed())
        .method(Method::EnergyMomentum, 1e-3)
        .until(1.0);
    let mut pendulum = Simulation::new(scene)?;
    for tenth in 1..=10 {
        pendulum.run_until(0.1 * f64::from(tenth))?;
        let [x, y] = pendulum.position("tip")?;
        let energy = pendulum.energy();
        println!("t = {:.1} s: tip at ({x:+.4}, {y:+.4}) m, kinetic energy {:.3} J", pendulum.time(), energy.kinetic);
    }
    Ok(())
}
