//! A child process with its three pipes.
//!
//! One thread writes and one reads, so that a program that neither reads nor answers cannot block this one. A third thread drains
//! standard error and keeps its last lines for the report.

use std::collections::VecDeque;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::quotation::quoted;
use crate::verdict::Fault;

/// Longest line that is read, in bytes: the longest right answer has some hundred thousand.
const LONGEST_LINE: u64 = 2 << 20;
/// Longest part of a line of standard error that is kept at once, in bytes.
const LONGEST_ERROR: u64 = 4096;
/// Number of lines that are read ahead.
const AHEAD: usize = 16;
/// Number of lines of standard error that are kept.
const KEPT: usize = 5;
/// Interval at which the end of standard input is checked.
const POLL: Duration = Duration::from_millis(50);
/// Time that a program has to exit after it closed a pipe.
const EXIT_TIME: Duration = Duration::from_millis(300);

/// A running program.
pub struct Process {
    child: Child,
    ended: bool,
    /// None: its standard input is closed.
    questions: Option<Sender<String>>,
    writer: JoinHandle<()>,
    error_reader: JoinHandle<()>,
    lines: Receiver<Result<String, Fault>>,
    last_errors: Arc<Mutex<VecDeque<String>>>,
}

impl Process {
    /// Starts a program with its arguments.
    ///
    /// # Errors
    /// The system's error if the program cannot be started.
    pub fn start(name: &str, arguments: &[String]) -> io::Result<Process> {
        let mut command = Command::new(name);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // Processes that the program starts belong to its group and are killed with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let (stdin, stdout, stderr) = match (child.stdin.take(), child.stdout.take(), child.stderr.take()) {
            (Some(stdin), Some(stdout), Some(stderr)) => (stdin, stdout, stderr),
            _ => return Err(io::Error::other("its standard input and output cannot be reached")),
        };
        let (questions, to_write) = channel();
        let (to_tell, lines) = sync_channel(AHEAD);
        let last_errors = Arc::new(Mutex::new(VecDeque::new()));
        let kept = Arc::clone(&last_errors);
        let threads = || -> io::Result<(JoinHandle<()>, JoinHandle<()>)> {
            let writer = thread::Builder::new().spawn(move || write_lines(stdin, &to_write))?;
            thread::Builder::new().spawn(move || read_lines(stdout, &to_tell))?;
            Ok((writer, thread::Builder::new().spawn(move || keep_last_lines(stderr, &kept))?))
        };
        match threads() {
            Ok((writer, error_reader)) => Ok(Process {
                child,
                ended: false,
                questions: Some(questions),
                writer,
                error_reader,
                lines,
                last_errors,
            }),
            Err(error) => {
                end(&mut child);
                Err(io::Error::new(error.kind(), format!("no thread for its pipes: {error}")))
            }
        }
    }

    /// Sends a line to the program.
    ///
    /// # Errors
    /// [`Fault::Crash`] if the program no longer reads.
    pub fn send(&self, line: String) -> Result<(), Fault> {
        self.questions.as_ref().and_then(|questions| questions.send(line).ok()).ok_or_else(not_reading)
    }

    /// Closes the program's standard input, and returns its next line; `None` if there is none within the time. A program that does not
    /// flush its output writes it when its input ends.
    pub fn last_words(&mut self, limit: Duration) -> Option<String> {
        self.questions = None;
        self.lines.recv_timeout(limit).ok()?.ok()
    }

    /// Returns the next line of the program; `None` if there is none within the time.
    ///
    /// # Errors
    /// [`Fault::Crash`] if no more lines will come, [`Fault::Endless`] if a line does not end.
    pub fn next(&self, limit: Duration) -> Result<Option<String>, Fault> {
        let started = Instant::now();
        loop {
            // The writer ends early if the program closed its input. An answer may still be on its way.
            let closed = self.writer.is_finished();
            let left = limit.saturating_sub(started.elapsed()).min(if closed { EXIT_TIME } else { POLL });
            match self.lines.recv_timeout(left) {
                Ok(line) => return line.map(Some),
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(Fault::Crash("it closed its standard output".into()));
                }
                Err(RecvTimeoutError::Timeout) if closed => return Err(not_reading()),
                Err(RecvTimeoutError::Timeout) if started.elapsed() >= limit => return Ok(None),
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// Ends the process and describes how it ended: exit status, or `how`, and the last line of standard error.
    pub fn exit_report(&mut self, how: &str) -> String {
        let deadline = Instant::now() + EXIT_TIME;
        let mut status = None;
        while status.is_none() && Instant::now() < deadline {
            status = self.child.try_wait().ok().flatten();
            thread::sleep(Duration::from_millis(5));
        }
        self.end();
        // On a busy machine the last line may not have been read yet.
        let deadline = Instant::now() + EXIT_TIME;
        while !self.error_reader.is_finished() && Instant::now() < deadline {
            thread::sleep(Duration::from_millis(5));
        }
        let mut report = status.map_or_else(|| how.to_string(), |status| status.to_string());
        let lines = self.last_errors.lock().unwrap_or_else(PoisonError::into_inner);
        // Octave says this after its own message, whatever the message was.
        let tells = |line: &&String| !line.trim().is_empty() && !line.contains("ignoring const execution_exception");
        if let Some(last) = lines.iter().rev().find(tells) {
            report += &format!("; last line of standard error: {}", quoted(last));
        }
        report
    }

    /// Kills the process and all processes that it started. Does nothing if it has ended.
    pub fn end(&mut self) {
        if !std::mem::replace(&mut self.ended, true) {
            end(&mut self.child);
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.end();
    }
}

/// Kills a process and its group.
fn end(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw) {
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

fn not_reading() -> Fault {
    Fault::Crash("it no longer reads its standard input".into())
}

fn write_lines(mut stdin: ChildStdin, lines: &Receiver<String>) {
    for line in lines {
        if stdin.write_all(line.as_bytes()).and_then(|()| stdin.write_all(b"\n")).and_then(|()| stdin.flush()).is_err()
        {
            return;
        }
    }
}

fn read_lines(stdout: ChildStdout, lines: &SyncSender<Result<String, Fault>>) {
    let mut stdout = BufReader::new(stdout);
    loop {
        let mut line = Vec::new();
        let line = match (&mut stdout).take(LONGEST_LINE).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return,
            Ok(count) if count as u64 == LONGEST_LINE => {
                // No more lines are read from a program that writes without end.
                let _ = lines.send(Err(Fault::Endless(format!("{} MB and more", LONGEST_LINE >> 20))));
                return;
            }
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
    while (&mut stderr).take(LONGEST_ERROR).read_until(b'\n', &mut line).is_ok_and(|count| count > 0) {
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.push_back(String::from_utf8_lossy(&line).into_owned());
        if kept.len() > KEPT {
            kept.pop_front();
        }
        line.clear();
    }
}
