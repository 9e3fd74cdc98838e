//! Order of the nodal vectors.

/// Orders that have a name: of the element's vectors, index in the program's e → index in (4).
const NAMED: [(&str, [usize; 7]); 10] = [
    ("positions first, then slopes", [0, 2, 5, 1, 3, 4, 6]),
    ("positions first, then r_x, then r_y", [0, 2, 5, 3, 1, 4, 6]),
    ("positions first, then r_y, then r_x", [0, 2, 5, 1, 4, 6, 3]),
    ("positions first, those of the ends before, then r_y, then r_x", [0, 5, 2, 1, 4, 6, 3]),
    ("positions of the ends first, then r_y alike, then r_x", [0, 5, 2, 1, 6, 4, 3]),
    ("the ends first: i, k, j", [0, 1, 5, 6, 2, 3, 4]),
    ("positions of the ends first, then slopes", [0, 5, 2, 1, 6, 3, 4]),
    ("r_y_j before r_x_j", [0, 1, 2, 4, 3, 5, 6]),
    ("slopes before positions", [1, 0, 3, 4, 2, 6, 5]),
    ("the middle first: j, i, k", [2, 3, 4, 0, 1, 5, 6]),
];

/// Orders that are tried where a program refuses all states in the order of the fixtures.
pub(super) fn usual_orders(vectors: usize) -> Vec<Vec<usize>> {
    let mut orders = vec![(0..vectors).collect::<Vec<_>>()];
    match vectors {
        7 => orders.extend(NAMED.iter().map(|(_, order)| order.to_vec())),
        4 => orders.extend([vec![0, 2, 1, 3], vec![2, 3, 0, 1]]),
        _ => {}
    }
    orders
}

/// An order in words.
pub(super) fn words(order: &[usize], names: &[&str]) -> String {
    let list = order.iter().filter_map(|n| names.get(*n).copied()).collect::<Vec<_>>().join(", ");
    match NAMED.iter().find(|(_, named)| named.as_slice() == order) {
        Some((name, _)) => format!("{name} ({list})"),
        None => list,
    }
}
