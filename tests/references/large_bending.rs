//! Cantilevers under dead loads that bend them far.

use ancf::model::Scene;
use nalgebra::Vector2;

use crate::common::evidence;
use crate::common::references::{EI, Kind, References, assert_stored, length, off, push, rod, slender, solve};

fn push_in(scene: Scene, F: f64, load_steps: usize) -> Scene {
    let mut scene = push(scene, F);
    scene.time.load_steps = load_steps;
    scene
}

/// Slender rods in large bending, PL²/EI = 10: the exactly integrated cubic resists a curved axis that does not
/// stretch, the more the slenderer it is. Signed errors of the tip's y against the elastica, of L = 1 m, and
/// distances of the tip.
///
/// At h/L = 10⁻² the errors of both elements stay: their limit is not the elastica. Stretch, shear and the
/// Green–Lagrange strain part the paper's element from it by some 10⁻⁴ L, a tenth of (hκ)²; Euler and Bernoulli's rod
/// stretches only, by P/EA = 8·10⁻⁵ where it hangs. The error of y changes its sign between 8 and 16 elements: the
/// small error with 16 is where the two cross, and no accuracy.
#[test]
fn slender_rods_approach_the_elastica_slowly() {
    let references = References::load();
    let elastica = references.entry("elastica-10");
    // From four elements on, or two, doubled.
    type Errors = &'static [(f64, f64)];
    let stored: [(Kind, f64, usize, Errors); 4] = [
        (
            Kind::Paper,
            1e-2,
            4,
            &[(1.0424e-2, 1.2530e-2), (1.4356e-3, 1.7337e-3), (-6.7841e-5, 9.1277e-5), (-1.3507e-4, 1.7490e-4)],
        ),
        (
            Kind::Paper,
            1e-3,
            4,
            &[(3.9686e-2, 6.2338e-2), (3.1669e-3, 3.8740e-3), (5.9178e-4, 6.8814e-4), (6.7866e-5, 8.1569e-5)],
        ),
        (
            Kind::EulerBernoulli,
            1e-2,
            2,
            &[
                (5.3024e-2, 7.4166e-2),
                (9.7306e-3, 1.1638e-2),
                (1.2284e-3, 1.5555e-3),
                (-1.8436e-5, 5.0527e-5),
                (-6.5618e-5, 6.6450e-5),
            ],
        ),
        (
            Kind::EulerBernoulli,
            1e-3,
            2,
            &[
                (1.7501e-1, 2.8786e-1),
                (3.1244e-2, 4.7795e-2),
                (2.8648e-3, 3.4165e-3),
                (5.7092e-4, 6.6692e-4),
                (5.7296e-5, 6.9849e-5),
            ],
        ),
    ];
    for (kind, h, fewest, errors) in stored {
        for (doubled, (stored_y, stored_tip)) in errors.iter().enumerate() {
            let elements = fewest << doubled;
            let scene = slender(kind, h, elements);
            let P = elastica.parameter("PL^2/EI") * EI(&scene);
            let at = Vector2::x() + solve(&push_in(scene, P, 1)).tip();
            let (y, error) = (at.y - elastica.value("tip.y"), off(at, elastica.tip()));
            println!("{kind:?}, h/L = {h:e}, {elements:2} elements: y off by {y:+.4e} L, the tip by {error:.4e} L");
            assert_stored(&format!("{kind:?}, {h:e}, {elements}, y"), y, *stored_y);
            if (kind, h) == (Kind::Paper, 1e-3) {
                evidence::number(&format!("references.elastica.{doubled}"), error);
            }
            assert_stored(&format!("{kind:?}, {h:e}, {elements}"), error, *stored_tip);
        }
    }
}

/// The same rod, h/L = 10⁻³, under smaller loads, 16 elements: distance of the tip, and the section's angle, against
/// the elastica.
#[test]
fn the_elastica_under_smaller_loads() {
    let references = References::load();
    let stored = [
        (Kind::Paper, "elastica-1", 8.3047e-5, 5.3842e-5),
        (Kind::Paper, "elastica-2", 2.2844e-4, 1.0091e-4),
        (Kind::Paper, "elastica-5", 4.5949e-4, 2.3398e-5),
        (Kind::Paper, "elastica-10", 6.8814e-4, -6.7892e-5),
        (Kind::EulerBernoulli, "elastica-1", 6.8940e-5, 4.5595e-5),
        (Kind::EulerBernoulli, "elastica-2", 2.0469e-4, 9.5009e-5),
        (Kind::EulerBernoulli, "elastica-5", 4.3772e-4, 3.6107e-5),
        (Kind::EulerBernoulli, "elastica-10", 6.6692e-4, -4.9562e-5),
    ];
    for (kind, id, stored_tip, stored_angle) in stored {
        let reference = references.entry(id);
        let scene = slender(kind, 1e-3, 16);
        let P = reference.parameter("PL^2/EI") * EI(&scene);
        let shape = solve(&push(scene, P));
        let error = off(Vector2::x() + shape.tip(), reference.tip());
        let angle = shape.angle() - reference.value("tip.angle");
        println!("{kind:?}, {id}: tip off by {error:.4e} L, angle by {angle:+.4e}");
        assert_stored(&format!("{kind:?}, {id}"), error, stored_tip);
        assert_stored(&format!("{kind:?}, {id}, angle"), angle, stored_angle);
    }
}

/// Large bending of two cantilevers of 2 m, ν = 0, dead load F: h = 0.5 m, F = 5·10⁸ h³ N, and h = 0.1 m, F = 3EI/L².
/// Each element converges to the limit of its own strains, with order 4.
///
/// The paper's: that of its field and strain energy (`oracle/references/director.py`); its director has degree 2, and
/// the energy, and a tip under a dead load, take the square of its error. Euler and Bernoulli's: with |r_x| − 1 and
/// the turn of the section per initial length its rod is Reissner's, rigid in shear; r_xx has degree 1.
#[test]
fn each_element_converges_to_its_own_limit() {
    let references = References::load();
    // Distance of the tip from the limit with 8, 16, 32 and 64 elements, of L, and the order between the last two:
    // above four, and falling, as long as locking fades. Beyond 32 of the stubby rod's, eight times as high as long,
    // the rounding of Euler and Bernoulli's curvature shows.
    let stored: [(Kind, &str, &[f64], f64); 4] = [
        (Kind::Paper, "director-stubby", &[2.4597e-6, 1.4849e-7, 9.2133e-9, 5.7489e-10], 4.00),
        (Kind::Paper, "director-slender", &[4.5641e-5, 1.4007e-6, 6.1215e-8, 3.4056e-9], 4.17),
        (Kind::EulerBernoulli, "reissner-stubby-shear-rigid", &[2.6905e-7, 1.1907e-8, 6.6196e-10], 4.17),
        (Kind::EulerBernoulli, "reissner-slender-shear-rigid", &[2.5299e-5, 6.0119e-7, 1.9378e-8, 9.0982e-10], 4.41),
    ];
    for (kind, id, errors, stored_order) in stored {
        let limit = references.entry(id);
        let L = length(&limit);
        let (mut before, mut order) = (f64::NAN, f64::NAN);
        for doubled in 0..3 + errors.len() {
            let elements = 1 << doubled;
            let shape = solve(&push_in(rod(kind, &limit, elements), limit.parameter("F"), 4));
            let error = off(Vector2::new(L, 0.0) + shape.tip(), limit.tip()) / L;
            order = (before / error).log2();
            println!("{kind:?}, {id}, {elements:2} elements: tip off by {error:.4e} L, order {order:.2}");
            if doubled >= 3 {
                assert_stored(&format!("{kind:?}, {id}, {elements} elements"), error, errors[doubled - 3]);
            }
            if kind == Kind::EulerBernoulli {
                // The angle is in the fixture as well; its error is of the tip's size.
                let angle = (shape.angle() - limit.value("tip.angle")).abs();
                assert!(angle <= 2.0 * error, "{kind:?}, {id}, {elements}: angle off by {angle:.4e}");
            }
            before = error;
            if doubled + 1 == 3 + errors.len() {
                evidence::number(&format!("references.own-limit.{id}"), error);
                evidence::number(&format!("references.own-limit-order.{id}"), order);
            }
        }
        assert!((order - stored_order).abs() <= 0.05, "{kind:?}, {id}: order {order:.2}, stored {stored_order}");
    }
}

/// Reissner's law, which others print, is another limit: N and M of the Green–Lagrange strain are not linear in stretch
/// and curvature, and the element has no shear correction. Whoever compares an element of this kind with Reissner's
/// beam sees these gaps, and no mesh closes them. At ν = 0 the tip is the limit in the fixture. At ν = 0.3 Poisson's
/// terms are on the axis; the stiffness is that of plane strain there, which alone makes up 1 − ν² = 0.91.
#[test]
fn reissners_beam_is_another_limit_and_by_how_much() {
    let references = References::load();
    // The tip's x and y in L, and its angle.
    let stored = [
        ("stubby", "nu0-k1", [-4.634144e-3, -3.707087e-3, -4.635953e-3]),
        ("stubby", "nu0-k5_6", [-4.006223e-3, -1.875191e-3, -5.069590e-3]),
        ("stubby", "nu0.3-k1", [8.011480e-3, 2.303838e-2, 3.771459e-2]),
        ("stubby", "nu0.3-k5_6", [8.826327e-3, 2.542245e-2, 3.715179e-2]),
        ("slender", "nu0-k1", [-9.370320e-4, -5.211308e-4, -6.382425e-4]),
        ("slender", "nu0-k5_6", [-8.764153e-4, -4.176313e-4, -7.264328e-4]),
        ("slender", "nu0.3-k1", [2.288782e-2, 2.397343e-2, 4.652106e-2]),
        ("slender", "nu0.3-k5_6", [2.296662e-2, 2.410803e-2, 4.640639e-2]),
    ];
    for (beam, variant, stored) in stored {
        let reissner = references.entry(&format!("reissner-{beam}-{variant}"));
        let (L, director) = (length(&reissner), references.entry(&format!("director-{beam}")));
        let kind = if reissner.parameter("nu") == 0.0 { Kind::Paper } else { Kind::Axis };
        let fine = solve(&push_in(rod(kind, &reissner, 64), reissner.parameter("F"), 4));
        let limit = match kind {
            Kind::Paper => Vector2::from(director.tip()),
            _ => Vector2::new(L, 0.0) + fine.tip(),
        };
        let gap = (limit - Vector2::from(reissner.tip())) / L;
        let gap = [gap.x, gap.y, fine.angle() - reissner.value("tip.angle")];
        let [x, y, angle] = gap;
        println!("{kind:?}, {beam}, {variant}: tip {x:+.6e}, {y:+.6e} L, angle {angle:+.6e} from Reissner's");
        evidence::number(&format!("references.from-reissner.{beam}-{variant}"), x.hypot(y));
        for (gap, stored) in gap.iter().zip(stored) {
            assert!((gap / stored - 1.0).abs() <= 1e-5, "{beam}, {variant}: {gap:e}, stored {stored:e}");
        }
    }
}

/// With Poisson's terms on the axis the element converges as fast at ν = 0.3: order between 16, 32 and 64 elements.
#[test]
fn on_the_axis_poissons_ratio_leaves_the_order() {
    let references = References::load();
    for (id, stored) in [("reissner-stubby-nu0.3-k1", 3.88), ("reissner-slender-nu0.3-k1", 4.49)] {
        let reference = references.entry(id);
        let tip = |elements| solve(&push_in(rod(Kind::Axis, &reference, elements), reference.parameter("F"), 4)).tip();
        let [coarse, middle, fine] = [16, 32, 64].map(tip);
        let order = ((middle - coarse).norm() / (fine - middle).norm()).log2();
        println!("{id}: order {order:.2}, last change {:.1e} m", (fine - middle).norm());
        assert!((order - stored).abs() <= 0.05, "{id}: order {order:.2}, stored {stored}");
    }
}

/// At ν = 0 Poisson's terms are none, wherever they act: the same numbers to the last digit.
#[test]
fn without_poissons_ratio_the_axis_changes_nothing() {
    let references = References::load();
    for (id, load) in
        [("timoshenko-10", "P"), ("timoshenko-1000", "P"), ("director-stubby", "F"), ("director-slender", "F")]
    {
        let reference = references.entry(id);
        let [full, axis] = [Kind::Paper, Kind::Axis]
            .map(|kind| solve(&push_in(rod(kind, &reference, 4), reference.parameter(load), 4)).u);
        assert_eq!(full, axis, "{id}");
    }
}
