//! The main job: both sections of the paper, a quick look at error against run time, and the stiff cases.

use std::cell::RefCell;
use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use crate::error::{Error, Result};
use crate::files::Files;
use crate::paper::balance::Balance;
use crate::paper::claims_section3::{self, PendulumStatement};
use crate::paper::claims_section4::{self, StructureStatement};
use crate::paper::comparison::Comparison;
use crate::paper::continuum::Continuum;
use crate::paper::locking::{self, Locking};
use crate::paper::model_error::{self, ErrorRow, ShearRow};
use crate::paper::pendulum::{self, Model, TipRow};
use crate::paper::printed;
use crate::paper::reference_pendulum::Oracle;
use crate::paper::reference_structures::Structures;
use crate::paper::scissors::Structure;
use crate::paper::section4::{self, A4Row};
use crate::{error_time, report_page, stability};

/// Files that the main job writes beside those of its studies.
const FILES: [&str; 4] = ["report.html", "pendulum.csv", "scissors.csv", "main.json"];

/// The content of `main.json`.
#[derive(Serialize)]
struct Report {
    wall_seconds: f64,
    /// Section 3: the pendulum against the oracle and against a plane solid, its tip, and the paper's statements.
    oracle: Vec<Comparison>,
    continuum: Vec<Comparison>,
    tip: Vec<TipRow>,
    errors: Vec<ErrorRow>,
    shear: Vec<ShearRow>,
    statements: Vec<PendulumStatement>,
    locking: Locking,
    /// Section 4: structures against the oracle, a4, energies, and the paper's statements.
    structures: Vec<Comparison>,
    a4: Vec<A4Row>,
    energy: Vec<Balance>,
    claims: Vec<StructureStatement>,
}

/// Runs the pendulum of Table 1 and the structure of Table 2 in all their models, a quick study of error against run time and the fast
/// stiff cases; hands tables to `print`, and writes pictures and `main.json` to `out`.
///
/// # Errors
/// [`Error::Comparison`] if a run exceeds the bound of its distance from the oracle or of its energy balance, or a stiff case is WRONG; the
/// files are written all the same. Errors of the runs.
pub fn main_job(out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    let clock = Instant::now();
    let all_text = RefCell::new(String::new());
    let print = |text: &str| {
        all_text.borrow_mut().push_str(text);
        print(text)
    };
    // First, so that a folder that cannot be written is found before the work.
    let names = [&pendulum::PICTURES[..], &section4::PICTURES, &error_time::FILES, &stability::FILES, &FILES];
    let mut files = Files::in_folder(out, names.concat(), &[])?;
    let (known, pinned, solids) = (Oracle::load()?, Structures::load()?, Continuum::load()?);

    print("Peng et al. (2018), Section 3: the heated pendulum of Table 1\n\n")?;
    let oracle = known.compare()?;
    print(&printed::oracle(&oracle))?;
    let models = pendulum::simulate()?;
    print(&printed::tips(&models, &known))?;
    print(&printed::differences(&models))?;
    let errors = model_error::errors(&models, &solids)?;
    let shear = model_error::shear(&models, &solids, &known.shear)?;
    print(&printed::errors(&errors, &shear))?;
    let continuum = model_error::bars(&models, &errors, &shear);
    print(&printed::bars(&continuum))?;
    let (statements, locking) = (claims_section3::measure(&models, &solids)?, locking::measure()?);
    print(&printed::statements(&statements, &locking))?;

    print("Section 4: the deployable structure of Table 2\n\n")?;
    let structures = pinned.compare()?;
    print(&printed::structures(&structures))?;
    let structure = Structure::simulate()?;
    let a4 = section4::rows(&structure);
    print(&printed::a4(&a4))?;
    let family = &structure.fine;
    let energy = vec![
        Balance::of("flexible", &family.flexible),
        Balance::of("1D", &family.axis),
        Balance::of("2D", &family.axis_and_section),
    ];
    print(&printed::energies(&energy))?;
    let claims = claims_section4::measure(&structure);
    print(&printed::claims(&claims))?;

    let options = error_time::Options { quick: true, ..Default::default() };
    let (_, error_time) = error_time::part(&options, out, &mut files, print)?;
    let (wrong, stability) = stability::part(&mut files, print)?;

    let compared = oracle.iter().chain(&continuum).chain(&structures);
    let failed = compared.filter(|row| !row.holds()).map(ToString::to_string);
    let balances = energy.iter().filter(|e| !e.holds()).map(ToString::to_string);
    let failed: Vec<String> = failed.chain(balances).chain(wrong).collect();
    let mut pictures = pendulum::pictures(&models, &known.rigid, &solids)?;
    pictures.extend(section4::pictures(&structure)?);
    for (name, svg) in &pictures {
        files.write_text(name, svg.clone())?;
    }
    pictures.extend([("error-time.svg", error_time), ("stability.svg", stability)]);
    let page = report_page::page(&all_text.borrow(), &pictures);
    files.write_text("report.html", page)?;
    files.write_table("pendulum.csv", |file| pendulum::curves(&models).write_csv(file))?;
    files.write_table("scissors.csv", |file| section4::curves(&structure).write_csv(file))?;
    let (wall_seconds, tip) = (clock.elapsed().as_secs_f64(), models.iter().flat_map(Model::rows).collect());
    let report = Report {
        wall_seconds,
        oracle,
        continuum,
        tip,
        errors,
        shear,
        statements,
        locking,
        structures,
        a4,
        energy,
        claims,
    };
    files.write_json("main.json", &report)?;
    let paths = files.publish()?;
    print(&format!("Written after {wall_seconds:.1} s:\n"))?;
    print(&paths.iter().map(|path| format!("   {}\n", path.display())).collect::<String>())?;
    match failed.first() {
        None => Ok(()),
        Some(first) => Err(Error::Comparison { count: failed.len(), first: first.clone() }),
    }
}
