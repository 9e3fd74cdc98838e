//! Diagnosis of wrong equations.
//!
//! Known mistakes are made deliberately, each kind in a file of its own. Their values are compared with the answers, in failing and in
//! right cases. Wrong factors and signs are computed from the answers by `factors`.

// Layers, from top to bottom; a module imports only from modules further down this list:
// invisible, diagnose, factors, power;
// errata, heat, law, integral, gradient, inertia, reading, angle, layout, copied;
// terms, quadrature, candidate, entries, observation, mistake.
mod angle;
mod candidate;
mod copied;
mod diagnose;
mod entries;
mod errata;
mod factors;
mod gradient;
mod heat;
mod inertia;
mod integral;
mod invisible;
mod law;
mod layout;
mod mistake;
mod observation;
mod power;
mod quadrature;
mod reading;
mod terms;
#[cfg(test)]
mod tests;

pub use diagnose::{Diagnosis, diagnose};
pub use invisible::{Invisible, invisible};
pub use mistake::{Mistake, MistakeKind};
pub use observation::{Observation, Outcome};
