//! What the paper says of its pendulum (Section 3 and conclusions 1 and 2), measured against a plane solid, window by window.
//!
//! The paper compares with ANSYS, whose numbers it does not print; the solid stands in for it, with an uncertainty of its own.
//! Where that and our own errors in space and time could turn a comparison round, it is undecided.

use std::fmt;

use serde::{Serialize, Serializer};

use super::continuum::{Continuum, Solid, Window};
use super::pendulum::{Model, largest_distance};
use crate::error::Result;

/// What is found in one window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    Holds,
    DoesNot,
    Undecided,
}

/// A number, how uncertain it is, and what follows from it, in one window.
#[derive(Serialize)]
pub struct Finding {
    pub window: Window,
    pub value: f64,
    pub uncertainty: f64,
    pub outcome: Outcome,
}

/// A statement measured with both starts.
#[derive(Serialize)]
pub struct Row {
    pub statement: &'static str,
    pub measure: &'static str,
    pub sudden: Vec<Finding>,
    pub relaxed: Vec<Finding>,
    pub verdict: String,
}

impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Outcome::Holds => "holds",
            Outcome::DoesNot => "does not hold",
            Outcome::Undecided => "undecided",
        })
    }
}

/// A comparison of models with the solid under 2D heat.
struct Claim {
    statement: &'static str,
    measure: &'static str,
    /// Value and uncertainty in a window.
    value: fn(&Start, Window) -> (f64, f64),
    /// The value has to be above it or below it.
    limit: Limit,
}

enum Limit {
    Above(f64),
    Below(f64),
}

impl Limit {
    fn judge(&self, (value, uncertainty): (f64, f64)) -> Outcome {
        let above = match self {
            Limit::Above(limit) => value - limit,
            Limit::Below(limit) => limit - value,
        };
        // A value that is not a number decides nothing.
        if above > uncertainty {
            Outcome::Holds
        } else if above < -uncertainty {
            Outcome::DoesNot
        } else {
            Outcome::Undecided
        }
    }
}

/// The models of one kind of start, and their solids.
struct Start<'a> {
    /// Heated along the axis: the paper's element, and the competitor's.
    axis: &'a Model,
    euler_bernoulli: &'a Model,
    /// Heated in the plane: the proposed model.
    plane: &'a Model,
    solid: Solid,
    cold_solid: Solid,
}

impl Start<'_> {
    /// Largest distance of a model from the heated solid, and its uncertainty, m.
    fn gap(&self, model: &Model, window: Window) -> (f64, f64) {
        let distance = largest_distance(&self.solid.tip, &model.tip, window);
        (distance, self.solid.uncertainty(window) + model.space_error(window) + model.time_error(window))
    }

    /// The gap as a part of what heat does to the solid, which is known to two per cent or better.
    fn share(&self, model: &Model, window: Window) -> (f64, f64) {
        let (gap, uncertainty) = self.gap(model, window);
        let effect = largest_distance(&self.solid.tip, &self.cold_solid.tip, window);
        (gap / effect, uncertainty / effect)
    }

    /// How much farther off the first model is than the second, m.
    fn farther(&self, first: &Model, second: &Model, window: Window) -> (f64, f64) {
        let ((a, u_a), (b, u_b)) = (self.gap(first, window), self.gap(second, window));
        (a - b, u_a + u_b)
    }
}

/// Statements about the curves. "Good agreement" is what cannot be told apart in a plot of the whole motion.
const CLAIMS: [Claim; 7] = [
    Claim {
        statement: "The proposed model is in good agreement with ANSYS within a large overall motion.",
        measure: "largest distance of 2D from the solid, m: below 0.02",
        value: |start, window| start.gap(start.plane, window),
        limit: Limit::Below(0.02),
    },
    Claim {
        statement: "So is the 1D model.",
        measure: "largest distance of 1D, Euler–Bernoulli, from the solid, m: below 0.02",
        value: |start, window| start.gap(start.euler_bernoulli, window),
        limit: Limit::Below(0.02),
    },
    Claim {
        statement: "The difference that heat makes is approximately that of ANSYS in the proposed model.",
        measure: "largest distance of 2D from the solid over what heat moves the solid by: below 0.1",
        value: |start, window| start.share(start.plane, window),
        limit: Limit::Below(0.1),
    },
    Claim {
        statement: "The 1D model has a huge gap with ANSYS.",
        measure: "largest distance of 1D, Euler–Bernoulli, from the solid over what heat moves the solid by: above 0.5",
        value: |start, window| start.share(start.euler_bernoulli, window),
        limit: Limit::Above(0.5),
    },
    Claim {
        statement: "… also if the paper's own element is heated along its axis only.",
        measure: "largest distance of 1D, the paper's element, from the solid over what heat moves the solid by: above 0.5",
        value: |start, window| start.share(start.axis, window),
        limit: Limit::Above(0.5),
    },
    Claim {
        statement: "The proposed model is more precise than the 1D model.",
        measure: "largest distance from the solid of 1D, Euler–Bernoulli, less that of 2D, m: above 0",
        value: |start, window| start.farther(start.euler_bernoulli, start.plane, window),
        limit: Limit::Above(0.0),
    },
    Claim {
        statement: "… also if the paper's own element is heated along its axis only.",
        measure: "largest distance from the solid of 1D, the paper's element, less that of 2D, m: above 0",
        value: |start, window| start.farther(start.axis, start.plane, window),
        limit: Limit::Above(0.0),
    },
];

/// All statements about the curves, measured.
pub fn measure(models: &[Model], continuum: &Continuum) -> Result<Vec<Row>> {
    let start = |name: &str| -> Result<Option<Start>> {
        let model = |id: String| models.iter().find(|model| model.kind.id == id);
        let found = (model(format!("1d-{name}")), model(format!("1d-eb-{name}")), model(format!("2d-{name}")));
        let (Some(axis), Some(euler_bernoulli), Some(plane)) = found else { return Ok(None) };
        let (solid, cold_solid) = (continuum.solid(&format!("2d-{name}"))?, continuum.solid("flexible")?);
        Ok(Some(Start { axis, euler_bernoulli, plane, solid, cold_solid }))
    };
    let (Some(sudden), Some(relaxed)) = (start("sudden")?, start("relaxed")?) else { return Ok(Vec::new()) };
    let row = |claim: &Claim| {
        let find = |start: &Start| -> Vec<Finding> {
            let finding = |window| {
                let (value, uncertainty) = (claim.value)(start, window);
                Finding { window, value, uncertainty, outcome: claim.limit.judge((value, uncertainty)) }
            };
            continuum.windows().map(finding).collect()
        };
        let (sudden, relaxed) = (find(&sudden), find(&relaxed));
        let verdict = verdict(&sudden, &relaxed);
        Row { statement: claim.statement, measure: claim.measure, sudden, relaxed, verdict }
    };
    Ok(CLAIMS.iter().map(row).collect())
}

/// One word where all windows of both starts say it, or what holds where.
fn verdict(sudden: &[Finding], relaxed: &[Finding]) -> String {
    let all = || sudden.iter().chain(relaxed);
    for outcome in [Outcome::Holds, Outcome::DoesNot, Outcome::Undecided] {
        if all().all(|finding| finding.outcome == outcome) {
            return outcome.to_string();
        }
    }
    let where_it = |findings: &[Finding], wanted: Outcome| {
        let its = findings.iter().filter(|finding| finding.outcome == wanted);
        spans(its.map(|finding| finding.window))
    };
    let of_start = |name: &str, findings: &[Finding]| {
        let parts = [Outcome::Holds, Outcome::DoesNot, Outcome::Undecided].map(|outcome| {
            let spans = where_it(findings, outcome);
            (!spans.is_empty()).then(|| format!("{outcome} in {spans}"))
        });
        format!("{name}: {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    };
    format!("{}; {}", of_start("sudden", sudden), of_start("relaxed", relaxed))
}

/// Windows as words, neighbours joined.
fn spans(windows: impl Iterator<Item = Window>) -> String {
    let mut joined: Vec<Window> = Vec::new();
    for window in windows {
        match joined.last_mut() {
            Some(last) if last.to == window.from => last.to = window.to,
            _ => joined.push(window),
        }
    }
    joined.iter().map(Window::to_string).collect::<Vec<_>>().join(" and ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(outcomes: [Outcome; 3]) -> Vec<Finding> {
        let window = |number: usize| Window { from: number as f64, to: number as f64 + 1.0, number };
        let finding = |(n, outcome)| Finding { window: window(n), value: 0.0, uncertainty: 0.0, outcome };
        outcomes.into_iter().enumerate().map(finding).collect()
    }

    #[test]
    fn a_value_decides_only_beyond_its_uncertainty() {
        let below = Limit::Below(0.1);
        assert_eq!(below.judge((0.05, 0.02)), Outcome::Holds);
        assert_eq!(below.judge((0.05, 0.06)), Outcome::Undecided);
        assert_eq!(below.judge((0.2, 0.05)), Outcome::DoesNot);
        assert_eq!(below.judge((f64::NAN, 0.05)), Outcome::Undecided);
        assert_eq!(below.judge((0.05, f64::NAN)), Outcome::Undecided);
        assert_eq!(Limit::Above(0.5).judge((0.6, 0.05)), Outcome::Holds);
        assert_eq!(Limit::Above(0.5).judge((0.6, 0.2)), Outcome::Undecided);
    }

    #[test]
    fn a_verdict_names_the_windows() {
        use Outcome::{DoesNot, Holds, Undecided};
        assert_eq!(verdict(&findings([Holds; 3]), &findings([Holds; 3])), "holds");
        assert_eq!(verdict(&findings([Undecided; 3]), &findings([Undecided; 3])), "undecided");
        let mixed = verdict(&findings([Holds, Holds, Undecided]), &findings([DoesNot, Holds, DoesNot]));
        let expected = "sudden: holds in 0 … 2 s, undecided in 2 … 3 s; \
                        relaxed: holds in 1 … 2 s, does not hold in 0 … 1 s and 2 … 3 s";
        assert_eq!(mixed, expected);
    }
}
