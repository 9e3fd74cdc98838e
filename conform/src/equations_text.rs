//! Listing of every equation's value in one state, for debugging by eye.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use ancf::internals::equations::{CONTENTS, Entry, Form};
use ancf::internals::state::evaluate_system;
use ancf::state::{ThermalModel, evaluate, evaluate_cable};

use crate::error::{Error, Result};
use crate::suite::{Length, Per, Quantity, State, Suite};

/// Number of digits after the decimal point.
const DIGITS: usize = 9;
/// Length of a row of numbers that belong to the coordinates or constraints of a structure.
const STRUCTURE_ROW: usize = 14;

const ELEMENT_HEAD: &str = "Values in SI units. Rows and columns of e in the order of (4): r_i r_y_i r_j r_x_j r_y_j r_k r_y_k, x before y.\n\
     Strains, stresses and S_a, S_b, S_c in global axes. Quantities of a point are listed for each point (x, y) in the element's axes.\n";
const CABLE_HEAD: &str = "Values in SI units. Rows and columns of e in the order r_i r_x_i r_k r_x_k, x before y. Quantities of a point are listed for\n\
     each point (x, 0) on the axis.\n";
const STRUCTURE_HEAD: &str = "Values in SI units, from the terms of (23) that are stored with the case: m, k q, f and Phi_q. One number for each coordinate.\n";

/// Lists every quantity of a state in the paper's order: its function, its form, and its numbers row by row. `name` is that of the state
/// in messages.
///
/// # Errors
/// [`Error::NotFinite`] for a state whose numbers lead out of the range of f64; [`Error::Suite`] if the embedded fixtures, which describe
/// the quantities, are malformed.
pub fn equations_text(state: &State, name: &str) -> Result<String> {
    let quantities = quantities()?;
    let (head, points): (&str, &[[f64; 2]]) = match state {
        State::Element(state) => (ELEMENT_HEAD, &state.points),
        State::Cable(state) => (CABLE_HEAD, &state.points),
        State::System(_) => (STRUCTURE_HEAD, &[]),
    };
    let (mut body, mut not_finite) = (String::new(), Vec::new());
    for entry in CONTENTS.iter().filter(|entry| applies(entry, state)) {
        let number = if entry.equation.is_empty() { String::new() } else { format!("({}) ", entry.equation) };
        let form = match entry.form {
            Form::AsPrinted => "",
            Form::Consistent => "  [consistent]",
            Form::Printed => "  [with the printed error]",
            Form::Beyond => "  [not in the paper]",
        };
        body += &format!("\n{number}{}  {}{form}\n", entry.quantity, entry.function);
        let Some(numbers) = value(state, entry.quantity) else {
            body += "  has no value in this state\n";
            continue;
        };
        if numbers.iter().any(|number| !number.is_finite()) {
            not_finite.push(entry.quantity);
        }
        let quantity = quantities.get(entry.reference);
        let row = quantity.map_or(1, row_length);
        if quantity.is_some_and(|quantity| quantity.per == Some(Per::Point)) {
            let size = numbers.len() / points.len().max(1);
            for (numbers, [x, y]) in numbers.chunks(size.max(1)).zip(points) {
                body += &format!("  at ({x}, {y})\n{}", lines(numbers, row));
            }
        } else {
            body += &lines(&numbers, row);
        }
    }
    if !not_finite.is_empty() {
        return Err(Error::NotFinite { name: name.into(), quantities: not_finite.join(", ") });
    }
    Ok(format!("{head}{body}"))
}

/// What the embedded fixtures say of each quantity, read once.
fn quantities() -> Result<&'static BTreeMap<String, Quantity>> {
    static KNOWN: OnceLock<BTreeMap<String, Quantity>> = OnceLock::new();
    match KNOWN.get() {
        Some(known) => Ok(known),
        None => {
            let read = Suite::embedded()?.quantities;
            Ok(KNOWN.get_or_init(|| read))
        }
    }
}

/// Whether a quantity exists in a state. Of the two thermal strains only that of the state's model does.
fn applies(entry: &Entry, state: &State) -> bool {
    match state {
        State::Element(state) => match entry.function {
            "strain::eps_T" => state.model == ThermalModel::TwoD,
            "strain::eps_T_1d" => matches!(state.model, ThermalModel::OneD | ThermalModel::Transverse),
            _ => !entry.is_of_a_structure() && !entry.is_of_a_cable(),
        },
        State::Cable(_) => entry.is_of_a_cable(),
        State::System(_) => entry.is_of_a_structure(),
    }
}

fn value(state: &State, quantity: &str) -> Option<Vec<f64>> {
    match state {
        State::Element(state) => evaluate(quantity, state),
        State::Cable(state) => evaluate_cable(quantity, state),
        State::System(state) => evaluate_system(quantity, state),
    }
}

/// Length of a row of the quantity's matrix.
fn row_length(quantity: &Quantity) -> usize {
    match quantity.shape.last() {
        Some(Length::Fixed(length)) => *length,
        Some(Length::Letter(_)) => STRUCTURE_ROW,
        None => 1,
    }
}

/// Lines of numbers. A zero has neither sign nor digits, so that the other numbers stand out.
fn lines(numbers: &[f64], row: usize) -> String {
    let number = |value: &f64| if *value == 0.0 { "0".into() } else { format!("{value:.DIGITS$e}") };
    let line = |row: &[f64]| {
        let cells: String = row.iter().map(|value| format!(" {:>17}", number(value))).collect();
        format!(" {cells}\n")
    };
    numbers.chunks(row).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_are_not_finite_are_refused_by_name() {
        let State::Element(mut state) = Suite::embedded().unwrap().cases.remove(0).state else { panic!() };
        let listed =
            |state: &ancf::state::ElementState| equations_text(&State::Element(Box::new(state.clone())), "mine.json");
        assert!(listed(&state).is_ok());
        state.e[0] = 1e200;
        let message = listed(&state).unwrap_err().to_string();
        assert!(
            message.starts_with("mine.json: ") && message.contains("19.Q_e") && !message.contains("7.M"),
            "{message}"
        );
    }
}
