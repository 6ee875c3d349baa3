//! How often ports take words.

use std::fmt;
use std::str::FromStr;

/// How often a port takes a new word. A node has the fastest rate of its operands, so what comes
/// once for a face is computed once for it, and held for the pixels. A constant has the slowest,
/// and a delay, which counts samples, the fastest of the netlist.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub enum Rate {
    /// Once for a scene.
    Scene,
    /// Once for an object.
    Object,
    /// Once for a face.
    Face,
    /// Once for a vertex.
    Vertex,
    /// Once for a pixel, or whatever a sample is: a port has this rate if nothing else is said.
    #[default]
    Pixel,
}

impl Rate {
    /// Every rate, from the slowest.
    pub const ALL: &'static [Self] =
        &[Self::Scene, Self::Object, Self::Face, Self::Vertex, Self::Pixel];

    /// Name in files, listings and ports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Object => "object",
            Self::Face => "face",
            Self::Vertex => "vertex",
            Self::Pixel => "pixel",
        }
    }
}

impl fmt::Display for Rate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A name that is no rate.
#[derive(Clone, Copy, Debug)]
pub struct NoRate;

impl FromStr for Rate {
    type Err = NoRate;

    fn from_str(text: &str) -> Result<Self, NoRate> {
        Self::ALL.iter().copied().find(|rate| rate.name() == text).ok_or(NoRate)
    }
}
