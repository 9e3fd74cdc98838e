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
    /// No numbers in any case, with the reference's inputs neither: nothing is known of its equation.
    Silent,
    /// Wrong in some case.
    Wrong {
        /// Whether there are wrong numbers, and not only cases without numbers.
        numbers: bool,
        /// What became of the failing cases when the reference's inputs were handed over.
        with_given: WithGiven,
    },
}

/// What the reference's intermediate values change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithGiven {
    /// The program does not take them, or there are none.
    NotTried,
    /// Every failing case was asked again, and is right then.
    Right,
    /// What was asked again is right then; other failing cases, which hung, crashed or had another line for an answer, were not.
    Partly {
        /// Failing cases that are right then.
        cured: usize,
        /// Failing cases that are not known.
        unasked: usize,
    },
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
    /// Whether it answers wrong numbers; otherwise it is right wherever there are any.
    pub numbers: bool,
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
    /// Without numbers in any case.
    pub silent: Vec<&'static str>,
}

impl Blame {
    /// The place of the first culprit with wrong numbers; if there is none, of the first one.
    pub fn first_wrong(&self) -> Option<usize> {
        let wrong = self.culprits.iter().position(|culprit| culprit.numbers);
        wrong.or((!self.culprits.is_empty()).then_some(0))
    }
}

/// Walks the graph from the inputs on.
pub fn blame(standings: &BTreeMap<&str, Standing>) -> Blame {
    let mut blame = Blame::default();
    for node in GRAPH {
        let (numbers, with_given) = match standings.get(node.quantity) {
            Some(Standing::Wrong { numbers, with_given }) => (*numbers, *with_given),
            Some(Standing::Silent) => {
                blame.silent.push(node.quantity);
                continue;
            }
            Some(Standing::Right | Standing::Unknown) | None => continue,
        };
        // That an input has no numbers does not explain wrong ones, but for who is right with the reference's.
        let faults_count = !numbers || with_given == WithGiven::Right;
        let wrong_inner = node.inner.iter().find_map(|input| wrong_at_or_before(input, standings, faults_count));
        let wrong_given = node.given.iter().find_map(|input| wrong_at_or_before(input, standings, faults_count));
        let used = matches!(with_given, WithGiven::Right | WithGiven::Wrong);
        // What was handed over and used excuses nothing any more.
        let excuse = match (wrong_inner, wrong_given, with_given) {
            (Some(input), _, _) => Some(input),
            (None, Some(_), WithGiven::Wrong) => None,
            (None, input, _) => input,
        };
        match excuse {
            Some(input) => blame.follow.push((node.quantity, input)),
            None => {
                let because = reason(node, used, with_given, standings);
                blame.culprits.push(Culprit { quantity: node.quantity, numbers, because });
            }
        }
    }
    blame
}

/// The quantity itself if it is wrong; if nobody knows, the first wrong one among what it is computed from. Whether one counts as wrong
/// that has no wrong numbers but cases without numbers is up to `faults_count`.
fn wrong_at_or_before(
    quantity: &str,
    standings: &BTreeMap<&str, Standing>,
    faults_count: bool,
) -> Option<&'static str> {
    let node = find(quantity)?;
    match standings.get(quantity) {
        Some(Standing::Wrong { numbers: true, .. }) => Some(node.quantity),
        Some(Standing::Wrong { numbers: false, .. } | Standing::Silent) if faults_count => Some(node.quantity),
        Some(Standing::Right) => None,
        _ => node.inputs().find_map(|input| wrong_at_or_before(input, standings, faults_count)),
    }
}

/// How it is known that the node itself is wrong.
fn reason(node: &Node, used: bool, with_given: WithGiven, standings: &BTreeMap<&str, Standing>) -> String {
    let stand = |input: &&str| standings.get(input).copied().unwrap_or(Standing::Unknown);
    let known: Vec<&str> = node.inputs().filter(|input| stand(input) == Standing::Right).collect();
    let unknown: Vec<&str> = node.inputs().filter(|input| stand(input) == Standing::Unknown).collect();
    let without_numbers =
        |input: &&str| matches!(stand(input), Standing::Silent | Standing::Wrong { numbers: false, .. });
    let faulty: Vec<&str> = node.inputs().filter(without_numbers).collect();
    let handed_over = node.given.join(", ");
    let mut reason = match with_given {
        WithGiven::Right => format!("right with the reference's {handed_over}: inside it uses others than it answers"),
        WithGiven::Wrong => format!("wrong with the reference's {handed_over} too"),
        WithGiven::Partly { cured: 1.., .. } => {
            format!(
                "right with the reference's {handed_over}, as far as it could be asked again: inside it uses others than it answers"
            )
        }
        _ if node.inputs().next().is_none() => "it depends on the state alone".into(),
        _ if known.is_empty() => "nothing that it is computed from is known to be wrong".into(),
        _ => format!("what it is computed from is right: {}", known.join(", ")),
    };
    if !used && !unknown.is_empty() {
        reason += &format!("; not implemented, so that the mistake may be there: {}", unknown.join(", "));
    }
    if !used && !faulty.is_empty() {
        reason += &format!("; no numbers, or not everywhere, so that the mistake may be there: {}", faulty.join(", "));
    }
    if let WithGiven::Partly { unasked, .. } = with_given {
        reason +=
            &format!("; in {unasked} failing case(s) it could not be asked again with the reference's {handed_over}");
    }
    reason
}

#[cfg(test)]
mod tests {
    use super::*;

    const WRONG: Standing = wrong(WithGiven::NotTried);

    const fn wrong(with_given: WithGiven) -> Standing {
        Standing::Wrong { numbers: true, with_given }
    }

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
        let still = wrong(WithGiven::Wrong);
        let cured = wrong(WithGiven::Right);
        let blame = blame(&standings(&[("9.J", WRONG), ("10.epsilon_m", still), ("17.mu", WRONG), ("16.D", cured)]));
        assert_eq!(culprits(&blame), ["9.J", "10.epsilon_m", "17.mu"]);
        assert_eq!(blame.follow, [("16.D", "17.mu")]);
    }

    #[test]
    fn values_that_are_not_used_excuse_as_before() {
        let same = wrong(WithGiven::Same);
        let blame = blame(&standings(&[("7.M", WRONG), ("6.T", same)]));
        assert_eq!(culprits(&blame), ["7.M"]);
    }

    #[test]
    fn a_quadrature_is_not_blamed_for_what_it_integrates() {
        let still = wrong(WithGiven::Wrong);
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
        let cured = wrong(WithGiven::Right);
        let blame = blame(&standings(&[("19.Q_e", cured)]));
        assert_eq!(culprits(&blame), ["19.Q_e"]);
        assert!(blame.culprits[0].because.contains("inside it uses others"), "{blame:?}");
    }

    #[test]
    fn who_answers_no_numbers_has_no_wrong_equation_and_excuses_none() {
        let silent = blame(&standings(&[("11.S_a", Standing::Silent), ("13.epsilon_1", WRONG)]));
        assert_eq!((silent.silent.as_slice(), culprits(&silent)), (&["11.S_a"][..], vec!["13.epsilon_1"]));
        assert!(silent.culprits[0].because.ends_with("may be there: 11.S_a"), "{silent:?}");
        let faulty = Standing::Wrong { numbers: false, with_given: WithGiven::NotTried };
        assert_eq!(
            culprits(&blame(&standings(&[("11.S_a", faulty), ("13.epsilon_1", WRONG)]))),
            ["11.S_a", "13.epsilon_1"]
        );
        // Faults explain faults, and what is right with the reference's values.
        for follower in [faulty, wrong(WithGiven::Right)] {
            let found = blame(&standings(&[("11.S_a", Standing::Silent), ("13.epsilon_1", follower)]));
            assert_eq!((culprits(&found), &found.follow), (vec![], &vec![("13.epsilon_1", "11.S_a")]));
        }
    }

    #[test]
    fn what_could_not_be_asked_again_is_not_called_right() {
        let because = |cured| {
            let found = blame(&standings(&[("19.Q_e", wrong(WithGiven::Partly { cured, unasked: 3 }))]));
            found.culprits[0].because.clone()
        };
        assert_eq!(
            because(0),
            "what it is computed from is right: 20.K; in 3 failing case(s) it could not be asked again with the reference's 20.K"
        );
        assert!(because(2).starts_with("right with the reference's 20.K, as far as it could be asked again"));
    }
}
