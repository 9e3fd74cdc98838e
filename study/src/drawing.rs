//! Drawings with arrows and letters: SVG with colours for light pages and dark ones.

use std::fmt::Write;

/// A drawing that is being made. Places are in pixels, y downwards.
pub struct Drawing {
    svg: String,
}

/// How a line is drawn.
#[derive(Clone, Copy)]
pub enum Line {
    Plain,
    Thin,
    Dashed,
    /// A vector, with a head at its end.
    Arrow,
}

/// Room of an arrow's head, in pixels.
const HEAD: f64 = 11.0;

impl Drawing {
    /// An empty drawing of a size, with a name that no other has and a text for those who cannot see it.
    pub fn new(name: &str, size: [f64; 2], says: &str) -> Drawing {
        let [width, height] = size;
        let styles = format!(
            "#{name} text{{font:17px system-ui,sans-serif;fill:#444}}#{name} .v{{font-weight:bold}}#{name} path{{stroke:#444;fill:none}}\
             #{name} .body{{fill:#0072b2;fill-opacity:.16;stroke:#0072b2}}#{name} .arrow{{stroke:#d55e00}}\
             #{name} .head{{fill:#d55e00;stroke:none}}#{name} .dot{{fill:#444}}@media(prefers-color-scheme:dark){{#{name} text{{fill:#ccc}}\
             #{name} path{{stroke:#ccc}}#{name} .body{{fill:#56b4e9;stroke:#56b4e9}}#{name} .arrow{{stroke:#e69f00}}\
             #{name} .head{{fill:#e69f00;stroke:none}}#{name} .dot{{fill:#ccc}}}}"
        );
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" id=\"{name}\" \
             role=\"img\" aria-label=\"{says}\">\n<style>{styles}</style>\n"
        );
        Drawing { svg }
    }

    /// The picture.
    pub fn finish(self) -> String {
        self.svg + "</svg>\n"
    }

    /// A body inside of a closed line.
    pub fn body(&mut self, outline: &[[f64; 2]]) {
        self.add(&format!("<path class=\"body\" stroke-width=\"1.5\" d=\"{}Z\"/>", path(outline)));
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f64; 2]], line: Line) {
        let d = path(points);
        let style = match line {
            Line::Plain => "stroke-width=\"2\"",
            Line::Thin => "stroke-width=\"1\"",
            Line::Dashed => "stroke-width=\"1\" stroke-dasharray=\"7 4 2 4\"",
            Line::Arrow => return self.arrow(points),
        };
        self.add(&format!("<path {style} d=\"{d}\"/>"));
    }

    fn arrow(&mut self, points: &[[f64; 2]]) {
        let [.., from, to] = points else { return };
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
        let [x, y] = [dx / length * HEAD, dy / length * HEAD];
        let base = [to[0] - x, to[1] - y];
        let sides = [[base[0] - 0.4 * y, base[1] + 0.4 * x], *to, [base[0] + 0.4 * y, base[1] - 0.4 * x]];
        let shaft: Vec<[f64; 2]> = points[..points.len() - 1].iter().copied().chain([base]).collect();
        self.add(&format!("<path class=\"arrow\" stroke-width=\"2\" d=\"{}\"/>", path(&shaft)));
        self.add(&format!("<path class=\"head\" d=\"{}Z\"/>", path(&sides)));
    }

    /// A dot.
    pub fn dot(&mut self, [x, y]: [f64; 2]) {
        self.add(&format!("<circle class=\"dot\" r=\"4\" cx=\"{x:.1}\" cy=\"{y:.1}\"/>"));
    }

    /// Letters that begin at a place; `above` is raised, `below` lowered. Vectors are bold.
    pub fn letters(&mut self, [x, y]: [f64; 2], is_vector: bool, letters: [&str; 3]) {
        let class = if is_vector { " class=\"v\"" } else { "" };
        let [main, above, below] = letters;
        let mut spans = String::new();
        for (text, up) in [(above, -7), (below, 5)].into_iter().filter(|(text, _)| !text.is_empty()) {
            // The shift back puts the other index under this one. Writing into a string cannot fail.
            let _ = write!(
                spans,
                "<tspan dy=\"{up}\" font-size=\"12\">{text}</tspan><tspan dy=\"{}\">\u{200b}</tspan>",
                -up
            );
        }
        self.add(&format!("<text{class} x=\"{x:.1}\" y=\"{y:.1}\">{main}{spans}</text>"));
    }

    /// Words that begin at a place.
    pub fn words(&mut self, place: [f64; 2], words: &str) {
        self.letters(place, false, [words, "", ""]);
    }

    fn add(&mut self, element: &str) {
        self.svg += element;
        self.svg.push('\n');
    }
}

/// Straight lines from point to point.
fn path(points: &[[f64; 2]]) -> String {
    let pairs: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
    format!("M{}", pairs.join("L"))
}
