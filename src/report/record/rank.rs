//! Figures that rank pictures.

use super::measured::Measured;
use crate::measure::Basis;
use serde::{Deserialize, Serialize};

/// The figure that ranks pictures, from their difference from the golden.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RankBy {
    /// The largest absolute difference of any channel, in linear light.
    #[default]
    Max,
    /// The mean absolute difference, in linear light.
    Mean,
    /// The root of the mean square, in linear light; ranks like PSNR.
    Rms,
    /// Mean FLIP.
    Flip,
    /// 1 - SSIM.
    Ssim,
    /// Share of the covered pixels whose 8-bit codes differ.
    Differing,
}

impl RankBy {
    /// All of them, each with its name on the command line and its description.
    pub const ALL: [(Self, &'static str, &'static str); 6] = [
        (Self::Max, "max", "largest difference of any channel, in linear light"),
        (Self::Mean, "mean", "mean difference over covered pixels, in linear light"),
        (
            Self::Rms,
            "rms",
            "root of the mean square over covered pixels, in linear light; ranks like PSNR",
        ),
        (Self::Flip, "flip", "mean FLIP"),
        (Self::Ssim, "ssim", "1 - SSIM"),
        (Self::Differing, "differing", "share of the covered pixels whose 8-bit codes differ"),
    ];

    /// How the figure is shown.
    pub(super) fn lead(self) -> Lead {
        let (what, scale, unit) = match self {
            Self::Max => ("largest difference", 255.0, "1/255"),
            Self::Mean => ("mean difference", 255.0, "1/255"),
            Self::Rms => ("rms difference", 255.0, "1/255"),
            Self::Flip => ("FLIP", 1.0, "0 to 1"),
            Self::Ssim => ("1 - SSIM", 1.0, "0 to 2"),
            Self::Differing => ("covered pixels with different 8-bit codes", 100.0, "%"),
        };
        Lead { quantity: "picture".to_owned(), what: what.to_owned(), scale, unit }
    }

    pub(super) fn of(self, measured: &Measured) -> Option<f64> {
        let figures = measured.figures("picture", Basis::EndToEnd)?;
        let picture = measured.picture.as_ref()?;
        Some(match self {
            Self::Max => figures.max.0,
            Self::Mean => figures.mean.0,
            Self::Rms => figures.rms.0,
            Self::Flip => picture.flip.0,
            Self::Ssim => 1.0 - picture.ssim.0,
            Self::Differing => picture.srgb8_differing,
        })
    }
}

/// The quantity that ranks points, as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Lead {
    /// Its name.
    pub quantity: String,
    /// The figure, in words.
    pub what: String,
    /// Factor from its figures to the shown numbers.
    pub scale: f64,
    /// Unit of the shown numbers.
    pub unit: &'static str,
}
