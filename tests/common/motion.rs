//! Runs compared with one another: vectors over time, never sums.

use ancf::model::{Probe, Quantity, Scene, Support};
use ancf::run::{Run, run};
use nalgebra::{Rotation2, Vector2};

/// Vectors over time.
pub type Path = Vec<[f64; 2]>;

/// The two columns `name.a` and `name.b`.
fn columns(run: &Run, name: &str, suffixes: [&str; 2]) -> Path {
    let column = |suffix| {
        let column = format!("{name}.{suffix}");
        run.trajectory.column(&column).unwrap_or_else(|| panic!("no column {column}"))
    };
    let [x, y] = suffixes.map(column);
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

pub fn positions(run: &Run, probe: &str) -> Path {
    columns(run, probe, ["x", "y"])
}

pub fn velocities(run: &Run, probe: &str) -> Path {
    columns(run, probe, ["vx", "vy"])
}

pub fn reactions(run: &Run, probe: &str) -> Path {
    columns(run, probe, ["rx", "ry"])
}

/// Largest distance of two paths at the same times; a NaN is infinitely far.
pub fn farthest(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    assert_eq!(a.len(), b.len(), "numbers of rows differ");
    let distance = |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - b[0]).hypot(a[1] - b[1]);
    a.iter().zip(b).map(distance).fold(0.0, |far, d| if d.is_nan() { f64::INFINITY } else { d.max(far) })
}

/// Largest length of the vectors of a path.
pub fn longest(path: &[[f64; 2]]) -> f64 {
    farthest(path, &vec![[0.0; 2]; path.len()])
}

/// A probe on a point that bears its name.
pub fn probe(point: &str, of: &[Quantity]) -> Probe {
    Probe { name: point.into(), point: Some(point.into()), rod: None, at: None, of: of.to_vec(), mean: None }
}

/// A probe `point-rod` of the force on a rod at a point.
pub fn force_on(point: &str, rod: &str) -> Probe {
    let (name, of) = (format!("{point}-{rod}"), vec![Quantity::Reaction]);
    Probe { name, point: Some(point.into()), rod: Some(rod.into()), at: None, of, mean: None }
}

/// Runs a scene that has to run.
pub fn must_run(scene: &Scene) -> Run {
    run(scene).unwrap_or_else(|error| panic!("{} ({}): {error}", scene.title, scene.time.method))
}

/// A congruence: mirrored at the x axis or not, then turned about the origin, then moved.
#[derive(Clone, Copy, Debug)]
pub struct Placing {
    pub mirrored: bool,
    pub angle: f64,
    pub by: [f64; 2],
}

impl Placing {
    /// Of a vector that has a direction only: a velocity, a force.
    pub fn vector(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        (Rotation2::new(self.angle) * Vector2::new(x, if self.mirrored { -y } else { y })).into()
    }

    pub fn point(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.vector(point);
        [x + self.by[0], y + self.by[1]]
    }

    /// The scene as a whole: points, forces, weight, and what supports leave free.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut placed = scene.clone();
        placed.points.values_mut().for_each(|point| *point = self.point(*point));
        placed.forces.iter_mut().for_each(|force| force.force = self.vector(force.force));
        placed.gravity = self.vector(scene.gravity);
        placed.supports.iter_mut().for_each(|support| self.support(support));
        placed
    }

    /// A support that holds one direction leaves the one across it free, which is a slide in any direction.
    fn support(&self, support: &mut Support) {
        if let [direction] = *support.fix {
            let free = if direction == ancf::model::Direction::X { [0.0, 1.0] } else { [1.0, 0.0] };
            (support.fix, support.slide) = (Vec::new(), Some(free));
        }
        support.slide = support.slide.map(|slide| self.vector(slide));
    }
}
