//! A signal and its reals.

use crate::hardware::rtl::Signal;
use crate::netlist::Quantity;

/// One signal of the wave.
#[derive(Clone, Debug)]
pub(super) struct Trace {
    pub(super) signal: Signal,
    /// Scopes and name.
    pub(super) path: Vec<String>,
    pub(super) name: String,
    pub(super) quantity: Quantity,
    /// True if the word itself is shown, not only some of its twins.
    pub(super) word: bool,
    /// The reals next to the word.
    pub(super) twins: Vec<Twin>,
    /// Number of the output port, if the signal is one.
    pub(super) port: Option<usize>,
}

/// A real next to a word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Twin {
    Value,
    Ideal,
    ArithError,
    ArithErrorUlp,
    Golden,
    TotalError,
    TotalErrorUlp,
}

impl Twin {
    /// Twins of an exact word.
    pub(super) const EXACT: &[Self] = &[Self::Value];
    /// Twins of any other inner word.
    pub(super) const INSIDE: &[Self] =
        &[Self::Value, Self::Ideal, Self::ArithError, Self::ArithErrorUlp];
    /// Twins of an output port.
    pub(super) const PORT: &[Self] = &[
        Self::Value,
        Self::Ideal,
        Self::ArithError,
        Self::ArithErrorUlp,
        Self::Golden,
        Self::TotalError,
        Self::TotalErrorUlp,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::Ideal => "ideal",
            Self::ArithError | Self::ArithErrorUlp => "arith_error",
            Self::Golden => "golden",
            Self::TotalError | Self::TotalErrorUlp => "total_error",
        }
    }

    fn is_in_ulp(self) -> bool {
        matches!(self, Self::ArithErrorUlp | Self::TotalErrorUlp)
    }
}

/// The angle between a direction and its golden model.
#[derive(Clone, Debug)]
pub(super) struct AngleTrace {
    /// Name without its unit.
    pub(super) name: String,
    /// Number of the direction.
    pub(super) direction: usize,
    /// The stage in which the whole direction is present.
    pub(super) stage: u32,
}

/// Suffix of names for angles in degrees.
pub(super) const DEGREES: &str = "_deg";

impl Trace {
    /// Name of a twin, and the suffix for its unit.
    pub(super) fn twin_name(&self, twin: Twin) -> (String, &'static str) {
        let unit = match self.quantity {
            Quantity::Turns => DEGREES,
            Quantity::Number | Quantity::Float20 => "",
        };
        let unit = if twin.is_in_ulp() { "_ulp" } else { unit };
        (format!("{}_{}", self.name, twin.name()), unit)
    }

    /// Keeps what the patterns select: the word with all twins if one matches the word, otherwise
    /// the twins that match.
    pub(super) fn choose(&mut self, patterns: &[String]) {
        let any = |text: &str| patterns.iter().any(|pattern| matches(pattern, text));
        if any(&full_name(self)) {
            return;
        }
        self.word = false;
        let scopes = self.path.iter().map(|scope| format!("{scope}.")).collect::<String>();
        let mut twins = std::mem::take(&mut self.twins);
        twins.retain(|twin| {
            let (name, unit) = self.twin_name(*twin);
            any(&format!("{scopes}{name}{unit}")) || any(&format!("{scopes}{name}"))
        });
        self.twins = twins;
    }

    pub(super) fn is_shown(&self) -> bool {
        self.word || !self.twins.is_empty()
    }

    /// Factor from values to displayed twins.
    pub(super) fn scale(&self) -> f64 {
        match self.quantity {
            Quantity::Turns => 360.0,
            Quantity::Number | Quantity::Float20 => 1.0,
        }
    }
}

impl AngleTrace {
    /// True if a pattern selects it, with or without its unit.
    pub(super) fn matches(&self, pattern: &str) -> bool {
        matches(pattern, &self.name) || matches(pattern, &format!("{}{DEGREES}", self.name))
    }
}

/// True if `text` matches a pattern with `*` for any text.
pub(super) fn matches(pattern: &str, text: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else { return pattern == text };
    let Some(mut text) = text.strip_prefix(head) else { return false };
    let (middle, tail) = rest.rsplit_once('*').unwrap_or(("", rest));
    // The leftmost match of each middle part leaves the most text for the others.
    for part in middle.split('*') {
        match text.find(part) {
            Some(at) => text = &text[at + part.len()..],
            None => return false,
        }
    }
    text.ends_with(tail)
}

/// `scope.name`, which patterns are matched against.
pub(super) fn full_name(trace: &Trace) -> String {
    let mut names = trace.path.clone();
    names.push(trace.name.clone());
    names.join(".")
}
