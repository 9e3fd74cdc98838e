//! Mistakes in the Euler–Bernoulli element: strains, curvatures, section, heat, mass and quadrature.
//!
//! The element is computed from its energy densities, whose parts can be changed. Forces and tangent are derivatives of the energy.

#![allow(non_snake_case)] // The symbols of the equations are names here.

use nalgebra::{SMatrix, Vector2};

use super::candidate::{Candidate, candidate, possible};
use super::entries::rows;
use super::jet::Jet;
use super::layout::permutations;
use super::mistake::MistakeKind::{self, Factor, Heat, Missing, NodeOrder, Other, Quadrature, Sign, XyOrder};
use super::quadrature::gauss;
use ancf::equations::cable::{Matrix8, S_i, S_i_x, S_i_xx, Vector8};
use ancf::equations::motion;
use ancf::state::{CableState, ThermalModel, evaluate_cable};

/// r_x and r_xx, each x before y.
type Slopes = [Jet; 4];
/// Matrix of r_x and r_xx by e.
type B = SMatrix<f64, 4, 8>;

/// The element with its parts.
#[derive(Clone)]
pub(super) struct Cable {
    state: CableState,
    /// Axial stiffness, N.
    EA: f64,
    /// Bending stiffness, N m².
    EI: f64,
    /// Mass per length, kg/m.
    rho_A: f64,
    eps_T: f64,
    /// Axial strain from r_x and thermal strain.
    epsilon: fn(&Slopes, f64) -> Jet,
    /// Square of the curvature.
    kappa_squared: fn(&Slopes) -> Jet,
    /// Curvature.
    kappa: fn(&Slopes) -> Jet,
    /// Gauss points for strain, curvature and mass.
    points: [usize; 3],
    /// Masses on the four vectors as shares of the whole; `None` for the consistent matrix.
    lumped: Option<[f64; 4]>,
}

fn square(slopes: &[Jet]) -> Jet {
    slopes[0] * slopes[0] + slopes[1] * slopes[1]
}

fn stretch(s: &Slopes) -> Jet {
    square(&s[..2]).powf(0.5)
}

fn cross(s: &Slopes) -> Jet {
    s[0] * s[3] - s[1] * s[2]
}

fn kappa(s: &Slopes) -> Jet {
    cross(s) * square(&s[..2]).powf(-1.0)
}

impl Cable {
    /// The right element.
    pub fn new(state: &CableState) -> Cable {
        let &CableState { h, w, E, rho, .. } = state;
        Cable {
            EA: E * h * w,
            EI: E * w * h.powi(3) / 12.0,
            rho_A: rho * h * w,
            eps_T: if state.model == ThermalModel::None { 0.0 } else { state.alpha * state.dT },
            epsilon: |s, eps_T| stretch(s) - Jet::constant(1.0 + eps_T),
            kappa_squared: |s| kappa(s) * kappa(s),
            kappa,
            points: [5, 3, 5],
            lumped: None,
            state: state.clone(),
        }
    }

    fn B(&self, x: f64) -> B {
        let (S_x, S_xx) = (S_i_x(x, self.state.l), S_i_xx(x, self.state.l));
        B::from_fn(|row, column| {
            let functions = if row < 2 { &S_x } else { &S_xx };
            if column % 2 == row % 2 { functions[column / 2] } else { 0.0 }
        })
    }

    fn slopes(&self, x: f64) -> Slopes {
        let values = self.B(x) * Vector8::from(self.state.e);
        std::array::from_fn(|n| Jet::variable(values[n], n))
    }

    /// Points and weights of Gauss's rule on the axis.
    fn rule(&self, points: usize) -> impl Iterator<Item = (f64, f64)> {
        let l = self.state.l;
        gauss(points).iter().map(move |(xi, weight)| (l / 2.0 * (1.0 + xi), l / 2.0 * weight))
    }

    /// Energies of strain and curvature with their derivatives by e.
    pub fn energies(&self) -> [(f64, Vector8, Matrix8); 2] {
        let [axial, bending, _] = self.points;
        let of_strain = |s: &Slopes| {
            let epsilon = (self.epsilon)(s, self.eps_T);
            0.5 * self.EA * (epsilon * epsilon)
        };
        [
            self.integrated(axial, of_strain),
            self.integrated(bending, |s: &Slopes| 0.5 * self.EI * (self.kappa_squared)(s)),
        ]
    }

    fn integrated(&self, points: usize, density: impl Fn(&Slopes) -> Jet) -> (f64, Vector8, Matrix8) {
        let zero = (0.0, Vector8::zeros(), Matrix8::zeros());
        self.rule(points).fold(zero, |(U, Q_e, K), (x, dx)| {
            let (B, density) = (self.B(x), density(&self.slopes(x)));
            let (gradient, hessian) = (B.tr_mul(&density.gradient), B.tr_mul(&(density.hessian * B)));
            (U + density.value * dx, Q_e + gradient * dx, K + hessian * dx)
        })
    }

    fn functions(&self, x: f64) -> SMatrix<f64, 2, 8> {
        let S = S_i(x, self.state.l);
        SMatrix::from_fn(|row, column| if column % 2 == row { S[column / 2] } else { 0.0 })
    }

    fn M(&self) -> Matrix8 {
        if let Some(shares) = self.lumped {
            let mass = self.rho_A * self.state.l;
            return Matrix8::from_diagonal(&Vector8::from_fn(|n, _| mass * shares[n / 2]));
        }
        self.rule(self.points[2])
            .fold(Matrix8::zeros(), |M, (x, dx)| M + self.rho_A * dx * self.functions(x).tr_mul(&self.functions(x)))
    }

    fn Q_w(&self) -> Vector8 {
        let g = Vector2::from(self.state.gravity);
        if let Some(shares) = self.lumped {
            return Vector8::from_fn(|n, _| self.rho_A * self.state.l * shares[n / 2] * g[n % 2]);
        }
        self.rule(self.points[2])
            .fold(Vector8::zeros(), |Q, (x, dx)| Q + self.rho_A * dx * self.functions(x).tr_mul(&g))
    }

    /// Value of a quantity that depends on the parts; `None` for others, and where it is not finite.
    fn value(&self, quantity: &str) -> Option<Vec<f64>> {
        let at_points = |of: &dyn Fn(&Slopes) -> f64| {
            self.state.points.iter().map(|[x, _]| of(&self.slopes(*x))).collect::<Vec<f64>>()
        };
        let [axial, bending] = self.energies();
        let value = match quantity {
            "cable.epsilon" => at_points(&|s| (self.epsilon)(s, self.eps_T).value),
            "cable.kappa" => at_points(&|s| (self.kappa)(s).value),
            "cable.U" => vec![axial.0 + bending.0],
            "cable.Q_e" => rows(&(axial.1 + bending.1)),
            "cable.tangent" => rows(&(axial.2 + bending.2)),
            "cable.M" => rows(&self.M()),
            "cable.T" => {
                let edot = Vector8::from(self.state.edot);
                vec![0.5 * edot.dot(&(self.M() * edot))]
            }
            "cable.Q_w" => rows(&self.Q_w()),
            "cable.eddot" => rows(&motion::acceleration(&self.M(), &(axial.1 + bending.1), &self.Q_w())?),
            _ => return None,
        };
        value.iter().all(|number| number.is_finite()).then_some(value)
    }
}

type Change = Box<dyn Fn(&mut Cable)>;

fn change(
    kind: MistakeKind,
    what: impl Into<String>,
    change: impl Fn(&mut Cable) + 'static,
) -> (MistakeKind, String, Change) {
    (kind, what.into(), Box::new(change))
}

/// Candidates for a quantity of the Euler–Bernoulli element.
pub(super) fn of<'a>(quantity: &'a str, state: &'a CableState) -> Vec<Candidate<'a>> {
    let changed = |(kind, what, change): (MistakeKind, String, Change)| {
        possible(kind, what, move || {
            let mut cable = Cable::new(state);
            change(&mut cable);
            cable.value(quantity)
        })
    };
    let mut all: Vec<Candidate> =
        [strains(), curvatures(), sections(), heats(), masses(), rules()].into_iter().flatten().map(changed).collect();
    all.extend(readings(quantity, state));
    if quantity == "cable.tangent" {
        all.extend(tangents(state));
    }
    all
}

fn strains() -> Vec<(MistakeKind, String, Change)> {
    vec![
        change(Other, "½ (r_x·r_x − 1), Green's strain, for |r_x| − 1", |cable| {
            cable.epsilon = |s, eps_T| 0.5 * (square(&s[..2]) - Jet::constant(1.0)) - Jet::constant(eps_T);
        }),
        change(Other, "ln |r_x|, the logarithmic strain, for |r_x| − 1", |cable| {
            cable.epsilon = |s, eps_T| stretch(s).ln() - Jet::constant(eps_T);
        }),
        change(Factor, "r_x·r_x − 1 for |r_x| − 1", |cable| {
            cable.epsilon = |s, eps_T| square(&s[..2]) - Jet::constant(1.0 + eps_T);
        }),
        change(Missing, "|r_x| without the −1", |cable| {
            cable.epsilon = |s, eps_T| stretch(s) - Jet::constant(eps_T);
        }),
        change(Other, "1 − 1/|r_x| for |r_x| − 1", |cable| {
            cable.epsilon = |s, eps_T| Jet::constant(1.0 - eps_T) - stretch(s).powf(-1.0);
        }),
        change(Other, "the x component of r_x for |r_x|: small slopes", |cable| {
            cable.epsilon = |s, eps_T| s[0] - Jet::constant(1.0 + eps_T);
        }),
    ]
}

fn curvatures() -> Vec<(MistakeKind, String, Change)> {
    type Kappa = fn(&Slopes) -> Jet;
    type Squared = fn(&Slopes) -> Jet;
    let list: [(MistakeKind, &str, Kappa, Squared); 8] = [
        (
            Other,
            "|r_x|³ for |r_x|² in the curvature: per length of the curve",
            |s| cross(s) * square(&s[..2]).powf(-1.5),
            |s| cross(s) * cross(s) * square(&s[..2]).powf(-3.0),
        ),
        (
            Other,
            "|r_x| for |r_x|² in the curvature",
            |s| cross(s) * square(&s[..2]).powf(-0.5),
            |s| cross(s) * cross(s) * square(&s[..2]).powf(-1.0),
        ),
        (Missing, "r_x × r_xx without |r_x|² in the curvature", cross, |s| cross(s) * cross(s)),
        (Other, "|r_xx| for the curvature", |s| square(&s[2..]).powf(0.5), |s| square(&s[2..])),
        (Other, "the y component of r_xx for the curvature: small slopes", |s| s[3], |s| s[3] * s[3]),
        (Sign, "r_xx × r_x: the curvature with the wrong sign", |s| -kappa(s), |s| kappa(s) * kappa(s)),
        (
            Sign,
            "x′y″ + y′x″ in the curvature",
            |s| (s[0] * s[3] + s[1] * s[2]) * square(&s[..2]).powf(-1.0),
            |s| (s[0] * s[3] + s[1] * s[2]).powf(2.0) * square(&s[..2]).powf(-2.0),
        ),
        (Missing, "the derivative of |r_x|² missing in that of the curvature", kappa, |s| {
            cross(s) * cross(s) * square(&s[..2]).powf(-2.0).frozen()
        }),
    ];
    let with = |(kind, what, kappa, squared): (MistakeKind, &str, Kappa, Squared)| {
        change(kind, what, move |cable: &mut Cable| (cable.kappa, cable.kappa_squared) = (kappa, squared))
    };
    list.map(with).into()
}

fn sections() -> Vec<(MistakeKind, String, Change)> {
    type Section = fn(&CableState) -> f64;
    let of_I: [(MistakeKind, &str, Section); 6] = [
        (Factor, "I = w h³ without 1/12", |s| s.w * s.h.powi(3)),
        (Other, "I = h w³/12: h and w exchanged", |s| s.h * s.w.powi(3) / 12.0),
        (Factor, "I = w h³/3, about an edge", |s| s.w * s.h.powi(3) / 3.0),
        (Factor, "I = w h²/12", |s| s.w * s.h.powi(2) / 12.0),
        (Other, "I = w h²/6, the section modulus", |s| s.w * s.h.powi(2) / 6.0),
        (Missing, "I = h³/12 without the width", |s| s.h.powi(3) / 12.0),
    ];
    let mut all: Vec<_> =
        of_I.map(|(kind, what, I)| change(kind, what, move |cable| cable.EI = cable.state.E * I(&cable.state))).into();
    all.extend([
        change(Other, "EA and EI exchanged", |cable| std::mem::swap(&mut cable.EA, &mut cable.EI)),
        change(Other, "EA for EI", |cable| cable.EI = cable.EA),
        change(Other, "EI for EA", |cable| cable.EA = cable.EI),
        change(Missing, "EA = E: without the area", |cable| cable.EA = cable.state.E),
        change(Missing, "EI = E h² w/12", |cable| {
            cable.EI = cable.state.E * cable.state.h.powi(2) * cable.state.w / 12.0
        }),
        change(MistakeKind::Poisson, "E/(1 − ν²) for E", |cable| {
            let by = 1.0 / (1.0 - cable.state.nu.powi(2));
            (cable.EA, cable.EI) = (by * cable.EA, by * cable.EI);
        }),
    ]);
    all
}

fn heats() -> Vec<(MistakeKind, String, Change)> {
    let scaled = |kind: MistakeKind, what: &str, factor: f64| change(kind, what, move |cable| cable.eps_T *= factor);
    let only = |what: &str, model: ThermalModel| {
        change(Heat, what, move |cable| {
            if cable.state.model == model {
                cable.eps_T = 0.0;
            }
        })
    };
    vec![
        scaled(Sign, "heat with the wrong sign", -1.0),
        scaled(Missing, "heat missing", 0.0),
        scaled(Factor, "half of the heat", 0.5),
        scaled(Factor, "twice the heat", 2.0),
        scaled(Factor, "a third of the heat: volumetric for linear expansion", 1.0 / 3.0),
        scaled(Factor, "three times the heat: linear for volumetric expansion", 3.0),
        only("heat missing in the 1D model", ThermalModel::OneD),
        only("heat missing in the 2D model", ThermalModel::TwoD),
        change(Heat, "(1 + ν)αΔT for αΔT", |cable| cable.eps_T *= 1.0 + cable.state.nu),
        change(Heat, "√(1 + 2αΔT) − 1 for αΔT", |cable| {
            cable.eps_T = (1.0 + 2.0 * cable.eps_T).max(0.0).sqrt() - 1.0
        }),
        change(Heat, "heat where the model is none", |cable| cable.eps_T = cable.state.alpha * cable.state.dT),
        change(Heat, "ΔT + 273.15: ΔT is a difference of temperatures", |cable| {
            if cable.state.model != ThermalModel::None {
                cable.eps_T = cable.state.alpha * (cable.state.dT + 273.15);
            }
        }),
        change(Heat, "ΔT for αΔT", |cable| {
            if cable.state.model != ThermalModel::None {
                cable.eps_T = cable.state.dT;
            }
        }),
        change(Heat, "|r_x|/(1 + αΔT) − 1: heat as a factor of the length", |cable| {
            cable.epsilon = |s, eps_T| (1.0 / (1.0 + eps_T)) * stretch(s) - Jet::constant(1.0);
        }),
        change(Heat, "(|r_x| − 1)(1 − αΔT): heat as a factor of the strain", |cable| {
            cable.epsilon = |s, eps_T| (1.0 - eps_T) * (stretch(s) - Jet::constant(1.0));
        }),
    ]
}

fn masses() -> Vec<(MistakeKind, String, Change)> {
    let lumped = |what: &str, shares: [f64; 4]| change(Other, what, move |cable| cable.lumped = Some(shares));
    vec![
        lumped("lumped: half on each end", [0.5, 0.0, 0.5, 0.0]),
        lumped("lumped: a quarter on each vector", [0.25; 4]),
        change(Missing, "ρ missing in the mass", |cable| cable.rho_A = cable.state.h * cable.state.w),
        change(Missing, "the area missing in the mass", |cable| cable.rho_A = cable.state.rho),
        change(Missing, "ρ h for ρ h w: the width missing in the mass", |cable| {
            cable.rho_A = cable.state.rho * cable.state.h
        }),
        change(XyOrder, "x and y of gravity exchanged", |cable| cable.state.gravity.swap(0, 1)),
        change(Sign, "gravity with the wrong sign", |cable| cable.state.gravity = cable.state.gravity.map(|g| -g)),
    ]
}

/// Other numbers of Gauss points for strain and curvature, and for the mass.
fn rules() -> Vec<(MistakeKind, String, Change)> {
    let pairs = (1..=5).flat_map(|axial| (1..=5).map(move |bending| (axial, bending)));
    let mut all: Vec<_> = pairs
        .filter(|pair| *pair != (5, 3))
        .map(|(axial, bending)| {
            let what =
                format!("{axial} Gauss points for the strain and {bending} for the curvature; right are 5 and 3");
            change(Quadrature, what, move |cable| (cable.points[0], cable.points[1]) = (axial, bending))
        })
        .collect();
    all.extend((1..=3).map(|mass| {
        change(Quadrature, format!("{mass} Gauss points for the mass"), move |cable| cable.points[2] = mass)
    }));
    all
}

/// Misread coordinates and lengths.
fn readings<'a>(quantity: &'a str, state: &'a CableState) -> Vec<Candidate<'a>> {
    let with = |kind: MistakeKind, what: String, read: Box<dyn Fn(&mut CableState)>| {
        possible(kind, what, move || {
            let mut changed = state.clone();
            read(&mut changed);
            evaluate_cable(quantity, &changed)
        })
    };
    const VECTORS: [&str; 4] = ["r_i", "r_x_i", "r_k", "r_x_k"];
    let mut all: Vec<Candidate> = permutations()
        .into_iter()
        .map(|order| {
            let what = order.map(|k| VECTORS[k]).join(", ");
            let read = move |e: &[f64; 8]| std::array::from_fn(|n| e[2 * order[n / 2] + n % 2]);
            with(
                NodeOrder,
                format!("e read in the order {what}"),
                Box::new(move |state| {
                    (state.e, state.e0, state.edot) = (read(&state.e), read(&state.e0), read(&state.edot));
                }),
            )
        })
        .collect();
    type Other = (MistakeKind, &'static str, fn(&mut CableState));
    let others: [Other; 8] = [
        (XyOrder, "y before x in e", |s| {
            let read = |e: &[f64; 8]| std::array::from_fn(|n| e[n ^ 1]);
            (s.e, s.edot) = (read(&s.e), read(&s.edot));
        }),
        (XyOrder, "all x, then all y in e", |s| {
            let read = |e: &[f64; 8]| std::array::from_fn(|n| e[n / 2 + 4 * (n % 2)]);
            (s.e, s.edot) = (read(&s.e), read(&s.edot));
        }),
        (Other, "e0 read for e", |s| s.e = s.e0),
        (Other, "e − e0 read for e: displacements for positions", |s| {
            s.e = std::array::from_fn(|n| s.e[n] - s.e0[n])
        }),
        (Other, "e read for ė", |s| s.edot = s.e),
        (Other, "ė read for e", |s| s.e = s.edot),
        (Other, "h and w exchanged", |s| std::mem::swap(&mut s.h, &mut s.w)),
        (NodeOrder, "x measured from the other end", |s| s.points.iter_mut().for_each(|p| p[0] = s.l - p[0])),
    ];
    all.extend(others.map(|(kind, what, read)| with(kind, what.into(), Box::new(read))));
    all.push(with(Other, "x for x/l".into(), Box::new(|s| s.points.iter_mut().for_each(|point| point[0] *= s.l))));
    all
}

/// Tangents that lack a part.
fn tangents(state: &CableState) -> Vec<Candidate<'_>> {
    let parts = move || {
        let cable = Cable::new(state);
        let squares = |points: usize, of: &dyn Fn(&Slopes) -> Jet, stiffness: f64| {
            cable.rule(points).fold(Matrix8::zeros(), |K, (x, dx)| {
                let gradient = cable.B(x).tr_mul(&of(&cable.slopes(x)).gradient);
                K + stiffness * dx * gradient * gradient.transpose()
            })
        };
        let epsilon = |s: &Slopes| (cable.epsilon)(s, cable.eps_T);
        let own = [squares(5, &epsilon, cable.EA), squares(3, &|s| kappa(s), cable.EI)];
        let all = cable.energies().map(|(_, _, K)| K);
        (all, own)
    };
    vec![
        candidate(Missing, "the parts with ε and κ missing: the material part only", move || {
            let (_, [axial, bending]) = parts();
            rows(&(axial + bending))
        }),
        candidate(Missing, "the part with ε missing: stress does not stiffen", move || {
            let ([_, bending], [axial, _]) = parts();
            rows(&(axial + bending))
        }),
        candidate(Missing, "the part with κ and its second derivatives missing", move || {
            let ([axial, _], [_, bending]) = parts();
            rows(&(axial + bending))
        }),
        candidate(Missing, "the part with the derivatives of ε missing", move || {
            let ([axial, bending], [own, _]) = parts();
            rows(&(axial - own + bending))
        }),
        candidate(Missing, "the part with the derivatives of κ missing", move || {
            let ([axial, bending], [_, own]) = parts();
            rows(&(axial + bending - own))
        }),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{State, Suite};

    #[test]
    fn the_right_parts_give_the_reference_values() {
        for case in &Suite::embedded().unwrap().cases {
            let State::Cable(state) = &case.state else { continue };
            for (quantity, reference) in &case.values {
                let Some(value) = Cable::new(state).value(quantity) else { continue };
                let worst = reference.worst_entry(&value).1;
                assert!(worst <= 30.0, "{quantity} in {}: {worst}", case.id);
            }
        }
    }
}
