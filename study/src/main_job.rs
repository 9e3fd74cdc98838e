//! The main job: both sections of the paper, a quick look at error against run time, and the stiff cases.

use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use crate::error::{Error, Result};
use crate::files::Files;
use crate::first_screen::{self, Check};
use crate::paper::balance::Balance;
use crate::paper::claims_section3::{self, PendulumStatement};
use crate::paper::claims_section4::{self, StructureStatement};
use crate::paper::comparison::Comparison;
use crate::paper::continuum::Continuum;
use crate::paper::locking::{self, Locking};
use crate::paper::model_error::{self, ErrorRow, ShearRow};
use crate::paper::pendulum::{self, Mesh, Model, TipRow};
use crate::paper::reading;
use crate::paper::readings::Readings;
use crate::paper::reference_pendulum::Oracle;
use crate::paper::reference_structures::Structures;
use crate::paper::scissors::{ELEMENTS, STEP, Structure};
use crate::paper::section4::{self, A4Row};
use crate::paper::statement::Statement;
use crate::paper::tables;
use crate::paper::{figure1, figure2};
use crate::paper_page::{self, Story, Titled};
use crate::picture::Picture;
use crate::stability::{StabilityRow, Verdict};
use crate::{error_time, stability};

/// Files that the main job writes beside those of its studies.
const FILES: [&str; 4] = ["paper.html", "pendulum.csv", "scissors.csv", "main.json"];

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
/// stiff cases. Hands `print` what was checked, line by line, and what the paper has right and wrong; writes the rest to `out`.
///
/// # Errors
/// [`Error::Comparison`] if a run exceeds the bound of its distance from the oracle or of its energy balance, or a stiff case is WRONG; the
/// files are written all the same. Errors of the runs.
pub fn main_job(out: &Path, print: impl Fn(&str) -> Result<()>) -> Result<()> {
    let clock = Instant::now();
    // First, so that a folder that cannot be written is found before the work.
    let names = [
        &[figure1::FILE, figure2::FILE][..],
        &pendulum::PICTURES,
        &section4::PICTURES,
        &error_time::FILES,
        &stability::FILES,
        &FILES,
    ];
    let mut files = Files::in_folder(out, names.concat(), &[])?;
    let (known, pinned, solids) = (Oracle::load()?, Structures::load()?, Continuum::load()?);
    let mut checks: Vec<Check> = Vec::new();
    let mut checked = |check: Check| {
        let line = check.line();
        checks.push(check);
        print(&line)
    };
    print("Peng et al. (2018), computed again: what was checked, and how many are within their bounds\n")?;

    let oracle = known.compare()?;
    checked(Check::of(
        "the pendulum on the oracle's meshes (strain energy alone, SciPy)",
        oracle.iter().map(Comparison::holds),
    ))?;
    let structures = pinned.compare()?;
    checked(Check::of(
        "pinned rods against the oracle, stiff scissors against rigid ones",
        structures.iter().map(Comparison::holds),
    ))?;
    let (stability, stability_picture) = stability::part(&mut files)?;
    checked(Check::of(
        "stiff and extreme cases, fast rows: right, warned of or refused",
        stability.rows().map(|row| row.verdict != Verdict::Wrong),
    ))?;
    let models = pendulum::simulate()?;
    let errors = model_error::errors(&models, &solids)?;
    let shear = model_error::shear(&models, &solids, &known.shear)?;
    let continuum = model_error::bars(&models, &errors, &shear);
    checked(Check::of("the pendulum against a plane solid", continuum.iter().map(Comparison::holds)))?;
    let structure = Structure::simulate(&reading::ASSUMED)?;
    let family = &structure.fine;
    let energy = vec![
        Balance::of("flexible", &family.flexible),
        Balance::of("1D", &family.axis),
        Balance::of("2D", &family.axis_and_section),
    ];
    checked(Check::of("energy of three scissors, at every step", energy.iter().map(Balance::holds)))?;

    let (statements, locking) = (claims_section3::measure(&models, &solids)?, locking::measure()?);
    let claims = claims_section4::measure(&structure);
    let of_pendulum: Vec<Statement> =
        std::iter::once(Statement::from(&locking)).chain(statements.iter().map(Statement::from)).collect();
    let of_structure: Vec<Statement> = claims.iter().map(Statement::from).collect();
    let readings = Readings::kept()?;
    let agreeing = readings.agree(&of_structure);
    checked(Check::of("verdicts on the structure, the same as in the stored study of readings", agreeing))?;
    let of_structure: Vec<Statement> = of_structure.into_iter().map(|statement| readings.judge(statement)).collect();
    print("\nThe paper on its pendulum (Section 3), measured\n")?;
    print(&first_screen::verdicts(&of_pendulum))?;
    print("The paper on its structure (Section 4), under 8 readings of figures that its text does not have\n")?;
    print(&first_screen::verdicts(&of_structure))?;

    // On an idle machine: it measures times.
    let options = error_time::Options { quick: true, ..Default::default() };
    let (error_time, error_time_picture) = error_time::part(&options, &mut files, |_| Ok(()))?;

    let compared = oracle.iter().chain(&continuum).chain(&structures);
    let failed = compared.filter(|row| !row.holds()).map(ToString::to_string);
    let balances = energy.iter().filter(|e| !e.holds()).map(ToString::to_string);
    let kept = (claims.iter().map(Statement::from))
        .filter(|fresh| !readings.agree(std::slice::from_ref(fresh)).all(|agrees| agrees))
        .map(|fresh| {
            format!("{}: {} is not what study/readings.json keeps: run `ancf readings`", fresh.brief, fresh.standing)
        });
    let failed: Vec<String> =
        failed.chain(balances).chain(kept).chain(stability.wrong().map(StabilityRow::line)).collect();
    let mut pictures = pendulum::pictures(&models, &known.rigid, &solids)?;
    pictures.extend(section4::pictures(&structure)?);
    pictures.extend([figure1::picture(), figure2::picture()?]);
    for picture in &pictures {
        files.write_text(picture.file, picture.svg.clone())?;
    }
    pictures.extend([
        Picture {
            file: "error-time.svg",
            caption: "Error against run time of each method, mesh and step: lower left is better.",
            svg: error_time_picture,
        },
        Picture {
            file: "stability.svg",
            caption: "Error of each case against the swept parameter, with its bound.",
            svg: stability_picture,
        },
    ]);
    let a4 = section4::rows(&structure);
    let mut tables = page_tables(&models, &known, &errors, &shear, [&oracle, &structures, &continuum], &a4, &energy);
    tables.insert(
        0,
        Titled {
            title: "The structure's statements under every reading".into(),
            note: "Measured by `ancf readings`: each cell from undamped and damped runs of two meshes.",
            table: readings.table(),
        },
    );
    let wall_seconds = clock.elapsed().as_secs_f64();
    let story = Story {
        checks,
        pendulum: of_pendulum,
        structure: of_structure,
        pictures,
        tables,
        error_time,
        stability,
        seconds: wall_seconds,
    };
    files.write_text("paper.html", paper_page::page(&story))?;
    files.write_table("pendulum.csv", |file| pendulum::curves(&models).write_csv(file))?;
    files.write_table("scissors.csv", |file| section4::curves(&structure).write_csv(file))?;
    let report = Report {
        wall_seconds,
        oracle,
        continuum,
        tip: models.iter().flat_map(Model::rows).collect(),
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
    let written = files.publish()?;
    let page = out.join("paper.html");
    print(&format!("\nPictures and numbers: {}; {} files, {wall_seconds:.0} s\n", page.display(), written.len()))?;
    match failed.first() {
        None => Ok(()),
        Some(first) => Err(Error::Comparison { count: failed.len(), first: first.clone() }),
    }
}

/// The tables at the end of the page.
fn page_tables(
    models: &[Model],
    known: &Oracle,
    errors: &[ErrorRow],
    shear: &[ShearRow],
    [oracle, structures, continuum]: [&[Comparison]; 3],
    a4: &[A4Row],
    energy: &[Balance],
) -> Vec<Titled> {
    let titled = |title: &str, note, table| Titled { title: title.into(), note, table };
    let mut tables = vec![titled(
        "The pendulum on the oracle's meshes",
        "The oracle has the strain energy alone and SciPy's DOP853; t = 0 … 0.5 s.",
        tables::compared(oracle),
    )];
    for model in models {
        let Mesh { elements, step, .. } = model.kind.mesh;
        tables.push(titled(
            &format!("Tip of the pendulum: {}, {elements} elements, explicit, step {step:.0e} s", model.kind.name),
            "The distance from the oracle's position with four elements is that of the mesh.",
            tables::tip(model, known),
        ));
    }
    for start in ["sudden", "relaxed"] {
        tables.push(titled(
            &format!("Distance between the models' tips, mm, {start} start"),
            "The paper's Figure 4. Its 1D model is Euler–Bernoulli; 1D without a name is the paper's own element, heated along its axis.",
            tables::differences(models, start),
        ));
    }
    tables.extend([
        titled(
            "Distance of the tip from the plane solid with the same heat, m",
            "Space: change by twice the elements. Time: change by twice the step. The remainder is at least the model's error.",
            tables::errors(errors),
        ),
        titled(
            "The flexible tip with a shear correction, m",
            "The element has no shear correction factor. Its effect is the oracle's, with 16 elements.",
            tables::shear(shear),
        ),
        titled("Bounds of the distance from the plane solid", "The error is the solid's own.", tables::compared(continuum)),
        titled(
            "Pinned rods at different temperatures, and stiff scissors",
            "Named by their elements; the oracle has free coordinates, t = 0 … 0.5 s. rigid-3: three scissors with E · 10⁴ beside the rigid \
             mechanism, t = 0 … 2.9 s.",
            tables::compared(structures),
        ),
        titled(
            &format!("Point a4: {ELEMENTS} elements a rod, energy–momentum, step {STEP:.0e} s"),
            "Changes by another step and another mesh, m.",
            tables::a4(a4),
        ),
        titled("Energy of three scissors", "At every step, over the energy put in.", tables::energies(energy)),
    ]);
    tables
}
