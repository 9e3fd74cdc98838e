//! The report of an examination: `conformance.json`, and Markdown to read and to paste.

mod markdown;
mod record;

pub use record::{
    CaseFault, Counts, CulpritResult, FailingCase, Failure, FewerDigits, InvalidResult, LeastAttainable,
    OtherPrecision, PartlyChecked, PrecisionResult, Program, QuantityResult, Report,
};
