//! Large rotations: a free rod that spins.

use std::f64::consts::PI;

use nalgebra::{DVector, Vector2};

use super::prelude::*;
use super::richardson::{Series, order};
use super::steps::each_step;
use ancf::integrators::Counts;
use ancf::integrators::State;
use ancf::internals::elements::{Ancf, Beam, Cable, Meaning, NodalVector};
use ancf::internals::structure::Structure;

pub const CASE: Case = Case {
    name: "rotation-free",
    parameter: "turns",
    unit: "of the initial value",
    reference: "initial energy and angular momentum: no load acts on a free rod",
    right: "energy–momentum: both drift by at most 2.5 n ε_mach in n steps, 5.6e-11 in 1,000 turns of a hundred: each step rounds position and \
            velocity once, and Newton leaves 1e-15 of the force N ≤ ρAω²L²/8, which works over ½ωLΔt, 0.4 ε_mach of the energy. Gauss and velocity \
            Verlet conserve what is bilinear in position and momentum, and so the angular momentum, to the same bound. Their energy, and both \
            quantities of the other methods, change by the error of the step: series of three runs with halved steps. Turns go on to 3,000, where \
            nothing has broken (a hundredth would be reached after 2e11 turns). With one or two steps a turn positions mean nothing, whatever is \
            conserved.",
    trials,
};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Invariant {
    Energy,
    AngularMomentum,
}

/// Time of a turn, s.
const TURN: f64 = 0.2;

fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    let mut add = |method: Method, element: Element, steps: usize, turns: &[usize]| {
        for &turns in turns {
            for (invariant, what) in [(Invariant::Energy, "energy"), (Invariant::AngularMomentum, "angular momentum")] {
                let name = format!("{method}, {element}, {steps} steps a turn, {what}");
                let run = move || spin(method, element, steps, turns, invariant);
                let trial = Trial::new(name, turns as f64, run).fast(turns == 10 && method == Method::EnergyMomentum);
                trials.push(trial.expect(Expected::result_if(steps >= 100)));
            }
        }
    };
    for element in ELEMENTS {
        add(Method::EnergyMomentum, element, 100, &[10, 100, 1000, 3000]);
        for steps in [30, 10, 5, 3] {
            add(Method::EnergyMomentum, element, steps, &[10]);
        }
        add(Method::Gauss, element, 100, &[10, 100]);
        add(Method::GeneralizedAlpha, element, 100, &[10, 100]);
    }
    add(Method::Explicit, Element::Ancf, 5000, &[10, 100]);
    // Fewer steps do not resolve the vibrations of the section and damp them: none are left after ten turns, with half of the steps either.
    add(Method::Nystrom, Element::Ancf, 20_000, &[10]);
    trials
}

/// A rod of one element that turns about its middle.
fn free_rod(method: Method, element: Element, step: f64, turns: usize) -> Result<Scene> {
    let mut scene = pendulum(element, 1)?.solved(method, step, TURN * turns as f64).newton(1e-15).rows_every(TURN);
    (scene.supports, scene.gravity) = (Vec::new(), [0.0; 2]);
    scene.motion = Some(Motion { velocity: [0.0; 2], omega: 2.0 * PI / TURN, about: [0.5, 0.0] });
    scene.clone().build()?;
    Ok(scene)
}

fn spin(method: Method, element: Element, steps: usize, turns: usize, invariant: Invariant) -> Result<Finding> {
    let step = TURN / steps as f64;
    let drift = |parts: f64| drift(&free_rod(method, element, step / parts, turns)?, invariant);
    let (error, counts) = drift(1.0)?;
    let conserves = match method {
        Method::EnergyMomentum => true,
        Method::Gauss | Method::Explicit => invariant == Invariant::AngularMomentum,
        _ => false,
    };
    let rounding = 2.5 * f64::EPSILON * (steps * turns) as f64;
    let (bound, why) = if conserves {
        (rounding, "conserved: rounding and Newton's residual".into())
    } else {
        let (half, quarter) = (drift(2.0)?.0, drift(4.0)?.0);
        // The shortest step rounds four times as often.
        let series = Series::new((error - half).abs(), (half - quarter).abs(), order(method)).above(4.0 * rounding);
        (series.bound() + 4.0 * rounding, format!("not conserved; halved steps {series}"))
    };
    Ok(Finding { error, bound, why, size: 1.0, rounding, counts, ..Finding::default() })
}

/// Largest relative change of an invariant at the ends of the turns.
fn drift(scene: &Scene, invariant: Invariant) -> Result<(f64, Counts)> {
    let (mut start, mut worst) = (f64::NAN, 0.0);
    let counts = each_step(scene, |structure, state, step, _| {
        let value = || match invariant {
            Invariant::Energy => {
                structure.kinetic_energy(&state.v, &mut DVector::zeros(structure.size()))
                    + structure.strain_energy(&state.u, &structure.thermal_strains(0.0))
            }
            Invariant::AngularMomentum => angular_momentum(scene, structure, state),
        };
        if step == 0 {
            start = value();
        } else if scene.is_row(step) {
            let change = (value() / start - 1.0).abs();
            // A NaN stays.
            worst = if change <= worst { worst } else { change };
        }
    })?;
    Ok((worst, counts))
}

/// Σ q × (M v) over the nodal vectors of the only rod, about the origin: slopes turn with the rod as positions do.
fn angular_momentum(scene: &Scene, structure: &Structure, state: &State) -> f64 {
    let rod = &scene.rods[0];
    let vectors: &[NodalVector] = match rod.element {
        Element::Ancf => Ancf::VECTORS,
        Element::EulerBernoulli => Cable::VECTORS,
    };
    let momentum = structure.inertia(&state.v);
    let of = |(number, &(meaning, at)): (usize, &NodalVector)| {
        let get = |of: &DVector<f64>| {
            let component = |c| structure.unknown(&rod.name, number, c).map_or(0.0, |unknown| of[unknown]);
            Vector2::new(component(0), component(1))
        };
        let start = match meaning {
            Meaning::Position => Vector2::new(at, 0.0),
            Meaning::SlopeX => Vector2::x(),
            Meaning::SlopeY => Vector2::y(),
        };
        (start + get(&state.u)).perp(&get(&momentum))
    };
    vectors.iter().enumerate().map(of).sum()
}
