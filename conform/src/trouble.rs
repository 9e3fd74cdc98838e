//! Troubles with the form of answers: they are read all the same, and said.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

/// A trouble with the form of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Trouble {
    /// Numbers with Fortran's exponents, such as 0.1D+01.
    FortranExponent,
    /// Numbers that a leading dot or a trailing dot, such as .5 and 1.
    BareDecimalPoint,
    /// Numbers with a plus sign, such as +1.
    PlusSign,
    /// NaN or infinity, which JSON does not have.
    NotFinite,
    /// A comma behind the last entry of a list or an object.
    TrailingComma,
    /// Strings in single quotes.
    SingleQuotes,
    /// Words of Python: True, False, None.
    PythonWords,
    /// An answer over several lines.
    SeveralLines,
    /// Several answers on a line.
    SeveralOnALine,
    /// Other text on the line of an answer.
    TextAround,
    /// A byte order mark at the beginning of a line.
    ByteOrderMark,
    /// Questions without an answer in the files.
    Unanswered,
    /// Answers to questions that are not asked.
    UnknownId,
    /// A last line that is cut off.
    CutOff,
}

impl Trouble {
    /// The trouble in words, for a sentence about `count` lines.
    pub(crate) fn what(self) -> &'static str {
        match self {
            Trouble::FortranExponent => "numbers with Fortran's exponents (`0.1D+01`)",
            Trouble::BareDecimalPoint => "numbers with a leading dot or a trailing dot (`.5`, `1.`)",
            Trouble::PlusSign => "numbers with a plus sign (`+1`)",
            Trouble::NotFinite => "NaN or infinity, which JSON does not have",
            Trouble::TrailingComma => "a comma behind the last entry",
            Trouble::SingleQuotes => "strings in single quotes",
            Trouble::PythonWords => "Python's words for true, false and null",
            Trouble::SeveralLines => "answers over several lines",
            Trouble::SeveralOnALine => "several answers on a line",
            Trouble::TextAround => "other text on the line of an answer",
            Trouble::ByteOrderMark => "a byte order mark",
            Trouble::Unanswered => "questions without an answer",
            Trouble::UnknownId => "answers to questions that are not asked",
            Trouble::CutOff => "a last line that is cut off",
        }
    }

    /// What to do about it.
    pub(crate) fn advice(self) -> &'static str {
        match self {
            Trouble::FortranExponent => "Write an E for the D: format (ES25.17E3)",
            Trouble::BareDecimalPoint => "Write digits on both sides of the point: 0.5, 1.0",
            Trouble::PlusSign => "Leave the plus sign out",
            Trouble::NotFinite => "Answer `error` with the reason where there is no value",
            Trouble::TrailingComma => "Write commas between entries only",
            Trouble::SingleQuotes => "Write strings in double quotes, or use a JSON writer (Python: json.dumps)",
            Trouble::PythonWords => "Use a JSON writer: json.dumps, not str or repr",
            Trouble::SeveralLines => "Write each answer on one line, without indentation",
            Trouble::SeveralOnALine => "End each answer with a line feed",
            Trouble::TextAround => "Write prompts and messages to standard error",
            Trouble::ByteOrderMark => "Write UTF-8 without a byte order mark",
            Trouble::Unanswered => "They count as not implemented",
            Trouble::UnknownId => "Repeat the id of the question letter by letter",
            Trouble::CutOff => "It was left out",
        }
    }
}

/// A trouble, how often it came, and where first.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Remark {
    /// The trouble.
    pub trouble: Trouble,
    /// Number of lines with it.
    pub lines: usize,
    /// Beginning of the first line with it.
    pub first: String,
}

/// All troubles so far.
#[derive(Clone, Debug, Default)]
pub struct Troubles(BTreeMap<Trouble, (usize, String)>);

impl Troubles {
    /// Notes a trouble of a line.
    pub fn add(&mut self, trouble: Trouble, line: &str) {
        self.0.entry(trouble).or_insert_with(|| (0, crate::quotation::quoted(line))).0 += 1;
    }

    /// The troubles as a list.
    pub fn remarks(&self) -> Vec<Remark> {
        let remark = |(trouble, (lines, first)): (&Trouble, &(usize, String))| Remark {
            trouble: *trouble,
            lines: *lines,
            first: first.clone(),
        };
        self.0.iter().map(remark).collect()
    }
}
