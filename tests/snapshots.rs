//! Tables for people to review: the shape functions at the nodes, the mass matrix, the tangent at rest.
//!
//! They are no oracle (`fixtures.rs` is); they show what the numbers are, with sums that can be done by hand. To take a
//! changed table over, run with `INSTA_UPDATE=always` and read the difference.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;

use ancf::equations::element::{Element, Matrix14};
use ancf::equations::material::LameConstants;
use ancf::equations::{force, inertia, shape};
use nalgebra::Vector3;

/// x as a fraction of small numbers, which everything here is, to 1e-13 of the table's largest entry; a zero has no
/// sign. Denominators to 1000 meet an arbitrary number that closely less than once in a thousand times.
fn fraction(x: f64, largest: f64) -> String {
    let small = (1..=1000).map(f64::from).find(|d| (x - (x * d).round() / d).abs() <= 1e-13 * largest);
    let denominator = small.unwrap_or_else(|| panic!("{x} is no small fraction"));
    let numerator = (x * denominator).round() + 0.0;
    if denominator == 1.0 { format!("{numerator}") } else { format!("{numerator}/{denominator}") }
}

/// A table: its unit, the columns' names, and rows of fractions with their names.
fn table(unit: &str, columns: &[&str], rows: &[(&str, Vec<f64>)]) -> String {
    let largest = rows.iter().flat_map(|(_, row)| row).fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let line = |name: &str, cells: Vec<String>| {
        let cells: String = cells.iter().map(|cell| format!("{cell:>10}")).collect();
        format!("{name:<14}{cells}\n")
    };
    let heads = line(unit, columns.iter().map(|name| name.to_string()).collect());
    let lines = rows.iter().map(|(name, row)| line(name, row.iter().map(|x| fraction(*x, largest)).collect()));
    std::iter::once(heads).chain(lines).collect()
}

const SHAPE_HEADING: &str = "\
Shape functions (3) at the nodes i, j, k: x = 0, l/2, l. Those of slopes contain l, and l b = y: divided out.
Each is 1 for its own nodal vector and 0 for the others: S1, S3, S6 in S, S4 in the middle of S_x, the others
in S_y. Sums: the positions' functions add up to 1, and so do the directors'; their derivatives to 0.
";

#[test]
fn shape_functions_at_the_nodes() {
    // Powers of two, so that l and b = y/l are taken out again without rounding.
    let (l, y) = (2.0, 0.5);
    let lb = y;
    let nodes = |S: fn(f64, f64, f64) -> [f64; 7]| [0.0, l / 2.0, l].map(|x| S(x, y, l));
    let section = |title: &str, at: [[f64; 7]; 3], unit: f64| {
        let row = |terms: &[(usize, f64)]| at.map(|S| terms.iter().map(|(i, size)| unit * S[*i] / size).sum()).to_vec();
        let rows = [
            ("S1     r_i", row(&[(0, 1.0)])),
            ("S3     r_j", row(&[(2, 1.0)])),
            ("S6     r_k", row(&[(5, 1.0)])),
            ("S4/l   r_x_j", row(&[(3, l)])),
            ("S2/lb  r_y_i", row(&[(1, lb)])),
            ("S5/lb  r_y_j", row(&[(4, lb)])),
            ("S7/lb  r_y_k", row(&[(6, lb)])),
            ("S1+S3+S6", row(&[(0, 1.0), (2, 1.0), (5, 1.0)])),
            ("(S2+S5+S7)/lb", row(&[(1, lb), (4, lb), (6, lb)])),
        ];
        table(title, &["i", "j", "k"], &rows)
    };
    let S_y = nodes(shape::S_i_y);
    let rows = [("S2     r_y_i", 1), ("S5     r_y_j", 4), ("S7     r_y_k", 6)];
    let across = rows.map(|(name, i)| (name, S_y.map(|S| S[i]).to_vec()));
    let text = [
        SHAPE_HEADING,
        &section("S", nodes(shape::S_i), 1.0),
        &section("l S_x", nodes(shape::S_i_x), l),
        &table("S_y", &["i", "j", "k"], &across),
    ]
    .join("\n");
    insta::assert_snapshot!(text);
}

const MASS_HEADING: &str = "\
Mass matrix (7), M = M7 ⊗ I2, in units of ρAl for the coordinates r, l r_x and h r_y.
sum r adds r_i, r_j, r_k, a translation: Simpson's 1/6, 2/3, 1/6, and the total mass 1.
sum r_y adds the slopes r_y, a turn of the sections: 1/12 of the same, from h²/12.
";

#[test]
fn mass_matrix() {
    let (l, h, w, rho) = (2.0, 0.5, 0.25, 8.0);
    let M = inertia::M(rho, &Element::straight(l, h, w, 0.0));
    // M = M₇ ⊗ I₂, to the last bit: both axes add up the same products, and between them there are none.
    for (row, column) in (0..14).flat_map(|row| (0..14).map(move |column| (row, column))) {
        let expected = if row % 2 == column % 2 { M[(row - row % 2, column - column % 2)] } else { 0.0 };
        assert_eq!(M[(row, column)], expected, "row {row}, column {column}");
    }

    // Place in (4), name and unit of the seven vectors, the axis first.
    let vectors = [
        (0, "r_i", 1.0),
        (2, "r_j", 1.0),
        (5, "r_k", 1.0),
        (3, "r_x_j", l),
        (1, "r_y_i", h),
        (4, "r_y_j", h),
        (6, "r_y_k", h),
    ];
    let entry = |a: usize, b: usize| {
        let ((row, _, unit), (column, _, other)) = (vectors[a], vectors[b]);
        M[(2 * row, 2 * column)] / (rho * l * h * w) / (unit * other)
    };
    let row = |a: usize| {
        let entries: Vec<f64> = (0..7).map(|b| entry(a, b)).collect();
        let sums = [entries[..3].iter().sum(), entries[4..].iter().sum()];
        [entries, sums.to_vec()].concat()
    };
    let mut rows: Vec<(&str, Vec<f64>)> = (0..7).map(|a| (vectors[a].1, row(a))).collect();
    rows.push(("sum r", (0..9).map(|b| rows[..3].iter().map(|(_, row)| row[b]).sum()).collect()));
    let columns = [vectors.map(|(_, name, _)| name).as_slice(), &["sum r", "sum r_y"]].concat();
    let text = [MASS_HEADING, &table("", &columns, &rows)].join("\n");
    insta::assert_snapshot!(text);
}

/// A coordinate's place in e, its name, and what it is multiplied by to be a length.
type Coordinate = (usize, &'static str, f64);

const TANGENT_HEADING: &str = "\
Tangent of the unstretched horizontal element at ν = 0, l/h = 10, in its three blocks: along the rod, bending
and shear, across it; for the coordinates r, l r_x and l r_y. EA/l = 1200 EI/l³, and GA is half of EA.
Below a block: motions, in units of l, and (>) the forces they take. Rigid motions take none; a unit stretch EA
at the ends; a unit curvature EI on the end sections and no shear; a unit shear GA at the ends and GA/6, 2GA/3,
GA/6 on the sections; a unit thickening EA/6, 2EA/3, EA/6.
";

#[test]
fn tangent_at_rest() {
    let (l, h, w, E) = (2.0, 0.2, 0.5, 1e6);
    let element = Element::straight(l, h, w, 0.0);
    let (A, I) = (h * w, w * h.powi(3) / 12.0);
    let K = force::tangent(&element.e_0, &Vector3::zeros(), LameConstants { lambda: 0.0, mu: E / 2.0 }, &element);

    let axial: [Coordinate; 4] = [(0, "r_i x", 1.0), (4, "r_j x", 1.0), (10, "r_k x", 1.0), (6, "r_x_j x", l)];
    let bending: [Coordinate; 7] = [
        (1, "r_i y", 1.0),
        (5, "r_j y", 1.0),
        (11, "r_k y", 1.0),
        (7, "r_x_j y", l),
        (2, "r_y_i x", l),
        (8, "r_y_j x", l),
        (12, "r_y_k x", l),
    ];
    let thickness: [Coordinate; 3] = [(3, "r_y_i y", l), (9, "r_y_j y", l), (13, "r_y_k y", l)];
    // Rigid motions, which cost no force, and uniform strains: their forces are those of statics.
    let axial_motions: [(&str, &[f64]); 2] =
        [("translation", &[1.0, 1.0, 1.0, 0.0]), ("stretch", &[0.0, 0.5, 1.0, 1.0])];
    let bending_motions: [(&str, &[f64]); 4] = [
        ("translation", &[1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0]),
        ("rotation", &[0.0, 0.5, 1.0, 1.0, -1.0, -1.0, -1.0]),
        ("curvature", &[0.0, 0.125, 0.5, 0.5, 0.0, -0.5, -1.0]),
        ("shear", &[0.0, 0.5, 1.0, 1.0, 0.0, 0.0, 0.0]),
    ];
    let thickness_motions: [(&str, &[f64]); 1] = [("thickening", &[1.0, 1.0, 1.0])];

    // The three blocks are all there is.
    let blocks: [&[Coordinate]; 3] = [&axial, &bending, &thickness];
    let block_of = |place: usize| blocks.iter().position(|block| block.iter().any(|(i, ..)| *i == place)).unwrap();
    for (row, column) in (0..14).flat_map(|row| (0..14).map(move |column| (row, column))) {
        let size = (K[(row, row)] * K[(column, column)]).sqrt();
        let apart = block_of(row) != block_of(column);
        assert!(!apart || K[(row, column)].abs() <= 1e-14 * size, "row {row} is coupled with column {column}");
    }

    let text = [
        TANGENT_HEADING,
        &block(&K, "EA/l", E * A / l, &axial, &axial_motions),
        &block(&K, "EI/l^3", E * I / l.powi(3), &bending, &bending_motions),
        &block(&K, "EI/l^3", E * I / l.powi(3), &thickness, &thickness_motions),
    ]
    .join("\n");
    insta::assert_snapshot!(text);
}

/// A block of K with `motions` and its products with them below.
fn block(K: &Matrix14, name: &str, unit: f64, coordinates: &[Coordinate], motions: &[(&str, &[f64])]) -> String {
    let entry = |a: &Coordinate, b: &Coordinate| K[(a.0, b.0)] / unit / (a.2 * b.2);
    let mut rows: Vec<(&str, Vec<f64>)> =
        coordinates.iter().map(|a| (a.1, coordinates.iter().map(|b| entry(a, b)).collect())).collect();
    let product = |motion: &[f64]| -> Vec<f64> {
        rows.iter().map(|(_, row)| row.iter().zip(motion).map(|(k, u)| k * u).sum()).collect()
    };
    let below = motions.iter().flat_map(|(name, motion)| [(*name, motion.to_vec()), (">", product(motion))]);
    let below: Vec<(&str, Vec<f64>)> = below.collect();
    rows.extend(below);
    table(name, &coordinates.iter().map(|(_, name, _)| *name).collect::<Vec<_>>(), &rows)
}
