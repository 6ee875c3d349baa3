//! What is known of an emboss beside its picture.

use serde::Serialize;

/// What is known of an emboss beside its picture.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Known {
    /// What no channel can be off by more than, in linear light; unknown for `filter = "nearest"`, where a
    /// position beside a texel's border may be on its other side.
    pub bound: Option<f64>,
    /// The largest error of a displaced texture coordinate of any vertex under any light, in texels.
    pub displacement_max_texels: f64,
    /// Texels that the emboss unit counts as 1.
    pub step_texels: f64,
}
