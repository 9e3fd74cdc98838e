//! When nothing is left of an element, or it has turned inside out.

use super::Cable;
use crate::elements::ancf::collapse::OUTERMOST;
use crate::elements::plane::{Vector, at};
use crate::equations::cable::Vector8;

impl Cable {
    /// The least of what is left at the quadrature points.
    ///
    /// The section stays plane and normal to the axis, so that a fibre at y is stretched by |r_x| − y θ_x with the axis' turning
    /// θ_x = (r_x × r_xx)/|r_x|²: det J of this theory. It is least at the outermost of Gauss's points across the section, whose height is
    /// √(12 EI/EA).
    ///
    /// An axis that has passed through nothing points the other way, and is as long as before: no determinant shows it. But r_x
    /// then has no part along what it was at `before`, unless it turned by more than a right angle in a step, which no method
    /// follows either.
    pub(super) fn least_left(&self, before: &Vector8, u: &Vector8) -> f64 {
        let (before, shape) = (self.shape_of(before), self.shape_of(u));
        let half_height = (3.0 * self.EI / self.EA).sqrt();
        let fibres = self.bending.iter().map(|station| {
            let bend = self.bend(station, &shape);
            bend.square.sqrt() - OUTERMOST * half_height * bend.kappa().abs()
        });
        let turned = self.axial.iter().map(|station| {
            let r_x = |shape| self.t + at(station.zeta, shape);
            r_x(&before).dot(r_x(&shape))
        });
        fibres.chain(turned).fold(f64::INFINITY, |least, left| if left >= least { least } else { left })
    }
}
