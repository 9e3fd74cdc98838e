//! Every equation's value for one element state, for people who debug by eye.

use crate::equations::{CONTENTS, Form};
use crate::state::{ElementState, evaluate};

/// Digits that are shown.
const DIGITS: usize = 9;

/// The state's points, then every quantity in the paper's order: its function, its form, and its numbers row by row.
pub fn equations_text(state: &ElementState) -> String {
    let mut text = String::from(
        "Values in SI units; rows and columns of e in the order of (4): r_i r_y_i r_j r_x_j r_y_j r_k r_y_k, x before y.\n\
         Strains, stresses and S_a, S_b, S_c in global axes. What varies over the element stands point by point.\n",
    );
    for entry in CONTENTS.iter().filter(|entry| !entry.is_of_a_structure() && !entry.is_of_a_cable()) {
        let number = if entry.equation.is_empty() { String::new() } else { format!("({}) ", entry.equation) };
        let form = match entry.form {
            Form::AsPrinted => "",
            Form::Consistent => "  [corrected]",
            Form::Printed => "  [as printed, wrong]",
            Form::Beyond => "  [not in the paper]",
        };
        text += &format!("\n{number}{}  {}{form}\n", entry.quantity, entry.function);
        text += &match evaluate(entry.quantity, state) {
            Some(numbers) => values(&numbers, row_length(entry.reference)),
            None => "  has no value in this state\n".into(),
        };
    }
    text
}

/// Numbers in a row of the quantity's matrix.
fn row_length(quantity: &str) -> usize {
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
fn values(numbers: &[f64], row: usize) -> String {
    let number = |value: &f64| if *value == 0.0 { "0".into() } else { format!("{value:.DIGITS$e}") };
    let line = |row: &[f64]| {
        let cells: String = row.iter().map(|value| format!(" {:>17}", number(value))).collect();
        format!(" {cells}\n")
    };
    numbers.chunks(row).map(line).collect()
}
