//! Dependencies between quantities: a mistake propagates along them from (1) to (23).

/// A quantity and the quantities from which it is computed.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Name in the fixtures; it begins with the number of the equation.
    pub quantity: &'static str,
    /// Inputs that are needed only at the state or at its points. They can be sent with a question as `given`.
    pub given: &'static [&'static str],
    /// Inputs that are needed elsewhere, such as at quadrature points. They cannot be sent.
    pub inner: &'static [&'static str],
}

impl Node {
    /// All inputs of the quantity.
    pub fn inputs(&self) -> impl Iterator<Item = &'static str> {
        self.given.iter().chain(self.inner).copied()
    }
}

const fn node(quantity: &'static str, given: &'static [&'static str], inner: &'static [&'static str]) -> Node {
    Node { quantity, given, inner }
}

/// Assembled terms of a structure. They are asked for where the case has a scene, and sent with every other question about (23).
pub const TERMS_OF_23: &[&str] = &["23.m", "23.Q_e", "23.f", "23.Phi_q"];

/// Whether a quantity can be computed only from the scene of a structure.
pub fn needs_a_scene(quantity: &str) -> bool {
    quantity == "23.Phi" || TERMS_OF_23.contains(&quantity)
}

const GRADIENTS: &[&str] = &["3.S_x", "3.S_y"];
const METRICS: &[&str] = &["3.S_x", "3.S_y", "9.J_0"];
const MOTION: &[&str] = &["7.M", "19.Q_e", "gravity.Q_w"];

/// Every quantity that is asked for, in the paper's order where inputs allow it: each input precedes the quantities that use it.
pub const GRAPH: &[Node] = &[
    node("4.nodes", &[], &[]),
    node("A.3.coefficients", &["4.nodes"], &[]),
    node("A.1.r", &["A.3.coefficients"], &[]),
    node("A.1.r_x", &["A.3.coefficients"], &[]),
    node("A.1.r_y", &["A.3.coefficients"], &[]),
    node("A.2.e", &["A.3.coefficients"], &[]),
    node("3.S", &[], &[]),
    node("3.S_x", &[], &["3.S"]),
    node("3.S_y", &[], &["3.S"]),
    node("A.4.r", &["3.S", "4.nodes"], &[]),
    node("2.S", &["3.S"], &[]),
    node("1.r", &["2.S"], &[]),
    node("5.rdot", &["2.S"], &[]),
    node("7.M", &[], &["2.S"]),
    node("6.T", &["7.M"], &[]),
    node("8.epsilon_T", &[], &[]),
    node("9.J_0", GRADIENTS, &[]),
    node("9.J", METRICS, &[]),
    node("10.epsilon_m", &["9.J"], &[]),
    node("11.S_a", METRICS, &[]),
    node("11.S_b", METRICS, &[]),
    node("11.S_c", METRICS, &[]),
    node("13.epsilon_1", &["11.S_a"], &[]),
    node("13.epsilon_2", &["11.S_b"], &[]),
    node("13.epsilon_3", &["11.S_c"], &[]),
    node("12.epsilon_f", &["13.epsilon_1", "13.epsilon_2", "13.epsilon_3"], &[]),
    node("14.epsilon", &["12.epsilon_f", "8.epsilon_T"], &[]),
    node("17.lambda", &[], &[]),
    node("17.mu", &[], &[]),
    node("16.D", &["17.lambda", "17.mu"], &[]),
    node("15.sigma", &["16.D", "14.epsilon"], &[]),
    node("18.U", &["8.epsilon_T", "16.D"], &["14.epsilon", "15.sigma"]),
    node("21.S_a1", &["11.S_a"], &[]),
    node("21.S_b1", &["11.S_b"], &[]),
    node("21.S_c1", &["11.S_c"], &[]),
    node("21.K_1", &["8.epsilon_T"], &["11.S_a", "11.S_b", "21.S_a1", "21.S_b1"]),
    node("21.K_2", &["8.epsilon_T"], &["11.S_a", "11.S_b", "21.S_a1", "21.S_b1"]),
    node("21.K_3", &["8.epsilon_T"], &["11.S_c", "21.S_c1"]),
    node("20.K", &["17.lambda", "17.mu", "21.K_1", "21.K_2", "21.K_3"], &[]),
    node("19.Q_e", &["20.K"], &[]),
    node("tangent.dQ_e", &["17.lambda", "17.mu", "20.K"], &["21.S_a1", "21.S_b1", "21.S_c1"]),
    node("gravity.Q_w", &[], &["2.S"]),
    node("22.residual", MOTION, &[]),
    node("22.eddot", MOTION, &[]),
    node("23.m", &[], &["7.M"]),
    node("23.Q_e", &[], &["19.Q_e"]),
    node("23.f", &[], &["gravity.Q_w"]),
    node("23.Phi", &[], &[]),
    node("23.Phi_q", &[], &[]),
    node("23.constraint_force", &[], &[]),
    node("23.residual", &["23.constraint_force"], &[]),
    node("23.acceleration", &[], &[]),
    node("23.lambda", &[], &[]),
    node("axis.D_0", &[], &[]),
    node("axis.epsilon", GRADIENTS, &[]),
    node("axis.U", &["axis.D_0", "16.D"], &["axis.epsilon"]),
    node("axis.Q_e", &["axis.D_0", "16.D"], &["axis.epsilon"]),
    node("axis.tangent", &["axis.D_0", "16.D"], &["axis.epsilon"]),
    node("uniaxial.D", &["17.mu"], &[]),
    node("uniaxial.U", &["uniaxial.D"], &["axis.epsilon"]),
    node("uniaxial.Q_e", &["uniaxial.D"], &["axis.epsilon"]),
    node("uniaxial.tangent", &["uniaxial.D"], &["axis.epsilon"]),
    node("cable.S", &[], &[]),
    node("cable.S_x", &[], &["cable.S"]),
    node("cable.S_xx", &[], &["cable.S_x"]),
    node("cable.r", &["cable.S"], &[]),
    node("cable.r_x", &["cable.S_x"], &[]),
    node("cable.r_xx", &["cable.S_xx"], &[]),
    node("cable.epsilon", &["cable.r_x"], &[]),
    node("cable.kappa", &["cable.r_x", "cable.r_xx"], &[]),
    node("cable.M", &[], &["cable.S"]),
    node("cable.T", &["cable.M"], &[]),
    node("cable.U", &[], &["cable.epsilon", "cable.kappa"]),
    node("cable.Q_e", &[], &["cable.epsilon", "cable.kappa"]),
    node("cable.tangent", &[], &["cable.epsilon", "cable.kappa"]),
    node("cable.Q_w", &[], &["cable.S"]),
    node("cable.eddot", &["cable.M", "cable.Q_e", "cable.Q_w"], &[]),
];

/// Inputs of quantities on routes that the paper does not take, but many programs do: strains and forces from the deformation gradient
/// and the stresses, forces from an energy, a tangent from the force.
const OTHER_ROUTES: &[(&str, &[&str])] = &[
    ("A.2.e", &["A.1.r", "A.1.r_x", "A.1.r_y"]),
    ("13.epsilon_1", &["10.epsilon_m"]),
    ("13.epsilon_2", &["10.epsilon_m"]),
    ("13.epsilon_3", &["10.epsilon_m"]),
    ("12.epsilon_f", &["10.epsilon_m"]),
    ("19.Q_e", &["9.J", "15.sigma", "18.U"]),
    ("tangent.dQ_e", &["9.J", "16.D", "15.sigma", "19.Q_e", "18.U"]),
    ("cable.Q_e", &["cable.U"]),
    ("cable.tangent", &["cable.Q_e", "cable.U"]),
];

/// Inputs of a quantity on routes that the paper does not take.
pub fn on_other_routes(quantity: &str) -> &'static [&'static str] {
    OTHER_ROUTES.iter().find(|(name, _)| *name == quantity).map_or(&[], |(_, inputs)| inputs)
}

/// Node of a quantity; `None` if it is not asked for.
pub fn find(quantity: &str) -> Option<&'static Node> {
    GRAPH.iter().find(|node| node.quantity == quantity)
}

/// Number of a quantity's equation in the paper, or a word such as `tangent` for an equation that the paper omits.
pub fn equation(quantity: &str) -> &str {
    let name = quantity.split('/').next().unwrap_or(quantity);
    name.rsplit_once('.').map_or(name, |(equation, _)| equation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn inputs_precede_the_quantities_that_use_them() {
        let mut seen = BTreeSet::new();
        for node in GRAPH {
            for input in node.inputs() {
                assert!(seen.contains(input), "{} uses {input}", node.quantity);
            }
            assert!(seen.insert(node.quantity), "{} is listed twice", node.quantity);
        }
    }

    #[test]
    fn other_routes_lead_forwards_and_are_not_the_papers() {
        let place = |quantity: &str| GRAPH.iter().position(|node| node.quantity == quantity).unwrap();
        for (quantity, inputs) in OTHER_ROUTES {
            for input in *inputs {
                assert!(place(input) < place(quantity) || *quantity == "A.2.e", "{quantity} uses {input}");
                assert!(
                    !find(quantity).unwrap().inputs().any(|of_paper| of_paper == *input),
                    "{quantity} uses {input}"
                );
            }
        }
    }

    #[test]
    fn the_equation_precedes_the_last_dot() {
        assert_eq!(equation("21.K_3/printed"), "21");
        assert_eq!(equation("A.3.coefficients"), "A.3");
        assert_eq!(equation("tangent.dQ_e"), "tangent");
    }
}
