//! What moves a structure: the loads beside which rounding of the elastic forces has to be small.
//!
//! A load that moves nothing says nothing of the motion and does not count: a force where and along what a support holds its point,
//! the constant heat of a relaxed start, what a history has after the end, the velocity of a translation. Heat stretches a rod by no
//! more than its strain, whatever the rod weighs, so that it counts only where nothing else moves the structure.
//!
//! So does a rotation that goes on as it began, whose load is what bends the paths, m ω² L. However slow it is, so small are
//! the displacements that rounding is a part of, and it is not lost before rounding has moved it away: a force F moves a rod by F t²/(2m)
//! beside the path of ω t L, which is ωt/2 of its share F/(m ω² L) of the load. The less of the two counts.

use std::collections::BTreeMap;

use crate::model::{Force, Rod, Scene, Start, times_of};

/// Sizes of what moves a structure, N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadScale {
    /// All of it together; 0 where nothing does.
    pub all: f64,
    /// The least of its parts: a rod's weight, the force at a point; where there is nothing else, what bends a rod's path as it turns.
    pub least: f64,
    /// Angular velocity of a structure that only goes on turning, rad/s.
    free_rotation: Option<f64>,
}

impl LoadScale {
    /// Those of a scene that moves in time.
    pub fn of(scene: &Scene) -> LoadScale {
        let acting = LoadScale::sum(of_weight(scene).chain(of_points(scene)));
        if acting.all > 0.0 {
            return LoadScale { all: acting.all + of_rotation(scene).sum::<f64>(), ..acting };
        }
        let turning = LoadScale::sum(of_rotation(scene));
        if turning.all > 0.0 {
            let heated = LoadScale::sum(of_heat(scene)).all > 0.0;
            return LoadScale { free_rotation: (!heated).then(|| omega(scene).abs()), ..turning };
        }
        LoadScale::sum(of_heat(scene))
    }

    /// What a force is of all loads, and of the least of them, at time `t`.
    pub fn shares(&self, force: f64, t: f64) -> [f64; 2] {
        let grown = self.free_rotation.map_or(1.0, |omega| (0.5 * omega * t).min(1.0));
        [self.all, self.least].map(|load| grown * force / load)
    }

    fn sum(parts: impl Iterator<Item = f64>) -> LoadScale {
        let parts: Vec<f64> = parts.filter(|part| *part > 0.0).collect();
        if parts.is_empty() {
            return LoadScale::default();
        }
        let least = parts.iter().copied().fold(f64::INFINITY, f64::min);
        LoadScale { all: parts.iter().sum(), least, free_rotation: None }
    }
}

/// Whether anything moves the structure of a scene from its start, or bends the path of its initial motion.
pub fn moves(scene: &Scene) -> bool {
    LoadScale::of(scene).all > 0.0
}

/// Weight of each rod.
fn of_weight(scene: &Scene) -> impl Iterator<Item = f64> {
    let weight = scene.gravity[0].hypot(scene.gravity[1]);
    scene.rods.iter().map(move |rod| mass(scene, rod) * weight)
}

/// m ω² L of each rod, where the structure turns at first.
fn of_rotation(scene: &Scene) -> impl Iterator<Item = f64> {
    let omega = omega(scene);
    scene.rods.iter().map(move |rod| mass(scene, rod) * omega * omega * scene.length(rod))
}

fn omega(scene: &Scene) -> f64 {
    scene.motion.as_ref().map_or(0.0, |motion| motion.omega)
}

/// A rod's mass, kg.
pub fn mass(scene: &Scene, rod: &Rod) -> f64 {
    let section = scene.section(rod);
    scene.material(rod).rho * section.height * section.width * scene.length(rod)
}

/// The largest force at each point from the start to the end, less what a support takes.
fn of_points(scene: &Scene) -> impl Iterator<Item = f64> {
    let mut points: BTreeMap<&str, Vec<&Force>> = BTreeMap::new();
    for force in &scene.forces {
        points.entry(&force.point).or_default().push(force);
    }
    points.into_iter().map(|(point, forces)| {
        let supports = scene.supports.iter().filter(|support| support.point == point);
        let held: Vec<[f64; 2]> = supports.flat_map(|support| support.held()).collect();
        let moving = |t: f64| {
            let [x, y] = forces.iter().map(|force| force.at(t)).fold([0.0; 2], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
            match *held {
                [] => x.hypot(y),
                [[along_x, along_y]] => (along_x * y - along_y * x).abs(),
                _ => 0.0,
            }
        };
        let histories = forces.iter().filter_map(|force| force.history.as_deref());
        times_of(histories, scene.time.end).into_iter().map(moving).fold(0.0, f64::max)
    })
}

/// EA α ΔT of each rod, ΔT the largest change from the heat of its start.
fn of_heat(scene: &Scene) -> impl Iterator<Item = f64> {
    scene.rods.iter().filter_map(|rod| {
        let (heat, material, section) = (scene.heat(rod)?, scene.material(rod), scene.section(rod));
        let before = if heat.start == Start::Relaxed { heat.at(0.0) } else { 0.0 };
        let times = times_of([heat.history.as_slice()], scene.time.end);
        let change = times.into_iter().map(|t| (heat.at(t) - before).abs()).fold(0.0, f64::max);
        Some(material.youngs_modulus * section.height * section.width * material.alpha.abs() * change)
    })
}
