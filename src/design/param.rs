//! Parameters of units: what they are for, which values they take.

use crate::base::error::{Error, Result};
use crate::base::whole;
use crate::number::function::Number;
use crate::schedule::Kind as Shared;
use std::fmt;

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
    pub(crate) fn is_of_sharing(self) -> bool {
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
