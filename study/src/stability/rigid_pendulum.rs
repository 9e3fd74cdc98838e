//! The rigid pendulum in closed form: Jacobi's elliptic functions by the arithmetic–geometric mean.

use ancf::model::{Element, Scene};

/// sn, cn and dn of `u` with the parameter m = k², 0 ≤ m < 1 (Abramowitz and Stegun 16.4: descending Landen steps).
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let (mut a, mut c) = (vec![1.0], vec![m.sqrt()]);
    let mut b = (1.0 - m).sqrt();
    while c[c.len() - 1].abs() > f64::EPSILON * a[a.len() - 1] && a.len() < 16 {
        let last = a[a.len() - 1];
        a.push(0.5 * (last + b));
        c.push(0.5 * (last - b));
        b = (last * b).sqrt();
    }
    let steps = a.len() - 1;
    let mut phi = (1u64 << steps) as f64 * a[steps] * u;
    for n in (1..=steps).rev() {
        phi = 0.5 * (phi + (c[n] / a[n] * phi.sin()).asin());
    }
    let (sin, cos) = phi.sin_cos();
    [sin, cos, (1.0 - m * sin * sin).sqrt()]
}

/// A rigid pendulum of length `l` (m) about its end: I φ'' = −½ m g L sin φ, φ from the downward vertical.
#[derive(Clone, Copy, Debug)]
pub struct RigidPendulum {
    /// Length, m.
    l: f64,
    /// ω₀² = m g L/(2 I), (rad/s)².
    pub square: f64,
}

impl RigidPendulum {
    /// Of a uniform section of height `h` (m): I = mL²/3 + mh²/12.
    fn new(l: f64, h: f64, g: f64) -> RigidPendulum {
        RigidPendulum { l, square: 0.5 * g * l / (l * l / 3.0 + h * h / 12.0) }
    }

    /// The rigid limit of the built-in pendulum of 1 m. Euler–Bernoulli elements have no rotary inertia: h = 0.
    pub fn limit_of(scene: &Scene) -> RigidPendulum {
        let h = if scene.rods[0].element == Element::Ancf { scene.section.height } else { 0.0 };
        RigidPendulum::new(1.0, h, -scene.gravity[1])
    }

    /// Tip at time `t` after release from rest at (l, 0): sin(φ/2) = k cd(ω₀t | k²) with k = sin(π/4).
    pub fn released(&self, t: f64) -> [f64; 2] {
        let m = 0.5;
        let [_, cn, dn] = jacobi(self.square.sqrt() * t, m);
        let half = m.sqrt() * cn / dn;
        let (sin, cos) = (2.0 * half * (1.0 - half * half).sqrt(), 1.0 - 2.0 * half * half);
        [self.l * sin, -self.l * cos]
    }

    /// Tip at time `t` if it passes the lowest point at t = 0 with `omega` (rad/s), more than 2ω₀, and goes over the top:
    /// φ/2 = am(ωt/2 | m) with m = (2ω₀/ω)².
    pub fn circling(&self, omega: f64, t: f64) -> [f64; 2] {
        let [sn, cn, _] = jacobi(0.5 * omega * t, 4.0 * self.square / (omega * omega));
        [self.l * 2.0 * sn * cn, -self.l * (cn * cn - sn * sn)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against another closed form: the differential equations sn' = cn dn, and the identities.
    #[test]
    fn jacobis_functions_satisfy_their_equations() {
        for m in [0.0, 0.1, 0.5, 0.9, 0.999] {
            for n in 0..60 {
                let u = -3.0 + 0.2 * f64::from(n);
                let [sn, cn, dn] = jacobi(u, m);
                assert!((sn * sn + cn * cn - 1.0).abs() < 1e-14 && (dn * dn + m * sn * sn - 1.0).abs() < 1e-14);
                let h = 1e-4;
                let at = |u: f64| jacobi(u, m)[0];
                let slope = (8.0 * (at(u + h) - at(u - h)) - (at(u + 2.0 * h) - at(u - 2.0 * h))) / (12.0 * h);
                assert!((slope - cn * dn).abs() < 1e-10, "m {m}, u {u}: {slope}, {}", cn * dn);
            }
        }
    }

    /// Against the oracle's pendulum, rounded from 30 digits.
    #[test]
    fn the_released_pendulum_is_the_oracles() {
        let oracle = crate::paper::reference_pendulum::Oracle::load().unwrap();
        let pendulum = RigidPendulum::new(1.0, 0.02, 9.8);
        assert!(oracle.rigid.t.len() > 100);
        for (&t, tip) in oracle.rigid.t.iter().zip(&oracle.rigid.r) {
            let own = pendulum.released(t);
            let off = (own[0] - tip[0]).hypot(own[1] - tip[1]);
            assert!(off < 2e-14, "{off:e} at {t}");
        }
    }

    /// φ'' = −ω₀² sin φ by differences of the tip's path, and the speed at the lowest point.
    #[test]
    fn the_circling_pendulum_satisfies_its_equation() {
        let (pendulum, omega, h) = (RigidPendulum::new(1.0, 0.02, 9.8), 9.0, 1e-3);
        let phi = |t: f64| {
            let [x, y] = pendulum.circling(omega, t);
            x.atan2(-y)
        };
        assert!((phi(1e-6) / 1e-6 - omega).abs() < 1e-6);
        for n in 0..40 {
            let t = 0.05 * f64::from(n);
            let turn =
                |angle: f64| (angle - phi(t) + 3.0 * std::f64::consts::PI).rem_euclid(2.0 * std::f64::consts::PI);
            let second = (turn(phi(t + h)) + turn(phi(t - h)) - 2.0 * std::f64::consts::PI) / (h * h);
            assert!((second + pendulum.square * phi(t).sin()).abs() < 1e-3, "t {t}: {second}");
        }
    }
}
