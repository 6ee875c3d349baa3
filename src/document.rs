//! A TOML file that somebody wrote by hand: its text as typed data, and what is wrong in which line.

use crate::cast;
use crate::error::{Error, Result};
use serde::de::DeserializeOwned;
use std::ops::Range;
use std::path::Path;

/// The text of a file, and its path for messages.
#[derive(Clone, Copy)]
pub(crate) struct Document<'a> {
    pub(crate) text: &'a str,
    pub(crate) path: &'a Path,
}

impl Document<'_> {
    /// Reads the whole text.
    ///
    /// # Errors
    /// If it isn't TOML, or not of this type, with the line and its text.
    pub(crate) fn parse<T: DeserializeOwned>(&self) -> Result<T> {
        toml::from_str(self.text).map_err(|why| {
            let span = why.span().unwrap_or_default();
            // As who writes the file would say it.
            let message = why.message().trim_end();
            let message = message.replace("expected i64", "expected a whole number");
            let message = message.replace("expected f64", "expected a number");
            let message =
                message.replace("expected an array of length 3", "expected three numbers");
            self.fail(&span, format!("{message} in `{}`", self.line_text(span.start)))
        })
    }

    /// The line in which a range of bytes starts, from 1.
    pub(crate) fn line(&self, span: &Range<usize>) -> u64 {
        let before = &self.text.as_bytes()[..span.start.min(self.text.len())];
        cast::count_of(1 + before.iter().filter(|byte| **byte == b'\n').count())
    }

    /// An error in the line in which a range of bytes starts.
    pub(crate) fn fail(&self, span: &Range<usize>, problem: String) -> Error {
        Error::line(self.path, self.line(span), problem)
    }

    /// The line around a byte, not too long, nothing in it that a terminal would act on.
    fn line_text(&self, at: usize) -> String {
        let number = self.text.bytes().take(at).filter(|byte| *byte == b'\n').count();
        let line = self.text.lines().nth(number).unwrap_or_default().trim();
        let end = if line.chars().nth(60).is_some() { "…" } else { "" };
        line.chars().take(60).filter(|c| !c.is_control()).collect::<String>() + end
    }
}
