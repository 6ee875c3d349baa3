//! Fields of CSV files, written so that typed readers (pandas, polars, DuckDB) infer each column's
//! type from any of its rows.
//!
//! A count is written as a whole number. A real number always has a point or an exponent, so that a
//! column that starts with `0.0` isn't taken for whole numbers. Non-finite numbers are `inf`,
//! `-inf` and `NaN`, which these readers parse as numbers. An empty field is missing. Text is
//! quoted where it has a comma, a quote or an end of line; no text of this crate has an end of
//! line.

use crate::base::error::Result;
use crate::base::output;
use std::fmt;
use std::io::Write;
use std::path::Path;

/// A field.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// A whole number.
    Count(u64),
    /// A word.
    Word(i64),
    /// A real number.
    Real(f64),
    /// A text.
    Text(String),
    /// Unknown.
    Missing,
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count(count) => write!(f, "{count}"),
            Self::Word(word) => write!(f, "{word}"),
            Self::Real(number) => write!(f, "{number:?}"),
            Self::Text(text) => f.write_str(text),
            Self::Missing => Ok(()),
        }
    }
}

impl From<u64> for Field {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<u32> for Field {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<f64> for Field {
    fn from(number: f64) -> Self {
        Self::Real(number)
    }
}

impl From<&str> for Field {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Field {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl<T: Into<Self>> From<Option<T>> for Field {
    fn from(field: Option<T>) -> Self {
        field.map_or(Self::Missing, Into::into)
    }
}

/// Writes a heading and rows; `path` names the file in errors.
///
/// # Errors
/// If they can't be written.
pub fn write(
    to: &mut dyn Write,
    path: &Path,
    heading: &[String],
    rows: impl Iterator<Item = Vec<Field>>,
) -> Result<()> {
    let fail = output::csv_at(path);
    let mut writer = csv::Writer::from_writer(to);
    writer.write_record(heading).map_err(fail)?;
    for row in rows {
        writer.write_record(row.iter().map(Field::to_string)).map_err(fail)?;
    }
    writer.flush().map_err(output::at(path))
}
