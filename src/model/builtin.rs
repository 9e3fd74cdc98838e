//! Built-in scenes, embedded in the library.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};

use super::nearest::nearest;
use super::scissors::Scissors;
use crate::error::{Error, Result};

/// Largest scene file, bytes: more than 100 000 rods need. A device or data file named by mistake does not fill the
/// memory.
const LARGEST_FILE: u64 = 16 << 20;

/// Names and JSON texts of the built-in scenes.
const BUILTIN: [(&str, &str); 10] = [
    ("pendulum-flexible", include_str!("scenes/pendulum-flexible.json")),
    ("pendulum-1d", include_str!("scenes/pendulum-1d.json")),
    ("pendulum-2d", include_str!("scenes/pendulum-2d.json")),
    ("pendulum-1d-relaxed", include_str!("scenes/pendulum-1d-relaxed.json")),
    ("pendulum-2d-relaxed", include_str!("scenes/pendulum-2d-relaxed.json")),
    ("free-rod-heated", include_str!("scenes/free-rod-heated.json")),
    ("scissors-3", include_str!("scenes/scissors-3.json")),
    ("scissors-3-thermal", include_str!("scenes/scissors-3-thermal.json")),
    ("cantilever", include_str!("scenes/cantilever.json")),
    ("scissor-static", include_str!("scenes/scissor-static.json")),
];

/// Names of the built-in scenes. Scissors of any number exist besides, see [`Scissors::named`].
pub fn builtin_names() -> impl Iterator<Item = &'static str> {
    BUILTIN.iter().map(|(name, _)| *name)
}

/// JSON text of a built-in scene, to start a file from.
///
/// # Errors
/// [`Error::Read`] with the nearest name if there is no such scene; [`Error::Scene`] for too many scissors.
pub fn builtin_text(name: &str) -> Result<Cow<'static, str>> {
    if let Some((_, text)) = BUILTIN.iter().find(|(known, _)| *known == name) {
        return Ok(Cow::Borrowed(text));
    }
    if let Some(scissors) = Scissors::named(name) {
        return Ok(Cow::Owned(scissors.scene()?.to_text()));
    }
    Err(Error::Read { path: name.into(), source: io::Error::new(io::ErrorKind::NotFound, unknown_scene(name)) })
}

/// Reason for an unknown scene name, with the nearest known one.
fn unknown_scene(name: &str) -> String {
    let nearest =
        nearest(name, builtin_names()).map_or(String::new(), |nearest| format!("the nearest is `{nearest}`, "));
    format!("no built-in scene has this name; {nearest}`ancf scenes` lists all")
}

/// JSON text of the built-in scene of this name, or else of the file.
///
/// # Errors
/// Those of [`builtin_text`]; [`Error::Read`] for a file that cannot be read.
pub fn scene_text(name_or_path: &str) -> Result<Cow<'static, str>> {
    match builtin_text(name_or_path) {
        Err(Error::Read { path, .. }) => {
            read(name_or_path).map(Cow::Owned).map_err(|source| Error::Read { path, source })
        }
        text => text,
    }
}

/// Content of the file at `path`.
fn read(path: &str) -> io::Result<String> {
    let explain = |source: io::Error| match source.kind() {
        io::ErrorKind::NotFound => io::Error::new(source.kind(), format!("no such file, and {}", unknown_scene(path))),
        _ => source,
    };
    let mut text = String::new();
    File::open(path).map_err(explain)?.take(LARGEST_FILE + 1).read_to_string(&mut text)?;
    if text.len() as u64 > LARGEST_FILE {
        let reason = format!("larger than {LARGEST_FILE} bytes; allowed: a scene file up to that size");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, reason));
    }
    Ok(text)
}
