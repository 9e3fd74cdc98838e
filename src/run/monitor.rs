//! Monitors a run for results that cannot be trusted: collapse, rounding, instability.

use nalgebra::DVector;

use super::equilibria::Equilibria;
use super::load_scale::LoadScale;
use crate::error::{Error, Result};
use crate::integrators::State;
use crate::model::{Method, Scene};
use crate::structure::Structure;

/// Motion between two checks for collapse: of nodes relative to the element length, and of slopes. r_x and r_y then
/// change by at most an eighth anywhere ([`Structure::largest_change`]). An element that goes on to collapse is noticed within
/// that, and one that recovers within it was hardly gone. A check in each step would make explicit runs of eight
/// elements slower by a quarter (the paper's element) to a half (Euler–Bernoulli); these checks cost no measurable
/// time.
const CHECK_DISTANCE: f64 = 0.01;

/// Rounding error that causes a warning, relative to the sum of loads or to the smallest one.
const WARNED: f64 = 1e-4;

/// Rounding error of statics that causes a warning, relative to the displacement. The estimate assumes errors of one
/// sign; real ones usually have both.
const WARNED_IN_STATICS: f64 = 1e-3;

/// Rounding error that is refused, relative to the loads: step by step it acts like a load.
const REFUSED: f64 = 0.05;

/// Rounding error of statics that is refused, relative to the displacement: no digit is left.
const REFUSED_IN_STATICS: f64 = 0.5;

/// Monitors the steps of a run.
pub struct Monitor {
    /// Displacement at the last check for collapse.
    before: DVector<f64>,
    /// Rounding in motion; `None` in statics, which has a check of its own.
    rounding: Option<Rounding>,
    /// Stability of the rows of statics.
    equilibria: Option<Equilibria>,
}

/// Largest relative rounding errors so far.
struct Rounding {
    /// Quantity that rounding is compared with.
    reference: Reference,
    /// Fractions of all loads and of the smallest one; or, twice, of the structure's size.
    fractions: [f64; 2],
}

enum Reference {
    Loads(LoadScale),
    /// Nothing moves the structure: it rests, or continues its motion, and its position is known. Its size, m, and a
    /// buffer.
    KnownPosition {
        size: f64,
        deviation: DVector<f64>,
    },
}

impl Monitor {
    pub fn new(scene: &Scene, structure: &Structure) -> Monitor {
        let rounding = (scene.time.method != Method::Static).then(|| {
            let loads = LoadScale::of(scene);
            let known = || Reference::KnownPosition { size: scene.size(), deviation: DVector::zeros(structure.size()) };
            let reference = if loads.total > 0.0 { Reference::Loads(loads) } else { known() };
            Rounding { reference, fractions: [0.0; 2] }
        });
        let equilibria = rounding.is_none().then(|| Equilibria::new(structure, scene.time.has_load_column()));
        Monitor { before: structure.start().clone(), rounding, equilibria }
    }

    /// Checks the state after a step for collapse, if it has moved since the last check.
    ///
    /// # Errors
    /// [`Error::Collapsed`] with the element.
    pub fn step(&mut self, structure: &Structure, state: &State) -> Result<()> {
        // What is not a number has moved.
        if structure.largest_change(&self.before, &state.u) <= CHECK_DISTANCE {
            Ok(())
        } else {
            self.check_collapse(structure, state)
        }
    }

    /// Checks the state of an output row for collapse and rounding.
    ///
    /// # Errors
    /// [`Error::Collapsed`], or [`Error::LostInRounding`].
    pub fn row(&mut self, structure: &Structure, state: &State) -> Result<()> {
        self.check_collapse(structure, state)?;
        if let Some(equilibria) = &mut self.equilibria {
            equilibria.row(structure, state);
        }
        self.rounding.as_mut().map_or(Ok(()), |rounding| rounding.row(structure, state))
    }

    /// Error of a failed step: rounding, if that is as large as the loads.
    pub fn explain(&mut self, structure: &Structure, state: &State, error: Error) -> Error {
        let numerical = matches!(
            error,
            Error::NewtonFailed { .. } | Error::Singular { .. } | Error::NotFinite { .. } | Error::StepTooSmall { .. }
        );
        match self.rounding.as_mut().map(|rounding| rounding.row(structure, state)) {
            Some(Err(lost)) if numerical => lost,
            _ => error,
        }
    }

    fn check_collapse(&mut self, structure: &Structure, state: &State) -> Result<()> {
        // Statics has followed the rods to the row, however far they have turned since the last one.
        let before = if self.equilibria.is_some() { &state.u } else { &self.before };
        structure.check_collapse(before, &state.u, state.load)?;
        self.before.copy_from(&state.u);
        Ok(())
    }

    /// Adds the warnings about the whole run; returns the most unstable directions of a static equilibrium.
    ///
    /// # Errors
    /// [`Error::LostInRounding`] for statics without a reliable digit.
    pub fn end(&self, structure: &Structure, state: &State, warnings: &mut Vec<String>) -> Result<usize> {
        if let Some(rounding) = &self.rounding {
            warnings.extend(rounding.warning());
            return Ok(0);
        }
        let share = structure.rounding_of_equilibrium(&state.u, state.load).unwrap_or(0.0);
        if share > REFUSED_IN_STATICS {
            return Err(Error::LostInRounding { time: state.load, share, of: "displacement", statics: true });
        }
        let unstable = self.equilibria.as_ref().map_or(0, Equilibria::unstable_directions);
        warnings.extend(self.equilibria.iter().flat_map(Equilibria::warnings));
        warnings.extend((share > WARNED_IN_STATICS).then(|| rounding_warning(share, "displacement")));
        Ok(unstable)
    }
}

impl Rounding {
    fn row(&mut self, structure: &Structure, state: &State) -> Result<()> {
        let fractions = match &mut self.reference {
            Reference::Loads(loads) => loads.fractions(structure.rounding_force(&state.u), state.t),
            Reference::KnownPosition { size, deviation } => {
                deviation.copy_from(&state.u);
                *deviation -= structure.start();
                deviation.axpy(-state.t, structure.start_velocity(), 1.0);
                [structure.largest_displacement(deviation)
                    / (*size + state.t * structure.largest_displacement(structure.start_velocity())); 2]
            }
        };
        for (largest, share) in self.fractions.iter_mut().zip(fractions) {
            *largest = largest.max(share);
        }
        let [share, _] = self.fractions;
        if share > REFUSED {
            return Err(Error::LostInRounding { time: state.t, share, of: self.reference.words(), statics: false });
        }
        Ok(())
    }

    fn warning(&self) -> Option<String> {
        let ([share, of_least], of) = (self.fractions, self.reference.words());
        let least = if of_least > WARNED.max(1.5 * share) {
            format!("{of}, {of_least:.0e} of the least of them")
        } else {
            of.into()
        };
        (share > WARNED || of_least > WARNED).then(|| rounding_warning(share, &least))
    }
}

impl Reference {
    fn words(&self) -> &'static str {
        match self {
            Reference::Loads(_) => "loads",
            Reference::KnownPosition { .. } => "size of the structure, which nothing moves",
        }
    }
}

fn rounding_warning(share: f64, of: &str) -> String {
    format!(
        "rounding errors of the elastic forces may be as much as {share:.0e} of the {of}: the structure is so stiff, or so slender, \
         that few digits are left"
    )
}
