//! A TOML file that somebody wrote by hand: its text as typed data, and what is wrong in which line.

use crate::cast;
use crate::error::{Error, Result};
use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer};
use std::ops::Range;
use std::path::Path;

/// The text of a file, and its path for messages.
#[derive(Clone, Copy)]
pub(crate) struct Document<'a> {
    pub(crate) text: &'a str,
    pub(crate) path: &'a Path,
}

/// An array of exactly so many values. Every array of fixed length in a file must be one: serde's own takes the
/// first `N` and drops the others without a word, since TOML's reader doesn't ask whether the end was reached.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exactly<T, const N: usize>(pub(crate) [T; N]);

impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Exactly<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let values = Vec::deserialize(deserializer)?;
        let wrong = |values: Vec<T>| {
            let expected = format!("an array of length {N}");
            D::Error::invalid_length(values.len(), &expected.as_str())
        };
        values.try_into().map(Self).map_err(wrong)
    }
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
