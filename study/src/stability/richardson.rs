//! Bounds the error of a run by runs with half and a quarter of its step (Richardson).
//!
//! x(h) − x(0) = Σ (x(h/2ⁿ) − x(h/2ⁿ⁺¹)). The first two terms are computed, d₁ and d₂. If each later term is at most q times the one
//! before, the rest is a geometric series: |x(h) − x(0)| ≤ d₁ + d₂/(1 − q). For q the observed ratio d₂/d₁ is taken, but not less than the
//! method's own 2⁻ᵖ, as a term may be small by chance. If the terms do not shrink, q ≥ 1, the bound is infinite. Series of meshes, or of
//! another parameter, are bounded alike.

use crate::error::Result;
use crate::path::{Path, largest_distance};
use ancf::model::{Method, Scene};
use ancf::run::{Run, run};

/// Order of a method's error in the step.
pub fn order(method: Method) -> i32 {
    match method {
        Method::Gauss | Method::GaussAdaptive | Method::Nystrom | Method::NystromAdaptive => 4,
        _ => 2,
    }
}

/// The first two terms of a series whose later terms shrink.
#[derive(Clone, Copy, Debug)]
pub struct Series {
    /// Change by half the step.
    pub first: f64,
    /// Change from half to a quarter of the step.
    pub second: f64,
    /// Largest ratio of a later term to the one before.
    pub ratio: f64,
    /// Ratio that the order of the method gives.
    expected: f64,
}

impl Series {
    /// Changes under halving by a method of this order.
    pub fn new(first: f64, second: f64, order: i32) -> Series {
        Series::with(first, second, 2f64.powi(-order))
    }

    /// Changes of which each should be `expected` times the one before.
    pub fn with(first: f64, second: f64, expected: f64) -> Series {
        // 0/0 is a series of zeros.
        let observed = if second == 0.0 { 0.0 } else { second / first };
        // `f64::max` would drop a NaN.
        let ratio = if observed.is_nan() { f64::NAN } else { observed.max(expected) };
        Series { first, second, ratio, expected }
    }

    /// The series if its terms are only known to `rounding`: a smaller term shows no order, and the expected ratio is taken.
    pub fn above(self, rounding: f64) -> Series {
        if self.second <= rounding { Series { ratio: self.expected, ..self } } else { self }
    }

    /// Bound of the whole series.
    pub fn bound(&self) -> f64 {
        if self.ratio < 1.0 { self.first + self.second / (1.0 - self.ratio) } else { f64::INFINITY }
    }

    /// Bound of the terms after the second.
    pub fn rest(&self) -> f64 {
        self.bound() - self.first - self.second
    }
}

impl std::fmt::Display for Series {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{:.1e} (halved {:.1e}, {:.1e})", self.bound(), self.first, self.second)
    }
}

/// Runs a scene with its step, half and a quarter of it, and compares the paths at the rows of the first.
///
/// # Errors
/// Those of [`run`].
pub fn in_steps(scene: &Scene, path: impl Fn(&Run) -> Path) -> Result<(Run, Series)> {
    let mut finer = scene.clone();
    finer.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
    let own = run(scene)?;
    let [half, quarter] = [(); 2].map(|()| {
        finer.time.step *= 0.5;
        run(&finer).map(|run| path(&run))
    });
    let half = half?;
    let changes = (largest_distance(&path(&own), &half), largest_distance(&half, &quarter?));
    Ok((own, Series::new(changes.0, changes.1, order(scene.time.method))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_an_order_is_the_error_and_luck_is_not_trusted() {
        // x(h) = h²: the error of h = 1 is 1.
        assert!((Series::new(0.75, 0.1875, 2).bound() - 1.0).abs() < 1e-15);
        // Order one, observed of a method of order two: x(h) = h.
        assert!((Series::new(0.5, 0.25, 2).bound() - 1.0).abs() < 1e-15);
        assert!(Series::new(0.75, 0.0, 2).bound() >= 0.75);
        assert_eq!(Series::new(0.0, 0.0, 2).bound(), 0.0);
        assert!((Series::new(1e-14, 3e-14, 2).above(3e-14).bound() - 5e-14).abs() < 1e-20);
        assert_eq!(Series::new(1e-14, 3e-14, 2).above(1e-14).bound(), f64::INFINITY);
        assert_eq!(Series::new(1e-14, f64::NAN, 2).above(1e-14).bound(), f64::INFINITY);
        for (first, second) in [(0.1, 0.1), (0.1, 0.2), (0.0, 0.1), (f64::NAN, 0.1), (0.1, f64::NAN)] {
            assert_eq!(Series::new(first, second, 2).bound(), f64::INFINITY, "{first}, {second}");
        }
    }
}
