//! Parameters of units: their roles and legal values.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::name;
use crate::base::whole;
use crate::number::format::{Overflow, Round};
use crate::number::function::Number;
use crate::schedule::Kind as Shared;
use crate::table::Scheme;
use std::cmp::Ordering;
use std::fmt;
use std::ops::RangeInclusive;
use std::sync::{Arc, LazyLock};

/// What a parameter is for. Code that treats some parameters alike uses the role, not the name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Bits of words, or of their integer, fraction or guard part.
    Width,
    /// Address bits of tables.
    TableSize,
    /// Size of a map that the datapath addresses.
    MapSize,
    /// Number of steps of an unrolled algorithm.
    Iterations,
    /// Selects one of several algorithms.
    Variant,
    /// As [`Role::Variant`], but each choice is a named pipeline of its own on a scene.
    Pipeline,
    /// How tables approximate.
    Scheme,
    /// How dropped bits are rounded.
    Rounding,
    /// How values outside a format are handled.
    Overflow,
    /// How a part of the datapath is built, or whether it exists.
    Switch,
    /// A number that the datapath holds.
    Constant,
    /// Number of ports of a kind.
    Count,
    /// A part of the reflection formula: on a scene, the material and the light give it.
    Material(Reflection),
    /// Reported only, without effect.
    Label,
    /// Clock, latency, and how tables are read.
    Timing,
    /// Kind of schedule.
    Schedule,
    /// Used only with a schedule that shares units.
    Sharing,
    /// Number of units for operations of a kind, with such a schedule.
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

    /// True if it is used only with a schedule other than the flat one.
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

/// A parameter of a unit: the constructor sets its legal values, the setters everything else.
///
/// ```
/// use fixpath::units::{Param, Role, Value};
///
/// let size = Param::bits("table_addr_bits", 2..=20).role(Role::TableSize).default(10).help("address bits");
/// assert_eq!(size.default, Value::Int(10));
/// let steps = Param::int("steps", 1..=40).auto("as many as bits").help("steps of the CORDIC");
/// assert_eq!(steps.default, Value::Auto);
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Param {
    /// Name on the command line: lower case, digits and single underscores.
    pub name: String,
    /// Its role.
    pub role: Role,
    /// Its legal values.
    pub kind: Kind,
    /// Its default.
    pub default: Value,
    /// One line of help.
    pub help: String,
}

/// The legal values of a parameter.
#[derive(Clone, PartialEq, Debug)]
pub enum Kind {
    /// A whole number in a range, or `auto` if there is a text that explains it.
    Int {
        /// Least legal value.
        min: i64,
        /// Greatest legal value.
        max: i64,
        /// Meaning of `auto`, if it is legal.
        auto: Option<String>,
    },
    /// A number in a range.
    Real {
        /// Least legal value.
        min: f64,
        /// Greatest legal value.
        max: f64,
    },
    /// One of some names.
    Choice(Vec<Arc<str>>),
}

impl Kind {
    /// The legal values in words.
    #[must_use]
    pub fn legal(&self) -> String {
        match self {
            Self::Int { min, max, auto: None } => format!("{min} to {max}"),
            Self::Int { min, max, auto: Some(auto) } => format!("{min} to {max}, or auto ({auto})"),
            Self::Real { min, max } => format!("{min} to {max}, fractions allowed"),
            Self::Choice(names) => names.join(", "),
        }
    }

    /// True if a value is legal.
    fn holds(&self, value: &Value) -> bool {
        match (self, value) {
            (Self::Int { min, max, .. }, Value::Int(number)) => (min..=max).contains(&number),
            (Self::Int { auto, .. }, Value::Auto) => auto.is_some(),
            (Self::Real { min, max }, Value::Real(number)) => (*min..=*max).contains(&number.get()),
            (Self::Choice(names), Value::Choice(name)) => names.contains(name),
            _ => false,
        }
    }

    /// The default if none is set: the least value, or the first name.
    fn first(&self) -> Value {
        match self {
            Self::Int { min, .. } => Value::Int(*min),
            Self::Real { min, .. } => Value::Real((*min).into()),
            Self::Choice(names) => names.first().cloned().map_or(Value::Auto, Value::Choice),
        }
    }
}

/// Value of a parameter.
#[derive(Clone, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum Value {
    /// A whole number.
    Int(i64),
    /// A number.
    Real(Number),
    /// `auto`.
    Auto,
    /// A name.
    Choice(Arc<str>),
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

macro_rules! values {
    ($($from:ty: $value:ident => $to:expr;)*) => {
        $(impl From<$from> for Value {
            fn from($value: $from) -> Self { $to }
        })*
    };
}

values! {
    i32: value => Self::Int(value.into());
    u32: value => Self::Int(value.into());
    i64: value => Self::Int(value);
    f64: value => Self::Real(value.into());
    bool: value => Self::Choice(FLAG[usize::from(value)].into());
    &str: value => if value == "auto" { Self::Auto } else { Self::Choice(value.into()) };
    Scheme: value => Self::Choice(value.name().into());
    Round: value => Self::Choice(value.name().into());
    Overflow: value => Self::Choice(value.name().into());
}

/// Names of the two states of a switch.
pub(super) const FLAG: [&str; 2] = ["off", "on"];

impl Param {
    fn new(name: impl Into<String>, role: Role, kind: Kind) -> Self {
        Self { name: name.into(), role, default: kind.first(), kind, help: String::new() }
    }

    /// A number of bits, with [`Role::Width`].
    #[must_use]
    pub fn bits(name: impl Into<String>, range: RangeInclusive<u32>) -> Self {
        let (min, max) = (i64::from(*range.start()), i64::from(*range.end()));
        Self::new(name, Role::Width, Kind::Int { min, max, auto: None })
    }

    /// A whole number, with [`Role::Constant`].
    #[must_use]
    pub fn int(name: impl Into<String>, range: RangeInclusive<i64>) -> Self {
        let (min, max) = range.into_inner();
        Self::new(name, Role::Constant, Kind::Int { min, max, auto: None })
    }

    /// A real number, with [`Role::Constant`].
    #[must_use]
    pub fn real(name: impl Into<String>, range: RangeInclusive<f64>) -> Self {
        let (min, max) = range.into_inner();
        Self::new(name, Role::Constant, Kind::Real { min, max })
    }

    /// One of several names, with [`Role::Switch`].
    #[must_use]
    pub fn choice<N: Into<Arc<str>>>(
        name: impl Into<String>,
        names: impl IntoIterator<Item = N>,
    ) -> Self {
        let names = names.into_iter().map(Into::into).collect();
        Self::new(name, Role::Switch, Kind::Choice(names))
    }

    /// `off` or `on`, with [`Role::Switch`].
    #[must_use]
    pub fn flag(name: impl Into<String>) -> Self {
        Self::choice(name, FLAG)
    }

    /// A table scheme.
    #[must_use]
    pub fn scheme(name: impl Into<String>) -> Self {
        Self::choice(name, Scheme::ALL.iter().map(|scheme| scheme.name()))
            .role(Role::Scheme)
            .help("how tables approximate: one word per cell, base + slope, or two tables added")
    }

    /// A rounding.
    #[must_use]
    pub fn rounding(name: impl Into<String>) -> Self {
        Self::choice(name, Round::ALL.iter().map(|round| round.name()))
            .role(Role::Rounding)
            .default(Round::HalfUp)
            .help("rounding wherever bits are dropped")
    }

    /// How values outside a format are handled.
    #[must_use]
    pub fn overflow(name: impl Into<String>) -> Self {
        Self::choice(name, Overflow::ALL.iter().map(|overflow| overflow.name()))
            .role(Role::Overflow)
            .default(Overflow::Saturate)
            .help("overflow: how values outside the format are handled")
    }

    /// Keeps only these names of a choice, in this order.
    #[must_use]
    pub fn among<V: Into<Value>>(mut self, some: impl IntoIterator<Item = V>) -> Self {
        if let Kind::Choice(names) = &mut self.kind {
            let kept = some.into_iter().filter_map(|value| match value.into() {
                Value::Choice(name) => names.contains(&name).then_some(name),
                Value::Int(_) | Value::Real(_) | Value::Auto => None,
            });
            *names = kept.collect();
        }
        self
    }

    /// Also allows `auto` for a whole number, with this meaning. It becomes the default unless one
    /// is set later.
    #[must_use]
    pub fn auto(mut self, meaning: impl Into<String>) -> Self {
        if let Kind::Int { auto, .. } = &mut self.kind {
            *auto = Some(meaning.into());
            self.default = Value::Auto;
        }
        self
    }

    /// Sets the default. Without it, the default is the least value, the first name or `auto`.
    #[must_use]
    pub fn default(mut self, value: impl Into<Value>) -> Self {
        self.default = match (&self.kind, value.into()) {
            (Kind::Real { .. }, Value::Int(number)) => Value::Real(cast::f64_of(number).into()),
            (Kind::Choice(_), Value::Auto) => Value::Choice("auto".into()),
            (Kind::Int { .. } | Kind::Real { .. } | Kind::Choice(_), value) => value,
        };
        self
    }

    /// Sets the line of help.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = help.into();
        self
    }

    /// Sets its role.
    #[must_use]
    pub fn role(mut self, role: Role) -> Self {
        self.role = role;
        self
    }

    /// Parses a value.
    ///
    /// # Errors
    /// If it is not legal; the message names the legal values.
    pub fn parse(&self, text: &str) -> Result<Value> {
        let value = match &self.kind {
            Kind::Int { auto: Some(_), .. } if text == "auto" => Some(Value::Auto),
            Kind::Int { .. } => whole::signed(text).map(Value::Int),
            Kind::Real { .. } => text.parse().ok().map(|x: f64| Value::Real(x.into())),
            Kind::Choice(names) => {
                names.iter().find(|name| ***name == *text).cloned().map(Value::Choice)
            }
        };
        let legal = value.filter(|value| self.kind.holds(value)); // not NaN
        legal.ok_or_else(|| Error::parameter_value(&self.name, text, self.kind.legal()))
    }

    /// Refuses a parameter that can't be set.
    pub(super) fn check(&self) -> Result<()> {
        let name = &self.name;
        if !name::is_legal(name) {
            return Err(Error::name("parameter", name));
        }
        let problem = match &self.kind {
            // A reversed range has no values.
            Kind::Int { min, max, .. } if min > max => format!("{min} to {max} is not a range"),
            Kind::Real { min, max } if min.partial_cmp(max).is_none_or(Ordering::is_gt) => {
                format!("{min} to {max} is not a range")
            }
            Kind::Choice(names) => {
                let plain = |name: &Arc<str>| {
                    !name.is_empty() && name.bytes().all(|b| b.is_ascii_graphic() && b != b',')
                };
                let doubled = |at: usize| names[..at].contains(&names[at]);
                if names.is_empty() {
                    "it has no choices".to_owned()
                } else if let Some(at) = (0..names.len()).find(|at| doubled(*at)) {
                    format!("it has the name `{}` twice", names[at])
                } else if let Some(odd) = names.iter().find(|name| !plain(name)) {
                    format!("its name `{odd}` can't be written: use ASCII without blanks or commas")
                } else {
                    String::new()
                }
            }
            Kind::Int { .. } | Kind::Real { .. } => String::new(),
        };
        if !problem.is_empty() {
            return Err(Error::usage(format!("parameter `{name}`: {problem}")));
        }
        if !self.kind.holds(&self.default) {
            let (default, legal) = (&self.default, self.kind.legal());
            return Err(Error::usage(format!(
                "parameter `{name}`: its default {default} isn't legal; legal is {legal}"
            )));
        }
        Ok(())
    }
}

/// Parameters of the pipeline, common to all units.
pub static PIPELINE: LazyLock<Vec<Param>> = LazyLock::new(|| {
    vec![
        Param::int("period_ps", 100..=1_000_000)
            .role(Role::Timing)
            .default(5000)
            .help("target clock period of the pipeline in ps, by the stated delay model"),
        Param::int("stages", 0..=256)
            .role(Role::Timing)
            .auto("as many as the target period needs")
            .help("latency in cycles; overrides period_ps; 0 is combinational and needs rom=distributed"),
        Param::choice("rom", ["block", "distributed"])
            .role(Role::Timing)
            .help("table reads are synchronous (block RAM) or combinational (distributed logic)"),
        Param::choice("schedule", ["flat", "shared", "printed"])
            .role(Role::Schedule)
            .help("flat: one sample per cycle; shared: operations share units as set by share_*; printed: the unit's hand-written schedule, if it has one"),
        Param::int("interval", 1..=1024)
            .role(Role::Sharing)
            .auto("as short as the units allow")
            .help("cycles from one sample to the next with schedule=shared"),
        share(Shared::Dot, "share_dot")
            .help("dot products of three: units for each structure, with schedule=shared"),
        share(Shared::Multiplier, "share_mul")
            .help("multipliers, except in roots, dividers, table schemes and dot products shared by share_dot: units, with schedule=shared"),
        share(Shared::Adder, "share_add")
            .help("adders, with the same exceptions: units, with schedule=shared"),
        share(Shared::Table, "share_table")
            .help("table schemes, all reads of one being one operation: units for each structure, with schedule=shared"),
        share(Shared::Root, "share_root")
            .help("roots and reciprocal roots: units for each structure, with schedule=shared"),
        share(Shared::Divider, "share_divide")
            .help("dividers: units for each structure, with schedule=shared"),
        Param::int("share_latency", 0..=64)
            .role(Role::Sharing)
            .auto("by the delay model and period_ps")
            .help("cycles from issue to output of each shared unit"),
        Param::choice("share_loads", ["no", "yes"])
            .role(Role::Sharing)
            .help("register the operands of shared units in the cycle before issue"),
    ]
});

fn share(kind: Shared, name: &str) -> Param {
    Param::int(name, 1..=1024).role(Role::Share(kind)).auto("hardware for each use")
}
