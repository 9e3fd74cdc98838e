//! Conventions are not mistakes: right programs with conventions of their own pass, and a mistake beside a convention is found.
//!
//! The programs here transform the reference values with matrices: e′ = T e, S′ = S T⁻¹, M′ = T⁻ᵀ M T⁻¹, ε′ = B ε, D′ = P D B⁻¹. They
//! share nothing with the kit's own translation.

#![allow(non_snake_case)] // The paper's symbols are names here.

use std::sync::LazyLock;

use ancf::state::{CableState, ElementState, evaluate, evaluate_cable};
use ancf_conform::{Answer, Asked, Code, Hello, How, Options, Report, Subject, Suite, examine};
use nalgebra::{DMatrix, DVector};
use serde_json::{Value, json};

static SUITE: LazyLock<Suite> = LazyLock::new(|| Suite::embedded().unwrap());

/// Quantities that a program without insight into its element gives.
const BLACK_BOX: [&str; 3] = ["7.M", "19.Q_e", "tangent.dQ_e"];

/// Quantities that tell all conventions of the element.
const TELLING: [&str; 16] = [
    "4.nodes",
    "2.S",
    "1.r",
    "5.rdot",
    "7.M",
    "8.epsilon_T",
    "9.J",
    "11.S_c",
    "13.epsilon_3",
    "12.epsilon_f",
    "14.epsilon",
    "16.D",
    "15.sigma",
    "18.U",
    "21.S_c1",
    "19.Q_e",
];

/// Value of a quantity with a mistake; `None` where it is right.
type MistakeOf = fn(&str, &ElementState) -> Option<Vec<f64>>;

/// A program that is right but for its conventions, and perhaps for one mistake.
#[derive(Clone)]
struct Mine {
    /// Vector in the program's e → vector in (4).
    order: [usize; 7],
    cable_order: [usize; 4],
    all_x_then_all_y: bool,
    /// Factors of r_x and r_y as functions of l and h.
    slopes: fn(f64, f64) -> [f64; 2],
    /// Component in the program's list → component of (11, 22, 12).
    voigt: [usize; 3],
    engineering: bool,
    /// Factors of S_c and K_3.
    shear_factors: [f64; 2],
    symmetrised: bool,
    /// Multiple of ½ ∫ ε_Tᵀ D ε_T dV that U lacks.
    constant_left_out: f64,
    heat_in_law: bool,
    by_columns: bool,
    flat: bool,
    degrees: bool,
    reads_own: bool,
    /// Whether a state without a straight e0 of inclination θ is refused.
    validates: bool,
    single: bool,
    six_digits: bool,
    quantities: Option<Vec<&'static str>>,
    mistake: Option<MistakeOf>,
    declared: Value,
    given: bool,
}

impl Default for Mine {
    fn default() -> Mine {
        Mine {
            order: [0, 1, 2, 3, 4, 5, 6],
            cable_order: [0, 1, 2, 3],
            all_x_then_all_y: false,
            slopes: |_, _| [1.0, 1.0],
            voigt: [0, 1, 2],
            engineering: false,
            shear_factors: [1.0, 1.0],
            symmetrised: false,
            constant_left_out: 0.0,
            heat_in_law: false,
            by_columns: false,
            flat: false,
            degrees: false,
            reads_own: false,
            validates: true,
            single: false,
            six_digits: false,
            quantities: None,
            mistake: None,
            declared: json!({}),
            given: false,
        }
    }
}

const POSITIONS_FIRST: [usize; 7] = [0, 2, 5, 1, 3, 4, 6];
const ENDS_FIRST: [usize; 7] = [0, 1, 5, 6, 2, 3, 4];

impl Mine {
    /// The nodal vectors of the program as a matrix times those of the fixtures.
    fn of_vectors(&self, vectors: usize, l: f64, h: f64) -> DMatrix<f64> {
        let [along, across] = (self.slopes)(l, h);
        let (order, kinds): (&[usize], &str) =
            if vectors == 7 { (&self.order, "pypxypy") } else { (&self.cable_order, "pxpx") };
        DMatrix::from_fn(vectors, vectors, |n, k| match (order[n] == k, kinds.as_bytes()[k]) {
            (false, _) => 0.0,
            (true, b'x') => along,
            (true, b'y') => across,
            (true, _) => 1.0,
        })
    }

    /// T in e′ = T e.
    fn of_coordinates(&self, vectors: usize, l: f64, h: f64) -> DMatrix<f64> {
        let T = self.of_vectors(vectors, l, h).kronecker(&DMatrix::identity(2, 2));
        if !self.all_x_then_all_y {
            return T;
        }
        DMatrix::from_fn(2 * vectors, 2 * vectors, |n, m| T[(2 * (n % vectors) + n / vectors, m)])
    }

    /// B in ε′ = B ε, and P in σ′ = P σ.
    fn of_strains(&self) -> (DMatrix<f64>, DMatrix<f64>) {
        let P = DMatrix::from_fn(3, 3, |n, k| f64::from(self.voigt[n] == k));
        let shear = if self.engineering { 2.0 } else { 1.0 };
        let B = DMatrix::from_fn(3, 3, |n, k| P[(n, k)] * if k == 2 { shear } else { 1.0 });
        (B, P)
    }

    /// The value of a quantity at one point, as the program has it.
    fn own(&self, quantity: &str, value: &DMatrix<f64>, l: f64, h: f64) -> DMatrix<f64> {
        let vectors = if quantity.starts_with("cable.") { 4 } else { 7 };
        let T = self.of_coordinates(vectors, l, h);
        let back = T.clone().try_inverse().unwrap();
        let of_vectors = self.of_vectors(vectors, l, h);
        let (B, P) = self.of_strains();
        let shear = if self.engineering { 2.0 } else { 1.0 };
        let [S_c, K_3] = self.shear_factors;
        let metric = || back.transpose() * value * &back;
        match quantity {
            "4.nodes" => of_vectors * value,
            "A.2.e" | "22.eddot" | "cable.eddot" => T * value,
            "3.S" | "3.S_x" | "3.S_y" | "cable.S" | "cable.S_x" | "cable.S_xx" => {
                of_vectors.try_inverse().unwrap().transpose() * value
            }
            "2.S" => value * &back,
            "19.Q_e" | "gravity.Q_w" | "22.residual" | "axis.Q_e" | "uniaxial.Q_e" | "cable.Q_e" | "cable.Q_w" => {
                back.transpose() * value
            }
            "7.M" | "11.S_a" | "11.S_b" | "21.S_a1" | "21.S_b1" | "21.K_1" | "21.K_2" | "20.K" | "tangent.dQ_e"
            | "axis.tangent" | "uniaxial.tangent" | "cable.M" | "cable.tangent" => metric(),
            "21.S_c1" => metric() * S_c,
            "21.K_3" => metric() * K_3,
            "11.S_c" if self.symmetrised => 0.5 * S_c * (metric() + metric().transpose()),
            "11.S_c" => metric() * S_c,
            "8.epsilon_T" | "12.epsilon_f" | "14.epsilon" => B * value,
            "13.epsilon_3" => value * shear,
            "15.sigma" | "axis.epsilon" => P * value,
            "16.D" => &P * value * B.try_inverse().unwrap(),
            "axis.D_0" | "uniaxial.D" => &P * value * P.transpose(),
            _ => value.clone(),
        }
    }

    fn answer(&self, question: &Asked) -> Answer {
        let quantity = question.equation;
        if self.quantities.as_ref().is_some_and(|list| !list.contains(&quantity)) || quantity.starts_with("23.") {
            return Answer::NotImplemented;
        }
        let mut state = question.state.clone();
        if self.degrees
            && let Some(theta) = state["theta"].as_f64()
        {
            state["theta"] = json!(theta.to_radians());
        }
        let number = |key: &str| question.state[key].as_f64().unwrap_or(1.0);
        let (l, h) = (number("l"), number("h"));
        if self.reads_own {
            let vectors = if quantity.starts_with("cable.") { 4 } else { 7 };
            let back =
                self.of_coordinates(vectors, l, h).try_inverse().unwrap_or(DMatrix::identity(2 * vectors, 2 * vectors));
            for key in ["e0", "e", "edot"] {
                let list = state[key].as_array().cloned().unwrap_or_default();
                let numbers: Vec<f64> = list.iter().filter_map(Value::as_f64).collect();
                if numbers.len() == 2 * vectors {
                    state[key] = json!((&back * DVector::from_vec(numbers)).as_slice());
                }
            }
        }
        if !(l > 0.0 && h > 0.0) {
            return Answer::Error("l and h must be over 0".into());
        }
        // Reference values come in the program's conventions, too, unless one is altered to see whether it is read.
        for (name, value) in question.given.iter().filter(|_| !question.id.ends_with("-altered")) {
            let own = self.value(name, &state, l, h).unwrap();
            assert!(close(&own, value), "{name} given for {quantity}: {value}, not {own}");
        }
        match self.value(quantity, &state, l, h) {
            Ok(value) => Answer::Value(value),
            Err(message) => Answer::Error(message),
        }
    }

    /// The numbers of the fixtures' conventions in the program's.
    fn value(&self, quantity: &str, state: &Value, l: f64, h: f64) -> Result<Value, String> {
        let numbers = self.numbers(quantity, state)?;
        let known = &SUITE.quantities[quantity];
        let lengths: Vec<usize> = serde_json::from_value(json!(known.shape)).unwrap();
        let (rows, columns) = match lengths[..] {
            [] => (1, 1),
            [rows] => (rows, 1),
            [rows, columns] => (rows, columns),
            _ => panic!("{quantity}"),
        };
        let printed = |x: f64| match (self.single, self.six_digits) {
            (true, _) => f64::from(x as f32),
            (_, true) => format!("{x:.5e}").parse().unwrap(),
            _ => x,
        };
        let at_a_point = |value: &[f64]| {
            let own = self.own(quantity, &DMatrix::from_row_slice(rows, columns, value), l, h).map(printed);
            let list = |numbers: Vec<f64>| json!(numbers);
            match (lengths.len(), self.flat, self.by_columns) {
                (0, ..) => json!(own[(0, 0)]),
                (1, ..) | (_, true, true) => list(own.as_slice().to_vec()),
                (_, true, false) => list(own.transpose().as_slice().to_vec()),
                (_, false, true) => own.column_iter().map(|column| list(column.iter().copied().collect())).collect(),
                (_, false, false) => own.row_iter().map(|row| list(row.iter().copied().collect())).collect(),
            }
        };
        let size = (rows * columns).max(1);
        if json!(known.per) == "point" {
            return Ok(numbers.chunks(size).map(at_a_point).collect());
        }
        Ok(at_a_point(&numbers))
    }

    /// Numbers of a quantity in the conventions of the fixtures but for those of energy and heat.
    fn numbers(&self, quantity: &str, state: &Value) -> Result<Vec<f64>, String> {
        let text = state.to_string();
        if quantity.starts_with("cable.") {
            let state = CableState::parse(&text, "state").map_err(|error| error.to_string())?;
            let mut numbers = evaluate_cable(quantity, &state).unwrap();
            if quantity == "cable.U" && self.constant_left_out != 0.0 {
                let rest = CableState { e: state.e0, ..state };
                numbers[0] -= self.constant_left_out * evaluate_cable(quantity, &rest).unwrap()[0];
            }
            return Ok(numbers);
        }
        let state: ElementState = if self.validates {
            ElementState::parse(&text, "state").map_err(|error| error.to_string())?
        } else {
            serde_json::from_str(&text).map_err(|error| error.to_string())?
        };
        if let Some(wrong) = self.mistake.and_then(|mistake| mistake(quantity, &state)) {
            return Ok(wrong);
        }
        let eps_T = state.eps_T();
        let mut numbers = evaluate(quantity, &state).ok_or("no value")?;
        if quantity == "14.epsilon" && self.heat_in_law {
            numbers.iter_mut().enumerate().for_each(|(n, eps)| *eps += eps_T[n % 3]);
        }
        if matches!(quantity, "18.U" | "axis.U" | "uniaxial.U") && self.constant_left_out != 0.0 {
            let rest = ElementState { e: state.e0, ..state.clone() };
            numbers[0] -= self.constant_left_out * evaluate(quantity, &rest).unwrap()[0];
        }
        Ok(numbers)
    }

    fn report(&self) -> Report {
        let mine = self.clone();
        let mut subject = Talkative {
            hello: Hello {
                name: Some("mine".into()),
                given: self.given,
                conventions: self.declared.as_object().cloned().unwrap_or_default(),
                ..Hello::default()
            },
            code: Code::new("mine", move |question: &Asked| mine.answer(question)),
        };
        let examination = examine(&SUITE, &mut subject, Options::default(), |_| {});
        Report::new(&SUITE, &examination)
    }
}

/// Whether nested lists of numbers agree to nine digits of the largest.
fn close(one: &Value, other: &Value) -> bool {
    fn numbers(value: &Value, all: &mut Vec<f64>) {
        match value {
            Value::Array(list) => list.iter().for_each(|value| numbers(value, all)),
            value => all.push(value.as_f64().unwrap_or(f64::NAN)),
        }
    }
    let (mut a, mut b) = (Vec::new(), Vec::new());
    numbers(one, &mut a);
    numbers(other, &mut b);
    let size = b.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    // Forces at rest are roundings of large terms.
    let bound = if size == 0.0 { 1e-3 } else { 1e-9 * size };
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= bound)
}

/// Code whose hello declares conventions.
struct Talkative<S> {
    hello: Hello,
    code: S,
}

impl<S: Subject> Subject for Talkative<S> {
    fn hello(&mut self, _: &ancf_conform::Question) -> Result<Hello, ancf_conform::Fault> {
        Ok(self.hello.clone())
    }

    fn ask(&mut self, question: &Asked) -> Result<Answer, ancf_conform::Fault> {
        self.code.ask(question)
    }
}

fn names(report: &Report) -> Vec<&'static str> {
    report.conventions.iter().map(|convention| convention.name).collect()
}

fn failing(report: &Report) -> Vec<&'static str> {
    report.quantities.iter().filter(|row| row.counts.fail > 0).map(|row| row.quantity).collect()
}

/// What a report should not say: that these quantities are not exactly those that fail, or the conventions not these.
fn complaint(what: &str, mine: &Mine, expected: &[&str], wrong: &[&str]) -> Option<String> {
    let report = mine.report();
    let is_bad =
        |convention: &&ancf_conform::Convention| convention.evidence.is_empty() || convention.how != How::Inferred;
    let unfounded = report.conventions.iter().find(is_bad);
    if failing(&report) == wrong && names(&report) == expected && unfounded.is_none() {
        return None;
    }
    let text = report.markdown();
    let head = text.split("| quantity |").next().unwrap_or_default().replace("\n\n", "\n");
    let (found, wrong) = (names(&report), failing(&report));
    Some(format!("{what}: {found:?}, expected {expected:?}; wrong {wrong:?}\n{unfounded:?}\n{head}"))
}

#[track_caller]
fn assert_none(complaints: Vec<Option<String>>) {
    let all: Vec<String> = complaints.into_iter().flatten().collect();
    assert!(all.is_empty(), "{} complaints:\n{}", all.len(), all.join("\n"));
}

/// Right programs, each with one convention.
fn programs() -> Vec<(&'static str, Mine, Vec<&'static str>)> {
    let mine = Mine { validates: false, ..Mine::default() };
    let natural: fn(f64, f64) -> [f64; 2] = |l, h| [l / 2.0, h / 2.0];
    vec![
        ("paper", mine.clone(), vec![]),
        ("positions first", Mine { order: POSITIONS_FIRST, ..mine.clone() }, vec!["order"]),
        ("by kind", Mine { order: [0, 2, 5, 1, 4, 6, 3], ..mine.clone() }, vec!["order"]),
        ("ends first", Mine { order: ENDS_FIRST, ..mine.clone() }, vec!["order"]),
        ("any order", Mine { order: [4, 6, 0, 3, 5, 1, 2], ..mine.clone() }, vec!["order"]),
        ("all x, then all y", Mine { all_x_then_all_y: true, ..mine.clone() }, vec!["components", "components"]),
        ("slopes by ξ, η", Mine { slopes: natural, ..mine.clone() }, vec!["slopes", "slopes"]),
        ("slopes by ξ in [0, 1]", Mine { slopes: |l, h| [l, h], ..mine.clone() }, vec!["slopes", "slopes"]),
        ("engineering shear", Mine { engineering: true, ..mine.clone() }, vec!["shear"]),
        (
            "engineering shear, 2 S_c",
            Mine { engineering: true, shear_factors: [2.0, 4.0], ..mine.clone() },
            vec!["shear"],
        ),
        ("11, 12, 22", Mine { voigt: [0, 2, 1], ..mine.clone() }, vec!["voigt"]),
        ("22, 11, 12", Mine { voigt: [1, 0, 2], ..mine.clone() }, vec!["voigt"]),
        ("symmetrised S_c", Mine { symmetrised: true, ..mine.clone() }, vec!["S_c"]),
        ("U without its constant", Mine { constant_left_out: 1.0, ..mine.clone() }, vec!["U"]),
        ("U less its constant", Mine { constant_left_out: 2.0, ..mine.clone() }, vec!["U"]),
        ("degrees", Mine { degrees: true, ..mine.clone() }, vec!["theta"]),
        ("columns", Mine { by_columns: true, ..mine.clone() }, vec!["matrices"]),
        ("flat rows", Mine { flat: true, ..mine.clone() }, vec!["matrices"]),
        ("flat columns", Mine { flat: true, by_columns: true, ..mine.clone() }, vec!["matrices"]),
        ("heat inside the law", Mine { heat_in_law: true, ..mine }, vec!["heat"]),
    ]
}

/// A program of another layout that reads its states in it.
fn with_own_reading(mine: &Mine) -> Option<(Mine, Vec<&'static str>)> {
    let changes_both = mine.all_x_then_all_y || (mine.slopes)(3.0, 5.0) != [1.0, 1.0];
    let keys = if changes_both {
        let key = if mine.all_x_then_all_y { "components" } else { "slopes" };
        vec![key, key, "state"]
    } else if mine.order == Mine::default().order {
        return None;
    } else {
        vec!["order", "state"]
    };
    Some((Mine { reads_own: true, ..mine.clone() }, keys))
}

#[test]
#[cfg_attr(debug_assertions, ignore = "half a minute; in release mode")]
fn each_convention_is_recognised() {
    let mut complaints = Vec::new();
    for (what, mine, expected) in programs() {
        complaints.push(complaint(what, &mine, &expected, &[]));
        let refusing = Mine { validates: true, ..mine };
        complaints.push(complaint(&format!("{what}, refusing"), &refusing, &expected, &[]));
    }
    assert_none(complaints);
}

#[test]
fn a_program_that_reads_its_own_layout_is_asked_again() {
    let mut complaints = Vec::new();
    for (what, mine, _) in programs() {
        let Some((mine, expected)) = with_own_reading(&mine) else { continue };
        complaints.push(complaint(&format!("{what}, own states"), &mine, &expected, &[]));
        // Only usual orders are found behind refusals.
        if what != "any order" {
            let refusing = Mine { validates: true, ..mine };
            complaints.push(complaint(&format!("{what}, own states, refusing"), &refusing, &expected, &[]));
        }
    }
    assert_none(complaints);
}

#[test]
fn black_boxes_with_a_convention_are_right() {
    let of_forces = ["order", "components", "slopes", "matrices", "theta", "state"];
    let mut complaints = Vec::new();
    for (what, mine, expected) in programs() {
        for (mine, expected) in [(mine.clone(), expected)].into_iter().chain(with_own_reading(&mine)) {
            let mine = Mine { quantities: Some(BLACK_BOX.into()), ..mine };
            let mut expected: Vec<&str> = expected.into_iter().filter(|name| of_forces.contains(name)).collect();
            expected.dedup();
            // All three are symmetric.
            if mine.by_columns && !mine.flat {
                expected.clear();
            }
            complaints.push(complaint(&format!("{what}, black box"), &mine, &expected, &[]));
        }
    }
    assert_none(complaints);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "minutes; in release mode")]
fn two_conventions_at_once() {
    let all = programs();
    let mut complaints = Vec::new();
    for (n, (first, one, _)) in all.iter().enumerate() {
        for (second, other, _) in &all[n + 1..] {
            let usual = Mine::default();
            let both = Mine {
                order: if one.order == usual.order { other.order } else { one.order },
                all_x_then_all_y: one.all_x_then_all_y || other.all_x_then_all_y,
                slopes: if (one.slopes)(3.0, 5.0) == [1.0, 1.0] { other.slopes } else { one.slopes },
                voigt: if one.voigt == usual.voigt { other.voigt } else { one.voigt },
                engineering: one.engineering || other.engineering,
                shear_factors: if one.engineering { one.shear_factors } else { other.shear_factors },
                symmetrised: one.symmetrised || other.symmetrised,
                constant_left_out: one.constant_left_out.max(other.constant_left_out),
                heat_in_law: one.heat_in_law || other.heat_in_law,
                by_columns: one.by_columns || other.by_columns,
                flat: one.flat || other.flat,
                degrees: one.degrees || other.degrees,
                quantities: Some(TELLING.into()),
                ..one.clone()
            };
            // In turn: states of the fixtures, own states, own states and others refused.
            let both = match n % 3 {
                0 => both,
                reads => Mine { reads_own: true, validates: reads == 2, ..both },
            };
            if both.order == [4, 6, 0, 3, 5, 1, 2] && both.validates && both.reads_own {
                continue; // Only usual orders are found behind refusals.
            }
            let report = both.report();
            let wrong = failing(&report);
            if !wrong.is_empty() {
                complaints.push(Some(format!("{first} and {second}: {wrong:?} {:?}", names(&report))));
            }
        }
    }
    assert_none(complaints);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "minutes; in release mode")]
fn a_mistake_beside_a_convention_is_found() {
    /// Mistakes, and the equations that are wrong first.
    const MISTAKES: [(&str, MistakeOf); 5] = [
        ("17.mu", |quantity, state| {
            let wrong = ElementState { nu: -state.nu, ..state.clone() };
            (quantity == "17.mu").then(|| evaluate(quantity, &wrong).unwrap())
        }),
        ("7.M", |quantity, state| {
            (quantity == "7.M").then(|| evaluate(quantity, state).unwrap().iter().map(|m| 2.0 * m).collect())
        }),
        ("gravity.Q_w", |quantity, state| {
            let turned = ElementState { gravity: [state.gravity[1], state.gravity[0]], ..state.clone() };
            (quantity == "gravity.Q_w").then(|| evaluate(quantity, &turned).unwrap())
        }),
        ("21.K_3", |quantity, state| (quantity == "21.K_3").then(|| evaluate("21.K_3/printed", state).unwrap())),
        ("19.Q_e", |quantity, state| (quantity == "19.Q_e").then(|| evaluate("19.Q_e/printed-shear", state).unwrap())),
    ];
    let mut complaints = Vec::new();
    for (what, mine, expected) in programs() {
        for (mine, expected) in [(mine.clone(), expected)].into_iter().chain(with_own_reading(&mine)) {
            for (quantity, mistake) in MISTAKES {
                let mine = Mine { mistake: Some(mistake), ..mine.clone() };
                complaints.push(complaint(&format!("{what}, {quantity}"), &mine, &expected, &[quantity]));
            }
        }
    }
    assert_none(complaints);
}

#[test]
fn a_single_quantity_in_another_convention_is_a_mistake() {
    fn permuted(quantity: &str, state: &ElementState, of: &str, order: impl Fn(usize) -> usize) -> Option<Vec<f64>> {
        let value = (quantity == of).then(|| evaluate(quantity, state).unwrap())?;
        let is_per_point = json!(SUITE.quantities[quantity].per) == "point";
        let size = value.len() / if is_per_point { state.points.len() } else { 1 };
        Some((0..value.len()).map(|n| value[n / size * size + order(n % size)]).collect())
    }
    const ALONE: [(&str, MistakeOf); 7] = [
        ("7.M", |quantity, state| {
            permuted(quantity, state, "7.M", |n| {
                let block = |n: usize| 2 * (n % 7) + n / 7;
                14 * block(n / 14) + block(n % 14)
            })
        }),
        ("19.Q_e", |quantity, state| permuted(quantity, state, "19.Q_e", |n| 2 * ENDS_FIRST[n / 2] + n % 2)),
        ("12.epsilon_f", |quantity, state| permuted(quantity, state, "12.epsilon_f", |n| [0, 2, 1][n])),
        ("15.sigma", |quantity, state| permuted(quantity, state, "15.sigma", |n| [0, 2, 1][n])),
        ("12.epsilon_f", |quantity, state| {
            let value = (quantity == "12.epsilon_f").then(|| evaluate(quantity, state).unwrap())?;
            Some(value.iter().enumerate().map(|(n, eps)| if n % 3 == 2 { 2.0 * eps } else { *eps }).collect())
        }),
        ("16.D", |quantity, state| {
            let mut value = (quantity == "16.D").then(|| evaluate(quantity, state).unwrap())?;
            value[8] /= 2.0;
            Some(value)
        }),
        ("9.J", |quantity, state| permuted(quantity, state, "9.J", |n| [0, 2, 1, 3][n])),
    ];
    let mut complaints = Vec::new();
    for (n, (quantity, mistake)) in ALONE.into_iter().enumerate() {
        let mine = Mine { mistake: Some(mistake), ..Mine::default() };
        complaints.push(complaint(&format!("{quantity} alone"), &mine, &[], &[quantity]));
        // Black boxes: the layout of M does not excuse the others, nor theirs M.
        if n < 2 {
            let mine = Mine { quantities: Some(BLACK_BOX.into()), ..mine };
            complaints.push(complaint(&format!("{quantity} alone in a black box"), &mine, &[], &[quantity]));
        }
    }
    assert_none(complaints);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "half a minute; in release mode")]
fn single_precision_hides_no_convention() {
    let mut complaints = Vec::new();
    for (what, mine, expected) in programs() {
        for (mine, expected) in [(mine.clone(), expected)].into_iter().chain(with_own_reading(&mine)) {
            let report = Mine { single: true, ..mine }.report();
            let few: Vec<&str> = (report.quantities.iter())
                .filter(|row| row.counts.digits.is_some_and(|digits| digits < 5.0))
                .map(|row| row.quantity)
                .collect();
            if names(&report) != expected || !few.is_empty() {
                let found = names(&report);
                complaints.push(Some(format!("{what}: {found:?}, expected {expected:?}; few digits in {few:?}")));
            }
        }
    }
    assert_none(complaints);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "half a minute; in release mode")]
fn six_digits_of_the_programs_own_numbers_are_enough() {
    let mut complaints = Vec::new();
    for (what, mine, expected) in programs() {
        for (mine, expected) in [(mine.clone(), expected)].into_iter().chain(with_own_reading(&mine)) {
            let report = Mine { six_digits: true, ..mine }.report();
            if names(&report) != expected || !report.passes {
                let (found, wrong) = (names(&report), failing(&report));
                complaints.push(Some(format!("{what}: {found:?}, expected {expected:?}; wrong: {wrong:?}")));
            }
        }
    }
    assert_none(complaints);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "half a minute; in release mode")]
fn given_values_come_in_the_programs_conventions() {
    let twice_the_force: MistakeOf = |quantity, state| {
        (quantity == "22.residual").then(|| evaluate(quantity, state).unwrap().iter().map(|f| 2.0 * f).collect())
    };
    let wrong_stress: MistakeOf = |quantity, state| {
        (quantity == "15.sigma").then(|| evaluate(quantity, state).unwrap().iter().map(|s| 2.0 * s).collect())
    };
    let mut complaints = Vec::new();
    for (what, mine, expected) in programs() {
        for (mine, expected) in [(mine.clone(), expected)].into_iter().chain(with_own_reading(&mine)) {
            let mistakes = [("22.residual", twice_the_force), ("15.sigma", wrong_stress)];
            // With a wrong stress, heat in the law cannot be told from a whole strain by mistake.
            let told = mistakes.into_iter().filter(|(quantity, _)| !(mine.heat_in_law && *quantity == "15.sigma"));
            for (quantity, mistake) in told {
                let mine = Mine { given: true, mistake: Some(mistake), ..mine.clone() };
                complaints.push(complaint(what, &mine, &expected, &[quantity]));
            }
        }
    }
    assert_none(complaints);
}

#[test]
fn declared_conventions_are_used_and_errors_named() {
    let names = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];
    let order: Vec<&str> = [4, 6, 0, 3, 5, 1, 2].iter().map(|n: &usize| names[*n]).collect();
    let mine = Mine {
        order: [4, 6, 0, 3, 5, 1, 2],
        engineering: true,
        degrees: true,
        reads_own: true,
        declared: json!({"order": order, "state": "own", "shear": "engineering", "theta": "degrees"}),
        ..Mine::default()
    };
    let report = mine.report();
    assert_eq!(failing(&report), Vec::<&str>::new(), "{}", report.markdown());
    assert_eq!(self::names(&report), ["order", "state", "shear", "theta"]);
    assert!(report.conventions.iter().all(|convention| convention.how == How::Declared));
    assert!(report.markdown().contains("θ in degrees (declared)"), "{}", report.markdown());

    let wrong = json!({"ordr": [], "shear": "enginering", "voigt": ["11", "22"], "slopes": 5});
    let report = Mine { declared: wrong, quantities: Some(BLACK_BOX.into()), ..Mine::default() }.report();
    let text = report.convention_errors.join("\n");
    for words in [
        "`ordr` is no convention; nearest: `order`",
        "`shear` cannot be `enginering`; nearest: `engineering`; allowed: tensor, engineering",
        "`voigt` cannot be `[\"11\",\"22\"]`; allowed: a list of 11, 22, 12, each once",
        "`slopes` cannot be `5`",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(report.markdown().contains("- In its hello: "));
}

#[test]
fn what_cannot_be_told_is_listed() {
    let report = Mine { order: ENDS_FIRST, quantities: Some(vec!["7.M"]), ..Mine::default() }.report();
    let [order] = &report.conventions[..] else { panic!("{}", report.markdown()) };
    // M is the same with r_y_i and r_y_k exchanged, and seen from the other end.
    assert!(order.ambiguous_with.len() >= 2, "{order:?}");
    assert!(order.ambiguous_with.iter().any(|words| words.contains("other end")), "{order:?}");
    let report = Mine { engineering: true, quantities: Some(vec!["16.D"]), ..Mine::default() }.report();
    let [shear] = &report.conventions[..] else { panic!("{}", report.markdown()) };
    assert_eq!(shear.name, "shear");
}
