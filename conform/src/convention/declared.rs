//! Conventions that a program declares in `hello`.

use ancf::internals::model::nearest;
use serde_json::{Map, Value};

use super::Conventions;
use super::angle::Angle;
use super::components::Components;
use super::energy::Energy;
use super::heat::Heat;
use super::layout::{CABLE, ELEMENT};
use super::matrices::Matrices;
use super::reading::Reading;
use super::shear::Shear;
use super::slopes::{ACROSS, ALONG, Slope};
use super::symmetrised::Metrics;
use super::voigt::{COMPONENTS, Voigt};

/// Keys under `conventions`.
const KEYS: [&str; 12] = [
    "order",
    "cable_order",
    "components",
    "slopes",
    "state",
    "matrices",
    "voigt",
    "shear",
    "S_c",
    "U",
    "heat",
    "theta",
];

/// Conventions that were declared, keys that were understood, and what was wrong.
#[derive(Debug, Default)]
pub struct Declared {
    /// Those that were declared, the others as in the fixtures.
    pub conventions: Conventions,
    /// Keys of those that were declared.
    pub keys: Vec<&'static str>,
    /// What was not understood, in words.
    pub errors: Vec<String>,
}

impl Declared {
    /// Reads the object under `conventions`. What is not understood is an error in words.
    pub fn read(table: &Map<String, Value>) -> Declared {
        let mut declared = Declared::default();
        for (key, value) in table.iter().filter(|(_, value)| !value.is_null()) {
            let Some(known) = KEYS.into_iter().find(|known| known == key) else {
                let nearest = or_nearest(key, KEYS);
                declared.errors.push(format!(
                    "`{}` is no convention{nearest}; allowed: {}",
                    short(key),
                    KEYS.join(", ")
                ));
                continue;
            };
            match set(&mut declared.conventions, known, value) {
                Ok(()) => declared.keys.push(known),
                Err(allowed) => {
                    let found = short(&value.as_str().map_or_else(|| value.to_string(), String::from));
                    declared.errors.push(format!("`{known}` cannot be `{found}`{allowed}"));
                }
            }
        }
        declared
    }
}

/// Suggestion to append to a message; empty where no known name is similar.
fn or_nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or(String::new(), |nearest| format!("; nearest: `{nearest}`"))
}

fn short(text: &str) -> String {
    crate::quotation::quoted(text)
}

/// Sets one convention; the error is what is allowed, as the end of a sentence.
fn set(conventions: &mut Conventions, key: &str, value: &Value) -> Result<(), String> {
    match key {
        "order" => conventions.element.order = permutation(value, &ELEMENT)?,
        "cable_order" => conventions.cable.order = permutation(value, &CABLE)?,
        "components" => {
            let components = one_of(value, Components::ALL.map(|choice| (choice.name(), choice)))?;
            (conventions.element.components, conventions.cable.components) = (components, components);
        }
        "slopes" => {
            let [along, across] = match value.as_array().map(Vec::as_slice) {
                Some([along, across]) => [slope(along, &ALONG)?, slope(across, &ACROSS)?],
                _ => return Err("; allowed: a list of two, such as [\"l/2\", \"h/2\"]".into()),
            };
            (conventions.element.slopes, conventions.cable.slopes) = ([along, across], [along, Slope::One]);
        }
        "state" => conventions.reading = one_of(value, [("fixture", Reading::Fixture), ("own", Reading::Own)])?,
        "matrices" => conventions.matrices = one_of(value, Matrices::ALL.map(|choice| (choice.name(), choice)))?,
        "voigt" => {
            let order = permutation(value, &COMPONENTS)?;
            conventions.voigt = Voigt(std::array::from_fn(|n| order.get(n).copied().unwrap_or(n)));
        }
        "shear" => {
            let engineering = Shear::Engineering { S_c: 1.0, K_3: 1.0 };
            conventions.shear = one_of(value, [("tensor", Shear::Tensor), ("engineering", engineering)])?;
        }
        "S_c" => {
            let choices = [("as-printed", Metrics::AsPrinted), ("symmetrised", Metrics::Symmetrised)];
            conventions.S_c = one_of(value, choices)?;
        }
        "U" => {
            let choices = [("whole", 0.0), ("without-constant", 1.0), ("constant-subtracted", 2.0)];
            conventions.energy = Energy([one_of(value, choices)?; 4]);
        }
        "heat" => conventions.heat = Heat([one_of(value, [("in-strain", false), ("in-law", true)])?, false, false]),
        _ => conventions.angle = one_of(value, [("radians", Angle::Radians), ("degrees", Angle::Degrees)])?,
    }
    Ok(())
}

fn one_of<T: Copy, const N: usize>(value: &Value, choices: [(&str, T); N]) -> Result<T, String> {
    let names = choices.map(|(name, _)| name);
    let text = value.as_str().unwrap_or_default();
    let chosen = choices.iter().find(|(name, _)| *name == text).map(|(_, choice)| *choice);
    chosen.ok_or_else(|| format!("{}; allowed: {}", or_nearest(text, names), names.join(", ")))
}

fn slope(value: &Value, choices: &[Slope]) -> Result<Slope, String> {
    let text = value.as_str().unwrap_or_default();
    let names: Vec<&str> = choices.iter().map(|choice| choice.name()).collect();
    let chosen = choices.iter().find(|choice| choice.name() == text).copied();
    chosen.ok_or_else(|| format!("; allowed: {}", names.join(", ")))
}

/// A list of all names, each once, as indices.
fn permutation(value: &Value, names: &[&str]) -> Result<Vec<usize>, String> {
    let place = |name: &Value| names.iter().position(|known| name.as_str() == Some(known));
    let order: Option<Vec<usize>> = value.as_array().and_then(|list| list.iter().map(place).collect());
    let is_complete = |order: &Vec<usize>| order.len() == names.len() && (0..names.len()).all(|n| order.contains(&n));
    order.filter(is_complete).ok_or_else(|| format!("; allowed: a list of {}, each once", names.join(", ")))
}
