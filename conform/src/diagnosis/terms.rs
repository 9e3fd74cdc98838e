//! Equations as sums of terms.

mod cable;
mod force;
mod motion;
mod points;
mod shape;
mod strain;
pub(super) mod term;

pub(super) use self::shape::POLYNOMIALS;
use self::term::{Term, term};
use super::entries::entry_name;
use super::layout::VECTORS;
use crate::suite::{Case, Reference, State};

/// Terms of a quantity's equation in one case.
pub(super) fn of(quantity: &str, case: &Case) -> Vec<Term> {
    match &case.state {
        State::Element(state) => {
            [shape::of, strain::of, force::of, motion::of].into_iter().flat_map(|of| of(quantity, state)).collect()
        }
        State::System(system) => motion::of_system(quantity, system),
        State::Cable(state) => cable::of(quantity, state),
    }
}

/// Shares of the Gauss points in an integral.
pub(super) fn of_points(quantity: &str, case: &Case) -> Vec<Term> {
    match &case.state {
        State::Element(state) => points::of(quantity, state),
        _ => Vec::new(),
    }
}

/// Parts of a value as terms: all of it, its entries or rows, and the entries of each nodal vector.
pub(super) fn parts(reference: &Reference) -> Vec<Term> {
    let shape = reference.shape_at_a_point();
    let size = shape.iter().product::<usize>().max(1);
    let mut all = vec![term("all of it", reference.numbers.clone())];
    let mut add = |name: String, of: &dyn Fn(usize) -> bool| {
        let entries = reference.numbers.iter().enumerate();
        all.push(term(name, entries.map(|(n, value)| if of(n % size) { *value } else { 0.0 }).collect()));
    };
    match *shape {
        [] => {}
        [14] => VECTORS.iter().enumerate().for_each(|(k, name)| add(format!("the entries of {name}"), &|n| n / 2 == k)),
        [14, 14] | [2, 14] => VECTORS.iter().enumerate().for_each(|(k, name)| {
            add(format!("the columns of {name}"), &|n| n % 14 / 2 == k);
            add(format!("rows and columns of {name}"), &|n| n % 14 / 2 == k || n / 28 == k);
        }),
        [_, 2] if size > 4 => (0..size / 2).for_each(|row| add(format!("row {}", row + 1), &|n| n / 2 == row)),
        _ if size <= 9 => {
            (0..size).for_each(|entry| add(format!("entry {}", entry_name(entry, shape)), &|n| n == entry))
        }
        _ => {}
    }
    if shape.last() == Some(&2) || *shape == [14] {
        for (component, name) in ["x", "y"].into_iter().enumerate() {
            add(format!("the components along {name}"), &|n| n % 2 == component);
        }
    }
    if let [n, columns] = *shape
        && n == columns
        && n >= 8
    {
        for (component, name) in ["x", "y"].into_iter().enumerate() {
            add(format!("the entries between components along {name}"), &|entry| {
                entry / n % 2 == component && entry % n % 2 == component
            });
        }
    }
    if let [14, 14] = *shape {
        add("the diagonal".into(), &|n| n / 14 == n % 14);
        add("all off the diagonal".into(), &|n| n / 14 != n % 14);
    }
    all
}
