//! The elements of one rod, of whatever kind, behind one interface.
//!
//! Elements of a rod are equal; its chain of nodal vectors ([`Components`]) says which unknowns each has.

use std::fmt::Debug;

use nalgebra::{DVector, Rotation2, SMatrix, SVector, Vector2};

use crate::kernel::{Beam, Ends, NodalVector, ThermalStrain};
use crate::linear::Filling;

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

/// What is asked of the elements of a rod, whose `chain` of nodal vectors is given.
pub(super) trait Mesh: Debug + Send + Sync {
    /// The nodal vectors of one element.
    fn vectors(&self) -> &'static [NodalVector];

    /// Force (N) of an axial strain of 1, or of a slope of 1 where that takes more.
    fn unit_force(&self) -> f64;

    /// Stretches less 1 (along, across) at which a thermal strain makes no stress.
    fn stress_free(&self, eps_t: ThermalStrain) -> [f64; 2];

    /// Displacement of the axis, `place` elements from the rod's beginning.
    fn axis(&self, chain: &[Components], place: f64, u: &DVector<f64>) -> Vector2<f64>;

    /// Adds M a.
    fn add_inertia(&self, chain: &[Components], a: &DVector<f64>, sum: &mut DVector<f64>);

    /// Adds the generalized force of gravity.
    fn add_gravity(&self, chain: &[Components], sum: &mut DVector<f64>);

    /// Adds the elastic forces.
    fn add_force(&self, chain: &[Components], u: &DVector<f64>, eps_t: ThermalStrain, sum: &mut DVector<f64>);

    /// Adds the step-averaged elastic forces.
    fn add_mean_force(&self, chain: &[Components], ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>);

    /// Adds the elements' matrices to the rod's block.
    fn add_matrix(&self, chain: &[Components], matrix: &ElementMatrix, block: &mut Filling);

    /// M a + Q_e − `weight` · Q_w at one nodal vector, N.
    fn force_at(&self, chain: &[Components], vector: usize, now: &Loaded) -> Vector2<f64>;

    /// Strain energy, J.
    fn energy(&self, chain: &[Components], u: &DVector<f64>, eps_t: ThermalStrain) -> f64;

    /// Energy that heating puts in over a step, J.
    fn heating_work(&self, chain: &[Components], ends: &Ends<DVector<f64>>) -> f64;

    /// The largest ω² of an element taken free, (rad/s)², at stretches less 1 (along, across) and a thermal strain. NaN where M is
    /// not positive definite.
    fn largest_square_frequency(&self, stretch: [f64; 2], eps_t: ThermalStrain) -> f64;
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
}

impl<B: Beam<N>, const N: usize> Equal<B, N> {
    /// Nodal vectors from an element to the next.
    const STRIDE: usize = N / 2 - 2;

    /// Each element's nodal vectors.
    fn elements<'a>(&self, chain: &'a [Components]) -> impl Iterator<Item = &'a [Components]> {
        chain.windows(N / 2).step_by(Self::STRIDE)
    }

    /// An element's displacement under stretches less 1, node i at rest.
    fn stretched(&self, stretch: [f64; 2]) -> SVector<f64, N> {
        let mut u = SVector::<f64, N>::zeros();
        for (n, &vector) in B::VECTORS.iter().enumerate() {
            u.fixed_rows_mut::<2>(2 * n).copy_from(&stretched(vector, stretch, Vector2::zeros(), self.along));
        }
        u
    }

    fn matrix(&self, vectors: &[Components], matrix: &ElementMatrix) -> SMatrix<f64, N, N> {
        match *matrix {
            ElementMatrix::Mass => self.mass,
            ElementMatrix::Tangent { u, eps_t, stiffness, mass } => {
                stiffness * self.beam.tangent(&gather(vectors, u), eps_t) + mass * self.mass
            }
            ElementMatrix::Mixed { before, u, eps_t } => {
                self.beam.mixed_tangent(&gather(vectors, before), &gather(vectors, u), eps_t)
            }
            ElementMatrix::Mean { ref ends, mass } => {
                over(vectors, ends, |ends| self.beam.mean_tangent(ends)) + mass * self.mass
            }
        }
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

    fn axis(&self, chain: &[Components], place: f64, u: &DVector<f64>) -> Vector2<f64> {
        let last = (chain.len() - 2) / Self::STRIDE - 1;
        let element = (place.floor() as usize).min(last);
        let u_e = gather(&chain[element * Self::STRIDE..][..N / 2], u);
        B::axis(place - element as f64, &u_e, self.along.norm())
    }

    fn add_inertia(&self, chain: &[Components], a: &DVector<f64>, sum: &mut DVector<f64>) {
        for vectors in self.elements(chain) {
            scatter(vectors, &(self.mass * gather(vectors, a)), sum);
        }
    }

    fn add_gravity(&self, chain: &[Components], sum: &mut DVector<f64>) {
        for vectors in self.elements(chain) {
            scatter(vectors, &self.gravity, sum);
        }
    }

    fn add_force(&self, chain: &[Components], u: &DVector<f64>, eps_t: ThermalStrain, sum: &mut DVector<f64>) {
        for vectors in self.elements(chain) {
            scatter(vectors, &self.beam.force(&gather(vectors, u), eps_t), sum);
        }
    }

    fn add_mean_force(&self, chain: &[Components], ends: &Ends<DVector<f64>>, sum: &mut DVector<f64>) {
        for vectors in self.elements(chain) {
            scatter(vectors, &over(vectors, ends, |ends| self.beam.mean_force(ends)), sum);
        }
    }

    fn add_matrix(&self, chain: &[Components], matrix: &ElementMatrix, block: &mut Filling) {
        for vectors in self.elements(chain) {
            let unknowns: [Option<usize>; N] = std::array::from_fn(|i| vectors[i / 2].unknowns[i % 2]);
            block.add_dense(unknowns, &turned(vectors, self.matrix(vectors, matrix)));
        }
    }

    fn force_at(&self, chain: &[Components], vector: usize, now: &Loaded) -> Vector2<f64> {
        let touching = self.elements(chain).enumerate().filter_map(|(element, vectors)| {
            let own = vector.checked_sub(element * Self::STRIDE).filter(|own| *own < N / 2)?;
            let (u, a) = (gather(vectors, now.u), gather(vectors, now.a));
            let force = self.mass * a + self.beam.force(&u, now.eps_t) - now.weight * self.gravity;
            Some(force.fixed_rows::<2>(2 * own).into_owned())
        });
        touching.sum()
    }

    fn energy(&self, chain: &[Components], u: &DVector<f64>, eps_t: ThermalStrain) -> f64 {
        self.elements(chain).map(|vectors| self.beam.energy(&gather(vectors, u), eps_t)).sum()
    }

    fn heating_work(&self, chain: &[Components], ends: &Ends<DVector<f64>>) -> f64 {
        self.elements(chain).map(|vectors| over(vectors, ends, |ends| self.beam.heating_work(ends))).sum()
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

/// An element's coordinates from a vector of unknowns, in global axes.
fn gather<const N: usize>(vectors: &[Components], u: &DVector<f64>) -> SVector<f64, N> {
    let mut gathered = SVector::<f64, N>::zeros();
    for (n, vector) in vectors.iter().enumerate() {
        gathered.fixed_rows_mut::<2>(2 * n).copy_from(&vector.get(u));
    }
    gathered
}

/// Adds an element's force to the unknowns'.
fn scatter<const N: usize>(vectors: &[Components], force: &SVector<f64, N>, sum: &mut DVector<f64>) {
    for (n, vector) in vectors.iter().enumerate() {
        vector.add(&force.fixed_rows::<2>(2 * n).into_owned(), sum);
    }
}

/// An element's matrix in its nodal vectors' own axes.
fn turned<const N: usize>(vectors: &[Components], mut matrix: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    for (n, vector) in vectors.iter().enumerate() {
        if let Some(turn) = vector.turn {
            let rows = turn.inverse() * matrix.fixed_rows::<2>(2 * n);
            matrix.fixed_rows_mut::<2>(2 * n).copy_from(&rows);
            let columns = matrix.fixed_columns::<2>(2 * n) * turn;
            matrix.fixed_columns_mut::<2>(2 * n).copy_from(&columns);
        }
    }
    matrix
}

/// A function of both ends of a step for one element.
fn over<T, const N: usize>(
    vectors: &[Components],
    ends: &Ends<DVector<f64>>,
    f: impl Fn(&Ends<SVector<f64, N>>) -> T,
) -> T {
    let (u_0, u_1) = (gather(vectors, ends.u_0), gather(vectors, ends.u_1));
    f(&Ends { u_0: &u_0, u_1: &u_1, thermal_0: ends.thermal_0, thermal_1: ends.thermal_1 })
}
