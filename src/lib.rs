//! Planar thermo-elastic beams of the absolute nodal coordinate formulation (ANCF): the reference implementation of Peng,
//! Wang, Li, Zhi and Li, *Dynamics Analysis of
//! Deployable Structures considering a Two-Dimensional Coupled Thermo-Structural Effect*, 2018,
//! [doi 10.1155/2018/1752815].
//!
//! [doi 10.1155/2018/1752815]: https://doi.org/10.1155/2018/1752815
//!
//! # Simulate a heated mechanism
//!
//! Describe it as a [`Scene`](model::Scene), in code or in a JSON file, and move it with a
//! [`Simulation`](run::Simulation):
//!
//! ```
//! use ancf::model::{Material, Rod, Scene, Section, Support, Temperature, ThermalModel};
//! use ancf::run::Simulation;
//!
//! let scene = Scene::new(Material::new(2e8, 0.0, 7750.0).alpha(2.85e-5), Section::new(0.02, 0.02))
//!     .point("pivot", [0.0, 0.0])
//!     .point("tip", [1.0, 0.0])
//!     .rod(Rod::new("rod", "pivot", "tip"))
//!     .support(Support::pinned("pivot"))
//!     .gravity([0.0, -9.8])
//!     .temperature(Temperature::new(ThermalModel::TwoD, vec![[0.0, 0.0], [0.2, 200.0]]));
//! let mut pendulum = Simulation::new(scene)?;
//! pendulum.run_until(0.2)?;
//! let [x, y] = pendulum.position("tip")?;
//! assert!((x - 0.968).abs() < 0.005 && (y + 0.232).abs() < 0.005, "{x} {y}");
//! # Ok::<(), ancf::error::Error>(())
//! ```
//!
//! * [`model`] says what can be simulated; a [`Model`](model::Model) is a checked scene.
//! * [`run`](mod@run) simulates it: [`run()`](run::run) from start to end, [`run_estimated`](run::run_estimated) with an
//!   estimate of its errors.
//! * [`integrators`] has the interface for time-stepping methods of your own.
//! * [`error`] has the errors; each says what is wrong, where, and what is allowed.
//!
//! # Check another implementation
//!
//! [`state::ElementState`] reads the state of one element from JSON, and [`state::evaluate`] gives the value of any
//! quantity of the fixtures for it. The fixtures hold such states with exact values:
//!
//! * `equations.json`: 36 states of the paper's element;
//! * `cable.json`: 27 states of the [`cable`](equations::cable) element, for [`state::CableState`] and
//!   [`state::evaluate_cable`];
//! * `structure.json`: the terms of (23) for pinned rods, and their motion;
//! * `pendulum.json`: the motion of the pendulum; `continuum.json`: that of a plane solid;
//! * `references.json`: solutions of statics, heat and vibration.
//!
//! `fixtures/README.md` explains each field; the crate `ancf-fixtures` embeds the files. The crate `ancf-conform` and
//! the command `ancf conform` ask any program for every value, and name the first equation that is wrong.
//!
//! # Learn the derivation
//!
//! [`equations`] is the paper, one function per equation:
//!
//! ```
//! use ancf::equations::strain;
//!
//! let eps_T = strain::eps_T(2.85e-5, 200.0); // (8), the thermal strain
//! assert!((eps_T[0] - 5.7e-3).abs() < 1e-15 && eps_T[0] == eps_T[1] && eps_T[2] == 0.0);
//! ```
//!
//! **Notation.** The paper's symbols are names: `S_a` is S_a, `K_1` is K₁, `eps_T` is ε_T, `e_dot` is ė; `dT` is the
//! temperature change ΔT. A point of an element has coordinates x along the axis and y across it. The 14 nodal
//! coordinates are e = \[rⁱ r_yⁱ rʲ r_xʲ r_yʲ rᵏ r_yᵏ\], (4).
//!
//! **Units and signs.** SI units throughout. The paper's strains are Green–Lagrange, its stresses second Piola–Kirchhoff;
//! [`equations`] has both in global axes. Tension is positive. Q_e is ∂U/∂e, the force *on the left* of
//! M ë + Q_e = Q_w, (22), as Φ_qᵀ λ is in (23). A reaction is the force of a support *on the structure*. A deflection is
//! positive to the left of from → to.
//!
//! **Equation → function.** `src/equations/contents.rs` lists them all.
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
//! | (11) | [`strain::S_abc_theta`], [`strain::S_abc`], [`strain::J_0_theta`] | | (A.2) | [`shape::nodal_conditions`] |
//! | (12) | [`strain::eps_f`] | | (A.3) | [`shape::coefficients`], [`shape::coefficients_printed`] (E1) |
//! | (13) | [`strain::eps_1`], [`strain::eps_2`], [`strain::eps_3`] | | (A.4), (A.5) | [`shape::r_nodal`], [`shape::S`] |
//! | (14) | [`strain::eps`] | | | |
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
//! [`strain::J_0_theta`]: equations::strain::J_0_theta
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

/// Linear algebra crate whose vectors and matrices the equations use.
pub use nalgebra;

mod elements;
pub mod equations;
pub mod error;
pub mod integrators;
pub mod internals;
mod lanes;
mod linear;
pub mod model;
pub mod run;
#[cfg(feature = "schema")]
mod schema;
pub mod state;
mod structure;

/// The README's program, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
