//! Four elements taken apart and put side by side again, for an element that is computed one by one.

#![allow(non_snake_case)] // eps_T is ε_T, as in the equations.

use nalgebra::SVector;

use super::beam::{Ends, FourEnds};
use crate::lanes::{LANES, Lanes};

/// Coordinates of each element.
pub(super) fn each<L: Lanes, const N: usize>(four: &[L; N]) -> [SVector<f64, N>; LANES] {
    let components = four.map(L::to_array);
    std::array::from_fn(|lane| SVector::from_fn(|i, _| components[i][lane]))
}

/// Coordinates of four elements side by side.
pub(super) fn side_by_side<L: Lanes, const N: usize>(token: L::Token, each: &[SVector<f64, N>; LANES]) -> [L; N] {
    std::array::from_fn(|i| L::load(token, &std::array::from_fn(|lane| each[lane][i])))
}

/// Function of both ends of a step, for each element.
pub(super) fn over_each<L: Lanes, T, const N: usize>(
    ends: &FourEnds<L, N>,
    f: impl Fn(&Ends<SVector<f64, N>>) -> T,
) -> [T; LANES] {
    let ([u_0, u_1], [eps_T0, eps_T1]) = (ends.u.each_ref().map(each), ends.eps_T.each_ref().map(each));
    std::array::from_fn(|n| {
        f(&Ends { u_0: &u_0[n], u_1: &u_1[n], thermal_0: eps_T0[n].into(), thermal_1: eps_T1[n].into() })
    })
}
