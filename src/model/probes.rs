//! Probes: what is recorded, and where.

use serde::{Deserialize, Serialize};

use super::choice::Quantity;
use super::json::shape;

/// Quantities recorded at a point, or along a rod.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name that heads the columns.
    pub name: String,
    /// Name of the point; `None` for a place on a rod.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub point: Option<String>,
    /// Name of a rod: with a point, the rod on which the reaction acts; without, the rod that is looked at.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub rod: Option<String>,
    /// Place on the rod as a fraction of its length, 0 … 1.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
    /// What is recorded, in the order of the columns.
    pub of: Vec<Quantity>,
}

impl Probe {
    /// Quantities of a point.
    pub fn point(name: &str, point: &str, of: &[Quantity]) -> Probe {
        Probe { name: name.into(), point: Some(point.into()), rod: None, at: None, of: of.into() }
    }

    /// The force on one of the rods that meet at a point.
    pub fn force_on(name: &str, point: &str, rod: &str) -> Probe {
        Probe { rod: Some(rod.into()), ..Probe::point(name, point, &[Quantity::Reaction]) }
    }

    /// The deflection of a rod at a fraction of its length.
    pub fn deflection(name: &str, rod: &str, at: f64) -> Probe {
        let of = vec![Quantity::Deflection];
        Probe { name: name.into(), point: None, rod: Some(rod.into()), at: Some(at), of }
    }
}

/// Columns of `trajectory.csv` that hold energies, J.
pub const ENERGY_COLUMNS: [&str; 5] =
    ["energy.kinetic", "energy.strain", "energy.potential", "energy.input", "energy.balance"];
