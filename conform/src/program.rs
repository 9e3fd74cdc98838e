//! A program in a process of its own: starts it, asks it, and restarts it after it hung or crashed.

use std::time::{Duration, Instant};

use crate::error::{Error, Result};
use crate::lines::Lines;
use crate::process::Process;
use crate::protocol::{Answer, AnswerLine, Asked, Hello, Question};
use crate::quotation::quoted;
use crate::subject::{Chatter, Subject};
use crate::trouble::Remark;
use crate::verdict::Fault;

/// Time limit for the answer to `hello`, unless that of an answer is longer.
const START_LIMIT: Duration = Duration::from_secs(30);
/// Largest number of times that a program is started.
pub const MOST_STARTS: usize = 25;
/// Largest number of lines other than JSON before an answer.
const MOST_CHATTER: usize = 100;
/// Time limit for an answer after such a line, once the program has printed one in place of an answer.
const SHORT_LIMIT: Duration = Duration::from_millis(10);
/// Time for an answer after the program's input was closed.
const LAST_LIMIT: Duration = Duration::from_secs(1);

/// A program that answers lines of JSON. It is restarted if it has ended when the next question comes.
pub struct Program {
    command: Vec<String>,
    limit: Duration,
    hello_line: String,
    running: Option<Process>,
    chatter_place: Option<ChatterPlace>,
    starts: usize,
    chatter: Chatter,
    lines: Lines,
}

/// Picks the line that is waited for, or the fault that it shows; `None` to skip a line.
type Wanted<'a, T> = &'a dyn Fn(AnswerLine) -> Option<Result<T, Fault>>;

/// Where a program prints lines other than JSON. After the first such line the whole time limit applies to the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ChatterPlace {
    /// Before its answers: the lines are skipped.
    BeforeAnswers,
    /// In place of answers: there is no answer to wait for.
    InPlaceOfAnswers,
}

impl Program {
    /// Starts a program. `command` is its name and its arguments, `limit` the time for one answer.
    ///
    /// # Errors
    /// [`Error::Command`] if the program cannot be started. A program that does not answer is not an error.
    pub fn start(command: &[String], limit: Duration) -> Result<Program> {
        let mut program = Program {
            command: command.to_vec(),
            limit,
            hello_line: String::new(),
            running: None,
            chatter_place: None,
            starts: 0,
            chatter: Chatter::default(),
            lines: Lines::default(),
        };
        program.running = Some(program.spawn()?);
        Ok(program)
    }

    fn spawn(&mut self) -> Result<Process> {
        let none = String::new();
        let (name, arguments) = self.command.split_first().unwrap_or((&none, &[]));
        let process = Process::start(name, arguments);
        self.starts += 1;
        process.map_err(|source| Error::Command { command: name.clone(), source })
    }

    fn greet(&mut self) -> Result<Hello, Fault> {
        // A banner before `hello` does not predict where later lines are printed.
        let chatter_place = self.chatter_place.take();
        let (line, limit) = (self.hello_line.clone(), self.limit.max(START_LIMIT));
        let hello = self.exchange(line, limit, &|line| match line {
            AnswerLine::Hello { hello } => Some(Ok(hello)),
            AnswerLine::Answer { .. } => Some(Err(Fault::Garbage("an answer before hello".into()))),
            AnswerLine::Chatter(_) => None,
        });
        self.chatter_place = chatter_place;
        hello
    }

    /// Sends a line and waits for one that `wanted` accepts. Kills a process that hung.
    fn exchange<T>(&mut self, line: String, limit: Duration, wanted: Wanted<T>) -> Result<T, Fault> {
        let Some(mut process) = self.running.take() else { return Err(Fault::Crash("it is not running".into())) };
        let before = self.chatter.lines;
        let outcome = process.send(line).and_then(|()| self.listen(&process, limit, wanted));
        match &outcome {
            Err(Fault::TimeLimit(_)) => {
                let why = self.why_late(&mut process, wanted);
                process.end();
                self.lines.give_up();
                return why.map_or(outcome, |why| Err(Fault::Buffered(why)));
            }
            Err(Fault::Endless(_)) => process.end(),
            Err(Fault::Crash(how)) => {
                if let Some(words) = self.lines.give_up() {
                    self.chatter.add(&words);
                }
                let mut report = process.exit_report(how);
                if self.chatter.lines > before {
                    report += &format!("; it printed: {}", self.chatter.last);
                }
                return Err(Fault::Crash(report));
            }
            _ => self.running = Some(process),
        }
        outcome
    }

    /// Why the answer did not come in time, if it comes now that the program's input is closed.
    fn why_late<T>(&mut self, process: &mut Process, wanted: Wanted<T>) -> Option<String> {
        let started = Instant::now();
        while let Some(left) = LAST_LIMIT.checked_sub(started.elapsed()) {
            let line = process.last_words(left)?;
            if self.lines.read(&line).into_iter().flatten().any(|line| matches!(wanted(line), Some(Ok(_)))) {
                return Some(if line.ends_with('\n') {
                    "it does not flush its output, or took a moment longer than the limit; flush standard output after each line \
                     (C: fflush(stdout), Python: print(…, flush=True), Fortran: flush(output_unit)), or ask it through files \
                     (--questions)"
                        .into()
                } else {
                    "its line does not end; write a line feed after each answer, and flush standard output".into()
                });
            }
        }
        None
    }

    /// Waits for a line that `wanted` accepts. Other lines are skipped; if nothing else comes, the first of them is the fault.
    fn listen<T>(&mut self, process: &Process, limit: Duration, wanted: Wanted<T>) -> Result<T, Fault> {
        let started = Instant::now();
        let (mut deadline, mut first, mut other, mut count) = (limit, None, None, 0);
        loop {
            // A program that writes on and on always has a line ready: the clock ends it, not silence.
            let left = deadline.checked_sub(started.elapsed()).filter(|left| !left.is_zero());
            let next = left.map_or(Ok(None), |left| process.next(left))?;
            let Some(line) = next else {
                if let Some(words) = self.lines.give_up() {
                    self.chatter.add(&words);
                    first.get_or_insert(words);
                }
                let limit = format!("{} s", limit.as_secs_f64());
                if let Some(id) = other {
                    return Err(Fault::TimeLimit(format!(
                        "{limit}, but one with the id `{id}`; it must be that of the question, letter by letter"
                    )));
                }
                let Some(line) = first.filter(|_| self.chatter_place != Some(ChatterPlace::BeforeAnswers)) else {
                    return Err(Fault::TimeLimit(limit));
                };
                self.chatter_place = Some(ChatterPlace::InPlaceOfAnswers);
                return Err(Fault::Garbage(line));
            };
            for read in self.lines.read(&line) {
                match read? {
                    AnswerLine::Chatter(words) if words.is_empty() => {}
                    AnswerLine::Chatter(words) => {
                        count += 1;
                        self.chatter.add(&words);
                        if count > MOST_CHATTER {
                            return Err(Fault::Garbage(words));
                        }
                        if self.chatter_place == Some(ChatterPlace::InPlaceOfAnswers) {
                            deadline = limit.min(started.elapsed() + SHORT_LIMIT);
                        }
                        first.get_or_insert(words);
                    }
                    line => {
                        let id = if let AnswerLine::Answer { id, .. } = &line { Some(quoted(id)) } else { None };
                        if let Some(answer) = wanted(line) {
                            if first.is_some() {
                                self.chatter_place = Some(ChatterPlace::BeforeAnswers);
                            }
                            return answer;
                        }
                        other = id;
                    }
                }
            }
        }
    }
}

impl Subject for Program {
    fn hello(&mut self, announcement: &Question) -> Result<Hello, Fault> {
        self.hello_line = announcement.line();
        self.greet()
    }

    fn ask(&mut self, question: &Asked) -> Result<Answer, Fault> {
        if self.running.is_none() {
            if self.starts >= MOST_STARTS {
                return Err(Fault::NotAsked(format!("the program was started {MOST_STARTS} times")));
            }
            self.running = Some(self.spawn().map_err(|error| Fault::Crash(error.to_string()))?);
            self.greet().map_err(|fault| Fault::Crash(format!("restarted: {fault}")))?;
        }
        let limit = self.limit;
        self.exchange(question.line(), limit, &|line| match line {
            AnswerLine::Answer { id: of, answer } if of == question.id => Some(Ok(answer)),
            AnswerLine::Hello { .. } => Some(Err(Fault::Garbage("a second hello".into()))),
            // A late answer to an earlier question.
            AnswerLine::Answer { .. } | AnswerLine::Chatter(_) => None,
        })
    }

    fn restart(&mut self) -> bool {
        self.running = None;
        self.starts < MOST_STARTS
    }

    fn description(&self) -> String {
        self.command.join(" ")
    }

    fn starts(&self) -> usize {
        self.starts
    }

    fn chatter(&self) -> Chatter {
        self.chatter.clone()
    }

    fn remarks(&self) -> Vec<Remark> {
        self.lines.remarks()
    }
}
