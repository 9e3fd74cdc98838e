//! What moves a structure: the loads beside which rounding of the elastic forces has to be small.
//!
//! A load that moves nothing says nothing of the motion and does not count: a force where and along what a support holds its point,
//! the constant heat of a relaxed start, what a history has after the end, the velocity of a translation. Heat stretches a rod by no
//! more than its strain, whatever the rod weighs, so that it counts only where nothing else moves the structure.

use std::collections::BTreeMap;

use crate::scene::{Force, Scene, Start, times_of};

/// Sizes of what moves a structure, N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loads {
    /// All of it together; 0 where nothing does.
    pub all: f64,
    /// The least of its parts: a rod's weight, what bends its path as it turns, the force at a point.
    pub least: f64,
}

impl Loads {
    /// Those of a scene that moves in time.
    pub fn of(scene: &Scene) -> Loads {
        let parts = of_rods(scene).chain(of_points(scene));
        let loads = Loads::sum(parts);
        if loads.all > 0.0 { loads } else { Loads::sum(of_heat(scene)) }
    }

    fn sum(parts: impl Iterator<Item = f64>) -> Loads {
        let parts: Vec<f64> = parts.filter(|part| *part > 0.0).collect();
        if parts.is_empty() {
            return Loads::default();
        }
        Loads { all: parts.iter().sum(), least: parts.into_iter().fold(f64::INFINITY, f64::min) }
    }
}

/// Whether anything moves the structure of a scene from its start, or bends the path of its initial motion.
pub fn moves(scene: &Scene) -> bool {
    Loads::of(scene).all > 0.0
}

/// Weight of each rod, and m ω² L where the structure turns at first.
fn of_rods(scene: &Scene) -> impl Iterator<Item = f64> {
    let omega = scene.motion.as_ref().map_or(0.0, |motion| motion.omega);
    let weight = scene.gravity[0].hypot(scene.gravity[1]);
    scene.rods.iter().flat_map(move |rod| {
        let (material, section, length) = (scene.material(rod), scene.section(rod), scene.length(rod));
        let mass = material.rho * section.height * section.width * length;
        [mass * weight, mass * omega * omega * length]
    })
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
