//! The library's inside, as far as the project's own studies, benches, tests and conformance kit need it.
//!
//! It may change in any version: nothing of it is part of the interface.

/// The elements arranged for speed.
pub mod elements {
    pub use crate::elements::*;
}

/// Time-stepping methods, and what they are made of.
pub mod integrators {
    pub use crate::integrators::inside::*;
}

/// Linear systems of rods and structures.
pub mod linear {
    pub use crate::linear::*;
}

/// Scenes beyond their file: built-in ones, words, plans.
pub mod model {
    pub use crate::model::inside::*;
}

/// Runs that are watched, or compute more than they need.
pub mod run {
    pub use crate::run::inside::*;
}

/// Numbering, assembly, constraints, mass.
pub mod structure {
    pub use crate::structure::*;
}
