//! Memory limit of matrices.

use crate::error::{Error, Result};

/// Most memory of one matrix, bytes: a structure that needs more is not a few rods.
const MOST_BYTES: usize = 2 << 30;

/// Refuses a matrix above the memory limit.
pub fn check_memory(unknowns: usize, band: usize, bytes: usize) -> Result<()> {
    if bytes > MOST_BYTES {
        return Err(Error::TooLarge { unknowns, band, gigabytes: bytes as f64 / 1e9 });
    }
    Ok(())
}
