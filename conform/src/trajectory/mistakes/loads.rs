//! Mistakes in weight and forces.

use ancf::model::Scene;

use crate::trajectory::mistake::{Add, INPUT, LOADS, has_gravity};
use crate::trajectory::setup::Weight;

/// Weight lost, turned, doubled or lumped; each force lost, turned, doubled, elsewhere, without its history.
pub fn loads(scene: &Scene, add: &mut Add) {
    if has_gravity(scene) {
        add("the weight is lost", LOADS, &|setup| setup.scene.gravity = [0.0; 2]);
        add("the weight acts upwards", LOADS, &|setup| setup.scene.gravity = setup.scene.gravity.map(|g| -g));
        add("the weight acts along x", LOADS, &|setup| setup.scene.gravity.swap(0, 1));
        add("g is 9.81 m/s²", INPUT, &|setup| {
            setup.scene.gravity = setup.scene.gravity.map(|g| g.signum() * 9.81 * f64::from(g != 0.0))
        });
        add("the weight is twice as large", LOADS, &|setup| setup.scene.gravity = setup.scene.gravity.map(|g| 2.0 * g));
        add("half of the weight is lost", LOADS, &|setup| setup.scene.gravity = setup.scene.gravity.map(|g| 0.5 * g));
        add("half of each element's weight on each of its ends", LOADS, &|setup| setup.weight = Weight::HalfOnEnds);
        add("all of a rod's weight at its last point", LOADS, &|setup| setup.weight = Weight::AtTheEnd);
    }
    for n in 0..scene.forces.len() {
        let name = &scene.forces[n].point;
        add(&format!("the force at {name} is lost"), LOADS, &|setup| _ = setup.scene.forces.remove(n));
        add(&format!("the force at {name} has the wrong sign"), LOADS, &|setup| {
            setup.scene.forces[n].force = setup.scene.forces[n].force.map(|f| -f);
        });
        add(&format!("the force at {name} is twice as large"), LOADS, &|setup| {
            setup.scene.forces[n].force = setup.scene.forces[n].force.map(|f| 2.0 * f);
        });
        add(&format!("half of the force at {name}"), LOADS, &|setup| {
            setup.scene.forces[n].force = setup.scene.forces[n].force.map(|f| 0.5 * f);
        });
        add(&format!("x and y of the force at {name} exchanged"), LOADS, &|setup| {
            setup.scene.forces[n].force.swap(0, 1)
        });
        add(&format!("the force at {name} does not follow its history"), LOADS, &|setup| {
            setup.scene.forces[n].history = None
        });
        for point in scene.points.keys().filter(|point| *point != name) {
            let what = format!("the force of {name} acts at {point}");
            add(&what, LOADS, &|setup| setup.scene.forces[n].point.clone_from(point));
        }
    }
}
