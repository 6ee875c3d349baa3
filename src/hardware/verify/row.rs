//! What a tool found.

use super::mismatch::Mismatch;
use serde::Serialize;

/// How a tool's run ended.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// All agrees; what was done, where that isn't plain.
    Agrees(String),
    /// No fault was found, and what was to be proved is not: why.
    Unproved(String),
    /// Words differ; the first of them, if one was named.
    Disagrees(Option<Box<Mismatch>>),
    /// It refused the hardware, or warned: what it said.
    Failed(String),
    /// It ran past the limit of time.
    TimedOut(String),
    /// It ran past the limit of memory, or the machine has too little.
    OutOfMemory(String),
    /// It could not be started, was killed, or had no room for its files: that says nothing of the
    /// hardware.
    Unusable(String),
    /// It isn't there, and what brings it.
    Missing(String),
}

/// What a tool found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The tool.
    pub tool: &'static str,
    /// Its version; empty if it isn't there.
    pub version: String,
    /// Vectors compared.
    pub vectors: u64,
    /// Words that differed.
    pub mismatches: u64,
    /// Time that it took, with building.
    pub seconds: f64,
    /// How it ended.
    pub verdict: Verdict,
}

impl Row {
    /// True if the tool ran and agreed.
    #[must_use]
    pub fn agrees(&self) -> bool {
        matches!(self.verdict, Verdict::Agrees(_))
    }

    /// True if the tool could not finish, which says nothing of the hardware.
    #[must_use]
    pub fn is_unfinished(&self) -> bool {
        matches!(
            self.verdict,
            Verdict::TimedOut(_) | Verdict::OutOfMemory(_) | Verdict::Unusable(_)
        )
    }

    /// True if the tool found no fault, and not the proof that it looked for.
    #[must_use]
    pub fn is_unproved(&self) -> bool {
        matches!(self.verdict, Verdict::Unproved(_))
    }

    /// True if the tool isn't there.
    #[must_use]
    pub fn is_missing(&self) -> bool {
        matches!(self.verdict, Verdict::Missing(_))
    }
}
