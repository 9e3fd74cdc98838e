//! Mistakes in the order of things: nodal vectors, their x and y, rows and columns.

use super::{Candidate, Kind, candidate, own_shape};
use crate::conformance::suite::{Case, Parsed, Reference};
use crate::state::{ElementState, evaluate};

/// Orders in which a program may keep the seven vectors of (4): place in its e → place in (4).
const ORDERS: [(&str, [usize; 7]); 6] = [
    ("k before i", [5, 6, 2, 3, 4, 0, 1]),
    ("the ends first, then the middle: i, k, j", [0, 1, 5, 6, 2, 3, 4]),
    ("the middle first: j, i, k", [2, 3, 4, 0, 1, 5, 6]),
    ("positions first, then slopes", [0, 2, 5, 3, 1, 4, 6]),
    ("r_y_j before r_x_j", [0, 1, 2, 4, 3, 5, 6]),
    ("slopes before positions", [1, 0, 3, 4, 2, 6, 5]),
];

/// Orders of the 14 coordinates.
fn coordinate_orders() -> Vec<(Kind, String, [usize; 14])> {
    let vectors = |order: [usize; 7]| std::array::from_fn(|n| 2 * order[n / 2] + n % 2);
    let inverse = |order: [usize; 7]| std::array::from_fn(|n| order.iter().position(|place| *place == n).unwrap_or(n));
    let mut orders = Vec::new();
    for (what, order) in ORDERS {
        orders.push((Kind::NodeOrder, what.to_string(), vectors(order)));
        let back: [usize; 7] = inverse(order);
        if back != order {
            orders.push((Kind::NodeOrder, format!("{what}, the other way round"), vectors(back)));
        }
    }
    orders.push((Kind::XyOrder, "y before x".into(), std::array::from_fn(|n| n ^ 1)));
    orders.push((Kind::XyOrder, "all x, then all y".into(), std::array::from_fn(|n| 2 * (n % 7) + n / 7)));
    orders.push((
        Kind::XyOrder,
        "x and y taken in turn from halves".into(),
        std::array::from_fn(|n| n / 2 + 7 * (n % 2)),
    ));
    orders
}

/// Answers in another order, values of a state that is read in another order, and transposed ones.
pub(super) fn of(quantity: &str, case: &Case, reference: &Reference) -> Vec<Candidate> {
    let mut all = Vec::new();
    let shape = own_shape(quantity, reference);
    let size = shape.iter().product::<usize>().max(1);
    let rearranged = |place: &dyn Fn(usize) -> usize| -> Vec<f64> {
        let at = |n: usize| reference.numbers.get(n / size * size + place(n % size)).copied().unwrap_or(f64::NAN);
        (0..reference.numbers.len()).map(at).collect()
    };
    if let [rows, columns] = *shape
        && rows == columns
    {
        all.push(candidate(Kind::Transpose, "transposed", rearranged(&|n| n % rows * rows + n / rows)));
    }
    for (kind, what, order) in coordinate_orders() {
        let value = match *shape {
            [14] => rearranged(&|n| order[n]),
            [14, 14] => rearranged(&|n| order[n / 14] * 14 + order[n % 14]),
            [2, 14] => rearranged(&|n| n / 14 * 14 + order[n % 14]),
            [7, 2] if kind == Kind::NodeOrder => rearranged(&|n| order[n]),
            _ => continue,
        };
        all.push(candidate(kind, format!("answered in another order: {what}"), value));
    }
    for (what, order) in ORDERS {
        if *shape == [7] {
            all.push(candidate(
                Kind::NodeOrder,
                format!("answered in another order: {what}"),
                rearranged(&|n| order[n]),
            ));
        }
    }
    if let [2] = *shape {
        all.push(candidate(Kind::XyOrder, "x and y exchanged", rearranged(&|n| n ^ 1)));
    }
    if let [_, 2] = *shape {
        all.push(candidate(Kind::XyOrder, "x and y exchanged", rearranged(&|n| n ^ 1)));
    }
    if let [3] = *shape {
        all.push(candidate(Kind::XyOrder, "11 and 22 exchanged", rearranged(&|n| [1, 0, 2][n])));
    }
    if let Parsed::Element(state) = &case.parsed {
        all.extend(misread(quantity, state));
    }
    all
}

/// The value for a state that is read in another order.
fn misread(quantity: &str, state: &ElementState) -> Vec<Candidate> {
    let mut all = Vec::new();
    for (kind, what, order) in coordinate_orders() {
        let read = |e: &[f64; 14]| std::array::from_fn(|n| e[order[n]]);
        let mistaken =
            ElementState { e: read(&state.e), e0: read(&state.e0), edot: read(&state.edot), ..state.clone() };
        let value = evaluate(quantity, &mistaken);
        all.push(Candidate { kind, what: format!("e read in another order: {what}"), value });
        let only = ElementState { e: mistaken.e, ..state.clone() };
        let value = evaluate(quantity, &only);
        all.push(Candidate { kind, what: format!("e (but not e0) read in another order: {what}"), value });
    }
    all
}
