//! Kinds of unknowns.

/// Kind of an unknown, which determines how its force is compared with others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UnknownKind {
    Position,
    /// Slope, with the length (m) over which its moment acts: h for r_y, l for r_x.
    Slope(f64),
    /// Lagrange multiplier λ.
    Multiplier,
}

impl UnknownKind {
    /// Reciprocal length that converts a force on the unknown to newtons; 0 for multipliers.
    pub fn weight(&self) -> f64 {
        match self {
            UnknownKind::Position => 1.0,
            UnknownKind::Slope(length) => 1.0 / length,
            UnknownKind::Multiplier => 0.0,
        }
    }
}
