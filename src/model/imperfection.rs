//! Imperfection: a stress-free deviation of the initial shape.

use serde::{Deserialize, Serialize};

use super::json::shape;

/// Stress-free deviation of the initial shape, in the shape of a vibration mode or of one bowed rod.
///
/// ```
/// use ancf::model::Imperfection;
///
/// assert_eq!(Imperfection::of_mode(1, 1e-4).mode, Some(1));
/// assert_eq!(Imperfection::of_rod("column", -1e-4).rod.as_deref(), Some("column"));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Imperfection {
    /// Number of a vibration mode of the cold, unloaded structure, from 1 on in the order of frequencies. At the node that
    /// moves farthest (of equally far ones, the first of the first rod) a positive amplitude is to the left of the rod's
    /// direction from → to; along it, where that node moves along its rod.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub mode: Option<usize>,
    /// Name of a rod that is bowed between its ends: by sin(πx/L), by sin²(πx/L) where both ends are clamped, and by
    /// sin(πx/L) sin(πx/2L) · 3√3/4 from one clamped end. A positive amplitude is to the left of from → to.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub rod: Option<String>,
    /// Largest displacement, m; not zero.
    pub amplitude: f64,
}

impl Imperfection {
    /// Deviation in the shape of the `mode`-th vibration mode.
    pub fn of_mode(mode: usize, amplitude: f64) -> Imperfection {
        Imperfection { mode: Some(mode), rod: None, amplitude }
    }

    /// Bow of one rod.
    pub fn of_rod(rod: &str, amplitude: f64) -> Imperfection {
        Imperfection { mode: None, rod: Some(rod.into()), amplitude }
    }
}
