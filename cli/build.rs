//! Tells the program the commit that it is built from, for `summary.json`; nothing outside of a repository.

use std::process::Command;

fn main() {
    // A commit, and whatever makes the sources other than it.
    let git = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).output().ok().filter(|output| output.status.success())?;
        Some(String::from_utf8_lossy(&output.stdout).trim().to_string())
    };
    if let Some(log) = git(&["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo:rerun-if-changed={log}");
    }
    for folder in ["src", "assets", "../src", "../study/src", "../conform/src", "../fixtures"] {
        println!("cargo:rerun-if-changed={folder}");
    }
    if let Some(commit) = git(&["describe", "--always", "--dirty"]) {
        println!("cargo:rustc-env=ANCF_COMMIT={commit}");
    }
}
