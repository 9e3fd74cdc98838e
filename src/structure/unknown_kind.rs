//! What an unknown measures.

/// What one unknown measures; its force is compared with others as a force over this length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UnknownKind {
    Position,
    /// A slope, with the length (m) over which its moment acts: h for r_y, l for r_x.
    Slope(f64),
    /// One of λ.
    Multiplier,
}

impl UnknownKind {
    /// One over the length over which a force on the unknown is judged; 0 for multipliers.
    pub fn weight(&self) -> f64 {
        match self {
            UnknownKind::Position => 1.0,
            UnknownKind::Slope(length) => 1.0 / length,
            UnknownKind::Multiplier => 0.0,
        }
    }
}
