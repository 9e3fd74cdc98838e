//! Axes of rods, for pictures.

use super::simulation::{Simulation, checked_fraction};
use crate::error::{Error, Result};

/// Point of a rod's axis at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AxisPoint {
    /// Position r(x, 0) of (1), m.
    pub position: [f64; 2],
    /// Slope ∂r/∂y across the section: the material point at y lies at `position` + y · `director`, (A.1). For
    /// Euler–Bernoulli elements, whose section keeps its size, the unit normal of the axis.
    pub director: [f64; 2],
    /// Axial strain of the straight rod, heat included: Green–Lagrange, (13) along the rod; |r_x| − 1 for Euler–Bernoulli
    /// elements.
    pub strain: f64,
    /// Part of the strain that heat causes freely, αΔT of (8), zero where heat strains the rod across only: `strain` less it is
    /// the elastic strain (14).
    pub thermal_strain: f64,
    /// Curvature, 1/m: rotation of the section per initial length, positive counterclockwise.
    pub curvature: f64,
    /// Temperature change ΔT, K; zero for a rod that no heat strains.
    pub temperature: f64,
}

impl Simulation {
    /// Present axis of a rod at fractions `at` of its length. Strain and curvature jump from element to element; between
    /// two of them they are the mean of both.
    ///
    /// ```
    /// use ancf::{model::Scene, run::Simulation};
    ///
    /// let mut pendulum = Simulation::new(Scene::builtin("pendulum-flexible").unwrap())?;
    /// pendulum.run_until(0.5)?;
    /// let axis = pendulum.axis("rod", &[0.0, 0.5, 1.0])?;
    /// assert_eq!(axis[2].position, pendulum.position("a")?);
    /// assert!(axis[1].strain.abs() < 1e-2 && axis[1].curvature != 0.0 && axis[1].temperature == 0.0);
    /// # Ok::<(), ancf::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no rod of this name; [`Error::Scene`] for a fraction outside 0 … 1;
    /// [`Error::NotFinite`] for a state that cannot be trusted.
    pub fn axis(&self, rod: &str, at: &[f64]) -> Result<Vec<AxisPoint>> {
        let (structure, state) = (self.structure(), self.state());
        let rod = structure.rod(rod)?;
        let [temperature, thermal_strain] = structure.heat(rod, state.load);
        let point = |&at: &f64| {
            let (position, section) = structure.axis(rod, checked_fraction("axis", at)?, &state.u);
            let director = section.director.into();
            let (strain, curvature) = (section.strain, section.curvature);
            let numbers = [position.x, position.y, section.director.x, section.director.y, strain, curvature];
            if !numbers.iter().all(|number| number.is_finite()) {
                return Err(Error::NotFinite { quantity: "the axis", time: state.t, step: state.step });
            }
            Ok(AxisPoint { position: position.into(), director, strain, thermal_strain, curvature, temperature })
        };
        at.iter().map(point).collect()
    }
}
