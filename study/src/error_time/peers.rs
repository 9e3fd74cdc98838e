//! The other program's points: its runs, with their distances from the limit of its own theory.

use super::benchmark::Benchmark;
use super::peer::{Answer, Motion, Offer, Peer};
use super::point::{Point, Status};
use super::reference::{Limit, Reference};
use super::samples::Samples;
use super::timing::Timing;
use super::trace::Trace;
use crate::error::Result;
use crate::escape;
use ancf::integrators::Counts;

/// A run of the other program.
#[derive(Clone, Debug, PartialEq)]
pub struct PeerPoint {
    /// Its number, to make it again.
    pub id: usize,
    /// The point.
    pub point: Point,
}

/// An element of the other program with what it converges to.
struct Theory {
    element: String,
    /// `None`: our Euler–Bernoulli element's.
    own: Option<(Samples, f64)>,
}

/// All points of a scene. `euler_bernoulli` is the reference of our Euler–Bernoulli element, which some of its elements share.
///
/// # Errors
/// [`Error::Peer`](crate::error::Error::Peer). A run that fails is a point.
pub fn points(
    peer: &mut Peer,
    benchmark: &Benchmark,
    euler_bernoulli: &Reference,
    quick: bool,
) -> Result<Vec<PeerPoint>> {
    let (times, mut theories, mut points) = (benchmark.times(), Vec::<Theory>::new(), Vec::new());
    for offer in peer.offers(benchmark.scene, quick)? {
        if !theories.iter().any(|theory| theory.element == offer.element) {
            let limit = peer.limit(benchmark.scene, &offer.element, &times)?;
            let own = limit.position.map(|position| (Samples { position, ..Samples::default() }, limit.uncertainty));
            theories.push(Theory { element: offer.element.clone(), own });
        }
        let own = theories.iter().find(|theory| theory.element == offer.element).and_then(|theory| theory.own.as_ref());
        let limit = match own {
            Some((solution, uncertainty)) => Limit { solution, uncertainty: *uncertainty, mesh: None },
            // Its meshes are ours, too.
            None => Limit { mesh: euler_bernoulli.mesh(offer.elements), ..euler_bernoulli.limit() },
        };
        points.push(point(peer, benchmark, offer, own.is_some(), &limit, &times)?);
    }
    Ok(points)
}

fn point(
    peer: &mut Peer,
    benchmark: &Benchmark,
    offer: Offer,
    has_shear: bool,
    limit: &Limit,
    times: &[f64],
) -> Result<PeerPoint> {
    let Offer { id, element, method, elements, step, newton_tolerance, options } = offer;
    let mut point = Point {
        program: peer.name.clone(),
        scene: benchmark.scene.into(),
        element: escape::line(&element),
        method: escape::line(&method),
        explicit: newton_tolerance.is_none(),
        elements,
        step: Some(step),
        newton_tolerance,
        options: escape::line(&options),
        // An element without shear has the limit of ours.
        has_shear,
        reference_uncertainty: limit.uncertainty,
        ..Point::default()
    };
    match peer.run(id, true)? {
        Answer::Failed { failed } => point.reason = escape::line(&failed),
        Answer::Done { steps, newton_iterations, jacobians, motion, .. } => {
            point.counts = Counts { steps, newton_iterations, tangent_calls: jacobians, ..Counts::default() };
            let trace = motion.map_or_else(Trace::default, trace);
            point.compare(&trace.at(times), trace.interpolation_error(), limit);
        }
    }
    if point.status != Status::Failed
        && let Answer::Done { lap, .. } = peer.run(id, false)?
    {
        point.time = Timing::of(&[lap.computed]);
    }
    Ok(PeerPoint { id, point })
}

fn trace(motion: Motion) -> Trace {
    let pair = |a: Vec<f64>, b: Vec<f64>| a.into_iter().zip(b).map(|(a, b)| [a, b]).collect();
    Trace { position: pair(motion.x, motion.y), velocity: pair(motion.vx, motion.vy), t: motion.t }
}
