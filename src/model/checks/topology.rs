//! Checks of points, rods and pivots, and of references to them by name.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

use crate::model::check::{Check, finite, require};
use crate::model::choice::{Element, Law, Poisson};
use crate::model::nearest::or_nearest;
use crate::model::rod::Rod;
use crate::model::scene::Scene;

/// Most elements of a scene: 400 000 coordinates. More is a mistyped number; in a rod of so many elements bending is
/// lost in rounding.
pub(in crate::model) const MOST_ELEMENTS: usize = 100_000;

/// Shortest rod relative to the largest coordinate of its ends: below it the difference of the ends has fewer than
/// seven digits.
const SHORTEST_ROD: f64 = 1e-9;

/// Most names listed in a message.
const MOST_NAMES: usize = 8;

/// Largest distance between the middles of two rods with one pivot, relative to the shorter rod.
const PIVOT_TOLERANCE: f64 = 1e-9;

/// Checks points, rods and pivots.
pub(in crate::model) fn check_topology(scene: &Scene) -> Check {
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
    check_pivots(scene)
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
                "a point further from `{}` than {SHORTEST_ROD:e} of their coordinates; the rod's length is {length:?} m",
                rod.from
            );
            // `length` overflows for points too far apart.
            require(length > SHORTEST_ROD * size && length.is_finite(), key, format_args!("{:?}", rod.to), allowed)?;
        }
        let most = MOST_ELEMENTS - elements;
        let allowed = format_args!("a whole number from 1 to {most} ({MOST_ELEMENTS} in all rods)");
        require((1..=most).contains(&rod.elements), format_args!("rods[{i}].elements"), rod.elements, allowed)?;
        elements += rod.elements;
        let allowed = format_args!("\"full\"; the element \"{}\" has no section for Poisson's terms", rod.element);
        let holds = rod.poisson == Poisson::Full || rod.element == Element::Ancf;
        require(holds, format_args!("rods[{i}].poisson"), format_args!("\"{}\"", rod.poisson), allowed)?;
        check_law(i, rod)?;
    }
    Ok(())
}

/// The uniaxial law is one of the paper's element, and has no Poisson's terms to be placed.
fn check_law(i: usize, rod: &Rod) -> Check {
    if rod.law == Law::PlaneStrain {
        return Ok(());
    }
    let allowed = format_args!(
        "\"plane-strain\", the default; the element \"{}\" is uniaxial anyway, with the stiffnesses EA and EI: leave `law` out",
        rod.element
    );
    require(rod.element == Element::Ancf, format_args!("rods[{i}].law"), format_args!("\"{}\"", rod.law), allowed)?;
    let allowed = format_args!(
        "\"full\", the default, beside \"law\": \"{}\", which has no Poisson's terms: leave one of the two keys out",
        rod.law
    );
    require(
        rod.poisson == Poisson::Full,
        format_args!("rods[{i}].poisson"),
        format_args!("\"{}\"", rod.poisson),
        allowed,
    )
}

/// Checks pivots: each is a point of its own at the middle of at least two rods, and needs a node there.
fn check_pivots(scene: &Scene) -> Check {
    let mut pivots: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (i, rod) in scene.rods.iter().enumerate() {
        if let Some(pivot) = &rod.pivot {
            let key = format_args!("rods[{i}].pivot");
            check_name(key, pivot)?;
            let allowed = "a name that no point in `points` has, since a pivot is the middle of rods";
            require(!scene.points.contains_key(pivot), key, format_args!("{pivot:?}"), allowed)?;
            let has_node = rod.elements.is_multiple_of(2) || rod.element == Element::Ancf;
            let allowed = format_args!(
                "an even number: the element \"{}\" has no node in its middle, where the pivot `{pivot}` is",
                rod.element
            );
            require(has_node, format_args!("rods[{i}].elements"), rod.elements, allowed)?;
            pivots.entry(pivot).or_default().push(i);
        }
    }
    for (pivot, rods) in pivots {
        let Some((&first, others)) = rods.split_first() else { continue };
        let allowed = "a name that at least two rods have as their `pivot`";
        require(!others.is_empty(), format_args!("rods[{first}].pivot"), format_args!("{pivot:?}"), allowed)?;
        for &other in others {
            check_same_middle(scene, &scene.rods[first], &scene.rods[other], format_args!("rods[{other}].pivot"))?;
        }
    }
    Ok(())
}

fn check_same_middle(scene: &Scene, first: &Rod, other: &Rod, key: impl Display) -> Check {
    let (Some(a), Some(b)) = (scene.middle(first), scene.middle(other)) else { return Ok(()) };
    let (first_name, other_name) = (&first.name, &other.name);
    let allowed = format_args!(
        "rods whose middles are at one place: `{first_name}` has its middle at {a:?}, `{other_name}` at {b:?}"
    );
    let holds = (a[0] - b[0]).hypot(a[1] - b[1]) <= PIVOT_TOLERANCE * scene.length(first).min(scene.length(other));
    require(holds, key, format_args!("{:?}", other.pivot.as_deref().unwrap_or_default()), allowed)
}

/// Refuses names with characters that have a meaning in key paths (`points.a`) or in the header of a CSV file, and those that a spreadsheet
/// would take for a formula.
pub(in crate::model) fn check_name(key: impl Display, name: &str) -> Check {
    let refused = |c: char| c.is_control() || ".,;[]\"`".contains(c);
    let holds =
        !name.is_empty() && name.trim() == name && !name.contains(refused) && !name.starts_with(['=', '+', '-', '@']);
    let allowed = "a name without . , ; [ ] \" ` and without spaces at its ends, that does not begin with = + - @";
    require(holds, key, format_args!("{name:?}"), allowed)
}

/// Refuses a name that no point has.
fn check_point(scene: &Scene, key: impl Display, name: &str) -> Check {
    if scene.points.contains_key(name) {
        return Ok(());
    }
    let known = || scene.points.keys().map(String::as_str);
    let allowed = format!("the name of a point in `points` ({}){}", list_names(known()), or_nearest(name, known()));
    require(false, key, format_args!("{name:?}"), allowed)
}

/// Refuses a name that neither a point nor a pivot has.
pub(in crate::model) fn check_node(scene: &Scene, key: impl Display, name: &str) -> Check {
    if scene.position(name).is_some() {
        return Ok(());
    }
    let pivots: BTreeSet<&str> = scene.rods.iter().filter_map(|rod| rod.pivot.as_deref()).collect();
    let known = || scene.points.keys().map(String::as_str).chain(pivots.iter().copied());
    let nearest = or_nearest(name, known());
    let advice = if nearest.is_empty() { "; where a point was taken away, what stands at it goes too" } else { "" };
    let allowed =
        format!("the name of a point in `points` or of a rod's pivot ({}){nearest}{advice}", list_names(known()));
    require(false, key, format_args!("{name:?}"), allowed)
}

/// Names in a list, or the first few.
fn list_names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    let more = if names.len() > MOST_NAMES { ", …" } else { "" };
    match names.len() {
        0 => "there is none".into(),
        n => names[..n.min(MOST_NAMES)].join(", ") + more,
    }
}

/// Refuses a name that no rod has, or a rod without a node at `point`, if given.
pub(in crate::model) fn check_rod(scene: &Scene, key: impl Display, name: &str, point: Option<&str>) -> Check {
    let Some(rod) = scene.rods.iter().find(|rod| rod.name == name) else {
        let known = || scene.rods.iter().map(|rod| rod.name.as_str());
        let allowed = format!("the name of a rod ({}){}", list_names(known()), or_nearest(name, known()));
        return require(false, key, format_args!("{name:?}"), allowed);
    };
    let Some(point) = point else { return Ok(()) };
    let allowed = format_args!("a rod that has `{point}` as its `from`, `to` or `pivot`");
    require(rod.has_node(point), key, format_args!("{name:?}"), allowed)
}

/// Refuses an empty list, and a list with a word twice.
pub(in crate::model) fn check_list(key: impl Display, words: impl ExactSizeIterator<Item = &'static str>) -> Check {
    require(words.len() > 0, &key, "[]", "at least one entry")?;
    let mut seen = BTreeSet::new();
    for (i, word) in words.enumerate() {
        require(seen.insert(word), format_args!("{key}[{i}]"), format_args!("{word:?}"), "each word once")?;
    }
    Ok(())
}

/// Refuses a name that an earlier entry of `list` has under the same `key`.
pub(in crate::model) fn unique<'a>(list: &str, key: &str, names: impl Iterator<Item = &'a str>) -> Check {
    let mut seen = BTreeMap::new();
    for (i, name) in names.enumerate() {
        if let Some(first) = seen.insert(name, i) {
            let allowed = format_args!("each name once; {list}[{first}] has this one");
            return require(false, format_args!("{list}[{i}].{key}"), format_args!("{name:?}"), allowed);
        }
    }
    Ok(())
}
