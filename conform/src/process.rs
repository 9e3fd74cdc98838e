//! One process with its three pipes.
//!
//! A thread writes and one reads, so that neither a program that does not read nor one that does not answer can stop this
//! one; its standard error is drained, and its last lines are kept for the report.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Error, Read, Result, Write};
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::protocol;
use super::verdict::Fault;

/// Longest line that is read, bytes.
const LONGEST_LINE: u64 = 16 << 20;
/// Lines that are read ahead.
const AHEAD: usize = 16;
/// Lines of standard error that are kept.
const KEPT: usize = 5;
/// Often enough looked whether the program still reads, s.
const GLANCE: Duration = Duration::from_millis(50);
/// Time to end by itself after its output has ended.
const FAREWELL: Duration = Duration::from_millis(300);

/// A running program.
pub struct Process {
    child: Child,
    over: bool,
    questions: Sender<String>,
    writer: JoinHandle<()>,
    lines: Receiver<std::result::Result<String, Fault>>,
    last_words: Arc<Mutex<VecDeque<String>>>,
}

impl Process {
    /// Starts a program.
    ///
    /// # Errors
    /// The system's reason if it cannot be started.
    pub fn start(name: &str, arguments: &[String]) -> Result<Process> {
        let mut command = Command::new(name);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // What it starts itself, as a shell does, belongs to its group and ends with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let (stdin, stdout, stderr) = match (child.stdin.take(), child.stdout.take(), child.stderr.take()) {
            (Some(stdin), Some(stdout), Some(stderr)) => (stdin, stdout, stderr),
            _ => return Err(Error::other("its input and output cannot be reached")),
        };
        let (questions, to_write) = channel();
        let (to_tell, lines) = sync_channel(AHEAD);
        let last_words = Arc::new(Mutex::new(VecDeque::new()));
        let writer = thread::spawn(move || write_lines(stdin, &to_write));
        thread::spawn(move || read_lines(stdout, &to_tell));
        let kept = Arc::clone(&last_words);
        thread::spawn(move || keep_last_lines(stderr, &kept));
        Ok(Process { child, over: false, questions, writer, lines, last_words })
    }

    /// Sends a line.
    ///
    /// # Errors
    /// [`Fault::Crash`] if nobody reads it.
    pub fn send(&self, line: String) -> std::result::Result<(), Fault> {
        self.questions.send(line).map_err(|_| not_reading())
    }

    /// The next line; `None` if none comes within the time.
    ///
    /// # Errors
    /// [`Fault::Crash`] if there will be none, [`Fault::Endless`] if it has no end.
    pub fn next(&self, limit: Duration) -> std::result::Result<Option<String>, Fault> {
        let started = Instant::now();
        loop {
            // A writer that is done before its channel closes has met a closed input: an answer may still be on its way.
            let closed = self.writer.is_finished();
            let left = limit.saturating_sub(started.elapsed()).min(if closed { FAREWELL } else { GLANCE });
            match self.lines.recv_timeout(left) {
                Ok(line) => return line.map(Some),
                Err(RecvTimeoutError::Disconnected) => return Err(Fault::Crash("its output has ended".into())),
                Err(RecvTimeoutError::Timeout) if closed => return Err(not_reading()),
                Err(RecvTimeoutError::Timeout) if started.elapsed() >= limit => return Ok(None),
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// How the process ended, with its exit code and its last words on standard error.
    pub fn obituary(&mut self, how: &str) -> String {
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

    /// Ends the process and what it has started; that it has ended already is no error.
    pub fn end(&mut self) {
        if std::mem::replace(&mut self.over, true) {
            return;
        }
        #[cfg(unix)]
        if let Some(group) = i32::try_from(self.child.id()).ok().and_then(rustix::process::Pid::from_raw) {
            let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.end();
    }
}

fn not_reading() -> Fault {
    Fault::Crash("it does not read its input any more".into())
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
            Ok(count) if count as u64 == LONGEST_LINE => {
                // Whoever writes on without an end is not listened to any more.
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
    while (&mut stderr).take(LONGEST_LINE).read_until(b'\n', &mut line).is_ok_and(|count| count > 0) {
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.push_back(String::from_utf8_lossy(&line).into_owned());
        if kept.len() > KEPT {
            kept.pop_front();
        }
        line.clear();
    }
}
