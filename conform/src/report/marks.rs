//! Marks of emphasis and code: those of Markdown, or none.

/// How a text is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marks {
    /// Markdown, which neither a terminal nor a browser may obey where a program under test wrote it.
    Markdown,
    /// No marks; whoever prints the text makes control characters visible.
    None,
}

impl Marks {
    /// Text that matters.
    pub fn strong(self, text: &str) -> String {
        self.between("**", text)
    }

    /// A name or a line of a program.
    pub fn code(self, text: &str) -> String {
        match self {
            Marks::Markdown => format!("`{}`", cell(text)),
            Marks::None => text.into(),
        }
    }

    /// Text of a program or a file.
    pub fn plain(self, text: &str) -> String {
        match self {
            Marks::Markdown => plain(text),
            Marks::None => text.into(),
        }
    }

    fn between(self, mark: &str, text: &str) -> String {
        match self {
            Marks::Markdown => format!("{mark}{text}{mark}"),
            Marks::None => text.into(),
        }
    }
}

/// Text that stays within a cell of a table, or within a span of code there. Neither a terminal nor a browser obeys it.
pub fn cell(text: &str) -> String {
    let is_command = |c: char| {
        c.is_control() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    text.replace('|', "\\|").replace('`', "'").replace(is_command, " ")
}

/// Text outside of a span of code, where HTML and links have a meaning, too.
pub fn plain(text: &str) -> String {
    cell(text).replace('&', "&amp;").replace('<', "&lt;").replace('[', "\\[")
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_name_stays_in_its_cell_and_line() {
        assert_eq!(super::cell("a|b\n# `c`"), "a\\|b # 'c'");
        assert_eq!(super::plain("\u{1b}[2J<img src=x>\u{202e}&"), " \\[2J&lt;img src=x> &amp;");
    }
}
