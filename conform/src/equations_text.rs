//! Every equation's value for one state, for people who debug by eye.

use crate::suite::Parsed;
use ancf::equations::{CONTENTS, Entry, Form};
use ancf::state::{CableState, ElementState, ThermalModel, evaluate, evaluate_cable, evaluate_system};

/// Digits that are shown.
const DIGITS: usize = 9;

const OF_AN_ELEMENT: &str = "Values in SI units; rows and columns of e in the order of (4): r_i r_y_i r_j r_x_j r_y_j r_k r_y_k, x before y.\n\
     Strains, stresses and S_a, S_b, S_c in global axes. What varies over the element stands point by point, (x, y) in its own axes.\n";
const OF_A_CABLE: &str = "Values in SI units; rows and columns of e in the order r_i r_x_i r_k r_x_k, x before y. What varies over the element stands\n\
     point by point, (x, 0) along it.\n";
const OF_A_STRUCTURE: &str = "Values in SI units, from the terms of (23) that are stored with the case: m, k q, f and Phi_q; one number for each coordinate.\n";

/// Every quantity of a state in the paper's order: its function, its form, and its numbers row by row. A warning at the top names those
/// that are not finite.
pub fn equations_text(state: &Parsed) -> String {
    let head = match state {
        Parsed::Element(_) => OF_AN_ELEMENT,
        Parsed::Cable(_) => OF_A_CABLE,
        Parsed::System(_) => OF_A_STRUCTURE,
    };
    let nowhere = without_points(state);
    let (mut body, mut overflown) = (String::new(), Vec::new());
    for entry in CONTENTS.iter().filter(|entry| is_of(entry, state)) {
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
            overflown.push(entry.quantity);
        }
        let row = row_length(entry.reference);
        // What varies over the element has no numbers where there are no points.
        match nowhere.as_ref().and_then(|nowhere| value(nowhere, entry.quantity)) {
            Some(none) if none.is_empty() => {
                let points = points(state);
                for (numbers, [x, y]) in numbers.chunks(numbers.len() / points.len()).zip(points) {
                    body += &format!("  at ({x}, {y})\n{}", lines(numbers, row));
                }
            }
            _ => body += &lines(&numbers, row),
        }
    }
    let warning = match &overflown[..] {
        [] => String::new(),
        names => format!(
            "\nWARNING: the state's numbers are too large or too small to compute with: not finite are {}.\n",
            names.join(", ")
        ),
    };
    format!("{head}{warning}{body}")
}

/// Whether a quantity is one of such a state; of the two thermal strains the model's own, and where there is no heat neither.
fn is_of(entry: &Entry, state: &Parsed) -> bool {
    match state {
        Parsed::Element(state) => match entry.function {
            "strain::eps_T" => state.model == ThermalModel::TwoD,
            "strain::eps_T_1d" => state.model == ThermalModel::OneD,
            _ => !entry.is_of_a_structure() && !entry.is_of_a_cable(),
        },
        Parsed::Cable(_) => entry.is_of_a_cable(),
        Parsed::System(_) => entry.is_of_a_structure(),
    }
}

fn value(state: &Parsed, quantity: &str) -> Option<Vec<f64>> {
    match state {
        Parsed::Element(state) => evaluate(quantity, state),
        Parsed::Cable(state) => evaluate_cable(quantity, state),
        Parsed::System(state) => evaluate_system(quantity, state),
    }
}

fn points(state: &Parsed) -> &[[f64; 2]] {
    match state {
        Parsed::Element(state) => &state.points,
        Parsed::Cable(state) => &state.points,
        Parsed::System(_) => &[],
    }
}

/// The same state, looked at nowhere.
fn without_points(state: &Parsed) -> Option<Parsed> {
    let points = Vec::new();
    match state {
        Parsed::Element(state) => Some(Parsed::Element(Box::new(ElementState { points, ..(**state).clone() }))),
        Parsed::Cable(state) => Some(Parsed::Cable(Box::new(CableState { points, ..(**state).clone() }))),
        Parsed::System(_) => None,
    }
}

/// Numbers in a row of the quantity's matrix.
fn row_length(quantity: &str) -> usize {
    if let Some(name) = quantity.strip_prefix("cable.") {
        return match name {
            "S" | "S_x" | "S_xx" => 4,
            "r" | "r_x" | "r_xx" => 2,
            "epsilon" | "kappa" | "T" | "U" => 1,
            _ => 8,
        };
    }
    if quantity.starts_with("23.") {
        return 14;
    }
    let (_, name) = quantity.rsplit_once('.').unwrap_or(("", quantity));
    match name.split('/').next().unwrap_or(name) {
        "r" | "r_x" | "r_y" | "rdot" | "nodes" | "J" | "J_0" | "epsilon_m" | "coefficients" => 2,
        "epsilon" | "epsilon_f" | "epsilon_T" | "sigma" | "D" | "D_0" => 3,
        "S" if quantity.starts_with('3') => 7,
        "S_x" | "S_y" => 7,
        "epsilon_1" | "epsilon_2" | "epsilon_3" | "lambda" | "mu" | "U" | "T" => 1,
        _ => 14,
    }
}

/// Lines of numbers; a zero without sign and digits, so that the others stand out.
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
    use crate::suite::Suite;

    #[test]
    fn values_that_overflow_are_told_at_the_top() {
        let Parsed::Element(mut state) = Suite::embedded().unwrap().cases.remove(0).parsed else { panic!() };
        let text = |state: &ancf::state::ElementState| equations_text(&Parsed::Element(Box::new(state.clone())));
        assert!(!text(&state).contains("WARNING"));
        state.e[0] = 1e200;
        let text = text(&state);
        let head: Vec<&str> = text.lines().take(4).collect();
        assert!(head[3].starts_with("WARNING: ") && head[3].contains("19.Q_e") && !head[3].contains("7.M"), "{head:?}");
    }
}
