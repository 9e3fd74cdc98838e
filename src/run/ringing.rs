//! Accelerations and reactions that ring: they jump back and forth from row to row, so that neither their rows nor, often,
//! their finer runs have a limit.

use crate::model::{Quantity, Scene};

use super::trajectory::Trajectory;

/// Successive changes that are looked at together.
const CHANGES: usize = 10;

/// Least number of them that turn back. Of a vibration with five rows a period 4 turn, of noise 6 or 7.
const TURNS: usize = 5;

/// Least mean change, relative to the largest value of both components.
const JUMP: f64 = 0.1;

/// Most columns named in the warning.
const MOST_NAMES: usize = 4;

/// Warning about accelerations and reactions that ring from row to row.
pub fn warning(scene: &Scene, trajectory: &Trajectory) -> Option<String> {
    if !scene.moves() {
        return None;
    }
    let columns = scene.probes.iter().filter(|probe| probe.mean.is_none()).flat_map(|probe| {
        let forces = probe.of.iter().filter(|of| matches!(of, Quantity::Acceleration | Quantity::Reaction));
        forces.map(|of| [0, 1].map(|component| format!("{}.{}", probe.name, of.suffixes()[component])))
    });
    let mut names: Vec<String> = Vec::new();
    for pair in columns {
        let Some(values) = pair.each_ref().map(|name| trajectory.column(name)).into_iter().collect::<Option<Vec<_>>>()
        else {
            continue;
        };
        let largest = values.iter().flatten().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        names.extend(pair.into_iter().zip(&values).filter(|(_, values)| rings(values, largest)).map(|(name, _)| name));
    }
    let more = if names.len() > MOST_NAMES { ", …" } else { "" };
    let quoted: Vec<String> = names.iter().take(MOST_NAMES).map(|name| format!("`{name}`")).collect();
    (!names.is_empty()).then(|| {
        format!(
            "values ring from row to row ({}{more}): {TURNS} or more of {CHANGES} successive changes turn back, and are {:.0} % of the \
             largest value or more on average; such values may not converge, which `--estimate` tells; a probe's `mean` over a \
             window of time does converge",
            quoted.join(", "),
            100.0 * JUMP
        )
    })
}

/// Whether values jump back and forth by a good part of the largest one.
fn rings(values: &[f64], largest: f64) -> bool {
    let changes: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    changes.windows(CHANGES).any(|changes| {
        let turns = changes.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        let mean = changes.iter().map(|change| change.abs()).sum::<f64>() / CHANGES as f64;
        turns >= TURNS && mean > JUMP * largest
    })
}

#[cfg(test)]
mod tests {
    use super::rings;

    fn wave(rows_per_period: f64, amplitude: f64) -> Vec<f64> {
        let angle = |row| std::f64::consts::TAU * f64::from(row) / rows_per_period;
        (0..100).map(|row| 1.0 + amplitude * angle(row).sin()).collect()
    }

    #[test]
    fn waves_that_rows_do_not_resolve_ring() {
        assert!(rings(&wave(2.3, 0.5), 1.5) && rings(&wave(3.7, 0.5), 1.5));
        assert!(!rings(&wave(5.5, 0.5), 1.5) && !rings(&wave(20.0, 5.0), 6.0));
    }

    #[test]
    fn small_ripples_and_steps_do_not() {
        assert!(!rings(&wave(2.3, 0.05), 1.05));
        let steps: Vec<f64> = (0..100).map(|row| f64::from(row / 10 % 2)).collect();
        assert!(!rings(&steps, 1.0) && !rings(&[1.0; 5], 1.0) && !rings(&[], 0.0));
    }
}
