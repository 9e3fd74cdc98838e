//! Answers in another order: nodal vectors, their x and y, rows and columns.

use super::places::own_shape;
use super::{Candidate, Kind, candidate};
use crate::suite::Reference;

/// Orders in which a program may keep the seven vectors of (4): place in its e → place in (4).
const ORDERS: [(&str, [usize; 7]); 6] = [
    ("k before i", [5, 6, 2, 3, 4, 0, 1]),
    ("the ends first, then the middle: i, k, j", [0, 1, 5, 6, 2, 3, 4]),
    ("the middle first: j, i, k", [2, 3, 4, 0, 1, 5, 6]),
    ("positions first, then slopes", [0, 2, 5, 3, 1, 4, 6]),
    ("r_y_j before r_x_j", [0, 1, 2, 4, 3, 5, 6]),
    ("slopes before positions", [1, 0, 3, 4, 2, 6, 5]),
];

/// Orders of the seven vectors, there and back.
fn vector_orders() -> Vec<(String, [usize; 7])> {
    let mut orders = Vec::new();
    for (what, order) in ORDERS {
        let back = std::array::from_fn(|n| order.iter().position(|place| *place == n).unwrap_or(n));
        orders.push((what.to_string(), order));
        if back != order {
            orders.push((format!("{what}, the other way round"), back));
        }
    }
    orders.push(("backwards".into(), std::array::from_fn(|n| 6 - n)));
    orders
}

/// Orders of the 14 coordinates.
pub(super) fn coordinate_orders() -> Vec<(Kind, String, [usize; 14])> {
    let vectors = |order: [usize; 7]| std::array::from_fn(|n| 2 * order[n / 2] + n % 2);
    let mut orders: Vec<(Kind, String, [usize; 14])> =
        vector_orders().into_iter().map(|(what, order)| (Kind::NodeOrder, what, vectors(order))).collect();
    for (what, ahead) in [("one place", 1), ("two places", 2), ("three places", 3), ("four places", 4)] {
        orders.push((Kind::NodeOrder, format!("{what} late"), std::array::from_fn(|n| (n + ahead) % 14)));
        orders.push((Kind::NodeOrder, format!("{what} early"), std::array::from_fn(|n| (n + 14 - ahead) % 14)));
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

/// The answer in another order, and transposed.
pub(super) fn of<'a>(quantity: &str, reference: &'a Reference) -> Vec<Candidate<'a>> {
    let mut all = Vec::new();
    let shape = own_shape(quantity, reference);
    let size = shape.iter().product::<usize>().max(1);
    let mut add = |kind: Kind, what: String, place: Box<dyn Fn(usize) -> usize>| {
        let at = move |n: usize| reference.numbers.get(n / size * size + place(n % size)).copied().unwrap_or(f64::NAN);
        all.push(candidate(kind, what, move || (0..reference.numbers.len()).map(&at).collect()));
    };
    if let [rows, columns] = *shape
        && rows == columns
    {
        add(Kind::Transpose, "transposed".into(), Box::new(move |n| n % rows * rows + n / rows));
    }
    for (kind, what, order) in coordinate_orders() {
        let place: Box<dyn Fn(usize) -> usize> = match *shape {
            [14] => Box::new(move |n| order[n]),
            [14, 14] => Box::new(move |n| order[n / 14] * 14 + order[n % 14]),
            [2, 14] => Box::new(move |n| n / 14 * 14 + order[n % 14]),
            [7, 2] => Box::new(move |n| order[n]),
            _ => continue,
        };
        add(kind, format!("answered in another order: {what}"), place);
    }
    if let [7] = *shape {
        for (what, order) in vector_orders() {
            add(Kind::NodeOrder, format!("answered in another order: {what}"), Box::new(move |n| order[n]));
        }
    }
    if let [2] | [_, 2] = *shape {
        add(Kind::XyOrder, "x and y exchanged".into(), Box::new(|n| n ^ 1));
    }
    if let [3] = *shape {
        for (what, order) in [
            ("11 and 22 exchanged", [1, 0, 2]),
            ("22 and 12 exchanged: 11, 12, 22", [0, 2, 1]),
            ("11 and 12 exchanged", [2, 1, 0]),
            ("22, 12, 11", [1, 2, 0]),
            ("12, 11, 22", [2, 0, 1]),
        ] {
            add(Kind::XyOrder, what.into(), Box::new(move |n| order[n]));
        }
    }
    all
}
