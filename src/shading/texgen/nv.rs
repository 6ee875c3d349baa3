//! The state of `GL_NV_texgen_emboss`: texture units, their coordinate generation, and the lights
//! that it needs.
//!
//! [`State`] is what calls build up. A call that OpenGL answers with an error is rejected and
//! leaves the state unchanged. As a restriction of this tool, so is a constant or plane with a
//! number that isn't finite. Only what the extension adds is checked: everything else of OpenGL 1.x
//! (planes, capabilities, other commands; `opengl` has the names) is stored as given, or passed on.
//! Coordinates in mode EMBOSS_MAP_NV are defined only if all four coordinates of the unit have that
//! mode and are enabled, S and T name the same light, and that light and lighting are enabled.
//! [`State::emboss`] returns a configuration, or every condition that fails.
//!
//! These come from the specification: tokens, errors, initial values (EYE_LINEAR, 1.0, LIGHT0, for
//! each of the four coordinates of each unit), odd units only, conditions. These come from OpenGL
//! 1.2 and ARB_multitexture, on which it builds: the other modes, that SPHERE_MAP is an error for R
//! and Q, the capabilities that are initially enabled (DITHER, MULTISAMPLE), and that a unit or
//! light out of range is INVALID_ENUM. REFLECTION_MAP and NORMAL_MAP, not for Q, come from OpenGL
//! 1.3.

use super::gx::numbered;
use super::opengl;
use super::setting::{Brief, Emboss, Setting};
use crate::base::cast;
use crate::base::error::nearest;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::ops::Range;
use toml::Spanned;

/// The limits of an implementation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Limits {
    /// MAX_LIGHTS; defaults to 8, the least that OpenGL allows.
    pub lights: i64,
    /// MAX_TEXTURE_UNITS; defaults to 4.
    pub texture_units: i64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { lights: 8, texture_units: 4 }
    }
}

/// A call; in a file, a TOML table with the call's name under `call`.
#[derive(Clone, Debug, Deserialize)]
pub enum Call {
    /// Selects the unit that later calls refer to.
    ActiveTexture {
        /// TEXTUREi.
        texture: String,
    },
    /// Sets a parameter of a coordinate.
    TexGen {
        /// S, T, R or Q.
        coord: String,
        /// TEXTURE_GEN_MODE, OBJECT_PLANE, EYE_PLANE, EMBOSS_LIGHT_NV or EMBOSS_CONSTANT_NV.
        pname: String,
        /// A token, a number, or an array of them.
        #[serde(alias = "params")]
        param: Spanned<Param>,
    },
    /// The same by a command that passes one value, so it can't set a plane: glTexGend, f or i.
    TexGenValue {
        /// S, T, R or Q.
        coord: String,
        /// TEXTURE_GEN_MODE, EMBOSS_LIGHT_NV or EMBOSS_CONSTANT_NV.
        pname: String,
        /// A token or a number.
        #[serde(alias = "params")]
        param: Spanned<Param>,
    },
    /// Queries a parameter of a coordinate.
    GetTexGen {
        /// S, T, R or Q.
        coord: String,
        /// As above.
        pname: String,
    },
    /// Enables a capability: LIGHTING, LIGHTi, TEXTURE_GEN_S, T, R, Q, or any other of OpenGL.
    Enable {
        /// The capability.
        cap: String,
    },
    /// Disables a capability.
    Disable {
        /// The capability.
        cap: String,
    },
    /// Queries whether a capability is enabled.
    IsEnabled {
        /// The capability.
        cap: String,
    },
    /// Another OpenGL command by its name, with its arguments by name: passed on.
    Other(BTreeMap<String, BTreeMap<Spanned<String>, Param>>),
}

/// The commands that are modelled here, without type suffixes.
const JUDGED: [&str; 6] =
    ["ActiveTexture", "TexGen", "GetTexGen", "Enable", "Disable", "IsEnabled"];

/// Other commands that may change the state here, in a way that isn't modelled.
const NOT_FOLLOWED: [&str; 11] = [
    "PushAttrib",
    "PopAttrib",
    "NewList",
    "EndList",
    "CallList",
    "CallLists",
    // These change the client's arrays.
    "EnableClientState",
    "DisableClientState",
    "InterleavedArrays",
    "PushClientAttrib",
    "PopClientAttrib",
];

impl Call {
    /// The variant of a command, with or without the prefix `gl`.
    ///
    /// # Errors
    /// If OpenGL has no such command.
    pub(super) fn kind(given: &str) -> Result<Vec<String>, String> {
        let name = command(given);
        let plain = name.strip_suffix("ARB").unwrap_or(name);
        // TexGen{ifd}, TexGen{ifd}v, and so for GetTexGen.
        let typed = |of: &str| {
            let end = plain.strip_prefix(of).map(|end| end.strip_suffix('v').unwrap_or(end));
            end.is_some_and(|end| ["", "d", "f", "i"].contains(&end))
        };
        if ["TexGend", "TexGenf", "TexGeni"].contains(&plain) {
            return Ok(vec!["TexGenValue".to_owned()]);
        }
        let is = |of: &&&str| **of == plain || (of.ends_with("TexGen") && typed(of));
        if let Some(known) = JUDGED.iter().find(is) {
            return Ok(vec![(*known).to_owned()]);
        }
        if opengl::is_command(name) {
            return Ok(vec!["Other".to_owned(), given.to_owned()]);
        }
        let hint = nearest(name, JUDGED.into_iter().chain(opengl::commands()));
        Err(format!("no call `{given}`{hint}: legal are the commands of OpenGL 1.x"))
    }

    /// Position and problem of a parameter whose number of values isn't what the command reads.
    pub(super) fn miscounted(&self) -> Option<(Range<usize>, String)> {
        let (Self::TexGen { pname, param, .. } | Self::TexGenValue { pname, param, .. }) = self
        else {
            return None;
        };
        let Param::List(values) = param.get_ref() else { return None };
        let takes = Pname::parse(pname).ok()?.values();
        let many = values.len();
        let told =
            || (param.span(), format!("`param` has {many} values, but {pname} takes {takes}"));
        (takes != many).then(told)
    }
}

/// The name of a command without `gl`.
fn command(name: &str) -> &str {
    name.strip_prefix("gl").unwrap_or(name)
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged, expecting = "param is a number or the name of a token, or an array of them")]
pub enum Param {
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f64),
    /// A token by its name.
    Token(String),
    /// TRUE or FALSE.
    Flag(bool),
    /// The values that a pointer points to.
    List(Vec<Param>),
}

impl Param {
    /// The number, if it is finite.
    fn number(&self) -> Option<f64> {
        let number = match self {
            Self::Integer(number) => cast::f64_of(*number),
            Self::Number(number) => *number,
            Self::Token(_) | Self::Flag(_) | Self::List(_) => return None,
        };
        number.is_finite().then_some(number)
    }
}

/// A coordinate of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Coord {
    /// The first.
    S,
    /// The second.
    T,
    /// The third.
    R,
    /// The divisor of the others.
    Q,
}

/// How a coordinate is generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "SCREAMING_SNAKE_CASE")]
pub enum Mode {
    /// A plane in eye coordinates.
    EyeLinear,
    /// A plane in the object's coordinates.
    ObjectLinear,
    /// A reflection, on a sphere.
    SphereMap,
    /// The normal in eye coordinates.
    NormalMap,
    /// A reflection in eye coordinates.
    ReflectionMap,
    /// Emboss.
    EmbossMapNv,
}

/// A parameter of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pname {
    Mode,
    ObjectPlane,
    EyePlane,
    Light,
    Constant,
}

/// A capability.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Cap {
    Lighting,
    Light(u8),
    TexGen(Coord),
    /// An array of the client, which another command enables.
    Array(String),
    /// Any other OpenGL capability, with its unit if each unit has its own.
    Other(Option<u8>, String),
}

/// A rejected call. OpenGL answers each with INVALID_ENUM, except [`Broken::Constant`] and
/// [`Broken::Plane`]: a C program can make those calls without an error, and rejecting them is a
/// restriction of this tool.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Broken {
    /// A name or number that isn't a legal token.
    #[error("INVALID_ENUM: {argument} `{given}`{hint}: legal is {legal}")]
    Token {
        /// The argument.
        argument: &'static str,
        /// The given text.
        given: String,
        /// `, did you mean …`, or nothing.
        hint: String,
        /// Its legal values.
        legal: &'static str,
    },
    /// Emboss on an even unit.
    #[error("INVALID_ENUM: {token} with texture unit {unit} active: only odd units accept it")]
    EvenUnit {
        /// The token in question.
        token: &'static str,
        /// The active unit.
        unit: u8,
    },
    /// A light or a constant for R or Q.
    #[error("INVALID_ENUM: {token} of coordinate {coord:?}: only S and T accept it")]
    RightCoord {
        /// The parameter.
        token: &'static str,
        /// The coordinate.
        coord: Coord,
    },
    /// A light that doesn't exist.
    #[error("INVALID_ENUM: {given}: i of LIGHTi is from 0 to MAX_LIGHTS - 1 = {last}")]
    Light {
        /// Its name as given.
        given: String,
        /// The last light.
        last: u8,
    },
    /// A number that isn't that of a light.
    #[error(
        "INVALID_ENUM: EMBOSS_LIGHT_NV {given}: legal is LIGHT0 = {LIGHT0} to LIGHT{last} = {}", LIGHT0 + i64::from(*.last)
    )]
    LightNumber {
        /// The number as given.
        given: String,
        /// The last light.
        last: u8,
    },
    /// A unit that doesn't exist.
    #[error("INVALID_ENUM: {given}: i of TEXTUREi is from 0 to MAX_TEXTURE_UNITS - 1 = {last}")]
    Unit {
        /// Its name as given.
        given: String,
        /// The last unit.
        last: u8,
    },
    /// A mode that the coordinate doesn't accept.
    #[error("INVALID_ENUM: {mode} of coordinate {coord:?}: only {takes} accept it")]
    ModeCoord {
        /// The mode.
        mode: Mode,
        /// The coordinate.
        coord: Coord,
        /// The coordinates that accept it.
        takes: &'static str,
    },
    /// A plane set by a command that passes one value.
    #[error(
        "INVALID_ENUM: {token} needs four values, and this command passes one: use glTexGendv, fv or iv"
    )]
    PlaneOfOne {
        /// The parameter.
        token: &'static str,
    },
    /// A plane that isn't four finite numbers; rejected by this tool, like [`Broken::Constant`].
    #[error("{token} = {given}: legal are four finite numbers")]
    Plane {
        /// The parameter.
        token: &'static str,
        /// The given value.
        given: String,
    },
    /// A constant that is NaN, infinite, or a token. In C all of them are numbers and OpenGL
    /// accepts them. This tool rejects them: the first two define no displacement, and a token is a
    /// mistake.
    #[error(
        "EMBOSS_CONSTANT_NV = {given}: legal is a finite number, such as 1 over the width of the texture"
    )]
    Constant {
        /// The given value.
        given: String,
    },
}

impl Broken {
    /// The error that `glGetError` returns; `None` if only this tool rejects the call.
    #[must_use]
    pub fn gl_error(&self) -> Option<&'static str> {
        match self {
            Self::Constant { .. } | Self::Plane { .. } => None,
            Self::Token { .. }
            | Self::EvenUnit { .. }
            | Self::RightCoord { .. }
            | Self::Light { .. }
            | Self::LightNumber { .. }
            | Self::Unit { .. }
            | Self::PlaneOfOne { .. }
            | Self::ModeCoord { .. } => Some("INVALID_ENUM"),
        }
    }

    fn token<'a>(
        argument: &'static str,
        given: &str,
        legal: &'static str,
        known: impl Iterator<Item = &'a str>,
    ) -> Self {
        let hint = nearest(bare(given), known);
        Self::Token { argument, given: given.to_owned(), hint, legal }
    }
}

/// A condition that fails and makes the result undefined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Condition {
    /// Not all four coordinates have the mode.
    #[error("TEXTURE_GEN_MODE of {coord:?} is {mode}: all of S, T, R and Q must be EMBOSS_MAP_NV")]
    Mode {
        /// A coordinate with another mode.
        coord: Coord,
        /// Its mode.
        mode: Mode,
    },
    /// Not all four coordinates are enabled.
    #[error("TEXTURE_GEN_{coord:?} is disabled: it must be enabled for all of S, T, R and Q")]
    Disabled {
        /// A disabled coordinate.
        coord: Coord,
    },
    /// S and T name different lights.
    #[error("EMBOSS_LIGHT_NV of S is LIGHT{s} and of T is LIGHT{t}: they must be the same")]
    Lights {
        /// The light of S.
        s: u8,
        /// The light of T.
        t: u8,
    },
    /// The light is off.
    #[error("LIGHT{light} is disabled: the light of the emboss must be enabled")]
    LightOff {
        /// Its number.
        light: u8,
    },
    /// Lighting is off.
    #[error("LIGHTING is disabled: it must be enabled")]
    LightingOff,
}

/// A unit whose coordinates are undefined, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Undefined {
    /// The texture unit.
    pub unit: u8,
    /// Its coordinates in mode EMBOSS_MAP_NV.
    pub coords: Vec<Coord>,
    /// Every condition that fails.
    pub conditions: Vec<Condition>,
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = Self::ALL.iter().find(|(mode, ..)| mode == self);
        write!(f, "{}", known.expect("bug: every mode has a name").1)
    }
}

impl fmt::Display for Param {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Integer(number) => write!(f, "{number}"),
            Self::Number(number) => write!(f, "{}", Brief(*number)),
            Self::Token(name) => write!(f, "{name}"),
            Self::Flag(on) => write!(f, "{}", if *on { "TRUE" } else { "FALSE" }),
            Self::List(values) => {
                let values: Vec<String> = values.iter().map(ToString::to_string).collect();
                write!(f, "[{}]", values.join(", "))
            }
        }
    }
}

impl fmt::Display for Call {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ActiveTexture { texture } => write!(f, "glActiveTexture({texture})"),
            Self::TexGen { coord, pname, param } | Self::TexGenValue { coord, pname, param } => {
                write!(f, "glTexGen({coord}, {pname}, {})", param.get_ref())
            }
            Self::GetTexGen { coord, pname } => write!(f, "glGetTexGen({coord}, {pname})"),
            Self::Enable { cap } => write!(f, "glEnable({cap})"),
            Self::Disable { cap } => write!(f, "glDisable({cap})"),
            Self::IsEnabled { cap } => write!(f, "glIsEnabled({cap})"),
            Self::Other(calls) => calls.iter().try_for_each(|(name, arguments)| {
                // In the order of the file.
                let mut arguments: Vec<_> = arguments.iter().collect();
                arguments.sort_by_key(|(key, _)| key.span().start);
                let values: Vec<String> =
                    arguments.into_iter().map(|(_, value)| value.to_string()).collect();
                write!(f, "gl{}({})", command(name), values.join(", "))
            }),
        }
    }
}

/// A name without the prefix `GL_`.
fn bare(text: &str) -> &str {
    text.strip_prefix("GL_").unwrap_or(text)
}

impl Coord {
    const ALL: [(Self, &'static str); 4] =
        [(Self::S, "S"), (Self::T, "T"), (Self::R, "R"), (Self::Q, "Q")];

    fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, is)| *is == name).map(|(coord, _)| *coord)
    }

    fn parse(text: &str) -> Result<Self, Broken> {
        let names = || Self::ALL.iter().map(|(_, name)| *name);
        Self::named(bare(text)).ok_or_else(|| Broken::token("coord", text, "S, T, R or Q", names()))
    }

    fn index(self) -> usize {
        Self::ALL.iter().position(|(coord, _)| *coord == self).expect("bug: every one is listed")
    }
}

impl Mode {
    const ALL: [(Self, &'static str, i64); 6] = [
        (Self::EyeLinear, "EYE_LINEAR", 0x2400),
        (Self::ObjectLinear, "OBJECT_LINEAR", 0x2401),
        (Self::SphereMap, "SPHERE_MAP", 0x2402),
        (Self::NormalMap, "NORMAL_MAP", 0x8511),
        (Self::ReflectionMap, "REFLECTION_MAP", 0x8512),
        (Self::EmbossMapNv, "EMBOSS_MAP_NV", 0x855f),
    ];

    fn parse(param: &Param) -> Result<Self, Broken> {
        // Two of them were extensions of three vendors, with the same numbers.
        let core = |name: &str| -> String {
            let ends = ["_MAP_ARB", "_MAP_EXT", "_MAP_NV"];
            let stem = ends.iter().find_map(|end| name.strip_suffix(end));
            match stem.filter(|stem| ["NORMAL", "REFLECTION"].contains(stem)) {
                Some(stem) => format!("{stem}_MAP"),
                None => name.to_owned(),
            }
        };
        let known = Self::ALL.iter().find(|(_, name, number)| match param {
            Param::Token(text) => *name == core(bare(text)),
            Param::Integer(given) => number == given,
            Param::Number(given) => cast::f64_of(*number) == *given,
            Param::Flag(_) | Param::List(_) => false,
        });
        known.map(|(mode, ..)| *mode).ok_or_else(|| {
            let legal =
                "EYE_LINEAR, OBJECT_LINEAR, SPHERE_MAP, NORMAL_MAP, REFLECTION_MAP or EMBOSS_MAP_NV";
            let names = Self::ALL.iter().map(|(_, name, _)| *name);
            Broken::token("TEXTURE_GEN_MODE", &param.to_string(), legal, names)
        })
    }

    /// The coordinates that accept it, unless all do.
    fn takes(self) -> Option<(&'static str, &'static [Coord])> {
        match self {
            Self::EyeLinear | Self::ObjectLinear | Self::EmbossMapNv => None,
            Self::SphereMap => Some(("S and T", &[Coord::S, Coord::T])),
            Self::NormalMap | Self::ReflectionMap => {
                Some(("S, T and R", &[Coord::S, Coord::T, Coord::R]))
            }
        }
    }
}

impl Pname {
    const ALL: [(Self, &'static str); 5] = [
        (Self::Mode, "TEXTURE_GEN_MODE"),
        (Self::ObjectPlane, "OBJECT_PLANE"),
        (Self::EyePlane, "EYE_PLANE"),
        (Self::Light, "EMBOSS_LIGHT_NV"),
        (Self::Constant, "EMBOSS_CONSTANT_NV"),
    ];

    fn parse(text: &str) -> Result<Self, Broken> {
        let known = Self::ALL.iter().find(|(_, name)| *name == bare(text));
        known.map(|(pname, _)| *pname).ok_or_else(|| {
            let legal =
                "TEXTURE_GEN_MODE, OBJECT_PLANE, EYE_PLANE, EMBOSS_LIGHT_NV or EMBOSS_CONSTANT_NV";
            Broken::token("pname", text, legal, Self::ALL.iter().map(|(_, name)| *name))
        })
    }

    fn name(self) -> &'static str {
        let known = Self::ALL.iter().find(|(pname, _)| *pname == self);
        known.expect("bug: every parameter has a name").1
    }

    /// Number of its values: a plane has four coefficients.
    fn values(self) -> usize {
        match self {
            Self::ObjectPlane | Self::EyePlane => 4,
            Self::Mode | Self::Light | Self::Constant => 1,
        }
    }
}

/// A coordinate's state.
#[derive(Clone, Debug, PartialEq)]
struct Generation {
    mode: Mode,
    enabled: bool,
    object_plane: Param,
    eye_plane: Param,
    constant: f64,
    light: u8,
}

impl Generation {
    /// Table 6.14, as changed by the extension.
    fn initial(coord: Coord) -> Self {
        // The planes of S and T select that coordinate, those of R and Q are 0.
        let plane = |along| Param::Number(if coord == along { 1.0 } else { 0.0 });
        let zero = || Param::Number(0.0);
        let plane = || Param::List(vec![plane(Coord::S), plane(Coord::T), zero(), zero()]);
        Self {
            mode: Mode::EyeLinear,
            enabled: false,
            object_plane: plane(),
            eye_plane: plane(),
            constant: 1.0,
            light: 0,
        }
    }
}

/// Checks a plane. A single number is accepted if a call doesn't name a command with four values.
fn plane(pname: Pname, param: &Param) -> Result<Param, Broken> {
    let values = if let Param::List(values) = param { values } else { std::slice::from_ref(param) };
    let legal = values.iter().all(|value| value.number().is_some());
    let given = || Broken::Plane { token: pname.name(), given: param.to_string() };
    legal.then(|| param.clone()).ok_or_else(given)
}

/// The number of LIGHT0.
const LIGHT0: i64 = 0x4000;

/// The state of all texture units, and of the lights.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    active: u8,
    units: Vec<[Generation; 4]>,
    lights: Vec<bool>,
    lighting: bool,
    /// Other enabled capabilities, with the unit if each unit has its own.
    others: BTreeSet<(Option<u8>, String)>,
    /// Number of unknown names that may still get a hint.
    hints: u32,
}

/// The most unknown names that get a hint: each is compared with all capabilities.
const MAX_HINTS: u32 = 1000;

impl State {
    /// The initial state, with 1 to 255 lights and units: limits beyond are clamped.
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        let count = |limit: i64| cast::index_of(limit.clamp(1, i64::from(u8::MAX)));
        Self {
            active: 0,
            units: vec![
                Coord::ALL.map(|(coord, _)| Generation::initial(coord));
                count(limits.texture_units)
            ],
            lights: vec![false; count(limits.lights)],
            lighting: false,
            others: ["DITHER", "MULTISAMPLE"].map(|cap| (None, cap.to_owned())).into(),
            hints: MAX_HINTS,
        }
    }

    fn last_light(&self) -> u8 {
        u8::try_from(self.lights.len() - 1).expect("bug: 255 lights at most")
    }

    /// A light by its name; `None` if the name isn't LIGHTi.
    fn light(&self, name: &str) -> Option<Result<u8, Broken>> {
        let (light, last) = (numbered(bare(name), "LIGHT")?, self.last_light());
        let given = name.to_owned();
        Some(if light <= last { Ok(light) } else { Err(Broken::Light { given, last }) })
    }

    /// A light by its name or number, which may be a float.
    fn emboss_light(&self, param: &Param) -> Result<u8, Broken> {
        let last = self.last_light();
        let number = |light: &u8| LIGHT0 + i64::from(*light);
        let found = match param {
            Param::Token(name) => {
                return self.light(name).unwrap_or_else(|| {
                    let known = ["LIGHT0"].into_iter();
                    Err(Broken::token("EMBOSS_LIGHT_NV", name, "LIGHTi", known))
                });
            }
            Param::Integer(given) => (0..=last).find(|light| number(light) == *given),
            Param::Number(given) => (0..=last).find(|light| cast::f64_of(number(light)) == *given),
            Param::Flag(_) | Param::List(_) => None,
        };
        found.ok_or_else(|| Broken::LightNumber { given: param.to_string(), last })
    }

    fn cap(&mut self, text: &str) -> Result<Cap, Broken> {
        if let Some(light) = self.light(text) {
            return Ok(Cap::Light(light?));
        }
        let known = opengl::capability(bare(text)).ok_or_else(|| {
            let legal =
                "what glEnable accepts in OpenGL 1.x, such as LIGHTING, LIGHTi, TEXTURE_GEN_S";
            let left = if self.hints > 0 { usize::MAX } else { 0 };
            self.hints = self.hints.saturating_sub(1);
            let known = opengl::capabilities().chain(["LIGHT0"]).take(left);
            Broken::token("cap", text, legal, known)
        })?;
        let coord = known.strip_prefix("TEXTURE_GEN_").and_then(Coord::named);
        Ok(match (known, coord) {
            ("LIGHTING", _) => Cap::Lighting,
            (_, Some(coord)) => Cap::TexGen(coord),
            _ if known.ends_with("_ARRAY") => Cap::Array(known.to_owned()),
            (_, None) => {
                let unit = opengl::is_of_unit(known).then_some(self.active);
                Cap::Other(unit, known.to_owned())
            }
        })
    }

    fn enable(&mut self, text: &str, on: bool) -> Result<String, Broken> {
        let cap = self.cap(text)?;
        match cap.clone() {
            Cap::Lighting => self.lighting = on,
            Cap::Light(light) => self.lights[usize::from(light)] = on,
            Cap::TexGen(coord) => self.generation_mut(coord).enabled = on,
            Cap::Array(_) => {}
            Cap::Other(unit, name) if on => {
                self.others.insert((unit, name));
            }
            Cap::Other(unit, name) => {
                self.others.remove(&(unit, name));
            }
        }
        Ok(self.told_enabled(&cap))
    }

    /// States whether a capability is enabled.
    fn told_enabled(&self, cap: &Cap) -> String {
        let (unit, name, on) = match cap {
            Cap::Lighting => (None, "LIGHTING".to_owned(), self.lighting),
            Cap::Light(light) => (None, format!("LIGHT{light}"), self.lights[usize::from(*light)]),
            Cap::TexGen(coord) => (
                Some(self.active),
                format!("TEXTURE_GEN_{coord:?}"),
                self.generation(*coord).enabled,
            ),
            Cap::Array(name) => {
                return format!("{name}: passed on; client arrays aren't modelled");
            }
            Cap::Other(unit, name) => {
                (*unit, name.clone(), self.others.contains(&(*unit, name.clone())))
            }
        };
        let of = unit.map_or(String::new(), |unit| format!("unit {unit}: "));
        format!("{of}{name} {}", if on { "enabled" } else { "disabled" })
    }

    fn generation(&self, coord: Coord) -> &Generation {
        &self.units[usize::from(self.active)][coord.index()]
    }

    fn generation_mut(&mut self, coord: Coord) -> &mut Generation {
        &mut self.units[usize::from(self.active)][coord.index()]
    }

    fn told(&self, coord: Coord, pname: Pname) -> String {
        let generation = self.generation(coord);
        let value = match pname {
            Pname::Mode => generation.mode.to_string(),
            Pname::ObjectPlane => generation.object_plane.to_string(),
            Pname::EyePlane => generation.eye_plane.to_string(),
            Pname::Light => format!("LIGHT{}", generation.light),
            Pname::Constant => Brief(generation.constant).to_string(),
        };
        format!("unit {}: {} of {coord:?} = {value}", self.active, pname.name())
    }

    fn texgen(&mut self, coord: Coord, pname: Pname, param: &Param) -> Result<(), Broken> {
        let (unit, even) = (self.active, self.active.is_multiple_of(2));
        // A pointer to one value is that value.
        let param = match param {
            Param::List(values) if pname.values() == 1 && values.len() == 1 => &values[0],
            Param::Integer(_)
            | Param::Number(_)
            | Param::Token(_)
            | Param::Flag(_)
            | Param::List(_) => param,
        };
        if matches!(pname, Pname::Light | Pname::Constant) {
            let token = pname.name();
            if even {
                return Err(Broken::EvenUnit { token, unit });
            }
            if matches!(coord, Coord::R | Coord::Q) {
                return Err(Broken::RightCoord { token, coord });
            }
        }
        match pname {
            Pname::Mode => {
                let mode = Mode::parse(param)?;
                if mode == Mode::EmbossMapNv && even {
                    return Err(Broken::EvenUnit { token: "EMBOSS_MAP_NV", unit });
                }
                if let Some((takes, coords)) = mode.takes()
                    && !coords.contains(&coord)
                {
                    return Err(Broken::ModeCoord { mode, coord, takes });
                }
                self.generation_mut(coord).mode = mode;
            }
            Pname::ObjectPlane => self.generation_mut(coord).object_plane = plane(pname, param)?,
            Pname::EyePlane => self.generation_mut(coord).eye_plane = plane(pname, param)?,
            Pname::Light => {
                self.generation_mut(coord).light = self.emboss_light(param)?;
            }
            Pname::Constant => {
                let given = || Broken::Constant { given: param.to_string() };
                self.generation_mut(coord).constant = param.number().ok_or_else(given)?;
            }
        }
        Ok(())
    }

    /// Makes a call; returns what it did.
    ///
    /// # Errors
    /// If it is rejected, see [`Broken`]; the state is unchanged.
    #[expect(clippy::missing_panics_doc, reason = "255 units at most")]
    pub fn call(&mut self, call: &Call) -> Result<String, Broken> {
        match call {
            Call::ActiveTexture { texture } => {
                let name = bare(texture);
                let name = name.strip_suffix("_ARB").unwrap_or(name);
                let unit = numbered(name, "TEXTURE").ok_or_else(|| {
                    Broken::token("texture", texture, "TEXTUREi", ["TEXTURE0"].into_iter())
                })?;
                let last = u8::try_from(self.units.len() - 1).expect("bug: 255 units at most");
                if unit > last {
                    return Err(Broken::Unit { given: texture.clone(), last });
                }
                self.active = unit;
                Ok(format!("texture unit {} is active", self.active))
            }
            Call::TexGen { coord, pname, param } | Call::TexGenValue { coord, pname, param } => {
                let (coord, pname) = (Coord::parse(coord)?, Pname::parse(pname)?);
                if matches!(call, Call::TexGenValue { .. }) && pname.values() > 1 {
                    return Err(Broken::PlaneOfOne { token: pname.name() });
                }
                self.texgen(coord, pname, param.get_ref())?;
                Ok(self.told(coord, pname))
            }
            Call::GetTexGen { coord, pname } => {
                Ok(self.told(Coord::parse(coord)?, Pname::parse(pname)?))
            }
            Call::Enable { cap } => self.enable(cap, true),
            Call::Disable { cap } => self.enable(cap, false),
            Call::IsEnabled { cap } => {
                let cap = self.cap(cap)?;
                Ok(self.told_enabled(&cap))
            }
            Call::Other(calls) => {
                let followed = calls.keys().all(|name| !NOT_FOLLOWED.contains(&command(name)));
                let not = "passed on; its effect on the state checked here isn't modelled";
                Ok(if followed { "passed on" } else { not }.to_owned())
            }
        }
    }

    /// Every condition of a unit that fails.
    fn conditions(&self, unit: &[Generation; 4]) -> Vec<Condition> {
        let mut failing = Vec::new();
        let coords = || Coord::ALL.iter().map(|(coord, _)| *coord).zip(unit);
        for (coord, generation) in coords() {
            let mode = generation.mode;
            if mode != Mode::EmbossMapNv {
                failing.push(Condition::Mode { coord, mode });
            }
        }
        for (coord, generation) in coords() {
            if !generation.enabled {
                failing.push(Condition::Disabled { coord });
            }
        }
        let (s, t) = (unit[0].light, unit[1].light);
        if s != t {
            failing.push(Condition::Lights { s, t });
        }
        let named = if s == t { vec![s] } else { vec![s, t] };
        let off = named.into_iter().filter(|light| !self.lights[usize::from(*light)]);
        failing.extend(off.map(|light| Condition::LightOff { light }));
        if !self.lighting {
            failing.push(Condition::LightingOff);
        }
        failing
    }

    /// For each texture unit with a coordinate in mode EMBOSS_MAP_NV: the configuration of the
    /// emboss unit, or why its coordinates are undefined.
    ///
    /// By the specification, all coordinates in that mode are then undefined, enabled or not.
    #[must_use]
    pub fn emboss(&self) -> Vec<Result<Emboss, Undefined>> {
        let mut found = Vec::new();
        for (number, unit) in (0_u8..).zip(&self.units) {
            let coords: Vec<Coord> = Coord::ALL
                .iter()
                .filter(|(coord, _)| unit[coord.index()].mode == Mode::EmbossMapNv)
                .map(|(coord, _)| *coord)
                .collect();
            if coords.is_empty() {
                continue;
            }
            let conditions = self.conditions(unit);
            found.push(if conditions.is_empty() {
                Ok(Emboss {
                    setting: Setting::Nv,
                    light: u32::from(unit[0].light),
                    source: u32::from(number - 1), // even units never have that mode
                    destination: u32::from(number),
                    ks: unit[0].constant,
                    kt: unit[1].constant,
                })
            } else {
                Err(Undefined { unit: number, coords, conditions })
            });
        }
        found
    }
}
