//! A scene of the user's own as a benchmark: its probe, its meshes, and two methods that have to agree on its reference.

use std::path::Path;

use super::benchmark::Benchmark;
use crate::error::{Error, Result};
use crate::path::distance;
use ancf::model::{Element, LoadPath, Method, Model, Quantity, Scene};

/// Longest run of its reference, s of one core.
pub const LONGEST_RUN: f64 = 1.0;

/// Intervals of a run, and instants in each.
const ROWS: usize = 8;
const INSTANTS: usize = 25;

/// Most elements of all rods on a mesh, unless three meshes need more.
const MOST_ELEMENTS: usize = 256;

/// Meshes that show how far the finest one is from the limit.
const LEAST_MESHES: usize = 3;

/// The finest mesh over the scene's own.
const FINER: usize = 4;

/// Whether an argument is a file rather than the name of a scene of the study.
pub fn is_file(argument: &str) -> bool {
    argument.ends_with(".json") || argument.contains(std::path::MAIN_SEPARATOR) || Path::new(argument).is_file()
}

/// The benchmark of a scene file, and the element of its first rod.
///
/// # Errors
/// Those of [`Model::load`]; [`Error::Scene`] for a scene without the position of a point, along a path, or with too many elements.
pub fn benchmark(file: &str) -> Result<(&'static Benchmark, Element)> {
    let scene = Model::load(file)?.into_scene();
    let refuse = |key: &str, value: String, allowed: &str| Error::Scene {
        file: file.into(),
        key: key.into(),
        value,
        allowed: allowed.into(),
    };
    let position = scene.probes.iter().find(|probe| probe.point.is_some() && probe.of.contains(&Quantity::Position));
    let probe = position.ok_or_else(|| {
        let allowed = "a probe of a point's position, from which errors are measured: {\"name\": \"tip\", \"point\": …, \"of\": [\"position\"]}";
        refuse("probes", "without one of a position".into(), allowed)
    })?;
    let is_static = scene.time.method == Method::Static;
    if is_static && scene.time.path == LoadPath::ArcLength {
        return Err(refuse("time.path", "arc-length".into(), "statics by load steps, or a motion"));
    }
    let element = scene.rods.first().map_or(Element::Ancf, |rod| rod.element);
    let (interval, rows, instants) =
        if is_static { (1.0, 1, 1) } else { (scene.time.end / ROWS as f64, ROWS, INSTANTS) };
    let meshes = meshes(&scene).ok_or_else(|| {
        let total: usize = scene.rods.iter().map(|rod| rod.elements).sum();
        let allowed = format!("numbers of which half and a quarter are whole, so that three meshes show an uncertainty; at most {MOST_ELEMENTS} in all on the coarsest");
        refuse("rods", format!("{total} elements in all"), &allowed)
    })?;
    let witnesses = if is_static {
        [(Method::Static, 20), (Method::Static, 30)]
    } else {
        [(Method::GeneralizedAlpha, 2 * INSTANTS), (Method::Gauss, 2 * INSTANTS)]
    };
    let name = Path::new(file).file_stem().map_or_else(|| file.into(), |stem| stem.to_string_lossy().into_owned());
    let found = Benchmark {
        scene: kept(crate::escape::line(&name)),
        probe: kept(probe.name.clone()),
        unit: unit(&scene),
        interval,
        rows,
        instants,
        meshes: Box::leak(meshes.into_boxed_slice()),
        smooth: false,
        coarsest: if is_static { 1 } else { 8 },
        witnesses,
        continuum: None,
        own: Some(Box::leak(Box::new(scene))),
    };
    Ok((Box::leak(Box::new(found)), element))
}

/// A text that is needed until the program ends; a command has a scene or two of its own.
fn kept(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

/// The largest power of ten within the distance of any two points, m.
fn unit(scene: &Scene) -> f64 {
    let points = || scene.points.values().map(|point| [point[0], point[1]]);
    let size = points().flat_map(|a| points().map(move |b| distance(a, b))).fold(0.0, f64::max);
    10f64.powi(size.log10().floor() as i32)
}

/// Elements of the first rod on each mesh: from the coarsest with the proportions of the scene, doubled.
fn meshes(scene: &Scene) -> Option<Vec<usize>> {
    // A rod that is pinned at its middle has a node there.
    let parts = scene.rods.iter().map(|rod| if rod.pivot.is_some() { rod.elements / 2 } else { rod.elements });
    let divisor = parts.fold(0, greatest_common_divisor);
    let (first, total) = (scene.rods.first()?.elements, scene.rods.iter().map(|rod| rod.elements).sum::<usize>());
    let of = |factor: usize| (first / divisor * factor, total / divisor * factor);
    let factors = (0..).map(|n| 1 << n).take_while(|factor| *factor <= FINER * divisor);
    let meshes: Vec<(usize, usize)> = factors.map(of).collect();
    let useful = meshes.iter().enumerate().take_while(|(n, (_, total))| *n < LEAST_MESHES || *total <= MOST_ELEMENTS);
    let found: Vec<usize> = useful.map(|(_, (elements, _))| *elements).collect();
    let coarse = meshes.first().is_some_and(|(_, total)| *total <= MOST_ELEMENTS);
    (coarse && found.len() >= LEAST_MESHES).then_some(found)
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(name: &str, elements: &[usize]) -> Scene {
        let mut scene = Scene::builtin(name).unwrap();
        scene.rods.iter_mut().zip(elements.iter().cycle()).for_each(|(rod, elements)| rod.elements = *elements);
        scene
    }

    #[test]
    fn meshes_keep_the_proportions_and_go_beyond_the_scene() {
        assert_eq!(meshes(&scene("pendulum-flexible", &[8])).unwrap(), [1, 2, 4, 8, 16, 32]);
        assert_eq!(meshes(&scene("pendulum-flexible", &[7])).unwrap(), [1, 2, 4, 8, 16]);
        // Pinned at the middle; and with other numbers in every second rod.
        assert_eq!(meshes(&scene("scissors-3", &[4])).unwrap(), [2, 4, 8, 16]);
        assert_eq!(meshes(&scene("scissors-3", &[4, 6])).unwrap(), [4, 8, 16]);
        assert!(meshes(&scene("pendulum-flexible", &[1])).is_some_and(|meshes| meshes == [1, 2, 4]));
        assert_eq!(meshes(&scene("scissors-3", &[500, 498])), None);
    }

    #[test]
    fn errors_are_parts_of_a_power_of_ten_within_the_structure() {
        assert_eq!(unit(&scene("pendulum-flexible", &[1])), 1.0);
        let mut small = scene("pendulum-flexible", &[1]);
        small.points.values_mut().for_each(|point| point.iter_mut().for_each(|x| *x *= 0.035));
        assert_eq!(unit(&small), 0.01);
    }

    #[test]
    fn names_are_no_files() {
        assert!(is_file("mine.json") && is_file("folder/mine") && !is_file("pendulum-flexible"));
    }
}
