//! Quotation of what a program wrote, for messages.

/// Longest quotation of a line, in characters.
pub const LONGEST: usize = 80;

/// Returns the beginning of a line, without control characters.
pub fn quoted(line: &str) -> String {
    let line: String = line.trim().chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    match line.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("{}…", line.get(..cut).unwrap_or_default()),
        None => line,
    }
}
