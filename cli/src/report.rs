//! Texts for people: all rounding and formatting happens here.

use ancf::internals::model::{Part, Plan};
use ancf::model::{Method, Scene, Section};
use ancf::run::{ColumnAccuracy, Convergence, Run};

use crate::ends::{energy_imbalance, final_time, final_values, largest_of};
use crate::quantity::Reading;

/// A run in a few lines for a person: what it was, what it took, where it ended. Ends with a newline.
pub fn run_text(scene: &Scene, run: &Run, wall_seconds: f64) -> String {
    let method = scene.time.method;
    let (steps, iterations) = (run.counts.steps, run.counts.newton_iterations);
    let mut lines = vec![
        scene.title.clone(),
        format!("{method}: {steps} steps, {iterations} Newton iterations, {wall_seconds:.3} s"),
    ];
    if let Some(time) = final_time(run) {
        lines.push(match method {
            Method::Static => format!("at {time} of the full load:"),
            _ => format!("at t = {} s:", (time * 1e9).round() / 1e9),
        });
    }
    let width = run.trajectory.columns.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    lines.extend(final_values(run).map(|(name, value)| {
        let known = run.accuracy.column(name).map_or(String::new(), |column| sure(column, value, unit(name)));
        format!("  {name:width$} {:>14} {}{known}", rounded(value), unit(name))
    }));
    if let Some(value) = energy_imbalance(&run.trajectory) {
        let kinetic = largest_of(&run.trajectory, "energy.kinetic").unwrap_or(f64::NAN);
        lines.push(format!(
            "largest energy imbalance {value:.1e} J, kinetic energy up to {kinetic:.1e} J (a small imbalance says nothing of the \
             accuracy in time and space)"
        ));
    }
    if !run.accuracy.columns.is_empty() {
        lines.push(
            "± is the largest error anywhere in the run; the `mean` of a probe over a longer window has a smaller one"
                .into(),
        );
    }
    for (of, estimate) in [("step", &run.accuracy.time), ("mesh", &run.accuracy.space)] {
        if let Some(estimate) = estimate {
            lines.push(format!("estimated error of the {of} {:.1e} m ({})", estimate.value, estimate.method));
        }
    }
    lines.extend(run.warnings.iter().map(|warning| format!("warning: {warning}")));
    lines.retain(|line| !line.is_empty());
    lines.join("\n") + "\n"
}

/// What is computed for a scene and what is left out, a line for each part, and its size. Ends with a newline.
pub fn plan_text(scene: &Scene) -> String {
    let parts = Plan::of(scene).parts(scene);
    let width = parts.iter().map(|part| part.what.chars().count()).max().unwrap_or(0);
    let line = |part: &Part| {
        let verb = if part.computed { "computed" } else { "left out" };
        format!("{verb}  {:width$}  {}", part.what, part.why)
    };
    let elements: usize = scene.rods.iter().map(|rod| rod.elements).sum();
    let (rods, method) = (scene.rods.len(), scene.time.method);
    let mut lines = vec![scene.title.clone(), format!("{method}; rods: {rods}, elements: {elements}")];
    let mut sections: Vec<&Section> = scene.rods.iter().map(|rod| scene.section(rod)).collect();
    sections.dedup();
    lines.extend(sections.iter().map(|section| {
        let [height, width] = [section.height, section.width].map(rounded);
        format!(
            "section: {height} m high, {width} m wide, A = {:.4e} m², I = {:.4e} m⁴",
            section.area(),
            section.inertia()
        )
    }));
    lines.extend(parts.iter().map(line));
    lines.push("`ancf error-time` measures what this saves".into());
    lines.retain(|line| !line.is_empty());
    lines.join("\n") + "\n"
}

/// Number with six significant digits, however small or large it is.
fn rounded(value: f64) -> String {
    let exponent = value.abs().log10().floor();
    if value == 0.0 {
        "0".into()
    } else if (-4.0..6.0).contains(&exponent) {
        format!("{value:.*}", (5.0 - exponent) as usize)
    } else {
        format!("{value:.5e}")
    }
}

/// How far a final value of a column is sure, in words.
fn sure(column: &ColumnAccuracy, value: f64, unit: &str) -> String {
    match (column.convergence, column.sure_digits(value)) {
        (Convergence::None, _) => {
            format!(" does not converge: finer runs change it by {:.0e} {unit} and no less", column.total())
        }
        (Convergence::Sure, digits @ 1..) => {
            let plural = if digits == 1 { "" } else { "s" };
            format!(" ± {:.1e}, {digits} reliable digit{plural}", column.total())
        }
        _ => format!(" ± {:.1e}, no reliable digit", column.total()),
    }
}

/// Unit of a probe's column.
fn unit(column: &str) -> &'static str {
    Reading::of(column).unit
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use ancf::integrators::Counts;
    use ancf::run::{Accuracy, Trajectory};

    /// Numbers whose shortest decimal form is easy to get wrong.
    pub const AWKWARD: [f64; 6] = [0.1, -1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.12345679, -0.0];

    pub fn run() -> (Scene, Run) {
        let scene = Scene::builtin("pendulum-flexible").unwrap();
        let mut rows = vec![vec![0.0; 10], AWKWARD.iter().chain(&[0.0; 4]).copied().collect()];
        (rows[0][5], rows[0][9]) = (2.0, -3e-7);
        rows[1][9] = 2e-7;
        let trajectory = Trajectory { columns: scene.columns(), rows: rows.into_iter().collect() };
        let counts = Counts {
            steps: 1,
            rejected: 0,
            newton_iterations: 2,
            force_calls: 3,
            tangent_calls: 4,
            factorizations: 5,
            solves: 6,
        };
        let (warnings, accuracy) = (vec!["mind the gap".into()], Accuracy::default());
        (scene, Run { trajectory, counts, warnings, unstable_directions: 0, accuracy })
    }

    #[test]
    fn csv_reads_back_to_the_same_numbers() {
        let (scene, run) = run();
        let mut csv = Vec::new();
        run.trajectory.write_csv(&mut csv).unwrap();
        let csv = String::from_utf8(csv).unwrap();
        let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(lines[0], scene.columns());
        assert_eq!(lines.len(), 3);
        let bits = |row: &[f64]| row.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        for (line, row) in lines[1..].iter().zip(&run.trajectory.rows) {
            let read: Vec<f64> = line.iter().map(|number| number.parse().unwrap()).collect();
            assert_eq!(bits(&read), bits(row));
        }
    }

    #[test]
    fn a_balance_that_is_not_a_number_is_not_lost() {
        let (_, mut run) = run();
        run.trajectory.rows[0][9] = -f64::NAN;
        assert!(energy_imbalance(&run.trajectory).unwrap().is_nan());
    }

    #[test]
    fn text_for_a_person() {
        let (mut scene, run) = run();
        scene.title = "a pendulum".into();
        let text = "a pendulum\n\
            energy-momentum: 1 steps, 2 Newton iterations, 0.250 s\n\
            at t = 0.1 s:\n";
        let all = run_text(&scene, &run, 0.25);
        assert!(all.starts_with(text), "{all}");
        assert!(all.contains("tip.x") && all.contains(" -0.333333 m\n"), "{all}");
        let end = "imbalance 3.0e-7 J, kinetic energy up to 2.0e0 J (a small imbalance says nothing of the accuracy in time and \
                   space)\nwarning: mind the gap\n";
        assert!(all.ends_with(end), "{all}");
    }
}
