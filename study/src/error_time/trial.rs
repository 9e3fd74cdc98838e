//! One run of the study: a scene with its element, mesh, method and step.

use super::case::Case;
use super::technique::{Drive, Technique};
use crate::error::Result;
use ancf::model::{Element, Method, Output, Quantity, Scene};
use ancf::run::run;

/// How accurate a method is told to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// Equal steps in a sample interval.
    Steps(usize),
    /// Local error of a step, m.
    Tolerance(f64),
    /// Load steps.
    LoadSteps(usize),
}

impl Setting {
    /// The next more accurate one.
    pub fn finer(self) -> Setting {
        match self {
            Setting::Steps(parts) => Setting::Steps(2 * parts),
            Setting::Tolerance(tolerance) => Setting::Tolerance(0.1 * tolerance),
            Setting::LoadSteps(count) => Setting::LoadSteps(2 * count),
        }
    }

    /// The step, s, or the part of the load.
    pub fn step(self, interval: f64) -> Option<f64> {
        match self {
            Setting::Steps(parts) | Setting::LoadSteps(parts) => Some(interval / parts as f64),
            Setting::Tolerance(_) => None,
        }
    }

    /// The local error of a step, m.
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Setting::Tolerance(tolerance) => Some(tolerance),
            _ => None,
        }
    }
}

/// What a run records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Record {
    /// Positions only: what the error needs, and what is timed.
    Position,
    /// Velocities where they converge, and reactions in statics, too.
    All,
    /// The energies as well.
    Energies,
}

/// One run of the study.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// Its scene.
    pub case: &'static Case,
    /// The element of all rods.
    pub element: Element,
    /// Elements of each rod.
    pub elements: usize,
    /// The method.
    pub technique: &'static Technique,
    /// Its step or tolerance.
    pub setting: Setting,
}

impl Trial {
    /// Its scene, ready to run.
    ///
    /// # Errors
    /// [`Error::Fixture`] where the built-in scene does not have what the study asks for.
    pub fn scene(&self, record: Record) -> Result<Scene> {
        let Trial { case, element, elements, technique, setting } = *self;
        let mut scene = case.built_in()?;
        for rod in &mut scene.rods {
            (rod.element, rod.elements) = (element, elements);
        }
        (scene.time.method, scene.time.newton_tolerance) = (technique.method, technique.newton_tolerance);
        scene.time.tolerance = setting.tolerance().unwrap_or(scene.time.tolerance);
        match setting {
            Setting::LoadSteps(count) => scene.time.load_steps = count,
            Setting::Steps(_) | Setting::Tolerance(_) => {
                scene.time.step = setting.step(case.interval).unwrap_or(case.interval);
                let energy = record == Record::Energies;
                scene.output = Output { interval: Some(case.interval), energy };
            }
        }
        scene.probes.retain_mut(|probe| {
            if record != Record::Position && case.is_static() && probe.of == [Quantity::Reaction] {
                return true;
            }
            probe.of = vec![Quantity::Position];
            if record != Record::Position && case.smooth {
                probe.of.push(Quantity::Velocity);
            }
            probe.name == case.probe
        });
        Ok(scene)
    }

    /// Where a method begins on this mesh: an explicit one at its largest step that divides the interval, as one below the
    /// limit costs no less and is no more accurate.
    ///
    /// # Errors
    /// Those of [`Trial::scene`].
    pub fn first_setting(&self) -> Result<Setting> {
        match self.technique.drive {
            Drive::Tolerances(first) => Ok(Setting::Tolerance(first)),
            Drive::LoadSteps => Ok(Setting::LoadSteps(self.case.coarsest)),
            Drive::Steps if self.technique.explicit => Ok(Setting::Steps(self.stable_parts()?)),
            Drive::Steps => Ok(Setting::Steps(self.case.coarsest)),
        }
    }

    /// What an explicit run takes at least, roughly, s: a step for each half of the shortest period, and a force of each element.
    /// Zero for implicit methods.
    pub fn explicit_seconds(&self) -> Result<f64> {
        /// Time for an element's force and its part of a solution, s.
        const SECONDS: f64 = 2e-7;
        if !self.technique.explicit {
            return Ok(0.0);
        }
        let verlet = Technique::of(Method::Explicit).unwrap_or(self.technique);
        let parts = Trial { technique: verlet, ..*self }.stable_parts()?;
        let elements: usize = self.scene(Record::Position)?.rods.iter().map(|rod| rod.elements).sum();
        Ok((parts * self.case.samples * elements) as f64 * SECONDS)
    }

    /// The least number of stable explicit steps in an interval. The method itself knows the limit, and tells it when it
    /// refuses a step that is far too long.
    fn stable_parts(&self) -> Result<usize> {
        let mut scene = Trial { setting: Setting::Steps(1), ..*self }.scene(Record::Position)?;
        scene.time.end = scene.time.step;
        match run(&scene) {
            Err(ancf::error::Error::StepTooLarge { step, largest, .. }) => Ok((step / largest).ceil() as usize),
            Err(error) => Err(error.into()),
            Ok(_) => Ok(1),
        }
    }

    /// The reaction of the support, which statics knows exactly: what the loads are, the other way.
    pub fn exact_reaction(&self) -> Result<[f64; 2]> {
        let scene = self.case.built_in()?;
        let sum = |sum: [f64; 2], force: [f64; 2]| [sum[0] - force[0], sum[1] - force[1]];
        Ok(scene.forces.iter().map(|force| force.force).fold([0.0; 2], sum))
    }

    /// Whether it stands still.
    pub fn is_static(&self) -> bool {
        self.technique.method == Method::Static
    }
}
