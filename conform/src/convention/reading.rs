//! Layout of the nodal coordinates that a program reads.

/// Layout of the e0, e and ė of the states that are sent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reading {
    /// That of the fixtures, whatever the layout of the answers.
    #[default]
    Fixture,
    /// The program's own.
    Own,
}
