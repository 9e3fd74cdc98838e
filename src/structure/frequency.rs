//! How fast a structure can vibrate: bounds for time steps.

use nalgebra::Vector2;

use super::Structure;
use super::rod::Rod;
use crate::equations::material;
use crate::kernel::ThermalStrain;
use crate::scene::{self, Element, Material, Scene};

impl Structure {
    /// The largest angular frequency, rad/s, to be expected: an upper bound of it for a straight structure at the start, and
    /// at every corner of the heat's history at the stress-free strain ε_T and at 2ε_T, to which sudden heat overshoots.
    ///
    /// A structure's largest frequency is not above the largest of its elements taken free (Irons and Treharne 1971):
    /// Rayleigh's quotient of the whole is a weighted mean of its elements'. Stretched rods are stiffer against the mass of
    /// their initial length, which is why heat counts. Motions that strain a rod by tens of percent beyond that can be faster
    /// still; an explicit run then ends in [`Error::NotFinite`](crate::error::Error::NotFinite).
    pub fn largest_frequency(&self) -> f64 {
        let mut largest: f64 = 0.0;
        for rod in &*self.rods {
            let mut look_at = |stretch: [f64; 2], thermal: ThermalStrain| {
                // Where nothing is left of the rod there is no such state.
                if stretch.iter().all(|less_one| 1.0 + less_one > 0.0) {
                    largest = largest.max(rod.mesh.largest_square_frequency(stretch, thermal));
                }
            };
            for thermal in rod.thermal_corners() {
                look_at([0.0; 2], thermal);
                look_at(rod.mesh.stress_free(thermal), thermal);
                look_at(rod.mesh.stress_free(thermal.map(|strain| 2.0 * strain)), thermal);
            }
        }
        largest.sqrt()
    }

    /// The shortest time in which an axial wave crosses an element, s.
    pub fn wave_crossing_time(scene: &Scene) -> f64 {
        let crossing = |rod: &scene::Rod| Structure::wave_time(scene, rod) / rod.elements as f64;
        scene.rods.iter().map(crossing).fold(f64::INFINITY, f64::min)
    }

    /// The time in which an axial wave, √((λ + 2μ)/ρ) fast or √(E/ρ), runs along a rod, s.
    pub fn wave_time(scene: &Scene, rod: &scene::Rod) -> f64 {
        let Material { youngs_modulus, nu, rho, .. } = *scene.material(rod);
        let stiff = match rod.element {
            Element::Ancf => material::lambda(youngs_modulus, nu) + 2.0 * material::mu(youngs_modulus, nu),
            Element::EulerBernoulli => youngs_modulus,
        };
        let ends = Vector2::from(scene.points[&rod.to]) - Vector2::from(scene.points[&rod.from]);
        ends.norm() / (stiff / rho).sqrt()
    }
}

impl Rod {
    /// Thermal strains at the start and at the corners of the temperature's history, between which they are linear.
    fn thermal_corners(&self) -> Vec<ThermalStrain> {
        let times = self.heat.iter().flat_map(|heat| heat.temperature.history.iter().map(|&[t, _]| t));
        std::iter::once(0.0).chain(times).map(|t| self.thermal_strain(t)).collect()
    }
}
