//! Parameters in JSON.

use crate::base::whole;
use crate::design::{Value, Values};
use serde_json::Map;

/// Parameters by name, in the unit's order: numbers as numbers, names as text.
pub type Parameters = Map<String, serde_json::Value>;

/// A parameter's value for JSON.
#[must_use]
pub fn json_of(value: &Value) -> serde_json::Value {
    match value {
        Value::Int(number) => (*number).into(),
        Value::Real(number) => number.get().into(),
        Value::Auto | Value::Choice(_) => value.to_string().into(),
    }
}

/// Parameters for JSON.
#[must_use]
pub fn parameters_of(values: &Values) -> Parameters {
    values.iter().map(|(name, value)| (name.to_owned(), json_of(value))).collect()
}

/// Parameters for JSON, from texts `key=value`.
#[must_use]
pub fn assigned(assignments: &[String]) -> Parameters {
    let pairs = assignments.iter().filter_map(|set| set.split_once('='));
    let value = |text: &str| match (whole::signed(text), text.parse::<f64>()) {
        (Some(number), _) => number.into(),
        (None, Ok(number)) if number.is_finite() => number.into(),
        (None, _) => text.into(),
    };
    pairs.map(|(key, text)| (key.to_owned(), value(text))).collect()
}

/// A parameter's value as text.
#[must_use]
pub fn plain(value: &serde_json::Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
