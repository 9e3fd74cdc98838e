//! Unit of the inclination θ in the state that a program reads.

/// Unit of the state's θ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Angle {
    /// Radians, as in the fixtures.
    #[default]
    Radians,
    /// Degrees.
    Degrees,
}

impl Angle {
    /// An angle in rad as it is sent.
    pub(super) fn sent(self, theta: f64) -> f64 {
        match self {
            Angle::Radians => theta,
            Angle::Degrees => theta.to_degrees(),
        }
    }
}
