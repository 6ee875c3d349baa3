//! The result of a sweep as data: `sweep.json` and `sweep.csv`.
//!
//! `sweep.json` holds a `header` (what was swept, over which inputs) and `points` in grid order,
//! one line each: its `parameters` (numbers, or names as text), and either `error`, the reason
//! why there are no figures, or `measured`. Numbers that JSON can't write are the texts `NaN`,
//! `inf` and `-inf`.
//!
//! Over a scene the quantities are `picture`, the difference to the golden picture in linear light,
//! and `lt_angle`, both end to end; parameters of the material that come from the scene are the
//! text `scene`; and `measured` also has `picture`, which no other quantity can tell.
//!
//! `sweep.csv` has one row per point. Its columns, in this order:
//!
//! - one per swept parameter, then one per other parameter, each under the parameter's name;
//! - `datapath_multipliers`, `datapath_adders` … operators of the datapath itself, and
//!   `scheme_multipliers`, `scheme_adders` … those inside table schemes; `tables`, `reads`,
//!   `ports`, `input_bits`, `latency_cycles`, `flip_flops`, `model_period_ps`,
//!   `rom_bits` (one copy of each table) and `rom_bits_dual_port` (as many copies as two
//!   ports per copy ask for); one that a parameter has the name of is `counted_<name>`;
//! - `samples`;
//! - `<quantity>_<basis>_<figure>_<unit>`, for instance `angle_total_max_rad`: the quantity is
//!   `angle`, `dot`, `x`, `y` or `z` of a direction (after the name of the direction, where a
//!   unit has several) or the name of a number, the basis `total`, `arithmetic`, `algorithm` or
//!   `end_to_end`, the figure `max`, `mean`, `bias`, `rms`, `p50`, `p99` or `p999`, the unit
//!   `rad`, `texel`, `rel` for an error over its scale, or `abs` for the absolute one of a number
//!   without a unit; numbers and components
//!   also have `<quantity>_<basis>_max_ulp`, which is empty where no node holds the component;
//! - `<quantity>_total_witness` of the leading quantity, which is the first: the input words that
//!   gave its largest total error, as `phi_a=123;theta_a=…`;
//!   over a scene `picture_witness` in its place, the pixel and channel of the largest difference,
//!   and before it `picture_psnr_db`, `picture_ssim`, `picture_flip`, `picture_covered_px` (pixels that see
//!   an object: the others, `picture_background_px`, count in no mean), `picture_srgb8_differing` (part
//!   of the covered pixels, 0 to 1) and `picture_srgb8_max_codes`;
//! - `overflows`: how often any `narrow` overflowed;
//! - `samples_per_second`, `threads` and `engine_samples_per_second_per_thread`;
//! - `error`: why a point has no figures; empty otherwise.
//!
//! [`crate::base::columns`] tells how fields are written, [`crate::base::json`] what documents have in common.

use crate::base::cast;
use crate::base::columns::{self, Field};
use crate::base::error::{Error, Result};
use crate::base::input;
use crate::base::json;
use crate::base::output;
use crate::base::whole;
use crate::design::{Design, Value, Values};
use crate::measure::{self, Basis, Speed, Witness};
use crate::netlist::{Counts, Quantity};
use crate::shading::picture::{Channel, Difference, coverage};
use crate::shading::render::{Rendered, Shot};
use crate::shading::scene::Scene;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Map;
use std::collections::BTreeSet;
use std::fmt;
use std::fs::OpenOptions;
use std::io;
use std::path::Path;

/// Most bytes of a `sweep.json` that are read: more than the largest sweep writes.
const MAX_BYTES: u64 = 1 << 32;

/// Version of the form of `sweep.json`.
pub const FORMAT_VERSION: u32 = 2;

/// A number that survives JSON even if it is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Real(pub f64);

impl Serialize for Real {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        json::real(&self.0, serializer)
    }
}

impl<'de> Deserialize<'de> for Real {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Written {
            Number(f64),
            Text(String),
        }
        match Written::deserialize(deserializer)? {
            Written::Number(number) => Ok(Self(number)),
            Written::Text(text) => match text.as_str() {
                "NaN" => Ok(Self(f64::NAN)),
                "inf" => Ok(Self(f64::INFINITY)),
                "-inf" => Ok(Self(f64::NEG_INFINITY)),
                other => Err(serde::de::Error::custom(format!("`{other}` is no number"))),
            },
        }
    }
}

/// Parameters by name, in the unit's order: numbers as numbers, names as text.
pub type Parameters = Map<String, serde_json::Value>;

/// One swept parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// The parameter.
    pub key: String,
    /// Its values.
    pub values: Vec<serde_json::Value>,
}

/// What was swept, over which inputs: what must be equal for a sweep to go on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// [`FORMAT_VERSION`] of the file.
    pub format_version: u32,
    /// Version of this crate.
    pub crate_version: String,
    /// Name of the unit.
    pub unit: String,
    /// Parameters that are not swept.
    pub base: Parameters,
    /// Swept parameters; the last one runs fastest.
    pub axes: Vec<Axis>,
    /// Name of the sampler.
    pub sampler: String,
    /// Samples asked for, for the random samplers.
    pub samples: u64,
    /// Seed of the random samplers.
    pub seed: u64,
    /// The scene that was rendered, if that is where inputs came from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneId>,
    /// What points over a scene are ranked by: points have all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<RankBy>,
}

/// Which scene it was.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SceneId {
    /// Its name, or its file's.
    pub name: String,
    /// Its fingerprint, in hexadecimal digits.
    pub fingerprint: String,
    /// Columns of its image.
    pub width_px: u32,
    /// Rows.
    pub height_px: u32,
    /// What isn't as its files have it, or stands still.
    #[serde(default)]
    pub notes: Vec<String>,
}

impl SceneId {
    /// That of a scene.
    #[must_use]
    pub fn new(name: &str, scene: &Scene) -> Self {
        Self {
            name: name.to_owned(),
            fingerprint: format!("{:016x}", scene.fingerprint()),
            width_px: scene.image.width,
            height_px: scene.image.height,
            notes: scene.notes_at_start(),
        }
    }
}

impl fmt::Display for SceneId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, fingerprint, width_px, height_px, notes: _ } = self;
        write!(f, "{name} ({width_px} x {height_px} px, fingerprint {fingerprint})")
    }
}

/// How a picture is ranked by its difference to the golden.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RankBy {
    /// The largest absolute difference of any channel, in linear light.
    #[default]
    Max,
    /// The mean absolute difference, in linear light.
    Mean,
    /// The root of the mean square, in linear light; it ranks as PSNR does.
    Rms,
    /// Mean FLIP.
    Flip,
    /// 1 less SSIM.
    Ssim,
    /// Part of the covered pixels whose 8-bit codes differ.
    Differing,
}

impl Header {
    /// In words, where this header (that of a file) differs from the one asked for.
    #[must_use]
    pub fn differences(&self, asked: &Self) -> Vec<String> {
        let mut found = Vec::new();
        let mut compare = |what: &str, there: String, here: String| {
            if there != here {
                found.push(format!("{what} is {there} there and {here} here"));
            }
        };
        let (there, here) = (self, asked);
        compare("format", there.format_version.to_string(), here.format_version.to_string());
        compare("version", there.crate_version.clone(), here.crate_version.clone());
        compare("unit", there.unit.clone(), here.unit.clone());
        compare("sampler", there.sampler.clone(), here.sampler.clone());
        compare("samples", there.samples.to_string(), here.samples.to_string());
        compare("seed", there.seed.to_string(), here.seed.to_string());
        let scene = |header: &Self| header.scene.as_ref().map(ToString::to_string);
        if let (Some(there), Some(here)) = (scene(there), scene(here)) {
            compare("scene", there, here);
        }
        let axis = |axis: &Axis| {
            let values: Vec<String> = axis.values.iter().map(plain).collect();
            format!("{}={}", axis.key, values.join(","))
        };
        let axes = |header: &Self| match header.axes.iter().map(axis).collect::<Vec<_>>() {
            axes if axes.is_empty() => "no axis".to_owned(),
            axes => axes.join(" "),
        };
        compare("the grid", axes(there), axes(here));
        // A parameter that is swept on one side is told by the grid.
        for (name, value) in &there.base {
            if let Some(other) = here.base.get(name) {
                compare(name, plain(value), plain(other));
            }
        }
        if found.is_empty() && there != here {
            found.push("the set of parameters is another one".to_owned());
        }
        found
    }
}

/// Figures of one quantity on one basis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Its name.
    pub quantity: String,
    /// `rad`, or `1` for absolute errors of numbers.
    pub unit: String,
    /// What it is told over, in words, where it isn't absolute.
    pub over: Option<String>,
    /// Against what.
    pub basis: Basis,
    /// Largest absolute value.
    pub max: Real,
    /// The same in ulp of the port or node, for numbers and Cartesian components.
    pub max_ulp: Option<Real>,
    /// Input that gave it.
    pub witness: Option<Witness>,
    /// Mean of the absolute value.
    pub mean: Real,
    /// Mean with sign.
    pub bias: Real,
    /// Root of the mean square.
    pub rms: Real,
    /// Median of the absolute value.
    pub p50: Real,
    /// 99th percentile.
    pub p99: Real,
    /// 99.9th percentile.
    pub p999: Real,
}

impl From<measure::Figures> for Figures {
    fn from(figures: measure::Figures) -> Self {
        Self {
            quantity: figures.quantity,
            unit: figures.unit.to_owned(),
            over: figures.over.map(str::to_owned),
            basis: figures.basis,
            max: Real(figures.max),
            max_ulp: figures.max_ulp.map(Real),
            witness: figures.witness,
            mean: Real(figures.mean),
            bias: Real(figures.bias),
            rms: Real(figures.rms),
            p50: Real(figures.p50),
            p99: Real(figures.p99),
            p999: Real(figures.p999),
        }
    }
}

/// How often a `narrow` overflowed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Overflows {
    /// The node.
    pub node: String,
    /// Its overflow mode.
    pub mode: String,
    /// How often.
    pub count: u64,
}

/// Figures of a picture that no other quantity has.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PictureFigures {
    /// Peak signal to noise ratio in dB, in linear light.
    pub psnr_db: Real,
    /// Mean structural similarity, 1 if the pictures are equal.
    pub ssim: Real,
    /// Mean FLIP, 0 if they are equal.
    pub flip: Real,
    /// Pixels that see an object: what means, quantiles, PSNR and the differing part are over.
    pub covered_px: u64,
    /// The other pixels.
    pub background_px: u64,
    /// Part of the covered pixels whose 8-bit codes differ, 0..=1.
    pub srgb8_differing: f64,
    /// The largest difference of 8-bit codes.
    pub srgb8_max_codes: u8,
    /// Column of the largest difference in linear light.
    pub x_px: usize,
    /// Its row.
    pub y_px: usize,
    /// Its channel.
    pub channel: Channel,
}

impl From<&Difference> for PictureFigures {
    fn from(difference: &Difference) -> Self {
        Self {
            psnr_db: Real(difference.psnr_db),
            ssim: Real(difference.ssim),
            flip: Real(difference.flip),
            covered_px: difference.covered_px,
            background_px: difference.background_px,
            srgb8_differing: difference.srgb8_differing,
            srgb8_max_codes: difference.srgb8_max_codes,
            x_px: difference.max.x_px,
            y_px: difference.max.y_px,
            channel: difference.max.channel,
        }
    }
}

impl RankBy {
    /// All with their names on the command line and what they are.
    pub const ALL: [(Self, &'static str, &'static str); 6] = [
        (Self::Max, "max", "largest difference of any channel, in linear light"),
        (Self::Mean, "mean", "mean difference over covered pixels, in linear light"),
        (
            Self::Rms,
            "rms",
            "root of the mean square over covered pixels, in linear light; ranks as PSNR does",
        ),
        (Self::Flip, "flip", "mean FLIP"),
        (Self::Ssim, "ssim", "1 less SSIM"),
        (Self::Differing, "differing", "part of the covered pixels whose 8-bit codes differ"),
    ];

    /// How it is shown.
    fn lead(self) -> Lead {
        let (what, scale, unit) = match self {
            Self::Max => ("largest difference", 255.0, "1/255"),
            Self::Mean => ("mean difference", 255.0, "1/255"),
            Self::Rms => ("rms difference", 255.0, "1/255"),
            Self::Flip => ("FLIP", 1.0, "0 to 1"),
            Self::Ssim => ("1 - SSIM", 1.0, "0 to 2"),
            Self::Differing => ("covered pixels with other 8-bit codes", 100.0, "%"),
        };
        Lead { quantity: "picture".to_owned(), what: what.to_owned(), scale, unit }
    }

    fn of(self, measured: &Measured) -> Option<f64> {
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

/// What was counted and measured of a point.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measured {
    /// Names of the input ports: what the words of a witness belong to.
    pub input_ports: Vec<String>,
    /// Names of the output ports.
    pub output_ports: Vec<String>,
    /// Counts of operators, tables and bits, by the names of their CSV columns.
    pub counts: Map<String, serde_json::Value>,
    /// Formats of the input ports, one behind the other with how often it comes.
    #[serde(default)]
    pub input_formats: String,
    /// Samples measured.
    pub samples: u64,
    /// One entry per quantity and basis.
    pub figures: Vec<Figures>,
    /// What only pictures have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<PictureFigures>,
    /// Every `narrow` that overflowed.
    pub overflows: Vec<Overflows>,
    /// Time spent; the only part that differs from run to run.
    pub speed: Speed,
}

/// A unit as columns are named by it.
fn short(unit: &str) -> &'static str {
    match unit {
        "rad" => "rad",
        "texel" => "texel",
        "rel" => "rel",
        _ => "abs",
    }
}

/// Names with how often each comes, one behind the other.
fn formats(names: impl Iterator<Item = String>) -> String {
    let mut runs: Vec<(String, u32)> = Vec::new();
    for name in names {
        match runs.last_mut() {
            Some((last, count)) if *last == name => *count += 1,
            Some(_) | None => runs.push((name, 1)),
        }
    }
    let runs: Vec<String> = runs.iter().map(|(name, count)| format!("{count} {name}")).collect();
    runs.join(", ")
}

impl Measured {
    /// Takes over a measurement of a design.
    #[must_use]
    pub fn new(design: &Design, report: measure::Report) -> Self {
        let netlist = &design.netlist;
        let inputs = netlist.inputs().iter().map(|id| netlist.label(*id));
        let mut counts = flat(&netlist.counts());
        let input_bits: u32 =
            netlist.inputs().iter().map(|id| netlist.node(*id).format.bits()).sum();
        counts.insert("input_bits".to_owned(), input_bits.into());
        if let Ok(rtl) = design.rtl() {
            counts.insert("latency_cycles".to_owned(), rtl.schedule().latency().into());
            counts.insert("flip_flops".to_owned(), rtl.register_bits().into());
            counts.insert("model_period_ps".to_owned(), rtl.schedule().period_ps().into());
            // The netlist's operators share units: what the hardware has stands beside them.
            if !rtl.units().is_empty() {
                counts.insert("interval_cycles".to_owned(), rtl.schedule().interval().into());
                for (name, count) in flat(&rtl.counts().operators) {
                    counts.insert(format!("hardware_{name}"), count);
                }
            }
        }
        Self {
            input_ports: inputs.collect(),
            output_ports: netlist.outputs().iter().map(|output| output.name.clone()).collect(),
            counts,
            input_formats: formats(netlist.inputs().iter().map(|id| {
                let node = netlist.node(*id);
                let short = node.quantity == Quantity::Float20;
                format!("{}{}", node.format, if short { " float20" } else { "" })
            })),
            samples: report.samples,
            figures: report.figures.into_iter().map(Figures::from).collect(),
            picture: None,
            overflows: report
                .overflows
                .into_iter()
                .map(|o| Overflows { node: o.node, mode: o.mode.to_owned(), count: o.count })
                .collect(),
            speed: report.speed,
        }
    }

    /// Takes over a shot of a scene.
    #[must_use]
    pub fn of_shot(rendered: &Rendered, shot: &Shot, difference: &Difference) -> Self {
        Self {
            picture: Some(difference.into()),
            ..Self::new(&shot.design, rendered.report(shot, difference))
        }
    }

    /// Figures of a quantity on a basis.
    #[must_use]
    pub fn figures(&self, quantity: &str, basis: Basis) -> Option<&Figures> {
        self.figures.iter().find(|f| f.quantity == quantity && f.basis == basis)
    }

    /// A count by the name of its CSV column.
    #[must_use]
    pub fn count(&self, name: &str) -> Option<u64> {
        self.counts.get(name)?.as_u64()
    }

    /// Figures of the leading quantity, which points are ranked by: the first.
    #[must_use]
    pub fn lead(&self, basis: Basis) -> Option<&Figures> {
        self.figures(&self.figures.first()?.quantity, basis)
    }

    /// Largest error of the leading quantity on a basis, in its own unit; NaN if there is none.
    #[must_use]
    pub fn lead_max(&self, basis: Basis) -> f64 {
        self.lead(basis).map_or(f64::NAN, |figures| figures.max.0)
    }

    /// Largest total error of any number or component in ulp of its port or node.
    #[must_use]
    pub fn max_ulp(&self) -> Option<f64> {
        let total = self.figures.iter().filter(|figures| figures.basis == Basis::Total);
        total.filter_map(|figures| Some(figures.max_ulp?.0)).reduce(f64::max)
    }

    /// Multipliers and adders everywhere: in the datapath, in table schemes, in dividers and roots.
    #[must_use]
    pub fn operators(&self) -> [u64; 2] {
        ["multipliers", "adders"].map(|what| {
            let groups = ["datapath", "scheme", "parts"].iter();
            groups.filter_map(|group| self.count(&format!("{group}_{what}"))).sum()
        })
    }

    /// Input words of the largest total error of the leading quantity, as `port=word;port=word`; of a
    /// picture, where the largest difference is.
    #[must_use]
    pub fn witness(&self) -> String {
        if let Some(PictureFigures { x_px, y_px, channel, .. }) = &self.picture {
            return format!("x_px={x_px};y_px={y_px};channel={}", channel.name());
        }
        let figures = self.lead(Basis::Total);
        let Some(witness) = figures.and_then(|figures| figures.witness.as_ref()) else {
            return String::new();
        };
        let pairs = self.input_ports.iter().zip(&witness.words);
        pairs.map(|(port, word)| format!("{port}={word}")).collect::<Vec<_>>().join(";")
    }
}

/// One point of the grid.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Point {
    /// All parameters.
    pub parameters: Parameters,
    /// Why there is nothing measured.
    pub error: Option<String>,
    /// What was measured.
    pub measured: Option<Measured>,
}

impl Point {
    /// A parameter as one would write it; nothing if there is no such parameter.
    #[must_use]
    pub fn text(&self, key: &str) -> String {
        self.parameters.get(key).map(plain).unwrap_or_default()
    }

    /// A parameter as a field of a CSV.
    pub(crate) fn field(&self, key: &str) -> Field {
        match self.parameters.get(key) {
            None => Field::Missing,
            // Whole numbers may be negative: as JSON writes them.
            Some(value) => Field::Text(plain(value)),
        }
    }

    /// A parameter that is a number.
    #[must_use]
    pub fn number(&self, key: &str) -> Option<f64> {
        self.parameters.get(key)?.as_f64()
    }
}

/// A sweep's result: what the files and reports are made from.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    /// What was swept.
    pub header: Header,
    /// Finished points in grid order.
    pub points: Vec<Point>,
}

/// The quantity that points are ranked by, as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Lead {
    /// Its name.
    pub quantity: String,
    /// What of it, in words.
    pub what: String,
    /// Factor from its figures to what is shown.
    pub scale: f64,
    /// Unit of what is shown.
    pub unit: &'static str,
}

impl Record {
    /// How much of the pictures means are over, in words; `None` without a picture.
    #[must_use]
    pub fn coverage(&self) -> Option<String> {
        let picture = self.points.iter().find_map(|point| point.measured.as_ref()?.picture)?;
        Some(coverage(picture.covered_px, picture.background_px))
    }

    /// The leading quantity; angles are shown in degrees.
    #[must_use]
    pub fn lead(&self) -> Lead {
        if let Some(error) = self.image_error() {
            return error.lead();
        }
        let figures = self.points.iter().find_map(|p| p.measured.as_ref()?.figures.first());
        let (quantity, unit) = figures.map_or(("", ""), |f| (f.quantity.as_str(), f.unit.as_str()));
        let (scale, unit) = match unit {
            "rad" => (1f64.to_degrees(), "deg"),
            unit => (1.0, short(unit)),
        };
        let over = figures.and_then(|f| f.over.as_ref());
        let over = over.map(|over| format!(" over {over}")).unwrap_or_default();
        let what = format!("largest {quantity} error{over}");
        Lead { quantity: quantity.to_owned(), what, scale, unit }
    }

    /// What points over a scene are ranked by; `None` over anything else.
    fn image_error(&self) -> Option<RankBy> {
        self.header.scene.as_ref().map(|_| self.header.error.unwrap_or_default())
    }

    /// The number that a point is ranked by on a basis, in the unit of [`lead`](Self::lead); NaN if
    /// there is none.
    #[must_use]
    pub fn error(&self, measured: &Measured, basis: Basis) -> f64 {
        let error = match self.image_error() {
            Some(error) => error.of(measured).unwrap_or(f64::NAN),
            None => measured.lead_max(basis),
        };
        error * self.lead().scale
    }

    /// What points are ranked by: the total error, but the end-to-end one where points differ in
    /// their inputs' words, and over a scene. A coarse input would look good against its own golden.
    #[must_use]
    pub fn ranking(&self) -> Basis {
        if self.header.scene.is_some() {
            return Basis::EndToEnd;
        }
        let drawn = matches!(self.header.sampler.as_str(), "lit" | "sphere");
        if drawn && self.inputs_differ() { Basis::EndToEnd } else { Basis::Total }
    }

    /// True if points were measured over different input words.
    #[must_use]
    pub fn inputs_differ(&self) -> bool {
        let of =
            |measured: &'_ Measured| (measured.count("input_bits"), measured.input_formats.clone());
        let mut inputs = self.points.iter().filter_map(|p| p.measured.as_ref()).map(of);
        let first = inputs.next();
        inputs.any(|other| Some(&other) != first.as_ref())
    }

    /// Reads `sweep.json`; `None` if there is no such file.
    ///
    /// # Errors
    /// If the file can't be read or is no result of a sweep.
    pub fn load(path: &Path) -> Result<Option<Self>> {
        let remedy = "choose another folder or pass --fresh";
        // Not by `input::open`: the sweep that reads it writes it anew.
        let file = match input::open_with(OpenOptions::new().read(true), path) {
            Ok(file) => file,
            Err(why) if why.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(why) => return Err(Error::file(path, format!("can't read: {why}: {remedy}"))),
        };
        let bytes = input::read(file, path, MAX_BYTES)
            .map_err(|why| Error::usage(format!("{why}: {remedy}")))?;
        let malformed = |why: String| {
            Error::file(
                path,
                format!("is not a sweep result that this version reads ({why}): {remedy}"),
            )
        };
        let record: Self =
            serde_json::from_slice(&bytes).map_err(|why| malformed(why.to_string()))?;
        for (point, number) in record.points.iter().zip(1..) {
            let whole = match (&point.measured, &point.error) {
                (Some(measured), None) => {
                    let judged = match record.header.scene {
                        Some(_) => {
                            measured.picture.is_some() && measured.lead(Basis::EndToEnd).is_some()
                        }
                        None => measured.lead(Basis::Total).is_some(),
                    };
                    judged && measured.count("rom_bits_dual_port").is_some()
                }
                (None, error) => error.is_some(),
                (Some(_), Some(_)) => false,
            };
            if !whole {
                return Err(malformed(format!("point {number} is incomplete")));
            }
        }
        Ok(Some(record))
    }

    /// Writes `sweep.json`, a line per point.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn write_json<'a>(
        path: &Path,
        header: &Header,
        points: impl Iterator<Item = &'a Point>,
    ) -> Result<()> {
        output::write_file(path, |to| {
            let fail = output::at(path);
            let json = |why: serde_json::Error| fail(why.into());
            to.write_all(b"{").map_err(&fail)?;
            for (name, value) in json::head("sweep") {
                write!(to, "\"{name}\": {value}, ").map_err(&fail)?;
            }
            write!(to, "\"header\": ").map_err(&fail)?;
            serde_json::to_writer_pretty(&mut *to, header).map_err(json)?;
            write!(to, ",\n\"points\": [").map_err(&fail)?;
            for (index, point) in points.enumerate() {
                to.write_all(if index == 0 { b"\n" } else { b",\n" }).map_err(&fail)?;
                serde_json::to_writer(&mut *to, point).map_err(json)?;
            }
            to.write_all(b"\n]}\n").map_err(&fail)
        })
    }

    /// Writes `sweep.csv`; the module's documentation names the columns.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn write_csv<'a>(
        path: &Path,
        header: &Header,
        points: impl Iterator<Item = &'a Point> + Clone,
    ) -> Result<()> {
        let columns = Columns::new(header, points.clone());
        let rows = points.map(|point| columns.row(point));
        output::write_file(path, |to| columns::write(to, path, &columns.names(), rows))
    }
}

/// Columns of the CSV: what any of the points has.
struct Columns {
    parameters: Vec<String>,
    counts: Vec<String>,
    /// Quantity and its unit in column names.
    quantities: Vec<(String, &'static str)>,
    /// Those that have figures in ulp.
    with_ulp: BTreeSet<String>,
    bases: Vec<Basis>,
    /// Over a scene.
    pictures: bool,
}

/// Picks one of a picture's figures.
type PickOfPicture = fn(&PictureFigures) -> Field;

/// Figures of pictures in columns.
const PICTURE_FIGURES: [(&str, PickOfPicture); 7] = [
    ("picture_psnr_db", |p| p.psnr_db.0.into()),
    ("picture_ssim", |p| p.ssim.0.into()),
    ("picture_flip", |p| p.flip.0.into()),
    ("picture_covered_px", |p| p.covered_px.into()),
    ("picture_background_px", |p| p.background_px.into()),
    ("picture_srgb8_differing", |p| p.srgb8_differing.into()),
    ("picture_srgb8_max_codes", |p| u32::from(p.srgb8_max_codes).into()),
];

/// Picks one of the figures.
type Pick = fn(&Figures) -> Real;

/// Figures in columns.
const FIGURES: [(&str, Pick); 7] = [
    ("max", |f| f.max),
    ("mean", |f| f.mean),
    ("bias", |f| f.bias),
    ("rms", |f| f.rms),
    ("p50", |f| f.p50),
    ("p99", |f| f.p99),
    ("p999", |f| f.p999),
];

impl Columns {
    fn new<'a>(header: &Header, points: impl Iterator<Item = &'a Point>) -> Self {
        let axes = header.axes.iter().map(|axis| &axis.key);
        let parameters = axes.chain(header.base.keys()).cloned().collect();
        let mut columns = Self {
            parameters,
            counts: Vec::new(),
            quantities: Vec::new(),
            with_ulp: BTreeSet::new(),
            bases: Vec::new(),
            pictures: header.scene.is_some(),
        };
        for measured in points.filter_map(|point| point.measured.as_ref()) {
            for name in measured.counts.keys() {
                if !columns.counts.contains(name) {
                    columns.counts.push(name.clone());
                }
            }
            for figures in &measured.figures {
                if columns.quantities.iter().all(|(name, _)| *name != figures.quantity) {
                    columns.quantities.push((figures.quantity.clone(), short(&figures.unit)));
                }
                if !columns.pictures && figures.unit == "1" && !figures.quantity.ends_with("dot") {
                    columns.with_ulp.insert(figures.quantity.clone());
                }
                if !columns.bases.contains(&figures.basis) {
                    columns.bases.push(figures.basis);
                }
            }
        }
        columns
    }

    fn names(&self) -> Vec<String> {
        let mut names = self.parameters.clone();
        // Some units have a parameter of that name: two columns of one name are none to many readers.
        names.extend(self.counts.iter().map(|name| match self.parameters.contains(name) {
            true => format!("counted_{name}"),
            false => name.clone(),
        }));
        names.push("samples".to_owned());
        for (quantity, unit) in &self.quantities {
            for basis in &self.bases {
                let basis = basis.name().replace('-', "_");
                for (figure, _) in FIGURES {
                    names.push(format!("{quantity}_{basis}_{figure}_{unit}"));
                }
                if self.with_ulp.contains(quantity) {
                    names.push(format!("{quantity}_{basis}_max_ulp"));
                }
            }
        }
        let lead = self.quantities.first().map_or("lead", |(quantity, _)| quantity.as_str());
        if self.pictures {
            names.extend(PICTURE_FIGURES.map(|(name, _)| name.to_owned()));
            names.push("picture_witness".to_owned());
        } else {
            names.push(format!("{lead}_total_witness"));
        }
        names.extend(
            [
                "overflows",
                "samples_per_second",
                "threads",
                "engine_samples_per_second_per_thread",
                "error",
            ]
            .map(str::to_owned),
        );
        names
    }

    fn row(&self, point: &Point) -> Vec<Field> {
        let mut row: Vec<Field> = self.parameters.iter().map(|key| point.field(key)).collect();
        let measured = point.measured.as_ref();
        row.extend(
            self.counts.iter().map(|name| Field::from(measured.and_then(|m| m.count(name)))),
        );
        row.push(measured.map(|m| m.samples).into());
        for (quantity, _) in &self.quantities {
            for basis in &self.bases {
                let figures = measured.and_then(|m| m.figures(quantity, *basis));
                row.extend(FIGURES.map(|(_, get)| Field::from(figures.map(|f| get(f).0))));
                if self.with_ulp.contains(quantity) {
                    row.push(figures.and_then(|f| Some(f.max_ulp?.0)).into());
                }
            }
        }
        if self.pictures {
            let picture = measured.and_then(|measured| measured.picture.as_ref());
            row.extend(PICTURE_FIGURES.map(|(_, get)| picture.map_or(Field::Missing, get)));
        }
        match measured {
            Some(measured) => {
                let speed = &measured.speed;
                row.extend([
                    measured.witness().into(),
                    measured.overflows.iter().map(|o| o.count).sum::<u64>().into(),
                    speed.samples_per_second.into(),
                    cast::count_of(speed.threads).into(),
                    speed.engine_samples_per_second_per_thread.into(),
                ]);
            }
            None => row.extend([const { Field::Missing }; 5]),
        }
        row.push(point.error.clone().into());
        row
    }
}

/// Counts with the operators' group in front of their names.
fn flat(counts: &Counts) -> Map<String, serde_json::Value> {
    let whole = serde_json::to_value(counts).expect("bug: counts are plain numbers");
    let mut flat = Map::new();
    for (name, value) in whole.as_object().expect("bug: counts have fields") {
        match value.as_object() {
            Some(group) => {
                let group_name = if name == "schemes" { "scheme" } else { name };
                for (name, value) in group {
                    flat.insert(format!("{group_name}_{name}"), value.clone());
                }
            }
            None => {
                flat.insert(name.clone(), value.clone());
            }
        }
    }
    flat
}

/// A parameter's value for JSON.
#[must_use]
pub fn json_of(value: Value) -> serde_json::Value {
    match value {
        Value::Int(number) => number.into(),
        Value::Real(number) => number.get().into(),
        Value::Auto | Value::Choice(_) => value.to_string().into(),
    }
}

/// Parameters for JSON.
#[must_use]
pub fn parameters_of(values: &Values) -> Parameters {
    values.iter().map(|(name, value)| (name.to_owned(), json_of(value))).collect()
}

/// Parameters for JSON of texts `key=value`.
#[must_use]
pub fn assigned(assignments: &[String]) -> Parameters {
    let pairs = assignments.iter().filter_map(|set| set.split_once('='));
    let value = |text: &str| match (whole::signed(text), text.parse::<f64>()) {
        (Some(number), _) => number.into(),
        (None, Ok(number)) if number.is_finite() => number.into(),
        (None, _) => text.into(),
    };
    pairs.map(|(key, text)| (key.to_owned(), value(text))).collect()
}

/// A parameter's value as one would write it.
#[must_use]
pub fn plain(value: &serde_json::Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
