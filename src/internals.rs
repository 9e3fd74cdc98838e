//! Internals of the library that the project's own studies, benches, tests and conformance kit use.
//!
//! They may change in any version, and are not part of the interface.

/// Beam elements arranged for speed.
pub mod elements {
    pub use crate::elements::*;
}

/// Numbers and functions of the paper, quadrature.
pub mod equations {
    pub use crate::equations::inside::*;
}

/// Time-stepping methods, Newton's iteration and statics.
pub mod integrators {
    pub use crate::integrators::inside::*;
}

/// Four numbers side by side, and the choice of the processor's instructions.
pub mod lanes {
    pub use crate::lanes::*;
}

/// Linear systems of rods and structures.
pub mod linear {
    pub use crate::linear::*;
}

/// Built-in scenes, words of scene files, and plans.
pub mod model {
    pub use crate::model::inside::*;
}

/// Functions that run a model with an observer or a given plan.
pub mod run {
    pub use crate::run::inside::*;
}

/// JSON Schemas of the project's files.
#[cfg(feature = "schema")]
pub mod schema {
    pub use crate::schema::*;
}

/// Structures: numbering, assembly, constraints, mass.
pub mod structure {
    pub use crate::structure::*;
}

/// The terms of (23) for a structure.
pub mod state {
    pub use crate::state::inside::*;
}
