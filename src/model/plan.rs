//! The plan of a run: terms that a scene needs, and terms left out because they cannot affect the results.
//!
//! Leaving a term out changes no force, tangent or trajectory beyond rounding. [`Plan::full`] computes every term, for
//! tests of that equality and for the study that measures the time saved.

use serde::Serialize;

use super::choice::{Constraints, Form, Method, Poisson, Quantity};
use super::scene::Scene;

/// Terms that a run computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Plan {
    /// Thermal strains in every force evaluation, and the work of heating.
    pub heat: bool,
    /// Poisson's terms λ tr ε of the paper's element.
    pub poisson: bool,
    /// Weight of the rods.
    pub weight: bool,
    /// Energies and the work of loads.
    pub energy: bool,
    /// Accelerations from the equation of motion, and reactions, which follow from them.
    pub acceleration: bool,
    /// Lagrange multipliers of pins and supports.
    pub multipliers: bool,
    /// A new matrix in every Newton iteration.
    pub new_matrices: bool,
}

impl Plan {
    /// Plan with the terms that a scene needs.
    pub fn of(scene: &Scene) -> Plan {
        let moves = scene.time.method != Method::Static;
        let asked = |quantity| scene.probes.iter().any(|probe| probe.of.contains(&quantity));
        Plan {
            heat: scene.rods.iter().any(|rod| scene.heat(rod).is_some()),
            poisson: has_poisson(scene) || scene.form == Form::PrintedShear,
            weight: scene.gravity != [0.0; 2],
            energy: scene.has_energies(),
            acceleration: moves && (asked(Quantity::Acceleration) || asked(Quantity::Reaction)),
            multipliers: scene.constraints == Constraints::Multipliers,
            new_matrices: matches!(scene.time.method, Method::Static | Method::EnergyMomentum),
        }
    }

    /// Plan with every term, needed or not; multipliers as the scene says, since they are additional unknowns.
    pub fn full(scene: &Scene) -> Plan {
        Plan {
            heat: true,
            poisson: true,
            weight: true,
            energy: scene.time.method != Method::Static,
            acceleration: scene.time.method != Method::Static,
            multipliers: scene.constraints == Constraints::Multipliers,
            new_matrices: true,
        }
    }

    /// Terms in words: each with whether it is computed, and why.
    pub fn parts(&self, scene: &Scene) -> Vec<Part> {
        let part = |what, computed, why: &str| Part { what, computed, why: why.into() };
        let explicit = scene.time.method.is_explicit();
        let deviated = scene.imperfection.iter().map(|_| {
            part("stress of the deviated shape, −A e", true, "`imperfection` makes that shape free of stress")
        });
        let mut parts = vec![
            part(
                "thermal strains and the work of heating",
                self.heat,
                if self.heat { "a rod has a `temperature`" } else { "no rod has a `temperature` that strains it" },
            ),
            part(
                "Poisson's terms, λ tr ε",
                self.poisson,
                match (self.poisson, has_poisson(scene)) {
                    (true, true) if is_axis(scene) => {
                        "a material has ν ≠ 0; with \"poisson\": \"axis\" they act on the axis, and the rod is one in plane strain: it \
                         deflects by 1 − ν² of what a strut with free sides does (\"law\": \"uniaxial\")"
                    }
                    (true, true) => "a material has ν ≠ 0",
                    (true, false) => "the printed form computes every term as it stands",
                    (false, _) if scene.rods.iter().all(|rod| scene.material(rod).nu == 0.0) => {
                        "every material has ν = 0"
                    }
                    (false, _) => {
                        "rods of ν ≠ 0 have none: they follow the law \"uniaxial\", or are Euler–Bernoulli elements"
                    }
                },
            ),
            part("weight, Q_w", self.weight, if self.weight { "there is `gravity`" } else { "there is no `gravity`" }),
            part(
                "multipliers of pins and supports",
                self.multipliers,
                if self.multipliers {
                    "`constraints` is \"multipliers\""
                } else {
                    "pinned points share their coordinates, and held ones have none"
                },
            ),
            part(
                "energies and the work of loads",
                self.energy,
                match (self.energy, scene.time.method) {
                    (true, _) => "`output.energy` is true",
                    (false, Method::Static) => "statics has no energy balance",
                    (false, _) => "`output.energy` is false",
                },
            ),
            part(
                "accelerations and reactions at the output rows",
                self.acceleration,
                match (self.acceleration, scene.time.method) {
                    (true, _) => "a probe asks for them",
                    (false, Method::Static) => {
                        "in statics nothing is accelerated, and reactions are what loads and elastic forces leave"
                    }
                    (false, _) => "no probe asks for them",
                },
            ),
            part(
                "looks at stability",
                true,
                match scene.time.method {
                    Method::Static => "each row is judged by the eigenvalues of its tangent",
                    _ => "one every 8 to 1000 steps, by the method's cost, tells whether small deviations grow",
                },
            ),
            part(
                "tangents",
                !explicit,
                if explicit { "the method is explicit" } else { "Newton's iteration needs them" },
            ),
            part(
                "a new matrix and its factors each time",
                self.new_matrices,
                match (self.new_matrices, explicit) {
                    (true, _) if scene.time.method == Method::EnergyMomentum => {
                        "energy is kept as well as the residual vanishes, which a tangent of each iteration does best"
                    }
                    (true, _) => "statics converges best with a tangent of each iteration",
                    (false, true) => "the mass matrix does not change, and is factorised once",
                    (false, false) => "an earlier tangent serves as long as the residual shrinks fast with it",
                },
            ),
        ];
        parts.extend(deviated);
        parts
    }
}

/// Whether a rod has Poisson's terms.
fn has_poisson(scene: &Scene) -> bool {
    scene.rods.iter().any(|rod| rod.has_poissons_terms(scene.material(rod)))
}

/// Whether Poisson's terms act on the axis of a rod.
fn is_axis(scene: &Scene) -> bool {
    scene.rods.iter().any(|rod| rod.poisson == Poisson::Axis && rod.has_poissons_terms(scene.material(rod)))
}

/// One term of a plan, in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Part {
    /// Name of the term.
    pub what: &'static str,
    /// Whether the term is computed.
    pub computed: bool,
    /// Reason for computing it or leaving it out.
    pub why: String,
}
