//! Tables for people to review: the shape functions at the nodes, the mass matrix, the tangent at rest; strains, force
//! and tangent of a bent, heated, inclined element.
//!
//! They are no oracle (`fixtures.rs` is); they show what the numbers are, with sums that can be done by hand. To take a
//! changed table over, run with `INSTA_UPDATE=always` and read the difference.

#![allow(non_snake_case)] // The paper's symbols are names here.

mod common;

use ancf::equations::element::{Element, Matrix14};
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::shape::{Nodes, Vector14};
use ancf::equations::{force, inertia, shape, strain};
use nalgebra::{Matrix2, Vector2, Vector3};

/// x as a fraction of small numbers, to 1e-13 of the table's largest entry; a zero has no sign. Denominators to 1000 meet
/// an arbitrary number that closely less than once in a thousand times. What is no such fraction is a decimal of six
/// digits, so that a table of wrong numbers can be read and compared.
fn fraction(x: f64, largest: f64) -> String {
    let small = (1..=1000).map(f64::from).find(|d| (x - (x * d).round() / d).abs() <= 1e-13 * largest);
    let Some(denominator) = small else { return decimal(x) };
    let numerator = (x * denominator).round() + 0.0;
    if denominator == 1.0 { format!("{numerator}") } else { format!("{numerator}/{denominator}") }
}

/// x with six digits, no more than six of them behind the point.
fn decimal(x: f64) -> String {
    let behind = (5.0 - x.abs().log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{x:.behind$}")
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

const BENT_HEADING: &str = "\
An element of ν = 0.3, bent, heated and inclined: l = 2, h = 2, w = 1, cos θ = 3/5, sin θ = 4/5; E = 26, so that
λ = 15, μ = 10, λ + 2μ = 35; α_T ΔT = 1/8. In its own axes it is bent by κ = 1/2 to r = (x - xy/2, x²/4 + y),
so that r_x = (1 - y/2, x/2) and r_y = (-x/2, 1). Its elastic strains there are those less heat:
  ε11 = -y/2 + (x² + y²)/8 - 1/8,  ε22 = x²/8 - 1/8,  ε12 = x²y/8.
";

const STRAINS_HEADING: &str = "\
Elastic strains (14) at points (x, y), by the closed form (11) for θ = 0 (own axes) and for θ (global axes):
  ε1 = (9 ε11 + 16 ε22 - 24 ε12)/25,  ε2 = (16 ε11 + 9 ε22 + 24 ε12)/25,  ε3 = (12 ε11 - 12 ε22 - 7 ε12)/25.
";

const FORCE_HEADING: &str = "\
Elastic forces (19) in the rod's own axes, along it and across it: on positions, and on slopes their moments.
Below: motions, and (work) what the forces do on them: nothing on a translation, nor on the rotation of the bent
element. stretch moves r by (x, 0), thicken by (0, y). Means over the volume 4: of x², 4/3; of y², 1/3; of what is
odd in y, 0; so of ε11, 1/12; of ε22, 1/24; of σ11, (35/12 + 15/24) = 85/24; of σ22, 65/24; of σ11 y, -35/6.
  stretch: 4 (mean of σ11 (1 - y/2) - σ12 x/2) = 4 (85/24 + 35/12) = 155/6
  thicken: 4 (mean of σ22 + σ12 x/2)           = 4 · 65/24         = 65/6
";

const BENT_TANGENT_HEADING: &str = "\
Tangent in the rod's own axes: forces on the rows' coordinates from the columns', along-along, along-across,
across-across. Below: motions and (>) the forces they take: none for a translation; for the rotation, the forces
above turned by a right angle. stretch and thicken take work on each other:
  stretch, stretch: 4 (mean of 35 (1 - y/2)² + 10 (x/2)² + σ11) = 4 (35 · 13/12 + 10/3 + 85/24) = 1075/6
  stretch, thicken: 4 (mean of 15 (1 - y/2) - 10 (x/2)²)        = 4 (15 - 10/3)                 = 140/3
  thicken, thicken: 4 (mean of 35 + 10 (x/2)² + σ22)            = 4 (35 + 10/3 + 65/24)         = 985/6
";

/// Names of the nodal vectors, in the order of (4).
const VECTORS: [&str; 7] = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];

#[test]
fn bent_heated_inclined_element() {
    let (l, h, w, kappa, theta) = (2.0, 2.0, 1.0, 0.5, f64::atan2(4.0, 3.0));
    let (lame, eps_T) = (LameConstants::from(YoungPoisson { E: 26.0, nu: 0.3 }), strain::eps_T(1.0, 0.125));
    let element = Element::straight(l, h, w, theta);
    // Position, r_x and r_y at (x, 0), in the rod's own axes.
    let r = |x: f64| Vector2::new(x, 0.5 * kappa * x * x);
    let (r_x, r_y) = (|x: f64| Vector2::new(1.0, kappa * x), |x: f64| Vector2::new(-kappa * x, 1.0));
    let (r_i, r_j, r_k) = (r(0.0), r(0.5 * l), r(l));
    let own =
        shape::e(&Nodes { r_i, r_y_i: r_y(0.0), r_j, r_x_j: r_x(0.5 * l), r_y_j: r_y(0.5 * l), r_k, r_y_k: r_y(l) });
    let e = each_vector(&own, &strain::J_0_theta(theta));

    let K_123 = (force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element), force::K_3(&e, &eps_T, &element));
    let Q_e = force::Q_e(&e, &force::K(lame, &K_123.0, &K_123.1, &K_123.2));
    // Columns turn by columns, rows by those of the transpose; the tangent is symmetric.
    let into_own = |M: &Matrix14| {
        let columns: Vec<Vector14> =
            M.column_iter().map(|column| each_vector(&column.into_owned(), &strain::J_0_theta(-theta))).collect();
        Matrix14::from_columns(&columns).transpose()
    };
    let tangent = into_own(&into_own(&force::tangent(&e, &eps_T, lame, &element)));
    let text = [
        BENT_HEADING,
        STRAINS_HEADING,
        &strains_table(&own, &e, &eps_T, l, theta),
        FORCE_HEADING,
        &force_table(&each_vector(&Q_e, &strain::J_0_theta(-theta)), &own),
        BENT_TANGENT_HEADING,
        &tangent_tables(&tangent, &own),
    ]
    .join("\n");
    insta::assert_snapshot!(text);
}

/// Each of the seven vectors of a column times a 2 × 2 matrix.
fn each_vector(column: &Vector14, matrix: &Matrix2<f64>) -> Vector14 {
    let vectors: Vec<f64> =
        (0..7).flat_map(|n| <[f64; 2]>::from(matrix * Vector2::new(column[2 * n], column[2 * n + 1]))).collect();
    Vector14::from_column_slice(&vectors)
}

/// Motions of the bent element in its own axes, with their names.
fn motions(own: &Vector14) -> [(&'static str, Vector14); 5] {
    let vectors = |position: fn(f64) -> [f64; 2], slope_x: [f64; 2], slope_y: [f64; 2]| {
        let [r_i, r_j, r_k] = [0.0, 1.0, 2.0].map(position);
        Vector14::from_column_slice(&[r_i, slope_y, r_j, slope_x, slope_y, r_k, slope_y].concat())
    };
    let none = [0.0, 0.0];
    [
        ("move along", vectors(|_| [1.0, 0.0], none, none)),
        ("move across", vectors(|_| [0.0, 1.0], none, none)),
        ("rotation", each_vector(own, &Matrix2::new(0.0, -1.0, 1.0, 0.0))),
        ("stretch", vectors(|x| [x, 0.0], [1.0, 0.0], none)),
        ("thicken", vectors(|_| [0.0, 0.0], none, [0.0, 1.0])),
    ]
}

/// Strains at points, in the rod's own axes and in global axes.
fn strains_table(own: &Vector14, e: &Vector14, eps_T: &Vector3<f64>, l: f64, theta: f64) -> String {
    let strains = |(x, y): (f64, f64), e: &Vector14, theta: f64| {
        let (S_a, S_b, S_c) = strain::S_abc_theta(x, y, l, theta);
        strain::eps(&strain::eps_f(strain::eps_1(e, &S_a), strain::eps_2(e, &S_b), strain::eps_3(e, &S_c)), eps_T)
    };
    let points = [("(0, 1)", (0.0, 1.0)), ("(1, 0)", (1.0, 0.0)), ("(1, -1)", (1.0, -1.0)), ("(2, 1)", (2.0, 1.0))];
    let row = |at| [strains(at, own, 0.0), strains(at, e, theta)].iter().flat_map(|eps| eps.iter().copied()).collect();
    table("(x, y)", &["ε11", "ε22", "ε12", "ε1", "ε2", "ε3"], &points.map(|(name, at)| (name, row(at))))
}

/// Components along and across of the vectors of a column.
fn components(column: &Vector14) -> [Vec<f64>; 2] {
    [0, 1].map(|axis| column.iter().skip(axis).step_by(2).copied().collect())
}

/// Elastic forces along and across, and below them motions with the forces' work.
fn force_table(Q_e: &Vector14, own: &Vector14) -> String {
    let two = |names: [&'static str; 2], column: &Vector14, work: Option<f64>| {
        let [along, across] = components(column);
        [(names[0], along), (names[1], [across, work.into_iter().collect()].concat())]
    };
    let mut rows = two(["along", "across"], Q_e, None).to_vec();
    for (name, motion) in motions(own) {
        rows.extend(two([name, ""], &motion, Some(Q_e.dot(&motion))));
    }
    table("Q_e", &[VECTORS.as_slice(), &["work"]].concat(), &rows)
}

/// Blocks of the tangent, and below them motions with the forces they take, and their work on each other.
fn tangent_tables(K: &Matrix14, own: &Vector14) -> String {
    let block = |name, row_axis: usize, column_axis: usize| {
        let row = |a: usize| (0..7).map(|b| K[(2 * a + row_axis, 2 * b + column_axis)]).collect();
        table(name, &VECTORS, &(0..7).map(|a| (VECTORS[a], row(a))).collect::<Vec<_>>())
    };
    let motions = motions(own);
    let taken = motions.iter().flat_map(|(name, motion)| {
        let [along, across] = components(&(K * motion));
        [(*name, along), (">", across)]
    });
    let of = |n: usize| &motions[n].1;
    let work = |a: usize, b: usize| of(a).dot(&(K * of(b)));
    let works = [("stretch", vec![work(3, 3), work(3, 4)]), ("thicken", vec![work(4, 3), work(4, 4)])];
    [
        block("along, along", 0, 0),
        block("along, across", 0, 1),
        block("across, across", 1, 1),
        table("forces", &VECTORS, &taken.collect::<Vec<_>>()),
        table("work", &["stretch", "thicken"], &works),
    ]
    .join("\n")
}
