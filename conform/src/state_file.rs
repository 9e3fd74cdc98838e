//! States from files and from the fixtures.

use std::fs::File;
use std::io::{self, ErrorKind, Read};

use ancf::internals::model::nearest;
use ancf::state::{CableState, ElementState};
use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::error::{Error, Result};
use crate::suite::{State, Suite};

/// Largest file that is read, bytes: a state has some thousand.
const LARGEST: u64 = 1 << 20;

/// Reads the state of an ANCF or Euler–Bernoulli element from a file. If there is no such file, `name` is that of a stored state, which
/// may also be the terms of (23) of a structure.
///
/// # Errors
/// [`Error::NoState`] if there is neither, [`Error::Read`] if the file cannot be read, [`Error::State`] with file, key, value and allowed
/// values if it is invalid.
pub fn load(name: &str) -> Result<State> {
    match read(name) {
        Ok(text) => State::parse(&text, name),
        Err(source) if source.kind() != ErrorKind::NotFound => Err(Error::Read { path: name.into(), source }),
        Err(_) => {
            let mut cases = Suite::embedded()?.cases;
            match cases.iter().position(|case| case.id == name) {
                Some(n) => Ok(cases.swap_remove(n).state),
                None => Err(unknown(name, cases.iter().map(|case| case.id.as_str()).collect())),
            }
        }
    }
}

impl State {
    /// Reads the state of an ANCF or Euler–Bernoulli element from JSON `text`; `file` is the name in messages.
    ///
    /// # Errors
    /// [`Error::State`] with file, key, value and allowed values.
    pub fn parse(text: &str, file: &str) -> Result<State> {
        if is_of_a_cable(text) {
            Ok(State::Cable(Box::new(CableState::parse(text, file)?)))
        } else {
            Ok(State::Element(Box::new(ElementState::parse(text, file)?)))
        }
    }
}

/// Text of a file, unless it is too large or has no end.
fn read(name: &str) -> io::Result<String> {
    let mut text = String::new();
    if File::open(name)?.take(LARGEST + 1).read_to_string(&mut text)? as u64 > LARGEST {
        return Err(io::Error::new(
            ErrorKind::FileTooLarge,
            format!("it has more than {LARGEST} bytes, which no state needs"),
        ));
    }
    Ok(text)
}

/// Whether a state has the eight nodal coordinates of a cable element.
fn is_of_a_cable(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Coordinates {
        e: Vec<IgnoredAny>,
    }
    serde_json::from_str::<Coordinates>(text).is_ok_and(|state| state.e.len() == 8)
}

fn unknown(name: &str, known: Vec<&str>) -> Error {
    let nearest = nearest(name, known.iter().copied()).map(|like| format!("; nearest: `{like}`")).unwrap_or_default();
    Error::NoState { name: name.into(), nearest, known: known.join(", ") }
}
