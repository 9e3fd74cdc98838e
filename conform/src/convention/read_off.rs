//! Layout of the nodal coordinates, read off one quantity.
//!
//! The shape functions are different functions, and M, K and the tangent have different blocks. So each nodal vector of the program is
//! matched with those of the fixtures that give its entries in every state, one after the other.

use super::Conventions;
use super::axes::{Axis, axes};
use super::components::Components;
use super::evidence::{Evidence, Row, Seen};
use super::layout::Layout;
use super::matrices::Matrices;
use super::slopes::{ACROSS, ALONG};
use super::translation::closeness;
use crate::suite::State;

/// Largest number of layouts that are read off one quantity.
const MOST: usize = 64;

/// A value at one point with its reference value, row by row.
struct Sample {
    theirs: Vec<f64>,
    ours: Vec<f64>,
    close: Vec<f64>,
    /// Length and height of the element.
    lengths: [f64; 2],
}

/// Values of one quantity, and what its axes are.
struct Samples {
    all: Vec<Sample>,
    axes: &'static [Axis],
    shape: Vec<usize>,
}

/// Layouts that give a quantity's answers in all cases, with its lists as `matrices`. With `spare` one nodal vector may fit nowhere: it
/// takes the place that is left.
pub(super) fn layouts(evidence: &Evidence, row: &Row, usual: &Layout, matrices: Matrices, spare: usize) -> Vec<Layout> {
    let Some(samples) = Samples::of(evidence, row, matrices) else { return Vec::new() };
    let has_components = samples.axes.iter().any(|axis| matches!(axis, Axis::Forces | Axis::Coordinates));
    let is_cable = !usual.names.iter().any(|name| name.starts_with("r_y"));
    let mut found: Vec<Layout> = Vec::new();
    for components in Components::ALL {
        for along in ALONG {
            for across in ACROSS.into_iter().take(if is_cable { 1 } else { ACROSS.len() }) {
                let layout = Layout { components, slopes: [along, across], ..usual.clone() };
                let solver = Solver { samples: &samples, layout: &layout };
                // A quantity without components looks alike in both orders of them.
                let read = if has_components { components } else { Components::Interleaved };
                let room = MOST.saturating_sub(found.len());
                let orders = solver.orders(read, spare, room);
                found.extend(orders.into_iter().map(|order| Layout { order, ..layout.clone() }));
            }
        }
    }
    found
}

impl Samples {
    fn of(evidence: &Evidence, row: &Row, matrices: Matrices) -> Option<Samples> {
        let axes = axes(row.quantity);
        let conventions = Conventions { matrices, ..Conventions::default() };
        let (mut all, mut shape) = (Vec::new(), Vec::new());
        for (n, seen) in &row.cases {
            let case = evidence.suite.cases.get(*n)?;
            let (reference, answer) = match (case.values.get(row.quantity)?, seen) {
                (reference, Seen::Numbers(answer)) => (reference, answer),
                (_, Seen::NotImplemented | Seen::Nothing) => continue,
            };
            shape = reference.shape_at_a_point().to_vec();
            let size = shape.iter().product::<usize>().max(1);
            let lengths = match &case.state {
                State::Element(state) => [state.l, state.h],
                State::Cable(state) => [state.l, state.h],
                State::System(_) => return None,
            };
            let numbers = conventions.numbers(row.quantity, case, reference, answer)?;
            let own = numbers.chunks(size).zip(reference.numbers.chunks(size)).enumerate();
            all.extend(own.map(|(point, (theirs, ours))| Sample {
                theirs: theirs.to_vec(),
                ours: ours.to_vec(),
                close: (0..size).map(|entry| closeness(reference, point * size + entry)).collect(),
                lengths,
            }));
        }
        (!all.is_empty()).then_some(Samples { all, axes, shape })
    }

    /// Indices of the entries that belong to a nodal vector, or to a pair of them where both axes count vectors.
    fn entries(&self, [v, u]: [usize; 2], vectors: usize, components: Components) -> Vec<usize> {
        let along = |axis: Axis, length: usize, v: usize| match (axis, components) {
            (Axis::Forces | Axis::Coordinates, Components::Interleaved) => vec![2 * v, 2 * v + 1],
            (Axis::Forces | Axis::Coordinates, Components::Blocks) => vec![v, vectors + v],
            (Axis::Functions | Axis::Vectors, _) => vec![v],
            _ => (0..length).collect(),
        };
        match (self.axes, &self.shape[..]) {
            ([axis], [length]) => along(*axis, *length, v),
            ([rows, columns], [height, width]) => {
                let second = if self.is_pair() { u } else { v };
                let columns = along(*columns, *width, second);
                along(*rows, *height, v)
                    .iter()
                    .flat_map(|row| columns.iter().map(move |column| row * width + column))
                    .collect()
            }
            _ => Vec::new(),
        }
    }

    fn is_pair(&self) -> bool {
        self.axes.iter().all(|axis| *axis != Axis::Other) && self.axes.len() == 2
    }

    /// Power of a vector's factor in the entries: 1 as in e, −1 as in forces.
    fn is_reciprocal(&self) -> bool {
        self.axes.iter().any(|axis| matches!(axis, Axis::Forces | Axis::Functions))
    }
}

/// Search for the order of the vectors, with given slopes.
struct Solver<'a> {
    samples: &'a Samples,
    layout: &'a Layout,
}

impl Solver<'_> {
    /// Whether the program's pair of vectors can be a pair of the fixtures.
    fn fits(&self, theirs: [usize; 2], ours: [usize; 2], components: Components) -> bool {
        let vectors = self.layout.names.len();
        let places = self.samples.entries(theirs, vectors, components);
        let own = self.samples.entries(ours, vectors, Components::Interleaved);
        self.samples.all.iter().all(|sample| {
            let [l, h] = sample.lengths;
            let of = |k: usize| {
                let factor = self.layout.factor(k, l, h);
                if self.samples.is_reciprocal() { 1.0 / factor } else { factor }
            };
            let factor = if self.samples.is_pair() { of(ours[0]) * of(ours[1]) } else { of(ours[0]) };
            places.iter().zip(&own).all(|(place, own)| {
                let at = |list: &[f64], n: usize| list.get(n).copied().unwrap_or(f64::NAN);
                let (found, expected) = (at(&sample.theirs, *place), at(&sample.ours, *own));
                (found - factor * expected).abs() <= factor * at(&sample.close, *own)
            })
        })
    }

    /// Orders that fit, at most `most`.
    fn orders(&self, components: Components, spare: usize, most: usize) -> Vec<Vec<usize>> {
        let (mut found, mut partial) = (Vec::new(), Vec::new());
        self.extend(&mut partial, components, spare, most, &mut found);
        // The vector that fits nowhere takes the place that is left.
        for order in &mut found {
            let left = (0..order.len()).find(|k| !order.contains(&Some(*k)));
            order.iter_mut().filter(|place| place.is_none()).for_each(|place| *place = left);
        }
        found.into_iter().map(|order| order.into_iter().flatten().collect()).collect()
    }

    /// Adds the next vector of the program in all ways that fit those before it; `None` stands for a vector that fits nowhere.
    fn extend(
        &self,
        partial: &mut Vec<Option<usize>>,
        components: Components,
        spare: usize,
        most: usize,
        found: &mut Vec<Vec<Option<usize>>>,
    ) {
        let (n, vectors) = (partial.len(), self.layout.names.len());
        if found.len() >= most {
            return;
        }
        if n == vectors {
            found.push(partial.clone());
            return;
        }
        let earlier: Vec<[usize; 2]> =
            partial.iter().enumerate().filter_map(|(n, place)| place.map(|k| [n, k])).collect();
        let free: Vec<usize> = (0..vectors).filter(|k| !partial.contains(&Some(*k))).collect();
        for k in free {
            let fits_earlier = || {
                earlier
                    .iter()
                    .all(|[m, j]| self.fits([n, *m], [k, *j], components) && self.fits([*m, n], [*j, k], components))
            };
            if self.fits([n, n], [k, k], components) && (!self.samples.is_pair() || fits_earlier()) {
                partial.push(Some(k));
                self.extend(partial, components, spare, most, found);
                partial.pop();
            }
        }
        if spare > 0 {
            partial.push(None);
            self.extend(partial, components, spare - 1, most, found);
            partial.pop();
        }
    }
}
