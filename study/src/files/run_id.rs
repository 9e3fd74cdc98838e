//! Id of a run, from what it found.

use std::fmt;
use std::fs::File;
use std::io::{self, Write};

use sha2::{Digest, Sha256};

/// Bytes of the id: two runs among a thousand million have the same by chance once in forty.
const BYTES: usize = 8;

/// Id of a run: the beginning of the SHA-256 of its tables.
#[derive(Clone, Debug, Default)]
pub struct RunId(Sha256);

impl RunId {
    /// Adds the bytes of a table.
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }
}

impl fmt::Display for RunId {
    /// 16 hexadecimal digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.clone().finalize().iter().take(BYTES).try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// A file whose bytes count for the id.
pub(super) struct Hashing<'a> {
    pub(super) file: &'a mut File,
    pub(super) id: &'a mut RunId,
}

impl Write for Hashing<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.file.write(bytes)?;
        self.id.add(bytes.get(..count).unwrap_or_default());
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `printf abc | sha256sum` (FIPS 180-4).
    #[test]
    fn id_is_the_beginning_of_sha256() {
        let mut id = RunId::default();
        id.add(b"a");
        id.add(b"bc");
        assert_eq!(id.to_string(), "ba7816bf8f01cfea");
    }
}
