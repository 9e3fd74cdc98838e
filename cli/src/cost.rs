//! `ancf plan --cost`: what a run will take, from its first steps.

use std::time::{Duration, Instant};

use ancf::model::Model;
use ancf::run::Simulation;

use crate::error::Result;

/// How long steps are made for.
const TRIED: Duration = Duration::from_millis(500);

/// A line with the time of the whole run on this machine, and the memory that the process has needed so far.
///
/// # Errors
/// A scene that cannot be run, or whose first steps fail.
pub fn cost_text(model: &Model) -> Result<String> {
    let steps = model.scene().steps();
    let mut simulation = Simulation::new(model.clone())?;
    let clock = Instant::now();
    while clock.elapsed() < TRIED && simulation.step()? {}
    let (made, seconds) = (simulation.steps_done().max(1), clock.elapsed().as_secs_f64());
    let whole = seconds * steps.max(made) as f64 / made as f64;
    let memory = peak_megabytes().map_or(String::new(), |megabytes| format!(", {megabytes:.0} MB of memory"));
    Ok(format!(
        "a run takes about {whole:.1} s on one core of this machine{memory} (from the first {made} of {steps} steps)\n"
    ))
}

/// Most memory that this process has had, where the system tells.
fn peak_megabytes() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches(" kB").parse::<f64>().ok().map(|kilobytes| kilobytes / 1024.0)
}
