//! The main job's tables as text.

use std::fmt::Write;
use std::path::PathBuf;

use super::oracle::{Oracle, Row};
use super::pendulum::{self, ELEMENTS, Model, STEP, TIMES};
use super::{Balance, claims, scissors, section4};

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
    let title = "4. Two pinned rods at different temperatures by the oracle, in free coordinates, t = 0 … 0.5 s (named by their elements);\n   \
                 rigid-3: three scissors with E · 10⁴ beside the rigid mechanism, t = 0 … 2.9 s";
    compared(title, rows)
}

fn compared(title: &str, rows: &[Row]) -> String {
    let mut lines = Lines(format!("{title}\n\n"));
    lines.push(format_args!(
        "   {:14} {:>8} {:>16} {:>16} {:>10}  {}",
        "run", "step, s", "distance, m", "oracle's error", "bound", "verdict"
    ));
    for row in rows {
        let verdict = if row.holds() { "holds" } else { "FAILS" };
        let Row { run, step, largest_distance, oracle_error, bound, .. } = row;
        lines.push(format_args!(
            "   {run:14} {step:8.1e} {largest_distance:16.1e} {oracle_error:16.1e} {bound:10.0e}  {verdict}"
        ));
    }
    lines.end()
}

/// Tip positions of all models, with what a coarser step and mesh change.
pub fn tips(models: &[Model], oracle: &Oracle) -> String {
    let mut lines = Lines(format!(
        "2. Tip position, m: {ELEMENTS} elements, explicit, step {STEP:.0e} s. Behind it what twice the step and half the\n   \
         elements change, and the oracle's position with four elements where it has one (its distance is the mesh's).\n"
    ));
    for model in models {
        lines.push(format_args!(
            "\n   {:12} {:>10} {:>10} {:>12} {:>12} {:>24}",
            model.name, "x", "y", "2 × step", "½ elements", "oracle, 4 elements"
        ));
        for row in model.rows() {
            let pendulum::Row { t, tip: [x, y], change_with_twice_the_step, change_with_half_the_elements, .. } = row;
            let oracle = oracle_at(oracle, model, t).map_or(String::new(), |[x, y]| format!("({x:.6}, {y:.6})"));
            lines.push(format_args!(
                "   t = {t:<4} s   {x:10.6} {y:10.6} {change_with_twice_the_step:12.1e} {change_with_half_the_elements:12.1e} {oracle:>24}"
            ));
        }
    }
    lines.end()
}

fn oracle_at(oracle: &Oracle, model: &Model, t: f64) -> Option<[f64; 2]> {
    let run = oracle.runs.iter().find(|run| run.scene() == Some(model.scene) && run.elements == 4)?;
    let sample = run.t.iter().position(|sample| (sample - t).abs() < 1e-9)?;
    Some(run.tip[sample])
}

/// How far the heated models' tips are from the flexible one's, and from each other.
pub fn differences(models: &[Model]) -> String {
    let [flexible, sudden_1d, sudden_2d, relaxed_1d, relaxed_2d] = models else { return String::new() };
    let mut lines = Lines("3. Distance between the models' tips, mm (the paper's Figure 4)\n\n".into());
    lines.push(format_args!("   {:10} {:>34} {:>34}", "", "sudden start", "relaxed start"));
    let head = ["1D–flexible", "2D–flexible", "2D–1D"];
    let heads = head.iter().chain(&head).map(|name| format!("{name:>11}")).collect::<Vec<_>>().join(" ");
    lines.push(format_args!("   {:10} {heads}", ""));
    for t in TIMES {
        let distance = |a: &Model, b: &Model| 1e3 * a.tip.distance(t, b.tip.at(t));
        let pairs = [
            (sudden_1d, flexible),
            (sudden_2d, flexible),
            (sudden_2d, sudden_1d),
            (relaxed_1d, flexible),
            (relaxed_2d, flexible),
            (relaxed_2d, relaxed_1d),
        ];
        let values = pairs.iter().map(|(a, b)| format!("{:11.3}", distance(a, b))).collect::<Vec<_>>().join(" ");
        lines.push(format_args!("   t = {t:<4} s {values}"));
    }
    lines.end()
}

/// a4 over time, with what a coarser step and mesh change.
pub fn a4(rows: &[section4::Row]) -> String {
    let mut lines = Lines(format!(
        "5. Point a4, m: {} elements a rod, energy–momentum, step {:.0e} s; and what twice the step and half the elements \
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
    let mut lines = Lines("6. Energy balance of these runs, every step\n\n".into());
    for row in rows {
        lines.push(format_args!("   {row}: {}", if row.holds() { "holds" } else { "FAILS" }));
    }
    lines.end()
}

/// The paper's statements.
pub fn claims(rows: &[claims::Row]) -> String {
    let mut lines = Lines(format!(
        "7. What the paper says of it, measured under the assumptions of `ancf scene scissors-3-thermal`: undamped (energy–\n   \
         momentum), the same with half the elements and with twice the step, and damped (generalized-α, ρ∞ = {}, step {:.0e} s)\n",
        scissors::DAMPED_RHO,
        scissors::DAMPED_STEP
    ));
    for claims::Row { statement, measure, undamped, half_the_elements, twice_the_step, damped, verdict } in rows {
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
