//! The paper's element, consistent form. Three things differ from the paper's arrangement; none changes a result:
//!
//! * **Through the thickness by hand.** With y across the section, r(x, y) = r₀(x) + y d(x): a cubic axis r₀ and a
//!   quadratic director d. All strains are polynomials in y,
//!   ε₁₁ = a₀ + a₁y + a₂y², ε₂₂ = c, 2ε₁₂ = g₀ + g₁y, so ∫dy needs only A = wh, I = wh³/12 and wh⁵/80, and
//!   five Gauss points along the axis remain of the fifteen.
//! * **In the rod's own axes.** The consistent energy is the same in every frame, so J₀ is the identity.
//! * **In displacements.** With u = e − e₀, p = u₀', δ = u_d, κ = u_d' and the initial unit vectors t and n:
//!   a₀ = t·p + ½p·p, c = n·δ + ½δ·δ, g₀ = t·δ + n·p + p·δ, a₁ = r'·κ, g₁ = d·κ, a₂ = ½κ·κ. No 1 is
//!   subtracted from a number near 1, so small strains keep their digits.

#![allow(non_snake_case)] // The symbols of the derivation are names here: A, I, C, B, N, eps_T.

use nalgebra::{Matrix2, SMatrix, SVector, Vector2};

use super::Meaning::{Position, SlopeX, SlopeY};
use super::{Beam, Ends, NodalVector, ThermalStrain};
use crate::equations::force::Matrix14;
use crate::equations::shape::{S, S_i_x, S_i_y, Vector14};
use crate::equations::volume::{GAUSS_5, axis_points};
use crate::scene::Poisson;

/// The generalized strains (a₀, a₁, a₂, c, g₀, g₁) of a section.
type Vector6 = SVector<f64, 6>;
type Matrix6 = SMatrix<f64, 6, 6>;

/// Places in `e` of the axis's vectors rⁱ, rʲ, r_xʲ, rᵏ and of the directors r_yⁱ, r_yʲ, r_yᵏ.
const AXIS: [usize; 4] = [0, 2, 3, 5];
const DIRECTOR: [usize; 3] = [1, 4, 6];

/// A Gauss point of the axis: weight (m) and shape functions there.
#[derive(Clone, Copy, Debug)]
struct Station {
    weight: f64,
    axis_x: [f64; 4],
    director: [f64; 3],
    director_x: [f64; 3],
}

/// The plane law of the section: Lamé's constants, Pa, and where Poisson's terms act.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// Lamé's first constant.
    pub lambda: f64,
    /// Shear modulus.
    pub mu: f64,
    /// Across the section, as in the paper, or on the axis ([`equations::axis`](crate::equations::axis)).
    pub poisson: Poisson,
}

/// One straight element: everything about it that does not change in time.
#[derive(Clone, Debug)]
pub struct Ancf {
    t: Vector2<f64>,
    n: Vector2<f64>,
    stations: [Station; 5],
    /// Section stiffness: derivative of the section's forces with respect to its strains.
    C: Matrix6,
}

/// The current vectors of a section: tangent r', director d and its rate κ = d'.
#[derive(Clone, Copy)]
struct Section {
    r_x: Vector2<f64>,
    d: Vector2<f64>,
    kappa: Vector2<f64>,
}

impl Section {
    /// B: derivative of the generalized strains with respect to (p, δ, κ).
    fn strain_rate(&self) -> Matrix6 {
        let Section { r_x, d, kappa } = self;
        let mut B = Matrix6::zeros();
        let mut place = |strain: usize, vector: usize, value: &Vector2<f64>| {
            B[(strain, 2 * vector)] = value.x;
            B[(strain, 2 * vector + 1)] = value.y;
        };
        place(0, 0, r_x);
        place(1, 0, kappa);
        place(1, 2, r_x);
        place(2, 2, kappa);
        place(3, 1, d);
        place(4, 0, d);
        place(4, 1, r_x);
        place(5, 1, kappa);
        place(5, 2, d);
        B
    }

    /// Change of (p, δ, κ) since an earlier state.
    fn change_from(&self, before: &Section) -> Vector6 {
        let change = [self.r_x - before.r_x, self.d - before.d, self.kappa - before.kappa];
        Vector6::from_fn(|i, _| change[i / 2][i % 2])
    }

    fn midpoint(&self, other: &Section) -> Section {
        Section {
            r_x: 0.5 * (self.r_x + other.r_x),
            d: 0.5 * (self.d + other.d),
            kappa: 0.5 * (self.kappa + other.kappa),
        }
    }
}

impl Ancf {
    /// An element of length `l`, section `h` × `w` (m) and inclination `theta` (rad).
    pub fn new(l: f64, h: f64, w: f64, theta: f64, law: Law) -> Ancf {
        let stations = axis_points(&GAUSS_5, l).map(|(x, weight)| {
            // Directors enter r as y·d: their shape functions are ∂S/∂y, and ∂²S/∂x∂y is ∂S/∂x at y = 1.
            let (axis_x, director, director_x) = (S_i_x(x, 0.0, l), S_i_y(x, 0.0, l), S_i_x(x, 1.0, l));
            Station {
                weight,
                axis_x: AXIS.map(|i| axis_x[i]),
                director: DIRECTOR.map(|i| director[i]),
                director_x: DIRECTOR.map(|i| director_x[i]),
            }
        });
        let (sin, cos) = theta.sin_cos();
        Ancf { t: Vector2::new(cos, sin), n: Vector2::new(-sin, cos), stations, C: law.section_stiffness(h, w) }
    }

    /// Section vectors and elastic generalized strains at a station.
    fn section(&self, station: &Station, u: &Vector14, eps_T: ThermalStrain) -> (Section, Vector6) {
        let vector = |i: usize| Vector2::new(u[2 * i], u[2 * i + 1]);
        let sum = |shape: &[f64], places: &[usize]| {
            shape.iter().zip(places).fold(Vector2::zeros(), |sum, (s, &i)| sum + *s * vector(i))
        };
        let p = sum(&station.axis_x, &AXIS);
        let delta = sum(&station.director, &DIRECTOR);
        let kappa = sum(&station.director_x, &DIRECTOR);
        let (r_x, d) = (self.t + p, self.n + delta);
        let strains = Vector6::new(
            self.t.dot(&p) + 0.5 * p.dot(&p) - eps_T[0],
            r_x.dot(&kappa),
            0.5 * kappa.dot(&kappa),
            self.n.dot(&delta) + 0.5 * delta.dot(&delta) - eps_T[1],
            self.t.dot(&delta) + self.n.dot(&p) + p.dot(&delta),
            d.dot(&kappa),
        );
        (Section { r_x, d, kappa }, strains)
    }

    /// Adds a station's force Bᵀ N to `Q`; `N` are the section's forces times the weight.
    fn add_force(&self, station: &Station, section: &Section, N: &Vector6, Q: &mut Vector14) {
        let Section { r_x, d, kappa } = section;
        let f_p = N[0] * r_x + N[4] * d + N[1] * kappa;
        let f_delta = N[3] * d + N[4] * r_x + N[5] * kappa;
        let f_kappa = N[1] * r_x + N[5] * d + N[2] * kappa;
        for (i, s_x) in AXIS.iter().zip(station.axis_x) {
            Q[2 * i] += s_x * f_p.x;
            Q[2 * i + 1] += s_x * f_p.y;
        }
        for (n, i) in DIRECTOR.iter().enumerate() {
            let (s, s_x) = (station.director[n], station.director_x[n]);
            Q[2 * i] += s * f_delta.x + s_x * f_kappa.x;
            Q[2 * i + 1] += s * f_delta.y + s_x * f_kappa.y;
        }
    }

    /// Adds a station's 6 × 6 stiffness in (p, δ, κ) to the element's `K`.
    fn add_stiffness(&self, station: &Station, H: &Matrix6, K: &mut Matrix14) {
        let block = |row: usize, column: usize| H.fixed_view::<2, 2>(2 * row, 2 * column).into_owned();
        let mut add = |row: usize, column: usize, value: Matrix2<f64>| {
            let mut target = K.fixed_view_mut::<2, 2>(2 * row, 2 * column);
            target += value;
        };
        for (&i, a_x) in AXIS.iter().zip(station.axis_x) {
            for (&j, b_x) in AXIS.iter().zip(station.axis_x) {
                add(i, j, a_x * b_x * block(0, 0));
            }
            for (m, &j) in DIRECTOR.iter().enumerate() {
                let (s, s_x) = (station.director[m], station.director_x[m]);
                add(i, j, a_x * (s * block(0, 1) + s_x * block(0, 2)));
                add(j, i, a_x * (s * block(1, 0) + s_x * block(2, 0)));
            }
        }
        for (n, &i) in DIRECTOR.iter().enumerate() {
            let (a, a_x) = (station.director[n], station.director_x[n]);
            for (m, &j) in DIRECTOR.iter().enumerate() {
                let (b, b_x) = (station.director[m], station.director_x[m]);
                let delta_row = b * block(1, 1) + b_x * block(1, 2);
                let kappa_row = b * block(2, 1) + b_x * block(2, 2);
                add(i, j, a * delta_row + a_x * kappa_row);
            }
        }
    }
}

impl Beam<14> for Ancf {
    const VECTORS: &'static [NodalVector] = &[
        (Position, 0.0),
        (SlopeY, 0.0),
        (Position, 0.5),
        (SlopeX, 0.5),
        (SlopeY, 0.5),
        (Position, 1.0),
        (SlopeY, 1.0),
    ];

    /// √(1 + 2ε) − 1 (M2).
    fn stress_free(eps_T: ThermalStrain) -> [f64; 2] {
        eps_T.map(|strain| (1.0 + 2.0 * strain).sqrt() - 1.0)
    }

    fn axis(fraction: f64, u: &Vector14, l: f64) -> Vector2<f64> {
        S(fraction * l, 0.0, l) * u
    }

    fn energy(&self, u: &Vector14, eps_T: ThermalStrain) -> f64 {
        self.stations
            .iter()
            .map(|station| {
                let (_, strains) = self.section(station, u, eps_T);
                0.5 * station.weight * strains.dot(&(self.C * strains))
            })
            .sum()
    }

    fn force(&self, u: &Vector14, eps_T: ThermalStrain) -> Vector14 {
        let mut Q = Vector14::zeros();
        for station in &self.stations {
            let (section, strains) = self.section(station, u, eps_T);
            self.add_force(station, &section, &(station.weight * (self.C * strains)), &mut Q);
        }
        Q
    }

    fn tangent(&self, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let mut K = Matrix14::zeros();
        for station in &self.stations {
            let (section, strains) = self.section(station, u, eps_T);
            let B = section.strain_rate();
            let H = B.transpose() * self.C * B + geometric(&(self.C * strains));
            self.add_stiffness(station, &(station.weight * H), &mut K);
        }
        K
    }

    fn mixed_tangent(&self, before: &Vector14, u: &Vector14, eps_T: ThermalStrain) -> Matrix14 {
        let mut K = Matrix14::zeros();
        for station in &self.stations {
            let (section_before, strains) = self.section(station, before, eps_T);
            let (section, _) = self.section(station, u, eps_T);
            let expected = self.C * (strains + section_before.strain_rate() * section.change_from(&section_before));
            let B = section.strain_rate();
            let H = B.transpose() * self.C * B + geometric(&expected);
            self.add_stiffness(station, &(station.weight * H), &mut K);
        }
        K
    }

    fn mean_force(&self, ends: &Ends<Vector14>) -> Vector14 {
        let mut Q = Vector14::zeros();
        for station in &self.stations {
            let (section_0, strains_0) = self.section(station, ends.u_0, ends.thermal_0);
            let (section_1, strains_1) = self.section(station, ends.u_1, ends.thermal_1);
            let N = 0.5 * station.weight * (self.C * (strains_0 + strains_1));
            self.add_force(station, &section_0.midpoint(&section_1), &N, &mut Q);
        }
        Q
    }

    fn mean_tangent(&self, ends: &Ends<Vector14>) -> Matrix14 {
        let mut K = Matrix14::zeros();
        for station in &self.stations {
            let (section_0, strains_0) = self.section(station, ends.u_0, ends.thermal_0);
            let (section_1, strains_1) = self.section(station, ends.u_1, ends.thermal_1);
            let B = section_0.midpoint(&section_1).strain_rate();
            let N = 0.5 * (self.C * (strains_0 + strains_1));
            let H = 0.5 * (B.transpose() * self.C * section_1.strain_rate() + geometric(&N));
            self.add_stiffness(station, &(station.weight * H), &mut K);
        }
        K
    }

    fn heating_work(&self, ends: &Ends<Vector14>) -> f64 {
        let change = [ends.thermal_1[0] - ends.thermal_0[0], ends.thermal_1[1] - ends.thermal_0[1]];
        self.stations
            .iter()
            .map(|station| {
                let (_, strains_0) = self.section(station, ends.u_0, ends.thermal_0);
                let (_, strains_1) = self.section(station, ends.u_1, ends.thermal_1);
                let N = 0.5 * (self.C * (strains_0 + strains_1));
                -station.weight * (N[0] * change[0] + N[3] * change[1])
            })
            .sum()
    }
}

impl Law {
    /// C of a section: ∫ dy of the law, in the order of the generalized strains. Where Poisson's terms act across it, λ couples
    /// ε₂₂ = c with all of ε₁₁ = a₀ + a₁y + a₂y²; where they act on the axis, with a₀ alone, and bending feels E/(1 − ν²).
    fn section_stiffness(&self, h: f64, w: f64) -> Matrix6 {
        let Law { lambda, mu, poisson } = *self;
        let (A, I, I_4) = (w * h, w * h.powi(3) / 12.0, w * h.powi(5) / 80.0);
        let stiff = lambda + 2.0 * mu;
        let (bending, coupled) = match poisson {
            Poisson::Full => (stiff, lambda),
            Poisson::Axis => (4.0 * mu * (lambda + mu) / stiff, 0.0),
        };
        #[rustfmt::skip]
        let C = Matrix6::new(
            stiff * A,   0.0,         bending * I,   lambda * A,  0.0,    0.0,
            0.0,         bending * I, 0.0,           0.0,         0.0,    0.0,
            bending * I, 0.0,         bending * I_4, coupled * I, 0.0,    0.0,
            lambda * A,  0.0,         coupled * I,   stiff * A,   0.0,    0.0,
            0.0,         0.0,         0.0,           0.0,         mu * A, 0.0,
            0.0,         0.0,         0.0,           0.0,         0.0,    mu * I,
        );
        C
    }
}

/// Second derivative of the strains in (p, δ, κ), contracted with the section forces: products of two vectors.
fn geometric(N: &Vector6) -> Matrix6 {
    let weights = [[N[0], N[4], N[1]], [N[4], N[3], N[5]], [N[1], N[5], N[2]]];
    Matrix6::from_fn(|row, column| if row % 2 == column % 2 { weights[row / 2][column / 2] } else { 0.0 })
}
