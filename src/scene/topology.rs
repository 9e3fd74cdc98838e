//! What a scene has to fulfil: names, points, rods, supports and probes that fit together.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

use super::Scene;
use super::parse::nearest;
use super::validate::{Check, finite, require};

/// Most elements of a scene: 400 000 coordinates. More is a mistyped number; a rod of that many elements has lost the
/// digits in which its bending shows.
const MOST_ELEMENTS: usize = 100_000;

/// Shortest rod relative to the largest coordinate of its ends: below, the difference of its ends has no more than
/// seven digits.
const SHORTEST: f64 = 1e-9;

/// Names, points, rods, supports and probes.
pub(super) fn check_topology(scene: &Scene) -> Check {
    for (name, position) in &scene.points {
        check_name(format_args!("points.{name}"), name)?;
        for (axis, &x) in position.iter().enumerate() {
            finite(format_args!("points.{name}[{axis}]"), x)?;
        }
    }
    check_rods(scene)?;
    let ends: BTreeSet<&str> = scene.rods.iter().flat_map(|rod| [rod.from.as_str(), rod.to.as_str()]).collect();
    for (name, position) in &scene.points {
        let allowed = "only points that a rod has as its `from` or `to`";
        require(ends.contains(name.as_str()), format_args!("points.{name}"), format_args!("{position:?}"), allowed)?;
    }
    check_supports(scene)?;
    check_probes(scene)
}

fn check_rods(scene: &Scene) -> Check {
    require(!scene.rods.is_empty(), "rods", "[]", "at least one rod")?;
    unique("rods", "name", scene.rods.iter().map(|rod| rod.name.as_str()))?;
    let mut elements = 0;
    for (i, rod) in scene.rods.iter().enumerate() {
        check_name(format_args!("rods[{i}].name"), &rod.name)?;
        check_point(scene, format_args!("rods[{i}].from"), &rod.from)?;
        check_point(scene, format_args!("rods[{i}].to"), &rod.to)?;
        let key = format_args!("rods[{i}].to");
        require(rod.from != rod.to, key, format_args!("{:?}", rod.to), "another point than `from`")?;
        if let (Some(&[x0, y0]), Some(&[x1, y1])) = (scene.points.get(&rod.from), scene.points.get(&rod.to)) {
            let length = (x1 - x0).hypot(y1 - y0);
            let size = [x0, y0, x1, y1].iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let allowed = format_args!(
                "a point further from `{}` than {SHORTEST:e} of their coordinates; the rod's length is {length:?} m",
                rod.from
            );
            // `length` overflows where the points are too far apart.
            require(length > SHORTEST * size && length.is_finite(), key, format_args!("{:?}", rod.to), allowed)?;
        }
        let most = MOST_ELEMENTS - elements;
        let allowed = format_args!("a whole number from 1 to {most} ({MOST_ELEMENTS} in all rods)");
        require((1..=most).contains(&rod.elements), format_args!("rods[{i}].elements"), rod.elements, allowed)?;
        elements += rod.elements;
    }
    Ok(())
}

fn check_supports(scene: &Scene) -> Check {
    for (i, support) in scene.supports.iter().enumerate() {
        check_point(scene, format_args!("supports[{i}].point"), &support.point)?;
        check_list(format_args!("supports[{i}].fix"), support.fix.iter().map(|direction| direction.word()))?;
    }
    unique("supports", "point", scene.supports.iter().map(|support| support.point.as_str()))
}

fn check_probes(scene: &Scene) -> Check {
    for (i, probe) in scene.probes.iter().enumerate() {
        check_name(format_args!("probes[{i}].name"), &probe.name)?;
        let allowed = "another name, as the columns `energy.…` hold energies";
        require(probe.name != "energy", format_args!("probes[{i}].name"), "\"energy\"", allowed)?;
        check_point(scene, format_args!("probes[{i}].point"), &probe.point)?;
        check_list(format_args!("probes[{i}].of"), probe.of.iter().map(|quantity| quantity.word()))?;
    }
    unique("probes", "name", scene.probes.iter().map(|probe| probe.name.as_str()))
}

/// Names are used in the paths of keys (`points.a`) and in the head of a CSV file, where these characters mean
/// something else.
fn check_name(key: impl Display, name: &str) -> Check {
    let refused = |c: char| c.is_control() || ".,;[]\"`".contains(c);
    let holds = !name.is_empty() && name.trim() == name && !name.contains(refused);
    require(holds, key, format_args!("{name:?}"), "a name without . , ; [ ] \" ` and without spaces at its ends")
}

/// Refuses a name that is not that of a point.
fn check_point(scene: &Scene, key: impl Display, name: &str) -> Check {
    if scene.points.contains_key(name) {
        return Ok(());
    }
    let allowed = match nearest(name, scene.points.keys().map(String::as_str)) {
        Some(nearest) => format!("the name of a point in `points`; nearest: `{nearest}`"),
        None => "the name of a point in `points`, which is empty".into(),
    };
    require(false, key, format_args!("{name:?}"), allowed)
}

/// Refuses an empty list and one that holds a word twice.
fn check_list(key: impl Display, words: impl ExactSizeIterator<Item = &'static str>) -> Check {
    require(words.len() > 0, &key, "[]", "at least one entry")?;
    let mut seen = BTreeSet::new();
    for (i, word) in words.enumerate() {
        require(seen.insert(word), format_args!("{key}[{i}]"), format_args!("{word:?}"), "each word once")?;
    }
    Ok(())
}

/// Refuses a name that an earlier entry of `list` has under the same `key`.
fn unique<'a>(list: &str, key: &str, names: impl Iterator<Item = &'a str>) -> Check {
    let mut seen = BTreeMap::new();
    for (i, name) in names.enumerate() {
        if let Some(first) = seen.insert(name, i) {
            let allowed = format_args!("each name once; {list}[{first}] has this one");
            return require(false, format_args!("{list}[{i}].{key}"), format_args!("{name:?}"), allowed);
        }
    }
    Ok(())
}
