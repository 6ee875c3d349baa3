//! A unit, and the values of its parameters.

use super::memory::MemoryFile;
use super::param::{FLAG, Kind, PIPELINE, Param, Reflection, Role, Value};
use super::{Bounds, Design};
use crate::base::error::{Error, Result};
use crate::base::escape;
use crate::base::name;
use crate::netlist::{Builder, Overrides};
use crate::number::format::{Format, Overflow, Round};
use crate::table::Scheme;
use std::fmt;
use std::ops::Deref;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// A parameterised datapath: a recipe that makes a [`Design`] from values of its parameters.
///
/// It is a value: made by [`Unit::new`] and setters, cheap to clone, and equal to its clones. Every
/// command and function of this crate accepts user-defined units like those of [`crate::units`].
///
/// ```
/// use fixpath::format::{Format, Overflow};
/// use fixpath::netlist::Quantity;
/// use fixpath::units::{Design, Golden, Param, Unit};
///
/// let square = Unit::new("square", "x times x, rounded")
///     .param(Param::bits("x_bits", 2..=24).default(16).help("bits of x, from -1 to 1"))
///     .param(Param::rounding("rounding"))
///     .design(|p| {
///         let mut b = p.builder("square"); // takes `-p format.NODE=…` into account
///         let format = Format::signed(p.bits("x_bits"), p.bits("x_bits").cast_signed() - 1)?;
///         let x = b.input("x", format, Quantity::Number);
///         let exact = b.mul(x, x);
///         let y = b.narrow(exact, format, p.rounding("rounding"), Overflow::Saturate);
///         b.output("y", y);
///         Ok(Design::new(p, b.build()?).golden(|_| Golden::each(|[x]: [f64; 1]| [x * x])))
///     });
/// let design = square.values(&["x_bits=8"])?.build()?;
/// assert_eq!(design.netlist.outputs()[0].name, "y");
/// # Ok::<(), fixpath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Unit(Arc<Recipe>);

/// The description of a unit.
#[derive(Clone)]
pub struct Recipe {
    /// Name on the command line: lower case, digits and single underscores.
    pub name: String,
    /// What it computes, in one line.
    pub summary: String,
    /// Its source, such as a paper.
    pub source: String,
    /// Its formulas: lines for `list`.
    pub formula: String,
    /// Its own parameters; [`PIPELINE`] follows them.
    pub params: Vec<Param>,
    /// Names and quantities of the input ports, for `list`.
    pub inputs: String,
    /// Names of the output ports, for `list`.
    pub outputs: String,
    /// Whether it shades the pixels of a scene.
    pub shades: Shading,
    design: Option<Arc<DesignFn>>,
}

type DesignFn = dyn Fn(&Values) -> Result<Design> + Send + Sync;

impl fmt::Debug for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

impl Deref for Unit {
    type Target = Recipe;

    fn deref(&self) -> &Recipe {
        &self.0
    }
}

impl PartialEq for Unit {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Unit {}

/// Whether a unit shades the pixels of a scene. If it does, its inputs are those of a
/// [fragment](crate::units::fragment), and it has the output `diffuse` and, if it has highlights,
/// `specular`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shading {
    /// No.
    None,
    /// Yes, from vectors that floating point rotated into the texture frame.
    Part,
    /// Yes, as a complete pipeline, or with a parameter of [`Role::Pipeline`] whose choices are
    /// complete pipelines.
    Pipeline,
}

impl Unit {
    /// A unit with a name and a one-line summary.
    #[must_use]
    pub fn new(name: impl Into<String>, summary: impl Into<String>) -> Self {
        Self(Arc::new(Recipe {
            name: name.into(),
            summary: summary.into(),
            source: String::new(),
            formula: String::new(),
            params: Vec::new(),
            inputs: String::new(),
            outputs: String::new(),
            shades: Shading::None,
            design: None,
        }))
    }

    fn with(mut self, set: impl FnOnce(&mut Recipe)) -> Self {
        set(Arc::make_mut(&mut self.0));
        self
    }

    /// Sets its source.
    #[must_use]
    pub fn source(self, source: impl Into<String>) -> Self {
        self.with(|recipe| recipe.source = source.into())
    }

    /// Sets its formulas, with signs and units: one or more lines, for `list`.
    #[must_use]
    pub fn formula(self, formula: impl Into<String>) -> Self {
        self.with(|recipe| recipe.formula = formula.into())
    }

    /// Adds a parameter.
    #[must_use]
    pub fn param(self, param: Param) -> Self {
        self.params([param])
    }

    /// Adds parameters.
    #[must_use]
    pub fn params(self, params: impl IntoIterator<Item = Param>) -> Self {
        self.with(|recipe| recipe.params.extend(params))
    }

    /// Sets the description of the input ports for `list`.
    #[must_use]
    pub fn inputs(self, inputs: impl Into<String>) -> Self {
        self.with(|recipe| recipe.inputs = inputs.into())
    }

    /// Sets the description of the output ports for `list`.
    #[must_use]
    pub fn outputs(self, outputs: impl Into<String>) -> Self {
        self.with(|recipe| recipe.outputs = outputs.into())
    }

    /// Sets whether it shades the pixels of a scene.
    #[must_use]
    pub fn shades(self, shades: Shading) -> Self {
        self.with(|recipe| recipe.shades = shades)
    }

    /// Sets the closure that makes the datapath.
    #[must_use]
    pub fn design(
        self,
        design: impl Fn(&Values) -> Result<Design> + Send + Sync + 'static,
    ) -> Self {
        self.with(|recipe| recipe.design = Some(Arc::new(design)))
    }

    /// All parameters: its own, then the pipeline's.
    pub fn all_params(&self) -> impl Iterator<Item = &Param> {
        self.params.iter().chain(PIPELINE.iter())
    }

    /// The parameter of a name.
    #[must_use]
    pub fn find_param(&self, name: &str) -> Option<&Param> {
        self.all_params().find(|param| param.name == name)
    }

    /// Refuses an unusable unit.
    ///
    /// # Errors
    /// If the name of the unit or of a parameter is not an identifier, two parameters share a name,
    /// a default isn't legal, a text has more than one line, or the unit has no `design`.
    pub fn check(&self) -> Result<()> {
        if !name::is_legal(&self.name) {
            return Err(Error::name("unit", &self.name));
        }
        let lines =
            [&self.summary, &self.source, &self.inputs, &self.outputs].map(|text| &text[..]);
        let texts = lines.into_iter().chain(self.formula.split('\n'));
        if let Some(text) = texts.into_iter().find(|text| text.contains(char::is_control)) {
            let text = escape::short(text);
            let why = format!("unit `{}`: `{text}` must be one line of text", self.name);
            return Err(Error::usage(why));
        }
        let of_unit = |why: &dyn fmt::Display| Error::usage(format!("unit `{}`: {why}", self.name));
        for (at, param) in self.params.iter().enumerate() {
            param.check().map_err(|why| of_unit(&why))?;
            let same = |known: &Param| known.name == param.name;
            if self.params[..at].iter().any(same) || PIPELINE.iter().any(same) {
                let whose =
                    if PIPELINE.iter().any(same) { "every unit has one" } else { "two parameters" };
                return Err(of_unit(&format!("parameter `{}`: {whose} of this name", param.name)));
            }
        }
        if self.design.is_none() {
            return Err(of_unit(&"it has no datapath: give it a `design`"));
        }
        Ok(())
    }

    /// The defaults.
    #[must_use]
    pub fn defaults(&self) -> Values {
        let values = self.all_params().map(|param| param.default.clone()).collect();
        let (formats, overrides) = (Vec::new(), Overrides::default());
        Values {
            unit: self.clone(),
            values,
            formats,
            schemes: Vec::new(),
            memories: Vec::new(),
            overrides,
            notes: None,
        }
    }

    /// A value for an axis of a sweep. Everything that [`Values::set`] accepts is legal, except
    /// memories: their words aren't part of a point.
    ///
    /// # Errors
    /// As [`Values::set`], or if the key is a memory.
    pub(crate) fn value(&self, key: &str, text: &str) -> Result<Value> {
        if key.starts_with(MEMORY) {
            let key = escape::short(key);
            return Err(Error::usage(format!("`{key}` can't be swept: set it with -p {key}=FILE")));
        }
        let mut values = self.defaults();
        values.set(key, text)?;
        let (_, value) =
            values.iter().find(|(known, _)| *known == key).expect("bug: it was set just now");
        Ok(value.clone())
    }

    /// The defaults, changed by `key=value` assignments.
    ///
    /// # Errors
    /// If a name is unknown or given twice, or a value is not legal.
    pub fn values<S: AsRef<str>>(&self, assignments: &[S]) -> Result<Values> {
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

/// One value for each parameter of a unit.
///
/// While a unit makes its design, the values record which parameters are read. This shows what a
/// golden model depends on, and turns a read of an unknown parameter into an error of the design.
/// Elsewhere such a read panics.
#[derive(Debug)]
pub struct Values {
    unit: Unit,
    values: Vec<Value>,
    /// Formats of nodes that override the recipe's: the key including [`FORMAT`], the value as
    /// text, the format.
    formats: Vec<(String, Value, Format)>,
    /// Schemes of tables that override the recipe's: the key including [`SCHEME`], the value as
    /// text, the scheme.
    schemes: Vec<(String, Value, Scheme)>,
    /// Words of memories: the key including [`MEMORY`], the file's path as text, its words.
    memories: Vec<(String, Value, Arc<MemoryFile>)>,
    /// Formats and schemes by the places where the recipe asks for them; known while a design is
    /// made.
    overrides: Overrides,
    notes: Option<Arc<Notes>>,
}

/// Prefix of keys for formats of nodes: `format.NODE=s20f18`.
const FORMAT: &str = "format.";

/// Prefix of keys for schemes of tables: `scheme.TABLE=linear`.
const SCHEME: &str = "scheme.";

/// Prefix of keys for words of memories: `memory.NAME=words.csv`.
pub(super) const MEMORY: &str = "memory.";

/// What was read.
#[derive(Debug)]
struct Notes {
    /// By parameter.
    read: Vec<AtomicBool>,
    /// The first read of an unknown parameter.
    wrong: Mutex<Option<Error>>,
}

impl Clone for Values {
    /// A copy that records nothing. It may be read at any time, so it counts as a read of all
    /// parameters.
    fn clone(&self) -> Self {
        self.note_all();
        self.with_notes(None)
    }
}

impl Values {
    /// The unit that the values belong to.
    #[must_use]
    pub fn unit(&self) -> &Unit {
        &self.unit
    }

    fn with_notes(&self, notes: Option<Arc<Notes>>) -> Self {
        Self {
            unit: self.unit.clone(),
            values: self.values.clone(),
            formats: self.formats.clone(),
            schemes: self.schemes.clone(),
            memories: self.memories.clone(),
            overrides: self.overrides.clone(),
            notes,
        }
    }

    /// Sets one parameter from text. `format.NODE` overrides the format of a node, by its
    /// [stable name](crate::netlist::Choice::name). `scheme.TABLE` overrides the scheme of a table.
    /// `memory.NAME` binds words to a memory, from a CSV file with a heading for each column and a
    /// line of words for each address. Unknown nodes, tables and memories are reported when the
    /// design is made.
    ///
    /// # Errors
    /// If the name is unknown, the value isn't legal, or the file can't be read.
    pub fn set(&mut self, name: &str, text: &str) -> Result<()> {
        if name.starts_with(FORMAT) {
            let Ok(format) = text.parse::<Format>() else {
                let legal = "a format, such as s20f18 or u12f12".to_owned();
                return Err(Error::parameter_value(&escape::short(name), text, legal));
            };
            self.formats.retain(|(known, ..)| known != name);
            self.formats.push((name.to_owned(), Value::Choice(format.to_string().into()), format));
            return Ok(());
        }
        if name.starts_with(SCHEME) {
            let names: Vec<&str> = Scheme::ALL.iter().map(|scheme| scheme.name()).collect();
            let Some(at) = names.iter().position(|known| *known == text) else {
                let legal = names.join(", ");
                return Err(Error::parameter_value(&escape::short(name), text, legal));
            };
            self.schemes.retain(|(known, ..)| known != name);
            self.schemes.push((name.to_owned(), Value::Choice(names[at].into()), Scheme::ALL[at]));
            return Ok(());
        }
        if name.starts_with(MEMORY) {
            if text.is_empty() {
                let legal = "the path of a CSV file".to_owned();
                return Err(Error::parameter_value(&escape::short(name), text, legal));
            }
            let file = Arc::new(MemoryFile::read(Path::new(text))?);
            self.memories.retain(|(known, ..)| known != name);
            self.memories.push((name.to_owned(), Value::Choice(text.to_owned().into()), file));
            return Ok(());
        }
        let (index, param) = self.find(name)?;
        self.values[index] = param.parse(text)?;
        Ok(())
    }

    fn find(&self, name: &str) -> Result<(usize, &Param)> {
        let unit = &self.unit;
        let mut all = unit.all_params().enumerate();
        all.find(|(_, param)| param.name == name).ok_or_else(|| {
            let names = unit.all_params().map(|param| param.name.as_str());
            Error::unknown_parameter(&unit.name, name, names)
        })
    }

    /// As [`Values::iter`], without parameters of sharing if the schedule is flat.
    pub fn told(&self) -> impl Iterator<Item = (&str, &Value)> {
        let flat = self.choice("schedule") == "flat";
        let silent = move |role: Role| flat && (role == Role::Schedule || role.is_of_sharing());
        self.params()
            .filter(move |(param, _)| !silent(param.role))
            .map(|(param, value)| (param.name.as_str(), value))
            .chain(self.named())
    }

    /// Formats of nodes, schemes of tables and words of memories that were set.
    pub(super) fn named(&self) -> impl Iterator<Item = (&str, &Value)> {
        let formats = self.formats.iter().map(|(key, value, _)| (key.as_str(), value));
        let schemes = self.schemes.iter().map(|(key, value, _)| (key.as_str(), value));
        formats
            .chain(schemes)
            .chain(self.memories.iter().map(|(key, value, _)| (key.as_str(), value)))
    }

    /// The words that were set for memories, by memory name.
    pub(super) fn memory_files(&self) -> impl Iterator<Item = (&str, &MemoryFile)> {
        self.memories
            .iter()
            .map(|(key, _, file)| (key.strip_prefix(MEMORY).unwrap_or_default(), &**file))
    }

    /// A builder for the netlist that applies the formats that were set. Recipes start with it.
    #[must_use]
    #[track_caller]
    pub fn builder(&self, name: &str) -> Builder {
        Builder::with(name, &self.overrides)
    }

    /// Pairs of parameter and value, in order.
    pub fn params(&self) -> impl Iterator<Item = (&Param, &Value)> {
        self.note_all();
        self.unit.all_params().zip(&self.values)
    }

    /// Pairs of name and value in the order of the parameters.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.params().map(|(param, value)| (param.name.as_str(), value)).chain(self.named())
    }

    /// True if there is a parameter of a name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.unit.find_param(name).is_some()
    }

    /// Reads a parameter's value through `of`. If the parameter is missing or `of` returns `None`,
    /// records an error or panics.
    fn read<'a, T>(
        &'a self,
        name: &str,
        what: &str,
        of: impl FnOnce(&'a Value) -> Option<T>,
    ) -> Option<T> {
        let wrong = match self.find(name) {
            Ok((index, param)) => {
                if let Some(notes) = &self.notes {
                    notes.read[index].store(true, Ordering::Relaxed);
                }
                let value = &self.values[index];
                let read = of(value);
                if read.is_some() {
                    return read;
                }
                let legal = param.kind.legal();
                Error::usage(format!(
                    "unit `{}` reads its parameter `{name}` as {what}, but it is {value} of {legal}",
                    self.unit.name
                ))
            }
            Err(wrong) => wrong,
        };
        let Some(notes) = &self.notes else { panic!("bug: {wrong}") };
        notes.wrong.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(wrong);
        None
    }

    /// The value of a parameter.
    ///
    /// # Panics
    /// If there is no such parameter. While a design is made, this is an error of the design
    /// instead.
    #[must_use]
    pub fn get(&self, name: &str) -> &Value {
        self.read(name, "a value", Some).unwrap_or(&Value::Auto)
    }

    /// A whole number; `None` for `auto`.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a whole number.
    #[must_use]
    pub fn int(&self, name: &str) -> Option<i64> {
        let of = |value: &Value| match value {
            Value::Int(number) => Some(Some(*number)),
            Value::Auto => Some(None),
            Value::Real(_) | Value::Choice(_) => None,
        };
        self.read(name, "a whole number", of).flatten()
    }

    /// The value of a part of the reflection formula, if the unit has that parameter.
    #[must_use]
    pub fn reflection(&self, part: Reflection) -> Option<&Value> {
        self.params().find(|(param, _)| param.role == Role::Material(part)).map(|(_, value)| value)
    }

    /// A number.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a real number.
    #[must_use]
    pub fn real(&self, name: &str) -> f64 {
        let of = |value: &Value| match value {
            Value::Real(number) => Some(number.get()),
            Value::Int(_) | Value::Auto | Value::Choice(_) => None,
        };
        self.read(name, "a number with fractions", of).unwrap_or_default()
    }

    /// A number of bits, for parameters without `auto`.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a count.
    #[must_use]
    pub fn bits(&self, name: &str) -> u32 {
        let of = |value: &Value| match value {
            Value::Int(number) => u32::try_from(*number).ok(),
            Value::Real(_) | Value::Auto | Value::Choice(_) => None,
        };
        self.read(name, "a count", of).unwrap_or(1)
    }

    /// A name.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a choice.
    #[must_use]
    pub fn choice(&self, name: &str) -> &str {
        self.read(name, "a name", Self::name_of).unwrap_or_default()
    }

    fn name_of(value: &Value) -> Option<&str> {
        match value {
            Value::Choice(name) => Some(name),
            Value::Int(_) | Value::Real(_) | Value::Auto => None,
        }
    }

    /// A switch: true for `on`.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a switch.
    #[must_use]
    pub fn flag(&self, name: &str) -> bool {
        let of = |value| FLAG.iter().position(|known| Self::name_of(value) == Some(known));
        self.read(name, "a switch, off or on", of) == Some(1)
    }

    /// A table scheme.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a table scheme.
    #[must_use]
    pub fn scheme(&self, name: &str) -> Scheme {
        let of = |value| {
            Scheme::ALL.iter().copied().find(|known| Self::name_of(value) == Some(known.name()))
        };
        self.read(name, "a table scheme", of).unwrap_or(Scheme::Direct)
    }

    /// The scheme of a table: the one set for its name, otherwise that of a parameter.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a table scheme.
    pub(crate) fn scheme_of(&self, table: &str, name: &str) -> Scheme {
        let own = self.scheme(name);
        let is_of = |key: &str| key.strip_prefix(SCHEME) == Some(table);
        self.schemes.iter().find(|(key, ..)| is_of(key)).map_or(own, |(.., scheme)| *scheme)
    }

    /// A rounding.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not a rounding.
    #[must_use]
    pub fn rounding(&self, name: &str) -> Round {
        let of = |value| Self::name_of(value)?.parse().ok();
        self.read(name, "a rounding", of).unwrap_or(Round::HalfEven)
    }

    /// How values outside a format are handled.
    ///
    /// # Panics
    /// As [`Values::get`], or if the parameter is not an overflow mode.
    #[must_use]
    pub fn overflow(&self, name: &str) -> Overflow {
        let of = |value| Self::name_of(value)?.parse().ok();
        self.read(name, "an overflow mode", of).unwrap_or(Overflow::Saturate)
    }

    /// The error for a value that is legal by itself but not in combination with others.
    #[must_use]
    pub fn refuse(&self, name: &str, legal: &str) -> Error {
        Error::parameter_value(name, &self.get(name).to_string(), legal.to_owned())
    }

    /// The same values, recording which are read.
    pub(crate) fn noting(&self) -> Self {
        let read = self.values.iter().map(|_| AtomicBool::new(false)).collect();
        self.with_notes(Some(Arc::new(Notes { read, wrong: Mutex::new(None) })))
    }

    /// For each parameter, whether it was read.
    pub(super) fn were_read(&self) -> Vec<bool> {
        let notes = self.notes.iter().flat_map(|notes| &notes.read);
        notes.map(|read| read.load(Ordering::Relaxed)).collect()
    }

    /// The first read of an unknown parameter.
    pub(crate) fn wrong(&self) -> Option<Error> {
        self.notes.as_ref()?.wrong.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn note_all(&self) {
        for read in self.notes.iter().flat_map(|notes| &notes.read) {
            read.store(true, Ordering::Relaxed);
        }
    }

    pub(super) fn all(&self) -> &[Value] {
        &self.values
    }

    /// Builds the datapath.
    ///
    /// # Errors
    /// If these values can't be combined, a word would be wider than 63 bits, or the unit or its
    /// design is invalid ([`Unit::check`], [`Design::check`]).
    pub fn build(&self) -> Result<Design> {
        self.design()
            .map_err(|error| self.with_remedy(error, &|values| values.design().map(|_| ())))
    }

    /// The same, without suggesting a remedy for words that are too wide.
    pub(crate) fn design(&self) -> Result<Design> {
        if self.formats.is_empty() && self.schemes.is_empty() {
            return self.design_of_recipe();
        }
        // The design without overrides has the names of its nodes; with their places, the recipe
        // runs again.
        let mut values = self.clone();
        let formats = std::mem::take(&mut values.formats);
        let schemes = std::mem::take(&mut values.schemes);
        let plain = values.design_of_recipe()?;
        let of = |(key, _, format): &(String, Value, Format)| {
            (key.strip_prefix(FORMAT).unwrap_or_default().to_owned(), *format)
        };
        let named: Vec<(String, Format)> = formats.iter().map(of).collect();
        if !named.is_empty() && plain.netlist.choices().is_empty() {
            return Err(Error::usage(format!(
                "unit `{}` has no formats to set by name: a netlist file fixes its own",
                self.unit.name
            )));
        }
        let of_tables: Vec<(&str, &str)> = schemes
            .iter()
            .map(|(key, _, scheme)| (key.strip_prefix(SCHEME).unwrap_or_default(), scheme.name()))
            .collect();
        let overrides = Overrides::new(&plain.netlist, &named)?;
        values.overrides = overrides.with_schemes(&plain.netlist, &of_tables)?;
        values.formats = formats;
        values.schemes.clone_from(&self.schemes);
        let design = values.design_of_recipe()?;
        let met = |name: &str| {
            design.netlist.choices().iter().any(|choice| choice.overridden && choice.name == name)
        };
        let has_scheme = |table: &str| {
            design.netlist.schemes().iter().any(|choice| choice.overridden && choice.table == table)
        };
        let unmet = named.iter().find(|(name, _)| !met(name));
        let unmet = unmet.map(|(name, _)| format!("format for node `{name}`")).or_else(|| {
            let (table, _) = of_tables.iter().find(|(table, _)| !has_scheme(table))?;
            Some(format!("scheme for table `{table}`"))
        });
        if let Some(what) = unmet {
            return Err(Error::usage(format!(
                "unit `{}` ignores the {what}: its recipe starts with its own builder instead of that of its \
                 parameters",
                self.unit.name
            )));
        }
        Ok(design.bounds(Bounds::unstated(
            "formats of nodes or schemes of tables were overridden, and the unit's bounds hold only for its own",
        )))
    }

    fn design_of_recipe(&self) -> Result<Design> {
        self.unit.check()?;
        let make = self.unit.design.as_ref().expect("bug: it was checked");
        let noting = self.noting();
        let made = make(&noting);
        if let Some(wrong) = noting.wrong() {
            return Err(wrong);
        }
        let design = made?;
        if design.values.unit != self.unit || design.values.values != self.values {
            return Err(Error::usage(format!(
                "unit `{}` makes a design from other values than it was given",
                self.unit.name
            )));
        }
        design.check()?;
        Ok(design)
    }

    /// Adds to an error about a too wide word of `make` the parameters that would narrow it.
    pub(crate) fn with_remedy(&self, error: Error, make: &dyn Fn(&Self) -> Result<()>) -> Error {
        let (node, place, needed) = match error.bits_needed() {
            Some((node, place, bits)) if bits > Format::MAX_BITS => (node, place, bits),
            Some(_) | None => return error,
        };
        let narrower = |step: i64, (index, param): (usize, &Param)| -> Option<String> {
            let (Kind::Int { min, max, .. }, Value::Int(number)) =
                (&param.kind, &self.values[index])
            else {
                return None;
            };
            let changed = number.saturating_add(step).clamp(*min, *max);
            let mut other = self.clone();
            other.values[index] = Value::Int(changed);
            let helps = changed != *number
                && match make(&other) {
                    Ok(()) => true,
                    // Another node is now the next one that is too wide, so the first one no longer
                    // is.
                    Err(other) => other.bits_needed().is_some_and(|(other, later, bits)| {
                        bits < needed || (other != node && later > place)
                    }),
                };
            helps.then(|| format!("`{}`", param.name))
        };
        let all = |step| -> Vec<String> {
            self.unit.params.iter().enumerate().filter_map(|param| narrower(step, param)).collect()
        };
        // If one bit shows no effect, many may: sums of many terms exceed the limit at another
        // term.
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
