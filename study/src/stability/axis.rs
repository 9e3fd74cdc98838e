//! The axes of the pictures: powers of ten, or degrees.

use std::ops::Range;

use super::case::Case;

/// What is less than this is drawn there: there is no zero on a logarithmic axis.
const LEAST: f64 = 1e-18;

/// Labels that fit beside one another.
const MOST_TICKS: i32 = 6;

/// An axis.
pub struct Axis {
    /// What is on it.
    pub title: String,
    /// From where to where, in its own numbers: exponents of ten, or degrees.
    pub range: Range<f64>,
    /// Where labels stand.
    pub ticks: Vec<f64>,
    kind: Kind,
}

/// What is drawn of a value.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// The logarithm of its size.
    Size,
    /// That of its distance from ½, in front of which Poisson's ratios crowd.
    FromHalf,
    /// Itself.
    Plain,
}

impl Axis {
    /// That of a case's parameter.
    pub fn of_parameter(case: &Case, values: impl Iterator<Item = f64> + Clone) -> Axis {
        if case.parameter.ends_with('°') {
            let ticks: Vec<f64> = (0..=6).map(|n| 15.0 * f64::from(n)).collect();
            return Axis { title: case.parameter.into(), range: 0.0..90.0, ticks, kind: Kind::Plain };
        }
        if case.parameter == "ν" {
            return Axis::powers("½ − ν".into(), values, Kind::FromHalf);
        }
        let title = if values.clone().any(|value| value < 0.0) {
            format!("|{}|", case.parameter)
        } else {
            case.parameter.into()
        };
        Axis::powers(title, values, Kind::Size)
    }

    /// That of errors and bounds.
    pub fn of_errors(title: String, values: impl Iterator<Item = f64>) -> Axis {
        // The larger of a NaN and something is something.
        let drawn = values.filter(|value| !value.is_nan()).map(|value| value.max(LEAST));
        Axis::powers(title, drawn, Kind::Size)
    }

    /// Whole decades around what can be drawn.
    fn powers(title: String, values: impl Iterator<Item = f64>, kind: Kind) -> Axis {
        let (low, high) = values
            .filter_map(|value| kind.number(value))
            .fold((f64::MAX, f64::MIN), |(low, high), number| (low.min(number), high.max(number)));
        let (low, high) = if low > high { (-1, 1) } else { (low.floor() as i32, high.ceil() as i32) };
        let high = high.max(low + 1);
        let every = (high - low).div_euclid(MOST_TICKS) + 1;
        let ticks = (low..=high).filter(|power| power.rem_euclid(every) == 0).map(f64::from).collect();
        Axis { title, range: f64::from(low)..f64::from(high), ticks, kind }
    }

    /// Where a value is drawn; `None` where it cannot be.
    pub fn place(&self, value: f64) -> Option<f64> {
        let value = if value == 0.0 { LEAST } else { value };
        self.kind.number(value).map(|number| number.clamp(self.range.start, self.range.end))
    }

    /// The label of a tick.
    pub fn label(&self, tick: f64) -> String {
        if self.kind == Kind::Plain {
            return format!("{tick}");
        }
        let digits = |digit: char| match digit {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => digit.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(digit),
        };
        let exponent: String = format!("{tick:.0}").chars().map(digits).collect();
        format!("10{exponent}")
    }
}

impl Kind {
    fn number(self, value: f64) -> Option<f64> {
        let number = match self {
            Kind::Size => value.abs().log10(),
            Kind::FromHalf => (0.5 - value).log10(),
            Kind::Plain => value,
        };
        number.is_finite().then_some(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_what_can_be_drawn() {
        let axis = Axis::of_errors(String::new(), [3e-5, 200.0, f64::NAN, f64::INFINITY].into_iter());
        assert_eq!((axis.range.clone(), axis.place(1e-9)), (-5.0..3.0, Some(-5.0)));
        assert_eq!(axis.place(f64::NAN), None);
        assert_eq!(axis.ticks, [-4.0, -2.0, 0.0, 2.0]);
        assert_eq!([-12.0, 0.0, 3.0].map(|tick| axis.label(tick)), ["10⁻¹²", "10⁰", "10³"]);
        assert_eq!(Axis::of_errors(String::new(), [0.0].into_iter()).range, -18.0..-17.0);
        assert_eq!(Axis::powers(String::new(), std::iter::empty(), Kind::Size).range, -1.0..1.0);
    }

    #[test]
    fn ratios_are_seen_in_front_of_a_half() {
        let axis = Axis::powers(String::new(), [0.0, 0.4999999, 0.5, f64::NAN].into_iter(), Kind::FromHalf);
        assert_eq!((axis.range.clone(), axis.place(0.5)), (-7.0..0.0, None));
    }
}
