//! Mistakes made on purpose: what each is called, what to look at, and how it moves.

mod assembly;
pub mod families;
mod heat;
mod law;
mod loads;
mod mesh;
pub mod methods;
mod outputs;
mod supports;

use ancf::model::Scene;

use super::mistake::{Made, Mistake};
use super::setup::Setup;

/// Mistakes without a number that is fitted. `step` is the program's, where it is known.
pub fn mistakes(scene: &Scene, step: Option<f64>) -> Vec<Mistake> {
    let right = Setup::of(scene.clone());
    let mut all = Vec::new();
    let mut add = |what: &str, look_at: &'static str, change: &dyn Fn(&mut Setup)| {
        let mut setup = right.clone();
        change(&mut setup);
        all.push(Mistake { what: what.into(), look_at, made: Made::Setup(Box::new(setup)) });
    };
    loads::loads(scene, &mut add);
    heat::heat(scene, &mut add);
    supports::supports(scene, &mut add);
    supports::joints(scene, &mut add);
    assembly::assembly(scene, &mut add);
    law::law(scene, &mut add);
    mesh::mesh(scene, &mut add);
    all.extend(outputs::outputs(scene));
    all.extend(step.into_iter().flat_map(|step| methods::methods(&right, step)));
    all
}
