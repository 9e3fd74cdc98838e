//! Magnitude of the loads that move a structure: rounding of the elastic forces must be small compared with it.
//!
//! A load that moves nothing does not count: a force in a held direction, the constant heat of a relaxed start, a
//! history after the end, the velocity of a translation. Heat stretches a rod by no more than its strain, whatever its
//! weight, so that it counts only if nothing else moves the structure.
//!
//! A rotation that merely continues also counts only if nothing else moves the structure; its load is the centripetal
//! force m ω² L. The slower it is, the smaller are the displacements that rounding is compared with, and the result is
//! not lost before rounding has moved it away. A force F moves a rod by F t²/(2m) off its path of ω t L, which is ωt/2
//! of its fraction F/(m ω² L) of the load. The smaller of the two counts.

use std::collections::BTreeMap;

use crate::model::{Force, Rod, Scene, Start, times_of};

/// Rest of forces that cancel each other, relative to the sum of their magnitudes.
const CANCELLED: f64 = 1e-14;

/// Magnitudes of the loads that move a structure, N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadScale {
    /// Sum of all loads; 0 where nothing moves the structure.
    pub total: f64,
    /// Smallest load: a rod's weight, the force at a point; without others, the centripetal force of a turning rod.
    pub least: f64,
    /// Angular velocity of a structure that merely continues to turn, rad/s.
    free_rotation: Option<f64>,
}

impl LoadScale {
    /// Loads of a scene that moves in time.
    pub fn of(scene: &Scene) -> LoadScale {
        let acting = LoadScale::sum(of_weight(scene).chain(of_points(scene)));
        if acting.total > 0.0 {
            return LoadScale { total: acting.total + of_rotation(scene).sum::<f64>(), ..acting };
        }
        let turning = LoadScale::sum(of_rotation(scene));
        if turning.total > 0.0 {
            let heated = LoadScale::sum(of_heat(scene)).total > 0.0;
            return LoadScale { free_rotation: (!heated).then(|| omega(scene).abs()), ..turning };
        }
        LoadScale::sum(of_heat(scene))
    }

    /// Fractions that a force is of all loads, and of the smallest, at time `t`.
    pub fn fractions(&self, force: f64, t: f64) -> [f64; 2] {
        let grown = self.free_rotation.map_or(1.0, |omega| (0.5 * omega * t).min(1.0));
        [self.total, self.least].map(|load| grown * force / load)
    }

    fn sum(parts: impl Iterator<Item = f64>) -> LoadScale {
        let parts: Vec<f64> = parts.filter(|part| *part > 0.0).collect();
        if parts.is_empty() {
            return LoadScale::default();
        }
        let least = parts.iter().copied().fold(f64::INFINITY, f64::min);
        LoadScale { total: parts.iter().sum(), least, free_rotation: None }
    }
}

/// Whether anything moves the structure of a scene from its start, or bends the path of its initial motion.
pub fn has_loads(scene: &Scene) -> bool {
    LoadScale::of(scene).total > 0.0
}

/// Weight of each rod.
fn of_weight(scene: &Scene) -> impl Iterator<Item = f64> {
    let weight = scene.gravity[0].hypot(scene.gravity[1]);
    scene.rods.iter().map(move |rod| mass(scene, rod) * weight)
}

/// Centripetal force m ω² L of each rod, for an initial rotation.
fn of_rotation(scene: &Scene) -> impl Iterator<Item = f64> {
    let omega = omega(scene);
    scene.rods.iter().map(move |rod| mass(scene, rod) * omega * omega * scene.length(rod))
}

fn omega(scene: &Scene) -> f64 {
    scene.motion.as_ref().map_or(0.0, |motion| motion.omega)
}

/// Mass of a rod, kg.
pub fn mass(scene: &Scene, rod: &Rod) -> f64 {
    let section = scene.section(rod);
    scene.material(rod).rho * section.height * section.width * scene.length(rod)
}

/// Largest force at each point between start and end, without the part that supports take.
fn of_points(scene: &Scene) -> impl Iterator<Item = f64> {
    let mut points: BTreeMap<&str, Vec<&Force>> = BTreeMap::new();
    for force in &scene.forces {
        points.entry(&force.point).or_default().push(force);
    }
    points.into_iter().map(|(point, forces)| {
        let supports = scene.supports.iter().filter(|support| support.point == point);
        let held: Vec<[f64; 2]> = supports.flat_map(|support| support.held()).collect();
        let moving = |t: f64| {
            let at_t = || forces.iter().map(|force| force.at(t));
            let [x, y] = at_t().fold([0.0; 2], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
            let moving = match *held {
                [] => x.hypot(y),
                [[along_x, along_y]] => (along_x * y - along_y * x).abs(),
                _ => 0.0,
            };
            // Forces that cancel each other, or that the support takes, leave what rounding makes of them.
            let all: f64 = at_t().map(|[x, y]| x.hypot(y)).sum();
            if moving > CANCELLED * all { moving } else { 0.0 }
        };
        let histories = forces.iter().filter_map(|force| force.history.as_deref());
        times_of(histories, scene.time.end).into_iter().map(moving).fold(0.0, f64::max)
    })
}

/// Thermal force EA α ΔT of each rod, with the largest change ΔT from the initial heat.
fn of_heat(scene: &Scene) -> impl Iterator<Item = f64> {
    scene.rods.iter().filter_map(|rod| {
        let (heat, material, section) = (scene.heat(rod)?, scene.material(rod), scene.section(rod));
        let before = if heat.start == Start::Relaxed { heat.at(0.0) } else { 0.0 };
        let times = times_of([heat.history.as_slice()], scene.time.end);
        let change = times.into_iter().map(|t| (heat.at(t) - before).abs()).fold(0.0, f64::max);
        Some(material.youngs_modulus * section.height * section.width * material.alpha.abs() * change)
    })
}
