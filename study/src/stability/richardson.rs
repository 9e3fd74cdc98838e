//! How far a run is from a step of nothing, by three runs: with its step, with half and with a quarter of it.
//!
//! x(h) − x(0) = Σ (x(h/2ⁿ) − x(h/2ⁿ⁺¹)). The first two terms are computed, d₁ and d₂. If each later term is at most q of the one
//! before, the rest is a geometric series: |x(h) − x(0)| ≤ d₁ + d₂/(1 − q). The third run confirms the order: q is the ratio that is
//! observed, d₂/d₁, and never less than the method's own, 2⁻ᵖ, as a term may be small by luck. Where terms do not shrink, q ≥ 1,
//! nothing is known, and the bound is infinite. The same holds for meshes.

use super::helpers::Path;
use crate::error::Result;
use crate::error_time::samples::largest;
use ancf::model::Scene;
use ancf::run::{Run, run};

/// Two terms of the series.
#[derive(Clone, Copy, Debug)]
pub struct Halving {
    /// What half the step changes.
    pub first: f64,
    /// What a quarter changes of that.
    pub second: f64,
    /// Each later term over the one before, at most.
    pub ratio: f64,
    /// That of the method's order.
    order: f64,
}

impl Halving {
    /// Of the terms of a method of this order.
    pub fn new(first: f64, second: f64, order: i32) -> Halving {
        Halving::with(first, second, 2f64.powi(-order))
    }

    /// Of terms of which each should be `order` of the one before.
    pub fn with(first: f64, second: f64, order: f64) -> Halving {
        // 0/0 is a series of nothing.
        let observed = if second == 0.0 { 0.0 } else { second / first };
        // `f64::max` would drop it.
        let ratio = if observed.is_nan() { f64::NAN } else { observed.max(order) };
        Halving { first, second, ratio, order }
    }

    /// The same where terms are known to `rounding` only: the ratio of one that is less says nothing of the order, which is then the
    /// method's.
    pub fn above(self, rounding: f64) -> Halving {
        if self.second <= rounding { Halving { ratio: self.order, ..self } } else { self }
    }

    /// The series.
    pub fn bound(&self) -> f64 {
        if self.ratio < 1.0 { self.first + self.second / (1.0 - self.ratio) } else { f64::INFINITY }
    }
}

impl std::fmt::Display for Halving {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{:.1e} (halved {:.1e}, {:.1e})", self.bound(), self.first, self.second)
    }
}

/// Runs a scene with its step, half and a quarter of it, and compares the rows of the first.
///
/// # Errors
/// Those of [`run`].
pub fn in_steps(scene: &Scene, order: i32, path: impl Fn(&Run) -> Path) -> Result<(Run, Halving)> {
    let mut finer = scene.clone();
    finer.output.interval = Some(scene.output.interval.unwrap_or(scene.time.step));
    let own = run(scene)?;
    let [half, quarter] = [(); 2].map(|()| {
        finer.time.step *= 0.5;
        run(&finer).map(|run| path(&run))
    });
    let half = half?;
    let halving = Halving::new(largest(&path(&own), &half), largest(&half, &quarter?), order);
    Ok((own, halving))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_an_order_is_the_error_and_luck_is_not_trusted() {
        // x(h) = h²: the error of h = 1 is 1.
        assert!((Halving::new(0.75, 0.1875, 2).bound() - 1.0).abs() < 1e-15);
        // Order one seen of a method of order two: x(h) = h.
        assert!((Halving::new(0.5, 0.25, 2).bound() - 1.0).abs() < 1e-15);
        assert!(Halving::new(0.75, 0.0, 2).bound() >= 0.75);
        assert_eq!(Halving::new(0.0, 0.0, 2).bound(), 0.0);
        assert!((Halving::new(1e-14, 3e-14, 2).above(3e-14).bound() - 5e-14).abs() < 1e-20);
        assert_eq!(Halving::new(1e-14, 3e-14, 2).above(1e-14).bound(), f64::INFINITY);
        assert_eq!(Halving::new(1e-14, f64::NAN, 2).above(1e-14).bound(), f64::INFINITY);
        for (first, second) in [(0.1, 0.1), (0.1, 0.2), (0.0, 0.1), (f64::NAN, 0.1), (0.1, f64::NAN)] {
            assert_eq!(Halving::new(first, second, 2).bound(), f64::INFINITY, "{first}, {second}");
        }
    }
}
