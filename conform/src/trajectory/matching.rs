//! Which mistakes made on purpose move as the program does.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::frames::{Frames, Path, distance};
use super::mistake::{Family, Made, Mistake, Output};
use super::mistakes::families::FAMILIES;
use super::mistakes::methods::right_methods;
use super::mistakes::mistakes;
use super::motion::{Method, frames};
use super::reference::Reference;
use super::rods::Rods;
use super::setup::Setup;

/// A mistake fits if its motion is nearer to the program's than this part of the reference's distance.
const NEAR: f64 = 0.05;
/// A fit so good, in parts of the reference's distance, that no number is fitted besides.
const SURE: f64 = 0.01;
/// Fits within this factor of the best one cannot be told from it.
const ALIKE: f64 = 3.0;
/// Largest number of mistakes that are named.
const MOST_NAMED: usize = 6;
/// Corrections of a fitted number.
const CORRECTIONS: usize = 5;
/// Where a number is fitted, a motion farther off than this many distances of the reference is not followed to its end.
const HOPELESS: f64 = 4.0;
/// Distance at which motions are the same, m, and in parts of the program's own error.
const SAME: (f64, f64) = (1e-8, 0.02);
/// Error of fine motions where sudden heat excites waves, m.
const ERROR_OF_WAVES: f64 = 3e-4;
/// The program may differ from a fine motion by this many errors of right methods.
const ERRORS_OF_A_METHOD: f64 = 2.0;
/// With steps below this, s, methods leave no error that hides a mistake.
const SHORTEST_STEP: f64 = 5e-6;

/// A mistake whose motion is the program's.
#[derive(Clone, Debug)]
pub struct Fit {
    /// What is wrong.
    pub what: String,
    /// What to look at.
    pub look_at: &'static str,
    /// Largest distance of its motion from the program's, m.
    pub distance: f64,
}

/// What is known before mistakes are matched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// The program's step does not explain its motion.
    Mistake,
    /// It may, or may not.
    Undecided,
    /// It does: a mistake counts only where the same method with it moves exactly as the program.
    SameMethod,
}

/// The program's motion, as mistakes are matched with it.
pub struct Observed<'a> {
    /// The right motion.
    pub reference: &'a Reference,
    /// Its frames at the program's times.
    pub right: &'a Frames,
    /// The program's motion, and what its limit for a step of nothing may be.
    pub motions: Vec<&'a Frames>,
    /// Distance of the program from the reference, m.
    pub off: f64,
    /// The program's own error, as far as it is known, m.
    pub own_error: f64,
    /// Its step, s.
    pub step: Option<f64>,
    /// What is known.
    pub search: Search,
}

/// Whether rods, moved finely, stay within a distance of a motion.
pub fn observed_near(motion: &Frames, rods: &Rods, near: f64) -> bool {
    let moved = frames(rods, Method::Fine, &motion.t, |moved| is_far(motion, moved, near));
    distance(&motion.position, &moved.position) <= near
}

/// Whether the last frame is farther than `near` from the same of `motion`.
fn is_far(motion: &Frames, frames: &Frames, near: f64) -> bool {
    let Some(last) = frames.t.len().checked_sub(1) else { return false };
    motion.position.iter().any(|(point, path)| {
        let pair = path.get(last).zip(frames.position.get(point).and_then(|path| path.get(last)));
        pair.is_some_and(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]) > near)
    })
}

impl Observed<'_> {
    /// Positions of a mistake at the program's times; they end where they are farther than `far` from the program's.
    fn positions(&self, made: &Made, right: &Setup, moved_by: Method, far: f64) -> BTreeMap<String, Path> {
        let times = &self.right.t;
        let moved = |setup: &Setup, method: Method, times: &[f64]| {
            let Some(rods) = Rods::new(setup) else { return BTreeMap::new() };
            let hopeless = |frames: &Frames| self.motions.iter().all(|motion| is_far(motion, frames, far));
            frames(&rods, method, times, hopeless).position
        };
        match made {
            Made::Setup(setup) => moved(setup, moved_by, times),
            Made::Method(method) => moved(right, *method, times),
            Made::Output(Output::Times(factor, shift)) => {
                let times: Vec<f64> = times.iter().map(|t| (factor * t + shift).max(0.0)).collect();
                moved(right, Method::Fine, &times)
            }
            Made::Output(Output::Map(map, relative)) => {
                let written = |(name, path): (&String, &Path)| {
                    let start = if *relative { path.first().copied().unwrap_or_default() } else { [0.0; 2] };
                    let mapped = path.iter().map(|p| {
                        let d = [p[0] - start[0], p[1] - start[1]];
                        [map[0][0] * d[0] + map[0][1] * d[1], map[1][0] * d[0] + map[1][1] * d[1]]
                    });
                    (name.clone(), mapped.collect())
                };
                self.right.position.iter().map(written).collect()
            }
            Made::Output(Output::Point(name)) => {
                let Some(path) = self.right.position.get(name) else { return BTreeMap::new() };
                // Written under the name of one other point.
                let others =
                    self.motions.iter().flat_map(|motion| motion.position.keys()).filter(|other| *other != name);
                let mut positions = self.right.position.clone();
                others.take(1).for_each(|other| _ = positions.insert(other.clone(), path.clone()));
                positions
            }
        }
    }

    /// Distances of mistakes, the cheapest motions first: by Verlet's steps as long as the program's, which share its error if it does the
    /// same; finely; by the trapezoidal rule with its step, if they come near. What follows is left out once a mistake is matched.
    fn distances(&self, mistakes: &[Mistake], right: &Setup) -> Vec<f64> {
        let of = |count: &(dyn Fn(&Made) -> f64 + Sync)| {
            mistakes.par_iter().map(|mistake| count(&mistake.made)).collect::<Vec<f64>>()
        };
        let by = |method: Option<Method>, made: &Made| match (made, method) {
            (Made::Setup(_), Some(method)) => self.distance(made, right, method, self.limit()),
            _ => f64::INFINITY,
        };
        let [verlet, trapezoidal] = match self.step.filter(|step| *step > SHORTEST_STEP).map(right_methods) {
            Some(methods) => methods.map(Some),
            None => [None; 2],
        };
        let mut nearest = of(&|made| match made {
            Made::Setup(_) => by(verlet, made),
            other => self.distance(other, right, Method::Fine, self.limit()),
        });
        let is_within = |nearest: &[f64], near: f64| nearest.iter().any(|distance| *distance < near);
        if is_within(&nearest, SAME.0) {
            return nearest;
        }
        if self.search == Search::SameMethod {
            let found = of(&|made| by(trapezoidal, made));
            return nearest.into_iter().zip(found).map(|(one, other)| one.min(other)).collect();
        }
        let fine = of(&|made| self.distance_of_the_limit(made, right));
        nearest.iter_mut().zip(&fine).for_each(|(nearest, fine)| *nearest = nearest.min(*fine));
        if !is_within(&nearest, self.found()) {
            let near = self.limit() + ERRORS_OF_A_METHOD * self.own_error;
            let comes_near = |(mistake, fine): (&Mistake, &f64)| match *fine <= near {
                true => by(trapezoidal, &mistake.made),
                false => f64::INFINITY,
            };
            let found: Vec<f64> = mistakes.par_iter().zip(&fine).map(comes_near).collect();
            nearest.iter_mut().zip(found).for_each(|(nearest, found)| *nearest = nearest.min(found));
        }
        // Farther ones were followed only for the sake of the program's own error.
        nearest.iter_mut().filter(|nearest| **nearest > self.limit()).for_each(|nearest| *nearest = f64::INFINITY);
        nearest
    }

    /// Distance of a mistake's motion from the program's, moved finely.
    fn distance_of_the_limit(&self, made: &Made, right: &Setup) -> f64 {
        let Made::Setup(setup) = made else { return f64::INFINITY };
        let near = self.limit() + ERRORS_OF_A_METHOD * self.own_error;
        if !setup.is_suddenly_heated() {
            return self.distance(made, right, Method::Fine, near);
        }
        match self.distance(made, right, Method::Fine, near + ERROR_OF_WAVES) {
            distance if distance <= near + ERROR_OF_WAVES => self.distance(made, right, Method::Finest, near),
            distance => distance,
        }
    }

    /// A distance so small that nothing else is tried.
    fn found(&self) -> f64 {
        (SURE * self.off).max(0.5 * self.own_error.min(self.off))
    }

    fn distance(&self, made: &Made, right: &Setup, method: Method, far: f64) -> f64 {
        let positions = self.positions(made, right, method, far);
        let of = |motion: &&Frames| distance(&motion.position, &positions);
        self.motions.iter().map(of).fold(f64::INFINITY, f64::min)
    }

    /// Largest distance at which a mistake fits.
    fn limit(&self) -> f64 {
        match self.search {
            Search::Mistake => self.own_error.max(NEAR * self.off).min(0.5 * self.off),
            Search::Undecided => NEAR * self.off,
            Search::SameMethod => SURE * self.off,
        }
    }

    /// Distance up to which fits cannot be told from the nearest one.
    fn alike(&self, nearest: f64) -> f64 {
        let same = SAME.0.max(SAME.1 * self.own_error);
        let error = if nearest < same { same } else { 0.5 * self.own_error };
        (ALIKE * nearest).max(error).min(self.limit())
    }
}

/// Mistakes that move as the program does, the nearest first; those that cannot be told apart all together.
pub fn matching(observed: &Observed) -> Vec<Fit> {
    let right = Setup::of(observed.reference.scene.clone());
    let fixed = mistakes(&observed.reference.scene, observed.step);
    let distances = observed.distances(&fixed, &right);
    let fits = fixed.iter().zip(distances);
    let mut fits: Vec<Fit> = fits
        .map(|(mistake, distance)| Fit { what: mistake.what.clone(), look_at: mistake.look_at, distance })
        .collect();
    let best = |fits: &[Fit]| fits.iter().map(|fit| fit.distance).fold(f64::INFINITY, f64::min);
    if best(&fits) > observed.found() && observed.search != Search::SameMethod {
        let fitted: Vec<Fit> = FAMILIES.par_iter().filter_map(|family| fitted(observed, family, &right)).collect();
        fits.extend(fitted);
    }
    let alike = observed.alike(best(&fits));
    fits.retain(|fit| fit.distance <= alike);
    fits.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    fits.truncate(MOST_NAMED);
    fits
}

/// The value of a family's number that moves most nearly as the program does.
fn fitted(observed: &Observed, family: &Family, right: &Setup) -> Option<Fit> {
    let positions = |value: f64| {
        let made = (family.make)(right, value, observed.step)?;
        Some(observed.positions(&made, right, Method::Fine, HOPELESS * observed.off))
    };
    let program = observed.motions.last()?;
    let differences = |positions: &BTreeMap<String, Path>| {
        let mut all = Vec::new();
        for (point, path) in &program.position {
            let ours = positions.get(point)?;
            if ours.len() < path.len() {
                return None;
            }
            all.extend(path.iter().zip(ours).flat_map(|(a, b)| [a[0] - b[0], a[1] - b[1]]));
        }
        Some(all)
    };
    let far = |positions: &BTreeMap<String, Path>| distance(&program.position, positions);
    let started = family.starts.iter().filter_map(|start| {
        let distance = far(&positions(*start)?);
        distance.is_finite().then_some((*start, distance))
    });
    let (mut value, mut reached) = started.min_by(|a, b| a.1.total_cmp(&b.1))?;
    for _ in 0..CORRECTIONS {
        // Gauss and Newton's correction of one number.
        let small = 1e-4 * value.abs().max(1e-6);
        let (Some(here), Some(there)) =
            (differences(&positions(value)?), positions(value + small).and_then(|positions| differences(&positions)))
        else {
            break;
        };
        let slope: Vec<f64> = here.iter().zip(&there).map(|(a, b)| (a - b) / small).collect();
        let square: f64 = slope.iter().map(|s| s * s).sum();
        let along: f64 = slope.iter().zip(&here).map(|(s, d)| s * d).sum();
        let mut correction = along / square;
        let mut better = None;
        for _ in 0..4 {
            let distance = positions(value + correction).map_or(f64::INFINITY, |positions| far(&positions));
            if distance < reached {
                better = Some((value + correction, distance));
                break;
            }
            correction *= 0.4;
        }
        let Some((next, distance)) = better else { break };
        let settled = distance > 0.95 * reached;
        (value, reached) = (next, distance);
        if settled {
            break;
        }
    }
    Some(Fit { what: (family.what)(value), look_at: family.look_at, distance: reached })
}
