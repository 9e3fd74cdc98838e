//! The report on a motion as data: `conformance.json` of a trajectory.

use schemars::JsonSchema;
use serde::Serialize;

/// Name and version of the report's format.
pub const SCHEMA: &str = "ancf-trajectory/1";

/// Report on another program's motion.
///
/// Serialised, it is `conformance.json`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Outcome {
    /// Name and version of this format.
    #[schemars(extend("const" = SCHEMA))]
    pub schema: &'static str,
    /// Run id, which the report's files share. Empty until the report is written.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub run: String,
    /// Version of `ancf`.
    pub ancf: &'static str,
    /// Motion of the fixtures that the program's is compared with.
    pub scene: String,
    /// That motion in a sentence.
    pub what: String,
    /// File of the fixtures, with its version.
    pub source: String,
    /// The program's files, that of the shortest step last.
    pub files: Vec<FileResult>,
    /// The verdict.
    pub verdict: Verdict,
    /// The verdict in a sentence.
    pub summary: String,
    /// What is compared at t = 0, and how far it is off.
    pub start: Vec<StartResult>,
    /// First sample of the last file that differs; null if none does.
    pub first_difference: Option<Difference>,
    /// Largest distance of the last file from the reference, m.
    pub off: f64,
    /// Error of the program's method in the last file, m, and how it is known; null if it is not.
    pub own_error: Option<OwnError>,
    /// What two steps show; null with one file.
    pub order: Option<OrderResult>,
    /// Energies, where the program gives them.
    pub energies: Vec<EnergyResult>,
    /// Mistakes made on purpose that move as the program does, the nearest first. They cannot be told apart by this motion.
    pub mistakes: Vec<Named>,
    /// What to do next.
    pub next: String,
    /// Remarks on the files.
    pub notes: Vec<String>,
}

/// A verdict on a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The motion is the reference's.
    Agrees,
    /// It differs by no more than its step explains.
    ShortenTheStep,
    /// It differs by more than its step explains.
    Mistake,
    /// It differs, and whether by its step cannot be told without a second one.
    Undecided,
}

/// A file of the program.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FileResult {
    /// Name.
    pub file: String,
    /// Step of the method, s; null if it is not known.
    pub step: Option<f64>,
    /// Number of the reference's times that it reaches.
    pub compared: usize,
    /// Number of them that were interpolated between samples.
    pub interpolated: usize,
    /// Estimated error of the interpolation, m.
    pub interpolation_error: f64,
    /// Half a unit of the last decimal place that is written, m.
    pub rounding: f64,
    /// Largest distance from the reference, m.
    pub off: f64,
}

/// Something at t = 0.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StartResult {
    /// What is compared.
    pub what: String,
    /// Whether it is right.
    pub right: bool,
    /// Largest difference, or why it cannot be compared.
    pub detail: String,
}

/// A sample that differs.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Difference {
    /// Time, s.
    pub t: f64,
    /// Point.
    pub point: String,
    /// Position in the fixtures, m.
    pub expected: [f64; 2],
    /// The program's, m.
    pub got: [f64; 2],
    /// Their distance, m.
    pub distance: f64,
    /// Distance that would agree, m.
    pub allowed: f64,
    /// Displacement since t = 0 in parts of the reference's, by component; null where that is nearly zero.
    pub ratio: [Option<f64>; 2],
}

/// Error of the program's method.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OwnError {
    /// Its size, m.
    pub size: f64,
    /// How it is known.
    pub how: String,
}

/// What two steps show.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OrderResult {
    /// Ratio of the two steps.
    pub ratio: f64,
    /// Distances from the reference, m.
    pub off: [f64; 2],
    /// Distance of both motions from one another, m.
    pub apart: f64,
    /// Order in which the distance from the reference falls.
    pub order: f64,
    /// Distance from the reference of the limit for a step of nothing, extrapolated with the observed order or with 2, m.
    pub limit_off: f64,
    /// Order that methods of second order show with these steps; null if the steps are not known.
    pub order_of_a_right_method: Option<f64>,
}

/// An energy over the motion.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EnergyResult {
    /// Its name; `total` is the sum less the input.
    pub name: String,
    /// Largest difference from the reference, J.
    pub off: f64,
    /// The difference at the last time, J.
    pub at_the_end: f64,
    /// Largest energy of the reference, of which these are parts, J.
    pub scale: f64,
    /// Factor of the reference that comes nearest; null for `total`.
    pub factor: Option<f64>,
}

/// A mistake that fits.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Named {
    /// What is wrong.
    pub what: String,
    /// What to look at.
    pub look_at: String,
    /// Largest distance of its motion from the program's, m.
    pub distance: f64,
}

impl Outcome {
    /// Whether nothing speaks against the program.
    pub fn passes(&self) -> bool {
        matches!(self.verdict, Verdict::Agrees | Verdict::ShortenTheStep)
    }

    /// The first screen: verdict, evidence, order, energies, mistakes, what to do.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}: {}\n\n", self.scene, self.summary);
        text += &format!("Compared with {} ({}): {}.\n", self.scene, self.source, self.what);
        for file in &self.files {
            let step = file.step.map_or("unknown".into(), |step| format!("{step:e} s"));
            let between = match file.interpolated {
                0 => String::new(),
                n => format!(", {n} interpolated to {:.0e} m", file.interpolation_error),
            };
            text += &format!(
                "* {}: step {step}, {} times{between}; off by {:.1e} m.\n",
                file.file, file.compared, file.off
            );
        }
        for start in self.start.iter().filter(|start| !start.right) {
            text += &format!("* At t = 0: {}: {}.\n", start.what, start.detail);
        }
        if let Some(first) = &self.first_difference {
            let ratio: Vec<String> = (["x", "y"].iter().zip(first.ratio))
                .filter_map(|(name, ratio)| ratio.map(|ratio| format!("{name} {ratio:.4}")))
                .collect();
            let ratio = if ratio.is_empty() {
                String::new()
            } else {
                format!("; displacement in parts of the expected one: {}", ratio.join(", "))
            };
            text += &format!(
                "* First difference: t = {} s, {}: expected ({:.9}, {:.9}), got ({:.9}, {:.9}), {:.1e} m apart, allowed {:.0e}{ratio}.\n",
                first.t,
                first.point,
                first.expected[0],
                first.expected[1],
                first.got[0],
                first.got[1],
                first.distance,
                first.allowed
            );
        }
        if let Some(own) = &self.own_error {
            text += &format!("* Error of its own method: about {:.1e} m ({}).\n", own.size, own.how);
        }
        if let Some(order) = &self.order {
            let right =
                order.order_of_a_right_method.map(|right| format!("; methods of second order show {right:.1} here"));
            text += &format!(
                "* Two steps, ratio {:.3}: off by {:.1e} and {:.1e} m, {:.1e} m apart: order {:.2}{}. Limit for a step of nothing: {:.1e} m off.\n",
                order.ratio,
                order.off[0],
                order.off[1],
                order.apart,
                order.order,
                right.unwrap_or_default(),
                order.limit_off
            );
        }
        if !self.energies.is_empty() {
            let of = |energy: &EnergyResult| {
                let factor = energy.factor.map(|factor| format!(", best factor {factor:.3}")).unwrap_or_default();
                format!(
                    "{} {:.1} % (at the end {:+.1} %{factor})",
                    energy.name,
                    1e2 * energy.off / energy.scale,
                    1e2 * energy.at_the_end / energy.scale
                )
            };
            text += &format!(
                "* Energies off, of the largest: {}.\n",
                self.energies.iter().map(of).collect::<Vec<_>>().join("; ")
            );
        }
        if !self.mistakes.is_empty() {
            let heading = if self.mistakes.len() == 1 {
                "Mistake that fits"
            } else {
                "Mistakes that fit; this motion does not tell them apart"
            };
            text += &format!("\n{heading}:\n");
            for mistake in &self.mistakes {
                text += &format!(
                    "* **{}** ({:.1e} m from the program's motion). Look at {}.\n",
                    mistake.what, mistake.distance, mistake.look_at
                );
            }
        }
        text += &format!("\n{}\n", self.next);
        for note in &self.notes {
            text += &format!("\nNote: {note}\n");
        }
        text
    }
}
