//! Location of an element's coordinates among the unknowns of a chain and its border.

/// Number of coordinates that an element shares with the next: two vectors.
pub const SHARED: usize = 4;

/// Most border unknowns of a chain: two components of both ends and of a pivot.
pub const MOST_BORDER_UNKNOWNS: usize = 6;

/// Marks a coordinate without an unknown of the chain's own.
pub const NO_UNKNOWN: u32 = u32::MAX;

/// Unknowns of an element's coordinates.
#[derive(Clone, Debug)]
pub struct ElementUnknowns<const N: usize> {
    /// Unknowns of the chain's own; [`NO_UNKNOWN`] for the others.
    pub own: [u32; N],
    /// The other coordinates: each with its index among the touched border unknowns, or `None` if held.
    pub others: Vec<(usize, Option<usize>)>,
    /// Number of border unknowns touched by this element or one before it; below, the index of its first side.
    pub reached: usize,
    pub first_side: usize,
}

impl<const N: usize> ElementUnknowns<N> {
    /// Locates an element's coordinates; border unknowns that it is the first to touch are appended to `touches`.
    pub fn new(unknowns: [u32; N], border: usize, touches: &mut Vec<usize>, first_side: usize) -> ElementUnknowns<N> {
        let own = unknowns.map(|unknown| if (unknown as usize) < border { unknown } else { NO_UNKNOWN });
        let mut others = Vec::new();
        for n in (0..N).filter(|&n| own[n] == NO_UNKNOWN) {
            let touched = (unknowns[n] != NO_UNKNOWN).then_some(unknowns[n] as usize);
            others
                .push((n, touched.map(|touched| touches.iter().position(|&t| t == touched).unwrap_or(touches.len()))));
            touches.extend(touched.filter(|touched| !touches.contains(touched)));
        }
        ElementUnknowns { own, others, reached: touches.len(), first_side }
    }
}
