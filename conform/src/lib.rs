//! Conformance kit: finds the wrong equation of another implementation of the planar thermo-elastic ANCF beam.
//!
//! `ancf conform -- COMMAND…` does this for a program in any language: [`examine`] starts it and asks for every quantity in every state
//! of the fixtures, one line of JSON at a time. It compares the answers entry by entry, follows wrong ones along the dependencies of
//! the paper's quantities to the first wrong equation, and names the mistakes that explain it. [`Report`] holds the results.
//!
//! A Rust implementation can be checked directly against the reference values of a [`Suite`]:
//!
//! ```
//! use ancf_conform::{State, Suite, Verdict};
//!
//! /// Our λ of (17).
//! fn lambda(e: f64, nu: f64) -> f64 {
//!     e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
//! }
//!
//! let suite = Suite::embedded()?;
//! for case in &suite.cases {
//!     let (State::Element(state), Some(reference)) = (&case.state, case.values.get("17.lambda")) else { continue };
//!     let verdict = Verdict::of(vec![lambda(state.E, state.nu)], reference);
//!     assert!(verdict.passes(), "{}: {verdict:?}", case.id);
//! }
//! # Ok::<(), ancf_conform::Error>(())
//! ```

// Layers, from top to bottom; a module imports only from modules further down this list:
// schema, report, examiner, examination, diagnosis, blame, subject, process, protocol; equations_text, state_file;
// verdict, suite, numbers, graph, error. `trajectory` stands beside them: of this crate it imports error alone.
mod blame;
mod diagnosis;
mod equations_text;
mod error;
mod examination;
mod examiner;
mod graph;
mod numbers;
mod process;
mod protocol;
pub mod report;
mod schema;
mod state_file;
mod subject;
mod suite;
pub mod trajectory;
mod verdict;

pub use blame::{Blame, Culprit, Follower};
pub use diagnosis::{Diagnosis, Mistake, MistakeKind};
pub use equations_text::equations_text;
pub use error::{Error, Result};
pub use examination::{CaseVerdict, Examination, InvalidOutcome, InvalidVerdict};
pub use examiner::{Options, examine};
pub use graph::{GRAPH, Node};
pub use protocol::{Answer, AnswerLine, Hello, numbers as read_numbers, read as read_answer};
pub use report::Report;
pub use schema::schemas;
pub use state_file::load as load_state;
pub use subject::{Chatter, MOST_STARTS};
pub use suite::{Case, InvalidCase, Length, Per, Quantity, Reference, State, Suite};
pub use verdict::{Fault, Verdict, Wrong};
