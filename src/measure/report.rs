//! The results of a measurement, and the time it took.

use crate::base::json;
use crate::netlist::{Netlist, NodeId};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// What is compared with what.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize, PartialOrd, Ord)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// Bit-true against the golden of the quantised inputs.
    Total,
    /// Bit-true against the netlist on reals.
    Arithmetic,
    /// The netlist on reals against the golden of the quantised inputs.
    Algorithm,
    /// Bit-true against the golden of the real inputs.
    EndToEnd,
}

impl Basis {
    /// All of them, in reporting order.
    pub const ALL: [Self; 4] = [Self::Total, Self::Arithmetic, Self::Algorithm, Self::EndToEnd];

    /// Name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Total => "total",
            Self::Arithmetic => "arithmetic",
            Self::Algorithm => "algorithm",
            Self::EndToEnd => "end-to-end",
        }
    }

    /// What is compared with what, in words.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Total => {
                "bit-true against the golden model (double precision) of the quantised inputs: arithmetic and algorithm together"
            }
            Self::Arithmetic => "bit-true against the netlist on reals: words and tables",
            Self::Algorithm => {
                "the netlist on reals against the golden model of the quantised inputs: the method itself"
            }
            Self::EndToEnd => "bit-true against the golden model of the inputs before quantisation",
        }
    }
}

/// The input that gave a maximum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// Number of the sample.
    pub sample: u64,
    /// Input words, by port.
    pub words: Vec<i64>,
    /// Their values.
    pub values: Vec<f64>,
    /// Output words, by port.
    pub outputs: Vec<i64>,
}

/// Statistics of one quantity on one basis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figures {
    /// The quantity. A direction has `angle` (between vectors), `dot` (largest error of a dot
    /// product with any unit vector: the length of the difference) and each component; a number has
    /// its own name.
    pub quantity: String,
    /// `rad`, `texel`, `turn`, `rel` for errors relative to a scale of the golden
    /// ([`Design::scales`](crate::design::Design::scales)), or `1` for absolute errors.
    pub unit: &'static str,
    /// What the error is relative to, in words, if it isn't absolute.
    pub over: Option<String>,
    /// What is compared with what.
    pub basis: Basis,
    /// Largest absolute value.
    #[serde(serialize_with = "json::real")]
    pub max: f64,
    /// The same in ulp of the port or node, for numbers and Cartesian components.
    #[serde(serialize_with = "json::known_real")]
    pub max_ulp: Option<f64>,
    /// The input that gave it.
    pub witness: Option<Witness>,
    /// Mean of the absolute value.
    #[serde(serialize_with = "json::real")]
    pub mean: f64,
    /// Mean with sign.
    #[serde(serialize_with = "json::real")]
    pub bias: f64,
    /// Root of the mean square.
    #[serde(serialize_with = "json::real")]
    pub rms: f64,
    /// Median of the absolute value, to 1.6 %; 0 means below 2^-44.
    #[serde(serialize_with = "json::real")]
    pub p50: f64,
    /// 99th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p99: f64,
    /// 99.9th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p999: f64,
}

/// How often a `narrow` overflowed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OverflowCount {
    /// The node.
    pub node: String,
    /// Its overflow mode.
    pub mode: &'static str,
    /// Number of overflows.
    pub count: u64,
}

/// Counts of the `narrow` nodes that overflowed.
pub(crate) fn overflow_counts(
    netlist: &Netlist,
    narrows: &[NodeId],
    counts: &[u64],
) -> Vec<OverflowCount> {
    narrows
        .iter()
        .zip(counts)
        .filter(|(_, count)| **count > 0)
        .map(|(id, count)| OverflowCount {
            node: netlist.label(*id),
            mode: netlist.node(*id).op.overflow().expect("bug: only narrows are counted").name(),
            count: *count,
        })
        .collect()
}

/// Seconds that each part of a measurement took, summed over all threads. Designs that are measured
/// together split the shared time equally.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Profile {
    /// Drawing inputs.
    pub draw: f64,
    /// Quantising them to words, and converting these back to values.
    pub quantise: f64,
    /// The golden of the inputs before and after quantisation.
    pub golden: f64,
    /// The bit-true engine.
    pub engine: f64,
    /// The netlist on reals.
    pub reals: f64,
    /// Errors, their sums, histograms and witnesses.
    pub statistics: f64,
}

impl Profile {
    /// Each part with its name, in the order of the work.
    #[must_use]
    pub fn parts(&self) -> [(&'static str, f64); 6] {
        [
            ("draw", self.draw),
            ("quantise", self.quantise),
            ("golden", self.golden),
            ("engine", self.engine),
            ("reals", self.reals),
            ("statistics", self.statistics),
        ]
    }

    /// Adds another's seconds.
    pub fn add(&mut self, other: &Self) {
        self.draw += other.draw;
        self.quantise += other.quantise;
        self.golden += other.golden;
        self.engine += other.engine;
        self.reals += other.reals;
        self.statistics += other.statistics;
    }
}

/// Returns the time since the last call.
pub(super) struct Lap(pub(super) Instant);

impl Lap {
    pub(super) fn seconds(&mut self) -> f64 {
        let now = Instant::now();
        let seconds = now.duration_since(self.0).as_secs_f64();
        self.0 = now;
        seconds
    }
}

/// Time spent.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Speed {
    /// Bit-true samples per second and thread: the engine alone.
    pub engine_samples_per_second_per_thread: f64,
    /// Samples per second of the whole run on all threads: inputs, golden, both evaluations,
    /// statistics. If several designs were measured at once, it counts the samples of all.
    pub samples_per_second: f64,
    /// Number of threads.
    pub threads: usize,
    /// Where the time went; not kept in files.
    #[serde(skip)]
    pub profile: Profile,
}

/// The measurement of a design.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Samples measured.
    pub samples: u64,
    /// One entry per quantity and basis.
    pub figures: Vec<Figures>,
    /// Every `narrow` that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
    /// Time spent; the only part that differs from run to run.
    pub speed: Speed,
}

impl Report {
    /// Figures of a quantity on a basis.
    ///
    /// # Panics
    /// If there is no such quantity.
    #[must_use]
    pub fn figures(&self, quantity: &str, basis: Basis) -> &Figures {
        self.figures
            .iter()
            .find(|figures| figures.quantity == quantity && figures.basis == basis)
            .expect("bug: no such quantity")
    }
}
