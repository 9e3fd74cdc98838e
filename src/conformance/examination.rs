//! All that was found out about a program.

use super::blame::Blame;
use super::mistakes::{Finding, Name};
use super::program::Chatter;
use super::protocol::Hello;
use super::verdict::{Fault, Verdict};

/// What is done wrong where zeros are answered everywhere: that says nothing of a cause.
const ZEROS: &str = "all of it missing";

/// All that was found out about a program.
#[derive(Debug)]
pub struct Examination {
    /// How it was started.
    pub command: String,
    /// What it says of itself; what came in place of that, after which it was not asked.
    pub hello: std::result::Result<Hello, Fault>,
    /// What it printed beside its answers.
    pub chatter: Chatter,
    /// Verdicts by quantity and case, in the order of asking.
    pub verdicts: Vec<(&'static str, Vec<(usize, Verdict)>)>,
    /// What became of the states that have to be refused, by their place in the suite.
    pub refusals: Vec<(usize, Refusal)>,
    /// Which equation is wrong.
    pub blame: Blame,
    /// What kind of mistake fits, for each of the culprits.
    pub findings: Vec<(&'static str, Finding)>,
    /// How often the program was started.
    pub starts: usize,
    /// Questions.
    pub questions: usize,
    /// How long all of it took, s.
    pub seconds: f64,
}

/// What became of a state that has to be refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// An error, as it has to be.
    Refused(String),
    /// A value, as if nothing was wrong.
    Accepted,
    /// The quantity is not implemented.
    NotImplemented,
    /// Something else.
    Fault(Fault),
}

impl Examination {
    /// Whether nothing failed.
    pub fn passes(&self) -> bool {
        let failing = |(_, cases): &(&str, Vec<(usize, Verdict)>)| cases.iter().any(|(_, verdict)| verdict.fails());
        let kept = |(_, refusal): &(usize, Refusal)| !matches!(refusal, Refusal::Refused(_) | Refusal::NotImplemented);
        !self.verdicts.iter().any(failing) && !self.refusals.iter().any(kept) && self.implemented() > 0
    }

    /// The program's name, or how it was started.
    pub fn name(&self) -> &str {
        self.hello.as_ref().map_or(&self.command, |hello| &hello.name)
    }

    /// The first culprit before a quantity that shows the very same mistake, and that mistake; none that follows another itself.
    pub fn same_as(&self, quantity: &str) -> Option<(&'static str, &Name)> {
        let place = self.findings.iter().position(|(other, _)| *other == quantity)?;
        let (earlier, rest) = self.findings.split_at(place);
        let (_, own) = rest.first()?;
        let shared = |name: &&Name| own.kinds.contains(name) && name.1 != ZEROS;
        let heads = earlier.iter().filter(|(first, _)| self.same_as(first).is_none());
        heads.into_iter().find_map(|(first, finding)| Some((*first, finding.kinds.iter().find(shared)?)))
    }

    /// How many quantities the program has.
    pub fn implemented(&self) -> usize {
        let has = |(_, cases): &&(&str, Vec<(usize, Verdict)>)| {
            cases.iter().any(|(_, verdict)| *verdict != Verdict::NotImplemented)
        };
        self.verdicts.iter().filter(has).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformance::mistakes::Kind;

    #[test]
    fn the_same_mistake_is_told_with_the_first_that_shows_it() {
        let name = |kind, what: &str| (kind, what.to_string());
        let (half, sign) = (name(Kind::Factor, "all of it half"), name(Kind::Sign, "all of it with the other sign"));
        let zero = name(Kind::Missing, "all of it missing");
        let finding =
            |kinds: &[&Name]| Finding { kinds: kinds.iter().copied().cloned().collect(), ..Finding::default() };
        let examination = Examination {
            command: String::new(),
            hello: Ok(Hello::default()),
            chatter: Chatter::default(),
            verdicts: Vec::new(),
            refusals: Vec::new(),
            blame: Blame::default(),
            findings: vec![
                ("21.S_a1", finding(&[&half, &zero])),
                ("21.S_b1", finding(&[&half, &sign])),
                ("21.S_c1", finding(&[&sign])),
                ("21.K_1", finding(&[&zero])),
                ("21.K_2", finding(&[&sign])),
            ],
            starts: 1,
            questions: 0,
            seconds: 0.0,
        };
        assert_eq!(examination.same_as("21.S_b1"), Some(("21.S_a1", &half)));
        for alone in ["21.S_a1", "21.S_c1", "21.K_1", "7.M"] {
            assert_eq!(examination.same_as(alone), None, "{alone}");
        }
        assert_eq!(examination.same_as("21.K_2"), Some(("21.S_c1", &sign)));
    }
}
