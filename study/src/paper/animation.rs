//! The structure in motion: an SVG that plays by itself, coloured by temperature.

use std::fmt::Write;

use super::scissors::ScissorsRun;

/// Seconds of the motion, and of one turn of the picture with a rest at its end.
const END: f64 = 3.0;
const TURN: f64 = 7.0;
const MOVES: f64 = 6.0;
/// Pictures in a turn: one each 0.05 s of the motion.
const FRAMES: usize = 60;

/// Pixels: of the picture, of a metre, of the origin, and of the temperature's panel.
const SIZE: [f64; 2] = [960.0, 400.0];
const METRE: f64 = 125.0;
const ORIGIN: [f64; 2] = [70.0, 315.0];
const PANEL: [f64; 4] = [560.0, 30.0, 330.0, 80.0];

/// Largest change of temperature, K.
const EXTREME: f64 = 150.0;

/// The picture of a run, with its temperature history, s and K.
pub fn svg(run: &ScissorsRun, history: &[[f64; 2]]) -> String {
    let times: Vec<f64> = (0..=FRAMES).map(|n| END * n as f64 / FRAMES as f64).collect();
    let point = |name: &str, t: f64| place(if name == "b1" { [0.0, 0.0] } else { run.position(name, t) });
    let mut svg = head();
    let colours: Vec<String> = times.iter().map(|t| colour(at(history, *t))).collect();
    svg += &format!(
        "<g fill=\"none\" stroke-width=\"5\" stroke-linecap=\"round\" stroke-linejoin=\"round\">{}",
        animate("stroke", &colours)
    );
    for k in 1..=3 {
        for (from, to) in [("a", "b"), ("b", "a")] {
            let names = [format!("{from}{k}"), format!("m{k}"), format!("{to}{}", k + 1)];
            let shape = |t: &f64| names.iter().map(|name| pair(point(name, *t))).collect::<Vec<_>>().join(" ");
            let shapes: Vec<String> = times.iter().map(shape).collect();
            svg += &format!("<polyline points=\"{}\">{}</polyline>", shapes[0], animate("points", &shapes));
        }
    }
    svg += "</g>\n<g class=\"pin\">";
    let pins = (1..=4).flat_map(|k| [format!("a{k}"), format!("b{k}")]).chain((1..=3).map(|k| format!("m{k}")));
    for name in pins {
        let places: Vec<[f64; 2]> = times.iter().map(|t| point(&name, *t)).collect();
        let [across, down] = [0, 1].map(|n| places.iter().map(|place| number(place[n])).collect::<Vec<_>>());
        svg += &format!(
            "<circle r=\"4\" cx=\"{}\" cy=\"{}\">{}{}</circle>",
            across[0],
            down[0],
            animate("cx", &across),
            animate("cy", &down)
        );
    }
    svg += "</g>\n";
    svg += &force(&times.iter().map(|t| point("a1", *t)).collect::<Vec<_>>());
    svg += &temperature(history, &times);
    svg + "</svg>\n"
}

/// Styles of this picture alone, also where a page has others: for light pages and dark ones.
const STYLE: &str = "#deployment text{font:15px system-ui,sans-serif;fill:#444}#deployment .line{stroke:#888;fill:none}\
#deployment .pin{fill:#fff;stroke:#444;stroke-width:1.5}#deployment .solid{fill:#444}@media(prefers-color-scheme:dark){\
#deployment text{fill:#ccc}#deployment .pin{fill:#222;stroke:#ccc}#deployment .solid{fill:#ccc}}";

/// Size, colours for light and dark pages, ground and support.
fn head() -> String {
    let [width, height] = SIZE;
    let [x, y] = ORIGIN;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" id=\"deployment\" role=\"img\" \
         aria-label=\"Three scissors of six rods deploy under heat and cold\">\n\
         <style>{STYLE}</style>\n\
         <path class=\"line\" d=\"M{x0} {top}V{bottom}M{x0} {bottom}H{right}\" stroke-dasharray=\"3 5\"/>\n\
         <path class=\"solid\" d=\"M{x} {y}l-10 17h20z\"/>\n\
         <text x=\"{x}\" y=\"{below}\">1 m</text><path class=\"line\" stroke-width=\"2\" d=\"M{x} {rule}h{METRE}\"/>\n",
        x0 = x,
        top = y - 2.2 * METRE,
        bottom = y + 17.0,
        right = width - 30.0,
        below = y + 62.0,
        rule = y + 38.0,
    )
}

/// The force on a1, an arrow that goes with it.
fn force(a1: &[[f64; 2]]) -> String {
    let shifts: Vec<String> = a1.iter().map(|[x, y]| format!("{} {}", number(*x), number(*y))).collect();
    let moves = animate("transform", &shifts).replace("<animate ", "<animateTransform type=\"translate\" ");
    format!(
        "<g transform=\"translate({})\">{moves}<path class=\"solid\" d=\"M0 -8l-6 -14h12z\"/>\
         <path d=\"M0 -20v-26\" class=\"line\" stroke-width=\"3\"/><text x=\"12\" y=\"-30\">50 N</text></g>\n",
        shifts[0]
    )
}

/// The temperature over time, with a dot that moves along it.
fn temperature(history: &[[f64; 2]], times: &[f64]) -> String {
    let [left, top, width, height] = PANEL;
    let across = |t: f64| number(left + width * t / END);
    let down = |change: f64| number(top + 0.5 * height * (1.0 - change / EXTREME));
    let corners: Vec<String> = history.iter().map(|[t, change]| format!("{},{}", across(*t), down(*change))).collect();
    let (xs, ys): (Vec<String>, Vec<String>) = times.iter().map(|t| (across(*t), down(at(history, *t)))).unzip();
    let colours: Vec<String> = times.iter().map(|t| colour(at(history, *t))).collect();
    format!(
        "<path class=\"line\" d=\"M{left} {middle}h{width}\" stroke-dasharray=\"2 4\"/><polyline class=\"line\" stroke-width=\"2\" \
         points=\"{}\"/>\n<text x=\"{left}\" y=\"{}\" text-anchor=\"end\" dx=\"-8\">+150 K</text>\
         <text x=\"{left}\" y=\"{}\" text-anchor=\"end\" dx=\"-8\">−150 K</text><text x=\"{}\" y=\"{}\" dx=\"6\">3 s</text>\n\
         <circle r=\"7\" cx=\"{}\" cy=\"{}\">{}{}{}</circle>\n",
        corners.join(" "),
        top + 5.0,
        top + height + 5.0,
        left + width,
        top + 0.5 * height + 5.0,
        xs[0],
        ys[0],
        animate("cx", &xs),
        animate("cy", &ys),
        animate("fill", &colours),
        middle = top + 0.5 * height,
    )
}

/// An attribute that takes the values one after the other, rests at the last, and begins again.
fn animate(attribute: &str, values: &[String]) -> String {
    let last = values.len().saturating_sub(1).max(1) as f64;
    let mut times = String::new();
    for n in 0..values.len() {
        // Writing into a string cannot fail.
        let _ = write!(times, "{:.4};", n as f64 / last * MOVES / TURN);
    }
    let rest = values.last().cloned().unwrap_or_default();
    format!(
        "<animate attributeName=\"{attribute}\" dur=\"{TURN}s\" repeatCount=\"indefinite\" keyTimes=\"{times}1\" values=\"{};{rest}\"/>",
        values.join(";")
    )
}

/// The value of a history at time `t`.
fn at(history: &[[f64; 2]], t: f64) -> f64 {
    let piece = history.windows(2).find(|pair| t <= pair[1][0]).or(history.windows(2).last());
    piece.map_or(0.0, |pair| {
        let ([from, a], [to, b]) = (pair[0], pair[1]);
        a + (b - a) * ((t - from) / (to - from)).clamp(0.0, 1.0)
    })
}

/// From blue over grey to vermillion, which the colour-blind can tell apart.
fn colour(change: f64) -> String {
    const COLD: [f64; 3] = [0.0, 114.0, 178.0];
    const NEUTRAL: [f64; 3] = [150.0, 150.0, 150.0];
    const HOT: [f64; 3] = [213.0, 94.0, 0.0];
    let extreme = if change < 0.0 { COLD } else { HOT };
    let part = (change.abs() / EXTREME).min(1.0);
    let mixed = [0, 1, 2].map(|n| (NEUTRAL[n] + part * (extreme[n] - NEUTRAL[n])).round() as u8);
    format!("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2])
}

fn place([x, y]: [f64; 2]) -> [f64; 2] {
    [ORIGIN[0] + METRE * x, ORIGIN[1] - METRE * y]
}

fn pair([x, y]: [f64; 2]) -> String {
    format!("{},{}", number(x), number(y))
}

fn number(value: f64) -> String {
    format!("{value:.1}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temperatures_have_their_colours() {
        assert_eq!([0.0, 150.0, -150.0, 400.0].map(colour), ["#969696", "#d55e00", "#0072b2", "#d55e00"]);
        let history = [[0.0, 0.0], [0.5, 100.0], [1.0, 100.0]];
        assert_eq!([0.25, 0.75, 2.0].map(|t| at(&history, t)), [50.0, 100.0, 100.0]);
    }

    #[test]
    fn an_attribute_has_as_many_times_as_values() {
        let text = animate("x", &["1".into(), "2".into(), "3".into()]);
        assert!(text.contains("values=\"1;2;3;3\"") && text.contains("keyTimes=\"0.0000;0.4286;0.8571;1\""), "{text}");
    }
}
