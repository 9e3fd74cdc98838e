//! Misread states: permuted coordinates, confused configurations, wrong lengths and points.

use super::candidate::{Candidate, possible};
use super::layout::{VECTORS, coordinate_orders};
use super::mistake::MistakeKind::{self, NodeOrder, Other, XyOrder};
use ancf::state::{ElementState, evaluate};

type Change = Box<dyn Fn(&mut ElementState)>;

/// Candidates with a misread state.
pub(super) fn of<'a>(quantity: &'a str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let with = |(kind, what, change): (MistakeKind, String, Change)| {
        possible(kind, what, move || {
            let mut read = state.clone();
            change(&mut read);
            evaluate(quantity, &read)
        })
    };
    orders().into_iter().chain(vectors()).chain(configurations()).chain(lengths_and_points()).map(with).collect()
}

fn change(
    kind: MistakeKind,
    what: impl Into<String>,
    change: impl Fn(&mut ElementState) + 'static,
) -> (MistakeKind, String, Change) {
    (kind, what.into(), Box::new(change))
}

/// Permuted coordinates.
fn orders() -> Vec<(MistakeKind, String, Change)> {
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

/// One nodal vector read for another.
fn vectors() -> Vec<(MistakeKind, String, Change)> {
    let mut all = Vec::new();
    for (k, of) in VECTORS.into_iter().enumerate() {
        for (n, read) in VECTORS.into_iter().enumerate().filter(|(n, _)| *n != k) {
            all.push(change(NodeOrder, format!("{read} read for {of}"), move |state| {
                for e in [&mut state.e, &mut state.edot] {
                    (e[2 * k], e[2 * k + 1]) = (e[2 * n], e[2 * n + 1]);
                }
            }));
        }
    }
    all
}

/// Confused configurations e, e0 and ė, entirely or in some vectors.
fn configurations() -> Vec<(MistakeKind, String, Change)> {
    fn some(which: &'static [usize]) -> impl Fn(&mut ElementState) + 'static {
        move |state| which.iter().for_each(|k| state.e[2 * k..2 * k + 2].copy_from_slice(&state.e0[2 * k..2 * k + 2]))
    }
    vec![
        change(Other, "e0 read for e", |state| state.e = state.e0),
        change(Other, "e read for e0", |state| state.e0 = state.e),
        change(Other, "e0 and e exchanged", |state| std::mem::swap(&mut state.e, &mut state.e0)),
        change(Other, "e − e0 read for e: displacements for positions", |state| {
            state.e = std::array::from_fn(|n| state.e[n] - state.e0[n]);
        }),
        change(Other, "the slopes of e0 read for those of e", some(&[1, 3, 4, 6])),
        change(Other, "the r_y of e0 read for those of e", some(&[1, 4, 6])),
        change(Other, "the r_x_j of e0 read for that of e", some(&[3])),
        change(Other, "the positions of e0 read for those of e", some(&[0, 2, 5])),
        change(Other, "e read for ė", |state| state.edot = state.e),
        change(Other, "ė read for e", |state| state.e = state.edot),
    ]
}

/// Wrong lengths, points and gravity.
fn lengths_and_points() -> Vec<(MistakeKind, String, Change)> {
    fn points(of: impl Fn(&ElementState, f64, f64) -> [f64; 2] + 'static) -> impl Fn(&mut ElementState) + 'static {
        move |state| state.points = state.points.iter().map(|&[x, y]| of(state, x, y)).collect()
    }
    vec![
        change(Other, "h and w exchanged", |state| std::mem::swap(&mut state.h, &mut state.w)),
        change(Other, "−h … h for −h/2 … h/2", |state| (state.h, state.w) = (2.0 * state.h, state.w / 2.0)),
        change(Other, "y with the wrong sign", points(|_, x, y| [x, -y])),
        change(Other, "y = 0", points(|_, x, _| [x, 0.0])),
        change(Other, "y/h for y/l", points(|state, x, y| [x, y * state.l / state.h])),
        change(Other, "2y/h for y/l", points(|state, x, y| [x, 2.0 * y * state.l / state.h])),
        change(Other, "y for y/l", points(|state, x, y| [x, y * state.l])),
        change(Other, "x for x/l", points(|state, x, y| [x * state.l, y])),
        change(Other, "x and y for x/l and y/l", points(|state, x, y| [x * state.l, y * state.l])),
        change(Other, "2x/l − 1 for x/l: from −1 to 1", points(|state, x, y| [2.0 * x - state.l, y])),
        change(Other, "x measured from the middle", points(|state, x, y| [x - state.l / 2.0, y])),
        change(Other, "x + l/2 for x: x measured from the middle", points(|state, x, y| [x + state.l / 2.0, y])),
        change(Other, "x and y exchanged", points(|_, x, y| [y, x])),
        change(NodeOrder, "x measured from the other end", points(|state, x, y| [state.l - x, y])),
        change(Other, "the first point for all points", |state| {
            let first = state.points.first().copied();
            state.points.iter_mut().for_each(|point| *point = first.unwrap_or(*point));
        }),
        change(XyOrder, "x and y of gravity exchanged", |state| state.gravity.swap(0, 1)),
        change(Other, "gravity turned by θ, as in the rod's own axes", |state| turn(&mut state.gravity, state.theta)),
        change(Other, "gravity turned by −θ, as in the rod's own axes", |state| {
            turn(&mut state.gravity, -state.theta)
        }),
        change(Other, "gravity of 9.81 for that of 9.8", |state| {
            state.gravity = state.gravity.map(|g| if g.abs() == 9.8 { 9.81 * g.signum() } else { g });
        }),
        change(Other, "gravity (0, −9.81) whatever the state says", |state| state.gravity = [0.0, -9.81]),
    ]
}

fn turn([x, y]: &mut [f64; 2], angle: f64) {
    let (sin, cos) = angle.sin_cos();
    (*x, *y) = (cos * *x - sin * *y, sin * *x + cos * *y);
}
