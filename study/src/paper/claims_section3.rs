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

/// A measured value in one window, its uncertainty, and the outcome for each limit.
#[derive(Serialize)]
pub struct WindowFinding {
    pub window: Window,
    pub value: f64,
    pub uncertainty: f64,
    pub outcomes: Vec<Outcome>,
}

/// A statement on the pendulum, measured with both starts.
#[derive(Serialize)]
pub struct PendulumStatement {
    /// The statement in a few words.
    pub brief: &'static str,
    pub statement: &'static str,
    /// What was measured, and which side of the limit it has to be on.
    pub measure: &'static str,
    /// The paper's words are not numbers: several limits, so that no verdict hangs on one of them.
    pub limits: &'static [f64],
    pub sudden: Vec<WindowFinding>,
    pub relaxed: Vec<WindowFinding>,
    pub verdict: String,
}

/// A comparison of models with the solid under 2D heat.
struct Claim {
    brief: &'static str,
    statement: &'static str,
    measure: &'static str,
    /// Value and uncertainty in a window.
    value: fn(&Start, Window) -> (f64, f64),
    /// The side of each limit on which the value has to be.
    side: Side,
    limits: &'static [f64],
}

enum Side {
    Above,
    Below,
}

impl Side {
    fn judge(&self, (value, uncertainty): (f64, f64), limit: f64) -> Outcome {
        let within = match self {
            Side::Above => value - limit,
            Side::Below => limit - value,
        };
        // A NaN decides nothing.
        if within > uncertainty {
            Outcome::Holds
        } else if within < -uncertainty {
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

    /// Gap of the first model over that of the second, and its uncertainty.
    fn times(&self, first: &Model, second: &Model, window: Window) -> (f64, f64) {
        let ((a, u_a), (b, u_b)) = (self.gap(first, window), self.gap(second, window));
        let ratio = a / b;
        // The least that the second gap may be is nothing where its uncertainty is as large: then the ratio is not known.
        (
            ratio,
            if b > u_b { ((a + u_a) / (b - u_b) - ratio).max(ratio - (a - u_a) / (b + u_b)) } else { f64::INFINITY },
        )
    }

    /// Gap of the first model minus that of the second, and its uncertainty, m.
    fn farther(&self, first: &Model, second: &Model, window: Window) -> (f64, f64) {
        let ((a, u_a), (b, u_b)) = (self.gap(first, window), self.gap(second, window));
        (a - b, u_a + u_b)
    }
}

/// Statements on the curves. "Good agreement": curves that coincide in a plot of the whole motion.
const CLAIMS: [Claim; 9] = [
    Claim {
        brief: "2D agrees with ANSYS",
        statement: "The proposed model is in good agreement with ANSYS within a large overall motion.",
        measure: "largest distance of 2D from the solid, m: below",
        value: |start, window| start.gap(start.plane, window),
        side: Side::Below,
        limits: &[0.01, 0.02, 0.05],
    },
    Claim {
        brief: "1D agrees with ANSYS",
        statement: "The 1D model agrees as well.",
        measure: "largest distance of 1D, Euler–Bernoulli, from the solid, m: below",
        value: |start, window| start.gap(start.euler_bernoulli, window),
        side: Side::Below,
        limits: &[0.01, 0.02, 0.05],
    },
    Claim {
        brief: "heat changes 2D as it changes ANSYS",
        statement: "The difference that heat makes is approximately that of ANSYS in the proposed model.",
        measure: "largest distance of 2D from the solid over the solid's displacement by heat: below",
        value: |start, window| start.share(start.plane, window),
        side: Side::Below,
        limits: &[0.05, 0.1, 0.2],
    },
    Claim {
        brief: "1D has a huge gap",
        statement: "The 1D model has a huge gap with ANSYS.",
        measure: "largest distance of 1D, Euler–Bernoulli, from the solid over the solid's displacement by heat: above",
        value: |start, window| start.share(start.euler_bernoulli, window),
        side: Side::Above,
        limits: &[0.1, 0.25, 0.5],
    },
    Claim {
        brief: "huge gap of 2D's element with 1D heat",
        statement: "The paper's own element, heated along its axis only, has a huge gap, too (not in the paper).",
        measure: "largest distance of 1D, the paper's element, from the solid over the solid's displacement by heat: above",
        value: |start, window| start.share(start.axis, window),
        side: Side::Above,
        limits: &[0.1, 0.25, 0.5],
    },
    Claim {
        brief: "1D has a relatively large gap",
        statement: "The 1D model has a relatively large gap (conclusion 2).",
        measure: "largest distance from the solid of 1D, Euler–Bernoulli, over that of 2D: above",
        value: |start, window| start.times(start.euler_bernoulli, start.plane, window),
        side: Side::Above,
        limits: &[1.5, 2.0, 5.0],
    },
    Claim {
        brief: "relatively large gap of 2D's element with 1D heat",
        statement: "The paper's own element, heated along its axis only, has a relatively large gap, too (not in the paper).",
        measure: "largest distance from the solid of 1D, the paper's element, over that of 2D: above",
        value: |start, window| start.times(start.axis, start.plane, window),
        side: Side::Above,
        limits: &[1.5, 2.0, 5.0],
    },
    Claim {
        brief: "2D is more precise than 1D",
        statement: "The proposed model is more precise than the 1D model.",
        measure: "largest distance from the solid of 1D, Euler–Bernoulli, minus that of 2D, m: above",
        value: |start, window| start.farther(start.euler_bernoulli, start.plane, window),
        side: Side::Above,
        limits: &[0.0],
    },
    Claim {
        brief: "2D is more precise than its element with 1D heat",
        statement: "The proposed model is more precise than its own element heated along the axis only (not in the paper).",
        measure: "largest distance from the solid of 1D, the paper's element, minus that of 2D, m: above",
        value: |start, window| start.farther(start.axis, start.plane, window),
        side: Side::Above,
        limits: &[0.0],
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
                let outcomes =
                    claim.limits.iter().map(|limit| claim.side.judge((value, uncertainty), *limit)).collect();
                WindowFinding { window, value, uncertainty, outcomes }
            };
            continuum.windows().map(finding).collect()
        };
        let (sudden, relaxed) = (find(&sudden), find(&relaxed));
        let Claim { brief, statement, measure, limits, .. } = *claim;
        let verdict = verdict(limits, &sudden, &relaxed);
        PendulumStatement { brief, statement, measure, limits, sudden, relaxed, verdict }
    };
    Ok(CLAIMS.iter().map(row).collect())
}

/// The verdict for each limit; one for all where they agree.
fn verdict(limits: &[f64], sudden: &[WindowFinding], relaxed: &[WindowFinding]) -> String {
    let verdicts: Vec<String> = (0..limits.len()).map(|n| verdict_for_limit(n, sudden, relaxed)).collect();
    match &verdicts[..] {
        [first, rest @ ..] if rest.iter().all(|verdict| verdict == first) => first.clone(),
        _ => {
            let each = limits.iter().zip(&verdicts).map(|(limit, verdict)| format!("limit {limit}: {verdict}"));
            each.collect::<Vec<_>>().join("\n")
        }
    }
}

/// The outcome of all windows of both starts, or the windows of each outcome.
fn verdict_for_limit(n: usize, sudden: &[WindowFinding], relaxed: &[WindowFinding]) -> String {
    const OUTCOMES: [Outcome; 3] = [Outcome::Holds, Outcome::DoesNot, Outcome::Undecided];
    let of_start = |findings: &[WindowFinding]| {
        let parts = OUTCOMES.iter().map(|outcome| {
            let its = findings.iter().filter(|finding| finding.outcomes[n] == *outcome);
            (outcome, spans(its.map(|finding| finding.window)))
        });
        let parts: Vec<_> = parts.filter(|(_, spans)| !spans.is_empty()).collect();
        match &parts[..] {
            [(outcome, _)] => outcome.to_string(),
            _ => parts.iter().map(|(outcome, spans)| format!("{outcome} in {spans}")).collect::<Vec<_>>().join(", "),
        }
    };
    match (of_start(sudden), of_start(relaxed)) {
        (sudden, relaxed) if sudden == relaxed => sudden,
        (sudden, relaxed) => format!("sudden: {sudden}; relaxed: {relaxed}"),
    }
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
        let finding =
            |(n, outcome)| WindowFinding { window: window(n), value: 0.0, uncertainty: 0.0, outcomes: vec![outcome] };
        outcomes.into_iter().enumerate().map(finding).collect()
    }

    #[test]
    fn a_value_decides_only_beyond_its_uncertainty() {
        let below = |value, uncertainty| Side::Below.judge((value, uncertainty), 0.1);
        assert_eq!(below(0.05, 0.02), Outcome::Holds);
        assert_eq!(below(0.05, 0.06), Outcome::Undecided);
        assert_eq!(below(0.2, 0.05), Outcome::DoesNot);
        assert_eq!(below(f64::NAN, 0.05), Outcome::Undecided);
        assert_eq!(below(0.05, f64::NAN), Outcome::Undecided);
        assert_eq!(Side::Above.judge((0.6, 0.05), 0.5), Outcome::Holds);
        assert_eq!(Side::Above.judge((0.6, 0.2), 0.5), Outcome::Undecided);
        assert_eq!(Side::Above.judge((9.0, f64::INFINITY), 2.0), Outcome::Undecided);
    }

    #[test]
    fn a_verdict_names_the_windows() {
        use Outcome::{DoesNot, Holds, Undecided};
        let one = |sudden, relaxed| verdict(&[0.5], &findings(sudden), &findings(relaxed));
        assert_eq!(one([const { Holds }; 3], [const { Holds }; 3]), "holds");
        assert_eq!(one([const { Undecided }; 3], [const { Undecided }; 3]), "undecided");
        assert_eq!(one([const { Holds }; 3], [const { DoesNot }; 3]), "sudden: holds; relaxed: does not hold");
        let mixed = one([Holds, Holds, Undecided], [DoesNot, Holds, DoesNot]);
        let expected = "sudden: holds in 0 … 2 s, undecided in 2 … 3 s; \
                        relaxed: holds in 1 … 2 s, does not hold in 0 … 1 s and 2 … 3 s";
        assert_eq!(mixed, expected);
    }

    #[test]
    fn a_verdict_that_hangs_on_the_limit_says_so() {
        let window = Window { from: 0.0, to: 1.0, number: 0 };
        let finding = |outcomes| WindowFinding { window, value: 0.3, uncertainty: 0.0, outcomes };
        let findings = [finding(vec![Outcome::Holds, Outcome::DoesNot])];
        assert_eq!(verdict(&[0.1, 0.5], &findings, &findings), "limit 0.1: holds\nlimit 0.5: does not hold");
    }
}
