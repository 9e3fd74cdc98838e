//! The report as data: `conformance.json`.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::Serialize;

use crate::blame::{self, Blame, Follower};
use crate::convention::Convention;
use crate::diagnosis::{Ancestor, Diagnosis, Invisible, Mistake};
use crate::examination::{CaseVerdict, Examination, InvalidOutcome, InvalidVerdict};
use crate::formula::formula;
use crate::graph::equation;
use crate::memory::Memory;
use crate::protocol::Hello;
use crate::subject::Chatter;
use crate::suite::{InvalidCase, Suite};
use crate::trouble::Remark;
use crate::verdict::{Fault, Verdict};

/// Name and version of the report's format.
const SCHEMA: &str = "ancf-conformance/2";
/// Largest number of faults that are listed for a quantity.
const MOST_FAULTS: usize = 3;
/// Mistake of a program that answers zero everywhere. It does not show a common cause.
const ZEROS: &str = "all of it missing";

/// Report on a program: which of its equations are wrong, and which mistakes explain that.
///
/// Serialised, it is `conformance.json`.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Report {
    /// Name and version of this format.
    #[schemars(extend("const" = SCHEMA))]
    pub schema: &'static str,
    /// Run id, which the report's files share: the first 16 hexadecimal digits of the SHA-256 of this report without it. Empty until the
    /// report is written.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub run: String,
    /// Version of `ancf`.
    pub ancf: &'static str,
    /// Version of each fixture file.
    pub fixtures: BTreeMap<String, String>,
    /// The program under test.
    pub program: Program,
    /// Conventions in which the program differs from the fixtures. They are not mistakes: its answers were translated.
    pub conventions: Vec<Convention>,
    /// What is wrong with the conventions in its hello, in words.
    pub convention_errors: Vec<String>,
    /// Lines on its standard output that are not JSON objects.
    pub chatter: Chatter,
    /// What it can attain, at which its answers are judged.
    pub precision: PrecisionResult,
    /// What was wrong with the form of its answers.
    pub remarks: Vec<Remark>,
    /// What the examination came to.
    pub verdict: Conclusion,
    /// Whether no answer failed, had fewer digits than demanded, or changed when asked for again, and something is implemented. Invalid
    /// states are judged under `refusal`.
    pub passes: bool,
    /// Evidence that answers depend on what was asked before; null if none was found. No equation is blamed for a quantity in it.
    pub memory: Option<Memory>,
    /// Quantities for which it does not read any value that it is given, although it says that it does.
    pub given_ignored: Vec<&'static str>,
    /// Whether a part was asked, as the user chose.
    pub asked_in_part: bool,
    /// Whether it refuses invalid states.
    pub refusal: Refusal,
    /// Quantities that it answers in some cases and says it does not implement in others.
    pub partly_checked: Vec<PartlyChecked>,
    /// Tags of which it leaves out every state, in all quantities that it implements; those that leave out the most states first.
    pub left_out: Vec<String>,
    /// The culprit to look at first; null if there is none.
    pub first_wrong: Option<CulpritResult>,
    /// Quantities that are wrong although their inputs are right, inputs before the quantities that use them.
    pub culprits: Vec<CulpritResult>,
    /// Quantities without numbers in any case. Whether their equations are wrong is unknown.
    pub silent: Vec<&'static str>,
    /// Wrong quantities with a wrong input.
    pub follow: Vec<Follower>,
    /// Results by quantity, in the order of the questions.
    pub quantities: Vec<QuantityResult>,
    /// Counts by tag over all quantities. `invalid` counts the states that must be refused.
    pub tags: BTreeMap<String, Counts>,
    /// Results for the states that must be refused.
    pub invalid: Vec<InvalidResult>,
    /// Number of questions.
    pub questions: usize,
    /// Number of times that the program was started.
    pub starts: usize,
    /// Duration of the examination, s.
    pub seconds: f64,
}

/// What an examination came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Conclusion {
    /// Every answer is right.
    Right,
    /// Every answer is right, but quantities that it implements were left out in some states.
    PartlyChecked,
    /// Some answers are wrong, or missing for another reason than `not_implemented`.
    Wrong,
    /// It did not answer hello, and nothing was asked.
    NoAnswer,
    /// It implements nothing of what was asked.
    NothingChecked,
}

/// Whether a program refuses the states that must be refused. This is a verdict of its own: right equations stay right.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Refusal {
    /// What it comes to.
    pub verdict: RefusalVerdict,
    /// Number of states that it refused.
    pub refused: usize,
    /// Number of states that it answered with a value.
    pub accepted: usize,
    /// Number of states at which it hung, crashed or wrote something else in place of an answer.
    pub no_answer: usize,
    /// Number of states.
    pub of: usize,
}

/// What the refusals of a program come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RefusalVerdict {
    /// It refused every state that was asked.
    Acceptable,
    /// It should refuse more.
    ShouldRefuse,
    /// It was asked none.
    NotAsked,
}

/// A quantity of which only a part was checked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PartlyChecked {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Number of cases with an answer.
    pub checked: usize,
    /// Number of cases.
    pub of: usize,
}

/// The program under test.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Program {
    /// Name that the program gives itself; its command if it did not answer hello.
    pub name: String,
    /// Whether it accepts intermediate values.
    pub given: bool,
    /// What came in place of an answer to hello; null if it answered.
    pub no_hello: Option<String>,
    /// Names in hello that are not asked for.
    pub unknown: Vec<String>,
}

/// Precision of a program's answers.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PrecisionResult {
    /// The precision in words, such as "single precision" or "six significant digits printed".
    pub kind: String,
    /// Whether the size of the errors shows it; otherwise all numbers have the form.
    pub by_errors: bool,
    /// Quantities with answers of another precision.
    pub others: Vec<OtherPrecision>,
    /// Correct digits of the worst right answer, at most 16; null without right answers.
    #[schemars(range(min = 0, max = 16))]
    pub least_digits: Option<f64>,
    /// Median of the correct digits of right answers, at most 16; null without right answers.
    #[schemars(range(min = 0, max = 16))]
    pub median_digits: Option<f64>,
    /// Case in which the least digits can be attained; null in double precision.
    pub least_attainable: Option<LeastAttainable>,
    /// Mistakes that would be seen in double precision, but not in these answers.
    pub invisible: Vec<Invisible>,
    /// Digits that every answer must have; null if none are demanded.
    pub demanded: Option<u8>,
    /// Quantities that have fewer digits than demanded.
    pub fewer: Vec<FewerDigits>,
}

/// Quantities whose answers have another precision than most.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OtherPrecision {
    /// Their precision in words.
    pub kind: String,
    /// Names of the quantities.
    pub quantities: Vec<&'static str>,
}

/// Case in which a program can attain the least digits.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LeastAttainable {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Name of the case.
    pub case: String,
    /// Digits of the tolerance, relative to the size of the terms that are added up.
    #[schemars(range(min = 0, max = 16))]
    pub digits: f64,
    /// What takes the other digits.
    pub because: &'static str,
}

/// A quantity that has fewer digits than demanded.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FewerDigits {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Name of the case with the fewest digits.
    pub case: String,
    /// Correct digits in this case.
    #[schemars(range(min = 0, max = 16))]
    pub digits: f64,
}

/// A quantity that is wrong although its inputs are right.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CulpritResult {
    /// The quantity, with the evidence that it is wrong.
    #[serde(flatten)]
    pub blame: blame::Culprit,
    /// Number of its equation in the paper, or a word for an equation that the paper omits.
    pub equation: &'static str,
    /// The mistakes that explain it.
    #[serde(flatten)]
    pub diagnosis: Diagnosis,
    /// Earlier quantities that are not answered and that the mistake may be in, likeliest first. If there are any, whether the quantity
    /// itself is wrong is unknown.
    pub ancestors: Vec<Ancestor>,
    /// Its formula, and where the paper prints another one.
    pub look_at: &'static str,
    /// Earlier culprit that shows the same mistake; null if there is none.
    pub same_as: Option<&'static str>,
}

/// Counts of cases.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Counts {
    /// Number of right answers.
    pub pass: usize,
    /// Number of wrong answers and of answers without numbers of the right shape.
    pub fail: usize,
    /// Number of answers that are not implemented.
    pub not_implemented: usize,
    /// Correct digits of the worst answer that has numbers, at most 16; null without numbers.
    #[schemars(range(min = 0, max = 16))]
    pub digits: Option<f64>,
}

/// Result for one quantity.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct QuantityResult {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Number of its equation in the paper, or a word for an equation that the paper omits.
    pub equation: &'static str,
    /// Counts of its cases.
    #[serde(flatten)]
    pub counts: Counts,
    /// Number of cases with a value in the fixtures, asked or not.
    pub in_fixture: usize,
    /// Names of the failing cases.
    pub failing: Vec<String>,
    /// The failing case with the fewest tags; null if none fails.
    pub smallest_failing: Option<FailingCase>,
    /// The first three different faults.
    pub faults: Vec<CaseFault>,
    /// Short names of all faults.
    #[serde(skip)]
    pub fault_words: BTreeSet<&'static str>,
}

/// A failing case.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FailingCase {
    /// Name of the case.
    pub case: String,
    /// Tags of the case.
    pub tags: Vec<String>,
    /// How it fails.
    #[serde(flatten)]
    pub failure: Failure,
}

/// How a case fails.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Failure {
    /// Some numbers are out of tolerance.
    Wrong {
        /// Index of the worst entry, row by row through all nested lists, counted from 0.
        entry: usize,
        /// Place of the worst entry in the nested lists, outer list first, counted from 0; empty for a number.
        index: Vec<usize>,
        /// Answer in the worst entry, in the quantity's unit.
        answered: f64,
        /// Reference value of the worst entry, in the quantity's unit.
        expected: f64,
        /// Correct digits of the worst entry.
        #[schemars(range(min = 0, max = 16))]
        digits: f64,
    },
    /// There are no numbers to compare.
    Fault {
        /// What came in place of numbers, in words.
        fault: String,
    },
}

/// A fault in one case.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CaseFault {
    /// Name of the case.
    pub case: String,
    /// What came in place of numbers.
    pub fault: Fault,
}

/// Result for a state that must be refused.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct InvalidResult {
    /// The state.
    #[serde(flatten)]
    pub case: InvalidCase,
    /// What the program did.
    #[serde(flatten)]
    pub verdict: InvalidVerdict,
}

impl Report {
    /// Writes the report on an examination with the questions of `suite`.
    pub fn new(suite: &Suite, examination: &Examination) -> Report {
        let culprits = culprits(&examination.blame, &examination.diagnoses, &examination.ancestors);
        let hello = examination.hello.as_ref();
        let partly_checked = partly_checked(examination);
        Report {
            schema: SCHEMA,
            run: String::new(),
            ancf: env!("CARGO_PKG_VERSION"),
            fixtures: suite.versions.clone(),
            program: Program {
                name: examination.name().into(),
                given: hello.is_ok_and(|hello| hello.given),
                no_hello: hello.err().map(ToString::to_string),
                unknown: hello.into_iter().flat_map(Hello::unknown).map(String::from).collect(),
            },
            conventions: examination.conventions.clone(),
            convention_errors: examination.convention_errors.clone(),
            chatter: examination.chatter.clone(),
            precision: PrecisionResult::new(examination),
            remarks: examination.remarks.clone(),
            verdict: Conclusion::of(examination, &partly_checked),
            passes: examination.passes(),
            memory: examination.memory.clone(),
            given_ignored: examination.given_ignored.clone(),
            asked_in_part: examination.in_part,
            refusal: Refusal::of(examination),
            partly_checked,
            left_out: left_out(suite, examination),
            first_wrong: culprits.iter().find(|culprit| culprit.blame.numbers).or(culprits.first()).cloned(),
            culprits,
            silent: examination.blame.silent.clone(),
            follow: examination.blame.follow.clone(),
            quantities: examination.verdicts.iter().map(|(id, cases)| QuantityResult::new(suite, id, cases)).collect(),
            tags: counts_by_tag(suite, examination),
            invalid: (suite.invalid.iter().zip(&examination.invalid))
                .map(|(case, verdict)| InvalidResult { case: case.clone(), verdict: verdict.clone() })
                .collect(),
            questions: examination.questions,
            starts: examination.starts,
            seconds: examination.seconds,
        }
    }
}

impl Report {
    /// Demands a number of correct digits of every answer that has numbers. The program fails if one has fewer.
    pub fn demand(&mut self, suite: &Suite, examination: &Examination, digits: u8) {
        let fewer = examination.verdicts.iter().filter_map(|(quantity, cases)| {
            let with_digits = cases.iter().filter_map(|(n, verdict)| Some((*n, verdict.digits()?)));
            let (n, least) = with_digits.min_by(|a, b| a.1.total_cmp(&b.1))?;
            let case = suite.cases.get(n)?.id.clone();
            (least < f64::from(digits)).then(|| FewerDigits { quantity, case, digits: rounded_down(least) })
        });
        self.precision.demanded = Some(digits);
        self.precision.fewer = fewer.collect();
        if !self.precision.fewer.is_empty() {
            self.passes = false;
            self.verdict = Conclusion::Wrong;
        }
    }
}

impl PrecisionResult {
    fn new(examination: &Examination) -> PrecisionResult {
        let precision = &examination.precision;
        let right = examination.verdicts.iter().flat_map(|(_, cases)| cases).filter(|(_, verdict)| verdict.passes());
        let mut digits: Vec<f64> = right.filter_map(|(_, verdict)| verdict.digits()).collect();
        digits.sort_by(f64::total_cmp);
        let mut others: BTreeMap<_, Vec<&'static str>> = BTreeMap::new();
        for (quantity, form) in &precision.others {
            others.entry(*form).or_default().push(quantity);
        }
        let others = others.into_iter().map(|(form, quantities)| OtherPrecision { kind: form.words(), quantities });
        PrecisionResult {
            kind: precision.form.words(),
            by_errors: precision.by_errors,
            others: others.collect(),
            least_digits: digits.first().copied().map(rounded),
            median_digits: digits.get(digits.len() / 2).copied().map(rounded),
            least_attainable: precision.least.as_ref().map(|least| LeastAttainable {
                quantity: least.quantity,
                case: least.case.clone(),
                digits: rounded(least.digits),
                because: least.because,
            }),
            invisible: examination.invisible.clone(),
            demanded: None,
            fewer: Vec::new(),
        }
    }
}

impl Conclusion {
    fn of(examination: &Examination, partly_checked: &[PartlyChecked]) -> Conclusion {
        let asked = examination.implemented() > 0
            || examination.invalid.iter().any(|verdict| verdict.outcome != InvalidOutcome::NotImplemented);
        match examination.passes() {
            _ if examination.hello.is_err() => Conclusion::NoAnswer,
            _ if !asked => Conclusion::NothingChecked,
            false => Conclusion::Wrong,
            true if partly_checked.is_empty() => Conclusion::Right,
            true => Conclusion::PartlyChecked,
        }
    }
}

impl Refusal {
    fn of(examination: &Examination) -> Refusal {
        let count = |wanted| examination.invalid.iter().filter(|verdict| verdict.outcome == wanted).count();
        let (refused, accepted, no_answer) =
            (count(InvalidOutcome::Refused), count(InvalidOutcome::Accepted), count(InvalidOutcome::Fault));
        let verdict = match (refused, accepted + no_answer) {
            _ if examination.hello.is_err() => RefusalVerdict::NotAsked,
            (0, 0) => RefusalVerdict::NotAsked,
            (_, 0) => RefusalVerdict::Acceptable,
            (_, _) => RefusalVerdict::ShouldRefuse,
        };
        Refusal { verdict, refused, accepted, no_answer, of: examination.invalid.len() }
    }
}

/// Number of cases that a program implements.
fn implemented(cases: &[CaseVerdict]) -> usize {
    cases.iter().filter(|(_, verdict)| *verdict != Verdict::NotImplemented).count()
}

/// Quantities that are implemented in some cases only. A quantity without any answer is not implemented, which is said elsewhere.
fn partly_checked(examination: &Examination) -> Vec<PartlyChecked> {
    let quantities = examination.verdicts.iter().map(|(quantity, cases)| PartlyChecked {
        quantity,
        checked: implemented(cases),
        of: cases.len(),
    });
    quantities.filter(|row| 0 < row.checked && row.checked < row.of).collect()
}

/// Tags of which every state is left out. If the states of one tag are all that is left out, it is the only one.
fn left_out(suite: &Suite, examination: &Examination) -> Vec<String> {
    let (mut left, mut answered) = (BTreeSet::new(), BTreeSet::new());
    for (_, cases) in examination.verdicts.iter().filter(|(_, cases)| implemented(cases) > 0) {
        for (n, verdict) in cases {
            if *verdict == Verdict::NotImplemented {
                left.insert(*n)
            } else {
                answered.insert(*n)
            };
        }
    }
    left.retain(|n| !answered.contains(n));
    let mut by_tag: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for n in &left {
        for tag in suite.cases.get(*n).iter().flat_map(|case| &case.tags) {
            by_tag.entry(tag).or_default().insert(*n);
        }
    }
    by_tag.retain(|tag, _| {
        !answered.iter().any(|n| suite.cases.get(*n).is_some_and(|case| case.tags.iter().any(|t| t == tag)))
    });
    if let Some((tag, _)) = by_tag.iter().find(|(_, cases)| **cases == left) {
        return vec![(*tag).to_string()];
    }
    let mut tags: Vec<_> = by_tag.into_iter().collect();
    tags.sort_by_key(|(_, cases)| std::cmp::Reverse(cases.len()));
    tags.into_iter().map(|(tag, _)| tag.to_string()).collect()
}

/// Culprits with their diagnoses. One that shows the mistake of an earlier culprit refers to it.
fn culprits(
    blame: &Blame,
    diagnoses: &BTreeMap<&str, Diagnosis>,
    ancestors: &BTreeMap<&str, Vec<Ancestor>>,
) -> Vec<CulpritResult> {
    let mut culprits: Vec<CulpritResult> = Vec::new();
    for culprit in &blame.culprits {
        let diagnosis = diagnoses.get(culprit.quantity).cloned().unwrap_or_default();
        let equation = equation(culprit.quantity);
        let mut own = CulpritResult {
            blame: culprit.clone(),
            equation,
            diagnosis,
            ancestors: ancestors.get(culprit.quantity).cloned().unwrap_or_default(),
            look_at: formula(culprit.quantity),
            same_as: None,
        };
        let same = culprits.iter().find(|other| other.same_as.is_none() && other.shared_mistake(&own).is_some());
        own.same_as = same.map(|other| other.blame.quantity);
        culprits.push(own);
    }
    culprits
}

impl CulpritResult {
    /// First mistake that explains both culprits.
    pub(super) fn shared_mistake(&self, other: &CulpritResult) -> Option<&Mistake> {
        let shared = |mistake: &&Mistake| other.diagnosis.mistakes.contains(mistake) && mistake.what != ZEROS;
        self.diagnosis.mistakes.iter().find(shared)
    }
}

impl Counts {
    fn add(&mut self, verdict: &Verdict) {
        match verdict {
            Verdict::Pass { .. } => self.pass += 1,
            Verdict::NotImplemented => self.not_implemented += 1,
            Verdict::Wrong(_) | Verdict::Fault(_) => self.fail += 1,
        }
        let digits = self.digits.into_iter().chain(verdict.digits().map(rounded));
        self.digits = digits.reduce(f64::min);
    }
}

/// Digits to one decimal; adding zero turns −0 into 0.
fn rounded(digits: f64) -> f64 {
    (digits * 10.0).round() / 10.0 + 0.0
}

/// Digits to one decimal, never more than there are.
fn rounded_down(digits: f64) -> f64 {
    (digits * 10.0).floor() / 10.0
}

fn counts_by_tag(suite: &Suite, examination: &Examination) -> BTreeMap<String, Counts> {
    let mut counts: BTreeMap<String, Counts> = BTreeMap::new();
    for (n, verdict) in examination.verdicts.iter().flat_map(|(_, cases)| cases) {
        for tag in suite.cases.get(*n).iter().flat_map(|case| &case.tags) {
            counts.entry(tag.clone()).or_default().add(verdict);
        }
    }
    for verdict in &examination.invalid {
        let invalid = counts.entry("invalid".into()).or_default();
        match verdict.outcome {
            InvalidOutcome::Refused => invalid.pass += 1,
            InvalidOutcome::NotImplemented => invalid.not_implemented += 1,
            InvalidOutcome::Accepted | InvalidOutcome::Fault => invalid.fail += 1,
        }
    }
    counts
}

impl QuantityResult {
    fn new(suite: &Suite, quantity: &'static str, cases: &[CaseVerdict]) -> QuantityResult {
        let mut counts = Counts::default();
        cases.iter().for_each(|(_, verdict)| counts.add(verdict));
        let failing = cases.iter().filter(|(_, verdict)| verdict.fails()).filter_map(|(n, _)| suite.cases.get(*n));
        let mut faults: Vec<CaseFault> = Vec::new();
        for (n, verdict) in cases {
            if let (Verdict::Fault(fault), Some(case)) = (verdict, suite.cases.get(*n))
                && faults.len() < MOST_FAULTS
                && !faults.iter().any(|listed| listed.fault == *fault)
            {
                faults.push(CaseFault { case: case.id.clone(), fault: fault.clone() });
            }
        }
        QuantityResult {
            quantity,
            equation: equation(quantity),
            counts,
            in_fixture: suite.cases.iter().filter(|case| case.values.contains_key(quantity)).count(),
            failing: failing.map(|case| case.id.clone()).collect(),
            smallest_failing: smallest_failing(suite, cases)
                .and_then(|(n, verdict)| FailingCase::new(suite, quantity, *n, verdict)),
            faults,
            fault_words: fault_words(cases),
        }
    }
}

/// Failing case with the fewest tags: the fewest possible causes. Cases that were asked precede those that were not.
fn smallest_failing<'a>(suite: &Suite, cases: &'a [CaseVerdict]) -> Option<&'a CaseVerdict> {
    let tags = |n: usize| suite.cases.get(n).map_or(usize::MAX, |case| case.tags.len());
    cases.iter().filter(|(_, verdict)| verdict.fails()).min_by_key(|(n, verdict)| {
        let unasked = matches!(verdict, Verdict::Fault(Fault::NotAsked(_)));
        (unasked, tags(*n), *n)
    })
}

/// Short names of all faults. That a case was not asked is listed only if there is no other fault.
fn fault_words(cases: &[CaseVerdict]) -> BTreeSet<&'static str> {
    let faults = cases.iter().filter_map(|(_, verdict)| match verdict {
        Verdict::Fault(fault) => Some(fault),
        _ => None,
    });
    let (unasked, other): (Vec<&Fault>, Vec<&Fault>) = faults.partition(|fault| matches!(fault, Fault::NotAsked(_)));
    let listed = if other.is_empty() { unasked } else { other };
    listed.into_iter().map(Fault::word).collect()
}

impl FailingCase {
    fn new(suite: &Suite, quantity: &str, n: usize, verdict: &Verdict) -> Option<FailingCase> {
        let case = suite.cases.get(n)?;
        let failure = match verdict {
            Verdict::Wrong(wrong) => Failure::Wrong {
                entry: wrong.entry,
                index: index(wrong.entry, &case.values.get(quantity)?.shape),
                answered: wrong.answered,
                expected: wrong.expected,
                digits: rounded(wrong.digits),
            },
            Verdict::Fault(fault) => Failure::Fault { fault: fault.to_string() },
            Verdict::Pass { .. } | Verdict::NotImplemented => return None,
        };
        Some(FailingCase { case: case.id.clone(), tags: case.tags.clone(), failure })
    }
}

/// Place of an entry in nested lists of a shape.
fn index(entry: usize, shape: &[usize]) -> Vec<usize> {
    let mut left = entry;
    let mut index: Vec<usize> = shape
        .iter()
        .rev()
        .map(|length| {
            let place = left % length;
            left /= length;
            place
        })
        .collect();
    index.reverse();
    index
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnosis::MistakeKind;

    #[test]
    fn the_index_of_an_entry_is_that_of_nested_lists() {
        assert!(index(0, &[]).is_empty());
        assert_eq!(index(17, &[2, 3, 4]), [1, 1, 1]);
        assert_eq!(index(23, &[2, 3, 4]), [1, 2, 3]);
    }

    #[test]
    fn a_case_that_was_not_asked_is_not_the_smallest() {
        let suite = Suite::embedded().unwrap();
        let tags = |n: &usize| suite.cases[*n].tags.len();
        let (few, many) = ((0..36).min_by_key(tags).unwrap(), (0..36).max_by_key(tags).unwrap());
        let fault = |n, fault: fn(String) -> Fault| (n, Verdict::Fault(fault(String::new())));
        let cases = [fault(few, Fault::NotAsked), fault(many, Fault::Crash)];
        assert_eq!(smallest_failing(&suite, &cases), Some(&cases[1]));
        assert_eq!(smallest_failing(&suite, &cases[..1]), Some(&cases[0]));
    }

    #[test]
    fn a_shared_mistake_refers_to_the_first_culprit_that_shows_it() {
        let mistake = |kind, what: &str| Mistake { kind, what: what.into() };
        let half = mistake(MistakeKind::Factor, "all of it half");
        let sign = mistake(MistakeKind::Sign, "all of it with the wrong sign");
        let zero = mistake(MistakeKind::Missing, ZEROS);
        let shown: [(&'static str, &[&Mistake]); 5] = [
            ("21.S_a1", &[&half, &zero]),
            ("21.S_b1", &[&half, &sign]),
            ("21.S_c1", &[&sign]),
            ("21.K_1", &[&zero]),
            ("21.K_2", &[&sign]),
        ];
        let blamed = |quantity| blame::Culprit { quantity, numbers: true, because: String::new() };
        let diagnosis = |mistakes: &[&Mistake]| Diagnosis {
            mistakes: mistakes.iter().copied().cloned().collect(),
            ..Diagnosis::default()
        };
        let blame = Blame { culprits: shown.map(|(quantity, _)| blamed(quantity)).into(), ..Blame::default() };
        let diagnoses = shown.map(|(quantity, mistakes)| (quantity, diagnosis(mistakes))).into();
        let same: Vec<_> =
            culprits(&blame, &diagnoses, &BTreeMap::new()).iter().map(|culprit| culprit.same_as).collect();
        assert_eq!(same, [None, Some("21.S_a1"), None, None, Some("21.S_c1")]);
    }
}
