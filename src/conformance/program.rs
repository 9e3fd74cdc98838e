//! The program under test: started, asked, and ended when it hangs.
//!
//! A thread writes and one reads, so that neither a program that does not read nor one that does not answer can stop this
//! one; its standard error is drained, and its last lines are kept for the report.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::protocol::{self, Answer, Hello, Line};
use super::verdict::Fault;
use crate::error::{Error, Result};

/// Longest line that is read, bytes.
const LONGEST_LINE: u64 = 64 << 20;
/// Lines that are read ahead.
const AHEAD: usize = 16;
/// Lines of standard error that are kept.
const KEPT: usize = 5;
/// Often enough looked whether the program still reads, s.
const GLANCE: Duration = Duration::from_millis(50);
/// Time to end by itself after its output has ended.
const FAREWELL: Duration = Duration::from_millis(300);
/// A program may take this long to start, if the time limit is not longer.
const START: Duration = Duration::from_secs(30);
/// So often a program is started at most.
pub const STARTS: usize = 25;

/// A program that is started when it is asked, and again after it hung or crashed.
pub struct Program {
    command: Vec<String>,
    limit: Duration,
    hello_line: String,
    running: Option<Running>,
    /// How often it was started.
    pub starts: usize,
    /// What it said of itself at last.
    pub hello: Hello,
}

/// One process.
struct Running {
    child: Child,
    questions: Sender<String>,
    writer: JoinHandle<()>,
    lines: Receiver<std::result::Result<String, Fault>>,
    last_words: Arc<Mutex<VecDeque<String>>>,
}

impl Program {
    /// Starts the program and exchanges `hello`.
    ///
    /// # Errors
    /// [`Error::Command`] if there is no such program, [`Error::NoHello`] if it does not answer `hello`.
    pub fn start(command: &[String], limit: Duration, hello_line: String) -> Result<Program> {
        let mut program =
            Program { command: command.to_vec(), limit, hello_line, running: None, starts: 0, hello: Hello::default() };
        let running = program.spawn()?;
        program
            .greet(running)
            .map_err(|fault| Error::NoHello { command: command.join(" "), reason: fault.to_string() })?;
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
            let running = self.spawn().map_err(|error| Fault::Crash(error.to_string()))?;
            self.greet(running).map_err(|fault| Fault::Crash(format!("started again: {fault}")))?;
        }
        let limit = self.limit;
        self.exchange(line, limit, |line| match line {
            Line::Answer(of, answer) if of == id => Some(Ok(answer)),
            // A late answer to an earlier question.
            Line::Answer(..) => None,
            Line::Hello(_) => Some(Err(Fault::Garbage("hello a second time".into()))),
        })
    }

    fn spawn(&mut self) -> Result<Running> {
        let (name, arguments) = self
            .command
            .split_first()
            .ok_or(Error::NoHello { command: String::new(), reason: "there is no command".into() })?;
        let mut command = Command::new(name);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let failed = |source| Error::Command { command: name.clone(), source };
        let mut child = command.spawn().map_err(failed)?;
        self.starts += 1;
        let missing = || failed(std::io::Error::other("its input and output cannot be reached"));
        let (stdin, stdout, stderr) = match (child.stdin.take(), child.stdout.take(), child.stderr.take()) {
            (Some(stdin), Some(stdout), Some(stderr)) => (stdin, stdout, stderr),
            _ => return Err(missing()),
        };
        let (questions, to_write) = channel();
        let (to_tell, lines) = sync_channel(AHEAD);
        let last_words = Arc::new(Mutex::new(VecDeque::new()));
        let writer = thread::spawn(move || write_lines(stdin, &to_write));
        thread::spawn(move || read_lines(stdout, &to_tell));
        let kept = Arc::clone(&last_words);
        thread::spawn(move || keep_last_lines(stderr, &kept));
        Ok(Running { child, questions, writer, lines, last_words })
    }

    fn greet(&mut self, running: Running) -> std::result::Result<(), Fault> {
        self.running = Some(running);
        let (line, limit) = (self.hello_line.clone(), self.limit.max(START));
        self.hello = self.exchange(line, limit, |line| match line {
            Line::Hello(hello) => Some(Ok(hello)),
            Line::Answer(..) => Some(Err(Fault::Garbage("an answer before hello".into()))),
        })?;
        Ok(())
    }

    /// Sends a line and waits for one that `wanted` takes. The process is ended if it hung or ended.
    fn exchange<T>(
        &mut self,
        line: String,
        limit: Duration,
        wanted: impl Fn(Line) -> Option<std::result::Result<T, Fault>>,
    ) -> std::result::Result<T, Fault> {
        let Some(mut running) = self.running.take() else { return Err(Fault::Crash("it is not running".into())) };
        let outcome = running.exchange(line, limit, wanted);
        match &outcome {
            Err(Fault::TimeLimit(_)) => running.end(),
            Err(Fault::Crash(how)) => return Err(Fault::Crash(running.obituary(how))),
            _ => self.running = Some(running),
        }
        outcome
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        if let Some(mut running) = self.running.take() {
            running.end();
        }
    }
}

impl Running {
    fn exchange<T>(
        &mut self,
        line: String,
        limit: Duration,
        wanted: impl Fn(Line) -> Option<std::result::Result<T, Fault>>,
    ) -> std::result::Result<T, Fault> {
        let started = Instant::now();
        if self.questions.send(line).is_err() {
            return Err(Fault::Crash("it does not read its input any more".into()));
        }
        loop {
            // A writer that is done before its channel closes has met a closed input: an answer may still be on its way.
            let closed = self.writer.is_finished();
            let left = limit.saturating_sub(started.elapsed()).min(if closed { FAREWELL } else { GLANCE });
            match self.lines.recv_timeout(left) {
                Ok(line) => {
                    if let Some(answer) = wanted(protocol::read(&line?)?) {
                        return answer;
                    }
                }
                Err(RecvTimeoutError::Disconnected) => return Err(Fault::Crash("its output has ended".into())),
                Err(RecvTimeoutError::Timeout) if closed => {
                    return Err(Fault::Crash("it does not read its input any more".into()));
                }
                Err(RecvTimeoutError::Timeout) if started.elapsed() >= limit => {
                    return Err(Fault::TimeLimit(format!("{} s", limit.as_secs_f64())));
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// How the process ended, with its exit code and its last words on standard error.
    fn obituary(&mut self, how: &str) -> String {
        let by = Instant::now() + FAREWELL;
        let mut status = None;
        while status.is_none() && Instant::now() < by {
            status = self.child.try_wait().ok().flatten();
            thread::sleep(Duration::from_millis(5));
        }
        self.end();
        let mut story = status.map_or_else(|| how.to_string(), |status| status.to_string());
        let words = self.last_words.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(last) = words.iter().rev().find(|line| !line.trim().is_empty()) {
            story += &format!("; its last words: {}", protocol::quoted(last));
        }
        story
    }

    /// Ends the process; that it has ended already is no error.
    fn end(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn write_lines(mut stdin: ChildStdin, lines: &Receiver<String>) {
    for line in lines {
        if stdin.write_all(line.as_bytes()).and_then(|()| stdin.write_all(b"\n")).and_then(|()| stdin.flush()).is_err()
        {
            return;
        }
    }
}

fn read_lines(stdout: ChildStdout, lines: &SyncSender<std::result::Result<String, Fault>>) {
    let mut stdout = BufReader::new(stdout);
    loop {
        let mut line = Vec::new();
        let line = match (&mut stdout).take(LONGEST_LINE).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return,
            Ok(count) if count as u64 == LONGEST_LINE => Err(Fault::Garbage("a line without an end".into())),
            Ok(_) => Ok(String::from_utf8_lossy(&line).into_owned()),
        };
        if lines.send(line).is_err() {
            return;
        }
    }
}

fn keep_last_lines(stderr: ChildStderr, kept: &Mutex<VecDeque<String>>) {
    let mut stderr = BufReader::new(stderr);
    let mut line = Vec::new();
    while (&mut stderr).take(LONGEST_LINE).read_until(b'\n', &mut line).is_ok_and(|count| count > 0) {
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.push_back(String::from_utf8_lossy(&line).into_owned());
        if kept.len() > KEPT {
            kept.pop_front();
        }
        line.clear();
    }
}
