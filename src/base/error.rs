//! The one error type of the library.
//!
//! An [`Error`] reports bad data from the caller: a parameter out of range, a file that can't be
//! read, a format that would be too wide. Bugs in this crate panic instead, with a message that
//! starts with `bug:`. Every error message names the given value, the legal range and the remedy.

use crate::base::escape;
use std::fmt;
use std::panic::Location;
use std::path::{Path, PathBuf};

/// The result of every fallible function of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// An error in what the caller gave: data, parameters or files. Its message is one line of bounded
/// length without terminal control characters, whatever the input was.
pub struct Error(Box<Kind>);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&escape::message(&self.0.to_string()))
    }
}

/// As [`Display`](fmt::Display): a `main` that returns an error prints it by `Debug`.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.0.source()
    }
}

#[derive(Debug, thiserror::Error)]
enum Kind {
    #[error("format of {bits} bits: a format has 1 to 63 bits")]
    FormatBits { bits: u32 },
    #[error("format with {frac_bits} fraction bits: fraction bits are from -127 to 127")]
    FormatFrac { frac_bits: i32 },
    #[error("`{text}` is not a format: write s16f14, u12f12 or sfix16_En14")]
    FormatText { text: String },
    #[error("word {raw} is outside format {format} ({min}..={max})")]
    WordRange { raw: i64, format: String, min: i64, max: i64 },
    #[error("input `{port}`: word {raw}{} is outside {format} ({min}..={max})", .sample.map(|at| format!(" of sample {at}")).unwrap_or_default())]
    OutsidePort {
        port: String,
        raw: i64,
        sample: Option<usize>,
        format: String,
        min: i64,
        max: i64,
    },
    #[error(
        "word {raw} of format {format} needs {given_bits} significant bits and an f64 holds 53: use the raw word"
    )]
    NotExact { raw: i64, format: String, given_bits: u32 },
    #[error("{value} can't be written in format {format}: give a finite number")]
    NotFinite { value: f64, format: String },
    #[error("{value} overflows format {format} and overflow mode `error` forbids it")]
    ValueOverflow { value: String, format: String },
    #[error(
        "node `{}` needs {given_bits} bits and words have at most {limit_bits}: lower the widths or guard bits that feed it", .node.with_formats
    )]
    NodeTooWide { node: Operation, place: usize, given_bits: u32, limit_bits: u32 },
    #[error("{part} needs {bits} bits and words have at most 63: {remedy}")]
    TooWide { part: String, bits: u32, remedy: String },
    #[error(
        "unit `{unit}`, shared by {operations}, would need words of {bits} bits and words have at most 63: {remedy}, or leave share_{kind}=auto"
    )]
    SharedTooWide {
        unit: String,
        operations: String,
        bits: u32,
        remedy: String,
        kind: &'static str,
    },
    #[error("node `{node}`: {problem}")]
    Node { node: String, problem: String },
    #[error("node `{}`: {problem}", .node.with_formats)]
    Operands { node: Operation, problem: String },
    #[error("{what}: {problem} ({}:{})", .caller.file(), .caller.line())]
    Misuse { what: String, problem: String, caller: &'static Location<'static> },
    #[error("netlist `{netlist}` has no {what}{hint}: {known}")]
    UnknownPart { netlist: String, what: String, hint: String, known: String },
    #[error(
        "node `{node}` overflowed {count} times under overflow mode `error`: widen it or choose another overflow mode"
    )]
    NodeOverflow { node: String, count: u64 },
    #[error("{what} `{given}`: a name is {}", crate::base::name::RULE)]
    Name { what: &'static str, given: String },
    #[error("no unit `{given}`{hint}: `fixpath list` names them all")]
    UnknownUnit { given: String, hint: String },
    #[error("unit `{unit}` has no parameter `{given}`{hint}: `fixpath list {unit}` names them all")]
    UnknownParameter { unit: String, given: String, hint: String },
    #[error("parameter `{name}` = `{value}`: legal is {legal}")]
    ParameterValue { name: String, value: String, legal: String },
    #[error("`{given}` is not of the form {form}")]
    Form { given: String, form: String },
    #[error("{}: {problem}", .path.display())]
    File { path: PathBuf, problem: String },
    #[error("{}, line {line}{}: {problem}", .path.display(), .column.as_ref().map(|c| format!(", column `{c}`")).unwrap_or_default())]
    Csv { path: PathBuf, line: u64, column: Option<String>, problem: String },
    #[error("{}, line {line}, column {column}: {problem}", .path.display())]
    Place { path: PathBuf, line: u64, column: u64, problem: String },
    #[error("{}: {action}: {source}", .path.display())]
    Io { path: PathBuf, action: &'static str, source: std::io::Error },
    #[error("{0}")]
    Usage(String),
}

/// An operation that can't be built, named by its operands.
#[derive(Clone, Debug)]
pub(crate) struct Operation {
    /// As in `add of x`.
    pub(crate) plain: String,
    /// As in `add of x (s8f4), lookup.y (s10f4)`.
    pub(crate) with_formats: String,
    /// The code that asked for it.
    pub(crate) caller: &'static Location<'static>,
}

macro_rules! constructors {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $ty:ty),*) = $kind:expr;)*) => {
        impl Error {
            $($(#[$doc])* pub(crate) fn $name($($arg: $ty),*) -> Self { Self(Box::new($kind)) })*
        }
    };
}

constructors! {
    format_bits(bits: u32) = Kind::FormatBits { bits };
    format_frac(frac_bits: i32) = Kind::FormatFrac { frac_bits };
    format_text(text: &str) = Kind::FormatText { text: escape::short(text) };
    word_range(raw: i64, format: String, min: i64, max: i64) = Kind::WordRange { raw, format, min, max };
    outside_port(port: String, raw: i64, sample: Option<usize>, format: (String, i64, i64)) = Kind::OutsidePort { port, raw, sample, format: format.0, min: format.1, max: format.2 };
    not_exact(raw: i64, format: String, given_bits: u32) = Kind::NotExact { raw, format, given_bits };
    not_finite(value: f64, format: String) = Kind::NotFinite { value, format };
    value_overflow(value: String, format: String) = Kind::ValueOverflow { value, format };
    node_too_wide(node: Operation, place: usize, given_bits: u32, limit_bits: u32) = Kind::NodeTooWide { node, place, given_bits, limit_bits };
    shared_too_wide(unit: &str, operations: String, bits: u32, kind: &'static str) = Kind::SharedTooWide { unit: unit.to_owned(), operations, bits, remedy: "narrow its operands".to_owned(), kind };
    node(node: String, problem: String) = Kind::Node { node, problem };
    operands(node: Operation, problem: String) = Kind::Operands { node, problem };
    misuse(what: String, problem: String, caller: &'static Location<'static>) = Kind::Misuse { what, problem, caller };
    node_overflow(node: String, count: u64) = Kind::NodeOverflow { node, count };
    name(what: &'static str, given: &str) = Kind::Name { what, given: escape::short(given) };
    form(given: &str, form: &str) = Kind::Form { given: escape::short(given), form: form.to_owned() };
    file(path: &Path, problem: String) = Kind::File { path: path.to_owned(), problem };
    csv(path: &Path, line: u64, column: Option<&str>, problem: String) = Kind::Csv { path: path.to_owned(), line, column: column.map(str::to_owned), problem };
    line(path: &Path, line: u64, problem: String) = Kind::Csv { path: path.to_owned(), line, column: None, problem };
    place(path: &Path, line: u64, column: u64, problem: String) = Kind::Place { path: path.to_owned(), line, column, problem };
    io(path: &Path, action: &'static str, source: std::io::Error) = Kind::Io { path: path.to_owned(), action, source };
}

impl Error {
    /// A usage error as free text: what was given, what is legal, what to do.
    #[must_use]
    pub fn usage(text: impl Into<String>) -> Self {
        Self(Box::new(Kind::Usage(text.into())))
    }

    /// An illegal parameter value, as `parameter NAME = VALUE: legal is …`.
    #[must_use]
    pub fn parameter_value(name: &str, value: &str, legal: impl Into<String>) -> Self {
        let (name, value) = (name.to_owned(), escape::short(value));
        Self(Box::new(Kind::ParameterValue { name, value, legal: legal.into() }))
    }

    pub(crate) fn unknown_unit<'a>(given: &str, known: impl Iterator<Item = &'a str>) -> Self {
        Self(Box::new(Kind::UnknownUnit {
            given: escape::short(given),
            hint: nearest(given, known),
        }))
    }

    pub(crate) fn unknown_parameter<'a>(
        unit: &str,
        given: &str,
        known: impl Iterator<Item = &'a str>,
    ) -> Self {
        Self(Box::new(Kind::UnknownParameter {
            unit: unit.to_owned(),
            given: escape::short(given),
            hint: nearest(given, known),
        }))
    }

    /// The netlist has no node of this name whose format can be overridden.
    pub(crate) fn unknown_node(netlist: &str, given: &str, known: &[&str]) -> Self {
        let what = format!("node `{}` whose format can be set", escape::short(given));
        Self::unknown_part(netlist, what, given, known)
    }

    pub(crate) fn unknown_table(netlist: &str, given: &str, known: &[&str]) -> Self {
        let what = format!("table `{}` whose scheme can be set", escape::short(given));
        Self::unknown_part(netlist, what, given, known)
    }

    pub(crate) fn unknown_memory(netlist: &str, given: &str, known: &[&str]) -> Self {
        let what = format!("memory `{}`", escape::short(given));
        Self::unknown_part(netlist, what, given, known)
    }

    fn unknown_part(netlist: &str, what: String, given: &str, known: &[&str]) -> Self {
        let listed = match known {
            [] => "there is none".to_owned(),
            [name] => format!("there is {name}"),
            names => format!("there are {}", names.join(", ")),
        };
        let hint = nearest(given, known.iter().copied());
        Self(Box::new(Kind::UnknownPart { netlist: netlist.to_owned(), what, hint, known: listed }))
    }

    pub(crate) fn earlier_samples(node: String) -> Self {
        Self::node(
            node,
            "it holds words of earlier samples, so errors can't be measured on independent samples: use `eval`, \
             `wave`, `hdl` or `verify`, which process samples in order"
                .to_owned(),
        )
    }

    pub(crate) fn unbound_memory(name: &str) -> Self {
        Self::usage(format!(
            "no words are bound to memory `{name}`: bind them with -p memory.{name}=FILE.csv, or by `Netlist::bind`"
        ))
    }

    /// For errors about a format's bits: the node or shared unit without its number, the number of
    /// nodes built before it, and the bits. An error about a bare format gives only the bits.
    pub(crate) fn bits_needed(&self) -> Option<(&str, usize, u32)> {
        let stem = |name: &'_ String| name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        if let Kind::NodeTooWide { node, place, given_bits, .. } = &*self.0 {
            return Some((&node.plain[..stem(&node.plain)], *place, *given_bits));
        }
        if let Kind::SharedTooWide { unit, bits, .. } = &*self.0 {
            return Some((&unit[..stem(unit)], 0, *bits));
        }
        let Kind::FormatBits { bits } = *self.0 else { return None };
        Some(("", 0, bits))
    }

    /// Adds a remedy to an error about a word that is too wide.
    pub(crate) fn with_remedy(mut self, remedy: String) -> Self {
        if let Kind::SharedTooWide { remedy: known, .. } = &mut *self.0 {
            *known = remedy;
            return self;
        }
        let Some((_, _, bits)) = self.bits_needed() else { return self };
        let part = if let Kind::NodeTooWide { node, .. } = &*self.0 {
            format!("node `{}`", node.with_formats)
        } else {
            "a word".to_owned()
        };
        Self(Box::new(Kind::TooWide { part, bits, remedy }))
    }

    /// Drops the source location, for code that isn't the caller's.
    pub(crate) fn without_place(self) -> Self {
        if let Kind::Misuse { what, problem, .. } = &*self.0 {
            return Self::usage(format!("{what}: {problem}"));
        }
        self
    }

    /// For errors while building a netlist: the source location that asked for the node.
    #[must_use]
    pub fn caller(&self) -> Option<&'static Location<'static>> {
        if let Kind::NodeTooWide { node, .. } | Kind::Operands { node, .. } = &*self.0 {
            return Some(node.caller);
        }
        if let Kind::Misuse { caller, .. } = &*self.0 { Some(caller) } else { None }
    }

    /// True if a failed check stopped the run (exit code 1), false for wrong input (2).
    #[must_use]
    pub fn is_failed_check(&self) -> bool {
        matches!(*self.0, Kind::NodeOverflow { .. })
    }

    /// True if writing failed because the reader of a pipe closed it.
    #[must_use]
    pub fn is_broken_pipe(&self) -> bool {
        matches!(&*self.0, Kind::Io { source, .. } if source.kind() == std::io::ErrorKind::BrokenPipe)
    }

    /// True if the error is about a file as a whole, not about a place in it.
    #[cfg(feature = "pictures")]
    pub(crate) fn is_of_file(&self) -> bool {
        matches!(&*self.0, Kind::Io { .. } | Kind::File { .. })
    }
}

/// The longest text that is compared with known names: the search takes time proportional to its
/// length.
const LONGEST_NAME: usize = 200;

/// `, did you mean …` for the closest known name, or an empty string if none is close.
pub(crate) fn nearest<'a>(given: &str, known: impl Iterator<Item = &'a str>) -> String {
    if given.len() > LONGEST_NAME {
        return String::new();
    }
    known
        .map(|name| (strsim::damerau_levenshtein(given, name), name))
        .min()
        // More than half of it must match.
        .filter(|(distance, _)| 2 * distance < given.chars().count())
        .map(|(_, name)| format!(", did you mean `{name}`"))
        .unwrap_or_default()
}
