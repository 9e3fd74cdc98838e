//! The main job: the paper's Sections 3 and 4, recomputed and compared with the oracles; [`error_time`], error against run time; [`stability`], stiff
//! and extreme cases.

pub mod error;
pub mod error_time;
mod figure;
pub mod files;
pub mod html;
mod page;
mod palette;
mod paper;
mod parallel;
mod snapshot;
pub mod stability;

pub use paper::main_job::main_job;
