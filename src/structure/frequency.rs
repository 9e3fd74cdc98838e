//! Largest frequency and wave speed of a structure: bounds for time steps.

use nalgebra::DVector;

use super::rod::{Rod, law};
use super::rod_elements::ElementMatrix;
use super::{MassFactors, Structure};
use crate::elements::{Meaning, ThermalStrain};
use crate::linear::{InertiaMemory, Pencil, SingularAt, largest_eigenvalue};
use crate::model::{self, Element, Scene};

/// State of a vibrating rod: its stretches minus 1 (along, across) and its thermal strain.
type RodState = ([f64; 2], ThermalStrain);

/// Multiples of the stress-free strain at which a heated rod is examined: at rest, stress-free, and twice that, to
/// which sudden heat overshoots.
const STRAIN_FACTORS: [f64; 3] = [0.0, 1.0, 2.0];

/// Margin for bent rods, which vibrate a little faster than straight ones: an exact limit has no margin of its own.
/// Without it, scissors of two elements per rod diverged at the limit itself, although they bend by no more than κl =
/// 0.04.
const BENDING_MARGIN: f64 = 1.01;

/// Most different heats of a structure that are examined one by one.
const MOST_HEATS: usize = 32;

/// Relative increases of an eigenvalue tried until it is certainly an upper bound.
const MARGINS: [f64; 6] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];

impl Structure {
    /// Largest angular frequency to be expected, rad/s. It is that of a straight structure at the start, at the end and
    /// at every corner of the heat histories in between, at the stress-free strain ε_T and at 2ε_T, to which sudden
    /// heat overshoots.
    ///
    /// The largest frequency of a structure is at most that of its free elements (Irons and Treharne 1971): Rayleigh's
    /// quotient of the whole is a weighted mean of its elements'. For the paper's element, whose fastest vibration is
    /// that of a section, this bound is nearly reached and is used as it is.
    ///
    /// A free Euler–Bernoulli element is 1.3 to 1.5 times as fast as a rod of them. If all rods are of this type,
    /// Lanczos' method finds the largest frequency of the whole. Its result may be too low, so it is raised until σM −
    /// K has no negative eigenvalue, which proves that nothing lies above σ; if that fails the bound of the elements
    /// stands. A hundredth is added for rods that bend.
    ///
    /// Stretched rods are stiffer, with the mass of their initial length, which is why heat counts. Motions that strain
    /// a rod by further tens of percent can be faster still; an explicit run then ends in
    /// [`Error::NotFinite`](crate::error::Error::NotFinite).
    ///
    /// # Errors
    /// Unknown of a vanishing pivot of the mass matrix.
    pub fn largest_frequency(&self) -> Result<f64, SingularAt> {
        let mut mass = self.factorize_mass()?;
        let heats = self.heats();
        let of_elements = self.rods.iter().enumerate().flat_map(|(n, rod)| {
            // Smallest and largest thermal strain of this rod, along or across, which share the sign of αΔT: no strain
            // between makes an element faster than both.
            let of_rod = || heats.iter().map(move |heat| heat[n]);
            let by_size = |a: &ThermalStrain, b: &ThermalStrain| (a[0] + a[1]).total_cmp(&(b[0] + b[1]));
            let extremes = [of_rod().min_by(by_size), of_rod().max_by(by_size)].into_iter().flatten();
            extremes
                .flat_map(move |thermal| STRAIN_FACTORS.map(|factor| rod.state(factor, thermal)))
                .map(|(stretch, thermal)| rod.mesh.largest_square_frequency(stretch, thermal))
        });
        // In the total order NaN is the largest, and is not lost.
        let bound = of_elements.max_by(f64::total_cmp).unwrap_or(0.0);
        let has_sections =
            self.rods.iter().any(|rod| rod.mesh.vectors().iter().any(|(what, _)| *what == Meaning::SlopeY));
        // Not with multipliers, whose matrix is not definite.
        if has_sections || !self.rows.is_empty() || bound.is_nan() || heats.len() > MOST_HEATS {
            return Ok(bound.sqrt());
        }
        let states = heats.iter().flat_map(|heat| STRAIN_FACTORS.map(|factor| self.states(factor, heat)));
        let of_whole = states.map(|states| self.largest_eigenvalue(&states, &mut mass).unwrap_or(bound));
        Ok((of_whole.fold(0.0, f64::max) * BENDING_MARGIN * BENDING_MARGIN).min(bound).sqrt())
    }

    /// Thermal strains of all rods at each time, without repetitions.
    fn heats(&self) -> Vec<Vec<ThermalStrain>> {
        let mut heats: Vec<Vec<ThermalStrain>> = Vec::new();
        for t in &self.times {
            let heat = self.thermal_strains(*t);
            if !heats.contains(&heat) {
                heats.push(heat);
            }
        }
        heats
    }

    fn states(&self, factor: f64, heat: &[ThermalStrain]) -> Vec<RodState> {
        self.rods.iter().zip(heat).map(|(rod, thermal)| rod.state(factor, *thermal)).collect()
    }

    /// Upper bound of the eigenvalues of K x = λ M x, and a close one; `None` where none is found.
    fn largest_eigenvalue(&self, states: &[RodState], mass: &mut MassFactors) -> Option<f64> {
        let (found, error_bound) = largest_eigenvalue(&mut Vibration { structure: self, mass, states })?;
        MARGINS
            .map(|margin| (found + error_bound) * (1.0 + margin))
            .into_iter()
            .find(|sigma| self.is_upper_bound(*sigma, states))
    }

    /// Whether K x = λ M x has no eigenvalue above `sigma`: σM − K has no negative one (Sylvester).
    fn is_upper_bound(&self, sigma: f64, states: &[RodState]) -> bool {
        let matrix = self.assemble_matrix(|rod| {
            let (stretch, eps_t) = states[rod];
            ElementMatrix::Stretched { stretch, eps_t, stiffness: -1.0, mass: sigma }
        });
        matrix.negative_eigenvalues(&mut InertiaMemory::default()) == Some(0)
    }

    /// Shortest time in which an axial wave crosses an element, s.
    pub fn wave_crossing_time(scene: &Scene) -> f64 {
        let crossing = |rod: &model::Rod| Structure::wave_time(scene, rod) / rod.elements as f64;
        scene.rods.iter().map(crossing).fold(f64::INFINITY, f64::min)
    }

    /// Time in which an axial wave, of speed √((λ + 2μ)/ρ) or √(E/ρ), runs along a rod, s.
    pub fn wave_time(scene: &Scene, rod: &model::Rod) -> f64 {
        let material = scene.material(rod);
        let stiff = match rod.element {
            Element::Ancf => law(rod, material).stiff(),
            Element::EulerBernoulli => material.youngs_modulus,
        };
        scene.length(rod) / (stiff / material.rho).sqrt()
    }
}

impl Rod {
    /// State of the rod at a multiple of its stress-free strain; at rest if a stretch would not be positive.
    fn state(&self, factor: f64, thermal: ThermalStrain) -> RodState {
        let stretch = self.mesh.stress_free(thermal.map(|strain| factor * strain));
        let is_there = stretch.iter().all(|less_one| 1.0 + less_one > 0.0);
        (if is_there { stretch } else { [0.0; 2] }, thermal)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Method, Start, Temperature, ThermalModel};

    fn heat(history: Vec<[f64; 2]>) -> Option<Temperature> {
        Some(Temperature { model: ThermalModel::TwoD, start: Start::Sudden, history })
    }

    /// Two pinned Euler–Bernoulli rods, one hinged, for 0.2 s.
    fn pair() -> Scene {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        scene.points.insert("b".into(), [1.5, 0.4]);
        let mut second = scene.rods[0].clone();
        (second.name, second.from, second.to, second.elements) = ("second".into(), "a".into(), "b".into(), 3);
        scene.rods.push(second);
        scene.rods.iter_mut().for_each(|rod| rod.element = Element::EulerBernoulli);
        (scene.time.method, scene.time.step, scene.time.end, scene.output.interval) =
            (Method::Explicit, 1e-4, 0.2, None);
        scene
    }

    /// Largest eigenvalue of the dense pencil.
    fn dense(structure: &Structure, states: &[RodState]) -> f64 {
        let matrix = |stiffness: f64, mass: f64| {
            let of_rod = |rod: usize| {
                let (stretch, eps_t): RodState = states[rod];
                ElementMatrix::Stretched { stretch, eps_t, stiffness, mass }
            };
            structure.assemble_matrix(of_rod).dense()
        };
        let lower = matrix(0.0, 1.0).cholesky().unwrap().l();
        let half = lower.solve_lower_triangular(&matrix(1.0, 0.0)).unwrap();
        lower.solve_lower_triangular(&half.transpose()).unwrap().symmetric_eigenvalues().max()
    }

    /// An estimate that is too low is noticed; the bound is above the exact value by at most 2·10⁻⁶.
    #[test]
    fn nothing_is_above_the_largest_eigenvalue() {
        let structure = Structure::new(pair()).unwrap();
        let mut mass = structure.factorize_mass().unwrap();
        for strain in [-0.1, 0.0, 0.05] {
            let states = structure.states(1.0, &[[strain; 2], [0.5 * strain; 2]]);
            let exact = dense(&structure, &states);
            assert!(
                !structure.is_upper_bound(exact * (1.0 - 1e-9), &states)
                    && structure.is_upper_bound(exact * (1.0 + 1e-9), &states)
            );
            let found = structure.largest_eigenvalue(&states, &mut mass).unwrap();
            assert!(found > exact && found < exact * (1.0 + 3e-6), "{found} {exact}");
        }
    }

    /// Heats combine the histories of all rods at one time, wherever it is in their lists; what comes after the end
    /// does not count.
    #[test]
    fn heats_are_those_of_one_time_within_the_run() {
        let mut scene = pair();
        scene.rods[0].temperature = heat(vec![[0.0, 0.0], [0.1, 300.0], [0.4, 0.0]]);
        scene.rods[1].temperature = heat(vec![[0.0, 0.0], [0.05, 0.0], [0.1, 200.0], [0.3, 800.0]]);
        let structure = Structure::new(&scene).unwrap();
        let alpha = scene.material.alpha;
        let changes: Vec<[f64; 2]> =
            structure.heats().iter().map(|heat| [heat[0][0] / alpha, heat[1][0] / alpha]).collect();
        let expected = [[0.0, 0.0], [150.0, 0.0], [300.0, 200.0], [200.0, 500.0]];
        assert_eq!(changes.len(), expected.len(), "{changes:?}");
        for (found, expected) in changes.iter().zip(expected) {
            assert!((found[0] - expected[0]).hypot(found[1] - expected[1]) < 1e-9, "{found:?} {expected:?}");
        }
        // The rods' own greatest heats, and nothing above them.
        let square = structure.largest_frequency().unwrap().powi(2);
        let states =
            structure.heats().into_iter().flat_map(|heat| STRAIN_FACTORS.map(|factor| structure.states(factor, &heat)));
        let exact =
            states.map(|states| dense(&structure, &states)).fold(0.0, f64::max) * BENDING_MARGIN * BENDING_MARGIN;
        assert!(square > exact && square < exact * (1.0 + 3e-6), "{square} {exact}");

        // More corners than are examined one by one: the bound of the elements is used.
        let history = (0..200).map(|n| [0.001 * f64::from(n), 3.0 * f64::from(n)]).collect();
        scene.rods[0].temperature = heat(history);
        let bound = Structure::new(&scene).unwrap().largest_frequency().unwrap();
        assert!(bound > square.sqrt() && bound < 2.0 * square.sqrt(), "{bound}");
    }

    /// Heat across alone, which comes and goes within the run, counts with its largest value: a section that is stretched by c
    /// vibrates c times as fast.
    #[test]
    fn heat_across_counts_where_it_is_largest() {
        let mut scene = Scene::builtin("pendulum-flexible").unwrap();
        let cold = Structure::new(&scene).unwrap().largest_frequency().unwrap();
        let history = vec![[0.0, 0.0], [0.1, 3000.0], [0.2, 0.0]];
        let [along, across] = [ThermalModel::OneD, ThermalModel::Transverse].map(|model| {
            scene.temperature = Some(Temperature::new(model, history.clone()));
            Structure::new(&scene).unwrap().largest_frequency().unwrap() / cold
        });
        // To twice the strain αΔT = 0.0855, to which sudden heat overshoots.
        let stretch = (1.0_f64 + 4.0 * 0.0855).sqrt();
        assert!(across > stretch && along < across, "{along} {across} {stretch}");
    }

    /// At no strain between two others is an element faster than at both, at rest, stress-free and beyond: checking
    /// corners is enough.
    #[test]
    fn elements_are_fastest_at_the_ends_of_a_range_of_strains() {
        for element in [Element::Ancf, Element::EulerBernoulli] {
            let mut scene = pair();
            scene.rods.iter_mut().for_each(|rod| rod.element = element);
            scene.rods[1].elements = 40;
            let structure = Structure::new(&scene).unwrap();
            for (rod, factor) in structure.rods.iter().flat_map(|rod| STRAIN_FACTORS.map(|factor| (rod, factor))) {
                for model in [ThermalModel::TwoD, ThermalModel::OneD, ThermalModel::Transverse] {
                    let square = |strain: f64| {
                        let (stretch, thermal) = rod.state(factor, model.strains(strain));
                        rod.mesh.largest_square_frequency(stretch, thermal)
                    };
                    for (from, to) in [(-0.2, 0.3), (-0.2, 0.0), (0.0, 1.0), (-0.02, 0.01)] {
                        let ends = square(from).max(square(to));
                        for n in 1..20 {
                            let between = square(from + (to - from) * f64::from(n) / 20.0);
                            assert!(
                                between <= ends * (1.0 + 1e-12),
                                "{element} {factor} {from} {to} {n}: {between} {ends}"
                            );
                        }
                    }
                }
            }
        }
    }
}
