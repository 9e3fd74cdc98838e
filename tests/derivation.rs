//! The derivation, `oracle/DERIVATION.md`, and the documentation of the code name each other's places, and these exist.
//! That its formulas are right is for its own program to say: `python -m oracle derivation --check`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ancf::internals::equations::CONTENTS;

const PAGE: &str = "oracle/DERIVATION.md";

fn read(path: impl AsRef<Path>) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The page's headings, without their marks.
fn headings(page: &str) -> Vec<&str> {
    page.lines().filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim()).collect()
}

/// A heading's anchor, as GitHub makes it.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase().replace(' ', "-");
    kept.chars().filter(|c| c.is_alphanumeric() || *c == '-' || *c == '_').collect()
}

fn anchors(page: &str) -> BTreeSet<String> {
    headings(page).into_iter().map(anchor).collect()
}

/// The anchor of the section of an equation's number.
fn section(page: &str, equation: &str) -> Option<String> {
    let start = format!("({equation}) ");
    headings(page).into_iter().find(|heading| heading.starts_with(&start)).map(anchor)
}

/// Markdown's links, as text and target.
fn links(text: &str) -> Vec<(&str, &str)> {
    let whole = |at: usize| {
        let from = text[..at].rfind('[')? + 1;
        let target = text[at + 2..].split(')').next()?;
        Some((&text[from..at], target))
    };
    text.match_indices("](").filter_map(|(at, _)| whole(at)).collect()
}

/// Sections that a text names in backquotes, with the page's name or without: `#the-tangent`.
fn sections_named(text: &str) -> BTreeSet<String> {
    let quoted = text.split('`').filter_map(|part| part.trim_start_matches(PAGE).strip_prefix('#'));
    quoted.filter(|anchor| !anchor.contains([' ', '[', '\n'])).map(str::to_owned).collect()
}

#[test]
fn every_link_of_the_page_leads_somewhere() {
    let page = read(PAGE);
    let anchors = anchors(&page);
    let links = links(&page);
    assert!(links.len() > 50, "{} links", links.len());
    for (text, target) in links {
        if let Some(anchor) = target.strip_prefix('#') {
            assert!(anchors.contains(anchor), "#{anchor} is no heading");
        } else if !target.starts_with("https://") {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracle").join(target);
            assert!(path.exists(), "{target} does not exist");
            if let Some((_, item)) = text.trim_matches('`').split_once("::") {
                let source = read(path);
                let there = ["fn", "struct"].iter().any(|kind| {
                    let start = format!("pub {kind} {item}");
                    source.split(&start).skip(1).any(|rest| rest.starts_with(['(', '<', ' ']))
                });
                assert!(there, "{target} has no {item}");
            }
        }
    }
}

#[test]
fn every_equation_has_its_section_and_every_function_its_link() {
    let page = read(PAGE);
    let linked: BTreeSet<&str> = links(&page).into_iter().map(|(text, _)| text.trim_matches('`')).collect();
    for entry in CONTENTS.iter().filter(|entry| !entry.equation.is_empty()) {
        assert!(section(&page, entry.equation).is_some(), "({}) has no section", entry.equation);
        assert!(linked.contains(entry.function), "{} is not linked", entry.function);
    }
}

#[test]
fn the_documentation_names_sections_that_exist() {
    let page = read(PAGE);
    let anchors = anchors(&page);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/equations");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    files.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/elements/ancf.rs"));
    for file in files {
        let named = sections_named(&read(&file));
        for anchor in &named {
            assert!(anchors.contains(anchor), "{}: #{anchor} is no heading of the page", file.display());
        }
        let module = file.file_stem().unwrap().to_str().unwrap();
        for entry in CONTENTS.iter().filter(|entry| entry.function.split("::").next() == Some(module)) {
            if !entry.equation.is_empty() {
                let section = section(&page, entry.equation).unwrap();
                assert!(named.contains(&section), "{}: #{section} is not named", file.display());
            }
        }
    }
}
