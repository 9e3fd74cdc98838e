//! `modes.html`: the table, and a picture of each shape. It asks for nothing and runs no script.

use ancf::model::Scene;
use ancf::run::{Buckling, Modes};
use ancf_study::escape;

use super::picture::svg;
use super::{frequency, heading, kind, sentence};

const PAGE: &str = include_str!("../../assets/modes/page.html");
const STYLES: [&str; 2] = [include_str!("../../assets/run/page.css"), include_str!("../../assets/modes/page.css")];

/// Text of the page.
pub fn text(scene: &Scene, found: &Modes, buckled: Option<&Buckling>) -> String {
    let title = if scene.title.is_empty() { "Modes" } else { &scene.title };
    let mut body = String::new();
    for (n, mode) in found.modes.iter().enumerate() {
        let caption = match mode.frequency() {
            Some(_) => format!("{}: {} Hz, {}", n + 1, frequency(mode), kind(mode)),
            None => format!("{}: {}", n + 1, kind(mode)),
        };
        body += &figure(&svg(&found.equilibrium, &mode.shape, &format!("Shape of mode {}", n + 1)), &caption);
    }
    if let Some(buckled) = buckled {
        let picture = if buckled.shape.is_empty() {
            String::new()
        } else {
            svg(&buckled.unloaded, &buckled.shape, "Shape of the linearised buckling")
        };
        body += &figure(&picture, &sentence(buckled));
    }
    // A title in braces is no place to be filled in.
    PAGE.replace("{{title}}", &escape::html(title).replace('{', "&#123;"))
        .replace("{{style}}", &STYLES.concat())
        .replace("{{heading}}", &escape::html(&heading(found)))
        .replace("{{program}}", concat!("ancf ", env!("CARGO_PKG_VERSION")))
        .replace("{{body}}", &body)
}

fn figure(picture: &str, caption: &str) -> String {
    format!("<figure class=\"chart\"><figcaption>{}</figcaption>{picture}</figure>\n", escape::html(caption))
}
