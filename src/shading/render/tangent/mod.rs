//! Scenes by tangent-space set-up: texture-space vectors per corner of a triangle, lighting per pixel.
//!
//! The flow of US 7,843,463: a vertex stage (float: unit normal, unit vector to the eye and to each
//! light, once per shared vertex), primitive assembly ([`Scene::assemble`](crate::shading::scene::Scene::assemble)), the set-up (the fixed-point unit
//! `tangent`, for each corner of each triangle: the map from object space to texture space, and the eye's and the
//! lights' vectors through it), a rasteriser (float: rays and perspective-correct weights, which interpolate
//! those vectors and the texture coordinates), and lighting per pixel in texture space: with interpolated
//! vectors made unit again, `N'` straight from the bump map, and the formula of the golden.
//!
//! - `tangent-smooth` has a map for each vertex of a triangle, with the vertex's normal;
//! - `tangent-faceted` has one for each triangle, whose normal is its own. It takes none from vertices: by itself it
//!   shows a mesh without normals in facets, as does its golden then ([`Scene::faceted`](crate::shading::scene::Scene::faceted)).
//!
//! # Two goldens
//! A picture's difference to the golden of all pipelines (frames and vectors per pixel, without triangles) splits
//! into *arithmetic*, against [`Known::flow`], which is the same flow with the unit's golden in place of its words,
//! and *algorithm*, of that against the golden: vectors interpolated over triangles, a tangent that is constant on
//! each, and the outline of a sphere that has corners here. As many triangles as `[emboss] tessellation` says.
//!
//! # Words
//! Positions and texture coordinates of an object's vertices are moved to the middle of their range and scaled by one
//! power of two each, so that they take at least half of what the unit's words hold; then each is a word of the buffer,
//! the same for all its triangles. Neither changes a direction. A small object beside a large one has steps of its
//! own: only edges enter the set-up, and no triangle has vertices of two objects. A texture whose determinant is 0 in these words, or a triangle
//! without area in them, gets the unit's fallback frame and is counted.
//!
//! # Frames for the other pipelines
//! With [`Frames::Setup`](super::Frames) pipelines that shade bumps per pixel take their frames from the unit, too: the
//! rows of the map at the corners of a face are interpolated, N made unit, and T its part at right angles to N made
//! unit, from which come the angles φ_N, θ_N and ψ (angles themselves wrap, so they aren't interpolated). Units have
//! B = N × T; so where the map's own B is on the other side, which is where a texture is mirrored, p_y changes sign. So
//! it does with frames in floating point. T isn't turned: with T and N × T both turned, bumps would be
//! dents.

pub(super) mod flow;
pub(super) mod frames;
pub(super) mod known;
mod setup;

pub use known::{FramesKnown, Known};
