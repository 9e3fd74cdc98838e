//! What can go wrong, with the numbers and names that a person needs to mend it.

use std::convert::Infallible;
use std::path::PathBuf;

/// Result with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Everything that can go wrong between a scene file and its output files.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The scene file holds something that is not allowed there.
    #[error("{file}: `{key}` is {value}; allowed: {allowed}")]
    Scene {
        /// File the scene was read from, or the name of a built-in scene; with line and column where the value stands
        /// in a file (`pendulum.json:4:21`).
        file: String,
        /// Path of the key inside the scene, such as `material.E` or `rods[0].from`.
        key: String,
        /// The offending value as it was written.
        value: String,
        /// What would have been accepted.
        allowed: String,
    },
    /// An explicit step is longer than the method's stability limit.
    #[error(
        "`time.step` is {step:e}; allowed: at most {largest:.6e} s for the method \"{method}\" \
         ({limit} / largest frequency, {frequency:.6e} rad/s)"
    )]
    StepTooLarge {
        /// The method's name.
        method: String,
        /// Step asked for, s.
        step: f64,
        /// Largest stable step, s.
        largest: f64,
        /// Upper bound of the structure's largest angular frequency, rad/s.
        frequency: f64,
        /// Largest product of step and frequency at which the method is stable.
        limit: f64,
    },
    /// Newton's iteration stopped short of its tolerance.
    #[error(
        "Newton's iteration did not converge at t = {} s: residual {residual:.3e} of the largest \
         force term after {iterations} iterations (tolerance {tolerance:.1e}); {}",
        written(*time),
        cure_of_iteration(*residual, *at_rounding)
    )]
    NewtonFailed {
        /// Time at the end of the failed step, s.
        time: f64,
        /// Iterations made.
        iterations: usize,
        /// Last residual, relative to the largest force term.
        residual: f64,
        /// Tolerance it had to reach.
        tolerance: f64,
        /// Whether the residual is of the order of rounding errors of the elastic forces, which no step makes less.
        at_rounding: bool,
    },
    /// Statics did not find an equilibrium.
    #[error(
        "no equilibrium was found at {} of the load: {reason}; more `time.load_steps` help, or more `elements` where rods \
         bend far, unless the structure buckles there",
        written(*factor)
    )]
    NoEquilibrium {
        /// Load factor at the end of the failed step, 0 … 1.
        factor: f64,
        /// Iterations and residual, or where the tangent is singular.
        reason: String,
    },
    /// A matrix that has to be inverted is singular.
    #[error(
        "the matrix is singular at t = {} s, iteration {iteration}, at {place}: a part of the structure is not \
         held, rods are stretched out in a singular position, or a step is far too large",
        written(*time)
    )]
    Singular {
        /// Time, s.
        time: f64,
        /// Newton's iteration, 0 for the mass matrix.
        iteration: usize,
        /// Where in the structure the vanishing pivot is.
        place: String,
    },
    /// Statics of a structure that can move without a strain.
    #[error(
        "statics has no answer: the structure can move without a strain (to first order), rods {rods}; allowed: \
         `supports` and pins that hold every rod"
    )]
    Drifts {
        /// The rods that move, or the first of them.
        rods: String,
    },
    /// A structure's matrices would not fit into memory.
    #[error(
        "the scene has {unknowns} unknowns in a band of {band}, for which a matrix takes {gigabytes:.1} GB; allowed: \
         2 GB, so fewer `elements`, or fewer rods at one point"
    )]
    TooLarge {
        /// Number of unknowns.
        unknowns: usize,
        /// Half-width of the band.
        band: usize,
        /// Memory of one matrix, GB.
        gigabytes: f64,
    },
    /// A method has created energy.
    #[error(
        "at t = {} s, step {step}, there are {created:.3e} J more than the {supply:.3e} J that were put in: the step is \
         far too long for a sudden load; {cure}",
        written(*time)
    )]
    EnergyAppeared {
        /// Time, s.
        time: f64,
        /// Number of the step.
        step: usize,
        /// Energy that nothing put in, J.
        created: f64,
        /// What forces, heat and weights have put in at most, J.
        supply: f64,
        /// What helps.
        cure: String,
    },
    /// Nothing is left of an element, or it has turned inside out.
    #[error(
        "element {element} of {elements} of the rod `{rod}` has collapsed at {}: it is \
         pressed to nothing, or inside out, at a quadrature point (det J ≤ 0); the loads or the heat are too large for it, {}",
        when(*time, *statics),
        if *statics { "or the steps too long" } else { CURE_OF_COLLAPSE }
    )]
    Collapsed {
        /// Name of the rod.
        rod: String,
        /// Number of the element, from 1.
        element: usize,
        /// Elements of the rod.
        elements: usize,
        /// Time, s; the load factor in statics.
        time: f64,
        /// Whether it is statics.
        statics: bool,
    },
    /// Rounding errors are as large as what is computed.
    #[error(
        "at {} rounding errors of the elastic forces may be {share:.1e} of the {of}: the \
         structure is too stiff, or too slender, for numbers of 16 digits; a smaller `E` or a higher section helps, or fewer elements",
        when(*time, *statics)
    )]
    LostInRounding {
        /// Time, s; the load factor in statics.
        time: f64,
        /// Rounding over what is computed.
        share: f64,
        /// What that is.
        of: &'static str,
        /// Whether it is statics.
        statics: bool,
    },
    /// The estimated error of a run leaves no digit of it sure.
    #[error(
        "the {place} is off by an estimated {time:.1e} m for the step and {space:.1e} m for the mesh, together more than a \
         tenth of the motion of {moved:.1e} m, so that not even the first digit is sure; a smaller `time.step` or \
         `time.tolerance`, more `elements`, or a `history` for what comes suddenly help"
    )]
    Inaccurate {
        /// What is off most, in words.
        place: String,
        /// The step's part, m.
        time: f64,
        /// The mesh's part, m.
        space: f64,
        /// The motion beside which it is judged, m.
        moved: f64,
    },
    /// A run from which an error would have been estimated failed.
    #[error("the error cannot be estimated, as the run with {what} fails: {reason}")]
    NoEstimate {
        /// What is finer in it.
        what: String,
        /// Its error.
        reason: String,
    },
    /// An error would have been estimated of an equilibrium that is one of many.
    #[error(
        "the error cannot be estimated, as the equilibrium found is unstable, in {directions} direction(s): others are near, and which of \
         them a finer run finds says nothing of this one; a small force across leads to the one where the structure stays"
    )]
    Unstable {
        /// Independent directions in which it is, in this run or a finer one.
        directions: usize,
    },
    /// An adaptive method has come to its shortest step.
    #[error(
        "at t = {} s the step would have to be shorter than {step:.1e} s: estimated error {error:.1e} m, tolerance \
         {tolerance:.1e} m; a larger `time.tolerance` helps, or a `history` where a force or heat comes suddenly",
        written(*time)
    )]
    StepTooSmall {
        /// Time at the start of the step, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// Its estimated error, m; infinite where it could not be made.
        error: f64,
        /// What the estimate may be, m.
        tolerance: f64,
    },
    /// A quantity stopped being a finite number.
    #[error("{quantity} is no longer finite at t = {} s, step {step}; a smaller `time.step` helps", written(*time))]
    NotFinite {
        /// What it was.
        quantity: &'static str,
        /// Time, s.
        time: f64,
        /// Number of the step.
        step: usize,
    },
    /// A time to which the steps of a method do not lead.
    #[error("no step ends at t = {} s; allowed: {allowed}", written(*time))]
    NotATime {
        /// The time that was asked for, s.
        time: f64,
        /// Times that steps lead to.
        allowed: String,
    },
    /// A name that the model does not have.
    #[error("there is no {what} `{name}`{nearest}")]
    Unknown {
        /// What the name should be of.
        what: &'static str,
        /// The name.
        name: String,
        /// The known name that is most like it, in words.
        nearest: String,
    },
    /// A file could not be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl Error {
    /// Whether the scene is to blame, and not the run.
    pub fn is_bad_input(&self) -> bool {
        matches!(
            self,
            Error::Scene { .. }
                | Error::StepTooLarge { .. }
                | Error::Drifts { .. }
                | Error::TooLarge { .. }
                | Error::NotATime { .. }
                | Error::Unknown { .. }
                | Error::Read { .. }
        )
    }
}

impl From<Infallible> for Error {
    /// What is a model already needs no check.
    fn from(never: Infallible) -> Error {
        match never {}
    }
}

/// A time without the digits that only rounding has written: 0.3 for 0.30000000000000004.
fn rounded(time: f64) -> f64 {
    format!("{time:.11e}").parse().unwrap_or(time)
}

/// The same in text; with an exponent where there would be a row of zeros.
pub(crate) fn written(time: f64) -> String {
    let time = rounded(time);
    if time == 0.0 || (1e-9..=1e9).contains(&time.abs()) { format!("{time}") } else { format!("{time:e}") }
}

/// A time, or the load factor of statics, in words.
fn when(time: f64, statics: bool) -> String {
    let time = written(time);
    if statics { format!("{time} of the load") } else { format!("t = {time} s") }
}

/// What helps where an element collapses in motion. What comes suddenly may drive it there within one step, where shorter ones would not.
const CURE_OF_COLLAPSE: &str = "or come too suddenly for the step: a `history` that lets them grow helps, or a smaller `time.step`, or \
     `time.tolerance` for adaptive methods";

/// What helps where an iteration does not converge.
fn cure_of_iteration(residual: f64, at_rounding: bool) -> &'static str {
    if !residual.is_finite() {
        "numbers have left their range: a load, `E` or `rho` is far too large or too small, or a step too long"
    } else if at_rounding {
        "it has stopped at rounding errors of the elastic forces, as `E` is large beside the loads: a larger `time.newton_tolerance` helps, \
         or fewer elements"
    } else {
        "a smaller `time.step` helps, and where heat or a force comes suddenly a `history` that lets it grow, or \"explicit\", which \
         iterates nothing"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_written_without_rounding() {
        let collapsed = |time, statics| {
            let rod = "rod".into();
            Error::Collapsed { rod, element: 1, elements: 2, time, statics }.to_string()
        };
        assert!(
            collapsed(3.0 * 0.1, false).contains("has collapsed at t = 0.3 s: "),
            "{}",
            collapsed(3.0 * 0.1, false)
        );
        assert!(collapsed(0.7 + 0.1, true).contains("has collapsed at 0.8 of the load: "));
        assert_eq!(rounded(123.456_789_012_3), 123.456_789_012);
        assert_eq!(rounded(1e-7), 1e-7);
        assert!(rounded(f64::NAN).is_nan());
        for (time, text) in [
            (1e-303, "1e-303"),
            (3e-10, "3e-10"),
            (2e9, "2e9"),
            (1e-9, "0.000000001"),
            (0.0, "0"),
            (-0.5, "-0.5"),
            (1e9, "1000000000"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(written(time), text);
        }
    }

    /// What comes suddenly collapses in a step what it would not in truth.
    #[test]
    fn a_collapse_in_motion_tells_of_sudden_loads() {
        let message = |statics| {
            let (rod, element, elements, time) = ("rod".into(), 1, 2, 0.5);
            Error::Collapsed { rod, element, elements, time, statics }.to_string()
        };
        let motion = message(false);
        assert!(
            ["suddenly", "`history`", "`time.step`", "`time.tolerance`"].iter().all(|part| motion.contains(part)),
            "{motion}"
        );
        assert!(message(true).ends_with("or the steps too long"), "{}", message(true));
    }
}
