//! Probes: recorded quantities, and their places.

use serde::{Deserialize, Serialize};

use super::choice::Quantity;
use super::json::shape;

/// Quantities recorded at a point or along a rod.
///
/// ```
/// use ancf::model::{Probe, Quantity, Scene};
///
/// let mut scene = Scene::builtin("pendulum-flexible").unwrap();
/// scene.output.energy = false;
/// scene.probes = vec![Probe::point("tip", "a", &[Quantity::Position]), Probe::deflection("rod", "rod", 0.5)];
/// assert_eq!(scene.columns(), ["t", "tip.x", "tip.y", "rod.w"]);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name of the probe, which begins its column names.
    pub name: String,
    /// Name of the probed point; `None` for a place on a rod.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub point: Option<String>,
    /// Name of a rod. With a point: the rod on which the reaction acts; without: the probed rod.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub rod: Option<String>,
    /// Place on the rod, as a fraction 0 … 1 of its length.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
    /// Recorded quantities, in the order of the columns.
    pub of: Vec<Quantity>,
    /// Window, s, that ends at each row: recorded are means over it, in place of instantaneous values. Before the first
    /// window is over, means since the start. Accelerations and reactions after a shock have a mean that converges.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub mean: Option<f64>,
}

impl Probe {
    /// Probes quantities of a point.
    pub fn point(name: &str, point: &str, of: &[Quantity]) -> Probe {
        Probe { name: name.into(), point: Some(point.into()), rod: None, at: None, of: of.into(), mean: None }
    }

    /// Records means over a window of this length, s, that ends at each row.
    #[must_use]
    pub fn mean(mut self, window: f64) -> Probe {
        self.mean = Some(window);
        self
    }

    /// Probes the force on one of the rods that meet at a point.
    pub fn force_on(name: &str, point: &str, rod: &str) -> Probe {
        Probe { rod: Some(rod.into()), ..Probe::point(name, point, &[Quantity::Reaction]) }
    }

    /// Probes the deflection of a rod at a fraction of its length.
    pub fn deflection(name: &str, rod: &str, at: f64) -> Probe {
        let of = vec![Quantity::Deflection];
        Probe { name: name.into(), point: None, rod: Some(rod.into()), at: Some(at), of, mean: None }
    }
}

/// Energy columns of `trajectory.csv`, J.
pub const ENERGY_COLUMNS: [&str; 5] =
    ["energy.kinetic", "energy.strain", "energy.potential", "energy.input", "energy.balance"];
