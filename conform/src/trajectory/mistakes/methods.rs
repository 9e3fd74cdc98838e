//! Methods: those that lose an order or energy, and right ones.

use crate::trajectory::mistake::{METHOD, Made, Mistake, OUTPUT, Output};
use crate::trajectory::motion::Method;
use crate::trajectory::setup::Setup;

/// Methods that lose an order or energy, with the program's step; and outputs a step late or early.
pub fn methods(right: &Setup, step: f64) -> Vec<Mistake> {
    let newmark = |beta: f64, gamma: f64| ([0.5 - beta, beta], [1.0 - gamma, gamma]);
    let named = [
        ("a first-order method: implicit Euler", ([0.0, 1.0], [0.0, 1.0])),
        ("a first-order method: explicit Euler", ([0.0, 0.0], [1.0, 0.0])),
        ("a first-order method: semi-implicit Euler", ([1.0, 0.0], [1.0, 0.0])),
        ("a first-order method: positions without ½ h² q̈", ([0.0, 0.0], [0.5, 0.5])),
        ("a first-order method: Newmark's with γ = 0.6, damped", newmark(0.3025, 0.6)),
        ("a first-order method: Newmark's with γ = 0.75, damped", newmark(0.390_625, 0.75)),
        ("a first-order method: Newmark's with γ = 1, damped", newmark(0.5625, 1.0)),
    ];
    let method = |(what, (c, d)): (&str, _)| Mistake {
        what: what.into(),
        look_at: METHOD,
        made: Made::Method(Method::Steps { step, c, d }),
    };
    let mut all: Vec<Mistake> = named.into_iter().map(method).collect();
    let heats = right.scene.rods.iter().filter_map(|rod| right.scene.heat(rod));
    let has_history = heats
        .map(|heat| heat.history.len())
        .chain(right.scene.forces.iter().map(|force| force.history.as_ref().map_or(0, Vec::len)));
    if has_history.max().unwrap_or(0) > 1 {
        let setup = Setup { delay: step, ..right.clone() };
        let what = "loads and heat are those of the step before".into();
        all.push(Mistake { what, look_at: METHOD, made: Made::Setup(Box::new(setup)) });
    }
    for (what, shift) in [("written a step late", -step), ("written a step early", step)] {
        all.push(Mistake { what: what.into(), look_at: OUTPUT, made: Made::Output(Output::Times(1.0, shift)) });
    }
    all
}

/// Methods of second order that keep energy, with the program's step: Verlet's and the trapezoidal rule. What a right program is off by.
pub fn right_methods(step: f64) -> [Method; 2] {
    [Method::Steps { step, c: [0.5, 0.0], d: [0.5, 0.5] }, Method::Steps { step, c: [0.25, 0.25], d: [0.5, 0.5] }]
}
