//! Angular frequencies of bending, straight and at rest.

use ancf::internals::elements::Meaning;
use ancf::internals::structure::Structure;
use ancf::model::{Direction, Method, Scene, Support};
use nalgebra::DVector;

use crate::common::evidence;
use crate::common::references::{Kind, References, assert_stored, rod, vectors};

/// Unknowns of v and of the sections' turning of a rod along x.
fn bending(scene: &Scene, structure: &Structure) -> Vec<usize> {
    let across = |meaning| if meaning == Meaning::SlopeY { 0 } else { 1 };
    let own = |(vector, (meaning, _))| structure.unknown("rod", vector, across(meaning));
    vectors(scene).into_iter().enumerate().filter_map(own).collect()
}

/// The lowest angular frequencies of bending above `rigid` motions: with M = L Lᵀ, ω² are the eigenvalues of L⁻¹ K
/// L⁻ᵀ.
fn frequencies(scene: &Scene, rigid: usize) -> Vec<f64> {
    let structure = Structure::new(scene).unwrap();
    let rest = DVector::zeros(structure.size());
    let (K, M) = (structure.tangent(&rest, &structure.thermal_strains(0.0)).dense(), structure.mass().dense());
    let own = bending(scene, &structure);
    let other: Vec<usize> = (0..structure.size()).filter(|unknown| !own.contains(unknown)).collect();
    for matrix in [&K, &M] {
        let coupling = matrix.select_rows(&own).select_columns(&other).amax();
        assert!(coupling <= 1e-14 * matrix.amax(), "bending and stretching are coupled by {coupling:.1e}");
    }
    let [K, M] = [K, M].map(|matrix| matrix.select_rows(&own).select_columns(&own));
    let lower = M.cholesky().unwrap().l();
    let half = lower.solve_lower_triangular(&K).unwrap();
    let reduced = lower.solve_lower_triangular(&half.transpose()).unwrap();
    let symmetric = 0.5 * (&reduced + reduced.transpose());
    let mut squares: Vec<f64> = symmetric.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    let largest = squares[squares.len() - 1];
    assert!(squares[..rigid].iter().all(|square| square.abs() <= 1e-13 * largest), "rigid motions: {squares:?}");
    squares[rigid..].iter().map(|square| square.sqrt()).collect()
}

/// Table 1's rod, ν = 0: the linear element is Timoshenko's with k = 1, or Euler and Bernoulli's without rotary
/// inertia; its fields are admissible and its mass is that of its fields, so that every frequency comes from above
/// (Rayleigh). The sections' turning has degree 2, r_xx degree 1: the energy, and ω, are of order 4. Table 1's rod is
/// slender enough for 8 elements to be on the way there.
#[test]
fn frequencies_fall_to_those_of_the_theory_with_order_four() {
    let references = References::load();
    // Relative errors of the first five: with 8 elements, with 16, and the order between them.
    let stored = [
        (
            Kind::Paper,
            "frequency-supported-timoshenko",
            [1.643e-5, 2.590e-4, 1.279e-3, 3.906e-3, 9.121e-3],
            [1.031e-6, 1.640e-5, 8.230e-5, 2.570e-4, 6.178e-4],
        ),
        (
            Kind::Paper,
            "frequency-free-timoshenko",
            [8.039e-5, 5.796e-4, 2.087e-3, 5.248e-3, 1.045e-2],
            [5.221e-6, 3.906e-5, 1.474e-4, 3.939e-4, 8.568e-4],
        ),
        (
            Kind::EulerBernoulli,
            "frequency-supported-euler",
            [1.644e-5, 2.597e-4, 1.287e-3, 3.947e-3, 9.271e-3],
            [1.031e-6, 1.644e-5, 8.279e-5, 2.597e-4, 6.278e-4],
        ),
        (
            Kind::EulerBernoulli,
            "frequency-free-euler",
            [8.065e-5, 5.836e-4, 2.111e-3, 5.335e-3, 1.068e-2],
            [5.238e-6, 3.934e-5, 1.492e-4, 4.011e-4, 8.785e-4],
        ),
    ];
    for (kind, id, eight, sixteen) in stored {
        let reference = references.entry(id);
        let hold = |point: &str, fix| Support { point: point.into(), fix, slide: None, clamp: None };
        let (supports, rigid) = match id {
            "frequency-free-timoshenko" | "frequency-free-euler" => (vec![], 2),
            _ => (vec![hold("o", vec![Direction::X, Direction::Y]), hold("a", vec![Direction::Y])], 0),
        };
        let errors = [8, 16, 32].map(|elements| {
            let mut scene = rod(kind, &reference, elements);
            scene.material.rho = reference.parameter("rho");
            scene = scene.method(Method::EnergyMomentum, 1e-3);
            // The scene's probe of a reaction needs its support.
            (scene.supports, scene.probes) = (supports.clone(), Vec::new());
            let found = frequencies(&scene, rigid);
            let error = |n: usize| found[n] / reference.value(&format!("omega_{}", n + 1)) - 1.0;
            [0, 1, 2, 3, 4].map(error)
        });
        for n in 0..5 {
            let [e_8, e_16, e_32] = errors.map(|errors| errors[n]);
            let order = (e_16 / e_32).log2();
            println!("{kind:?}, {id}, mode {}: {e_8:+.3e}, {e_16:+.3e}, {e_32:+.3e}, order {order:.2}", n + 1);
            evidence::number(&format!("references.vibration-order.{id}-{}", n + 1), order);
            assert!(e_32 > 0.0, "{id}, mode {}: from below", n + 1);
            assert_stored(&format!("{kind:?}, {id}, 8 elements, mode {}", n + 1), e_8, eight[n]);
            assert_stored(&format!("{kind:?}, {id}, 16 elements, mode {}", n + 1), e_16, sixteen[n]);
            assert!((order - 4.0).abs() <= 0.2, "{kind:?}, {id}, mode {}: order {order:.2}", n + 1);
        }
    }
}
