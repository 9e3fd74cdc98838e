//! Numbers that `docs/evidence.md` tells. A test prints each; where `ANCF_MEASURED` names a file, it is added there, for `docs/numbers.py`.

use std::fmt::{Debug, Display};
use std::fs::OpenOptions;
use std::io::Write;

/// Something that is at most this large: the page tells the largest of all that have the name.
pub fn at_most(name: &str, value: f64) {
    write("at-most", name, value);
}

/// A number by itself: of two with one name the page tells the last. `name.0`, `name.1`, … are told in a row.
pub fn number(name: &str, value: impl Display + Debug) {
    write("number", name, value);
}

/// Numbers in a row.
pub fn numbers(name: &str, values: &[f64]) {
    for (n, value) in values.iter().enumerate() {
        number(&format!("{name}.{n}"), value);
    }
}

fn write(kind: &str, name: &str, value: impl Debug) {
    println!("measured: {name} {value:?}");
    let Ok(path) = std::env::var("ANCF_MEASURED") else { return };
    // One line, written at once: tests run side by side.
    let mut file =
        OpenOptions::new().append(true).create(true).open(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    file.write_all(format!("{kind} {name} {value:?}\n").as_bytes()).unwrap_or_else(|error| panic!("{path}: {error}"));
}
