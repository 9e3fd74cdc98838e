//! The report of an examination: `conformance.json`; Markdown and text to read; JUnit XML for servers of CI.

// markdown and text import screen and marks, and these record.
mod junit;
mod markdown;
mod marks;
mod record;
mod screen;
mod text;

pub use junit::junit;
pub use record::{
    CaseFault, Conclusion, Counts, CulpritResult, FailingCase, Failure, InvalidResult, PartlyChecked, Program,
    QuantityResult, Refusal, RefusalVerdict, Report,
};
