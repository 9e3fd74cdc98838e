//! A part of the time in which distances are compared.

use serde::Serialize;

/// A part of the time, s, without its start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Window {
    pub from: f64,
    pub to: f64,
    /// Its number among the windows.
    #[serde(skip)]
    pub number: usize,
}

impl Window {
    /// Whether it includes a time.
    pub fn contains(&self, t: f64) -> bool {
        t > self.from + 1e-9 && t <= self.to + 1e-9
    }
}

impl std::fmt::Display for Window {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} … {} s", self.from, self.to)
    }
}
