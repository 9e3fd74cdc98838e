//! A state from a file, or a stored one.

use std::io::ErrorKind;

use ancf::internals::nearest;
use ancf::state::{CableState, ElementState};
use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::error::{Error, Result};
use crate::suite::{Parsed, Suite};

/// The state of a file, of an element or of a cable element; or the stored state of that name, also the terms of (23) of a structure.
///
/// # Errors
/// [`Error::NoState`] if there is neither, [`Error::Read`] if the file cannot be read, [`Error::Scene`] with file, key, value and
/// what is allowed if it holds no state.
pub fn load(name: &str) -> Result<Parsed> {
    match std::fs::read_to_string(name) {
        Ok(text) if is_of_a_cable(&text) => Ok(Parsed::Cable(Box::new(CableState::parse(&text, name)?))),
        Ok(text) => Ok(Parsed::Element(Box::new(ElementState::parse(&text, name)?))),
        Err(source) if source.kind() != ErrorKind::NotFound => Err(Error::Read { path: name.into(), source }),
        Err(_) => {
            let mut cases = Suite::embedded()?.cases;
            match cases.iter().position(|case| case.id == name) {
                Some(place) => Ok(cases.swap_remove(place).parsed),
                None => Err(unknown(name, cases.iter().map(|case| case.id.as_str()).collect())),
            }
        }
    }
}

/// Cable elements have eight nodal coordinates.
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
