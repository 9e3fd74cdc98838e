//! `paper.html`: each statement of the paper beside its picture and its numbers.

use crate::error_time::ErrorTimeStudy;
use crate::first_screen::{self, Check};
use crate::html::Html;
use crate::paper::statement::Statement;
use crate::picture::Picture;
use crate::stability::StabilityStudy;
use crate::table::Table;
use crate::{error_time, stability};

/// A table under a title, with a note.
pub struct Titled {
    pub title: String,
    pub note: &'static str,
    pub table: Table,
}

/// What the page shows.
pub struct Story {
    pub checks: Vec<Check>,
    /// The statements of Sections 3 and 4.
    pub pendulum: Vec<Statement>,
    pub structure: Vec<Statement>,
    pub pictures: Vec<Picture>,
    /// Comparisons with oracles and solid, and positions.
    pub tables: Vec<Titled>,
    pub error_time: ErrorTimeStudy,
    pub stability: StabilityStudy,
    pub seconds: f64,
}

/// A part of the page: pictures, and the statements that they belong to, by their numbers.
struct Scene {
    title: &'static str,
    text: &'static str,
    pictures: &'static [&'static str],
    statements: std::ops::Range<usize>,
}

const PENDULUM: [Scene; 4] = [
    Scene {
        title: "The element",
        text: "A rod is a chain of such elements. The slope across lets its section turn by itself, stretch and shear.",
        pictures: &["figure1.svg"],
        statements: 0..1,
    },
    Scene {
        title: "The whole motion",
        text: "The pendulum of Table 1 falls from the horizontal; heat of 200 K is there from t = 0. A plane solid stands in for the paper's \
               ANSYS curve.",
        pictures: &["figure2.svg", "figure3.svg"],
        statements: 1..3,
    },
    Scene {
        title: "What heat changes",
        text: "The distance of each model from the solid, over time. Relaxed: the rod begins at its stress-free length. Sudden: it begins cold, \
               and an axial wave runs through it.",
        pictures: &["figure4.svg"],
        statements: 3..8,
    },
    Scene { title: "Which model is the more precise one", text: "", pictures: &[], statements: 8..10 },
];

const STRUCTURE: [Scene; 3] = [
    Scene {
        title: "The structure",
        text: "Three scissor-like elements of Table 2, driven by 50 N at a1. Figures 5 and 6 are not in the paper's text: 80° at the start, the \
               supports, and straight lines between the temperature's corners are assumed.",
        pictures: &["deployment.svg", "structure.svg", "figure6.svg"],
        statements: 0..0,
    },
    Scene {
        title: "Deflections",
        text: "Deflection of the rods' middles from the chord, with and without heat.",
        pictures: &["figure7.svg"],
        statements: 0..6,
    },
    Scene {
        title: "The point a4",
        text: "The sudden force starts axial waves without damping: acceleration at an instant does not converge with mesh and step. Its mean over \
               20 ms does.",
        pictures: &["figure8-x.svg", "figure8-y.svg"],
        statements: 6..11,
    },
];

/// Errors in the paper's equations, which `oracle/` proves and `tests/errata.rs` shows.
const ERRORS: [[&str; 5]; 4] = [
    ["E1", "(A.3), a₁", "… + rᵏ …", "… − rᵏ …", "the nodal conditions (A.2) are missed"],
    ["E2", "(21), K₃", "S_c1 (eᵀS_c e − 1)", "S_c1 (eᵀS_c e)", "the undeformed element is not in equilibrium"],
    [
        "E3",
        "(16), (18)",
        "shear energy ½·2μ ε₁₂²",
        "½·4μ ε₁₂²",
        "a rod at 45° loses a quarter of its bending stiffness",
    ],
    ["E4", "(23)", "Φ_q λ", "Φ_qᵀ λ", "reactions do work on motions that the constraints allow"],
];

/// The page.
pub fn page(story: &Story) -> String {
    let mut html = Html::default();
    let Story { checks, pendulum, structure, tables, error_time, stability, seconds, .. } = story;
    html.section("checked", "What was checked");
    html.table(&first_screen::checks(checks));
    html.section("verdicts", "What the paper says, measured");
    html.subheading("Of the pendulum, Section 3");
    html.verdicts(pendulum.iter().enumerate().map(|(n, statement)| (id("pendulum", n), statement)));
    html.subheading("Of the structure, Section 4, under eight readings of figures that its text does not have");
    html.verdicts(structure.iter().enumerate().map(|(n, statement)| (id("structure", n), statement)));
    html.section("errors", "Errors in the equations");
    html.table(&Table::new(
        "error | where | printed | must be | how it shows",
        ERRORS.iter().map(|row| row.map(Into::into).to_vec()),
    ));
    html.section("section-3", "Section 3: the heated pendulum");
    PENDULUM.iter().for_each(|scene| story.scene(&mut html, "pendulum", pendulum, scene));
    html.section("section-4", "Section 4: the deployable structure");
    STRUCTURE.iter().for_each(|scene| story.scene(&mut html, "structure", structure, scene));
    html.section("tables", "Comparisons and positions");
    for Titled { title, note, table } in tables {
        html.subheading(title);
        html.paragraph(note);
        html.table(table);
    }
    html.section("error-time", "Error against run time");
    html.paragraph(
        "A part of `ancf error-time`: the flexible pendulum on a coarse grid. error-time.html has all of it.",
    );
    story.picture(&mut html, "error-time.svg");
    for (name, table) in error_time::fastest(error_time) {
        html.subheading(&name);
        html.table(&table);
    }
    html.section("stability", "Stiff and extreme cases");
    html.paragraph("The fast rows of `ancf stability`, counted by verdict. stability.html has each row.");
    story.picture(&mut html, "stability.svg");
    html.table(&stability::counts_table(stability));
    html.section("files", "Files");
    html.paragraph(&format!(
        "main.json has the numbers with all digits, pendulum.csv and scissors.csv the curves. Computed in {seconds:.0} s."
    ));
    html.page("Peng et al. (2018), computed again")
}

/// The anchor of a statement.
fn id(section: &str, n: usize) -> String {
    format!("{section}-{}", n + 1)
}

impl Story {
    fn scene(&self, html: &mut Html, section: &str, statements: &[Statement], scene: &Scene) {
        html.subheading(scene.title);
        if !scene.text.is_empty() {
            html.paragraph(scene.text);
        }
        scene.pictures.iter().for_each(|file| self.picture(html, file));
        for (n, statement) in statements.iter().enumerate().filter(|(n, _)| scene.statements.contains(n)) {
            html.statement(&id(section, n), statement);
        }
    }

    fn picture(&self, html: &mut Html, file: &str) {
        let known = self.pictures.iter().find(|picture| picture.file == file);
        known.iter().for_each(|picture| html.figure(&picture.svg, picture.caption));
    }
}
