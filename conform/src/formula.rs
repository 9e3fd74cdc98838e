//! The formula of every quantity, in a line to compare with one's own.

/// What to look at if a quantity is wrong: its formula, and where the paper prints another one. Empty for a quantity that is not asked for.
pub fn formula(quantity: &str) -> &'static str {
    FORMULAS.iter().find(|(name, _)| *name == quantity).map_or("", |(_, formula)| formula)
}

/// Formulas by quantity, in the order of the questions. ξ = x/l, η = y/l; c = cos θ, s = sin θ; E1 to E4 are the paper's printed errors.
const FORMULAS: &[(&str, &str)] = &[
    ("4.nodes", "e holds r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k in this order, each vector x before y"),
    (
        "A.3.coefficients",
        "a_0 … a_6 solve (A.2); a_1 = −(5 r_i − 4 r_j − r_k + 2l r_x_j)/l, where the paper prints + r_k (E1)",
    ),
    ("A.1.r", "r = a_0 + a_1 x + a_2 y + a_3 xy + a_4 x² + a_5 x³ + a_6 x²y"),
    ("A.1.r_x", "∂r/∂x = a_1 + a_3 y + 2 a_4 x + 3 a_5 x² + 2 a_6 xy"),
    ("A.1.r_y", "∂r/∂y = a_2 + a_3 x + a_6 x²"),
    ("A.2.e", "(A.1) and its derivatives at y = 0: r, r_y at x = 0; r, r_x, r_y at x = l/2; r, r_y at x = l"),
    (
        "3.S",
        "S_1 = 1 − 5ξ + 8ξ² − 4ξ³, S_2 = lη(1 − 3ξ + 2ξ²), S_3 = 4ξ − 4ξ², S_4 = l(−2ξ + 6ξ² − 4ξ³), S_5 = lη(4ξ − 4ξ²), \
         S_6 = ξ − 4ξ² + 4ξ³, S_7 = lη(−ξ + 2ξ²), with ξ = x/l and η = y/l",
    ),
    ("3.S_x", "derivatives of S_1 … S_7 in x, not in ξ: a factor 1/l"),
    ("3.S_y", "derivatives of S_1 … S_7 in y, not in η: a factor 1/l; those of S_1, S_3, S_4, S_6 are 0"),
    ("A.4.r", "r = S_1 r_i + S_2 r_y_i + S_3 r_j + S_4 r_x_j + S_5 r_y_j + S_6 r_k + S_7 r_y_k"),
    ("2.S", "S = [S_1 I, S_2 I, …, S_7 I], 2 × 14, I the 2 × 2 identity"),
    ("1.r", "r = S e"),
    ("5.rdot", "ṙ = S ė; S does not change in time"),
    ("7.M", "M = ∫ ρ SᵀS dV over l, h and w; two Gauss points across and four along are exact"),
    ("6.T", "T = ½ ėᵀ M ė"),
    (
        "8.epsilon_T",
        "αΔT (1, 1, 0) in the model 2d, αΔT (c², s², sc) in 1d, 0 in none; order 11, 22, 12, global axes; the shear entry is ε₁₂, \
         not 2ε₁₂",
    ),
    ("9.J_0", "J_0 = [S_x e_0, S_y e_0] as columns: a rotation by θ for the straight element"),
    ("9.J", "J = [S_x e, S_y e] J_0⁻¹"),
    ("10.epsilon_m", "ε = ½ (JᵀJ − I); not J Jᵀ; no heat"),
    ("11.S_a", "S_a = c² S_xᵀS_x − sc (S_xᵀS_y + S_yᵀS_x) + s² S_yᵀS_y, each product over both rows of S"),
    ("11.S_b", "S_b = s² S_xᵀS_x + sc (S_xᵀS_y + S_yᵀS_x) + c² S_yᵀS_y, each product over both rows of S"),
    ("11.S_c", "S_c = sc S_xᵀS_x + c² S_xᵀS_y − s² S_yᵀS_x − sc S_yᵀS_y; not symmetric"),
    ("13.epsilon_1", "ε_1 = ½ (eᵀS_a e − 1)"),
    ("13.epsilon_2", "ε_2 = ½ (eᵀS_b e − 1)"),
    ("13.epsilon_3", "ε_3 = ½ eᵀS_c e, without − 1; it is ε₁₂, not 2ε₁₂"),
    ("12.epsilon_f", "ε_f = (ε_1, ε_2, ε_3), in the order 11, 22, 12"),
    ("14.epsilon", "ε = ε_f − ε_T"),
    ("17.lambda", "λ = Eν/((1 + ν)(1 − 2ν))"),
    ("17.mu", "μ = E/(2(1 + ν))"),
    ("16.D", "D = [[λ + 2μ, λ, 0], [λ, λ + 2μ, 0], [0, 0, 2μ]], for ε₁₂ as the shear strain"),
    ("15.sigma", "σ = D ε, with the heat taken off; σ₁₂ = 2μ ε₁₂"),
    (
        "18.U",
        "U = ½ ∫ (σ₁₁ε₁₁ + σ₂₂ε₂₂ + 2σ₁₂ε₁₂) dV: the shear counts twice, where the paper counts it once (E3); ε is that of (14)",
    ),
    ("21.S_a1", "S_a1 = S_aᵀ + S_a"),
    ("21.S_b1", "S_b1 = S_bᵀ + S_b"),
    ("21.S_c1", "S_c1 = S_cᵀ + S_c"),
    (
        "21.K_1",
        "K_1 = ¼ ∫ S_a1 (eᵀS_a e − 1 − 2ε_T1) + S_b1 (eᵀS_b e − 1 − 2ε_T2) dV; five Gauss points along and three across are exact",
    ),
    (
        "21.K_2",
        "K_2 = ¼ ∫ S_a1 (eᵀS_b e − 1 − 2ε_T2) + S_b1 (eᵀS_a e − 1 − 2ε_T1) dV; five Gauss points along and three across are exact",
    ),
    (
        "21.K_3",
        "K_3 = ¼ ∫ S_c1 (eᵀS_c e − 2ε_T3) dV: the bracket has no − 1, where the paper prints − 1 and no heat (E2)",
    ),
    ("20.K", "K = (λ + 2μ) K_1 + λ K_2 + 4μ K_3, where the paper prints 2μ K_3 (E3)"),
    ("19.Q_e", "Q_e = Kᵀe = ∂U/∂e; it stands on the left of M ë + Q_e = Q_w"),
    (
        "tangent.dQ_e",
        "∂Q_e/∂e = K + ¼ ∫ (λ + 2μ)(aaᵀ + bbᵀ) + λ(abᵀ + baᵀ) + 4μ ccᵀ dV, with a = S_a1 e, b = S_b1 e, c = S_c1 e",
    ),
    ("gravity.Q_w", "Q_w = ∫ ρ Sᵀg dV"),
    ("22.residual", "M a + Q_e − Q_w, with the numbers of ė for a"),
    ("22.eddot", "ë solves M ë = Q_w − Q_e"),
    ("23.m", "each element's M at the coordinates that it shares, added where elements meet"),
    ("23.Q_e", "each element's Q_e at its own temperature, added where elements meet"),
    ("23.f", "each element's Q_w, and the point forces times their histories"),
    ("23.Phi", "pins, then fixed and sliding points, then clamps, each less its value at first"),
    ("23.Phi_q", "∂Φ/∂q: a row for each constraint, a column for each coordinate"),
    ("23.constraint_force", "Φ_qᵀ λ, where the paper prints Φ_q λ (E4)"),
    ("23.residual", "m q̈ + Q_e + Φ_qᵀ λ − f; Φ_qᵀ, where the paper prints Φ_q (E4)"),
    ("23.acceleration", "q̈ solves [[m, Φ_qᵀ], [Φ_q, 0]] (q̈, λ) = (f − Q_e, 0)"),
    ("23.lambda", "λ of [[m, Φ_qᵀ], [Φ_q, 0]] (q̈, λ) = (f − Q_e, 0), with this sign"),
    ("axis.D_0", "D_0 = diag(E*, E*, μ), E* = E/(1 − ν²), for the strains (11, 22, 2·12)"),
    ("axis.epsilon", "strain of (14) turned into the rod's axes, as (11, 22, 2·12): the shear entry is twice ε₁₂"),
    ("axis.U", "U = ½ ∫ εᵀD_0 ε dV + ½ hw ∫ εᵀ(D − D_0) ε dx on the axis y = 0, with axis.epsilon"),
    ("axis.Q_e", "derivative of axis.U by e"),
    ("axis.tangent", "second derivative of axis.U by e"),
    ("uniaxial.D", "D = diag(E, E, G), G = E/(2(1 + ν)), for the strains (11, 22, 2·12)"),
    ("uniaxial.U", "U = ½ ∫ εᵀD ε dV with axis.epsilon and uniaxial.D"),
    ("uniaxial.Q_e", "derivative of uniaxial.U by e"),
    ("uniaxial.tangent", "second derivative of uniaxial.U by e"),
    (
        "cable.S",
        "S_1 = 1 − 3ξ² + 2ξ³, S_2 = l(ξ − 2ξ² + ξ³), S_3 = 3ξ² − 2ξ³, S_4 = l(−ξ² + ξ³), with ξ = x/l from 0 to 1",
    ),
    ("cable.S_x", "derivatives of S_1 … S_4 in x, not in ξ: a factor 1/l"),
    ("cable.S_xx", "second derivatives of S_1 … S_4 in x, not in ξ: a factor 1/l²"),
    ("cable.r", "r = S_1 r_i + S_2 r_x_i + S_3 r_k + S_4 r_x_k"),
    ("cable.r_x", "∂r/∂x, the sum of S_i_x e_i; its length is the stretch"),
    ("cable.r_xx", "∂²r/∂x², the sum of S_i_xx e_i"),
    ("cable.epsilon", "ε = |r_x| − 1 − αΔT; not ½ (|r_x|² − 1)"),
    ("cable.kappa", "κ = (r_x × r_xx)/|r_x|²; not divided by |r_x|³"),
    ("cable.M", "M = ∫ ρA SᵀS dx, A = hw, without the section's rotation"),
    ("cable.T", "T = ½ ėᵀ M ė"),
    ("cable.U", "U = ½ ∫ EA ε² dx with five Gauss points + ½ ∫ EI κ² dx with three, A = hw, I = wh³/12"),
    ("cable.Q_e", "derivative of cable.U by e, with the same Gauss points: five for ε, three for κ"),
    ("cable.tangent", "second derivative of cable.U by e, with the same Gauss points: five for ε, three for κ"),
    ("cable.Q_w", "Q_w = ∫ ρA Sᵀg dx"),
    ("cable.eddot", "ë solves M ë = Q_w − Q_e"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::GRAPH;

    #[test]
    fn every_quantity_has_its_formula_in_the_order_of_the_questions() {
        let named: Vec<&str> = FORMULAS.iter().map(|(name, _)| *name).collect();
        assert_eq!(named, GRAPH.iter().map(|node| node.quantity).collect::<Vec<_>>());
    }
}
