//! Conventions: what a program may write in its own way without a mistake.
//!
//! [`Conventions`] holds one choice of each kind, each kind in a file of its own. `translation` turns a program's values into those of the
//! fixtures and back; `inference` reads the conventions off its answers; `declared` reads them from `hello`.
//!
//! A convention is accepted where it makes answers right and none wrong that was right. So a single quantity in another order, among
//! others in the paper's, stays a mistake.

#![allow(non_snake_case)] // The paper's symbols are names here.

// Layers, from top to bottom; a module imports only from modules further down this list:
// inference, read_off, evidence, declared, translation, axes;
// layout, order, slopes, components, voigt, shear, symmetrised, energy, heat, angle, matrices, reading; rest, named.
mod angle;
mod axes;
mod components;
mod declared;
mod energy;
mod evidence;
mod heat;
mod inference;
mod layout;
mod matrices;
mod named;
mod order;
mod read_off;
mod reading;
mod rest;
mod shear;
mod slopes;
mod symmetrised;
mod translation;
mod voigt;

pub use declared::Declared;
pub use inference::infer;
pub use named::{Convention, How};

use angle::Angle;
use energy::Energy;
use heat::Heat;
use layout::Layout;
use matrices::Matrices;
use reading::Reading;
use shear::Shear;
use symmetrised::Metrics;
use voigt::Voigt;

/// One choice of each convention; those of the fixtures by default.
#[derive(Clone, Debug, PartialEq)]
pub struct Conventions {
    /// Nested lists of a matrix.
    matrices: Matrices,
    /// Nodal coordinates of the paper's element.
    element: Layout,
    /// Nodal coordinates of the cable element.
    cable: Layout,
    /// Order of the components of strain and stress.
    voigt: Voigt,
    /// Measure of the shear strain.
    shear: Shear,
    /// The matrix S_c of (11).
    S_c: Metrics,
    /// Constant part of the strain energy.
    energy: Energy,
    /// Place where the thermal strain is subtracted.
    heat: Heat,
    /// Unit of the state's θ.
    angle: Angle,
    /// Layout of the state's e0, e and ė.
    reading: Reading,
}

impl Default for Conventions {
    fn default() -> Conventions {
        Conventions {
            matrices: Matrices::default(),
            element: Layout::of_the_element(),
            cable: Layout::of_the_cable(),
            voigt: Voigt::default(),
            shear: Shear::default(),
            S_c: Metrics::default(),
            energy: Energy::default(),
            heat: Heat::default(),
            angle: Angle::default(),
            reading: Reading::default(),
        }
    }
}
