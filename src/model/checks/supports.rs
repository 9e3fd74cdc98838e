//! Checks of supports: existing points and rods, and no direction held twice.

use std::collections::BTreeMap;

use super::topology::{check_list, check_node, check_rod};
use crate::model::check::{Check, finite, require};
use crate::model::json::words::Words;
use crate::model::scene::Scene;
use crate::model::supports::Support;

/// Sine of the largest angle between directions that count as parallel.
const PARALLEL: f64 = 1e-9;

/// Checks the supports, each by itself and against the others.
pub(in crate::model) fn check_supports(scene: &Scene) -> Check {
    let mut points: BTreeMap<&str, HeldPoint> = BTreeMap::new();
    for (i, support) in scene.supports.iter().enumerate() {
        check_support(scene, i, support)?;
        points.entry(&support.point).or_default().add(i, support)?;
    }
    Ok(())
}

fn check_support(scene: &Scene, i: usize, support: &Support) -> Check {
    let Support { point, fix, slide, clamp } = support;
    check_node(scene, format_args!("supports[{i}].point"), point)?;
    if !fix.is_empty() || (slide.is_none() && clamp.is_none()) {
        let key = format_args!("supports[{i}].fix");
        require(!fix.is_empty(), key, "missing", "at least one entry, or `slide` or `clamp` in its place")?;
        check_list(key, fix.iter().map(|direction| direction.word()))?;
    }
    if let Some(direction) = slide {
        for (axis, &component) in direction.iter().enumerate() {
            finite(format_args!("supports[{i}].slide[{axis}]"), component)?;
        }
        let (holds, key) = (*direction != [0.0, 0.0], format_args!("supports[{i}].slide"));
        require(holds, key, format_args!("{direction:?}"), "a direction that is not zero")?;
    }
    match clamp {
        Some(rod) => check_rod(scene, format_args!("supports[{i}].clamp"), rod, Some(point)),
        None => Ok(()),
    }
}

/// Directions and sections held at one point by the supports checked so far.
#[derive(Default)]
struct HeldPoint<'a> {
    /// Unit vectors along which the point is held, at most two.
    directions: Vec<HeldDirection>,
    /// Rods whose sections are clamped there, with the number of the support.
    clamps: BTreeMap<&'a str, usize>,
}

/// Unit vector along which a point is held, with its origin in the scene.
struct HeldDirection {
    direction: [f64; 2],
    /// Whether it is the normal of a slide.
    slide: bool,
    by: String,
}

impl<'a> HeldPoint<'a> {
    /// Adds support number `i`, which must hold what was free so far.
    fn add(&mut self, i: usize, support: &'a Support) -> Check {
        let Support { point, fix, slide, clamp } = support;
        for (k, axis) in fix.iter().enumerate() {
            let hold = HeldDirection { direction: axis.unit(), slide: false, by: format!("supports[{i}].fix") };
            self.hold(hold, point, format!("supports[{i}].fix[{k}]"), format!("\"{axis}\""))?;
        }
        if let (Some(slide), Some(direction)) = (*slide, support.across()) {
            let hold = HeldDirection { direction, slide: true, by: format!("supports[{i}].slide") };
            self.hold(hold, point, format!("supports[{i}].slide"), format!("{slide:?}"))?;
        }
        if let Some(rod) = clamp
            && let Some(first) = self.clamps.insert(rod, i)
        {
            let allowed = format_args!(
                "a rod that no other support clamps at `{point}`: supports[{i}] is redundant beside supports[{first}]"
            );
            require(false, format_args!("supports[{i}].clamp"), format_args!("{rod:?}"), allowed)?;
        }
        Ok(())
    }

    /// Adds one direction. In the plane a slide excludes any other: a direction parallel to its normal is redundant,
    /// every other one blocks the slide.
    fn hold(&mut self, new: HeldDirection, point: &str, key: String, value: String) -> Check {
        let [x, y] = new.direction;
        let parallel = |old: &&HeldDirection| (old.direction[0] * y - old.direction[1] * x).abs() <= PARALLEL;
        let (first, verdict) = match (self.directions.iter().find(parallel), self.directions.as_slice()) {
            // Both directions are held, the slide's among them.
            (_, [first, _]) if new.slide => (first, "contradicts"),
            (Some(first), _) => (first, "is redundant beside"),
            (None, [first, ..]) if new.slide || first.slide => (first, "contradicts"),
            // Without slides there are only x and y: after two directions no third one is possible.
            (None, _) => {
                self.directions.push(new);
                return Ok(());
            }
        };
        let (by, first) = (&new.by, &first.by);
        let allowed = format_args!("directions that no other support holds at `{point}`: {by} {verdict} {first}");
        require(false, key, value, allowed)
    }
}
