//! Text from files and programs in media that would take parts of it for commands, a function for each medium. (Markdown is written by
//! `ancf-conform` alone, which has the one for it.)

/// Text with HTML's special characters as entities, and control characters, which it has no place for, as their codes.
pub fn html(text: &str) -> String {
    // `&` first, as the other entities begin with it.
    let entities = [('&', "&amp;"), ('<', "&lt;"), ('>', "&gt;"), ('"', "&quot;"), ('\'', "&#39;")];
    entities.iter().fold(terminal(text), |text, (character, entity)| text.replace(*character, entity))
}

/// Text for a terminal, in lines: control characters, which move the cursor or change colours, and those that turn the direction of
/// writing are shown as their codes. Line ends and tabs stay.
pub fn terminal(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut shown, c| {
        match c {
            '\n' | '\t' => shown.push(c),
            _ if is_command(c) => shown.extend(c.escape_default()),
            _ => shown.push(c),
        }
        shown
    })
}

/// Text for one line of a terminal: [`terminal`] with line ends and tabs as their codes.
pub fn line(text: &str) -> String {
    terminal(text).replace('\n', "\\n").replace('\t', "\\t")
}

/// Text for a cell of CSV: [`terminal`], and behind an apostrophe if a spreadsheet would take it for a formula. Quotes are the writer's.
pub fn csv_cell(text: &str) -> String {
    let shown = terminal(text);
    if shown.starts_with(['=', '+', '-', '@', '\t', '\n']) { format!("'{shown}") } else { shown }
}

/// Whether a terminal obeys a character rather than showing it.
fn is_command(c: char) -> bool {
    c.is_control() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_characters_are_escaped() {
        assert_eq!(html("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
        assert_eq!(html("\u{1b}[2J"), "\\u{1b}[2J");
    }

    #[test]
    fn a_terminal_gets_no_commands() {
        assert_eq!(
            terminal("µ \u{1b}[2J\u{9b}1m\u{7}\r\u{202e}b\n\tc"),
            "µ \\u{1b}[2J\\u{9b}1m\\u{7}\\r\\u{202e}b\n\tc"
        );
        assert_eq!(line("a\nb\tc"), "a\\nb\\tc");
    }

    #[test]
    fn a_spreadsheet_gets_no_formula() {
        for formula in ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\n=1"] {
            assert_eq!(csv_cell(formula), format!("'{formula}"));
        }
        assert_eq!(csv_cell("\r=1"), "\\r=1");
        assert_eq!(csv_cell("a = b"), "a = b");
    }
}
