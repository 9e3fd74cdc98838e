//! Effect of rounding errors of the elastic forces.
//!
//! A strain is made of differences of u over the element length l, of slopes, and of the thermal strain. It carries an
//! error of ε_mach times the largest of |u|/l, |slope| and |ε_T| (at least
//! [`Beam::ROUNDING_SCALE`](crate::elements::Beam::ROUNDING_SCALE)), which a stiff rod turns into a force. Where that force is no
//! longer small compared with the loads, a motion follows the rounding; in statics a slender rod turns it into a
//! displacement.

use nalgebra::DVector;

use super::unknown_kind::UnknownKind;
use super::{Matrix, Structure};
use crate::elements::ThermalStrain;

impl Structure {
    /// Whether every entry of a residual, at `u` and the rods' thermal strains, is within `times` the rounding error of
    /// the elastic forces: the rounding error of a strain times the force of a unit strain.
    pub fn within_rounding(
        &self,
        residual: &DVector<f64>,
        u: &DVector<f64>,
        thermal: &[ThermalStrain],
        times: f64,
    ) -> bool {
        let heat = thermal.iter().flatten().map(|strain| strain.abs()).fold(0.0, f64::max);
        let floor = times * self.rounding_strain(u, heat);
        let mut entries = residual.iter().zip(&self.unit_forces).zip(&self.kinds);
        entries.all(|((value, unit), kind)| *kind == UnknownKind::Multiplier || value.abs() <= floor * unit)
    }

    /// Rounding error of an energy, J: ε_mach times the strain energy of a unit strain.
    pub fn energy_rounding(&self) -> f64 {
        let length: f64 = self.rods.iter().map(|rod| rod.elements as f64 * rod.along.norm()).sum();
        f64::EPSILON * length * self.largest_unit_force()
    }

    /// Largest force that rounding of the strains at `u` may cause, N.
    pub fn rounding_force(&self, u: &DVector<f64>) -> f64 {
        self.largest_unit_force() * self.rounding_strain(u, 0.0)
    }

    /// Displacement of an equilibrium by rounding of the strains, relative to its displacement from the start or to an
    /// element's thermal stretch. The larger one of two patterns of errors: of one sign, and of signs that hardly
    /// repeat. `None` where nothing moves, or the tangent is singular.
    pub fn rounding_of_equilibrium(&self, u: &DVector<f64>, t: f64) -> Option<f64> {
        let (thermal, mut factors) = (self.thermal_strains(t), self.factors());
        let tangent = Matrix::Tangent { u, thermal: &thermal, stiffness: 1.0, mass: 0.0 };
        self.factorize(tangent, &mut factors).ok()?;
        let hottest = thermal.iter().flatten().map(|strain| strain.abs()).fold(0.0, f64::max);
        let errors = &self.unit_forces * self.rounding_strain(u, hottest);
        let moved = |sign: &dyn Fn(usize) -> f64| {
            let mut moved = errors.map_with_location(|row, _, error| sign(row) * error);
            factors.solve(&mut moved);
            self.largest_displacement(&moved)
        };
        // Elimination along a rod sums errors of one sign; errors of changing sign act on short elements.
        let farthest = moved(&|_| 1.0).max(moved(&|n| (1.7 * n as f64 * n as f64).sin().signum()));
        let far = self.largest_displacement(u).max(hottest * self.shortest_element);
        (far > 0.0).then(|| farthest / far)
    }

    fn largest_unit_force(&self) -> f64 {
        let positions = self.unit_forces.iter().zip(&self.kinds).filter(|(_, kind)| **kind == UnknownKind::Position);
        positions.map(|(force, _)| *force).fold(0.0, f64::max)
    }

    /// Rounding error of a strain: ε_mach times the largest of |u|/l, the slopes' changes and the thermal strain
    /// `hottest`.
    fn rounding_strain(&self, u: &DVector<f64>, hottest: f64) -> f64 {
        let size = |(u, kind): (&f64, &UnknownKind)| match kind {
            UnknownKind::Position => u.abs() / self.shortest_element,
            UnknownKind::Slope(_) => u.abs(),
            // During an iteration this entry is λ: a force, not a strain.
            UnknownKind::Multiplier => 0.0,
        };
        f64::EPSILON * u.iter().zip(&self.kinds).map(size).fold(hottest.max(self.rounding_scale), f64::max)
    }
}
