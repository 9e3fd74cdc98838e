//! Constant part of the strain energy, which no force depends on.

use super::rest::value_at_rest;
use crate::suite::State;

/// Quantities that are strain energies.
pub(super) const ENERGIES: [&str; 4] = ["18.U", "axis.U", "uniaxial.U", "cable.U"];

/// What a program leaves out of each of [`ENERGIES`], in multiples of ½ ∫ ε_Tᵀ D ε_T dV.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy(pub(super) [f64; 4]);

/// Choices: all of U, without the constant, with its sign reversed.
pub(super) const MULTIPLES: [f64; 3] = [0.0, 1.0, 2.0];

impl Energy {
    /// Difference of an answer from the reference value; zero for other quantities.
    pub(super) fn shift(self, quantity: &str, state: &State) -> f64 {
        let multiple = ENERGIES.iter().zip(self.0).find(|(name, _)| **name == quantity).map_or(0.0, |(_, of)| of);
        if multiple == 0.0 {
            return 0.0;
        }
        // At e = e0 the strain is −ε_T, and the energy is the constant.
        let constant = value_at_rest(quantity, state).and_then(|value| value.first().copied());
        -multiple * constant.unwrap_or(f64::NAN)
    }

    /// The convention in words.
    pub(super) fn words(self) -> String {
        let list = |wanted: f64| {
            let names = ENERGIES.iter().zip(self.0).filter(|(_, of)| *of == wanted).map(|(name, _)| *name);
            names.collect::<Vec<_>>().join(", ")
        };
        let of = |names: String, words: &str| if names.is_empty() { None } else { Some(format!("{names} {words}")) };
        [
            of(list(1.0), "without the constant ½ ∫ ε_Tᵀ D ε_T dV"),
            of(list(2.0), "with the constant ½ ∫ ε_Tᵀ D ε_T dV subtracted"),
        ]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join("; ")
    }
}
