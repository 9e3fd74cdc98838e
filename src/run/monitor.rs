//! What makes a result doubtful: found in the scene, in its motion or at its end.

use nalgebra::DVector;

use super::load_scale::LoadScale;
use crate::error::{Error, Result};
use crate::integrators::State;
use crate::model::{Method, Scene};
use crate::structure::Structure;

/// How far nodes may move from one look at the elements to the next, of an element's length, and slopes turn. r_x and r_y then change by
/// no more than an eighth anywhere ([`Structure::moved`]): an element that goes on to collapse is seen within that, and what comes back
/// within it was hardly gone. A look at each step would make explicit runs of eight elements longer by a quarter (the paper's element) to a
/// half (the other); these cannot be told from none.
const UNSEEN: f64 = 0.01;

/// Part of the loads, or of the least of them, from which rounding is warned of.
const WARNED: f64 = 1e-4;

/// Part of the displacement from which it is: an estimate for errors of one sign, which mostly have both.
const WARNED_IN_STATICS: f64 = 1e-3;

/// Rounding of this part of the loads is refused: step by step it acts like one.
const LOST: f64 = 0.05;

/// Rounding of this part of the displacement leaves no digit of it.
const NO_DIGIT: f64 = 0.5;

/// Watches the steps of a run.
pub struct Monitor {
    /// Displacement that was looked at last.
    before: DVector<f64>,
    /// `None` in statics, which has its own.
    rounding: Option<Rounding>,
}

/// The largest shares that rounding has had so far.
struct Rounding {
    /// Beside what rounding is judged.
    beside: Beside,
    /// Of all loads, of the least of them; or of the structure's size.
    shares: [f64; 2],
}

enum Beside {
    LoadScale(LoadScale),
    /// Nothing moves the structure: it rests, or goes on as it began, and is where it is known to be. Its size, m, and memory.
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

    /// Looks at the state after a step, where it has moved since the last look.
    ///
    /// # Errors
    /// [`Error::Collapsed`].
    pub fn step(&mut self, structure: &Structure, state: &State) -> Result<()> {
        // What is no number has moved.
        if structure.moved(&self.before, &state.u) <= UNSEEN { Ok(()) } else { self.look(structure, state) }
    }

    /// Looks at the state of an output row.
    ///
    /// # Errors
    /// [`Error::Collapsed`], [`Error::LostInRounding`].
    pub fn row(&mut self, structure: &Structure, state: &State) -> Result<()> {
        self.look(structure, state)?;
        self.rounding.as_mut().map_or(Ok(()), |rounding| rounding.row(structure, state))
    }

    /// What a step failed for: rounding, where that is as large as the loads.
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

    /// Adds doubts about the whole run to the warnings; in how many directions the equilibrium of statics is unstable.
    ///
    /// # Errors
    /// [`Error::LostInRounding`].
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

/// An equilibrium that would not stay: a column above its Euler load.
fn stability_warning(directions: usize) -> String {
    format!(
        "the equilibrium found is unstable, in {directions} direction(s): the structure is pressed beyond its buckling load and would \
         bend out of this position; a small force across shows where to"
    )
}
