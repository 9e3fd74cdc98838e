//! `error-time.html`: which method to use for which accuracy, in words.

use std::collections::BTreeMap;

use super::Study;
use super::economies::Economy;
use super::group::Group;
use super::point::{Point, Status};
use super::text;
use super::timing::RUNS;
use crate::html::Html;

/// The page with the picture.
pub fn page(study: &Study, svg: &str) -> String {
    let mut html = Html::default();
    html.paragraph(
        "Every point is one run: a scene with one of two elements, a mesh, a method and a step. Its error is the largest \
         distance of the probe from a converged reference at the sample times; its time is what the run takes with nothing \
         recorded but what the error needs.",
    );
    html.paragraph(&format!(
        "Times are medians of {RUNS} runs or more after one that does not count, with the shortest and the longest in brackets; \
         points that the same method betters in four fifths of the time or less (\"outclassed\") were timed once. {}",
        study.machine.line()
    ));
    html.svg(svg);
    which_method(&mut html, study);
    explicit_or_implicit(&mut html, study);
    split(&mut html, study);
    peers(&mut html, study);
    economies(&mut html, study);
    failures(&mut html, study);
    html.heading("The data");
    html.paragraph(
        "error-time.csv has a line for each point, error-time.json the same with references, options and provenance.",
    );
    html.page("Error against run time")
}

fn which_method(html: &mut Html, study: &Study) {
    html.heading("Which method for which accuracy");
    html.paragraph(
        "The fastest point that is proved to be as accurate. A point at the reference's limit counts where its error and the \
         reference's uncertainty together are below the bound.",
    );
    for group in &study.groups {
        html.subheading(&group.name());
        let row = |(error, point): &(f64, Option<&Point>)| {
            let what = point.map_or_else(|| text::nothing(group, *error), Point::what);
            let time = text::timing(point.and_then(|point| point.time.as_ref()));
            let found = point.and_then(Point::error).map_or("–".into(), |error| format!("{error:.1e}"));
            let counts = point.map_or("–".into(), |point| {
                let counts = &point.counts;
                format!(
                    "{}, {}, {}, {}",
                    counts.force_calls, counts.tangent_calls, counts.factorizations, counts.solves
                )
            });
            vec![format!("{error:.0e}"), what, found, time, counts]
        };
        let rows: Vec<Vec<String>> = group.decades().iter().map(row).collect();
        let head = ["error below, m", "fastest", "its error, m", "time", "forces, tangents, factorisations, solves"];
        html.table(&head, &rows);
    }
}

fn explicit_or_implicit(html: &mut Html, study: &Study) {
    let with_explicit: Vec<&Group> =
        study.groups.iter().filter(|group| group.points.iter().any(|point| point.explicit)).collect();
    if with_explicit.is_empty() {
        return;
    }
    html.heading("Explicit or implicit");
    for group in with_explicit {
        html.subheading(&group.name());
        html.list(&text::leads(&group.leads()));
    }
}

fn split(html: &mut Html, study: &Study) {
    html.heading("What the error is made of");
    html.paragraph(
        "Time: distance from the solution that is converged in time on the same mesh. Space: distance of that solution from the \
         reference. Model: distance of the reference from the continuum, which no mesh and no step can mend.",
    );
    let row = |group: &Group| {
        let space = group.space.iter().filter(|(elements, _)| *elements != group.reference.elements);
        let space: Vec<String> = space.map(|(elements, error)| format!("{error:.1e} ({elements})")).collect();
        let model = group.model.as_ref().map_or("not known".into(), |model| {
            format!("{:.1e} ± {:.0e} ({})", model.distance, model.uncertainty, model.continuum)
        });
        let order = group.reference.order.map_or("–".into(), |order| format!("{order:.1}"));
        let uncertainty = format!("{:.1e} ({})", group.reference.uncertainty, group.reference.elements);
        vec![group.name(), space.join(", "), order, uncertainty, model]
    };
    let rows: Vec<Vec<String>> = study.groups.iter().map(row).collect();
    html.table(
        &["scene, element", "space, m (elements)", "last order", "reference ±, m (elements)", "model, m"],
        &rows,
    );
    html.subheading("Along the Pareto fronts");
    let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.1e}"));
    let rows: Vec<Vec<String>> = study
        .groups
        .iter()
        .flat_map(|group| group.front().into_iter().map(move |point| (group, point)))
        .map(|(group, point)| {
            let errors = point.errors.as_ref();
            vec![
                group.name(),
                point.what(),
                text::timing(point.time.as_ref()),
                number(point.error()),
                number(errors.and_then(|errors| errors.time)),
                number(errors.and_then(|errors| errors.space)),
                number(errors.and_then(|errors| errors.velocity)),
                number(errors.and_then(|errors| errors.energy)),
            ]
        })
        .collect();
    let head = ["scene, element", "point", "time", "error, m", "time's, m", "space's, m", "velocity, m/s", "energy, J"];
    html.table(&head, &rows);
    html.paragraph(
        "An error that is well below one of its two parts is luck: mesh and step are off in opposite ways. Velocities are compared \
         where they converge, which they do not after a sudden load; a kept energy balance is no \
         evidence of accuracy. Pins and supports are shared coordinates here, so that there is no constraint residual.",
    );
}

fn peers(html: &mut Html, study: &Study) {
    html.heading("Beside another program");
    html.paragraph(&study.peers);
    let mut rows = Vec::new();
    for group in study.groups.iter().filter(|group| !group.peers.is_empty()) {
        for (error, ours) in group.decades().into_iter().take(PEER_DECADES) {
            let peer = group.peer(error);
            let cell = |point: Option<&Point>| point.map_or("–".into(), Point::what);
            let time = |point: Option<&Point>| text::timing(point.and_then(|point| point.time.as_ref()));
            let ratio = group.ratio(error).map_or("–".into(), |ratio| text::ratio(&ratio));
            rows.push(vec![
                group.name(),
                format!("{error:.0e}"),
                cell(ours),
                time(ours),
                cell(peer),
                time(peer),
                ratio,
            ]);
        }
    }
    if !rows.is_empty() {
        html.paragraph(
            "Errors of the other program and of our Euler–Bernoulli element are distances from the same converged solution, as their \
             theory is the same; those of the paper's element are from its own. The ratio is the \
             other program's median over ours, in brackets its shortest run over our longest and its longest over our shortest.",
        );
        html.table(&["scene, element", "error below, m", "ours", "time", "other", "time", "ratio"], &rows);
    }
}

/// What leaving things out saves.
fn economies(html: &mut Html, study: &Study) {
    html.heading("What is left out, and what that saves");
    html.paragraph(
        "Runs with and without what a scene does not need, in turn; medians with the shortest and the longest. `ancf plan SCENE` \
         says what is left out of a scene, and why.",
    );
    let row = |economy: &Economy| {
        vec![
            economy.what.into(),
            economy.scene.clone(),
            text::timing(Some(&economy.full)),
            text::timing(Some(&economy.pruned)),
            format!("{:.2}", economy.ratio()),
            format!("{:.0e}", economy.difference),
        ]
    };
    let rows: Vec<Vec<String>> = study.economies.iter().map(row).collect();
    html.table(&["left out", "scene", "with it", "without", "ratio", "changes, m"], &rows);
}

/// Decades in which the programs are compared.
const PEER_DECADES: usize = 4;

fn failures(html: &mut Html, study: &Study) {
    let mut reasons: BTreeMap<(String, String), usize> = BTreeMap::new();
    for group in &study.groups {
        for point in group.points.iter().chain(group.own_peers()).filter(|point| point.status == Status::Failed) {
            // Up to the numbers, which differ from run to run.
            let reason = point.reason.split(" at t =").next().unwrap_or_default().to_string();
            *reasons.entry((format!("{}: {}, {}", point.program, group.name(), point.method), reason)).or_default() +=
                1;
        }
    }
    html.heading("Runs that failed");
    if reasons.is_empty() {
        html.paragraph("None.");
        return;
    }
    let rows: Vec<Vec<String>> =
        reasons.into_iter().map(|((what, reason), count)| vec![what, count.to_string(), reason]).collect();
    html.table(&["what", "runs", "reason"], &rows);
}
