//! HTML pages. All text is escaped.

use crate::escape::html as escape;
use crate::table::Table;

/// A page under construction.
#[derive(Debug, Default)]
pub struct Html(String);

impl Html {
    fn element(&mut self, tag: &str, text: &str) {
        self.0 += &format!("<{tag}>{}</{tag}>\n", escape(text));
    }

    /// Adds a heading of the second level.
    pub fn heading(&mut self, text: &str) {
        self.element("h2", text);
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

    /// Adds a table.
    pub fn table(&mut self, table: &Table) {
        self.0 += &table.html();
    }

    /// Adds text whose columns are aligned by spaces.
    pub fn preformatted(&mut self, text: &str) {
        self.0 += &format!("<div class=\"wide\"><pre>{}</pre></div>\n", escape(text));
    }

    /// Adds a picture that this program has drawn, unescaped.
    pub fn svg(&mut self, svg: &str) {
        self.0 += &format!("<figure>{svg}</figure>\n");
    }

    /// Adds a picture with a caption.
    pub fn figure(&mut self, svg: &str, caption: &str) {
        self.0 += &format!("<figure>{svg}<figcaption>{}</figcaption></figure>\n", escape(caption));
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

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#222;background:#fff}\
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}\
th,td{padding:.2rem .7rem;text-align:left;border-bottom:1px solid #ddd;vertical-align:top}\
th{border-bottom:2px solid #888}figure{margin:1rem 0}figcaption{font-size:.8rem;color:#666}svg{max-width:100%;height:auto}pre{font-size:.8rem}.wide{overflow-x:auto}";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::cells;

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
