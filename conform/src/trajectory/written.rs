//! A motion as a program wrote it.

use super::frames::Frames;
use crate::error::Error;

/// Columns of CSV, in words.
pub const COLUMNS: &str = "a header with `t` and columns of points, such as `tip_x,tip_y`, with or without `tip_vx,tip_vy`, \
                       `kinetic,strain,potential`";
/// Keys of JSON, in words.
pub const KEYS: &str = "an object such as {\"t\": [0, …], \"tip\": [[1, 0], …]}, with or without \"tip_velocity\", \"energy\", \
                    \"step\", \"q\", \"M\", \"q_ddot\"";

/// A motion as a program wrote it.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// Name of the file.
    pub file: String,
    /// Samples, in order of time.
    pub frames: Frames,
    /// Step of its method, where the file says so, s.
    pub step: Option<f64>,
    /// Half a unit of the last decimal place that is written, m.
    pub rounding: f64,
    /// Nodal coordinates at t = 0.
    pub nodal: Option<Vec<f64>>,
    /// Mass matrix, row by row.
    pub mass: Option<Vec<Vec<f64>>>,
    /// Accelerations of the nodal coordinates at t = 0.
    pub acceleration: Option<Vec<f64>>,
    /// Time of the first sample that is not a number, from which on the file is ignored.
    pub ends_at: Option<f64>,
    /// Columns or keys that are not known.
    pub ignored: Vec<String>,
}

/// An error with place, value and what is allowed.
pub fn fault(file: &str, place: impl Into<String>, value: impl Into<String>, allowed: impl Into<String>) -> Error {
    Error::Motion { file: file.into(), place: place.into(), value: value.into(), allowed: allowed.into() }
}
