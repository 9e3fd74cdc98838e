//! Reading a state: what no element can be is refused with the key and what is allowed.

use serde::de::DeserializeOwned;

use super::{CableState, ElementState, ThermalModel};
use crate::error::Result;
use crate::model::{Refusal, read_json, refuse_in_file};

/// How far e0 may be from the straight unstretched element of `theta`, in its own length.
const STRAIGHT: f64 = 1e-9;

impl ElementState {
    /// Reads and checks the text of a state; `file` is the name used in messages.
    ///
    /// # Errors
    /// [`Error::Scene`] with file, key, value and what is allowed.
    pub fn parse(text: &str, file: &str) -> Result<ElementState> {
        read(text, file, ElementState::check)
    }

    /// What an element has to fulfil beyond the types of its numbers.
    fn check(&self) -> std::result::Result<(), Refusal> {
        let &ElementState { l, h, w, theta, E, nu, rho, alpha, dT, .. } = self;
        let common = Common { l, h, w, theta, E, nu, rho, alpha, dT, e0: &self.e0, points: &self.points };
        common.check_numbers()?;
        if self.model != ThermalModel::None && 1.0 + 2.0 * alpha * dT <= 0.0 {
            return refuse("dT", dT, "1 + 2 alpha dT over 0: it is the square of the stretch without stress");
        }
        let Straight { t, n, .. } = common.straight();
        let [i, j, k] = [0.0, l / 2.0, l].map(|x| common.straight().at(x));
        common.check_initial(&[i, n, j, t, n, k, n])?;
        common.check_points(h / 2.0, "−h/2 ≤ y ≤ h/2")
    }
}

impl CableState {
    /// Reads and checks the text of a state; `file` is the name used in messages.
    ///
    /// # Errors
    /// [`Error::Scene`] with file, key, value and what is allowed.
    pub fn parse(text: &str, file: &str) -> Result<CableState> {
        read(text, file, CableState::check)
    }

    /// What a cable element has to fulfil beyond the types of its numbers.
    fn check(&self) -> std::result::Result<(), Refusal> {
        let &CableState { l, h, w, theta, E, nu, rho, alpha, dT, .. } = self;
        let common = Common { l, h, w, theta, E, nu, rho, alpha, dT, e0: &self.e0, points: &self.points };
        common.check_numbers()?;
        if self.model != ThermalModel::None && 1.0 + alpha * dT <= 0.0 {
            return refuse("dT", dT, "1 + alpha dT over 0: it is the stretch without stress");
        }
        let Straight { t, .. } = common.straight();
        let [i, k] = [0.0, l].map(|x| common.straight().at(x));
        common.check_initial(&[i, t, k, t])?;
        common.check_points(0.0, "0: points are those of the axis")
    }
}

/// A state that fulfils what it has to.
fn read<T: DeserializeOwned>(text: &str, file: &str, check: fn(&T) -> std::result::Result<(), Refusal>) -> Result<T> {
    let state = read_json(text, file, "state")?;
    check(&state).map_err(|refused| refuse_in_file(refused, text, file))?;
    Ok(state)
}

/// What states of both elements have.
struct Common<'a> {
    l: f64,
    h: f64,
    w: f64,
    theta: f64,
    E: f64,
    nu: f64,
    rho: f64,
    alpha: f64,
    dT: f64,
    e0: &'a [f64],
    points: &'a [[f64; 2]],
}

/// The straight, unstretched axis of the inclination theta through the first node of e0.
struct Straight {
    first: [f64; 2],
    /// Along it, and normal to it.
    t: [f64; 2],
    n: [f64; 2],
}

impl Straight {
    fn at(&self, x: f64) -> [f64; 2] {
        [self.first[0] + x * self.t[0], self.first[1] + x * self.t[1]]
    }
}

impl Common<'_> {
    fn check_numbers(&self) -> std::result::Result<(), Refusal> {
        let positive = [("l", self.l), ("h", self.h), ("w", self.w), ("E", self.E), ("rho", self.rho)];
        for (key, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return refuse(key, value, "a finite number over 0");
            }
        }
        if !(self.nu > -1.0 && self.nu < 0.5) {
            return refuse("nu", self.nu, "a number over −1 and under 0.5");
        }
        for (key, value) in [("theta", self.theta), ("alpha", self.alpha), ("dT", self.dT)] {
            if !value.is_finite() {
                return refuse(key, value, "a finite number");
            }
        }
        Ok(())
    }

    fn straight(&self) -> Straight {
        let (sin, cos) = self.theta.sin_cos();
        Straight { first: [self.e0[0], self.e0[1]], t: [cos, sin], n: [-sin, cos] }
    }

    /// e0 is a straight, unstretched element of the length l and the inclination theta, which has the `nodes`.
    fn check_initial(&self, nodes: &[[f64; 2]]) -> std::result::Result<(), Refusal> {
        let distances = self.e0.iter().zip(nodes.as_flattened()).map(|(own, straight)| (own - straight).abs());
        let away = distances.fold(0.0, f64::max);
        if self.e0.iter().all(|entry| entry.is_finite()) && away <= STRAIGHT * (1.0 + self.l) {
            return Ok(());
        }
        // Which of both is wrong shows where the last node is, whose position and one slope are the last four numbers.
        let last = &self.e0[self.e0.len() - 4..];
        let length = (last[0] - self.e0[0]).hypot(last[1] - self.e0[1]);
        let [x, y] = self.straight().at(self.l);
        let is_turned = (last[0] - x).hypot(last[1] - y) > STRAIGHT * (1.0 + self.l);
        if is_turned && (length - self.l).abs() <= STRAIGHT * (1.0 + self.l) {
            let direction = (last[1] - self.e0[1]).atan2(last[0] - self.e0[0]);
            return refuse("theta", self.theta, &format!("the inclination of e0, {direction:?} rad"));
        }
        let allowed = format!(
            "the nodal coordinates of a straight, unstretched element of the length l = {:?} and the inclination theta; its \
             last node is {length:?} from the first",
            self.l
        );
        Err(Refusal { key: "e0".into(), value: format!("{away:.1e} off"), allowed })
    }

    fn check_points(&self, highest: f64, heights: &str) -> std::result::Result<(), Refusal> {
        if self.points.is_empty() {
            let allowed = "one point [x, y] at least".into();
            return Err(Refusal { key: "points".into(), value: "[]".into(), allowed });
        }
        for (n, [x, y]) in self.points.iter().enumerate() {
            if !(0.0..=self.l).contains(x) {
                return refuse(&format!("points[{n}][0]"), *x, "0 ≤ x ≤ l");
            }
            if !(-highest..=highest).contains(y) {
                return refuse(&format!("points[{n}][1]"), *y, heights);
            }
        }
        Ok(())
    }
}

fn refuse(key: &str, value: f64, allowed: &str) -> std::result::Result<(), Refusal> {
    Err(Refusal { key: key.into(), value: format!("{value:?}"), allowed: allowed.into() })
}
