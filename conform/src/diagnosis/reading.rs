//! States that are read wrongly: coordinates in another order, those of the start for those of now, other places.

use super::layout::coordinate_orders;
use super::{Candidate, Kind, possible};
use ancf::state::{ElementState, evaluate};

type Change = Box<dyn Fn(&mut ElementState)>;

/// The seven vectors of (4).
pub(super) const VECTORS: [&str; 7] = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];

/// The value for a state that is read wrongly.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let with = |(kind, what, change): (Kind, String, Change)| {
        possible(kind, what, move || {
            let mut read = state.clone();
            change(&mut read);
            evaluate(quantity, &read)
        })
    };
    orders().into_iter().chain(vectors()).chain(configurations()).chain(places()).map(with).collect()
}

fn change(kind: Kind, what: impl Into<String>, change: impl Fn(&mut ElementState) + 'static) -> (Kind, String, Change) {
    (kind, what.into(), Box::new(change))
}

/// The coordinates in another order.
fn orders() -> Vec<(Kind, String, Change)> {
    let mut all = Vec::new();
    for (kind, what, order) in coordinate_orders() {
        let read = move |e: &[f64; 14]| std::array::from_fn(|n| e[order[n]]);
        all.push(change(kind, format!("e read in another order: {what}"), move |state| {
            (state.e, state.e0, state.edot) = (read(&state.e), read(&state.e0), read(&state.edot));
        }));
        all.push(change(kind, format!("e (but not e0) read in another order: {what}"), move |state| {
            state.e = read(&state.e);
        }));
    }
    all
}

/// One vector read where another stands.
fn vectors() -> Vec<(Kind, String, Change)> {
    let mut all = Vec::new();
    for (k, of) in VECTORS.into_iter().enumerate() {
        for (n, read) in VECTORS.into_iter().enumerate().filter(|(n, _)| *n != k) {
            all.push(change(Kind::NodeOrder, format!("{read} read for {of}"), move |state| {
                for e in [&mut state.e, &mut state.edot] {
                    (e[2 * k], e[2 * k + 1]) = (e[2 * n], e[2 * n + 1]);
                }
            }));
        }
    }
    all
}

/// One configuration read for another: e, e0 and ė, all of it or some of its vectors.
fn configurations() -> Vec<(Kind, String, Change)> {
    fn some(which: &'static [usize]) -> impl Fn(&mut ElementState) + 'static {
        move |state| which.iter().for_each(|k| state.e[2 * k..2 * k + 2].copy_from_slice(&state.e0[2 * k..2 * k + 2]))
    }
    vec![
        change(Kind::Other, "e0 in the place of e", |state| state.e = state.e0),
        change(Kind::Other, "e in the place of e0", |state| state.e0 = state.e),
        change(Kind::Other, "e0 and e exchanged", |state| std::mem::swap(&mut state.e, &mut state.e0)),
        change(Kind::Other, "e − e0 in the place of e: displacements for positions", |state| {
            state.e = std::array::from_fn(|n| state.e[n] - state.e0[n]);
        }),
        change(Kind::Other, "the slopes of e0 in the place of those of e", some(&[1, 3, 4, 6])),
        change(Kind::Other, "the r_y of e0 in the place of those of e", some(&[1, 4, 6])),
        change(Kind::Other, "the r_x_j of e0 in the place of that of e", some(&[3])),
        change(Kind::Other, "the positions of e0 in the place of those of e", some(&[0, 2, 5])),
        change(Kind::Other, "e in the place of ė", |state| state.edot = state.e),
        change(Kind::Other, "ė in the place of e", |state| state.e = state.edot),
    ]
}

/// Lengths and points.
fn places() -> Vec<(Kind, String, Change)> {
    fn points(of: impl Fn(&ElementState, f64, f64) -> [f64; 2] + 'static) -> impl Fn(&mut ElementState) + 'static {
        move |state| state.points = state.points.iter().map(|&[x, y]| of(state, x, y)).collect()
    }
    vec![
        change(Kind::Other, "h and w exchanged", |state| std::mem::swap(&mut state.h, &mut state.w)),
        change(Kind::Other, "−h … h for −h/2 … h/2", |state| {
            (state.h, state.w) = (2.0 * state.h, state.w / 2.0)
        }),
        change(Kind::Other, "y with the other sign", points(|_, x, y| [x, -y])),
        change(Kind::Other, "y = 0", points(|_, x, _| [x, 0.0])),
        change(Kind::Other, "y/h for y/l", points(|state, x, y| [x, y * state.l / state.h])),
        change(Kind::Other, "2y/h for y/l", points(|state, x, y| [x, 2.0 * y * state.l / state.h])),
        change(Kind::Other, "y for y/l", points(|state, x, y| [x, y * state.l])),
        change(Kind::Other, "x for x/l", points(|state, x, y| [x * state.l, y])),
        change(Kind::Other, "x and y for x/l and y/l", points(|state, x, y| [x * state.l, y * state.l])),
        change(Kind::Other, "2x/l − 1 for x/l: from −1 to 1", points(|state, x, y| [2.0 * x - state.l, y])),
        change(Kind::Other, "x counted from the middle", points(|state, x, y| [x - state.l / 2.0, y])),
        change(Kind::Other, "x and y exchanged", points(|_, x, y| [y, x])),
        change(Kind::NodeOrder, "x counted from the other end", points(|state, x, y| [state.l - x, y])),
        change(Kind::Other, "only the first point, for all of them", |state| {
            let first = state.points.first().copied();
            state.points.iter_mut().for_each(|point| *point = first.unwrap_or(*point));
        }),
        change(Kind::XyOrder, "x and y of gravity exchanged", |state| state.gravity.swap(0, 1)),
    ]
}
