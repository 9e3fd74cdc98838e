//! Declaration of conventions: what `hello` may have under `conventions`.

#![allow(non_snake_case)] // The paper's symbols are names here.

use schemars::JsonSchema;

/// Conventions of a program, under `conventions` in `hello`. Those that are absent are read off the answers.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "its schema is used, never its values")]
pub struct DeclaredConventions {
    /// The seven nodal vectors in the program's order: r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k in the fixtures.
    order: Option<Vec<String>>,
    /// The four nodal vectors of the cable in the program's order: r_i, r_x_i, r_k, r_x_k in the fixtures.
    cable_order: Option<Vec<String>>,
    /// Order of x and y in e: interleaved (the fixtures') or blocks (all x, then all y).
    components: Option<String>,
    /// What r_x and r_y are multiplied by in e: 1, l/2 or l, and 1, h/2, h, l or l/2. 1 and 1 in the fixtures.
    slopes: Option<[String; 2]>,
    /// Layout of e0, e and edot in the states that the program reads: fixture, or own (as its answers).
    state: Option<String>,
    /// Nested lists of a matrix: rows (the fixtures'), columns, flat-rows or flat-columns.
    matrices: Option<String>,
    /// Order of the components of strain and stress: 11, 22, 12 in the fixtures.
    voigt: Option<[String; 3]>,
    /// Measure of the shear strain: tensor (ε₁₂, the fixtures') or engineering (2ε₁₂, with μ in D).
    shear: Option<String>,
    /// The matrix S_c of (11): as-printed (the fixtures') or symmetrised.
    S_c: Option<String>,
    /// The strain energies: whole (the fixtures'), without-constant (½ ∫ ε_Tᵀ D ε_T dV left out) or constant-subtracted.
    U: Option<String>,
    /// Where the thermal strain is subtracted: in-strain (14, the fixtures') or in-law (14 is the whole strain).
    heat: Option<String>,
    /// Unit of the state's theta: radians (the fixtures') or degrees.
    theta: Option<String>,
}
