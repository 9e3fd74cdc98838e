//! Figure 2: the pendulum, its weight and its temperature.

use crate::drawing::{Drawing, Line};
use crate::error::Result;
use crate::picture::Picture;
use crate::scene::builtin;

/// Pixels: of the picture, of the hinge, of the rod and of its height.
const SIZE: [f64; 2] = [760.0, 205.0];
const HINGE: [f64; 2] = [110.0, 120.0];
const ROD: [f64; 2] = [340.0, 14.0];

/// The panel of the temperature: left, top, width, height.
const PANEL: [f64; 4] = [570.0, 60.0, 130.0, 90.0];

/// Its file.
pub const FILE: &str = "figure2.svg";

/// The picture with its caption.
pub fn picture() -> Result<Picture> {
    let caption = "Figure 2: the pendulum at rest, and its temperature, which jumps at the start.";
    Ok(Picture { file: FILE, caption, svg: svg()? })
}

/// The picture, with the numbers of the built-in scene.
fn svg() -> Result<String> {
    let scene = builtin("pendulum-2d")?;
    let points = || scene.points.values().map(|[x, _]| *x);
    let length = points().fold(f64::MIN, f64::max) - points().fold(f64::MAX, f64::min);
    let gravity = scene.gravity[1].abs();
    let heat = scene.temperature.as_ref().map_or(0.0, |temperature| temperature.at(0.0));
    let mut drawing = Drawing::new(
        "figure2",
        SIZE,
        "A horizontal rod, hinged at its left end, under gravity, and the temperature over time: a jump at the start",
    );
    let [x, y] = HINGE;
    let [long, high] = ROD;
    let end = x + long;
    drawing.body(&[[x, y - 0.5 * high], [end, y - 0.5 * high], [end, y + 0.5 * high], [x, y + 0.5 * high]]);
    drawing.line(&[[x, y], [end, y]], Line::Dashed);
    drawing.line(&[[x, y], [x - 16.0, y + 28.0], [x + 16.0, y + 28.0], [x, y]], Line::Plain);
    drawing.line(&[[x - 34.0, y + 28.0], [x + 34.0, y + 28.0]], Line::Plain);
    drawing.dot(HINGE);
    drawing.dot([end, y]);
    drawing.words([x - 20.0, y - 12.0], "O");
    drawing.words([end + 9.0, y + 6.0], "A");
    for point in [[x, y - 30.0], [end, y - 30.0]] {
        drawing.line(&[point, [point[0], y - 50.0]], Line::Thin);
    }
    drawing.line(&[[x, y - 40.0], [end, y - 40.0]], Line::Thin);
    drawing.words(
        [x + 0.5 * long - 100.0, y - 50.0],
        &format!("{length} m long, {} mm high", number(1000.0 * scene.section.height)),
    );
    let middle = x + 0.5 * long;
    drawing.line(&[[middle, y + 20.0], [middle, y + 75.0]], Line::Arrow);
    drawing.letters([middle + 12.0, y + 62.0], true, ["g", "", ""]);
    drawing.words([middle + 28.0, y + 62.0], &format!("= {gravity} m/s²"));
    temperature(&mut drawing, heat);
    Ok(drawing.finish())
}

fn temperature(drawing: &mut Drawing, heat: f64) {
    let [left, top, width, height] = PANEL;
    let bottom = top + height;
    drawing.line(&[[left - 30.0, bottom], [left + width, bottom]], Line::Thin);
    drawing.line(&[[left, bottom + 8.0], [left, top - 20.0]], Line::Thin);
    drawing.line(&[[left - 30.0, bottom], [left, bottom], [left, top], [left + width, top]], Line::Plain);
    drawing.words([left + 10.0, top - 10.0], &format!("ΔT = {} K", number(heat)));
    drawing.words([left + width - 5.0, bottom + 20.0], "t");
    drawing.words([left - 5.0, bottom + 26.0], "0");
}

fn number(value: f64) -> String {
    format!("{}", value.round())
}

#[cfg(test)]
mod tests {
    #[test]
    fn its_numbers_are_those_of_the_scene() {
        let svg = super::svg().expect("a built-in scene");
        std::fs::write("/tmp/x/figure2.svg", &svg).unwrap();
        for words in ["1 m long, 20 mm high", "= 9.8 m/s²", "ΔT = 200 K"] {
            assert!(svg.contains(words), "{words}");
        }
    }
}
