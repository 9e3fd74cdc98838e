//! Settings that only some methods use.

use super::choice::Method;
use super::time::Time;

/// Setting of some methods.
pub struct Setting {
    pub key: &'static str,
    pub is_used: fn(Method) -> bool,
    /// What uses it, in words.
    pub users: &'static str,
    /// Its value as written.
    pub value: fn(&Time) -> String,
    /// Gives it the value of another time.
    pub copy: fn(&mut Time, &Time),
}

pub const SETTINGS: [Setting; 6] = [
    Setting {
        key: "time.path",
        is_used: |method| method == Method::Static,
        users: "only \"static\" follows one",
        value: |time| format!("\"{}\"", time.path),
        copy: |time, other| time.path = other.path,
    },
    Setting {
        key: "time.step",
        is_used: |method| method != Method::Static,
        users: "methods that move in time have a step, statics has `time.load_steps`",
        value: |time| format!("{:?}", time.step),
        copy: |time, other| time.step = other.step,
    },
    Setting {
        key: "time.rho_inf",
        is_used: |method| method == Method::GeneralizedAlpha,
        users: "\"generalized-alpha\" has a spectral radius",
        value: |time| format!("{:?}", time.rho_inf),
        copy: |time, other| time.rho_inf = other.rho_inf,
    },
    Setting {
        key: "time.newton_tolerance",
        is_used: |method| !method.is_explicit(),
        users: "implicit methods and \"static\" iterate",
        value: |time| format!("{:?}", time.newton_tolerance),
        copy: |time, other| time.newton_tolerance = other.newton_tolerance,
    },
    Setting {
        key: "time.tolerance",
        is_used: Method::is_adaptive,
        users: "\"gauss-adaptive\" and \"nystrom-adaptive\" choose their steps by it",
        value: |time| format!("{:?}", time.tolerance),
        copy: |time, other| time.tolerance = other.tolerance,
    },
    Setting {
        key: "time.load_steps",
        is_used: |method| method == Method::Static,
        users: "\"static\" has load steps",
        value: |time| time.load_steps.to_string(),
        copy: |time, other| time.load_steps = other.load_steps,
    },
];

/// Returns the settings that the method ignores to their defaults.
pub fn drop_idle(time: &mut Time) {
    let (method, default) = (time.method, Time::until(time.end));
    let idle = SETTINGS.iter().filter(|setting| !(setting.is_used)(method));
    idle.for_each(|setting| (setting.copy)(time, &default));
}
