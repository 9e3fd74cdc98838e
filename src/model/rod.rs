//! Rods, materials and cross-sections.

use serde::{Deserialize, Serialize};

use super::choice::{Element, Law, Poisson, is_default};
use super::heat::Temperature;
use super::json::shape;

/// Isotropic, linear thermo-elastic material.
///
/// ```
/// use ancf::model::Material;
///
/// let aluminium = Material::new(7e10, 0.3, 2750.0).alpha(2.3e-5);
/// assert_eq!(aluminium.alpha, 2.3e-5);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Material {
    /// Young's modulus, Pa; positive.
    #[serde(rename = "E")]
    pub youngs_modulus: f64,
    /// Poisson's ratio ν; −1 < ν < 0.5.
    pub nu: f64,
    /// Density ρ, kg/m³; positive.
    pub rho: f64,
    /// Coefficient of thermal expansion α, 1/K; may be left out of a file without heat.
    #[serde(default)]
    pub alpha: f64,
}

impl Material {
    /// Material without thermal expansion: Young's modulus (Pa), Poisson's ratio, density (kg/m³).
    pub fn new(youngs_modulus: f64, nu: f64, rho: f64) -> Material {
        Material { youngs_modulus, nu, rho, alpha: 0.0 }
    }

    /// Sets the coefficient of thermal expansion α, 1/K.
    #[must_use]
    pub fn alpha(mut self, alpha: f64) -> Material {
        self.alpha = alpha;
        self
    }
}

/// Rectangular cross-section.
///
/// A scene file gives it by `height` and `width`, or by `area` and `inertia` of any section that is symmetric about its axis, of which it
/// is the rectangle with the same A and I: both elements know nothing else of a section. A shear stiffness is that of the rectangle.
///
/// ```
/// use ancf::model::Section;
///
/// let section = Section::new(0.02, 0.01);
/// assert_eq!((section.height, section.width), (0.02, 0.01));
///
/// // A tube of 16 mm outside and 12 mm inside.
/// let tube = Section::of_area(8.796e-5, 2.199e-9);
/// assert!((tube.area() / 8.796e-5 - 1.0).abs() < 1e-15 && (tube.inertia() / 2.199e-9 - 1.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(try_from = "SectionKeys")]
#[non_exhaustive]
pub struct Section {
    /// Height h in the plane of motion, m; positive.
    pub height: f64,
    /// Width w across the plane of motion, m; positive.
    pub width: f64,
}

impl Section {
    /// Cross-section from its height in the plane of motion and its width across it, m.
    pub fn new(height: f64, width: f64) -> Section {
        Section { height, width }
    }

    /// The rectangle with this area A, m², and second moment of area I about the axis across the plane, m⁴: h = √(12 I/A), w = A/h.
    pub fn of_area(area: f64, inertia: f64) -> Section {
        let height = (12.0 * inertia / area).sqrt();
        Section { height, width: area / height }
    }

    /// Area A = h w, m².
    pub fn area(&self) -> f64 {
        self.height * self.width
    }

    /// Second moment of area I = w h³/12, m⁴.
    pub fn inertia(&self) -> f64 {
        self.width * self.height.powi(3) / 12.0
    }
}

/// The keys of a section in a file: `height` and `width`, or `area` and `inertia`.
#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(extend("oneOf" = [{"required": ["height", "width"]}, {"required": ["area", "inertia"]}])))]
#[serde(deny_unknown_fields)]
struct SectionKeys {
    /// Height h in the plane of motion, m; positive.
    #[serde(default, deserialize_with = "shape::some")]
    height: Option<f64>,
    /// Width w across the plane of motion, m; positive.
    #[serde(default, deserialize_with = "shape::some")]
    width: Option<f64>,
    /// Area A of a section that is no rectangle, m²; positive. It is computed as the rectangle with the same A and I.
    #[serde(default, deserialize_with = "shape::some")]
    area: Option<f64>,
    /// Its second moment of area I about the axis across the plane, m⁴; positive.
    #[serde(default, deserialize_with = "shape::some")]
    inertia: Option<f64>,
}

impl TryFrom<SectionKeys> for Section {
    // In serde's words, which the reader of a scene explains.
    type Error = String;

    fn try_from(keys: SectionKeys) -> Result<Section, String> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let SectionKeys { height, width, area, inertia } = keys;
        Err(match [height, width, area, inertia] {
            [Some(height), Some(width), None, None] => return Ok(Section { height, width }),
            [None, None, Some(area), Some(inertia)] if positive(area) && positive(inertia) => {
                return Ok(Section::of_area(area, inertia));
            }
            [None, None, Some(_), Some(_)] => "invalid section, expected an `area` and an `inertia` over 0",
            [None, _, None, None] => "missing field `height`",
            [_, None, None, None] => "missing field `width`",
            [None, None, None, _] => "missing field `area`",
            [None, None, _, None] => "missing field `inertia`",
            _ => "invalid section, expected either `height` and `width`, or `area` and `inertia`",
        }
        .into())
    }
}

/// Straight rod between two points.
///
/// ```
/// use ancf::model::{Element, Rod};
///
/// let rod = Rod::new("ab", "a", "b");
/// assert_eq!((rod.elements, rod.element), (8, Element::Ancf));
///
/// let scissor = Rod::new("cd", "c", "d").elements(Element::EulerBernoulli, 4).pivot("m");
/// assert_eq!(scissor.pivot.as_deref(), Some("m"));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Rod {
    /// Name of the rod.
    pub name: String,
    /// Name of its first point.
    pub from: String,
    /// Name of its last point.
    pub to: String,
    /// Number of elements, all of equal length.
    #[serde(default = "default_elements")]
    pub elements: usize,
    /// Element type.
    #[serde(default, skip_serializing_if = "is_default")]
    pub element: Element,
    /// Where Poisson's terms act in the paper's element.
    #[serde(default, skip_serializing_if = "is_default")]
    pub poisson: Poisson,
    /// Law between stress and strain of the paper's element.
    #[serde(default, skip_serializing_if = "is_default")]
    pub law: Law,
    /// Name of the pivot, a point at the rod's middle; rods with the same pivot are pinned together there. The paper's
    /// element has a node there for even and odd numbers of elements.
    #[serde(default, deserialize_with = "shape::some", skip_serializing_if = "Option::is_none")]
    pub pivot: Option<String>,
    /// The rod's own material; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub material: Option<Material>,
    /// The rod's own cross-section; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub section: Option<Section>,
    /// The rod's own temperature change; `None`: the scene's.
    #[serde(default, deserialize_with = "shape::some_object", skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
}

fn default_elements() -> usize {
    8
}

impl Rod {
    /// Rod between two points, with 8 of the paper's elements and the scene's material, section and temperature.
    pub fn new(name: &str, from: &str, to: &str) -> Rod {
        Rod {
            name: name.into(),
            from: from.into(),
            to: to.into(),
            elements: default_elements(),
            element: Element::default(),
            poisson: Poisson::default(),
            law: Law::default(),
            pivot: None,
            material: None,
            section: None,
            temperature: None,
        }
    }

    /// Sets the element type and the number of elements.
    #[must_use]
    pub fn elements(mut self, element: Element, elements: usize) -> Rod {
        (self.element, self.elements) = (element, elements);
        self
    }

    /// Names the point at the rod's middle: rods with the same pivot are pinned together there.
    #[must_use]
    pub fn pivot(mut self, name: &str) -> Rod {
        self.pivot = Some(name.into());
        self
    }

    /// Gives the rod a temperature change of its own.
    #[must_use]
    pub fn temperature(mut self, temperature: Temperature) -> Rod {
        self.temperature = Some(temperature);
        self
    }

    /// Whether Poisson's terms act in the rod: of the paper's element, in plane strain, at ν ≠ 0.
    pub(crate) fn has_poissons_terms(&self, material: &Material) -> bool {
        self.element == Element::Ancf && self.law == Law::PlaneStrain && material.nu != 0.0
    }

    /// Whether the rod has a node at the point: one of its ends, or its pivot.
    pub(crate) fn has_node(&self, point: &str) -> bool {
        self.from == point || self.to == point || self.pivot.as_deref() == Some(point)
    }
}
