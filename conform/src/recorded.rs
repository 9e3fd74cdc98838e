//! Answers that were recorded, and their recording: for programs that are slow, or closed, or end before all is asked.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::error::{Error, Result};
use crate::lines::Lines;
use crate::protocol::{AGAIN, Answer, AnswerLine, Asked, Hello, Question};
use crate::quotation::quoted;
use crate::subject::{Chatter, Subject};
use crate::suite::Suite;
use crate::trouble::{Remark, Trouble};
use crate::verdict::Fault;

/// A program whose answers were recorded. It is asked like any other; what it did not answer counts as not implemented.
#[derive(Debug, Default)]
pub struct Recorded {
    name: String,
    hello: Option<Hello>,
    answers: BTreeMap<String, Result<Answer, Fault>>,
    asked: BTreeSet<String>,
    unanswered: Vec<String>,
    chatter: Chatter,
    lines: Lines,
}

/// Line of a recording for a question that was not answered.
#[derive(Deserialize, Serialize)]
struct FaultLine {
    id: String,
    #[serde(flatten)]
    fault: Fault,
}

impl Recorded {
    /// Reads lines of answers, in any order. `file` is the name in messages; several files are read one after another.
    ///
    /// # Errors
    /// [`Error::Answers`] if answers are of other fixtures than the suite's, or if two answers to a question differ.
    pub fn read(&mut self, suite: &Suite, text: &str, file: &str) -> Result<()> {
        let fault = |reason: String| Error::Answers { file: file.into(), reason };
        if self.name.is_empty() {
            self.name = file.into();
        }
        for line in text.lines() {
            if let Ok(FaultLine { id, fault: found }) = serde_json::from_str(line) {
                self.add(id, Err(found)).map_err(fault)?;
                continue;
            }
            for read in self.lines.read(line) {
                match read {
                    Ok(AnswerLine::Hello { hello }) => {
                        self.hello = Some(of_these_fixtures(hello, suite).map_err(fault)?);
                    }
                    Ok(AnswerLine::Answer { id, answer }) => self.add(id, Ok(answer)).map_err(fault)?,
                    Ok(AnswerLine::Chatter(words)) if words.is_empty() => {}
                    Ok(AnswerLine::Chatter(words)) => self.chatter.add(&words),
                    Err(found) => {
                        return Err(fault(format!("{found}; allowed: lines of answers (fixtures/PROTOCOL.md)")));
                    }
                }
            }
        }
        if let Some(words) = self.lines.give_up() {
            self.lines.note(Trouble::CutOff, &words);
        }
        Ok(())
    }

    fn add(&mut self, id: String, answer: Result<Answer, Fault>) -> Result<(), String> {
        match self.answers.get(&id) {
            Some(other) if *other != answer => {
                Err(format!("two answers to the question `{}` differ; allowed: one; remove the other", quoted(&id)))
            }
            _ => {
                self.answers.insert(id, answer);
                Ok(())
            }
        }
    }

    /// The questions that were asked and have no answer, a line each, after the announcement.
    pub fn unanswered(&self) -> &[String] {
        &self.unanswered
    }
}

/// Refuses answers of other fixtures.
fn of_these_fixtures(hello: Hello, suite: &Suite) -> Result<Hello, String> {
    for (file, theirs) in hello.fixtures.iter().flatten() {
        let ours = suite.versions.get(file).map_or("none", String::as_str);
        if ours != theirs {
            return Err(format!(
                "the answers are of {file} {}, the reference values of version {ours}; allowed: one version; ask again with new \
                 --questions, or name the older --fixtures",
                quoted(theirs)
            ));
        }
    }
    Ok(hello)
}

impl Subject for Recorded {
    fn hello(&mut self, announcement: &Question) -> Result<Hello, Fault> {
        self.unanswered.push(announcement.line());
        Ok(self.hello.clone().unwrap_or_else(|| Hello { name: Some(self.name.clone()), ..Hello::default() }))
    }

    fn ask(&mut self, question: &Asked) -> Result<Answer, Fault> {
        if let Some(answer) = self.answers.get(question.id) {
            self.asked.insert(question.id.into());
            return answer.clone();
        }
        let line = question.line();
        if !self.answers.is_empty() {
            self.lines.note(Trouble::Unanswered, question.id);
        }
        self.unanswered.push(line);
        Ok(Answer::NotImplemented)
    }

    fn can_repeat(&self) -> bool {
        false
    }

    fn description(&self) -> String {
        self.name.clone()
    }

    fn chatter(&self) -> Chatter {
        self.chatter.clone()
    }

    fn remarks(&self) -> Vec<Remark> {
        let mut lines = self.lines.remarks();
        let unknown: Vec<&String> = self.answers.keys().filter(|id| !self.asked.contains(*id)).collect();
        if let Some(first) = unknown.first() {
            lines.push(Remark { trouble: Trouble::UnknownId, lines: unknown.len(), first: quoted(first) });
        }
        lines
    }
}

/// A subject whose answers are recorded as they come, a line each, as [`Recorded::read`] reads them.
pub struct Recorder<'a, W> {
    subject: &'a mut dyn Subject,
    fixtures: BTreeMap<String, String>,
    out: W,
    /// The first error of the output. Nothing is written after it.
    error: Option<io::Error>,
}

impl<'a, W: Write> Recorder<'a, W> {
    /// Records the answers of `subject` to questions of `suite` in `out`.
    pub fn new(subject: &'a mut dyn Subject, suite: &Suite, out: W) -> Recorder<'a, W> {
        Recorder { subject, fixtures: suite.versions.clone(), out, error: None }
    }

    /// The error that ended the recording, if there was one.
    pub fn into_error(self) -> Option<io::Error> {
        self.error
    }

    fn write(&mut self, line: &Value) {
        if self.error.is_none() {
            // A line at once, so that a process that is killed leaves whole ones.
            let written = self.out.write_all(format!("{line}\n").as_bytes()).and_then(|()| self.out.flush());
            self.error = written.err();
        }
    }
}

impl<W: Write> Subject for Recorder<'_, W> {
    fn hello(&mut self, announcement: &Question) -> Result<Hello, Fault> {
        let hello = self.subject.hello(announcement)?;
        let Hello { name, given, quantities, conventions, .. } = &hello;
        let name = name.clone().unwrap_or_else(|| self.subject.description());
        let fixtures = &self.fixtures;
        self.write(&json!({
            "hello": {"name": name, "given": given, "quantities": quantities, "conventions": conventions, "fixtures": fixtures}
        }));
        Ok(hello)
    }

    fn ask(&mut self, question: &Asked) -> Result<Answer, Fault> {
        let answer = self.subject.ask(question);
        let id = question.id;
        if id.starts_with(AGAIN) {
            return answer;
        }
        let line = match &answer {
            Ok(Answer::Value(value)) => json!({"id": id, "value": value}),
            Ok(Answer::NotImplemented) => json!({"id": id, "not_implemented": true}),
            Ok(Answer::Error(message)) => json!({"id": id, "error": message}),
            Err(fault) => json!(FaultLine { id: id.into(), fault: fault.clone() }),
        };
        self.write(&line);
        answer
    }

    fn can_repeat(&self) -> bool {
        self.subject.can_repeat()
    }

    fn restart(&mut self) -> bool {
        self.subject.restart()
    }

    fn description(&self) -> String {
        self.subject.description()
    }

    fn starts(&self) -> usize {
        self.subject.starts()
    }

    fn chatter(&self) -> Chatter {
        self.subject.chatter()
    }

    fn remarks(&self) -> Vec<Remark> {
        self.subject.remarks()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Code, Options, Report, Selection, examine};

    fn poisson(question: &Asked) -> Answer {
        let number = |key: &str| question.state[key].as_f64().unwrap_or(f64::NAN);
        let (e, nu) = (number("E"), number("nu"));
        match question.equation {
            "17.lambda" if nu > 0.48 => Answer::Error("nearly incompressible".into()),
            "17.lambda" => Answer::value(e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))),
            // Twice the right one.
            _ => Answer::value(e / (1.0 + nu)),
        }
    }

    fn report(suite: &Suite, subject: &mut dyn Subject) -> Value {
        let options = Options { asked: Selection::new(suite, &["17".into()], &[]).unwrap(), ..Options::default() };
        let mut report = Report::new(suite, &examine(suite, subject, options, |_| {}));
        // A live program is asked some questions again, which a recording is not.
        (report.seconds, report.questions) = (0.0, 0);
        serde_json::to_value(report).unwrap()
    }

    #[test]
    fn recorded_answers_are_judged_like_those_of_the_program() {
        let suite = Suite::embedded().unwrap();
        let (mut code, mut text) = (Code::new("mine", poisson), Vec::new());
        let live = report(&suite, &mut Recorder::new(&mut code, &suite, &mut text));
        assert_eq!(live["first_wrong"]["quantity"], "17.mu");
        let text = String::from_utf8(text).unwrap();
        // The order does not matter.
        let turned: String = text.lines().rev().map(|line| format!("{line}\n")).collect();
        for text in [&text, &turned] {
            let mut recorded = Recorded::default();
            recorded.read(&suite, text, "answers").unwrap();
            assert_eq!(report(&suite, &mut recorded), live);
            assert_eq!(recorded.unanswered().len(), 1, "the announcement alone");
        }
    }

    #[test]
    fn faults_are_recorded_too() {
        let suite = Suite::embedded().unwrap();
        let line = json!(FaultLine { id: "17.mu/rest-vertical".into(), fault: Fault::Crash("exit status: 3".into()) });
        let mut recorded = Recorded::default();
        recorded.read(&suite, &line.to_string(), "answers").unwrap();
        let found = report(&suite, &mut recorded);
        let row = found["quantities"].as_array().unwrap().iter().find(|row| row["quantity"] == "17.mu").unwrap();
        assert_eq!(row["faults"][0]["fault"], json!({"fault": "crash", "detail": "exit status: 3"}));
    }

    #[test]
    fn questions_without_an_answer_are_kept_and_answers_without_a_question_said() {
        let suite = Suite::embedded().unwrap();
        let mut nothing = Recorded::default();
        assert_eq!(report(&suite, &mut nothing)["remarks"], json!([]));
        let questions: Vec<Value> =
            nothing.unanswered().iter().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert!(questions[0]["hello"]["protocol"].is_string());
        let ids: BTreeSet<&str> = questions[1..].iter().map(|line| line["id"].as_str().unwrap()).collect();
        assert_eq!(ids.len(), questions.len() - 1, "each has its own");
        assert!(ids.contains("17.mu/rest-vertical") && ids.contains("17.lambda/poisson-half"));

        let mut some = Recorded::default();
        some.read(
            &suite,
            "{\"id\":\"17.mu/rest-vertical\",\"value\":1}\n{\"id\":\"18.mu/none\",\"value\":1}\n{\"id\":",
            "a",
        )
        .unwrap();
        let remarks = report(&suite, &mut some)["remarks"].clone();
        let found: Vec<_> = remarks
            .as_array()
            .unwrap()
            .iter()
            .map(|r| (r["trouble"].as_str().unwrap(), r["lines"].as_u64().unwrap()))
            .collect();
        // A wrong answer is asked for once more, with θ in degrees.
        assert_eq!(found, [("unanswered", questions.len() as u64 - 1), ("cut-off", 1), ("unknown-id", 1)]);
    }

    #[test]
    fn other_fixtures_and_two_answers_are_errors() {
        let suite = Suite::embedded().unwrap();
        let message = |text: &str| Recorded::default().read(&suite, text, "file").unwrap_err().to_string();
        let other = message(r#"{"hello":{"fixtures":{"equations.json":"0.9"}}}"#);
        assert!(
            other.contains("file: the answers are of equations.json 0.9, the reference values of version"),
            "{other}"
        );
        let two = message("{\"id\":\"1\",\"value\":1}\n{\"id\":\"1\",\"value\":2}");
        assert!(two.contains("two answers to the question `1` differ"), "{two}");
        assert!(
            Recorded::default().read(&suite, "{\"id\":\"1\",\"value\":1}\n{\"id\":\"1\",\"value\":1}", "file").is_ok()
        );
    }
}
