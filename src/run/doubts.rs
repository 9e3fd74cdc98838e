//! What makes a result doubtful: found in the scene, in its motion or at its end.

use nalgebra::DVector;

use crate::error::{Error, Result};
use crate::integrators::State;
use crate::scene::{Method, Scene};
use crate::structure::Structure;

/// Explicit steps are much cheaper than a look at every element, and too short for one to collapse unseen between ten.
const EXPLICIT_STEPS: usize = 10;

/// Part of the loads from which rounding is warned of.
const WARNED: f64 = 1e-4;

/// Part of the displacement from which it is: an estimate for errors of one sign, which mostly have both.
const WARNED_IN_STATICS: f64 = 1e-3;

/// Rounding of this part of the loads is refused: step by step it acts like one.
const LOST: f64 = 0.05;

/// Rounding of this part of the displacement leaves no digit of it.
const NO_DIGIT: f64 = 0.5;

/// Watches the steps of a run.
pub struct Watch {
    /// Displacement that was looked at last.
    before: DVector<f64>,
    /// Steps between two looks, and until the next.
    every: usize,
    left: usize,
    /// Size of what moves the structure, N; `None` in statics, and where nothing is known to.
    loads: Option<f64>,
    /// Largest share of it that rounding has had.
    share: f64,
}

impl Watch {
    pub fn new(scene: &Scene, start: &DVector<f64>) -> Watch {
        let every = if scene.time.method.is_explicit() { EXPLICIT_STEPS } else { 1 };
        let loads = (scene.time.method != Method::Static).then(|| loads(scene)).filter(|loads| *loads > 0.0);
        Watch { before: start.clone(), every, left: every, loads, share: 0.0 }
    }

    /// Looks at the state after a step, where it is time to.
    ///
    /// # Errors
    /// [`Error::Collapsed`].
    pub fn step(&mut self, structure: &Structure, state: &State) -> Result<()> {
        self.left -= 1;
        if self.left == 0 { self.look(structure, state) } else { Ok(()) }
    }

    /// Looks at the state of an output row.
    ///
    /// # Errors
    /// [`Error::Collapsed`], [`Error::LostInRounding`].
    pub fn row(&mut self, structure: &Structure, state: &State) -> Result<()> {
        self.look(structure, state)?;
        let Some(loads) = self.loads else { return Ok(()) };
        self.share = self.share.max(structure.rounding_force(&state.u) / loads);
        if self.share > LOST {
            return Err(Error::LostInRounding { time: state.t, share: self.share, of: "loads" });
        }
        Ok(())
    }

    fn look(&mut self, structure: &Structure, state: &State) -> Result<()> {
        self.left = self.every;
        structure.check_collapse(&self.before, &state.u, state.t)?;
        self.before.copy_from(&state.u);
        Ok(())
    }

    /// Doubts about the whole run.
    ///
    /// # Errors
    /// [`Error::LostInRounding`].
    pub fn end(self, scene: &Scene, structure: &Structure, state: &State) -> Result<Vec<String>> {
        if scene.time.method != Method::Static {
            return Ok(rounding_warning(self.share, WARNED, "loads").into_iter().collect());
        }
        let share = structure.rounding_of_equilibrium(&state.u, state.t).unwrap_or(0.0);
        if share > NO_DIGIT {
            return Err(Error::LostInRounding { time: state.t, share, of: "displacement" });
        }
        Ok(stability_warning(structure, state)
            .into_iter()
            .chain(rounding_warning(share, WARNED_IN_STATICS, "displacement"))
            .collect())
    }
}

/// Size of what moves a structure, N: weights, forces, heat, and what bends the paths of an initial motion.
fn loads(scene: &Scene) -> f64 {
    let of_rods = scene.rods.iter().map(|rod| {
        let (material, section) = (scene.material(rod), scene.section(rod));
        let area = section.height * section.width;
        let ends = [&rod.from, &rod.to].map(|point| scene.points.get(point).copied().unwrap_or_default());
        let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
        let mass = material.rho * area * length;
        let weight = mass * scene.gravity[0].hypot(scene.gravity[1]);
        let hottest = scene
            .heat(rod)
            .map_or(0.0, |heat| heat.history.iter().map(|pair| (material.alpha * pair[1]).abs()).fold(0.0, f64::max));
        let fastest = scene
            .motion
            .as_ref()
            .map_or(0.0, |motion| ends.map(|end| motion.at(end)).iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max));
        weight + material.youngs_modulus * area * hottest + mass * fastest * fastest / length
    });
    let of_forces = scene.forces.iter().map(|force| {
        let factor = force.history.iter().flatten().map(|pair| pair[1].abs()).fold(0.0, f64::max);
        let factor = if force.history.is_some() { factor } else { 1.0 };
        force.force[0].hypot(force.force[1]) * factor
    });
    of_rods.chain(of_forces).sum()
}

fn rounding_warning(share: f64, warned: f64, of: &str) -> Option<String> {
    (share > warned).then(|| {
        format!(
            "rounding errors of the elastic forces may be as much as {share:.0e} of the {of}: the structure is so stiff, or so \
             slender, that few digits are left"
        )
    })
}

/// An equilibrium that would not stay: a column above its Euler load.
fn stability_warning(structure: &Structure, state: &State) -> Option<String> {
    let directions = structure.unstable_directions(&state.u, state.t).filter(|count| *count > 0)?;
    Some(format!(
        "the equilibrium found is unstable, in {directions} direction(s): the structure is pressed beyond its buckling load and \
         would bend out of this position; a small force across shows where to"
    ))
}
