//! The structure's terms of (23) against the oracle: two pairs of pinned rods, inclined, at different temperatures, on
//! sliding supports and clamped, disturbed and turned.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;

use ancf::integrators::{Counts, EquationOfMotion};
use ancf::internals::structure::Structure;
use ancf::model::{Constraints, Method, Model, Scene};
use common::system::{Terms, systems};
use nalgebra::{DMatrix, DVector, Vector2};

/// Assembled terms are met to this fraction of the largest of their kind: a force over all positions, a moment over all
/// slopes.
const TOLERANCE: f64 = 1e-13;

/// A case's structure with its multipliers, and where the oracle's coordinates and rows are among its unknowns.
struct Ours<'a> {
    terms: Terms<'a>,
    structure: Structure,
    coordinates: Vec<usize>,
    rows: Vec<usize>,
    /// Whether a coordinate is one of a position.
    position: Vec<bool>,
    q_0: Vec<f64>,
    t: f64,
}

impl Ours<'_> {
    fn of(case: &serde_json::Value) -> Ours<'_> {
        let terms = Terms::read(case);
        let scene = Model::parse(&case["scene"].to_string(), terms.id).unwrap().into_scene();
        assert_eq!(scene.constraints, Constraints::Multipliers);
        let structure = Structure::new(&scene).unwrap();
        let (mut coordinates, mut position, mut q_0) = (Vec::new(), Vec::new(), Vec::new());
        for rod in &scene.rods {
            let [from, to] = [&rod.from, &rod.to].map(|point| Vector2::from(scene.points[point]));
            let t = (to - from).normalize();
            let n = Vector2::new(-t.y, t.x);
            for vector in 0..5 * rod.elements + 2 {
                let along = (vector / 5) as f64 + if vector % 5 == 2 { 0.5 } else { 0.0 };
                let initial = match vector % 5 {
                    0 | 2 => from + (to - from) * (along / rod.elements as f64),
                    3 => t,
                    _ => n,
                };
                for component in 0..2 {
                    coordinates.push(structure.unknown(&rod.name, vector, component).unwrap());
                    position.push(matches!(vector % 5, 0 | 2));
                    q_0.push(initial[component]);
                }
            }
        }
        let rows: Vec<usize> = (0..).map_while(|row| structure.multiplier(row)).collect();
        assert_eq!(coordinates.len() + rows.len(), structure.size(), "{}: unknowns left over", terms.id);
        let t = case["state"]["t"].as_f64().unwrap();
        Ours { terms, structure, coordinates, rows, position, q_0, t }
    }

    /// Displacement of the oracle's state.
    fn u(&self) -> DVector<f64> {
        let q = self.terms.case["state"]["q"].as_array().unwrap();
        let mut u = DVector::zeros(self.structure.size());
        for ((unknown, q), q_0) in self.coordinates.iter().zip(q).zip(&self.q_0) {
            u[*unknown] = q.as_f64().unwrap() - q_0;
        }
        u
    }

    fn coordinates_of(&self, vector: &DVector<f64>) -> Vec<f64> {
        self.coordinates.iter().map(|&unknown| vector[unknown]).collect()
    }

    fn rows_of(&self, vector: &DVector<f64>) -> Vec<f64> {
        self.rows.iter().map(|&unknown| vector[unknown]).collect()
    }

    fn elastic(&self) -> DVector<f64> {
        let mut force = DVector::zeros(self.structure.size());
        self.structure.force(&self.u(), &self.structure.thermal_strains(self.t), &mut force);
        force
    }

    /// Entry by entry, the largest value of the same kind.
    fn kind_scale(&self, values: &[f64]) -> Vec<f64> {
        let largest = |position: bool| {
            let its = values.iter().zip(&self.position).filter(|(_, p)| **p == position);
            its.map(|(value, _)| value.abs()).fold(f64::MIN_POSITIVE, f64::max)
        };
        self.position.iter().map(|&position| largest(position)).collect()
    }
}

#[track_caller]
fn assert_close(what: &str, actual: &[f64], expected: &[f64], scale: &[f64]) {
    let ratio = common::worst_ratio(actual, expected, scale);
    assert!(common::within(TOLERANCE, actual, expected, scale), "{what}: off by {ratio:.1e}");
}

fn every_case(check: impl Fn(&Ours)) {
    let systems = systems();
    let cases = systems["cases"].as_array().unwrap();
    let with_scene: Vec<_> = cases.iter().filter(|case| !case["scene"].is_null()).collect();
    assert!(with_scene.len() >= 4, "only {} structures", with_scene.len());
    with_scene.into_iter().for_each(|case| check(&Ours::of(case)));
}

#[test]
fn the_mass_matrix() {
    every_case(|ours| {
        let (m, n) = (ours.structure.mass().dense(), ours.coordinates.len());
        let picked = DMatrix::from_fn(n, n, |i, j| m[(ours.coordinates[j], ours.coordinates[i])]);
        let expected = ours.terms.value("23.m");
        let diagonal: Vec<f64> = (0..n).map(|i| expected[i * n + i].sqrt()).collect();
        let scale: Vec<f64> = diagonal.iter().flat_map(|a| diagonal.iter().map(move |b| a * b)).collect();
        assert_close(ours.terms.id, picked.as_slice(), &expected, &scale);
    });
}

#[test]
fn elastic_forces_of_rods_at_different_temperatures() {
    every_case(|ours| {
        let expected = ours.terms.value("23.Q_e");
        assert_close(ours.terms.id, &ours.coordinates_of(&ours.elastic()), &expected, &ours.kind_scale(&expected));
    });
}

#[test]
fn weight_and_point_forces() {
    every_case(|ours| {
        let expected = ours.terms.value("23.f");
        let load = ours.structure.load(ours.t);
        // On slopes the weight of a straight element cancels to nothing.
        let scale = ours.kind_scale(&expected).into_iter().fold(0.0, f64::max);
        assert_close(ours.terms.id, &ours.coordinates_of(&load), &expected, &vec![scale; expected.len()]);
    });
}

#[test]
fn constraints_and_their_derivative() {
    every_case(|ours| {
        let mut Phi = DVector::zeros(ours.structure.size());
        ours.structure.set_constraint_rows(&ours.u(), &mut Phi);
        let ones = vec![1.0; ours.rows.len()];
        assert_close(ours.terms.id, &ours.rows_of(&Phi), &ours.terms.value("23.Phi"), &ones);

        // Multipliers have no mass: what stands in their rows and columns are the constraints.
        let mut matrix = ours.structure.mass();
        ours.structure.add_constraints(1.0, &mut matrix);
        let dense = matrix.dense();
        let below = ours.rows.iter().flat_map(|&i| ours.coordinates.iter().map(move |&j| (i, j)));
        let (Phi_q, Phi_q_transposed): (Vec<f64>, Vec<f64>) =
            below.map(|(i, j)| (dense[(i, j)], dense[(j, i)])).unzip();
        let expected = ours.terms.value("23.Phi_q");
        let ones = vec![1.0; expected.len()];
        assert_close(ours.terms.id, &Phi_q, &expected, &ones);
        assert_close(ours.terms.id, &Phi_q_transposed, &expected, &ones);
    });
}

#[test]
fn the_residual_with_constraint_forces() {
    every_case(|ours| {
        let mut given = DVector::zeros(ours.structure.size());
        let place = |numbers: &DVector<f64>, places: &[usize], vector: &mut DVector<f64>| {
            places.iter().zip(numbers).for_each(|(&unknown, value)| vector[unknown] = *value);
        };
        place(&ours.terms.state.q_ddot, &ours.coordinates, &mut given);
        let mut residual = ours.structure.inertia(&given) + ours.elastic() - ours.structure.load(ours.t);
        place(&ours.terms.state.lambda, &ours.rows, &mut given);
        ours.structure.add_constraint_forces(&given, &mut residual);
        let expected = ours.terms.value("23.residual");
        assert_close(ours.terms.id, &ours.coordinates_of(&residual), &expected, &ours.kind_scale(&expected));
    });
}

/// Where a motion begins: accelerations and multipliers by block elimination, equilibrated.
#[test]
fn consistent_accelerations_and_multipliers() {
    every_case(|ours| {
        let mut counts = Counts::default();
        let mut motion = EquationOfMotion::new(&ours.structure, &mut counts).unwrap();
        motion.accelerate(&ours.structure, &ours.u(), ours.t, &mut counts);
        let mut a = motion.a;
        let scale = ours.terms.solution_scale();
        let n = ours.coordinates.len();
        let rows = ours.rows_of(&a);
        assert_close(ours.terms.id, &rows, &ours.terms.value("23.lambda"), &scale.as_slice()[n..]);
        ours.structure.take_multipliers(&mut a);
        let expected = ours.terms.value("23.acceleration");
        assert_close(ours.terms.id, &ours.coordinates_of(&a), &expected, &scale.as_slice()[..n]);
    });
}

/// Shared coordinates are the same structure: at a state that the constraints allow, the same accelerations.
#[test]
fn condensed_accelerations_are_those_with_multipliers() {
    every_case(|ours| {
        let mut scene = Model::parse(&ours.terms.case["scene"].to_string(), ours.terms.id).unwrap().into_scene();
        let accelerations = |scene: &Scene| {
            let structure = Structure::new(scene).unwrap();
            let mut counts = Counts::default();
            let mut motion = EquationOfMotion::new(&structure, &mut counts).unwrap();
            motion.accelerate(&structure, &DVector::zeros(structure.size()), ours.t, &mut counts);
            let a = motion.a;
            let names = scene.rods.iter().flat_map(|rod| [Some(&rod.from), Some(&rod.to), rod.pivot.as_ref()]);
            names
                .flatten()
                .flat_map(|name| structure.at_point(structure.point(name).unwrap(), &a))
                .collect::<Vec<f64>>()
        };
        let with_multipliers = accelerations(&scene);
        (scene.constraints, scene.time.method) = (Constraints::Condensed, Method::EnergyMomentum);
        let condensed = accelerations(&scene);
        let largest = condensed.iter().fold(0.0, |m: f64, a| m.max(a.abs()));
        assert_close(ours.terms.id, &condensed, &with_multipliers, &vec![1e2 * largest; condensed.len()]);
    });
}
