//! Limits that every surface obeys, whatever its source.

use crate::base::error::Result;
use glam::DVec3;

/// Coordinates, lengths and angles stay within this, so that their squares don't overflow.
pub(super) const FAR: f64 = 1e6;

/// Formats a number for a message, however large.
pub(super) fn shown(value: f64) -> String {
    if value.abs() < 1e9 { value.to_string() } else { format!("{value:e}") }
}

/// The most triangles of a mesh, and of all objects of a scene together.
pub(super) const MAX_TRIANGLES: usize = 1_000_000;

/// Checks the coordinates of a vertex.
pub(super) fn check_coordinates(what: &str, values: &[f64]) -> Result<(), String> {
    match values.iter().find(|value| !(-FAR..=FAR).contains(*value)) {
        Some(value) => {
            let value = shown(*value);
            Err(format!("{what} has {value}: legal is -{FAR} to {FAR}"))
        }
        None => Ok(()),
    }
}

/// A normal; `None` if its length is negligible, which counts as no normal. Longer normals keep
/// their direction in all arithmetic.
pub(super) fn checked_normal(what: &str, normal: DVec3) -> Result<Option<DVec3>, String> {
    check_coordinates(what, &normal.to_array())?;
    Ok((normal.length_squared() >= 1e-24).then_some(normal))
}

pub(super) fn too_many() -> String {
    format!("more than {MAX_TRIANGLES} triangles, the most that a mesh may have: simplify it")
}
