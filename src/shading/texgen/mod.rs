//! Texture coordinate generation as two graphics interfaces ask for it: calls in, a configuration of the
//! emboss unit out.
//!
//! [`gx`] has the rules of `GXSetTexCoordGen` (seeds 000 and 003), [`nv`] those of
//! `GL_NV_texgen_emboss` (seed 002). [`Calls`] is a list of calls as it stands in a TOML file:
//!
//! ```
//! use fixpath::texgen::Calls;
//! let calls = Calls::parse(
//!     r#"
//!     [[gx]]
//!     call = "SetTexCoordGen"
//!     dst_coord = "TEXCOORD0"
//!     func = "MTX2x4"
//!     src_param = "TEX0"
//!     mat_idx = "TEXMTX3"
//!
//!     [[gx]]
//!     call = "SetTexCoordGen"
//!     dst_coord = "TEXCOORD1"
//!     func = "BUMP0"
//!     src_param = "TEXCOORD0"
//!     mat_idx = "IDENTITY"
//!     "#,
//!     "calls.toml".as_ref(),
//! )?;
//! let outcome = calls.run();
//! assert_eq!(outcome.problems(), 0);
//! assert_eq!(outcome.emboss[0].to_string(), "setting=gx light=0 source=0 destination=1 ks=1 kt=1");
//! # Ok::<(), fixpath::error::Error>(())
//! ```

pub mod gx;
pub mod nv;
mod opengl;

use crate::base::document::{Document, Table};
use crate::base::error::Result;
use crate::base::escape;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;

/// Calls in the order in which they are made; the two interfaces don't know of each other.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Calls {
    limits: Option<Spanned<Table<nv::Limits>>>,
    gx: Vec<Spanned<gx::Call>>,
    nv: Vec<Spanned<nv::Call>>,
}

/// One of the two interfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Setting {
    /// `GXSetTexCoordGen`.
    Gx,
    /// `GL_NV_texgen_emboss`.
    Nv,
}

/// A configuration of the emboss unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Emboss {
    /// The interface, whose variant of the unit it is.
    pub setting: Setting,
    /// The light.
    pub light: u32,
    /// What is displaced: a generated coordinate (gx), a texture unit (nv).
    pub source: u32,
    /// Where the result goes, likewise.
    pub destination: u32,
    /// Scale of the displacement of s.
    pub ks: f64,
    /// Scale of the displacement of t.
    pub kt: f64,
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

impl fmt::Display for Emboss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { setting, light, source, destination, ks, kt } = self;
        let (ks, kt) = (nv::Brief(*ks), nv::Brief(*kt));
        write!(
            f,
            "setting={setting} light={light} source={source} destination={destination} ks={ks} kt={kt}"
        )
    }
}

/// A call, and what came of it.
#[derive(Clone, Debug)]
pub struct Event {
    /// The interface.
    pub api: Setting,
    /// Which of its calls, from 1.
    pub number: usize,
    /// Where it stands in the text, in bytes.
    pub span: Range<usize>,
    /// The call as it was given.
    pub call: String,
    /// What it did, or the rule that it breaks.
    pub outcome: std::result::Result<String, Refusal>,
}

/// A rule that is broken.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// What `glGetError` gives, where that is what a program would see.
    pub gl_error: Option<&'static str>,
    /// Which rule.
    pub message: String,
}

impl From<gx::Broken> for Refusal {
    fn from(broken: gx::Broken) -> Self {
        Self { gl_error: None, message: printable(&broken.to_string()) }
    }
}

impl From<nv::Broken> for Refusal {
    fn from(broken: nv::Broken) -> Self {
        Self { gl_error: broken.gl_error(), message: printable(&broken.to_string()) }
    }
}

/// A text from a file as it is told: texts in calls can be long.
fn printable(text: &str) -> String {
    escape::message(text)
}

/// What all calls together give.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Every call.
    pub events: Vec<Event>,
    /// What the GX calls leave unfinished.
    pub unfinished: Option<gx::Broken>,
    /// Where the GX state isn't as the patents say that it should be, but may be.
    pub advice: Vec<gx::Advice>,
    /// The registers that hold the GX state.
    pub registers: Vec<gx::Register>,
    /// Configurations of the emboss unit.
    pub emboss: Vec<Emboss>,
    /// Texture units whose coordinates are undefined.
    pub undefined: Vec<nv::Undefined>,
}

impl Outcome {
    /// Broken rules and undefined texture units.
    #[must_use]
    pub fn problems(&self) -> usize {
        let refused = self.events.iter().filter(|event| event.outcome.is_err()).count();
        refused + usize::from(self.unfinished.is_some()) + self.undefined.len()
    }
}

impl Calls {
    /// Reads a TOML file; `path` names it in messages.
    ///
    /// # Errors
    /// If it isn't TOML, if a key is unknown, missing or of another type, or a limit is out of range.
    pub fn parse(text: &str, path: &Path) -> Result<Self> {
        let document = Document { text, path };
        let calls: Self =
            document.parse_tagged("call", &[("gx", gx::Call::kind), ("nv", nv::Call::kind)])?;
        calls.check(&document)?;
        Ok(calls)
    }

    /// What serde can't check.
    pub(crate) fn check(&self, document: &Document<'_>) -> Result<()> {
        if let Some((at, problem)) = self.nv.iter().find_map(|call| call.get_ref().miscounted()) {
            return Err(document.fail(&at, problem));
        }
        let Some(limits) = &self.limits else { return Ok(()) };
        let of = limits.get_ref();
        for (key, value, least) in
            [("lights", of.lights, 8), ("texture_units", of.texture_units, 1)]
        {
            if !(least..=32).contains(&value) {
                let problem = format!("`{key}` = {value}: legal is {least} to 32");
                return Err(document.fail(&limits.span(), problem));
            }
        }
        Ok(())
    }

    /// Makes every call.
    #[must_use]
    pub fn run(&self) -> Outcome {
        let mut events = Vec::new();
        let mut coordinates = gx::TexCoords::default();
        for (number, call) in (1..).zip(&self.gx) {
            let outcome = coordinates.call(call.get_ref()).map_err(Refusal::from);
            let (span, call) = (call.span(), printable(&call.get_ref().to_string()));
            events.push(Event { api: Setting::Gx, number, span, call, outcome });
        }
        let limits =
            self.limits.as_ref().map_or_else(nv::Limits::default, |limits| **limits.get_ref());
        let mut state = nv::State::new(limits);
        for (number, call) in (1..).zip(&self.nv) {
            let outcome = state.call(call.get_ref()).map_err(Refusal::from);
            let (span, call) = (call.span(), printable(&call.get_ref().to_string()));
            events.push(Event { api: Setting::Nv, number, span, call, outcome });
        }
        let mut emboss = coordinates.emboss();
        let mut undefined = Vec::new();
        for unit in state.emboss() {
            match unit {
                Ok(configured) => emboss.push(configured),
                Err(unit) => undefined.push(unit),
            }
        }
        Outcome {
            events,
            unfinished: coordinates.finish().err(),
            advice: coordinates.advice(),
            registers: coordinates.registers(),
            emboss,
            undefined,
        }
    }

    /// True if there is no call at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.gx.is_empty() && self.nv.is_empty()
    }
}
