//! Rows read and add what the elements one by one do, whichever unknowns are held, shared or turned.

use nalgebra::{DVector, Rotation2, SVector};
use proptest::prelude::*;

use super::*;
use crate::lanes::{Path, Task};
use crate::structure::element_dofs::ElementDofs;

/// A rod's chain of nodal vectors: which are free, held in one or both directions, turned or shared.
fn chain(vectors: usize, kinds: &[u8]) -> (Vec<NodeDofs>, usize) {
    let (mut next, mut shared) = (3, 1000);
    let number = |from: &mut usize| {
        *from += 1;
        Some(*from - 1)
    };
    let of = |n: usize| {
        let (unknowns, turn) = match kinds[n % kinds.len()] {
            0 => ([number(&mut shared), number(&mut shared)], None),
            1 => ([None, number(&mut next)], None),
            2 => ([None, None], None),
            3 => ([number(&mut next), None], Some(Rotation2::new(0.7))),
            _ => ([number(&mut next), number(&mut next)], None),
        };
        NodeDofs { unknowns, turn }
    };
    ((0..vectors).map(of).collect(), 1000 + 2 * vectors)
}

/// Coordinates of every element, and a vector to which each element's coordinates have been added, squared and negative.
struct Round<'a, const N: usize> {
    rows: &'a [Row<N>],
    u: &'a [f64],
    sum: &'a mut [f64],
}

impl<const N: usize> Task for Round<'_, N> {
    type Output = Vec<SVector<f64, N>>;

    #[inline(always)]
    fn run<L: Lanes>(self, token: L::Token) -> Vec<SVector<f64, N>> {
        let mut each = Vec::new();
        for row in self.rows {
            let mut columns = row.coordinates::<L>(token, self.u);
            for lane in 0..row.count() {
                each.push(SVector::from_fn(|i, _| columns[i].to_array()[lane]));
            }
            for column in &mut columns {
                *column = *column * *column;
            }
            row.add(token, columns, -1.0, self.sum);
        }
        each
    }
}

fn check<const N: usize>(elements: usize, kinds: &[u8], values: &[f64]) {
    let (chain, size) = chain((N / 2 - 2) * elements + 2, kinds);
    let u = DVector::from_fn(size, |i, _| values[i % values.len()] * (1.0 + (i % 7) as f64));
    let places: Vec<ElementDofs<N>> = chain.windows(N / 2).step_by(N / 2 - 2).map(ElementDofs::of).collect();
    let rows = Row::<N>::of(&chain);
    let mut expected = DVector::zeros(size);
    places.iter().for_each(|place| place.scatter(place.gather(&u).map(|x| -x * x), &mut expected));
    for path in [Path::PORTABLE, Path::fastest()] {
        let mut sum = DVector::zeros(size);
        let each = path.run(Round { rows: &rows, u: u.as_slice(), sum: sum.as_mut_slice() });
        assert_eq!(each.len(), elements);
        for (own, place) in each.iter().zip(&places) {
            assert!((own - place.gather(&u)).amax() <= 1e-15 * u.amax(), "{path:?}: {own} {}", place.gather(&u));
        }
        assert!((&sum - &expected).amax() <= 1e-14 * expected.amax(), "{path:?}: {sum} {expected}");
    }
}

proptest! {
    /// Kinds repeat along the chain; most vectors are free, as in a rod, so that rows of every sort come up.
    #[test]
    fn rows_are_the_elements_one_by_one(
        elements in 1usize..14,
        kinds in prop::collection::vec(prop_oneof![8 => Just(9u8), 1 => 0u8..4], 1..40),
        values in prop::collection::vec(-1.0..1.0, 50),
    ) {
        check::<14>(elements, &kinds, &values);
        check::<8>(elements, &kinds, &values);
    }
}
