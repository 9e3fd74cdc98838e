//! Cost of a step for each scissor-like element, from 10 to 1000 of them in a row: it should not depend on their number.
//!
//! `cargo bench --bench scissors`, about two minutes. Building a structure and its first factorisation are timed apart from
//! the steps, and the first steps, in which the memory is touched for the first time, are not timed. Every round measures all sizes one after the other, so that slow phases of the machine hit all alike, and ratios
//! are taken within a round; the table shows medians over rounds, and half the distance of the quartiles as their spread.
//! Times are processor times where the system tells them; other programs still take their share of the caches.

use std::hint::black_box;

use ancf::error::Result;
use ancf::integrators::Counts;
use ancf::integrators::{Integrator, State};
use ancf::internals::model::Scissors;
use ancf::internals::structure::Structure;
use ancf::model::{Constraints, Method, Scene};
use ancf::nalgebra::DVector;

/// Numbers of scissor-like elements; the bar compares the last with the first.
const COUNTS: [usize; 3] = [10, 100, 1000];

/// Elements of a rod.
const ELEMENTS: usize = 4;

/// Time step, s.
const STEP: f64 = 1e-3;

/// Steps from rest that are not timed, and those after them that are.
const FIRST_STEPS: usize = 2;
const STEPS: usize = 10;

const ROUNDS: usize = 5;

/// Small structures repeat their steps within a round until this many scissors have made them.
const LEAST_SCISSORS: usize = 200;

/// Most that a step of the largest structure may cost for each scissor, relative to the smallest.
const MOST_RATIO: f64 = 1.2;

const CASES: [(&str, Method, Constraints); 3] = [
    ("energy-momentum, condensed", Method::EnergyMomentum, Constraints::Condensed),
    ("generalized-alpha, condensed", Method::GeneralizedAlpha, Constraints::Condensed),
    ("generalized-alpha, multipliers", Method::GeneralizedAlpha, Constraints::Multipliers),
];

/// One size in one round, times in s.
#[derive(Clone, Copy)]
struct Sample {
    /// Building the structure and the method.
    setup: f64,
    /// All steps once.
    steps: f64,
    iterations: usize,
}

fn main() -> Result<()> {
    println!(
        "scissors of 2 rods, {ELEMENTS} elements each; {STEPS} steps of {STEP} s from rest; median of {ROUNDS} rounds ± half \
         the interquartile distance"
    );
    let mut holds = true;
    for (name, method, constraints) in CASES {
        holds &= case(name, method, constraints)?;
    }
    println!(
        "\ncost per step, iteration and scissor at most {MOST_RATIO} times as large, memory linear: {}",
        verdict(holds)
    );
    Ok(())
}

/// Measures one way of computing at all sizes, prints its table, and says whether its cost is linear.
fn case(name: &str, method: Method, constraints: Constraints) -> Result<bool> {
    let scenes = COUNTS.map(|count| scene(count, method, constraints));
    let scenes = scenes.into_iter().collect::<Result<Vec<Scene>>>()?;
    let bytes: Vec<f64> = scenes
        .iter()
        .zip(COUNTS)
        .map(|(scene, count)| Ok(Structure::new(scene)?.matrix_bytes() as f64 / count as f64))
        .collect::<Result<_>>()?;
    let mut samples: Vec<Vec<Sample>> = vec![Vec::new(); COUNTS.len()];
    for _ in 0..ROUNDS {
        for ((scene, count), samples) in scenes.iter().zip(COUNTS).zip(&mut samples) {
            samples.push(sample(scene, LEAST_SCISSORS.div_ceil(count))?);
        }
    }

    println!("\n{name}");
    println!(
        "{:>8} {:>22} {:>12} {:>26} {:>16} {:>18}",
        "scissors", "step/scissor, µs", "iter./step", "iteration/scissor, µs", "matrix, kB/sc.", "setup/scissor, µs"
    );
    let each = |of: &dyn Fn(&Sample) -> f64, n: usize| samples[n].iter().map(of).collect::<Vec<f64>>();
    let per_step = |n: usize| each(&|sample| sample.steps / (STEPS * COUNTS[n]) as f64 * 1e6, n);
    let per_iteration = |n: usize| each(&|sample| sample.steps / (sample.iterations * COUNTS[n]) as f64 * 1e6, n);
    for (n, count) in COUNTS.into_iter().enumerate() {
        let setup = each(&|sample| sample.setup / count as f64 * 1e6, n);
        println!(
            "{count:>8} {:>22} {:>12.2} {:>26} {:>16.2} {:>18}",
            with_spread(per_step(n)),
            samples[n][0].iterations as f64 / STEPS as f64,
            with_spread(per_iteration(n)),
            bytes[n] / 1e3,
            with_spread(setup),
        );
    }
    let last = COUNTS.len() - 1;
    let ratios = |of: &dyn Fn(usize) -> Vec<f64>| of(last).iter().zip(of(0)).map(|(a, b)| a / b).collect::<Vec<f64>>();
    let (step, iteration) = (ratios(&per_step), ratios(&per_iteration));
    let memory = bytes[last] / bytes[0];
    let (of_step, of_iteration) = (median(step.clone()), median(iteration.clone()));
    let holds = of_step <= MOST_RATIO && of_iteration <= MOST_RATIO && memory <= MOST_RATIO;
    println!(
        "{} to {}: per step {}, per iteration {}, memory {memory:.3}: {}",
        COUNTS[last],
        COUNTS[0],
        with_spread(step),
        with_spread(iteration),
        verdict(holds)
    );
    Ok(holds)
}

fn scene(count: usize, method: Method, constraints: Constraints) -> Result<Scene> {
    let mut scene = Scissors { elements: ELEMENTS, ..Scissors::new(count) }.scene()?;
    (scene.time.method, scene.time.step, scene.constraints) = (method, STEP, constraints);
    scene.clone().build()?;
    Ok(scene)
}

/// The steps of a structure, `repetitions` times from the same start: mean times.
fn sample(scene: &Scene, repetitions: usize) -> Result<Sample> {
    let (mut setup, mut steps, mut iterations) = (0.0, 0.0, 0);
    for _ in 0..repetitions {
        let before = seconds();
        let structure = Structure::new(scene)?;
        let mut counts = Counts::default();
        let (u, v) = (structure.start().clone(), DVector::zeros(structure.size()));
        let mut state = State { step: 0, t: 0.0, load: 0.0, u, v };
        let mut method: Box<dyn Integrator> = ancf::internals::integrators::integrator(
            scene,
            &ancf::internals::model::Plan::of(scene),
            &structure,
            &state,
            &mut counts,
        )?;
        setup += seconds() - before;

        let mut before = seconds();
        for step in 1..=FIRST_STEPS + STEPS {
            let t_1 = scene.time_after(step);
            method.step(&structure, &mut state, t_1, &mut counts)?;
            (state.step, state.t) = (step, t_1);
            if step == FIRST_STEPS {
                (before, counts) = (seconds(), Counts::default());
            }
        }
        steps += seconds() - before;
        iterations = counts.newton_iterations;
        black_box(&state);
    }
    Ok(Sample { setup: setup / repetitions as f64, steps: steps / repetitions as f64, iterations })
}

/// Processor time of this thread, s.
#[cfg(unix)]
fn seconds() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// Time since the first call, s.
#[cfg(not(unix))]
fn seconds() -> f64 {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed().as_secs_f64()
}

fn verdict(holds: bool) -> &'static str {
    if holds { "holds" } else { "DOES NOT HOLD" }
}

fn median(values: Vec<f64>) -> f64 {
    quantile(values, 0.5)
}

/// Median ± half the distance of the quartiles.
fn with_spread(values: Vec<f64>) -> String {
    let spread = 0.5 * (quantile(values.clone(), 0.75) - quantile(values.clone(), 0.25));
    format!("{:.3} ± {spread:.3}", median(values))
}

/// The value below which a fraction of the values lies, linear in between.
fn quantile(mut values: Vec<f64>, fraction: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let place = fraction * (values.len() - 1) as f64;
    let (below, above) = (values[place.floor() as usize], values[place.ceil() as usize]);
    below + place.fract() * (above - below)
}
