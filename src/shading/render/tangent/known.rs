//! What is known of a set-up beside pictures.

use crate::measure::OverflowCount;
use crate::netlist::Counts;
use crate::shading::picture::Picture;
use crate::shading::scene::Sharing;
use serde::Serialize;

/// What is known of a set-up beside its picture.
#[derive(Clone, Debug, Serialize)]
pub struct Known {
    /// The same flow with the golden of the set-up.
    #[serde(skip)]
    pub flow: Picture,
    /// What sharing of vertices saves.
    pub sharing: Sharing,
    /// Operations of the set-up for each triangle; `None` if none are apart from those of its vertices.
    pub per_primitive: Option<Counts>,
    /// Operations for each vertex of a triangle, besides.
    pub per_vertex: Counts,
    /// Triangles whose texture is mirrored.
    pub mirrored: u64,
    /// Corners that got a fallback frame.
    pub degenerate: u64,
    /// Last place of positions, in the world: that of the object where it is coarsest.
    pub position_step: f64,
    /// Last place of texture coordinates, likewise.
    pub uv_step: f64,
}

/// What is known of the set-up of a scene's frames.
#[derive(Clone, Debug, Serialize)]
pub struct FramesKnown {
    /// Faces that were set up, with three corners each; spheres have none.
    pub faces: u64,
    /// Faces whose texture is mirrored.
    pub mirrored: u64,
    /// Corners that got a fallback frame.
    pub degenerate: u64,
    /// As [`Known::position_step`].
    pub position_step: f64,
    /// As [`Known::uv_step`].
    pub uv_step: f64,
    /// Every `narrow` of the set-up that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
}
