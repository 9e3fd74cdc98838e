//! Mean of a recorded quantity over a window of time.

use std::collections::VecDeque;

/// Mean of a vector over a window that ends at the last value, by the trapezoidal rule over the steps.
#[derive(Debug)]
pub struct WindowMean {
    /// Length of the window, s.
    window: f64,
    /// Last time and value.
    last: Option<(f64, [f64; 2])>,
    /// Times and integrals up to there, from the start of the window on.
    integrals: VecDeque<(f64, [f64; 2])>,
}

impl WindowMean {
    pub fn new(window: f64) -> WindowMean {
        WindowMean { window, last: None, integrals: VecDeque::new() }
    }

    /// Adds the value at a later time, s.
    pub fn add(&mut self, t: f64, value: [f64; 2]) {
        let so_far = self.integrals.back().map_or([0.0; 2], |(_, integral)| *integral);
        let (before, first) = self.last.unwrap_or((t, value));
        let integral = [0, 1].map(|n| so_far[n] + 0.5 * (t - before) * (first[n] + value[n]));
        self.integrals.push_back((t, integral));
        self.last = Some((t, value));
        // One integral at or before the start of the window stays.
        let starts = |(time, _): &(f64, [f64; 2])| *time <= t - self.window;
        while self.integrals.get(1).is_some_and(starts) {
            self.integrals.pop_front();
        }
    }

    /// Mean over the window, or since the first value if that is later; the value itself if it is the only one.
    pub fn mean(&self) -> [f64; 2] {
        let (Some((t, value)), Some((first, earliest)), Some((_, all))) =
            (self.last, self.integrals.front(), self.integrals.back())
        else {
            return [f64::NAN; 2];
        };
        let from = (t - self.window).max(*first);
        if from >= t {
            return value;
        }
        // The integral at the start of the window lies between those of two steps.
        let (next, integral) = self.integrals.get(1).copied().unwrap_or((t, *all));
        let share = (from - first) / (next - first);
        [0, 1].map(|n| (all[n] - earliest[n] - share * (integral[n] - earliest[n])) / (t - from))
    }
}

#[cfg(test)]
mod tests {
    use super::WindowMean;

    /// Mean of f(t) = (t, 1 − t) over the last window is its value in the middle.
    #[test]
    fn means_of_straight_lines() {
        let mut mean = WindowMean::new(0.5);
        for step in 0..=8 {
            let t = 0.125 * f64::from(step);
            mean.add(t, [t, 1.0 - t]);
            let middle = t - 0.25_f64.min(0.5 * t);
            assert_eq!(mean.mean(), [middle, 1.0 - middle], "t = {t}");
        }
    }

    /// A wave of a period that the window holds twice has the mean of its offset; its samples are 3 to 20 per period.
    #[test]
    fn a_wave_vanishes_over_its_periods() {
        let mut mean = WindowMean::new(0.2);
        for step in 0..=400 {
            let t = 0.005 * f64::from(step);
            mean.add(t, [2.0 + (20.0 * std::f64::consts::PI * t).sin(), 0.0]);
        }
        assert!((mean.mean()[0] - 2.0).abs() < 1e-12, "{:?}", mean.mean());
    }
}
