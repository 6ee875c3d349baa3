//! Normals where a mesh has none: those of its triangles, or means of them.
//!
//! The mean at a corner is over the triangles around its point, each weighted by its angle there
//! (Thürmer and Wüthrich, "Computing vertex normals from polygonal facets", 1998), so it doesn't
//! depend on how a surface is cut into triangles. It ends at creases: edges at which the normals of
//! the two triangles differ by more than an angle, and edges of a single triangle or of more than
//! [`MOST`]. Points with equal coordinates count as one, however often a file has them: a texture
//! seam isn't a crease. A vertex at a crease has a normal on each side, and so becomes several
//! vertices. All of this applies to the mesh as its file places it, before an object's `scale`.

use super::assembly::{Mesh, SharedVertex};
use crate::base::cast;
use crate::number::trig::{atan2, sin_cos_turns};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// Replaces the normals that a mesh lacks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Normals {
    /// A mean at each corner.
    Means,
    /// The normal of each triangle: vertices have 0 and stay shared.
    Facets,
}

/// Crease angle of an object that names none and whose file format has no other default, in
/// degrees: cubes (90) and octahedra (71) keep their edges, a cylinder of seven sides (51) is
/// round.
pub(super) const CREASE_DEGREES: f64 = 60.0;

/// The most triangles of an edge that isn't a crease: they are compared in pairs.
const MOST: usize = 8;
/// Tolerance of a cosine: triangles at exactly the crease angle are within it.
const ROUNDING: f64 = 1e-12;
/// Cosine above which two triangles are in one plane, up to rounding.
const PLANE: f64 = 1.0 - 1e-15;
/// Cosine to a triangle's own normal below which a mean is discarded: it lies in the triangle's
/// plane or behind it.
const BEHIND: f64 = 1e-6;

/// The vertices of a mesh, all with a normal, and its triangles, in order.
pub(super) fn completed(
    mesh: &Mesh,
    crease_degrees: f64,
    normals: Normals,
) -> (Vec<SharedVertex>, Vec<[u32; 3]>) {
    let whole = mesh.vertices.iter().map(|vertex| SharedVertex {
        position: vertex.position,
        normal: vertex.normal.unwrap_or(DVec3::ZERO),
        uv: vertex.uv.unwrap_or(DVec2::ZERO),
    });
    let mut vertices: Vec<SharedVertex> = whole.collect();
    let mut triangles = mesh.triangles.clone();
    if normals == Normals::Facets || corners_without(mesh) == 0 {
        return (vertices, triangles);
    }
    let made = means(mesh, crease_degrees);
    // The vertex for each normal that a vertex without one gets; the first normal stays at the
    // vertex.
    let mut known: HashMap<(u32, [u64; 3]), u32> = HashMap::new();
    for (corner, normal) in triangles.as_flattened_mut().iter_mut().zip(made) {
        let number = cast::index_of_u32(*corner);
        if mesh.vertices[number].normal.is_some() {
            continue;
        }
        let key = (*corner, normal.to_array().map(f64::to_bits));
        *corner = *known.entry(key).or_insert_with(|| {
            if vertices[number].normal == DVec3::ZERO {
                vertices[number].normal = normal;
                return *corner;
            }
            vertices.push(SharedVertex { normal, ..vertices[number] });
            cast::id_of(vertices.len() - 1)
        });
    }
    (vertices, triangles)
}

/// Number of triangle corners without a normal.
pub(super) fn corners_without(mesh: &Mesh) -> u64 {
    let lacks = |triangle: &[u32; 3]| {
        mesh.corners(*triangle).iter().filter(|vertex| vertex.normal.is_none()).count()
    };
    cast::count_of(mesh.triangles.iter().map(lacks).sum())
}

/// A unit normal for each corner of each triangle.
fn means(mesh: &Mesh, crease_degrees: f64) -> Vec<DVec3> {
    let positions: Vec<[DVec3; 3]> =
        mesh.triangles.iter().map(|t| mesh.corners(*t).map(|vertex| vertex.position)).collect();
    // A triangle with some normals faces the side of those.
    let facet = |(triangle, [a, b, c]): (&[u32; 3], &[DVec3; 3])| {
        let given = mesh.corners(*triangle).map(|v| v.normal.unwrap_or_default());
        let side: DVec3 = given.into_iter().map(DVec3::normalize_or_zero).sum();
        let facet = (b - a).cross(c - a).normalize();
        if facet.dot(side) < 0.0 { -facet } else { facet }
    };
    let mut facets: Vec<DVec3> = mesh.triangles.iter().zip(&positions).map(facet).collect();
    let (smooth, mut planes) = joined(&positions, &facets, crease_degrees);
    // One normal for a plane, to the last bit, so that flat areas stay flat.
    for triangle in 0..facets.len() {
        facets[triangle] = facets[planes.first(triangle)];
    }
    let mut sums: Vec<Mean> = vec![Mean::default(); 3 * facets.len()];
    let corners = || (0..facets.len()).flat_map(|t| [0, 1, 2].map(|k| (t, k)));
    let mut smooth = smooth;
    for (triangle, k) in corners() {
        let [at, next, last] = [0, 1, 2].map(|i| positions[triangle][(k + i) % 3]);
        let (e1, e2) = (next - at, last - at);
        let angle = atan2(e1.cross(e2).length(), e1.dot(e2));
        sums[smooth.first(3 * triangle + k)].add(facets[triangle], angle);
    }
    let normal = |(triangle, k): (usize, usize)| {
        let own = facets[triangle];
        let mean = sums[smooth.first(3 * triangle + k)].normal();
        if mean.dot(own) < BEHIND { own } else { mean }
    };
    corners().map(normal).collect()
}

/// A weighted mean of normals.
#[derive(Clone, Copy, Default)]
struct Mean {
    sum: DVec3,
    first: DVec3,
    /// True if they aren't all equal.
    mixed: bool,
}

impl Mean {
    fn add(&mut self, normal: DVec3, weight: f64) {
        if self.first == DVec3::ZERO {
            self.first = normal;
        }
        self.mixed |= normal != self.first;
        self.sum += weight * normal;
    }

    /// The unit mean; 0 where they cancel.
    fn normal(&self) -> DVec3 {
        if self.mixed { self.sum.normalize_or_zero() } else { self.first }
    }
}

/// Which corners (three per triangle) share a mean, and which triangles share a plane.
fn joined(positions: &[[DVec3; 3]], facets: &[DVec3], crease_degrees: f64) -> (Sets, Sets) {
    let mut points: HashMap<[u64; 3], u32> = HashMap::new();
    let mut point = |at: DVec3| {
        let next = cast::id_of(points.len());
        // -0 is 0.
        *points.entry((at + DVec3::ZERO).to_array().map(f64::to_bits)).or_insert(next)
    };
    let points: Vec<[u32; 3]> = positions.iter().map(|of| of.map(&mut point)).collect();
    // For each edge of each triangle: its ends, the lower point first, and the corners there.
    let mut edges: Vec<([u32; 2], [usize; 2])> = Vec::with_capacity(3 * points.len());
    for (triangle, of) in points.iter().enumerate() {
        for (k, l) in [(0, 1), (1, 2), (2, 0)] {
            let (k, l) = if of[k] < of[l] { (k, l) } else { (l, k) };
            edges.push(([of[k], of[l]], [3 * triangle + k, 3 * triangle + l]));
        }
    }
    edges.sort_unstable();
    let (mut smooth, mut planes) = (Sets::new(3 * points.len()), Sets::new(points.len()));
    let (_, cosine) = sin_cos_turns(crease_degrees / 360.0);
    let least = cosine - ROUNDING;
    for around in edges.chunk_by(|a, b| a.0 == b.0).filter(|around| around.len() <= MOST) {
        for (i, (_, [a, b])) in around.iter().enumerate() {
            for (_, [c, d]) in &around[..i] {
                let cosine = facets[a / 3].dot(facets[c / 3]);
                if cosine >= least {
                    smooth.join(*a, *c);
                    smooth.join(*b, *d);
                }
                if cosine >= PLANE {
                    planes.join(a / 3, c / 3);
                }
            }
        }
    }
    (smooth, planes)
}

/// Disjoint sets of numbers.
struct Sets(Vec<usize>);

impl Sets {
    fn new(len: usize) -> Self {
        Self((0..len).collect())
    }

    /// The smallest number in a number's set.
    fn first(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b)] = a.min(b);
    }
}
