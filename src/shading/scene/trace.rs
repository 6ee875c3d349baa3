//! The pixels that a scene covers: rays against faces and spheres, and the surface where they meet.

use super::assembly::{Mesh, SharedVertex, has_area, is_area};
use super::normals::{self, Normals};
use super::{Camera, Image, Projection, Scene};
use crate::base::cast;
use crate::number::trig::Real;
use glam::{DMat3, DVec2, DVec3};
use std::array;
use std::collections::HashSet;
use std::f64::consts::{PI, TAU};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

/// Face number of a fragment whose face isn't flat: its normal varies from pixel to pixel.
pub const CURVED: u32 = u32::MAX;

/// Faces are enlarged by this fraction of their edges, so that neighbours leave no crack.
const EDGE: f64 = 1e-9;

/// Triangles or balls in a leaf of the tree.
const LEAF: usize = 4;
/// The most faces and spheres that the rays of one picture may test together: about a minute's
/// work.
const MAX_TRIES: u64 = 1 << 33;
/// Columns and rows of probe rays, which are tested first.
const PROBES: u32 = 32;
/// The largest depth of the tree: every level halves, and there are fewer than 2^32 primitives.
const DEPTH: usize = 40;

/// What pixels see, as columns: entry `i` of each column belongs to one pixel. Reused without
/// allocation.
#[derive(Clone, Default, Debug)]
pub struct Fragments {
    /// Index of the pixel, `row * width + column`, row 0 on top; increasing.
    pub pixel: Vec<u32>,
    /// Index of the object, in the order of the scene file.
    pub object: Vec<u32>,
    /// Number of the flat face in its object, or [`CURVED`].
    pub face: Vec<u32>,
    /// Position in the world: x, y, z.
    pub position: [Vec<f64>; 3],
    /// Unit normal N.
    pub normal: [Vec<f64>; 3],
    /// Unit vector T, perpendicular to N.
    pub tangent: [Vec<f64>; 3],
    /// Handedness h, +1 or -1: B = h (N x T).
    pub handedness: Vec<f64>,
    /// Unit vector V to the eye.
    pub eye: [Vec<f64>; 3],
    /// Index of the face in [`Scene::faces`], or [`CURVED`] on a sphere.
    pub primitive: Vec<u32>,
    /// Weights of the face's second and third corner; the first has the remainder to 1.
    pub weights: [Vec<f64>; 2],
    /// Index of the texel in the texture.
    pub texel: Vec<u32>,
    /// Index of the texel in the bump vector map.
    pub bump: Vec<u32>,
}

impl Fragments {
    /// Number of fragments.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pixel.len()
    }

    /// True if no pixel is covered.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pixel.is_empty()
    }

    /// Removes all fragments and keeps their memory.
    pub fn clear(&mut self) {
        self.pixel.clear();
        self.object.clear();
        self.face.clear();
        self.handedness.clear();
        self.primitive.clear();
        self.weights.iter_mut().for_each(Vec::clear);
        self.texel.clear();
        self.bump.clear();
        for vectors in [&mut self.position, &mut self.normal, &mut self.tangent, &mut self.eye] {
            vectors.iter_mut().for_each(Vec::clear);
        }
    }

    /// Entry `i` of three columns, such as [`Self::normal`].
    ///
    /// # Panics
    /// If there are fewer entries.
    #[must_use]
    pub fn vector(columns: &[Vec<f64>; 3], i: usize) -> DVec3 {
        DVec3::new(columns[0][i], columns[1][i], columns[2][i])
    }

    /// B of fragment `i`.
    ///
    /// # Panics
    /// If there are fewer fragments.
    #[must_use]
    pub fn bitangent(&self, i: usize) -> DVec3 {
        let cross = Self::vector(&self.normal, i).cross(Self::vector(&self.tangent, i));
        self.handedness[i] * cross
    }
}

fn push(columns: &mut [Vec<f64>; 3], vector: DVec3) {
    for (column, component) in columns.iter_mut().zip(vector.to_array()) {
        column.push(component);
    }
}

impl Scene {
    /// Corners of all faces in the world, with the index of their object: for planes and cubes
    /// those at (u, v) = (0, 0), (1, 0) and (0, 1), for meshes the triangles. They run
    /// counter-clockwise seen from the side of their normals.
    pub fn faces(&self) -> impl Iterator<Item = (u32, [SharedVertex; 3])> + '_ {
        let corner = |face: &Face, i: usize| SharedVertex {
            position: face.points[i],
            normal: face.normals[i],
            uv: face.uvs[i],
        };
        let of = move |face: &Face| (face.place.object, [0, 1, 2].map(|i| corner(face, i)));
        self.surfaces.faces.iter().map(of)
    }

    /// The unit vector V from a point to the eye; 0 at the eye itself.
    #[must_use]
    pub fn to_eye(&self, point: DVec3) -> DVec3 {
        Rays::new(&self.camera, &self.image).to_eye(point)
    }

    /// What the pixels of some rows see, in order; pixels that see no object are left out. Replaces
    /// the contents of `fragments`. Rows below the image have no pixels.
    pub fn trace(&self, rows: Range<u32>, fragments: &mut Fragments) {
        fragments.clear();
        let rays = Rays::new(&self.camera, &self.image);
        for y in rows.start..rows.end.min(self.image.height) {
            for x in 0..self.image.width {
                let ray = rays.through(x, y);
                let Some((t, i, place)) = self.surfaces.meet(&ray) else { continue };
                let seen = self.surfaces.at(&ray, t, i, place);
                let is_face = cast::index_of_u32(i) < self.surfaces.faces.len();
                fragments.primitive.push(if is_face { i } else { CURVED });
                fragments.weights[0].push(place.x);
                fragments.weights[1].push(place.y);
                fragments.pixel.push(y * self.image.width + x);
                fragments.object.push(seen.object);
                fragments.face.push(seen.face);
                push(&mut fragments.position, seen.position);
                push(&mut fragments.normal, seen.normal);
                push(&mut fragments.tangent, seen.tangent);
                fragments.handedness.push(seen.handedness);
                push(&mut fragments.eye, rays.to_eye(seen.position));
                fragments.texel.push(self.texture.texel(seen.uv.x, seen.uv.y));
                fragments.bump.push(self.bumps.texel(seen.uv.x, seen.uv.y));
            }
        }
    }
}

/// The rays of a camera.
pub(super) struct Rays {
    eye: DVec3,
    forward: DVec3,
    /// From the middle of the image to its right and upper border, where a = w/h and b = 1.
    right: DVec3,
    top: DVec3,
    perspective: bool,
    width: f64,
    height: f64,
}

/// A ray; its direction has any length.
pub(super) struct Ray {
    origin: DVec3,
    direction: DVec3,
}

impl Rays {
    pub(super) fn new(camera: &Camera, image: &Image) -> Self {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up.normalize()).normalize();
        let top = right.cross(forward);
        let (reach, perspective) = match camera.projection {
            Projection::Perspective { fov_degrees } => (libm::tan(fov_degrees * PI / 360.0), true),
            Projection::Orthographic { height } => (0.5 * height, false),
        };
        let (width, height) = (f64::from(image.width), f64::from(image.height));
        let (right, top) = (right * (reach * width / height), top * reach);
        Self { eye: camera.eye, forward, right, top, perspective, width, height }
    }

    pub(super) fn through(&self, x: u32, y: u32) -> Ray {
        let a = 2.0 * (f64::from(x) + 0.5) / self.width - 1.0;
        let b = 1.0 - 2.0 * (f64::from(y) + 0.5) / self.height;
        let aside = self.right * a + self.top * b;
        if self.perspective {
            Ray { origin: self.eye, direction: self.forward + aside }
        } else {
            Ray { origin: self.eye + aside, direction: self.forward }
        }
    }

    fn to_eye(&self, position: DVec3) -> DVec3 {
        if self.perspective { (self.eye - position).normalize_or_zero() } else { -self.forward }
    }
}

/// A shape before it is placed.
#[derive(Debug)]
pub(super) enum Shape {
    Plane,
    Cube,
    Sphere,
    Mesh {
        /// The file that it comes from.
        file: PathBuf,
        /// Shared by objects of the same file.
        mesh: Arc<Mesh>,
        /// Edges up to this angle are smooth where normals are computed.
        crease_degrees: f64,
    },
}

/// Position, orientation and size of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    linear: DMat3,
    offset: DVec3,
}

impl Placement {
    /// Scales along the axes, then rotates about x, y and z in this order, then translates.
    pub(super) fn new(offset: DVec3, rotate_degrees: [f64; 3], scale: DVec3) -> Self {
        let turns = rotate_degrees.map(|degrees| degrees / 360.0);
        let (mut sin, mut cos) = ([0.0; 3], [0.0; 3]);
        // Exact at quarter turns, which radians in the standard library can't be.
        f64::sin_cos_turns(&turns, &mut sin, &mut cos);
        let x = DMat3::from_cols(
            DVec3::X,
            DVec3::new(0.0, cos[0], sin[0]),
            DVec3::new(0.0, -sin[0], cos[0]),
        );
        let y = DMat3::from_cols(
            DVec3::new(cos[1], 0.0, -sin[1]),
            DVec3::Y,
            DVec3::new(sin[1], 0.0, cos[1]),
        );
        let z = DMat3::from_cols(
            DVec3::new(cos[2], sin[2], 0.0),
            DVec3::new(-sin[2], cos[2], 0.0),
            DVec3::Z,
        );
        Self { linear: z * y * x * DMat3::from_diagonal(scale), offset }
    }

    fn point(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.offset
    }
}

/// Why a mesh can't be lit.
#[derive(Debug)]
pub(super) struct Unfit {
    /// The mesh's object.
    pub(super) object: usize,
    /// Line in its file, for text formats.
    pub(super) line: Option<u64>,
    /// The problem.
    pub(super) problem: String,
}

/// All surfaces of a scene, and a tree over them.
#[derive(Clone, Debug)]
pub(super) struct Surfaces {
    pub(super) faces: Vec<Face>,
    pub(super) balls: Vec<Ball>,
    /// The meshes from which triangular faces were assembled.
    pub(super) meshes: Vec<PlacedMesh>,
    /// Faces, then balls, in the order of the tree's leaves; without faces that are hidden
    /// everywhere.
    order: Vec<u32>,
    nodes: Vec<TreeNode>,
}

/// A mesh in the world, and its object.
#[derive(Clone, Debug)]
pub(super) struct PlacedMesh {
    pub(super) object: u32,
    pub(super) vertices: Vec<SharedVertex>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) indices: u64,
    pub(super) stitches: u64,
}

/// A triangle or parallelogram of points a + s (b-a) + r (c-a). Seen from its front, a, b, c run
/// counter-clockwise.
#[derive(Clone, Debug)]
pub(super) struct Face {
    pub(super) place: Place,
    pub(super) points: [DVec3; 3],
    uvs: [DVec2; 3],
    normals: [DVec3; 3],
    /// True if the normals are all equal.
    flat: bool,
}

/// The number of a face, and its kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) object: u32,
    pub(super) number: u32,
    pub(super) triangle: bool,
}

/// A placed sphere.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    pub(super) object: u32,
    linear: DMat3,
    inverse: DMat3,
    offset: DVec3,
    handedness: f64,
}

/// A node of the tree. Its children are the next node and node `next`; a leaf has `len` entries of
/// `order` from `next` on.
#[derive(Clone, Debug)]
struct TreeNode {
    low: DVec3,
    high: DVec3,
    next: u32,
    len: u32,
}

/// The surface that a ray meets.
pub(super) struct Seen {
    pub(super) object: u32,
    face: u32,
    pub(super) position: DVec3,
    pub(super) normal: DVec3,
    pub(super) tangent: DVec3,
    pub(super) handedness: f64,
    pub(super) uv: DVec2,
}

/// The (T, B) of each face of the cube; N = T x B.
const CUBE: [(DVec3, DVec3); 6] = [
    (DVec3::Y, DVec3::Z),
    (DVec3::NEG_Y, DVec3::Z),
    (DVec3::NEG_X, DVec3::Z),
    (DVec3::X, DVec3::Z),
    (DVec3::X, DVec3::Y),
    (DVec3::X, DVec3::NEG_Y),
];

impl Surfaces {
    /// Places shapes; with bumps, every face needs an area in the texture.
    pub(super) fn new(
        objects: &[(Shape, Placement)],
        has_bumps: bool,
        normals: Normals,
    ) -> Result<Self, Unfit> {
        let (mut faces, mut balls, mut meshes) = (Vec::new(), Vec::new(), Vec::new());
        for (i, (shape, placement)) in objects.iter().enumerate() {
            let object = cast::id_of(i);
            let normal_matrix = placement.linear.inverse().transpose();
            let mut square = |number, centre: DVec3, t: DVec3, b: DVec3| {
                let points = [centre - t - b, centre + t - b, centre - t + b];
                let normal = (normal_matrix * t.cross(b)).normalize();
                faces.push(Face::new(
                    Place { object, number, triangle: false },
                    points.map(|point| placement.point(point)),
                    [DVec2::ZERO, DVec2::X, DVec2::Y],
                    [normal; 3],
                ));
            };
            match shape {
                Shape::Plane => square(0, DVec3::ZERO, DVec3::X, DVec3::Y),
                Shape::Cube => {
                    for (number, (t, b)) in (0..).zip(CUBE) {
                        square(number, t.cross(b), t, b);
                    }
                }
                Shape::Sphere => balls.push(Ball {
                    object,
                    linear: placement.linear,
                    inverse: placement.linear.inverse(),
                    offset: placement.offset,
                    handedness: placement.linear.determinant().signum(),
                }),
                Shape::Mesh { mesh, crease_degrees, .. } => {
                    let (vertices, mut triangles) =
                        normals::completed(mesh, *crease_degrees, normals);
                    let placed = |vertex: SharedVertex| SharedVertex {
                        position: placement.point(vertex.position),
                        normal: (normal_matrix * vertex.normal).normalize_or_zero(),
                        uv: vertex.uv,
                    };
                    let vertices: Vec<SharedVertex> = vertices.into_iter().map(placed).collect();
                    // A mirror reverses the winding.
                    if placement.linear.determinant() < 0.0 {
                        triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
                    }
                    for (number, corners) in (0..).zip(&triangles) {
                        let of = corners.map(|corner| vertices[cast::index_of_u32(corner)]);
                        let face = Face::new(
                            Place { object, number, triangle: true },
                            of.map(|vertex| vertex.position),
                            of.map(|vertex| vertex.uv),
                            of.map(|vertex| vertex.normal),
                        );
                        let line = mesh.line(cast::index_of_u32(number));
                        if !face.has_area() {
                            let problem = format!(
                                "triangle {number} (they count from 0) has no area after `scale`: scale the mesh evenly, or remove the triangle"
                            );
                            return Err(Unfit { object: i, line, problem });
                        }
                        if has_bumps && face.uv_determinant() == 0.0 {
                            let problem = format!(
                                "triangle {number} (they count from 0) has no area in the texture, so bumps have no direction: unwrap the mesh, or leave [height] out"
                            );
                            return Err(Unfit { object: i, line, problem });
                        }
                        faces.push(face);
                    }
                    let Mesh { indices, stitches, .. } = **mesh;
                    meshes.push(PlacedMesh { object, vertices, triangles, indices, stitches });
                }
            }
        }
        Ok(Self { meshes, ..Self::over(faces, balls) })
    }

    /// Builds the tree over placed faces and balls.
    pub(super) fn over(faces: Vec<Face>, balls: Vec<Ball>) -> Self {
        let meshes = Vec::new();
        let mut surfaces = Self { faces, balls, meshes, order: Vec::new(), nodes: Vec::new() };
        surfaces.grow();
        surfaces
    }

    pub(super) fn is_right_handed(&self) -> bool {
        self.balls.iter().all(|ball| ball.handedness > 0.0)
            && self.faces.iter().all(|face| face.uv_determinant() >= 0.0)
    }

    /// Builds the tree: splits at the median along the longest side.
    fn grow(&mut self) {
        let boxes: Vec<(DVec3, DVec3)> = self
            .faces
            .iter()
            .map(Face::bounds)
            .chain(self.balls.iter().map(Ball::bounds))
            .collect();
        let middle = |i: u32| {
            let (low, high) = boxes[cast::index_of_u32(i)];
            low + high
        };
        // Of coinciding faces only the first is ever seen.
        let mut seen = HashSet::new();
        let is_first = |i: &u32| match self.faces.get(cast::index_of_u32(*i)) {
            // Adding 0.0 turns -0 into 0.
            Some(Face { points, place, .. }) => seen.insert((
                points.map(|point| point.to_array().map(|x| (x + 0.0).to_bits())),
                place.triangle,
            )),
            None => true,
        };
        self.order = (0..cast::id_of(boxes.len())).filter(is_first).collect();
        // Ranges that still become nodes, and the parent that needs the index of its second child.
        let mut waiting: Vec<(Range<usize>, Option<usize>)> = vec![(0..self.order.len(), None)];
        while let Some((range, parent)) = waiting.pop() {
            let id = self.nodes.len();
            if let Some(parent) = parent {
                self.nodes[parent].next = cast::id_of(id);
            }
            let order = &mut self.order[range.clone()];
            let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let (low, high) = order.iter().fold(empty, |(low, high), i| {
                let (l, h) = boxes[cast::index_of_u32(*i)];
                (low.min(l), high.max(h))
            });
            let len = range.len();
            if len <= LEAF {
                let (next, len) = (cast::id_of(range.start), cast::id_of(len));
                self.nodes.push(TreeNode { low, high, next, len });
                continue;
            }
            self.nodes.push(TreeNode { low, high, next: 0, len: 0 });
            let axis = (high - low).max_position();
            order.select_nth_unstable_by(len / 2, |a, b| {
                middle(*a)[axis].total_cmp(&middle(*b)[axis]).then(a.cmp(b))
            });
            let half = range.start + len / 2;
            waiting.push((half..range.end, Some(id)));
            waiting.push((range.start..half, None));
        }
    }

    /// The surface at a hit of [`Self::meet`].
    fn at(&self, ray: &Ray, t: f64, i: u32, place: DVec2) -> Seen {
        let index = cast::index_of_u32(i);
        match self.faces.get(index) {
            Some(face) => face.at(place),
            None => self.balls[index - self.faces.len()].at(ray, t),
        }
    }

    /// The nearest thing that a ray meets from its front; at equal distances, the first in the
    /// scene. Returns the ray parameter, its number among faces and then balls, and the position on
    /// a face.
    pub(super) fn meet(&self, ray: &Ray) -> Option<(f64, u32, DVec2)> {
        self.meet_counted(ray, &mut 0)
    }

    /// Rejects scenes that would take hours: faces and spheres so close together that rays must
    /// test most of them. Tests some rays and extrapolates to all.
    pub(super) fn check_tries(&self, camera: &Camera, image: &Image) -> Result<(), String> {
        let rays = Rays::new(camera, image);
        let (columns, rows) = (image.width.min(PROBES), image.height.min(PROBES));
        let most = MAX_TRIES / image.pixels() * u64::from(columns * rows);
        let middle = |i: u32, of: u32, side: u32| (2 * i + 1) * side / (2 * of);
        let mut tries = 0;
        for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
            let ray = rays.through(middle(i, columns, image.width), middle(j, rows, image.height));
            self.meet_counted(&ray, &mut tries);
            if tries > most {
                return Err(format!(
                    "faces lie so close together that the rays of a picture would test more than {MAX_TRIES} of them, the most that a picture may take: remove duplicates, or make the picture smaller than {} x {}",
                    image.width, image.height
                ));
            }
        }
        Ok(())
    }

    /// As [`Self::meet`], and counts the primitives tested.
    #[inline]
    fn meet_counted(&self, ray: &Ray, tries: &mut u64) -> Option<(f64, u32, DVec2)> {
        // A direction of 0 along an axis would give NaN at the faces of a box.
        let inverse = DVec3::from_array(
            ray.direction.to_array().map(|d| 1.0 / if d == 0.0 { 1e-300 } else { d }),
        );
        let mut nearest: Option<(f64, u32, DVec2)> = None;
        let mut stack = [0u32; DEPTH];
        let mut top = 1;
        while top > 0 {
            top -= 1;
            let node = &self.nodes[cast::index_of_u32(stack[top])];
            let limit = nearest.map_or(f64::INFINITY, |(t, ..)| t);
            let (a, b) = ((node.low - ray.origin) * inverse, (node.high - ray.origin) * inverse);
            let enter = a.min(b).max_element().max(0.0);
            let leave = a.max(b).min_element();
            // The tolerance keeps surfaces on the box's own border in spite of rounding.
            if enter > leave * (1.0 + 1e-12) || enter > limit {
                continue;
            }
            if node.len == 0 {
                // The child that the ray enters first goes on top.
                let children = [stack[top] + 1, node.next];
                let entry = |child: u32| {
                    let node = &self.nodes[cast::index_of_u32(child)];
                    (0.5 * (node.low + node.high) - ray.origin).dot(ray.direction)
                };
                let (near, far) = if entry(children[0]) <= entry(children[1]) {
                    (children[0], children[1])
                } else {
                    (children[1], children[0])
                };
                stack[top] = far;
                stack[top + 1] = near;
                top += 2;
                continue;
            }
            *tries += u64::from(node.len);
            let start = cast::index_of_u32(node.next);
            for &i in &self.order[start..start + cast::index_of_u32(node.len)] {
                let index = cast::index_of_u32(i);
                let met = match self.faces.get(index) {
                    Some(face) => face.meet(ray),
                    None => {
                        self.balls[index - self.faces.len()].meet(ray).map(|t| (t, DVec2::ZERO))
                    }
                };
                let Some((t, place)) = met else { continue };
                if nearest.is_none_or(|(best, other, _)| t < best || (t == best && i < other)) {
                    nearest = Some((t, i, place));
                }
            }
        }
        nearest
    }
}

impl Face {
    /// A face whose corners are ordered so that its front is the side of its unit normals. A normal
    /// of 0 is replaced by the face's own, on the side of the other normals.
    pub(super) fn new(
        place: Place,
        points: [DVec3; 3],
        uvs: [DVec2; 3],
        normals: [DVec3; 3],
    ) -> Self {
        let square = (points[1] - points[0]).cross(points[2] - points[0]);
        let turned = square.dot(normals[0] + normals[1] + normals[2]) < 0.0;
        let side = if turned { -square } else { square }.normalize_or_zero();
        let own = |normal| if normal == DVec3::ZERO { side } else { normal };
        let normals = normals.map(own);
        let flat = normals[0] == normals[1] && normals[0] == normals[2];
        let mut face = Self { place, points, uvs, normals, flat };
        if turned {
            face.points.swap(1, 2);
            face.uvs.swap(1, 2);
            face.normals.swap(1, 2);
        }
        face
    }

    fn edges(&self) -> [DVec3; 2] {
        [self.points[1] - self.points[0], self.points[2] - self.points[0]]
    }

    fn uv_edges(&self) -> [DVec2; 2] {
        [self.uvs[1] - self.uvs[0], self.uvs[2] - self.uvs[0]]
    }

    pub(super) fn has_area(&self) -> bool {
        has_area(self.points)
    }

    /// Twice the area in the texture, negative where mirrored; 0 if it is negligible.
    fn uv_determinant(&self) -> f64 {
        let [d1, d2] = self.uv_edges();
        let longest = d1.length_squared().max(d2.length_squared()).max(d1.distance_squared(d2));
        let determinant = d1.perp_dot(d2);
        if is_area(determinant.abs(), longest) { determinant } else { 0.0 }
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let [a, b, c] = self.points;
        // A triangle has no fourth corner: one of its own stands in.
        let d = if self.place.triangle { a } else { b + c - a };
        (a.min(b).min(c).min(d), a.max(b).max(c).max(d))
    }

    /// The ray parameter where the ray meets the front, and (s, r) there (Möller and Trumbore).
    #[inline]
    fn meet(&self, ray: &Ray) -> Option<(f64, DVec2)> {
        let [e1, e2] = self.edges();
        let p = ray.direction.cross(e2);
        let determinant = e1.dot(p); // -direction . (e1 x e2)
        if determinant <= 0.0 {
            return None;
        }
        let from_corner = ray.origin - self.points[0];
        let s = from_corner.dot(p) / determinant;
        let q = from_corner.cross(e1);
        let r = ray.direction.dot(q) / determinant;
        let t = e2.dot(q) / determinant;
        let far = if self.place.triangle { s + r } else { s.max(r) };
        let inside = s >= -EDGE && r >= -EDGE && far <= 1.0 + EDGE && t > 0.0;
        inside.then(|| (t, DVec2::new(s, r).clamp(DVec2::ZERO, DVec2::ONE)))
    }

    /// Texture coordinates at (s, r).
    pub(super) fn uv(&self, DVec2 { x: s, y: r }: DVec2) -> DVec2 {
        let [d1, d2] = self.uv_edges();
        self.uvs[0] + s * d1 + r * d2
    }

    pub(super) fn at(&self, DVec2 { x: s, y: r }: DVec2) -> Seen {
        let [e1, e2] = self.edges();
        let normal = if self.flat {
            self.normals[0]
        } else {
            let [a, b, c] = self.normals;
            let sum = a * (1.0 - s - r) + b * s + c * r;
            sum.try_normalize().unwrap_or_else(|| e1.cross(e2).normalize())
        };
        let [d1, d2] = self.uv_edges();
        let determinant = self.uv_determinant();
        let handedness = if determinant < 0.0 { -1.0 } else { 1.0 };
        // Up to a positive factor, the absolute determinant.
        let (dpdu, dpdv) = if determinant == 0.0 {
            (e1, e2)
        } else {
            (handedness * (d2.y * e1 - d1.y * e2), handedness * (d1.x * e2 - d2.x * e1))
        };
        let across = dpdu - normal * normal.dot(dpdu);
        let tangent = if across.length_squared() > 1e-24 * dpdu.length_squared() {
            across.normalize()
        } else {
            (handedness * dpdv.cross(normal)).normalize()
        };
        Seen {
            object: self.place.object,
            face: if self.flat { self.place.number } else { CURVED },
            position: self.points[0] + s * e1 + r * e2,
            normal,
            tangent,
            handedness,
            uv: self.uv(DVec2::new(s, r)),
        }
    }
}

impl Ball {
    fn bounds(&self) -> (DVec3, DVec3) {
        let half = DVec3::from_array(array::from_fn(|i| self.linear.row(i).length()));
        (self.offset - half, self.offset + half)
    }

    /// The ray parameter where the ray meets the ball from outside.
    #[inline]
    fn meet(&self, ray: &Ray) -> Option<f64> {
        let origin = self.inverse * (ray.origin - self.offset);
        let direction = self.inverse * ray.direction;
        let square = direction.length_squared();
        let middle = -origin.dot(direction) / square;
        // The ray's nearest point to the centre: from far away, this keeps more digits than b² -
        // ac.
        let depth = 1.0 - (origin + middle * direction).length_squared();
        let t = middle - (depth / square).sqrt();
        // NaN where the ray misses.
        (t > 0.0).then_some(t)
    }

    fn at(&self, ray: &Ray, t: f64) -> Seen {
        let met = self.inverse * (ray.origin + t * ray.direction - self.offset);
        let p = met.normalize();
        let rho = libm::hypot(p.x, p.y);
        // At a pole the azimuth is 0, whatever the signs of its zeros.
        let (azimuth, east) = if rho == 0.0 {
            (0.0, DVec3::Y)
        } else {
            (libm::atan2(p.y, p.x), DVec3::new(-p.y / rho, p.x / rho, 0.0))
        };
        let turns = azimuth / TAU;
        let u = if turns < 0.0 { turns + 1.0 } else { turns };
        let v = 1.0 - libm::atan2(rho, p.z) / PI;
        self.seen(p, east, DVec2::new(u, v))
    }

    /// The surface at a point `p` of the unit sphere, with its eastward direction.
    pub(super) fn seen(&self, p: DVec3, east: DVec3, uv: DVec2) -> Seen {
        let normal = (self.inverse.transpose() * p).normalize();
        let along = self.linear * east;
        Seen {
            object: self.object,
            face: CURVED,
            position: self.linear * p + self.offset,
            normal,
            tangent: (along - normal * normal.dot(along)).normalize(),
            handedness: self.handedness,
            uv,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::assembly::MeshVertex;
    use super::*;
    use rand_core::{RngCore, SeedableRng};

    /// The tree finds the same as testing everything.
    #[test]
    fn the_tree_finds_the_nearest() {
        let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(5);
        let mut real = || f64::from(random.next_u32()) / 2_147_483_648.0 - 1.0;
        let mut vector = || DVec3::new(real(), real(), real());
        let mut objects = Vec::new();
        let mut mesh = Mesh::default();
        for i in 0..700 {
            let (at, normal) = (vector(), vector().normalize());
            let points = [at, at + 0.2 * vector(), at + 0.2 * vector()];
            for (position, uv) in points.into_iter().zip([DVec2::ZERO, DVec2::X, DVec2::Y]) {
                let (normal, uv) = (Some(normal), Some(uv));
                mesh.vertices.push(MeshVertex { position, normal, uv });
            }
            mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
        }
        let here = Placement::new(DVec3::ZERO, [0.0; 3], DVec3::ONE);
        let (file, mesh) = (PathBuf::new(), Arc::new(mesh));
        objects.push((Shape::Mesh { file, mesh, crease_degrees: 0.0 }, here));
        for _ in 0..30 {
            let placement = Placement::new(vector(), vector().to_array(), DVec3::splat(0.05));
            objects.push((Shape::Sphere, placement));
        }
        // Boxes without thickness, and rays along them.
        objects.push((Shape::Plane, Placement::new(DVec3::ZERO, [0.0; 3], DVec3::splat(0.3))));
        let surfaces = Surfaces::new(&objects, true, Normals::Means).unwrap();
        let mut hits = 0;
        for i in 0..3000 {
            let mut ray = Ray { origin: 2.0 * vector(), direction: vector() };
            ray.direction -= 0.5 * ray.origin;
            if i % 5 == 0 {
                ray.direction[i % 3] = 0.0;
            }
            let faces = surfaces.faces.iter().filter_map(|face| {
                Some((face.meet(&ray)?.0, face.place.object, face.place.number))
            });
            let balls = surfaces
                .balls
                .iter()
                .filter_map(|ball| Some((ball.meet(&ray)?, ball.object, CURVED)));
            let nearest = faces.chain(balls).min_by(|a, b| a.0.total_cmp(&b.0));
            let seen = surfaces.meet(&ray).map(|(t, i, place)| surfaces.at(&ray, t, i, place));
            hits += u32::from(seen.is_some());
            assert_eq!(
                seen.map(|seen| (seen.object, seen.face)),
                nearest.map(|(_, object, face)| (object, face))
            );
        }
        assert!(hits > 500, "{hits}");
    }

    #[test]
    fn quarter_turns_are_exact_and_in_order() {
        let place = Placement::new(
            DVec3::new(10.0, 0.0, 0.0),
            [90.0, 0.0, 90.0],
            DVec3::new(1.0, 2.0, 3.0),
        );
        // y: doubled, rotated about x to z, unchanged about z; z: tripled, to -y, to +x.
        assert_eq!(place.point(DVec3::Y), DVec3::new(10.0, 0.0, 2.0));
        assert_eq!(place.point(DVec3::Z), DVec3::new(13.0, 0.0, 0.0));
        assert_eq!(place.point(DVec3::X), DVec3::new(10.0, 1.0, 0.0));
    }

    #[test]
    fn normals_that_cancel_fall_back_to_the_face() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let place = super::Place { object: 0, number: 0, triangle: true };
        let normals = [DVec3::Z, DVec3::X, DVec3::NEG_X];
        let face = Face::new(place, points, [DVec2::ZERO, DVec2::X, DVec2::Y], normals);
        let seen = face.at(DVec2::new(0.5, 0.5));
        assert_eq!((seen.normal, seen.face), (DVec3::Z, CURVED));
        // N is along dP/du: T is still perpendicular, and B is along dP/dv.
        let seen = face.at(DVec2::new(1.0, 0.0));
        assert_eq!(seen.normal, DVec3::X);
        assert_eq!(seen.normal.cross(seen.tangent), DVec3::Y);
    }
}
