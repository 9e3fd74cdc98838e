//! The results of an examination.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

use crate::blame::Blame;
use crate::convention::Convention;
use crate::diagnosis::{Ancestor, Diagnosis, Invisible};
use crate::memory::Memory;
use crate::precision::Precision;
use crate::protocol::Hello;
use crate::subject::Chatter;
use crate::trouble::Remark;
use crate::verdict::{Fault, Verdict};

pub use crate::verdict::CaseVerdict;

/// All results of an examination.
#[derive(Debug)]
pub struct Examination {
    /// What the program is called if its hello has no name: the command that started it.
    pub description: String,
    /// The program's answer to `hello`, or the fault that came in its place. After a fault nothing was asked.
    pub hello: Result<Hello, Fault>,
    /// Conventions of the program that differ from the fixtures. Its answers were translated before they were judged.
    pub conventions: Vec<Convention>,
    /// What the conventions in its hello should have been, in words.
    pub convention_errors: Vec<String>,
    /// Lines on the program's standard output that are not JSON objects.
    pub chatter: Chatter,
    /// Precision of the answers, at which they are judged.
    pub precision: Precision,
    /// Mistakes that this precision hides, in the quantities that the program answers.
    pub invisible: Vec<Invisible>,
    /// What was wrong with the form of its answers.
    pub remarks: Vec<Remark>,
    /// Whether a part was asked, as the user chose.
    pub in_part: bool,
    /// Verdicts by quantity and case, in the order of the questions.
    pub verdicts: Vec<(&'static str, Vec<CaseVerdict>)>,
    /// Verdicts on the states that must be refused, in the order of [`Suite::invalid`](crate::Suite::invalid).
    pub invalid: Vec<InvalidVerdict>,
    /// Wrong quantities: culprits and followers.
    pub blame: Blame,
    /// Diagnosis of each culprit.
    pub diagnoses: BTreeMap<&'static str, Diagnosis>,
    /// Earlier quantities that each culprit's mistake may be in, although they are not answered, likeliest first.
    pub ancestors: BTreeMap<&'static str, Vec<Ancestor>>,
    /// Evidence that answers depend on what was asked before; `None` if none was found.
    pub memory: Option<Memory>,
    /// Quantities for which the program does not read any value that it is given, although it says that it does.
    pub given_ignored: Vec<&'static str>,
    /// Number of times that the program was started.
    pub starts: usize,
    /// Number of questions.
    pub questions: usize,
    /// Duration, s.
    pub seconds: f64,
}

/// Verdict on the answer to a state that must be refused.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct InvalidVerdict {
    /// What the program did.
    pub outcome: InvalidOutcome,
    /// Message of the program, or the fault; null if accepted or not implemented.
    pub detail: Option<String>,
}

/// What a program did with a state that must be refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum InvalidOutcome {
    /// It answered an error, as it must.
    Refused,
    /// It answered a value: it does not check its input.
    Accepted,
    /// It does not implement the quantity.
    NotImplemented,
    /// It hung, crashed or wrote something else in place of an answer.
    Fault,
}

impl Examination {
    /// Whether no answer failed or changed when it was asked for again, and something is implemented. Whether invalid states are refused
    /// is another question.
    pub fn passes(&self) -> bool {
        let failing = self.verdicts.iter().flat_map(|(_, cases)| cases).any(|(_, verdict)| verdict.fails());
        let asked = |verdict: &InvalidVerdict| verdict.outcome != InvalidOutcome::NotImplemented;
        !failing && self.memory.is_none() && (self.implemented() > 0 || self.invalid.iter().any(asked))
    }

    /// Name of the program; what it is called otherwise if it did not answer `hello`.
    pub fn name(&self) -> &str {
        match &self.hello {
            Ok(hello) => hello.name.as_deref().unwrap_or("a program without a name"),
            Err(_) => &self.description,
        }
    }

    /// Number of quantities that the program implements.
    pub fn implemented(&self) -> usize {
        let implemented = |cases: &[CaseVerdict]| cases.iter().any(|(_, verdict)| *verdict != Verdict::NotImplemented);
        self.verdicts.iter().filter(|(_, cases)| implemented(cases)).count()
    }
}
