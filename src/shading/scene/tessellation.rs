//! A scene as vertices and triangles, for values that are computed per vertex and interpolated.
//!
//! There are two forms. A [`Tessellation`] has texture frames at its vertices, as the emboss needs
//! them; since each mesh triangle has its own dP/du, it has its own vertices. An [`Assembly`] has
//! only what triangles share, each vertex once.
//!
//! Planes and faces of cubes become grids of `tessellation` by `tessellation` squares. A sphere
//! becomes a grid of `tessellation` rows (at least 2) from pole to pole and twice as many columns.
//! Each row is a strip of triangles, two per square; at a pole a square is one triangle, whose tip
//! has the azimuth of the square's middle. Mesh triangles stay as they are. The weights of a
//! pixel's corners are those of the point that its ray meets, so interpolation with them is
//! perspective-correct.

use super::Scene;
use super::assembly::{SharedVertex, Sharing, Topology};
use super::trace::{self, Face, Place, Rays, Surfaces};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::number::trig::Real;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// The most triangles of a scene.
const MAX_TRIANGLES: u64 = 1 << 22;

/// A vertex, in the world.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vertex {
    /// Its position.
    pub position: DVec3,
    /// Unit normal N.
    pub normal: DVec3,
    /// Unit vector T, along which u grows; perpendicular to N.
    pub tangent: DVec3,
    /// Unit vector B = h (N × T), along which v grows.
    pub binormal: DVec3,
    /// Handedness h, +1 or -1: -1 where the texture is mirrored.
    pub handedness: f64,
    /// u and v.
    pub uv: DVec2,
    /// Index of its object.
    pub object: u32,
}

/// A scene's surfaces as triangles with texture frames.
#[derive(Clone, Debug)]
pub struct Tessellation {
    /// All vertices.
    pub vertices: Vec<Vertex>,
    triangles: Triangles,
}

/// A scene's surfaces as triangles that share vertices.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// All vertices, in the world, each once.
    pub vertices: Vec<SharedVertex>,
    /// Words of index buffers.
    indices: u64,
    /// Triangles left out of strips.
    stitches: u64,
    triangles: Triangles,
}

/// Triangles between numbered vertices, and the surfaces that rays intersect.
#[derive(Clone, Debug)]
struct Triangles {
    /// Vertices of each triangle, counter-clockwise seen from the side of their normals.
    corners: Vec<[u32; 3]>,
    surfaces: Surfaces,
}

/// What pixels see of triangles, as columns: entry `i` of each column belongs to one pixel.
#[derive(Clone, Default, Debug)]
pub struct Seen {
    /// Index of the pixel, `row * width + column`, row 0 on top; increasing.
    pub pixel: Vec<u32>,
    /// Number of the triangle.
    pub triangle: Vec<u32>,
    /// The triangle's vertices.
    pub corners: Vec<[u32; 3]>,
    /// The weight of each vertex; they add up to 1.
    pub weights: Vec<[f64; 3]>,
}

impl Seen {
    /// Number of pixels.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pixel.len()
    }

    /// True if no pixel is covered.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pixel.is_empty()
    }

    /// Interpolates a per-vertex value between a pixel's corners.
    ///
    /// # Panics
    /// If there are fewer pixels, or `of` has no value for a vertex.
    #[must_use]
    pub fn between(&self, i: usize, of: impl Fn(usize) -> f64) -> f64 {
        let pairs = self.corners[i].iter().zip(self.weights[i]);
        pairs.map(|(corner, weight)| weight * of(cast::index_of_u32(*corner))).sum()
    }
}

impl Scene {
    /// Its surfaces as triangles with texture frames.
    ///
    /// # Errors
    /// If there are more than 2^22 triangles.
    pub fn tessellate(&self) -> Result<Tessellation> {
        let vertex = |seen: &trace::Seen| Vertex {
            position: seen.position,
            normal: seen.normal,
            tangent: seen.tangent,
            binormal: seen.handedness * seen.normal.cross(seen.tangent),
            handedness: seen.handedness,
            uv: seen.uv,
            object: seen.object,
        };
        let shared = |v: &Vertex| SharedVertex { position: v.position, normal: v.normal, uv: v.uv };
        let mut grower = self.grow(vertex, shared)?;
        for face in self.surfaces.faces.iter().filter(|face| face.place.triangle) {
            let corners = [DVec2::ZERO, DVec2::X, DVec2::Y].map(|at| grower.vertex(&face.at(at)));
            grower.triangle(face.place.object, corners);
        }
        let (vertices, triangles) = (std::mem::take(&mut grower.vertices), grower.done());
        Ok(Tessellation { vertices, triangles })
    }

    /// Its surfaces as triangles that share vertices: those of the grids, and those of meshes as in
    /// their files.
    ///
    /// # Errors
    /// If there are more than 2^22 triangles.
    pub fn assemble(&self) -> Result<Assembly> {
        let vertex = |seen: &trace::Seen| SharedVertex {
            position: seen.position,
            normal: seen.normal,
            uv: seen.uv,
        };
        let mut grower = self.grow(vertex, |vertex| *vertex)?;
        for placed in &self.surfaces.meshes {
            let first = cast::id_of(grower.vertices.len());
            grower.vertices.extend(&placed.vertices);
            for corners in &placed.triangles {
                grower.triangle(placed.object, corners.map(|corner| first + corner));
            }
            grower.indices += placed.indices;
            grower.stitches += placed.stitches;
        }
        let (indices, stitches) = (grower.indices, grower.stitches);
        let (vertices, triangles) = (std::mem::take(&mut grower.vertices), grower.done());
        Ok(Assembly { vertices, indices, stitches, triangles })
    }

    /// Builds the grids of everything that isn't a mesh.
    fn grow<V>(
        &self,
        make: fn(&trace::Seen) -> V,
        shared: fn(&V) -> SharedVertex,
    ) -> Result<Grower<V>> {
        let parts = u64::from(self.emboss.tessellation);
        let per_face = |face: &Face| if face.place.triangle { 1 } else { 2 * parts * parts };
        let count: u64 = self.surfaces.faces.iter().map(per_face).sum::<u64>()
            + 4 * parts * parts * cast::count_of(self.surfaces.balls.len());
        if count > MAX_TRIANGLES {
            return Err(Error::usage(format!(
                "the scene has {count} triangles at `tessellation` = {parts}: legal are at most {MAX_TRIANGLES}; lower it in [emboss]"
            )));
        }
        let parts = self.emboss.tessellation;
        let mut grower = Grower {
            make,
            shared,
            vertices: Vec::new(),
            corners: Vec::new(),
            faces: Vec::new(),
            indices: 0,
            stitches: 0,
        };
        for face in self.surfaces.faces.iter().filter(|face| !face.place.triangle) {
            let part = |i: u32| f64::from(i) / f64::from(parts);
            let at = |i: u32, j: u32| face.at(DVec2::new(part(i), part(j)));
            grower.grid(face.place.object, [parts, parts], |grower, i, j| grower.vertex(&at(i, j)));
        }
        for ball in &self.surfaces.balls {
            let rows = parts.max(2);
            let columns = 2 * rows;
            let at = |column: f64, row: u32| {
                let (u, v) = (column / f64::from(columns), f64::from(row) / f64::from(rows));
                let turns = [u, 0.5 * (1.0 - v)];
                let (mut sin, mut cos) = ([0.0; 2], [0.0; 2]);
                f64::sin_cos_turns(&turns, &mut sin, &mut cos);
                let point = DVec3::new(sin[1] * cos[0], sin[1] * sin[0], cos[1]);
                ball.seen(point, DVec3::new(-sin[0], cos[0], 0.0), DVec2::new(u, v))
            };
            grower.grid(ball.object, [columns, rows], |grower, i, j| {
                // At a pole, the tip of a square's one triangle is its first corner there, or its
                // last.
                let middle = match j {
                    0 => 0.5,
                    j if j == rows => -0.5,
                    _ => 0.0,
                };
                grower.vertex(&at(f64::from(i) + middle, j))
            });
        }
        Ok(grower)
    }
}

/// The vertices and triangles built so far.
struct Grower<V> {
    make: fn(&trace::Seen) -> V,
    shared: fn(&V) -> SharedVertex,
    vertices: Vec<V>,
    corners: Vec<[u32; 3]>,
    faces: Vec<Face>,
    indices: u64,
    stitches: u64,
}

impl<V> Grower<V> {
    fn vertex(&mut self, seen: &trace::Seen) -> u32 {
        self.vertices.push((self.make)(seen));
        cast::id_of(self.vertices.len() - 1)
    }

    /// The squares of a grid of vertices: each row is a strip with two triangles per square, or one
    /// if the other has no area.
    fn grid(
        &mut self,
        object: u32,
        [columns, rows]: [u32; 2],
        vertex: impl Fn(&mut Self, u32, u32) -> u32,
    ) {
        let first = cast::id_of(self.vertices.len());
        for j in 0..=rows {
            for i in 0..=columns {
                vertex(self, i, j);
            }
        }
        let id = |i: u32, j: u32| first + j * (columns + 1) + i;
        for j in 0..rows {
            // Upper and lower ends alternate: at the lower pole the second triangle of a square has
            // no area, at the upper pole the first.
            let strip: Vec<u32> = (0..=columns).flat_map(|i| [id(i, j + 1), id(i, j)]).collect();
            self.indices += cast::count_of(strip.len());
            let count = Topology::Strip.triangles(strip.len()).expect("bug: a square has corners");
            for triangle in 0..count {
                let corners = Topology::Strip.corners(triangle).map(|place| strip[place]);
                self.stitches += u64::from(!self.triangle(object, corners));
            }
        }
    }

    /// Adds a triangle; returns false if it has no area.
    fn triangle(&mut self, object: u32, corners: [u32; 3]) -> bool {
        let of = corners.map(|corner| (self.shared)(&self.vertices[cast::index_of_u32(corner)]));
        let place = Place { object, number: 0, triangle: true };
        let points = of.map(|vertex| vertex.position);
        let face = Face::new(place, points, of.map(|v| v.uv), of.map(|v| v.normal));
        if !face.has_area() {
            return false;
        }
        let [a, b, c] = corners;
        // A face orders its corners so that it is seen from the side of its normals.
        let turned = face.points[1] != points[1];
        self.corners.push(if turned { [a, c, b] } else { corners });
        self.faces.push(face);
        true
    }

    fn done(self) -> Triangles {
        let Self { corners, faces, .. } = self;
        Triangles { corners, surfaces: Surfaces::over(faces, Vec::new()) }
    }
}

impl Tessellation {
    /// What the pixels of some rows see, in order; pixels that see nothing are left out. Replaces
    /// the contents of `seen`.
    pub fn trace(&self, scene: &Scene, rows: Range<u32>, seen: &mut Seen) {
        self.triangles.trace(scene, rows, seen);
    }
}

impl Assembly {
    /// Vertices of each triangle, by number; counter-clockwise seen from the side of their normals.
    #[must_use]
    pub fn primitives(&self) -> &[[u32; 3]] {
        &self.triangles.corners
    }

    /// Index of a triangle's object.
    ///
    /// # Panics
    /// If there are fewer triangles.
    #[must_use]
    pub fn object(&self, triangle: u32) -> u32 {
        self.triangles.surfaces.faces[cast::index_of_u32(triangle)].place.object
    }

    /// Texture coordinates of a pixel, by the same arithmetic as in [`Scene::trace`]: for mesh
    /// triangles they are bit-identical, so that both see the same texel on a border of two.
    ///
    /// # Panics
    /// If there are fewer pixels.
    #[must_use]
    pub fn uv(&self, seen: &Seen, i: usize) -> DVec2 {
        let [_, s, r] = seen.weights[i];
        self.triangles.surfaces.faces[cast::index_of_u32(seen.triangle[i])].uv(DVec2::new(s, r))
    }

    /// What vertex sharing saves.
    #[must_use]
    pub fn sharing(&self) -> Sharing {
        Sharing::of(self.vertices.len(), self.primitives(), self.indices, self.stitches)
    }

    /// As [`Tessellation::trace`].
    pub fn trace(&self, scene: &Scene, rows: Range<u32>, seen: &mut Seen) {
        self.triangles.trace(scene, rows, seen);
    }
}

impl Triangles {
    fn trace(&self, scene: &Scene, rows: Range<u32>, seen: &mut Seen) {
        seen.pixel.clear();
        seen.triangle.clear();
        seen.corners.clear();
        seen.weights.clear();
        let rays = Rays::new(&scene.camera, &scene.image);
        for y in rows.start..rows.end.min(scene.image.height) {
            for x in 0..scene.image.width {
                let Some((_, triangle, at)) = self.surfaces.meet(&rays.through(x, y)) else {
                    continue;
                };
                seen.pixel.push(y * scene.image.width + x);
                seen.triangle.push(triangle);
                seen.corners.push(self.corners[cast::index_of_u32(triangle)]);
                seen.weights.push([1.0 - at.x - at.y, at.x, at.y]);
            }
        }
    }
}
