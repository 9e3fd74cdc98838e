//! Two rods hinged in the middle between two fixed points: heat pushes the hinge up. Statics, in load steps.
//!
//! `cargo run --release --example two_heated_rods`

use ancf::model::{Material, Method, Rod, Scene, Section, Support, Temperature, ThermalModel};
use ancf::run::Simulation;

fn main() -> ancf::error::Result<()> {
    let height = 0.05;
    let mut scene = Scene::new(Material::new(7e10, 0.0, 2750.0).alpha(2.3e-5), Section::new(0.02, 0.02))
        .point("left", [-1.0, 0.0])
        .point("hinge", [0.0, height])
        .point("right", [1.0, 0.0])
        .rod(Rod::new("left rod", "left", "hinge"))
        .rod(Rod::new("right rod", "hinge", "right"))
        .support(Support::pinned("left"))
        .support(Support::pinned("right"))
        .temperature(Temperature::new(ThermalModel::OneD, vec![[0.0, 150.0]]));
    scene.time.method = Method::Static;
    let mut rods = Simulation::new(scene)?;
    while rods.step()? {
        let ([_, y], [thrust, _]) = (rods.position("hinge")?, rods.reaction("left")?);
        println!("{:3.0} % of the heat: hinge at {y:.6} m, thrust {thrust:9.2e} N", 100.0 * rods.time());
    }

    // The rods may stretch freely: the hinge is where their length is √(1 + 2αΔT) times the cold one, without stress.
    let stretched = (1.0 + height * height) * (1.0 + 2.0 * 2.3e-5 * 150.0);
    println!("in closed form: hinge at {:.6} m, no thrust", (stretched - 1.0_f64).sqrt());
    Ok(())
}
