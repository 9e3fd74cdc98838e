//! What can go wrong, with the numbers and names that a person needs to mend it.

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
        "Newton's iteration did not converge at t = {time} s: residual {residual:.3e} of the largest \
         force term after {iterations} iterations (tolerance {tolerance:.1e}); a smaller `time.step` helps, and where heat \
         or a force comes suddenly a `history` that lets it grow, \"energy-momentum\" or \"explicit\""
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
    },
    /// Statics did not find an equilibrium.
    #[error(
        "no equilibrium was found at {factor} of the load: {reason}; more `time.load_steps` help, unless the structure \
         buckles there"
    )]
    NoEquilibrium {
        /// Load factor at the end of the failed step, 0 … 1.
        factor: f64,
        /// Iterations and residual, or where the tangent is singular.
        reason: String,
    },
    /// A matrix that has to be inverted is singular.
    #[error(
        "the matrix is singular at t = {time} s, iteration {iteration}, at {place}: a part of the structure is not \
         held, rods are stretched out in a singular position, or a step is far too large"
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
        "at t = {time} s, step {step}, there are {created:.3e} J more than the {supply:.3e} J that were put in: the step is \
         far too long for a sudden load; a smaller `time.step` helps, a `history` that lets it grow, \"energy-momentum\" or \
         \"explicit\""
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
    },
    /// Nothing is left of an element, or it has turned inside out.
    #[error(
        "element {element} of {elements} of the rod `{rod}` has collapsed at t = {time} (s; in statics the load factor): it is \
         pressed to nothing, or inside out, at a quadrature point (det J ≤ 0); the loads or the heat are too large for it, or the \
         steps too long"
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
    },
    /// Rounding errors are as large as what is computed.
    #[error(
        "at t = {time} (s; in statics the load factor) rounding errors of the elastic forces may be {share:.1e} of the {of}: the \
         structure is too stiff, or too slender, for numbers of 16 digits; a smaller `E` or a higher section helps, or fewer elements"
    )]
    LostInRounding {
        /// Time, s; the load factor in statics.
        time: f64,
        /// Rounding over what is computed.
        share: f64,
        /// What that is.
        of: &'static str,
    },
    /// The estimated error of a run leaves no digit of it.
    #[error(
        "the positions are off by an estimated {time:.1e} m for the step and {space:.1e} m for the mesh, of {moved:.1e} m that they move: \
         no digit is right; a smaller `time.step` or `time.tolerance`, more `elements`, or a `history` for what comes suddenly help"
    )]
    Inaccurate {
        /// The step's part, m.
        time: f64,
        /// The mesh's part, m.
        space: f64,
        /// The largest distance from where a point starts, m.
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
    /// An adaptive method has come to its shortest step.
    #[error(
        "at t = {time} s the step would have to be shorter than {step:.1e} s: estimated error {error:.1e} m, tolerance \
         {tolerance:.1e} m; a larger `time.tolerance` helps, or a `history` where a force or heat comes suddenly"
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
    #[error("{quantity} is no longer finite at t = {time} s, step {step}; a smaller `time.step` helps")]
    NotFinite {
        /// What it was.
        quantity: &'static str,
        /// Time, s.
        time: f64,
        /// Number of the step.
        step: usize,
    },
    /// A file could not be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A file could not be written.
    #[error("cannot write {path}: {source}")]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// An embedded fixture is not what the program expects.
    #[error("the embedded fixture {name} cannot be used: {reason}")]
    Fixture {
        /// Its file name.
        name: &'static str,
        /// What is wrong with it.
        reason: String,
    },
    /// Fixtures that another program is to be compared with are not what this program expects.
    #[error("the fixtures cannot be used: {file}: {reason}")]
    Suite {
        /// The file.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A program that is to be tested cannot be started.
    #[error("cannot start the command `{command}`: {source}; allowed: a program and its arguments behind `--`")]
    Command {
        /// Its name.
        command: String,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A state that is neither a file nor stored.
    #[error("cannot read {name}: there is no such file, and no stored state of that name{nearest}; stored are {known}")]
    NoState {
        /// What was asked for.
        name: String,
        /// The name that is most like it, in words.
        nearest: String,
        /// The stored names.
        known: String,
    },
    /// A program that was tested is wrong somewhere.
    #[error("the program does not conform: {summary}")]
    NotConforming {
        /// What it has, and what fails.
        summary: String,
    },
    /// A picture could not be drawn.
    #[error("cannot draw \"{title}\": {reason}")]
    Picture {
        /// The picture's title.
        title: String,
        /// The drawing library's reason.
        reason: String,
    },
    /// A table that was read holds something that is not allowed there.
    #[error("{file}:{line}: `{column}` is {value}; allowed: {allowed}")]
    Table {
        /// The file.
        file: String,
        /// Number of the line, from 1, the heading's line.
        line: u64,
        /// The column's name.
        column: String,
        /// The offending value as it was written.
        value: String,
        /// What would have been accepted.
        allowed: String,
    },
    /// A result is further from its reference than its bound.
    #[error("{count} comparison(s) with the reference failed; the first: {first}")]
    Comparison {
        /// How many failed.
        count: usize,
        /// The first, with its numbers.
        first: String,
    },
}

impl Error {
    /// Exit code of the command line: 1 the run failed, 2 bad input.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Scene { .. }
            | Error::StepTooLarge { .. }
            | Error::Drifts { .. }
            | Error::TooLarge { .. }
            | Error::Table { .. }
            | Error::Suite { .. }
            | Error::Command { .. }
            | Error::NoState { .. }
            | Error::Read { .. } => 2,
            _ => 1,
        }
    }
}
