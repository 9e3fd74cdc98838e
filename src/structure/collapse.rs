//! Elements of which nothing is left: pressed to nothing, or turned inside out.

use nalgebra::DVector;

use super::Structure;
use crate::error::{Error, Result};

impl Structure {
    /// Refuses a state `u` in which an element has collapsed ([`Beam::left`](crate::kernel::Beam::left)); `before` is the state that
    /// was looked at last. The equations still have solutions there, of an element that is its own mirror image.
    ///
    /// # Errors
    /// [`Error::Collapsed`].
    pub fn check_collapse(&self, before: &DVector<f64>, u: &DVector<f64>, time: f64) -> Result<()> {
        for rod in &*self.rods {
            if let Some(element) = rod.mesh.collapsed(before, u) {
                let (element, elements) = (element + 1, rod.elements);
                return Err(Error::Collapsed { rod: rod.name.clone(), element, elements, time, statics: self.grows });
            }
        }
        Ok(())
    }
}
