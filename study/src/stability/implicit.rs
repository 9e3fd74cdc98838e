//! Implicit methods with their constraints: no stability limit bounds their step.

use ancf::model::{Constraints, Element, Method};

/// An implicit method, with pins and supports condensed or by multipliers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Implicit {
    pub method: Method,
    pub constraints: Constraints,
}

/// All of them. Energy–momentum solves the same equations either way, so that only generalized-α comes with both constraints.
pub const IMPLICIT: [Implicit; 4] = [
    Implicit { method: Method::EnergyMomentum, constraints: Constraints::Condensed },
    Implicit { method: Method::GeneralizedAlpha, constraints: Constraints::Condensed },
    Implicit { method: Method::GeneralizedAlpha, constraints: Constraints::Multipliers },
    Implicit { method: Method::Gauss, constraints: Constraints::Condensed },
];

impl Implicit {
    /// Name of the variant with an element; the paper's is not named.
    pub fn with(&self, element: Element) -> String {
        let constraints = if self.constraints == Constraints::Multipliers { ", multipliers" } else { "" };
        let element = if element == Element::Ancf { String::new() } else { format!(", {element}") };
        format!("{}{constraints}{element}", self.method)
    }
}
