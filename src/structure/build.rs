//! Builds a structure from a model: nodes, numbering, loads, initial state.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{DVector, Vector2};

use super::constraints::rows;
use super::deviation::Deviation;
use super::memory::check_memory;
use super::point::{Node, Point};
use super::rod::Rod;
use super::uniform_elements::stretched;
use super::unknown_kind::UnknownKind;
use super::unknowns::{Numbering, condensed, with_multipliers};
use super::{Structure, mobility};
use crate::elements::Meaning;
use crate::error::{Error, Result};
use crate::lanes::Path;
use crate::model::plan::Plan;
use crate::model::{Constraints, Method, Model, Motion, Scene, Start, times_of};

impl Structure {
    /// Builds the structure of a model.
    ///
    /// # Errors
    /// [`Error::TooLarge`] where the matrices exceed the memory limit; [`Error::Drifts`] for statics of a mechanism.
    pub fn new<M>(model: M) -> Result<Structure>
    where
        M: TryInto<Model>,
        Error: From<M::Error>,
    {
        let model = model.try_into()?;
        Structure::of(&model, &Plan::of(model.scene()))
    }

    /// Builds the structure of a model with a given plan, which may compute more than the model needs.
    ///
    /// # Errors
    /// Those of [`new`](Structure::new).
    pub fn planned<M>(model: M, plan: &Plan) -> Result<Structure>
    where
        M: TryInto<Model>,
        Error: From<M::Error>,
    {
        Structure::of(&model.try_into()?, plan)
    }

    /// Builds the structure of a model with a given plan and the instructions that it is to be computed with.
    ///
    /// # Errors
    /// Those of [`new`](Structure::new).
    pub fn planned_on<M>(model: M, plan: &Plan, path: Path) -> Result<Structure>
    where
        M: TryInto<Model>,
        Error: From<M::Error>,
    {
        Structure::on_path(&model.try_into()?, plan, path)
    }

    /// Builds the structure of a checked model. An imperfection needs the straight structure first.
    pub(crate) fn of(model: &Model, plan: &Plan) -> Result<Structure> {
        Structure::on_path(model, plan, Path::chosen())
    }

    fn on_path(model: &Model, plan: &Plan, path: Path) -> Result<Structure> {
        let scene = model.scene();
        let Some(imperfection) = &scene.imperfection else { return Structure::assembled(scene, plan, path, None) };
        // With multipliers a rod by itself is free, and its stiffness singular: no modes can be computed.
        let condensed = Scene { constraints: Constraints::Condensed, ..scene.clone() };
        let deviation = Structure::assembled(&condensed, plan, path, None)?.deviation(scene, imperfection)?;
        Structure::assembled(scene, plan, path, Some(&deviation))
    }

    /// Number of independent motions of a model's structure without strain, to first order: rigid ones and those of mechanisms.
    ///
    /// # Errors
    /// [`Error::TooLarge`] where too many rods meet for the memory.
    pub(crate) fn degrees_of_freedom(model: &Model) -> Result<usize> {
        let (scene, plan) = (model.scene(), Plan::of(model.scene()));
        let rods: Vec<Rod> = scene.rods.iter().map(|rod| Rod::new(scene, rod, &plan, Path::chosen())).collect();
        mobility::degrees_of_freedom(scene, &points(scene, &rods), &rods)
    }

    /// Structure that starts in a deviated shape, free of stress there.
    fn assembled(scene: &Scene, plan: &Plan, path: Path, deviation: Option<&Deviation>) -> Result<Structure> {
        let mut rods: Vec<Rod> = scene.rods.iter().map(|rod| Rod::new(scene, rod, plan, path)).collect();
        let points = points(scene, &rods);
        if scene.time.method == Method::Static {
            mobility::check(scene, &points, &rods)?;
        }
        if let Some(mode) = scene.imperfection.as_ref().and_then(|imperfection| imperfection.mode) {
            mobility::check(scene, &points, &rods).map_err(|error| no_vibration(error, mode))?;
        }
        let numbering = match scene.constraints {
            Constraints::Condensed => condensed(scene, &points, &mut rods),
            Constraints::Multipliers => with_multipliers(rows(scene, &points), &mut rods),
        };
        let Numbering { layout, kinds, rows } = numbering;
        rods.iter_mut().for_each(|rod| rod.mesh.number(&rod.chain));
        let size = layout.size();
        let mut start = DVector::zeros(size);
        if let Some(deviation) = deviation {
            deviation.set(&rods, &mut start);
            rods.iter_mut().for_each(|rod| rod.mesh.deviate(&start));
        }
        let eliminated: usize = rods.iter().map(|rod| rod.elements.saturating_mul(rod.mesh.bytes_each())).sum();
        check_memory(size, layout.border_band, layout.bytes().saturating_add(eliminated))?;
        let mut structure = Structure {
            plan: *plan,
            path,
            shortest_element: rods.iter().map(|rod| rod.along.norm()).fold(f64::INFINITY, f64::min),
            rounding_scale: rods.iter().map(|rod| rod.mesh.rounding_scale()).fold(0.0, f64::max),
            force_weights: DVector::from_iterator(kinds.len(), kinds.iter().map(UnknownKind::weight)),
            motion_factors: motion_factors(&rods, &kinds),
            rods: rods.into(),
            kinds,
            points: points.into_iter().collect(),
            rows,
            layout: Arc::new(layout),
            gravity: DVector::zeros(size),
            forces: scene.forces.clone(),
            force_places: Vec::new(),
            start,
            start_velocity: DVector::zeros(size),
            is_static: scene.time.method == Method::Static,
            times: times(scene),
            unit_forces: DVector::zeros(size),
        };
        structure.rods.iter().for_each(|rod| rod.mesh.add_gravity(&mut structure.gravity));
        let places = scene.forces.iter().map(|force| Ok(structure.point_dofs(structure.point(&force.point)?)));
        structure.force_places = places.collect::<Result<_>>()?;
        structure.unit_forces = structure.unit_forces();
        if scene.rods.iter().any(|rod| scene.heat(rod).is_some_and(|heat| heat.start == Start::Relaxed)) {
            structure.start = structure.stress_free_start(scene);
        }
        if let Some(motion) = &scene.motion {
            structure.start_velocity = structure.rigid_velocities(scene, motion);
        }
        Ok(structure)
    }

    /// Force of a unit strain on each unknown, summed over the elements that meet there: (λ + 2μ)A, EA or EA + 12EI/l²
    /// for a position, times l for a slope.
    fn unit_forces(&self) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        for rod in &*self.rods {
            let (force, l) = (rod.mesh.unit_force(), rod.along.norm());
            let vectors = (0..rod.elements).flat_map(|element| rod.vectors(element));
            for unknown in vectors.flat_map(|vector| vector.unknowns).flatten() {
                let slope = matches!(self.kinds[unknown], UnknownKind::Slope(_));
                sum[unknown] += if slope { force * l } else { force };
            }
        }
        sum
    }

    /// Displacement to the stress-free configuration at ΔT(0): a stretch in each heated direction, about the supported
    /// point (or the rod's first point).
    fn stress_free_start(&self, scene: &Scene) -> DVector<f64> {
        let mut u = DVector::zeros(self.size());
        let thermal = self.thermal_strains(0.0);
        for ((rod, data), eps_t) in scene.rods.iter().zip(&*self.rods).zip(thermal) {
            let about = scene.supports.first().map_or(&rod.from, |support| &support.point);
            let origin =
                Vector2::from(scene.points[&rod.from]) - Vector2::from(scene.position(about).unwrap_or_default());
            for (n, vector) in data.chain.iter().enumerate() {
                let value = stretched(data.nodal(n), data.mesh.stress_free(eps_t), origin, data.along);
                vector.set(&value, &mut u);
            }
        }
        u
    }
}

impl Structure {
    /// Velocities of the initial rigid motion.
    fn rigid_velocities(&self, scene: &Scene, motion: &Motion) -> DVector<f64> {
        let mut v = DVector::zeros(self.size());
        for (rod, data) in scene.rods.iter().zip(&*self.rods) {
            let t = data.along.normalize();
            for (n, vector) in data.chain.iter().enumerate() {
                let (meaning, place) = data.nodal(n);
                let moved = vector.get(&self.start);
                let velocity = match meaning {
                    Meaning::Position => {
                        motion.at((Vector2::from(scene.points[&rod.from]) + place * data.along + moved).into())
                    }
                    Meaning::SlopeX => motion.turned((t + moved).into()),
                    Meaning::SlopeY => motion.turned((Vector2::new(-t.y, t.x) + moved).into()),
                };
                vector.set(&velocity.into(), &mut v);
            }
        }
        v
    }
}

/// Refuses a mode of a mechanism, which moves without a vibration.
fn no_vibration(error: Error, mode: usize) -> Error {
    let Error::Drifts { rods } = error else { return error };
    let allowed = format!(
        "`rod` in place of `mode`, or supports and pins that hold every rod: this structure can move without a strain (to first \
         order), rods {rods}, and vibrates about no place"
    );
    let (file, key, value) = ("scene".into(), "imperfection.mode".into(), mode.to_string());
    Error::Scene { file, key, value, allowed }
}

/// Factors of [`Structure::largest_change`], by unknown: those of the shortest element where several meet.
fn motion_factors(rods: &[Rod], kinds: &[UnknownKind]) -> DVector<f64> {
    let mut factors = DVector::zeros(kinds.len());
    for rod in rods {
        let l = rod.along.norm();
        for unknown in rod.chain.iter().flat_map(|vector| vector.unknowns).flatten() {
            let factor = match kinds[unknown] {
                UnknownKind::Position => 1.0 / l,
                UnknownKind::Slope(length) => f64::max(1.0, length / l),
                UnknownKind::Multiplier => 0.0,
            };
            factors[unknown] = f64::max(factors[unknown], factor);
        }
    }
    factors
}

/// Start, end, and the corners of all histories in between.
fn times(scene: &Scene) -> Vec<f64> {
    let of_rods = scene.rods.iter().filter_map(|rod| Some(scene.heat(rod)?.history.as_slice()));
    // In statics the time of a single pair has no meaning.
    let of_rods = of_rods.filter(|history| history.len() > 1 || scene.time.method != Method::Static);
    let of_forces = scene.forces.iter().filter_map(|force| force.history.as_deref());
    times_of(of_rods.chain(of_forces), scene.time.end)
}

/// Named points, with the node of each rod that meets there.
fn points(scene: &Scene, rods: &[Rod]) -> BTreeMap<String, Point> {
    let mut points = BTreeMap::new();
    for (number, (rod, data)) in scene.rods.iter().zip(rods).enumerate() {
        let mut meet = |name: &String, initial: Option<[f64; 2]>, place: f64| {
            let new = || Point { initial: initial.unwrap_or_default(), nodes: Vec::new() };
            let node = data.node(place).map(|(position, slope)| Node { rod: number, position, slope });
            points.entry(name.clone()).or_insert_with(new).nodes.extend(node);
        };
        let elements = rod.elements as f64;
        meet(&rod.from, scene.points.get(&rod.from).copied(), 0.0);
        meet(&rod.to, scene.points.get(&rod.to).copied(), elements);
        if let Some(pivot) = &rod.pivot {
            // A node shared by two elements, or the middle node j of the middle element.
            meet(pivot, scene.middle(rod), elements / 2.0);
        }
    }
    points
}
