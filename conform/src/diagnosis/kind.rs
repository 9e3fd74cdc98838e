//! The kinds of mistakes that can be told apart.

use serde::Serialize;

/// One kind of mistake; the likeliest come first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A printed error of the paper, copied.
    Erratum,
    /// Heat on the shear component.
    HeatOnShear,
    /// Heat along the global x axis, not along the rod.
    HeatAlongX,
    /// Another mistake in the thermal strain.
    Heat,
    /// Poisson's ratio in the wrong place.
    Poisson,
    /// Sine and cosine exchanged.
    SinCos,
    /// The nodal vectors in another order.
    NodeOrder,
    /// x and y in another order.
    XyOrder,
    /// A transpose is missing, or one too many.
    Transpose,
    /// The sign, or that of a term.
    Sign,
    /// A factor ½ or 2, or another one.
    Factor,
    /// A term or a factor is missing.
    Missing,
    /// An integral by too few points, or by points at other places.
    Quadrature,
    /// Another formula.
    Other,
    /// The right formula with too few digits.
    Digits,
}

impl Kind {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Erratum => "printed error copied",
            Kind::HeatOnShear => "heat on the shear component",
            Kind::HeatAlongX => "heat along the global x",
            Kind::Heat => "heat",
            Kind::Poisson => "ν in the wrong place",
            Kind::SinCos => "sin and cos exchanged",
            Kind::NodeOrder => "node order",
            Kind::XyOrder => "order of x and y in e",
            Kind::Transpose => "transpose",
            Kind::Sign => "sign",
            Kind::Factor => "factor",
            Kind::Missing => "missing term",
            Kind::Quadrature => "quadrature",
            Kind::Other => "another formula",
            Kind::Digits => "too few digits",
        }
    }
}
