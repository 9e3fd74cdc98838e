//! The elements of one rod, of whatever kind, behind one interface.
//!
//! Elements of a rod are equal; its chain of nodal vectors ([`Components`]) says which unknowns each has, and is looked at once,
//! when these are numbered.

use std::fmt::Debug;

use nalgebra::{Complex, DVector, Rotation2, SMatrix, SVector, Vector2};

use crate::kernel::{Beam, Ends, LANES, NodalVector, ThermalStrain};
use crate::linear::{Chain, Elements, Filling, NONE};

/// Where the components of a nodal vector are among the unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Components {
    /// `None` where a support holds the component.
    pub unknowns: [Option<usize>; 2],
    /// From the vector's own axes to the global ones, where they differ.
    pub turn: Option<Rotation2<f64>>,
}

impl Components {
    /// The nodal vector in a vector of unknowns, in global axes; zero where it is held.
    pub fn get(&self, u: &DVector<f64>) -> Vector2<f64> {
        let own = Vector2::from(self.unknowns.map(|unknown| unknown.map_or(0.0, |unknown| u[unknown])));
        self.turn.map_or(own, |turn| turn * own)
    }

    /// Adds a nodal vector, in global axes, to the unknowns; what is held takes none.
    pub fn add(&self, vector: &Vector2<f64>, sum: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                sum[unknown] += value;
            }
        }
    }

    /// Puts a nodal vector, in global axes, in its place.
    pub fn set(&self, vector: &Vector2<f64>, u: &mut DVector<f64>) {
        let own = self.turn.map_or(*vector, |turn| turn.inverse() * vector);
        for (unknown, value) in self.unknowns.iter().zip(&own) {
            if let Some(unknown) = *unknown {
                u[unknown] = *value;
            }
        }
    }
}

/// Which matrix of an element is asked for; vectors are those of the whole structure.
pub(super) enum ElementMatrix<'a> {
    Mass,
    /// `stiffness` · tangent + `mass` · M.
    Tangent {
        u: &'a DVector<f64>,
        eps_t: ThermalStrain,
        stiffness: f64,
        mass: f64,
    },
    /// The same of every element at these stretches less 1.
    Stretched {
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        stiffness: f64,
        mass: f64,
    },
    /// [`Beam::mixed_tangent`].
    Mixed {
        before: &'a DVector<f64>,
        u: &'a DVector<f64>,
        eps_t: ThermalStrain,
    },
    /// [`Beam::mean_tangent`] + `mass` · M.
    Mean {
        ends: Ends<'a, DVector<f64>>,
        mass: f64,
    },
}

/// What is asked of the elements of a rod.
pub(super) trait Mesh: Debug + Send + Sync {
    /// The nodal vectors of one element.
    fn vectors(&self) -> &'static [NodalVector];

    /// Force (N) of an axial strain of 1, or of a slope of 1 where that takes more.
    fn unit_force(&self) -> f64;

    /// Stretches less 1 (along, across) at which a thermal strain makes no stress.
    fn stress_free(&self, eps_t: ThermalStrain) -> [f64; 2];

    /// Takes the unknowns' numbers from the rod's chain of nodal vectors.
    fn number(&mut self, chain: &[Components]);

    /// Memory for the factors of its matrix; unknowns from `border` on are shared.
    fn chain(&self, border: usize) -> Box<dyn Chain<f64>>;

    /// The same for a complex matrix.
    fn complex_chain(&self, border: usize) -> Box<dyn Chain<Complex<f64>>>;

    /// Memory that the factors take for each element at most, bytes.
    fn bytes_each(&self) -> usize;

    /// Displacement of the axis, `place` elements from the rod's beginning.
    fn axis(&self, place: f64, u: &DVector<f64>) -> Vector2<f64>;

    /// The entry of an element's M that couples two of its nodal vectors, kg: M couples neither x with y nor tells them apart.
    fn mass(&self, row: usize, column: usize) -> f64;

    /// Adds M a.
    fn add_inertia(&self, a: &DVector<f64>, sum: &mut DVector<f64>);

    /// Adds the generalized force of gravity.
    fn add_gravity(&self, sum: &mut DVector<f64>);

    /// Adds the elastic forces.
    fn add_force(&self, u: &DVector<f64>, eps_t: ThermalStrain, sum: &mut DVector<f64>);

    /// Adds the step-averaged elastic forces.
    fn add_mean_force(&self, ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>);

    /// One element's matrix, by columns.
    fn matrix(&self, element: usize, matrix: &ElementMatrix, columns: &mut [f64]);

    /// Adds the elements' matrices to the rod's block.
    fn add_matrix(&self, matrix: &ElementMatrix, block: &mut Filling);

    /// M a + Q_e − `weight` · Q_w at one nodal vector, N.
    fn force_at(&self, vector: usize, now: &Loaded) -> Vector2<f64>;

    /// The first element that has collapsed.
    fn collapsed(&self, before: &DVector<f64>, u: &DVector<f64>) -> Option<usize>;

    /// Strain energy, J.
    fn energy(&self, u: &DVector<f64>, eps_t: ThermalStrain) -> f64;

    /// Energy that heating puts in over a step, J.
    fn heating_work(&self, ends: &Ends<DVector<f64>>) -> f64;

    /// The largest ω² of an element taken free, (rad/s)², at stretches less 1 (along, across) and a thermal strain. NaN where M is
    /// not positive definite.
    fn largest_square_frequency(&self, stretch: [f64; 2], eps_t: ThermalStrain) -> f64;

    /// Adds K x, every element at these stretches less 1 and this thermal strain.
    fn add_stretched_stiffness(
        &self,
        stretch: [f64; 2],
        eps_t: ThermalStrain,
        x: &DVector<f64>,
        sum: &mut DVector<f64>,
    );
}

/// What acts on a rod at an instant.
pub(super) struct Loaded<'a> {
    pub u: &'a DVector<f64>,
    pub a: &'a DVector<f64>,
    pub eps_t: ThermalStrain,
    pub weight: f64,
}

/// Equal elements of one kind with `N` nodal coordinates.
#[derive(Clone, Debug)]
pub(super) struct Equal<B, const N: usize> {
    pub beam: B,
    /// From node i to node k of an element, m.
    pub along: Vector2<f64>,
    pub mass: SMatrix<f64, N, N>,
    pub gravity: SVector<f64, N>,
    pub unit_force: f64,
    /// There once unknowns are numbered.
    pub places: Vec<Place<N>>,
}

/// Where an element's coordinates are among the unknowns.
#[derive(Clone, Debug)]
pub(super) struct Place<const N: usize> {
    /// [`NONE`] for those that are held.
    unknowns: [u32; N],
    /// Nodal vectors in axes of their own.
    turns: Vec<(usize, Rotation2<f64>)>,
}

impl<const N: usize> Place<N> {
    fn of(vectors: &[Components]) -> Place<N> {
        let unknown = |i: usize| vectors[i / 2].unknowns[i % 2].map_or(NONE, |unknown| unknown as u32);
        let turns = vectors.iter().enumerate().filter_map(|(n, vector)| Some((n, vector.turn?)));
        Place { unknowns: std::array::from_fn(unknown), turns: turns.collect() }
    }

    /// The element's coordinates from a vector of unknowns, in global axes.
    #[inline(always)]
    fn gather(&self, u: &DVector<f64>) -> SVector<f64, N> {
        let u = u.as_slice();
        let value = |i: usize| u.get(self.unknowns[i] as usize).copied().unwrap_or(0.0);
        let mut gathered = SVector::<f64, N>::from_fn(|i, _| value(i));
        for (n, turn) in &self.turns {
            let own = gathered.fixed_rows::<2>(2 * n).into_owned();
            gathered.fixed_rows_mut::<2>(2 * n).copy_from(&(turn * own));
        }
        gathered
    }

    /// Adds the element's force to the unknowns'.
    #[inline(always)]
    fn scatter(&self, mut force: SVector<f64, N>, sum: &mut DVector<f64>) {
        for (n, turn) in &self.turns {
            let own = turn.inverse() * force.fixed_rows::<2>(2 * n);
            force.fixed_rows_mut::<2>(2 * n).copy_from(&own);
        }
        let sum = sum.as_mut_slice();
        for (unknown, value) in self.unknowns.iter().zip(&force) {
            if let Some(sum) = sum.get_mut(*unknown as usize) {
                *sum += value;
            }
        }
    }

    /// The element's matrix in its nodal vectors' own axes.
    fn turned(&self, mut matrix: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
        for (n, turn) in &self.turns {
            let rows = turn.inverse() * matrix.fixed_rows::<2>(2 * n);
            matrix.fixed_rows_mut::<2>(2 * n).copy_from(&rows);
            let columns = matrix.fixed_columns::<2>(2 * n) * turn;
            matrix.fixed_columns_mut::<2>(2 * n).copy_from(&columns);
        }
        matrix
    }

    /// A function of both ends of a step for this element.
    #[inline(always)]
    fn over<T>(&self, ends: &Ends<DVector<f64>>, f: impl Fn(&Ends<SVector<f64, N>>) -> T) -> T {
        let (u_0, u_1) = (self.gather(ends.u_0), self.gather(ends.u_1));
        f(&Ends { u_0: &u_0, u_1: &u_1, thermal_0: ends.thermal_0, thermal_1: ends.thermal_1 })
    }
}

/// Coordinates of up to [`LANES`] elements; where there are fewer the rest is at rest.
#[inline(always)]
fn gather<const N: usize>(places: &[Place<N>], u: &DVector<f64>) -> [SVector<f64, N>; LANES] {
    std::array::from_fn(|lane| places.get(lane).map_or(SVector::zeros(), |place| place.gather(u)))
}

/// Adds their forces to the unknowns'.
#[inline(always)]
fn scatter<const N: usize>(places: &[Place<N>], forces: [SVector<f64, N>; LANES], sum: &mut DVector<f64>) {
    places.iter().zip(forces).for_each(|(place, force)| place.scatter(force, sum));
}

impl<B: Beam<N>, const N: usize> Equal<B, N> {
    /// Nodal vectors from an element to the next.
    const STRIDE: usize = N / 2 - 2;

    /// An element's displacement under stretches less 1, node i at rest.
    fn stretched(&self, stretch: [f64; 2]) -> SVector<f64, N> {
        let mut u = SVector::<f64, N>::zeros();
        for (n, &vector) in B::VECTORS.iter().enumerate() {
            u.fixed_rows_mut::<2>(2 * n).copy_from(&stretched(vector, stretch, Vector2::zeros(), self.along));
        }
        u
    }

    /// An element's matrix, by columns.
    fn element_matrix(&self, place: &Place<N>, matrix: &ElementMatrix, columns: &mut [f64]) {
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
        if !place.turns.is_empty() {
            let turned = place.turned(SMatrix::from_column_slice(columns));
            columns.copy_from_slice(turned.as_slice());
        }
    }

    /// M a. The matrix treats x and y alike, and couples neither with the other: half of it is zero.
    #[inline(always)]
    fn momentum(&self, a: &SVector<f64, N>) -> SVector<f64, N> {
        let (mut sum, a) = (SVector::<f64, N>::zeros(), a.as_slice().as_chunks::<2>().0);
        let sums = sum.as_mut_slice().as_chunks_mut::<2>().0;
        for (column, a) in a.iter().enumerate() {
            for (row, sum) in sums.iter_mut().enumerate() {
                let mass = self.mass[(2 * row, 2 * column)];
                sum[0] += mass * a[0];
                sum[1] += mass * a[1];
            }
        }
        sum
    }

    fn unknowns(&self) -> impl Iterator<Item = [u32; N]> {
        self.places.iter().map(|place| place.unknowns)
    }
}

impl<B: Beam<N> + Debug + Send + Sync, const N: usize> Mesh for Equal<B, N> {
    fn vectors(&self) -> &'static [NodalVector] {
        B::VECTORS
    }

    fn unit_force(&self) -> f64 {
        self.unit_force
    }

    fn stress_free(&self, eps_t: ThermalStrain) -> [f64; 2] {
        B::stress_free(eps_t)
    }

    fn number(&mut self, chain: &[Components]) {
        self.places = chain.windows(N / 2).step_by(Self::STRIDE).map(Place::of).collect();
    }

    fn chain(&self, border: usize) -> Box<dyn Chain<f64>> {
        Box::new(Elements::<f64, N>::new(self.unknowns(), border))
    }

    fn complex_chain(&self, border: usize) -> Box<dyn Chain<Complex<f64>>> {
        Box::new(Elements::<Complex<f64>, N>::new(self.unknowns(), border))
    }

    fn bytes_each(&self) -> usize {
        Elements::<f64, N>::bytes_each()
    }

    fn axis(&self, place: f64, u: &DVector<f64>) -> Vector2<f64> {
        let element = (place.floor() as usize).min(self.places.len() - 1);
        B::axis(place - element as f64, &self.places[element].gather(u), self.along.norm())
    }

    fn mass(&self, row: usize, column: usize) -> f64 {
        self.mass[(2 * row, 2 * column)]
    }

    fn add_inertia(&self, a: &DVector<f64>, sum: &mut DVector<f64>) {
        for place in &self.places {
            place.scatter(self.momentum(&place.gather(a)), sum);
        }
    }

    fn add_gravity(&self, sum: &mut DVector<f64>) {
        for place in &self.places {
            place.scatter(self.gravity, sum);
        }
    }

    fn add_force(&self, u: &DVector<f64>, eps_t: ThermalStrain, sum: &mut DVector<f64>) {
        for places in self.places.chunks(LANES) {
            if let [place] = places {
                place.scatter(self.beam.force(&place.gather(u), eps_t), sum);
            } else {
                scatter(places, self.beam.forces(&gather(places, u), eps_t), sum);
            }
        }
    }

    fn add_mean_force(&self, ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>) {
        let &Ends { thermal_0, thermal_1, .. } = ends;
        for places in self.places.chunks(LANES) {
            if let [place] = places {
                place.scatter(place.over(ends, |ends| self.beam.mean_force(ends)), sum);
            } else {
                let (u_0, u_1) = (gather(places, ends.u_0), gather(places, ends.u_1));
                let ends = Ends { u_0: &u_0, u_1: &u_1, thermal_0, thermal_1 };
                scatter(places, self.beam.mean_forces(&ends), sum);
            }
        }
    }

    fn matrix(&self, element: usize, matrix: &ElementMatrix, columns: &mut [f64]) {
        self.element_matrix(&self.places[element], matrix, columns);
    }

    fn add_matrix(&self, matrix: &ElementMatrix, block: &mut Filling) {
        for place in &self.places {
            let unknowns = place.unknowns.map(|unknown| (unknown != NONE).then_some(unknown as usize));
            let mut dense = SMatrix::<f64, N, N>::zeros();
            self.element_matrix(place, matrix, dense.as_mut_slice());
            block.add_dense(unknowns, &dense);
        }
    }

    fn force_at(&self, vector: usize, now: &Loaded) -> Vector2<f64> {
        let touching = self.places.iter().enumerate().filter_map(|(element, place)| {
            let own = vector.checked_sub(element * Self::STRIDE).filter(|own| *own < N / 2)?;
            let (u, a) = (place.gather(now.u), place.gather(now.a));
            let force = self.mass * a + self.beam.force(&u, now.eps_t) - now.weight * self.gravity;
            Some(force.fixed_rows::<2>(2 * own).into_owned())
        });
        touching.sum()
    }

    fn collapsed(&self, before: &DVector<f64>, u: &DVector<f64>) -> Option<usize> {
        let left = |place: &Place<N>| self.beam.left(&place.gather(before), &place.gather(u));
        // A NaN is not over 0.
        self.places.iter().position(|place| left(place).partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater))
    }

    fn energy(&self, u: &DVector<f64>, eps_t: ThermalStrain) -> f64 {
        self.places.iter().map(|place| self.beam.energy(&place.gather(u), eps_t)).sum()
    }

    fn heating_work(&self, ends: &Ends<DVector<f64>>) -> f64 {
        self.places.iter().map(|place| place.over(ends, |ends| self.beam.heating_work(ends))).sum()
    }

    fn largest_square_frequency(&self, stretch: [f64; 2], eps_t: ThermalStrain) -> f64 {
        let size = |matrix: &SMatrix<f64, N, N>| nalgebra::DMatrix::from_column_slice(N, N, matrix.as_slice());
        let (stiffness, mass) = (size(&self.beam.tangent(&self.stretched(stretch), eps_t)), size(&self.mass));
        // With M = L Lᵀ the largest eigenvalue of L⁻¹ K L⁻ᵀ.
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

/// What a nodal vector changes by under stretches less 1 (along, across) of an element that spans `along`, its node i at
/// `origin` from the fixed point.
pub(super) fn stretched(
    (meaning, at): NodalVector,
    [stretch, thicken]: [f64; 2],
    origin: Vector2<f64>,
    along: Vector2<f64>,
) -> Vector2<f64> {
    use crate::kernel::Meaning::{Position, SlopeX, SlopeY};
    let t = along.normalize();
    match meaning {
        Position => stretch * (origin + at * along),
        SlopeX => stretch * t,
        SlopeY => thicken * Vector2::new(-t.y, t.x),
    }
}
