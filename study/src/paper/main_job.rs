//! The main job: both sections of the paper, a quick look at error against run time, and the stiff cases.

use std::cell::RefCell;
use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use super::balance::Balance;
use super::{
    claims_section3, claims_section4, continuum, locking, model_error, pendulum, reference_pendulum,
    reference_structures, scissors, section4, table,
};
use crate::error::{Error, Result};
use crate::files::Files;
use crate::{error_time, page, stability};

/// `main.json`.
#[derive(Serialize)]
struct Report {
    wall_seconds: f64,
    /// Section 3: the pendulum against the oracle and against a plane solid, its tip, and the paper's statements.
    oracle: Vec<reference_pendulum::Row>,
    continuum: Vec<reference_pendulum::Row>,
    tip: Vec<pendulum::Row>,
    errors: Vec<model_error::ErrorRow>,
    shear: Vec<model_error::ShearRow>,
    statements: Vec<claims_section3::Row>,
    locking: locking::Locking,
    /// Section 4: structures against the oracle, a4, energies, and the paper's statements.
    structures: Vec<reference_pendulum::Row>,
    a4: Vec<section4::Row>,
    energy: Vec<Balance>,
    claims: Vec<claims_section4::Row>,
}

/// Runs the pendulum of Table 1 and the structure of Table 2 in all their models, hands tables to `print`, and writes
/// pictures and `main.json` to `out`.
///
/// # Errors
/// [`Error::Comparison`] when a run misses the oracle or its energy balance, or a stiff case is WRONG: the files are written all the same. Those of
/// the runs themselves.
pub fn main_job(out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    let clock = Instant::now();
    let printed = RefCell::new(String::new());
    let print = |text: &str| {
        printed.borrow_mut().push_str(text);
        print(text)
    };
    // First, so that a folder that cannot be written is not found after the work.
    let mut files = Files::in_folder(out)?;
    let (oracle, pinned, continuum) = (reference_pendulum::load()?, reference_structures::load()?, continuum::load()?);

    print("Peng et al. (2018), Section 3: the heated pendulum of Table 1\n\n")?;
    let rows = reference_pendulum::compare(&oracle)?;
    print(&table::oracle(&rows))?;
    let models = pendulum::simulate()?;
    print(&table::tips(&models, &oracle))?;
    print(&table::differences(&models))?;
    let errors = model_error::errors(&models, &continuum)?;
    let shear = model_error::shear(&models, &continuum, &oracle.shear)?;
    print(&table::errors(&errors, &shear))?;
    let bars = model_error::bars(&models, &errors, &shear);
    print(&table::bars(&bars))?;
    let (statements, locking) = (claims_section3::measure(&models, &continuum)?, locking::measure()?);
    print(&table::statements(&statements, &locking))?;

    print("Section 4: the deployable structure of Table 2\n\n")?;
    let structures = reference_structures::compare(&pinned)?;
    print(&table::structures(&structures))?;
    let structure = scissors::Structure::simulate()?;
    let a4 = section4::rows(&structure);
    print(&table::a4(&a4))?;
    let family = &structure.fine;
    let energy = vec![
        Balance::of("flexible", &family.flexible),
        Balance::of("1D", &family.axis),
        Balance::of("2D", &family.axis_and_section),
    ];
    print(&table::energies(&energy))?;
    let claims = claims_section4::measure(&structure);
    print(&table::claims(&claims))?;

    let options = error_time::Options { quick: true, ..Default::default() };
    let (_, error_time) = error_time::part(&options, out, &mut files, print)?;
    let (wrong, stability) = stability::part(&mut files, print)?;

    let failed = rows.iter().chain(&bars).chain(&structures).filter(|row| !row.holds()).map(ToString::to_string);
    let balances = energy.iter().filter(|e| !e.holds()).map(ToString::to_string);
    let failed: Vec<String> = failed.chain(balances).chain(wrong).collect();
    let pictures: Vec<(&'static str, String)> = pendulum::pictures(&models, &oracle.rigid, &continuum)?
        .into_iter()
        .chain(section4::pictures(&structure)?)
        .collect();
    for (name, svg) in &pictures {
        files.write(name, |file| file.write_all(svg.as_bytes()))?;
    }
    let parts = [("error-time.svg", error_time), ("stability.svg", stability)];
    let drawn: Vec<(&str, String)> = pictures.into_iter().chain(parts).collect();
    files.write("report.html", |file| file.write_all(page::page(&printed.borrow(), &drawn).as_bytes()))?;
    files.write("pendulum.csv", |file| pendulum::curves(&models).write_csv(file))?;
    files.write("scissors.csv", |file| section4::curves(&structure).write_csv(file))?;
    let report = Report {
        wall_seconds: clock.elapsed().as_secs_f64(),
        oracle: rows,
        continuum: bars,
        tip: models.iter().flat_map(pendulum::Model::rows).collect(),
        errors,
        shear,
        statements,
        locking,
        structures,
        a4,
        energy,
        claims,
    };
    files.write("main.json", |file| Ok(serde_json::to_writer_pretty(file, &report)?))?;
    let paths = files.publish()?;
    print(&table::written(&paths, report.wall_seconds))?;
    match failed.first() {
        None => Ok(()),
        Some(first) => Err(Error::Comparison { count: failed.len(), first: first.clone() }),
    }
}
