//! Figure 1: the element, its nodal vectors, and the position of a material point.

use std::iter::once;

use nalgebra::Vector2;

use ancf::equations::shape::{self, Nodes, Vector14};

use crate::drawing::{Drawing, Line};
use crate::picture::Picture;

/// Length and height of the drawn element, m; a rod of the paper would be a line at this size.
const L: f64 = 4.0;
const H: f64 = 0.7;

/// Pixels: of the picture, of a metre, and of the origin.
const SIZE: [f64; 2] = [760.0, 400.0];
const METRE: f64 = 125.0;
const ORIGIN: [f64; 2] = [70.0, 350.0];

/// Length at which a slope is drawn, m: its own would run out of the body.
const SLOPE: f64 = 0.75;

/// Its file.
pub const FILE: &str = "figure1.svg";

/// The picture with its caption.
pub fn picture() -> Picture {
    let caption = "Figure 1: the element. Seven vectors give the position of each of its points: three positions and four slopes.";
    Picture { file: FILE, caption, svg: svg() }
}

/// The body is (1) for these nodal vectors: bent, stretched and sheared.
fn svg() -> String {
    let nodes = Nodes {
        r_i: Vector2::new(0.55, 0.75),
        r_y_i: Vector2::new(-0.42, 0.95),
        r_j: Vector2::new(2.35, 1.7),
        r_x_j: Vector2::new(1.02, 0.22),
        r_y_j: Vector2::new(-0.2, 1.0),
        r_k: Vector2::new(4.35, 1.45),
        r_y_k: Vector2::new(0.3, 0.98),
    };
    let e = shape::e(&nodes);
    let mut drawing = Drawing::new(
        "figure1",
        SIZE,
        "A bent beam element with nodes i, j and k, the slope across it at each node, the slope along it at j, and the position r of a point p",
    );
    axes(&mut drawing);
    drawing.body(&outline(&e));
    drawing.line(&along(&e, 0.0), Line::Dashed);
    let Nodes { r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k } = nodes;
    for (position, letter, places) in [(r_i, "i", [-4.0, 24.0]), (r_j, "j", [-2.0, 26.0]), (r_k, "k", [8.0, 20.0])] {
        let [x, y] = place(position);
        drawing.dot([x, y]);
        drawing.words([x + places[0], y + places[1]], letter);
    }
    for (position, slope, letters) in [
        (r_i, r_y_i, ["r", "i", "y"]),
        (r_j, r_y_j, ["r", "j", "y"]),
        (r_k, r_y_k, ["r", "k", "y"]),
        (r_j, r_x_j, ["r", "j", "x"]),
    ] {
        let end = place(position + SLOPE * slope);
        drawing.line(&[place(position), end], Line::Arrow);
        drawing.letters([end[0] + 7.0, end[1] + 2.0], true, letters);
    }
    let p = place(shape::r(0.78 * L, -0.25 * H, &e, L));
    drawing.line(&[ORIGIN, p], Line::Arrow);
    drawing.dot(p);
    drawing.words([p[0] + 8.0, p[1] + 6.0], "p");
    let middle = [0.5 * (ORIGIN[0] + p[0]), 0.5 * (ORIGIN[1] + p[1])];
    drawing.letters([middle[0] + 4.0, middle[1] + 22.0], true, ["r = S(x, y) e", "", ""]);
    drawing.finish()
}

fn axes(drawing: &mut Drawing) {
    let [x, y] = ORIGIN;
    drawing.line(&[ORIGIN, [x + 90.0, y]], Line::Arrow);
    drawing.line(&[ORIGIN, [x, y - 90.0]], Line::Arrow);
    drawing.words([x + 96.0, y + 5.0], "X");
    drawing.words([x - 5.0, y - 98.0], "Y");
    drawing.words([x - 18.0, y + 18.0], "O");
}

/// The line of all points at the height y.
fn along(e: &Vector14, y: f64) -> Vec<[f64; 2]> {
    (0..=40).map(|n| place(shape::r(L * f64::from(n) / 40.0, y, e, L))).collect()
}

fn outline(e: &Vector14) -> Vec<[f64; 2]> {
    let [lower, upper] = [-0.5 * H, 0.5 * H].map(|y| along(e, y));
    lower.into_iter().chain(upper.into_iter().rev()).chain(once(place(shape::r(0.0, -0.5 * H, e, L)))).collect()
}

fn place(position: Vector2<f64>) -> [f64; 2] {
    [ORIGIN[0] + METRE * position.x, ORIGIN[1] - METRE * position.y]
}
