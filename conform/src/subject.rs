//! The program under test: started, asked, and started again after it hung or crashed.

use std::time::{Duration, Instant};

use super::process::Process;
use super::protocol::{self, Answer, Hello, Line};
use super::verdict::Fault;
use crate::error::{Error, Result};

/// A program may take this long to start, if the time limit is not longer.
const START: Duration = Duration::from_secs(30);
/// So often a program is started at most.
pub const STARTS: usize = 25;
/// Lines that are no JSON before an answer, at most.
const PATIENCE: usize = 100;
/// Time for an answer behind such a line of a program that has shown to print them in place of answers.
const AFTERWARDS: Duration = Duration::from_millis(10);

/// A program that is started when it is asked, and again after it hung or crashed.
pub struct Program {
    command: Vec<String>,
    limit: Duration,
    hello_line: String,
    running: Option<Process>,
    habit: Option<Habit>,
    /// How often it was started.
    pub starts: usize,
    /// What it said of itself at last; what came in place of that the first time, after which it need not be asked.
    pub hello: std::result::Result<Hello, Fault>,
    /// What it printed beside its answers.
    pub chatter: Chatter,
}

/// Lines on standard output that are no JSON.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Chatter {
    /// How many there were.
    pub lines: usize,
    /// The first of them.
    pub first: String,
    /// The last of them.
    pub last: String,
}

/// Where a program prints lines that are no JSON. The first time it has all its time to answer behind such a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Habit {
    /// Before its answers: they are passed over.
    BesideAnswers,
    /// In place of them: nothing is worth waiting for.
    InPlaceOfAnswers,
}

impl Program {
    /// Starts the program and exchanges `hello`.
    ///
    /// # Errors
    /// [`Error::Command`] if there is no such program. That it does not answer is a result.
    pub fn start(command: &[String], limit: Duration, hello_line: String) -> Result<Program> {
        let mut program = Program {
            command: command.to_vec(),
            limit,
            hello_line,
            running: None,
            habit: None,
            starts: 0,
            hello: Ok(Hello::default()),
            chatter: Chatter::default(),
        };
        let process = program.spawn()?;
        program.hello = program.greet(process);
        Ok(program)
    }

    /// Asks one question.
    ///
    /// # Errors
    /// What came in place of an answer.
    pub fn ask(&mut self, id: &str, line: String) -> std::result::Result<Answer, Fault> {
        if self.running.is_none() {
            if self.starts >= STARTS {
                return Err(Fault::NotAsked(format!("the program was started {STARTS} times")));
            }
            let process = self.spawn().map_err(|error| Fault::Crash(error.to_string()))?;
            let hello = self.greet(process).map_err(|fault| Fault::Crash(format!("started again: {fault}")))?;
            self.hello = Ok(hello);
        }
        let limit = self.limit;
        self.exchange(line, limit, |line| match line {
            Line::Answer(of, answer) if of == id => Some(Ok(answer)),
            Line::Hello(_) => Some(Err(Fault::Garbage("hello a second time".into()))),
            // A late answer to an earlier question.
            Line::Answer(..) | Line::Chatter(_) => None,
        })
    }

    fn spawn(&mut self) -> Result<Process> {
        let none = String::new();
        let (name, arguments) = self.command.split_first().unwrap_or((&none, &[]));
        let process = Process::start(name, arguments);
        self.starts += 1;
        process.map_err(|source| Error::Command { command: name.clone(), source })
    }

    fn greet(&mut self, process: Process) -> std::result::Result<Hello, Fault> {
        self.running = Some(process);
        // A banner says nothing about answers.
        let habit = self.habit.take();
        let (line, limit) = (self.hello_line.clone(), self.limit.max(START));
        let hello = self.exchange(line, limit, |line| match line {
            Line::Hello(hello) => Some(Ok(hello)),
            Line::Answer(..) => Some(Err(Fault::Garbage("an answer before hello".into()))),
            Line::Chatter(_) => None,
        });
        self.habit = habit;
        hello
    }

    /// Sends a line and waits for one that `wanted` takes. The process is ended if it hung or ended.
    fn exchange<T>(
        &mut self,
        line: String,
        limit: Duration,
        wanted: impl Fn(Line) -> Option<std::result::Result<T, Fault>>,
    ) -> std::result::Result<T, Fault> {
        let Some(mut process) = self.running.take() else { return Err(Fault::Crash("it is not running".into())) };
        let before = self.chatter.lines;
        let outcome = process.send(line).and_then(|()| self.listen(&process, limit, wanted));
        match &outcome {
            Err(Fault::TimeLimit(_) | Fault::Endless(_)) => process.end(),
            Err(Fault::Crash(how)) => {
                let mut story = process.obituary(how);
                if self.chatter.lines > before {
                    story += &format!("; it printed: {}", self.chatter.last);
                }
                return Err(Fault::Crash(story));
            }
            _ => self.running = Some(process),
        }
        outcome
    }

    /// Waits for a line that `wanted` takes; what is no JSON is passed over, unless it is all that comes.
    fn listen<T>(
        &mut self,
        process: &Process,
        limit: Duration,
        wanted: impl Fn(Line) -> Option<std::result::Result<T, Fault>>,
    ) -> std::result::Result<T, Fault> {
        let started = Instant::now();
        let (mut by, mut first, mut count) = (limit, None, 0);
        loop {
            let Some(line) = process.next(by.saturating_sub(started.elapsed()))? else {
                let Some(words) = first.filter(|_| self.habit != Some(Habit::BesideAnswers)) else {
                    return Err(Fault::TimeLimit(format!("{} s", limit.as_secs_f64())));
                };
                self.habit = Some(Habit::InPlaceOfAnswers);
                return Err(Fault::Garbage(words));
            };
            match protocol::read(&line)? {
                Line::Chatter(words) if words.is_empty() => {}
                Line::Chatter(words) => {
                    count += 1;
                    self.chatter.add(&words);
                    if count > PATIENCE {
                        return Err(Fault::Garbage(words));
                    }
                    if self.habit == Some(Habit::InPlaceOfAnswers) {
                        by = limit.min(started.elapsed() + AFTERWARDS);
                    }
                    first.get_or_insert(words);
                }
                line => {
                    if let Some(answer) = wanted(line) {
                        if first.is_some() {
                            self.habit = Some(Habit::BesideAnswers);
                        }
                        return answer;
                    }
                }
            }
        }
    }
}

impl Chatter {
    fn add(&mut self, words: &str) {
        if self.lines == 0 {
            self.first = words.into();
        }
        self.last = words.into();
        self.lines += 1;
    }
}
