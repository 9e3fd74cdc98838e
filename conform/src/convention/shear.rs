//! Measure of the shear strain.

/// Measure of the shear strain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Shear {
    /// The tensor's component ε₁₂.
    #[default]
    Tensor,
    /// The engineering shear 2ε₁₂; D has μ in place of 2μ, and stresses are the same.
    Engineering {
        /// Factor of S_c and S_c1: 2 where 2ε₁₂ = ½ eᵀS_c e.
        S_c: f64,
        /// Factor of K₃: 4 if it has both of them, 2 if one.
        K_3: f64,
    },
}

impl Shear {
    /// Choices, usual ones first.
    pub(super) fn all() -> Vec<Shear> {
        let mut all = vec![Shear::Tensor];
        for S_c in [1.0, 2.0] {
            all.extend([1.0, 2.0, 4.0].map(|K_3| Shear::Engineering { S_c, K_3 }));
        }
        all
    }

    /// Factor of the strain's component 12.
    pub(super) fn of_strain(self) -> f64 {
        if self == Shear::Tensor { 1.0 } else { 2.0 }
    }

    /// Factor of all entries of a quantity that belongs to the shear alone.
    pub(super) fn of(self, quantity: &str) -> f64 {
        match (self, quantity) {
            (Shear::Engineering { .. }, "13.epsilon_3") => 2.0,
            (Shear::Engineering { S_c, .. }, "11.S_c" | "21.S_c1") => S_c,
            (Shear::Engineering { K_3, .. }, "21.K_3") => K_3,
            _ => 1.0,
        }
    }

    /// The measure in words.
    pub(super) fn words(self) -> String {
        let Shear::Engineering { S_c, K_3 } = self else { return "tensor shear ε₁₂".into() };
        let mut words = "engineering shear 2ε₁₂, with μ for 2μ in D".to_string();
        if S_c != 1.0 {
            words += &format!(", {S_c} S_c");
        }
        if K_3 != 1.0 {
            words += &format!(", {K_3} K_3");
        }
        words
    }
}
