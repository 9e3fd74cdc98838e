//! `fixtures/pendulum.json`.

use ancf::model::{Element, Scene, ThermalModel};
use serde::Deserialize;

#[derive(Deserialize)]
pub struct Pendulum {
    pub runs: Vec<OracleRun>,
}

#[derive(Deserialize)]
pub struct OracleRun {
    pub id: String,
    pub element: Element,
    pub model: String,
    pub start: Option<String>,
    pub elements: usize,
    pub tip: Vec<[f64; 2]>,
    pub error_estimate: ErrorEstimate,
}

#[derive(Deserialize)]
pub struct ErrorEstimate {
    pub position: f64,
}

impl Pendulum {
    pub fn load() -> Pendulum {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/pendulum.json");
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    }

    pub fn run(&self, id: &str) -> &OracleRun {
        self.runs.iter().find(|run| run.id == id).unwrap_or_else(|| panic!("no run {id}"))
    }
}

impl OracleRun {
    /// The scene of the same model, start, element and mesh.
    pub fn scene(&self) -> Scene {
        let mut scene = Scene::builtin(self.builtin()).unwrap();
        (scene.rods[0].element, scene.rods[0].elements) = (self.element, self.elements);
        if self.model == "transverse" {
            scene.temperature.as_mut().unwrap().model = ThermalModel::Transverse;
        }
        scene
    }

    /// The built-in scene of the same start and, but for heat across alone, model.
    fn builtin(&self) -> &'static str {
        match (self.model.as_str(), self.start.as_deref()) {
            ("none", None) => "pendulum-flexible",
            ("1d", Some("sudden")) => "pendulum-1d",
            ("2d" | "transverse", Some("sudden")) => "pendulum-2d",
            ("1d", Some("relaxed")) => "pendulum-1d-relaxed",
            ("2d" | "transverse", Some("relaxed")) => "pendulum-2d-relaxed",
            other => panic!("{}: unknown model {other:?}", self.id),
        }
    }
}
