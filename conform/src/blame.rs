//! Blame: which wrong quantities are wrong by themselves, and which inherit the mistake of an input.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

use crate::graph::{GRAPH, Node, find, on_other_routes};
use crate::lost_digits::{LostDigits, Unexplained, WrongInput};

/// Status of a quantity over all its cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Right in every case.
    Right,
    /// Not implemented or not asked.
    Unknown,
    /// Without numbers in any case, even with reference inputs. Whether the equation is wrong is unknown.
    Silent,
    /// Wrong in some case.
    Wrong {
        /// Whether some answers are wrong numbers. Otherwise some cases only lack numbers.
        numbers: bool,
        /// Effect of reference inputs on the failing cases.
        with_given: WithGiven,
    },
}

/// Effect of reference inputs, sent as `given`, on the failing cases of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithGiven {
    /// None were sent: the program does not accept them, or the quantity has none.
    NotTried,
    /// All failing cases become right.
    Right,
    /// All failing cases that were asked again become right. Others hung, crashed or printed another line and were not asked again.
    Partly {
        /// Number of failing cases that become right.
        cured: usize,
        /// Number of failing cases that were not asked again.
        unasked: usize,
    },
    /// Some cases stay wrong, with other numbers: the program used the inputs.
    Wrong,
    /// All answers stay equal: the program did not use the inputs, or they do not matter.
    Same,
}

/// A quantity that is wrong by itself, with the evidence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Culprit {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Whether some answers are wrong numbers. Otherwise some cases only lack numbers.
    #[serde(skip)]
    pub numbers: bool,
    /// Evidence that the quantity itself is wrong.
    pub because: String,
}

/// A wrong quantity with a wrong input.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Follower {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Name of its wrong input.
    pub from: &'static str,
}

/// All wrong quantities: culprits, followers, and those without numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Blame {
    /// Quantities that are wrong although their inputs are right, inputs first.
    pub culprits: Vec<Culprit>,
    /// Wrong quantities with a wrong input.
    pub follow: Vec<Follower>,
    /// Quantities without numbers in any case.
    pub silent: Vec<&'static str>,
}

/// Inputs that a program does not read from `given`, by quantity.
pub type Unread = BTreeMap<&'static str, Vec<&'static str>>;

/// Separates culprits from followers, from the inputs on. A quantity that lost many more digits than its wrong inputs is a culprit.
pub fn blame(statuses: &BTreeMap<&str, Status>, unread: &Unread, lost: &LostDigits) -> Blame {
    let mut blame = Blame::default();
    for node in GRAPH {
        let (numbers, with_given) = match statuses.get(node.quantity) {
            Some(Status::Wrong { numbers, with_given }) => (*numbers, *with_given),
            Some(Status::Silent) => {
                blame.silent.push(node.quantity);
                continue;
            }
            Some(Status::Right | Status::Unknown) | None => continue,
        };
        // An input without numbers does not explain wrong numbers, unless they are right with reference inputs.
        let faults_count = !numbers || with_given == WithGiven::Right;
        let wrong_inner = node.inner.iter().find_map(|input| wrong_at_or_before(input, statuses, faults_count));
        let wrong_given = node.given.iter().find_map(|input| wrong_at_or_before(input, statuses, faults_count));
        let used = matches!(with_given, WithGiven::Right | WithGiven::Wrong);
        let wrong_unread = (unread.get(node.quantity).into_iter().flatten())
            .find_map(|input| wrong_at_or_before(input, statuses, faults_count));
        // Reference inputs that were used are no excuse; inputs that the program computes itself are.
        let excuse = match (wrong_inner, wrong_given, with_given) {
            (Some(input), _, _) => Some(input),
            (None, Some(_), WithGiven::Wrong) => wrong_unread,
            (None, input, _) => input,
        };
        let unexplained = excuse.filter(|_| numbers && with_given != WithGiven::Right).and_then(|_| {
            let without_given = with_given == WithGiven::Wrong;
            lost.unexplained(node.quantity, &wrong_inputs(node, without_given, statuses))
        });
        // Reference inputs that were used show the paper's route.
        let is_of_paper =
            with_given == WithGiven::Right || with_given == WithGiven::Wrong && !unread.contains_key(node.quantity);
        if numbers
            && !is_of_paper
            && (excuse.is_none() || unexplained.is_some())
            && let Some(from) = on_other_route(node, statuses, lost)
        {
            blame.follow.push(Follower { quantity: node.quantity, from });
            continue;
        }
        match (excuse, unexplained) {
            (Some(from), None) => blame.follow.push(Follower { quantity: node.quantity, from }),
            (_, unexplained) => {
                let because = match unexplained {
                    Some(case) => lost_reason(&case),
                    None => reason(node, used, with_given, statuses),
                };
                blame.culprits.push(Culprit { quantity: node.quantity, numbers, because });
            }
        }
    }
    blame
}

/// A wrong input of a route that is not the paper's, if it fails wherever the quantity does, together with the quantity's other inputs.
fn on_other_route(node: &Node, statuses: &BTreeMap<&str, Status>, lost: &LostDigits) -> Option<&'static str> {
    let wrong = |input: &&'static str| wrong_at_or_before(input, statuses, false);
    let by_other: Vec<&'static str> = on_other_routes(node.quantity).iter().filter_map(wrong).collect();
    let by_paper = node.inputs().filter_map(|input| wrong_at_or_before(input, statuses, false));
    let all: Vec<&'static str> = by_other.iter().copied().chain(by_paper).collect();
    by_other.first().copied().filter(|_| lost.fails_only_with(node.quantity, &all))
}

/// The quantity itself if it is wrong. If its status is unknown: the first wrong one among its inputs, and theirs. With `faults_count` a
/// quantity counts as wrong if it lacks numbers in some case.
fn wrong_at_or_before(quantity: &str, statuses: &BTreeMap<&str, Status>, faults_count: bool) -> Option<&'static str> {
    let node = find(quantity)?;
    match statuses.get(quantity) {
        Some(Status::Wrong { numbers: true, .. }) => Some(node.quantity),
        Some(Status::Wrong { numbers: false, .. } | Status::Silent) if faults_count => Some(node.quantity),
        Some(Status::Right) => None,
        _ => node.inputs().find_map(|input| wrong_at_or_before(input, statuses, faults_count)),
    }
}

/// Wrong inputs of a node, and those of inputs with unknown status. With `without_given` its inputs were replaced by the reference's.
fn wrong_inputs(node: &Node, without_given: bool, statuses: &BTreeMap<&str, Status>) -> Vec<WrongInput> {
    let of = |inputs: &[&'static str], inner: bool| -> Vec<WrongInput> {
        let wrong = |input: &&'static str| match statuses.get(input) {
            Some(Status::Right) => Vec::new(),
            Some(Status::Wrong { .. } | Status::Silent) => vec![WrongInput { quantity: input, inner }],
            Some(Status::Unknown) | None => find(input).map_or_else(Vec::new, |input| {
                let before = wrong_inputs(input, false, statuses).into_iter();
                before.map(|before| WrongInput { inner: before.inner || inner, ..before }).collect()
            }),
        };
        inputs.iter().flat_map(wrong).collect()
    };
    let given = if without_given { Vec::new() } else { of(node.given, false) };
    [given, of(node.inner, true)].concat()
}

/// Evidence that a node lost more digits than its inputs explain.
fn lost_reason(Unexplained { case, input, input_lost, lost }: &Unexplained) -> String {
    format!(
        "its inputs' errors do not explain its own: in `{case}` {input} lost {input_lost:.1} digits, it lost {lost:.1}"
    )
}

/// Evidence that the node itself is wrong.
fn reason(node: &Node, used: bool, with_given: WithGiven, statuses: &BTreeMap<&str, Status>) -> String {
    let status = |input: &str| statuses.get(input).copied().unwrap_or(Status::Unknown);
    let list =
        |wanted: fn(Status) -> bool| node.inputs().filter(|input| wanted(status(input))).collect::<Vec<_>>().join(", ");
    let right = list(|status| status == Status::Right);
    let unknown = list(|status| status == Status::Unknown);
    let faulty = list(|status| matches!(status, Status::Silent | Status::Wrong { numbers: false, .. }));
    let given = node.given.join(", ");
    let mut reason = match with_given {
        WithGiven::Right => {
            format!("right with the reference's {given}: it uses other values internally than it answers")
        }
        WithGiven::Wrong => format!("wrong even with the reference's {given}"),
        WithGiven::Partly { cured: 1.., .. } => format!(
            "right with the reference's {given} where it could be asked again: it uses other values internally than it answers"
        ),
        _ if node.inputs().next().is_none() => "it depends on the state alone".into(),
        _ if right.is_empty() => "none of its inputs is known to be wrong".into(),
        _ => format!("its inputs are right: {right}"),
    };
    if !used && !unknown.is_empty() {
        reason += &format!("; not implemented, so the mistake may be there: {unknown}");
    }
    if !used && !faulty.is_empty() {
        reason += &format!("; without numbers in some or all cases, so the mistake may be there: {faulty}");
    }
    if let WithGiven::Partly { unasked, .. } = with_given {
        reason += &format!("; {unasked} failing case(s) could not be asked again with the reference's {given}");
    }
    reason
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::Suite;
    use crate::verdict::{Verdict, Wrong};

    const WRONG: Status = wrong(WithGiven::NotTried);

    const fn wrong(with_given: WithGiven) -> Status {
        Status::Wrong { numbers: true, with_given }
    }

    fn statuses(wrong: &[(&'static str, Status)]) -> BTreeMap<&'static str, Status> {
        let right = GRAPH.iter().map(|node| (node.quantity, Status::Right));
        right.chain(wrong.iter().copied()).collect()
    }

    fn blame_of(statuses: &BTreeMap<&str, Status>) -> Blame {
        blame(statuses, &Unread::new(), &LostDigits::default())
    }

    fn follow(blame: &Blame) -> Vec<(&str, &str)> {
        blame.follow.iter().map(|follower| (follower.quantity, follower.from)).collect()
    }

    fn culprits(blame: &Blame) -> Vec<&str> {
        blame.culprits.iter().map(|culprit| culprit.quantity).collect()
    }

    #[test]
    fn a_program_without_mistakes_has_nothing_to_blame() {
        assert_eq!(blame_of(&statuses(&[])), Blame::default());
    }

    #[test]
    fn the_first_wrong_quantity_is_the_culprit_and_the_others_follow() {
        let blame =
            blame_of(&statuses(&[("11.S_a", WRONG), ("13.epsilon_1", WRONG), ("21.K_1", WRONG), ("20.K", WRONG)]));
        assert_eq!(culprits(&blame), ["11.S_a"]);
        assert_eq!(follow(&blame), [("13.epsilon_1", "11.S_a"), ("21.K_1", "11.S_a"), ("20.K", "21.K_1")]);
        assert!(blame.culprits[0].because.contains("3.S_x"), "{blame:?}");
    }

    #[test]
    fn given_values_reveal_a_second_mistake() {
        let still = wrong(WithGiven::Wrong);
        let cured = wrong(WithGiven::Right);
        let blame = blame_of(&statuses(&[("9.J", WRONG), ("10.epsilon_m", still), ("17.mu", WRONG), ("16.D", cured)]));
        assert_eq!(culprits(&blame), ["9.J", "10.epsilon_m", "17.mu"]);
        assert_eq!(follow(&blame), [("16.D", "17.mu")]);
    }

    #[test]
    fn given_values_that_are_not_used_remain_an_excuse() {
        let same = wrong(WithGiven::Same);
        let blame = blame_of(&statuses(&[("7.M", WRONG), ("6.T", same)]));
        assert_eq!(culprits(&blame), ["7.M"]);
    }

    #[test]
    fn a_quadrature_is_not_blamed_for_what_it_integrates() {
        let still = wrong(WithGiven::Wrong);
        let blame = blame_of(&statuses(&[("11.S_c", WRONG), ("21.K_3", still)]));
        assert_eq!(culprits(&blame), ["11.S_c"]);
    }

    #[test]
    fn inputs_that_are_not_implemented_are_looked_through() {
        let unknown =
            ["20.K", "21.K_1", "21.K_2", "21.K_3", "21.S_c1", "21.S_a1", "21.S_b1"].map(|q| (q, Status::Unknown));
        let with = |wrong: &[(&'static str, Status)]| blame_of(&statuses(&[&unknown[..], wrong].concat()));
        assert_eq!(culprits(&with(&[("11.S_c", WRONG), ("19.Q_e", WRONG)])), ["11.S_c"]);
        let alone = with(&[("19.Q_e", WRONG)]);
        assert_eq!(culprits(&alone), ["19.Q_e"]);
        assert!(alone.culprits[0].because.ends_with("may be there: 20.K"), "{alone:?}");
    }

    #[test]
    fn a_quantity_that_is_right_only_with_given_values_is_a_culprit() {
        let cured = wrong(WithGiven::Right);
        let blame = blame_of(&statuses(&[("19.Q_e", cured)]));
        assert_eq!(culprits(&blame), ["19.Q_e"]);
        assert!(blame.culprits[0].because.contains("it uses other values internally"), "{blame:?}");
    }

    #[test]
    fn a_wrong_stress_excuses_the_force_that_fails_in_the_same_states() {
        let suite = Suite::embedded().unwrap();
        let verdict = |digits: f64| match digits > 13.0 {
            true => Verdict::Pass { digits },
            false => Verdict::Wrong(Wrong { digits, entry: 0, answered: 0.0, expected: 1.0, answer: vec![0.0] }),
        };
        let verdicts = |digits: [f64; 2]| digits.into_iter().map(verdict).enumerate().collect::<Vec<_>>();
        let statuses = statuses(&[("15.sigma", WRONG), ("19.Q_e", WRONG)]);
        let blamed = |force: [f64; 2]| {
            let both = [("15.sigma", verdicts([1.0, 16.0])), ("19.Q_e", verdicts(force))];
            blame(&statuses, &Unread::new(), &LostDigits::of(&suite, &both))
        };
        assert_eq!(follow(&blamed([1.0, 16.0])), [("19.Q_e", "15.sigma")]);
        // The force fails where the stress is right.
        assert_eq!(culprits(&blamed([1.0, 1.0])), ["15.sigma", "19.Q_e"]);
    }

    #[test]
    fn a_quantity_without_numbers_is_no_culprit_and_no_excuse() {
        let silent = blame_of(&statuses(&[("11.S_a", Status::Silent), ("13.epsilon_1", WRONG)]));
        assert_eq!((silent.silent.as_slice(), culprits(&silent)), (&["11.S_a"][..], vec!["13.epsilon_1"]));
        assert!(silent.culprits[0].because.ends_with("may be there: 11.S_a"), "{silent:?}");
        let faulty = Status::Wrong { numbers: false, with_given: WithGiven::NotTried };
        assert_eq!(
            culprits(&blame_of(&statuses(&[("11.S_a", faulty), ("13.epsilon_1", WRONG)]))),
            ["11.S_a", "13.epsilon_1"]
        );
        // Faults explain faults, and quantities that are right with given values.
        for follower in [faulty, wrong(WithGiven::Right)] {
            let found = blame_of(&statuses(&[("11.S_a", Status::Silent), ("13.epsilon_1", follower)]));
            assert_eq!((culprits(&found), follow(&found)), (vec![], vec![("13.epsilon_1", "11.S_a")]));
        }
    }

    #[test]
    fn cases_that_could_not_be_asked_again_are_counted() {
        let because = |cured| {
            let found = blame_of(&statuses(&[("19.Q_e", wrong(WithGiven::Partly { cured, unasked: 3 }))]));
            found.culprits[0].because.clone()
        };
        assert_eq!(
            because(0),
            "its inputs are right: 20.K; 3 failing case(s) could not be asked again with the reference's 20.K"
        );
        assert!(because(2).starts_with("right with the reference's 20.K where it could be asked again"));
    }
}
