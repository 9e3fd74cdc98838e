//! Four elements side by side, on each path of the processor's instructions, held to the elements one by one.

use ancf::internals::elements::{Beam, Ends, FourEnds, ThermalStrain};
use ancf::internals::lanes::{LANES, Lanes, Path, Task};
use nalgebra::{SMatrix, SVector};

/// Largest difference from the element by itself, of the size of the terms.
const TOLERANCE: f64 = 1e-12;

/// Displacements of four elements at both ends of a step, and their thermal strains there.
pub struct Four<'a, B, const N: usize> {
    pub beam: &'a B,
    pub mass: &'a SMatrix<f64, N, N>,
    pub u: [[SVector<f64, N>; LANES]; 2],
    pub eps_T: [[ThermalStrain; LANES]; 2],
}

/// Sizes of the terms: forces, energies, det J.
pub struct TermSizes<'a> {
    pub force: &'a [f64],
    pub energy: f64,
    pub det_j: f64,
}

/// What is computed for four elements; forces and energies at the start of the step.
pub struct Answers<const N: usize> {
    forces: [SVector<f64, N>; LANES],
    mean_forces: [SVector<f64, N>; LANES],
    momenta: [SVector<f64, N>; LANES],
    energies: [f64; LANES],
    heating_works: [f64; LANES],
    min_det_js: [f64; LANES],
}

/// The portable path, and the fastest of this machine.
pub fn paths() -> [Path; 2] {
    [Path::PORTABLE, Path::fastest()]
}

fn columns<L: Lanes, const N: usize>(token: L::Token, each: &[SVector<f64, N>; LANES]) -> [L; N] {
    std::array::from_fn(|i| L::load(token, &std::array::from_fn(|lane| each[lane][i])))
}

fn each<L: Lanes, const N: usize>(columns: &[L; N]) -> [SVector<f64, N>; LANES] {
    std::array::from_fn(|lane| SVector::from_fn(|i, _| columns[i].to_array()[lane]))
}

impl<B: Beam<N>, const N: usize> Task for &Four<'_, B, N> {
    type Output = Answers<N>;

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) -> Answers<N> {
        let ends = FourEnds {
            u: [columns::<L, N>(token, &self.u[0]), columns(token, &self.u[1])],
            eps_T: [0, 1].map(|end: usize| columns(token, &self.eps_T[end].map(SVector::from))),
        };
        let ([u_0, u_1], eps_T) = (&ends.u, ends.eps_T[0]);
        Answers {
            forces: each(&self.beam.forces(token, u_0, eps_T)),
            mean_forces: each(&self.beam.mean_forces(token, &ends)),
            momenta: each(&B::momenta(token, self.mass, u_0)),
            energies: self.beam.energies(token, u_0, eps_T).to_array(),
            heating_works: self.beam.heating_works(token, &ends).to_array(),
            min_det_js: self.beam.min_det_js(token, u_0, u_1).to_array(),
        }
    }
}

impl<B: Beam<N>, const N: usize> Four<'_, B, N> {
    /// Each lane is the element in it, on every path.
    #[track_caller]
    pub fn assert_each_is_itself(&self, sizes: &TermSizes) {
        for path in paths() {
            let answers = path.run(self);
            for n in 0..LANES {
                let ends = Ends {
                    u_0: &self.u[0][n],
                    u_1: &self.u[1][n],
                    thermal_0: self.eps_T[0][n],
                    thermal_1: self.eps_T[1][n],
                };
                let same = |what: &str, own: &[f64], lane: &[f64], size: &[f64]| {
                    for (i, ((own, lane), size)) in own.iter().zip(lane).zip(size).enumerate() {
                        let off = (own - lane).abs() / size;
                        assert!(
                            off <= TOLERANCE,
                            "{path:?}, lane {n}, {what} {i}: {lane:e}, by itself {own:e}: {off:e}"
                        );
                    }
                };
                let force = self.beam.force(ends.u_0, ends.thermal_0);
                same("force", force.as_slice(), answers.forces[n].as_slice(), sizes.force);
                let mean = self.beam.mean_force(&ends);
                same("mean force", mean.as_slice(), answers.mean_forces[n].as_slice(), sizes.force);
                let terms = self.mass.abs() * ends.u_0.abs() + SVector::repeat(f64::MIN_POSITIVE);
                let momentum = self.mass * ends.u_0;
                same("momentum", momentum.as_slice(), answers.momenta[n].as_slice(), terms.as_slice());
                let energy = [self.beam.energy(ends.u_0, ends.thermal_0), self.beam.heating_work(&ends)];
                let both = [answers.energies[n], answers.heating_works[n]];
                same("energy", &energy, &both, &[sizes.energy; 2]);
                same("det J", &[self.beam.min_det_j(ends.u_0, ends.u_1)], &[answers.min_det_js[n]], &[sizes.det_j]);
            }
        }
    }
}
