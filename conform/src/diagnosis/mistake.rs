//! Mistakes that can be recognised.

use schemars::JsonSchema;
use serde::Serialize;

/// A mistake that explains the answers to a quantity.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Mistake {
    /// Kind of the mistake.
    pub kind: MistakeKind,
    /// The mistake in words.
    pub what: String,
}

/// Kind of a mistake; likelier kinds first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MistakeKind {
    /// A printed error of the paper was copied.
    Erratum,
    /// The shear component has a thermal strain.
    HeatOnShear,
    /// The thermal strain acts along the global x axis instead of the rod.
    HeatAlongX,
    /// Another mistake in the thermal strain.
    Heat,
    /// Poisson's ratio enters in the wrong place.
    Poisson,
    /// Sine and cosine are exchanged.
    SinCos,
    /// The nodal vectors are in another order.
    NodeOrder,
    /// The x and y components are in another order.
    XyOrder,
    /// A transpose is missing or superfluous.
    Transpose,
    /// The value or a term has the wrong sign.
    Sign,
    /// The value or a term has a wrong factor.
    Factor,
    /// A term or a factor is missing.
    Missing,
    /// An integral uses too few points or wrong points.
    Quadrature,
    /// Another formula was used.
    Other,
    /// The formula is right, but the value has too few digits.
    Digits,
}

impl MistakeKind {
    /// Short name for reports.
    pub(crate) fn word(self) -> &'static str {
        match self {
            MistakeKind::Erratum => "printed error copied",
            MistakeKind::HeatOnShear => "heat on the shear component",
            MistakeKind::HeatAlongX => "heat along the global x",
            MistakeKind::Heat => "heat",
            MistakeKind::Poisson => "ν in the wrong place",
            MistakeKind::SinCos => "sin and cos exchanged",
            MistakeKind::NodeOrder => "node order",
            MistakeKind::XyOrder => "order of x and y in e",
            MistakeKind::Transpose => "transpose",
            MistakeKind::Sign => "sign",
            MistakeKind::Factor => "factor",
            MistakeKind::Missing => "missing term",
            MistakeKind::Quadrature => "quadrature",
            MistakeKind::Other => "another formula",
            MistakeKind::Digits => "too few digits",
        }
    }
}
