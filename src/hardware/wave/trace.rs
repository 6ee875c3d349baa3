//! A signal with the reals beside it.

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
    /// The reals beside it.
    pub(super) twins: Vec<Twin>,
    /// Number of the output port that it is.
    pub(super) port: Option<usize>,
}

/// A real beside a word.
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
    /// Those of an exact word.
    pub(super) const EXACT: &[Self] = &[Self::Value];
    /// Those of another word inside.
    pub(super) const INSIDE: &[Self] =
        &[Self::Value, Self::Ideal, Self::ArithError, Self::ArithErrorUlp];
    /// Those of an output port.
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

/// The angle between a direction and its golden.
#[derive(Clone, Debug)]
pub(super) struct AngleTrace {
    /// Name without its unit.
    pub(super) name: String,
    /// Number of the direction.
    pub(super) direction: usize,
    /// The stage in which all of the direction is there.
    pub(super) stage: u32,
}

/// Unit of angles at the end of a name.
pub(super) const DEGREES: &str = "_deg";

impl Trace {
    /// Name of a twin, and its unit behind it.
    pub(super) fn twin_name(&self, twin: Twin) -> (String, &'static str) {
        let unit = match self.quantity {
            Quantity::Turns => DEGREES,
            Quantity::Number | Quantity::Float20 => "",
        };
        let unit = if twin.is_in_ulp() { "_ulp" } else { unit };
        (format!("{}_{}", self.name, twin.name()), unit)
    }

    /// Leaves what patterns choose: all of a word that one matches, or the twins that one does.
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

    /// Factor from values to what twins show.
    pub(super) fn scale(&self) -> f64 {
        match self.quantity {
            Quantity::Turns => 360.0,
            Quantity::Number | Quantity::Float20 => 1.0,
        }
    }
}

impl AngleTrace {
    /// True if a pattern chooses it, with its unit or without.
    pub(super) fn matches(&self, pattern: &str) -> bool {
        matches(pattern, &self.name) || matches(pattern, &format!("{}{DEGREES}", self.name))
    }
}

/// True if `text` matches a pattern with `*` for any text.
pub(super) fn matches(pattern: &str, text: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else { return pattern == text };
    let Some(mut text) = text.strip_prefix(head) else { return false };
    let (middle, tail) = rest.rsplit_once('*').unwrap_or(("", rest));
    // The leftmost place of each middle part leaves the most text to the others.
    for part in middle.split('*') {
        match text.find(part) {
            Some(at) => text = &text[at + part.len()..],
            None => return false,
        }
    }
    text.ends_with(tail)
}

/// `scope.name`, what patterns are matched with.
pub(super) fn full_name(trace: &Trace) -> String {
    let mut names = trace.path.clone();
    names.push(trace.name.clone());
    names.join(".")
}
