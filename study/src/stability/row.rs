//! One row of the table: a value of the swept parameter, its error beside its bound, and the verdict.

use std::io::{self, Write};

use serde::Serialize;

use ancf::integrators::counts::Counts;

/// What a row comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Verdict {
    /// Within the bound.
    #[serde(rename = "right")]
    Right,
    /// Within the bound, and the run says what to doubt.
    #[serde(rename = "right with warning")]
    Warned,
    /// There is no result, but an error that says why.
    #[serde(rename = "refused")]
    Refused,
    /// A result outside of the bound, one that is useless without saying so, or a refusal without its reason.
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

/// One row.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the case.
    pub case: &'static str,
    /// Method, element, mesh.
    pub variant: String,
    /// What is swept.
    pub parameter: &'static str,
    /// Its value.
    pub value: f64,
    /// Distance from the reference; `None` where there is no result.
    pub error: Option<f64>,
    /// What the error may be.
    pub bound: Option<f64>,
    /// Size of what is measured.
    pub size: Option<f64>,
    /// Whether the bound is more than a hundredth of that: such a row shows little.
    pub loose: bool,
    /// Unit of error, bound and size.
    pub unit: &'static str,
    /// What the bound is made of, in numbers.
    pub why: String,
    /// The error of another form, shown beside it and not judged.
    pub beside: Option<f64>,
    /// The work that was done.
    pub counts: Counts,
    /// What it comes to.
    pub verdict: Verdict,
    /// The refusal or the warnings.
    pub note: String,
}

impl Row {
    /// The parameter's value as it was chosen, so that what is swept towards a limit can be told from the limit; four digits of one
    /// that was computed.
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

    /// The row in a line.
    pub fn line(&self) -> String {
        let Row { case, variant, parameter, unit, .. } = self;
        let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
        let (error, bound) = (number(self.error), number(self.bound));
        let note = if self.note.is_empty() { String::new() } else { format!(": {}", self.note) };
        let verdict = self.verdict.word();
        let value = self.shown();
        format!("{case}, {variant}, {parameter} = {value}: error {error} {unit}, bound {bound}, {verdict}{note}")
    }
}

/// Writes `stability.csv`.
///
/// # Errors
/// What `out` reports.
pub fn write<'a>(out: &mut dyn Write, rows: impl Iterator<Item = &'a Row>) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    csv.write_record([
        "case",
        "variant",
        "parameter",
        "value",
        "error",
        "bound",
        "unit",
        "size",
        "verdict",
        "beside",
        "steps",
        "newton_iterations",
        "force_calls",
        "tangent_calls",
        "factorizations",
        "solves",
        "why",
        "note",
    ])?;
    let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:?}"));
    for row in rows {
        let Counts { steps, newton_iterations, force_calls, tangent_calls, factorizations, solves, .. } = row.counts;
        let counts = [steps, newton_iterations, force_calls, tangent_calls, factorizations, solves];
        let head = [row.case.into(), row.variant.clone(), row.parameter.into(), format!("{:?}", row.value)];
        let measured = [number(row.error), number(row.bound), row.unit.into(), number(row.size)];
        let judged = [row.verdict.word().into(), number(row.beside)];
        let counts = counts.map(|count| count.to_string());
        let words = [row.why.clone(), row.note.clone()];
        csv.write_record(head.iter().chain(&measured).chain(&judged).chain(&counts).chain(&words))?;
    }
    csv.flush()
}
