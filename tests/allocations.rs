//! Time stepping asks the heap for nothing: a run of twice as many steps makes exactly as many allocations.
//!
//! Held for every method, both elements, with and without heat, pins, energies, accelerations and reactions. Two things do
//! take memory as a run goes on, and are told, not judged:
//!
//! * rows of the trajectory, in one block. All of it is there before the first step, so that none is taken in the loop;
//! * `"constraints": "multipliers"`: each factorisation beside multipliers makes its matrix and its factors anew.
//!
//! One test, alone in its process, as everything that the process allocates is counted. `--nocapture` shows the numbers.

use std::cell::Cell;

use ancf::integrators::Counts;
use ancf::model::{Constraints, Element, Method, Probe, Quantity, Scene};
use ancf::run::run_with_progress;

#[global_allocator]
static ALLOCATOR: dhat::Alloc = dhat::Alloc;

/// Steps of the shorter run, or its load steps.
const STEPS: usize = 40;
const LOAD_STEPS: usize = 8;

const SCENES: [&str; 3] = ["pendulum-flexible", "pendulum-2d", "scissors-3-thermal"];

const METHODS: [Method; 7] = [
    Method::GeneralizedAlpha,
    Method::EnergyMomentum,
    Method::Explicit,
    Method::Gauss,
    Method::Nystrom,
    Method::GaussAdaptive,
    Method::NystromAdaptive,
];

/// What is recorded.
#[derive(Clone, Copy, PartialEq)]
enum Recorded {
    /// Positions alone.
    Little,
    /// Every quantity, and the energies.
    All,
}

/// What a run asked the heap for.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Heap {
    blocks: u64,
    bytes: u64,
}

impl Heap {
    fn now() -> Heap {
        let dhat::HeapStats { total_blocks: blocks, total_bytes: bytes, .. } = dhat::HeapStats::get();
        Heap { blocks, bytes }
    }

    fn since(self, before: Heap) -> Heap {
        Heap { blocks: self.blocks - before.blocks, bytes: self.bytes - before.bytes }
    }
}

/// One run: all of its allocations, those after its first step or row, and what it did.
struct Measured {
    all: Heap,
    later: Heap,
    counts: Counts,
}

fn measure(scene: &Scene) -> Measured {
    let start = Heap::now();
    let (first, last) = (Cell::new(None), Cell::new(start));
    let run = run_with_progress(scene, |_| {
        last.set(Heap::now());
        first.set(first.get().or(Some(last.get())));
    })
    .expect("the scene runs");
    let all = Heap::now().since(start);
    Measured { all, later: last.get().since(first.get().expect("there are steps")), counts: run.counts }
}

fn scene(name: &str, method: Method, element: Element, recorded: Recorded) -> Scene {
    let mut scene = Scene::builtin(name).expect("a built-in scene");
    scene.time.method = method;
    scene.rods.iter_mut().for_each(|rod| rod.element = element);
    scene.time.step = match name {
        _ if method == Method::Static => scene.time.step,
        // Below the limits of the explicit methods.
        "scissors-3-thermal" if method.is_explicit() => 1e-6,
        "scissors-3-thermal" => 2.5e-4,
        _ => 1e-5,
    };
    scene.output.energy = recorded == Recorded::All || method == Method::Static;
    scene.probes.retain_mut(|probe| {
        if recorded == Recorded::Little {
            probe.of.retain(|quantity| *quantity == Quantity::Position);
        }
        !probe.of.is_empty()
    });
    if recorded == Recorded::All {
        let mut add = |point: &str, rod: Option<&str>, of: &[Quantity]| {
            let name = format!("probe-{}", scene.probes.len());
            let (point, rod, of) = (Some(point.to_string()), rod.map(str::to_string), of.to_vec());
            scene.probes.push(Probe { name, point, rod, at: None, of, mean: None });
        };
        match name {
            "cantilever" => add("o", Some("rod"), &[Quantity::Reaction]),
            "scissors-3-thermal" => {
                add("b1", None, &[Quantity::Reaction]);
                add("m2", Some("b2a3"), &[Quantity::Reaction]);
            }
            _ => add("o", None, &[Quantity::Acceleration, Quantity::Reaction]),
        }
    }
    scene
}

/// The scene with a number of steps, and two rows or one each step. Adaptive methods go on for as long as these steps take,
/// and reach each row.
fn lasting(scene: &Scene, steps: usize, two_rows: bool) -> Scene {
    let mut scene = scene.clone();
    scene.time.end = steps as f64 * scene.time.step;
    scene.output.interval = Some(if two_rows { scene.time.end } else { scene.time.step });
    scene
}

#[test]
fn steps_ask_the_heap_for_nothing() {
    let _profiler = dhat::Profiler::builder().testing().build();
    let mut failures = Vec::new();
    let mut expect_none = |case: &str, what: &str, blocks: u64| {
        if blocks != 0 {
            failures.push(format!("{case}: {blocks} blocks {what}"));
        }
    };
    println!("{:>20} {:>16} {:>18} {:>8} | blocks of a run, of twice the steps; steps", "", "", "", "recorded");
    for name in SCENES {
        for element in [Element::Ancf, Element::EulerBernoulli] {
            for method in METHODS {
                for recorded in [Recorded::Little, Recorded::All] {
                    let scene = scene(name, method, element, recorded);
                    let case = case(name, method, element, recorded);
                    // The test's own thread is up by then, and so is all that is made once in a process.
                    measure(&lasting(&scene, 1, true));
                    let [once, twice] = [1, 2].map(|times| measure(&lasting(&scene, times * STEPS, true)));
                    println!("{case} | {} {}; {}", once.all.blocks, twice.all.blocks, twice.counts.steps);
                    expect_none(&case, "more in a run of twice the steps", twice.all.blocks.abs_diff(once.all.blocks));
                    expect_none(&case, "bytes more", twice.all.bytes.abs_diff(once.all.bytes));
                    let rows = measure(&lasting(&scene, STEPS, false));
                    expect_none(&case, "after the first row, of one each step", rows.later.blocks);
                }
            }
        }
    }
    for element in [Element::Ancf, Element::EulerBernoulli] {
        for recorded in [Recorded::Little, Recorded::All] {
            let case = case("cantilever", Method::Static, element, recorded);
            let mut scene = scene("cantilever", Method::Static, element, recorded);
            let [once, twice] = [1, 2].map(|times| {
                scene.time.load_steps = times * LOAD_STEPS;
                measure(&scene)
            });
            println!("{case} | {} {}; {}", once.all.blocks, twice.all.blocks, twice.counts.steps);
            expect_none(&case, "after the first load step", twice.later.blocks);
            // Every load step is a row, and all of them are in one block.
            expect_none(&case, "more in a run of twice the load steps", twice.all.blocks - once.all.blocks);
        }
    }
    let [few, many] = [1, 100_001].map(|rows| {
        let mut scene = scene("pendulum-flexible", Method::Explicit, Element::EulerBernoulli, Recorded::Little);
        (scene.rods[0].elements, scene.probes, scene.output.interval) = (1, Vec::new(), None);
        scene.time.end = scene.time.step * f64::from(rows);
        measure(&scene).all.bytes
    });
    // What `model/checks/time.rs` promises: 8 bytes a number, here of one column.
    println!("{} bytes for 100,000 rows of one number", many - few);
    assert_eq!(many - few, 8 * 100_000, "a number takes more than 8 bytes");

    assert!(failures.is_empty(), "{} times memory is taken:\n{}", failures.len(), failures.join("\n"));

    for name in SCENES {
        for element in [Element::Ancf, Element::EulerBernoulli] {
            let mut scene = scene(name, Method::GeneralizedAlpha, element, Recorded::All);
            scene.constraints = Constraints::Multipliers;
            let [once, twice] = [1, 2].map(|times| measure(&lasting(&scene, times * STEPS, true)));
            let factorizations = twice.counts.factorizations - once.counts.factorizations;
            println!(
                "{} with multipliers | {} {}; {}: {factorizations} factorisations more",
                case(name, Method::GeneralizedAlpha, element, Recorded::All),
                once.all.blocks,
                twice.all.blocks,
                twice.counts.steps
            );
        }
    }
}

fn case(name: &str, method: Method, element: Element, recorded: Recorded) -> String {
    let recorded = if recorded == Recorded::All { "all" } else { "little" };
    format!("{name:>20} {:>16} {:>18} {recorded:>8}", element.to_string(), method.to_string())
}
