//! The memory that matrices take.

use crate::error::{Error, Result};

/// More memory than this for one matrix, in bytes, is refused: a structure that needs it is not a few rods.
const MOST_BYTES: usize = 2 << 30;

/// Refuses a matrix that would not fit into memory.
pub fn check_memory(unknowns: usize, band: usize, bytes: usize) -> Result<()> {
    if bytes > MOST_BYTES {
        return Err(Error::TooLarge { unknowns, band, gigabytes: bytes as f64 / 1e9 });
    }
    Ok(())
}
