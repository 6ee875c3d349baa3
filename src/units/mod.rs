//! Units: parameterised datapaths with their golden models.
//!
//! A unit is one file and one row of [`UNITS`]: its parameters with their legal
//! ranges, its netlist, its golden function in plain floating point (written
//! from the mathematics and not from the netlist), its input sampler, its hard
//! cases and its stated error bound. The command line, the suite, the sweep and
//! the reports know units only through this table.

pub mod basis;
pub mod bump;
pub mod combine;
pub mod cross;
mod divide;
pub mod dot;
pub mod emboss;
pub mod ernst;
pub mod fragment;
pub mod illumination;
pub mod kim;
pub mod kugler;
pub mod normalise;
pub mod peercy;
mod plan;
mod polar;
mod root;
pub mod rotation;
pub mod rsqrt;
pub mod sampler;
mod setup;
pub mod tangent;

use crate::cast;
use crate::error::{Error, Result};
use crate::format::{Format, Round};
use crate::function::Function;
pub use crate::function::Number;
use crate::lut::{Scheme, Spec};
use crate::netlist::{Netlist, NodeId};
use crate::rtl::Rtl;
use crate::schedule::{Binding, Depth, Kind as Shared, Plan, Rom, Schedule, Share};
use crate::whole;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::TAU;
use std::fmt;
use std::sync::Arc;

/// Every unit.
pub static UNITS: &[&Unit] = &[
    &rotation::ROTATION,
    &illumination::ILLUMINATION,
    &bump::BUMP,
    &peercy::PEERCY,
    &ernst::ERNST,
    &kim::KIM,
    &kugler::KUGLER,
    &dot::DOT,
    &normalise::NORMALISE,
    &rsqrt::RSQRT,
    &cross::CROSS,
    &basis::BASIS,
    &emboss::EMBOSS,
    &sampler::SAMPLER,
    &combine::COMBINE,
    &tangent::TANGENT,
];

/// A parameterised datapath.
#[derive(Debug)]
pub struct Unit {
    /// Name on the command line.
    pub name: &'static str,
    /// What it computes, in one line.
    pub summary: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Its own parameters; [`PIPELINE`] follows them.
    pub params: &'static [Param],
    /// Those of its own parameters that the golden model, the sampler or the set of ports depends
    /// on: designs that differ in them share no golden values.
    pub golden_params: &'static [&'static str],
    /// Names of the input ports with what they measure, for `list`.
    pub inputs: &'static str,
    /// Names of the output ports, for `list`.
    pub outputs: &'static str,
    /// Whether it shades the pixels of a scene.
    pub shades: Shading,
    /// Builds the datapath.
    pub build: fn(&Values) -> Result<Design>,
}

/// Whether a unit shades the pixels of a scene: its inputs are then those of a [`fragment`], and it has outputs
/// `diffuse` and, if it has highlights, `specular`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shading {
    /// It doesn't.
    None,
    /// It does, from vectors that floating point turned into the texture frame.
    Part,
    /// It is a pipeline of its own, or has a parameter of [`Role::Pipeline`] whose choices are.
    Pipeline,
}

/// A parameter of a unit.
#[derive(Clone, Copy, Debug)]
pub struct Param {
    /// Name on the command line.
    pub name: &'static str,
    /// What it is for.
    pub role: Role,
    /// What values it takes.
    pub kind: Kind,
    /// Its default, as one would write it.
    pub default: &'static str,
    /// One line of help.
    pub help: &'static str,
}

/// What a parameter is for. Whatever treats some parameters alike goes by this and not by their names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Bits of words, or of their whole, fraction or guard part.
    Width,
    /// Address bits of tables.
    TableSize,
    /// Size of a map that the datapath addresses.
    MapSize,
    /// Steps of an algorithm that is unrolled.
    Iterations,
    /// Which of several algorithms the unit is.
    Variant,
    /// As [`Role::Variant`], where each is a pipeline of its own on a scene, with a name.
    Pipeline,
    /// How tables approximate.
    Scheme,
    /// What becomes of bits that are dropped.
    Rounding,
    /// What becomes of values past a format.
    Overflow,
    /// How a part of the datapath is made, or whether it is there.
    Switch,
    /// A number that the datapath holds.
    Constant,
    /// How many ports of a kind there are.
    Count,
    /// A part of the reflection formula: on a scene it comes from material and light.
    Material(Reflection),
    /// Told, and of no effect.
    Label,
    /// Clock, latency, and how tables are read.
    Timing,
    /// Which kind of schedule there is.
    Schedule,
    /// What counts with a schedule that shares units.
    Sharing,
    /// How many units serve operations of a kind, with such a schedule.
    Share(Shared),
}

impl Role {
    /// Name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Width => "width",
            Self::TableSize => "table-size",
            Self::MapSize => "map-size",
            Self::Iterations => "iterations",
            Self::Variant => "variant",
            Self::Pipeline => "pipeline",
            Self::Scheme => "scheme",
            Self::Rounding => "rounding",
            Self::Overflow => "overflow",
            Self::Switch => "switch",
            Self::Constant => "constant",
            Self::Count => "count",
            Self::Material(_) => "material",
            Self::Label => "label",
            Self::Timing => "timing",
            Self::Schedule => "schedule",
            Self::Sharing | Self::Share(_) => "sharing",
        }
    }

    /// True if it counts only with another schedule than the flat one.
    fn is_of_sharing(self) -> bool {
        matches!(self, Self::Sharing | Self::Share(_))
    }
}

/// Parts of the reflection formula.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Reflection {
    /// Ambient light.
    Ambient,
    /// The diffuse reflection.
    Diffuse,
    /// The specular reflection.
    Specular,
    /// Its exponent.
    Exponent,
}

/// What values a parameter takes.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// A whole number in a range, or `auto` if there is a text that says what that means.
    Int {
        /// Least legal value.
        min: i64,
        /// Greatest legal value.
        max: i64,
        /// Meaning of `auto`, if it is legal.
        auto: Option<&'static str>,
    },
    /// A number in a range.
    Real {
        /// Least legal value.
        min: f64,
        /// Greatest legal value.
        max: f64,
    },
    /// One of some names.
    Choice(&'static [&'static str]),
}

impl Kind {
    /// The legal values in words.
    #[must_use]
    pub fn legal(self) -> String {
        match self {
            Self::Int { min, max, auto: None } => format!("{min} to {max}"),
            Self::Int { min, max, auto: Some(auto) } => format!("{min} to {max}, or auto ({auto})"),
            Self::Real { min, max } => format!("{min} to {max}, also with fractions"),
            Self::Choice(names) => names.join(", "),
        }
    }
}

/// Parameters of the pipeline, common to all units.
pub static PIPELINE: &[Param] = &[
    Param {
        name: "period_ps",
        role: Role::Timing,
        kind: Kind::Int { min: 100, max: 1_000_000, auto: None },
        default: "5000",
        help: "target clock period of the pipeline in ps, by the stated delay model",
    },
    Param {
        name: "stages",
        role: Role::Timing,
        kind: Kind::Int { min: 0, max: 256, auto: Some("as many as the target period asks for") },
        default: "auto",
        help: "latency in cycles, over period_ps; 0 is combinational and asks for rom=distributed",
    },
    Param {
        name: "rom",
        role: Role::Timing,
        kind: Kind::Choice(&["block", "distributed"]),
        default: "block",
        help: "table reads take a clock (block RAM) or none (distributed logic)",
    },
    Param {
        name: "schedule",
        role: Role::Schedule,
        kind: Kind::Choice(&["flat", "shared", "printed"]),
        default: "flat",
        help: "flat: a sample a cycle; shared: operations share units by share_*; printed: as bound by hand, where a unit brings that",
    },
    Param {
        name: "interval",
        role: Role::Sharing,
        kind: Kind::Int { min: 1, max: 1024, auto: Some("as short as the units allow") },
        default: "auto",
        help: "cycles from one sample to the next with schedule=shared",
    },
    share(
        Shared::Dot,
        "share_dot",
        "dot products of three: units for each structure, with schedule=shared",
    ),
    share(
        Shared::Multiplier,
        "share_mul",
        "multipliers outside of roots, dividers, table schemes and dot products that share_dot shares: units, with schedule=shared",
    ),
    share(Shared::Adder, "share_add", "adders outside of the same: units, with schedule=shared"),
    share(
        Shared::Table,
        "share_table",
        "table schemes: units for each structure, with schedule=shared",
    ),
    share(
        Shared::Root,
        "share_root",
        "roots and reciprocal roots: units for each structure, with schedule=shared",
    ),
    share(
        Shared::Divider,
        "share_divide",
        "dividers: units for each structure, with schedule=shared",
    ),
    Param {
        name: "share_latency",
        role: Role::Sharing,
        kind: Kind::Int { min: 0, max: 64, auto: Some("by the delay model and period_ps") },
        default: "auto",
        help: "cycles from issue to output of each shared unit",
    },
    Param {
        name: "share_loads",
        role: Role::Sharing,
        kind: Kind::Choice(&["no", "yes"]),
        default: "no",
        help: "operands of shared units are registered in the cycle before the issue",
    },
];

const fn share(kind: Shared, name: &'static str, help: &'static str) -> Param {
    let auto = Some("hardware for each use");
    let role = Role::Share(kind);
    Param { name, role, kind: Kind::Int { min: 1, max: 1024, auto }, default: "auto", help }
}

impl Unit {
    /// The unit of this name.
    ///
    /// # Errors
    /// If there is none; the message names the nearest.
    pub fn find(name: &str) -> Result<&'static Self> {
        UNITS
            .iter()
            .find(|unit| unit.name == name)
            .copied()
            .ok_or_else(|| Error::unknown_unit(name, UNITS.iter().map(|unit| unit.name)))
    }

    /// All parameters: its own, then the pipeline's.
    pub fn all_params(&self) -> impl Iterator<Item = &'static Param> + use<> {
        self.params.iter().chain(PIPELINE)
    }

    /// The parameter of a name.
    #[must_use]
    pub fn param(&self, name: &str) -> Option<&'static Param> {
        self.all_params().find(|param| param.name == name)
    }

    /// The defaults.
    ///
    /// # Panics
    /// If a default is not legal: that is wrong code.
    #[must_use]
    pub fn defaults(&'static self) -> Values {
        let values = self
            .all_params()
            .map(|param| param.parse(param.default).expect("bug: a default is legal"))
            .collect();
        Values { unit: self, values }
    }

    /// The defaults with some `key=value` assignments.
    ///
    /// # Errors
    /// If a name is unknown or given twice, or a value is not legal.
    pub fn values<S: AsRef<str>>(&'static self, assignments: &[S]) -> Result<Values> {
        let mut values = self.defaults();
        let mut given: Vec<&str> = Vec::new();
        for assignment in assignments {
            let text = assignment.as_ref();
            let (name, value) =
                text.split_once('=').ok_or_else(|| Error::form(text, "key=value"))?;
            values.set(name, value)?;
            if given.contains(&name) {
                return Err(Error::usage(format!("parameter `{name}` is given twice")));
            }
            given.push(name);
        }
        Ok(values)
    }
}

/// Value of a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum Value {
    /// A whole number.
    Int(i64),
    /// A number.
    Real(Number),
    /// `auto`.
    Auto,
    /// A name.
    Choice(&'static str),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(number) => f.pad(&number.to_string()),
            Self::Real(number) => f.pad(&number.get().to_string()),
            Self::Auto => f.pad("auto"),
            Self::Choice(name) => f.pad(name),
        }
    }
}

impl Param {
    /// Reads a value.
    ///
    /// # Errors
    /// If it is not legal; the message names the legal values.
    pub fn parse(&self, text: &str) -> Result<Value> {
        let value = match self.kind {
            Kind::Int { auto: Some(_), .. } if text == "auto" => Some(Value::Auto),
            Kind::Int { min, max, .. } => {
                whole::signed(text).filter(|n| (min..=max).contains(n)).map(Value::Int)
            }
            Kind::Real { min, max } => text
                .parse()
                .ok()
                .filter(|x| (min..=max).contains(x)) // not NaN
                .map(|x: f64| Value::Real(x.into())),
            Kind::Choice(names) => {
                names.iter().find(|name| **name == text).map(|name| Value::Choice(name))
            }
        };
        value.ok_or_else(|| Error::parameter_value(self.name, text, self.kind.legal()))
    }
}

/// One value for each parameter of a unit.
#[derive(Clone, Debug)]
pub struct Values {
    unit: &'static Unit,
    values: Vec<Value>,
}

impl Values {
    /// The unit that they belong to.
    #[must_use]
    pub fn unit(&self) -> &'static Unit {
        self.unit
    }

    /// Sets one parameter from text.
    ///
    /// # Errors
    /// If the name is unknown or the value not legal.
    #[expect(clippy::missing_panics_doc, reason = "the index was found just before")]
    pub fn set(&mut self, name: &str, text: &str) -> Result<()> {
        let position = self.unit.all_params().position(|param| param.name == name);
        let index = position.ok_or_else(|| {
            Error::unknown_parameter(self.unit.name, name, self.unit.all_params().map(|p| p.name))
        })?;
        let param = self.unit.all_params().nth(index).expect("bug: found above");
        self.values[index] = param.parse(text)?;
        Ok(())
    }

    /// As [`Values::iter`], without what only counts for shared units where none are.
    pub fn told(&self) -> impl Iterator<Item = (&'static str, Value)> + '_ {
        let flat = self.choice("schedule") == "flat";
        let silent = move |role: Role| flat && (role == Role::Schedule || role.is_of_sharing());
        self.params()
            .filter(move |(param, _)| !silent(param.role))
            .map(|(p, value)| (p.name, value))
    }

    /// Pairs of parameter and value, in order.
    pub fn params(&self) -> impl Iterator<Item = (&'static Param, Value)> + '_ {
        self.unit.all_params().zip(self.values.iter().copied())
    }

    /// Pairs of name and value in the order of the parameters.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Value)> + '_ {
        self.params().map(|(param, value)| (param.name, value))
    }

    /// The value of a parameter.
    ///
    /// # Panics
    /// If there is no such parameter.
    #[must_use]
    pub fn get(&self, name: &str) -> Value {
        self.iter().find(|(known, _)| *known == name).expect("bug: unknown parameter").1
    }

    /// A whole number; `None` for `auto`.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn int(&self, name: &str) -> Option<i64> {
        match self.get(name) {
            Value::Int(number) => Some(number),
            Value::Auto => None,
            Value::Real(_) | Value::Choice(_) => panic!("bug: `{name}` is no whole number"),
        }
    }

    /// The value of what it takes of the reflection formula, if it takes that.
    #[must_use]
    pub fn reflection(&self, part: Reflection) -> Option<Value> {
        self.params().find(|(param, _)| param.role == Role::Material(part)).map(|(_, value)| value)
    }

    /// A number.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn real(&self, name: &str) -> f64 {
        match self.get(name) {
            Value::Real(number) => number.get(),
            Value::Int(_) | Value::Auto | Value::Choice(_) => panic!("bug: `{name}` is no number"),
        }
    }

    /// A count of bits that has no `auto`.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn bits(&self, name: &str) -> u32 {
        let number = self.int(name).expect("bug: no auto here");
        u32::try_from(number).expect("bug: counts of bits are small")
    }

    /// A name.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn choice(&self, name: &str) -> &'static str {
        match self.get(name) {
            Value::Choice(choice) => choice,
            Value::Int(_) | Value::Real(_) | Value::Auto => panic!("bug: `{name}` is no name"),
        }
    }

    /// The error for a value that is legal by itself and not together with others.
    #[must_use]
    pub fn refuse(&self, name: &str, legal: &str) -> Error {
        Error::parameter_value(name, &self.get(name).to_string(), legal.to_owned())
    }

    /// Builds the datapath.
    ///
    /// # Errors
    /// If these values don't go together, or a word would be wider than 63 bits.
    pub fn build(&self) -> Result<Design> {
        let build = self.unit.build;
        build(self).map_err(|error| self.with_remedy(error, &|values| build(values).map(|_| ())))
    }

    /// An error of a word that is too wide in what `make` makes, with the parameters that make it narrower.
    fn with_remedy(&self, error: Error, make: &dyn Fn(&Self) -> Result<()>) -> Error {
        let (node, place, needed) = match error.bits_needed() {
            Some((node, place, bits)) if bits > Format::MAX_BITS => (node, place, bits),
            Some(_) | None => return error,
        };
        let narrower = |step: i64, (index, param): (usize, &Param)| -> Option<String> {
            let (Kind::Int { min, max, .. }, Value::Int(number)) = (param.kind, self.values[index])
            else {
                return None;
            };
            let changed = (number + step).clamp(min, max);
            let mut other = self.clone();
            other.values[index] = Value::Int(changed);
            let helps = changed != number
                && match make(&other) {
                    Ok(()) => true,
                    // Another node is the next one that is too wide: the first one isn't any more.
                    Err(other) => other.bits_needed().is_some_and(|(other, later, bits)| {
                        bits < needed || (other != node && later > place)
                    }),
                };
            helps.then(|| format!("`{}`", param.name))
        };
        let all = |step| -> Vec<String> {
            self.unit.params.iter().enumerate().filter_map(|param| narrower(step, param)).collect()
        };
        // Where one bit shows nothing, many may: sums of many terms pass the limit at another term.
        let steps = [(-1, "lower"), (-64, "lower"), (1, "raise")];
        let mut remedies = steps.into_iter().filter_map(|(step, verb)| {
            let names = all(step);
            (!names.is_empty()).then(|| format!("{verb} {}", names.join(" or ")))
        });
        match remedies.next() {
            Some(remedy) => error.with_remedy(remedy),
            None => error,
        }
    }
}

impl Design {
    /// The nodes of all groups in order, which start with the output ports.
    #[must_use]
    pub fn judged(&self) -> Vec<NodeId> {
        self.groups.iter().flat_map(|group| group.nodes.iter().copied()).collect()
    }

    /// Number of the golden model's columns: those of all groups, then the scales.
    #[must_use]
    pub fn golden_columns(&self) -> usize {
        let columns = |shape: Shape| shape.columns().len() + shape.scales().len();
        self.groups.iter().map(|group| columns(group.shape)).sum()
    }

    /// What the errors of some quantities are told over, by the quantities' names.
    #[must_use]
    pub fn scales(&self) -> Vec<(String, &'static str)> {
        let of = |group: &Group| -> Vec<(String, &'static str)> {
            let scales = group.shape.scales().iter();
            scales.map(|scale| (prefixed(group.name, scale.name), scale.what)).collect()
        };
        self.groups.iter().flat_map(of).collect()
    }

    /// Values that a row of golden columns means for the judged nodes.
    #[must_use]
    pub fn of_golden(&self, row: &[f64]) -> Vec<f64> {
        let mut values = Vec::new();
        let mut at = 0;
        for group in &self.groups {
            let columns = group.shape.columns().len();
            values.extend(group.shape.of_golden(&row[at..at + columns]));
            at += columns;
        }
        values
    }

    /// The parameters that the golden model depends on.
    pub(crate) fn golden_key(&self) -> Vec<Value> {
        self.values.unit().golden_params.iter().map(|name| self.values.get(name)).collect()
    }

    /// The schedule by hand, if the parameters ask for it.
    #[must_use]
    pub fn printed(&self) -> Option<&Binding> {
        self.binding.as_ref().filter(|_| self.values.choice("schedule") == "printed")
    }

    /// The hardware that the pipeline parameters ask for.
    ///
    /// # Errors
    /// If the latency or interval asked for is too short, a shared unit would have words over 63
    /// bits, or parameters of one schedule are set for another.
    pub fn rtl(&self) -> Result<Rtl> {
        let make = |values: &Values| (values.unit.build)(values)?.hardware().map(|_| ());
        self.hardware().map_err(|error| self.values.with_remedy(error, &make))
    }

    fn hardware(&self) -> Result<Rtl> {
        let values = &self.values;
        let rom = if values.choice("rom") == "block" { Rom::Block } else { Rom::Distributed };
        let count = |n: i64| u32::try_from(n).expect("bug: legal values are small");
        let period = count(values.int("period_ps").expect("bug: no auto here"));
        let stages = values.int("stages").map(count);
        let kind = values.choice("schedule");
        // What only a found schedule takes must not be set for another.
        for (param, value) in values.params().filter(|(param, _)| param.role.is_of_sharing()) {
            if kind != "shared" && value.to_string() != param.default {
                let legal = format!(
                    "{} with schedule={kind}; it counts with schedule=shared",
                    param.default
                );
                return Err(values.refuse(param.name, &legal));
            }
        }
        if kind != "flat" && stages.is_some() {
            let legal = format!("auto with schedule={kind}: the schedule makes the latency");
            return Err(values.refuse("stages", &legal));
        }
        let schedule = match kind {
            "flat" => {
                let depth = stages.map_or(Depth::Period(period), Depth::Stages);
                Schedule::pipeline(&self.netlist, rom, depth)?
            }
            "shared" => {
                let latency = values.int("share_latency").map(count);
                let loads = values.choice("share_loads") == "yes";
                let shares =
                    values.params().filter_map(|(param, value)| match (param.role, value) {
                        (Role::Share(kind), Value::Int(units)) => {
                            Some(Share { kind, units: count(units), latency, loads })
                        }
                        _ => None,
                    });
                let interval = values.int("interval").map(count);
                let plan = Plan { shares: shares.collect(), interval };
                Schedule::shared(&self.netlist, rom, period, &plan)?
            }
            _ => {
                let Some(binding) = &self.binding else {
                    let legal = format!(
                        "flat or shared: {} has no printed schedule with these parameters; that of emboss is for \
                         setting=gx and every switch that is auto left there",
                        values.unit().name
                    );
                    return Err(values.refuse("schedule", &legal));
                };
                Schedule::bound(&self.netlist, rom, period, binding)?
            }
        };
        Ok(Rtl::new(Arc::clone(&self.netlist), schedule))
    }
}

/// What some nodes are together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// A direction in three components; the golden gives x, y, z.
    Cartesian,
    /// A direction as azimuth and polar angle in turns; the golden gives x, y, z.
    Polar,
    /// A number; the golden gives it.
    Scalar,
    /// A number whose error counts beside scales of its own: absolute and, as `NAME_SCALE`, over
    /// each of them. The golden gives it, and its scales in
    /// columns of their own after those of all groups.
    Scaled {
        /// The scales.
        scales: &'static [Scale],
        /// Texels of a texture whose coordinate it moves: the error is also told in them.
        texels: Option<u32>,
    },
}

/// What an error is told over.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Scale {
    /// Name after the quantity's.
    pub name: &'static str,
    /// What it is, in words: errors are told over that.
    pub what: &'static str,
}

impl Shape {
    /// Its scales.
    #[must_use]
    pub fn scales(self) -> &'static [Scale] {
        match self {
            Self::Scaled { scales, .. } => scales,
            Self::Cartesian | Self::Polar | Self::Scalar => &[],
        }
    }

    /// How many nodes it takes.
    #[must_use]
    pub fn nodes(self) -> usize {
        match self {
            Self::Cartesian => 3,
            Self::Polar => 2,
            Self::Scalar | Self::Scaled { .. } => 1,
        }
    }

    /// True if it is a direction.
    #[must_use]
    pub fn is_direction(self) -> bool {
        matches!(self, Self::Cartesian | Self::Polar)
    }

    /// Names of the golden's columns.
    #[must_use]
    pub fn columns(self) -> &'static [&'static str] {
        match self {
            Self::Cartesian | Self::Polar => &["x", "y", "z"],
            Self::Scalar | Self::Scaled { .. } => &[""],
        }
    }

    /// Values that golden columns mean for the nodes; angles in turns, 0 to 1.
    #[must_use]
    pub fn of_golden(self, golden: &[f64]) -> Vec<f64> {
        match (self, golden) {
            (Self::Polar, [x, y, z]) => {
                let phi = (libm::atan2(*y, *x) / TAU).rem_euclid(1.0) + 0.0; // -0 becomes 0
                vec![phi, libm::atan2(libm::hypot(*x, *y), *z) / TAU]
            }
            (Self::Cartesian | Self::Scalar | Self::Scaled { .. } | Self::Polar, _) => {
                golden.to_vec()
            }
        }
    }
}

/// Nodes with one meaning, which the golden model has too.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Group {
    /// Name in front of its quantities; nothing for the only one.
    pub name: &'static str,
    /// What the nodes are together.
    pub shape: Shape,
    /// The nodes.
    pub nodes: Vec<NodeId>,
}

impl Group {
    /// Names of the golden's columns.
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        self.shape.columns().iter().map(|column| prefixed(self.name, column)).collect()
    }

    /// One number for each output port of a netlist, named as the port.
    ///
    /// # Panics
    /// If a name is no output port.
    #[must_use]
    pub fn ports(netlist: &Netlist, names: &[&'static str]) -> Vec<Self> {
        let group = |name: &&'static str| {
            let output = netlist.outputs().iter().find(|output| output.name == *name);
            let node = output.expect("bug: a port of this name").node;
            Self { name, shape: Shape::Scalar, nodes: vec![node] }
        };
        names.iter().map(group).collect()
    }
}

impl Group {
    /// Nodes inside, by their labels.
    ///
    /// # Panics
    /// If there is no node of a label, or not as many as the shape takes: that is wrong code.
    pub(crate) fn inside(
        netlist: &Netlist,
        name: &'static str,
        shape: Shape,
        labels: &[&str],
    ) -> Self {
        let find = |label: &&str| netlist.ids().find(|id| netlist.label(*id) == **label);
        let found = labels.iter().map(|label| find(label).expect("bug: a node of this label"));
        let nodes: Vec<NodeId> = found.collect();
        assert_eq!(nodes.len(), shape.nodes(), "bug: nodes of `{name}`");
        Self { name, shape, nodes }
    }
}

/// `group_part`, or the one that isn't empty.
fn prefixed(group: &str, part: &str) -> String {
    match (group, part) {
        ("", name) | (name, "") => name.to_owned(),
        (group, part) => format!("{group}_{part}"),
    }
}

/// A golden model on blocks: input columns in, columns of all groups out, in order, and then the
/// scales of those that have one.
pub type Golden<F> = fn(&Values, &[&[F]], &mut [Vec<F>]);

/// A bound from parameters and the exact worst error of each table scheme by its name.
pub type BoundFn = fn(&Values, &dyn Fn(&str) -> f64) -> f64;

/// A stated bound on the error against the golden of the quantised inputs.
#[derive(Clone, Copy)]
pub struct Bound {
    /// What is bounded, in a word.
    pub what: &'static str,
    /// The quantities that it holds for, by their names in reports.
    pub quantities: &'static [&'static str],
    /// The bound, in the unit of those.
    pub bound: BoundFn,
}

impl fmt::Debug for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.what)
    }
}

/// What a design promises of its errors.
#[derive(Clone, Debug)]
pub enum Bounds {
    /// These.
    Stated(Vec<Bound>),
    /// These, for such inputs only.
    Within(&'static str, Vec<Bound>),
    /// Nothing, and why.
    Unstated(&'static str),
}

/// A table scheme as a design uses it: what is needed to judge it alone.
#[derive(Clone, Debug)]
pub struct Tabulated {
    /// Name of the table and of its scope.
    pub name: &'static str,
    /// Its functions.
    pub functions: Vec<Function>,
    /// Scheme.
    pub scheme: Scheme,
    /// Address bits asked for.
    pub addr_bits: u32,
    /// Quarter-wave folding asked for.
    pub quarter_wave: bool,
    /// Value of the argument's word 0.
    pub origin: f64,
    /// Format of the result.
    pub output: Format,
    /// Rounding of its sums.
    pub round: Round,
    /// Format of the argument.
    pub argument: Format,
}

impl Tabulated {
    /// The specification for [`crate::lut::emit`].
    #[must_use]
    pub fn spec(&self) -> Spec<'_> {
        Spec {
            name: self.name,
            functions: &self.functions,
            scheme: self.scheme,
            addr_bits: self.addr_bits,
            quarter_wave: self.quarter_wave,
            origin: self.origin,
            output: self.output,
            round: self.round,
        }
    }
}

/// A group of hard cases.
#[derive(Clone, Debug)]
pub struct HardCase {
    /// What is hard about them.
    pub name: &'static str,
    /// Input words, one vector per case.
    pub words: Vec<Vec<i64>>,
}

/// Where inputs come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sampler {
    /// Vectors uniform on the sphere, with the light on the lit side of the surface.
    Lit,
    /// Vectors uniform on the sphere.
    Sphere,
    /// Every combination of input words.
    Exhaustive,
    /// The hard-case list.
    Hard,
}

impl Sampler {
    /// Names on the command line.
    pub const ALL: &'static [(Self, &'static str)] = &[
        (Self::Lit, "lit"),
        (Self::Sphere, "sphere"),
        (Self::Exhaustive, "exhaustive"),
        (Self::Hard, "hard"),
    ];

    /// True if it draws, so that a number of samples and a seed mean something.
    #[must_use]
    pub fn is_random(self) -> bool {
        match self {
            Self::Lit | Self::Sphere => true,
            Self::Exhaustive | Self::Hard => false,
        }
    }

    /// Name on the command line.
    ///
    /// # Panics
    /// Never: every sampler is listed.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(known, _)| *known == self).expect("bug: every sampler is listed").1
    }
}

/// Random numbers: a stream for each seed, the same everywhere.
#[derive(Debug)]
pub struct Uniform(Pcg64Mcg);

impl Uniform {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// The next number, uniform in 0 to 1 without 1, of 53 bits.
    #[inline]
    pub fn draw(&mut self) -> f64 {
        cast::f64_of(cast::word_of_bits(self.0.next_u64() >> 11)) * 2f64.powi(-53)
    }
}

/// Fills one column per input with random values.
pub type Draw = fn(&Design, Sampler, &mut Uniform, &mut [Vec<f64>], usize);

/// A datapath with what it takes to run and judge it.
#[derive(Debug)]
pub struct Design {
    /// Parameters that made it.
    pub values: Values,
    /// The datapath.
    pub netlist: Arc<Netlist>,
    /// What is judged: the output ports in order, then nodes inside.
    pub groups: Vec<Group>,
    /// Golden model in `f64`.
    pub golden: Golden<f64>,
    /// The same in `f32`, to be judged as a rival.
    pub golden_f32: Golden<f32>,
    /// Stated error bounds.
    pub bounds: Bounds,
    /// Table schemes in use.
    pub tabulated: Vec<Tabulated>,
    /// The hard cases.
    pub hard: Vec<HardCase>,
    /// Input sampler.
    pub draw: Draw,
    /// A schedule given by hand, for `schedule=printed`.
    pub binding: Option<Binding>,
}
