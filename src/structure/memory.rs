//! Memory limit of matrices.

use crate::error::{Error, Result};

/// Most memory of one matrix, bytes: a structure that needs more is not a few rods.
const MOST_BYTES: usize = 2 << 30;

/// Matrices that a method holds at the same time: mass, tangent and its factors.
const MATRICES: usize = 3;

/// Refuses a matrix above the memory limit, and those that the system has no memory for: it would end the process when they are made.
pub fn check_memory(unknowns: usize, band: usize, bytes: usize) -> Result<()> {
    if bytes > MOST_BYTES {
        return Err(Error::TooLarge { unknowns, band, gigabytes: bytes as f64 / 1e9 });
    }
    Vec::<u8>::new().try_reserve_exact(MATRICES * bytes).map_err(|_| Error::OutOfMemory {
        what: format!("the {MATRICES} matrices of {unknowns} unknowns in a band of {band}"),
        gigabytes: (MATRICES * bytes) as f64 / 1e9,
        allowed: "fewer `elements`, or a computer with more memory".into(),
    })
}
