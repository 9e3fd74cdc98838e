//! Conventions that a program declares in `hello`.

use ancf::internals::model::nearest;
use schemars::JsonSchema;
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

/// Conventions of a program, under `conventions` in `hello`. Those that are absent are read off the answers.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "its schema is used, never its values")]
pub struct DeclaredConventions {
    /// The seven nodal vectors in the program's order: r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k in the fixtures.
    order: Option<Vec<String>>,
    /// The four nodal vectors of the cable in the program's order: r_i, r_x_i, r_k, r_x_k in the fixtures.
    cable_order: Option<Vec<String>>,
    /// Order of x and y in e: interleaved (the fixtures') or blocks (all x, then all y).
    components: Option<String>,
    /// What r_x and r_y are multiplied by in e: 1, l/2 or l, and 1, h/2, h, l or l/2. 1 and 1 in the fixtures.
    slopes: Option<[String; 2]>,
    /// Layout of e0, e and edot in the states that the program reads: fixture, or own (as its answers).
    state: Option<String>,
    /// Nested lists of a matrix: rows (the fixtures'), columns, flat-rows or flat-columns.
    matrices: Option<String>,
    /// Order of the components of strain and stress: 11, 22, 12 in the fixtures.
    voigt: Option<[String; 3]>,
    /// Measure of the shear strain: tensor (ε₁₂, the fixtures') or engineering (2ε₁₂, with μ in D).
    shear: Option<String>,
    /// The matrix S_c of (11): as-printed (the fixtures') or symmetrised.
    S_c: Option<String>,
    /// The strain energies: whole (the fixtures'), without-constant (½ ∫ ε_Tᵀ D ε_T dV left out) or constant-subtracted.
    U: Option<String>,
    /// Where the thermal strain is subtracted: in-strain (14, the fixtures') or in-law (14 is the whole strain).
    heat: Option<String>,
    /// Unit of the state's theta: radians (the fixtures') or degrees.
    theta: Option<String>,
}

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
    crate::protocol::quoted(text)
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
