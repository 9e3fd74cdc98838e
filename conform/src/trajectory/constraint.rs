//! Constraints of pinned rods, Φ = Φ_q (q − q_0), and their elimination from the accelerations.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::collections::BTreeMap;

use ancf::model::{Direction, Support};
use nalgebra::{DMatrix, SymmetricEigen};

use super::rod::Rod;
use super::setup::{Joint, Setup};

/// A row of Φ_q: coordinates with factors.
pub type Row = Vec<(usize, f64)>;

/// A rod at a point: its number, its position there and its section's vector.
pub type Place = (usize, usize, usize);

/// Rows of the joints and supports, each a list of coordinates with factors; `None` for a name that there is not.
pub fn rows(
    setup: &Setup,
    rods: &[Rod],
    points: &BTreeMap<String, usize>,
    places: &BTreeMap<&str, Vec<Place>>,
) -> Option<Vec<Row>> {
    let mut rows = Vec::new();
    for (name, meeting) in places {
        let joint = setup.joint.as_ref().filter(|(point, _)| point == name).map(|(_, joint)| *joint);
        for pair in meeting.windows(2) {
            let [(one, at, section), (two, at_2, section_2)] = *pair else { continue };
            for component in 0..2 {
                if matches!(
                    (joint, component),
                    (Some(Joint::Open), _) | (Some(Joint::OnlyX), 1) | (Some(Joint::OnlyY), 0)
                ) {
                    continue;
                }
                rows.push(vec![(at_2 + component, 1.0), (at + component, -1.0)]);
            }
            if joint == Some(Joint::Welded) {
                let (Some(a), Some(b)) = (rods.get(one), rods.get(two)) else { continue };
                // r_y of the second rod is that of the first, turned by the initial angle between them.
                let (c, s) = (a.t[0] * b.t[0] + a.t[1] * b.t[1], a.t[0] * b.t[1] - a.t[1] * b.t[0]);
                rows.push(vec![(section_2, 1.0), (section, -c), (section + 1, s)]);
                rows.push(vec![(section_2 + 1, 1.0), (section, -s), (section + 1, -c)]);
            }
        }
    }
    for support in &setup.scene.supports {
        let at = *points.get(&support.point)?;
        // What springs hold is no constraint.
        let fixed: &[Direction] = if setup.support_springs.is_some() { &[] } else { &support.fix };
        for direction in fixed {
            rows.push(vec![(at + usize::from(*direction == Direction::Y), 1.0)]);
        }
        if let Some([x, y]) = support.slide {
            rows.push(vec![(at, -y / x.hypot(y)), (at + 1, x / x.hypot(y))]);
        }
        if let Some(name) = &support.clamp {
            let number = setup.scene.rods.iter().position(|rod| rod.name == *name)?;
            let (_, _, section) = places.get(support.point.as_str())?.iter().find(|(n, ..)| *n == number)?;
            let rod = rods.get(number)?;
            // The section's direction: r_y stays across t, a cable's r_x along it.
            let [t_x, t_y] = rod.t;
            let [x, y] = if rod.is_cable() { [-t_y, t_x] } else { [t_x, t_y] };
            rows.push(vec![(*section, x), (section + 1, y)]);
        }
    }
    if let Some(point) = &setup.held_section {
        let (_, _, section) = places.get(point.as_str())?.first()?;
        rows.extend([vec![(*section, 1.0)], vec![(section + 1, 1.0)]]);
    }
    Some(rows)
}

/// Coordinates that supports fix.
pub fn fixed(setup: &Setup, points: &BTreeMap<String, usize>) -> Vec<usize> {
    let of_support = |support: &Support| {
        let at = points.get(&support.point).copied();
        let coordinate = move |direction: &Direction| at.map(|at| at + usize::from(*direction == Direction::Y));
        support.fix.iter().filter_map(coordinate).collect::<Vec<usize>>()
    };
    setup.scene.supports.iter().flat_map(of_support).collect()
}

/// A of masses and constraint rows, each a list of coordinates with factors. Rows that follow from others are passed over.
pub fn eliminated(mass: &DMatrix<f64>, rows: &[Row]) -> Option<DMatrix<f64>> {
    let inverse = mass.clone().try_inverse()?;
    if SymmetricEigen::new(mass.clone()).eigenvalues.min() <= 0.0 {
        return None;
    }
    if rows.is_empty() {
        return Some(inverse);
    }
    let mut Phi_q = DMatrix::zeros(rows.len(), mass.nrows());
    for (n, row) in rows.iter().enumerate() {
        row.iter().for_each(|(at, factor)| Phi_q[(n, *at)] = *factor);
    }
    let by_mass = &inverse * Phi_q.transpose();
    let within = (&Phi_q * &by_mass).pseudo_inverse(1e-9).ok()?;
    Some(inverse - &by_mass * within * by_mass.transpose())
}
