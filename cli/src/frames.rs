//! Frames: the axes of all rods at instants of a run, taken while it goes on.

use ancf::model::Scene;
use ancf::run::{AxisPoint, Simulation};

/// Axes of all rods at the instants of a schedule.
#[derive(Debug, Default)]
pub struct Frames {
    /// Number of steps from one frame to the next.
    every: usize,
    /// Fractions of the length at which each rod is sampled.
    pub at: Vec<Vec<f64>>,
    /// Frames in the order of time.
    pub list: Vec<Frame>,
}

/// Axes of all rods at an instant.
#[derive(Debug)]
pub struct Frame {
    step: usize,
    /// Time, s; in statics the load factor, or the number of the row of an arc-length path.
    pub t: f64,
    /// Load factor of statics; the time in motion.
    pub load: f64,
    /// Points of each rod, in the scene's order.
    pub rods: Vec<Vec<AxisPoint>>,
}

/// Most frames of a page: ten seconds at thirty frames a second.
const MOST_FRAMES: usize = 300;

/// Fewest frames of a page, however many rods there are.
const FEWEST_FRAMES: usize = 40;

/// Most points of a page in all frames together: some 2 MB.
const MOST_POINTS: usize = 60_000;

/// Choices of the largest number of points of a rod.
const POINTS: [usize; 4] = [33, 17, 9, 5];

impl Frames {
    /// Frames for a page: as many instants and points as an eye needs and a browser shows fast.
    pub fn for_page(scene: &Scene) -> Frames {
        let points = |cap: usize| scene.rods.iter().map(move |rod| (2 * rod.elements + 1).clamp(3, cap));
        let fits = |cap: &&usize| points(**cap).sum::<usize>() * MOST_FRAMES / 2 <= MOST_POINTS;
        let cap = POINTS.iter().find(fits).copied().unwrap_or(3);
        let points: Vec<usize> = points(cap).collect();
        let most = (MOST_POINTS / points.iter().sum::<usize>().max(1)).clamp(FEWEST_FRAMES, MOST_FRAMES);
        Frames::every(page_stride(scene, most), &points)
    }

    /// Frames that `output.shapes` asks for.
    pub fn for_shapes(scene: &Scene) -> Option<Frames> {
        let points = scene.output.shapes.as_ref()?.points;
        Some(Frames::every(scene.shapes_every()?, &vec![points; scene.rods.len()]))
    }

    fn every(every: usize, points: &[usize]) -> Frames {
        let fractions = |count: &usize| (0..*count).map(|n| n as f64 / (count - 1) as f64).collect();
        Frames { every, at: points.iter().map(fractions).collect(), list: Vec::new() }
    }

    /// Takes a frame, if one is due.
    pub fn see(&mut self, simulation: &Simulation) {
        if simulation.steps_done().is_multiple_of(self.every) {
            self.take(simulation);
        }
    }

    /// Takes the frame of the last step, if it is not there yet.
    pub fn end(&mut self, simulation: &Simulation) {
        if self.list.last().is_none_or(|last| last.step != simulation.steps_done()) {
            self.take(simulation);
        }
    }

    fn take(&mut self, simulation: &Simulation) {
        let rods = simulation.model().scene().rods.iter().zip(&self.at);
        let axes = rods.map(|(rod, at)| simulation.axis(&rod.name, at)).collect();
        // A state that is not finite is the run's own error, and no frame.
        if let Ok(rods) = axes {
            let state = simulation.state();
            self.list.push(Frame { step: simulation.steps_done(), t: state.t, load: state.load, rods });
        }
    }
}

/// Steps from one frame of a page to the next: as few as make at most so many frames, and so that rows are frames where
/// possible.
fn page_stride(scene: &Scene, most: usize) -> usize {
    let (steps, rows_every) = (scene.steps(), scene.rows_every());
    let divisors = (1..=rows_every).filter(|part| rows_every.is_multiple_of(*part));
    let of_a_row = divisors.into_iter().find(|part| steps / part <= most);
    of_a_row.unwrap_or_else(|| rows_every * (steps / rows_every).div_ceil(most).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stride(end: f64, step: f64, interval: Option<f64>) -> usize {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        (scene.time.end, scene.time.step, scene.output.interval) = (end, step, interval);
        page_stride(&scene, MOST_FRAMES)
    }

    #[test]
    fn frames_are_rows_where_possible() {
        assert_eq!(stride(2.0, 2.5e-4, Some(0.01)), 40, "200 rows");
        assert_eq!(stride(2.0, 2.5e-4, None), 27, "8000 rows");
        assert_eq!(stride(2.0, 2.5e-4, Some(2.0)), 32, "one row, 250 frames");
        assert_eq!(stride(2.0, 1e-2, Some(1.0)), 1, "as many as there are steps");
    }

    #[test]
    fn many_rods_have_fewer_points_and_frames() {
        let mut scene = Scene::builtin("scissors-3-thermal").unwrap();
        assert_eq!(Frames::for_page(&scene).at, vec![Frames::every(1, &[17]).at[0].clone(); 6]);
        let rod = scene.rods[0].clone();
        scene.rods = vec![rod; 400];
        let many = Frames::for_page(&scene);
        assert_eq!((many.at[0].len(), many.every), (3, 12000 / 50));
    }
}
