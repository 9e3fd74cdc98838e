//! What a scene has to fulfil beyond the types of its values: material, section, temperature and time.

use std::fmt::Display;

use super::topology::check_topology;
use super::{Material, Scene, Section, Start, Temperature, Time};

/// Most time steps of a run: more is a mistyped step, and would take days even with one element.
const MOST_STEPS: f64 = 1e9;

/// Most numbers in a trajectory, which is kept in memory: 0.8 GB.
const MOST_NUMBERS: f64 = 1e8;

/// How far a ratio that has to be whole may be from it: relative, and in the unit of the ratio. The first lets pass
/// steps that were written with ten digits; the second keeps the end of a long run within a thousandth of a step.
const WHOLE: (f64, f64) = (1e-9, 1e-3);

/// A value that is not allowed: the path of its key, the value, and what is allowed.
#[derive(Debug)]
pub(super) struct Refusal {
    pub(super) key: String,
    pub(super) value: String,
    pub(super) allowed: String,
}

/// Outcome of one check.
pub(super) type Check = Result<(), Refusal>;

/// Refuses `value` at `key` unless `holds`.
pub(super) fn require(holds: bool, key: impl Display, value: impl Display, allowed: impl Display) -> Check {
    if holds {
        return Ok(());
    }
    Err(Refusal { key: key.to_string(), value: value.to_string(), allowed: allowed.to_string() })
}

/// Refuses numbers that are not finite.
pub(super) fn finite(key: impl Display, value: f64) -> Check {
    require(value.is_finite(), key, value, "a finite number")
}

/// Everything that a scene has to fulfil.
pub(super) fn check(scene: &Scene) -> Check {
    let title_holds = !scene.title.contains(char::is_control);
    require(title_holds, "title", format_args!("{:?}", scene.title), "a text in one line, without control characters")?;
    check_material(&scene.material)?;
    check_section(&scene.section)?;
    check_topology(scene)?;
    for (axis, &g) in scene.gravity.iter().enumerate() {
        finite(format_args!("gravity[{axis}]"), g)?;
    }
    if let Some(temperature) = &scene.temperature {
        check_history(temperature)?;
    }
    if let Some(heat) = scene.heat() {
        check_heat(heat, scene)?;
    }
    check_time(&scene.time)?;
    check_output(scene)
}

/// Refuses numbers that are not over 0.
fn positive(key: &str, value: f64) -> Check {
    require(value.is_finite() && value > 0.0, key, format_args!("{value:?}"), "a finite number over 0")
}

fn check_material(material: &Material) -> Check {
    let Material { youngs_modulus, nu, rho, alpha } = *material;
    positive("material.E", youngs_modulus)?;
    require(-1.0 < nu && nu < 0.5, "material.nu", format_args!("{nu:?}"), "a number between -1 and 0.5, without both")?;
    positive("material.rho", rho)?;
    finite("material.alpha", alpha)
}

fn check_section(section: &Section) -> Check {
    positive("section.height", section.height)?;
    positive("section.width", section.width)
}

/// The history is a function of time.
fn check_history(temperature: &Temperature) -> Check {
    let history = &temperature.history;
    for (i, &[time, change]) in history.iter().enumerate() {
        finite(format_args!("temperature.history[{i}][0]"), time)?;
        finite(format_args!("temperature.history[{i}][1]"), change)?;
    }
    for (i, pair) in history.windows(2).enumerate() {
        if let [[before, _], [time, _]] = pair {
            let key = format_args!("temperature.history[{}][0]", i + 1);
            require(
                time > before,
                key,
                format_args!("{time:?}"),
                format_args!("a time after the {before:?} s before it"),
            )?;
        }
    }
    Ok(())
}

/// What heat asks for, if it strains anything.
fn check_heat(heat: &Temperature, scene: &Scene) -> Check {
    require(!heat.history.is_empty(), "temperature.history", "[]", "at least one pair [t, dT]")?;
    let alpha = scene.material.alpha;
    // ΔT is linear between the pairs, so that 1 + 2αΔT is smallest at one of them.
    for (i, &[_, change]) in heat.history.iter().enumerate() {
        let limit = -0.5 / alpha;
        let side = if alpha > 0.0 { "over" } else { "under" };
        let allowed = format_args!("dT {side} {limit:.6e} K, where 1 + 2 alpha dT stays positive");
        let key = format_args!("temperature.history[{i}][1]");
        require(1.0 + 2.0 * alpha * change > 0.0, key, format_args!("{change:?}"), allowed)?;
    }
    let (rods, held) = (scene.rods.len(), scene.supports.len());
    let allowed = format_args!(
        "\"sudden\"; \"relaxed\" needs a single rod that is held at no more than one point, so that it can stretch \
         freely (here: rods {rods}, points held {held})"
    );
    require(heat.start == Start::Sudden || (rods == 1 && held <= 1), "temperature.start", "\"relaxed\"", allowed)
}

fn check_time(time: &Time) -> Check {
    let &Time { end, step, method: _, rho_inf, newton_tolerance } = time;
    positive("time.end", end)?;
    positive("time.step", step)?;
    let steps = end / step;
    let allowed = format_args!("at least {:.9e} s, for {MOST_STEPS:e} steps at most", end / MOST_STEPS);
    require(steps <= MOST_STEPS, "time.step", format_args!("{step:?}"), allowed)?;
    whole("time.end", end, step)?;
    let rho_holds = (0.0..=1.0).contains(&rho_inf);
    require(rho_holds, "time.rho_inf", format_args!("{rho_inf:?}"), "a number from 0 to 1, with both")?;
    let tolerance_holds = newton_tolerance > 0.0 && newton_tolerance <= 1e-2;
    let allowed = "a number over 0, and not over 1e-2";
    require(tolerance_holds, "time.newton_tolerance", format_args!("{newton_tolerance:?}"), allowed)
}

fn check_output(scene: &Scene) -> Check {
    let key = "output.interval";
    let Time { end, step, .. } = scene.time;
    if let Some(interval) = scene.output.interval {
        positive(key, interval)?;
        whole(key, interval, step)?;
    }
    let interval = scene.output.interval.unwrap_or(step);
    let rows = end / interval;
    let columns = scene.columns().len() as f64;
    let smallest = end * columns / MOST_NUMBERS;
    let allowed = format_args!("at least {smallest:.3e} s: {columns} columns, and {MOST_NUMBERS:e} numbers at most");
    require(rows * columns <= MOST_NUMBERS, key, format_args!("{interval:?}"), allowed)
}

/// Refuses a duration that is not a whole number of steps.
fn whole(key: &str, duration: f64, step: f64) -> Check {
    let count = duration / step;
    let holds = count > 0.5 && (count - count.round()).abs() <= (WHOLE.0 * count).min(WHOLE.1);
    let fitting = duration / count.ceil().max(1.0);
    let allowed = format_args!(
        "a whole number of steps of `time.step` = {step:?} s, not {count:.6}; a step of {fitting:.9e} s divides it"
    );
    require(holds, key, format_args!("{duration:?}"), allowed)
}
