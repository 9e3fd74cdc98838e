//! A state from a file, checked: what no element can be is refused with the key and what is allowed. Or a stored one.

use std::io::ErrorKind;

use super::{ElementState, ThermalModel};
use crate::conformance::suite::{Parsed, Suite};
use crate::equations::shape::Vector14;
use crate::error::{Error, Result};
use crate::scene::{Refused, nearest, read_json};

/// How far e0 may be from the straight unstretched element of `theta`, in its own length.
const STRAIGHT: f64 = 1e-9;

/// The element state of a file; or the stored state of that name, also a cable element's or the terms of (23) of a structure.
///
/// # Errors
/// [`Error::NoState`] if there is neither, [`Error::Read`] if the file cannot be read, [`Error::Scene`] with file, key, value and
/// what is allowed if it holds no element state.
pub fn load(name: &str) -> Result<Parsed> {
    match std::fs::read_to_string(name) {
        Ok(text) => Ok(Parsed::Element(Box::new(ElementState::parse(&text, name)?))),
        Err(source) if source.kind() != ErrorKind::NotFound => Err(Error::Read { path: name.into(), source }),
        Err(_) => {
            let mut cases = Suite::embedded()?.cases;
            match cases.iter().position(|case| case.id == name) {
                Some(place) => Ok(cases.swap_remove(place).parsed),
                None => Err(unknown(name, cases.iter().map(|case| case.id.as_str()).collect())),
            }
        }
    }
}

fn unknown(name: &str, known: Vec<&str>) -> Error {
    let nearest = nearest(name, known.iter().copied()).map(|like| format!("; nearest: `{like}`")).unwrap_or_default();
    Error::NoState { name: name.into(), nearest, known: known.join(", ") }
}

impl ElementState {
    /// Reads and checks the text of a state; `file` is the name used in messages.
    ///
    /// # Errors
    /// [`Error::Scene`] with file, key, value and what is allowed.
    pub fn parse(text: &str, file: &str) -> Result<ElementState> {
        let state: ElementState = read_json(text, file, "state")?;
        state.check().map_err(|refused| refused.in_file(text, file))?;
        Ok(state)
    }

    /// What an element has to fulfil beyond the types of its numbers.
    fn check(&self) -> std::result::Result<(), Refused> {
        let refuse = |key: &str, value: f64, allowed: &str| {
            Err(Refused { key: key.into(), value: format!("{value:?}"), allowed: allowed.into() })
        };
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
        if self.model != ThermalModel::None && 1.0 + 2.0 * self.alpha * self.dT <= 0.0 {
            return refuse("dT", self.dT, "1 + 2 alpha dT over 0: it is the square of the stretch without stress");
        }
        self.check_initial()?;
        if self.points.is_empty() {
            let allowed = "one point [x, y] at least".into();
            return Err(Refused { key: "points".into(), value: "[]".into(), allowed });
        }
        for (n, [x, y]) in self.points.iter().enumerate() {
            if !(0.0..=self.l).contains(x) {
                return refuse(&format!("points[{n}][0]"), *x, "0 ≤ x ≤ l");
            }
            if !(-self.h / 2.0..=self.h / 2.0).contains(y) {
                return refuse(&format!("points[{n}][1]"), *y, "−h/2 ≤ y ≤ h/2");
            }
        }
        Ok(())
    }

    /// e0 is a straight, unstretched element of the length l and the inclination theta.
    fn check_initial(&self) -> std::result::Result<(), Refused> {
        let (sin, cos) = self.theta.sin_cos();
        let [x, y] = [self.e0[0], self.e0[1]];
        let along = |s: f64| [x + s * cos, y + s * sin];
        let (t, n) = ([cos, sin], [-sin, cos]);
        let vectors = [along(0.0), n, along(self.l / 2.0), t, n, along(self.l), n];
        let straight = Vector14::from_iterator(vectors.into_iter().flatten());
        let away = (Vector14::from(self.e0) - straight).amax();
        if away.is_finite() && away <= STRAIGHT * (1.0 + self.l) {
            return Ok(());
        }
        let allowed =
            "the nodal coordinates of a straight, unstretched element of the length l and the inclination theta";
        // Which of both is wrong shows where the last node is.
        let length = (self.e0[10] - x).hypot(self.e0[11] - y);
        let key = if (length - self.l).abs() <= STRAIGHT * (1.0 + self.l) { "theta" } else { "e0" };
        let value = if key == "theta" { format!("{:?}", self.theta) } else { format!("{away:.1e} off") };
        let allowed = if key == "theta" { "the inclination of e0, rad" } else { allowed };
        Err(Refused { key: key.into(), value, allowed: allowed.into() })
    }
}
