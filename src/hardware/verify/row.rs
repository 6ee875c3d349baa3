//! Result of a tool.

use super::mismatch::Mismatch;
use serde::Serialize;

/// How a tool's run ended.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Everything agrees; the text says what was checked, unless that is obvious.
    Agrees(String),
    /// No fault was found, but the intended proof wasn't obtained: the reason.
    Unproved(String),
    /// Words differ; the first of them, if the tool named one.
    Disagrees(Option<Box<Mismatch>>),
    /// The tool rejected the hardware or warned about it: its message.
    Failed(String),
    /// It ran past the time limit.
    TimedOut(String),
    /// It ran past the memory limit, or the machine has too little memory.
    OutOfMemory(String),
    /// It could not be started, was killed, or had no room for its files: this says nothing about
    /// the hardware.
    Unusable(String),
    /// It isn't installed: how to install it.
    Missing(String),
}

/// Result of a tool.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The tool.
    pub tool: &'static str,
    /// Its version; empty if it isn't installed.
    pub version: String,
    /// Vectors compared.
    pub vectors: u64,
    /// Words that differed.
    pub mismatches: u64,
    /// Run time, including the build.
    pub seconds: f64,
    /// How the run ended.
    pub verdict: Verdict,
}

impl Row {
    /// True if the tool ran and agreed.
    #[must_use]
    pub fn agrees(&self) -> bool {
        matches!(self.verdict, Verdict::Agrees(_))
    }

    /// True if the tool could not finish, which says nothing about the hardware.
    #[must_use]
    pub fn is_unfinished(&self) -> bool {
        matches!(
            self.verdict,
            Verdict::TimedOut(_) | Verdict::OutOfMemory(_) | Verdict::Unusable(_)
        )
    }

    /// True if the tool found no fault, but no proof either.
    #[must_use]
    pub fn is_unproved(&self) -> bool {
        matches!(self.verdict, Verdict::Unproved(_))
    }

    /// True if the tool isn't installed.
    #[must_use]
    pub fn is_missing(&self) -> bool {
        matches!(self.verdict, Verdict::Missing(_))
    }
}
