//! Functions of one element: the kernel's, and beside them those of `equations` that it is held to.
//!
//! `cargo bench --bench kernel`, about a minute. At the end both are timed in turns, so that slow phases of the machine hit both
//! alike: the paper's force in the kernel's arrangement has to be [`LEAST_RATIO`] times as fast as in that of the paper.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::hint::black_box;
use std::time::{Duration, Instant};

use ancf::equations::element::{Element, Matrix14};
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::shape::Vector14;
use ancf::equations::{cable, force};
use ancf::internals::elements::{Ancf, Beam, Cable, Ends, Law};
use ancf::model::Poisson;
use ancf::nalgebra::{SMatrix, SVector, Vector3};
use criterion::Criterion;

/// Least ratio of the times of (19) with K of (20) and (21), and of the kernel's force.
const LEAST_RATIO: f64 = 30.0;

/// Rounds of the ratios, and how long one side takes in each.
const ROUNDS: usize = 15;
const TURN: Duration = Duration::from_millis(20);

// An element of the pendulum of Table 1, with ν ≠ 0 so that no term is left out; SI units.
const L: f64 = 0.125;
const H: f64 = 0.02;
const E: f64 = 2e8;
const NU: f64 = 0.3;
const HEAT: f64 = 5.7e-3;
const THETA: f64 = 0.3;

/// A bent and stretched element of either kind, with `N` coordinates.
struct Case<const N: usize> {
    /// Displacement at both ends of a step, e − e₀.
    u: [SVector<f64, N>; 2],
    /// Initial coordinates.
    e_0: SVector<f64, N>,
    eps_T: [f64; 2],
}

impl<const N: usize> Case<N> {
    /// An element of the initial coordinates `e_0`, displaced by a wave along them.
    fn new(e_0: SVector<f64, N>) -> Case<N> {
        let wave = |size: f64| SVector::from_fn(|i, _| size * (1.0 + i as f64).sin());
        Case { u: [wave(1e-3), wave(1.1e-3)], e_0, eps_T: [HEAT, HEAT] }
    }

    fn ends(&self) -> Ends<'_, SVector<f64, N>> {
        Ends { u_0: &self.u[0], u_1: &self.u[1], thermal_0: self.eps_T, thermal_1: self.eps_T }
    }

    /// The functions of the kernel.
    fn bench(&self, name: &str, beam: &impl Beam<N>, criterion: &mut Criterion) {
        let mut group = criterion.benchmark_group(format!("kernel/{name}"));
        let (case, beam) = (black_box(self), black_box(beam));
        group.bench_function("force", |b| b.iter(|| beam.force(black_box(&case.u[0]), case.eps_T)));
        group.bench_function("tangent", |b| b.iter(|| beam.tangent(black_box(&case.u[0]), case.eps_T)));
        group.bench_function("mean force", |b| b.iter(|| beam.mean_force(black_box(&case.ends()))));
        group.bench_function("mean tangent", |b| b.iter(|| beam.mean_tangent(black_box(&case.ends()))));
        group.finish();
    }
}

/// The paper's element as `equations` has it.
struct Paper {
    element: Element,
    lame: LameConstants,
    eps_T: Vector3<f64>,
}

impl Paper {
    /// (19) with K of (20) and K₁, K₂, K₃ of (21).
    fn force(&self, e: &Vector14) -> Vector14 {
        let Paper { element, lame, eps_T } = self;
        let (K_1, K_2, K_3) =
            (force::K_1(e, eps_T, element), force::K_2(e, eps_T, element), force::K_3(e, eps_T, element));
        force::Q_e(e, &force::K(*lame, &K_1, &K_2, &K_3))
    }

    fn tangent(&self, e: &Vector14) -> Matrix14 {
        force::tangent(e, &self.eps_T, self.lame, &self.element)
    }
}

/// The cable element as `equations` has it.
struct Competitor {
    EA: f64,
    EI: f64,
}

impl Competitor {
    fn force(&self, e: &SVector<f64, 8>) -> SVector<f64, 8> {
        cable::Q_e(e, HEAT, self.EA, self.EI, L)
    }

    fn tangent(&self, e: &SVector<f64, 8>) -> SMatrix<f64, 8, 8> {
        cable::tangent(e, HEAT, self.EA, self.EI, L)
    }
}

fn main() {
    let mut criterion = Criterion::default()
        .without_plots()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(1))
        .sample_size(20)
        .configure_from_args();

    let element = Element::straight(L, H, H, THETA);
    let case = Case::new(element.e_0);
    let lame = LameConstants::from(YoungPoisson { E, nu: NU });
    let beam = Ancf::new(L, H, H, THETA, Law::PlaneStrain { lame, poisson: Poisson::Full });
    let paper = Paper { element, lame, eps_T: Vector3::new(HEAT, HEAT, 0.0) };
    let e = case.e_0 + case.u[0];
    same("ancf", beam.force(&case.u[0], case.eps_T).as_slice(), paper.force(&e).as_slice());

    let (sin, cos) = THETA.sin_cos();
    let cable_case = Case::new(cable::Vector8::from([0.0, 0.0, cos, sin, L * cos, L * sin, cos, sin]));
    let competitor = Competitor { EA: E * H * H, EI: E * H.powi(4) / 12.0 };
    let cable = Cable::new(L, THETA, competitor.EA, competitor.EI);
    let cable_e = cable_case.e_0 + cable_case.u[0];
    let of_cable = cable.force(&cable_case.u[0], cable_case.eps_T);
    same("euler-bernoulli", of_cable.as_slice(), competitor.force(&cable_e).as_slice());

    case.bench("ancf", &beam, &mut criterion);
    let mut group = criterion.benchmark_group("equations/ancf");
    group.bench_function("force", |b| b.iter(|| paper.force(black_box(&e))));
    group.bench_function("tangent", |b| b.iter(|| paper.tangent(black_box(&e))));
    group.finish();
    cable_case.bench("euler-bernoulli", &cable, &mut criterion);
    let mut group = criterion.benchmark_group("equations/euler-bernoulli");
    group.bench_function("force", |b| b.iter(|| competitor.force(black_box(&cable_e))));
    group.bench_function("tangent", |b| b.iter(|| competitor.tangent(black_box(&cable_e))));
    group.finish();
    criterion.final_summary();

    println!("time of `equations` over that of the kernel, median of {ROUNDS} rounds (quartiles):");
    let (u, eps_T) = (&case.u[0], case.eps_T);
    let of_force = ratio("ancf, force", || beam.force(black_box(u), eps_T), || paper.force(black_box(&e)));
    ratio("ancf, tangent", || beam.tangent(black_box(u), eps_T), || paper.tangent(black_box(&e)));
    let u = &cable_case.u[0];
    ratio("euler-bernoulli, force", || cable.force(black_box(u), eps_T), || competitor.force(black_box(&cable_e)));
    ratio(
        "euler-bernoulli, tangent",
        || cable.tangent(black_box(u), eps_T),
        || competitor.tangent(black_box(&cable_e)),
    );
    let holds = of_force >= LEAST_RATIO;
    let verdict = if holds { "holds" } else { "DOES NOT HOLD" };
    println!("force of the paper's element at least {LEAST_RATIO} times as fast as its equations: {verdict}");
    if !holds {
        std::process::exit(1);
    }
}

/// What is compared computes the same.
fn same(name: &str, kernel: &[f64], equations: &[f64]) {
    let largest = equations.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let off = kernel.iter().zip(equations).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= 1e-9 * largest, "{name}: the forces differ by {off:e} of {largest:e}");
}

/// Time of `slow` over that of `fast`, taken in turns: the median, printed with its quartiles.
fn ratio<T>(name: &str, fast: impl Fn() -> T, slow: impl Fn() -> T) -> f64 {
    let mut ratios: Vec<f64> = (0..ROUNDS).map(|_| 1.0 / (seconds(&fast) / seconds(&slow))).collect();
    ratios.sort_by(f64::total_cmp);
    let [first, median, third] = [1, 2, 3].map(|quarter| ratios[quarter * (ROUNDS - 1) / 4]);
    println!("{name:>26} {median:>8.1} ({first:.1} to {third:.1})");
    median
}

/// Mean time of a call, over one turn.
fn seconds<T>(call: impl Fn() -> T) -> f64 {
    const BATCH: usize = 50;
    let (start, mut calls) = (Instant::now(), 0);
    while start.elapsed() < TURN {
        (0..BATCH).for_each(|_| {
            black_box(call());
        });
        calls += BATCH;
    }
    start.elapsed().as_secs_f64() / calls as f64
}
