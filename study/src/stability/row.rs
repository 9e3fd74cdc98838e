//! One row of the table: a value of the swept parameter, the error, its bound and the verdict.

use serde::Serialize;

use ancf::integrators::Counts;

/// Verdict of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Verdict {
    /// Within the bound.
    #[serde(rename = "right")]
    Right,
    /// Within the bound, with a warning from the run.
    #[serde(rename = "right with warning")]
    Warned,
    /// No result, but an error with the reason.
    #[serde(rename = "refused")]
    Refused,
    /// A result outside its bound, a useless one without a warning, or a refusal without its reason.
    #[serde(rename = "WRONG")]
    Wrong,
}

impl Verdict {
    /// The word in the table.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Warned => "right with warning",
            Verdict::Refused => "refused",
            Verdict::Wrong => "WRONG",
        }
    }
}

/// Result of one trial of a case.
#[derive(Clone, Debug, Serialize)]
pub struct StabilityRow {
    /// Name of the case.
    pub case: &'static str,
    /// Method, element, mesh.
    pub variant: String,
    /// The swept parameter.
    pub parameter: &'static str,
    /// Its value.
    pub value: f64,
    /// Distance from the reference; `None` without a result.
    pub error: Option<f64>,
    /// Largest error that is right.
    pub bound: Option<f64>,
    /// Size of the measured quantity.
    pub size: Option<f64>,
    /// Whether the bound is more than a hundredth of the size: such a row shows little.
    pub loose: bool,
    /// Unit of error, bound and size.
    pub unit: &'static str,
    /// Parts of the bound, in numbers.
    pub why: String,
    /// Error of another form, shown for comparison and not judged.
    pub beside: Option<f64>,
    /// Work of the run.
    pub counts: Counts,
    /// The verdict.
    pub verdict: Verdict,
    /// The refusal or the warnings.
    pub note: String,
}

impl StabilityRow {
    /// The parameter's value with its digits, so that a value close to a limit differs from the limit; four digits if that is too long.
    pub fn shown(&self) -> String {
        let (value, size) = (self.value, self.value.abs());
        let plain = (1e-3..1e5).contains(&size) || size == 0.0 || !value.is_finite();
        let whole = if plain { format!("{value}") } else { format!("{value:e}") };
        match whole.len() {
            0..=16 => whole,
            _ if plain => format!("{value:.4}"),
            _ => format!("{value:.3e}"),
        }
    }

    /// The row in one line.
    pub fn line(&self) -> String {
        let StabilityRow { case, variant, parameter, unit, .. } = self;
        let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
        let (value, error, bound) = (self.shown(), number(self.error), number(self.bound));
        let note = if self.note.is_empty() { String::new() } else { format!(": {}", self.note) };
        let verdict = self.verdict.word();
        format!("{case}, {variant}, {parameter} = {value}: error {error} {unit}, bound {bound}, {verdict}{note}")
    }
}
