//! The paper's Sections 3 and 4, recomputed and compared with the oracles.

pub mod balance;
pub mod claims_section3;
pub mod claims_section4;
pub mod continuum;
pub mod locking;
pub mod main_job;
pub mod model_error;
pub mod pendulum;
pub mod reference_pendulum;
pub mod reference_structures;
pub mod scissors;
pub mod section4;
pub mod table;
pub mod time_series;
