//! Reading a state from JSON, and its checks: a value that no element can have is refused with its key and what is allowed.

#![allow(non_snake_case)] // The keys of the JSON contract: E, dT.

use super::beam::{BeamState, CableState, ElementState};
use crate::error::Result;
use crate::model::{Refusal, ThermalModel, read_json, refuse_in_file};

/// Allowed distance of e0 from the straight, unstretched element of `theta`, as a fraction of 1 + l.
const STRAIGHT: f64 = 1e-9;

/// Most points: each has a thousand numbers in a listing.
const MOST_POINTS: usize = 1000;

type Check = std::result::Result<(), Refusal>;

impl ElementState {
    /// Reads a state of the paper's element from JSON `text` and checks it; `file` is the name in messages.
    ///
    /// # Errors
    /// [`Error::Scene`](crate::error::Error::Scene) with file, key, value and what is allowed.
    ///
    /// ```
    /// use ancf::state::ElementState;
    ///
    /// let text = r#"{"l": 2.0, "h": 0.1, "w": 0.05, "theta": 0.0,
    ///     "e0": [0, 0, 0, 1, 1, 0, 1, 0, 0, 1, 2, 0, 0, 1],
    ///     "e": [0, 0, 0, 1, 1, 0.2, 1, 0, 0, 1, 2, 0, 0, 1],
    ///     "edot": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    ///     "E": 2e8, "nu": 0.3, "rho": 7200.0, "alpha": 1e-5, "dT": 100.0, "model": "2d",
    ///     "points": [[0.0, 0.0], [1.0, 0.05]]}"#;
    /// let state = ElementState::parse(text, "state.json")?;
    /// assert_eq!(state.gravity, [0.0, 0.0]);
    ///
    /// let error = ElementState::parse(&text.replace("0.3", "0.5"), "state.json").unwrap_err();
    /// assert!(error.to_string().contains("nu"));
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    pub fn parse(text: &str, file: &str) -> Result<ElementState> {
        read(text, file, ElementState::check)
    }

    fn check(&self) -> Check {
        let &ElementState { l, h, alpha, dT, .. } = self;
        self.check_numbers()?;
        if self.model != ThermalModel::None && 1.0 + 2.0 * alpha * dT <= 0.0 {
            return refuse("dT", dT, "1 + 2 alpha dT over 0: it is the square of the stretch without stress");
        }
        let [i, j, k] = [0.0, l / 2.0, l].map(|x| self.on_straight_axis(x));
        let (t, n) = self.initial_axes();
        self.check_initial(&[i, n, j, t, n, k, n])?;
        self.check_points(h / 2.0, "−h/2 ≤ y ≤ h/2")
    }
}

impl CableState {
    /// Reads a state of the cable element from JSON `text` and checks it; `file` is the name in messages.
    ///
    /// # Errors
    /// [`Error::Scene`](crate::error::Error::Scene) with file, key, value and what is allowed.
    pub fn parse(text: &str, file: &str) -> Result<CableState> {
        read(text, file, CableState::check)
    }

    fn check(&self) -> Check {
        let &CableState { l, alpha, dT, .. } = self;
        self.check_numbers()?;
        if self.model == ThermalModel::Transverse {
            let allowed = "\"2d\", \"1d\" or \"none\": the element has no section that heat could strain across";
            return Err(Refusal { key: "model".into(), value: "\"transverse\"".into(), allowed: allowed.into() });
        }
        if self.model != ThermalModel::None && 1.0 + alpha * dT <= 0.0 {
            return refuse("dT", dT, "1 + alpha dT over 0: it is the stretch without stress");
        }
        let [i, k] = [0.0, l].map(|x| self.on_straight_axis(x));
        let (t, _) = self.initial_axes();
        self.check_initial(&[i, t, k, t])?;
        self.check_points(0.0, "0: points are those of the axis")
    }
}

/// A state that has passed its `check`.
fn read<const N: usize>(text: &str, file: &str, check: fn(&BeamState<N>) -> Check) -> Result<BeamState<N>>
where
    [f64; N]: serde::de::DeserializeOwned,
{
    let state = read_json(text, file, "state")?;
    check(&state).map_err(|refused| refuse_in_file(refused, text, file))?;
    Ok(state)
}

impl<const N: usize> BeamState<N> {
    fn check_numbers(&self) -> Check {
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

    /// Unit vectors along and across the initial axis of inclination theta.
    fn initial_axes(&self) -> ([f64; 2], [f64; 2]) {
        let (sin, cos) = self.theta.sin_cos();
        ([cos, sin], [-sin, cos])
    }

    /// Point at the length `x` of the straight axis of inclination theta through the first node of e0.
    fn on_straight_axis(&self, x: f64) -> [f64; 2] {
        let (t, _) = self.initial_axes();
        [self.e0[0] + x * t[0], self.e0[1] + x * t[1]]
    }

    /// e0 is the straight, unstretched element of length l and inclination theta, whose nodal vectors are `nodes`.
    fn check_initial(&self, nodes: &[[f64; 2]]) -> Check {
        let distances = self.e0.iter().zip(nodes.as_flattened()).map(|(own, straight)| (own - straight).abs());
        let away = distances.fold(0.0, f64::max);
        if self.e0.iter().all(|entry| entry.is_finite()) && away <= STRAIGHT * (1.0 + self.l) {
            return Ok(());
        }
        // The last node, whose position and one slope are the last four numbers, shows whether theta or e0 is wrong.
        let last = &self.e0[N - 4..];
        let length = (last[0] - self.e0[0]).hypot(last[1] - self.e0[1]);
        let [x, y] = self.on_straight_axis(self.l);
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

    fn check_points(&self, highest: f64, heights: &str) -> Check {
        if self.points.is_empty() {
            let allowed = "one point [x, y] at least".into();
            return Err(Refusal { key: "points".into(), value: "[]".into(), allowed });
        }
        if self.points.len() > MOST_POINTS {
            let (value, allowed) =
                (format!("a list of {}", self.points.len()), format!("at most {MOST_POINTS} points"));
            return Err(Refusal { key: "points".into(), value, allowed });
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

fn refuse(key: &str, value: f64, allowed: &str) -> Check {
    Err(Refusal { key: key.into(), value: format!("{value:?}"), allowed: allowed.into() })
}
