//! Calls from a file, and the outcome of each.

use super::setting::{Emboss, Setting};
use super::{gx, nv};
use crate::base::document::{Document, Table};
use crate::base::error::Result;
use crate::base::escape;
use serde::Deserialize;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;

/// Calls in the order in which they are made; the two interfaces are independent.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Calls {
    limits: Option<Spanned<Table<nv::Limits>>>,
    gx: Vec<Spanned<gx::Call>>,
    nv: Vec<Spanned<nv::Call>>,
}

/// A call and its outcome.
#[derive(Clone, Debug)]
pub struct Event {
    /// The interface.
    pub api: Setting,
    /// Its number among the interface's calls, from 1.
    pub number: usize,
    /// Its position in the text, in bytes.
    pub span: Range<usize>,
    /// The call as it was given.
    pub call: String,
    /// What it did, or the rule that it breaks.
    pub outcome: std::result::Result<String, Refusal>,
}

/// A rule that is broken.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// The error that `glGetError` returns, if a program would see one.
    pub gl_error: Option<&'static str>,
    /// The rule.
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

/// A text from a file, shortened and escaped for messages.
fn printable(text: &str) -> String {
    escape::message(text)
}

/// The outcome of all calls together.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Every call.
    pub events: Vec<Event>,
    /// The gap that the GX calls leave, if any.
    pub unfinished: Option<gx::Broken>,
    /// Where the GX state departs from what the patents recommend, but is legal.
    pub advice: Vec<gx::Advice>,
    /// The registers that hold the GX state.
    pub registers: Vec<gx::Register>,
    /// Configurations of the emboss unit.
    pub emboss: Vec<Emboss>,
    /// Texture units whose coordinates are undefined.
    pub undefined: Vec<nv::Undefined>,
}

impl Outcome {
    /// Number of broken rules and undefined texture units.
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
    /// If it isn't TOML, a key is unknown, missing or of another type, or a limit is out of range.
    pub fn parse(text: &str, path: &Path) -> Result<Self> {
        let document = Document { text, path };
        let calls: Self =
            document.parse_tagged("call", &[("gx", gx::Call::kind), ("nv", nv::Call::kind)])?;
        calls.check(&document)?;
        Ok(calls)
    }

    /// Checks what serde can't.
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

    /// True if there are no calls.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.gx.is_empty() && self.nv.is_empty()
    }
}
