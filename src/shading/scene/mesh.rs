//! Meshes from files, by extension, and a generated mesh.

use super::assembly::{Mesh, MeshVertex, Topology};
use super::{gltf, map, obj};
use crate::base::cast;
use crate::base::error::{Error, Result};
use glam::{DVec2, DVec3};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Strips of the generated mesh, and squares in each.
const SHELL_SQUARES: u32 = 48;

/// A dome over the square [-1, 1]² whose halves left and right of x = 0 share a texture: u = |x|, v
/// = 2 (y + 1), and z = 0.6 (1 - x²) (1 - y²). Each row is one strip; the vertices at x = 0 belong
/// to both halves.
pub(super) fn shell() -> Mesh {
    let mut mesh = Mesh::default();
    let along = |i: u32| 2.0 * f64::from(i) / f64::from(SHELL_SQUARES) - 1.0; // exact at 0 and ±1
    for j in 0..=SHELL_SQUARES {
        for i in 0..=SHELL_SQUARES {
            let (x, y) = (along(i), along(j));
            let (across, up) = (1.0 - x * x, 1.0 - y * y);
            mesh.vertices.push(MeshVertex {
                position: DVec3::new(x, y, 0.6 * across * up),
                normal: Some(DVec3::new(1.2 * x * up, 1.2 * y * across, 1.0)),
                uv: Some(DVec2::new(x.abs(), 2.0 * (y + 1.0))),
            });
        }
    }
    let id = |i: u32, j: u32| j * (SHELL_SQUARES + 1) + i;
    for j in 0..SHELL_SQUARES {
        let (lower, upper) = (|i| id(i, j), |i| id(i, j + 1));
        let half = SHELL_SQUARES / 2;
        // A repeated corner flips the strip: the right half's squares are cut as mirror images of
        // the left's.
        let mut strip = vec![lower(0)];
        strip.extend((0..=half).flat_map(|i| [lower(i), upper(i)]));
        strip.push(lower(half));
        strip.extend((half + 1..=SHELL_SQUARES).flat_map(|i| [upper(i), lower(i)]));
        mesh.assemble(Topology::Strip, &strip, None).expect("bug: a whole strip");
        mesh.indices += cast::count_of(strip.len());
    }
    mesh
}

/// Meshes by file. Each file is read once, however many objects use it.
#[derive(Default)]
pub(super) struct Files(HashMap<PathBuf, Arc<Mesh>>);

impl Files {
    pub(super) fn open(&mut self, path: &Path) -> Result<Arc<Mesh>> {
        let file = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if let Some(mesh) = self.0.get(&file) {
            return Ok(Arc::clone(mesh));
        }
        let mesh = Arc::new(read(path)?);
        self.0.insert(file, Arc::clone(&mesh));
        Ok(mesh)
    }
}

/// Reads a mesh by its file's extension.
fn read(path: &Path) -> Result<Mesh> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    let mesh = match extension.to_ascii_lowercase().as_str() {
        "obj" => obj::read(&map::read_file(path)?, path)?,
        "gltf" | "glb" => gltf::read(&map::read_file(path)?, path)?,
        _ => {
            let problem = "isn't a mesh: legal extensions are .obj, .gltf and .glb".to_owned();
            return Err(Error::file(path, problem));
        }
    };
    if mesh.triangles.is_empty() {
        let why: Vec<String> =
            std::iter::once("has no triangles".to_owned()).chain(mesh.told()).collect();
        return Err(Error::file(path, why.join("; ")));
    }
    Ok(mesh)
}

#[cfg(test)]
mod file_tests {
    use super::*;

    #[test]
    fn a_file_is_read_once() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        let text =
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1/1 2/2/1 3/3/1";
        fs::write(&path, text).unwrap();
        let mut files = Files::default();
        let first = files.open(&path).unwrap();
        assert!(Arc::ptr_eq(&first, &files.open(&folder.path().join("./a.obj")).unwrap()));
        assert!(files.open(&folder.path().join("b.obj")).is_err());
    }
}
