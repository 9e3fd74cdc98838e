//! The drawing area of every picture: an SVG under a title.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::error::{Error, Result};

/// An area of a picture.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Result of drawing; writing into memory gives no error of its own.
pub type Drawn = std::result::Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Size of a picture, in pixels.
pub struct Size {
    pub width: u32,
    /// Height of the title, and of what `draw` puts below it.
    pub head: u32,
    /// Height of the rest.
    pub body: u32,
    /// Parts of a pixel: plotters has whole numbers for positions, and curves need finer ones.
    pub parts: u32,
}

/// A picture: `draw` gets the area below the title, and the body, both in parts of pixels.
///
/// # Errors
/// [`Error::Picture`] with the library's reason.
pub fn svg(title: &str, size: Size, draw: impl for<'a> FnOnce(&Area<'a>, &Area<'a>) -> Drawn) -> Result<String> {
    let mut text = String::new();
    let Size { width, head, body, parts } = size;
    let fine = (width * parts, (head + body) * parts);
    let drawn = || -> Drawn {
        let root = SVGBackend::with_string(&mut text, fine).into_drawing_area();
        root.fill(&WHITE)?;
        let (top, rest) = root.split_vertically(head * parts);
        draw(&top.titled(title, ("sans-serif", 20 * parts))?, &rest)?;
        root.present()
    };
    drawn().map_err(|reason| Error::Picture { title: title.into(), reason: reason.to_string() })?;
    let attributes = |(width, height): (u32, u32)| format!("<svg width=\"{width}\" height=\"{height}\"");
    // The view box keeps the parts.
    Ok(text.replacen(&attributes(fine), &attributes((width, head + body)), 1))
}
