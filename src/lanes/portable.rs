//! Four numbers side by side with the instructions that every processor has.

use std::ops::{Add, Mul, Neg, Sub};

use wide::f64x4;

use super::{LANES, Lanes};

/// Four numbers, computed two at a time where the processor can.
#[derive(Clone, Copy)]
pub(super) struct Portable(f64x4);

impl Add for Portable {
    type Output = Portable;
    #[inline(always)]
    fn add(self, other: Portable) -> Portable {
        Portable(self.0 + other.0)
    }
}

impl Sub for Portable {
    type Output = Portable;
    #[inline(always)]
    fn sub(self, other: Portable) -> Portable {
        Portable(self.0 - other.0)
    }
}

impl Mul for Portable {
    type Output = Portable;
    #[inline(always)]
    fn mul(self, other: Portable) -> Portable {
        Portable(self.0 * other.0)
    }
}

impl Neg for Portable {
    type Output = Portable;
    #[inline(always)]
    fn neg(self) -> Portable {
        Portable(-self.0)
    }
}

impl Lanes for Portable {
    type Token = ();

    #[inline(always)]
    fn splat(_: (), number: f64) -> Portable {
        Portable(f64x4::splat(number))
    }

    #[inline(always)]
    fn load(_: (), row: &[f64; LANES]) -> Portable {
        Portable(f64x4::new(*row))
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        self.0.to_array()
    }

    /// Rounded twice, on processors with a fused instruction too.
    #[inline(always)]
    fn mul_add(self, factor: Portable, sum: Portable) -> Portable {
        Portable(self.0 * factor.0 + sum.0)
    }

    #[inline(always)]
    fn recip(self) -> Portable {
        Portable(f64x4::ONE / self.0)
    }

    #[inline(always)]
    fn sqrt(self) -> Portable {
        Portable(self.0.sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Portable {
        Portable(self.0.abs())
    }

    /// Number by number: processors differ in what they make of a NaN.
    #[inline(always)]
    fn min(self, other: Portable) -> Portable {
        let ([a, b, c, d], [p, q, r, s]) = (self.to_array(), other.to_array());
        Portable(f64x4::new([lesser(a, p), lesser(b, q), lesser(c, r), lesser(d, s)]))
    }

    #[inline(always)]
    fn transpose([a, b, c, d]: [Portable; LANES]) -> [Portable; LANES] {
        let (a, b, c, d) = (a.to_array(), b.to_array(), c.to_array(), d.to_array());
        [
            Portable(f64x4::new([a[0], b[0], c[0], d[0]])),
            Portable(f64x4::new([a[1], b[1], c[1], d[1]])),
            Portable(f64x4::new([a[2], b[2], c[2], d[2]])),
            Portable(f64x4::new([a[3], b[3], c[3], d[3]])),
        ]
    }

    #[inline(always)]
    fn shifted(self, before: Portable) -> Portable {
        let ([a, b, c, _], [_, _, _, last]) = (self.to_array(), before.to_array());
        Portable(f64x4::new([last, a, b, c]))
    }

    #[inline(always)]
    fn halves_swapped(self) -> Portable {
        let [a, b, c, d] = self.to_array();
        Portable(f64x4::new([c, d, a, b]))
    }
}

#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
