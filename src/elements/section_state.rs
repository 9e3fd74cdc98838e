//! State of an element's section at a place on its axis, as pictures show it.

use nalgebra::Vector2;

/// Section of an element at a place on its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionState {
    /// Slope ∂r/∂y across the section; the unit normal of the axis where the element has none.
    pub director: Vector2<f64>,
    /// Axial strain of the axis, heat included: Green–Lagrange, or |r_x| − 1 of the cable.
    pub strain: f64,
    /// Rotation of the section per initial length, 1/m, positive counterclockwise.
    pub curvature: f64,
}

impl SectionState {
    /// Mean of two sections.
    pub fn mean(self, other: SectionState) -> SectionState {
        SectionState {
            director: 0.5 * (self.director + other.director),
            strain: 0.5 * (self.strain + other.strain),
            curvature: 0.5 * (self.curvature + other.curvature),
        }
    }
}
