//! Setup of one run of the study: scene, element, mesh, method and step.

use super::benchmark::Benchmark;
use super::technique::{Refinement, Technique};
use crate::error::Result;
use crate::scene::Change;
use ancf::model::{Element, Method, Output, Quantity, Scene};
use ancf::run::run;

/// Resolution in time, by which a method is made more or less accurate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    /// Equal steps in a sample interval.
    Steps(usize),
    /// Local error of a step, m.
    Tolerance(f64),
    /// Load steps.
    LoadSteps(usize),
}

impl Resolution {
    /// The next finer one.
    pub fn finer(self) -> Resolution {
        match self {
            Resolution::Steps(parts) => Resolution::Steps(2 * parts),
            Resolution::Tolerance(tolerance) => Resolution::Tolerance(0.1 * tolerance),
            Resolution::LoadSteps(count) => Resolution::LoadSteps(2 * count),
        }
    }

    /// Step, s, or part of the load.
    pub fn step(self, interval: f64) -> Option<f64> {
        match self {
            Resolution::Steps(parts) | Resolution::LoadSteps(parts) => Some(interval / parts as f64),
            Resolution::Tolerance(_) => None,
        }
    }

    /// Tolerance of the local error, m.
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Resolution::Tolerance(tolerance) => Some(tolerance),
            _ => None,
        }
    }
}

/// What a run records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Record {
    /// Positions only, which the error needs; this is timed.
    Position,
    /// Also velocities where they converge, and reactions in statics.
    All,
    /// Also energies.
    Energies,
}

/// Setup of one run.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Its scene.
    pub benchmark: &'static Benchmark,
    /// The element of all rods.
    pub element: Element,
    /// Elements of each rod.
    pub elements: usize,
    /// The method.
    pub technique: &'static Technique,
    /// Its step or tolerance.
    pub resolution: Resolution,
}

impl Setup {
    /// Its scene, ready to run.
    ///
    /// # Errors
    /// [`Error::Fixture`](crate::error::Error::Fixture) if there is no such built-in scene.
    pub fn scene(&self, record: Record) -> Result<Scene> {
        let Setup { benchmark, element, elements, technique, resolution } = *self;
        let mut scene = benchmark.built_in()?.meshed(element, elements);
        let step = scene.time.step;
        scene = scene.method(technique.method, step);
        scene = scene.newton(technique.newton_tolerance);
        scene.time.tolerance = resolution.tolerance().unwrap_or(scene.time.tolerance);
        match resolution {
            Resolution::LoadSteps(count) => scene.time.load_steps = count,
            Resolution::Steps(_) | Resolution::Tolerance(_) => {
                scene.time.step = resolution.step(benchmark.interval).unwrap_or(benchmark.interval);
                let energy = record == Record::Energies;
                scene.output = Output { interval: Some(benchmark.interval), energy, shapes: None };
            }
        }
        scene.probes.retain_mut(|probe| {
            if record != Record::Position && benchmark.is_static() && probe.of == [Quantity::Reaction] {
                return true;
            }
            probe.of = vec![Quantity::Position];
            if record != Record::Position && benchmark.smooth {
                probe.of.push(Quantity::Velocity);
            }
            probe.name == benchmark.probe
        });
        Ok(scene)
    }

    /// The first resolution on this mesh. An explicit method starts at its largest stable step that divides the interval, as a shorter one
    /// costs more.
    ///
    /// # Errors
    /// Those of [`Setup::scene`].
    pub fn first_resolution(&self) -> Result<Resolution> {
        match self.technique.refinement {
            Refinement::Tolerance(first) => Ok(Resolution::Tolerance(first)),
            Refinement::LoadSteps => Ok(Resolution::LoadSteps(self.benchmark.coarsest)),
            Refinement::Steps if self.technique.explicit => Ok(Resolution::Steps(self.stable_parts()?)),
            Refinement::Steps => Ok(Resolution::Steps(self.benchmark.coarsest)),
        }
    }

    /// Rough lower bound of an explicit run's time, s: a step for each half of the shortest period, and a force of each element. Zero for
    /// implicit methods.
    pub fn explicit_seconds(&self) -> Result<f64> {
        /// Time for the force of an element and its part of a solution, s.
        const SECONDS: f64 = 2e-7;
        if !self.technique.explicit {
            return Ok(0.0);
        }
        let verlet = Technique::of(Method::Explicit).unwrap_or(self.technique);
        let parts = Setup { technique: verlet, ..*self }.stable_parts()?;
        let elements: usize = self.scene(Record::Position)?.rods.iter().map(|rod| rod.elements).sum();
        Ok((parts * self.benchmark.samples * elements) as f64 * SECONDS)
    }

    /// The least number of stable explicit steps in an interval. The method reports its limit when it refuses a step that is far too long.
    fn stable_parts(&self) -> Result<usize> {
        let mut scene = Setup { resolution: Resolution::Steps(1), ..*self }.scene(Record::Position)?;
        scene.time.end = scene.time.step;
        match run(&scene) {
            Err(ancf::error::Error::StepTooLarge { step, largest, .. }) => Ok((step / largest).ceil() as usize),
            Err(error) => Err(error.into()),
            Ok(_) => Ok(1),
        }
    }

    /// The reaction of the support in statics: minus the sum of the loads.
    pub fn exact_reaction(&self) -> Result<[f64; 2]> {
        let scene = self.benchmark.built_in()?;
        let sum = |sum: [f64; 2], force: [f64; 2]| [sum[0] - force[0], sum[1] - force[1]];
        Ok(scene.forces.iter().map(|force| force.force).fold([0.0; 2], sum))
    }

    /// Whether it is statics.
    pub fn is_static(&self) -> bool {
        self.technique.method == Method::Static
    }
}
