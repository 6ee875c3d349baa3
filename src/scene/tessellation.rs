//! A scene as vertices and triangles, for what is computed per vertex and interpolated: the emboss.
//!
//! Planes and faces of cubes become grids of `tessellation` by `tessellation` squares, a sphere one of
//! `tessellation` rows (2 at least) from pole to pole and twice as many columns, each square two triangles; at a pole
//! a square is one triangle, whose tip has the azimuth of the square's middle. Triangles of meshes stay
//! as they are, each with vertices of its own. The weights of a pixel's corners are those of the place that
//! its ray meets, so what is interpolated with them is right in perspective.

use super::Scene;
use super::trace::{Face, Place, Rays, Surfaces};
use crate::cast;
use crate::error::{Error, Result};
use crate::trig::Real;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// Most triangles of a scene.
const MAX_TRIANGLES: u64 = 1 << 22;

/// A vertex, in the world.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vertex {
    /// Where it is.
    pub position: DVec3,
    /// Unit normal N.
    pub normal: DVec3,
    /// Unit vector T, along which u grows, at right angles to N.
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

/// A scene's surfaces as triangles.
#[derive(Clone, Debug)]
pub struct Tessellation {
    /// All vertices.
    pub vertices: Vec<Vertex>,
    /// Vertices of each triangle, by number.
    corners: Vec<[u32; 3]>,
    surfaces: Surfaces,
}

/// What pixels see of triangles, as columns: entry `i` of each belongs to one pixel.
#[derive(Clone, Default, Debug)]
pub struct Seen {
    /// Index of the pixel, `row * width + column`, row 0 on top; increasing.
    pub pixel: Vec<u32>,
    /// The triangle's vertices.
    pub corners: Vec<[u32; 3]>,
    /// What each of them counts; together 1.
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

    /// What is between a pixel's corners of something that vertices have.
    ///
    /// # Panics
    /// If there are fewer pixels, or something lacks a vertex.
    #[must_use]
    pub fn between(&self, i: usize, of: impl Fn(usize) -> f64) -> f64 {
        let pairs = self.corners[i].iter().zip(self.weights[i]);
        pairs.map(|(corner, weight)| weight * of(cast::index_of_u32(*corner))).sum()
    }
}

impl Scene {
    /// Its surfaces as triangles.
    ///
    /// # Errors
    /// If they are more than 2^22.
    pub fn tessellate(&self) -> Result<Tessellation> {
        let parts = u64::from(self.emboss.tessellation);
        let per_face = |face: &Face| if face.place.triangle { 1 } else { 2 * parts * parts };
        let count: u64 = self.surfaces.faces.iter().map(per_face).sum::<u64>()
            + 4 * parts * parts * cast::count_of(self.surfaces.balls.len());
        if count > MAX_TRIANGLES {
            return Err(Error::usage(format!(
                "the scene has {count} triangles at `tessellation` = {parts}: legal are {MAX_TRIANGLES}; lower it in [emboss]"
            )));
        }
        let parts = self.emboss.tessellation;
        let mut grower = Grower::default();
        for face in &self.surfaces.faces {
            if face.place.triangle {
                let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
                let corners = corners.map(|at| grower.vertex(&face.at(at)));
                grower.triangle(corners);
                continue;
            }
            let part = |i: u32| f64::from(i) / f64::from(parts);
            let at = |i: u32, j: u32| face.at(DVec2::new(part(i), part(j)));
            grower.grid(parts, parts, |grower, i, j| grower.vertex(&at(i, j)));
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
            grower.grid(columns, rows, |grower, i, j| {
                // Of a square's one triangle at a pole, the tip is its first corner there, or its last.
                let middle = match j {
                    0 => 0.5,
                    j if j == rows => -0.5,
                    _ => 0.0,
                };
                grower.vertex(&at(f64::from(i) + middle, j))
            });
        }
        Ok(grower.done())
    }
}

/// Vertices and triangles so far.
#[derive(Default)]
struct Grower {
    vertices: Vec<Vertex>,
    corners: Vec<[u32; 3]>,
    faces: Vec<Face>,
}

impl Grower {
    fn vertex(&mut self, seen: &super::trace::Seen) -> u32 {
        self.vertices.push(Vertex {
            position: seen.position,
            normal: seen.normal,
            tangent: seen.tangent,
            binormal: seen.handedness * seen.normal.cross(seen.tangent),
            handedness: seen.handedness,
            uv: seen.uv,
            object: seen.object,
        });
        cast::id_of(self.vertices.len() - 1)
    }

    /// Squares of a grid of vertices, row by row, each two triangles or one if the other has no area.
    fn grid(&mut self, columns: u32, rows: u32, vertex: impl Fn(&mut Self, u32, u32) -> u32) {
        let first = cast::id_of(self.vertices.len());
        for j in 0..=rows {
            for i in 0..=columns {
                vertex(self, i, j);
            }
        }
        let id = |i: u32, j: u32| first + j * (columns + 1) + i;
        for j in 0..rows {
            for i in 0..columns {
                // At the lower pole the first of these has no area, at the upper one the second.
                self.triangle([id(i, j), id(i + 1, j), id(i + 1, j + 1)]);
                self.triangle([id(i, j), id(i + 1, j + 1), id(i, j + 1)]);
            }
        }
    }

    fn triangle(&mut self, corners: [u32; 3]) {
        let of = corners.map(|corner| self.vertices[cast::index_of_u32(corner)]);
        let place = Place { object: of[0].object, number: 0, triangle: true };
        let points = of.map(|vertex| vertex.position);
        let face = Face::new(place, points, of.map(|v| v.uv), of.map(|v| v.normal));
        if !face.has_area() {
            return;
        }
        let [a, b, c] = corners;
        // A face turns its corners so that it is met from the side of its normals.
        let turned = face.points[1] != points[1];
        self.corners.push(if turned { [a, c, b] } else { corners });
        self.faces.push(face);
    }

    fn done(self) -> Tessellation {
        let Self { vertices, corners, faces } = self;
        Tessellation { vertices, corners, surfaces: Surfaces::over(faces, Vec::new()) }
    }
}

impl Tessellation {
    /// What the pixels of some rows see, in order; pixels that see nothing are left out. Replaces what
    /// `seen` held.
    pub fn trace(&self, scene: &Scene, rows: Range<u32>, seen: &mut Seen) {
        seen.pixel.clear();
        seen.corners.clear();
        seen.weights.clear();
        let rays = Rays::new(&scene.camera, &scene.image);
        for y in rows.start..rows.end.min(scene.image.height) {
            for x in 0..scene.image.width {
                let Some((_, triangle, at)) = self.surfaces.meet(&rays.through(x, y)) else {
                    continue;
                };
                seen.pixel.push(y * scene.image.width + x);
                seen.corners.push(self.corners[cast::index_of_u32(triangle)]);
                seen.weights.push([1.0 - at.x - at.y, at.x, at.y]);
            }
        }
    }
}
