//! Picture of a shape: the structure in grey, its deflection either way in colour.

/// Size of the longer side, pixels.
const SIZE: f64 = 300.0;

/// Largest displacement, as a part of the structure's size.
const DEFLECTION: f64 = 0.12;

/// Least height of a picture, pixels.
const LEAST: f64 = 60.0;

/// SVG of the rods' axes and of a shape whose largest displacement is 1; `title` is for those who hear the page.
pub fn svg(axes: &[Vec<[f64; 2]>], shape: &[Vec<[f64; 2]>], title: &str) -> String {
    let all = || axes.iter().flatten();
    let least = [0, 1].map(|c| all().map(|point| point[c]).fold(f64::INFINITY, f64::min));
    let most = [0, 1].map(|c| all().map(|point| point[c]).fold(f64::NEG_INFINITY, f64::max));
    let size = f64::max(most[0] - least[0], most[1] - least[1]);
    let margin = 1.3 * DEFLECTION * size;
    let scale = SIZE / (size + 2.0 * margin);
    let width = scale * (most[0] - least[0] + 2.0 * margin);
    let height = (scale * (most[1] - least[1] + 2.0 * margin)).max(LEAST);
    let line = |factor: f64, class: &str| {
        let rods = axes.iter().zip(shape).map(|(axis, moved)| {
            let point = |(point, moved): (&[f64; 2], &[f64; 2])| {
                let at = [0, 1].map(|c| point[c] + factor * DEFLECTION * size * moved[c] - least[c] + margin);
                format!("{:.1},{:.1}", scale * at[0], height - scale * at[1])
            };
            let points: Vec<String> = axis.iter().zip(moved).map(point).collect();
            format!("<polyline class=\"{class}\" points=\"{}\"/>", points.join(" "))
        });
        rods.collect::<String>()
    };
    format!(
        "<svg viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" aria-label=\"{title}\">{}{}{}</svg>",
        line(0.0, "rest"),
        line(-1.0, "back"),
        line(1.0, "moved")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rod along x that moves across: grey in the middle, coloured as far above it as below.
    #[test]
    fn a_shape_is_drawn_either_way() {
        let axis = vec![vec![[0.0, 0.0], [1.0, 0.0]]];
        let text = svg(&axis, &[vec![[0.0, 0.0], [0.0, 1.0]]], "mode 1");
        let heights: Vec<f64> = text
            .split("points=\"")
            .skip(1)
            .map(|rest| {
                let last = rest.split('"').next().and_then(|points| points.split(' ').next_back());
                last.and_then(|point| point.split(',').nth(1)).and_then(|y| y.parse().ok()).unwrap()
            })
            .collect();
        assert_eq!(heights.len(), 3);
        assert!(
            (heights[0] - heights[2] - 27.4).abs() < 0.2 && (heights[1] - heights[0] - 27.4).abs() < 0.2,
            "{heights:?}"
        );
        assert!(!text.contains("NaN"));
    }
}
