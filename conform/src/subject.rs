//! What is examined: a program in a process of its own, or code of this one.

use schemars::JsonSchema;
use serde::Serialize;

use crate::protocol::{Answer, Asked, Hello, Question};
use crate::trouble::Remark;
use crate::verdict::Fault;

/// What is examined. [`Program`](crate::Program) asks a process, [`Code`] a closure.
pub trait Subject {
    /// Introduces itself. `announcement` is [`Question::Hello`].
    ///
    /// # Errors
    /// The fault that came in place of an answer. Then nothing is asked.
    fn hello(&mut self, announcement: &Question) -> Result<Hello, Fault>;

    /// Answers a question.
    ///
    /// # Errors
    /// The fault that came in place of an answer.
    fn ask(&mut self, question: &Asked) -> Result<Answer, Fault>;

    /// Whether a question can be asked twice. Answers that were recorded cannot.
    fn can_repeat(&self) -> bool {
        true
    }

    /// Forgets everything that was asked before, as a fresh process does; `false` if it cannot.
    fn restart(&mut self) -> bool {
        false
    }

    /// What it is called in the report if its hello has no name.
    fn description(&self) -> String {
        "a program without a name".into()
    }

    /// Number of starts.
    fn starts(&self) -> usize {
        1
    }

    /// Lines on its standard output that are not JSON objects.
    fn chatter(&self) -> Chatter {
        Chatter::default()
    }

    /// What was wrong with the form of its answers.
    fn remarks(&self) -> Vec<Remark> {
        Vec::new()
    }
}

/// Lines on standard output that are not JSON objects.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Chatter {
    /// Beginning of the first line.
    pub first: String,
    /// Number of lines.
    pub lines: usize,
    /// Beginning of the last line.
    #[serde(skip)]
    pub last: String,
}

impl Chatter {
    pub(crate) fn add(&mut self, words: &str) {
        if self.lines == 0 {
            self.first = words.into();
        }
        self.last = words.into();
        self.lines += 1;
    }
}

/// Code of this process, for a unit test: a closure that answers questions.
///
/// ```
/// use ancf_conform::{Answer, Asked, Code, Options, Report, Suite, examine};
///
/// /// Our Lamé constants of (17).
/// fn answer(question: &Asked) -> Answer {
///     let number = |key: &str| question.state[key].as_f64().unwrap_or(f64::NAN);
///     let (e, nu) = (number("E"), number("nu"));
///     if !(e > 0.0 && -1.0 < nu && nu < 0.5) {
///         return Answer::Error(format!("E = {e}, nu = {nu}; allowed: E > 0, -1 < nu < 0.5"));
///     }
///     match question.equation {
///         "17.lambda" => Answer::value(e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))),
///         "17.mu" => Answer::value(e / (2.0 * (1.0 + nu))),
///         _ => Answer::NotImplemented,
///     }
/// }
///
/// let suite = Suite::embedded()?;
/// let mut mine = Code::new("mine", answer).with_quantities(["17.lambda", "17.mu"]);
/// let report = Report::new(&suite, &examine(&suite, &mut mine, Options::default(), |_| {}));
/// assert!(report.first_wrong.is_none(), "{}", report.markdown());
/// # Ok::<(), ancf_conform::Error>(())
/// ```
pub struct Code<F> {
    hello: Hello,
    answer: F,
}

impl<F: FnMut(&Asked) -> Answer> Code<F> {
    /// Code that answers with `answer`, called `name` in the report.
    pub fn new(name: impl Into<String>, answer: F) -> Code<F> {
        Code { hello: Hello { name: Some(name.into()), ..Hello::default() }, answer }
    }

    /// Has the code asked for these quantities only.
    #[must_use]
    pub fn with_quantities<'a>(mut self, quantities: impl IntoIterator<Item = &'a str>) -> Code<F> {
        self.hello.quantities = Some(quantities.into_iter().map(String::from).collect());
        self
    }

    /// Says that the code computes with the values of other quantities in [`Asked::given`].
    #[must_use]
    pub fn with_given(mut self) -> Code<F> {
        self.hello.given = true;
        self
    }
}

impl<F: FnMut(&Asked) -> Answer> Subject for Code<F> {
    fn hello(&mut self, _: &Question) -> Result<Hello, Fault> {
        Ok(self.hello.clone())
    }

    fn ask(&mut self, question: &Asked) -> Result<Answer, Fault> {
        Ok((self.answer)(question))
    }
}
