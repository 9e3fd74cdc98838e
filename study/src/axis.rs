//! Logarithmic axes: their range, their ticks and the labels of these.

use std::ops::Range;

/// Labels that fit side by side.
const MOST_TICKS: i32 = 6;

/// Whole decades around the positive finite values, at least one; 0.1 … 10 if there are none.
pub fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let powers = values.filter(|value| *value > 0.0 && value.is_finite()).map(f64::log10);
    let (low, high) = powers.fold((f64::MAX, f64::MIN), |(low, high), power| (low.min(power), high.max(power)));
    let (low, high) = if low > high { (-1, 1) } else { (low.floor() as i32, high.ceil() as i32) };
    power(low)..power(high.max(low + 1))
}

/// 10ⁿ, the nearest f64.
fn power(n: i32) -> f64 {
    format!("1e{n}").parse().unwrap_or(f64::NAN)
}

/// Powers of ten in a range, so few of them that labels do not overlap.
pub fn ticks(range: &Range<f64>) -> Vec<f64> {
    let (low, high) = (range.start.log10().round() as i32, range.end.log10().round() as i32);
    let every = (high - low).div_euclid(MOST_TICKS) + 1;
    (low..=high).filter(|n| n.rem_euclid(every) == 0).map(power).collect()
}

/// The label of a power of ten.
pub fn power_label(value: &f64) -> String {
    let digit = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(digit),
    };
    let exponent: String = format!("{:.0}", value.log10()).chars().map(digit).collect();
    format!("10{exponent}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_the_values() {
        assert_eq!(decades([3e-5, 200.0, 0.0, f64::NAN, f64::INFINITY].into_iter()), 1e-5..1e3);
        assert_eq!(decades([1.0].into_iter()), 1.0..10.0);
        assert_eq!(decades(std::iter::empty()), 0.1..10.0);
    }

    #[test]
    fn ticks_are_few_and_labels_are_powers() {
        assert_eq!(ticks(&(1e-5..1e3)), [1e-4, 1e-2, 1.0, 1e2]);
        assert_eq!([1e-12, 1.0, 1e3].map(|tick| power_label(&tick)), ["10⁻¹²", "10⁰", "10³"]);
    }
}
