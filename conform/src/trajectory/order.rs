//! What two steps show: the order, the limit for a step of nothing.

use std::collections::BTreeMap;

use super::comparison::Comparison;
use super::frames::{Frames, Path, distance};
use super::outcome::{Named, OrderResult};
use super::run::Run;

/// Below this order a method has lost one, where methods of second order show at least [`SECOND`].
const FIRST: f64 = 1.4;
const SECOND: f64 = 1.7;
/// A difference within this many errors of right methods with the same step is one of the step.
pub const EXPLAINED: f64 = 2.0;

impl Comparison<'_> {
    /// What two steps show.
    pub fn order(&self) -> Option<OrderResult> {
        let ([one, two], Some(ratio)) = (&self.runs[..], self.ratio) else { return None };
        let off = [*self.off.first()?, *self.off.get(1)?];
        let (coarse, fine) = common(one, two);
        let apart = distance(&fine.position, &coarse.position);
        let order = (off[0] / off[1]).ln() / ratio.ln();
        let limits = [order.clamp(0.5, 4.0), 2.0].map(|p| extrapolated(&coarse, &fine, ratio.powf(p)));
        let right = self.right(two).position;
        let limit_off = limits.iter().map(|limit| distance(limit, &right)).fold(f64::INFINITY, f64::min);
        let expected = |n: usize| self.expected.get(n).and_then(|expected| Some(expected.as_ref()?.position));
        let order_of_a_right_method =
            expected(0).zip(expected(1)).map(|(coarse, fine)| (coarse / fine).ln() / ratio.ln());
        Some(OrderResult { ratio, off, apart, order, limit_off, order_of_a_right_method })
    }

    /// A method that comes to the reference, but more slowly than methods of second order do.
    pub fn lost_order(&self, order: &OrderResult) -> Option<Named> {
        let right = order.order_of_a_right_method?;
        let (_, off) = self.last();
        let expected = self.expected.last()?.as_ref()?.position;
        let approaches = order.limit_off < 0.5 * off && order.order > 0.5;
        let lost = approaches && order.order < FIRST && right > SECOND && off > EXPLAINED * expected;
        lost.then(|| Named {
            what: format!(
                "a first-order method: its error falls with order {:.2}, that of second-order methods with {right:.2}",
                order.order
            ),
            look_at: "the time-stepping method: where q̇ and q̈ are evaluated within the step".into(),
            distance: order.limit_off,
        })
    }
}

/// Frames of two runs at the times that both have, points that both have.
pub fn common(one: &Run, two: &Run) -> (Frames, Frames) {
    let of = |run: &Run, other: &Run| {
        let picked: Vec<usize> = (0..run.sampled.indices.len())
            .filter(|n| other.sampled.indices.contains(&run.sampled.indices[*n]))
            .collect();
        run.sampled.frames.picked(&picked)
    };
    (of(one, two), of(two, one))
}

/// Limit of two motions whose errors are in a ratio.
pub fn extrapolated(coarse: &Frames, fine: &Frames, ratio: f64) -> BTreeMap<String, Path> {
    let limit = |(point, path): (&String, &Path)| {
        let other = coarse.position.get(point)?;
        let extrapolate = |(p, q): (&[f64; 2], &[f64; 2])| [0, 1].map(|c| p[c] + (p[c] - q[c]) / (ratio - 1.0));
        Some((point.clone(), path.iter().zip(other).map(extrapolate).collect()))
    };
    fine.position.iter().filter_map(limit).collect()
}
