//! How fast a structure can vibrate: bounds for time steps.

use nalgebra::Vector2;

use super::Structure;
use crate::equations::force::Matrix14;
use crate::equations::material;
use crate::kernel::ThermalStrain;
use crate::scene::{Rod, Scene};

impl Structure {
    /// An upper bound of the largest angular frequency, rad/s, at the start and every corner of the heat's history.
    ///
    /// A structure's largest frequency is not above the largest of its elements taken free (Irons and Treharne 1971):
    /// Rayleigh's quotient of the whole is a weighted mean of its elements'.
    pub fn largest_frequency(&self) -> f64 {
        let mut largest: f64 = 0.0;
        let mut first = 0;
        while let Some(place) = self.places.get(first) {
            let rod = &self.rods[place.rod];
            for thermal in self.thermal_extremes() {
                // All elements of a rod start alike but for a translation, which does not matter.
                let stiffness = rod.kernel.tangent(&place.gather(&self.start), thermal);
                largest = largest.max(largest_eigenvalue(&stiffness, &rod.mass));
            }
            first += self.places[first..].iter().take_while(|other| other.rod == place.rod).count();
        }
        largest.max(0.0).sqrt()
    }

    /// The shortest time in which an axial wave, √((λ + 2μ)/ρ) fast, crosses an element, s.
    pub fn wave_crossing_time(scene: &Scene) -> f64 {
        let (youngs_modulus, nu) = (scene.material.youngs_modulus, scene.material.nu);
        let stiff = material::lambda(youngs_modulus, nu) + 2.0 * material::mu(youngs_modulus, nu);
        let speed = (stiff / scene.material.rho).sqrt();
        let length = |rod: &Rod| {
            let ends = Vector2::from(scene.points[&rod.to]) - Vector2::from(scene.points[&rod.from]);
            ends.norm() / rod.elements as f64
        };
        scene.rods.iter().map(length).fold(f64::INFINITY, f64::min) / speed
    }

    /// Thermal strains at the start and at the corners of the temperature's history, between which they are linear.
    fn thermal_extremes(&self) -> Vec<ThermalStrain> {
        let times = self.heat.iter().flat_map(|heat| heat.temperature.history.iter().map(|&[t, _]| t));
        std::iter::once(0.0).chain(times).map(|t| self.thermal_strain(t)).collect()
    }
}

/// The largest ω² of K φ = ω² M φ: with M = L Lᵀ the largest eigenvalue of L⁻¹ K L⁻ᵀ. NaN where M is not positive definite.
fn largest_eigenvalue(stiffness: &Matrix14, mass: &Matrix14) -> f64 {
    let reduced = mass.cholesky().and_then(|cholesky| {
        let lower = cholesky.l();
        let half = lower.solve_lower_triangular(stiffness)?;
        lower.solve_lower_triangular(&half.transpose())
    });
    reduced.map_or(f64::NAN, |matrix| matrix.symmetric_eigenvalues().max())
}
