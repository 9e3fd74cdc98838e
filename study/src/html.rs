//! HTML, as far as the pages need it. Every text is escaped.

/// A page in the making.
#[derive(Debug, Default)]
pub struct Html(String);

impl Html {
    /// A heading of the second level.
    pub fn heading(&mut self, text: &str) {
        self.0 += &format!("<h2>{}</h2>\n", escape(text));
    }

    /// A heading of the third level.
    pub fn subheading(&mut self, text: &str) {
        self.0 += &format!("<h3>{}</h3>\n", escape(text));
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.0 += &format!("<p>{}</p>\n", escape(text));
    }

    /// A list.
    pub fn list(&mut self, items: &[String]) {
        let items: String = items.iter().map(|item| format!("<li>{}</li>\n", escape(item))).collect();
        self.0 += &format!("<ul>\n{items}</ul>\n");
    }

    /// A table; the first column are names.
    pub fn table(&mut self, head: &[&str], rows: &[Vec<String>]) {
        let head: String = head.iter().map(|cell| format!("<th>{}</th>", escape(cell))).collect();
        let row = |cells: &Vec<String>| {
            let cells: String = cells.iter().map(|cell| format!("<td>{}</td>", escape(cell))).collect();
            format!("<tr>{cells}</tr>\n")
        };
        let rows: String = rows.iter().map(row).collect();
        self.0 += &format!(
            "<div class=\"wide\"><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
        );
    }

    /// Text whose columns stand below one another.
    pub fn preformatted(&mut self, text: &str) {
        self.0 += &format!("<div class=\"wide\"><pre>{}</pre></div>\n", escape(text));
    }

    /// A picture that this program has drawn; as it is.
    pub fn svg(&mut self, svg: &str) {
        self.0 += &format!("<figure>{svg}</figure>\n");
    }

    /// The same with what stands below it.
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

/// Text with the characters that mean something in HTML written as such.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\'' => escaped += "&#39;",
            other => escaped.push(other),
        }
    }
    escaped
}
