//! Factors as products of a simple fraction and powers of l, h, w, ρ and E.

use super::mistake::MistakeKind::{self, Factor, Missing, Sign};
use crate::suite::Case;

/// Quantities in a factor, each with the largest exponent that is tried.
const NAMES: [(&str, i32); 5] = [("l", 3), ("h", 2), ("w", 1), ("ρ", 1), ("E", 1)];
/// Values of [`NAMES`] in one case; 1 for a quantity that the case lacks.
pub(super) type Numbers = [f64; 5];

/// Values of [`NAMES`] in a case.
pub(super) fn numbers_of(case: &Case) -> Numbers {
    ["l", "h", "w", "rho", "E"].map(|key| case.state_json[key].as_f64().unwrap_or(1.0))
}

/// Largest denominator and numerator of a simple fraction.
const SIMPLE: i32 = 16;

/// Factor of a term in one case.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The factor.
    pub factor: f64,
    /// Uncertainty of the factor.
    pub within: f64,
    /// Values of which the factor may be composed.
    pub of: Numbers,
}

impl Sample {
    fn is(&self, factor: f64) -> bool {
        (self.factor - factor).abs() <= self.within + 1e-10 * factor.abs()
    }
}

/// A number times powers of [`NAMES`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PowerLaw {
    number: f64,
    exponents: [i32; 5],
}

impl PowerLaw {
    /// Simplest law that gives all factors.
    pub(super) fn of(samples: &[Sample]) -> Option<PowerLaw> {
        let best = samples.iter().min_by(|a, b| a.within.total_cmp(&b.within))?;
        let mut all = exponents();
        all.sort_by_key(|exponents| exponents.iter().map(|n| n.abs()).sum::<i32>());
        all.into_iter().find_map(|exponents| {
            let raw = best.factor / product(&best.of, &exponents);
            let fraction = fraction(raw, best.within / raw.abs() + 1e-10);
            let constant = exponents == [0; 5];
            // A number that is not a simple fraction is evidence only without powers; zero needs no powers.
            let number = fraction.map_or(raw, |(p, q)| f64::from(p) / f64::from(q));
            if (fraction.is_none() || number == 0.0) && !constant {
                return None;
            }
            let law = PowerLaw { number, exponents };
            samples.iter().all(|sample| sample.is(law.value(&sample.of))).then_some(law)
        })
    }

    /// Law of a constant factor.
    pub(super) fn constant(number: f64) -> PowerLaw {
        PowerLaw { number, exponents: [0; 5] }
    }

    /// Law of a factor that is a power of one of the [`NAMES`], by its place there.
    pub(super) fn power(place: usize, exponent: i32) -> PowerLaw {
        PowerLaw { number: 1.0, exponents: std::array::from_fn(|n| if n == place { exponent } else { 0 }) }
    }

    /// The factor in a case.
    pub(super) fn value(&self, of: &Numbers) -> f64 {
        self.number * product(of, &self.exponents)
    }

    /// Whether the factor is constant.
    pub(super) fn is_constant(&self) -> bool {
        self.exponents == [0; 5]
    }

    /// Kind of the mistake, and the factor in words that follow the name of a term.
    pub(super) fn words(&self) -> (MistakeKind, String) {
        if !self.is_constant() {
            return self.power_words();
        }
        let size = match self.number.abs() {
            0.0 => return (Missing, "missing".into()),
            0.25 => "a quarter".into(),
            0.5 => "half".into(),
            1.0 => String::new(),
            2.0 => "twice".into(),
            4.0 => "four times".into(),
            _ => format!("times {}", number_words(self.number.abs())),
        };
        match (self.number < 0.0, size.as_str()) {
            (true, "") => (Sign, "with the wrong sign".into()),
            (true, size) => (Sign, format!("with the wrong sign and {size}")),
            (false, size) => (Factor, size.into()),
        }
    }

    fn power_words(&self) -> (MistakeKind, String) {
        let of_sign = |sign: i32| -> Vec<String> {
            let power = |((name, _), n): (&(&str, i32), &i32)| match n.abs() {
                1 => name.to_string(),
                2 => format!("{name}²"),
                _ => format!("{name}³"),
            };
            NAMES.iter().zip(&self.exponents).filter(|(_, n)| n.signum() == sign).map(power).collect()
        };
        let (above, below) = (of_sign(1), of_sign(-1));
        match (&above[..], &below[..], self.number) {
            ([], [one], 1.0) => return (Missing, format!("without the factor {one}")),
            ([one], [], 1.0) => return (Factor, format!("times {one}: one factor too many, or a missing division")),
            _ => {}
        }
        let number = number_words(self.number);
        let above = if self.number == 1.0 && !above.is_empty() {
            above.join(" ")
        } else {
            [vec![number], above].concat().join(" ")
        };
        let words = match &below[..] {
            [] => format!("times {above}"),
            [one] => format!("times {above}/{one}"),
            many => format!("times {above}/({})", many.join(" ")),
        };
        (if self.exponents.iter().all(|n| *n <= 0) { Missing } else { Factor }, words)
    }
}

/// All combinations of exponents.
fn exponents() -> Vec<[i32; 5]> {
    let mut all = vec![[0; 5]];
    for (place, (_, most)) in NAMES.iter().enumerate() {
        all = all
            .iter()
            .flat_map(|exponents| {
                (-most..=*most).map(|n| {
                    let mut changed = *exponents;
                    changed[place] = n;
                    changed
                })
            })
            .collect();
    }
    all
}

fn product(of: &Numbers, exponents: &[i32; 5]) -> f64 {
    of.iter().zip(exponents).map(|(value, n)| value.powi(*n)).product()
}

/// Simple fraction with the smallest denominator that equals a number; `None` if there is none.
pub(super) fn fraction(number: f64, within: f64) -> Option<(i32, i32)> {
    (1..=SIMPLE).find_map(|q| {
        let p = (number * f64::from(q)).round();
        let near = (number - p / f64::from(q)).abs() <= within * number.abs().max(1.0);
        (p.abs() <= f64::from(SIMPLE) && near).then_some((p as i32, q))
    })
}

fn number_words(number: f64) -> String {
    match fraction(number, 1e-12) {
        Some((p, 1)) => p.to_string(),
        Some((p, q)) => format!("{p}/{q}"),
        None => format!("{number:.6}"),
    }
}
