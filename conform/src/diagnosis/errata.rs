//! Printed errors of the paper that were copied.

#![allow(non_snake_case)] // The paper's symbols are names here.

use nalgebra::DMatrix;

use super::candidate::{Candidate, candidate, possible};
use super::entries::rows;
use super::mistake::MistakeKind::Erratum;
use super::quadrature::{self, K, integrands};
use crate::suite::{Case, State};
use ancf::equations::element::{Element, Matrix14};
use ancf::equations::force;
use ancf::equations::material::LameConstants;
use ancf::equations::motion;
use ancf::equations::shape::Vector14;
use ancf::internals::state::SystemState;
use ancf::state::{ElementState, evaluate};

/// Candidates with the printed forms of the fixtures.
pub(super) fn of<'a>(quantity: &'a str, case: &'a Case) -> Vec<Candidate<'a>> {
    let printed = |what: &str, name: &'static str| {
        vec![possible(Erratum, what, move || case.values.get(name).map(|value| value.numbers.clone()))]
    };
    let mut all = match quantity {
        "A.3.coefficients" => printed("E1: +r_k in a_1", "A.3.coefficients/printed"),
        "21.K_3" => printed("E2: −1 in K_3, and no heat", "21.K_3/printed"),
        "18.U" => printed("E3: the shear counted once", "18.U/printed-shear"),
        "19.Q_e" => printed("E3: 2μ K_3 for 4μ K_3", "19.Q_e/printed-shear"),
        "20.K" => printed("E3: 2μ K_3 for 4μ K_3", "20.K/printed-shear"),
        "tangent.dQ_e" => printed("E3: 2μ K_3 for 4μ K_3", "tangent.dQ_e/printed-shear"),
        "23.constraint_force" => printed("E4: Φ_q λ for Φ_qᵀ λ", "23.constraint_force/printed"),
        "23.residual" => printed("E4: Φ_q λ for Φ_qᵀ λ", "23.residual/printed"),
        _ => Vec::new(),
    };
    match &case.state {
        State::Element(state) => all.extend(of_element(quantity, state)),
        State::System(system) => all.extend(of_system(quantity, system)),
        State::Cable(_) => {}
    }
    all
}

/// Candidates with E4 where Φ_q is one list of numbers: any shape can be read from it.
fn of_system<'a>(quantity: &str, system: &'a SystemState) -> Option<Candidate<'a>> {
    let SystemState { m, q_ddot, kq, Phi_q, lambda, f } = system;
    let force = move || DMatrix::from_row_slice(Phi_q.ncols(), Phi_q.nrows(), &rows(Phi_q)) * lambda;
    let what = "E4: Φ_q λ for Φ_qᵀ λ, with Φ_q read from one list";
    match quantity {
        "23.constraint_force" => Some(candidate(Erratum, what, move || rows(&force()))),
        "23.residual" => {
            Some(candidate(Erratum, what, move || rows(&motion::system_residual(m, q_ddot, kq, &force(), f))))
        }
        _ => None,
    }
}

/// Candidates with a part of E2, the −1 without the missing heat, and with E2 and E3 together.
fn of_element<'a>(quantity: &str, state: &'a ElementState) -> Vec<Candidate<'a>> {
    let lame = LameConstants::from(state.moduli());
    let K_123 = move || {
        let (e, element, eps_T) = (Vector14::from(state.e), state.element(), state.eps_T());
        let unit = K(&integrands(&e, &element, &quadrature::exact(state)), |_| [0.0, 0.0, 1.0]);
        let K_3 = force::K_3(&e, &eps_T, &element) - unit;
        (force::K_1(&e, &eps_T, &element), force::K_2(&e, &eps_T, &element), K_3)
    };
    type Sum = fn(LameConstants, &Matrix14, &Matrix14, &Matrix14) -> Matrix14;
    let sums: [(&str, Sum); 2] =
        [("E2: −1 in K_3", force::K), ("E2 and E3: −1 in K_3, and 2μ K_3 for 4μ K_3", force::K_printed)];
    let summed = move |sum: Sum| {
        let (K_1, K_2, K_3) = K_123();
        sum(lame, &K_1, &K_2, &K_3)
    };
    match quantity {
        "18.U" | "tangent.dQ_e" => vec![in_own_axes(quantity, state)],
        "21.K_3" => vec![candidate(Erratum, "E2: −1 in K_3", move || rows(&K_123().2))],
        "20.K" => {
            let of_sums = sums.map(|(what, sum)| candidate(Erratum, what, move || rows(&summed(sum))));
            of_sums.into_iter().chain([in_own_axes(quantity, state)]).collect()
        }
        "19.Q_e" => {
            let e = Vector14::from(state.e);
            let of_sums = sums.map(|(what, sum)| candidate(Erratum, what, move || rows(&force::Q_e(&e, &summed(sum)))));
            of_sums.into_iter().chain([in_own_axes(quantity, state)]).collect()
        }
        _ => Vec::new(),
    }
}

/// Candidate with E3 made in the rod's own axes: their shear strain counts once, as in rods without θ.
///
/// The strains in these axes are those of (9)–(13) for an initial element along x: they depend on lengths and angles of r_x and r_y alone.
fn in_own_axes<'a>(quantity: &str, state: &'a ElementState) -> Candidate<'a> {
    let printed = format!("{quantity}/printed-shear");
    possible(Erratum, "E3 in the rod's own axes: the shear counted once there, μ for 2μ", move || {
        let along_x = Element::straight(state.l, state.h, state.w, 0.0);
        evaluate(&printed, &ElementState { theta: 0.0, e0: along_x.e_0.into(), ..state.clone() })
    })
}
