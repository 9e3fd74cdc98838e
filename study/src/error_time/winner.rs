//! The fastest points of a group for an accuracy, ours and another program's: what is published.

use serde::Serialize;

use super::group::Group;
use super::pareto::Ratio;
use super::point::Point;

/// The fastest points that are certain to be as accurate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Winner {
    /// The scene.
    pub scene: &'static str,
    /// The element.
    pub element: &'static str,
    /// The label: errors are below it at every time, m.
    pub below: f64,
    /// Our fastest point, in words.
    pub what: String,
    /// Upper bound of its error at any time, m.
    pub bound: f64,
    /// The point.
    pub ours: Point,
    /// The other program's fastest point.
    pub theirs: Option<Point>,
    /// Its time over ours.
    pub ratio: Option<Ratio>,
}

/// The winners of all groups.
pub fn winners(groups: &[Group]) -> Vec<Winner> {
    let of = |group: &Group| {
        let found = group.decades().into_iter().filter_map(|(below, point)| {
            let ours = point?.clone();
            let bound = ours.bound()?;
            let (theirs, ratio) = (group.peer(below).cloned(), group.ratio(below));
            Some(Winner {
                scene: group.scene,
                element: group.element,
                below,
                what: ours.what(),
                bound,
                ours,
                theirs,
                ratio,
            })
        });
        found.collect::<Vec<_>>()
    };
    groups.iter().flat_map(of).collect()
}
