//! Scenes by tangent-space setup: texture-space vectors per triangle corner, lighting per pixel.
//!
//! The flow of US 7,843,463:
//!
//! - a vertex stage (float): unit normal, and unit vectors to the eye and to each light, once per
//!   shared vertex;
//! - primitive assembly ([`Scene::assemble`](crate::shading::scene::Scene::assemble));
//! - the setup (fixed-point unit `tangent`), for each corner of each triangle: the map from object
//!   space to texture space, applied to the vectors to the eye and the lights;
//! - a rasteriser (float): rays and perspective-correct weights, which interpolate those vectors
//!   and the texture coordinates;
//! - lighting per pixel in texture space: with renormalised interpolated vectors, `N'` directly
//!   from the bump map, and the formula of the golden.
//!
//! There are two pipelines:
//!
//! - `tangent-smooth` has a map for each vertex of a triangle, with the vertex's normal;
//! - `tangent-faceted` has one map for each triangle, with the triangle's normal. It uses no vertex
//!   normals: rendered alone, it and its golden show a mesh without normals in facets
//!   ([`Scene::faceted`](crate::shading::scene::Scene::faceted)).
//!
//! # Two goldens
//! A picture's difference to the golden of all pipelines (frames and vectors per pixel, without
//! triangles) has two parts. *Arithmetic* is the difference to [`Known::flow`], the same flow with
//! the unit's golden in place of its words. *Algorithm* is the difference of that flow to the
//! golden: vectors interpolated over triangles, a tangent that is constant on each, and a sphere
//! whose outline has corners. The number of triangles follows `tessellation` in `[emboss]`.
//!
//! # Words
//! Positions and texture coordinates of an object's vertices are moved to the middle of their range
//! and scaled by one power of two each, so that they use at least half of the range of the unit's
//! words. Each is then one word of the buffer, the same for all its triangles. Neither step changes
//! a direction. A small object beside a large one has its own steps: only edges enter the setup,
//! and no triangle has vertices of two objects. A texture whose determinant is 0 in these words, or
//! a triangle without area in them, gets the unit's fallback frame and is counted.
//!
//! # Frames for the other pipelines
//! With [`Frames::Setup`](super::Frames), the bump-mapping pipelines take their frames from the
//! unit, too. The rows of the map at the corners of a face are interpolated, N is normalised, and T
//! is its part perpendicular to N, normalised. The angles φ_N, θ_N and ψ are computed from these
//! (angles wrap, so they aren't interpolated). Units define B = N × T. Where the map's own B is on
//! the other side, which means that the texture is mirrored, p_y changes sign, as it does for
//! floating-point frames. T isn't negated: with both T and N × T negated, bumps would be dents.

pub(super) mod flow;
pub(super) mod frames;
pub(super) mod known;
mod setup;

pub use known::{FramesKnown, Known};
