//! The evidence for `ancf`: [`main_job`] recomputes the paper's Sections 3 and 4 and compares them with the oracles; [`error_time`] measures
//! error against run time; [`stability`] runs stiff and extreme cases.

mod axis;
mod canvas;
mod drawing;
pub mod error;
pub mod error_time;
pub mod escape;
mod figure;
pub mod files;
mod first_screen;
mod fixture;
mod html;
mod main_job;
mod palette;
mod paper;
mod paper_page;
mod parallel;
mod path;
mod picture;
mod scene;
mod snapshot;
pub mod stability;
mod table;

pub use main_job::main_job;
pub use paper::readings::study as readings;
