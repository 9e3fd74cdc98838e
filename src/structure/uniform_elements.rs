//! Elements of a rod, all equal. Their unknowns are read from the rod's chain of nodal vectors ([`NodeDofs`]) once,
//! when they are numbered.

use std::fmt::Debug;

use nalgebra::{Complex, DVector, SMatrix, SVector, Vector2};

use super::element_dofs::ElementDofs;
use super::node_dofs::NodeDofs;
use super::rod_elements::{ElementMatrix, RodElements, RodInstant};
use super::row::Row;
use super::sweep::{Energy, Forces, HeatingWork, IsWhole, MeanForces, Momenta, Sweep};
use crate::elements::{Beam, Deviation, Ends, NodalVector, SectionState, ThermalStrain};
use crate::lanes::Path;
use crate::linear::{BlockMut, Chain, FrontalChain, NO_UNKNOWN};

/// Equal elements of one type with `N` nodal coordinates each.
#[derive(Clone, Debug)]
pub(super) struct UniformElements<B, const N: usize> {
    pub beam: B,
    /// Vector from node i to node k of an element, m.
    pub along: Vector2<f64>,
    pub mass: SMatrix<f64, N, N>,
    pub gravity: SVector<f64, N>,
    pub unit_force: f64,
    /// Unknowns of the elements; empty until they are numbered.
    pub places: Vec<ElementDofs<N>>,
    /// The same, of four elements at a time.
    pub rows: Vec<Row<N>>,
    /// Instructions that they are computed with.
    pub path: Path,
    /// Stress-free deviations of the elements; empty for a straight rod.
    pub deviations: Vec<Deviation<N>>,
}

impl<B: Beam<N>, const N: usize> UniformElements<B, N> {
    /// Number of nodal vectors from an element to the next.
    const STRIDE: usize = N / 2 - 2;

    /// Displacement of an element under stretches minus 1, node i at rest.
    fn stretched(&self, stretch: [f64; 2]) -> SVector<f64, N> {
        let mut u = SVector::<f64, N>::zeros();
        for (n, &vector) in B::VECTORS.iter().enumerate() {
            u.fixed_rows_mut::<2>(2 * n).copy_from(&stretched(vector, stretch, Vector2::zeros(), self.along));
        }
        u
    }

    /// Matrix of an element, by columns.
    fn element_matrix(&self, element: usize, matrix: &ElementMatrix, columns: &mut [f64]) {
        let place = &self.places[element];
        let mut put = |stiffness: f64, tangent: &SMatrix<f64, N, N>, mass: f64| {
            for ((entry, tangent), own) in columns.iter_mut().zip(tangent.as_slice()).zip(self.mass.as_slice()) {
                *entry = tangent * stiffness + own * mass;
            }
        };
        match *matrix {
            ElementMatrix::Mass => columns.copy_from_slice(self.mass.as_slice()),
            ElementMatrix::Tangent { u, eps_t, stiffness, mass } => {
                put(stiffness, &self.beam.tangent(&place.gather(u), eps_t), mass);
            }
            ElementMatrix::Stretched { stretch, eps_t, stiffness, mass } => {
                put(stiffness, &self.beam.tangent(&self.stretched(stretch), eps_t), mass);
            }
            ElementMatrix::Mixed { before, u, eps_t } => {
                put(1.0, &self.beam.mixed_tangent(&place.gather(before), &place.gather(u), eps_t), 0.0);
            }
            ElementMatrix::Mean { ref ends, mass } => {
                put(1.0, &place.over(ends, |ends| self.beam.mean_tangent(ends)), mass);
            }
        }
        if let Some(deviation) = self.deviations.get(element) {
            let less = deviation.stiffness() * matrix.share_of_stress();
            columns.iter_mut().zip(less.as_slice()).for_each(|(entry, less)| *entry -= less);
        }
        if !place.turns.is_empty() {
            let turned = place.turned(SMatrix::from_column_slice(columns));
            columns.copy_from_slice(turned.as_slice());
        }
    }

    fn sweep(&self) -> Sweep<'_, B, N> {
        Sweep { beam: &self.beam, rows: &self.rows }
    }

    fn unknowns(&self) -> impl Iterator<Item = [u32; N]> {
        self.places.iter().map(|place| place.unknowns)
    }
}

impl<B: Beam<N> + Debug + Send + Sync, const N: usize> RodElements for UniformElements<B, N> {
    fn vectors(&self) -> &'static [NodalVector] {
        B::VECTORS
    }

    fn unit_force(&self) -> f64 {
        self.unit_force
    }

    fn rounding_scale(&self) -> f64 {
        B::ROUNDING_SCALE
    }

    fn stress_free(&self, eps_t: ThermalStrain) -> [f64; 2] {
        B::stress_free(eps_t)
    }

    fn number(&mut self, chain: &[NodeDofs]) {
        self.places = chain.windows(N / 2).step_by(Self::STRIDE).map(ElementDofs::of).collect();
        self.rows = Row::of(chain);
    }

    fn deviate(&mut self, u: &DVector<f64>) {
        self.deviations = self.places.iter().filter_map(|place| self.beam.deviation(&place.gather(u))).collect();
    }

    fn chain(&self, border: usize) -> Box<dyn Chain<f64>> {
        Box::new(FrontalChain::<f64, N>::new(self.unknowns(), border))
    }

    fn complex_chain(&self, border: usize) -> Box<dyn Chain<Complex<f64>>> {
        Box::new(FrontalChain::<Complex<f64>, N>::new(self.unknowns(), border))
    }

    fn bytes_each(&self) -> usize {
        FrontalChain::<f64, N>::bytes_each()
    }

    fn axis(&self, place: f64, u: &DVector<f64>) -> Vector2<f64> {
        let element = (place.floor() as usize).min(self.places.len() - 1);
        B::axis(place - element as f64, &self.places[element].gather(u), self.along.norm())
    }

    fn section_state(&self, place: f64, u: &DVector<f64>) -> SectionState {
        // A fraction of the length is a place between two elements but for rounding.
        let place = if (place - place.round()).abs() < 1e-9 { place.round() } else { place };
        let element = (place.floor() as usize).min(self.places.len() - 1);
        let of = |element: usize| self.beam.section_state(place - element as f64, &self.places[element].gather(u));
        let own = of(element);
        if element > 0 && place == element as f64 { own.mean(of(element - 1)) } else { own }
    }

    fn mass(&self, row: usize, column: usize) -> f64 {
        self.mass[(2 * row, 2 * column)]
    }

    fn add_inertia(&self, a: &DVector<f64>, sum: &mut DVector<f64>) {
        let (a, sum) = (a.as_slice(), sum.as_mut_slice());
        self.path.run(Momenta { sweep: self.sweep(), mass: &self.mass, a, sum });
    }

    fn add_gravity(&self, sum: &mut DVector<f64>) {
        for place in &self.places {
            place.scatter(self.gravity, sum);
        }
    }

    fn add_force(&self, u: &DVector<f64>, eps_t: ThermalStrain, factor: f64, sum: &mut DVector<f64>) {
        let sweep = self.sweep();
        self.path.run(Forces { sweep, u: u.as_slice(), eps_T: eps_t, factor, sum: sum.as_mut_slice() });
        for (place, deviation) in self.places.iter().zip(&self.deviations) {
            place.scatter(factor * deviation.force(&place.gather(u)), sum);
        }
    }

    fn add_mean_force(&self, ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>) {
        self.path.run(MeanForces { sweep: self.sweep(), ends: slices(ends), sum: sum.as_mut_slice() });
        for (place, deviation) in self.places.iter().zip(&self.deviations) {
            let middle = 0.5 * (place.gather(ends.u_0) + place.gather(ends.u_1));
            place.scatter(deviation.force(&middle), sum);
        }
    }

    fn matrix(&self, element: usize, matrix: &ElementMatrix, columns: &mut [f64]) {
        self.element_matrix(element, matrix, columns);
    }

    fn add_matrix(&self, matrix: &ElementMatrix, block: &mut BlockMut) {
        for (element, place) in self.places.iter().enumerate() {
            let unknowns = place.unknowns.map(|unknown| (unknown != NO_UNKNOWN).then_some(unknown as usize));
            let mut dense = SMatrix::<f64, N, N>::zeros();
            self.element_matrix(element, matrix, dense.as_mut_slice());
            block.add_dense(unknowns, &dense);
        }
    }

    fn force_at(&self, vector: usize, now: &RodInstant) -> Vector2<f64> {
        let touching = self.places.iter().enumerate().filter_map(|(element, place)| {
            let own = vector.checked_sub(element * Self::STRIDE).filter(|own| *own < N / 2)?;
            let (u, a) = (place.gather(now.u), place.gather(now.a));
            let mut force = self.mass * a + self.beam.force(&u, now.eps_t) - now.weight * self.gravity;
            if let Some(deviation) = self.deviations.get(element) {
                force += deviation.force(&u);
            }
            Some(force.fixed_rows::<2>(2 * own).into_owned())
        });
        touching.sum()
    }

    fn collapsed(&self, before: &DVector<f64>, u: &DVector<f64>) -> Option<usize> {
        if self.path.run(IsWhole { sweep: self.sweep(), before: before.as_slice(), u: u.as_slice() }) {
            return None;
        }
        let min_det_j = |place: &ElementDofs<N>| self.beam.min_det_j(&place.gather(before), &place.gather(u));
        // A NaN is not over 0.
        self.places.iter().position(|place| min_det_j(place).partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater))
    }

    fn energy(&self, u: &DVector<f64>, eps_t: ThermalStrain) -> f64 {
        let straight = self.path.run(Energy { sweep: self.sweep(), u: u.as_slice(), eps_T: eps_t });
        let deviated = self.places.iter().zip(&self.deviations);
        straight + deviated.map(|(place, deviation)| deviation.energy(&place.gather(u), eps_t)).sum::<f64>()
    }

    fn heating_work(&self, ends: &Ends<DVector<f64>>) -> f64 {
        let straight = self.path.run(HeatingWork { sweep: self.sweep(), ends: slices(ends) });
        let change = [0, 1].map(|n| ends.thermal_1[n] - ends.thermal_0[n]);
        straight + self.deviations.iter().map(|deviation| deviation.heating_work(change)).sum::<f64>()
    }

    fn largest_square_frequency(&self, stretch: [f64; 2], eps_t: ThermalStrain) -> f64 {
        let size = |matrix: &SMatrix<f64, N, N>| nalgebra::DMatrix::from_column_slice(N, N, matrix.as_slice());
        let (stiffness, mass) = (size(&self.beam.tangent(&self.stretched(stretch), eps_t)), size(&self.mass));
        // With M = L Lᵀ this is the largest eigenvalue of L⁻¹ K L⁻ᵀ.
        let reduced = mass.cholesky().and_then(|cholesky| {
            let lower = cholesky.l();
            let half = lower.solve_lower_triangular(&stiffness)?;
            lower.solve_lower_triangular(&half.transpose())
        });
        reduced.map_or(f64::NAN, |matrix| matrix.symmetric_eigenvalues().max())
    }

    fn add_stretched_stiffness(
        &self,
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        x: &DVector<f64>,
        sum: &mut DVector<f64>,
    ) {
        let tangent = self.beam.tangent(&self.stretched(stretch), eps_t);
        for place in &self.places {
            place.scatter(tangent * place.gather(x), sum);
        }
    }
}

/// Both ends of a step as slices.
fn slices<'a>(ends: &Ends<'a, DVector<f64>>) -> Ends<'a, [f64]> {
    let &Ends { u_0, u_1, thermal_0, thermal_1 } = ends;
    Ends { u_0: u_0.as_slice(), u_1: u_1.as_slice(), thermal_0, thermal_1 }
}

/// Change of a nodal vector under stretches minus 1 (along, across); the element spans `along`, and its node i is at
/// `origin` relative to the fixed point.
pub(super) fn stretched(
    (meaning, at): NodalVector,
    [stretch, thicken]: [f64; 2],
    origin: Vector2<f64>,
    along: Vector2<f64>,
) -> Vector2<f64> {
    use crate::elements::Meaning::{Position, SlopeX, SlopeY};
    let t = along.normalize();
    match meaning {
        Position => stretch * (origin + at * along),
        SlopeX => stretch * t,
        SlopeY => thicken * Vector2::new(-t.y, t.x),
    }
}
