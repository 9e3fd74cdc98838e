//! Words of the report: numbers and lists that stay short.

/// Largest number of names that a line lists.
const MOST_NAMES: usize = 6;

/// A number with six digits.
pub fn short(number: f64) -> String {
    let size = number.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{number:.5e}");
    }
    let text = format!("{number:.6}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}

/// A number with all its digits.
pub fn exact(number: f64) -> String {
    if number == 0.0 || (1e-3..1e6).contains(&number.abs()) { number.to_string() } else { format!("{number:e}") }
}

/// Names in a list; the rest as a number.
pub fn listed(names: &[String]) -> String {
    match names.get(..MOST_NAMES) {
        Some(shown) if names.len() > MOST_NAMES + 1 => {
            format!("{} and {} more", shown.join(", "), names.len() - MOST_NAMES)
        }
        _ => names.join(", "),
    }
}

/// A sentence from its beginning in lower case.
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    #[test]
    fn numbers_and_lists_are_short() {
        assert_eq!([0.5, 2.0, -1.0 / 3.0, 0.0].map(super::short), ["0.5", "2", "-0.333333", "0"]);
        assert_eq!(super::short(1.5e-7), "1.50000e-7");
        assert_eq!([-0.0, 2.0, -1.0 / 3.0, 1e7].map(super::exact), ["-0", "2", "-0.3333333333333333", "1e7"]);
        let names: Vec<String> = (0..9).map(|n| n.to_string()).collect();
        assert_eq!(super::listed(&names), "0, 1, 2, 3, 4, 5 and 3 more");
        assert_eq!(super::listed(&names[..7]), "0, 1, 2, 3, 4, 5, 6");
    }
}
