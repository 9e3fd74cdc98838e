//! Lines of a program, assembled to answers.

use crate::protocol::{self, AnswerLine};
use crate::quotation::quoted;
use crate::spelling::{is_open, objects};
use crate::trouble::{Remark, Trouble, Troubles};
use crate::verdict::Fault;

/// Longest answer that is assembled from several lines, in bytes.
const LONGEST: usize = 2 << 20;

/// Reader of lines. It keeps an unfinished answer, and what was wrong with the form of the others.
#[derive(Debug, Default)]
pub struct Lines {
    unfinished: String,
    troubles: Troubles,
}

impl Lines {
    /// Reads a further line, and returns the answers that it completes. None: more lines must follow.
    pub fn read(&mut self, line: &str) -> Vec<Result<AnswerLine, Fault>> {
        if self.unfinished.is_empty() {
            return self.read_text(line, false);
        }
        // A whole answer shows that what came before was none.
        if let Some(mut answers) = self.answers(line, false) {
            answers.insert(0, Ok(AnswerLine::Chatter(quoted(&std::mem::take(&mut self.unfinished)))));
            return answers;
        }
        let text = std::mem::take(&mut self.unfinished) + "\n" + line;
        self.read_text(&text, true)
    }

    fn read_text(&mut self, text: &str, over_lines: bool) -> Vec<Result<AnswerLine, Fault>> {
        // First, as reading what is not finished yet would take long with every line of it.
        if is_open(text) && text.len() < LONGEST {
            self.unfinished = text.trim_end().into();
            return Vec::new();
        }
        if let Some(answers) = self.answers(text, over_lines) {
            return answers;
        }
        match objects(text) {
            Some((tables, _)) => tables.iter().map(|table| protocol::answer(table, text)).collect(),
            None => vec![protocol::read(text)],
        }
    }

    /// Answers of a text; `None` if it has other objects, or none.
    fn answers(&mut self, text: &str, over_lines: bool) -> Option<Vec<Result<AnswerLine, Fault>>> {
        let around = || {
            // A prompt or a message on the same line.
            let (start, end) = (text.find('{')?, text.rfind('}')?);
            let (tables, mut troubles) = objects(text.get(start..=end)?)?;
            troubles.insert(Trouble::TextAround);
            Some((tables, troubles))
        };
        let (tables, troubles) = objects(text).or_else(around)?;
        if !tables.iter().all(|table| table.contains_key("id") || table.contains_key("hello")) {
            return None;
        }
        let over_lines = over_lines.then_some(Trouble::SeveralLines);
        troubles.into_iter().chain(over_lines).for_each(|trouble| self.troubles.add(trouble, text));
        Some(tables.iter().map(|table| protocol::answer(table, text)).collect())
    }

    /// Gives up the unfinished answer, and returns its beginning.
    pub fn give_up(&mut self) -> Option<String> {
        let unfinished = std::mem::take(&mut self.unfinished);
        (!unfinished.is_empty()).then(|| quoted(&unfinished))
    }

    /// Notes a trouble that lines alone do not show.
    pub fn note(&mut self, trouble: Trouble, line: &str) {
        self.troubles.add(trouble, line);
    }

    /// What was wrong with the form of the lines.
    pub fn remarks(&self) -> Vec<Remark> {
        self.troubles.remarks()
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::protocol::Answer;

    fn one(id: &str) -> Result<AnswerLine, Fault> {
        Ok(AnswerLine::Answer { id: id.into(), answer: Answer::Value(json!([1, 2])) })
    }

    fn troubles(lines: &Lines) -> Vec<Trouble> {
        lines.remarks().into_iter().map(|remark| remark.trouble).collect()
    }

    #[test]
    fn an_answer_over_several_lines_is_assembled() {
        let mut lines = Lines::default();
        for line in ["{\n", "  \"id\": \"7\",\n", "  \"value\": [\n", "    1,\n", "    2\n", "  ]\n"] {
            assert_eq!(lines.read(line), []);
        }
        assert_eq!(lines.read("}\n"), [one("7")]);
        assert_eq!(troubles(&lines), [Trouble::SeveralLines]);
        assert_eq!(lines.give_up(), None);
    }

    #[test]
    fn a_whole_answer_ends_what_was_none() {
        let mut lines = Lines::default();
        assert_eq!(lines.read("{ computing\n"), []);
        let answer = "{\"id\":\"7\",\"value\":[1,2]}\n";
        assert_eq!(lines.read(answer), [Ok(AnswerLine::Chatter("{ computing".into())), one("7")]);
        assert_eq!(troubles(&lines), []);
        assert_eq!(lines.read("{\"id\":\n"), []);
        assert_eq!(lines.give_up().as_deref(), Some("{\"id\":"));
    }

    #[test]
    fn several_answers_and_a_prompt_on_a_line() {
        let mut lines = Lines::default();
        assert_eq!(lines.read(r#"{"id":"7","value":[1,2]} {"id":"8","value":[1,2]}"#), [one("7"), one("8")]);
        assert_eq!(lines.read(r#">> {"id":"7","value":[1,2]} ok"#), [one("7")]);
        assert_eq!(troubles(&lines), [Trouble::SeveralOnALine, Trouble::TextAround]);
        // Other objects are no answers, with words around them or without.
        assert_eq!(lines.read(r#"data {"a":1}"#), [Ok(AnswerLine::Chatter(r#"data {"a":1}"#.into()))]);
        assert!(matches!(lines.read(r#"{"a":1}"#)[..], [Err(Fault::Garbage(_))]));
    }

    #[test]
    fn carriage_returns_are_no_trouble() {
        let mut lines = Lines::default();
        assert_eq!(lines.read("{\"id\":\"7\",\"value\":[1,2]}\r\n"), [one("7")]);
        assert_eq!(troubles(&lines), []);
    }
}
