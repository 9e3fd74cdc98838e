//! The paper's statements on its pendulum (Section 3 and conclusions 1 and 2), measured against a plane solid, window by window.
//!
//! The paper compares with ANSYS, but does not print its numbers; the solid takes its place, with an uncertainty of its own. A comparison
//! is undecided if that and our own errors in space and time could reverse it.

use serde::Serialize;

use super::continuum::{Continuum, Solid};
use super::outcome::Outcome;
use super::pendulum::Model;
use super::window::Window;
use crate::error::Result;

/// A measured value in one window, its uncertainty and the outcome.
#[derive(Serialize)]
pub struct WindowFinding {
    pub window: Window,
    pub value: f64,
    pub uncertainty: f64,
    pub outcome: Outcome,
}

/// A statement on the pendulum, measured with both starts.
#[derive(Serialize)]
pub struct PendulumStatement {
    pub statement: &'static str,
    pub measure: &'static str,
    pub sudden: Vec<WindowFinding>,
    pub relaxed: Vec<WindowFinding>,
    pub verdict: String,
}

/// A comparison of models with the solid under 2D heat.
struct Claim {
    statement: &'static str,
    measure: &'static str,
    /// Value and uncertainty in a window.
    value: fn(&Start, Window) -> (f64, f64),
    /// The limit that the value has to meet.
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
        // A NaN decides nothing.
        if above > uncertainty {
            Outcome::Holds
        } else if above < -uncertainty {
            Outcome::DoesNot
        } else {
            Outcome::Undecided
        }
    }
}

/// The models with one start, and their solids.
struct Start<'a> {
    /// Heated along the axis: the paper's element, and the one it compares with.
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
        let distance = model.tip.largest_distance_in(&self.solid.tip, window);
        (distance, self.solid.uncertainty(window) + model.space_error(window) + model.time_error(window))
    }

    /// The gap over the solid's displacement by heat, which is known to two per cent or better.
    fn share(&self, model: &Model, window: Window) -> (f64, f64) {
        let (gap, uncertainty) = self.gap(model, window);
        let effect = self.cold_solid.tip.largest_distance_in(&self.solid.tip, window);
        (gap / effect, uncertainty / effect)
    }

    /// Gap of the first model minus that of the second, and its uncertainty, m.
    fn farther(&self, first: &Model, second: &Model, window: Window) -> (f64, f64) {
        let ((a, u_a), (b, u_b)) = (self.gap(first, window), self.gap(second, window));
        (a - b, u_a + u_b)
    }
}

/// Statements on the curves. "Good agreement": curves that coincide in a plot of the whole motion.
const CLAIMS: [Claim; 7] = [
    Claim {
        statement: "The proposed model is in good agreement with ANSYS within a large overall motion.",
        measure: "largest distance of 2D from the solid, m: below 0.02",
        value: |start, window| start.gap(start.plane, window),
        limit: Limit::Below(0.02),
    },
    Claim {
        statement: "The 1D model agrees as well.",
        measure: "largest distance of 1D, Euler–Bernoulli, from the solid, m: below 0.02",
        value: |start, window| start.gap(start.euler_bernoulli, window),
        limit: Limit::Below(0.02),
    },
    Claim {
        statement: "The difference that heat makes is approximately that of ANSYS in the proposed model.",
        measure: "largest distance of 2D from the solid over the solid's displacement by heat: below 0.1",
        value: |start, window| start.share(start.plane, window),
        limit: Limit::Below(0.1),
    },
    Claim {
        statement: "The 1D model has a huge gap with ANSYS.",
        measure: "largest distance of 1D, Euler–Bernoulli, from the solid over the solid's displacement by heat: above 0.5",
        value: |start, window| start.share(start.euler_bernoulli, window),
        limit: Limit::Above(0.5),
    },
    Claim {
        statement: "… also if the paper's own element is heated along its axis only.",
        measure: "largest distance of 1D, the paper's element, from the solid over the solid's displacement by heat: above 0.5",
        value: |start, window| start.share(start.axis, window),
        limit: Limit::Above(0.5),
    },
    Claim {
        statement: "The proposed model is more precise than the 1D model.",
        measure: "largest distance from the solid of 1D, Euler–Bernoulli, minus that of 2D, m: above 0",
        value: |start, window| start.farther(start.euler_bernoulli, start.plane, window),
        limit: Limit::Above(0.0),
    },
    Claim {
        statement: "… also if the paper's own element is heated along its axis only.",
        measure: "largest distance from the solid of 1D, the paper's element, minus that of 2D, m: above 0",
        value: |start, window| start.farther(start.axis, start.plane, window),
        limit: Limit::Above(0.0),
    },
];

/// Measures all statements.
pub fn measure(models: &[Model], continuum: &Continuum) -> Result<Vec<PendulumStatement>> {
    let start = |name: &str| -> Result<Option<Start>> {
        let model = |id: String| models.iter().find(|model| model.kind.id == id);
        let found = (model(format!("1d-{name}")), model(format!("1d-eb-{name}")), model(format!("2d-{name}")));
        let (Some(axis), Some(euler_bernoulli), Some(plane)) = found else { return Ok(None) };
        let (solid, cold_solid) = (continuum.solid(&format!("2d-{name}"))?, continuum.solid("flexible")?);
        Ok(Some(Start { axis, euler_bernoulli, plane, solid, cold_solid }))
    };
    let (Some(sudden), Some(relaxed)) = (start("sudden")?, start("relaxed")?) else { return Ok(Vec::new()) };
    let row = |claim: &Claim| {
        let find = |start: &Start| -> Vec<WindowFinding> {
            let finding = |window| {
                let (value, uncertainty) = (claim.value)(start, window);
                WindowFinding { window, value, uncertainty, outcome: claim.limit.judge((value, uncertainty)) }
            };
            continuum.windows().map(finding).collect()
        };
        let (sudden, relaxed) = (find(&sudden), find(&relaxed));
        let verdict = verdict(&sudden, &relaxed);
        PendulumStatement { statement: claim.statement, measure: claim.measure, sudden, relaxed, verdict }
    };
    Ok(CLAIMS.iter().map(row).collect())
}

/// The outcome of all windows of both starts, or the windows of each outcome.
fn verdict(sudden: &[WindowFinding], relaxed: &[WindowFinding]) -> String {
    let all = || sudden.iter().chain(relaxed);
    for outcome in [Outcome::Holds, Outcome::DoesNot, Outcome::Undecided] {
        if all().all(|finding| finding.outcome == outcome) {
            return outcome.to_string();
        }
    }
    let where_it = |findings: &[WindowFinding], wanted: &Outcome| {
        let its = findings.iter().filter(|finding| finding.outcome == *wanted);
        spans(its.map(|finding| finding.window))
    };
    let of_start = |name: &str, findings: &[WindowFinding]| {
        let parts = [Outcome::Holds, Outcome::DoesNot, Outcome::Undecided].map(|outcome| {
            let spans = where_it(findings, &outcome);
            (!spans.is_empty()).then(|| format!("{outcome} in {spans}"))
        });
        format!("{name}: {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    };
    format!("{}; {}", of_start("sudden", sudden), of_start("relaxed", relaxed))
}

/// Windows in words, adjacent ones merged.
fn spans(windows: impl Iterator<Item = Window>) -> String {
    let mut merged: Vec<Window> = Vec::new();
    for window in windows {
        match merged.last_mut() {
            Some(last) if last.to == window.from => last.to = window.to,
            _ => merged.push(window),
        }
    }
    merged.iter().map(Window::to_string).collect::<Vec<_>>().join(" and ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(outcomes: [Outcome; 3]) -> Vec<WindowFinding> {
        let window = |number: usize| Window { from: number as f64, to: number as f64 + 1.0, number };
        let finding = |(n, outcome)| WindowFinding { window: window(n), value: 0.0, uncertainty: 0.0, outcome };
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
        assert_eq!(verdict(&findings([const { Holds }; 3]), &findings([const { Holds }; 3])), "holds");
        assert_eq!(verdict(&findings([const { Undecided }; 3]), &findings([const { Undecided }; 3])), "undecided");
        let mixed = verdict(&findings([Holds, Holds, Undecided]), &findings([DoesNot, Holds, DoesNot]));
        let expected = "sudden: holds in 0 … 2 s, undecided in 2 … 3 s; \
                        relaxed: holds in 1 … 2 s, does not hold in 0 … 1 s and 2 … 3 s";
        assert_eq!(mixed, expected);
    }
}
