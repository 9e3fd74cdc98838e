//! Text in HTML.

/// Text with HTML's special characters as entities.
pub fn escape(text: &str) -> String {
    // `&` first, as the other entities begin with it.
    let entities = [('&', "&amp;"), ('<', "&lt;"), ('>', "&gt;"), ('"', "&quot;"), ('\'', "&#39;")];
    entities.iter().fold(text.to_string(), |text, (character, entity)| text.replace(*character, entity))
}

#[cfg(test)]
mod tests {
    #[test]
    fn special_characters_are_escaped() {
        assert_eq!(super::escape("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    }
}
