//! Measurements of a setup, beside pictures.

use crate::measure::OverflowCount;
use crate::netlist::Counts;
use crate::shading::picture::Picture;
use crate::shading::scene::Sharing;
use serde::Serialize;

/// Measurements of a setup, beside its picture.
#[derive(Clone, Debug, Serialize)]
pub struct Known {
    /// The same flow with the golden of the setup.
    #[serde(skip)]
    pub flow: Picture,
    /// What vertex sharing saves.
    pub sharing: Sharing,
    /// Operations of the setup per triangle; `None` if all of them are per vertex.
    pub per_primitive: Option<Counts>,
    /// Further operations per vertex of a triangle.
    pub per_vertex: Counts,
    /// Triangles whose texture is mirrored.
    pub mirrored: u64,
    /// Corners that got a fallback frame.
    pub degenerate: u64,
    /// Ulp of positions, in the world: that of the object where it is largest.
    pub position_step: f64,
    /// Ulp of texture coordinates, likewise.
    pub uv_step: f64,
}

/// Measurements of the setup of a scene's frames.
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
    /// Every `narrow` of the setup that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
}
