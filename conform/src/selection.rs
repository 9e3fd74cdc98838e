//! What is asked: everything, or a part that the user chose.

use std::collections::BTreeSet;

use ancf::internals::model::nearest;

use crate::error::{Error, Result};
use crate::graph::{GRAPH, equation};
use crate::suite::Suite;

/// Quantities and states that are asked for; everything by default.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    quantities: Option<BTreeSet<&'static str>>,
    states: Option<BTreeSet<String>>,
}

impl Selection {
    /// Selects quantities by their names or the first parts of them, such as `21.K_1`, `21` or `cable`, and states by their names. An
    /// empty list selects all.
    ///
    /// # Errors
    /// [`Error::NoQuantity`] and [`Error::NoSuchState`] for a name that selects nothing, with the nearest one; [`Error::NothingAsked`] if no
    /// selected state has a selected quantity.
    pub fn new(suite: &Suite, quantities: &[String], states: &[String]) -> Result<Selection> {
        let mut selection = Selection::default();
        for name in quantities {
            let chosen: Vec<_> = GRAPH.iter().map(|node| node.quantity).filter(|id| is_in(id, name)).collect();
            if chosen.is_empty() {
                return Err(unknown_quantity(name));
            }
            selection.quantities.get_or_insert_default().extend(chosen);
        }
        let known: Vec<&str> = suite
            .cases
            .iter()
            .map(|case| &case.id)
            .chain(suite.invalid.iter().map(|case| &case.id))
            .map(String::as_str)
            .collect();
        for name in states {
            if !known.contains(&name.as_str()) {
                let nearest = nearest_name(name, known.iter().copied());
                return Err(Error::NoSuchState { name: name.clone(), nearest, known: known.join(", ") });
            }
            selection.states.get_or_insert_default().insert(name.clone());
        }
        let asked = suite.cases.iter().any(|case| {
            selection.has_state(&case.id)
                && GRAPH
                    .iter()
                    .any(|node| selection.has_quantity(node.quantity) && case.values.contains_key(node.quantity))
        });
        let refused = |id: &str, quantity: &str| selection.has_state(id) && selection.has_quantity(quantity);
        if asked || suite.invalid.iter().any(|case| refused(&case.id, &case.equation)) {
            return Ok(selection);
        }
        Err(Error::NothingAsked { quantities: quantities.join(", "), states: states.join(", ") })
    }

    /// Whether a quantity is asked for.
    pub fn has_quantity(&self, quantity: &str) -> bool {
        self.quantities.as_ref().is_none_or(|chosen| chosen.contains(quantity))
    }

    /// Whether quantities are asked for in a state.
    pub fn has_state(&self, id: &str) -> bool {
        self.states.as_ref().is_none_or(|chosen| chosen.contains(id))
    }

    /// Whether everything is asked.
    pub fn is_everything(&self) -> bool {
        *self == Selection::default()
    }
}

/// Whether a quantity has a name, or a part of its name before a dot.
fn is_in(quantity: &str, name: &str) -> bool {
    quantity.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

fn unknown_quantity(name: &str) -> Error {
    let quantities = GRAPH.iter().map(|node| node.quantity);
    let equations: BTreeSet<&str> = quantities.clone().map(equation).collect();
    let nearest = nearest_name(name, quantities.chain(equations.iter().copied()));
    Error::NoQuantity { name: name.into(), nearest, known: equations.into_iter().collect::<Vec<_>>().join(", ") }
}

fn nearest_name<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map(|like| format!("; nearest: `{like}`")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn selected(quantities: &[&str], states: &[&str]) -> Result<Selection> {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_string()).collect::<Vec<_>>();
        Selection::new(&Suite::embedded().unwrap(), &owned(quantities), &owned(states))
    }

    #[test]
    fn quantities_are_selected_by_name_or_by_its_first_parts() {
        let chosen = |name: &str| {
            let selection = selected(&[name], &[]).unwrap();
            GRAPH.iter().filter(|node| selection.has_quantity(node.quantity)).count()
        };
        assert_eq!((chosen("21.K_1"), chosen("21"), chosen("A.3"), chosen("A")), (1, 6, 1, 6));
        assert_eq!(chosen("cable"), GRAPH.iter().filter(|node| node.quantity.starts_with("cable.")).count());
        assert!(selected(&[], &[]).unwrap().is_everything());
    }

    #[test]
    fn unknown_names_are_errors_with_the_nearest() {
        let message = |result: Result<Selection>| result.unwrap_err().to_string();
        assert!(message(selected(&["21.K1"], &[])).contains("nearest: `21.K_1`"));
        assert!(message(selected(&["cabel"], &[])).contains("nearest: `cable`"));
        assert!(message(selected(&["2.K_1"], &[])).contains("no quantity `2.K_1`"));
        assert!(message(selected(&[], &["rest-vertcal"])).contains("nearest: `rest-vertical`"));
        assert!(message(selected(&["cable"], &["rest-vertical"])).contains("nothing is asked"));
    }
}
