//! Four numbers side by side: the same formula for four elements at once. The only place that knows the processor.
//!
//! ```text
//!             lane 0    lane 1    lane 2    lane 3
//!           ┌─────────┬─────────┬─────────┬─────────┐
//! a: Lanes  │ of      │ of      │ of      │ of      │    one instruction computes all four
//!           │ element │ element │ element │ element │
//!           │ e       │ e + 1   │ e + 2   │ e + 3   │
//!           └─────────┴─────────┴─────────┴─────────┘
//! ```
//!
//! A [`Task`] is written once, for any [`Lanes`], and [`Path::run`] chooses among two forms of it:
//!
//! * **portable**: two numbers of the compiler's least processor at a time (SSE2, NEON, or one on WebAssembly). A product and a
//!   sum are rounded one after the other, so that every machine computes the same bits.
//! * **AVX2**: four numbers in one register, and fused products and sums, rounded once. Where the processor has it.
//!
//! Both agree to rounding. The environment variable `ANCF_PORTABLE=1` forces the portable form.
//!
//! Code for AVX2 is compiled for a processor that the rest of the crate is not compiled for. A function is inlined into it only where
//! it must be: everything below [`Task::run`] is `#[inline(always)]`, and closures, which cannot be, are avoided.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod path;
mod portable;

pub use path::{Path, Task};

use std::ops::{Add, Mul, Neg, Sub};

/// Number of elements side by side.
pub const LANES: usize = 4;

/// Four numbers side by side.
pub trait Lanes: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// Proof that the processor has the instructions.
    type Token: Copy;

    /// `number` in every lane.
    fn splat(token: Self::Token, number: f64) -> Self;

    /// Numbers of a row in memory.
    fn load(token: Self::Token, row: &[f64; LANES]) -> Self;

    /// The numbers, lane by lane.
    fn to_array(self) -> [f64; LANES];

    /// `self` · `factor` + `sum`.
    fn mul_add(self, factor: Self, sum: Self) -> Self;

    /// 1/`self`.
    fn recip(self) -> Self;

    /// Square root.
    fn sqrt(self) -> Self;

    /// Magnitude.
    fn abs(self) -> Self;

    /// The lesser of each two numbers; `other` where one of them is not a number.
    fn min(self, other: Self) -> Self;

    /// Rows to columns: lane n of row m to lane m of row n.
    fn transpose(rows: [Self; LANES]) -> [Self; LANES];

    /// Each number moved to the next lane, and the last one of `before` in the first: (before₃, a₀, a₁, a₂).
    fn shifted(self, before: Self) -> Self;

    /// Halves exchanged: (a₂, a₃, a₀, a₁).
    fn halves_swapped(self) -> Self;
}

/// Repeats a block for the lanes below a number, in ascending or (`rev`) descending order. The compiler leaves a loop with such a
/// block a loop, and then keeps its registers in memory.
macro_rules! for_lanes {
    ($lane:ident < $count:expr, $body:block) => {
        $crate::lanes::for_lanes!(@ $lane, $count, $body, 0 1 2 3)
    };
    (rev $lane:ident < $count:expr, $body:block) => {
        $crate::lanes::for_lanes!(@ $lane, $count, $body, 3 2 1 0)
    };
    (@ $lane:ident, $count:expr, $body:block, $($number:literal)*) => {{
        $({
            let $lane: usize = $number;
            if $lane < $count $body
        })*
    }};
}
pub(crate) use for_lanes;

/// Row of four numbers that begins at `at`.
#[inline(always)]
pub fn load<L: Lanes>(token: L::Token, numbers: &[f64], at: usize) -> L {
    let mut row = [0.0; LANES];
    row.copy_from_slice(&numbers[at..at + LANES]);
    L::load(token, &row)
}

/// Writes four numbers, from `at` on.
#[inline(always)]
pub fn store<L: Lanes>(row: L, numbers: &mut [f64], at: usize) {
    numbers[at..at + LANES].copy_from_slice(&row.to_array());
}
