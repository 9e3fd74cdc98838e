//! The machine and the program that run times belong to.

use std::fs;
use std::process::Command;

use serde::Serialize;

/// Processor, system and program version of the run times.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Machine {
    /// Model of the processor, "unknown" if the system does not say.
    pub cpu: String,
    /// Operating system and architecture.
    pub system: String,
    /// The compiler found on this machine, "unknown" if there is none; the program does not know which one built it.
    pub rustc_found: String,
    /// The oldest compiler that is supported.
    pub rust_version: &'static str,
    /// Version of this package.
    pub version: &'static str,
    /// Commit of the current folder, if it is a working copy.
    pub commit: Option<String>,
    /// Build profile.
    pub profile: &'static str,
    /// Number of threads.
    pub threads: usize,
}

impl Machine {
    /// This machine.
    pub fn here() -> Machine {
        let answer = |program: &str, arguments: &[&str]| {
            let output =
                Command::new(program).args(arguments).output().ok().filter(|output| output.status.success())?;
            let text = String::from_utf8(output.stdout).ok()?;
            Some(text.trim().to_string()).filter(|text| !text.is_empty())
        };
        Machine {
            cpu: cpu().unwrap_or_else(|| "unknown".into()),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            rustc_found: answer("rustc", &["--version"]).unwrap_or_else(|| "unknown".into()),
            rust_version: env!("CARGO_PKG_RUST_VERSION"),
            version: env!("CARGO_PKG_VERSION"),
            commit: answer("git", &["rev-parse", "HEAD"]),
            profile: if cfg!(debug_assertions) { "debug: its times mean nothing" } else { "release" },
            threads: 1,
        }
    }

    /// The machine in one line.
    pub fn line(&self) -> String {
        let commit = self.commit.as_deref().map_or(String::new(), |commit| format!(", commit {:.12}", commit));
        format!(
            "{}, {}, one thread; ancf {}{commit}, {} build; compiler found here: {}",
            self.cpu, self.system, self.version, self.profile, self.rustc_found
        )
    }
}

fn cpu() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_string())
}
