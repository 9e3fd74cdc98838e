//! Parts of a step, and one step of each method, of a pendulum of 8 elements and of three scissor-like elements with 4 a rod.
//!
//! `cargo bench --bench structure`, about a minute and a half. The time of a step is a mean over a run from rest without its first
//! steps, again and again, so that a matrix serves for as many steps as it does in a run. A step of an adaptive method is one of its own choice.

use std::hint::black_box;
use std::time::{Duration, Instant};

use ancf::error::Result;
use ancf::integrators::Counts;
use ancf::integrators::{Integrator, State};
use ancf::internals::model::Plan;
use ancf::internals::model::Scissors;
use ancf::internals::structure::{Matrix, Structure};
use ancf::model::{Element, Method, Model, Scene, ThermalModel};
use ancf::nalgebra::DVector;
use criterion::Criterion;

/// Steps from rest that are not timed, and those after them that are.
const FIRST_STEPS: usize = 20;
const STEPS: usize = 200;

const METHODS: [Method; 7] = [
    Method::GeneralizedAlpha,
    Method::EnergyMomentum,
    Method::Explicit,
    Method::Gauss,
    Method::Nystrom,
    Method::GaussAdaptive,
    Method::NystromAdaptive,
];

fn main() -> Result<()> {
    let mut criterion = Criterion::default()
        .without_plots()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(1))
        .sample_size(20)
        .configure_from_args();
    for element in [Element::Ancf, Element::EulerBernoulli] {
        let pendulum = Model::load("pendulum-flexible")?.into_scene();
        parts_and_steps("pendulum of 8 elements", pendulum, element, [1e-3, 2e-5], &mut criterion)?;
        let scissors = Scissors { elements: 4, model: ThermalModel::TwoD, ..Scissors::new(3) }.scene()?;
        parts_and_steps("3 scissors of 4 elements", scissors, element, [1e-3, 1e-6], &mut criterion)?;
    }
    criterion.final_summary();
    Ok(())
}

/// Times a scene with one of the elements; steps (s) of implicit methods, and of explicit ones.
fn parts_and_steps(
    name: &str,
    mut scene: Scene,
    element: Element,
    steps: [f64; 2],
    criterion: &mut Criterion,
) -> Result<()> {
    scene.rods.iter_mut().for_each(|rod| rod.element = element);
    let mut group = criterion.benchmark_group(format!("{name}, {element}"));

    let structure = Structure::new(&scene)?;
    let (u, thermal) = (structure.start(), structure.thermal_strains(0.0));
    let mut sum = DVector::zeros(structure.size());
    group.bench_function("elastic force", |b| b.iter(|| structure.force(black_box(u), &thermal, &mut sum)));
    group.bench_function("inertia", |b| b.iter(|| structure.inertia_into(black_box(u), &mut sum)));
    let (weight, mut a) = (structure.load(0.0), DVector::zeros(structure.size()));
    let mut mass_factors = structure.factorize_mass().expect("the scenes have masses");
    group.bench_function("mass solve", |b| {
        b.iter(|| {
            a.copy_from(&weight);
            mass_factors.solve(black_box(&mut a));
        })
    });
    // Generalized-α's with ρ∞ = 0.9.
    let (stiffness, mass) = (1.0 / 1.9, 1.1 / 1.9 * 4.0 * (1.9 / 2.0_f64).powi(2) / steps[0].powi(2));
    let mut factors = structure.factors();
    group.bench_function("factorisation", |b| {
        b.iter(|| {
            structure.factorize(Matrix::Tangent { u: black_box(u), thermal: &thermal, stiffness, mass }, &mut factors)
        })
    });
    let load = structure.load(0.0);
    let mut b_x = load.clone();
    group.bench_function("solve", |b| {
        b.iter(|| {
            b_x.copy_from(&load);
            factors.solve(black_box(&mut b_x));
        })
    });

    for method in METHODS {
        scene.time.method = method;
        scene.time.step = steps[usize::from(method.is_explicit())];
        let mut walk = Walk::new(&scene, &structure)?;
        let mut failure = None;
        group.bench_function(format!("step, {method}"), |b| {
            b.iter_custom(|iterations| {
                walk.steps(iterations).unwrap_or_else(|error| {
                    failure = Some(error);
                    Duration::from_secs(1)
                })
            })
        });
        failure.map_or(Ok(()), Err)?;
    }
    group.finish();
    Ok(())
}

/// Steps of a run that begins anew after [`STEPS`] of them.
struct Walk<'a> {
    scene: &'a Scene,
    structure: &'a Structure,
    method: Box<dyn Integrator>,
    state: State,
    counts: Counts,
}

impl<'a> Walk<'a> {
    /// A run after its first steps.
    fn new(scene: &'a Scene, structure: &'a Structure) -> Result<Walk<'a>> {
        let mut counts = Counts::default();
        let state = State::at_start(structure);
        let method = ancf::internals::integrators::integrator(scene, &Plan::of(scene), structure, &state, &mut counts)?;
        let mut walk = Walk { scene, structure, method, state, counts };
        (0..FIRST_STEPS).try_for_each(|_| walk.step())?;
        walk.counts = Counts::default();
        Ok(walk)
    }

    fn step(&mut self) -> Result<()> {
        let t_1 = self.state.t + self.scene.time.step;
        self.method.step(self.structure, &mut self.state, t_1, &mut self.counts)
    }

    /// Time that a number of steps takes; beginning anew is not timed.
    fn steps(&mut self, number: u64) -> Result<Duration> {
        let (mut left, mut elapsed) = (number, Duration::ZERO);
        while left > 0 {
            if self.counts.steps >= STEPS {
                *self = Walk::new(self.scene, self.structure)?;
            }
            let now = left.min((STEPS - self.counts.steps) as u64);
            let start = Instant::now();
            (0..now).try_for_each(|_| self.step())?;
            elapsed += start.elapsed();
            left -= now;
        }
        black_box(&self.state);
        Ok(elapsed)
    }
}
