//! The main job's tables as text.

use std::fmt::Write;
use std::path::PathBuf;

use super::balance::Balance;
use super::claims_section3::Finding;
use super::locking::{Locking, SmallLoad};
use super::model_error::{ErrorRow, ShearRow};
use super::pendulum::{self, Mesh, Model, TIMES};
use super::reference_pendulum::{Oracle, Row};
use super::{claims_section3, claims_section4, scissors, section4};

/// Lines of text; writing into a string cannot fail.
struct Lines(String);

impl Lines {
    fn push(&mut self, line: std::fmt::Arguments) {
        let _ = self.0.write_fmt(line);
        self.0.push('\n');
    }

    /// The lines, and an empty one.
    fn end(self) -> String {
        self.0 + "\n"
    }
}

/// Our runs beside the oracle's.
pub fn oracle(rows: &[Row]) -> String {
    compared("1. The same meshes by the oracle: strain energy alone, DOP853, t = 0 … 0.5 s", rows)
}

/// Structures beside the oracle's, and stiff ones beside rigid ones.
pub fn structures(rows: &[Row]) -> String {
    let title = "7. Two pinned rods at different temperatures by the oracle, in free coordinates, t = 0 … 0.5 s (named by their elements);\n   \
                 rigid-3: three scissors with E · 10⁴ beside the rigid mechanism, t = 0 … 2.9 s";
    compared(title, rows)
}

fn compared(title: &str, rows: &[Row]) -> String {
    let mut lines = Lines(format!("{title}\n\n"));
    lines.push(format_args!(
        "   {:19} {:>8} {:>16} {:>16} {:>10}  {}",
        "run", "step, s", "distance, m", "oracle's error", "bound", "verdict"
    ));
    for row in rows {
        let verdict = if row.holds() { "holds" } else { "FAILS" };
        let Row { run, step, largest_distance, oracle_error, bound, .. } = row;
        lines.push(format_args!(
            "   {run:19} {step:8.1e} {largest_distance:16.1e} {oracle_error:16.1e} {bound:10.1e}  {verdict}"
        ));
    }
    lines.end()
}

/// Tip positions of all models, with what a coarser step and another mesh change.
pub fn tips(models: &[Model], oracle: &Oracle) -> String {
    let mut lines = Lines(
        "2. Tip position, m, explicit. Behind it what twice the step and twice the elements change, and the oracle's position\n   \
         with four elements where it has one (its distance is the mesh's).\n"
            .into(),
    );
    for model in models {
        let Mesh { elements, step, other_elements } = model.kind.mesh;
        lines.push(format_args!("\n   {}, {elements} elements, step {step:.0e} s", model.kind.name));
        lines.push(format_args!(
            "   {:12} {:>10} {:>10} {:>12} {:>12} {:>24}",
            "",
            "x",
            "y",
            "2 × step",
            format!("{other_elements} elements"),
            "oracle, 4 elements"
        ));
        for row in model.rows() {
            let pendulum::Row { t, tip: [x, y], change_with_twice_the_step, change_with_the_other_mesh, .. } = row;
            let oracle = oracle_at(oracle, model, t).map_or(String::new(), |[x, y]| format!("({x:.6}, {y:.6})"));
            lines.push(format_args!(
                "   t = {t:<4} s   {x:10.6} {y:10.6} {change_with_twice_the_step:12.1e} {change_with_the_other_mesh:12.1e} {oracle:>24}"
            ));
        }
    }
    lines.end()
}

fn oracle_at(oracle: &Oracle, model: &Model, t: f64) -> Option<[f64; 2]> {
    let kind = |run: &&super::reference_pendulum::Run| {
        run.scene() == Some(model.kind.scene) && run.element == model.kind.element
    };
    let run = oracle.runs.iter().filter(kind).find(|run| run.elements == 4)?;
    let sample = run.t.iter().position(|sample| (sample - t).abs() < 1e-9)?;
    Some(run.tip[sample])
}

/// How far the heated models' tips are from the flexible one's, and from each other.
pub fn differences(models: &[Model]) -> String {
    let of = |id: &str| models.iter().find(|model| model.kind.id == id);
    let mut lines = Lines("3. Distance between the models' tips, mm (the paper's Figure 4; its 1D model is Euler–Bernoulli, EB; 1D: the paper's own element)\n\n".into());
    lines.push(format_args!("   {:10} {:>47} {:>47}", "", "sudden start", "relaxed start"));
    let head = ["1D–flexible", "2D–flexible", "2D–1D", "2D–1D EB"];
    let heads = head.iter().chain(&head).map(|name| format!("{name:>11}")).collect::<Vec<_>>().join(" ");
    lines.push(format_args!("   {:10} {heads}", ""));
    for t in TIMES {
        let distance = |(a, b): (&str, &str)| match (of(a), of(b)) {
            (Some(a), Some(b)) => 1e3 * a.tip.distance(t, b.tip.at(t)),
            _ => f64::NAN,
        };
        let pairs = [
            ("1d-sudden", "flexible"),
            ("2d-sudden", "flexible"),
            ("2d-sudden", "1d-sudden"),
            ("2d-sudden", "1d-eb-sudden"),
            ("1d-relaxed", "flexible"),
            ("2d-relaxed", "flexible"),
            ("2d-relaxed", "1d-relaxed"),
            ("2d-relaxed", "1d-eb-relaxed"),
        ];
        let values = pairs.map(|pair| format!("{:11.3}", distance(pair))).join(" ");
        lines.push(format_args!("   t = {t:<4} s {values}"));
    }
    lines.end()
}

/// What the distance from the solid is made of.
pub fn errors(rows: &[ErrorRow], shear: &[ShearRow]) -> String {
    let mut lines = Lines(
        "4. Largest distance of the tip from the plane solid that is heated alike, m; what twice the elements change (space),\n   \
         twice the step (time), the solid's uncertainty, and what these leave for the model at least\n\n"
            .into(),
    );
    let heads = ["distance", "space", "time", "solid's own", "model, ≥"].map(|head| format!("{head:>11}")).join(" ");
    lines.push(format_args!("   {:14} {:12} {heads}", "model", ""));
    for ErrorRow { model, window, distance, space, time, reference, model_error } in rows {
        let window = window.to_string();
        let model_error = if *model_error > 0.0 { format!("{model_error:.1e}") } else { "–".into() };
        lines.push(format_args!(
            "   {model:14} {window:12} {distance:11.1e} {space:11.1e} {time:11.1e} {reference:11.1e} {model_error:>11}"
        ));
    }
    lines.push(format_args!(
        "\n   The flexible model's own error is the shear correction that the element does not have. Its distance every 0.05 s, and\n   \
         what is left of it when the tip is moved by what a factor of 5/6 would change (oracle, 16 elements):"
    ));
    for ShearRow { window, distance, corrected } in shear {
        let window = window.to_string();
        lines.push(format_args!("   {:14} {window:12} {distance:11.1e} → {corrected:.1e}", ""));
    }
    lines.end()
}

/// The bars for these distances.
pub fn bars(rows: &[Row]) -> String {
    compared("5. What the distance from the plane solid may be; the error beside it is the solid's own", rows)
}

/// The paper's statements on the pendulum.
pub fn statements(rows: &[claims_section3::Row], locking: &Locking) -> String {
    let mut lines = Lines(
        "6. What the paper says of it, measured against the plane solid heated in 2D, in the windows of 4; ± the solid's\n   \
         uncertainty with our space and time\n"
            .into(),
    );
    lines.push(format_args!("\n   {}", locking.statement));
    lines.push(format_args!(
        "      tip of one element under a small load over that of Timoshenko's beam, L/h = 2, 10, 100, 1000"
    ));
    for SmallLoad { nu, poisson, ratios } in &locking.small_load {
        let ratios = ratios.iter().map(|(_, ratio)| format!("{ratio:.4}")).collect::<Vec<_>>().join(", ");
        lines.push(format_args!("      ν = {nu}, Poisson's terms \"{poisson}\": {ratios}"));
    }
    let errors = locking.large_bending.iter().map(|(elements, error)| format!("{error:.1e} ({elements})"));
    let errors = errors.collect::<Vec<_>>().join(", ");
    lines.push(format_args!(
        "      PL²/EI = 10, h/L = 10⁻³: distance of the tip from the elastica's over L (elements): {errors}"
    ));
    lines.push(format_args!("      → {}", locking.verdict));
    for claims_section3::Row { statement, measure, sudden, relaxed, verdict } in rows {
        lines.push(format_args!("\n   {statement}"));
        lines.push(format_args!("      {measure}"));
        for (name, findings) in [("sudden", sudden), ("relaxed", relaxed)] {
            let words = |Finding { value, uncertainty, .. }: &Finding| format!("{value:.2e} ± {uncertainty:.1e}");
            lines.push(format_args!("      {name:8} {}", findings.iter().map(words).collect::<Vec<_>>().join(", ")));
        }
        lines.push(format_args!("      → {verdict}"));
    }
    lines.end()
}

/// a4 over time, with what a coarser step and mesh change.
pub fn a4(rows: &[section4::Row]) -> String {
    let mut lines = Lines(format!(
        "8. Point a4, m: {} elements a rod, energy–momentum, step {:.0e} s; and what twice the step and half the elements \
         change\n\n   {:10} {:10} {:>10} {:>10} {:>12} {:>12}\n",
        scissors::ELEMENTS,
        scissors::STEP,
        "model",
        "",
        "x",
        "y",
        "2 × step",
        "½ elements"
    ));
    for row in rows {
        let section4::Row { model, t, a4: [x, y], change_with_twice_the_step, change_with_half_the_elements } = row;
        lines.push(format_args!(
            "   {model:10} t = {t:<4} s {x:10.6} {y:10.6} {change_with_twice_the_step:12.1e} {change_with_half_the_elements:12.1e}"
        ));
    }
    lines.end()
}

/// Energy balances.
pub fn energies(rows: &[Balance]) -> String {
    let mut lines = Lines("9. Energy balance of these runs, every step\n\n".into());
    for row in rows {
        lines.push(format_args!("   {row}: {}", if row.holds() { "holds" } else { "FAILS" }));
    }
    lines.end()
}

/// The paper's statements.
pub fn claims(rows: &[claims_section4::Row]) -> String {
    let mut lines = Lines(format!(
        "10. What the paper says of it, measured under the assumptions of `ancf scene scissors-3-thermal`: undamped (energy–\n   \
         momentum), the same with half the elements and with twice the step, and damped (generalized-α, ρ∞ = {}, step {:.0e} s)\n",
        scissors::DAMPED_RHO,
        scissors::DAMPED_STEP
    ));
    for claims_section4::Row { statement, measure, undamped, half_the_elements, twice_the_step, damped, verdict } in
        rows
    {
        lines.push(format_args!("\n   {statement}"));
        lines.push(format_args!("      {measure}"));
        for (name, finding) in [
            ("undamped", undamped),
            ("½ elements", half_the_elements),
            ("2 × step", twice_the_step),
            ("damped", damped),
        ] {
            lines.push(format_args!("      {name:12} {}", finding.numbers));
        }
        lines.push(format_args!("      → {verdict}"));
    }
    lines.end()
}

/// The files written.
pub fn written(paths: &[PathBuf], seconds: f64) -> String {
    let mut lines = Lines(String::new());
    lines.push(format_args!("Written after {seconds:.1} s:"));
    for path in paths {
        lines.push(format_args!("   {}", path.display()));
    }
    lines.0
}
