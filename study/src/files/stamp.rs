//! The run id within a text.

/// The text with the run id where readers of its kind do not mind: the first key of a JSON object, a comment in SVG, HTML and Markdown.
pub(super) fn stamped(name: &str, text: &str, run: &str) -> String {
    let comment = format!("<!-- run {run} -->\n");
    let (kind, head) = match name.rsplit('.').next() {
        // The JSON files of this project are objects with keys, a key a line.
        Some("json") if text.starts_with("{\n") => (format!("\n  \"run\": \"{run}\","), Some(1)),
        Some("json") => (String::new(), None),
        // A comment before the document type would send old browsers into another mode.
        Some("html") => (comment, text.find('\n').map(|end| end + 1)),
        _ => (comment, Some(0)),
    };
    let (head, rest) = text.split_at(head.unwrap_or_default());
    format!("{head}{kind}{rest}")
}

#[cfg(test)]
mod tests {
    use super::stamped;

    #[test]
    fn each_kind_of_text_carries_the_id() {
        let json = serde_json::to_string_pretty(&serde_json::json!({"a": [1], "b": "x"})).unwrap();
        let with: serde_json::Value = serde_json::from_str(&stamped("a.json", &json, "0f")).unwrap();
        assert_eq!(with, serde_json::json!({"run": "0f", "a": [1], "b": "x"}));
        assert_eq!(stamped("a.svg", "<svg/>", "0f"), "<!-- run 0f -->\n<svg/>");
        assert_eq!(stamped("a.md", "# A\n", "0f"), "<!-- run 0f -->\n# A\n");
        let html = stamped("a.html", "<!DOCTYPE html>\n<html></html>\n", "0f");
        assert_eq!(html, "<!DOCTYPE html>\n<!-- run 0f -->\n<html></html>\n");
    }
}
