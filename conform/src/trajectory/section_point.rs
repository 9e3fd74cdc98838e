//! A Gauss point of an element: derivatives of the position there, and forces that do work in their changes.

#![allow(non_snake_case)] // The paper's symbols are names here.

/// A Gauss point: derivatives of the shape functions by x and by y (of a cable r_x and r_xx), and its share of the volume (length).
#[derive(Clone, Debug)]
pub struct Point<const N: usize> {
    /// Derivatives by x.
    pub a: [f64; N],
    /// Derivatives by y; of a cable the second ones by x.
    pub b: [f64; N],
    /// Share of the volume, or of the length.
    pub weight: f64,
}

impl<const N: usize> Point<N> {
    /// Derivatives of the position at the point.
    #[inline]
    pub fn slopes(&self, q: &[f64]) -> [[f64; 2]; 2] {
        let mut slopes = [[0.0; 2]; 2];
        for ((a, b), r) in self.a.iter().zip(&self.b).zip(q.chunks_exact(2)) {
            slopes[0][0] += a * r[0];
            slopes[0][1] += a * r[1];
            slopes[1][0] += b * r[0];
            slopes[1][1] += b * r[1];
        }
        slopes
    }

    /// Adds the forces that do work in changes of the two derivatives.
    #[inline]
    pub fn add(&self, on_a: [f64; 2], on_b: [f64; 2], Q_e: &mut [f64; 14]) {
        for ((a, b), Q) in self.a.iter().zip(&self.b).zip(Q_e.chunks_exact_mut(2)) {
            let (a, b) = (self.weight * a, self.weight * b);
            Q[0] += a * on_a[0] + b * on_b[0];
            Q[1] += a * on_a[1] + b * on_b[1];
        }
    }
}
