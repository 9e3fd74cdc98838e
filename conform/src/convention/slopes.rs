//! Parameter by which the slopes are derivatives.

/// What the slopes r_x or r_y are multiplied by in a program's e: dx/dξ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Slope {
    /// Derivatives by the length, as in the paper.
    #[default]
    One,
    /// By ξ from −1 to 1 along the element.
    HalfLength,
    /// By ξ from 0 to 1 along the element, or by y/l across it.
    Length,
    /// By η from −1 to 1 across the element.
    HalfHeight,
    /// By η from −½ to ½ or from 0 to 1 across the element.
    Height,
}

/// Choices for r_x, usual ones first.
pub(super) const ALONG: [Slope; 3] = [Slope::One, Slope::HalfLength, Slope::Length];
/// Choices for r_y, usual ones first.
pub(super) const ACROSS: [Slope; 5] = [Slope::One, Slope::HalfHeight, Slope::Height, Slope::Length, Slope::HalfLength];

impl Slope {
    /// Factor of the slopes in an element of length `l` and height `h`.
    pub(super) fn factor(self, l: f64, h: f64) -> f64 {
        match self {
            Slope::One => 1.0,
            Slope::HalfLength => l / 2.0,
            Slope::Length => l,
            Slope::HalfHeight => h / 2.0,
            Slope::Height => h,
        }
    }

    /// Value in the key `slopes` of `hello`.
    pub(super) fn name(self) -> &'static str {
        match self {
            Slope::One => "1",
            Slope::HalfLength => "l/2",
            Slope::Length => "l",
            Slope::HalfHeight => "h/2",
            Slope::Height => "h",
        }
    }
}
