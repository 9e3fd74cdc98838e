//! Order of the x and y components among the nodal coordinates.

/// Place of the components of nodal vectors in a list of coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Components {
    /// x and y of one vector, then those of the next, as in (4).
    #[default]
    Interleaved,
    /// All x, then all y.
    Blocks,
}

impl Components {
    pub(super) const ALL: [Components; 2] = [Components::Interleaved, Components::Blocks];

    /// Vector and component of the coordinate `n` among those of `vectors` vectors.
    pub(super) fn vector_and_component(self, n: usize, vectors: usize) -> (usize, usize) {
        match self {
            Components::Interleaved => (n / 2, n % 2),
            Components::Blocks => (n % vectors, n / vectors),
        }
    }

    /// Value of the key `components` in `hello`.
    pub(super) fn name(self) -> &'static str {
        match self {
            Components::Interleaved => "interleaved",
            Components::Blocks => "blocks",
        }
    }
}
