//! The fixtures' motions, with the scene that each is of.

use std::collections::BTreeMap;

use ancf::internals::model::{Words, nearest};
use ancf::model::{Element, Material, Model, Rod, Scene, Section, Support, Temperature, ThermalModel};
use serde_json::Value;

use super::frames::{Frames, Path};
use crate::error::{Error, Result};

/// Elements of the rod by which the solid's motion is compared with beams.
pub const BEAMS_OF_THE_SOLID: usize = 8;

/// A motion of the fixtures.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Name; `continuum-` stands before those of continuum.json.
    pub id: String,
    /// File and version.
    pub source: String,
    /// A sentence.
    pub what: String,
    /// The scene.
    pub scene: Scene,
    /// The motion.
    pub frames: Frames,
    /// Uncertainty of positions at each time, m.
    pub position_uncertainty: Vec<f64>,
    /// Uncertainty of velocities, m/s.
    pub velocity_uncertainty: f64,
    /// Uncertainty of energies, J.
    pub energy_uncertainty: f64,
    /// Whether it is that of a plane solid, from which any beam departs a little.
    pub is_solid: bool,
    /// Nodal coordinates at t = 0, where the file has them.
    pub nodal: Option<Vec<f64>>,
    /// Their accelerations.
    pub acceleration: Option<Vec<f64>>,
}

/// All motions of the embedded fixtures.
///
/// # Errors
/// [`Error::Suite`] if a file is malformed.
pub fn references() -> Result<Vec<Reference>> {
    type Read = fn(&Value) -> Option<Vec<Reference>>;
    let files: [(&str, &str, Read); 3] = [
        ("pendulum.json", ancf_fixtures::PENDULUM, pendulums),
        ("structure.json", ancf_fixtures::STRUCTURE, structures),
        ("continuum.json", ancf_fixtures::CONTINUUM, solids),
    ];
    let mut all = Vec::new();
    for (file, text, read) in files {
        let malformed = |reason: String| Error::Suite { file: file.into(), reason };
        let json: Value = serde_json::from_str(text).map_err(|error| malformed(error.to_string()))?;
        all.extend(read(&json).ok_or_else(|| malformed("its motions are not those of its schema".into()))?);
    }
    Ok(all)
}

/// The motion of a name.
///
/// # Errors
/// [`Error::NoMotion`] for an unknown name.
pub fn reference(id: &str) -> Result<Reference> {
    let all = references()?;
    match all.iter().find(|reference| reference.id == id) {
        Some(found) => Ok(found.clone()),
        None => {
            let like = nearest(id, all.iter().map(|reference| reference.id.as_str()));
            let known = all.iter().map(|one| one.id.as_str()).collect::<Vec<_>>().join(", ");
            let nearest = like.map(|like| format!("; nearest: `{like}`")).unwrap_or_default();
            Err(Error::NoMotion { id: id.into(), nearest, known })
        }
    }
}

fn numbers(json: &Value) -> Option<Vec<f64>> {
    json.as_array()?.iter().map(Value::as_f64).collect()
}

fn tables(json: &Value) -> Option<BTreeMap<String, Vec<f64>>> {
    json.as_object()?.iter().map(|(name, list)| Some((name.clone(), numbers(list)?))).collect()
}

fn path(json: &Value) -> Option<Path> {
    json.as_array()?.iter().map(|pair| Some([pair[0].as_f64()?, pair[1].as_f64()?])).collect()
}

fn paths(json: &Value) -> Option<BTreeMap<String, Path>> {
    json.as_object()?.iter().map(|(name, list)| Some((name.clone(), path(list)?))).collect()
}

/// The rod of Table 1 on its hinge.
fn hinged(parameters: &Value, element: Element, elements: usize, model: &str, start: Option<&str>) -> Option<Scene> {
    let number = |key: &str| parameters[key].as_f64();
    let mut scene = Scene::new(
        Material::new(number("E")?, number("nu")?, number("rho")?).alpha(number("alpha")?),
        Section::new(number("h")?, number("w")?),
    )
    .point("hinge", [0.0, 0.0])
    .point("tip", [number("L")?, 0.0])
    .rod(Rod::new("rod", "hinge", "tip").elements(element, elements))
    .support(Support::pinned("hinge"))
    .gravity([0.0, -number("g")?]);
    if model != "none" {
        let model = ThermalModel::from_word(model)?;
        let heat = Temperature::new(model, vec![[0.0, number("dT")?]]);
        scene = scene.temperature(if start == Some("relaxed") { heat.relaxed() } else { heat });
    }
    Some(scene)
}

/// The heat of a pendulum in words.
fn heat_words(model: &str, start: Option<&str>) -> String {
    match (model, start) {
        ("none", _) => "without heat".into(),
        (model, Some("relaxed")) => format!("{model} heat, from the stress-free stretch"),
        (model, _) => format!("{model} heat, sudden at t = 0"),
    }
}

fn pendulums(file: &Value) -> Option<Vec<Reference>> {
    let run = |run: &Value| {
        let (model, start) = (run["model"].as_str()?, run["start"].as_str());
        let elements = run["elements"].as_u64()? as usize;
        let (element, kind) = match run["element"].as_str()? {
            "ancf" => (Element::Ancf, "of the paper"),
            _ => (Element::EulerBernoulli, "of Euler and Bernoulli"),
        };
        let plural = if elements == 1 { "" } else { "s" };
        let energy = tables(&run["energy"])?;
        let frames = Frames {
            t: numbers(&run["t"])?,
            position: [("tip".to_string(), path(&run["tip"])?)].into(),
            velocity: [("tip".to_string(), path(&run["tip_velocity"])?)].into(),
            energy,
        };
        let error = &run["error_estimate"];
        Some(Reference {
            id: run["id"].as_str()?.into(),
            source: format!("pendulum.json {}", file["version"].as_str()?),
            what: format!(
                "the pendulum of Table 1 with {elements} element{plural} {kind}, {}; point: tip; 0 to 0.5 s",
                heat_words(model, start)
            ),
            scene: hinged(&file["parameters"], element, elements, model, start)?,
            position_uncertainty: vec![error["position"].as_f64()?; frames.t.len()],
            velocity_uncertainty: error["velocity"].as_f64()?,
            energy_uncertainty: error["energy"].as_f64()?,
            is_solid: false,
            nodal: numbers(&run["nodal"]["q"][0]),
            acceleration: numbers(&run["initial_acceleration"]),
            frames,
        })
    };
    file["runs"].as_array()?.iter().map(run).collect()
}

fn structures(file: &Value) -> Option<Vec<Reference>> {
    let motion = |motion: &Value| {
        let id = motion["id"].as_str()?;
        let scene = Model::parse(&motion["scene"].to_string(), id).ok()?.into_scene();
        let energy = tables(&motion["energy"])?;
        let (position, velocity) = (paths(&motion["position"])?, paths(&motion["velocity"])?);
        let points: Vec<&str> = position.keys().map(String::as_str).collect();
        let error = &motion["error_estimate"];
        let t = numbers(&motion["t"])?;
        Some(Reference {
            id: id.into(),
            source: format!("structure.json {}", file["version"].as_str()?),
            what: format!("{}; points: {}; 0 to 0.5 s", scene.title, points.join(", ")),
            position_uncertainty: vec![error["position"].as_f64()?; t.len()],
            velocity_uncertainty: error["velocity"].as_f64()?,
            energy_uncertainty: error["energy"].as_f64()?,
            is_solid: false,
            nodal: numbers(&motion["nodal"]["q"][0]),
            acceleration: numbers(&motion["initial_acceleration"]),
            scene,
            frames: Frames { t, position, velocity, energy },
        })
    };
    file["trajectories"].as_array()?.iter().map(motion).collect()
}

fn solids(file: &Value) -> Option<Vec<Reference>> {
    let windows = path(&file["windows"])?;
    let run = |run: &Value| {
        let (model, start) = (run["model"].as_str()?, run["start"].as_str());
        let tip = path(&run["tip"])?;
        let interval = file["interval"].as_f64()?;
        let t: Vec<f64> = (0..tip.len()).map(|n| n as f64 * interval).collect();
        let totals = numbers(&run["uncertainty"]["total"])?;
        let energy: BTreeMap<String, Vec<f64>> = tables(&run["energy"])?;
        let uncertainties: Vec<Vec<f64>> = tables(&run["energy_uncertainty"])?.into_values().collect();
        let uncertainty = |t: &f64| {
            let window = windows.iter().position(|[_, end]| *t <= end + 1e-9).unwrap_or(windows.len() - 1);
            totals.get(window).copied().unwrap_or(f64::INFINITY)
        };
        Some(Reference {
            id: format!("continuum-{}", run["id"].as_str()?),
            source: format!("continuum.json {}", file["version"].as_str()?),
            what: format!(
                "the pendulum of Table 1 as a plane solid, {}; point: tip; 0 to 2 s, energies to 0.5 s",
                heat_words(model, start)
            ),
            scene: hinged(&file["parameters"], Element::Ancf, BEAMS_OF_THE_SOLID, model, start)?,
            position_uncertainty: t.iter().map(uncertainty).collect(),
            velocity_uncertainty: 0.0,
            energy_uncertainty: uncertainties.into_iter().flatten().fold(0.0, f64::max),
            is_solid: true,
            nodal: None,
            acceleration: None,
            frames: Frames { t, position: [("tip".to_string(), tip)].into(), energy, ..Frames::default() },
        })
    };
    file["runs"].as_array()?.iter().map(run).collect()
}
