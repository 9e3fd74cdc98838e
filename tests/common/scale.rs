//! The scale of every quantity: the size of the terms that are added up for it, before they cancel.
//!
//! All of it follows from three lists, by hand from (3): how large a shape function and its derivatives get over the
//! element. Nothing here comes from `src/`, so that no mistake there can widen its own tolerance.

use super::Case;

/// Factors of the nodal coordinates in what is computed from them.
pub struct Scales {
    /// Largest terms of S over the element, by coordinate.
    N: [f64; 14],
    /// Largest |∂S/∂x| + |∂S/∂y| over the element, by coordinate.
    D: [f64; 14],
    /// |∂S/∂x| + |∂S/∂y| at the state's points (the oracle's values), by coordinate.
    at_points: Vec<[f64; 14]>,
    /// Terms of the gradient r_x, r_y at those points: Σ (|∂S/∂x| + |∂S/∂y|) |e|.
    gradients: Vec<f64>,
    volume: f64,
    /// |λ| + 2μ.
    stiff: f64,
}

impl Scales {
    pub fn of(case: &Case) -> Scales {
        let s = &case.state;
        let (l, h) = (s.l, s.h);
        let pairs = |v: [f64; 7]| -> [f64; 14] { std::array::from_fn(|i| v[i / 2]) };
        let b = h / 2.0 / l;
        // S₁ … S₇ over 0 ≤ a ≤ 1, |y| ≤ h/2; S₄ by its terms, which cancel to l/5.
        let N = pairs([1.0, h / 2.0, 1.0, l, h / 2.0, 1.0, h / 2.0]);
        let x = [5.0 / l, 3.0 * b, 4.0 / l, 2.0, 4.0 * b, 5.0 / l, 3.0 * b];
        let y = [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
        let D = pairs(std::array::from_fn(|i| x[i] + y[i]));
        let (S_x, S_y) = (case.value("3.S_x"), case.value("3.S_y"));
        let at_points: Vec<[f64; 14]> = (S_x.chunks(7).zip(S_y.chunks(7)))
            .map(|(x, y)| pairs(std::array::from_fn(|i| x[i].abs() + y[i].abs())))
            .collect();
        let gradient = |d: &[f64; 14]| d.iter().zip(&s.e).map(|(d, e)| d * e.abs()).sum::<f64>();
        Scales {
            N,
            D,
            gradients: at_points.iter().map(gradient).collect(),
            at_points,
            volume: l * h * s.w,
            stiff: case.scalar("17.lambda").abs() + 2.0 * case.scalar("17.mu"),
        }
    }

    /// Terms of a strain, ½ (eᵀS_a e − 1), point by point.
    fn strains(&self, entries: usize) -> Vec<f64> {
        self.gradients.iter().flat_map(|g| vec![0.5 * (g * g + 1.0); entries]).collect()
    }

    /// The larger of them, standing for the whole element.
    fn strain(&self) -> f64 {
        self.strains(1).into_iter().fold(0.0, f64::max)
    }

    /// Terms of Q_e = ∫ (∂ε/∂e)ᵀ σ dV.
    fn force(&self, i: usize) -> f64 {
        let gradient = self.gradients.iter().copied().fold(0.0, f64::max);
        self.stiff * self.volume * self.D[i] * gradient * self.strain()
    }

    /// Sizes of the coefficients (A.3) by the vectors that enter them.
    fn coefficients(&self, case: &Case) -> [f64; 7] {
        let l = case.state.l;
        let size = |n: usize| case.state.e[2 * n].abs().max(case.state.e[2 * n + 1].abs());
        let r = size(0).max(size(2)).max(size(5)).max(l * size(3));
        let r_y = size(1).max(size(4)).max(size(6));
        [r, 12.0 * r / l, r_y, 8.0 * r_y / l, 22.0 * r / l.powi(2), 12.0 * r / l.powi(3), 8.0 * r_y / l.powi(2)]
    }
}

/// The table: a quantity's scale, entry by entry, with the reason for it.
///
/// # Panics
/// For a quantity without a row.
pub fn scale(quantity: &str, case: &Case) -> Vec<f64> {
    let s = &case.state;
    let scales = Scales::of(case);
    let Scales { N, D, volume, stiff, .. } = scales;
    let c = scales.coefficients(case);
    let (l, h) = (s.l, s.h);

    let points = |per_point: Vec<f64>| per_point.repeat(s.points.len());
    let product = |factor: f64, a: &[f64; 14], b: &[f64; 14]| -> Vec<f64> {
        a.iter().flat_map(|a| b.iter().map(move |b| factor * a * b)).collect()
    };
    let sum = |e: &[f64; 14]| N.iter().zip(e).map(|(n, e)| n * e.abs()).sum::<f64>().max(f64::MIN_POSITIVE);
    let halves = |v: [f64; 7]| -> Vec<f64> { v.iter().flat_map(|v| [*v, *v]).collect() };
    let gravity = s.gravity[0].abs() + s.gravity[1].abs();
    // 1 − 2ν carries ν's rounding, ½ε_mach.
    let poisson = 1.0 / (1.0 - 2.0 * s.nu);

    match quantity {
        // Σ S_i e_i.
        "1.r" | "A.4.r" => points(vec![sum(&s.e); 2]),
        "5.rdot" => points(vec![sum(&s.edot); 2]),
        // The shape functions' own size.
        "2.S" => points([0, 1].iter().flat_map(|_| N).collect()),
        "3.S" => points((0..7).map(|i| N[2 * i]).collect()),
        "3.S_x" | "3.S_y" => points((0..7).map(|i| D[2 * i]).collect()),
        // Read from e unchanged; (A.3) and (A.1) take terms apart and add them again.
        "4.nodes" => vec![1.0; 14],
        "A.3.coefficients" | "A.3.coefficients/printed" => halves(c),
        "A.1.r" => {
            let axis = c[0] + c[1] * l + c[4] * l.powi(2) + c[5] * l.powi(3);
            points(vec![axis + h * (c[2] + c[3] * l + c[6] * l.powi(2)); 2])
        }
        "A.1.r_x" => {
            let axis = c[1] + 2.0 * c[4] * l + 3.0 * c[5] * l.powi(2);
            points(vec![axis + h * (c[3] + 2.0 * c[6] * l); 2])
        }
        "A.1.r_y" => points(vec![c[2] + c[3] * l + c[6] * l.powi(2); 2]),
        "A.2.e" => {
            let r = c[0] + c[1] * l + c[4] * l.powi(2) + c[5] * l.powi(3);
            let r_x = c[1] + 2.0 * c[4] * l + 3.0 * c[5] * l.powi(2);
            let r_y = c[2] + c[3] * l + c[6] * l.powi(2);
            halves([r, r_y, r, r_x, r_y, r, r_y])
        }
        // ½ρ ∫ ṙᵀṙ and ∫ρSᵀS: products of two such sums.
        "6.T" => vec![0.5 * s.rho * volume * sum(&s.edot).powi(2).max(f64::MIN_POSITIVE)],
        "7.M" => product(s.rho * volume, &N, &N),
        "gravity.Q_w" => N.iter().map(|n| s.rho * volume * n * gravity.max(1.0)).collect(),
        // The strain itself.
        "8.epsilon_T" => vec![(s.alpha * s.dT).abs().max(f64::MIN_POSITIVE); 3],
        // Σ S_x e₀ and Σ S_x e, times the rotation J₀⁻¹.
        "9.J_0" => points(vec![3.0; 4]),
        "9.J" => scales.gradients.iter().flat_map(|g| [*g; 4]).collect(),
        // S_a = G₁ᵀG₁, products of derivatives of S.
        "11.S_a" | "11.S_b" | "11.S_c" | "21.S_a1" | "21.S_b1" | "21.S_c1" => {
            scales.at_points.iter().flat_map(|d| product(1.0, d, d)).collect()
        }
        // A square of the gradient, less 1; the stress: times the stiffness.
        "10.epsilon_m" => scales.strains(4),
        "12.epsilon_f" | "14.epsilon" => scales.strains(3),
        "13.epsilon_1" | "13.epsilon_2" | "13.epsilon_3" => scales.strains(1),
        "15.sigma" => scales.strains(3).iter().map(|strain| stiff * poisson * strain).collect(),
        // λ and μ, with ν's rounding in 1 − 2ν.
        "16.D" => vec![stiff * poisson; 9],
        "17.lambda" => vec![stiff * poisson],
        "17.mu" => vec![stiff],
        // ½ ∫ ε : σ.
        "18.U" | "18.U/printed-shear" => vec![0.5 * stiff * poisson * volume * scales.strain().powi(2)],
        // As the same quantities of the consistent form, in other axes.
        "axis.D_0" | "uniaxial.D" => vec![stiff * poisson; 9],
        "axis.epsilon" => scales.strains(3),
        "axis.U" | "uniaxial.U" => vec![0.5 * stiff * poisson * volume * scales.strain().powi(2)],
        // ∫ S_a1 (eᵀS_a e − 1), and times the stiffness; the tangent's second part is of the same size.
        "21.K_1" | "21.K_2" | "21.K_3" | "21.K_3/printed" => product(volume * scales.strain(), &D, &D),
        "20.K"
        | "20.K/printed-shear"
        | "tangent.dQ_e"
        | "tangent.dQ_e/printed-shear"
        | "axis.tangent"
        | "uniaxial.tangent" => product(stiff * poisson * volume * scales.strain(), &D, &D),
        "19.Q_e" | "19.Q_e/printed-shear" | "axis.Q_e" | "uniaxial.Q_e" => {
            (0..14).map(|i| poisson * scales.force(i)).collect()
        }
        // Inertia, elastic force and weight.
        "22.residual" => {
            (0..14).map(|i| poisson * scales.force(i) + s.rho * volume * N[i] * (sum(&s.edot) + gravity)).collect()
        }
        // Forces through |M⁻¹|.
        "22.eddot" => {
            let M = nalgebra::DMatrix::from_row_slice(14, 14, &case.value("7.M"));
            let inverse = M.cholesky().unwrap().inverse().abs();
            let load =
                nalgebra::DVector::from_fn(14, |i, _| poisson * scales.force(i) + s.rho * volume * N[i] * gravity);
            (inverse * load).as_slice().to_vec()
        }
        _ => panic!("no scale for {quantity}"),
    }
}
