//! The planar thermo-elastic ANCF beam of Peng et al. (2018).

pub mod equations;
pub mod error;
pub mod integrators;
pub mod kernel;
pub mod linear;
pub mod newton;
pub mod report;
pub mod run;
pub mod scene;
pub mod state;
pub mod structure;
#[cfg(feature = "cli")]
pub mod study;
