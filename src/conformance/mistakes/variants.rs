//! Mistakes in what enters an equation: the angle, the thermal strain, Poisson's ratio, a printed error.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::{Matrix2, Vector3};

use super::stations::{K, Station, material, stations};
use super::{Candidate, Kind, candidate};
use crate::conformance::suite::{Case, Parsed};
use crate::equations::force::{self, Matrix14};
use crate::equations::shape::{self, Vector14};
use crate::equations::{material as law, strain};
use crate::state::{ElementState, SystemState, ThermalModel, evaluate};

/// All of them for a quantity.
pub(super) fn of(quantity: &str, case: &Case) -> Vec<Candidate> {
    let mut all = printed(quantity, case);
    match &case.parsed {
        Parsed::Element(state) => {
            all.extend(angles(quantity, state));
            all.extend(
                heats(state)
                    .into_iter()
                    .filter_map(|(kind, what, eps_T)| Some(candidate(kind, what, with_heat(quantity, state, &eps_T)?))),
            );
            all.extend(laws(quantity, state));
            all.extend(gradients(quantity, state));
            all.extend(parameters(quantity, case, state));
        }
        Parsed::System(system) => all.extend(signs_of_23(quantity, system)),
        Parsed::Other => {}
    }
    all
}

/// The paper's printed errors.
fn printed(quantity: &str, case: &Case) -> Vec<Candidate> {
    let stored = |name: &str| case.values.get(name).map(|value| value.numbers.clone());
    let mut all = Vec::new();
    let mut add = |what: &str, value: Option<Vec<f64>>| {
        all.push(Candidate { kind: Kind::Erratum, what: what.into(), value });
    };
    match quantity {
        "A.3.coefficients" => add("E1: +r_k in a_1", stored("A.3.coefficients/printed")),
        "21.K_3" => add("E2: −1 in K_3, and no heat", stored("21.K_3/printed")),
        "18.U" => add("E3: the shear counted once", stored("18.U/printed-shear")),
        "19.Q_e" => add("E3: 2μ K_3 for 4μ K_3", stored("19.Q_e/printed-shear")),
        "20.K" => add("E3: 2μ K_3 for 4μ K_3", stored("20.K/printed-shear")),
        "tangent.dQ_e" => add("E3: 2μ K_3 for 4μ K_3", stored("tangent.dQ_e/printed-shear")),
        "23.constraint_force" => add("E4: Φ_q λ for Φ_qᵀ λ", stored("23.constraint_force/printed")),
        "23.residual" => add("E4: Φ_q λ for Φ_qᵀ λ", stored("23.residual/printed")),
        _ => {}
    }
    let Parsed::Element(state) = &case.parsed else { return all };
    let (e, element) = (Vector14::from(state.e), state.element());
    if !matches!(quantity, "19.Q_e" | "20.K" | "21.K_3") {
        return all;
    }
    // The −1 of E2 alone, with heat as it should be, and both errors at once.
    let unit = K(&stations(&e, &element), |_| [0.0, 0.0, 1.0]);
    let (lambda, mu, eps_T) = (law::lambda(state.E, state.nu), law::mu(state.E, state.nu), state.eps_T());
    let (K_1, K_2) = (force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element));
    let K_3 = force::K_3(&e, &eps_T, &element) - unit;
    let sums = [
        ("E2: −1 in K_3", force::K(lambda, mu, &K_1, &K_2, &K_3)),
        ("E2 and E3: −1 in K_3, and 2μ K_3 for 4μ K_3", force::K_printed(lambda, mu, &K_1, &K_2, &K_3)),
    ];
    for (what, K) in sums {
        let value = match quantity {
            "21.K_3" => rows(&K_3),
            "20.K" => rows(&K),
            _ => force::Q_e(&e, &K).as_slice().to_vec(),
        };
        all.push(candidate(Kind::Erratum, what, value));
    }
    all
}

/// The inclination with a mistake.
fn angles(quantity: &str, state: &ElementState) -> Vec<Candidate> {
    let quantity = match quantity {
        "9.J_0" => "9.J_0/theta",
        other => other,
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    let with = |theta: f64| evaluate(quantity, &ElementState { theta, ..state.clone() });
    [
        (Kind::SinCos, "cos θ and sin θ exchanged", with(quarter - state.theta)),
        (Kind::Sign, "sin θ with the other sign, as where a rotation is transposed", with(-state.theta)),
        (Kind::Other, "θ left out: as if the element lay along x", with(0.0)),
    ]
    .into_iter()
    .map(|(kind, what, value)| Candidate { kind, what: what.into(), value })
    .collect()
}

/// Thermal strains with a mistake, (11, 22, 12) in global axes.
fn heats(state: &ElementState) -> Vec<(Kind, &'static str, Vector3<f64>)> {
    let heat = state.alpha * state.dT;
    let (sin, cos) = state.theta.sin_cos();
    let right = state.eps_T();
    let model = |one: Vector3<f64>, two: Vector3<f64>| match state.model {
        ThermalModel::OneD => one,
        ThermalModel::TwoD => two,
        ThermalModel::None => Vector3::zeros(),
    };
    let only_1d = |x: f64, y: f64, xy: f64| model(heat * Vector3::new(x, y, xy), right);
    let only_2d = |x: f64, y: f64, xy: f64| model(right, heat * Vector3::new(x, y, xy));
    let both = Vector3::new(heat, heat, 0.0);
    vec![
        (
            Kind::HeatOnShear,
            "αΔT on the shear component too",
            model(right + Vector3::z() * heat, right + Vector3::z() * heat),
        ),
        (Kind::HeatOnShear, "αΔT on the shear component too, 2D model", only_2d(1.0, 1.0, 1.0)),
        (
            Kind::HeatOnShear,
            "αΔT on the shear component too, 1D model",
            right + model(Vector3::z() * heat, Vector3::zeros()),
        ),
        (
            Kind::HeatOnShear,
            "2 sin θ cos θ on the shear component, 1D model",
            only_1d(cos * cos, sin * sin, 2.0 * sin * cos),
        ),
        (
            Kind::HeatOnShear,
            "½ sin θ cos θ on the shear component, 1D model",
            only_1d(cos * cos, sin * sin, 0.5 * sin * cos),
        ),
        (Kind::HeatOnShear, "no heat on the shear component, 1D model", only_1d(cos * cos, sin * sin, 0.0)),
        (Kind::HeatOnShear, "−sin θ cos θ on the shear component, 1D model", only_1d(cos * cos, sin * sin, -sin * cos)),
        (Kind::HeatAlongX, "[αΔT, 0, 0] in the 1D model", only_1d(1.0, 0.0, 0.0)),
        (Kind::HeatAlongX, "[αΔT, 0, 0] in the 2D model", only_2d(1.0, 0.0, 0.0)),
        (Kind::HeatAlongX, "[αΔT, 0, 0] in both models", model(heat * Vector3::x(), heat * Vector3::x())),
        (Kind::SinCos, "cos θ and sin θ exchanged, 1D model", only_1d(sin * sin, cos * cos, sin * cos)),
        (Kind::Heat, "cos θ and sin θ for their squares, 1D model", only_1d(cos, sin, sin * cos)),
        (Kind::Heat, "2D heat in the 1D model", model(both, both)),
        (
            Kind::Heat,
            "1D heat in the 2D model",
            if state.model == ThermalModel::TwoD {
                strain::eps_T_1d(state.alpha, state.dT, state.theta)
            } else {
                right
            },
        ),
        (Kind::Heat, "heat where the model is none", if state.model == ThermalModel::None { both } else { right }),
        (Kind::Missing, "no heat", Vector3::zeros()),
        (Kind::Sign, "heat with the other sign", -right),
        (Kind::Factor, "half of the heat: αΔT for 2αΔT", 0.5 * right),
        (Kind::Factor, "twice the heat", 2.0 * right),
        (Kind::Heat, "(1 + ν)αΔT: heat of true plane strain", (1.0 + state.nu) * right),
        (
            Kind::Heat,
            "√(1 + 2αΔT) − 1 for αΔT",
            right * if heat == 0.0 { 1.0 } else { ((1.0 + 2.0 * heat).max(0.0).sqrt() - 1.0) / heat },
        ),
    ]
}

/// The value for another thermal strain.
fn with_heat(quantity: &str, state: &ElementState, eps_T: &Vector3<f64>) -> Option<Vec<f64>> {
    let (lambda, mu) = (law::lambda(state.E, state.nu), law::mu(state.E, state.nu));
    match quantity {
        "8.epsilon_T" => Some(eps_T.as_slice().to_vec()),
        "14.epsilon" => Some(
            evaluate("12.epsilon_f", state)?
                .chunks(3)
                .flat_map(|eps_f| eps_f.iter().zip(eps_T.iter()).map(|(f, t)| f - t).collect::<Vec<_>>())
                .collect(),
        ),
        _ => with_heat_and_law(quantity, state, eps_T, lambda, mu),
    }
}

/// Energy, force, stiffness and tangent for another thermal strain and other constants.
fn with_heat_and_law(
    quantity: &str,
    state: &ElementState,
    eps_T: &Vector3<f64>,
    lambda: f64,
    mu: f64,
) -> Option<Vec<f64>> {
    let (e, element) = (Vector14::from(state.e), state.element());
    let K = || {
        let (K_1, K_2) = (force::K_1(&e, eps_T, &element), force::K_2(&e, eps_T, &element));
        force::K(lambda, mu, &K_1, &K_2, &force::K_3(&e, eps_T, &element))
    };
    match quantity {
        "18.U" => Some(vec![force::U(&e, eps_T, lambda, mu, &element)]),
        "21.K_1" => Some(rows(&force::K_1(&e, eps_T, &element))),
        "21.K_2" => Some(rows(&force::K_2(&e, eps_T, &element))),
        "21.K_3" => Some(rows(&force::K_3(&e, eps_T, &element))),
        "20.K" => Some(rows(&K())),
        "19.Q_e" => Some(force::Q_e(&e, &K()).as_slice().to_vec()),
        "tangent.dQ_e" => Some(rows(&force::tangent(&e, eps_T, lambda, mu, &element))),
        _ => None,
    }
}

/// Poisson's ratio in other places of (17), and laws that are taken for (16).
fn laws(quantity: &str, state: &ElementState) -> Vec<Candidate> {
    let ElementState { E, nu, .. } = *state;
    let lambda = law::lambda(E, nu);
    let mu = law::mu(E, nu);
    let lambdas = [
        ("plane stress: λ = Eν/(1 − ν²)", E * nu / (1.0 - nu * nu)),
        ("λ = Eν/((1 + ν)(1 − ν)(1 − 2ν))", E * nu / ((1.0 + nu) * (1.0 - nu) * (1.0 - 2.0 * nu))),
        ("λ = Eν/(1 − 2ν)", E * nu / (1.0 - 2.0 * nu)),
        ("λ = Eν/(1 + ν)", E * nu / (1.0 + nu)),
        ("λ = Eν/((1 − ν)(1 − 2ν))", E * nu / ((1.0 - nu) * (1.0 - 2.0 * nu))),
        ("λ = Eν/((1 + ν)(1 + 2ν))", E * nu / ((1.0 + nu) * (1.0 + 2.0 * nu))),
        ("λ = Eν/((1 − ν)(1 + 2ν))", E * nu / ((1.0 - nu) * (1.0 + 2.0 * nu))),
        ("λ = Eν/((1 + 2ν)(1 − ν))", E * nu / ((1.0 + 2.0 * nu) * (1.0 - nu))),
        ("λ = Eν/((1 + 2ν)(1 − 2ν))", E * nu / ((1.0 + 2.0 * nu) * (1.0 - 2.0 * nu))),
        ("λ = E/((1 + ν)(1 − 2ν)), without the ν above", E / ((1.0 + nu) * (1.0 - 2.0 * nu))),
        ("λ = E(1 − ν)/((1 + ν)(1 − 2ν))", E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))),
        ("the bulk modulus E/(3(1 − 2ν)) for λ", E / (3.0 * (1.0 - 2.0 * nu))),
        ("λ = 0", 0.0),
    ];
    let mus = [
        ("μ = E/(2(1 − ν))", E / (2.0 * (1.0 - nu))),
        ("μ = E/(2(1 + 2ν))", E / (2.0 * (1.0 + 2.0 * nu))),
        ("μ = E/(2(1 − 2ν))", E / (2.0 * (1.0 - 2.0 * nu))),
        ("μ = E/(2 + ν)", E / (2.0 + nu)),
        ("μ = E/(1 + 2ν)", E / (1.0 + 2.0 * nu)),
        ("μ = E/2, without ν", E / 2.0),
        ("μ = Eν/(2(1 + ν))", E * nu / (2.0 * (1.0 + nu))),
    ];
    let D = |lambda: f64, mu: f64| law::D(lambda, mu);
    let value = |lambda: f64, mu: f64| match quantity {
        "16.D" => Some(rows(&D(lambda, mu))),
        "15.sigma" => Some(
            evaluate("14.epsilon", state)?
                .chunks_exact(3)
                .flat_map(|eps| rows(&(D(lambda, mu) * Vector3::from_row_slice(eps))))
                .collect(),
        ),
        _ => with_heat_and_law(quantity, state, &state.eps_T(), lambda, mu),
    };
    let mut all = Vec::new();
    for (what, wrong) in lambdas {
        let value = if quantity == "17.lambda" { Some(vec![wrong]) } else { value(wrong, mu) };
        all.extend(value.map(|value| candidate(Kind::Poisson, what, value)));
    }
    for (what, wrong) in mus {
        let value = if quantity == "17.mu" { Some(vec![wrong]) } else { value(lambda, wrong) };
        all.extend(value.map(|value| candidate(Kind::Poisson, what, value)));
    }
    let stress = [("plane stress in place of (16)", 2.0 * mu * nu / (1.0 - nu), mu), ("λ and μ exchanged", mu, lambda)];
    for (what, lambda, mu) in stress {
        all.extend(value(lambda, mu).map(|value| candidate(Kind::Poisson, what, value)));
    }
    all
}

/// Mistakes in (9), (10) and in the products of (11) and (21).
fn gradients(quantity: &str, state: &ElementState) -> Vec<Candidate> {
    let (e, element) = (Vector14::from(state.e), state.element());
    let at_points = |f: &dyn Fn(f64, f64) -> Vec<f64>| state.points.iter().flat_map(|&[x, y]| f(x, y)).collect();
    let J_0 = |x, y| strain::J_0(x, y, &element);
    let gradient = |x, y| strain::J(x, y, &e, &element) * J_0(x, y);
    let inverse = |x, y| J_0(x, y).try_inverse().unwrap_or_else(Matrix2::zeros);
    let J = |x, y| strain::J(x, y, &e, &element);
    let S = |x, y| strain::S_abc(x, y, &element);
    let identity = Matrix2::identity();
    let transpose = |what: &str, value| candidate(Kind::Transpose, what, value);
    let other = |what: &str, value| candidate(Kind::Other, what, value);
    match quantity {
        "9.J" => vec![
            transpose("J_0⁻ᵀ for J_0⁻¹", at_points(&|x, y| rows(&(gradient(x, y) * inverse(x, y).transpose())))),
            transpose("J_0⁻¹ from the left", at_points(&|x, y| rows(&(inverse(x, y) * gradient(x, y))))),
            transpose(
                "the gradient transposed before J_0⁻¹",
                at_points(&|x, y| rows(&(gradient(x, y).transpose() * inverse(x, y)))),
            ),
            other("J_0 for J_0⁻¹", at_points(&|x, y| rows(&(gradient(x, y) * J_0(x, y))))),
            other("without J_0⁻¹", at_points(&|x, y| rows(&gradient(x, y)))),
        ],
        "10.epsilon_m" => vec![
            transpose("J Jᵀ for Jᵀ J", at_points(&|x, y| rows(&(0.5 * (J(x, y) * J(x, y).transpose() - identity))))),
            transpose("J J for Jᵀ J", at_points(&|x, y| rows(&(0.5 * (J(x, y) * J(x, y) - identity))))),
            other(
                "½ (J + Jᵀ) − I, the small strain",
                at_points(&|x, y| rows(&(0.5 * (J(x, y) + J(x, y).transpose()) - identity))),
            ),
        ],
        "21.S_a1" => vec![transpose("S_a for S_aᵀ + S_a", at_points(&|x, y| rows(&S(x, y).0)))],
        "21.S_b1" => vec![transpose("S_b for S_bᵀ + S_b", at_points(&|x, y| rows(&S(x, y).1)))],
        "21.S_c1" => vec![
            transpose("S_c + S_c for S_cᵀ + S_c", at_points(&|x, y| rows(&(2.0 * S(x, y).2)))),
            transpose("S_cᵀ + S_cᵀ for S_cᵀ + S_c", at_points(&|x, y| rows(&(2.0 * S(x, y).2.transpose())))),
            transpose("S_c for S_cᵀ + S_c", at_points(&|x, y| rows(&S(x, y).2))),
            candidate(Kind::Sign, "S_cᵀ − S_c", at_points(&|x, y| rows(&(S(x, y).2.transpose() - S(x, y).2)))),
            candidate(Kind::Sign, "S_c − S_cᵀ", at_points(&|x, y| rows(&(S(x, y).2 - S(x, y).2.transpose())))),
        ],
        "21.K_3" | "21.K_1" | "21.K_2" | "tangent.dQ_e" => integrals(quantity, state),
        _ => Vec::new(),
    }
}

/// Mistakes inside the integrals of (21) and in the tangent.
fn integrals(quantity: &str, state: &ElementState) -> Vec<Candidate> {
    let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
    let stations = stations(&e, &element);
    let unit = [1.0, 1.0, 0.0];
    let strain = |s: &Station, k: usize| s.form[k] - unit[k] - 2.0 * eps_T[k];
    let value = |weights: &dyn Fn(&Station) -> [f64; 3]| rows(&K(&stations, weights));
    match quantity {
        "21.K_1" => vec![
            candidate(Kind::Other, "K_2 for K_1: S_a1 with S_b", value(&|s| [strain(s, 1), strain(s, 0), 0.0])),
            candidate(
                Kind::Other,
                "the heat of 11 and 22 exchanged",
                value(&|s| [s.form[0] - 1.0 - 2.0 * eps_T[1], s.form[1] - 1.0 - 2.0 * eps_T[0], 0.0]),
            ),
        ],
        "21.K_2" => vec![
            candidate(Kind::Other, "K_1 for K_2: S_a1 with S_a", value(&|s| [strain(s, 0), strain(s, 1), 0.0])),
            candidate(
                Kind::Other,
                "the heat of 11 and 22 exchanged",
                value(&|s| [s.form[1] - 1.0 - 2.0 * eps_T[0], s.form[0] - 1.0 - 2.0 * eps_T[1], 0.0]),
            ),
        ],
        "21.K_3" => {
            let of = |S: &dyn Fn(&Station) -> Matrix14| {
                let sum = stations.iter().map(|s| S(s) * (0.25 * strain(s, 2) * s.dV));
                rows(&sum.fold(Matrix14::zeros(), |sum, part| sum + part))
            };
            vec![
                candidate(Kind::Transpose, "S_c + S_c for S_c1", of(&|s| 2.0 * s.S[2])),
                candidate(Kind::Transpose, "S_c for S_c1", of(&|s| s.S[2])),
                candidate(
                    Kind::HeatOnShear,
                    "αΔT in K_3, as in K_1",
                    value(&|s| {
                        let heat = if state.model == ThermalModel::None { 0.0 } else { state.alpha * state.dT };
                        [0.0, 0.0, s.form[2] - 2.0 * heat]
                    }),
                ),
            ]
        }
        _ => {
            // K, the material part left out, halved or doubled is among the terms; here E3 in it alone.
            let (lambda, mu) = (law::lambda(state.E, state.nu), law::mu(state.E, state.nu));
            let (K_1, K_2) = (force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element));
            let stiffness = force::K(lambda, mu, &K_1, &K_2, &force::K_3(&e, &eps_T, &element));
            let stiff = lambda + 2.0 * mu;
            let half = [[stiff, lambda, 0.0], [lambda, stiff, 0.0], [0.0, 0.0, 2.0 * mu]];
            vec![candidate(
                Kind::Erratum,
                "E3 in the material part alone",
                rows(&(stiffness + material(&stations, &e, half))),
            )]
        }
    }
}

/// A length, the density or a modulus left out, or taken twice; other lengths in the place of one.
fn parameters(quantity: &str, case: &Case, state: &ElementState) -> Vec<Candidate> {
    let Some(reference) = case.values.get(quantity) else { return Vec::new() };
    let names = [("l", state.l), ("h", state.h), ("w", state.w), ("ρ", state.rho), ("E", state.E)];
    let times = |factor: f64| reference.numbers.iter().map(|value| factor * value).collect();
    let mut all = Vec::new();
    for (name, value) in names {
        all.push(candidate(Kind::Missing, format!("{name} left out"), times(1.0 / value)));
        all.push(candidate(Kind::Factor, format!("{name} taken twice"), times(value)));
    }
    if quantity.starts_with("3.") {
        for i in 0..7 {
            let entries = reference.numbers.iter().enumerate();
            let numbers = entries.map(|(n, value)| if n % 7 == i { value / state.l } else { *value }).collect();
            all.push(candidate(Kind::Missing, format!("in S_{} the factor l left out", i + 1), numbers));
        }
    }
    let exchanged = ElementState { h: state.w, w: state.h, ..state.clone() };
    all.extend(evaluate(quantity, &exchanged).map(|value| candidate(Kind::Other, "h and w exchanged", value)));
    let halved = ElementState { h: 2.0 * state.h, w: state.w / 2.0, ..state.clone() };
    all.extend(evaluate(quantity, &halved).map(|value| candidate(Kind::Other, "−h … h for −h/2 … h/2", value)));
    for (what, y) in [("y with the other sign", -1.0), ("y = 0", 0.0)] {
        let points = state.points.iter().map(|[x, at]| [*x, y * at]).collect();
        let moved = ElementState { points, ..state.clone() };
        all.extend(evaluate(quantity, &moved).map(|value| candidate(Kind::Other, what, value)));
    }
    let backwards =
        ElementState { points: state.points.iter().map(|[x, y]| [state.l - x, *y]).collect(), ..state.clone() };
    all.extend(
        evaluate(quantity, &backwards).map(|value| candidate(Kind::NodeOrder, "x counted from the other end", value)),
    );
    let swapped = shape_of_velocity(quantity, state);
    all.extend(swapped.map(|value| candidate(Kind::Other, "e in the place of ė", value)));
    all
}

/// (5) and (6) with e for ė.
fn shape_of_velocity(quantity: &str, state: &ElementState) -> Option<Vec<f64>> {
    match quantity {
        "5.rdot" => Some(
            state
                .points
                .iter()
                .flat_map(|&[x, y]| {
                    let r = shape::r(x, y, &Vector14::from(state.e), state.l);
                    [r[0], r[1]]
                })
                .collect(),
        ),
        "6.T" => evaluate("6.T", &ElementState { edot: state.e, ..state.clone() }),
        _ => None,
    }
}

/// (23) solved with other signs.
fn signs_of_23(quantity: &str, system: &SystemState) -> Vec<Candidate> {
    let changes: [(&str, SystemState); 2] = [
        ("k q with the other sign", SystemState { kq: -&system.kq, ..system.clone() }),
        ("f with the other sign", SystemState { f: -&system.f, ..system.clone() }),
    ];
    let with = |(what, system): (&str, SystemState)| {
        Some(candidate(Kind::Sign, what, crate::state::evaluate_system(quantity, &system)?))
    };
    changes.into_iter().filter_map(with).collect()
}

/// The numbers of a matrix, row by row.
pub(super) fn rows<R: nalgebra::Dim, C: nalgebra::Dim, S: nalgebra::RawStorage<f64, R, C>>(
    matrix: &nalgebra::Matrix<f64, R, C, S>,
) -> Vec<f64> {
    matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect()
}
