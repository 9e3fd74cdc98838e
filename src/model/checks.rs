//! Conditions of a valid scene beyond the types of its values, one group after the other.

mod heat;
mod history;
pub mod idle;
mod imperfection;
mod loads;
mod motion;
mod probes;
mod statics;
mod supports;
mod time;
pub mod topology;

use std::fmt::Display;

use super::check::{Check, finite, positive, require};
use super::choice::{Constraints, Element, Form, Law, Method, Poisson};
use super::rod::{Material, Rod, Section};
use super::scene::Scene;
use heat::check_heat;
use idle::check_idle;
use imperfection::check_imperfection;
use loads::check_loads;
use motion::check_motion;
use probes::check_probes;
use statics::check_statics;
use supports::check_supports;
use time::{check_output, check_shapes, check_time};
use topology::check_topology;

/// Checks every condition of a scene.
pub fn check(scene: &Scene) -> Check {
    check_line("title", &scene.title)?;
    for (i, note) in scene.notes.iter().enumerate() {
        check_line(format_args!("notes[{i}]"), note)?;
    }
    check_material("material", &scene.material)?;
    check_section("section", &scene.section)?;
    for (i, rod) in scene.rods.iter().enumerate() {
        if let Some(material) = &rod.material {
            check_material(format_args!("rods[{i}].material"), material)?;
        }
        if let Some(section) = &rod.section {
            check_section(format_args!("rods[{i}].section"), section)?;
        }
    }
    check_topology(scene)?;
    check_supports(scene)?;
    check_loads(scene)?;
    check_heat(scene)?;
    check_constraints(scene)?;
    check_form(scene)?;
    check_imperfection(scene)?;
    check_time(scene)?;
    check_idle(scene, |_| false)?;
    check_statics(scene)?;
    check_motion(scene)?;
    check_probes(scene)?;
    check_output(scene)?;
    check_shapes(scene)
}

fn check_line(key: impl Display, text: &str) -> Check {
    let holds = !text.contains(char::is_control);
    require(holds, key, format_args!("{text:?}"), "a text in one line, without control characters")
}

fn check_material(key: impl Display, material: &Material) -> Check {
    let Material { youngs_modulus, nu, rho, alpha } = *material;
    positive(format_args!("{key}.E"), youngs_modulus)?;
    let nu_holds = -1.0 < nu && nu < 0.5;
    let nu_key = format_args!("{key}.nu");
    require(nu_holds, nu_key, format_args!("{nu:?}"), "a number between -1 and 0.5, both excluded")?;
    positive(format_args!("{key}.rho"), rho)?;
    finite(format_args!("{key}.alpha"), alpha)
}

fn check_section(key: impl Display, section: &Section) -> Check {
    positive(format_args!("{key}.height"), section.height)?;
    positive(format_args!("{key}.width"), section.width)?;
    // The highest integral of the section, needed for bending in large strains; an underflow would silently remove it.
    let highest = section.width * section.height.powi(5);
    let allowed = "a height whose fifth power times the width is a normal f64 number, without underflow or overflow; other units help";
    require(highest.is_normal(), format_args!("{key}.height"), format_args!("{:?}", section.height), allowed)
}

/// Only generalized-α solves equation (23) with multipliers.
fn check_constraints(scene: &Scene) -> Check {
    let holds = scene.constraints != Constraints::Multipliers || scene.time.method == Method::GeneralizedAlpha;
    let allowed = format_args!(
        "\"condensed\"; \"multipliers\" needs the method \"generalized-alpha\" (here: \"{}\")",
        scene.time.method
    );
    require(holds, "constraints", "\"multipliers\"", allowed)
}

/// The printed shear term belongs to the paper's element in plane strain, with Poisson's terms in the whole section.
fn check_form(scene: &Scene) -> Check {
    let printed =
        |rod: &Rod| rod.element == Element::Ancf && rod.poisson == Poisson::Full && rod.law == Law::PlaneStrain;
    let other = scene.rods.iter().find(|rod| !printed(rod));
    let holds = scene.form == Form::Consistent || other.is_none();
    let name = other.map_or("", |rod| &rod.name);
    let allowed = format_args!(
        "\"consistent\"; \"printed-shear\" needs rods with \"element\": \"ancf\", \"poisson\": \"full\" and \"law\": \"plane-strain\" (not so: `{name}`)"
    );
    require(holds, "form", "\"printed-shear\"", allowed)
}
