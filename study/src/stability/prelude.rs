//! What most cases need.

pub use super::case::{Case, Expected, Finding, Trial};
pub use crate::error::{Error, Result};
pub use crate::path::{Path, column, columns, distance, largest, largest_distance, last, last_tip, positions, tip};
pub use crate::scene::{Change, ELEMENTS, builtin, cantilever, light_cantilever, pendulum, point_probe};
pub use ancf::internals::model::{Plan, Scissors};
pub use ancf::model::{
    Constraints, Direction, Element, Force, Method, Motion, Poisson, Probe, Quantity, Scene, Support, Temperature,
    ThermalModel,
};
pub use ancf::run::{Run, run};
pub use itertools::iproduct;
