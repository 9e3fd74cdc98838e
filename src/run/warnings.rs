//! Warnings about a scene itself.

use super::unresolved_loads::unresolved_load;
use crate::model::{Form, Method, Poisson, Rod, Scene, Start, ThermalModel};
use crate::structure::Structure;

/// Steps per crossing of an element by the axial wave below which a heat shock is poorly resolved, by the method's
/// order. Measured on the suddenly heated pendulum (2D) with four elements, 0–0.5 s. Second-order methods against the
/// oracle: six steps leave 1.1 to 1.5 mm, sixteen 0.2 to 0.3 mm, thirty-one 0.2 mm. "gauss", of order four, against
/// "explicit" with 5·10⁻⁶ s: 0.8 steps leave 1.2 mm, 1.6 steps 0.6 mm, three and six 0.2 mm. The stability limit of
/// explicit methods is short enough, and adaptive ones keep their tolerance.
fn steps_per_crossing(method: Method) -> Option<f64> {
    match method {
        Method::GeneralizedAlpha | Method::EnergyMomentum => Some(20.0),
        Method::Gauss => Some(3.0),
        _ => None,
    }
}

/// All warnings about the scene itself.
pub fn warnings(scene: &Scene) -> Vec<String> {
    let warnings = [shock_warning, unresolved_load_warning, locking_warning, form_warning, clamp_warning];
    warnings.iter().filter_map(|warning| warning(scene)).collect()
}

/// Warning about a history that comes and goes between the ends of the steps.
fn unresolved_load_warning(scene: &Scene) -> Option<String> {
    let step = scene.time.step;
    let short = unresolved_load(scene, step)?;
    let (what, length) = (short.what, short.length);
    Some(if scene.time.method.is_adaptive() {
        format!(
            "{what} rises and falls, or begins with the end, within the rounding of times, in as little as {length:.1e} s: steps may skip it; stretch it over a \
             longer time, with smaller values"
        )
    } else {
        format!(
            "{what} rises and falls, or begins with the end, within no more than the step of {step:e} s, in as little as {length:.1e} s: steps may miss it \
             altogether, or take it for another load; a smaller step, or an adaptive method, resolves it"
        )
    })
}

/// Warning about locking: rods of the paper's element with ν ≠ 0 are too stiff in bending, for any mesh. Rods of one ν are
/// named together.
fn locking_warning(scene: &Scene) -> Option<String> {
    let locks = |rod: &&Rod| rod.has_poissons_terms(scene.material(rod)) && rod.poisson == Poisson::Full;
    let mut groups: Vec<(f64, Vec<String>)> = Vec::new();
    for rod in scene.rods.iter().filter(locks) {
        let (nu, name) = (scene.material(rod).nu, format!("`{}`", rod.name));
        match groups.iter_mut().find(|(other, _)| *other == nu) {
            Some((_, names)) => names.push(name),
            None => groups.push((nu, vec![name])),
        }
    }
    let bends = |(nu, names): &(f64, Vec<String>)| {
        let share = 100.0 * (1.0 - 2.0 * nu) / (1.0 - nu).powi(2);
        let rods = if names.len() == 1 { "the slender rod" } else { "each of the slender rods" };
        format!("with nu = {nu} {rods} {} bends by only {share:.1} % of plane strain's deflection", names.join(", "))
    };
    let of_groups: Vec<String> = groups.iter().map(bends).collect();
    let form = if scene.form == Form::Consistent { "" } else { ", with \"form\": \"consistent\"" };
    (!groups.is_empty()).then(|| {
        format!(
            "the paper's element locks: {}; \"poisson\": \"axis\" cures it for rods in plane strain (strips of a wide plate), \"law\": \
             \"uniaxial\" for struts, whose sides are free and which deflect by 1/(1 - nu^2) of plane strain's deflection{form}",
            of_groups.join("; ")
        )
    })
}

/// Warning about the printed shear term, with which a rod's stiffness depends on its inclination.
fn form_warning(scene: &Scene) -> Option<String> {
    (scene.form == Form::PrintedShear).then(|| {
        "\"form\": \"printed-shear\" counts the shear once, as printed: a rod at 45° is 1.33 times as flexible in bending and 1.50 \
         times along its axis; the results are for comparison only"
            .into()
    })
}

/// Warning about a clamp at a point that nothing holds: its section keeps its direction, and moves.
fn clamp_warning(scene: &Scene) -> Option<String> {
    let held = |point: &str| scene.supports.iter().any(|other| other.point == point && !other.held().is_empty());
    let loose = scene.supports.iter().find(|support| support.clamp.is_some() && !held(&support.point))?;
    Some(format!(
        "the clamp at `{}` keeps the direction of a section, and nothing holds the point itself; for a built-in end add \"fix\": [\"x\", \"y\"]",
        loose.point
    ))
}

/// Warning about implicit steps that do not resolve the wave of a heat shock.
fn shock_warning(scene: &Scene) -> Option<String> {
    let (needed, crossing) = (steps_per_crossing(scene.time.method)?, Structure::wave_crossing_time(scene));
    let shock = scene.rods.iter().any(|rod| {
        // Heat across the rod alone starts no wave along it.
        scene.heat(rod).filter(|heat| heat.model != ThermalModel::Transverse).is_some_and(|heat| {
            let sudden = heat.start == Start::Sudden && heat.at(0.0) != 0.0;
            // Heat within the time of a wave along the rod is practically sudden.
            let wave = Structure::wave_time(scene, rod);
            sudden || heat.history.windows(2).any(|pair| pair[1][1] != pair[0][1] && pair[1][0] - pair[0][0] < wave)
        })
    });
    let step = scene.time.step;
    if shock && step * needed > crossing {
        return Some(format!(
            "sudden heat starts an axial wave that crosses an element in {crossing:.1e} s, which the step of {step:e} s \
             does not resolve: where it moves the structure sideways, positions may be off by millimetres or more, and no energy \
             balance shows it; compare with a smaller step, or use \"explicit\""
        ));
    }
    None
}
