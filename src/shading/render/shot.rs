//! Pictures of a scene, and measurements on them.

use super::pipeline::Pipeline;
use super::{emboss, tangent};
use crate::base::cast;
use crate::base::error::Result;
use crate::base::json;
use crate::design::Design;
use crate::measure::{BINS, Basis, Figures, Histograms, OverflowCount, Report, Speed, Stream};
use crate::shading::picture::{Difference, Picture};
use serde::Serialize;
use std::sync::Arc;
use std::time::Duration;

/// Angle errors of the rotated light vectors of a scene's pixels, end to end: against the golden of
/// the inputs before quantisation.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct VectorError {
    /// The largest, in rad.
    #[serde(serialize_with = "json::real")]
    pub max_rad: f64,
    /// The mean, in rad.
    #[serde(serialize_with = "json::real")]
    pub mean_rad: f64,
    /// The root of the mean square, in rad.
    #[serde(serialize_with = "json::real")]
    pub rms_rad: f64,
    /// The median, in rad, to 1.6 %; 0 means below 2^-44.
    #[serde(serialize_with = "json::real")]
    pub p50_rad: f64,
    /// The 99th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p99_rad: f64,
    /// The 99.9th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p999_rad: f64,
}

impl VectorError {
    pub(super) fn of(angles: &Stream, histogram: &[u64]) -> Self {
        let figures = angles.figures("lt_angle", "rad", Basis::EndToEnd, histogram);
        Self {
            max_rad: figures.max,
            mean_rad: figures.mean,
            rms_rad: figures.rms,
            p50_rad: figures.p50,
            p99_rad: figures.p99,
            p999_rad: figures.p999,
        }
    }

    /// The same as figures of the quantity `lt_angle`.
    fn figures(&self) -> Figures {
        Figures {
            quantity: "lt_angle".to_owned(),
            unit: "rad",
            over: None,
            basis: Basis::EndToEnd,
            max: self.max_rad,
            max_ulp: None,
            witness: None,
            mean: self.mean_rad,
            bias: self.mean_rad, // an angle has no sign
            rms: self.rms_rad,
            p50: self.p50_rad,
            p99: self.p99_rad,
            p999: self.p999_rad,
        }
    }
}

/// A picture by a pipeline.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The pipeline.
    pub pipeline: Pipeline,
    /// Its picture.
    pub picture: Picture,
    /// Its golden picture, if that isn't [`Rendered::golden`]: for an emboss that displaces the
    /// other way.
    pub golden: Option<Arc<Picture>>,
    /// One of its designs: that of the first material under the first light.
    pub design: Arc<Design>,
    /// Designs of the units behind it, if any.
    pub behind: Vec<Arc<Design>>,
    /// Measurements of an emboss.
    pub emboss: Option<emboss::known::Known>,
    /// Measurements of a tangent-space setup.
    pub setup: Option<Box<tangent::known::Known>>,
    /// Measurements of the setup of its frames, if its frames come from the unit.
    pub frames: Option<Box<tangent::known::FramesKnown>>,
    /// Time in the bit-true engine, all threads together.
    pub engine: Duration,
    /// Samples per second and thread of the engine alone: the median over blocks of rows, weighted
    /// by samples, so that an interrupted thread hardly matters.
    pub samples_per_second: f64,
    /// Samples that the engine processed: covered pixels times lights.
    pub samples: u64,
    /// Errors of the rotated light vectors, if requested and if the unit has them.
    pub vectors: Option<VectorError>,
    /// Every `narrow` that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
}

impl Shot {
    /// Total number of overflows in all `narrow`s.
    #[must_use]
    pub fn overflowed(&self) -> u64 {
        self.overflows.iter().map(|overflow| overflow.count).sum()
    }
}

/// A scene rendered.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The golden picture, in `f64`: tangent-space bump mapping, or the emboss of the first
    /// pipeline.
    pub golden: Picture,
    /// The largest difference of Blinn's equation to it, in linear light; none for an emboss.
    pub blinn: Option<f64>,
    /// Pixels that see an object.
    pub covered: u64,
    /// Which pixels see an object, row by row.
    pub covers: Vec<bool>,
    /// The pipelines' pictures.
    pub shots: Vec<Shot>,
    /// Total wall-clock time.
    pub elapsed: Duration,
}

impl Rendered {
    /// The golden picture of a shot.
    #[must_use]
    pub fn golden_of<'a>(&'a self, shot: &'a Shot) -> &'a Picture {
        shot.golden.as_deref().unwrap_or(&self.golden)
    }

    /// Pixels that see no object.
    #[must_use]
    pub fn background(&self) -> u64 {
        cast::count_of(self.covers.len()) - self.covered
    }

    /// The difference of one picture of the scene to another, over the pixels that see an object;
    /// `pixels_per_degree` is FLIP's.
    ///
    /// # Errors
    /// If no pixel sees an object, or `pixels_per_degree` is outside FLIP's range.
    pub fn difference(
        &self,
        picture: &Picture,
        golden: &Picture,
        pixels_per_degree: f64,
    ) -> Result<Difference> {
        Difference::over(&self.covers, picture, golden, pixels_per_degree)
    }

    /// A shot as a measurement, end to end: `picture`, the difference to the golden in linear light
    /// of every channel of every covered pixel, and `lt_angle`, if it was measured. `difference`
    /// must be that of the shot's picture.
    #[must_use]
    pub fn report(&self, shot: &Shot, difference: &Difference) -> Report {
        let mut histogram = vec![0; BINS];
        let (mut stream, histograms) = (Stream::EMPTY, Histograms::new(1));
        let width = self.golden.width_px();
        let golden = self.golden_of(shot);
        let rows = shot.picture.pixels().chunks(width).zip(golden.pixels().chunks(width));
        for ((is, should), covers) in rows.zip(self.covers.chunks(width)) {
            let pixels = is.iter().zip(should).zip(covers).filter(|(_, covered)| **covered);
            let pairs = pixels.flat_map(|((is, should), _)| is.iter().zip(should));
            let errors: Vec<f64> = pairs.map(|(a, b)| f64::from(*a) - f64::from(*b)).collect();
            stream.merge(&Stream::of(&errors, 0, &mut histogram));
            histograms.take(&mut histogram);
        }
        // Take the mean from `difference`: it sums in another order, and two numbers would differ
        // in the last place.
        let mut figures = vec![Figures {
            mean: difference.mean,
            ..stream.figures("picture", "1", Basis::EndToEnd, &histograms.of(0))
        }];
        figures.extend(shot.vectors.map(|vectors| vectors.figures()));
        let samples = self.shots.iter().map(|shot| shot.samples).sum();
        Report {
            samples: shot.samples,
            figures,
            overflows: shot.overflows.clone(),
            speed: Speed {
                engine_samples_per_second_per_thread: shot.samples_per_second,
                samples_per_second: cast::f64_of_count(samples)
                    / self.elapsed.as_secs_f64().max(f64::MIN_POSITIVE),
                threads: rayon::current_num_threads(),
                ..Speed::default()
            },
        }
    }
}
