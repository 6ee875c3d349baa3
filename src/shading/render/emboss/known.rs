//! Measurements of an emboss, beside its picture.

use serde::Serialize;

/// Measurements of an emboss, beside its picture.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Known {
    /// Bound on the error of any channel, in linear light; `None` for `filter = "nearest"`, where a
    /// position near a texel's border may be on the other side of it.
    pub bound: Option<f64>,
    /// The largest error of a displaced texture coordinate of any vertex under any light, in
    /// texels.
    pub displacement_max_texels: f64,
    /// Texels per unit of the emboss unit's coordinates.
    pub step_texels: f64,
}
