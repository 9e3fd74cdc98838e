//! When nothing is left of an element, or it has turned inside out.

use super::{Ancf, Shape};
use crate::elements::plane::{Quadratic, Vec2, Vector, at, slope_at};
use crate::equations::shape::Vector14;

/// Gauss's outermost points across the section, of h/2: √(3/5).
pub(in crate::elements) const OUTERMOST: f64 = 0.774_596_669_241_483_4;

/// a × b.
pub(in crate::elements) fn cross<V: Vector>(a: V, b: V) -> V::Number {
    a.turn().dot(b)
}

impl Ancf {
    /// The least det J of the 15 quadrature points. With J = [r₀' + yκ, d] it is r₀' × d + y κ × d, linear in y: least at one of the
    /// outermost points.
    pub(super) fn least_determinant(&self, u: &Vector14) -> f64 {
        let shape: Shape<Vec2> = self.shape_of(u);
        let delta: &Quadratic<Vec2> = &shape.delta;
        let of = |zeta: f64| {
            let (r_x, d) = (self.t + at(zeta, &shape.p), self.n + at(zeta, delta));
            let kappa = slope_at(zeta, delta) * (2.0 * self.per_length);
            cross(r_x, d) - OUTERMOST * self.half_height * cross(kappa, d).abs()
        };
        // A NaN is least of all.
        self.stations
            .iter()
            .map(|station| of(station.zeta))
            .fold(f64::INFINITY, |least, det| if det >= least { least } else { det })
    }
}
