//! How often ports get new words.

use std::fmt;
use std::str::FromStr;

/// How often a port gets a new word. A node has the fastest rate of its operands, so a node that
/// depends only on per-face ports is computed once per face and held for the pixels. A constant has
/// the slowest rate. A delay counts samples, so it has the netlist's fastest rate.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub enum Rate {
    /// Once per scene.
    Scene,
    /// Once per object.
    Object,
    /// Once per face.
    Face,
    /// Once per vertex.
    Vertex,
    /// Once per pixel, or per sample of any other kind: the default.
    #[default]
    Pixel,
}

impl Rate {
    /// Every rate, slowest first.
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

/// The name is not a rate.
#[derive(Clone, Copy, Debug)]
pub struct NoRate;

impl FromStr for Rate {
    type Err = NoRate;

    fn from_str(text: &str) -> Result<Self, NoRate> {
        Self::ALL.iter().copied().find(|rate| rate.name() == text).ok_or(NoRate)
    }
}
