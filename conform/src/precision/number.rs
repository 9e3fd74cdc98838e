//! Digits of one number.

/// Number of significant digits and of decimals in the shortest decimal form of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digits {
    /// Significant digits, without zeros at the end.
    pub significant: i32,
    /// Digits after the point.
    pub decimals: i32,
}

/// Digits of a number. Zero has none.
pub fn digits(number: f64) -> Digits {
    if number == 0.0 {
        return Digits { significant: 0, decimals: 0 };
    }
    let text = format!("{number:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let significant = mantissa.chars().filter(char::is_ascii_digit).count() as i32;
    let exponent: i32 = exponent.parse().unwrap_or_default();
    Digits { significant, decimals: (significant - 1 - exponent).max(0) }
}

/// Unit of the last of `significant` digits.
pub fn last_digit(number: f64, significant: i32) -> f64 {
    if number == 0.0 { 0.0 } else { 10f64.powi(number.abs().log10().floor() as i32 - significant + 1) }
}

/// Distance of the numbers of single precision around a number.
pub fn single_spacing(number: f64) -> f64 {
    let exponent = number.abs().log2().floor().max(f64::from(f32::MIN_EXP - 1));
    2f64.powi(exponent as i32 + 1 - f32::MANTISSA_DIGITS as i32)
}

/// Whether a number is one of single precision, printed to the nearest multiple of `unit` or with as few digits as tell it apart.
pub fn is_single(number: f64, unit: f64) -> bool {
    let single = number as f32;
    let away = (number - f64::from(single)).abs();
    away <= 0.501 * unit + 4.0 * f64::EPSILON * number.abs()
        || single.to_string().parse::<f64>().is_ok_and(|shortest| shortest == number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_of_printed_numbers() {
        for (number, significant, decimals) in [
            (0.0, 0, 0),
            (1.0, 1, 0),
            (0.25, 2, 2),
            (-123.456, 6, 3),
            (1e21, 1, 0),
            (1.25e-7, 3, 9),
            (0.1 + 0.2, 17, 17),
        ] {
            assert_eq!(digits(number), Digits { significant, decimals }, "{number}");
        }
    }

    #[test]
    fn units_of_last_digits() {
        assert_eq!(last_digit(123.456, 6), 1e-3);
        assert_eq!(last_digit(-0.02, 3), 1e-4);
        assert_eq!(single_spacing(1.0), f64::from(f32::EPSILON));
        assert_eq!(single_spacing(3.0), 2.0 * f64::from(f32::EPSILON));
    }

    #[test]
    fn numbers_of_single_precision_in_three_forms() {
        let number = 0.1f32;
        assert!(is_single(f64::from(number), 0.0));
        assert!(is_single(0.1, 0.0)); // its shortest decimal
        assert!(is_single(0.100000001, 1e-9)); // its nine digits
        assert!(!is_single(0.1000000012, 0.0));
    }
}
