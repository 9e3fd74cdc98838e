//! The study: fronts, limits and ratios, the files that are read, and the points of a small grid.

use std::fs;
use std::path::Path;

use ancf::error::Error;
use ancf::integrators::Counts;
use ancf::internals::model::Words;
use ancf::model::{Element, Method};

use super::benchmark::Benchmark;
use super::benchmarks::BENCHMARKS;
use super::grid::{Limits, Subject};
use super::pareto::{fastest, in_turns, leads, pareto_front, ratio};
use super::point::{Errors, OURS, Point, Status};
use super::reference::Reference;
use super::setup::{Record, Resolution, Setup};
use super::tables;
use super::technique::{Refinement, TECHNIQUES, Technique};
use super::timing::Timing;

const UNCERTAINTY: f64 = 1e-6;

/// A made-up point that took `time` (s) for an error of `error` (m).
fn point(time: f64, error: f64) -> Point {
    let errors = Errors { position: error, time: Some(0.1 * error), space: Some(0.9 * error), ..Errors::default() };
    Point {
        program: OURS.into(),
        scene: "pendulum-flexible".into(),
        element: "ancf".into(),
        method: "energy-momentum".into(),
        elements: 4,
        step: Some(1.0 / 3.0),
        errors: Some(errors),
        reference_uncertainty: UNCERTAINTY,
        time: Timing::of(&[0.9 * time, time, 1.1 * time]),
        counts: Counts {
            rejected: 0,
            steps: 7,
            newton_iterations: 6,
            force_calls: 5,
            tangent_calls: 4,
            factorizations: 3,
            solves: 2,
        },
        status: Status::of(error, UNCERTAINTY),
        ..Point::default()
    }
}

fn failed() -> Point {
    let reason = "Newton's iteration, said: \"no\"\nand stopped".into();
    Point { errors: None, time: None, failed_after: Some(0.1), status: Status::Failed, reason, ..point(1.0, 1.0) }
}

fn times(points: &[&Point]) -> Vec<f64> {
    points.iter().filter_map(|point| point.seconds()).collect()
}

#[test]
fn the_table_reads_back_to_the_same_numbers() {
    let points =
        [point(0.1, 1.0 / 3.0), failed(), Point { tolerance: Some(1e-300), step: None, ..point(5e-324, 1e-9) }];
    let mut csv = Vec::new();
    tables::points(points.iter()).csv(&mut csv).unwrap();
    let mut reader = csv::Reader::from_reader(&csv[..]);
    let heading: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!((heading.len(), rows.len()), (34, points.len()));
    for (point, row) in points.iter().zip(&rows) {
        let field = |name: &str| &row[heading.iter().position(|column| column == name).unwrap()];
        let number = |name: &str| Some(field(name)).filter(|text| !text.is_empty()).map(|text| text.parse().unwrap());
        let count = |name: &str| field(name).parse::<usize>().unwrap();
        let (errors, time) = (point.errors.as_ref(), point.time.as_ref());
        assert_eq!([field("program"), field("scene"), field("element")], ["ancf", "pendulum-flexible", "ancf"]);
        assert_eq!(
            [field("method"), field("status"), field("reason")],
            [&*point.method, point.status.word(), &*point.reason]
        );
        assert_eq!([number("step"), number("tolerance")], [point.step, point.tolerance]);
        assert_eq!(number("newton_tolerance"), None);
        assert_eq!(number("error_position"), errors.map(|errors| errors.position));
        assert_eq!([number("error_velocity"), number("error_reaction"), number("energy_balance")], [None; 3]);
        assert_eq!(number("error_time"), errors.and_then(|errors| errors.time));
        assert_eq!(number("error_space"), errors.and_then(|errors| errors.space));
        assert_eq!(number("reference_uncertainty"), Some(UNCERTAINTY));
        assert_eq!(number("error_bound"), point.bound());
        let times = [number("time_median_s"), number("time_lower_s"), number("time_upper_s")];
        assert_eq!(times, [time.map(|t| t.median), time.map(|t| t.lower), time.map(|t| t.upper)]);
        assert_eq!((field("disturbed"), field("in_turns")), ("0", "false"));
        assert_eq!([count("elements"), count("runs")], [4, time.map_or(0, |time| time.runs)]);
        assert_eq!((field("rejected"), ["steps", "newton_iterations", "force_calls"].map(count)), ("", [7, 6, 5]));
        assert_eq!(["tangent_calls", "factorizations", "solves"].map(count), [4, 3, 2]);
    }
}

#[test]
fn a_pareto_front_has_no_point_that_another_beats() {
    let points =
        [point(1.0, 1e-2), point(2.0, 2e-2), point(3.0, 1e-3), point(3.0, 5e-3), point(4.0, 1e-3), point(9.0, 1e-5)];
    // Fast and accurate, but not to be trusted: failed, or as good as the reference.
    let at_limit = point(0.5, 1e-7);
    let failed = failed();
    let all: Vec<&Point> = points.iter().chain([&at_limit, &failed]).collect();
    assert_eq!(times(&pareto_front(&all)), [1.0, 3.0, 9.0]);
    assert!(pareto_front(&[&at_limit, &failed]).is_empty() && pareto_front(&[]).is_empty());
}

#[test]
fn a_point_near_the_reference_is_at_its_limit() {
    assert_eq!(Status::of(2.9e-6, UNCERTAINTY), Status::AtLimit);
    assert_eq!(Status::of(3.1e-6, UNCERTAINTY), Status::Ok);
    assert_eq!(Status::of(f64::NAN, UNCERTAINTY), Status::Failed);
    assert_eq!(failed().bound(), None);
    let (at_limit, slow) = (point(1.0, 2e-6), point(5.0, 4e-6));
    assert_eq!(times(&[fastest(&[&at_limit, &slow], 1e-5).unwrap()]), [1.0]);
    assert!(fastest(&[&at_limit, &slow], 2.5e-6).is_none());
}

/// Parts that cancel, a maximum between the instants, interpolation and the reference's uncertainty: a label has to hold with all of them.
#[test]
fn a_label_covers_all_that_an_error_may_be() {
    let errors = Errors {
        position: 1e-4,
        time: Some(8e-4),
        space: Some(7e-4),
        between: 1e-5,
        interpolation: 2e-6,
        ..Errors::default()
    };
    let crossing = Point { errors: Some(errors), ..point(1.0, 1e-4) };
    assert_eq!(crossing.error(), Some(8e-4 + 1e-5));
    assert_eq!(crossing.bound(), Some(8e-4 + 1e-5 + 2e-6 + UNCERTAINTY));
    assert!(fastest(&[&crossing], 8e-4).is_none() && fastest(&[&crossing], 1e-3).is_some());
}

#[test]
fn programs_are_compared_at_equal_error() {
    let ours = [point(1.0, 9e-3), point(2.0, 9e-5)];
    let theirs = [point(10.0, 5e-4), point(50.0, 1e-5)];
    let [ours, theirs]: [Vec<&Point>; 2] = [ours.iter().collect(), theirs.iter().collect()];
    let found = ratio(&ours, &theirs, 1e-3).unwrap();
    assert_eq!((found.error, found.ratio), (1e-3, 5.0));
    assert!((found.least - 9.5 / 2.1).abs() < 1e-12 && (found.most - 10.5 / 1.9).abs() < 1e-12);
    assert_eq!(ratio(&ours, &theirs, 1e-2).unwrap().ratio, 10.0);
    assert_eq!(ratio(&ours, &theirs, 1e-4).unwrap().ratio, 25.0);
    // One of them does not get there.
    assert!(ratio(&ours, &theirs, 1e-5).is_none() && ratio(&ours, &[], 1e-2).is_none());
}

#[test]
fn times_taken_in_turns_are_compared_with_each_other_only() {
    let mut points = [point(1.0, 1e-3), point(2.0, 1e-3), point(3.0, 1e-4)];
    let all = |points: &[Point]| times(&in_turns(&points.iter().collect::<Vec<_>>()));
    assert_eq!(all(&points), [1.0, 2.0, 3.0]);
    points.iter_mut().skip(1).for_each(|point| point.time.as_mut().unwrap().in_turns = true);
    assert_eq!(all(&points), [2.0, 3.0]);
}

#[test]
fn the_faster_family_is_told_range_by_range() {
    let explicit = |time, error| Point { explicit: true, ..point(time, error) };
    let points = [
        point(1.0, 1e-2),
        point(4.0, 1e-3),
        point(16.0, 1e-4),
        explicit(2.0, 1e-3),
        explicit(4.0, 1e-4),
        explicit(9.0, 1e-5),
    ];
    let all: Vec<&Point> = points.iter().collect();
    let found = leads(&all);
    let short: Vec<_> = found.iter().map(|lead| (lead.from, lead.to, lead.explicit, lead.ratio)).collect();
    let [a, b, c, d] = [1e-2, 1e-3, 1e-4, 1e-5].map(|error| error + UNCERTAINTY);
    assert_eq!(short, [(a, a, false, Some([2.0, 2.0])), (b, c, true, Some([2.0, 4.0])), (d, d, true, None)]);
}

fn cantilever() -> &'static Benchmark {
    BENCHMARKS.iter().find(|benchmark| benchmark.scene == "cantilever").unwrap()
}

fn reference_text() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/converged/cantilever-ancf.json"))
        .unwrap()
}

#[test]
fn a_broken_reference_is_refused() {
    let text = reference_text();
    let parse = |text: &str| Reference::parse("cantilever-ancf.json", text, cantilever(), Element::Ancf);
    parse(&text).unwrap();
    let broken: [(&str, &str, &str); 7] = [
        ("\"version\": \"2.0\"", "\"version\": \"1.0\"", "its version is 1.0, not 2.0"),
        ("ancf-converged/2", "ancf-converged/1", "its schema is ancf-converged/1"),
        ("\"scene\": \"cantilever\"", "\"scene\": \"pendulum\"", "it is of pendulum with ancf"),
        ("\"uncertainty\": ", "\"uncertainty\": 1e-3, \"was\": ", "unknown field `was`"),
        ("\"time_uncertainty\":", "\"time_uncertainty\":-", "the run with 1 elements is not whole"),
        ("\"elements\": 256,\n    \"space\"", "\"elements\": 128,\n    \"space\"", "not the converged one of 128"),
        ("\"space\": ", "\"space\": 1", "does not cover"),
    ];
    for (from, to, says) in broken {
        assert!(text.contains(from), "{from}");
        let error = parse(&text.replacen(from, to, 1)).unwrap_err();
        assert!(
            matches!(&error, crate::error::Error::Fixture { .. }) && error.to_string().contains(says),
            "{says}: {error}"
        );
    }
    assert!(parse(&text[..text.len() / 2]).is_err());
    assert!(Reference::parse("x", &text, cantilever(), Element::EulerBernoulli).is_err());
}

#[test]
fn embedded_references_are_whole_and_their_meshes_converge() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/converged");
    let mut files = names(&folder);
    for benchmark in &BENCHMARKS {
        for element in [Element::Ancf, Element::EulerBernoulli] {
            let name = Reference::file_name(benchmark, element);
            // Every file that is there is embedded; the quick study and the cheapest one cannot do without theirs.
            if !files.contains(&name) && !matches!(benchmark.scene, "pendulum-flexible" | "cantilever") {
                assert!(Reference::embedded(benchmark, element).unwrap_err().to_string().contains("--references"));
                continue;
            }
            files.retain(|file| *file != name);
            let reference = Reference::embedded(benchmark, element).unwrap();
            let elements: Vec<usize> = reference.meshes.iter().map(|mesh| mesh.elements).collect();
            assert_eq!(elements, benchmark.meshes);
            let first = reference.space_error(&reference.meshes[0]);
            assert!(reference.converged.uncertainty < 0.3 * first, "{}, {element}: {first}", benchmark.scene);
            let methods: Vec<&str> = benchmark.witnesses.iter().map(|(method, _)| method.word()).collect();
            for mesh in &reference.meshes {
                assert!(mesh.witnesses.iter().all(|witness| methods.contains(&witness.method.as_str())));
                assert!(mesh.time_uncertainty >= mesh.witnesses[0].change);
            }
        }
    }
    assert!(files.is_empty(), "not of the study: {files:?}");
}

#[test]
fn a_setup_records_what_it_is_asked_for() {
    let benchmark = &BENCHMARKS[0];
    let technique = Technique::of(Method::EnergyMomentum).unwrap();
    let setup = Setup {
        benchmark,
        element: Element::EulerBernoulli,
        elements: 3,
        technique,
        resolution: Resolution::Steps(500),
    };
    let scene = setup.scene(Record::Position).unwrap();
    assert_eq!(setup.scene(Record::Instants).unwrap().output.interval, Some(0.005));
    assert_eq!(scene.columns(), ["t", "tip.x", "tip.y"]);
    assert_eq!((scene.rods[0].elements, scene.rods[0].element, scene.time.step), (3, Element::EulerBernoulli, 5e-4));
    assert_eq!((scene.output.interval, scene.time.method), (Some(0.25), Method::EnergyMomentum));
    let columns = setup.scene(Record::Steps).unwrap().columns();
    assert!(
        columns.contains(&"tip.vx".into())
            && columns.contains(&"support.rx".into())
            && columns.contains(&"energy.balance".into()),
        "{columns:?}"
    );
    // An explicit method begins at the largest stable step that divides the interval.
    let setup = Setup { technique: Technique::of(Method::Explicit).unwrap(), ..setup };
    let Resolution::Steps(parts) = setup.first_resolution().unwrap() else { panic!("not steps") };
    let run = |parts| {
        let mut scene = Setup { resolution: Resolution::Steps(parts), ..setup }.scene(Record::Position).unwrap();
        scene.time.end = benchmark.interval;
        ancf::run::run(&scene)
    };
    assert!(run(parts).is_ok() && matches!(run(parts - 1), Err(Error::StepTooLarge { .. })), "{parts}");
}

#[test]
fn every_method_is_in_the_study_and_no_two_techniques_are_the_same() {
    for word in Method::WORDS {
        assert!(Technique::of(Method::from_word(word).unwrap()).is_some(), "{word}");
    }
    for (n, technique) in TECHNIQUES.iter().enumerate() {
        assert!(!TECHNIQUES[..n].contains(technique), "{technique:?}");
    }
    assert!(
        TECHNIQUES.iter().all(|technique| technique.is_static() == (technique.refinement == Refinement::LoadSteps))
    );
}

/// Sudden heat collapses an element within long steps. How far the others are from the reference, that of a relaxed start, is of no matter.
#[test]
fn failures_are_points_too() {
    let [sudden, relaxed] = ["pendulum-2d", "pendulum-2d-relaxed"].map(|scene| super::benchmarks::of(scene).unwrap());
    let reference = Reference::embedded(relaxed, Element::Ancf).unwrap();
    let subject = Subject::new(sudden, Element::Ancf, reference).unwrap();
    let points = subject.points(&Limits { longest_run: 0.005, finest_mesh: 1, finest_static: 1 }, || ()).unwrap();
    let failures: Vec<_> =
        points.iter().map(|(_, point)| point).filter(|point| point.status == Status::Failed).collect();
    assert!(failures.iter().any(|point| point.reason.contains("collapsed")), "{} failures", failures.len());
    assert!(failures.iter().all(|point| point.errors.is_none() && point.time.is_none() && !point.reason.is_empty()));
}

#[test]
fn the_front_is_timed() {
    let benchmark = cantilever();
    let reference = Reference::embedded(benchmark, Element::EulerBernoulli).unwrap();
    let subject = Subject::new(benchmark, Element::EulerBernoulli, reference).unwrap();
    let limits = Limits { longest_run: 1.0, finest_mesh: 8, finest_static: 8 };
    let points = subject.points(&limits, || ()).unwrap();
    let all: Vec<&Point> = points.iter().map(|(_, point)| point).collect();
    assert!(all.iter().all(|point| point.status != Status::Failed), "a load step that is too long is halved");
    let front = pareto_front(&all);
    // How long the front is depends on the machine's noise; where it ends does not.
    assert!(!front.is_empty() && front.iter().all(|point| point.time.as_ref().unwrap().runs >= 3));
    assert_eq!(front.last().unwrap().elements, 8);
    let errors = front.last().unwrap().errors.as_ref().unwrap();
    assert!(errors.reaction.unwrap() < 1e-6 && errors.time.unwrap() < 1e-9 && errors.velocity.is_none());
}

fn names(folder: &Path) -> Vec<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}
