//! Primitive assembly: vertex buffers whose vertices are shared by primitives, and triangles of
//! vertex numbers.
//!
//! A mesh stores each vertex once, however many triangles share it. A [`Topology`] says which
//! corners of a list form the next triangle. File readers return corners and a topology; all other
//! code takes vertices and triangles of vertex numbers. A per-vertex computation is done once for
//! all triangles that share the vertex, which is the claim of US 7,843,463; [`Sharing`] counts the
//! savings.

use super::limits::{MAX_TRIANGLES, too_many};
use crate::base::cast;
use glam::{DVec2, DVec3};
use serde::Serialize;

/// How a list of corners forms triangles (glTF's modes 4, 5 and 6).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Topology {
    /// Three corners per triangle.
    List,
    /// Each corner from the third on, with the two before it.
    Strip,
    /// Each corner from the third on, with the one before it and the first.
    Fan,
}

impl Topology {
    /// Number of triangles that so many corners form.
    ///
    /// # Errors
    /// If corners are left over, or there are too few for a triangle.
    pub fn triangles(self, corners: usize) -> Result<usize, String> {
        match self {
            Self::List if corners.is_multiple_of(3) => Ok(corners / 3),
            Self::List => {
                Err(format!("{corners} corners in a list of triangles: legal is a multiple of 3"))
            }
            Self::Strip | Self::Fan if corners >= 3 => Ok(corners - 2),
            Self::Strip => Err(format!("a strip of {corners} corners: it needs 3 or more")),
            Self::Fan => Err(format!("a fan of {corners} corners: it needs 3 or more")),
        }
    }

    /// Positions of a triangle's corners in the list. All triangles have the winding of the first:
    /// in a strip every other triangle has its last two corners exchanged, as glTF 2.0 (3.7.2.1)
    /// specifies.
    #[must_use]
    pub fn corners(self, triangle: usize) -> [usize; 3] {
        let i = triangle;
        match self {
            Self::List => [3 * i, 3 * i + 1, 3 * i + 2],
            Self::Strip if i.is_multiple_of(2) => [i, i + 1, i + 2],
            Self::Strip => [i, i + 2, i + 1],
            Self::Fan => [0, i + 1, i + 2],
        }
    }
}

/// A shared vertex: it doesn't depend on any of its triangles.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SharedVertex {
    /// Its position.
    pub position: DVec3,
    /// Its unit normal N; 0 where triangles use their own
    /// ([`Scene::faceted`](super::Scene::faceted)).
    pub normal: DVec3,
    /// u and v, v up; 0 if the mesh has none and nothing needs them.
    pub uv: DVec2,
}

/// A vertex as the file gives it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct MeshVertex {
    pub(super) position: DVec3,
    /// Of any length except zero.
    pub(super) normal: Option<DVec3>,
    pub(super) uv: Option<DVec2>,
}

/// Vertices and the triangles between them, as the file gives them.
#[derive(Clone, Default, Debug)]
pub(super) struct Mesh {
    /// Each vertex once.
    pub(super) vertices: Vec<MeshVertex>,
    /// Vertex numbers of each triangle.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Line of each triangle in its file, for text formats.
    pub(super) lines: Vec<u64>,
    /// Words of index buffers: the corners of all lists, strips and fans that have one.
    pub(super) indices: u64,
    /// Strip triangles that were left out because two of their corners coincide: they only stitch.
    pub(super) stitches: u64,
    /// Other triangles that were left out because they have no area.
    pub(super) flat: Tally,
    /// Anything else that the reader left out or ignored, in words.
    pub(super) notes: Vec<String>,
    /// True if the format requires the triangles' own normals where vertices have none.
    pub(super) is_faceted: bool,
}

/// How often something occurred in a file, and where first.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Tally {
    pub(super) count: u64,
    /// Line of the first, for text formats.
    line: Option<u64>,
}

impl Tally {
    pub(super) fn add(&mut self, line: Option<u64>) {
        if self.count == 0 {
            self.line = line;
        }
        self.count += 1;
    }

    /// Rejects a statement that should have come before these.
    pub(super) fn follows(&self, name: &str) -> Result<(), String> {
        match self.line {
            Some(line) => Err(format!(
                "the first `{name}` comes after line {line}, whose corners refer to one: move it before that line"
            )),
            None => Ok(()),
        }
    }

    /// A note of the count and the first line; `None` if the count is 0.
    pub(super) fn told(&self, what: &str) -> Option<String> {
        let place = self.line.map(|line| format!(", the first in line {line}"));
        (self.count > 0).then(|| format!("{what}: {}{}", self.count, place.unwrap_or_default()))
    }
}

/// A triangle whose area is below this fraction of its longest edge squared has none.
const THIN: f64 = 1e-12;
/// Squared edges below this have lost their significant digits.
const TINY: f64 = 1e-60;

/// False for a triangle or parallelogram of these corners that degenerates to a line or a point.
pub(super) fn has_area([a, b, c]: [DVec3; 3]) -> bool {
    let longest = a.distance_squared(b).max(a.distance_squared(c)).max(b.distance_squared(c));
    is_area((b - a).cross(c - a).length(), longest)
}

/// False if an area is negligible against the square of its longest edge.
pub(super) fn is_area(area: f64, longest: f64) -> bool {
    longest > TINY && area > THIN * longest
}

impl Mesh {
    /// Corners of a triangle.
    pub(super) fn corners(&self, triangle: [u32; 3]) -> [&MeshVertex; 3] {
        triangle.map(|corner| &self.vertices[cast::index_of_u32(corner)])
    }

    /// The first triangle that has a corner without texture coordinates.
    pub(super) fn without_uv(&self) -> Option<usize> {
        let lacks = |triangle: &[u32; 3]| self.corners(*triangle).iter().any(|v| v.uv.is_none());
        self.triangles.iter().position(lacks)
    }

    /// Line of a triangle, where its file has lines.
    pub(super) fn line(&self, triangle: usize) -> Option<u64> {
        self.lines.get(triangle).copied()
    }

    /// How the mesh differs from its file, in words.
    pub(super) fn told(&self) -> Vec<String> {
        let flat = self.flat.told("triangles without area left out");
        flat.into_iter().chain(self.notes.iter().cloned()).collect()
    }

    /// Adds the triangles of a list of corners, which are vertex numbers; triangles without area
    /// are only counted.
    ///
    /// # Errors
    /// If the corners don't form triangles, or there are too many triangles.
    ///
    /// # Panics
    /// If a corner has no vertex: readers check this.
    pub(super) fn assemble(
        &mut self,
        topology: Topology,
        corners: &[u32],
        line: Option<u64>,
    ) -> Result<(), String> {
        let count = topology.triangles(corners.len())?;
        self.triangles.reserve(count.min(MAX_TRIANGLES));
        for triangle in 0..count {
            let corners = topology.corners(triangle).map(|place| corners[place]);
            let points = self.corners(corners).map(|vertex| vertex.position);
            let [a, b, c] = points;
            // Strips are stitched by repeated indices or by coinciding points.
            if topology == Topology::Strip && (a == b || b == c || a == c) {
                self.stitches += 1;
                continue;
            }
            if !has_area(points) {
                self.flat.add(line);
                continue;
            }
            if self.triangles.len() == MAX_TRIANGLES {
                return Err(too_many());
            }
            self.triangles.push(corners);
            self.lines.extend(line);
        }
        Ok(())
    }
}

/// What vertex sharing saves against a separate copy of a vertex for each of its triangles.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Sharing {
    /// Vertices in the buffer.
    pub vertices: u64,
    /// Triangles.
    pub primitives: u64,
    /// Words of the index buffer; 0 if there is none.
    pub indices: u64,
    /// Triangles left out of strips because they only stitch.
    pub stitches: u64,
    /// Operations of the vertex stage with sharing: one for each vertex that is used by a triangle.
    pub vertex_operations: u64,
    /// Without sharing: 3 per triangle.
    pub replicated_operations: u64,
    /// Bytes of vertices and indices: 8 `f32` per vertex (position, normal, uv) and 4 bytes per
    /// index.
    pub bytes: u64,
    /// Bytes without sharing: one vertex per corner, no indices.
    pub replicated_bytes: u64,
}

/// Bytes of a vertex in the buffer.
const VERTEX_BYTES: u64 = 8 * 4;
/// Bytes of an index.
const INDEX_BYTES: u64 = 4;

impl Sharing {
    /// Counts vertices, triangles between them, words of indices and stitches.
    #[must_use]
    pub fn of(vertices: usize, triangles: &[[u32; 3]], indices: u64, stitches: u64) -> Self {
        let mut used = vec![false; vertices];
        for corner in triangles.as_flattened() {
            used[cast::index_of_u32(*corner)] = true;
        }
        let corners = 3 * cast::count_of(triangles.len());
        let vertices = cast::count_of(vertices);
        Self {
            vertices,
            primitives: cast::count_of(triangles.len()),
            indices,
            stitches,
            vertex_operations: cast::count_of(used.iter().filter(|used| **used).count()),
            replicated_operations: corners,
            bytes: vertices * VERTEX_BYTES + indices * INDEX_BYTES,
            replicated_bytes: corners * VERTEX_BYTES,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(points: &[[i32; 2]]) -> Mesh {
        let vertex = |[x, y]: &[i32; 2]| MeshVertex {
            position: DVec3::new(f64::from(*x), f64::from(*y), 0.0),
            normal: None,
            uv: None,
        };
        Mesh { vertices: points.iter().map(vertex).collect(), ..Mesh::default() }
    }

    /// Twice the area of each triangle, positive where it turns counter-clockwise.
    fn areas(mesh: &Mesh) -> Vec<f64> {
        let at = |corner: u32| mesh.vertices[cast::index_of_u32(corner)].position;
        let area = |[a, b, c]: &[u32; 3]| (at(*b) - at(*a)).cross(at(*c) - at(*a)).z;
        mesh.triangles.iter().map(area).collect()
    }

    /// A ladder of 2 x 6 points as one strip: all its triangles have the same winding, and cover it
    /// once.
    #[test]
    fn strips_turn_one_way() {
        let points: Vec<[i32; 2]> = (0..12).map(|i| [i / 2, 1 - i % 2]).collect();
        let mut ladder = mesh(&points);
        ladder.assemble(Topology::Strip, &(0..12).collect::<Vec<_>>(), None).unwrap();
        assert_eq!(areas(&ladder), [1.0; 10]);
        let mut seen: Vec<[u32; 3]> = ladder.triangles.clone();
        seen.iter_mut().for_each(|corners| corners.sort_unstable());
        let expected: Vec<[u32; 3]> = (0..10).map(|i| [i, i + 1, i + 2]).collect();
        assert_eq!(seen, expected);
    }

    /// Two ladders stitched into one strip: by repeated indices, and by coinciding points.
    #[test]
    fn stitches_make_no_triangles() {
        let ladder = |x: i32| (0..6).map(move |i| [x + i / 2, 1 - i % 2]);
        let points: Vec<[i32; 2]> = ladder(0).chain(ladder(10)).collect();
        let mut indexed = mesh(&points);
        let corners = [0, 1, 2, 3, 4, 5, 5, 6, 6, 7, 8, 9, 10, 11];
        indexed.assemble(Topology::Strip, &corners, None).unwrap();
        assert_eq!((areas(&indexed), indexed.stitches), (vec![1.0; 8], 4));

        let points: Vec<[i32; 2]> =
            corners.iter().map(|i| points[cast::index_of_u32(*i)]).collect();
        let mut plain = mesh(&points);
        plain.assemble(Topology::Strip, &(0..14).collect::<Vec<_>>(), None).unwrap();
        assert_eq!((areas(&plain), plain.stitches), (vec![1.0; 8], 4));
    }

    #[test]
    fn fans_and_lists() {
        let points = [[0, 0], [2, 0], [2, 1], [1, 2], [0, 2]];
        let mut fan = mesh(&points);
        fan.assemble(Topology::Fan, &[0, 1, 2, 3, 4], None).unwrap();
        assert_eq!(fan.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        assert_eq!(areas(&fan), [2.0, 3.0, 2.0]);
        let mut list = mesh(&points);
        list.assemble(Topology::List, &[0, 1, 2, 0, 2, 3, 0, 3, 4], None).unwrap();
        assert_eq!(list.triangles, fan.triangles);
        for (topology, corners) in
            [(Topology::List, 4), (Topology::Strip, 2), (Topology::Fan, 0), (Topology::Strip, 0)]
        {
            assert!(topology.triangles(corners).is_err(), "{topology:?} {corners}");
        }
        assert_eq!(Topology::List.triangles(0), Ok(0));
    }

    #[test]
    fn triangles_without_area_are_counted() {
        let mut list = mesh(&[[0, 0], [2, 0], [2, 1], [1, 0]]);
        let corners = [0, 1, 2, 0, 1, 3, 2, 1, 1, 0, 3, 2];
        list.assemble(Topology::List, &corners, Some(7)).unwrap();
        assert_eq!(list.triangles, [[0, 1, 2], [0, 3, 2]]);
        assert_eq!((list.lines, list.stitches), (vec![7, 7], 0));
        let told = list.flat.told("flat").unwrap();
        assert_eq!(told, "flat: 2, the first in line 7");
        assert_eq!(Tally::default().told("flat"), None);
    }

    #[test]
    fn sharing_counts_each_vertex_once() {
        // Two triangles with a common edge, and a vertex that nothing uses.
        let sharing = Sharing::of(5, &[[0, 1, 2], [2, 1, 3]], 4, 0);
        assert_eq!((sharing.vertices, sharing.primitives), (5, 2));
        assert_eq!((sharing.vertex_operations, sharing.replicated_operations), (4, 6));
        assert_eq!((sharing.bytes, sharing.replicated_bytes), (5 * 32 + 16, 6 * 32));
    }
}
