//! Measures of a quantity over time, sampled in equal steps.

/// Samples in a time window, with the time of the first and the step, s.
#[derive(Clone, Debug)]
pub struct Signal {
    start: f64,
    step: f64,
    values: Vec<f64>,
}

impl Signal {
    /// A signal that begins at t = 0.
    pub fn new(step: f64, values: Vec<f64>) -> Signal {
        Signal { start: 0.0, step, values }
    }

    /// Times and values.
    pub fn points(&self) -> Vec<(f64, f64)> {
        self.values.iter().enumerate().map(|(n, value)| (self.start + n as f64 * self.step, *value)).collect()
    }

    /// Difference from another signal with the same times.
    pub fn less(&self, other: &Signal) -> Signal {
        let values = self.values.iter().zip(&other.values).map(|(a, b)| a - b).collect();
        Signal { values, ..*self }
    }

    /// The signal plus a number.
    pub fn shifted(&self, by: f64) -> Signal {
        Signal { values: self.values.iter().map(|value| value + by).collect(), ..*self }
    }

    /// The samples in a window of time.
    pub fn within(&self, from: f64, to: f64) -> Signal {
        let place = |t: f64| (((t - self.start) / self.step).round().max(0.0) as usize).min(self.values.len());
        let (first, last) = (place(from), place(to));
        Signal { start: self.start + first as f64 * self.step, values: self.values[first..last].to_vec(), ..*self }
    }

    /// Root mean square; 0 without samples.
    pub fn rms(&self) -> f64 {
        let squares = self.values.iter().map(|value| value * value).sum::<f64>();
        (squares / self.values.len().max(1) as f64).sqrt()
    }

    /// Largest absolute value.
    pub fn largest(&self) -> f64 {
        self.values.iter().map(|value| value.abs()).max_by(f64::total_cmp).unwrap_or(0.0)
    }

    /// Mean over a window around each sample by the trapezoidal rule, without samples whose window extends past an end.
    pub fn mean(&self, window: f64) -> Signal {
        let half = ((0.5 * window / self.step).round() as usize).max(1);
        let mean = |samples: &[f64]| {
            let ends = 0.5 * (samples[0] + samples[samples.len() - 1]);
            (samples[1..samples.len() - 1].iter().sum::<f64>() + ends) / (samples.len() - 1) as f64
        };
        let values = self.values.windows(2 * half + 1).map(mean).collect();
        Signal { start: self.start + half as f64 * self.step, values, ..*self }
    }

    /// Largest and smallest sample of each piece of time as long as a window, at its middle.
    pub fn envelope(&self, window: f64) -> [Vec<(f64, f64)>; 2] {
        let piece = ((window / self.step).round() as usize).max(1);
        let extreme = |wanted: fn(f64, f64) -> f64| {
            let of_piece = |(n, samples): (usize, &[f64])| {
                let middle = self.start + (n as f64 + 0.5) * piece as f64 * self.step;
                (middle, samples.iter().copied().fold(samples[0], wanted))
            };
            self.values.chunks_exact(piece).enumerate().map(of_piece).collect()
        };
        [extreme(f64::max), extreme(f64::min)]
    }

    /// The signal times a number.
    pub fn times(&self, factor: f64) -> Signal {
        Signal { values: self.values.iter().map(|value| factor * value).collect(), ..*self }
    }

    /// Vibration faster than a window: the signal minus its mean over the window.
    pub fn vibration(&self, window: f64) -> Signal {
        let mean = self.mean(window);
        let skip = ((mean.start - self.start) / self.step).round() as usize;
        let values = self.values[skip.min(self.values.len())..].iter().zip(&mean.values).map(|(a, b)| a - b).collect();
        Signal { values, ..mean }
    }
}

/// Root mean square of a vector's length.
pub fn rms(components: [&Signal; 2]) -> f64 {
    components.map(Signal::rms).into_iter().fold(0.0, f64::hypot)
}

/// Largest length of a vector over time.
pub fn largest(components: [&Signal; 2]) -> f64 {
    let lengths = components[0].values.iter().zip(&components[1].values).map(|(x, y)| x.hypot(*y));
    lengths.max_by(f64::total_cmp).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3 + 2t + sin(2π t/0.1), a slope and a vibration.
    fn signal() -> Signal {
        let t = |n: i32| f64::from(n) * 1e-3;
        Signal::new(1e-3, (0..=1000).map(|n| 3.0 + 2.0 * t(n) + (std::f64::consts::TAU * t(n) / 0.1).sin()).collect())
    }

    #[test]
    fn a_mean_over_whole_periods_leaves_the_slope() {
        let mean = signal().mean(0.1);
        for (t, value) in mean.points() {
            assert!((value - 3.0 - 2.0 * t).abs() < 1e-12, "{t}: {value}");
        }
        assert_eq!(mean.points().len(), 901);
    }

    #[test]
    fn vibration_is_what_the_mean_leaves() {
        let vibration = signal().vibration(0.1).within(0.1, 0.9);
        assert!((vibration.rms() - 0.5f64.sqrt()).abs() < 1e-12 && (vibration.largest() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn an_envelope_has_the_extremes() {
        let [upper, lower] = Signal::new(0.5, vec![1.0, 3.0, -2.0, 0.0, 9.0]).times(2.0).envelope(1.0);
        assert_eq!((upper, lower), (vec![(0.5, 6.0), (1.5, 0.0)], vec![(0.5, 2.0), (1.5, -4.0)]));
    }

    #[test]
    fn windows_begin_and_end_where_they_should() {
        let points = signal().within(0.2, 0.3).points();
        assert_eq!((points.len(), points[0].0), (100, 0.2));
        assert!((points[99].0 - 0.299).abs() < 1e-12);
        let difference = signal().less(&signal());
        assert_eq!((difference.largest(), rms([&difference, &difference])), (0.0, 0.0));
    }
}
