//! What the paper says of its structure (Section 4 and conclusion 3), put as questions with a number for an answer.
//!
//! Each statement is measured on four families of runs: without damping, the same with half the elements and with twice the
//! step, and with the numerical damping that an engineer's integrator has. Where all agree, that is the verdict.
//!
//! Accelerations and fast vibrations are compared by their r.m.s., never instant by instant: undamped, another step changes
//! their instantaneous values by more than heat does.

use serde::{Serialize, Serializer};

use super::scissors::{Family, Motion, POINTS, RODS, Structure};
use super::time_series::{Signal, largest, rms};

/// Mean over which a vibration is what is faster, s: the first bending period of half a rod is 22 ms.
pub const WINDOW: f64 = 0.02;

/// Inflection points of the temperature that the paper names.
const INFLECTIONS: [&str; 4] = ["0.25 s", "1.25 s", "1.75 s", "2.75 s"];

/// Time before and after an inflection point over which vibrations are compared, s.
const AROUND: f64 = 0.1;

const END: f64 = 3.0;

/// A statement of the paper, in our words.
pub struct Claim {
    statement: &'static str,
    measure: &'static str,
    find: fn(&Family) -> Finding,
}

/// What one family of runs says.
#[derive(Serialize)]
pub struct Finding {
    pub numbers: String,
    pub outcome: Outcome,
}

/// Whether a statement holds for what it speaks of: rods, instants, points.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    Holds,
    DoesNot,
    OnlyFor(Vec<&'static str>),
}

impl Outcome {
    fn words(&self) -> String {
        match self {
            Outcome::Holds => "holds".into(),
            Outcome::DoesNot => "does not hold".into(),
            Outcome::OnlyFor(items) => format!("holds only for {}", items.join(", ")),
        }
    }
}

impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.words())
    }
}

/// A statement with what was found.
#[derive(Serialize)]
pub struct Row {
    pub statement: &'static str,
    pub measure: &'static str,
    pub undamped: Finding,
    pub half_the_elements: Finding,
    pub twice_the_step: Finding,
    pub damped: Finding,
    pub verdict: String,
}

/// The verdict: what all families say, or what they disagree in. The first three are the undamped ones.
fn verdict([undamped, half_the_elements, twice_the_step, damped]: [&Outcome; 4]) -> String {
    let undecided = "cannot be decided from the text";
    if undamped != half_the_elements || undamped != twice_the_step {
        format!("{undecided}: without damping mesh and step decide; damped it {}", damped.words())
    } else if undamped != damped {
        format!("{undecided}: without damping it {}, damped it {}", undamped.words(), damped.words())
    } else {
        undamped.words()
    }
}

/// Every statement that can be measured, in the paper's order.
pub const CLAIMS: [Claim; 10] = [
    Claim {
        statement: "After 2.7 s the deflections with and without heat differ greatly.",
        measure: "r.m.s. of 2D less flexible in 2.7 … 3 s over the largest of the nine 0.3 s before, per rod: above 1",
        find: differ_most_after_2_7,
    },
    Claim {
        statement: "Heat brings many small vibrations of the deflections, clearly seen after 2.7 s.",
        measure: "r.m.s. vibration of 2D over that of flexible in 2.7 … 3 s, per rod: above 1.05",
        find: vibrations_show_after_2_7,
    },
    Claim {
        statement: "Transverse thermal strain takes part in causing them, beside axial strain.",
        measure: "share of the r.m.s. vibration that 2D has more than flexible and 1D has not, 2.7 … 3 s, per rod: above 0.1",
        find: transverse_strain_takes_part,
    },
    Claim {
        statement: "Heat's influence on the deflections weakens in 2 … 2.5 s.",
        measure: "r.m.s. of 2D less flexible in 2 … 2.5 s over the lesser of 1.5 … 2 and 2.5 … 3 s, per rod: below 1",
        find: weaker_from_2_to_2_5,
    },
    Claim {
        statement: "The cold phase offsets part of what the hot one did.",
        measure: "r.m.s. of 2D less flexible in 2 … 2.5 s with the whole history over that with its hot half only: below 1",
        find: cold_offsets_hot,
    },
    Claim {
        statement: "Heat hardly affects the displacement of a4.",
        measure: "largest distance of 2D from flexible over the largest displacement: below 0.05",
        find: displacement_hardly_changes,
    },
    Claim {
        statement: "Heat hardly affects the velocity of a4.",
        measure: "largest difference of 2D from flexible over the largest speed: below 0.05",
        find: velocity_hardly_changes,
    },
    Claim {
        statement: "Heat hugely affects the acceleration of a4.",
        measure: "r.m.s. of 2D over that of flexible: above 2 (in brackets: r.m.s. of what heat changes of the means over 20 ms, over theirs)",
        find: acceleration_changes_hugely,
    },
    Claim {
        statement: "The acceleration of a4 vibrates more after 0.25, 1.25, 1.75 and 2.75 s.",
        measure: "r.m.s. vibration of 2D in the 0.1 s after over that in the 0.1 s before: above 1.2",
        find: vibrations_grow_at_inflections,
    },
    Claim {
        statement: "Heat brings additional vibrations to the acceleration of any point.",
        measure: "r.m.s. vibration of 2D over that of flexible at a1 … a4, b2 … b4, m1 … m3: above 1",
        find: every_point_vibrates_more,
    },
];

/// All statements, measured.
pub fn measure(structure: &Structure) -> Vec<Row> {
    let row = |claim: &Claim| {
        let Structure { fine, coarse, twice_the_step, damped } = structure;
        let [undamped, half_the_elements, twice_the_step, damped] =
            [fine, coarse, twice_the_step, damped].map(|family| (claim.find)(family));
        let outcomes = [&undamped, &half_the_elements, &twice_the_step, &damped].map(|finding| &finding.outcome);
        let (statement, measure, verdict) = (claim.statement, claim.measure, verdict(outcomes));
        Row { statement, measure, undamped, half_the_elements, twice_the_step, damped, verdict }
    };
    CLAIMS.iter().map(row).collect()
}

/// A ratio for each of the items, and the condition on it. A ratio that is not a number fulfils none.
fn each(items: &[&'static str], ratio: impl Fn(&'static str) -> f64, condition: impl Fn(f64) -> bool) -> Finding {
    let ratios: Vec<f64> = items.iter().map(|item| ratio(item)).collect();
    let holds: Vec<&str> = items.iter().zip(&ratios).filter(|(_, r)| condition(**r)).map(|(item, _)| *item).collect();
    let outcome = match holds.len() {
        0 => Outcome::DoesNot,
        n if n == items.len() => Outcome::Holds,
        _ => Outcome::OnlyFor(holds),
    };
    Finding { numbers: ratios.iter().map(|ratio| format!("{ratio:.2}")).collect::<Vec<_>>().join(", "), outcome }
}

/// r.m.s. in a window.
fn in_window(signal: &Signal, from: f64, to: f64) -> f64 {
    signal.within(from, to).rms()
}

/// The largest of f over the windows of 0.3 s before 2.7 s.
fn earlier(f: impl Fn(f64, f64) -> f64) -> f64 {
    (0..9).map(|n| f(0.3 * n as f64, 0.3 * (n + 1) as f64)).fold(0.0, f64::max)
}

fn differ_most_after_2_7(family: &Family) -> Finding {
    let ratio = |rod: &str| {
        let difference = family.axis_and_section.deflection(rod).less(&family.flexible.deflection(rod));
        in_window(&difference, 2.7, END) / earlier(|from, to| in_window(&difference, from, to))
    };
    each(&RODS, ratio, |ratio| ratio > 1.0)
}

fn vibrations_show_after_2_7(family: &Family) -> Finding {
    let ratio = |rod: &str, from, to| {
        let vibration = |motion: &Motion| in_window(&motion.deflection(rod).vibration(WINDOW), from, to);
        vibration(&family.axis_and_section) / vibration(&family.flexible)
    };
    each(&RODS, |rod| ratio(rod, 2.7, END), |ratio| ratio > 1.05)
}

fn transverse_strain_takes_part(family: &Family) -> Finding {
    let share = |rod: &str| {
        let vibration = |motion: &Motion| in_window(&motion.deflection(rod).vibration(WINDOW), 2.7, END);
        let heated = vibration(&family.axis_and_section);
        (heated - vibration(&family.axis)) / (heated - vibration(&family.flexible))
    };
    each(&RODS, share, |share| share > 0.1)
}

fn weaker_from_2_to_2_5(family: &Family) -> Finding {
    let ratio = |rod: &str| {
        let difference = family.axis_and_section.deflection(rod).less(&family.flexible.deflection(rod));
        let rms = |from, to| in_window(&difference, from, to);
        rms(2.0, 2.5) / f64::min(rms(1.5, 2.0), rms(2.5, END))
    };
    each(&RODS, ratio, |ratio| ratio < 1.0)
}

fn cold_offsets_hot(family: &Family) -> Finding {
    let ratio = |rod: &str| {
        let flexible = family.flexible.deflection(rod);
        let rms = |motion: &Motion| in_window(&motion.deflection(rod).less(&flexible), 2.0, 2.5);
        rms(&family.axis_and_section) / rms(&family.hot_half)
    };
    each(&RODS, ratio, |ratio| ratio < 1.0)
}

/// Components of what heat changes at a4.
fn change_at_a4(family: &Family, quantity: &str) -> [Signal; 2] {
    let [heated, flexible] = [&family.axis_and_section, &family.flexible].map(|motion| motion.of_point("a4", quantity));
    [heated[0].less(&flexible[0]), heated[1].less(&flexible[1])]
}

fn displacement_hardly_changes(family: &Family) -> Finding {
    let [x, y] = change_at_a4(family, "");
    let start = family.flexible.position("a4", 0.0);
    let [from_x, from_y] = family.flexible.of_point("a4", "");
    let travel = largest([&from_x.shifted(-start[0]), &from_y.shifted(-start[1])]);
    relative(largest([&x, &y]), travel, "m")
}

fn velocity_hardly_changes(family: &Family) -> Finding {
    let [x, y] = change_at_a4(family, "v");
    let [v_x, v_y] = family.flexible.of_point("a4", "v");
    relative(largest([&x, &y]), largest([&v_x, &v_y]), "m/s")
}

fn relative(change: f64, size: f64, unit: &str) -> Finding {
    let ratio = change / size;
    let Finding { outcome, .. } = each(&["a4"], |_| ratio, |ratio| ratio < 0.05);
    Finding { numbers: format!("{ratio:.4} ({change:.4} of {size:.2} {unit})"), outcome }
}

fn acceleration_changes_hugely(family: &Family) -> Finding {
    let [heated, flexible] = [&family.axis_and_section, &family.flexible].map(|motion| motion.of_point("a4", "a"));
    let ratio = rms([&heated[0], &heated[1]]) / rms([&flexible[0], &flexible[1]]);
    let [x, y] = change_at_a4(family, "a").map(|change| change.mean(WINDOW));
    let means = flexible.map(|signal| signal.mean(WINDOW));
    let means = rms([&x, &y]) / rms([&means[0], &means[1]]);
    let Finding { outcome, .. } = each(&["a4"], |_| ratio, |ratio| ratio > 2.0);
    Finding { numbers: format!("{ratio:.2} ({means:.2})"), outcome }
}

/// r.m.s. vibration of a point's acceleration in a window.
fn acceleration_vibrates(motion: &Motion, point: &str, from: f64, to: f64) -> f64 {
    let [x, y] = motion.of_point(point, "a").map(|signal| signal.vibration(WINDOW).within(from, to));
    rms([&x, &y])
}

fn vibrations_grow_at_inflections(family: &Family) -> Finding {
    let vibration = |from, to| acceleration_vibrates(&family.axis_and_section, "a4", from, to);
    let ratio = |name: &str| {
        let t = name.trim_end_matches(" s").parse().unwrap_or(f64::NAN);
        vibration(t, t + AROUND) / vibration(t - AROUND, t)
    };
    each(&INFLECTIONS, ratio, |ratio| ratio > 1.2)
}

fn every_point_vibrates_more(family: &Family) -> Finding {
    let ratio = |point: &str| {
        let vibration = |motion| acceleration_vibrates(motion, point, 0.0, END);
        vibration(&family.axis_and_section) / vibration(&family.flexible)
    };
    each(&POINTS, ratio, |ratio| ratio > 1.0)
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
        assert!(damping.starts_with("cannot be decided") && damping.contains("damped it holds"), "{damping}");
        assert!(verdict([holds, &only, holds, holds]).contains("mesh and step decide"));
        assert!(verdict([holds, holds, &only, holds]).contains("mesh and step decide"));
    }

    #[test]
    fn a_ratio_that_is_not_a_number_holds_nothing() {
        let ratio = |item: &str| if item == "a" { 2.0 } else { f64::NAN };
        let finding = each(&["a", "b"], ratio, |ratio| ratio > 1.0);
        assert_eq!((finding.numbers.as_str(), finding.outcome), ("2.00, NaN", Outcome::OnlyFor(vec!["a"])));
        assert_eq!(each(&["b"], ratio, |ratio| ratio < 1.0).outcome, Outcome::DoesNot);
    }
}
