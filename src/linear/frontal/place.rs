//! Where the coordinates of an element of a chain stand.

/// Coordinates that an element shares with the next: two vectors.
pub const SHARED: usize = 4;

/// Most border unknowns of a chain: two components of two ends and of a pivot.
pub const MOST_BORDER_UNKNOWNS: usize = 6;

/// Stands for a coordinate that is no unknown of the chain's own.
pub const NONE: u32 = u32::MAX;

/// Where an element's coordinates stand.
#[derive(Clone, Debug)]
pub struct ElementPlaces<const N: usize> {
    /// Unknowns of the chain's own, [`NONE`] for others.
    pub own: [u32; N],
    /// Those others: the coordinate, and its place among the touched unknowns of the border; held ones have none.
    pub others: Vec<(usize, Option<usize>)>,
    /// How many of the border's unknowns this element or one before it touches, and where their sides begin.
    pub reached: usize,
    pub first_side: usize,
}

impl<const N: usize> ElementPlaces<N> {
    /// The place of an element; what it touches and no element before it did is added to `touches`.
    pub fn new(unknowns: [u32; N], border: usize, touches: &mut Vec<usize>, first_side: usize) -> ElementPlaces<N> {
        let own = unknowns.map(|unknown| if (unknown as usize) < border { unknown } else { NONE });
        let mut others = Vec::new();
        for n in (0..N).filter(|&n| own[n] == NONE) {
            let touched = (unknowns[n] != NONE).then_some(unknowns[n] as usize);
            others
                .push((n, touched.map(|touched| touches.iter().position(|&t| t == touched).unwrap_or(touches.len()))));
            touches.extend(touched.filter(|touched| !touches.contains(touched)));
        }
        ElementPlaces { own, others, reached: touches.len(), first_side }
    }
}
