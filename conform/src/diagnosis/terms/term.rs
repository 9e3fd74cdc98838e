//! A term of an equation.

use ancf::state::ElementState;

/// A term of a quantity in one case.
pub(crate) struct Term {
    /// The term in words, equal in all cases.
    pub name: String,
    /// Entries of the term, one for each entry of the quantity.
    pub numbers: Vec<f64>,
    /// Whether the correct equation has the term. Otherwise it is one that is often added by mistake.
    pub belongs: bool,
}

/// Term of the correct equation.
pub(crate) fn term(name: impl Into<String>, numbers: Vec<f64>) -> Term {
    Term { name: name.into(), numbers, belongs: true }
}

/// Term that is often added by mistake.
pub(crate) fn foreign(name: impl Into<String>, numbers: Vec<f64>) -> Term {
    Term { belongs: false, ..term(name, numbers) }
}

/// Terms of a quantity of a point: `at` gives the numbers of each term at one point.
pub(crate) fn at_points(state: &ElementState, names: &[&str], at: impl Fn(f64, f64) -> Vec<Vec<f64>>) -> Vec<Term> {
    let points: Vec<Vec<Vec<f64>>> = state.points.iter().map(|&[x, y]| at(x, y)).collect();
    let of = |k: usize| points.iter().filter_map(|terms| terms.get(k)).flatten().copied().collect();
    names.iter().enumerate().map(|(k, name)| term(*name, of(k))).collect()
}
