//! Where the unknowns of a bordered matrix stand.

use super::BandMatrix;

/// Where everything stands; found once for a structure.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// The blocks; block i's own unknowns follow on those of block i − 1.
    pub blocks: Vec<BlockLayout>,
    /// First unknown of the border, the number of unknowns before it.
    pub border: usize,
    /// Number of the border's unknowns.
    pub border_size: usize,
    /// Half-width of the border's band.
    pub border_band: usize,
}

/// One block's place.
#[derive(Clone, Debug, Default)]
pub struct BlockLayout {
    /// Its first unknown.
    pub first: usize,
    /// Number of its own unknowns.
    pub size: usize,
    /// Half-width of its band.
    pub band: usize,
    /// Unknowns of the border that it touches.
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
