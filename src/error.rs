//! The crate's errors: each carries the numbers and names that a person needs to mend the fault.
//!
//! The text of an error says what to do next. Times are printed without rounding noise: 0.3 s, not 0.30000000000000004
//! s.

use std::convert::Infallible;
use std::path::PathBuf;

/// [`std::result::Result`] with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Any failure between a scene file and its output files.
///
/// ```
/// use ancf::{error::Error, model::Model};
///
/// match Model::load("pendulum-flexibel") {
///     Err(Error::Read { path, source }) => {
///         assert_eq!(path.to_str(), Some("pendulum-flexibel"));
///         assert!(source.to_string().contains("nearest is `pendulum-flexible`"));
///     }
///     other => panic!("{other:?}"),
/// }
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A value of the scene is not allowed.
    #[error("{file}: `{key}` is {value}; allowed: {allowed}")]
    Scene {
        /// File of the scene, or name of a built-in scene; followed by line and column of the value in a file
        /// (`pendulum.json:4:21`).
        file: String,
        /// Path of the key, such as `material.E` or `rods[0].from`.
        key: String,
        /// Offending value, as it was written.
        value: String,
        /// Values that would have been accepted.
        allowed: String,
    },
    /// The explicit step exceeds the method's stability limit.
    #[error(
        "`time.step` is {step:e}; allowed: at most {largest:.6e} s for the method \"{method}\" \
         ({limit} / largest frequency, {frequency:.6e} rad/s)"
    )]
    StepTooLarge {
        /// Name of the method.
        method: String,
        /// Requested step, s.
        step: f64,
        /// Largest stable step, s.
        largest: f64,
        /// Upper bound of the structure's largest angular frequency, rad/s.
        frequency: f64,
        /// Stability limit of the method: largest product of step and angular frequency.
        limit: f64,
    },
    /// Newton's iteration did not reach its tolerance.
    #[error(
        "Newton's iteration did not converge at t = {} s: residual {residual:.3e} of the largest \
         force term after {iterations} iterations (tolerance {tolerance:.1e}); {}",
        time_text(*time),
        newton_advice(*residual, *at_rounding, *shared_tangent)
    )]
    NewtonFailed {
        /// Time at the end of the failed step, s.
        time: f64,
        /// Number of iterations.
        iterations: usize,
        /// Last residual, relative to the largest force term.
        residual: f64,
        /// Required residual, relative to the largest force term.
        tolerance: f64,
        /// Whether the residual is at the level of rounding errors of the elastic forces, which a smaller step does not
        /// reduce.
        at_rounding: bool,
        /// Whether one tangent serves both stages of the method, which converges only while they are alike.
        shared_tangent: bool,
    },
    /// Statics cannot follow the equilibria.
    #[error(
        "the equilibria cannot be followed beyond {} of the load: {reason}; {advice}",
        time_text(*factor)
    )]
    NoEquilibrium {
        /// Load factor of the last equilibrium.
        factor: f64,
        /// Cause: iterations and residual, the place where the tangent is singular, or a jump to other equilibria.
        reason: String,
        /// What to do next.
        advice: &'static str,
    },
    /// A matrix to be factorised is singular.
    #[error(
        "the matrix is singular at t = {} s, iteration {iteration}, at {place}: a part of the structure is not \
         held, rods are stretched out in a singular position, or a step is far too large",
        time_text(*time)
    )]
    Singular {
        /// Time, s.
        time: f64,
        /// Newton's iteration, 0 for the mass matrix.
        iteration: usize,
        /// Location of the vanishing pivot in the structure, in words.
        place: String,
    },
    /// Statics of a mechanism: the structure can move without strain.
    #[error(
        "statics has no solution: the structure can move without a strain (to first order): rods {rods}; allowed: \
         `supports` and pins that hold every rod"
    )]
    Drifts {
        /// Names of the moving rods, or the first few.
        rods: String,
    },
    /// The structure's matrices exceed the memory limit.
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
    /// The system does not give the memory that a run needs.
    #[error("{what} take {gigabytes:.3} GB, which the system does not give; allowed: {allowed}")]
    OutOfMemory {
        /// What takes the memory, in words.
        what: String,
        /// Memory, GB.
        gigabytes: f64,
        /// What would take less.
        allowed: String,
    },
    /// The method has created energy.
    #[error(
        "at t = {} s, step {step}, the energy has grown by {created:.3e} J more than the {supply:.3e} J that loads and heat put in: {cause}; \
         {cure}",
        time_text(*time)
    )]
    EnergyAppeared {
        /// Time, s.
        time: f64,
        /// Number of the step.
        step: usize,
        /// Energy beyond the supply, J.
        created: f64,
        /// Upper bound of the energy that forces, heat and weight have put in, J.
        supply: f64,
        /// Probable cause.
        cause: String,
        /// Advice for this method.
        cure: String,
    },
    /// An element has collapsed or turned inside out (det J ≤ 0).
    #[error(
        "element {element} of {elements} of the rod `{rod}` has collapsed at {}: it is \
         compressed to nothing, or turned inside out, at a quadrature point (det J ≤ 0); the loads or the heat are too large for it{}",
        instant(*time, *statics),
        if *statics { "" } else { COLLAPSE_ADVICE }
    )]
    Collapsed {
        /// Name of the rod.
        rod: String,
        /// Number of the element, from 1.
        element: usize,
        /// Number of elements of the rod.
        elements: usize,
        /// Time, s; the load factor in statics.
        time: f64,
        /// Whether the run is static, so that `time` is a load factor.
        statics: bool,
    },
    /// Rounding errors are as large as the result.
    #[error(
        "at {} rounding errors of the elastic forces may be {share:.1e} of the {of}: the \
         structure is too stiff, or too slender, for numbers of 16 digits; a smaller `E` or a higher section helps, or fewer elements",
        instant(*time, *statics)
    )]
    LostInRounding {
        /// Time, s; the load factor in statics.
        time: f64,
        /// Rounding error relative to the quantity `of`.
        share: f64,
        /// Quantity that the rounding error is compared with.
        of: &'static str,
        /// Whether the run is static, so that `time` is a load factor.
        statics: bool,
    },
    /// The estimated error of a run exceeds a tenth of the motion.
    #[error(
        "the {place} is off by an estimated {time:.1e} m for the step and {space:.1e} m for the mesh, together more than a \
         tenth of the motion of {moved:.1e} m, so that not even the first digit is sure; shorter steps help (`time.step`, \
         `time.tolerance` of adaptive methods, more `time.load_steps` in statics), or more `elements`, or a `history` for sudden loads"
    )]
    Inaccurate {
        /// Position or deflection with the worst error, in words.
        place: String,
        /// Estimated error due to the step, m.
        time: f64,
        /// Estimated error due to the mesh, m.
        space: f64,
        /// Motion that the error is compared with, m.
        moved: f64,
    },
    /// A refined run needed for the error estimate failed.
    #[error("the error cannot be estimated, as the run with {what} fails: {reason}")]
    NoEstimate {
        /// Refinement of that run, in words.
        what: String,
        /// Error text of that run.
        reason: String,
    },
    /// The equilibrium is unstable, so that its error cannot be estimated.
    #[error(
        "the error cannot be estimated, as an equilibrium on the way is unstable, in {directions} direction(s): other equilibria are \
         near, and the one that a finer run finds says nothing about this one; an `imperfection` or a small force across leads to the stable one"
    )]
    Unstable {
        /// Number of independent unstable directions, in this run or a refined one.
        directions: usize,
    },
    /// A small deviation at the start decides the motion.
    #[error(
        "the motion is unstable, so that its error cannot be estimated: a deviation of {deviation:.0e} m at the start grows \
         {amplification:.0e} times and moves {place} by {moved:.1e}, more than the {error:.1e} that its error may be; rounding \
         decides where such a structure goes, as where a straight rod buckles; an `imperfection` or a small force across decides it"
    )]
    UnstableMotion {
        /// Deviation at the start, m.
        deviation: f64,
        /// Growth of the deviation.
        amplification: f64,
        /// Quantity or column that moves too far.
        place: String,
        /// Change of the quantity, in its unit.
        moved: f64,
        /// Its estimated error, or a tenth of its motion, in its unit.
        error: f64,
    },
    /// An adaptive method has reached its shortest step.
    #[error(
        "at t = {} s the step would have to be shorter than {step:.1e} s: estimated error {error:.1e} m, tolerance \
         {tolerance:.1e} m; a larger `time.tolerance` helps, or a `history` where a force or heat comes suddenly",
        time_text(*time)
    )]
    StepTooSmall {
        /// Time at the start of the step, s.
        time: f64,
        /// Length of the step, s.
        step: f64,
        /// Estimated error of the step, m; infinite where the step could not be made.
        error: f64,
        /// Largest allowed error, m.
        tolerance: f64,
    },
    /// A quantity is infinite or not a number.
    #[error("{quantity} is no longer finite at t = {} s, step {step}; shorter steps help", time_text(*time))]
    NotFinite {
        /// Name of the quantity.
        quantity: &'static str,
        /// Time, s.
        time: f64,
        /// Number of the step.
        step: usize,
    },
    /// The requested time is not the end of a step.
    #[error("no step ends at {}; allowed: {allowed}", instant(*time, *statics))]
    NotATime {
        /// Requested time, s.
        time: f64,
        /// Times that can be reached, in words.
        allowed: String,
        /// Whether the time is the load factor of statics.
        statics: bool,
    },
    /// The simulation has failed before.
    #[error("the simulation has failed at t = {} s, so that its state is meaningless; allowed: a new one", time_text(*time))]
    HasFailed {
        /// Time where it failed, s.
        time: f64,
    },
    /// The model has no item of this name.
    #[error("there is no {what} `{name}`{nearest}")]
    Unknown {
        /// Kind of item: a point or a rod.
        what: &'static str,
        /// Name asked for.
        name: String,
        /// Nearest known name, in words; empty if none is similar.
        nearest: String,
    },
    /// A file cannot be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// Path of the file.
        path: PathBuf,
        /// Reason given by the system.
        source: std::io::Error,
    },
}

impl Error {
    /// Whether the input is at fault, not the run.
    pub fn is_bad_input(&self) -> bool {
        matches!(
            self,
            Error::Scene { .. }
                | Error::StepTooLarge { .. }
                | Error::Drifts { .. }
                | Error::TooLarge { .. }
                | Error::OutOfMemory { .. }
                | Error::NotATime { .. }
                | Error::Unknown { .. }
                | Error::Read { .. }
        )
    }
}

impl From<Infallible> for Error {
    /// Never called: converting a [`Model`](crate::model::Model) to itself cannot fail.
    fn from(never: Infallible) -> Error {
        match never {}
    }
}

/// Time rounded to 12 significant digits: 0.3 for 0.30000000000000004.
fn round_time(time: f64) -> f64 {
    format!("{time:.11e}").parse().unwrap_or(time)
}

/// Time as text, rounded; with an exponent below 10⁻⁹ and above 10⁹.
pub(crate) fn time_text(time: f64) -> String {
    let time = round_time(time);
    if time == 0.0 || (1e-9..=1e9).contains(&time.abs()) { format!("{time}") } else { format!("{time:e}") }
}

/// Time, or load factor of statics, in words.
fn instant(time: f64, statics: bool) -> String {
    let time = time_text(time);
    if statics { format!("{time} of the load") } else { format!("t = {time} s") }
}

/// Advice for a collapse in motion. A sudden load may collapse an element within one step, where shorter steps would
/// not.
const COLLAPSE_ADVICE: &str = ", or come too suddenly for the step: a `history` that lets them grow helps, or a smaller `time.step`, or \
     `time.tolerance` for adaptive methods";

/// Advice for an iteration that does not converge.
fn newton_advice(residual: f64, at_rounding: bool, shared_tangent: bool) -> &'static str {
    if !residual.is_finite() {
        "numbers have left their range: a load, `E` or `rho` is far too large or too small, or a step too long"
    } else if at_rounding {
        "it has stopped at rounding errors of the elastic forces, since `E` is large compared with the loads: a larger `time.newton_tolerance` helps, \
         or fewer elements"
    } else if shared_tangent {
        "one tangent serves both stages of \"gauss\", which are too different where stiff rods turn or bend far in a step; \
         \"energy-momentum\" helps, and a much smaller `time.step`"
    } else {
        "a smaller `time.step` helps, and for sudden heat or forces a `history` that lets them grow, or \"explicit\", which does \
         not iterate"
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
        assert_eq!(round_time(123.456_789_012_3), 123.456_789_012);
        assert_eq!(round_time(1e-7), 1e-7);
        assert!(round_time(f64::NAN).is_nan());
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
            assert_eq!(time_text(time), text);
        }
    }

    /// A sudden load can collapse an element within one long step, although it would not in reality.
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
        assert!(message(true).ends_with("too large for it"), "{}", message(true));
    }
}
