//! Each equation as the terms that it adds up: one of them with the other sign, half, twice, or missing.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{DVector, SVector, Vector2};

use super::stations::{K, Station, material, product, stations};
use super::variants::rows;
use super::{Candidate, Kind, candidate, own_shape};
use crate::conformance::suite::{Case, Parsed, Reference};
use crate::equations::force::{self, Matrix14};
use crate::equations::shape::{self, Vector14};
use crate::equations::{inertia, material as law, motion, strain};
use crate::state::{ElementState, SystemState};

/// What is done to a term or to all of it.
const CHANGES: [(Kind, &str, f64); 7] = [
    (Kind::Sign, "with the other sign", -1.0),
    (Kind::Factor, "half", 0.5),
    (Kind::Factor, "twice", 2.0),
    (Kind::Factor, "a quarter", 0.25),
    (Kind::Factor, "four times", 4.0),
    (Kind::Missing, "missing", 0.0),
    (Kind::Sign, "with the other sign and half", -0.5),
];

/// A term's name and its numbers.
type Term = (String, Vec<f64>);

/// Every term changed.
pub(super) fn of(quantity: &str, case: &Case) -> Vec<Candidate> {
    let Some(reference) = case.values.get(quantity) else { return Vec::new() };
    let terms = match &case.parsed {
        Parsed::Element(state) => of_element(quantity, state),
        Parsed::System(system) => of_system(quantity, system),
        Parsed::Other => Vec::new(),
    };
    let changed = |term: &[f64], factor: f64| {
        reference.numbers.iter().zip(term).map(|(all, part)| all + (factor - 1.0) * part).collect()
    };
    let each = |(name, term): &Term| {
        CHANGES.map(|(kind, how, factor)| candidate(kind, format!("{name} {how}"), changed(term, factor)))
    };
    terms.iter().flat_map(each).collect()
}

/// All of it changed.
pub(super) fn whole(reference: &Reference) -> Vec<Candidate> {
    let times = |factor: f64| reference.numbers.iter().map(|value| factor * value).collect();
    CHANGES.map(|(kind, how, factor)| candidate(kind, format!("all of it {how}"), times(factor))).into()
}

/// One entry, or all entries of one nodal vector, changed at every point.
pub(super) fn components(quantity: &str, reference: &Reference) -> Vec<Candidate> {
    let shape = own_shape(quantity, reference);
    let size = shape.iter().product::<usize>().max(1);
    let changed = |of: &dyn Fn(usize) -> bool, factor: f64| -> Vec<f64> {
        let entries = reference.numbers.iter().enumerate();
        entries.map(|(n, value)| if of(n % size) { factor * value } else { *value }).collect()
    };
    let mut all = Vec::new();
    let mut add = |what: String, of: &dyn Fn(usize) -> bool| {
        all.extend(CHANGES.map(|(kind, how, factor)| candidate(kind, format!("{what} {how}"), changed(of, factor))));
    };
    const VECTORS: [&str; 7] = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];
    match *shape {
        [] => {}
        [14] => VECTORS.iter().enumerate().for_each(|(k, name)| add(format!("the entries of {name}"), &|n| n / 2 == k)),
        [14, 14] | [2, 14] => VECTORS.iter().enumerate().for_each(|(k, name)| {
            add(format!("the columns of {name}"), &|n| n % 14 / 2 == k);
            add(format!("rows and columns of {name}"), &|n| n % 14 / 2 == k || n / 28 == k);
        }),
        [_, 2] if size > 4 => (0..size / 2).for_each(|row| add(format!("row {}", row + 1), &|n| n / 2 == row)),
        _ if size <= 9 => (0..size).for_each(|entry| add(super::place(entry, shape), &|n| n == entry)),
        _ => {}
    }
    if shape.last() == Some(&2) || *shape == [14] {
        for (component, name) in ["x", "y"].into_iter().enumerate() {
            add(format!("the components along {name}"), &|n| n % 2 == component);
        }
    }
    all
}

fn term(name: impl Into<String>, numbers: Vec<f64>) -> Term {
    (name.into(), numbers)
}

/// Terms of vectors, point by point: of the function's list at each point, the numbers of each term in a row.
fn at_points(state: &ElementState, names: &[String], at: impl Fn(f64, f64) -> Vec<Vec<f64>>) -> Vec<Term> {
    let points: Vec<Vec<Vec<f64>>> = state.points.iter().map(|&[x, y]| at(x, y)).collect();
    let of = |k: usize| points.iter().filter_map(|terms| terms.get(k)).flatten().copied().collect();
    names.iter().enumerate().map(|(k, name)| term(name.clone(), of(k))).collect()
}

/// The names as strings.
fn named(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| name.to_string()).collect()
}

/// S₁ … S₇: whether y or l stands before it, and the coefficients of aⁿ.
const POLYNOMIALS: [(char, [f64; 4]); 7] = [
    ('1', [1.0, -5.0, 8.0, -4.0]),
    ('y', [1.0, -3.0, 2.0, 0.0]),
    ('1', [0.0, 4.0, -4.0, 0.0]),
    ('l', [0.0, -2.0, 6.0, -4.0]),
    ('y', [0.0, 4.0, -4.0, 0.0]),
    ('1', [0.0, 1.0, -4.0, 4.0]),
    ('y', [0.0, -1.0, 2.0, 0.0]),
];

/// Terms of (3) or of its derivative in x or y.
fn of_shapes(derivative: Option<char>, state: &ElementState) -> Vec<Term> {
    let mut terms = Vec::new();
    for (i, (before, coefficients)) in POLYNOMIALS.iter().enumerate() {
        for (n, c) in coefficients.iter().enumerate().filter(|(_, c)| **c != 0.0) {
            let value = |[x, y]: [f64; 2]| {
                let a = x / state.l;
                let factor = match (derivative, before) {
                    (Some('y'), 'y') => 1.0,
                    (Some('y'), _) => 0.0,
                    (_, 'y') => y,
                    (_, 'l') => state.l,
                    _ => 1.0,
                };
                let power = if derivative == Some('x') {
                    if n == 0 { 0.0 } else { n as f64 * a.powi(n as i32 - 1) / state.l }
                } else {
                    a.powi(n as i32)
                };
                factor * c * power
            };
            let numbers = state.points.iter().flat_map(|point| {
                let mut row = [0.0; 7];
                row[i] = value(*point);
                row
            });
            terms.push(term(format!("in S_{} the term {c} a^{n}", i + 1), numbers.collect()));
        }
    }
    terms
}

/// Terms of (A.3): the row, then the nodal vectors' shares in it.
fn of_coefficients(state: &ElementState) -> Vec<Term> {
    let v = |k: usize| Vector2::new(state.e[2 * k], state.e[2 * k + 1]);
    let l = state.l;
    const NAMES: [&str; 7] = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];
    let shares: [&[(usize, f64)]; 7] = [
        &[(0, 1.0)],
        &[(0, -5.0 / l), (2, 4.0 / l), (5, 1.0 / l), (3, -2.0)],
        &[(1, 1.0)],
        &[(1, -3.0 / l), (4, 4.0 / l), (6, -1.0 / l)],
        &[(0, 8.0 / l.powi(2)), (2, -4.0 / l.powi(2)), (5, -4.0 / l.powi(2)), (3, 6.0 / l)],
        &[(0, -4.0 / l.powi(3)), (5, 4.0 / l.powi(3)), (3, -4.0 / l.powi(2))],
        &[(1, 2.0 / l.powi(2)), (4, -4.0 / l.powi(2)), (6, 2.0 / l.powi(2))],
    ];
    let mut terms = Vec::new();
    for (row, shares) in shares.iter().enumerate() {
        for (k, factor) in *shares {
            let mut numbers = vec![0.0; 14];
            let share = v(*k) * *factor;
            (numbers[2 * row], numbers[2 * row + 1]) = (share[0], share[1]);
            terms.push(term(format!("in a_{row} the term of {}", NAMES[*k]), numbers));
        }
    }
    terms
}

/// Terms of an element's quantity.
fn of_element(quantity: &str, state: &ElementState) -> Vec<Term> {
    let l = state.l;
    let (e, e_dot, element, eps_T) =
        (Vector14::from(state.e), Vector14::from(state.edot), state.element(), state.eps_T());
    let list = |v: Vector2<f64>| vec![v[0], v[1]];
    let c = shape::coefficients(&shape::nodes(&e), l);
    let nodal =
        |e: &Vector14, S: [f64; 7]| (0..7).map(|i| vec![S[i] * e[2 * i], S[i] * e[2 * i + 1]]).collect::<Vec<_>>();
    let sums: Vec<String> = (1..=7).map(|i| format!("the term of S_{i}")).collect();
    let halves = |S: &Matrix14| vec![vec![0.5 * e.dot(&(S * e))], vec![-0.5]];
    match quantity {
        "A.1.r" => {
            at_points(state, &named(&["a_0", "a_1 x", "a_2 y", "a_3 xy", "a_4 x²", "a_5 x³", "a_6 x²y"]), |x, y| {
                [1.0, x, y, x * y, x * x, x.powi(3), x * x * y].iter().zip(c).map(|(m, a)| list(a * *m)).collect()
            })
        }
        "A.1.r_x" => at_points(state, &named(&["a_1", "a_3 y", "2 a_4 x", "3 a_5 x²", "2 a_6 xy"]), |x, y| {
            vec![list(c[1]), list(c[3] * y), list(c[4] * 2.0 * x), list(c[5] * 3.0 * x * x), list(c[6] * 2.0 * x * y)]
        }),
        "A.1.r_y" => at_points(state, &named(&["a_2", "a_3 x", "a_6 x²"]), |x, _| {
            vec![list(c[2]), list(c[3] * x), list(c[6] * x * x)]
        }),
        "A.3.coefficients" => of_coefficients(state),
        "A.4.r" | "1.r" => at_points(state, &sums, |x, y| nodal(&e, shape::S_i(x, y, l))),
        "5.rdot" => at_points(state, &sums, |x, y| nodal(&e_dot, shape::S_i(x, y, l))),
        "3.S" => of_shapes(None, state),
        "3.S_x" => of_shapes(Some('x'), state),
        "3.S_y" => of_shapes(Some('y'), state),
        "10.epsilon_m" => at_points(state, &named(&["½ JᵀJ", "−½ I"]), |x, y| {
            let J = strain::J(x, y, &e, &element);
            vec![rows(&(0.5 * J.transpose() * J)), vec![-0.5, 0.0, 0.0, -0.5]]
        }),
        "11.S_a" | "11.S_b" | "11.S_c" => of_metric(quantity, state),
        "13.epsilon_1" => {
            at_points(state, &named(&["½ eᵀS_a e", "−½"]), |x, y| halves(&strain::S_abc(x, y, &element).0))
        }
        "13.epsilon_2" => {
            at_points(state, &named(&["½ eᵀS_b e", "−½"]), |x, y| halves(&strain::S_abc(x, y, &element).1))
        }
        // The −½ is not there: half of it too much is the −½ itself.
        "13.epsilon_3" => at_points(state, &named(&["½ eᵀS_c e", "a −½ that is not there,"]), |x, y| {
            halves(&strain::S_abc(x, y, &element).2)
        }),
        "14.epsilon" => at_points(state, &named(&["ε_f", "−ε_T"]), |x, y| {
            let eps_f = strain::J(x, y, &e, &element);
            let eps_m = strain::eps_m(&eps_f);
            vec![vec![eps_m[(0, 0)], eps_m[(1, 1)], eps_m[(0, 1)]], rows(&(-eps_T))]
        }),
        "21.S_a1" | "21.S_b1" | "21.S_c1" => at_points(state, &named(&["S", "Sᵀ"]), |x, y| {
            let (S_a, S_b, S_c) = strain::S_abc(x, y, &element);
            let S = match quantity {
                "21.S_a1" => S_a,
                "21.S_b1" => S_b,
                _ => S_c,
            };
            vec![rows(&S), rows(&S.transpose())]
        }),
        "15.sigma" | "18.U" | "19.Q_e" | "20.K" | "21.K_1" | "21.K_2" | "21.K_3" | "tangent.dQ_e" | "22.residual"
        | "22.eddot" => of_forces(quantity, state),
        _ => Vec::new(),
    }
}

/// The four products of (11).
fn of_metric(quantity: &str, state: &ElementState) -> Vec<Term> {
    let (sin, cos) = state.theta.sin_cos();
    let factors = match quantity {
        "11.S_a" => [cos * cos, -sin * cos, -sin * cos, sin * sin],
        "11.S_b" => [sin * sin, sin * cos, sin * cos, cos * cos],
        _ => [sin * cos, cos * cos, -sin * sin, -sin * cos],
    };
    let names = named(&["the term S_ixᵀS_ix", "the term S_ixᵀS_iy", "the term S_iyᵀS_ix", "the term S_iyᵀS_iy"]);
    at_points(state, &names, |x, y| {
        let (S_x, S_y) = (shape::S_x(x, y, state.l), shape::S_y(x, y, state.l));
        let products = [S_x.tr_mul(&S_x), S_x.tr_mul(&S_y), S_y.tr_mul(&S_x), S_y.tr_mul(&S_y)];
        products.iter().zip(factors).map(|(product, factor)| rows(&(product * factor))).collect()
    })
}

/// Terms from the stress to the acceleration.
fn of_forces(quantity: &str, state: &ElementState) -> Vec<Term> {
    let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
    let (lambda, mu) = (law::lambda(state.E, state.nu), law::mu(state.E, state.nu));
    let stations = stations(&e, &element);
    let matrices = |terms: Vec<(&str, Matrix14)>| terms.iter().map(|(name, K)| term(*name, rows(K))).collect();
    let K_m = || [force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element), force::K_3(&e, &eps_T, &element)];
    let parts = || {
        let [K_1, K_2, K_3] = K_m();
        vec![
            ("λ K_1", lambda * K_1),
            ("2μ K_1", 2.0 * mu * K_1),
            ("(λ + 2μ) K_1", (lambda + 2.0 * mu) * K_1),
            ("λ K_2", lambda * K_2),
            ("4μ K_3", 4.0 * mu * K_3),
        ]
    };
    let integrated = |name: &str, weights: &dyn Fn(&Station) -> [f64; 3]| term(name, rows(&K(&stations, weights)));
    match quantity {
        "15.sigma" => {
            let D = law::D(lambda, mu);
            let names = named(&["what ε_1 adds", "what ε_2 adds", "what ε_3 adds"]);
            at_points(state, &names, |x, y| {
                let eps_m = strain::eps_m(&strain::J(x, y, &e, &element));
                let eps = nalgebra::Vector3::new(eps_m[(0, 0)], eps_m[(1, 1)], eps_m[(0, 1)]) - eps_T;
                (0..3).map(|n| rows(&(D.column(n) * eps[n]))).collect()
            })
        }
        "18.U" => {
            let squares = [
                (0, 0, 0.5 * (lambda + 2.0 * mu)),
                (1, 1, 0.5 * (lambda + 2.0 * mu)),
                (0, 1, lambda),
                (2, 2, 2.0 * mu),
            ];
            let names = ["the square of ε_1", "the square of ε_2", "the product ε_1 ε_2", "the square of ε_3"];
            let value = |(k, n, factor): (usize, usize, f64)| vec![factor * product(&stations, &eps_T, k, n)];
            names.iter().zip(squares).map(|(name, square)| term(*name, value(square))).collect()
        }
        "20.K" => matrices(parts()),
        "19.Q_e" => parts().iter().map(|(name, K)| term(format!("{name} e"), rows(&(K * e)))).collect(),
        "21.K_1" => vec![
            integrated("eᵀS_a e", &|s| [s.form[0], 0.0, 0.0]),
            integrated("eᵀS_b e", &|s| [0.0, s.form[1], 0.0]),
            integrated("−1 beside eᵀS_a e", &|_| [-1.0, 0.0, 0.0]),
            integrated("−1 beside eᵀS_b e", &|_| [0.0, -1.0, 0.0]),
            integrated("−1 in both brackets", &|_| [-1.0, -1.0, 0.0]),
            integrated("heat in both brackets", &|_| [-2.0 * eps_T[0], -2.0 * eps_T[1], 0.0]),
            integrated("heat beside eᵀS_a e", &|_| [-2.0 * eps_T[0], 0.0, 0.0]),
            integrated("heat beside eᵀS_b e", &|_| [0.0, -2.0 * eps_T[1], 0.0]),
            integrated("the bracket with S_a1", &|s| [s.form[0] - 1.0 - 2.0 * eps_T[0], 0.0, 0.0]),
            integrated("the bracket with S_b1", &|s| [0.0, s.form[1] - 1.0 - 2.0 * eps_T[1], 0.0]),
        ],
        "21.K_2" => vec![
            integrated("eᵀS_b e", &|s| [s.form[1], 0.0, 0.0]),
            integrated("eᵀS_a e", &|s| [0.0, s.form[0], 0.0]),
            integrated("−1 beside eᵀS_b e", &|_| [-1.0, 0.0, 0.0]),
            integrated("−1 beside eᵀS_a e", &|_| [0.0, -1.0, 0.0]),
            integrated("−1 in both brackets", &|_| [-1.0, -1.0, 0.0]),
            integrated("heat in both brackets", &|_| [-2.0 * eps_T[1], -2.0 * eps_T[0], 0.0]),
            integrated("heat beside eᵀS_b e", &|_| [-2.0 * eps_T[1], 0.0, 0.0]),
            integrated("heat beside eᵀS_a e", &|_| [0.0, -2.0 * eps_T[0], 0.0]),
            integrated("the bracket with S_a1", &|s| [s.form[1] - 1.0 - 2.0 * eps_T[1], 0.0, 0.0]),
            integrated("the bracket with S_b1", &|s| [0.0, s.form[0] - 1.0 - 2.0 * eps_T[0], 0.0]),
        ],
        "21.K_3" => vec![
            integrated("eᵀS_c e", &|s| [0.0, 0.0, s.form[2]]),
            integrated("heat", &|_| [0.0, 0.0, -2.0 * eps_T[2]]),
        ],
        "tangent.dQ_e" => {
            let stiff = lambda + 2.0 * mu;
            let of = |weights| material(&stations, &e, weights);
            let one = of([[stiff, 0.0, 0.0], [0.0, stiff, 0.0], [0.0; 3]]);
            let two = of([[0.0, lambda, 0.0], [lambda, 0.0, 0.0], [0.0; 3]]);
            let three = of([[0.0; 3], [0.0; 3], [0.0, 0.0, 4.0 * mu]]);
            let [K_1, K_2, K_3] = K_m();
            let stiffness = force::K(lambda, mu, &K_1, &K_2, &K_3);
            let mut terms = vec![
                ("K, the part with the stress,", stiffness),
                ("the material part", one + two + three),
                ("the material part of ε_1 and ε_2", one),
                ("the material part of ε_1 with ε_2", two),
                ("the material part of ε_3", three),
            ];
            terms.extend(parts());
            matrices(terms)
        }
        "22.residual" | "22.eddot" => {
            let Q = rows(&force::Q_e(&e, &{
                let [K_1, K_2, K_3] = K_m();
                force::K(lambda, mu, &K_1, &K_2, &K_3)
            }));
            let Q = Vector14::from_row_slice(&Q);
            let M = inertia::M(state.rho, &element);
            let Q_w = inertia::Q_w_gravity(&Vector2::from(state.gravity), state.rho, &element);
            if quantity == "22.residual" {
                let inertia = M * Vector14::from(state.edot);
                return vec![term("M ë", rows(&inertia)), term("Q_e", rows(&Q)), term("−Q_w", rows(&(-Q_w)))];
            }
            let zero = SVector::zeros();
            let solved = |Q_e: &Vector14, Q_w: &Vector14| motion::acceleration(&M, Q_e, Q_w).map(|a| rows(&a));
            let (of_Q_e, of_Q_w) = (solved(&Q, &zero), solved(&zero, &Q_w));
            [("what Q_e adds", of_Q_e), ("what Q_w adds", of_Q_w)]
                .into_iter()
                .filter_map(|(name, numbers)| Some(term(name, numbers?)))
                .collect()
        }
        _ => Vec::new(),
    }
}

/// Terms of (23).
fn of_system(quantity: &str, system: &SystemState) -> Vec<Term> {
    let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = system;
    let zero = DVector::zeros(kq.len());
    let solved = |kq: &DVector<f64>, f: &DVector<f64>| {
        let (acceleration, lambda) = motion::system_acceleration(m, kq, Phi_q, f)?;
        Some(if quantity == "23.lambda" { rows(&lambda) } else { rows(&acceleration) })
    };
    match quantity {
        "23.residual" => vec![
            term("m q̈", rows(&(m * q_ddot))),
            term("k q", rows(kq)),
            term("Φ_qᵀ λ", rows(&motion::constraint_force(Phi_q, lambda))),
            term("−f", rows(&(-f))),
        ],
        "23.acceleration" | "23.lambda" => [("what k q adds", solved(kq, &zero)), ("what f adds", solved(&zero, f))]
            .into_iter()
            .filter_map(|(name, numbers)| Some(term(name, numbers?)))
            .collect(),
        _ => Vec::new(),
    }
}
