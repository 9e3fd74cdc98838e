//! Which equation is wrong, and which only pass a mistake on.

use std::collections::BTreeMap;

use super::graph::{GRAPH, Node, find};

/// How a program did with one quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Right in every case.
    Right,
    /// Not implemented, or not asked.
    Unknown,
    /// Wrong in some case.
    Wrong {
        /// What became of the failing cases when the reference's inputs were handed over.
        with_given: WithGiven,
    },
}

/// What the reference's intermediate values change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithGiven {
    /// The program does not take them, or there are none.
    NotTried,
    /// Every failing case is right then.
    Right,
    /// Wrong all the same, but not in the same way: they were used.
    Wrong,
    /// The very same wrong numbers: they were not used, or do not matter.
    Same,
}

/// A quantity that is wrong by itself, and how that is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Culprit {
    /// Its name.
    pub quantity: &'static str,
    /// How it is known.
    pub because: String,
}

/// The wrong quantities, told apart.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Blame {
    /// Wrong although their inputs are right; the first of them comes first.
    pub culprits: Vec<Culprit>,
    /// Wrong, but an input is too: the quantity and that input.
    pub follow: Vec<(&'static str, &'static str)>,
}

/// Walks the graph from the inputs on.
pub fn blame(standings: &BTreeMap<&str, Standing>) -> Blame {
    let mut blame = Blame::default();
    for node in GRAPH {
        let Some(Standing::Wrong { with_given }) = standings.get(node.quantity).copied() else { continue };
        let wrong_inner = node.inner.iter().find_map(|input| wrong_at_or_before(input, standings));
        let wrong_given = node.given.iter().find_map(|input| wrong_at_or_before(input, standings));
        let used = matches!(with_given, WithGiven::Right | WithGiven::Wrong);
        // What was handed over and used excuses nothing any more.
        let excuse = match (wrong_inner, wrong_given, with_given) {
            (Some(input), _, _) => Some(input),
            (None, Some(_), WithGiven::Wrong) => None,
            (None, input, _) => input,
        };
        match excuse {
            Some(input) => blame.follow.push((node.quantity, input)),
            None => blame
                .culprits
                .push(Culprit { quantity: node.quantity, because: reason(node, used, with_given, standings) }),
        }
    }
    blame
}

/// The quantity itself if it is wrong; if nobody knows, the first wrong one among what it is computed from.
fn wrong_at_or_before(quantity: &str, standings: &BTreeMap<&str, Standing>) -> Option<&'static str> {
    let node = find(quantity)?;
    match standings.get(quantity) {
        Some(Standing::Wrong { .. }) => Some(node.quantity),
        Some(Standing::Right) => None,
        Some(Standing::Unknown) | None => node.inputs().find_map(|input| wrong_at_or_before(input, standings)),
    }
}

/// How it is known that the node itself is wrong.
fn reason(node: &Node, used: bool, with_given: WithGiven, standings: &BTreeMap<&str, Standing>) -> String {
    let stand = |input: &&str| standings.get(input).copied().unwrap_or(Standing::Unknown);
    let known: Vec<&str> = node.inputs().filter(|input| stand(input) == Standing::Right).collect();
    let unknown: Vec<&str> = node.inputs().filter(|input| stand(input) == Standing::Unknown).collect();
    let handed_over = node.given.join(", ");
    let mut reason = match with_given {
        WithGiven::Right => format!("right with the reference's {handed_over}: inside it uses others than it answers"),
        WithGiven::Wrong => format!("wrong with the reference's {handed_over} too"),
        _ if node.inputs().next().is_none() => "it depends on the state alone".into(),
        _ if known.is_empty() => "nothing that it is computed from is wrong".into(),
        _ => format!("what it is computed from is right: {}", known.join(", ")),
    };
    if !used && !unknown.is_empty() {
        reason += &format!("; not implemented, so that the mistake may be there: {}", unknown.join(", "));
    }
    reason
}

#[cfg(test)]
mod tests {
    use super::*;

    const WRONG: Standing = Standing::Wrong { with_given: WithGiven::NotTried };

    fn standings(wrong: &[(&'static str, Standing)]) -> BTreeMap<&'static str, Standing> {
        let right = GRAPH.iter().map(|node| (node.quantity, Standing::Right));
        right.chain(wrong.iter().copied()).collect()
    }

    fn culprits(blame: &Blame) -> Vec<&str> {
        blame.culprits.iter().map(|culprit| culprit.quantity).collect()
    }

    #[test]
    fn a_program_without_mistakes_has_nothing_to_blame() {
        assert_eq!(blame(&standings(&[])), Blame::default());
    }

    #[test]
    fn the_first_wrong_one_is_to_blame_and_the_others_follow() {
        let blame =
            blame(&standings(&[("11.S_a", WRONG), ("13.epsilon_1", WRONG), ("21.K_1", WRONG), ("20.K", WRONG)]));
        assert_eq!(culprits(&blame), ["11.S_a"]);
        assert_eq!(blame.follow, [("13.epsilon_1", "11.S_a"), ("21.K_1", "11.S_a"), ("20.K", "21.K_1")]);
        assert!(blame.culprits[0].because.contains("3.S_x"), "{blame:?}");
    }

    #[test]
    fn what_is_handed_over_shows_a_second_mistake() {
        let still = Standing::Wrong { with_given: WithGiven::Wrong };
        let cured = Standing::Wrong { with_given: WithGiven::Right };
        let blame = blame(&standings(&[("9.J", WRONG), ("10.epsilon_m", still), ("17.mu", WRONG), ("16.D", cured)]));
        assert_eq!(culprits(&blame), ["9.J", "10.epsilon_m", "17.mu"]);
        assert_eq!(blame.follow, [("16.D", "17.mu")]);
    }

    #[test]
    fn values_that_are_not_used_excuse_as_before() {
        let same = Standing::Wrong { with_given: WithGiven::Same };
        let blame = blame(&standings(&[("7.M", WRONG), ("6.T", same)]));
        assert_eq!(culprits(&blame), ["7.M"]);
    }

    #[test]
    fn a_quadrature_is_not_blamed_for_what_it_integrates() {
        let still = Standing::Wrong { with_given: WithGiven::Wrong };
        let blame = blame(&standings(&[("11.S_c", WRONG), ("21.K_3", still)]));
        assert_eq!(culprits(&blame), ["11.S_c"]);
    }

    #[test]
    fn one_looks_through_what_is_not_implemented() {
        let unknown =
            ["20.K", "21.K_1", "21.K_2", "21.K_3", "21.S_c1", "21.S_a1", "21.S_b1"].map(|q| (q, Standing::Unknown));
        let with = |wrong: &[(&'static str, Standing)]| blame(&standings(&[&unknown[..], wrong].concat()));
        assert_eq!(culprits(&with(&[("11.S_c", WRONG), ("19.Q_e", WRONG)])), ["11.S_c"]);
        let alone = with(&[("19.Q_e", WRONG)]);
        assert_eq!(culprits(&alone), ["19.Q_e"]);
        assert!(alone.culprits[0].because.ends_with("may be there: 20.K"), "{alone:?}");
    }

    #[test]
    fn right_only_with_the_references_inputs_although_its_own_are_right() {
        let cured = Standing::Wrong { with_given: WithGiven::Right };
        let blame = blame(&standings(&[("19.Q_e", cured)]));
        assert_eq!(culprits(&blame), ["19.Q_e"]);
        assert!(blame.culprits[0].because.contains("inside it uses others"), "{blame:?}");
    }
}
