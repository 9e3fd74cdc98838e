//! Which quantity is computed from which: the order in which a mistake travels from (1) to (23).

/// One quantity and what it is computed from.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Its name in the fixtures; the equation's number comes first.
    pub quantity: &'static str,
    /// Inputs whose values at the state, or at its points, are all that is needed: these can be handed over as `given`.
    pub given: &'static [&'static str],
    /// Inputs that are needed at other points, such as those of a quadrature: these cannot.
    pub inner: &'static [&'static str],
}

impl Node {
    /// All inputs.
    pub fn inputs(&self) -> impl Iterator<Item = &'static str> {
        self.given.iter().chain(self.inner).copied()
    }
}

const fn node(quantity: &'static str, given: &'static [&'static str], inner: &'static [&'static str]) -> Node {
    Node { quantity, given, inner }
}

/// What every question of (23) brings along: the terms that a structure assembles.
pub const TERMS_OF_23: &[&str] = &["23.m", "23.Q_e", "23.f", "23.Phi_q"];

const GRADIENTS: &[&str] = &["3.S_x", "3.S_y"];
const METRICS: &[&str] = &["3.S_x", "3.S_y", "9.J_0"];
const MOTION: &[&str] = &["7.M", "19.Q_e", "gravity.Q_w"];

/// Every quantity that is asked for; inputs come before what uses them, otherwise the paper's order.
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
    node("23.constraint_force", &[], &[]),
    node("23.residual", &["23.constraint_force"], &[]),
    node("23.acceleration", &[], &[]),
    node("23.lambda", &[], &[]),
    node("axis.D_0", &[], &[]),
    node("axis.epsilon", GRADIENTS, &[]),
    node("axis.U", &["axis.D_0", "16.D"], &["axis.epsilon"]),
    node("axis.Q_e", &["axis.D_0", "16.D"], &["axis.epsilon"]),
    node("axis.tangent", &["axis.D_0", "16.D"], &["axis.epsilon"]),
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

/// The node of a quantity.
pub fn find(quantity: &str) -> Option<&'static Node> {
    GRAPH.iter().find(|node| node.quantity == quantity)
}

/// The paper's number of a quantity's equation, or the word for what the paper leaves out.
pub fn equation(quantity: &str) -> &str {
    let name = quantity.split('/').next().unwrap_or(quantity);
    name.rsplit_once('.').map_or(name, |(equation, _)| equation)
}

/// Quantities that vary over the element: their values have an entry for each point of the state.
const OF_A_POINT: &[&str] = &[
    "A.1.r",
    "A.1.r_x",
    "A.1.r_y",
    "A.4.r",
    "1.r",
    "2.S",
    "3.S",
    "3.S_x",
    "3.S_y",
    "5.rdot",
    "9.J_0",
    "9.J",
    "10.epsilon_m",
    "11.S_a",
    "11.S_b",
    "11.S_c",
    "12.epsilon_f",
    "13.epsilon_1",
    "13.epsilon_2",
    "13.epsilon_3",
    "14.epsilon",
    "15.sigma",
    "21.S_a1",
    "21.S_b1",
    "21.S_c1",
    "axis.epsilon",
    "cable.S",
    "cable.S_x",
    "cable.S_xx",
    "cable.r",
    "cable.r_x",
    "cable.r_xx",
    "cable.epsilon",
    "cable.kappa",
];

/// Whether a quantity's value has an entry for each point of the state.
pub fn is_of_a_point(quantity: &str) -> bool {
    OF_A_POINT.contains(&quantity)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::Suite;
    use std::collections::BTreeSet;

    #[test]
    fn inputs_come_before_what_uses_them() {
        let mut seen = BTreeSet::new();
        for node in GRAPH {
            for input in node.inputs() {
                assert!(seen.contains(input), "{} uses {input}", node.quantity);
            }
            assert!(seen.insert(node.quantity), "{} stands twice", node.quantity);
        }
    }

    #[test]
    fn every_quantity_of_the_fixtures_is_asked_for_but_printed_forms_and_terms() {
        let suite = Suite::embedded().unwrap();
        let asked: BTreeSet<&str> = GRAPH.iter().map(|node| node.quantity).collect();
        let stored: BTreeSet<&str> = suite.quantities.iter().map(|quantity| quantity.id.as_str()).collect();
        let expected: BTreeSet<&str> = stored
            .iter()
            .copied()
            .filter(|id| !id.contains("/printed") && *id != "23.Phi" && !TERMS_OF_23.contains(id))
            .collect();
        assert_eq!(asked, expected);
    }

    #[test]
    fn the_fixtures_say_the_same_of_points() {
        for quantity in Suite::embedded().unwrap().quantities {
            assert_eq!(is_of_a_point(&quantity.id), quantity.per.as_deref() == Some("point"), "{}", quantity.id);
        }
    }

    #[test]
    fn the_equation_is_what_stands_before_the_last_point() {
        assert_eq!(equation("21.K_3/printed"), "21");
        assert_eq!(equation("A.3.coefficients"), "A.3");
        assert_eq!(equation("tangent.dQ_e"), "tangent");
    }
}
