//! HTML pages. All text is escaped.

use crate::escape::html as escape;
use crate::paper::standing::Standing;
use crate::paper::statement::Statement;
use crate::table::Table;

/// A page under construction.
#[derive(Debug, Default)]
pub struct Html(String);

impl Html {
    fn element(&mut self, tag: &str, text: &str) {
        self.0 += &format!("<{tag}>{}</{tag}>\n", prose(text));
    }

    /// Adds a heading of the second level.
    pub fn heading(&mut self, text: &str) {
        self.element("h2", text);
    }

    /// Adds a heading of the second level with an anchor.
    pub fn section(&mut self, id: &str, text: &str) {
        self.0 += &format!("<h2 id=\"{id}\">{}</h2>\n", escape(text));
    }

    /// Adds a heading of the third level.
    pub fn subheading(&mut self, text: &str) {
        self.element("h3", text);
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.element("p", text);
    }

    /// Adds a list.
    pub fn list(&mut self, items: &[String]) {
        self.0 += "<ul>\n";
        items.iter().for_each(|item| self.element("li", item));
        self.0 += "</ul>\n";
    }

    /// Adds a line for each statement: its verdict, and a link to its numbers.
    pub fn verdicts<'a>(&mut self, statements: impl Iterator<Item = (String, &'a Statement)>) {
        self.0 += "<div class=\"wide\"><table><tbody>\n";
        for (id, Statement { brief, standing, .. }) in statements {
            let verdict = format!("<td class=\"{}\">{standing}</td>", class(*standing));
            self.0 += &format!("<tr>{verdict}<td><a href=\"#{id}\">{}</a></td></tr>\n", escape(brief));
        }
        self.0 += "</tbody></table></div>\n";
    }

    /// Adds a statement of the paper with its verdict, what was measured, and the numbers.
    pub fn statement(&mut self, id: &str, statement: &Statement) {
        let Statement { text, measure, numbers, verdict, standing, .. } = statement;
        let verdict = verdict.lines().map(prose).collect::<Vec<_>>().join("<br>");
        self.0 += &format!("<section id=\"{id}\" class=\"statement\"><h4>{}</h4>\n", prose(text));
        self.element("p", &format!("Measured: {measure}."));
        numbers.iter().for_each(|table| self.table(table));
        self.0 += &format!("<p><b class=\"{}\">{standing}</b><br>{verdict}</p></section>\n", class(*standing));
    }

    /// Adds a table.
    pub fn table(&mut self, table: &Table) {
        self.0 += &table.html();
    }

    /// Adds a picture that this program has drawn, unescaped.
    pub fn svg(&mut self, svg: &str) {
        self.0 += &format!("<figure>{svg}</figure>\n");
    }

    /// Adds a picture with a caption.
    pub fn figure(&mut self, svg: &str, caption: &str) {
        self.0 += &format!("<figure>{svg}<figcaption>{}</figcaption></figure>\n", prose(caption));
    }

    /// The whole page.
    pub fn page(self, title: &str) -> String {
        let (title, body) = (escape(title), self.0);
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
             <style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{body}</body>\n</html>\n"
        )
    }
}

/// Escaped text; what stands between backticks is code.
fn prose(text: &str) -> String {
    let mut parts = escape(text).split('`').map(String::from).collect::<Vec<_>>();
    // An odd one is a backtick.
    if parts.len() % 2 == 0 {
        let last = parts.pop().unwrap_or_default();
        parts.last_mut().into_iter().for_each(|part| *part += &format!("`{last}"));
    }
    let mark = |(n, part): (usize, String)| if n % 2 == 1 { format!("<code>{part}</code>") } else { part };
    parts.into_iter().enumerate().map(mark).collect()
}

/// Colours are not the only sign: each verdict is written, too.
fn class(standing: Standing) -> &'static str {
    match standing {
        Standing::Holds => "holds",
        Standing::InPart => "in-part",
        Standing::DoesNot => "does-not",
        Standing::Undecided => "undecided",
    }
}

const STYLE: &str = "\
:root{color-scheme:light dark;--ink:#222;--paper:#fff;--line:#ddd;--faint:#666;--holds:#00664b;--part:#8a5a00;--not:#a33c00;--open:#555}\
@media(prefers-color-scheme:dark){:root{--ink:#ddd;--paper:#16181c;--line:#3a3d44;--faint:#999;--holds:#4cc9a4;--part:#e6b04f;--not:#ff9a66;--open:#aaa}}\
body{font:16px/1.5 system-ui,sans-serif;max-width:64rem;margin:2rem auto;padding:0 1rem;color:var(--ink);background:var(--paper)}\
a{color:inherit}table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}\
th,td{padding:.2rem .7rem;text-align:left;border-bottom:1px solid var(--line);vertical-align:top}\
th{border-bottom:2px solid var(--faint)}figure{margin:1rem 0;background:#fff;color:#222;padding:.5rem}\
figcaption{font-size:.85rem;color:#555}svg{max-width:100%;height:auto}.wide{overflow-x:auto}\
table+table{margin-top:.6rem}.wide{margin:.6rem 0}.statement{border-left:3px solid var(--line);padding-left:1rem;margin:1.5rem 0}h4{margin:.2rem 0;font-weight:600}\
.holds{color:var(--holds)}.in-part{color:var(--part)}.does-not{color:var(--not)}.undecided{color:var(--open)}";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::cells;

    #[test]
    fn code_is_marked() {
        assert_eq!(prose("run `a<b` or ` alone"), "run <code>a&lt;b</code> or ` alone");
        assert_eq!(prose("plain"), "plain");
    }

    #[test]
    fn text_is_escaped() {
        let mut html = Html::default();
        html.heading("<1>");
        html.paragraph("<2>");
        html.list(&["<3>".into()]);
        html.table(&Table::new("<4>", [cells!["<5>"]]));
        let page = html.page("<6>");
        for number in 1..=6 {
            assert!(page.contains(&format!("&lt;{number}&gt;")) && !page.contains(&format!("<{number}>")), "{page}");
        }
    }
}
