//! Answers with permuted entries: nodal vectors, x and y, rows and columns.

use super::candidate::{Candidate, candidate};
use super::mistake::MistakeKind::{self, Missing, NodeOrder, Other, Transpose, XyOrder};
use crate::suite::Reference;

/// Names of the seven nodal vectors of (4).
pub(super) const VECTORS: [&str; 7] = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];

/// Other orders of the seven vectors: index in the program's e → index in (4).
const ORDERS: [(&str, [usize; 7]); 6] = [
    ("k before i", [5, 6, 2, 3, 4, 0, 1]),
    ("the ends first, then the middle: i, k, j", [0, 1, 5, 6, 2, 3, 4]),
    ("the middle first: j, i, k", [2, 3, 4, 0, 1, 5, 6]),
    ("positions first, then slopes", [0, 2, 5, 3, 1, 4, 6]),
    ("r_y_j before r_x_j", [0, 1, 2, 4, 3, 5, 6]),
    ("slopes before positions", [1, 0, 3, 4, 2, 6, 5]),
];

/// Other orders of the seven vectors, with their inverses.
fn vector_orders() -> Vec<(String, [usize; 7])> {
    let mut orders = Vec::new();
    for (what, order) in ORDERS {
        let back = std::array::from_fn(|n| order.iter().position(|place| *place == n).unwrap_or(n));
        orders.push((what.to_string(), order));
        if back != order {
            orders.push((format!("{what}, inverted"), back));
        }
    }
    orders.push(("backwards".into(), std::array::from_fn(|n| 6 - n)));
    orders
}

/// Other orders of the 14 coordinates.
pub(super) fn coordinate_orders() -> Vec<(MistakeKind, String, [usize; 14])> {
    let vectors = |order: [usize; 7]| std::array::from_fn(|n| 2 * order[n / 2] + n % 2);
    let mut orders: Vec<(MistakeKind, String, [usize; 14])> =
        vector_orders().into_iter().map(|(what, order)| (NodeOrder, what, vectors(order))).collect();
    for (what, ahead) in [("one place", 1), ("two places", 2), ("three places", 3), ("four places", 4)] {
        orders.push((NodeOrder, format!("shifted back by {what}"), std::array::from_fn(|n| (n + ahead) % 14)));
        orders.push((NodeOrder, format!("shifted forward by {what}"), std::array::from_fn(|n| (n + 14 - ahead) % 14)));
    }
    orders.push((XyOrder, "y before x".into(), std::array::from_fn(|n| n ^ 1)));
    orders.push((XyOrder, "all x, then all y".into(), std::array::from_fn(|n| 2 * (n % 7) + n / 7)));
    orders.push((
        XyOrder,
        "x and y interleaved from the two halves".into(),
        std::array::from_fn(|n| n / 2 + 7 * (n % 2)),
    ));
    orders
}

/// Orders with two vectors exchanged, for the 14 coordinates.
fn exchanges() -> Vec<(String, [usize; 14])> {
    let mut all = Vec::new();
    for (one, name) in VECTORS.iter().enumerate() {
        for (other, other_name) in VECTORS.iter().enumerate().skip(one + 1) {
            let vector = move |n: usize| match n {
                n if n == one => other,
                n if n == other => one,
                n => n,
            };
            let order = std::array::from_fn(|n| 2 * vector(n / 2) + n % 2);
            all.push((format!("{name} and {other_name} exchanged"), order));
        }
    }
    all
}

/// Other orders of four vectors.
pub(super) fn permutations() -> Vec<[usize; 4]> {
    let code = |n: usize| [n / 64, n / 16 % 4, n / 4 % 4, n % 4];
    let is_permutation = |order: &[usize; 4]| (0..4).all(|k| order.contains(&k));
    (0..256).map(code).filter(is_permutation).filter(|order| *order != [0, 1, 2, 3]).collect()
}

/// Candidates with permuted or transposed entries.
pub(super) fn of(reference: &Reference) -> Vec<Candidate<'_>> {
    let mut all = Vec::new();
    let shape = reference.shape_at_a_point();
    let size = shape.iter().product::<usize>().max(1);
    let mut add = |kind: MistakeKind, what: String, place: Box<dyn Fn(usize) -> usize>| {
        let at = move |n: usize| reference.numbers.get(n / size * size + place(n % size)).copied().unwrap_or(f64::NAN);
        all.push(candidate(kind, what, move || (0..reference.numbers.len()).map(&at).collect()));
    };
    if let [rows, columns] = *shape
        && rows == columns
    {
        add(Transpose, "transposed".into(), Box::new(move |n| n % rows * rows + n / rows));
    }
    let exchanges = exchanges().into_iter().map(|(what, order)| (NodeOrder, what, order));
    for (kind, what, order) in coordinate_orders().into_iter().chain(exchanges) {
        let place: Box<dyn Fn(usize) -> usize> = match *shape {
            [14] => Box::new(move |n| order[n]),
            [14, 14] => Box::new(move |n| order[n / 14] * 14 + order[n % 14]),
            [2, 14] => Box::new(move |n| n / 14 * 14 + order[n % 14]),
            [7, 2] => Box::new(move |n| order[n]),
            _ => continue,
        };
        add(kind, format!("answered in another order: {what}"), place);
    }
    if let [8] | [8, 8] = *shape {
        let orders = permutations().into_iter().map(|order| {
            let vectors: [usize; 8] = std::array::from_fn(|n| 2 * order[n / 2] + n % 2);
            (NodeOrder, format!("the vectors {order:?} of 0 to 3"), vectors)
        });
        let y_first = (XyOrder, "y before x".to_string(), std::array::from_fn(|n| n ^ 1));
        let all_x = (XyOrder, "all x, then all y".to_string(), std::array::from_fn(|n| 2 * (n % 4) + n / 4));
        for (kind, what, order) in orders.chain([y_first, all_x]) {
            let of_matrix = shape.len() == 2;
            let place = move |n: usize| if of_matrix { order[n / 8] * 8 + order[n % 8] } else { order[n] };
            add(kind, format!("answered in another order: {what}"), Box::new(place));
        }
    }
    if let [7] = *shape {
        for (what, order) in vector_orders() {
            add(NodeOrder, format!("answered in another order: {what}"), Box::new(move |n| order[n]));
        }
    }
    if let [2] | [_, 2] = *shape {
        add(XyOrder, "x and y exchanged".into(), Box::new(|n| n ^ 1));
        add(Other, "the first component twice".into(), Box::new(|n| n & !1));
        add(Other, "the second component twice".into(), Box::new(|n| n | 1));
    }
    if let [3] = *shape {
        for (what, order) in [
            ("11 and 22 exchanged", [1, 0, 2]),
            ("22 and 12 exchanged: 11, 12, 22", [0, 2, 1]),
            ("11 and 12 exchanged", [2, 1, 0]),
            ("22, 12, 11", [1, 2, 0]),
            ("12, 11, 22", [2, 0, 1]),
        ] {
            add(XyOrder, what.into(), Box::new(move |n| order[n]));
        }
    }
    if let [2, 14] = *shape {
        // The right entry (1, 2) is zero.
        let place = |n: usize| match n {
            0..14 => n,
            _ if n.is_multiple_of(2) => n + 1,
            _ => 1,
        };
        add(XyOrder, "the second row in the columns of x".into(), Box::new(place));
    }
    all.extend(triangles(reference));
    all
}

/// Candidates for a square matrix of which one triangle is filled.
fn triangles(reference: &Reference) -> Vec<Candidate<'_>> {
    let [rows, columns] = *reference.shape_at_a_point() else { return Vec::new() };
    if rows != columns {
        return Vec::new();
    }
    let filled = move |keep: fn(usize, usize) -> bool| {
        let entry = |(n, value): (usize, &f64)| {
            let n = n % (rows * columns);
            if keep(n / columns, n % columns) { *value } else { 0.0 }
        };
        reference.numbers.iter().enumerate().map(entry).collect::<Vec<f64>>()
    };
    vec![
        candidate(Missing, "only the upper triangle filled", move || filled(|row, column| row <= column)),
        candidate(Missing, "only the lower triangle filled", move || filled(|row, column| row >= column)),
    ]
}
