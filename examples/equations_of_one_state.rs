//! Equations (18)–(21) of one element in one state: strain energy, stiffness and its parts, elastic forces.
//!
//! `cargo run --release --example equations_of_one_state`

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::equations::element::Element;
use ancf::equations::force::{K, K_1, K_2, K_3, Q_e, U};
use ancf::equations::material::{LameConstants, YoungPoisson};
use ancf::equations::strain::eps_T;

fn main() {
    // An element of Table 1's pendulum at 30°, bent and stretched, 200 K warmer; ν = 0.3 so that no term vanishes.
    let element = Element::straight(0.125, 0.02, 0.02, 30f64.to_radians());
    let moduli = LameConstants::from(YoungPoisson { E: 2e8, nu: 0.3 });
    let eps_T = eps_T(2.85e-5, 200.0);
    let mut e = element.e_0;
    e[5] += 1e-3; // y of the middle node, r_j
    e[10] += 2e-4; // x of the last node, r_k

    let U = U(&e, &eps_T, moduli, &element);
    let (K_1, K_2, K_3) = (K_1(&e, &eps_T, &element), K_2(&e, &eps_T, &element), K_3(&e, &eps_T, &element));
    let K = K(moduli, &K_1, &K_2, &K_3);
    let Q_e = Q_e(&e, &K);

    println!("λ = {:.4e} Pa, μ = {:.4e} Pa", moduli.lambda, moduli.mu);
    println!("(18) U = {U:.6e} J");
    println!("(21) first entries of K₁, K₂, K₃: {:.4e}, {:.4e}, {:.4e} m", K_1[(0, 0)], K_2[(0, 0)], K_3[(0, 0)]);
    println!("(20) first entry of K: {:.4e} N/m", K[(0, 0)]);
    println!("(19) Q_e:");
    for (name, row) in ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"].iter().zip(Q_e.as_slice().chunks(2)) {
        println!("  {name:5} {:+.6e} {:+.6e}", row[0], row[1]);
    }
}
