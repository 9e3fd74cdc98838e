//! Conformance kit: finds the wrong equation of another implementation of the planar thermo-elastic ANCF beam.
//!
//! `ancf conform -- COMMAND…` does this for a program in any language: [`examine`] asks for every quantity in every state of the
//! fixtures, one line of JSON at a time. It compares the answers entry by entry, follows wrong ones along the dependencies of the
//! paper's quantities to the first wrong equation, and names the mistakes that explain it. [`Report`] holds the results.
//!
//! A [`Subject`] is what is asked: a [`Program`] in a process of its own, or [`Code`] of this process, for a unit test in Rust. Values
//! can also be compared one at a time with the reference values of a [`Suite`]:
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
// schema, report, examiner, standing, given, examination, diagnosis, blame, memory, own_digits, convention, lost_digits, precision, answers, formula;
// recorded, program, subject, process, lines; protocol, declaration, spelling, trouble, quotation; selection, equations_text,
// state_file; verdict, suite, numbers, graph, error. `trajectory` stands beside them: of this crate it imports error alone.
mod answers;
mod blame;
mod convention;
mod declaration;
mod diagnosis;
mod equations_text;
mod error;
mod examination;
mod examiner;
mod formula;
mod given;
mod graph;
mod lines;
mod lost_digits;
mod memory;
mod numbers;
mod own_digits;
mod precision;
mod process;
mod program;
mod protocol;
mod quotation;
mod recorded;
pub mod report;
mod schema;
mod selection;
mod spelling;
mod standing;
mod state_file;
mod subject;
mod suite;
pub mod trajectory;
mod trouble;
mod verdict;

pub use blame::{Blame, Culprit, Follower};
pub use convention::{Convention, How};
pub use diagnosis::{Ancestor, Diagnosis, Invisible, Mistake, MistakeKind};
pub use equations_text::equations_text;
pub use error::{Error, Result};
pub use examination::{CaseVerdict, Examination, InvalidOutcome, InvalidVerdict};
pub use examiner::{Options, examine};
pub use graph::{GRAPH, Node};
pub use memory::{ChangedAnswer, EarlierQuestion, Memory, When};
pub use precision::{Form, Least, Precision, Printing};
pub use program::{MOST_STARTS, Program};
pub use protocol::{Answer, AnswerLine, Asked, Hello, Question, numbers as read_numbers, read as read_answer};
pub use recorded::{Recorded, Recorder};
pub use report::Report;
pub use schema::schemas;
pub use selection::Selection;
pub use state_file::load as load_state;
pub use subject::{Chatter, Code, Subject};
pub use suite::{Case, InvalidCase, Length, Per, Quantity, Reference, State, Suite, Tolerance};
pub use trouble::{Remark, Trouble};
pub use verdict::{Fault, Verdict, Wrong};
