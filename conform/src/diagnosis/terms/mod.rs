//! Each equation as the terms that it adds up.

mod force;
mod motion;
mod shape;
mod strain;

use super::places::{own_shape, place};
use super::reading::VECTORS;
use crate::suite::{Case, Parsed, Reference};
use ancf::state::ElementState;

/// A term of a quantity in one case.
pub(super) struct Term {
    /// In words; the same in every case.
    pub name: String,
    /// Its numbers, as many as the quantity has.
    pub numbers: Vec<f64>,
    /// Whether the right quantity has it; otherwise it is one that is often added.
    pub there: bool,
}

fn term(name: impl Into<String>, numbers: Vec<f64>) -> Term {
    Term { name: name.into(), numbers, there: true }
}

fn foreign(name: impl Into<String>, numbers: Vec<f64>) -> Term {
    Term { name: name.into(), numbers, there: false }
}

/// The terms of the formula.
pub(super) fn of(quantity: &str, case: &Case) -> Vec<Term> {
    match &case.parsed {
        Parsed::Element(state) => {
            let mut all = shape::of(quantity, state);
            all.extend(strain::of(quantity, state));
            all.extend(force::of(quantity, state));
            all.extend(motion::of(quantity, state));
            all
        }
        Parsed::System(system) => motion::of_system(quantity, system),
        Parsed::Cable(_) => Vec::new(),
    }
}

/// All of a quantity, each of its entries, and the entries of each nodal vector.
pub(super) fn parts(quantity: &str, reference: &Reference) -> Vec<Term> {
    let shape = own_shape(quantity, reference);
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
        _ if size <= 9 => (0..size).for_each(|entry| add(format!("entry {}", place(entry, shape)), &|n| n == entry)),
        _ => {}
    }
    if shape.last() == Some(&2) || *shape == [14] {
        for (component, name) in ["x", "y"].into_iter().enumerate() {
            add(format!("the components along {name}"), &|n| n % 2 == component);
        }
    }
    if let [14, 14] = *shape {
        add("the diagonal".into(), &|n| n / 14 == n % 14);
        add("what is not on the diagonal".into(), &|n| n / 14 != n % 14);
    }
    all
}

/// Terms at each point: of the function's list the numbers of each term, one point after the other.
fn at_points(state: &ElementState, names: &[&str], at: impl Fn(f64, f64) -> Vec<Vec<f64>>) -> Vec<Term> {
    let points: Vec<Vec<Vec<f64>>> = state.points.iter().map(|&[x, y]| at(x, y)).collect();
    let of = |k: usize| points.iter().filter_map(|terms| terms.get(k)).flatten().copied().collect();
    names.iter().enumerate().map(|(k, name)| term(*name, of(k))).collect()
}
