//! The main job: the paper's Sections 3 and 4, recomputed and compared with the oracles; [`error_time`], error against run time; [`stability`], stiff
//! and extreme cases.

mod claims;
mod continuum;
mod distance;
pub mod error_time;
mod figure;
mod locking;
mod oracle;
mod page;
mod palette;
mod pendulum;
mod pinned;
mod scissors;
mod section3;
mod section4;
mod signal;
mod snapshot;
pub mod stability;
mod table;

use std::cell::RefCell;
use std::path::Path;
use std::time::Instant;

use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::Serialize;

use crate::error::{Error, Result};
use crate::report::{self, Files};

/// `main.json`.
#[derive(Serialize)]
struct Report {
    wall_seconds: f64,
    /// Section 3: the pendulum against the oracle and against a plane solid, its tip, and the paper's statements.
    oracle: Vec<oracle::Row>,
    continuum: Vec<oracle::Row>,
    tip: Vec<pendulum::Row>,
    errors: Vec<distance::ErrorRow>,
    shear: Vec<distance::ShearRow>,
    statements: Vec<section3::Row>,
    locking: locking::Locking,
    /// Section 4: structures against the oracle, a4, energies, and the paper's statements.
    structures: Vec<oracle::Row>,
    a4: Vec<section4::Row>,
    energy: Vec<Balance>,
    claims: Vec<claims::Row>,
}

/// The energy balance of a structure's run.
#[derive(Serialize)]
struct Balance {
    model: &'static str,
    /// Largest imbalance, and energy put in at the end, J.
    largest: f64,
    input: f64,
    /// Bound of the first over the second.
    bound: f64,
}

/// Bound of the imbalance over the energy put in.
const BALANCE: f64 = 1e-8;

impl Balance {
    fn of(model: &'static str, motion: &scissors::Motion) -> Balance {
        let [largest, input] = motion.energy_balance();
        Balance { model, largest, input, bound: BALANCE }
    }

    /// A balance that is not a number does not hold.
    fn holds(&self) -> bool {
        self.largest <= self.bound * self.input
    }
}

impl std::fmt::Display for Balance {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Balance { model, largest, input, bound } = self;
        write!(f, "{model}: energy balance {largest:.1e} J of {input:.1} J put in, bound {bound:.0e} of it")
    }
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
    let (oracle, pinned, continuum) = (oracle::load()?, pinned::load()?, continuum::load()?);

    print("Peng et al. (2018), Section 3: the heated pendulum of Table 1\n\n")?;
    let rows = oracle::compare(&oracle)?;
    print(&table::oracle(&rows))?;
    let models = pendulum::simulate()?;
    print(&table::tips(&models, &oracle))?;
    print(&table::differences(&models))?;
    let errors = distance::errors(&models, &continuum)?;
    let shear = distance::shear(&models, &continuum, &oracle.shear)?;
    print(&table::errors(&errors, &shear))?;
    let bars = distance::bars(&models, &errors, &shear);
    print(&table::bars(&bars))?;
    let (statements, locking) = (section3::measure(&models, &continuum)?, locking::measure()?);
    print(&table::statements(&statements, &locking))?;

    print("Section 4: the deployable structure of Table 2\n\n")?;
    let structures = pinned::compare(&pinned)?;
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
    let claims = claims::measure(&structure);
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
    files.write("pendulum.csv", |file| report::write_csv(file, &pendulum::curves(&models)))?;
    files.write("scissors.csv", |file| report::write_csv(file, &section4::curves(&structure)))?;
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

/// Does all jobs on all cores, in the order given, with a progress bar on a terminal.
fn in_parallel<J: Sync, R: Send>(
    what: &'static str,
    jobs: &[J],
    f: impl Fn(&J) -> Result<R> + Sync + Send,
) -> Result<Vec<R>> {
    let style = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}, {eta} left");
    let bar = ProgressBar::new(jobs.len() as u64).with_message(what);
    let bar = style.map_or(bar.clone(), |style| bar.with_style(style));
    let results = jobs.par_iter().progress_with(bar.clone()).map(f).collect();
    bar.finish_and_clear();
    results
}
