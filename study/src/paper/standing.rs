//! Whether a statement holds, all measurements together.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::outcome::Outcome;

/// Whether a statement holds, all measurements together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Standing {
    Holds,
    /// For some windows, starts, rods or readings, and not for others.
    InPart,
    DoesNot,
    Undecided,
}

impl Standing {
    /// All, the best first.
    pub const ALL: [Standing; 4] = [Standing::Holds, Standing::InPart, Standing::DoesNot, Standing::Undecided];

    /// What outcomes say together.
    pub fn of<'a>(outcomes: impl Iterator<Item = &'a Outcome> + Clone) -> Standing {
        let all = |wanted: &Outcome| outcomes.clone().all(|outcome| outcome == wanted);
        let any = |wanted: fn(&Outcome) -> bool| outcomes.clone().any(wanted);
        if all(&Outcome::Holds) {
            Standing::Holds
        } else if any(|outcome| matches!(outcome, Outcome::Holds | Outcome::OnlyFor(_))) {
            Standing::InPart
        } else if any(|outcome| *outcome == Outcome::DoesNot) {
            Standing::DoesNot
        } else {
            Standing::Undecided
        }
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Standing::Holds => "holds",
            Standing::InPart => "holds in part",
            Standing::DoesNot => "does not hold",
            Standing::Undecided => "cannot be decided",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_measurements_together_decide() {
        use Outcome::{DoesNot, Holds, OnlyFor, Undecided};
        let standing = |outcomes: &[Outcome]| Standing::of(outcomes.iter());
        assert_eq!(standing(&[Holds, Holds]), Standing::Holds);
        assert_eq!(standing(&[Holds, DoesNot]), Standing::InPart);
        assert_eq!(standing(&[Holds, Undecided]), Standing::InPart);
        assert_eq!(standing(&[OnlyFor(vec!["a"])]), Standing::InPart);
        assert_eq!(standing(&[DoesNot, Undecided]), Standing::DoesNot);
        assert_eq!(standing(&[Undecided, Undecided]), Standing::Undecided);
    }
}
