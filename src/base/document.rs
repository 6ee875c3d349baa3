//! Hand-written TOML files: parses them into typed data, and reports errors with their line.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::escape;
use serde::de::value::MapAccessDeserializer;
use serde::de::{DeserializeOwned, Error as _, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;
use std::ops::{Deref, Range};
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The text of a file, and its path for messages.
#[derive(Clone, Copy)]
pub(crate) struct Document<'a> {
    pub(crate) text: &'a str,
    pub(crate) path: &'a Path,
}

/// An array of exactly `N` values. Every fixed-length array in a file must use this type: serde's
/// own takes the first `N` and silently drops the rest, since TOML's reader doesn't check that the
/// end was reached.
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

/// A table. Every nested struct in a file must use this type: serde's own also accepts an array,
/// assigns its values to the keys in order, and drops the rest.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Table<T>(T);

impl<T> Deref for Table<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Table<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Keys<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Keys<T> {
            type Value = Table<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a table")
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                T::deserialize(MapAccessDeserializer::new(map)).map(Table)
            }
        }
        deserializer.deserialize_map(Keys(PhantomData))
    }
}

/// Maps a table's tag to enum variant names, outermost first, or to an error message.
pub(crate) type Kind = fn(&str) -> Result<Vec<String>, String>;

/// Where the lines of a text end, in bytes.
pub(crate) struct Lines(Vec<usize>);

impl Lines {
    /// The line of a byte, from 1.
    pub(crate) fn of(&self, at: usize) -> u64 {
        cast::count_of(1 + self.0.partition_point(|end| *end < at))
    }
}

impl Document<'_> {
    /// Reads the whole text.
    ///
    /// # Errors
    /// If it isn't TOML or doesn't match the type; the error gives the line and its text.
    pub(crate) fn parse<T: DeserializeOwned>(&self) -> Result<T> {
        toml::from_str(self.text).map_err(|why| self.told(&why))
    }

    /// Reads the whole text, where some arrays hold tables whose key `tag` names an enum variant.
    ///
    /// serde supports such enums too, but loses the positions of their keys. So each table
    /// `{ tag = "Name", … }` becomes `{ Name = { … } }`, which is serde's default form of an enum.
    ///
    /// # Errors
    /// As [`Document::parse`], and if a table has no such key or `kind` refuses its name.
    pub(crate) fn parse_tagged<T: DeserializeOwned>(
        &self,
        tag: &str,
        arrays: &[(&str, Kind)],
    ) -> Result<T> {
        let mut root = DeTable::parse(self.text).map_err(|why| self.told(&why))?;
        for (name, kind) in arrays {
            // If it isn't an array of tables, serde reports that.
            let array = root.get_mut().get_mut(*name).map(Spanned::get_mut);
            let Some(DeValue::Array(items)) = array else { continue };
            for item in items.iter_mut() {
                self.untag(item, tag, *kind)?;
            }
        }
        T::deserialize(toml::de::Deserializer::from(root)).map_err(|why| self.told(&why))
    }

    /// Turns `{ tag = "Name", … }` into `{ Name = { … } }`.
    fn untag(&self, item: &mut Spanned<DeValue<'_>>, tag: &str, kind: Kind) -> Result<()> {
        let span = item.span();
        let DeValue::Table(table) = item.get_mut() else {
            let line = self.line_text(span.start);
            return Err(self.fail(&span, format!("expected a table with `{tag}` in `{line}`")));
        };
        let given = table.remove(tag).ok_or_else(|| {
            let line = self.line_text(span.start);
            self.fail(&span, format!("missing field `{tag}` in `{line}`"))
        })?;
        let at = given.span();
        let names = match given.get_ref() {
            DeValue::String(name) => kind(name),
            DeValue::Integer(_)
            | DeValue::Float(_)
            | DeValue::Boolean(_)
            | DeValue::Datetime(_)
            | DeValue::Array(_)
            | DeValue::Table(_) => Err(format!("`{tag}` must be a name in quotes")),
        };
        let names = names.map_err(|problem| {
            self.fail(&at, format!("{problem} in `{}`", self.line_text(at.start)))
        })?;
        let mut value = DeValue::Table(std::mem::take(table));
        for name in names.into_iter().rev() {
            let mut outer = DeTable::new();
            outer.insert(
                Spanned::new(at.clone(), Cow::Owned(name)),
                Spanned::new(span.clone(), value),
            );
            value = DeValue::Table(outer);
        }
        *item = Spanned::new(span, value);
        Ok(())
    }

    /// Rewords an error of the reader for the file's author.
    fn told(&self, why: &toml::de::Error) -> Error {
        let span = why.span().unwrap_or_default();
        let message = why.message().trim_end();
        let message = message.replace("expected i64", "expected a whole number");
        let message = message.replace("expected f64", "expected a number");
        let mut message =
            message.replace("expected an array of length 3", "expected three numbers");
        // The reader words this differently for enums than for structs.
        let unknown = message.strip_prefix("unexpected keys in table: ");
        if let Some((given, legal)) = unknown.and_then(|rest| rest.split_once(", available keys: "))
        {
            let given = given.split(", ").next().unwrap_or_default();
            let legal: Vec<String> = legal.split(", ").map(|name| format!("`{name}`")).collect();
            message = format!("unknown field `{given}`, expected one of {}", legal.join(", "));
        }
        self.fail(&span, format!("{message} in `{}`", self.line_text(span.start)))
    }

    /// Where its lines end.
    pub(crate) fn lines(&self) -> Lines {
        let ends = self.text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Lines(ends.map(|(at, _)| at).collect())
    }

    /// An error in the line in which a byte range starts.
    pub(crate) fn fail(&self, span: &Range<usize>, problem: String) -> Error {
        Error::line(self.path, self.lines().of(span.start), problem)
    }

    /// The line around a byte.
    fn line_text(&self, at: usize) -> String {
        let before = self.text.get(..at).unwrap_or(self.text);
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        escape::short(self.text[start..].lines().next().unwrap_or_default().trim())
    }
}
