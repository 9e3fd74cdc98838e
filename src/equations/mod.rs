//! **The paper.** Equations (1)–(23) and (A.1)–(A.5) of Peng et al. (2018), one function each, in the paper's order
//! and symbols.
//!
//! | equations | module |
//! |---|---|
//! | (1)–(5), (A.1)–(A.5) | [`shape`]: position, velocity |
//! | (6)–(7) | [`inertia`]: kinetic energy, mass matrix |
//! | (8)–(14) | [`strain`]: thermal, Green–Lagrange, elastic |
//! | (15)–(17) | [`material`]: stress, moduli |
//! | (18)–(21) | [`force`]: energy, elastic forces, stiffness, tangent |
//! | (22)–(23) | [`motion`]: one element, a structure |
//! | beyond the paper | [`axis`]: a cure for locking; [`uniaxial`]: a law for struts; [`cable`]: the paper's competitor |
//!
//! [`element`] has the element that is integrated over; `volume.rs` the quadrature, `contents.rs` a list of every function by its
//! number.
//!
//! Functions are pure: numbers and arrays in SI units, global axes, written for reading and checking.
//! `elements` holds the same formulas arranged for speed.
//!
//! `oracle/DERIVATION.md` derives the equations step by step and asserts every formula. Each module names its sections there.
//! The choices M1–M8 are in `#7-choices-to-know`.
//!
//! **Two forms.** Where the paper is wrong, the printed form (`…_printed`) follows the consistent one:
//! E1 [`shape::coefficients_printed`], E2 [`force::K_3_printed`], E3 [`force::U_printed`] and [`force::K_printed`],
//! E4 [`motion::constraint_force_printed`]. Everything else in this crate uses the consistent forms.

#![allow(non_snake_case)] // The paper's symbols are names here: S, M, K_1, S_a, eps_T.

pub mod axis;
pub mod cable;
mod contents;
pub mod element;
pub mod force;
pub mod inertia;
pub mod material;
pub mod motion;
pub mod shape;
pub mod strain;
pub mod uniaxial;
pub(crate) mod volume;

/// The paper's numbers and their functions, and the quadrature.
pub(crate) mod inside {
    pub use crate::equations::contents::{CONTENTS, Entry, Form};
    /// Gauss quadrature over an element.
    pub mod volume {
        pub use crate::equations::volume::*;
    }
}
