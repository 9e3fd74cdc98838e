//! The paper's Sections 3 and 4, recomputed and compared with the oracles.

pub mod animation;
pub mod balance;
pub mod claims_section3;
pub mod claims_section4;
pub mod comparison;
pub mod continuum;
pub mod figure1;
pub mod figure2;
pub mod locking;
pub mod model_error;
pub mod outcome;
pub mod pendulum;
pub mod pendulum_run;
pub mod reading;
pub mod readings;
pub mod reference_pendulum;
pub mod reference_structures;
pub mod scissors;
pub mod section4;
pub mod standing;
pub mod statement;
pub mod tables;
pub mod time_series;
pub mod tip;
pub mod window;
