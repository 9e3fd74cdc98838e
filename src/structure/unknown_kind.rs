//! What an unknown measures.

/// What one unknown measures; its force is compared with others as a force over this length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Position,
    /// A slope, with the length (m) over which its moment acts: h for r_y, l for r_x.
    Slope(f64),
    /// One of λ.
    Multiplier,
}

impl Kind {
    /// One over the length over which a force on the unknown is judged; 0 for multipliers.
    pub fn weight(&self) -> f64 {
        match self {
            Kind::Position => 1.0,
            Kind::Slope(length) => 1.0 / length,
            Kind::Multiplier => 0.0,
        }
    }
}
