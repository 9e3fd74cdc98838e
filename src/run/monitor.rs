//! Monitors a run for results that cannot be trusted: collapse, rounding, instability.

use nalgebra::DVector;

use super::load_scale::LoadScale;
use crate::error::{Error, Result};
use crate::integrators::State;
use crate::model::{Method, Scene};
use crate::structure::Structure;

/// Motion between two checks for collapse: of nodes relative to the element length, and of slopes. r_x and r_y then
/// change by at most an eighth anywhere ([`Structure::moved`]). An element that goes on to collapse is noticed within
/// that, and one that recovers within it was hardly gone. A check in each step would make explicit runs of eight
/// elements slower by a quarter (the paper's element) to a half (Euler–Bernoulli); these checks cost no measurable
/// time.
const UNSEEN: f64 = 0.01;

/// Rounding error that causes a warning, relative to the sum of loads or to the smallest one.
const WARNED: f64 = 1e-4;

/// Rounding error of statics that causes a warning, relative to the displacement. It is estimated for errors of one
/// sign, which usually have both.
const WARNED_IN_STATICS: f64 = 1e-3;

/// Rounding error that is refused, relative to the loads: step by step it acts like a load.
const LOST: f64 = 0.05;

/// Rounding error of statics that is refused, relative to the displacement: no digit is left.
const NO_DIGIT: f64 = 0.5;

/// Monitors the steps of a run.
pub struct Monitor {
    /// Displacement at the last check for collapse.
    before: DVector<f64>,
    /// Rounding in motion; `None` in statics, which has a check of its own.
    rounding: Option<Rounding>,
}

/// Largest relative rounding errors so far.
struct Rounding {
    /// Quantity that rounding is compared with.
    beside: Beside,
    /// Fractions of all loads and of the smallest one; or, twice, of the structure's size.
    shares: [f64; 2],
}

enum Beside {
    LoadScale(LoadScale),
    /// Nothing moves the structure: it rests, or continues its motion, and its position is known. Its size, m, and a
    /// buffer.
    Known {
        size: f64,
        off: DVector<f64>,
    },
}

impl Monitor {
    pub fn new(scene: &Scene, structure: &Structure) -> Monitor {
        let rounding = (scene.time.method != Method::Static).then(|| {
            let loads = LoadScale::of(scene);
            let known = || Beside::Known { size: scene.size(), off: DVector::zeros(structure.size()) };
            let beside = if loads.all > 0.0 { Beside::LoadScale(loads) } else { known() };
            Rounding { beside, shares: [0.0; 2] }
        });
        Monitor { before: structure.start().clone(), rounding }
    }

    /// Checks the state after a step for collapse, if it has moved since the last check.
    ///
    /// # Errors
    /// [`Error::Collapsed`] with the element.
    pub fn step(&mut self, structure: &Structure, state: &State) -> Result<()> {
        // What is not a number has moved.
        if structure.moved(&self.before, &state.u) <= UNSEEN { Ok(()) } else { self.look(structure, state) }
    }

    /// Checks the state of an output row for collapse and rounding.
    ///
    /// # Errors
    /// [`Error::Collapsed`], or [`Error::LostInRounding`].
    pub fn row(&mut self, structure: &Structure, state: &State) -> Result<()> {
        self.look(structure, state)?;
        self.rounding.as_mut().map_or(Ok(()), |rounding| rounding.row(structure, state))
    }

    /// Error of a failed step: rounding, if that is as large as the loads.
    pub fn cause(&mut self, structure: &Structure, state: &State, error: Error) -> Error {
        let numerical = matches!(
            error,
            Error::NewtonFailed { .. } | Error::Singular { .. } | Error::NotFinite { .. } | Error::StepTooSmall { .. }
        );
        match self.rounding.as_mut().map(|rounding| rounding.row(structure, state)) {
            Some(Err(lost)) if numerical => lost,
            _ => error,
        }
    }

    fn look(&mut self, structure: &Structure, state: &State) -> Result<()> {
        structure.check_collapse(&self.before, &state.u, state.t)?;
        self.before.copy_from(&state.u);
        Ok(())
    }

    /// Adds the warnings about the whole run; returns the number of unstable directions of a static equilibrium.
    ///
    /// # Errors
    /// [`Error::LostInRounding`] for statics without a reliable digit.
    pub fn end(self, structure: &Structure, state: &State, warnings: &mut Vec<String>) -> Result<usize> {
        if let Some(rounding) = self.rounding {
            warnings.extend(rounding.warning());
            return Ok(0);
        }
        let share = structure.rounding_of_equilibrium(&state.u, state.t).unwrap_or(0.0);
        if share > NO_DIGIT {
            return Err(Error::LostInRounding { time: state.t, share, of: "displacement", statics: true });
        }
        let unstable = structure.unstable_directions(&state.u, state.t).unwrap_or(0);
        warnings.extend((unstable > 0).then(|| stability_warning(unstable)));
        warnings.extend((share > WARNED_IN_STATICS).then(|| rounding_warning(share, "displacement")));
        Ok(unstable)
    }
}

impl Rounding {
    fn row(&mut self, structure: &Structure, state: &State) -> Result<()> {
        let shares = match &mut self.beside {
            Beside::LoadScale(loads) => loads.shares(structure.rounding_force(&state.u), state.t),
            Beside::Known { size, off } => {
                off.copy_from(&state.u);
                *off -= structure.start();
                off.axpy(-state.t, structure.start_velocity(), 1.0);
                [structure.farthest(off) / (*size + state.t * structure.farthest(structure.start_velocity())); 2]
            }
        };
        for (largest, share) in self.shares.iter_mut().zip(shares) {
            *largest = largest.max(share);
        }
        let [share, _] = self.shares;
        if share > LOST {
            return Err(Error::LostInRounding { time: state.t, share, of: self.beside.words(), statics: false });
        }
        Ok(())
    }

    fn warning(&self) -> Option<String> {
        let ([share, of_least], of) = (self.shares, self.beside.words());
        let least = if of_least > WARNED.max(1.5 * share) {
            format!("{of}, {of_least:.0e} of the least of them")
        } else {
            of.into()
        };
        (share > WARNED || of_least > WARNED).then(|| rounding_warning(share, &least))
    }
}

impl Beside {
    fn words(&self) -> &'static str {
        match self {
            Beside::LoadScale(_) => "loads",
            Beside::Known { .. } => "size of the structure, which nothing moves",
        }
    }
}

fn rounding_warning(share: f64, of: &str) -> String {
    format!(
        "rounding errors of the elastic forces may be as much as {share:.0e} of the {of}: the structure is so stiff, or so slender, \
         that few digits are left"
    )
}

/// Warning about an equilibrium that would not stay, as a column above its Euler load.
fn stability_warning(directions: usize) -> String {
    format!(
        "the equilibrium found is unstable, in {directions} direction(s): the structure is pressed beyond its buckling load and would \
         bend out of this position; a small force across shows where to"
    )
}
