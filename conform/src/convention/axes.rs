//! What the axes of each quantity's value count, and how a program's entries correspond to those of the fixtures.

use super::Conventions;
use super::layout::Layout;

/// What an axis of a value counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    /// Nodal coordinates, as in e.
    Coordinates,
    /// Nodal coordinates, as in forces and in columns of S: slopes have the reciprocal factor.
    Forces,
    /// Nodal vectors, as in e.
    Vectors,
    /// Nodal vectors, as in the shape functions.
    Functions,
    /// Components of a strain.
    Strain,
    /// Components of a strain by which a stress is differentiated: columns of D.
    ByStrain,
    /// Components of a stress, or of a strain whose shear is the engineering shear in the fixtures.
    Stress,
    /// Anything else: x and y, powers of x.
    Other,
}

/// Axes of a quantity's value at a point; empty for a number, and for a quantity that no convention concerns.
pub(super) fn axes(quantity: &str) -> &'static [Axis] {
    use Axis::{ByStrain, Coordinates, Forces, Functions, Other, Strain, Stress, Vectors};
    match quantity {
        "4.nodes" => &[Vectors, Other],
        "A.2.e" | "22.eddot" | "cable.eddot" => &[Coordinates],
        "3.S" | "3.S_x" | "3.S_y" | "cable.S" | "cable.S_x" | "cable.S_xx" => &[Functions],
        "2.S" => &[Other, Forces],
        "7.M" | "11.S_a" | "11.S_b" | "11.S_c" | "21.S_a1" | "21.S_b1" | "21.S_c1" | "21.K_1" | "21.K_2" | "21.K_3"
        | "20.K" | "tangent.dQ_e" | "axis.tangent" | "uniaxial.tangent" | "cable.M" | "cable.tangent" => {
            &[Forces, Forces]
        }
        "19.Q_e" | "gravity.Q_w" | "22.residual" | "axis.Q_e" | "uniaxial.Q_e" | "cable.Q_e" | "cable.Q_w" => &[Forces],
        "8.epsilon_T" | "12.epsilon_f" | "14.epsilon" => &[Strain],
        "15.sigma" | "axis.epsilon" => &[Stress],
        "16.D" => &[Stress, ByStrain],
        "axis.D_0" | "uniaxial.D" => &[Stress, Stress],
        "9.J_0" | "9.J" | "10.epsilon_m" | "A.3.coefficients" => &[Other, Other],
        _ => &[],
    }
}

/// Correspondence of entries: index in the program's list → (index in the fixtures', factor of the program's entry).
pub(super) type Map = Vec<(usize, f64)>;

/// Map of one axis of `length` entries in an element of length `l` and height `h`.
pub(super) fn map(axis: Axis, length: usize, conventions: &Conventions, layout: &Layout, [l, h]: [f64; 2]) -> Map {
    let of_vector = |v: usize| layout.order.get(v).map_or((v, 1.0), |k| (*k, layout.factor(*k, l, h)));
    let of_coordinate = |n: usize| {
        let (v, component) = layout.components.vector_and_component(n, layout.names.len());
        let (k, factor) = of_vector(v);
        (2 * k + component, factor)
    };
    let of_component = |n: usize, shear: f64| {
        let place = conventions.voigt.0.get(n).copied().unwrap_or(n);
        (place, if place == 2 { shear } else { 1.0 })
    };
    let shear = conventions.shear.of_strain();
    let entry = |n: usize| match axis {
        Axis::Coordinates => of_coordinate(n),
        Axis::Forces => reciprocal(of_coordinate(n)),
        Axis::Vectors => of_vector(n),
        Axis::Functions => reciprocal(of_vector(n)),
        Axis::Strain => of_component(n, shear),
        Axis::ByStrain => of_component(n, 1.0 / shear),
        Axis::Stress => of_component(n, 1.0),
        Axis::Other => (n, 1.0),
    };
    (0..length).map(entry).collect()
}

fn reciprocal((place, factor): (usize, f64)) -> (usize, f64) {
    (place, 1.0 / factor)
}

/// Map of all entries of a value, row by row, from those of its axes.
pub(super) fn product(maps: &[Map]) -> Map {
    let mut all = vec![(0, 1.0)];
    for map in maps {
        let with = |(place, factor): &(usize, f64)| {
            let (place, factor) = (*place * map.len(), *factor);
            map.iter().map(move |(inner, of_inner)| (place + inner, factor * of_inner)).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(with).collect();
    }
    all
}
