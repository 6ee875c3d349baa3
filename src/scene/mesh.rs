//! Triangles from files. The OBJ reader is ours because it names lines and refuses what can't be lit.

use super::text::{self, FAR};
use super::{gltf, map};
use crate::error::{Error, Result};
use glam::{DVec2, DVec3};
use std::path::Path;

/// Most triangles of a mesh, and of all objects of a scene together.
pub(super) const MAX_TRIANGLES: usize = 1_000_000;

/// A triangle as in its file, v up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    pub(super) points: [DVec3; 3],
    /// Of any length but zero.
    pub(super) normals: [DVec3; 3],
    pub(super) uvs: [DVec2; 3],
    /// Line of its file, where that has lines.
    pub(super) line: Option<u64>,
}

/// Reads a mesh by its file's extension.
pub(super) fn read(path: &Path) -> Result<Vec<Triangle>> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    let triangles = match extension.to_ascii_lowercase().as_str() {
        "obj" => read_obj(&String::from_utf8_lossy(&map::read_file(path)?), path)?,
        "gltf" | "glb" => gltf::read(&map::read_file(path)?, path)?,
        _ => {
            let problem = "a mesh is an .obj, .gltf or .glb file, by its extension".to_owned();
            return Err(Error::file(path, problem));
        }
    };
    if triangles.is_empty() {
        return Err(Error::file(path, "has no triangles".to_owned()));
    }
    Ok(triangles)
}

/// What is wrong with the coordinates of a vertex.
pub(super) fn check_coordinates(what: &str, values: &[f64]) -> Result<(), String> {
    match values.iter().find(|value| !(-FAR..=FAR).contains(*value)) {
        Some(value) => {
            let value = text::shown(*value);
            Err(format!("{what} has {value}: legal is -{FAR} to {FAR}"))
        }
        None => Ok(()),
    }
}

/// Longer than this, a normal's direction survives all arithmetic.
pub(super) fn check_normal(what: &str, normal: DVec3) -> Result<(), String> {
    check_coordinates(what, &normal.to_array())?;
    if normal.length_squared() < 1e-24 {
        return Err(format!("{what} has no length: give every vertex a direction"));
    }
    Ok(())
}

fn read_obj(text: &str, path: &Path) -> Result<Vec<Triangle>> {
    let (mut points, mut normals, mut uvs) = (Vec::new(), Vec::new(), Vec::new());
    let mut triangles = Vec::new();
    let mut corners = Vec::new();
    for (line, number) in text.lines().zip(1..) {
        let fail = |problem| Error::line(path, number, problem);
        let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
        match words.next() {
            Some("v") => {
                let point = numbers::<3>("the point", words).map_err(fail)?;
                points.push(DVec3::from_array(point));
            }
            Some("vn") => {
                let normal = DVec3::from_array(numbers::<3>("the normal", words).map_err(fail)?);
                check_normal("the normal", normal).map_err(fail)?;
                normals.push(normal);
            }
            Some("vt") => {
                let uv = numbers::<2>("the texture coordinate", words).map_err(fail)?;
                uvs.push(DVec2::from_array(uv));
            }
            Some("f") => {
                corners.clear();
                for word in words {
                    let mut indices = word.split('/');
                    let point = pick(&points, "point", word, indices.next()).map_err(fail)?;
                    let uv =
                        pick(&uvs, "texture coordinate", word, indices.next()).map_err(fail)?;
                    let normal = pick(&normals, "normal", word, indices.next()).map_err(fail)?;
                    corners.push((point, normal, uv));
                }
                if corners.len() < 3 {
                    return Err(fail(format!(
                        "a face of {} corners: 3 or more make one",
                        corners.len()
                    )));
                }
                for i in 2..corners.len() {
                    let (a, b, c) = (corners[0], corners[i - 1], corners[i]);
                    triangles.push(Triangle {
                        points: [a.0, b.0, c.0],
                        normals: [a.1, b.1, c.1],
                        uvs: [a.2, b.2, c.2],
                        line: Some(number),
                    });
                }
                if triangles.len() > MAX_TRIANGLES {
                    return Err(fail(too_many()));
                }
            }
            // Names, groups, materials and what else there is change no shape.
            _ => {}
        }
    }
    Ok(triangles)
}

pub(super) fn too_many() -> String {
    format!("more than {MAX_TRIANGLES} triangles, the most that a mesh may have: simplify it")
}

/// The first `N` numbers of a line.
fn numbers<'a, const N: usize>(
    what: &str,
    mut words: impl Iterator<Item = &'a str>,
) -> Result<[f64; N], String> {
    let mut values = [0.0; N];
    for value in &mut values {
        let word = words.next().ok_or_else(|| format!("{what} has fewer than {N} numbers"))?;
        *value = word.parse().map_err(|_| format!("{what} has `{}`, no number", shown(word)))?;
    }
    check_coordinates(what, &values)?;
    Ok(values)
}

/// What a corner's index names: from 1, or from -1 backwards.
fn pick<T: Copy>(list: &[T], what: &str, corner: &str, index: Option<&str>) -> Result<T, String> {
    let corner = shown(corner);
    let Some(index) = index.filter(|index| !index.is_empty()) else {
        return Err(format!(
            "corner `{corner}` has no {what}: export with texture coordinates and normals (v/vt/vn)"
        ));
    };
    let parsed: Option<i64> = index.parse().ok();
    let position = parsed.and_then(|index| match index {
        1.. => usize::try_from(index - 1).ok(),
        0 => None,
        _ => {
            usize::try_from(index.unsigned_abs()).ok().and_then(|back| list.len().checked_sub(back))
        }
    });
    position.and_then(|position| list.get(position)).copied().ok_or_else(|| {
        format!(
            "corner `{corner}` names {what} {}, and up to here there are {} (they count from 1)",
            shown(index),
            list.len()
        )
    })
}

/// A word for a message: not too long, nothing that a terminal would act on.
fn shown(word: &str) -> String {
    word.chars().take(40).flat_map(char::escape_default).collect()
}
