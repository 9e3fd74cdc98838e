//! From a scene to a structure: nodes, numbering, loads, the relaxed start.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{DVector, Vector2};

use super::constraints::rows;
use super::rod::{Rod, stress_free, stretched};
use super::unknowns::{Numbering, condensed, with_multipliers};
use super::{Kind, Node, Point, Structure, mobility};
use crate::equations::material;
use crate::error::{Error, Result};
use crate::scene::{Constraints, Method, Scene, Start};

/// More memory than this for one matrix, in bytes, is refused: a structure that needs it is not a few rods.
const MOST_BYTES: usize = 2 << 30;

impl Structure {
    /// Builds the structure of a (validated) scene.
    ///
    /// # Errors
    /// [`Error::TooLarge`] where the matrices would not fit into memory; [`Error::Drifts`] for statics of a structure
    /// that can move without a strain.
    pub fn new(scene: &Scene) -> Result<Structure> {
        let mut rods: Vec<Rod> = scene.rods.iter().map(|rod| Rod::new(scene, rod)).collect();
        let points = points(scene);
        if scene.time.method == Method::Static {
            mobility::check(scene, &points, &rods)?;
        }
        let numbering = match scene.constraints {
            Constraints::Condensed => condensed(scene, &points, &mut rods),
            Constraints::Multipliers => with_multipliers(rows(scene, &points), &mut rods),
        };
        let Numbering { layout, kinds, rows } = numbering;
        let size = layout.size();
        check_memory(size, layout.border_band, layout.bytes())?;
        let mut structure = Structure {
            shortest: rods.iter().map(|rod| rod.element.l).fold(f64::INFINITY, f64::min),
            rods,
            kinds,
            points,
            rows,
            layout: Arc::new(layout),
            gravity: DVector::zeros(size),
            forces: scene.forces.clone(),
            start: DVector::zeros(size),
            grows: scene.time.method == Method::Static,
            unit_forces: DVector::zeros(size),
        };
        structure.gravity = structure.assemble_vector(|rod| rod.gravity);
        structure.unit_forces = structure.unit_forces(scene);
        if scene.rods.iter().any(|rod| scene.heat(rod).is_some_and(|heat| heat.start == Start::Relaxed)) {
            structure.start = structure.relaxed(scene);
        }
        Ok(structure)
    }

    /// What the elements that meet at an unknown feel of a unit strain: (λ + 2μ)A on a position, times l on a slope.
    fn unit_forces(&self, scene: &Scene) -> DVector<f64> {
        let mut sum = DVector::zeros(self.size());
        for (rod, data) in scene.rods.iter().zip(&self.rods) {
            let (material, section) = (scene.material(rod), scene.section(rod));
            let (lambda, mu) = (
                material::lambda(material.youngs_modulus, material.nu),
                material::mu(material.youngs_modulus, material.nu),
            );
            let force = (lambda + 2.0 * mu) * section.height * section.width;
            for unknown in
                (0..rod.elements).flat_map(|element| data.vectors(element)).flat_map(|v| v.unknowns).flatten()
            {
                let slope = matches!(self.kinds[unknown], Kind::Slope(_));
                sum[unknown] += if slope { force * data.element.l } else { force };
            }
        }
        sum
    }

    /// Displacement from the initial to the stress-free configuration at ΔT(0): a stretch √(1 + 2ε) in each heated
    /// direction, about the supported point (or the beginning of the rod).
    fn relaxed(&self, scene: &Scene) -> DVector<f64> {
        let mut u = DVector::zeros(self.size());
        let thermal = self.thermal_strains(0.0);
        for ((rod, data), thermal) in scene.rods.iter().zip(&self.rods).zip(thermal) {
            let about = scene.supports.first().map_or(&rod.from, |support| &support.point);
            let about = Vector2::from(self.points[about].start);
            let from = Vector2::from(scene.points[&rod.from]);
            let direction = Vector2::from(scene.points[&rod.to]) - from;
            for element in 0..rod.elements {
                let origin = from - about + direction * (element as f64 / rod.elements as f64);
                let u_e = stretched(&data.element, stress_free(thermal), origin);
                for (n, vector) in data.vectors(element).iter().enumerate() {
                    vector.set(&u_e.fixed_rows::<2>(2 * n).into_owned(), &mut u);
                }
            }
        }
        u
    }
}

/// Refuses a matrix that would not fit into memory.
pub(super) fn check_memory(unknowns: usize, band: usize, bytes: usize) -> Result<()> {
    if bytes > MOST_BYTES {
        return Err(Error::TooLarge { unknowns, band, gigabytes: bytes as f64 / 1e9 });
    }
    Ok(())
}

/// The named points, with the node that each of the rods has there.
fn points(scene: &Scene) -> BTreeMap<String, Point> {
    let mut points = BTreeMap::new();
    for (number, rod) in scene.rods.iter().enumerate() {
        let last = 5 * rod.elements;
        let mut meet = |name: &String, start: Option<[f64; 2]>, position: usize, director: usize| {
            let new = || Point { start: start.unwrap_or_default(), nodes: Vec::new() };
            points.entry(name.clone()).or_insert_with(new).nodes.push(Node { rod: number, position, director });
        };
        let [from, to] = [&rod.from, &rod.to].map(|name| scene.points.get(name).copied());
        meet(&rod.from, from, 0, 1);
        meet(&rod.to, to, last, last + 1);
        if let Some(pivot) = &rod.pivot {
            let middle = 5 * (rod.elements / 2);
            match rod.elements % 2 {
                // The end node that two elements share, or the middle node j of the element in the middle.
                0 => meet(pivot, scene.middle(rod), middle, middle + 1),
                _ => meet(pivot, scene.middle(rod), middle + 2, middle + 4),
            }
        }
    }
    points
}
