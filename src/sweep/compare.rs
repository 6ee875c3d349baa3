//! Table 1 of Lee et al. rebuilt: the operators of the architectures, counted from their netlists,
//! beside the paper's figures; and their errors, which the paper lacks.
//!
//! A node belongs to the set-up if its outermost scope is one of the architecture's set-up scopes,
//! otherwise to the illumination. As in the paper, operators inside dividers, roots and table
//! schemes don't count as the datapath's. A *look-up* is a word that a table returns, whatever its
//! scheme; a *map* is a table of two or three angles.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::design::{Design, Role, Unit};
use crate::measure::{self, Basis, Inputs, Report};
use crate::netlist::op::Op;
use crate::netlist::{Netlist, Part, ScopeId};
use crate::report::record::assigned;
use crate::shading::picture::PIXELS_PER_DEGREE;
use crate::shading::render::{Pipeline, check_view, render, set_material};
use crate::shading::scene::Scene;
use serde::{Serialize, Serializer};
use std::collections::BTreeSet;

/// The source of the paper's figures.
pub const SOURCE: &str = "Lee et al., Table 1 and section 4.3";

/// Operators of a stage.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Hardware {
    /// Multipliers.
    pub multipliers: u64,
    /// Adders and subtractors.
    pub adders: u64,
    /// Table look-ups; the paper counts LUTs.
    pub lookups: u64,
    /// Maps.
    pub maps: u64,
    /// Dividers.
    pub dividers: u64,
    /// Square roots.
    pub square_roots: u64,
}

/// Names of the counts, in order.
pub const COUNTS: [&str; 6] =
    ["multipliers", "adders", "look-ups", "maps", "dividers", "square roots"];

impl Hardware {
    const fn new([multipliers, adders, lookups, maps, dividers, square_roots]: [u64; 6]) -> Self {
        Self { multipliers, adders, lookups, maps, dividers, square_roots }
    }

    /// The counts in order.
    #[must_use]
    pub const fn counts(self) -> [u64; 6] {
        let Self { multipliers, adders, lookups, maps, dividers, square_roots } = self;
        [multipliers, adders, lookups, maps, dividers, square_roots]
    }

    /// The sum of two stages that share nothing.
    fn plus(self, other: Self) -> Self {
        let (a, b) = (self.counts(), other.counts());
        Self::new(std::array::from_fn(|i| a[i] + b[i]))
    }
}

/// A column of the paper's Table 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Paper {
    /// Its name there.
    pub name: &'static str,
    /// Illumination environment set-up.
    pub set_up: Hardware,
    /// Illumination calculation, if available.
    pub illumination: Option<Hardware>,
}

const PEERCY: Paper =
    Paper { name: "Peercy", set_up: Hardware::new([27, 18, 0, 0, 9, 3]), illumination: None };
const KUGLER: Paper = Paper {
    name: "Kugler",
    set_up: Hardware::new([5, 2, 3, 1, 0, 0]),
    illumination: Some(Hardware::new([8, 4, 5, 2, 0, 0])),
};
const KIM: Paper = Paper {
    name: "Kim",
    set_up: Hardware::new([31, 18, 6, 0, 0, 0]),
    illumination: Some(Hardware::new([6, 5, 12, 0, 0, 0])),
};
const ERNST: Paper = Paper {
    name: "Ernst",
    set_up: Hardware::new([27, 18, 0, 0, 9, 3]),
    illumination: Some(Hardware::new([7, 5, 1, 0, 0, 0])),
};
const LEE: Paper = Paper {
    name: "Ours",
    set_up: Hardware::new([6, 16, 12, 0, 0, 0]),
    illumination: Some(Hardware::new([2, 11, 8, 0, 0, 0])),
};

/// One architecture as a unit.
#[derive(Debug)]
pub struct Architecture {
    /// Name in reports.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Parameters of the unit that select this architecture.
    pub params: &'static [&'static str],
    /// The paper's counts.
    pub paper: Paper,
    /// Outermost scopes of the set-up.
    pub set_up: &'static [&'static str],
    /// The quantity whose angle is compared.
    pub vector: &'static str,
    /// Why counts differ from the paper's at the defaults.
    pub differences: &'static [Note],
}

/// A count that differs from the paper's at the defaults.
#[derive(Clone, Copy, Debug)]
pub struct Note {
    /// Stage.
    pub stage: Stage,
    /// The counted operator, one of [`COUNTS`].
    pub count: &'static str,
    /// Ours.
    pub ours: u64,
    /// The reason, in one line.
    pub why: &'static str,
}

const fn note(stage: Stage, count: &'static str, ours: u64, why: &'static str) -> Note {
    Note { stage, count, ours, why }
}

/// A stage of Table 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Illumination environment set-up.
    SetUp,
    /// Illumination calculation.
    Illumination,
}

impl Stage {
    /// Name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::SetUp => "set-up",
            Self::Illumination => "illumination",
        }
    }
}

use Stage::{Illumination, SetUp};

const ROTATIONS: &[&str] = &["light", "half", "bump"];
/// The reason for differences that don't appear at the defaults.
pub const BY_PARAMETERS: &str = "it comes with the parameters that were set";

const FOR_PSI: &str =
    "one more rotates N' by psi, for texture axes that don't follow N's own frame";
const TABLES: &str =
    "the paper counts 6 tables per vector: sines and cosines at X and Y are 4 words of one of them";
const TEXT: &str = "the paper's section 4.2 says 13 as well, its Table 1 says 11";

const SEED: &[Note] = &[
    note(SetUp, "adders", 17, FOR_PSI),
    note(SetUp, "look-ups", 18, TABLES),
    note(Illumination, "adders", 13, TEXT),
];

/// Every architecture, in the paper's order; this project's pipelines follow.
pub static ARCHITECTURES: &[Architecture] = &[
    Architecture {
        name: "peercy",
        unit: "peercy",
        params: &[],
        paper: PEERCY,
        set_up: &["setup"],
        vector: "lt_angle",
        differences: &[],
    },
    Architecture {
        name: "kugler",
        unit: "kugler",
        params: &[],
        paper: KUGLER,
        set_up: &["setup"],
        vector: "pl_angle",
        differences: &[
            note(
                SetUp,
                "multipliers",
                3,
                "reconstruction: two ratios and a length turn the normal into angles; the paper doesn't say what its 5 do",
            ),
            note(
                SetUp,
                "adders",
                6,
                "two rotate, as in the paper; four fold octants of the normal's angles",
            ),
            note(
                SetUp,
                "look-ups",
                5,
                "the normal's angles need two reciprocals, two arctangents and a secant, words of two tables",
            ),
            note(
                Illumination,
                "multipliers",
                0,
                "reconstruction: the set-up's map rotates N' into the light's frame without a product",
            ),
            note(
                Illumination,
                "adders",
                3,
                "a difference of azimuths for each light, and the sum of both lights",
            ),
            note(
                Illumination,
                "look-ups",
                0,
                "addresses come from the set-up's map, not from LUTs",
            ),
            note(
                Illumination,
                "maps",
                3,
                "two light maps as in the paper, and the set-up's map again for their addresses",
            ),
        ],
    },
    Architecture {
        name: "kim",
        unit: "kim",
        params: &[],
        paper: KIM,
        set_up: &["setup"],
        vector: "lt_angle",
        differences: &[
            note(
                SetUp,
                "multipliers",
                30,
                "reconstruction: 8 for components and frame, 16 in the transforms, whose binormal has no z, 6 for angles",
            ),
            note(
                SetUp,
                "adders",
                19,
                "reconstruction: 10 in the transforms, 8 fold octants of angles, 1 for psi",
            ),
            note(
                SetUp,
                "look-ups",
                22,
                "sines and cosines of six angles are 12 words of one table; 10 turn components into angles",
            ),
            note(Illumination, "look-ups", 10, "sine and cosine of N' serve both dot products"),
        ],
    },
    Architecture {
        name: "ernst",
        unit: "ernst",
        params: &[],
        paper: ERNST,
        set_up: &["setup"],
        vector: "lt_angle",
        differences: &[note(Illumination, "adders", 6, "one more adds the ambient light")],
    },
    Architecture {
        name: "lee printed",
        unit: "bump",
        params: &["pipeline=printed"],
        paper: LEE,
        set_up: ROTATIONS,
        vector: "lt_angle",
        differences: SEED,
    },
    Architecture {
        name: "lee corrected",
        unit: "bump",
        params: &["pipeline=corrected"],
        paper: LEE,
        set_up: ROTATIONS,
        vector: "lt_angle",
        differences: SEED,
    },
    Architecture {
        name: "exact-polar",
        unit: "bump",
        params: &["pipeline=exact-polar"],
        paper: LEE,
        set_up: ROTATIONS,
        vector: "lt_angle",
        differences: &[
            note(
                SetUp,
                "adders",
                49,
                "for each vector 9 for angles, 11 for sums in place of products, 4 that fold octants; 1 for psi",
            ),
            note(
                SetUp,
                "look-ups",
                38,
                "for each vector 14 sines and cosines of 8 angles, and 5 words that turn components into angles",
            ),
            note(Illumination, "adders", 13, TEXT),
        ],
    },
    Architecture {
        name: "exact-cartesian",
        unit: "bump",
        params: &["pipeline=exact-cartesian"],
        paper: LEE,
        set_up: ROTATIONS,
        vector: "lt_angle",
        differences: &[
            note(
                SetUp,
                "multipliers",
                4,
                "none in the rotation; four rotate N' by psi in components",
            ),
            note(
                SetUp,
                "adders",
                42,
                "for each vector 9 for angles and 11 for sums in place of products; two rotate N' by psi",
            ),
            note(
                SetUp,
                "look-ups",
                30,
                "for each vector 14 sines and cosines of 8 angles; two of psi",
            ),
            note(Illumination, "multipliers", 6, "dot products of components take three each"),
            note(Illumination, "adders", 5, "two in each dot product, and the sum of both lights"),
            note(Illumination, "look-ups", 2, "the light tables alone"),
        ],
    },
];

/// Counts the operators in some scopes of a netlist.
#[must_use]
pub fn hardware(netlist: &Netlist, counted: impl Fn(ScopeId) -> bool) -> Hardware {
    let counts = netlist.counts_of(&counted);
    // Words that come from a table and leave the table scheme.
    let scheme = |scope| netlist.part_of(scope).filter(|(part, _)| *part == Part::Scheme);
    let nodes = netlist.nodes();
    let mut of_table = vec![false; nodes.len()];
    let mut lookups = BTreeSet::new();
    let mut accesses = BTreeSet::new();
    for (id, node) in netlist.ids().zip(nodes) {
        let within = scheme(node.scope);
        of_table[id.index()] = within.is_some()
            && (matches!(node.op, Op::Read { .. })
                || node.operands.iter().any(|operand| of_table[operand.index()]));
        if let (None, None, Op::Read { table, .. }) = (within, netlist.part_of(node.scope), node.op)
            && counted(node.scope)
        {
            accesses.insert((table, node.operands[0]));
        }
        for operand in &node.operands {
            let from = nodes[operand.index()].scope;
            if of_table[operand.index()] && scheme(from) != within && counted(from) {
                lookups.insert(*operand);
            }
        }
    }
    let maps: BTreeSet<_> = accesses.iter().map(|(table, _)| *table).collect();
    Hardware {
        multipliers: counts.datapath.multipliers,
        adders: counts.datapath.adders,
        lookups: cast::count_of(lookups.len()),
        maps: cast::count_of(maps.len()),
        dividers: counts.dividers,
        square_roots: counts.square_roots,
    }
}

/// Mean, 99th percentile and maximum of an error.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Spread {
    /// Mean of the absolute value.
    pub mean: f64,
    /// 99th percentile, to 1.6 %.
    pub p99: f64,
    /// Largest absolute value.
    pub max: f64,
}

impl Spread {
    fn of(report: &Report, quantity: &str) -> Option<Self> {
        let here = report.figures.iter().any(|figures| figures.quantity == quantity);
        here.then(|| {
            let figures = report.figures(quantity, Basis::EndToEnd);
            Self { mean: figures.mean, p99: figures.p99, max: figures.max }
        })
    }
}

/// An architecture counted and measured.
#[derive(Debug, Serialize)]
pub struct Row {
    /// The architecture's name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Parameters that differ from the unit's defaults, as `key=value`; in JSON they are an object.
    #[serde(serialize_with = "as_parameters")]
    pub parameters: Vec<String>,
    /// The paper's column.
    pub paper: Paper,
    /// Set-up.
    pub set_up: Hardware,
    /// Illumination; `None` if the unit has none.
    pub illumination: Option<Hardware>,
    /// Both stages; shared operators count once.
    pub whole: Hardware,
    /// Distinct tables and maps.
    pub tables: u64,
    /// Their stored bits.
    pub rom_bits: u64,
    /// Latency.
    pub latency_cycles: u32,
    /// Angle error of the direction whose quantity is `vector`, in rad, end to end.
    pub angle: Option<Spread>,
    /// That quantity.
    pub vector: &'static str,
    /// N'·L, end to end.
    pub dot: Option<Spread>,
    /// Light of the pixel, end to end.
    pub intensity: Option<Spread>,
    /// Difference of each scene's picture from the golden one; empty if the unit computes no light.
    pub images: Vec<ImageError>,
    /// Each count that differs from the paper's.
    pub differences: Vec<Difference>,
}

/// Serialises `key=value` as parameters by name.
fn as_parameters<S: Serializer>(assignments: &[String], to: S) -> Result<S::Ok, S::Error> {
    assigned(assignments).serialize(to)
}

/// How far a scene's picture is from the golden one, in linear light.
#[derive(Clone, Debug, Serialize)]
pub struct ImageError {
    /// The scene.
    pub scene: String,
    /// The largest difference of a channel.
    pub max: f64,
    /// The mean difference.
    pub mean: f64,
    /// LDR-FLIP.
    pub flip: f64,
}

/// A count that differs from the paper's.
#[derive(Debug, Serialize)]
pub struct Difference {
    /// Stage.
    pub stage: Stage,
    /// The counted operator.
    pub count: &'static str,
    /// Ours.
    pub ours: u64,
    /// The paper's.
    pub paper: u64,
    /// The reason, in one line.
    pub why: &'static str,
}

impl Row {
    /// Counts of a stage and the paper's, where available.
    #[must_use]
    pub fn stage(&self, stage: Stage) -> (Option<Hardware>, Option<Hardware>) {
        match stage {
            SetUp => (Some(self.set_up), Some(self.paper.set_up)),
            Illumination => (self.illumination, self.paper.illumination),
        }
    }
}

/// The claim "up to 78 % fewer multiplications", in one of its readings.
#[derive(Debug, Serialize)]
pub struct Claim {
    /// The pipeline that is compared.
    pub name: &'static str,
    /// What it is compared with.
    pub against: &'static str,
    /// Its multipliers, and those of the other.
    pub multipliers: [u64; 2],
    /// The same according to the paper.
    pub paper: [u64; 2],
}

/// Share of multipliers that is saved, in percent.
#[must_use]
pub fn saved_percent([of, against]: [u64; 2]) -> f64 {
    100.0 * (1.0 - cast::f64_of_count(of) / cast::f64_of_count(against))
}

/// Table 1 rebuilt.
#[derive(Debug, Serialize)]
pub struct Comparison {
    /// The source of the paper's figures.
    pub source: &'static str,
    /// Fragments measured.
    pub samples: u64,
    /// Seed of their random stream.
    pub seed: u64,
    /// One per architecture.
    pub rows: Vec<Row>,
    /// Both readings of the claim for each pipeline of the paper's authors and of this project.
    pub claims: Vec<Claim>,
    /// Scenes that were rendered.
    pub scenes: Vec<SceneRendered>,
}

/// A scene that was rendered.
#[derive(Debug, Serialize)]
pub struct SceneRendered {
    /// Its name.
    pub scene: String,
    /// Pixels that see an object: means of pictures are over these.
    pub covered_px: u64,
    /// Other pixels.
    pub background_px: u64,
    /// How it deviates from its files, or that it stands still.
    pub notes: Vec<String>,
}

/// Name of the parameter that `key=value` sets.
fn name_of(set: &str) -> Option<&str> {
    set.split_once('=').map(|(name, _)| name)
}

/// Builds, counts and measures every architecture; `set` are `key=value` for those that have the
/// parameter. `progress` receives each one's name and the number of samples done.
///
/// # Errors
/// If a value is not legal, or no architecture has the parameter.
///
/// # Panics
/// If an architecture that the claim names is not listed, which is a bug.
pub fn compare(
    set: &[String],
    inputs: &Inputs,
    progress: &(dyn Fn(&str, u64) + Sync),
) -> Result<Comparison> {
    for set in set {
        let name = name_of(set).ok_or_else(|| Error::form(set, "key=value"))?;
        let known =
            |a: &Architecture| Unit::find(a.unit).is_ok_and(|unit| unit.find_param(name).is_some());
        if !ARCHITECTURES.iter().any(known) {
            let text = format!("no architecture has a parameter `{name}`");
            return Err(Error::usage(text));
        }
    }
    let row = |architecture: &'static Architecture| {
        let unit = Unit::find(architecture.unit)?;
        let mut assignments: Vec<String> =
            architecture.params.iter().map(|&param| param.to_owned()).collect();
        let has = |set: &&String| name_of(set).is_some_and(|name| unit.find_param(name).is_some());
        assignments.extend(set.iter().filter(has).cloned());
        let design = unit.values(&assignments)?.build()?;
        progress(architecture.name, 0);
        let done = |samples| progress(architecture.name, samples);
        let report = measure::measure(&[&design], inputs, &done)?.remove(0);
        row_of(architecture, assignments, &design, &report)
    };
    let rows = ARCHITECTURES.iter().map(row).collect::<Result<Vec<Row>>>()?;
    let find = |name: &str| rows.iter().find(|row| row.name == name).expect("bug: it is listed");
    let (peercy, kim) = (find("peercy"), find("kim"));
    let mut claims = Vec::new();
    for row in rows.iter().filter(|row| row.unit == "bump") {
        claims.push(Claim {
            name: row.name,
            against: "set-up against peercy",
            multipliers: [row.set_up.multipliers, peercy.set_up.multipliers],
            paper: [LEE.set_up.multipliers, PEERCY.set_up.multipliers],
        });
        claims.push(Claim {
            name: row.name,
            against: "whole against kim",
            multipliers: [row.whole.multipliers, kim.whole.multipliers],
            paper: [LEE, KIM].map(|paper| whole(paper).map_or(0, |whole| whole.multipliers)),
        });
    }
    Ok(Comparison {
        source: SOURCE,
        samples: inputs.samples,
        seed: inputs.seed,
        rows,
        claims,
        scenes: Vec::new(),
    })
}

impl Comparison {
    /// Renders a scene with every architecture that computes light, and adds the results. Material
    /// parameters that were set also apply to the scene and to its golden.
    ///
    /// # Errors
    /// If the scene's material can't be combined with the parameters that were set.
    pub fn add_scene(
        &mut self,
        name: &str,
        scene: &Scene,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<()> {
        let (mut pipelines, mut of) = (Vec::new(), Vec::new());
        let mut scene = scene.clone();
        for (at, row) in self.rows.iter().enumerate().filter(|(_, row)| row.intensity.is_some()) {
            let unit = Unit::find(row.unit)?;
            let values = unit.values(&row.parameters)?;
            for (param, value) in values.params() {
                let Role::Material(part) = param.role else { continue };
                let is_set = |set: &String| name_of(set) == Some(&param.name);
                if row.parameters.iter().any(is_set) {
                    set_material(&mut scene, part, value);
                }
            }
            pipelines.push(Pipeline::of_unit(row.name, unit, &row.parameters));
            of.push(at);
        }
        check_view(&scene)?;
        let rendered = render(&scene, &pipelines, false, progress)?;
        self.scenes.push(SceneRendered {
            scene: name.to_owned(),
            covered_px: rendered.covered,
            background_px: scene.image.pixels() - rendered.covered,
            notes: scene.notes_at_start(),
        });
        for (at, shot) in of.into_iter().zip(&rendered.shots) {
            let d = rendered.difference(&shot.picture, &rendered.golden, PIXELS_PER_DEGREE)?;
            self.rows[at].images.push(ImageError {
                scene: name.to_owned(),
                max: d.max.difference,
                mean: d.mean,
                flip: d.flip,
            });
        }
        Ok(())
    }
}

/// Both stages of the paper, if both are available.
#[must_use]
pub fn whole(paper: Paper) -> Option<Hardware> {
    paper.illumination.map(|illumination| paper.set_up.plus(illumination))
}

fn row_of(
    architecture: &'static Architecture,
    parameters: Vec<String>,
    design: &Design,
    report: &Report,
) -> Result<Row> {
    let netlist = &design.netlist;
    let in_set_up = |scope| {
        let path = netlist.scope_path(scope);
        path.first().is_some_and(|first| architecture.set_up.contains(first))
    };
    let counts = netlist.counts();
    let lit = netlist.outputs().iter().any(|output| output.name == "intensity");
    let mut row = Row {
        name: architecture.name,
        unit: architecture.unit,
        parameters,
        paper: architecture.paper,
        set_up: hardware(netlist, in_set_up),
        illumination: lit.then(|| hardware(netlist, |scope| !in_set_up(scope))),
        whole: hardware(netlist, |_| true),
        tables: counts.tables,
        rom_bits: counts.rom_bits,
        latency_cycles: design.rtl()?.schedule().latency(),
        angle: Spread::of(report, architecture.vector),
        vector: architecture.vector,
        dot: Spread::of(report, "dot_l"),
        intensity: Spread::of(report, "intensity"),
        images: Vec::new(),
        differences: Vec::new(),
    };
    for stage in [SetUp, Illumination] {
        let (Some(ours), Some(paper)) = row.stage(stage) else { continue };
        for ((count, ours), paper) in COUNTS.into_iter().zip(ours.counts()).zip(paper.counts()) {
            if ours != paper {
                let known = architecture.differences.iter();
                let note = known
                    .filter(|note| note.stage == stage && note.count == count && note.ours == ours)
                    .map(|note| note.why)
                    .next();
                let why = note.unwrap_or(BY_PARAMETERS);
                row.differences.push(Difference { stage, count, ours, paper, why });
            }
        }
    }
    Ok(row)
}
