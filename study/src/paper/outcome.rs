//! Whether a statement of the paper holds.

use std::fmt;

use serde::{Serialize, Serializer};

/// Result of measuring a statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    Holds,
    DoesNot,
    /// The uncertainty is larger than the distance from the limit.
    Undecided,
    /// Holds for these rods, instants or points, and not for others.
    OnlyFor(Vec<&'static str>),
}

impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Outcome::Holds => f.write_str("holds"),
            Outcome::DoesNot => f.write_str("does not hold"),
            Outcome::Undecided => f.write_str("undecided"),
            Outcome::OnlyFor(items) => write!(f, "holds only for {}", items.join(", ")),
        }
    }
}
