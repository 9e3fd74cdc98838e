//! All cases, in the order of the table.

use super::case::Case;
use super::{
    bad_structure, collapsed, estimate_check, explicit_with_a_hinge, far_from_origin, fine_mesh, heat, inclined,
    loads_that_move_nothing, long_run, poisson, rotation_free, rotation_over_the_top, shock, singular, slender,
    soft_and_stiff, step_size, stiff, units,
};
use crate::error::{Error, Result};

/// All cases, in the order of the table.
pub const CASES: &[Case] = &[
    stiff::CASE,
    loads_that_move_nothing::CASE,
    slender::CASE,
    soft_and_stiff::CASE,
    heat::FREE,
    heat::CLAMPED,
    shock::CASE,
    explicit_with_a_hinge::CASE,
    estimate_check::CASE,
    poisson::CASE,
    rotation_free::CASE,
    rotation_over_the_top::CASE,
    far_from_origin::CASE,
    units::CASE,
    step_size::CASE,
    long_run::CASE,
    fine_mesh::SMALL,
    fine_mesh::LARGE,
    singular::CASE,
    bad_structure::CASE,
    collapsed::CASE,
    inclined::CASE,
];

/// Names of all cases.
pub fn names() -> impl Iterator<Item = &'static str> {
    CASES.iter().map(|case| case.name)
}

/// The cases with these names; all if there are none.
///
/// # Errors
/// [`Error::Name`] for an unknown name.
pub fn named(wanted: &[String]) -> Result<Vec<&'static Case>> {
    let find = |name: &String| {
        CASES.iter().find(|case| case.name == name).ok_or_else(|| Error::Name {
            file: "ancf stability".into(),
            key: "CASE".into(),
            value: name.clone(),
            allowed: format!("`{}`", names().collect::<Vec<_>>().join("`, `")),
        })
    };
    if wanted.is_empty() { Ok(CASES.iter().collect()) } else { wanted.iter().map(find).collect() }
}
