//! **The kit for other implementations**: which equation of a program is wrong, and what kind of mistake it is.
//!
//! `ancf conform -- COMMAND…` starts any program in any language and asks it, line by line ([`protocol`]), for every quantity in
//! every state of the fixtures ([`suite`]). Answers are compared entry by entry ([`verdict`]); what is wrong is followed along the
//! equations that it is computed from ([`graph`]) to the first one that is wrong by itself ([`blame`]); and its answers are compared with
//! what known mistakes would give ([`mistakes`]). [`report`] says all of it as text, Markdown and JSON.
//!
//! The feature `cli` adds what needs processes: `process`, `program`, `examine`, `examination` and `report`.

pub mod blame;
pub mod diagnosis;
pub mod equations_text;
pub mod error;
pub mod examination;
pub mod examiner;
pub mod graph;
pub mod process;
pub mod protocol;
pub mod report;
pub mod state_file;
pub mod subject;
pub mod suite;
pub mod verdict;
