//! Sweeps over a rod, row by row: what is computed for four elements side by side.

#![allow(non_snake_case)] // eps_T is ε_T, as in the equations.

use nalgebra::SMatrix;

use super::row::Row;
use crate::elements::{Beam, Ends, FourEnds, ThermalStrain};
use crate::lanes::{Lanes, Task, for_lanes};

/// Rod whose elements are swept.
#[derive(Clone, Copy)]
pub(super) struct Sweep<'a, B, const N: usize> {
    pub beam: &'a B,
    pub rows: &'a [Row<N>],
}

/// Thermal strain in every lane.
#[inline(always)]
fn splat<L: Lanes>(token: L::Token, [along, across]: ThermalStrain) -> [L; 2] {
    [L::splat(token, along), L::splat(token, across)]
}

/// Both ends of a step in a vector of unknowns.
#[inline(always)]
fn four_ends<L: Lanes, const N: usize>(token: L::Token, row: &Row<N>, ends: &Ends<[f64]>) -> FourEnds<L, N> {
    FourEnds {
        u: [row.coordinates(token, ends.u_0), row.coordinates(token, ends.u_1)],
        eps_T: [splat(token, ends.thermal_0), splat(token, ends.thermal_1)],
    }
}

/// Sum over a row's elements; the other lanes hold copies.
#[inline(always)]
fn total<L: Lanes>(values: L, count: usize) -> f64 {
    let mut sum = 0.0;
    let values = values.to_array();
    for_lanes!(lane < count, { sum += values[lane] });
    sum
}

/// Elastic forces, `factor` times, added to `sum`.
pub(super) struct Forces<'a, B, const N: usize> {
    pub sweep: Sweep<'a, B, N>,
    pub u: &'a [f64],
    pub eps_T: ThermalStrain,
    pub factor: f64,
    pub sum: &'a mut [f64],
}

impl<B: Beam<N>, const N: usize> Task for Forces<'_, B, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) {
        let eps_T = splat(token, self.eps_T);
        for row in self.sweep.rows {
            let u = row.coordinates::<L>(token, self.u);
            row.add(token, self.sweep.beam.forces(token, &u, eps_T), self.factor, self.sum);
        }
    }
}

/// Forces of an energy–momentum step, added to `sum`.
pub(super) struct MeanForces<'a, B, const N: usize> {
    pub sweep: Sweep<'a, B, N>,
    pub ends: Ends<'a, [f64]>,
    pub sum: &'a mut [f64],
}

impl<B: Beam<N>, const N: usize> Task for MeanForces<'_, B, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) {
        for row in self.sweep.rows {
            let ends = four_ends::<L, N>(token, row, &self.ends);
            row.add(token, self.sweep.beam.mean_forces(token, &ends), 1.0, self.sum);
        }
    }
}

/// Products M a, added to `sum`.
pub(super) struct Momenta<'a, B, const N: usize> {
    pub sweep: Sweep<'a, B, N>,
    pub mass: &'a SMatrix<f64, N, N>,
    pub a: &'a [f64],
    pub sum: &'a mut [f64],
}

impl<B: Beam<N>, const N: usize> Task for Momenta<'_, B, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) {
        for row in self.sweep.rows {
            let a = row.coordinates::<L>(token, self.a);
            row.add(token, B::momenta(token, self.mass, &a), 1.0, self.sum);
        }
    }
}

/// Strain energy of a rod, J.
pub(super) struct Energy<'a, B, const N: usize> {
    pub sweep: Sweep<'a, B, N>,
    pub u: &'a [f64],
    pub eps_T: ThermalStrain,
}

impl<B: Beam<N>, const N: usize> Task for Energy<'_, B, N> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) -> f64 {
        let (eps_T, mut sum) = (splat(token, self.eps_T), 0.0);
        for row in self.sweep.rows {
            let u = row.coordinates::<L>(token, self.u);
            sum += total(self.sweep.beam.energies(token, &u, eps_T), row.count());
        }
        sum
    }
}

/// Energy supplied by heating a rod over a step, J.
pub(super) struct HeatingWork<'a, B, const N: usize> {
    pub sweep: Sweep<'a, B, N>,
    pub ends: Ends<'a, [f64]>,
}

impl<B: Beam<N>, const N: usize> Task for HeatingWork<'_, B, N> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) -> f64 {
        let mut sum = 0.0;
        for row in self.sweep.rows {
            let ends = four_ends::<L, N>(token, row, &self.ends);
            sum += total(self.sweep.beam.heating_works(token, &ends), row.count());
        }
        sum
    }
}

/// Whether every element's smallest det J is over 0.
pub(super) struct IsWhole<'a, B, const N: usize> {
    pub sweep: Sweep<'a, B, N>,
    pub before: &'a [f64],
    pub u: &'a [f64],
}

impl<B: Beam<N>, const N: usize> Task for IsWhole<'_, B, N> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) -> bool {
        for row in self.sweep.rows {
            let (before, u) = (row.coordinates::<L>(token, self.before), row.coordinates::<L>(token, self.u));
            // Lanes without an element repeat the last one. A NaN is not over 0.
            let [a, b, c, d] = self.sweep.beam.min_det_js(token, &before, &u).to_array();
            if !(a > 0.0 && b > 0.0 && c > 0.0 && d > 0.0) {
                return false;
            }
        }
        true
    }
}
