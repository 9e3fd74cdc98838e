//! Rods and what they are made of.

use serde::{Deserialize, Serialize};

use super::choice::{Element, Poisson, is_default};
use super::heat::Temperature;
use super::json::shape;

/// An isotropic, linear thermo-elastic material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Young's modulus, Pa; positive.
    #[serde(rename = "E")]
    pub youngs_modulus: f64,
    /// Poisson's ratio ν; −1 < ν < 0.5.
    pub nu: f64,
    /// Density ρ, kg/m³; positive.
    pub rho: f64,
    /// Coefficient of thermal expansion α, 1/K; may be left out of a file that heats nothing.
    #[serde(default)]
    pub alpha: f64,
}

impl Material {
    /// A material that heat does not expand: Young's modulus (Pa), Poisson's ratio, density (kg/m³).
    pub fn new(youngs_modulus: f64, nu: f64, rho: f64) -> Material {
        Material { youngs_modulus, nu, rho, alpha: 0.0 }
    }

    /// Sets the coefficient of thermal expansion, 1/K.
    #[must_use]
    pub fn alpha(mut self, alpha: f64) -> Material {
        self.alpha = alpha;
        self
    }
}

/// A rectangular cross-section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// Height h in the plane of motion, m; positive.
    pub height: f64,
    /// Width w across the plane of motion, m; positive.
    pub width: f64,
}

impl Section {
    /// A section of this height in the plane of motion and width across it, m.
    pub fn new(height: f64, width: f64) -> Section {
        Section { height, width }
    }
}

/// A straight rod between two points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rod {
    /// The rod's own name.
    pub name: String,
    /// Name of the point where it begins.
    pub from: String,
    /// Name of the point where it ends.
    pub to: String,
    /// Number of elements, all of one length.
    #[serde(default = "default_elements")]
    pub elements: usize,
    /// Which element it is made of.
    #[serde(default, skip_serializing_if = "is_default")]
    pub element: Element,
    /// Where Poisson's terms act in the paper's element.
    #[serde(default, skip_serializing_if = "is_default")]
    pub poisson: Poisson,
    /// Name of the point at its middle, a node for even and odd numbers of elements; rods with one pivot are pinned there.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub pivot: Option<String>,
    /// Its own material; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub material: Option<Material>,
    /// Its own cross-section; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub section: Option<Section>,
    /// Its own change of temperature; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
}

fn default_elements() -> usize {
    8
}

impl Rod {
    /// A rod between two points: 8 of the paper's elements, with the scene's material, section and temperature.
    pub fn new(name: &str, from: &str, to: &str) -> Rod {
        Rod {
            name: name.into(),
            from: from.into(),
            to: to.into(),
            elements: default_elements(),
            element: Element::default(),
            poisson: Poisson::default(),
            pivot: None,
            material: None,
            section: None,
            temperature: None,
        }
    }

    /// Sets the kind and the number of its elements.
    #[must_use]
    pub fn elements(mut self, element: Element, elements: usize) -> Rod {
        (self.element, self.elements) = (element, elements);
        self
    }

    /// Names the point at its middle: rods with one pivot are pinned there.
    #[must_use]
    pub fn pivot(mut self, name: &str) -> Rod {
        self.pivot = Some(name.into());
        self
    }

    /// Gives it a temperature of its own.
    #[must_use]
    pub fn temperature(mut self, temperature: Temperature) -> Rod {
        self.temperature = Some(temperature);
        self
    }

    /// Whether it has a node of this name: where it begins, where it ends, or its pivot.
    pub(crate) fn has_node(&self, point: &str) -> bool {
        self.from == point || self.to == point || self.pivot.as_deref() == Some(point)
    }
}
