//! Order of the components of strain and stress.

/// Names of the components in the order of the fixtures.
pub(super) const COMPONENTS: [&str; 3] = ["11", "22", "12"];

/// Order of the components: index in the program's list → index in (11, 22, 12).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Voigt(pub(super) [usize; 3]);

impl Default for Voigt {
    fn default() -> Voigt {
        Voigt([0, 1, 2])
    }
}

impl Voigt {
    pub(super) const ALL: [Voigt; 6] =
        [Voigt([0, 1, 2]), Voigt([0, 2, 1]), Voigt([1, 0, 2]), Voigt([1, 2, 0]), Voigt([2, 0, 1]), Voigt([2, 1, 0])];

    /// The order in words.
    pub(super) fn words(self) -> String {
        let list = self.0.iter().filter_map(|n| COMPONENTS.get(*n).copied()).collect::<Vec<_>>().join(", ");
        format!("strains and stresses as ({list})")
    }
}
