//! A process killed while it writes: no file has its final name that is not whole.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A run of some tenths of a second that writes megabytes.
const SCENE: &str = r#"{"schema": "ancf-scene/1", "material": {"E": 2e8, "nu": 0.0, "rho": 7750.0},
 "section": {"height": 0.02, "width": 0.02}, "points": {"o": [0.0, 0.0], "a": [1.0, 0.0]},
 "rods": [{"name": "rod", "from": "o", "to": "a", "elements": 1}], "supports": [{"point": "o", "fix": ["x", "y"]}],
 "gravity": [0.0, -9.8], "time": {"end": 4.0, "step": 4e-5, "method": "explicit"},
 "probes": [{"name": "tip", "point": "a", "of": ["position", "velocity"]}]}"#;

const ROWS: usize = 100_001;

#[test]
fn killed_at_any_time_no_file_is_cut_off() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.json");
    fs::write(&scene, SCENE).unwrap();
    let start = |out: &Path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
        command.arg("run").arg(&scene).arg("--out").arg(out);
        command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
    };
    let times = if cfg!(debug_assertions) { 20 } else { 200 };
    let (mut cut, mut done) = (0, 0);
    for n in 0..times {
        let out = folder.path().join(format!("out-{n}"));
        let mut child = start(&out);
        // What is on the disk says when to kill, since no clock says how fast the machine is: while the run goes on,
        // while its files are written, once the first of them has its name.
        match n % 4 {
            0 => wait_for(&out, |_| true),
            1 | 2 => wait_for(&out, |name| name.starts_with(".ancf-")),
            _ => wait_for(&out, |name| name == "trajectory.csv"),
        }
        sleep(Duration::from_micros(500 * (n as u64 / 4)));
        child.kill().unwrap();
        child.wait().unwrap();
        let (trajectory, summary) = (out.join("trajectory.csv"), out.join("summary.json"));
        if trajectory.exists() {
            let text = fs::read_to_string(&trajectory).unwrap();
            assert!(text.ends_with('\n') && text.lines().count() == ROWS + 1, "{} lines", text.lines().count());
            done += 1;
        } else {
            cut += 1;
        }
        if summary.exists() {
            let text = fs::read_to_string(&summary).unwrap();
            serde_json::from_str::<serde_json::Value>(&text).unwrap();
            // It gets its name last.
            assert!(trajectory.exists());
        }
        fs::remove_dir_all(&out).ok();
    }
    println!("killed {times} times: {cut} without a file, {done} with whole ones");
    // The first kill of each kind comes at once, the last of the last kind after a file has its name.
    assert!(cut > 0 && done >= times / 4);
}

/// Waits until a folder exists and, unless any content will do, has a file of an accepted name.
fn wait_for(folder: &Path, accepts: impl Fn(&str) -> bool) {
    let begin = Instant::now();
    let has_one = || {
        fs::read_dir(folder).is_ok_and(|entries| {
            let mut names = entries.flatten().map(|entry| entry.file_name());
            accepts("") || names.any(|name| name.to_str().is_some_and(&accepts))
        })
    };
    while !has_one() {
        assert!(begin.elapsed() < Duration::from_secs(60), "nothing in {}", folder.display());
        sleep(Duration::from_micros(200));
    }
}
