//! A point: its counts and figures.

use super::parameters::{Parameters, plain};
use crate::base::columns::Field;
use crate::base::error::Result;
use crate::base::json;
use crate::design::Design;
use crate::measure::{self, Basis, Speed, Witness};
use crate::netlist::{Counts, Quantity};
use crate::shading::picture::{Channel, Difference};
use crate::shading::render::{Rendered, Shot};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Map;

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
                other => Err(serde::de::Error::custom(format!("`{other}` is not a number"))),
            },
        }
    }
}

/// Figures of one quantity on one basis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Its name.
    pub quantity: String,
    /// `rad`, `turn`, `texel`, `rel` for errors relative to a scale, or `1` for absolute errors.
    pub unit: String,
    /// What the error is relative to, in words, if it isn't absolute.
    pub over: Option<String>,
    /// What is compared with what.
    pub basis: Basis,
    /// Largest absolute value.
    pub max: Real,
    /// The same in ulp of the port or node, for numbers and Cartesian components.
    pub max_ulp: Option<Real>,
    /// The input that gave it.
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
            over: figures.over,
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
    /// Number of overflows.
    pub count: u64,
}

/// Figures that only pictures have.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PictureFigures {
    /// Peak signal to noise ratio in dB, in linear light.
    pub psnr_db: Real,
    /// Mean structural similarity, 1 if the pictures are equal.
    pub ssim: Real,
    /// Mean FLIP, 0 if they are equal.
    pub flip: Real,
    /// Pixels that see an object: means, quantiles, PSNR and the differing share are over these.
    pub covered_px: u64,
    /// Other pixels.
    pub background_px: u64,
    /// Share of the covered pixels whose 8-bit codes differ, 0..=1.
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

/// The counts and measurements of a point.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measured {
    /// Names of the input ports, to which the words of a witness belong.
    pub input_ports: Vec<String>,
    /// Names of the output ports.
    pub output_ports: Vec<String>,
    /// Counts of operators, tables and bits, by the names of their CSV columns.
    pub counts: Map<String, serde_json::Value>,
    /// Formats of the input ports in order, each after its number of repetitions.
    #[serde(default)]
    pub input_formats: String,
    /// Samples measured.
    pub samples: u64,
    /// One entry per quantity and basis.
    pub figures: Vec<Figures>,
    /// Figures that only pictures have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<PictureFigures>,
    /// Every `narrow` that overflowed.
    pub overflows: Vec<Overflows>,
    /// Time spent; the only part that differs from run to run.
    pub speed: Speed,
}

/// A unit as it appears in column names.
pub(super) fn short(unit: &str) -> &'static str {
    match unit {
        "rad" => "rad",
        "texel" => "texel",
        "rel" => "rel",
        _ => "abs",
    }
}

/// Names in order, each with its number of repetitions.
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
    /// Converts a measurement of a design.
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
            // The netlist's operators share units, so the hardware's counts are recorded as well.
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

    /// Converts a shot of a scene.
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

    /// Figures of the leading quantity, the first, which ranks points.
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

    /// All multipliers and adders: in the datapath, table schemes, dividers and roots.
    #[must_use]
    pub fn operators(&self) -> [u64; 2] {
        ["multipliers", "adders"].map(|what| {
            let groups = ["datapath", "scheme", "parts"].iter();
            groups.filter_map(|group| self.count(&format!("{group}_{what}"))).sum()
        })
    }

    /// Input words of the largest total error of the leading quantity, as `port=word;port=word`;
    /// for a picture, the position of the largest difference.
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
    /// Why nothing was measured.
    pub error: Option<String>,
    /// The counts and measurements.
    pub measured: Option<Measured>,
}

impl Point {
    /// A parameter as text; empty if there is no such parameter.
    #[must_use]
    pub fn text(&self, key: &str) -> String {
        self.parameters.get(key).map(plain).unwrap_or_default()
    }

    /// A parameter as a field of a CSV.
    pub(crate) fn field(&self, key: &str) -> Field {
        match self.parameters.get(key) {
            None => Field::Missing,
            // Whole numbers may be negative: written as in JSON.
            Some(value) => Field::Text(plain(value)),
        }
    }

    /// A parameter that is a number.
    #[must_use]
    pub fn number(&self, key: &str) -> Option<f64> {
        self.parameters.get(key)?.as_f64()
    }
}

/// Flattens the counts: names of operators get their group as prefix.
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
