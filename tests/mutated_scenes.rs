//! Scene files with bytes changed, lost, doubled and moved: each is read or refused, none panics or takes long.

use std::panic::catch_unwind;
use std::time::{Duration, Instant};

use ancf::error::Error;
use ancf::internals::model::{builtin_names, builtin_text};
use ancf::model::Model;
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// A structure with every key that one scene may have.
const ALL: &str = r#"{"schema": "ancf-scene/1", "title": "all", "notes": ["α ΔT"],
 "material": {"E": 7e10, "nu": 0.3, "rho": 2750.0, "alpha": 2.3e-5}, "section": {"height": 0.02, "width": 0.02},
 "points": {"a": [0, 0], "b": [1, 1], "c": [1, 0], "d": [0, 1]},
 "rods": [{"name": "ab", "from": "a", "to": "b", "pivot": "m", "elements": 2, "poisson": "axis", "law": "plane-strain",
           "temperature": {"model": "2d", "start": "sudden", "history": [[0, 0], [0.1, 50]]}},
          {"name": "cd", "from": "c", "to": "d", "pivot": "m", "elements": 4, "element": "euler-bernoulli",
           "material": {"E": 1e9, "nu": 0, "rho": 1000}, "section": {"height": 0.01, "width": 0.03}}],
 "supports": [{"point": "a", "fix": ["x", "y"]}, {"point": "d", "slide": [1, 2], "clamp": "cd"}],
 "forces": [{"point": "b", "force": [0, -50], "history": [[0, 0], [0.2, 1]]}], "gravity": [0, -9.8],
 "motion": {"velocity": [0, 0], "omega": 0, "about": [0, 0]}, "constraints": "condensed",
 "time": {"end": 0.5, "step": 5e-4, "method": "gauss-adaptive", "newton_tolerance": 1e-10, "tolerance": 1e-6},
 "output": {"interval": 0.01, "energy": true},
 "probes": [{"name": "b", "point": "b", "of": ["position", "velocity", "acceleration"], "mean": 0.02},
            {"name": "pin", "point": "m", "rod": "ab", "of": ["reaction"]},
            {"name": "bend", "rod": "cd", "at": 0.25, "of": ["deflection"]}]}"#;

/// Pieces that mean something to a reader of JSON, or to this one.
const PIECES: [&str; 24] = [
    "{",
    "}",
    "[",
    "]",
    "\"",
    ",",
    ":",
    "\\",
    "null",
    "true",
    "-",
    "e308",
    "1e999",
    "-0",
    "0.0",
    "NaN",
    "\u{feff}",
    "\\u0000",
    "\\ud800",
    "\u{0}",
    "9999999999999999999",
    "1e-320",
    "\"a\"",
    "[[",
];

struct Mutator(TestRng);

impl Mutator {
    fn below(&mut self, number: usize) -> usize {
        (self.0.next_u64() % number.max(1) as u64) as usize
    }

    /// One to four changes.
    fn change(&mut self, text: &[u8]) -> Vec<u8> {
        let mut bytes = text.to_vec();
        for _ in 0..=self.below(4) {
            let (at, length) = (self.below(bytes.len()), self.below(12));
            let end = (at + length).min(bytes.len());
            match self.below(6) {
                0 if !bytes.is_empty() => bytes[at] = self.below(256) as u8,
                1 if !bytes.is_empty() => bytes[at] ^= 1 << self.below(8),
                2 => drop(bytes.drain(at..end)),
                3 => {
                    let piece = PIECES[self.below(PIECES.len())];
                    bytes.splice(at..at, piece.bytes());
                }
                4 => {
                    let copied = bytes[at..end].to_vec();
                    let to = self.below(bytes.len());
                    bytes.splice(to..to, copied);
                }
                _ => bytes.truncate(at),
            }
        }
        bytes
    }
}

#[test]
fn changed_scene_files_are_read_or_refused() {
    let number = if cfg!(debug_assertions) { 20_000 } else { 1_000_000 };
    let texts: Vec<String> =
        builtin_names().map(|name| builtin_text(name).unwrap().to_string()).chain([ALL.into()]).collect();
    Model::parse(ALL, "all").unwrap().into_scene();
    let mut mutator = Mutator(TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]));
    let (mut read, mut no_text, mut slowest) = (0, 0, Duration::ZERO);
    for n in 0..number {
        let text = mutator.change(texts[n % texts.len()].as_bytes());
        // As `Model::load` does: what is no text is refused before it is parsed.
        let Ok(text) = String::from_utf8(text) else {
            no_text += 1;
            continue;
        };
        let clock = Instant::now();
        let outcome = catch_unwind(|| Model::parse(&text, "mutated"));
        slowest = slowest.max(clock.elapsed());
        match outcome {
            Ok(Ok(scene)) => {
                read += 1;
                // A scene that was read can be written and read again.
                if n % 100 == 0 {
                    assert_eq!(Model::parse(&scene.scene().to_text(), "again").unwrap(), scene, "{text}");
                }
            }
            Ok(Err(Error::Scene { key, allowed, .. })) => {
                assert!(!key.is_empty() && !allowed.is_empty(), "`{key}`; allowed: {allowed}; in\n{text}");
            }
            Ok(Err(other)) => panic!("{other}:\n{text}"),
            Err(_) => panic!("panics:\n{text}"),
        }
    }
    println!("{number} files: {read} are scenes, {no_text} no text, the slowest took {slowest:?}");
    assert!(read > number / 1000, "hardly any change leaves a scene");
    assert!(no_text * 2 < number, "hardly any file is a text");
    assert!(slowest < Duration::from_secs(2), "{slowest:?}");
}
