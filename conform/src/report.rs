//! The report of an examination: `conformance.json`; Markdown and text to read; JUnit XML for servers of CI.

// markdown and text import screen, findings, words and marks, and these record.
mod findings;
mod junit;
mod markdown;
mod marks;
mod record;
mod screen;
mod text;
mod words;

pub use junit::junit;
pub use record::{
    CaseFault, Conclusion, Counts, CulpritResult, FailingCase, Failure, FewerDigits, InvalidResult, LeastAttainable,
    OtherPrecision, PartlyChecked, PrecisionResult, Program, QuantityResult, Refusal, RefusalVerdict, Report,
};
