//! Mistakes in supports and joints.

use ancf::model::{Direction, Rod, Scene, Support};

use crate::trajectory::mistake::{Add, CONSTRAINTS};
use crate::trajectory::setup::{Joint, Setup};

/// Supports lost, one-sided, clamped, hinged, elsewhere.
pub fn supports(scene: &Scene, add: &mut Add) {
    for (n, support) in scene.supports.iter().enumerate() {
        let point = &support.point;
        let change = |setup: &mut Setup, change: &dyn Fn(&mut Support)| change(&mut setup.scene.supports[n]);
        let rod = scene.rods.iter().find(|rod| rod.from == *point || rod.to == *point);
        add(&format!("{point} is not held"), CONSTRAINTS, &|setup| _ = setup.scene.supports.remove(n));
        if support.fix.len() == 2 {
            add(&format!("{point} is held along x only"), CONSTRAINTS, &|setup| {
                change(setup, &|s| s.fix = vec![Direction::X])
            });
            add(&format!("{point} is held along y only"), CONSTRAINTS, &|setup| {
                change(setup, &|s| s.fix = vec![Direction::Y])
            });
        }
        if let Some([x, y]) = support.slide {
            let slides = [
                ("across its direction", Some([-y, x]), vec![]),
                ("along its direction mirrored in x", Some([x, -y]), vec![]),
                ("along x", Some([1.0, 0.0]), vec![]),
                ("along y", Some([0.0, 1.0]), vec![]),
                ("not at all: it is held in both directions", None, vec![Direction::X, Direction::Y]),
            ];
            for (what, slide, fix) in slides {
                add(&format!("{point} slides {what}"), CONSTRAINTS, &|setup| {
                    change(setup, &|support| (support.slide, support.fix) = (slide, fix.clone()));
                });
            }
        }
        if support.clamp.is_some() {
            add(&format!("{point} is hinged in place of clamped"), CONSTRAINTS, &|setup| {
                change(setup, &|s| s.clamp = None)
            });
        } else if let Some(rod) = rod {
            add(&format!("{point} is clamped: the section keeps its direction"), CONSTRAINTS, &|setup| {
                change(setup, &|support| support.clamp = Some(rod.name.clone()));
            });
        }
        add(&format!("all of the section's vector is held at {point}"), CONSTRAINTS, &|setup| {
            setup.held_section = Some(point.clone());
        });
        if let Some(rod) = rod {
            let other = if rod.from == *point { &rod.to } else { &rod.from };
            add(&format!("{other} is held in place of {point}"), CONSTRAINTS, &|setup| {
                change(setup, &|support| support.point.clone_from(other));
            });
            if support.clamp.is_none() {
                add(&format!("{other} is held as well as {point}"), CONSTRAINTS, &|setup| {
                    let mut second = support.clone();
                    second.point.clone_from(other);
                    setup.scene.supports.push(second);
                });
            }
        }
    }
}

/// Joints open, one-sided, welded.
pub fn joints(scene: &Scene, add: &mut Add) {
    let meeting = |point: &str| {
        let has = |rod: &&Rod| rod.from == point || rod.to == point || rod.pivot.as_deref() == Some(point);
        scene.rods.iter().filter(has).count()
    };
    let pivots = scene.rods.iter().filter_map(|rod| rod.pivot.clone());
    let mut points: Vec<String> =
        scene.points.keys().cloned().chain(pivots).filter(|point| meeting(point) > 1).collect();
    points.sort();
    points.dedup();
    for point in points {
        for (joint, what) in [
            (Joint::Open, "are not pinned"),
            (Joint::OnlyX, "are pinned along x only"),
            (Joint::OnlyY, "are pinned along y only"),
            (Joint::Welded, "are welded: they keep their angle"),
        ] {
            add(&format!("the rods at {point} {what}"), CONSTRAINTS, &|setup| {
                setup.joint = Some((point.clone(), joint))
            });
        }
    }
}
