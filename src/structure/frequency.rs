//! How fast a structure can vibrate: bounds for time steps.

use nalgebra::DVector;

use super::rod::Rod;
use super::{MassFactors, Structure};
use crate::equations::material;
use crate::kernel::{Meaning, ThermalStrain};
use crate::linear::{Pencil, SingularAt, largest_eigenvalue};
use crate::scene::{self, Element, Material, Scene};

/// What a rod is like while it vibrates: its stretches less 1 (along, across) and its thermal strain.
type RodState = ([f64; 2], ThermalStrain);

impl Structure {
    /// The largest angular frequency, rad/s, to be expected: that of a straight structure at the start, and at every corner of the
    /// heat's history at the stress-free strain ε_T and at 2ε_T, to which sudden heat overshoots.
    ///
    /// A structure's largest frequency is not above the largest of its elements taken free (Irons and Treharne 1971):
    /// Rayleigh's quotient of the whole is a weighted mean of its elements'. With the paper's element, whose fastest vibration is
    /// that of a section, this bound is as good as reached, and stands. An Euler–Bernoulli element taken free is 1.3 to 1.5 times as
    /// fast as a rod of them: where all rods are of these, Lanczos' method is asked for that of the whole, an estimate to 10⁻⁶; where it does not settle the bound stands. Stretched rods are stiffer
    /// against the mass of their initial length, which is why heat counts. Motions that strain a rod by tens of percent beyond
    /// that can be faster still; an explicit run then ends in [`Error::NotFinite`](crate::error::Error::NotFinite).
    ///
    /// # Errors
    /// The unknown with a vanishing pivot of the mass matrix.
    pub fn largest_frequency(&self) -> Result<f64, SingularAt> {
        let mut mass = self.factorize_mass()?;
        let mut largest: f64 = 0.0;
        let has_sections =
            self.rods.iter().any(|rod| rod.mesh.vectors().iter().any(|(what, _)| *what == Meaning::SlopeY));
        for states in self.states_of_heat() {
            let of_elements = self.rods.iter().zip(&states);
            let of_elements =
                of_elements.map(|(rod, (stretch, thermal))| rod.mesh.largest_square_frequency(*stretch, *thermal));
            // In the total order NaN is the largest, and is not lost.
            let bound = of_elements.max_by(f64::total_cmp).unwrap_or(0.0);
            // Without multipliers, whose matrix is not definite.
            let whole = (self.rows.is_empty() && !has_sections).then(|| {
                let mut vibration = Vibration { structure: self, mass: &mut mass, states: &states };
                largest_eigenvalue(&mut vibration)
            });
            let whole = whole.flatten().map_or(f64::INFINITY, |(eigenvalue, missed)| eigenvalue + missed);
            let square = if bound.is_nan() { bound } else { bound.min(whole) };
            largest = if square <= largest { largest } else { square };
        }
        Ok(largest.sqrt())
    }

    /// States of the rods to look at: cold and hot, at rest, stress-free, and stretched twice as far. Where nothing would be left
    /// of a rod it stays at rest.
    fn states_of_heat(&self) -> Vec<Vec<RodState>> {
        let corners: Vec<Vec<ThermalStrain>> = self.rods.iter().map(Rod::thermal_corners).collect();
        let most = corners.iter().map(Vec::len).max().unwrap_or(0);
        let states = (0..most).flat_map(|corner| [0.0, 1.0, 2.0].map(|share| (corner, share)));
        let mut states: Vec<Vec<RodState>> = states
            .map(|(corner, share)| {
                let of_rod = |(rod, corners): (&Rod, &Vec<ThermalStrain>)| {
                    let thermal = corners[corner.min(corners.len() - 1)];
                    let stretch = rod.mesh.stress_free(thermal.map(|strain| share * strain));
                    let is_there = stretch.iter().all(|less_one| 1.0 + less_one > 0.0);
                    (if is_there { stretch } else { [0.0; 2] }, thermal)
                };
                self.rods.iter().zip(&corners).map(of_rod).collect()
            })
            .collect();
        states.dedup();
        states
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
        scene.length(rod) / (stiff / rho).sqrt()
    }
}

impl Rod {
    /// Thermal strains at the start and at the corners of the temperature's history, between which they are linear.
    fn thermal_corners(&self) -> Vec<ThermalStrain> {
        let times = self.heat.iter().flat_map(|heat| heat.temperature.history.iter().map(|&[t, _]| t));
        std::iter::once(0.0).chain(times).map(|t| self.thermal_strain(t)).collect()
    }
}

/// Small vibrations of a structure of straight rods.
struct Vibration<'a> {
    structure: &'a Structure,
    mass: &'a mut MassFactors,
    states: &'a [RodState],
}

impl Pencil for Vibration<'_> {
    fn size(&self) -> usize {
        self.structure.size()
    }

    fn stiffness(&mut self, x: &DVector<f64>, product: &mut DVector<f64>) {
        product.fill(0.0);
        for (rod, (stretch, thermal)) in self.structure.rods.iter().zip(self.states) {
            rod.mesh.add_stretched_stiffness(*stretch, *thermal, x, product);
        }
    }

    fn mass(&mut self, x: &DVector<f64>, product: &mut DVector<f64>) {
        self.structure.inertia_into(x, product);
    }

    fn solve_mass(&mut self, x: &mut DVector<f64>) {
        self.mass.solve(x);
    }
}
