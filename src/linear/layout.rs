//! Numbering of the unknowns of a bordered matrix.

use super::BandMatrix;

/// Numbering of blocks and border, found once per structure.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// Blocks; the unknowns of block i follow those of block i − 1.
    pub blocks: Vec<BlockLayout>,
    /// First unknown of the border, which is the number of unknowns before it.
    pub border: usize,
    /// Number of border unknowns.
    pub border_size: usize,
    /// Half-width of the border's band.
    pub border_band: usize,
}

/// Unknowns of one block.
#[derive(Clone, Debug, Default)]
pub struct BlockLayout {
    /// First unknown of the block.
    pub first: usize,
    /// Number of unknowns of the block.
    pub size: usize,
    /// Half-width of the block's band.
    pub band: usize,
    /// Border unknowns that the block touches.
    pub touches: Vec<usize>,
}

impl Layout {
    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.border + self.border_size
    }

    /// Memory of one matrix with its factors, bytes.
    pub fn bytes(&self) -> usize {
        let block = |block: &BlockLayout| {
            let wide = block.size.saturating_mul(2 * block.touches.len()).saturating_mul(size_of::<f64>());
            BandMatrix::<f64>::bytes(block.size, block.band).saturating_add(wide)
        };
        let corner = BandMatrix::<f64>::bytes(self.border_size, self.border_band);
        self.blocks.iter().map(block).fold(corner, usize::saturating_add)
    }
}
