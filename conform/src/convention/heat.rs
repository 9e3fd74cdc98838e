//! Place where the thermal strain is subtracted: in the strain (14), or in the law that gives the stress.

use super::rest::value_at_rest;
use crate::suite::State;

/// Strains, with the quantities that follow from them: those must be right where a strain keeps its heat.
pub(super) const STRAINS: [(&str, &[&str]); 3] = [
    ("14.epsilon", &["15.sigma", "18.U", "19.Q_e", "tangent.dQ_e"]),
    ("axis.epsilon", &["axis.U", "axis.Q_e", "axis.tangent", "uniaxial.U", "uniaxial.Q_e", "uniaxial.tangent"]),
    ("cable.epsilon", &["cable.U", "cable.Q_e", "cable.tangent"]),
];

/// Whether each of [`STRAINS`] is the whole strain, and its heat is subtracted inside the law.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Heat(pub(super) [bool; 3]);

impl Heat {
    /// Difference of an answer from the reference value, entry by entry; `None` for other quantities.
    pub(super) fn shift(self, quantity: &str, state: &State) -> Option<Vec<f64>> {
        let is_whole = STRAINS.iter().zip(self.0).any(|((name, _), whole)| *name == quantity && whole);
        // At e = e0 the strain less heat is −ε_T.
        is_whole.then(|| value_at_rest(quantity, state).unwrap_or_default().iter().map(|eps| -eps).collect())
    }

    /// The convention in words.
    pub(super) fn words(self) -> String {
        let names = STRAINS.iter().zip(self.0).filter(|(_, whole)| *whole).map(|((name, _), _)| *name);
        format!("{} is the whole strain; the heat is subtracted inside the law", names.collect::<Vec<_>>().join(", "))
    }
}
