//! Factor of a structure's loads and heat at which it buckles.

use super::equilibrium_scene::{About, equilibrium_scene};
use super::modes::{axes, fractions, refused, shape};
use crate::error::{Error, Result};
use crate::integrators::{Counts, State, integrator};
use crate::linear::SingularAt;
use crate::model::Model;
use crate::model::plan::Plan;
use crate::structure::{StabilityCounter, Structure};

/// Part of the linearised factor to which the path is followed at first.
const BEYOND: f64 = 1.25;

/// Steps of the path, and how many times it is followed twice as far.
const STEPS: usize = 20;
const DOUBLINGS: usize = 3;

/// Halvings of the step in which the tangent turns singular: to 10⁻⁹ of the factor.
const HALVINGS: usize = 26;

/// Factors of all loads and heat together at which a structure buckles.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Buckling {
    /// State whose loads are multiplied.
    pub about: About,
    /// Lowest positive factor of the linearised stiffness K(0) + λ K'(0); `None` where no positive factor is.
    pub linearised: Option<f64>,
    /// Where the stiffness turns singular on the path of equilibria; `None` where it does not up to `followed`.
    pub factor: Option<f64>,
    /// Factor to which the path was followed.
    pub followed: f64,
    /// Fractions of the length at which each rod is sampled.
    pub at: Vec<Vec<f64>>,
    /// Positions [x, y] of the unloaded axes, m.
    pub unloaded: Vec<Vec<[f64; 2]>>,
    /// Displacements [x, y] of the axes in the linearised buckling; empty without a factor.
    pub shape: Vec<Vec<[f64; 2]>>,
}

/// Factors of a model's loads (or of its heat alone, [`About::Heated`]) at which the perfect structure buckles: an imperfection is
/// left out. Loads and heat are those at the scene's end, and grow together.
///
/// ```
/// use ancf::model::{Element, Force, Material, Rod, Scene, Section, Support};
/// use ancf::run::{About, buckling};
///
/// let column = Scene::new(Material::new(2e8, 0.0, 7750.0), Section::new(0.02, 0.02))
///     .point("a", [0.0, 0.0])
///     .point("b", [1.0, 0.0])
///     .rod(Rod::new("rod", "a", "b").elements(Element::Ancf, 8))
///     .support(Support::pinned("a"))
///     .support(Support::sliding("b", [1.0, 0.0]))
///     .force(Force::new("b", [-10.0, 0.0]));
/// let found = buckling(&column.build()?, About::Loaded)?;
/// let euler = std::f64::consts::PI.powi(2) * 2e8 * 0.02_f64.powi(4) / 12.0 / 10.0;
/// assert!((found.linearised.unwrap() / euler - 1.0).abs() < 3e-3);
/// assert!((found.factor.unwrap() / euler - 1.0).abs() < 3e-3);
/// # Ok::<(), ancf::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Scene`] for the unloaded state; [`Error::Drifts`] for a mechanism, which no load has to buckle.
pub fn buckling(model: &Model, about: About) -> Result<Buckling> {
    if about == About::Unloaded {
        let allowed = "\"loaded\" or \"heated\": without a load there is nothing to multiply".into();
        return Err(refused("about", "\"unloaded\"".into(), allowed));
    }
    let mut perfect = model.scene().clone();
    perfect.imperfection = None;
    let own = equilibrium_scene(&perfect, about, 1.0)?;
    let scene = own.scene().clone();
    let structure = Structure::new(own)?;
    let singular =
        |SingularAt(unknown)| Error::Singular { time: 0.0, iteration: 0, place: structure.location(unknown) };
    let linearised = structure.linearised_buckling().map_err(singular)?;
    let at = fractions(&scene);
    let shape = linearised.as_ref().map(|(_, moved)| shape(&structure, &scene, &at, moved)).transpose()?;
    let linearised = linearised.map(|(factor, _)| factor);
    let (factor, followed) = match linearised {
        Some(linearised) => on_path(|factor| equilibrium_scene(&perfect, about, factor), BEYOND * linearised)?,
        None => on_path(|factor| equilibrium_scene(&perfect, about, factor), 1.0)?,
    };
    let unloaded = axes(&structure, &scene, &at, structure.start())?;
    Ok(Buckling { about, linearised, factor, followed, at, unloaded, shape: shape.unwrap_or_default() })
}

/// Factor at which the tangent turns singular on the path, searched up to `end` and then twice as far; and how far it was followed.
fn on_path(scaled: impl Fn(f64) -> Result<Model>, mut end: f64) -> Result<(Option<f64>, f64)> {
    for doubling in 0..=DOUBLINGS {
        let model = scaled(end)?;
        if let Some(part) = first_singular(&model)? {
            return Ok((Some(part * end), end));
        }
        if doubling < DOUBLINGS {
            end *= 2.0;
        }
    }
    Ok((None, end))
}

/// Part of the load at which the stable path of equilibria ends: the tangent has a negative eigenvalue, or no equilibrium follows.
fn first_singular(model: &Model) -> Result<Option<f64>> {
    let (scene, plan) = (model.scene(), Plan::of(model.scene()));
    let structure = Structure::of(model, &plan)?;
    let mut counter = StabilityCounter::new(&structure);
    let mut counts = Counts::default();
    let start = State::at_start(&structure);
    let mut method = integrator(scene, &plan, &structure, &start, &mut counts)?;
    let mut stable = start;
    let mut is_stable = |stable: &State, part: f64| -> Option<State> {
        let mut next = stable.clone();
        method.step(&structure, &mut next, part, &mut counts).ok()?;
        (counter.unstable_directions(&structure, &next.u, part) == Some(0)).then_some(next)
    };
    for step in 1..=STEPS {
        let part = step as f64 / STEPS as f64;
        if let Some(next) = is_stable(&stable, part) {
            stable = next;
            continue;
        }
        let mut beyond = part;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (stable.load + beyond);
            match is_stable(&stable, middle) {
                Some(next) => stable = next,
                None => beyond = middle,
            }
        }
        return Ok(Some(0.5 * (stable.load + beyond)));
    }
    Ok(None)
}
