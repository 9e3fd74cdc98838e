//! `error-time.html`: the fastest method for each accuracy.

use std::collections::BTreeMap;

use super::group::Group;
use super::point::{Point, Status};
use super::study::ErrorTimeStudy;
use super::tables;
use super::wording::{advice, fastest, leads, ratio, time_of};
use crate::html::Html;
use crate::table::{Table, cells};

/// The page with the picture.
pub fn page(study: &ErrorTimeStudy, svg: &str) -> String {
    let mut html = Html::default();
    html.paragraph(
        "Every point is one run: a scene with one of two elements, a mesh, a method and a step. Its error is the largest distance of the probe \
         from a converged reference at every one of some hundred instants, with what it may be larger in between; where its parts by step and \
         mesh cancel, the larger part. Its time is that of a run that records a few rows.",
    );
    html.paragraph(&format!(
        "Times are those of one core. Finalists took turns, at least seven each, on the same core; brackets: quartiles. A run was made again \
         where another program had used the core meanwhile, or where a fixed piece of work beside it took a tenth longer than usual. A point is \
         outclassed if its method is as accurate in less than four fifths of the time; such points were timed once. {}",
        study.machine.line()
    ));
    html.svg(svg);
    which_method(&mut html, study);
    explicit_or_implicit(&mut html, study);
    parts(&mut html, study);
    peers(&mut html, study);
    if !study.economies.is_empty() {
        economies(&mut html, study);
    }
    failures(&mut html, study);
    html.heading("The data");
    html.paragraph(
        "error-time.csv has a line for each point; error-time.json has the points with references, options and provenance.",
    );
    html.page("Error against run time")
}

fn which_method(html: &mut Html, study: &ErrorTimeStudy) {
    html.heading("Which method for which accuracy");
    html.paragraph(
        "The fastest point that is certain to be below each bound at every time: error, reference's uncertainty and what interpolation between \
         steps may hide, together. For each, the lines of a scene file.",
    );
    for (name, table) in fastest_by_group(study) {
        html.subheading(&name);
        html.table(&table);
    }
    html.subheading("As lines of a scene file");
    html.list(&study.groups.iter().flat_map(advice).collect::<Vec<_>>());
}

/// The fastest point for each bound of the error, of each scene and element.
pub fn fastest_by_group(study: &ErrorTimeStudy) -> impl Iterator<Item = (String, Table)> {
    let columns = "error below, m :.0e | fastest | its error, m :.1e | time | forces, tangents, factorisations, solves";
    study.groups.iter().map(move |group| {
        let cells = |(error, point): (f64, Option<&Point>)| {
            let counts = point.map(|point| {
                let counts = &point.counts;
                let [forces, tangents] = [counts.force_calls, counts.tangent_calls];
                format!("{forces}, {tangents}, {}, {}", counts.factorizations, counts.solves)
            });
            cells![error, fastest(group, error, point), point.and_then(Point::error), time_of(point), counts]
        };
        (group.name(), Table::new(columns, group.decades().into_iter().map(cells)))
    })
}

fn explicit_or_implicit(html: &mut Html, study: &ErrorTimeStudy) {
    let with_explicit = |group: &&Group| group.points.iter().any(|point| point.explicit);
    let mut groups = study.groups.iter().filter(with_explicit).peekable();
    if groups.peek().is_some() {
        html.heading("Explicit or implicit");
    }
    for group in groups {
        html.subheading(&group.name());
        html.list(&leads(&group.leads()));
    }
}

fn parts(html: &mut Html, study: &ErrorTimeStudy) {
    html.heading("Parts of the error");
    html.paragraph(
        "Time: distance from the solution on the same mesh that is converged in time. Space: distance of that solution from the reference. \
         Model: distance of the reference from the continuum, which no mesh and no step reduces.",
    );
    let cells = |group: &Group| {
        let reference = &group.reference;
        let space = group.space.iter().filter(|(elements, _)| *elements != reference.elements);
        let space: Vec<String> = space.map(|(elements, error)| format!("{error:.1e} ({elements})")).collect();
        let model = group.model.as_ref().map_or("not known".into(), |model| {
            format!("{:.1e} ± {:.0e} ({})", model.distance, model.uncertainty, model.continuum)
        });
        let uncertainty = format!("{:.1e} ({})", reference.uncertainty, reference.elements);
        let (velocity, reaction) = (reference.velocity, reference.reaction);
        cells![group.name(), space.join(", "), reference.order, uncertainty, model, velocity, reaction]
    };
    let columns = "scene, element | space, m (elements) | last order :.1 | reference ±, m (elements) | model, m | its velocity ±, m/s :.0e | its reaction ±, N :.0e";
    html.table(&Table::new(columns, study.groups.iter().map(cells)));
    html.subheading("Along the Pareto fronts");
    let columns = "scene, element | point | time | error, m :.1e | in time, m :.1e | in space, m :.1e | velocity, m/s :.1e | reaction, N :.1e | energy, J :.1e";
    let cells = |group: &Group, point: &Point| {
        let part = |of: fn(&super::point::Errors) -> Option<f64>| point.errors.as_ref().and_then(of);
        let (in_time, in_space) = (part(|errors| errors.time), part(|errors| errors.space));
        let (velocity, reaction) = (part(|errors| errors.velocity), part(|errors| errors.reaction));
        let energy = part(|errors| errors.energy);
        let (name, time) = (group.name(), time_of(Some(point)));
        cells![name, point.what(), time, point.error(), in_time, in_space, velocity, reaction, energy]
    };
    let rows = study
        .groups
        .iter()
        .flat_map(|group| group.pareto_front().into_iter().map(|point| cells(group, point)).collect::<Vec<_>>());
    html.table(&Table::new(columns, rows));
    html.paragraph(
        "Velocities and reactions are compared where they converge, which they do not after a sudden load: the reaction at instants that are \
         ends of steps. The references' own: see the last two columns above. A conserved energy is no evidence of accuracy. Pins and supports \
         are shared coordinates here, so that there is no constraint residual.",
    );
}

/// Decades in which the programs are compared.
const PEER_DECADES: usize = 4;

fn peers(html: &mut Html, study: &ErrorTimeStudy) {
    html.heading("Comparison with another program");
    html.paragraph(&study.peer);
    let compared = study.groups.iter().filter(|group| !group.peers.is_empty());
    let rows: Vec<_> = compared
        .flat_map(|group| {
            group.decades().into_iter().take(PEER_DECADES).map(move |(error, ours)| {
                let peer = group.peer(error);
                let ratio = group.ratio(error).map(|found| ratio(&found));
                let (our_run, their_run) = (ours.map(Point::what), peer.map(Point::what));
                let element = peer.map(|peer| peer.element.clone());
                cells![group.name(), error, our_run, time_of(ours), their_run, element, time_of(peer), ratio]
            })
        })
        .collect();
    if !rows.is_empty() {
        html.paragraph(
            "Each element is measured from its own limit. The other program's element without shear has that of our Euler–Bernoulli element, as the \
             theory is the same; beside the paper's element stands its element with shear where there is one, the one without shear elsewhere. \
             Ratio: the other program's median over ours; brackets: its lower quartile over our upper one, and its upper over our lower.",
        );
        let columns = "scene, element | error below, m :.0e | ours | time | other | its element | time | ratio";
        html.table(&Table::new(columns, rows));
    }
}

fn economies(html: &mut Html, study: &ErrorTimeStudy) {
    html.heading("Economies");
    html.paragraph(
        "Run times with and without parts that a scene does not need, in turns; medians with quartiles. Thermal strains, ν and weight are not in \
         the table: left out they save nothing that can be measured. \
         `ancf plan SCENE` lists the parts that a scene leaves out, with the reasons.",
    );
    html.table(&tables::economies(&study.economies));
}

fn failures(html: &mut Html, study: &ErrorTimeStudy) {
    let mut reasons: BTreeMap<(String, &str), usize> = BTreeMap::new();
    for group in &study.groups {
        for point in group.all_points().filter(|point| point.status == Status::Failed) {
            // Without the numbers, which differ from run to run.
            let reason = point.reason.split(" at t =").next().unwrap_or_default();
            *reasons.entry((format!("{}: {}, {}", point.program, group.name(), point.method), reason)).or_default() +=
                1;
        }
    }
    html.heading("Runs that failed");
    if reasons.is_empty() {
        html.paragraph("None.");
        return;
    }
    let rows = reasons.into_iter().map(|((what, reason), count)| cells![what, count, reason]);
    html.table(&Table::new("method | runs :.0 | reason", rows));
}
