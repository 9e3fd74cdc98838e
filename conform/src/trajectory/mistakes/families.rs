//! Mistakes with a number that is fitted.

use ancf::model::Start;

use crate::trajectory::mistake::{
    CONSTRAINTS, Family, HEAT, INPUT, LAW, LOADS, METHOD, Made, OUTPUT, Output, each_material, each_section,
    has_gravity, is_heated,
};
use crate::trajectory::motion::Method;
use crate::trajectory::setup::Setup;

fn setup(right: &Setup, change: impl Fn(&mut Setup)) -> Option<Made> {
    let mut setup = right.clone();
    change(&mut setup);
    Some(Made::Setup(Box::new(setup)))
}

/// Implicit methods with shorter steps than this, s, are not tried: they take too long, and few take them.
const SHORTEST_IMPLICIT_STEP: f64 = 9e-5;

const FACTORS: &[f64] = &[0.25, 0.6, 0.95, 1.05, 1.6, 4.0];

/// Mistakes with a number that is fitted.
pub const FAMILIES: &[Family] = &[
    Family {
        what: |factor| format!("the weight times {factor:.4}"),
        look_at: LOADS,
        starts: FACTORS,
        make: |right, factor, _| {
            has_gravity(&right.scene)
                .then(|| setup(right, |setup| setup.scene.gravity = setup.scene.gravity.map(|g| factor * g)))?
        },
    },
    Family {
        what: |factor| format!("E times {factor:.4}"),
        look_at: INPUT,
        starts: FACTORS,
        make: |right, factor, _| {
            setup(right, |s| each_material(&mut s.scene, |material| material.youngs_modulus *= factor))
        },
    },
    Family {
        what: |factor| format!("ρ times {factor:.4}"),
        look_at: INPUT,
        starts: FACTORS,
        make: |right, factor, _| setup(right, |s| each_material(&mut s.scene, |material| material.rho *= factor)),
    },
    Family {
        what: |factor| format!("the thermal strain times {factor:.4}"),
        look_at: HEAT,
        starts: &[-1.0, 0.25, 0.6, 0.95, 1.05, 1.6, 3.0],
        make: |right, factor, _| is_heated(&right.scene).then(|| setup(right, |setup| setup.heat = [factor; 2]))?,
    },
    Family {
        what: |factor| format!("the heat grows over {factor:.4} s"),
        look_at: HEAT,
        starts: &[0.003, 0.007, 0.015, 0.03, 0.05, 0.07, 0.1, 0.13, 0.16, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45],
        make: |right, ramp, _| {
            let at_once = |right: &Setup| {
                right.scene.temperature.as_ref().is_some_and(|heat| heat.at(0.0) != 0.0 && heat.start == Start::Sudden)
            };
            (at_once(right) && ramp > 0.0).then(|| setup(right, |setup| setup.ramp = ramp))?
        },
    },
    Family {
        what: |factor| format!("I times {:.4}", factor * factor),
        look_at: INPUT,
        starts: &[0.5, 0.8, 1.25, 2.0],
        make: |right, factor, _| setup(right, |setup| setup.law.depth = factor),
    },
    Family {
        what: |factor| format!("the section's height times {factor:.4}"),
        look_at: INPUT,
        starts: &[0.5, 0.8, 1.25, 2.0],
        make: |right, factor, _| {
            setup(right, |setup| each_section(&mut setup.scene, |section| section.height *= factor))
        },
    },
    Family {
        what: |factor| format!("the shear stiffness times {factor:.4}"),
        look_at: LAW,
        starts: &[0.3, 0.8, 1.3, 3.0],
        make: |right, factor, _| setup(right, |setup| setup.law.shear = factor),
    },
    Family {
        what: |rate| format!("damping, {rate:.4} /s times the mass"),
        look_at: METHOD,
        starts: &[0.1, 1.0, 10.0],
        make: |right, rate, _| setup(right, |setup| setup.mass_damping = rate),
    },
    Family {
        what: |gamma| format!("a first-order method: Newmark's with γ = {gamma:.3}, damped"),
        look_at: METHOD,
        starts: &[0.55, 0.7, 0.9],
        make: |_, gamma, step| {
            let beta = 0.25 * (gamma + 0.5).powi(2);
            let (c, d) = ([0.5 - beta, beta], [1.0 - gamma, gamma]);
            step.filter(|step| *step > SHORTEST_IMPLICIT_STEP && gamma > 0.5 && gamma < 1.5)
                .map(|step| Made::Method(Method::Steps { step, c, d }))
        },
    },
    Family {
        what: |power| {
            format!("fixed points give way: springs of {:.2e} N/m in place of constraints", 10f64.powf(power))
        },
        look_at: CONSTRAINTS,
        starts: &[2.0, 3.0, 4.0, 5.0, 6.0],
        make: |right, power, _| {
            let fixed = right.scene.supports.iter().any(|support| !support.fix.is_empty());
            // Stiffer springs vibrate faster than the fine motion's steps.
            (fixed && power < 7.0).then(|| setup(right, |setup| setup.support_springs = Some(10f64.powf(power))))?
        },
    },
    Family {
        what: |time| format!("damping, {time:.2e} s times the stiffness"),
        look_at: METHOD,
        starts: &[1e-6, 1e-5],
        // A longer time of retardation leaves no step that the fine motion could take.
        make: |right, time, _| (time < 3e-5).then(|| setup(right, |setup| setup.retardation = time))?,
    },
    Family {
        what: |factor| format!("times times {factor:.4}"),
        look_at: OUTPUT,
        starts: &[0.5, 0.97, 1.03, 2.0],
        make: |_, factor, _| (factor > 0.0).then_some(Made::Output(Output::Times(factor, 0.0))),
    },
    Family {
        what: |shift| format!("written {:.2e} s {}", shift.abs(), if shift < 0.0 { "late" } else { "early" }),
        look_at: OUTPUT,
        starts: &[-1e-2, 1e-2],
        make: |_, shift, _| Some(Made::Output(Output::Times(1.0, shift))),
    },
];
