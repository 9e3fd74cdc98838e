//! A reading of Section 4: its Figures 5 and 6, which the text does not have, leave supports, angle and temperature open.

use std::f64::consts::PI;

use ancf::model::{Direction, Scene, Support};

/// What the text leaves open.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    pub name: &'static str,
    /// Angle between the rods and the x axis at the start, degrees.
    pub angle: f64,
    pub guided: Guided,
    pub temperature: Temperature,
    /// Where a rod's deflection is measured, as a fraction of its length.
    pub at: f64,
}

/// The point that slides; b1 is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Guided {
    /// a1 on x = 0.
    A1,
    /// b4 on y = 0.
    B4,
}

/// How the temperature goes from corner to corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Temperature {
    /// In straight lines, as the scene has it.
    Lines,
    /// In half periods of a cosine.
    Cosines,
    /// 150 K sin(2πt/3 s), without corners.
    Sine,
}

/// The reading that the built-in scene has.
pub const ASSUMED: Reading =
    Reading { name: "as assumed", angle: 80.0, guided: Guided::A1, temperature: Temperature::Lines, at: 0.5 };

/// Readings that the text allows.
pub const READINGS: [Reading; 8] = [
    ASSUMED,
    Reading { name: "b4 guided on y = 0", guided: Guided::B4, ..ASSUMED },
    Reading { name: "79.5° at the start", angle: 79.5, ..ASSUMED },
    Reading { name: "82° at the start", angle: 82.0, ..ASSUMED },
    Reading { name: "cosine ramps", temperature: Temperature::Cosines, ..ASSUMED },
    Reading { name: "a sine", temperature: Temperature::Sine, ..ASSUMED },
    Reading { name: "deflection at ¼", at: 0.25, ..ASSUMED },
    Reading { name: "deflection at ¾", at: 0.75, ..ASSUMED },
];

/// Steps of a smooth history, s: 1/50 of a ramp.
const INTERVAL: f64 = 5e-3;

impl Reading {
    /// Changes the scene of the paper's structure, whose angle is that of the reading already.
    pub fn apply(&self, scene: &mut Scene) {
        if self.guided == Guided::B4 {
            scene.supports = vec![Support::pinned("b1"), Support::fixed("b4", &[Direction::Y])];
        }
        for probe in scene.probes.iter_mut().filter(|probe| probe.at.is_some()) {
            probe.at = Some(self.at);
        }
        if let Some(temperature) = &mut scene.temperature {
            temperature.history = self.history(&temperature.history);
        }
    }

    /// The temperature between the scene's corners.
    fn history(&self, corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let (Some([from, _]), Some([to, _])) = (corners.first(), corners.last()) else { return corners.to_vec() };
        let steps = ((to - from) / INTERVAL).round() as usize;
        let times = (0..=steps).map(|n| from + n as f64 * INTERVAL);
        match self.temperature {
            Temperature::Lines => corners.to_vec(),
            Temperature::Cosines => times.map(|t| [t, cosine(corners, t)]).collect(),
            // The second half period is the cold phase.
            Temperature::Sine => {
                let ends_hot = corners.iter().all(|[_, value]| *value >= 0.0);
                let value = |t: f64| if ends_hot && t > 1.5 { 0.0 } else { 150.0 * (2.0 * PI * t / 3.0).sin() };
                (0..=600).map(|n| f64::from(n) * INTERVAL).map(|t| [t, value(t)]).collect()
            }
        }
    }
}

/// The value at time `t` of corners joined by half periods of a cosine.
fn cosine(corners: &[[f64; 2]], t: f64) -> f64 {
    let piece = corners.windows(2).find(|pair| t <= pair[1][0]).or(corners.windows(2).last());
    piece.map_or(0.0, |pair| {
        let ([from, a], [to, b]) = (pair[0], pair[1]);
        a + 0.5 * (b - a) * (1.0 - (PI * ((t - from) / (to - from)).clamp(0.0, 1.0)).cos())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [0.25, 150.0], [1.25, 150.0], [1.75, -150.0]];

    #[test]
    fn smooth_histories_meet_the_corners() {
        let history = Reading { temperature: Temperature::Cosines, ..ASSUMED }.history(&CORNERS);
        for [t, value] in CORNERS {
            let met = history.iter().any(|[at, found]| (at - t).abs() < 1e-9 && (found - value).abs() < 1e-9);
            assert!(met, "{t}: {value}");
        }
        assert_eq!(ASSUMED.history(&CORNERS), CORNERS);
    }

    #[test]
    fn the_hot_half_of_a_sine_has_no_cold_phase() {
        let sine = Reading { temperature: Temperature::Sine, ..ASSUMED };
        assert!(sine.history(&CORNERS).iter().any(|[_, value]| *value < -149.0));
        assert!(sine.history(&CORNERS[..3]).iter().all(|[_, value]| *value >= -1e-9));
    }
}
