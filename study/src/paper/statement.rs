//! A statement of the paper, and what was measured.

use super::claims_section3::{PendulumStatement, WindowFinding};
use super::claims_section4::StructureStatement;
use super::locking::Locking;
use super::standing::Standing;
use crate::table::{Cell, Table, cells};

/// A statement with its numbers and the verdict.
pub struct Statement {
    /// The statement in a few words.
    pub brief: &'static str,
    /// The statement in our words.
    pub text: &'static str,
    /// What was measured, and the limit.
    pub measure: String,
    pub numbers: Vec<Table>,
    pub verdict: String,
    pub standing: Standing,
}

impl From<&Locking> for Statement {
    fn from(locking: &Locking) -> Statement {
        let slenderness =
            locking.small_load.first().map(|case| case.ratios.iter().map(|(slenderness, _)| *slenderness));
        let small_columns: String =
            slenderness.into_iter().flatten().map(|slenderness| format!(" | L/h = {slenderness} :.4")).collect();
        let small_cells = locking.small_load.iter().map(|case| {
            let name = format!("one element, small load, ν = {}, Poisson's terms \"{}\"", case.nu, case.poisson);
            std::iter::once(Cell::from(name)).chain(case.ratios.iter().map(|(_, ratio)| Cell::from(*ratio))).collect()
        });
        let large_columns: String =
            locking.large_bending.iter().map(|(elements, _)| format!(" | {elements} elements :.1e")).collect();
        let large_cells = std::iter::once(Cell::from("PL²/EI = 10, h/L = 10⁻³, distance from the elastica over L"))
            .chain(locking.large_bending.iter().map(|(_, error)| Cell::from(*error)));
        Statement {
            brief: "the element is free of locking",
            text: locking.statement,
            measure: "tip of one element over that of Timoshenko's beam; distance from the elastica in large bending"
                .into(),
            numbers: vec![
                Table::new(&format!("cantilever{small_columns}"), small_cells),
                Table::new(&format!("cantilever{large_columns}"), [large_cells.collect()]),
            ],
            verdict: locking.verdict.clone(),
            standing: if locking.verdict == "holds" { Standing::Holds } else { Standing::InPart },
        }
    }
}

impl From<&PendulumStatement> for Statement {
    fn from(statement: &PendulumStatement) -> Statement {
        let PendulumStatement { brief, statement: text, measure, limits, sudden, relaxed, verdict } = statement;
        let columns: String = sudden.iter().map(|finding| format!(" | {}", finding.window)).collect();
        let number = |finding: &WindowFinding| Cell::from(measured(finding.value, finding.uncertainty));
        let row = |name: &str, findings: &[WindowFinding]| {
            std::iter::once(Cell::from(name)).chain(findings.iter().map(number)).collect::<Vec<_>>()
        };
        let outcomes = sudden.iter().chain(relaxed).flat_map(|finding| &finding.outcomes);
        let limits: Vec<String> = limits.iter().map(ToString::to_string).collect();
        Statement {
            brief,
            text,
            measure: format!("{measure} {}", limits.join(", ")),
            numbers: vec![Table::new(&format!("start{columns}"), [row("sudden", sudden), row("relaxed", relaxed)])],
            verdict: verdict.clone(),
            standing: Standing::of(outcomes),
        }
    }
}

impl From<&StructureStatement> for Statement {
    fn from(statement: &StructureStatement) -> Statement {
        let StructureStatement { brief, statement: text, measure, verdict, .. } = statement;
        let families = [
            ("undamped", &statement.undamped),
            ("undamped, half the elements", &statement.half_the_elements),
            ("undamped, twice the step", &statement.twice_the_step),
            ("damped", &statement.damped),
        ];
        let rows = families.map(|(name, finding)| cells![name, &*finding.numbers, finding.outcome.to_string()]);
        let first = &families[0].1.outcome;
        let standing = if families.iter().any(|(_, finding)| finding.outcome != *first) {
            Standing::Undecided
        } else {
            Standing::of(std::iter::once(first))
        };
        Statement {
            brief,
            text,
            measure: (*measure).into(),
            numbers: vec![Table::new("runs | measured | ", rows)],
            verdict: verdict.clone(),
            standing,
        }
    }
}

/// A value with its uncertainty, both with the digits that the latter leaves.
fn measured(value: f64, uncertainty: f64) -> String {
    let size = value.abs().max(uncertainty);
    if !uncertainty.is_finite() {
        return format!("{value:.2e}, uncertain");
    } else if !(1e-2..1e4).contains(&size) {
        return format!("{value:.2e} ± {uncertainty:.0e}");
    }
    let decimals = (-uncertainty.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{value:.decimals$} ± {uncertainty:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_that_the_uncertainty_leaves() {
        assert_eq!(measured(10.234, 7.1), "10 ± 7");
        assert_eq!(measured(0.1725, 0.0013), "0.172 ± 0.001");
        assert_eq!(measured(0.010012, 3e-5), "0.01001 ± 0.00003");
        assert_eq!(measured(1.77e-5, 6e-6), "1.77e-5 ± 6e-6");
        assert_eq!(measured(8.97, f64::INFINITY), "8.97e0, uncertain");
    }
}
