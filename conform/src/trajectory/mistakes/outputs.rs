//! Right motions that are written wrongly.

use ancf::model::Scene;

use crate::trajectory::mistake::{Made, Mistake, OUTPUT, Output};

/// Axes, signs, units, other points.
pub fn outputs(scene: &Scene) -> Vec<Mistake> {
    let maps = [
        ("x has the wrong sign", [[-1.0, 0.0], [0.0, 1.0]], false),
        ("y has the wrong sign", [[1.0, 0.0], [0.0, -1.0]], false),
        ("x and y are exchanged", [[0.0, 1.0], [1.0, 0.0]], false),
        ("lengths in mm", [[1e3, 0.0], [0.0, 1e3]], false),
        ("displacements in place of positions", [[1.0, 0.0], [0.0, 1.0]], true),
    ];
    let output = |what: &str, output| Mistake { what: what.into(), look_at: OUTPUT, made: Made::Output(output) };
    let mut all: Vec<Mistake> =
        maps.into_iter().map(|(what, map, relative)| output(what, Output::Map(map, relative))).collect();
    all.push(output("times in ms", Output::Times(1e-3, 0.0)));
    if scene.rods.len() > 1 {
        let names = scene.points.keys();
        all.extend(names.map(|name| output(&format!("positions of {name}"), Output::Point(name.clone()))));
    }
    all
}
