//! Diagnosis of wrong equations.
//!
//! Known mistakes are made deliberately, each kind in a file of its own. Their values are compared with the answers, in failing and in
//! right cases. Wrong factors and signs are computed from the answers by `factors`.

// Layers, from top to bottom; a module imports only from modules further down this list:
// invisible, ancestors, wrong_values, diagnose, factors, power;
// force;
// errata, heat, law, functions, integral, gradient, inertia, solution, reading, angle, copied;
// terms, cable, chain, formulas, layout, quadrature, jet, candidate, entries, observation, mistake.
mod ancestors;
mod angle;
mod cable;
mod candidate;
mod chain;
mod copied;
mod diagnose;
mod entries;
mod errata;
mod factors;
mod force;
mod formulas;
mod functions;
mod gradient;
mod heat;
mod inertia;
mod integral;
mod invisible;
mod jet;
mod law;
mod layout;
mod mistake;
mod observation;
mod power;
mod quadrature;
mod reading;
mod solution;
mod terms;
#[cfg(test)]
mod tests;
mod wrong_values;

pub use ancestors::{Ancestor, Seen, ancestors};
pub use diagnose::{Diagnosis, diagnose};
pub use invisible::{Invisible, invisible};
pub use mistake::{Mistake, MistakeKind};
pub use observation::{Observation, Outcome};
pub use wrong_values::Upstream;
