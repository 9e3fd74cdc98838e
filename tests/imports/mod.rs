//! Which file of a crate imports from which.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::path::Path;

/// Files that re-export from everywhere.
const SHOW_ALL: [&str; 3] = ["lib", "internals", "main"];

/// Top-level module of a file.
fn module(file: &str) -> &str {
    file.split("::").next().unwrap_or(file)
}

/// The sources of a crate: module path (`model::json::parse`, `lib`) → text without comments and unit tests.
pub struct Sources(BTreeMap<String, String>);

/// One file that takes something from another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Import {
    pub from: String,
    pub to: String,
    /// What it names.
    pub path: String,
}

impl fmt::Display for Import {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} takes {} from {}", self.from, self.path, self.to)
    }
}

impl Sources {
    /// All files below a folder.
    pub fn read(folder: &Path) -> Sources {
        let mut files = BTreeMap::new();
        let mut folders = vec![folder.to_path_buf()];
        while let Some(inner) = folders.pop() {
            for entry in fs::read_dir(&inner).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let name = path.strip_prefix(folder).unwrap().with_extension("");
                    let mut parts: Vec<&str> = name.iter().map(|part| part.to_str().unwrap()).collect();
                    if parts.last() == Some(&"mod") {
                        parts.pop();
                    }
                    if parts.last() != Some(&"tests") {
                        files.insert(parts.join("::"), code(&fs::read_to_string(&path).unwrap()));
                    }
                }
            }
        }
        Sources(files)
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Adds a line to a file.
    pub fn add_line(&mut self, file: &str, line: &str) {
        let text = self.0.get_mut(file).unwrap_or_else(|| panic!("there is no file {file}"));
        *text = format!("{line}\n{text}");
    }

    /// All imports between different files, each once.
    pub fn imports(&self) -> Vec<Import> {
        let mut imports = BTreeSet::new();
        for (file, text) in &self.0 {
            let used = statements(text)
                .into_iter()
                .flat_map(|(public, tree)| leaves(&tree).into_iter().map(move |path| (public, path)));
            for (public, path) in used.chain(paths(text).into_iter().map(|path| (false, path))) {
                let to = self.resolve(file, &path);
                // A module shows what its own files have, the crate's root what all have.
                let shows = |to: &str| public && (module(to) == module(file) || SHOW_ALL.contains(&file.as_str()));
                if let Some(to) = to.filter(|to| to != file && !shows(to)) {
                    imports.insert(Import { from: file.clone(), to, path });
                }
            }
        }
        imports.into_iter().collect()
    }

    /// The file that an item comes from; `None` for one of another crate.
    fn resolve(&self, file: &str, path: &str) -> Option<String> {
        let here: Vec<&str> = if file == "lib" || file == "main" { Vec::new() } else { file.split("::").collect() };
        let mut parts: Vec<&str> = path.split("::").collect();
        let mut module: Vec<&str> = match parts.remove(0) {
            "crate" => Vec::new(),
            "self" => here.clone(),
            "super" => here[..here.len() - 1].to_vec(),
            // A module of this file, or another crate.
            first => {
                parts.insert(0, first);
                here.clone()
            }
        };
        let is_local = path.starts_with("crate::") || path.starts_with("self::") || path.starts_with("super::");
        while parts.first() == Some(&"super") {
            parts.remove(0);
            module.pop();
        }
        let mut moved = false;
        while let Some(&part) = parts.first() {
            let inner = [&module[..], &[part]].concat().join("::");
            if !self.0.contains_key(&inner) {
                break;
            }
            module.push(part);
            parts.remove(0);
            moved = true;
        }
        if !is_local && !moved {
            return None;
        }
        let module = if module.is_empty() { self.root() } else { module.join("::") };
        match parts.first() {
            Some(item) => Some(self.origin(&module, item).unwrap_or(module)),
            None => Some(module),
        }
    }

    fn root(&self) -> String {
        if self.0.contains_key("lib") { "lib".into() } else { "main".into() }
    }

    /// Where an item that a file re-exports comes from.
    fn origin(&self, file: &str, item: &str) -> Option<String> {
        let exported = statements(self.0.get(file)?).into_iter().filter(|(public, _)| *public);
        let found = exported.flat_map(|(_, tree)| leaves(&tree)).find(|path| path.rsplit("::").next() == Some(item))?;
        self.resolve(file, &found).filter(|origin| origin != file)
    }
}

/// The text without comments and unit tests: a `mod tests` in the file ends it, one in another file is a line.
fn code(text: &str) -> String {
    let text = text.replace("#[cfg(test)]\nmod tests;\n", "");
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    text.lines().map(|line| line.split("//").next().unwrap_or_default().to_string() + "\n").collect()
}

/// The trees of all `use` statements, and whether they are public.
fn statements(text: &str) -> Vec<(bool, String)> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("use ") {
        let (before, after) = rest.split_at(at);
        let line = before.rsplit('\n').next().unwrap_or_default().trim();
        rest = &after[4..];
        let is_public = line.starts_with("pub");
        if (line.is_empty() || (is_public && !line.contains(' ')))
            && let Some(end) = rest.find(';')
        {
            found.push((is_public, rest[..end].split_whitespace().collect::<Vec<_>>().join(" ")));
            rest = &rest[end..];
        }
    }
    found
}

/// The paths of a tree such as `a::{b, c::{self, d}}`; a name after `as` is left out.
fn leaves(tree: &str) -> Vec<String> {
    let Some(open) = tree.find('{') else {
        let path = tree.split(" as ").next().unwrap_or_default().trim();
        return vec![path.trim_end_matches("::self").to_string()];
    };
    let prefix = &tree[..open];
    let inner = &tree[open + 1..tree.rfind('}').unwrap_or(tree.len())];
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&inner[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&inner[start..]);
    let parts = parts.into_iter().map(str::trim).filter(|part| !part.is_empty());
    parts.flat_map(|part| leaves(&format!("{prefix}{part}"))).collect()
}

/// Paths from `crate::` and `super::` in the code beside `use` statements.
fn paths(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in text.lines().filter(|line| !line.trim_start().starts_with("use ") && !line.contains("pub use")) {
        for start in ["crate::", "super::"] {
            for (at, _) in line.match_indices(start) {
                let is_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
                let begins = !line[..at].ends_with(|c: char| is_name(c) || c == '$');
                let path: String = line[at..].chars().take_while(|c| is_name(*c)).collect();
                if begins && !line[..at].trim_end().ends_with("pub(in") {
                    found.push(path.trim_end_matches(':').to_string());
                }
            }
        }
    }
    found
}
