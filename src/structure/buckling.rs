//! Linearised buckling: the factor λ of all loads and heat at which K(0) + λ K'(0) is singular.
//!
//! K(s) is the tangent along the path of equilibria u(s) under the part s of the load. Its rate at no load, K'(0), holds the
//! stresses and the change of shape of first order. (K(0) + λ K'(0)) x = 0 has x with 1/λ as an eigenvalue of −K(0)⁻¹ K'(0),
//! which is self-adjoint in the inner product of K(0).
//!
//! A load that bends couples bending and stretching in K'(0), and K(0) + λ K'(0) is singular where a deflection is of the order of the
//! height: terms of second order, which are left out, keep K positive there. So a factor counts only if the tangent itself has a
//! negative eigenvalue a little beyond it, at the displacement λ u'.

use nalgebra::DVector;

use super::{Matrix, Structure};
use crate::elements::ThermalStrain;
use crate::linear::{Bordered, SingularAt, largest_eigenvalues};

/// Largest strain at which K'(0) is taken as a difference: the paper's element has none of its error, the cable its square.
const STRAIN: f64 = 1e-4;

/// Start vectors, more than there are of one buckling load as a rule.
const BLOCK: usize = 4;

/// Eigenvalues among which the first one that the tangent confirms is looked for.
const CANDIDATES: usize = 12;

/// Part of a factor beyond which the tangent must have a negative eigenvalue.
const BEYOND: f64 = 1.05;

/// Least 1/λ: heat and loads do not take a structure's stiffness at a millionth of what would buckle it.
const LEAST: f64 = 1e-9;

impl Structure {
    /// Lowest positive factor of the loads and heat of statics at which the linearised stiffness is singular, with the
    /// displacement in which it is; `None` where no positive factor is. For statics in the condensed form, without histories.
    ///
    /// # Errors
    /// Unknown of a vanishing pivot.
    pub fn linearised_buckling(&self) -> Result<Option<(f64, DVector<f64>)>, SingularAt> {
        let rest = DVector::zeros(self.size());
        let cold = self.thermal_strains(0.0);
        let heat = self.thermal_strains(1.0);
        let mut factors = self.factors();
        self.factorize(Matrix::Tangent { u: &rest, thermal: &cold, stiffness: 1.0, mass: 0.0 }, &mut factors)?;
        // K(0) u' = f' − ∂Q/∂θ θ'; Q is linear in θ.
        let mut rate = self.load(1.0);
        let [mut heated, mut relaxed] = [DVector::zeros(self.size()), DVector::zeros(self.size())];
        self.force(&rest, &heat, &mut heated);
        self.force(&rest, &cold, &mut relaxed);
        rate += relaxed - heated;
        factors.solve(&mut rate);

        let hottest = heat.iter().flatten().map(|strain| strain.abs()).fold(0.0, f64::max);
        let largest = self.largest_displacement(&rate) / self.shortest_element;
        let part = STRAIN / f64::max(hottest, largest);
        if !part.is_finite() {
            return Ok(None);
        }
        let start = self.tangent(&rest, &cold);
        let stress = self.tangent_rate(&rate, &heat, part);
        let softened = |x: &DVector<f64>| {
            let mut moved = stress.product(&-x);
            factors.solve(&mut moved);
            moved
        };
        let found = largest_eigenvalues(self.size(), CANDIDATES, BLOCK, softened, |x| start.product(x));
        let found = found.unwrap_or_default();
        let factors = &mut self.factors();
        let mut is_confirmed = |factor: f64| {
            let far = BEYOND * factor;
            let thermal: Vec<ThermalStrain> = heat.iter().map(|strains| strains.map(|strain| far * strain)).collect();
            self.eigenvalues_below(0.0, &(far * &rate), &thermal, factors).is_none_or(|negative| negative > 0)
        };
        let positive = found.values.into_iter().zip(found.vectors).filter(|(value, _)| value * part > LEAST * STRAIN);
        Ok(positive.map(|(value, shape)| (1.0 / value, shape)).find(|(factor, _)| is_confirmed(*factor)))
    }

    /// K'(0), as the difference of the tangents at ±`part` of the load.
    fn tangent_rate(&self, rate: &DVector<f64>, heat: &[ThermalStrain], part: f64) -> Bordered {
        let at = |part: f64| {
            let thermal: Vec<ThermalStrain> = heat.iter().map(|strains| strains.map(|strain| part * strain)).collect();
            self.tangent(&(part * rate), &thermal)
        };
        let mut sum = Bordered::zeros(&self.layout);
        sum.add_scaled(0.5 / part, &at(part));
        sum.add_scaled(-0.5 / part, &at(-part));
        sum
    }
}
