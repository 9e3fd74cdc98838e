//! A process killed at any time: the folder holds the earlier run's files untouched, or the new run's; never some of each, and nothing hidden.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Instant;

use serde_json::Value;

/// A run of some tenths of a second that writes megabytes, and one of milliseconds.
const SCENE: &str = r#"{"schema": "ancf-scene/1", "material": {"E": 2e8, "nu": 0.0, "rho": 7750.0},
 "section": {"height": 0.02, "width": 0.02}, "points": {"o": [0.0, 0.0], "a": [1.0, 0.0]},
 "rods": [{"name": "rod", "from": "o", "to": "a", "elements": 1}], "supports": [{"point": "o", "fix": ["x", "y"]}],
 "gravity": [0.0, -9.8], "time": {"end": END, "step": 4e-5, "method": "explicit"},
 "probes": [{"name": "tip", "point": "a", "of": ["position", "velocity"]}]}"#;

/// What a run leaves: its table, and the run id of its summary.
#[derive(Debug, PartialEq)]
struct Set {
    table: Option<String>,
    id: Option<Value>,
}

impl Set {
    fn of(folder: &Path) -> Set {
        let read = |name: &str| fs::read_to_string(folder.join(name)).ok();
        let id = |text: String| serde_json::from_str::<Value>(&text).unwrap()["run"].clone();
        Set { table: read("trajectory.csv"), id: read("summary.json").map(id) }
    }

    /// Whether these are files of that run, all or some.
    fn is_part_of(&self, run: &Set) -> bool {
        (self.table.is_none() || self.table == run.table) && (self.id.is_none() || self.id == run.id)
    }
}

/// Names that do not belong to a result.
fn hidden(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.starts_with('.')).collect()
}

fn start(scene: &Path, out: &Path) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    command.arg("run").arg(scene).arg("--out").arg(out);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

#[test]
fn killed_at_any_time_one_run_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let [short, long] = [("short", "0.004"), ("long", "4.0")].map(|(name, end)| {
        let scene = folder.path().join(format!("{name}.json"));
        fs::write(&scene, SCENE.replace("END", end)).unwrap();
        scene
    });
    let out = folder.path().join("out");
    let run = |scene: &Path| {
        assert!(start(scene, &out).wait().unwrap().success());
        assert!(hidden(&out).is_empty(), "{:?}", hidden(&out));
        Set::of(&out)
    };
    let begin = Instant::now();
    let new = run(&long);
    let lasts = begin.elapsed();
    let earlier = run(&short);
    assert!(new.id != earlier.id && new.table.as_ref().is_some_and(|table| table.lines().count() == 100_002));

    let times = if cfg!(debug_assertions) { 10 } else { 200 };
    let (mut untouched, mut replaced, mut cut_off) = (0, 0, 0);
    for n in 0..times {
        let mut child = start(&long, &out);
        if n % 2 == 0 {
            // From the start to a little beyond the end.
            sleep(lasts.mul_f64(1.1 * f64::from(n) / f64::from(times)));
        } else {
            // While files get their names, which takes less than a millisecond; what is on the disk says when.
            sleep(lasts / 4);
            let begin = Instant::now();
            while hidden(&out).is_empty() && begin.elapsed() < 3 * lasts && child.try_wait().unwrap().is_none() {}
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let set = Set::of(&out);
        if hidden(&out).is_empty() {
            assert!(set == earlier || set == new, "files of two runs, or not all of one: {:?}", set.id);
        } else {
            assert!(set.is_part_of(&earlier) || set.is_part_of(&new), "files of two runs: {:?}", set.id);
            cut_off += 1;
        }
        untouched += usize::from(set == earlier);
        replaced += usize::from(set == new);
        // The next run leaves its own files alone, whatever it has found.
        assert!(run(&short) == earlier);
    }
    println!(
        "{times} kills: {untouched} left the earlier files, {replaced} the new ones, {cut_off} something hidden for the next run"
    );
    // The first kill comes at once.
    assert!(untouched > 0);
}
