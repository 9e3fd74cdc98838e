//! Observations of the runs of an error estimate: quantities and instants that are compared.

use std::collections::BTreeSet;

use nalgebra::DVector;

use super::load_scale::{has_loads, mass};
use super::result::Run;
use super::simulation::{Simulation, run_watched};
use crate::error::{Error, Result};
use crate::model::{Method, Quantity, Rod, Scene};
use crate::structure::{PointId, RodId, Structure};

/// Factor from the change to the error: halving a step or an element at least halves the error, so that the remainder
/// is at most the change.
pub(super) const SAFETY: f64 = 2.0;

/// Largest estimated error relative to the motion: above it no digit is reliable.
pub(super) const INACCURATE: f64 = 0.1;

/// Least motion, relative to the structure's size, that an error is compared with.
const LEAST_MOTION: f64 = 1e-6;

/// Error that is rounding, relative to the structure's size.
const ROUNDING: f64 = 1e-12;

/// Most observed vectors of a run, which are kept in memory: 32 MB.
const MOST_OBSERVATIONS: usize = 2_000_000;

/// Quantities and instants to be observed in all runs of an estimate.
pub(super) struct Observer<'a> {
    /// Scene of the run itself.
    pub(super) scene: &'a Scene,
    observables: Vec<Observable>,
    /// Steps of the run itself between observations; rows are observed too.
    every: usize,
}

/// Observed quantity: a position or a deflection.
struct Observable {
    kind: ObservableKind,
    /// Initial velocity of the centre of mass of its connected part, m/s.
    velocity: [f64; 2],
}

enum ObservableKind {
    Point(String),
    /// Deflection of a rod at a fraction of its length.
    Rod(String, f64),
}

/// Observations of one run.
#[derive(Default)]
pub(super) struct Observations {
    /// Times of the instants, s.
    times: Vec<f64>,
    /// Whether each instant is an output row of the run itself.
    rows: Vec<bool>,
    /// All quantities at the first instant, then at the second, …, m; a deflection has one component.
    values: Vec<[f64; 2]>,
}

impl Observations {
    /// One quantity at all instants.
    fn of(&self, observable: usize) -> impl Iterator<Item = [f64; 2]> {
        self.values.iter().copied().skip(observable).step_by((self.values.len() / self.times.len().max(1)).max(1))
    }
}

impl Observable {
    fn name(&self) -> String {
        match &self.kind {
            ObservableKind::Point(name) => format!("position of `{name}`"),
            ObservableKind::Rod(name, _) => format!("deflection of the rod `{name}`"),
        }
    }
}

/// Observed quantity in the structure of one run.
enum Located {
    Point(PointId),
    /// Deflection of a rod at a fraction of its length.
    Rod(RodId, f64),
}

impl Located {
    fn of(observable: &Observable, structure: &Structure) -> Result<Located> {
        Ok(match &observable.kind {
            ObservableKind::Point(name) => Located::Point(structure.point(name)?),
            ObservableKind::Rod(name, at) => Located::Rod(structure.rod(name)?, *at),
        })
    }

    fn at(&self, structure: &Structure, u: &DVector<f64>) -> [f64; 2] {
        match *self {
            Located::Point(point) => structure.position(point, u),
            Located::Rod(rod, at) => [structure.deflection(rod, at, u), 0.0],
        }
    }
}

impl Observer<'_> {
    /// Observes all points, the deflections that probes ask for, and those of rods held at both ends, which no point
    /// shows.
    pub(super) fn of(scene: &Scene) -> Observer<'_> {
        let point = |name: &String| Observable {
            kind: ObservableKind::Point(name.clone()),
            velocity: drift(scene, name).unwrap_or_default(),
        };
        let rod =
            |name: &String, at: f64| Observable { kind: ObservableKind::Rod(name.clone(), at), velocity: [0.0; 2] };
        let pivots: BTreeSet<&String> = scene.rods.iter().filter_map(|rod| rod.pivot.as_ref()).collect();
        let points = scene.points.keys().chain(pivots).map(point);
        let bends = scene.probes.iter().filter(|probe| probe.of.contains(&Quantity::Deflection));
        let probed = bends.filter_map(|probe| Some(rod(probe.rod.as_ref()?, probe.at?)));
        let is_held = |point: &String| {
            let supports = scene.supports.iter().filter(|support| support.point == *point);
            supports.map(|support| support.held().len()).sum::<usize>() > 0
        };
        let held = scene.rods.iter().filter(|rod| is_held(&rod.from) && is_held(&rod.to));
        // A single bow, and a wave with a node in the middle.
        let bows = held.flat_map(|held| [0.5, 0.25].map(|at| rod(&held.name, at)));
        let observables: Vec<Observable> = points.chain(probed).chain(bows).collect();

        let every = (scene.steps() * observables.len()).div_ceil(MOST_OBSERVATIONS).max(1);
        Observer { scene, observables, every }
    }

    pub(super) fn run(&self, scene: &Scene) -> Result<(Run, Observations)> {
        self.run_with_progress(&mut Simulation::new(scene)?, |_| ())
    }

    /// Runs the scene, or a finer one with several steps per step, and observes it.
    pub(super) fn run_with_progress(
        &self,
        run: &mut Simulation,
        on_step: impl FnMut(&Simulation),
    ) -> Result<(Run, Observations)> {
        let parts = (run.model().scene().steps() / self.scene.steps()).max(1);
        let located: Vec<Located> = self
            .observables
            .iter()
            .map(|observable| Located::of(observable, run.structure()))
            .collect::<Result<_>>()?;
        let observes = |step: usize| step.is_multiple_of(self.every) || self.scene.is_row(step);
        let mut seen = Observations::default();
        let run = run_watched(run, on_step, |now| {
            let step = now.steps_done();
            if step.is_multiple_of(parts) && observes(step / parts) {
                seen.times.push(now.time());
                seen.rows.push(self.scene.is_row(step / parts));
                seen.values.extend(located.iter().map(|observable| observable.at(now.structure(), &now.state().u)));
            }
        })?;
        Ok((run, seen))
    }

    /// Instants of observation, in words.
    pub(super) fn schedule(&self) -> String {
        match (self.scene.time.method, self.every) {
            (Method::Static, 1) => "compared after each load step".into(),
            (method, 1) if method.is_adaptive() => "compared at the rows".into(),
            (_, 1) => "compared after each step".into(),
            (_, every) => format!("compared after every {every} steps and at the rows"),
        }
    }

    /// Estimated errors: twice the largest distance between two runs, over the instants that `counts` accepts (rows or
    /// others). NaN if a distance is.
    pub(super) fn changes(&self, own: &Observations, finer: &Observations, counts: impl Fn(bool) -> bool) -> Vec<f64> {
        self.distances(own, finer, counts).into_iter().map(|distance| SAFETY * distance).collect()
    }

    /// Largest distances between two runs, over the instants that `counts` accepts (rows or others). NaN if a distance
    /// is.
    pub(super) fn distances(
        &self,
        own: &Observations,
        finer: &Observations,
        counts: impl Fn(bool) -> bool,
    ) -> Vec<f64> {
        if own.times.len() != finer.times.len() {
            return vec![f64::NAN; self.observables.len()];
        }
        let apart = |([x, y], [other_x, other_y]): ([f64; 2], [f64; 2])| (x - other_x).hypot(y - other_y);
        let change = |observable: usize| {
            let pairs = own.of(observable).zip(finer.of(observable)).zip(&own.rows);
            largest(pairs.filter(|(_, is_row)| counts(**is_row)).map(|(pair, _)| apart(pair)))
        };
        (0..self.observables.len()).map(change).collect()
    }

    /// An observed quantity in words.
    pub(super) fn name(&self, observable: usize) -> String {
        self.observables[observable].name()
    }

    /// Motions that the errors are compared with, m: of each observed quantity from its start or from its position
    /// without loads; of the farthest one where its own is too small.
    pub(super) fn motions(&self, seen: &Observations) -> Vec<f64> {
        let motion_of = |observable: usize, free_rotation: f64| {
            let [x_0, y_0] = seen.of(observable).next().unwrap_or_default();
            let [v_x, v_y] = self.observables[observable].velocity.map(|velocity| free_rotation * velocity);
            let gone = |([x, y], t): ([f64; 2], &f64)| (x - x_0 - t * v_x).hypot(y - y_0 - t * v_y);
            largest(seen.of(observable).zip(&seen.times).map(gone))
        };
        let farthest = largest((0..self.observables.len()).map(|observable| motion_of(observable, 0.0)));
        let (size, resting) = (self.scene.size(), !has_loads(self.scene));
        let moved = |observable: usize| {
            let own = motion_of(observable, 0.0).min(motion_of(observable, 1.0));
            // Where nothing moves the structure there is no motion to compare with.
            if resting {
                farthest.max(size)
            } else if own >= LEAST_MOTION * size {
                own
            } else {
                farthest
            }
        };
        (0..self.observables.len()).map(moved).collect()
    }

    /// Refuses errors that leave no reliable digit of a motion.
    ///
    /// # Errors
    /// [`Error::Inaccurate`] for the worst quantity.
    pub(super) fn judge(&self, seen: &Observations, time: &[f64], space: &[f64]) -> Result<()> {
        let (motions, size) = (self.motions(seen), self.scene.size());
        let judged = |((observable, time), space): ((usize, &f64), &f64)| {
            let moved = motions[observable];
            // A NaN is not small.
            let small = time + space <= INACCURATE * moved || time + space <= ROUNDING * size;
            let name = || self.name(observable);
            (!small).then(|| Error::Inaccurate { place: name(), time: *time, space: *space, moved })
        };
        let share = |error: &Error| match error {
            Error::Inaccurate { time, space, moved, .. } => (time + space) / moved,
            _ => 0.0,
        };
        let bad = (0..self.observables.len()).zip(time).zip(space).filter_map(judged);
        bad.max_by(|a, b| share(a).total_cmp(&share(b))).map_or(Ok(()), Err)
    }
}

/// Initial velocity of the centre of mass of the rods connected with a point; `None` without an initial motion.
fn drift(scene: &Scene, point: &String) -> Option<[f64; 2]> {
    let motion = scene.motion.as_ref()?;
    let mut points = BTreeSet::from([point]);
    let touches = |points: &BTreeSet<&String>, rod: &Rod| ends(rod).any(|point| points.contains(point));
    // As many rounds as the longest chain of rods needs.
    for _ in &scene.rods {
        let more: Vec<&String> = scene.rods.iter().filter(|rod| touches(&points, rod)).flat_map(ends).collect();
        points.extend(more);
    }
    let (mut momentum, mut total_mass) = ([0.0; 2], 0.0);
    for rod in scene.rods.iter().filter(|rod| touches(&points, rod)) {
        let (mass, [x, y]) = (mass(scene, rod), motion.at(scene.middle(rod)?));
        momentum = [momentum[0] + mass * x, momentum[1] + mass * y];
        total_mass += mass;
    }
    Some(momentum.map(|component| component / total_mass))
}

/// Points of a rod.
fn ends(rod: &Rod) -> impl Iterator<Item = &String> {
    [&rod.from, &rod.to].into_iter().chain(&rod.pivot)
}

/// Largest value; in the total order NaN is the largest, and is not lost.
fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
