//! Terms of (16), (18) to (21) and the tangent.

#![allow(non_snake_case)] // The paper's symbols are names here.

use super::term::{Term, foreign, term};
use crate::diagnosis::entries::rows;
use crate::diagnosis::quadrature::{Integrand, K, exact, integrands, material, product};
use ancf::equations::element::Matrix14;
use ancf::equations::force;
use ancf::equations::material::LameConstants;
use ancf::equations::shape::Vector14;
use ancf::state::ElementState;

/// Terms of (16), (18) to (21) and the tangent.
pub(super) fn of(quantity: &str, state: &ElementState) -> Vec<Term> {
    let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
    let LameConstants { lambda, mu } = state.moduli().into();
    let parts = || {
        let (K_1, K_2) = (force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element));
        let K_3 = force::K_3(&e, &eps_T, &element);
        [
            ("λ K_1", lambda * K_1),
            ("2μ K_1", 2.0 * mu * K_1),
            ("(λ + 2μ) K_1", (lambda + 2.0 * mu) * K_1),
            ("λ K_2", lambda * K_2),
            ("4μ K_3", 4.0 * mu * K_3),
        ]
    };
    let at = || integrands(&e, &element, &exact(state));
    match quantity {
        "16.D" => vec![
            term("λ", vec![lambda, lambda, 0.0, lambda, lambda, 0.0, 0.0, 0.0, 0.0]),
            term("2μ", vec![2.0 * mu, 0.0, 0.0, 0.0, 2.0 * mu, 0.0, 0.0, 0.0, 2.0 * mu]),
        ],
        "18.U" => {
            let integrands = at();
            let stiff = 0.5 * (lambda + 2.0 * mu);
            let value = |k, n, factor: f64| vec![factor * product(&integrands, &eps_T, k, n)];
            vec![
                term("the square of ε_1", value(0, 0, stiff)),
                term("the square of ε_2", value(1, 1, stiff)),
                term("the product ε_1 ε_2", value(0, 1, lambda)),
                term("the square of ε_3", value(2, 2, 2.0 * mu)),
            ]
        }
        "20.K" => parts().map(|(name, K)| term(name, rows(&K))).into(),
        "19.Q_e" => parts().map(|(name, K)| term(format!("{name} e"), rows(&(K * e)))).into(),
        "21.K_1" | "21.K_2" => of_K(quantity, &at(), eps_T[0], eps_T[1]),
        "21.K_3" => {
            let integrands = at();
            vec![
                term("eᵀS_c e", rows(&K(&integrands, |s| [0.0, 0.0, s.form[2]]))),
                term("heat", rows(&K(&integrands, |_| [0.0, 0.0, -2.0 * eps_T[2]]))),
                foreign("1 next to eᵀS_c e", rows(&K(&integrands, |_| [0.0, 0.0, 1.0]))),
            ]
        }
        "tangent.dQ_e" => {
            let (integrands, stiff) = (at(), lambda + 2.0 * mu);
            let of = |weights| material(&integrands, |s| s.S_1.map(|S_1| S_1 * e), weights);
            let one = of([[stiff, 0.0, 0.0], [0.0, stiff, 0.0], [0.0; 3]]);
            let two = of([[0.0, lambda, 0.0], [lambda, 0.0, 0.0], [0.0; 3]]);
            let three = of([[0.0; 3], [0.0; 3], [0.0, 0.0, 4.0 * mu]]);
            let parts = parts();
            let stiffness = parts[2].1 + parts[3].1 + parts[4].1;
            let mut terms: Vec<(&str, Matrix14)> = vec![
                ("K, the part with the stress,", stiffness),
                ("the material part", one + two + three),
                ("the material part of ε_1 and ε_2", one),
                ("the material part of ε_1 with ε_2", two),
                ("the material part of ε_3", three),
            ];
            terms.extend(parts);
            terms.iter().map(|(name, K)| term(*name, rows(K))).collect()
        }
        _ => Vec::new(),
    }
}

/// Terms of K_1 or K_2; in K_2, S_a and S_b are exchanged in the brackets.
fn of_K(quantity: &str, integrands: &[Integrand], heat_1: f64, heat_2: f64) -> Vec<Term> {
    // Form and heat that multiply S_a1, and those that multiply S_b1.
    let ((a, heat_a), (b, heat_b), forms) = match quantity {
        "21.K_1" => ((0, heat_1), (1, heat_2), ["eᵀS_a e", "eᵀS_b e"]),
        _ => ((1, heat_2), (0, heat_1), ["eᵀS_b e", "eᵀS_a e"]),
    };
    let integrated = |name: String, weights: &dyn Fn(&Integrand) -> [f64; 3]| term(name, rows(&K(integrands, weights)));
    let [form_a, form_b] = forms;
    vec![
        integrated(form_a.into(), &|s| [s.form[a], 0.0, 0.0]),
        integrated(form_b.into(), &|s| [0.0, s.form[b], 0.0]),
        integrated(format!("−1 next to {form_a}"), &|_| [-1.0, 0.0, 0.0]),
        integrated(format!("−1 next to {form_b}"), &|_| [0.0, -1.0, 0.0]),
        integrated("−1 in both brackets".into(), &|_| [-1.0, -1.0, 0.0]),
        integrated("heat in both brackets".into(), &|_| [-2.0 * heat_a, -2.0 * heat_b, 0.0]),
        integrated(format!("heat next to {form_a}"), &|_| [-2.0 * heat_a, 0.0, 0.0]),
        integrated(format!("heat next to {form_b}"), &|_| [0.0, -2.0 * heat_b, 0.0]),
        integrated("the bracket with S_a1".into(), &|s| [s.form[a] - 1.0 - 2.0 * heat_a, 0.0, 0.0]),
        integrated("the bracket with S_b1".into(), &|s| [0.0, s.form[b] - 1.0 - 2.0 * heat_b, 0.0]),
    ]
}
