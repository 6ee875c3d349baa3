//! Meshes from files. The OBJ reader is ours because it names lines and refuses what can't be lit.

use super::assembly::{Mesh, SharedVertex, Topology};
use super::text::{self, FAR};
use super::{gltf, map};
use crate::cast;
use crate::error::{Error, Result};
use glam::{DVec2, DVec3};
use std::collections::HashMap;
use std::path::Path;

/// Most triangles of a mesh, and of all objects of a scene together.
pub(super) const MAX_TRIANGLES: usize = 1_000_000;

/// Strips of a made-up mesh, and squares of each.
const SHELL_SQUARES: u32 = 48;

/// A dome over the square [-1, 1]² whose halves left and right of x = 0 share a texture: u = |x|, v = 2 (y + 1), and
/// z = 0.6 (1 - x²) (1 - y²). Rows of one strip each; the vertices of x = 0 belong to both halves.
pub(super) fn shell() -> Mesh {
    let mut mesh = Mesh::default();
    let along = |i: u32| 2.0 * f64::from(i) / f64::from(SHELL_SQUARES) - 1.0; // exact at 0 and ±1
    for j in 0..=SHELL_SQUARES {
        for i in 0..=SHELL_SQUARES {
            let (x, y) = (along(i), along(j));
            let (across, up) = (1.0 - x * x, 1.0 - y * y);
            mesh.vertices.push(SharedVertex {
                position: DVec3::new(x, y, 0.6 * across * up),
                normal: DVec3::new(1.2 * x * up, 1.2 * y * across, 1.0),
                uv: DVec2::new(x.abs(), 2.0 * (y + 1.0)),
            });
        }
    }
    let id = |i: u32, j: u32| j * (SHELL_SQUARES + 1) + i;
    for j in 0..SHELL_SQUARES {
        let (lower, upper) = (|i| id(i, j), |i| id(i, j + 1));
        let half = SHELL_SQUARES / 2;
        // A corner that comes twice turns the strip over: its squares are cut as in a mirror, left and right.
        let mut strip = vec![lower(0)];
        strip.extend((0..=half).flat_map(|i| [lower(i), upper(i)]));
        strip.push(lower(half));
        strip.extend((half + 1..=SHELL_SQUARES).flat_map(|i| [upper(i), lower(i)]));
        mesh.assemble(Topology::Strip, &strip).expect("bug: a whole strip");
        mesh.indices += cast::count_of(strip.len());
    }
    mesh
}

/// Reads a mesh by its file's extension.
pub(super) fn read(path: &Path) -> Result<Mesh> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    let mesh = match extension.to_ascii_lowercase().as_str() {
        "obj" => read_obj(&String::from_utf8_lossy(&map::read_file(path)?), path)?,
        "gltf" | "glb" => gltf::read(&map::read_file(path)?, path)?,
        _ => {
            let problem = "a mesh is an .obj, .gltf or .glb file, by its extension".to_owned();
            return Err(Error::file(path, problem));
        }
    };
    if mesh.triangles.is_empty() {
        return Err(Error::file(path, "has no triangles".to_owned()));
    }
    Ok(mesh)
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

fn read_obj(text: &str, path: &Path) -> Result<Mesh> {
    let (mut points, mut normals, mut uvs) = (Vec::new(), Vec::new(), Vec::new());
    let mut mesh = Mesh::default();
    let mut corners = Vec::new();
    // Corners that name the same point, texture coordinate and normal are one vertex.
    let mut known: HashMap<[usize; 3], u32> = HashMap::new();
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
                    let names = [
                        pick(points.len(), "point", word, indices.next()),
                        pick(uvs.len(), "texture coordinate", word, indices.next()),
                        pick(normals.len(), "normal", word, indices.next()),
                    ];
                    let [point, uv, normal] = names;
                    let names = [point.map_err(fail)?, uv.map_err(fail)?, normal.map_err(fail)?];
                    let vertices = &mut mesh.vertices;
                    corners.push(*known.entry(names).or_insert_with(|| {
                        let [point, uv, normal] = names;
                        vertices.push(SharedVertex {
                            position: points[point],
                            normal: normals[normal],
                            uv: uvs[uv],
                        });
                        cast::id_of(vertices.len() - 1)
                    }));
                }
                if corners.len() < 3 {
                    return Err(fail(format!(
                        "a face of {} corners: 3 or more make one",
                        corners.len()
                    )));
                }
                mesh.assemble(Topology::Fan, &corners).map_err(fail)?;
                mesh.indices += cast::count_of(corners.len());
                mesh.lines.resize(mesh.triangles.len(), number);
            }
            // Names, groups, materials and what else there is change no shape.
            _ => {}
        }
    }
    Ok(mesh)
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

/// The place in a list of so many that a corner's index names: from 1, or from -1 backwards.
fn pick(len: usize, what: &str, corner: &str, index: Option<&str>) -> Result<usize, String> {
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
        _ => usize::try_from(index.unsigned_abs()).ok().and_then(|back| len.checked_sub(back)),
    });
    position.filter(|position| *position < len).ok_or_else(|| {
        format!(
            "corner `{corner}` names {what} {}, and up to here there are {len} (they count from 1)",
            shown(index)
        )
    })
}

/// A word for a message: not too long, nothing that a terminal would act on.
fn shown(word: &str) -> String {
    word.chars().take(40).flat_map(char::escape_default).collect()
}
