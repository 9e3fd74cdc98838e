//! Form of numbers: of single precision, or printed with few digits.

use super::answered::is_telling;
use super::number::{Digits, digits, is_single, last_digit, single_spacing};

/// Least number of telling numbers that show a form.
const LEAST_NUMBERS: usize = 12;
/// Numbers of digits that count as few. More are no loss, fewer no numbers.
const FEW: std::ops::RangeInclusive<i32> = 4..=14;
/// Numbers of decimals that count as few.
const FEW_DECIMALS: std::ops::RangeInclusive<i32> = 2..=12;
/// Least share of numbers that use all digits of the form: nine of ten do, as the last digit is not 0.
const USING_ALL: f64 = 0.5;
/// Digits that a double keeps in any case.
const DOUBLE_DIGITS: i32 = 15;
/// Digits that tell numbers of single precision apart.
const SINGLE_DIGITS: i32 = 9;
/// Least number of digits of a number that shows whether it is one of single precision.
const SHOWING_SINGLE: i32 = 8;

/// Form of the numbers of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Form {
    /// Whether they are of single precision.
    pub single: bool,
    /// How they are printed.
    pub printing: Printing,
}

/// How numbers are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Printing {
    /// With all their digits.
    #[default]
    Full,
    /// With so many significant digits, as `%.6g` does.
    Significant(i32),
    /// With so many decimals, as `%.6f` does.
    Decimals(i32),
}

impl Printing {
    /// Unit of the last digit of a number; zero if it has all digits.
    pub fn unit(self, number: f64) -> f64 {
        match self {
            Printing::Full => 0.0,
            Printing::Significant(significant) => last_digit(number, significant),
            Printing::Decimals(decimals) => 10f64.powi(-decimals),
        }
    }

    fn of(numbers: &[(f64, Digits)], telling: &[(f64, Digits)]) -> Printing {
        let significant = numbers.iter().map(|(_, digits)| digits.significant).max().unwrap_or(0);
        let decimals = numbers.iter().map(|(_, digits)| digits.decimals).max().unwrap_or(0);
        let share = |uses_all: &dyn Fn(&Digits) -> bool, can: &dyn Fn(f64) -> bool| {
            let able: Vec<&Digits> =
                telling.iter().filter(|(number, _)| can(*number)).map(|(_, digits)| digits).collect();
            let using = able.iter().filter(|digits| uses_all(digits)).count();
            if able.len() < LEAST_NUMBERS { 0.0 } else { using as f64 / able.len() as f64 }
        };
        let of_significant = match FEW.contains(&significant) {
            true => share(&|digits| digits.significant == significant, &|_| true),
            false => 0.0,
        };
        // Large numbers have no room for all decimals.
        let has_room = |number: f64| number.abs() < 10f64.powi(DOUBLE_DIGITS - decimals);
        let of_decimals = match FEW_DECIMALS.contains(&decimals) {
            true => share(&|digits| digits.decimals == decimals, &has_room),
            false => 0.0,
        };
        if of_significant.max(of_decimals) < USING_ALL {
            Printing::Full
        } else if of_decimals > of_significant {
            Printing::Decimals(decimals)
        } else {
            Printing::Significant(significant)
        }
    }
}

impl Form {
    /// Form of answered numbers, each with its reference value; `None` if too few tell.
    pub fn of(entries: impl Iterator<Item = (f64, f64)>) -> Option<Form> {
        let (mut numbers, mut telling) = (Vec::new(), Vec::new());
        for (answer, right) in entries {
            let number = (answer, digits(answer));
            numbers.push(number);
            if answer != 0.0 && is_telling(right) {
                telling.push(number);
            }
        }
        if telling.len() < LEAST_NUMBERS {
            return None;
        }
        let single = |printing: Printing| {
            // Numbers whose digits are finer than the spacing in single precision.
            let shows = |(number, digits): &&(f64, Digits)| {
                digits.significant >= SHOWING_SINGLE && 3.0 * printing.unit(*number) < single_spacing(*number)
            };
            let showing: Vec<f64> = telling.iter().filter(shows).map(|(number, _)| *number).collect();
            showing.len() >= LEAST_NUMBERS && showing.iter().all(|number| is_single(*number, printing.unit(*number)))
        };
        // With as few digits as tell them apart, numbers of single precision have nine at most.
        if single(Printing::Full) {
            return Some(Form { single: true, printing: Printing::Full });
        }
        let printing = Printing::of(&numbers, &telling);
        let single = single(printing);
        let printing = match printing {
            Printing::Significant(SINGLE_DIGITS..) if single => Printing::Full,
            printing => printing,
        };
        Some(Form { single, printing })
    }

    /// Whether the numbers have less than double precision.
    pub fn is_reduced(self) -> bool {
        self != Form::default()
    }

    /// The form in words.
    pub fn words(self) -> String {
        const NUMBERS: [&str; 13] =
            ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
        let number = |n: i32| {
            let word = usize::try_from(n).ok().and_then(|n| NUMBERS.get(n));
            word.map_or_else(|| n.to_string(), ToString::to_string)
        };
        let printed = match self.printing {
            Printing::Full => None,
            Printing::Significant(n) => Some(format!("{} significant digits printed", number(n))),
            Printing::Decimals(n) => Some(format!("{} decimals printed", number(n))),
        };
        match (self.single, printed) {
            (false, None) => "double precision".into(),
            (false, Some(printed)) => printed,
            (true, None) => "single precision".into(),
            (true, Some(printed)) => format!("single precision, {printed}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of many sizes, as a program answers them.
    fn numbers(answer: impl Fn(f64) -> f64) -> Option<Form> {
        Form::of((1..100).map(|n| {
            let right = f64::from(n).sqrt().sin() * 10f64.powi(n % 9 - 5);
            (answer(right), right)
        }))
    }

    fn printed(text: &str) -> f64 {
        text.parse().unwrap()
    }

    #[test]
    fn forms_of_right_and_wrong_numbers() {
        // A mistake does not change the form.
        for factor in [1.0, -2.7] {
            let form = |answer: &dyn Fn(f64) -> f64| numbers(|right| answer(factor * right)).unwrap().words();
            assert_eq!(form(&|x| x), "double precision");
            assert_eq!(form(&|x| f64::from(x as f32)), "single precision");
            assert_eq!(form(&|x| printed(&(x as f32).to_string())), "single precision");
            assert_eq!(form(&|x| printed(&format!("{:.8e}", x as f32))), "single precision");
            assert_eq!(form(&|x| printed(&format!("{:.11e}", f64::from(x as f32)))), "single precision");
            assert_eq!(form(&|x| printed(&format!("{x:.8e}"))), "nine significant digits printed");
            assert_eq!(form(&|x| printed(&format!("{x:.5e}"))), "six significant digits printed");
            assert_eq!(form(&|x| printed(&format!("{x:.6}"))), "six decimals printed");
            assert_eq!(form(&|x| printed(&format!("{x:.14e}"))), "double precision");
        }
    }

    #[test]
    fn numbers_that_are_short_in_any_form_show_nothing() {
        assert_eq!(Form::of((0..100).map(|n| (f64::from(n), f64::from(n)))), None);
        assert_eq!(numbers(|_| 0.0), None);
        assert_eq!(numbers(|_| 1.0).unwrap().words(), "double precision");
    }
}
