//! The paper's statements on its structure (Section 4 and conclusion 3), as questions with a number for an answer.
//!
//! Each statement is measured on four families of runs: without damping, with half the elements, with twice the step, and with the
//! numerical damping of engineering integrators. If all agree, that is the verdict.
//!
//! Accelerations and fast vibrations are compared by their root mean square, never at instants: without damping, another step changes their
//! instantaneous values more than heat does.

use serde::Serialize;

use super::outcome::Outcome;
use super::scissors::{Family, POINTS, RODS, ScissorsRun, Structure};
use super::time_series::{Signal, largest, rms};

/// Window of the mean that vibrations are measured from, s: the first bending period of half a rod is 22 ms.
pub const WINDOW: f64 = 0.02;

/// Inflection points of the temperature that the paper names.
const INFLECTIONS: [&str; 4] = ["0.25 s", "1.25 s", "1.75 s", "2.75 s"];

/// Time before and after an inflection point in which vibrations are compared, s.
const AROUND: f64 = 0.1;

const END: f64 = 3.0;

/// A statement of the paper, in our words.
struct Claim {
    brief: &'static str,
    statement: &'static str,
    measure: &'static str,
    find: fn(&Family) -> FamilyFinding,
}

/// Numbers and outcome of one family of runs.
#[derive(Serialize)]
pub struct FamilyFinding {
    pub numbers: String,
    pub outcome: Outcome,
}

/// A statement on the structure, measured on all families.
#[derive(Serialize)]
pub struct StructureStatement {
    /// The statement in a few words.
    pub brief: &'static str,
    pub statement: &'static str,
    pub measure: &'static str,
    pub undamped: FamilyFinding,
    pub half_the_elements: FamilyFinding,
    pub twice_the_step: FamilyFinding,
    pub damped: FamilyFinding,
    pub verdict: String,
}

/// The outcome on which all families agree, or their disagreement.
fn verdict([undamped, half_the_elements, twice_the_step, damped]: [&Outcome; 4]) -> String {
    let undecided = "cannot be decided from the text";
    if undamped != half_the_elements || undamped != twice_the_step {
        format!("{undecided}: without damping it depends on mesh and step; with damping it {damped}")
    } else if undamped != damped {
        format!("{undecided}: without damping it {undamped}, with damping it {damped}")
    } else {
        undamped.to_string()
    }
}

/// Every statement that can be measured, in the paper's order.
const CLAIMS: [Claim; 11] = [
    Claim {
        brief: "deflections differ greatly after 2.7 s",
        statement: "After 2.7 s the deflections with and without heat differ greatly.",
        measure: "r.m.s. of 2D minus flexible in 2.7 … 3 s over the largest of the nine 0.3 s before, per rod: above 1",
        find: |family| {
            let ratio = |rod: &str| {
                let change = family.change(rod);
                let rms = |from, to| change.within(from, to).rms();
                let before = (0..9).map(|n| rms(0.3 * f64::from(n), 0.3 * f64::from(n + 1)));
                rms(2.7, END) / before.fold(0.0, f64::max)
            };
            each(&RODS, ratio, |ratio| ratio > 1.0)
        },
    },
    Claim {
        brief: "heat brings small vibrations",
        statement: "Heat brings many small vibrations of the deflections, clearly seen after 2.7 s.",
        measure: "r.m.s. vibration of 2D over that of flexible in 2.7 … 3 s, per rod: above 1.05",
        find: |family| {
            let ratio =
                |rod: &str| late_vibration(&family.axis_and_section, rod) / late_vibration(&family.flexible, rod);
            each(&RODS, ratio, |ratio| ratio > 1.05)
        },
    },
    Claim {
        brief: "transverse strain takes part in the vibrations",
        statement: "Transverse thermal strain contributes to them, in addition to axial strain.",
        measure: "r.m.s. of 2D minus 1D over that of 2D minus flexible, 2.7 … 3 s, per rod: above 0.1 (brackets: of heat across alone minus flexible)",
        find: |family| {
            let Family { flexible, axis, section, axis_and_section, .. } = family;
            let by_heat = |rod: &str| late_difference(axis_and_section, flexible, rod);
            let of_2d = |rod: &str| late_difference(axis_and_section, axis, rod) / by_heat(rod);
            let alone = |rod: &str| late_difference(section, flexible, rod) / by_heat(rod);
            each(&RODS, of_2d, |share| share > 0.1).beside(&RODS, alone)
        },
    },
    Claim {
        brief: "heat across alone brings small vibrations",
        statement: "The varying moment of inertia, by transverse strain, brings small vibrations.",
        measure: "r.m.s. vibration of heat across alone over that of flexible in 2.7 … 3 s, per rod: above 1.05 (brackets: of heat along alone)",
        find: |family| {
            let ratio = |run, rod: &str| late_vibration(run, rod) / late_vibration(&family.flexible, rod);
            let across = |rod: &str| ratio(&family.section, rod);
            each(&RODS, across, |ratio| ratio > 1.05).beside(&RODS, |rod| ratio(&family.axis, rod))
        },
    },
    Claim {
        brief: "heat's influence weakens in 2 … 2.5 s",
        statement: "The influence of heat on the deflections weakens in 2 … 2.5 s.",
        measure: "r.m.s. of 2D minus flexible in 2 … 2.5 s over the smaller of 1.5 … 2 and 2.5 … 3 s, per rod: below 1",
        find: |family| {
            let ratio = |rod: &str| {
                let change = family.change(rod);
                let rms = |from, to| change.within(from, to).rms();
                rms(2.0, 2.5) / f64::min(rms(1.5, 2.0), rms(2.5, END))
            };
            each(&RODS, ratio, |ratio| ratio < 1.0)
        },
    },
    Claim {
        brief: "the cold phase offsets the hot one",
        statement: "The cold phase offsets a part of the effect of the hot one.",
        measure: "r.m.s. of 2D minus flexible in 2 … 2.5 s with the whole history over that with its hot half only: below 1",
        find: |family| {
            let ratio = |rod: &str| {
                let flexible = family.flexible.deflection(rod);
                let rms = |run: &ScissorsRun| run.deflection(rod).less(&flexible).within(2.0, 2.5).rms();
                rms(&family.axis_and_section) / rms(&family.hot_half)
            };
            each(&RODS, ratio, |ratio| ratio < 1.0)
        },
    },
    Claim {
        brief: "displacement of a4 hardly affected",
        statement: "Heat hardly affects the displacement of a4.",
        measure: "largest distance of 2D from flexible over the largest displacement: below 0.05",
        find: |family| {
            let start = family.flexible.position("a4", 0.0);
            let [x, y] = family.flexible.of_point("a4", "");
            hardly_changes(family, "", largest([&x.shifted(-start[0]), &y.shifted(-start[1])]), "m")
        },
    },
    Claim {
        brief: "velocity of a4 hardly affected",
        statement: "Heat hardly affects the velocity of a4.",
        measure: "largest difference of 2D from flexible over the largest speed: below 0.05",
        find: |family| {
            let [x, y] = family.flexible.of_point("a4", "v");
            hardly_changes(family, "v", largest([&x, &y]), "m/s")
        },
    },
    Claim {
        brief: "acceleration of a4 hugely affected",
        statement: "Heat hugely affects the acceleration of a4.",
        measure: "r.m.s. of 2D over that of flexible: above 2 (brackets: r.m.s. change of the means over 20 ms by heat, over that of the means)",
        find: |family| {
            let [heated, flexible] = family.heated_and_flexible("a");
            let ratio = rms([&heated[0], &heated[1]]) / rms([&flexible[0], &flexible[1]]);
            let [x, y] = family.change_at_a4("a").map(|change| change.mean(WINDOW));
            let means = flexible.map(|signal| signal.mean(WINDOW));
            let means = rms([&x, &y]) / rms([&means[0], &means[1]]);
            let FamilyFinding { outcome, .. } = each(&["a4"], |_| ratio, |ratio| ratio > 2.0);
            FamilyFinding { numbers: format!("{ratio:.2} ({means:.2})"), outcome }
        },
    },
    Claim {
        brief: "a4 vibrates more after the temperature's corners",
        statement: "The acceleration of a4 vibrates more after 0.25, 1.25, 1.75 and 2.75 s.",
        measure: "r.m.s. vibration of 2D in the 0.1 s after over that in the 0.1 s before: above 1.2",
        find: |family| {
            let vibration = |from, to| acceleration_vibration(&family.axis_and_section, "a4", from, to);
            let ratio = |name: &str| {
                let t = name.trim_end_matches(" s").parse().unwrap_or(f64::NAN);
                vibration(t, t + AROUND) / vibration(t - AROUND, t)
            };
            each(&INFLECTIONS, ratio, |ratio| ratio > 1.2)
        },
    },
    Claim {
        brief: "heat brings vibrations to any point",
        statement: "Heat brings additional vibrations to the acceleration of any point.",
        measure: "r.m.s. vibration of 2D over that of flexible at a1 … a4, b2 … b4, m1 … m3: above 1",
        find: |family| {
            let ratio = |point: &str| {
                let vibration = |run| acceleration_vibration(run, point, 0.0, END);
                vibration(&family.axis_and_section) / vibration(&family.flexible)
            };
            each(&POINTS, ratio, |ratio| ratio > 1.0)
        },
    },
];

/// Measures all statements.
pub fn measure(structure: &Structure) -> Vec<StructureStatement> {
    let row = |claim: &Claim| {
        let Structure { fine, coarse, twice_the_step, damped } = structure;
        let [undamped, half_the_elements, twice_the_step, damped] =
            [fine, coarse, twice_the_step, damped].map(claim.find);
        let outcomes = [&undamped, &half_the_elements, &twice_the_step, &damped].map(|finding| &finding.outcome);
        let verdict = verdict(outcomes);
        let Claim { brief, statement, measure, .. } = *claim;
        StructureStatement { brief, statement, measure, undamped, half_the_elements, twice_the_step, damped, verdict }
    };
    CLAIMS.iter().map(row).collect()
}

/// A ratio for each of the items, and the condition on it, which a NaN does not meet.
fn each(items: &[&'static str], ratio: impl Fn(&'static str) -> f64, condition: fn(f64) -> bool) -> FamilyFinding {
    let ratios: Vec<f64> = items.iter().map(|item| ratio(item)).collect();
    let holds: Vec<&str> = items.iter().zip(&ratios).filter(|(_, r)| condition(**r)).map(|(item, _)| *item).collect();
    let outcome = match holds.len() {
        0 => Outcome::DoesNot,
        n if n == items.len() => Outcome::Holds,
        _ => Outcome::OnlyFor(holds),
    };
    FamilyFinding { numbers: ratios.iter().map(|ratio| format!("{ratio:.2}")).collect::<Vec<_>>().join(", "), outcome }
}

impl FamilyFinding {
    /// The finding with another ratio of the items in brackets, which decides nothing.
    fn beside(mut self, items: &[&'static str], ratio: impl Fn(&'static str) -> f64) -> FamilyFinding {
        let ratios: Vec<String> = items.iter().map(|item| format!("{:.2}", ratio(item))).collect();
        self.numbers += &format!(" ({})", ratios.join(" / "));
        self
    }
}

impl Family {
    /// Change of a rod's deflection by heat.
    fn change(&self, rod: &str) -> Signal {
        self.axis_and_section.deflection(rod).less(&self.flexible.deflection(rod))
    }

    /// A quantity of a4, heated and flexible.
    fn heated_and_flexible(&self, quantity: &str) -> [[Signal; 2]; 2] {
        [&self.axis_and_section, &self.flexible].map(|run| run.of_point("a4", quantity))
    }

    /// Change of a quantity of a4 by heat.
    fn change_at_a4(&self, quantity: &str) -> [Signal; 2] {
        let [heated, flexible] = self.heated_and_flexible(quantity);
        [heated[0].less(&flexible[0]), heated[1].less(&flexible[1])]
    }
}

/// r.m.s. difference of a rod's deflection between two runs in 2.7 … 3 s.
fn late_difference(run: &ScissorsRun, other: &ScissorsRun, rod: &str) -> f64 {
    run.deflection(rod).less(&other.deflection(rod)).within(2.7, END).rms()
}

/// r.m.s. vibration of a rod's deflection in 2.7 … 3 s.
fn late_vibration(run: &ScissorsRun, rod: &str) -> f64 {
    run.deflection(rod).vibration(WINDOW).within(2.7, END).rms()
}

/// Largest change of a quantity of a4 by heat over its size: below 0.05.
fn hardly_changes(family: &Family, quantity: &str, size: f64, unit: &str) -> FamilyFinding {
    let [x, y] = family.change_at_a4(quantity);
    let change = largest([&x, &y]);
    let ratio = change / size;
    let FamilyFinding { outcome, .. } = each(&["a4"], |_| ratio, |ratio| ratio < 0.05);
    FamilyFinding { numbers: format!("{ratio:.4} ({change:.4} of {size:.2} {unit})"), outcome }
}

/// r.m.s. vibration of a point's acceleration in a window of time.
fn acceleration_vibration(run: &ScissorsRun, point: &str, from: f64, to: f64) -> f64 {
    let [x, y] = run.of_point(point, "a").map(|signal| signal.vibration(WINDOW).within(from, to));
    rms([&x, &y])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_verdict_is_what_all_families_say() {
        let only = Outcome::OnlyFor(vec!["b1a2"]);
        let holds = &Outcome::Holds;
        assert_eq!(verdict([holds; 4]), "holds");
        assert_eq!(verdict([&Outcome::DoesNot; 4]), "does not hold");
        assert_eq!(verdict([&only; 4]), "holds only for b1a2");
        let damping = verdict([&only, &only, &only, holds]);
        assert!(damping.starts_with("cannot be decided") && damping.contains("with damping it holds"), "{damping}");
        assert!(verdict([holds, &only, holds, holds]).contains("depends on mesh and step"));
        assert!(verdict([holds, holds, &only, holds]).contains("depends on mesh and step"));
    }

    #[test]
    fn a_ratio_that_is_not_a_number_holds_nothing() {
        let ratio = |item: &str| if item == "a" { 2.0 } else { f64::NAN };
        let finding = each(&["a", "b"], ratio, |ratio| ratio > 1.0);
        assert_eq!((finding.numbers.as_str(), finding.outcome), ("2.00, NaN", Outcome::OnlyFor(vec!["a"])));
        assert_eq!(each(&["b"], ratio, |ratio| ratio < 1.0).outcome, Outcome::DoesNot);
    }
}
