//! Mistakes in the heat.

use ancf::model::{Element, Scene, Start, Temperature, ThermalModel};

use crate::trajectory::mistake::{Add, HEAT};
use crate::trajectory::setup::StartStretch;

/// Changes the heat of all rods.
fn each_heat(scene: &mut Scene, change: impl Fn(&mut Temperature)) {
    scene.temperature.iter_mut().for_each(&change);
    scene.rods.iter_mut().filter_map(|rod| rod.temperature.as_mut()).for_each(&change);
}

/// Heat lost, doubled, turned, ramped, of another model, start, history or rod.
pub fn heat(scene: &Scene, add: &mut Add) {
    let heats = || scene.rods.iter().filter_map(|rod| scene.heat(rod)).filter(|heat| heat.model != ThermalModel::None);
    if heats().next().is_none() {
        return;
    }
    let relaxed = heats().any(|heat| heat.start == Start::Relaxed);
    add("there is no heat", HEAT, &|setup| setup.heat = [0.0; 2]);
    add("the heat is doubled", HEAT, &|setup| setup.heat = [2.0; 2]);
    add("half of the heat", HEAT, &|setup| setup.heat = [0.5; 2]);
    add("the heat has the wrong sign", HEAT, &|setup| setup.heat = [-1.0; 2]);
    if heats().any(|heat| heat.model == ThermalModel::TwoD) && scene.rods.iter().any(|rod| rod.element == Element::Ancf)
    {
        add("1D heat in place of 2D: no thermal strain across the rod", HEAT, &|setup| setup.heat = [1.0, 0.0]);
        add("the thermal strain across the rod only", HEAT, &|setup| setup.heat = [0.0, 1.0]);
        add("the thermal strain across the rod is doubled", HEAT, &|setup| setup.heat = [1.0, 2.0]);
        add("the thermal strain along the rod is doubled", HEAT, &|setup| setup.heat = [2.0, 1.0]);
        if relaxed {
            add("the relaxed start is not stretched across the rod", HEAT, &|setup| {
                setup.start_at_rest = StartStretch::AlongOnly
            });
        }
    }
    if heats().any(|heat| heat.model == ThermalModel::OneD) && scene.rods.iter().any(|rod| rod.element == Element::Ancf)
    {
        add("2D heat in place of 1D", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| heat.model = ThermalModel::TwoD)
        });
        add("the thermal strain across the rod in place of along", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| heat.model = ThermalModel::TwoD);
            setup.heat = [0.0, 1.0];
        });
    }
    if heats().any(|heat| heat.model == ThermalModel::Transverse) {
        add("2D heat in place of heat across the rod only", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| heat.model = ThermalModel::TwoD)
        });
        add("the thermal strain along the rod in place of across", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| heat.model = ThermalModel::OneD)
        });
    }
    if heats().any(|heat| heat.at(0.0) != 0.0) {
        let (what, other) = match relaxed {
            true => ("a sudden start in place of a relaxed one", Start::Sudden),
            false => ("a relaxed start in place of a sudden one", Start::Relaxed),
        };
        add(what, HEAT, &|setup| each_heat(&mut setup.scene, |heat| heat.start = other));
        for ramp in [0.01, 0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0] {
            let what = format!("the heat grows over {ramp} s in place of acting from t = 0");
            add(&what, HEAT, &|setup| {
                setup.ramp = ramp;
                each_heat(&mut setup.scene, |heat| heat.start = Start::Sudden);
            });
        }
    }
    if heats().any(|heat| heat.history.len() > 1) {
        add("the heat is constant: that of the history's end", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| {
                heat.history.drain(..heat.history.len().saturating_sub(1)).for_each(drop)
            });
        });
        add("the heat jumps: steps in place of straight lines", HEAT, &|setup| each_heat(&mut setup.scene, stepped));
        add("the heat's largest value from t = 0", HEAT, &|setup| {
            each_heat(&mut setup.scene, |heat| {
                let largest = heat
                    .history
                    .iter()
                    .map(|pair| pair[1])
                    .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
                heat.history = vec![[0.0, largest]];
            });
        });
    }
    for n in 0..scene.rods.len() {
        if scene.rods.len() < 2 {
            continue;
        }
        let name = &scene.rods[n].name;
        add(&format!("rod {name} is not heated"), HEAT, &|setup| {
            let none = scene.heat(&scene.rods[n]).cloned();
            setup.scene.rods[n].temperature = none.map(|mut heat| {
                heat.model = ThermalModel::None;
                heat
            });
        });
        for other in (0..scene.rods.len()).filter(|other| *other != n) {
            add(&format!("rod {name} has the heat of rod {}", scene.rods[other].name), HEAT, &|setup| {
                setup.scene.rods[n].temperature = scene.heat(&scene.rods[other]).cloned();
            });
        }
        let own = scene.heat(&scene.rods[n]).map(|heat| heat.model);
        let other = match own {
            Some(ThermalModel::TwoD) => Some((ThermalModel::OneD, "1D heat in place of 2D")),
            Some(ThermalModel::OneD) => Some((ThermalModel::TwoD, "2D heat in place of 1D")),
            Some(ThermalModel::Transverse) => {
                Some((ThermalModel::TwoD, "2D heat in place of heat across the rod only"))
            }
            _ => None,
        };
        if let Some((model, what)) = other {
            add(&format!("{what} in rod {name}"), HEAT, &|setup| {
                let mut heat = scene.heat(&scene.rods[n]).cloned();
                heat.iter_mut().for_each(|heat| heat.model = model);
                setup.scene.rods[n].temperature = heat;
            });
        }
    }
}

/// A history that keeps each value until the next entry.
fn stepped(heat: &mut Temperature) {
    const JUMP: f64 = 1e-9;
    let mut steps = Vec::new();
    for (n, [t, value]) in heat.history.iter().enumerate() {
        if let Some([_, before]) = n.checked_sub(1).and_then(|n| heat.history.get(n)) {
            steps.push([t - JUMP, *before]);
        }
        steps.push([*t, *value]);
    }
    heat.history = steps;
}
