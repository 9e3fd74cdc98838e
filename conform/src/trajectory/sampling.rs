//! A program's samples at the reference's times.

use std::collections::BTreeMap;

use super::frames::{Frames, Path};
use super::reference::Reference;
use super::written::Written;
use crate::error::{Error, Result};

/// Samples this near to a time of the reference, in parts of the reference's interval, are at that time.
const SAME_TIME: f64 = 1e-6;

/// A program's motion at times of the reference.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// Indices of those times in the reference.
    pub indices: Vec<usize>,
    /// The motion.
    pub frames: Frames,
    /// Estimated error of interpolated positions, m; 0 where nothing was interpolated.
    pub interpolation: f64,
    /// Number of times between samples.
    pub interpolated: usize,
    /// Largest distance of samples, s.
    pub interval: f64,
}

/// Samples a motion at all times of the reference that it reaches.
///
/// # Errors
/// [`Error::Motion`] if it reaches none, or its samples are too far apart to be interpolated.
pub fn sample(written: &Written, reference: &Reference) -> Result<Sampled> {
    let t = &written.frames.t;
    let fault = |value: String, allowed: String| Error::Motion {
        file: written.file.clone(),
        place: "samples".into(),
        value,
        allowed,
    };
    let interval = reference.frames.t.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    let slack = SAME_TIME * interval;
    let within =
        |time: &f64| t.first().is_some_and(|t| *t <= time + slack) && t.last().is_some_and(|t| *t >= time - slack);
    let indices: Vec<usize> = (0..reference.frames.t.len()).filter(|n| within(&reference.frames.t[*n])).collect();
    let wanted = format!(
        "samples at the fixture's times, 0, {interval}, {} … {} s",
        2.0 * interval,
        reference.frames.t.last().unwrap_or(&0.0)
    );
    if indices.len() < 2 {
        let (first, last) = (t.first().unwrap_or(&0.0), t.last().unwrap_or(&0.0));
        return Err(fault(format!("they last from {first} to {last} s"), wanted));
    }
    let mut frames = Frames { t: indices.iter().map(|n| reference.frames.t[*n]).collect(), ..Frames::default() };
    let (mut interpolation, mut interpolated): (f64, usize) = (0.0, 0);
    for (n, time) in frames.t.iter().enumerate() {
        let next = t.partition_point(|t| *t < time - slack);
        let exact = t.get(next).is_some_and(|t| (t - time).abs() <= slack);
        interpolated += usize::from(!exact);
        for (point, path) in &written.frames.position {
            let velocity = written.frames.velocity.get(point);
            let value = if exact {
                path[next]
            } else {
                let (value, error) = interpolate(t, path, velocity, *time, next)
                    .ok_or_else(|| fault(format!("{} are too few to be interpolated", t.len()), wanted.clone()))?;
                interpolation = interpolation.max(error);
                value
            };
            put(&mut frames.position, point, value, n);
        }
        for (point, path) in &written.frames.velocity {
            let value =
                if exact { Some(path[next]) } else { interpolate(t, path, None, *time, next).map(|(value, _)| value) };
            if let Some(value) = value {
                put(&mut frames.velocity, point, value, n);
            }
        }
        for (name, list) in &written.frames.energy {
            let pairs: Path = list.iter().map(|energy| [*energy, 0.0]).collect();
            let value = if exact {
                Some(list[next])
            } else {
                interpolate(t, &pairs, None, *time, next).map(|(value, _)| value[0])
            };
            frames.energy.entry(name.clone()).or_default().extend(value);
        }
    }
    let interval_of_samples = t.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    Ok(Sampled { indices, frames, interpolation, interpolated, interval: interval_of_samples })
}

fn put(table: &mut BTreeMap<String, Path>, point: &str, value: [f64; 2], n: usize) {
    let path = table.entry(point.to_string()).or_default();
    if path.len() == n {
        path.push(value);
    }
}

/// Value between samples, before the one with index `next`, with an estimate of its error: by the cubic through two samples and their
/// velocities, or else through four samples. The estimate is the difference from the cubic through the neighbours, which is worse.
fn interpolate(t: &[f64], path: &Path, velocity: Option<&Path>, time: f64, next: usize) -> Option<([f64; 2], f64)> {
    let after = next.clamp(1, t.len() - 1);
    let first = after.saturating_sub(2).min(t.len().checked_sub(4)?);
    let through = |nodes: &[usize]| {
        let mut value = [0.0; 2];
        for n in nodes {
            let others = nodes.iter().filter(|m| *m != n);
            let weight: f64 = others.map(|m| (time - t[*m]) / (t[*n] - t[*m])).product();
            value.iter_mut().zip(path[*n]).for_each(|(value, p)| *value += weight * p);
        }
        value
    };
    let cubic = through(&[first, first + 1, first + 2, first + 3]);
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    match velocity {
        Some(velocity) => {
            let (a, b) = (after - 1, after);
            let h = t[b] - t[a];
            let s = (time - t[a]) / h;
            let (p, q) = (s * s * (3.0 - 2.0 * s), [s * (1.0 - s).powi(2) * h, s * s * (s - 1.0) * h]);
            let value =
                [0, 1].map(|c| (1.0 - p) * path[a][c] + p * path[b][c] + q[0] * velocity[a][c] + q[1] * velocity[b][c]);
            Some((value, apart(value, cubic)))
        }
        None => {
            // Through samples twice as far apart the error is about sixteen times as large.
            let wide: Vec<usize> = (0..4).map(|n| (first + 2 * n).saturating_sub(3).min(t.len() - 1)).collect();
            let distinct = wide.windows(2).all(|pair| pair[0] < pair[1]);
            let nodes = if distinct { wide } else { vec![first, first + 1, first + 2] };
            Some((cubic, apart(cubic, through(&nodes)) / if distinct { 4.0 } else { 1.0 }))
        }
    }
}
