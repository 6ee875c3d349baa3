//! JSON for other programs: the head that all documents share, and their schema.
//!
//! A document is an object whose first fields are `tool`, `version` (of this crate), `document`
//! (its kind) and `schema_version`. [`SCHEMA`] is the JSON Schema of all documents. A later version
//! of the crate may add fields; [`SCHEMA_VERSION`] goes up when a field changes its meaning or is
//! removed.
//!
//! A real number that JSON can't write is one of the strings `NaN`, `inf` and `-inf`. `null` means
//! unknown.

use serde::{Serialize, Serializer};
use serde_json::{Map, Value};

/// The JSON Schema of every document.
pub const SCHEMA: &str = include_str!("schema.json");

/// Version of the schema.
pub const SCHEMA_VERSION: u32 = 1;

/// The fields that every document starts with.
#[must_use]
pub fn head(document: &str) -> Map<String, Value> {
    let fields: [(&str, Value); 4] = [
        ("tool", "fixpath".into()),
        ("version", env!("CARGO_PKG_VERSION").into()),
        ("document", document.into()),
        ("schema_version", SCHEMA_VERSION.into()),
    ];
    fields.map(|(name, value)| (name.to_owned(), value)).into_iter().collect()
}

/// A document: its head, followed by the fields of an object.
///
/// # Panics
/// If `fields` is not an object, or can't be written as JSON: a bug in the caller.
#[must_use]
pub fn document(name: &str, fields: impl Serialize) -> Value {
    let fields = serde_json::to_value(fields).expect("bug: figures are plain values");
    let Value::Object(fields) = fields else { panic!("bug: a document is an object") };
    let mut all = head(name);
    all.extend(fields);
    Value::Object(all)
}

/// A value as text, ending in a newline. Characters that a terminal acts on, which occur only
/// inside strings, are written as escapes.
///
/// # Panics
/// Never: the values are plain.
#[must_use]
pub fn text(value: &Value) -> String {
    let plain = serde_json::to_string_pretty(value).expect("bug: JSON values can be written");
    let mut text = String::with_capacity(plain.len() + 1);
    for c in plain.chars() {
        if c != '\n' && crate::base::escape::is_hidden(c) {
            for unit in c.encode_utf16(&mut [0; 2]) {
                text.push_str(&format!("\\u{unit:04x}"));
            }
        } else {
            text.push(c);
        }
    }
    text.push('\n');
    text
}

/// A real number as JSON.
#[must_use]
pub fn number(number: f64) -> Value {
    if number.is_finite() { number.into() } else { number.to_string().into() }
}

/// For `serialize_with`: a real number.
pub(crate) fn real<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() { to.serialize_f64(*value) } else { to.collect_str(value) }
}

/// For `serialize_with`: a real number that may be unknown.
pub(crate) fn known_real<S: Serializer>(value: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
    match value {
        Some(value) => real(value, to),
        None => to.serialize_none(),
    }
}

/// For `serialize_with`: real numbers that may be unknown.
pub(crate) fn known_reals<S: Serializer>(
    values: &Option<Vec<f64>>,
    to: S,
) -> Result<S::Ok, S::Error> {
    match values {
        Some(values) => reals(values, to),
        None => to.serialize_none(),
    }
}

/// For `serialize_with`: real numbers.
pub(crate) fn reals<S: Serializer>(values: &[f64], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(values.iter().map(|value| number(*value)))
}
