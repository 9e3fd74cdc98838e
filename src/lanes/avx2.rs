//! Four numbers side by side in one register of AVX2, with fused products and sums.

use std::ops::{Add, Mul, Neg, Sub};

use pulp::f64x4;
use pulp::x86::V3;

use super::{LANES, Lanes};

/// Four numbers in one register.
#[derive(Clone, Copy)]
pub(super) struct Avx2(V3, f64x4);

impl Add for Avx2 {
    type Output = Avx2;
    #[inline(always)]
    fn add(self, other: Avx2) -> Avx2 {
        Avx2(self.0, self.0.add_f64x4(self.1, other.1))
    }
}

impl Sub for Avx2 {
    type Output = Avx2;
    #[inline(always)]
    fn sub(self, other: Avx2) -> Avx2 {
        Avx2(self.0, self.0.sub_f64x4(self.1, other.1))
    }
}

impl Mul for Avx2 {
    type Output = Avx2;
    #[inline(always)]
    fn mul(self, other: Avx2) -> Avx2 {
        Avx2(self.0, self.0.mul_f64x4(self.1, other.1))
    }
}

impl Neg for Avx2 {
    type Output = Avx2;
    #[inline(always)]
    fn neg(self) -> Avx2 {
        Avx2(self.0, self.0.xor_f64x4(self.1, self.0.splat_f64x4(-0.0)))
    }
}

impl Lanes for Avx2 {
    type Token = V3;

    #[inline(always)]
    fn splat(token: V3, number: f64) -> Avx2 {
        Avx2(token, token.splat_f64x4(number))
    }

    #[inline(always)]
    fn load(token: V3, &[a, b, c, d]: &[f64; LANES]) -> Avx2 {
        Avx2(token, f64x4(a, b, c, d))
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        let f64x4(a, b, c, d) = self.1;
        [a, b, c, d]
    }

    #[inline(always)]
    fn mul_add(self, factor: Avx2, sum: Avx2) -> Avx2 {
        Avx2(self.0, self.0.mul_add_f64x4(self.1, factor.1, sum.1))
    }

    #[inline(always)]
    fn recip(self) -> Avx2 {
        Avx2(self.0, self.0.div_f64x4(self.0.splat_f64x4(1.0), self.1))
    }

    #[inline(always)]
    fn sqrt(self) -> Avx2 {
        Avx2(self.0, self.0.sqrt_f64x4(self.1))
    }

    #[inline(always)]
    fn abs(self) -> Avx2 {
        Avx2(self.0, self.0.abs_f64x4(self.1))
    }

    #[inline(always)]
    fn min(self, other: Avx2) -> Avx2 {
        Avx2(self.0, self.0.min_f64x4(self.1, other.1))
    }

    /// Pairs of neighbours within the halves of a register, then halves between registers.
    #[inline(always)]
    fn transpose([a, b, c, d]: [Avx2; LANES]) -> [Avx2; LANES] {
        let token = a.0;
        let (a, b, c, d) = (pulp::cast(a.1), pulp::cast(b.1), pulp::cast(c.1), pulp::cast(d.1));
        let (even_ab, odd_ab) = (token.avx._mm256_unpacklo_pd(a, b), token.avx._mm256_unpackhi_pd(a, b));
        let (even_cd, odd_cd) = (token.avx._mm256_unpacklo_pd(c, d), token.avx._mm256_unpackhi_pd(c, d));
        [
            Avx2(token, pulp::cast(token.avx._mm256_permute2f128_pd::<0x20>(even_ab, even_cd))),
            Avx2(token, pulp::cast(token.avx._mm256_permute2f128_pd::<0x20>(odd_ab, odd_cd))),
            Avx2(token, pulp::cast(token.avx._mm256_permute2f128_pd::<0x31>(even_ab, even_cd))),
            Avx2(token, pulp::cast(token.avx._mm256_permute2f128_pd::<0x31>(odd_ab, odd_cd))),
        ]
    }

    #[inline(always)]
    fn shifted(self, before: Avx2) -> Avx2 {
        let token = self.0;
        let moved = token.avx2._mm256_permute4x64_pd::<0b10_01_00_00>(pulp::cast(self.1));
        let last = token.avx2._mm256_permute4x64_pd::<0b11_11_11_11>(pulp::cast(before.1));
        Avx2(token, pulp::cast(token.avx._mm256_blend_pd::<1>(moved, last)))
    }

    #[inline(always)]
    fn halves_swapped(self) -> Avx2 {
        let swapped = self.0.avx2._mm256_permute4x64_pd::<0b01_00_11_10>(pulp::cast(self.1));
        Avx2(self.0, pulp::cast(swapped))
    }
}
