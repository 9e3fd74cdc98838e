//! Deployable structures of Section 4: a row of scissor-like elements, of any number.

use std::collections::BTreeMap;
use std::fmt::Display;

use super::check::require;
use super::checks::check;
use super::checks::topology::MOST_ELEMENTS;
use super::choice::{Direction, Element, Method, Quantity, Start, ThermalModel};
use super::heat::Temperature;
use super::loads::Force;
use super::probes::Probe;
use super::rod::{Material, Rod, Section};
use super::scene::Scene;
use super::supports::Support;
use super::time::{Output, Time};
use crate::error::Result;

/// Length of a rod (Table 2), m.
const LENGTH: f64 = 2.0;

/// Most rods whose deflection is recorded: b1a2, b2a3, b3a4.
const MOST_DEFLECTIONS: usize = 3;

/// Temperature history, s and K (Figure 6): a single slope of 600 K/s fits the extremes and the inflection points.
const TEMPERATURE: [[f64; 2]; 6] =
    [[0.0, 0.0], [0.25, 150.0], [1.25, 150.0], [1.75, -150.0], [2.75, -150.0], [3.0, 0.0]];

/// Row of scissor-like elements with the rods of Table 2, and assumptions for what the paper's text leaves open.
///
/// The points a1 … a(n+1) lie above b1 … b(n+1). The rods a(k)–b(k+1) and b(k)–a(k+1) are pinned at their middles m(k).
/// b1 is fixed, a1 slides on a vertical, and a force pushes a1 down, which deploys the structure along x.
#[derive(Debug, Clone, PartialEq)]
pub struct Scissors {
    /// Number of scissor-like elements, at least 1.
    pub count: usize,
    /// Initial angle between the rods and the x axis, degrees; between 0 and 90.
    pub angle: f64,
    /// Force on a1 towards b1, N.
    pub force: f64,
    /// Number of elements per rod.
    pub elements: usize,
    /// Strains caused by the changing temperature.
    pub model: ThermalModel,
}

impl Scissors {
    /// The paper's structure without heat, with `count` scissor-like elements instead of three.
    pub fn new(count: usize) -> Scissors {
        Scissors { count, angle: 80.0, force: 50.0, elements: 8, model: ThermalModel::None }
    }

    /// Structure of a scene name: `scissors-<n>`, or `scissors-<n>-thermal` with heat (2D).
    pub fn named(name: &str) -> Option<Scissors> {
        let count = name.strip_prefix("scissors-")?;
        let (count, model) = match count.strip_suffix("-thermal") {
            Some(count) => (count, ThermalModel::TwoD),
            None => (count, ThermalModel::None),
        };
        let digits = count.bytes().all(|c| c.is_ascii_digit()) && (count == "0" || !count.starts_with('0'));
        // A number that overflows is also too large for a scene, which reports it.
        let count = if digits && !count.is_empty() { count.parse().unwrap_or(usize::MAX) } else { return None };
        Some(Scissors { model, ..Scissors::new(count) })
    }

    /// Scene of the structure.
    ///
    /// # Errors
    /// [`Error::Scene`](crate::error::Error::Scene) for a value that is not allowed.
    pub fn scene(&self) -> Result<Scene> {
        self.check()?;
        let (n, (sin, cos)) = (self.count, self.angle.to_radians().sin_cos());
        let (height, pitch) = (LENGTH * sin, LENGTH * cos);
        let column = |k: usize| (k - 1) as f64 * pitch;
        let points =
            (1..=n + 1).flat_map(|k| [(format!("a{k}"), [column(k), height]), (format!("b{k}"), [column(k), 0.0])]);
        let scene = Scene {
            title: self.title(),
            notes: self.notes(),
            points: points.collect::<BTreeMap<_, _>>(),
            rods: (1..=n).flat_map(|k| self.rods(k)).collect(),
            supports: vec![Support::pinned("b1"), Support::fixed("a1", &[Direction::X])],
            forces: vec![Force::new("a1", [0.0, 0.0 - self.force])],
            temperature: self.temperature(),
            time: Time { step: 2.5e-4, method: Method::EnergyMomentum, ..Time::until(3.0) },
            output: Output { interval: Some(0.01), ..Output::default() },
            probes: self.probes(),
            ..Scene::new(Material::new(7e10, 0.0, 2750.0).alpha(2.3e-5), Section::new(0.02, 0.02))
        };
        check(&scene).map_err(|refusal| refusal.into_error(&self.name(), None))?;
        Ok(scene)
    }

    fn check(&self) -> Result<()> {
        let &Scissors { count, angle, force, elements, model: _ } = self;
        let most = MOST_ELEMENTS / 2 / elements.max(1);
        let refuse = |holds: bool, key: &str, value: &dyn Display, allowed: &dyn Display| {
            require(holds, key, value, allowed).map_err(|refusal| refusal.into_error(&self.name(), None))
        };
        let allowed = format!("a whole number from 1 to {most}, as {MOST_ELEMENTS} elements are allowed in all rods");
        refuse((1..=most).contains(&count), "scissors-<n>", &count, &allowed)?;
        let allowed = "a number between 0 and 90 degrees, both excluded";
        refuse(angle > 0.0 && angle < 90.0, "angle", &format!("{angle:?}"), &allowed)?;
        refuse(force.is_finite(), "force", &format!("{force:?}"), &"a finite number, N")
    }

    /// Name of its scene.
    fn name(&self) -> String {
        let heat = if self.model == ThermalModel::None { "" } else { "-thermal" };
        format!("scissors-{}{heat}", self.count)
    }

    /// The two rods of scissor-like element `k`.
    fn rods(&self, k: usize) -> [Rod; 2] {
        [("a", "b"), ("b", "a")].map(|(from, to)| {
            let (from, to) = (format!("{from}{k}"), format!("{to}{}", k + 1));
            Rod::new(&format!("{from}{to}"), &from, &to)
                .elements(Element::default(), self.elements)
                .pivot(&format!("m{k}"))
        })
    }

    fn temperature(&self) -> Option<Temperature> {
        let heat = Temperature { model: self.model, start: Start::Sudden, history: TEMPERATURE.to_vec() };
        (self.model != ThermalModel::None).then_some(heat)
    }

    /// Probes of the outermost upper point, and deflections of the rods that begin at b1, b2 and b3.
    fn probes(&self) -> Vec<Probe> {
        let end = format!("a{}", self.count + 1);
        let point = Probe::point(&end, &end, &[Quantity::Position, Quantity::Velocity, Quantity::Acceleration]);
        let deflections = (1..=self.count.min(MOST_DEFLECTIONS)).map(|k| {
            let rod = format!("b{k}a{}", k + 1);
            Probe::deflection(&rod, &rod, 0.5)
        });
        std::iter::once(point).chain(deflections).collect()
    }

    fn title(&self) -> String {
        let Scissors { count, angle, force, .. } = self;
        let plural = if *count == 1 { "element" } else { "elements" };
        let heat = match self.model {
            ThermalModel::None => "without heat",
            ThermalModel::OneD => "in changing temperature, heat strains the axis only",
            ThermalModel::Transverse => "in changing temperature, heat strains the section only",
            ThermalModel::TwoD => "in changing temperature, heat strains the axis and the section",
        };
        format!(
            "deployable structure of Table 2 (Peng et al. 2018): {count} scissor-like {plural} at {angle} degrees, \
             driven by {force} N, {heat}"
        )
    }

    /// Assumptions where the paper's text is silent.
    fn notes(&self) -> Vec<String> {
        let Scissors { angle, force, .. } = self;
        let mut notes = vec![
            "source: Peng et al. (2018), Section 4 and Table 2; Figures 5 and 6 are not in the text, so that what \
             follows is assumed"
                .to_string(),
            format!("assumed: the rods are inclined by {angle} degrees at the start, and are pinned at their middles"),
            "assumed supports: b1 is fixed, a1 slides on the line x = 0".into(),
            format!("assumed: the force of {force} N at a1 is directed downwards, towards b1, and keeps its direction"),
            "assumed: no gravity".into(),
            "assumed: at rest at t = 0".into(),
            "assumed: the deflection is plotted for the middle of the rods".into(),
        ];
        if self.model != ThermalModel::None {
            notes.push(
                "assumed: temperature is linear in time between the extremes of 150 and -150 K and the inflection \
                 points at 0.25, 1.25, 1.75 and 2.75 s; it begins and ends at 0, where the rods are free of stress"
                    .into(),
            );
        }
        notes
    }
}
