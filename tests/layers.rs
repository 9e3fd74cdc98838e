//! Imports run downwards: between the library's modules in the order of [`LAYERS`], and without a circle among the files of any crate.
//!
//! An import is a `use` line, or a path from `crate::` in the code. A `mod` line is none, and neither is a
//! re-export (`pub use`) of a module's own files: what is taken from it is taken from the file that it comes from.

mod imports;

use std::collections::BTreeMap;
use std::path::Path;

use imports::{Import, Sources};

/// The library's modules from the bottom up; those of one line do not know one another.
const LAYERS: [&[&str]; 11] = [
    &["error"],
    &["lanes"],
    &["equations"],
    &["model"],
    &["state", "elements", "linear"],
    &["structure"],
    &["integrators"],
    &["run"],
    &["schema"],
    &["internals"],
    &["lib"],
];

/// Folder of a crate's sources, and the fewest files that it has: a folder that is not found would have no circles.
const CRATES: [(&str, usize); 4] = [("src", 60), ("conform/src", 20), ("study/src", 40), ("cli/src", 3)];

fn read(crate_: &str) -> Sources {
    Sources::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(crate_))
}

/// Number of a module's layer, from the bottom.
fn layer(file: &str) -> usize {
    let module = file.split("::").next().unwrap_or(file);
    LAYERS.iter().position(|layer| layer.contains(&module)).unwrap_or_else(|| panic!("`{module}` has no layer"))
}

/// Imports that do not run downwards: up, or to another module of the same layer.
fn upwards(imports: &[Import]) -> Vec<&Import> {
    let module = |file: &str| file.split("::").next().map(str::to_string);
    let crosses_modules = |import: &&Import| module(&import.from) != module(&import.to);
    imports.iter().filter(crosses_modules).filter(|import| layer(&import.to) >= layer(&import.from)).collect()
}

/// Files that import one another in a circle, each with the import that leads on.
fn circles(imports: &[Import]) -> Vec<Vec<&Import>> {
    let mut left: BTreeMap<&str, Vec<&Import>> = BTreeMap::new();
    for import in imports {
        left.entry(&import.from).or_default().push(import);
    }
    let mut circles = Vec::new();
    while !left.is_empty() {
        // A file that imports nothing that is left is in no circle.
        let free = left.iter().find(|(_, imports)| imports.iter().all(|import| !left.contains_key(&*import.to)));
        if let Some(free) = free.map(|(file, _)| *file) {
            left.remove(free);
            continue;
        }
        // From any file on, the first import that is left leads into a circle.
        let next = |file: &str| left[file].iter().copied().find(|import| left.contains_key(&*import.to));
        let mut path: Vec<&Import> = Vec::new();
        let mut file: &str = left.keys().next().unwrap();
        let start = loop {
            let import = next(file).unwrap();
            if let Some(start) = path.iter().position(|earlier| earlier.from == import.from) {
                break start;
            }
            path.push(import);
            file = &import.to;
        };
        let circle = path.split_off(start);
        left.remove(&*circle[0].from);
        circles.push(circle);
    }
    circles
}

fn text(imports: &[&Import]) -> String {
    imports.iter().map(|import| format!("  {import}\n")).collect()
}

#[test]
fn the_library_imports_downwards() {
    let imports = read("src").imports();
    assert!(imports.len() > 200, "only {} imports were found", imports.len());
    let upwards = upwards(&imports);
    assert!(upwards.is_empty(), "{} imports do not run downwards:\n{}", upwards.len(), text(&upwards));
}

#[test]
fn no_crate_has_a_circle_of_imports() {
    for (crate_, least) in CRATES {
        let sources = read(crate_);
        assert!(sources.len() >= least, "{crate_}: only {} files", sources.len());
        let imports = sources.imports();
        let circles = circles(&imports);
        let all: String = circles.iter().map(|circle| format!("{}\n", text(circle))).collect();
        assert!(circles.is_empty(), "{crate_}: {} circles of imports:\n{all}", circles.len());
    }
}

/// One more import is found: upwards, to a neighbour, in a circle, through a re-export or as a path in the code.
#[test]
fn a_new_arrow_upwards_and_a_new_circle_are_found() {
    for (file, line, is_upwards, is_circle) in [
        ("equations::force", "use crate::run::Simulation;", true, true),
        ("elements::ancf", "use crate::linear::Layout;", true, false),
        ("model::scene", "fn f(_: crate::structure::Structure) {}", true, true),
        ("model", "pub use crate::run::Simulation;", true, true),
        ("equations::element", "use super::force::U;", false, true),
        ("model::rod", "use crate::model::{Model, Probe};", false, true),
        ("integrators::state", "use super::Integrator;", false, true),
    ] {
        let mut sources = read("src");
        sources.add_line(file, line);
        let imports = sources.imports();
        assert_eq!(!upwards(&imports).is_empty(), is_upwards, "{file}: {line}");
        assert_eq!(!circles(&imports).is_empty(), is_circle, "{file}: {line}");
    }
}
