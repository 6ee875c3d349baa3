//! The result of both interfaces: a configuration of the emboss unit.

use serde::Serialize;
use std::fmt;

/// One of the two interfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Setting {
    /// `GXSetTexCoordGen`.
    Gx,
    /// `GL_NV_texgen_emboss`.
    Nv,
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}",
            match self {
                Self::Gx => "gx",
                Self::Nv => "nv",
            }
        )
    }
}

/// A configuration of the emboss unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Emboss {
    /// The interface, which also selects the variant of the unit.
    pub setting: Setting,
    /// The light.
    pub light: u32,
    /// The displaced coordinate: a generated coordinate (gx), a texture unit (nv).
    pub source: u32,
    /// The destination of the result, likewise.
    pub destination: u32,
    /// Scale of the displacement of s.
    pub ks: f64,
    /// Scale of the displacement of t.
    pub kt: f64,
}

impl fmt::Display for Emboss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { setting, light, source, destination, ks, kt } = self;
        let (ks, kt) = (Brief(*ks), Brief(*kt));
        write!(
            f,
            "setting={setting} light={light} source={source} destination={destination} ks={ks} kt={kt}"
        )
    }
}

/// A number in its shortest form; very large and small ones in scientific notation.
pub(super) struct Brief(pub(super) f64);

impl fmt::Display for Brief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number) = self;
        let plain = !number.is_finite() || *number == 0.0 || (1e-5..1e16).contains(&number.abs());
        if plain { write!(f, "{number}") } else { write!(f, "{number:e}") }
    }
}
