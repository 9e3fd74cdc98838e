//! Nodal vectors: what the coordinates of an element are, two by two.

/// Quantity that a nodal vector holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meaning {
    /// Position r, m.
    Position,
    /// Slope ∂r/∂x.
    SlopeX,
    /// Slope ∂r/∂y.
    SlopeY,
}

/// Nodal vector of an element: its quantity, and its place as a fraction of the length.
pub type NodalVector = (Meaning, f64);
