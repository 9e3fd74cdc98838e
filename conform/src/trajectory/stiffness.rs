//! Strains and stresses of the paper's element in the rod's own axes, with room for mistakes.

/// Stresses per strain in the rod's own axes.
#[derive(Clone, Copy, Debug)]
pub struct Stiffness {
    /// Stress S_11 per strain ε_11.
    pub along: f64,
    /// Stress S_22 per strain ε_22.
    pub across: f64,
    /// Stress of one direction per strain of the other.
    pub coupling: f64,
    /// Stress S_12 per strain ε_12.
    pub shear: f64,
    /// Of E3: taken from the shear of the global axes.
    pub printed: f64,
    /// Whether the strains are linear in the displacement.
    pub linear: bool,
    /// Kelvin and Voigt's time of retardation, s.
    pub retardation: f64,
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a x + b y.
fn sum(a: f64, x: [f64; 2], b: f64, y: [f64; 2]) -> [f64; 2] {
    [a * x[0] + b * y[0], a * x[1] + b * y[1]]
}

impl Stiffness {
    /// Strains (11, 22, 12) in the rod's own axes, less the thermal ones.
    #[inline]
    pub fn strains(&self, r_x: [f64; 2], r_y: [f64; 2], heat: [f64; 2], t: [f64; 2]) -> [f64; 3] {
        if self.linear {
            let n = [-t[1], t[0]];
            return [dot(t, r_x) - 1.0 - heat[0], dot(n, r_y) - 1.0 - heat[1], 0.5 * (dot(n, r_x) + dot(t, r_y))];
        }
        [0.5 * (dot(r_x, r_x) - 1.0) - heat[0], 0.5 * (dot(r_y, r_y) - 1.0) - heat[1], 0.5 * dot(r_x, r_y)]
    }

    /// Derivatives of the energy density by the strains (11, 22, 12).
    #[inline]
    pub fn stresses(&self, [e_1, e_2, e_12]: [f64; 3], t: [f64; 2]) -> [f64; 3] {
        let mut stresses =
            [self.along * e_1 + self.coupling * e_2, self.across * e_2 + self.coupling * e_1, 2.0 * self.shear * e_12];
        if self.printed != 0.0 {
            // Half of the shear ε_12 of the global axes is missing.
            let (product, difference) = (t[0] * t[1], t[0] * t[0] - t[1] * t[1]);
            let missing = self.printed * (product * (e_1 - e_2) + difference * e_12);
            stresses[0] -= missing * product;
            stresses[1] += missing * product;
            stresses[2] -= missing * difference;
        }
        stresses
    }

    /// Forces that do work in changes of r_x and of r_y.
    #[inline]
    pub fn forces(
        &self,
        r_x: [f64; 2],
        r_y: [f64; 2],
        rates: Option<[[f64; 2]; 2]>,
        heat: [f64; 2],
        t: [f64; 2],
    ) -> [[f64; 2]; 2] {
        let mut strains = self.strains(r_x, r_y, heat, t);
        if let Some([v_x, v_y]) = rates {
            let rates = [dot(r_x, v_x), dot(r_y, v_y), 0.5 * (dot(v_x, r_y) + dot(r_x, v_y))];
            strains.iter_mut().zip(rates).for_each(|(strain, rate)| *strain += self.retardation * rate);
        }
        let [s_1, s_2, s_12] = self.stresses(strains, t);
        let (x, y) = if self.linear { (t, [-t[1], t[0]]) } else { (r_x, r_y) };
        [sum(s_1, x, 0.5 * s_12, y), sum(s_2, y, 0.5 * s_12, x)]
    }
}
