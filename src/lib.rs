//! The planar thermo-elastic ANCF beam of Peng, Wang, Li, Zhi and Li, *Dynamics Analysis of Deployable Structures
//! considering a Two-Dimensional Coupled Thermo-Structural Effect*, 2018, [doi 10.1155/2018/1752815]: a reference
//! implementation to read, to run and to check others against.
//!
//! [doi 10.1155/2018/1752815]: https://doi.org/10.1155/2018/1752815
//!
//! **Where to start.** [`equations`] is the paper, one function an equation. [`kernel`] is the same element, fast.
//! [`scene`] is what can be simulated, [`run`] simulates it:
//!
//! ```
//! use ancf::{run::run, scene::{Method, Scene}};
//!
//! let mut scene = Scene::builtin("pendulum-flexible").unwrap();
//! (scene.time.method, scene.time.step, scene.time.end) = (Method::EnergyMomentum, 1e-3, 0.5);
//! let run = run(&scene)?;
//! let y = run.trajectory.column("tip.y").unwrap();
//! assert!((y.last().unwrap() + 0.99685).abs() < 1e-4);
//! # Ok::<(), ancf::error::Error>(())
//! ```
//!
//! **Notation.** The paper's symbols are names: `S_a` is S_a, `K_1` is K₁, `eps_T` is ε_T, `e_dot` is ė; `dT` is the change of
//! temperature ΔT. A point of an element has coordinates x along the axis and y across it. The 14 nodal coordinates are
//! e = \[rⁱ r_yⁱ rʲ r_xʲ r_yʲ rᵏ r_yᵏ\], (4).
//!
//! **Checking another implementation.** [`conformance`] asks any program for every value of the fixtures, and names the first equation
//! that is wrong. `fixtures/equations.json` has 36 element states and the exact value of every quantity of
//! [`equations::CONTENTS`] for each; [`state::ElementState`] reads a state, [`state::evaluate`] gives our value. `fixtures/cable.json`
//! has 27 of the [`cable`](equations::cable) element, for [`state::CableState`] and [`state::evaluate_cable`].
//! `fixtures/pendulum.json` has the pendulum's motion, `fixtures/continuum.json` that of a plane solid; `fixtures/structure.json`
//! the terms of (23) for pinned rods, and their motion; `fixtures/references.json` solutions of statics and vibration. Each field is
//! explained in `fixtures/README.md`.
//!
//! **Structures.** [`structure`] assembles rods that are pinned at their ends and middles; [`integrators`] move it and
//! [`statics`] loads it, as it should be computed (pins as shared coordinates) or as (23) has it (with multipliers).
//!
//! **Units and signs.** SI throughout. The paper's strains are Green–Lagrange, its stresses second Piola–Kirchhoff, both in global axes
//! in [`equations`]; tension is positive. Q_e is ∂U/∂e, the force *on the left* of M ë + Q_e = Q_w, (22),
//! as Φ_qᵀ λ is in (23). A reaction is the force of a support *on the structure*; a deflection is positive to the left of
//! from → to.
//!
//! **Equation → function.** [`equations::CONTENTS`] lists them all.
//!
//! | equation | function | | equation | function |
//! |---|---|---|---|---|
//! | (1) | [`shape::r`] | | (15) | [`material::sigma`] |
//! | (2) | [`shape::S`] | | (16) | [`material::D`] |
//! | (3) | [`shape::S_i`] | | (17) | [`material::lambda`], [`material::mu`] |
//! | (4) | [`shape::e`], [`shape::nodes`] | | (18) | [`force::U`], [`force::U_printed`] (E3) |
//! | (5) | [`shape::r_dot`] | | (19) | [`force::Q_e`] |
//! | (6) | [`inertia::T`], [`inertia::T_integral`] | | (20) | [`force::K`], [`force::K_printed`] (E3) |
//! | (7) | [`inertia::M`] | | (21) | [`force::K_1`], [`force::K_2`], [`force::K_3`], [`force::K_3_printed`] (E2), [`force::S_1`] |
//! | (8) | [`strain::eps_T`] | | (22) | [`motion::residual`], [`motion::acceleration`] |
//! | (9) | [`strain::J`], [`strain::J_0`] | | (23) | [`motion::system_residual`], [`motion::system_acceleration`], [`motion::constraint_force`], [`motion::constraint_force_printed`] (E4) |
//! | (10) | [`strain::eps_m`] | | (A.1) | [`shape::r_polynomial`] |
//! | (11) | [`strain::S_abc_theta`], [`strain::S_abc`] | | (A.2) | [`shape::nodal_conditions`] |
//! | (12) | [`strain::eps_f`] | | (A.3) | [`shape::coefficients`], [`shape::coefficients_printed`] (E1) |
//! | (13) | [`strain::eps_1`], [`strain::eps_2`], [`strain::eps_3`] | | (A.4), (A.5) | [`shape::r_nodal`], [`shape::S`] |
//! | (14) | [`strain::eps`] | | | |
//!
//! **Features.** `cli` (on by default) adds the command line, the pictures and the main job; the library does without:
//! `ancf = { path = "…", default-features = false }`.
//!
//! [`shape::r`]: equations::shape::r
//! [`shape::S`]: equations::shape::S
//! [`shape::S_i`]: equations::shape::S_i
//! [`shape::e`]: equations::shape::e
//! [`shape::nodes`]: equations::shape::nodes
//! [`shape::r_dot`]: equations::shape::r_dot
//! [`shape::r_polynomial`]: equations::shape::r_polynomial
//! [`shape::nodal_conditions`]: equations::shape::nodal_conditions
//! [`shape::coefficients`]: equations::shape::coefficients
//! [`shape::coefficients_printed`]: equations::shape::coefficients_printed
//! [`shape::r_nodal`]: equations::shape::r_nodal
//! [`inertia::T`]: equations::inertia::T
//! [`inertia::T_integral`]: equations::inertia::T_integral
//! [`inertia::M`]: equations::inertia::M
//! [`strain::eps_T`]: equations::strain::eps_T
//! [`strain::J`]: equations::strain::J
//! [`strain::J_0`]: equations::strain::J_0
//! [`strain::eps_m`]: equations::strain::eps_m
//! [`strain::S_abc_theta`]: equations::strain::S_abc_theta
//! [`strain::S_abc`]: equations::strain::S_abc
//! [`strain::eps_f`]: equations::strain::eps_f
//! [`strain::eps_1`]: equations::strain::eps_1
//! [`strain::eps_2`]: equations::strain::eps_2
//! [`strain::eps_3`]: equations::strain::eps_3
//! [`strain::eps`]: equations::strain::eps
//! [`material::sigma`]: equations::material::sigma
//! [`material::D`]: equations::material::D
//! [`material::lambda`]: equations::material::lambda
//! [`material::mu`]: equations::material::mu
//! [`force::U`]: equations::force::U
//! [`force::U_printed`]: equations::force::U_printed
//! [`force::Q_e`]: equations::force::Q_e
//! [`force::K`]: equations::force::K
//! [`force::K_printed`]: equations::force::K_printed
//! [`force::K_1`]: equations::force::K_1
//! [`force::K_2`]: equations::force::K_2
//! [`force::K_3`]: equations::force::K_3
//! [`force::K_3_printed`]: equations::force::K_3_printed
//! [`force::S_1`]: equations::force::S_1
//! [`motion::residual`]: equations::motion::residual
//! [`motion::acceleration`]: equations::motion::acceleration
//! [`motion::constraint_force`]: equations::motion::constraint_force
//! [`motion::constraint_force_printed`]: equations::motion::constraint_force_printed
//! [`motion::system_residual`]: equations::motion::system_residual
//! [`motion::system_acceleration`]: equations::motion::system_acceleration

/// The matrices and vectors of [`equations`] are its types.
pub use nalgebra;

mod elements;
pub mod equations;
pub mod error;
pub mod integrators;
pub mod internals;
mod linear;
pub mod model;
pub mod run;
pub mod state;
mod structure;
