//! Motions of another program against those of the fixtures: `ancf conform --trajectory FILE… --scene ID`.
//!
//! [`compare`] reads one file, or two with different steps, and judges in this order: what is there at t = 0; the first sample that
//! differs; the order that two steps show, and whether their limit is the reference; energies. What its step does not explain is
//! matched with mistakes made on purpose, each moved by a second program within this module.

// Layers, from top to bottom; a module imports only from modules further down this list:
// compare, judgement, advice, order, start, energies, comparison, expected, matching, mistakes, mistake, mass, outcome, run, sampling,
// file, csv, json, column, written, reference, motion, rods, constraint, body, rod, element, section_point, stiffness, setup, gauss, frames.
mod advice;
mod body;
mod column;
mod compare;
mod comparison;
mod constraint;
mod csv;
mod element;
mod energies;
mod expected;
mod file;
mod frames;
mod gauss;
mod json;
mod judgement;
mod mass;
mod matching;
mod mistake;
mod mistakes;
mod motion;
mod order;
mod outcome;
mod reference;
mod rod;
mod rods;
mod run;
mod sampling;
mod section_point;
mod setup;
mod start;
mod stiffness;
mod written;

pub use compare::{Request, compare};
pub use frames::{Frames, Path};
pub use outcome::{Difference, EnergyResult, FileResult, Named, OrderResult, Outcome, OwnError, StartResult, Verdict};
pub use reference::{Reference, reference, references};

#[cfg(test)]
mod tests {
    use super::frames::{distance, largest_difference};
    use super::motion::{Method, frames, initial_acceleration};
    use super::reference::references;
    use super::rods::Rods;
    use super::setup::Setup;

    #[test]
    fn rods_without_a_mistake_move_as_the_fixtures_say() {
        for reference in references().unwrap().iter().filter(|reference| !reference.is_solid) {
            let rods = Rods::new(&Setup::of(reference.scene.clone())).unwrap();
            let clock = std::time::Instant::now();
            let ours = frames(&rods, Method::Fine, &reference.frames.t, |_| false);
            let seconds = clock.elapsed().as_secs_f64();
            let position = distance(&reference.frames.position, &ours.position);
            let energy = |name: &&str| largest_difference(&reference.frames.energy[*name], &ours.energy[*name]);
            let energies: Vec<f64> = ["kinetic", "strain", "potential"].iter().map(energy).collect();
            println!("{:16} {position:.1e} m  {energies:?} J  {seconds:.2} s", reference.id);
            let sudden = reference.id.contains("sudden");
            assert!(position < if sudden { 2e-4 } else { 2e-6 }, "{}: {position:.1e} m", reference.id);
            if let (Some(nodal), Some(acceleration)) = (&reference.nodal, &reference.acceleration) {
                let a = initial_acceleration(&rods);
                let scale = acceleration.iter().fold(1.0, |scale: f64, a| scale.max(a.abs()));
                assert!(largest_difference(nodal, rods.start.as_slice()) < 1e-14);
                let apart = largest_difference(acceleration, a.as_slice()) / scale;
                // Of a relaxed start only the rounding of large thermal forces is left beside the weight.
                assert!(apart < 1e-7, "{}: {apart:.1e} of the largest", reference.id);
            }
        }
    }
}
