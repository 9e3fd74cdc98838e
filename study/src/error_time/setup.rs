//! Setup of one run of the study: scene, element, mesh, method and step.

use super::benchmark::Benchmark;
use super::samples::SUPPORT;
use super::technique::{Refinement, Technique};
use crate::error::Result;
use crate::scene::{Change, point_probe};
use ancf::model::{Element, Method, Output, Probe, Quantity, Scene};
use ancf::run::run;

/// Resolution in time, by which a method is made more or less accurate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    /// Equal steps in an interval.
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
    /// Positions at the ends of the intervals; this is timed.
    Position,
    /// Positions at every instant of the errors; velocities and reactions where they converge.
    Instants,
    /// The same at every step, and energies.
    Steps,
}

/// Parts of an interval at whose ends steps of a method's own choice end.
const LANDINGS: usize = 10;

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
        let mut scene = benchmark.meshed(element, elements)?;
        let step = scene.time.step;
        scene = scene.method(technique.method, step);
        scene = scene.newton(technique.newton_tolerance);
        scene.time.tolerance = resolution.tolerance().unwrap_or(scene.time.tolerance);
        let every = match (record, resolution) {
            (Record::Position, Resolution::Steps(_)) => benchmark.interval,
            (Record::Steps, Resolution::Steps(parts)) => benchmark.interval / parts as f64,
            // Steps of their own choice end at rows, so that these are always the same.
            (Record::Position | Record::Steps, _) => benchmark.interval / LANDINGS as f64,
            (Record::Instants, _) => benchmark.interval / benchmark.instants as f64,
        };
        match resolution {
            Resolution::LoadSteps(count) => scene.time.load_steps = count,
            Resolution::Steps(_) | Resolution::Tolerance(_) => {
                scene.time.step = resolution.step(benchmark.interval).unwrap_or(every);
                scene.output = Output { interval: Some(every), energy: record == Record::Steps, shapes: None };
            }
        }
        let probe = |mut probe: Probe| {
            probe.of = vec![Quantity::Position];
            if record != Record::Position && benchmark.smooth {
                probe.of.push(Quantity::Velocity);
            }
            probe
        };
        scene.probes.retain(|probe| probe.name == benchmark.probe);
        scene.probes = scene.probes.into_iter().map(probe).collect();
        if record != Record::Position && (benchmark.smooth || benchmark.is_static()) {
            let support = scene.supports.first().map(|support| support.point.clone());
            scene.probes.extend(
                support.map(|point| Probe { name: SUPPORT.into(), ..point_probe(&point, &[Quantity::Reaction]) }),
            );
        }
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
        Ok((parts * self.benchmark.rows * elements) as f64 * SECONDS)
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
        let scene = self.benchmark.model()?;
        let sum = |sum: [f64; 2], force: [f64; 2]| [sum[0] - force[0], sum[1] - force[1]];
        Ok(scene.forces.iter().map(|force| force.force).fold([0.0; 2], sum))
    }

    /// Whether it is statics.
    pub fn is_static(&self) -> bool {
        self.technique.method == Method::Static
    }
}
