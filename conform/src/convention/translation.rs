//! Translation of values and states between a program's conventions and those of the fixtures.

use serde_json::Value;

use super::Conventions;
use super::axes::{Axis, Map, axes, map, product};
use super::layout::Layout;
use super::reading::Reading;
use super::symmetrised::{Metrics, skew};
use crate::numbers::flatten;
use crate::protocol::Answer;
use crate::suite::{Case, Reference, State, Suite};

/// Numbers of a program's answer, row by row, with the lengths of its nested lists.
#[derive(Clone, Debug)]
pub(super) struct Shaped {
    pub shape: Vec<usize>,
    pub numbers: Vec<f64>,
}

impl Shaped {
    /// `None` for anything but nested lists of numbers of equal lengths.
    pub(super) fn read(value: &Value) -> Option<Shaped> {
        let mut numbers = Vec::new();
        flatten(value, &mut numbers).map(|shape| Shaped { shape, numbers })
    }
}

/// Largest error of an answer that counts as right for a convention, relative to the terms that are added up. Conventions differ by much
/// more, and single precision by less.
const CLOSE: f64 = 1e-5;

/// Quantities that repeat coordinates of the state, which a program may answer in the layout that it reads.
const ECHOES: [&str; 2] = ["4.nodes", "A.2.e"];

/// Whether all numbers are right as far as conventions matter.
pub(super) fn is_close(numbers: &[f64], reference: &Reference) -> bool {
    let near = |(n, (a, b)): (usize, (&f64, &f64))| (a - b).abs() <= closeness(reference, n);
    numbers.len() == reference.numbers.len() && numbers.iter().zip(&reference.numbers).enumerate().all(near)
}

/// Largest distance at which an entry of the program can be one of the fixtures.
pub(super) fn closeness(reference: &Reference, entry: usize) -> f64 {
    (CLOSE / reference.relative).max(1.0) * reference.absolute.get(entry).copied().unwrap_or(0.0)
}

/// Nested lists of the lengths `shape` with these numbers, row by row.
fn nested(shape: &[usize], numbers: &[f64]) -> Value {
    match shape {
        [] => numbers.first().copied().unwrap_or(f64::NAN).into(),
        [_, inner @ ..] => {
            let size = inner.iter().product::<usize>().max(1);
            Value::Array(numbers.chunks(size).map(|numbers| nested(inner, numbers)).collect())
        }
    }
}

impl Conventions {
    /// Whether they are those of the fixtures.
    pub fn are_usual(&self) -> bool {
        *self == Conventions::default()
    }

    /// Layout of the coordinates of a case; `None` for a structure.
    fn layout_of(&self, state: &State) -> Option<(&Layout, [f64; 2])> {
        match state {
            State::Element(state) => Some((&self.element, [state.l, state.h])),
            State::Cable(state) => Some((&self.cable, [state.l, state.h])),
            State::System(_) => None,
        }
    }

    /// Map of the entries of a quantity at one point of a case.
    fn map(&self, quantity: &str, case: &Case, shape: &[usize]) -> Option<Map> {
        let (layout, lengths) = self.layout_of(&case.state)?;
        let axes = axes(quantity);
        if axes.len() != shape.len() {
            return Some(product(&[(0..shape.iter().product()).map(|n| (n, 1.0)).collect()]));
        }
        let maps: Vec<Map> =
            axes.iter().zip(shape).map(|(axis, length)| map(*axis, *length, self, layout, lengths)).collect();
        Some(product(&maps))
    }

    /// Numbers of an answer in the conventions of the fixtures; `None` if its shape is not that of this convention.
    pub(super) fn numbers(
        &self,
        quantity: &str,
        case: &Case,
        reference: &Reference,
        answer: &Shaped,
    ) -> Option<Vec<f64>> {
        let ours = self.rearranged(quantity, case, reference, answer)?;
        if !ECHOES.contains(&quantity) || is_close(&ours, reference) {
            return Some(ours);
        }
        let lists_alone = Conventions { matrices: self.matrices, ..Conventions::default() };
        let echo = lists_alone.rearranged(quantity, case, reference, answer);
        Some(echo.filter(|echo| is_close(echo, reference)).unwrap_or(ours))
    }

    /// Numbers of an answer, rearranged and scaled.
    fn rearranged(&self, quantity: &str, case: &Case, reference: &Reference, answer: &Shaped) -> Option<Vec<f64>> {
        let shape = reference.shape_at_a_point();
        let points = points(reference);
        if !self.matrices.admits(&answer.shape, shape, points) {
            return None;
        }
        let size = shape.iter().product::<usize>().max(1);
        let map = self.map(quantity, case, shape)?;
        let scale = self.shear.of(quantity);
        let mut ours = Vec::with_capacity(answer.numbers.len());
        for theirs in answer.numbers.chunks(size) {
            let mut value = vec![f64::NAN; size];
            for (entry, (place, factor)) in self.matrices.rows(shape, theirs, true).iter().zip(&map) {
                if let Some(own) = value.get_mut(*place) {
                    *own = entry / (factor * scale);
                }
            }
            ours.extend(value);
        }
        self.shifts(quantity, case, reference).iter().zip(&mut ours).for_each(|(shift, own)| *own -= shift);
        Some(ours)
    }

    /// What the program's value is larger by, in the layout of the fixtures; empty where nothing is.
    fn shifts(&self, quantity: &str, case: &Case, reference: &Reference) -> Vec<f64> {
        if quantity == "11.S_c" && self.S_c == Metrics::Symmetrised {
            let size = reference.shape_at_a_point().iter().product::<usize>().max(1);
            return reference.numbers.chunks(size).flat_map(|S_c| skew(S_c).into_iter().map(|part| -part)).collect();
        }
        if let Some(shift) = self.heat.shift(quantity, &case.state) {
            return shift;
        }
        match self.energy.shift(quantity, &case.state) {
            0.0 => Vec::new(),
            shift => vec![shift],
        }
    }

    /// An answer in the conventions of the fixtures. What cannot be translated stays as it came.
    fn translated(&self, quantity: &str, case: &Case, reference: &Reference, answer: Value) -> Value {
        let Some(shaped) = Shaped::read(&answer) else { return answer };
        match self.numbers(quantity, case, reference, &shaped) {
            // Numbers that no convention concerns keep their digits.
            Some(numbers) if shaped.shape != reference.shape || shaped.numbers != numbers => {
                nested(&reference.shape, &numbers)
            }
            _ => answer,
        }
    }

    /// An answer in the case with index `n`, in the conventions of the fixtures.
    pub fn answer(&self, suite: &Suite, quantity: &str, n: usize, answer: Answer) -> Answer {
        let case = suite.cases.get(n);
        match (answer, case.and_then(|case| Some((case, case.values.get(quantity)?)))) {
            (Answer::Value(value), Some((case, reference))) => {
                Answer::Value(self.translated(quantity, case, reference, value))
            }
            (answer, _) => answer,
        }
    }

    /// A reference value in the program's conventions, to be sent as `given`.
    pub fn given(&self, quantity: &str, case: &Case, reference: &Reference) -> Value {
        let shape = reference.shape_at_a_point();
        let Some(map) = self.map(quantity, case, shape) else { return reference.json.clone() };
        if self.are_usual() {
            return reference.json.clone();
        }
        let scale = self.shear.of(quantity);
        let mut ours = reference.numbers.clone();
        self.shifts(quantity, case, reference).iter().zip(&mut ours).for_each(|(shift, own)| *own += shift);
        let mut theirs = Vec::with_capacity(ours.len());
        for value in ours.chunks(map.len().max(1)) {
            let entry =
                |(place, factor): &(usize, f64)| value.get(*place).copied().unwrap_or(f64::NAN) * factor * scale;
            let by_rows: Vec<f64> = map.iter().map(entry).collect();
            theirs.extend(self.matrices.rows(shape, &by_rows, false));
        }
        nested(&self.matrices.shape(shape, points(reference)), &theirs)
    }

    /// Reference values that are sent with a question about `quantity`, [`Case::given`], in the program's conventions.
    pub fn all_given<'a>(&self, case: &'a Case, quantity: &str, inputs: &[&'a str]) -> Vec<(&'a str, Value)> {
        let theirs = |(name, value): (&'a str, &Value)| match case.values.get(name) {
            Some(reference) => (name, self.given(name, case, reference)),
            None => (name, value.clone()),
        };
        case.given(quantity, inputs).into_iter().map(theirs).collect()
    }

    /// A state as the program reads it; `None` where it is that of the fixtures. An invalid state is rewritten as far as it goes.
    pub fn state(&self, state: &Value) -> Option<Value> {
        let length = state["e"].as_array().map(Vec::len);
        let layout = match length {
            Some(14) => &self.element,
            Some(8) => &self.cable,
            _ => return None,
        };
        let own = self.reading == Reading::Own && !layout.is_usual();
        let mut sent = state.clone();
        if own {
            let lengths = [state["l"].as_f64()?, state["h"].as_f64()?];
            let map = map(Axis::Coordinates, length?, self, layout, lengths);
            for key in ["e0", "e", "edot"] {
                let Some(Shaped { numbers, .. }) = Shaped::read(&state[key]) else { continue };
                if numbers.len() == map.len() {
                    let entry =
                        |(place, factor): &(usize, f64)| numbers.get(*place).copied().unwrap_or(f64::NAN) * factor;
                    sent[key] = map.iter().map(entry).collect();
                }
            }
        }
        if let Some(theta) = state["theta"].as_f64() {
            sent["theta"] = self.angle.sent(theta).into();
        }
        (sent != *state).then_some(sent)
    }
}

/// Number of points of a quantity per point.
fn points(reference: &Reference) -> Option<usize> {
    if reference.per_point { reference.shape.first().copied() } else { None }
}
