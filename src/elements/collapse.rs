//! det J of a fibre, and the smallest of several: both elements need them to detect a collapse.

use super::plane::{Vec2, Vector};

/// Outermost Gauss points across the section, as a fraction of h/2: √(3/5).
pub(super) const OUTERMOST: f64 = 0.774_596_669_241_483_4;

/// Cross product a × b in the plane.
pub(super) fn cross(a: Vec2, b: Vec2) -> f64 {
    a.turn().dot(b)
}

/// Smallest of `numbers`; NaN if any is NaN.
pub(super) fn smallest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(f64::INFINITY, |least, number| if number >= least || least.is_nan() { least } else { number })
}
