//! Collapsed elements: compressed to nothing, or turned inside out.

use nalgebra::DVector;

use super::Structure;
use crate::error::{Error, Result};

impl Structure {
    /// Largest change between two displacements: of a position relative to the element length, or of a slope. For r_y
    /// in elements higher than long it is multiplied by h/l.
    ///
    /// If it is δ, no r_x changes by more than 13 δ and no r_y by more than 1.3 δ at any quadrature point. These are
    /// the sums of |∂S/∂x| and |∂S/∂y| over an element's nodal vectors, weighted as above.
    pub fn largest_change(&self, before: &DVector<f64>, u: &DVector<f64>) -> f64 {
        // Four independent maxima at a time: a single one would make every comparison wait for the one before.
        let (mut largest, mut sum) = ([0.0_f64; 4], [0.0_f64; 4]);
        let mut accumulate = |before: &[f64], u: &[f64], factors: &[f64]| {
            for (n, ((before, u), factor)) in before.iter().zip(u).zip(factors).enumerate() {
                let moved = ((u - before) * factor).abs();
                largest[n] = if moved > largest[n] { moved } else { largest[n] };
                sum[n] += moved;
            }
        };
        let (before, last_before) = before.as_slice().as_chunks::<4>();
        let (u, last) = u.as_slice().as_chunks::<4>();
        let (factors, last_shares) = self.motion_factors.as_slice().as_chunks::<4>();
        before.iter().zip(u).zip(factors).for_each(|((before, u), factors)| accumulate(before, u, factors));
        accumulate(last_before, last, last_shares);
        // A comparison drops a NaN; a sum does not.
        let sum: f64 = sum.iter().sum();
        if sum.is_nan() { sum } else { largest.into_iter().fold(0.0, f64::max) }
    }

    /// Refuses a state `u` in which an element has collapsed ([`Beam::min_det_j`](crate::elements::Beam::min_det_j)); `before` is the state that
    /// was checked last. The equations still have solutions there, of an element that is its own mirror image.
    ///
    /// # Errors
    /// [`Error::Collapsed`].
    pub fn check_collapse(&self, before: &DVector<f64>, u: &DVector<f64>, time: f64) -> Result<()> {
        for rod in &*self.rods {
            if let Some(element) = rod.mesh.collapsed(before, u) {
                let (element, elements) = (element + 1, rod.elements);
                return Err(Error::Collapsed {
                    rod: rod.name.clone(),
                    element,
                    elements,
                    time,
                    statics: self.is_static,
                });
            }
        }
        Ok(())
    }
}
