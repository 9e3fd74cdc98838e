//! Test of what is published: each fastest run of `docs/results/error-time.json` is made again, and compared with a reference at every step.

use std::fs;
use std::path::Path;

use serde::Deserialize;

use super::benchmarks;
use super::reference::{Reference, Witness};
use super::samples::Samples;
use super::setup::{Resolution, Setup};
use super::technique::{Refinement, TECHNIQUES, Technique};
use super::trace::Trace;
use crate::scene::ELEMENTS;
use ancf::internals::model::Words;
use ancf::model::{Element, Method};

#[derive(Deserialize)]
struct Kept {
    winners: Vec<Winner>,
}

#[derive(Deserialize)]
struct Winner {
    scene: String,
    element: String,
    below: f64,
    bound: f64,
    ours: Ours,
}

#[derive(Deserialize)]
struct Ours {
    method: String,
    elements: usize,
    step: Option<f64>,
    tolerance: Option<f64>,
    newton_tolerance: Option<f64>,
    time: Time,
}

#[derive(Deserialize)]
struct Time {
    in_turns: bool,
}

fn winners() -> Vec<Winner> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/results/error-time.json");
    serde_json::from_str::<Kept>(&fs::read_to_string(file).unwrap()).unwrap().winners
}

fn element(word: &str) -> Element {
    ELEMENTS.into_iter().find(|element| element.word() == word).unwrap()
}

impl Winner {
    fn setup(&self) -> Setup {
        let (benchmark, Ours { method, elements, step, tolerance, newton_tolerance, .. }) =
            (benchmarks::of(&self.scene).unwrap(), &self.ours);
        let its = |technique: &&Technique| {
            technique.method.word() == method
                && newton_tolerance.is_none_or(|newton| newton == technique.newton_tolerance)
        };
        let parts = |step: f64| (benchmark.interval / step).round() as usize;
        let resolution = match (tolerance, step) {
            (Some(tolerance), _) => Resolution::Tolerance(*tolerance),
            (None, Some(step)) if benchmark.is_static() => Resolution::LoadSteps(parts(*step)),
            (None, step) => Resolution::Steps(parts(step.unwrap())),
        };
        let technique = TECHNIQUES.iter().find(its).unwrap();
        Setup { benchmark, element: element(&self.element), elements: *elements, technique, resolution }
    }
}

/// A converged solution that can be read at any time: runs with the last steps of a witness of the stored one, extrapolated as that one is.
struct Converged {
    coarse: Trace,
    fine: Trace,
    order: Option<i32>,
}

impl Converged {
    fn of(scene: &str, element: Element) -> Converged {
        let benchmark = benchmarks::of(scene).unwrap();
        let reference = Reference::embedded(benchmark, element).unwrap();
        // The witness with the fewest steps: both agree within the uncertainty.
        let last = |witness: &&Witness| (benchmark.interval / witness.steps.last().unwrap()) as usize;
        let witness = reference.finest().witnesses.iter().min_by_key(last).unwrap();
        let known = Technique::of(Method::from_word(&witness.method).unwrap()).unwrap();
        // A tolerance that leaves nothing; the tests end before that matters.
        let technique: &Technique =
            Box::leak(Box::new(Technique { newton_tolerance: 1e-10, refinement: Refinement::Steps, ..*known }));
        let run = |step: f64| {
            let resolution = Resolution::Steps((benchmark.interval / step).round() as usize);
            Trace::of(&Setup { benchmark, element, elements: reference.converged.elements, technique, resolution })
                .unwrap()
                .0
        };
        let [.., coarse, fine] = witness.steps[..] else { panic!("{scene}: one run only") };
        let order = witness.extrapolated.then_some(technique.order);
        let own = Converged { coarse: run(coarse), fine: run(fine), order };
        let apart = own.at(&benchmark.times()).distance(reference.solution());
        assert!(apart <= reference.converged.uncertainty, "{scene}, {element}: {apart:e}");
        own
    }

    fn at(&self, times: &[f64]) -> Samples {
        let fine = self.fine.at(times);
        self.order.map_or_else(|| fine.clone(), |order| self.coarse.at(times).extrapolated(&fine, order))
    }
}

#[test]
fn published_runs_are_within_their_labels_by_their_own_bounds() {
    let winners = winners();
    assert!(winners.iter().any(|winner| winner.scene == "pendulum-flexible"));
    for Winner { scene, element, below, bound, ours } in &winners {
        assert!(bound <= below && ours.time.in_turns, "{scene}, {element}: {bound:e} for {below:e}");
    }
}

/// The bar of the study: none.
#[test]
#[cfg_attr(debug_assertions, ignore = "runs of the finest meshes; in release mode")]
fn no_published_run_exceeds_its_label_at_any_step() {
    let winners: Vec<Winner> =
        winners().into_iter().filter(|winner| !benchmarks::of(&winner.scene).unwrap().is_static()).collect();
    let mut exceeding = Vec::new();
    for group in winners.chunk_by(|a, b| (&a.scene, &a.element) == (&b.scene, &b.element)) {
        let converged = Converged::of(&group[0].scene, element(&group[0].element));
        for winner in group {
            let (trace, _) = Trace::of(&winner.setup()).unwrap();
            let known = converged.at(&trace.t[1..]);
            let own = Samples { position: trace.position[1..].to_vec(), ..Samples::default() };
            let error = own.distance(&known);
            let line = format!(
                "{}, {}, {}: {error:.2e} m at {} steps, labelled {:.0e}",
                winner.scene,
                winner.element,
                winner.ours.method,
                known.position.len(),
                winner.below
            );
            println!("{line}");
            if error.is_nan() || error > winner.below {
                exceeding.push(line);
            }
        }
    }
    assert!(exceeding.is_empty(), "{exceeding:#?}");
}

/// The run that was labelled 10⁻³ m by its errors at eight instants, 4.2·10⁻⁴ m.
#[test]
fn the_label_that_did_not_hold_is_refused() {
    let benchmark = benchmarks::of("pendulum-flexible").unwrap();
    let technique = &TECHNIQUES[0];
    let setup = Setup { benchmark, element: Element::Ancf, elements: 4, technique, resolution: Resolution::Steps(48) };
    assert_eq!((technique.method, technique.newton_tolerance), (Method::GeneralizedAlpha, 1e-3));
    let reference = Reference::embedded(benchmark, Element::Ancf).unwrap();
    let (trace, _) = Trace::of(&setup).unwrap();
    let (samples, solution) = (trace.at(&benchmark.times()), reference.solution());
    let at = |samples: &Samples| Samples {
        position: samples.position.iter().skip(benchmark.instants - 1).step_by(benchmark.instants).copied().collect(),
        ..Samples::default()
    };
    let eight = at(&samples).distance(&at(solution));
    assert!((4.1e-4..4.3e-4).contains(&eight), "{eight:e}");
    let all = samples.distance(solution);
    assert!(
        (1.7e-3..1.9e-3).contains(&all) && trace.interpolation_error() < 1e-4,
        "{all:e}, {:e}",
        trace.interpolation_error()
    );
}
