//! The text of a scene file: lines, quotations, and syntax errors on one line.

use crate::error::{Parts, SceneError};

/// The longest quotation from a file in an error, characters.
const QUOTATION: usize = 60;

/// A scene file's text and the name that errors give it.
pub(crate) struct Source<'a> {
    pub(crate) origin: &'a str,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// An error about `key`, on the line that holds byte `start`.
    pub(crate) fn error(&self, start: Option<usize>, key: String, problem: String) -> SceneError {
        let line = start.map(|start| self.line(start));
        Parts { line, key: Some(key), ..self.parts(problem) }.into()
    }

    /// The parser's own explanation of text that is not TOML, with line and column.
    pub(crate) fn syntax_error(&self, error: &toml::de::Error) -> SceneError {
        let start = error.span().map(|span| span.start);
        let explanation = error.message().trim().replace('\n', ", ");
        let line = start.map(|start| self.line(start));
        let column = start.map(|start| self.column(start));
        Parts { line, column, ..self.parts(format!("not valid TOML: {explanation}")) }.into()
    }

    fn parts(&self, problem: String) -> Parts {
        Parts { file: Some(self.origin.to_owned()), problem, ..Parts::default() }
    }

    /// What the file says from byte `start` to `end`, on one line and not too long.
    pub(crate) fn quote(&self, span: std::ops::Range<usize>) -> String {
        let text = self.text.get(span).unwrap_or_default();
        let one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        shortened(&one_line)
    }

    /// The line of byte `at`, from 1.
    fn line(&self, at: usize) -> usize {
        1 + self.before(at).matches('\n').count()
    }

    /// The column of byte `at`, in characters from 1.
    fn column(&self, at: usize) -> usize {
        1 + self.before(at).chars().rev().take_while(|&c| c != '\n').count()
    }

    fn before(&self, at: usize) -> &str {
        &self.text[..self.text.floor_char_boundary(at)]
    }
}

/// `text`, cut to a length that fits an error message.
pub(crate) fn shortened(text: &str) -> String {
    match text.char_indices().nth(QUOTATION) {
        Some((cut, _)) => format!("{}…", &text[..cut]),
        None => text.to_owned(),
    }
}
