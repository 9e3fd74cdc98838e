//! `ancf modes`: frequencies, shapes and buckling factors of a scene's structure.

mod file;
mod page;
mod picture;

pub use file::ModesFile;

use std::path::Path;

use ancf::model::Model;
use ancf::run::{About, Buckling, Kind, Mode, Modes, buckling, modes};
use ancf_study::files::{Files, written_lines};

use crate::error::Result;

/// Files of the command.
const FILES: [&str; 2] = ["modes.json", "modes.html"];

/// What `ancf modes` is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// State to vibrate about; `None`: the loaded one of statics and of buckling, otherwise the unloaded one.
    pub about: Option<About>,
    /// Number of vibrations.
    pub number: usize,
    /// Compute the buckling factor.
    pub buckling: bool,
}

/// Computes the modes of a model, `name` of which is a built-in scene or a file, writes their files into `folder`, and returns a text
/// for people.
///
/// # Errors
/// Bad input; an equilibrium that is not found; files that cannot be written.
pub fn run(model: &Model, name: &str, options: Options, folder: &Path) -> Result<String> {
    let scene = model.scene();
    // First, so that a folder that cannot be written is not found after the work.
    let mut files = Files::in_folder(folder, FILES, &[Path::new(name)])?;
    let by_default = if options.buckling { About::Loaded } else { About::of(scene) };
    let about = options.about.unwrap_or(by_default);
    let found = modes(model, about, options.number)?;
    let buckled = if options.buckling { Some(buckling(model, about)?) } else { None };
    files.identify(scene.to_text().as_bytes());
    files.identify(format!("{} {}", about.word(), options.number).as_bytes());
    let id = files.run_id();
    files.write(FILES[0], |out| file::write(out, &ModesFile::of(&id, scene, &found, buckled.as_ref())))?;
    files.write_text(FILES[1], page::text(scene, &found, buckled.as_ref()))?;
    Ok(text(&found, buckled.as_ref()) + &written_lines(&files.publish()?))
}

/// The table of modes, and what buckles.
fn text(found: &Modes, buckled: Option<&Buckling>) -> String {
    let mut text = heading(found) + ":\n\n  number  frequency, Hz  kind\n";
    for (n, mode) in found.modes.iter().enumerate() {
        text += &format!("  {:>6}  {:>13}  {}\n", n + 1, frequency(mode), kind(mode));
    }
    text += "\n";
    buckled.map_or(text.clone(), |buckled| text + &sentence(buckled) + "\n")
}

/// What the modes are those of.
fn heading(found: &Modes) -> String {
    let state = match found.about {
        About::Unloaded => "cold and without loads",
        About::Heated => "in equilibrium under the heat",
        About::Loaded => "in equilibrium under all loads",
    };
    format!("Modes of the structure {state}, {} unknowns", found.unknowns)
}

/// A frequency with six digits.
fn frequency(mode: &Mode) -> String {
    match mode.frequency() {
        Some(0.0) => "0".into(),
        Some(hertz) => six_digits(hertz),
        None => "–".into(),
    }
}

fn kind(mode: &Mode) -> String {
    match mode.growth() {
        Some(growth) => format!("{}: grows like e^({} t)", word(mode.kind), six_digits(growth)),
        None => word(mode.kind).into(),
    }
}

/// Word for a kind, in texts and files.
fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Rigid => "rigid",
        Kind::Mechanism => "mechanism",
        Kind::Vibration => "vibration",
        Kind::Unstable => "unstable",
    }
}

/// What buckles, in a sentence.
fn sentence(buckled: &Buckling) -> String {
    let what = if buckled.about == About::Heated { "heat" } else { "loads" };
    let linearised = match buckled.linearised {
        Some(factor) => format!("{} times the {what} by the linearised stiffness", six_digits(factor)),
        None => format!("by the linearised stiffness no multiple of the {what}"),
    };
    let on_path = match buckled.factor {
        Some(factor) => format!("{} times on the path of equilibria", six_digits(factor)),
        None => format!("on the path none up to {} times", six_digits(buckled.followed)),
    };
    format!("Buckles at: {linearised}; {on_path}.")
}

fn six_digits(number: f64) -> String {
    if (1e-3..1e6).contains(&number.abs()) {
        let decimals = (5.0 - number.abs().log10().floor()).max(0.0) as usize;
        format!("{number:.decimals$}")
    } else {
        format!("{number:.5e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits() {
        let shown = [0.001, 2.8826609993, 123456.7, 3.1e-7, 1.25e9].map(six_digits);
        assert_eq!(shown, ["0.00100000", "2.88266", "123457", "3.10000e-7", "1.25000e9"]);
    }
}
