//! All that was found out about a program.

use std::collections::BTreeMap;

use super::blame::Blame;
use super::diagnosis::{Finding, Name};
use super::protocol::Hello;
use super::subject::Chatter;
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

    /// Culprits that show the very same mistake as one before them: that one, which follows no other itself, and the mistake.
    pub fn alike(&self) -> BTreeMap<&'static str, (&'static str, &Name)> {
        let mut alike = BTreeMap::new();
        let mut heads: Vec<&(&'static str, Finding)> = Vec::new();
        for culprit in &self.findings {
            let (quantity, own) = culprit;
            let shared = |name: &&Name| own.kinds.contains(name) && name.1 != ZEROS;
            let same = heads.iter().find_map(|(first, finding)| Some((*first, finding.kinds.iter().find(shared)?)));
            match same {
                Some(same) => _ = alike.insert(*quantity, same),
                None => heads.push(culprit),
            }
        }
        alike
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
    use crate::diagnosis::Kind;

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
        let expected = [("21.S_b1", ("21.S_a1", &half)), ("21.K_2", ("21.S_c1", &sign))];
        assert_eq!(examination.alike(), BTreeMap::from(expected));
    }
}
