//! Texture coordinates in the style of `GXSetTexCoordGen` (US 6,980,218 and 7,307,640).
//!
//! Eight coordinates are generated for each vertex, in the order of their numbers: by a matrix from
//! an attribute of the vertex (MTX2x4, MTX3x4), by emboss from an already generated coordinate and
//! one of eight lights (BUMP0 to BUMP7), or from a lit colour (SRTG). [`TexCoords`] is the state
//! that calls build up. A call that would break a rule is rejected and leaves the state unchanged.
//!
//! The patents define the call and its four arguments, the names of the functions, and a light for
//! each BUMP. They also say that a bump coordinate is numbered after its base (n, n + 1), that bump
//! coordinates come after the transformed ones and before those of lit colours, and that no matrix
//! is used for a bump coordinate, "therefore use an identity matrix". For two of these orders (n +
//! 1 after n; all transformed ones first) they say "should", and two bases with a bump each can't
//! satisfy both. Departures from them are reported as [`Advice`] and accepted. That coordinates of
//! lit colours come last is a rule, since nothing requires breaking it. Several lights over one
//! base are our extension: their coordinates follow the base as n + 1, n + 2, … without a gap.
//!
//! The register words are not in the patents. Names of sources and matrices, addresses and fields
//! are those that the console's public drivers and emulators agree on. Bit 1 is the projection (0:
//! S, T; 1: S, T, Q). Bits 2-3 are the form of the input (0: A, B, 1, 1; 1: A, B, C, 1). Bits 4-6
//! are the kind (0: matrix, 1: emboss, 2 and 3: from colour 0 and 1). Bits 7-11 are the row of the
//! source (0 position, 1 normal, 2 colours, 3 and 4 the binormals, 5 to 12 textures). Bits 12-14
//! are the coordinate that emboss displaces, bits 15-17 its light. Bit 0 and bits 18 and above are
//! 0.

use super::setting::{Emboss, Setting};
use crate::base::error::nearest;
use serde::Deserialize;
use std::fmt;

/// Generated coordinates, TEXCOORD0 to TEXCOORD7.
pub const COORDINATES: u8 = 8;
/// Lights, of BUMP0 to BUMP7.
pub const LIGHTS: u8 = 8;
/// Number of rows that a matrix index can name: 6 bits.
pub const MATRIX_ROWS: u8 = 64;
/// The identity matrix.
pub const IDENTITY: u8 = 60;
/// Texture matrices have three rows each, starting at this row.
const FIRST_TEXTURE_MATRIX: u8 = 30;
/// Texture matrices, TEXMTX0 to TEXMTX9.
const TEXTURE_MATRICES: u8 = 10;

/// A call; in a file, a TOML table with the call's name under `call`.
#[derive(Clone, Debug, Deserialize)]
pub enum Call {
    /// Sets how a coordinate is generated.
    SetTexCoordGen {
        /// The generated coordinate: TEXCOORD0 to TEXCOORD7.
        dst_coord: String,
        /// MTX2x4, MTX3x4, BUMP0 to BUMP7, SRTG.
        func: String,
        /// POS, NRM, BINRM, TANGENT, TEX0 to TEX7, TEXCOORD0 to TEXCOORD6, COLOR0, COLOR1.
        src_param: String,
        /// TEXMTX0 to TEXMTX9, IDENTITY, or the row where a matrix starts.
        mat_idx: Matrix,
    },
    /// Sets it from the word of its register.
    LoadRegister {
        /// The generated coordinate.
        dst_coord: String,
        /// The 32-bit register word; see the module documentation.
        word: i64,
        /// As above; the word doesn't contain it. Defaults to IDENTITY.
        mat_idx: Option<Matrix>,
    },
}

impl Call {
    /// The variant of a call, with or without the prefix `GX`.
    ///
    /// # Errors
    /// If there is no such call.
    pub(super) fn kind(given: &str) -> Result<Vec<String>, String> {
        let names = ["SetTexCoordGen", "LoadRegister"];
        let name = given.strip_prefix("GX").unwrap_or(given);
        if names.contains(&name) {
            return Ok(vec![name.to_owned()]);
        }
        let hint = nearest(name, names.into_iter());
        Err(format!("no call `{given}`{hint}: legal is SetTexCoordGen or LoadRegister"))
    }
}

/// A matrix by its name or by its first row.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "a matrix is TEXMTX0 to TEXMTX9, IDENTITY or the number of its first row"
)]
pub enum Matrix {
    /// By its name.
    Name(String),
    /// By its first row.
    Row(i64),
}

/// What generates a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// A 2x4 matrix: S and T.
    Mtx2x4,
    /// A 3x4 matrix: S, T and Q.
    Mtx3x4,
    /// Emboss with this light.
    Bump(u8),
    /// A lit colour.
    Srtg,
}

/// What a coordinate is generated from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The vertex.
    Pos,
    /// The normal.
    Nrm,
    /// The first binormal.
    Binrm,
    /// The second binormal.
    Tangent,
    /// A texture coordinate of the vertex.
    Tex(u8),
    /// A generated coordinate.
    TexCoord(u8),
    /// A lit colour.
    Color(u8),
}

/// How one coordinate is generated; legal by itself, independently of the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TexGen {
    function: Function,
    source: Source,
    matrix: u8,
}

/// A rule that a call breaks.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Broken {
    /// A name that the argument doesn't accept.
    #[error("{argument} `{given}`{hint}: legal is {legal}")]
    Name {
        /// The argument.
        argument: &'static str,
        /// The given text.
        given: String,
        /// `, did you mean …`, or nothing.
        hint: String,
        /// Its legal values.
        legal: &'static str,
    },
    /// A number out of range.
    #[error("{argument} {given}: legal is {legal}")]
    Range {
        /// The argument.
        argument: &'static str,
        /// The given number.
        given: String,
        /// Its legal values.
        legal: &'static str,
    },
    /// A matrix needs an attribute of the vertex.
    #[error(
        "{function} from {given}: a matrix transforms an attribute of the vertex, POS, NRM, BINRM, TANGENT or TEX0 to TEX7"
    )]
    TransformSource {
        /// The function.
        function: Function,
        /// The source.
        given: Source,
    },
    /// Emboss needs a generated coordinate.
    #[error(
        "{function} from {given}: emboss displaces an already generated coordinate, TEXCOORD0 to TEXCOORD6"
    )]
    BumpSource {
        /// The function.
        function: Function,
        /// The source.
        given: Source,
    },
    /// SRTG needs a lit colour.
    #[error("SRTG from {given}: coordinates from lighting channels come from COLOR0 or COLOR1")]
    ColorSource {
        /// The source.
        given: Source,
    },
    /// Emboss uses no matrix.
    #[error("{function} with matrix {}: no matrix is used for a displaced coordinate, give IDENTITY", MatrixName(*.matrix))]
    BumpMatrix {
        /// The function.
        function: Function,
        /// Its first row.
        matrix: u8,
    },
    /// A matrix that would read nonexistent rows.
    #[error("{function} with matrix {}: its {rows} rows end at row {}, and the last row is 63: start it at row {} or below", MatrixName(*.matrix), matrix + rows - 1, MATRIX_ROWS - rows)]
    MatrixRows {
        /// The function.
        function: Function,
        /// Its first row, below 64.
        matrix: u8,
        /// Its rows.
        rows: u8,
    },
    /// The source isn't generated before the destination.
    #[error(
        "TEXCOORD{destination} from TEXCOORD{source_index}: coordinates are generated in the order of their numbers, so emboss needs a source with a lower number"
    )]
    SourceNotLower {
        /// The coordinate that a call sets.
        destination: u8,
        /// Its source.
        source_index: u8,
    },
    /// The source isn't set.
    #[error(
        "TEXCOORD{destination} from TEXCOORD{source_index}, which no call has set: set the base coordinate first"
    )]
    SourceNotSet {
        /// The coordinate that a call sets.
        destination: u8,
        /// Its source.
        source_index: u8,
    },
    /// Kinds in the wrong order.
    #[error(
        "TEXCOORD{later} ({later_function}) after TEXCOORD{earlier} ({earlier_function}): coordinates from lighting channels (SRTG) come after all others"
    )]
    Order {
        /// The lower number.
        earlier: u8,
        /// How it is generated.
        earlier_function: Function,
        /// The higher number.
        later: u8,
        /// How it is generated.
        later_function: Function,
    },
    /// A coordinate is missing below another.
    #[error(
        "TEXCOORD{missing} is not set, but TEXCOORD{above} is: number coordinates from 0 without a gap"
    )]
    Gap {
        /// The missing one.
        missing: u8,
        /// The lowest above it.
        above: u8,
    },
    /// A register word with an invalid field.
    #[error("word {word:#010x}: bits {bits} ({field}) are {given}, legal is {legal}")]
    Field {
        /// The word.
        word: u32,
        /// The bits of the field.
        bits: &'static str,
        /// Its name.
        field: &'static str,
        /// Its value.
        given: u32,
        /// Its legal values here.
        legal: &'static str,
    },
}

/// A legal departure from what the patents recommend ("should").
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Advice {
    /// A coordinate is between a base coordinate and its displaced one.
    #[error(
        "TEXCOORD{destination} from TEXCOORD{source_index}: base and displaced coordinate should be numbered n and n + 1, but TEXCOORD{between} between them is {} from {}", .is.function, .is.source
    )]
    NotSequential {
        /// The displaced coordinate.
        destination: u8,
        /// Its base.
        source_index: u8,
        /// What is in between.
        between: u8,
        /// How that is generated.
        is: TexGen,
    },
    /// A transformed coordinate comes after a bump coordinate.
    #[error(
        "TEXCOORD{later} ({later_function}) after TEXCOORD{earlier} ({earlier_function}): transformed coordinates should come before all bump coordinates"
    )]
    Order {
        /// The lower number.
        earlier: u8,
        /// How it is generated.
        earlier_function: Function,
        /// The higher number.
        later: u8,
        /// How it is generated.
        later_function: Function,
    },
}

impl fmt::Display for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mtx2x4 => write!(f, "MTX2x4"),
            Self::Mtx3x4 => write!(f, "MTX3x4"),
            Self::Bump(light) => write!(f, "BUMP{light}"),
            Self::Srtg => write!(f, "SRTG"),
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pos => write!(f, "POS"),
            Self::Nrm => write!(f, "NRM"),
            Self::Binrm => write!(f, "BINRM"),
            Self::Tangent => write!(f, "TANGENT"),
            Self::Tex(i) => write!(f, "TEX{i}"),
            Self::TexCoord(i) => write!(f, "TEXCOORD{i}"),
            Self::Color(i) => write!(f, "COLOR{i}"),
        }
    }
}

/// A matrix's name, or its row if it has none.
struct MatrixName(u8);

impl fmt::Display for MatrixName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.checked_sub(FIRST_TEXTURE_MATRIX) {
            _ if self.0 == IDENTITY => write!(f, "IDENTITY"),
            Some(row) if row % 3 == 0 && row / 3 < TEXTURE_MATRICES => {
                write!(f, "TEXMTX{}", row / 3)
            }
            Some(_) | None => write!(f, "row {}", self.0),
        }
    }
}

/// The number after a word: 3 for `TEXCOORD3` after `TEXCOORD`; `u8::MAX` if larger than that. It
/// has no sign and no leading zeros, like the names of tokens.
pub(super) fn numbered(text: &str, word: &str) -> Option<u8> {
    let digits = text.strip_prefix(word)?;
    let all = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let token = all && (digits == "0" || !digits.starts_with('0'));
    token.then(|| digits.parse().unwrap_or(u8::MAX))
}

impl Function {
    /// Parses a name, with or without `GX_TG_`.
    ///
    /// # Errors
    /// If there is no such function.
    pub fn parse(text: &str) -> Result<Self, Broken> {
        let (argument, legal) = ("func", "MTX2x4, MTX3x4, BUMP0 to BUMP7, SRTG");
        let name = text.strip_prefix("GX_TG_").unwrap_or(text);
        match (name, numbered(name, "BUMP")) {
            ("MTX2x4", _) => Ok(Self::Mtx2x4),
            ("MTX3x4", _) => Ok(Self::Mtx3x4),
            ("SRTG", _) => Ok(Self::Srtg),
            (_, Some(light)) if light < LIGHTS => Ok(Self::Bump(light)),
            (_, Some(_)) => Err(Broken::Range {
                argument,
                given: text.to_owned(),
                legal: "BUMP0 to BUMP7, one for each of eight lights",
            }),
            (_, None) => {
                let hint = nearest(name, ["MTX2x4", "MTX3x4", "BUMP0", "SRTG"].into_iter());
                Err(Broken::Name { argument, given: text.to_owned(), hint, legal })
            }
        }
    }
}

impl Source {
    /// Parses a name, with or without `GX_TG_`.
    ///
    /// # Errors
    /// If there is no such source.
    pub fn parse(text: &str) -> Result<Self, Broken> {
        let argument = "src_param";
        let name = text.strip_prefix("GX_TG_").unwrap_or(text);
        let within = |index: u8, count: u8, source: Self, legal: &'static str| {
            let given = text.to_owned();
            if index < count { Ok(source) } else { Err(Broken::Range { argument, given, legal }) }
        };
        if let Some(i) = numbered(name, "TEXCOORD") {
            // The last coordinate can't be a source, since no coordinate follows it.
            return within(i, COORDINATES - 1, Self::TexCoord(i), "TEXCOORD0 to TEXCOORD6");
        }
        if let Some(i) = numbered(name, "TEX") {
            return within(i, 8, Self::Tex(i), "TEX0 to TEX7");
        }
        if let Some(i) = numbered(name, "COLOR") {
            return within(i, 2, Self::Color(i), "COLOR0 and COLOR1");
        }
        let known = [
            ("POS", Self::Pos),
            ("NRM", Self::Nrm),
            ("BINRM", Self::Binrm),
            ("TANGENT", Self::Tangent),
        ];
        known.iter().find(|(is, _)| *is == name).map(|(_, source)| *source).ok_or_else(|| {
            let names = known.iter().map(|(is, _)| *is).chain(["TEX0", "TEXCOORD0", "COLOR0"]);
            Broken::Name {
                argument,
                given: text.to_owned(),
                hint: nearest(name, names),
                legal: "POS, NRM, BINRM, TANGENT, TEX0 to TEX7, TEXCOORD0 to TEXCOORD6, COLOR0, COLOR1",
            }
        })
    }
}

/// Parses the name of a generated coordinate, with or without `GX_`.
fn destination(text: &str) -> Result<u8, Broken> {
    let (argument, legal) = ("dst_coord", "TEXCOORD0 to TEXCOORD7");
    let name = text.strip_prefix("GX_").unwrap_or(text);
    match numbered(name, "TEXCOORD") {
        Some(i) if i < COORDINATES => Ok(i),
        Some(_) => Err(Broken::Range { argument, given: text.to_owned(), legal }),
        None => {
            let hint = nearest(name, ["TEXCOORD0"].into_iter());
            Err(Broken::Name { argument, given: text.to_owned(), hint, legal })
        }
    }
}

impl Matrix {
    /// The row where it starts.
    ///
    /// # Errors
    /// If there is no such matrix. [`TexGen::new`] checks that all its rows exist.
    fn row(&self) -> Result<u8, Broken> {
        let argument = "mat_idx";
        match self {
            Self::Row(row) => {
                let fits = u8::try_from(*row).ok().filter(|row| *row < MATRIX_ROWS);
                let given = row.to_string();
                fits.ok_or(Broken::Range { argument, given, legal: "a row from 0 to 63" })
            }
            Self::Name(text) => {
                let name = text.strip_prefix("GX_").unwrap_or(text);
                match numbered(name, "TEXMTX") {
                    Some(i) if i < TEXTURE_MATRICES => Ok(FIRST_TEXTURE_MATRIX + 3 * i),
                    Some(_) => {
                        let given = text.clone();
                        Err(Broken::Range { argument, given, legal: "TEXMTX0 to TEXMTX9" })
                    }
                    None if name == "IDENTITY" => Ok(IDENTITY),
                    None => Err(Broken::Name {
                        argument,
                        given: text.clone(),
                        hint: nearest(name, ["TEXMTX0", "IDENTITY"].into_iter()),
                        legal: "TEXMTX0 to TEXMTX9, IDENTITY or a row from 0 to 63",
                    }),
                }
            }
        }
    }
}

impl fmt::Display for Matrix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => write!(f, "{name}"),
            Self::Row(row) => write!(f, "{row}"),
        }
    }
}

/// A register word in hexadecimal; a number that isn't one in decimal.
struct Word(i64);

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match u32::try_from(self.0) {
            Ok(word) => write!(f, "{word:#010x}"),
            Err(_) => write!(f, "{}", self.0),
        }
    }
}

impl fmt::Display for Call {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SetTexCoordGen { dst_coord, func, src_param, mat_idx } => {
                write!(f, "GXSetTexCoordGen({dst_coord}, {func}, {src_param}, {mat_idx})")
            }
            Self::LoadRegister { dst_coord, word, mat_idx: None } => {
                write!(f, "LoadRegister({dst_coord}, {})", Word(*word))
            }
            Self::LoadRegister { dst_coord, word, mat_idx: Some(matrix) } => {
                write!(f, "LoadRegister({dst_coord}, {}, {matrix})", Word(*word))
            }
        }
    }
}

/// A field of the register word: its lowest bit and its width.
#[derive(Clone, Copy)]
struct Field {
    least: u32,
    bits: u32,
}

const PROJECTION: Field = Field { least: 1, bits: 1 };
const INPUT_FORM: Field = Field { least: 2, bits: 2 };
const KIND: Field = Field { least: 4, bits: 3 };
const SOURCE_ROW: Field = Field { least: 7, bits: 5 };
const BUMP_SOURCE: Field = Field { least: 12, bits: 3 };
const BUMP_LIGHT: Field = Field { least: 15, bits: 3 };

const KIND_MATRIX: u32 = 0;
const KIND_EMBOSS: u32 = 1;
const KIND_COLOR: u32 = 2;
const ROW_COLORS: u32 = 2;
const ROW_TEX: u32 = 5;

impl Field {
    fn put(self, value: u32) -> u32 {
        assert!(value < 1 << self.bits, "bug: {value} in {} bits", self.bits);
        value << self.least
    }

    fn get(self, word: u32) -> u32 {
        word >> self.least & ((1 << self.bits) - 1)
    }
}

impl TexGen {
    /// Combines a function with its source and matrix.
    ///
    /// # Errors
    /// If the function doesn't accept that source or matrix, or a number is out of range.
    pub fn new(function: Function, source: Source, matrix: u8) -> Result<Self, Broken> {
        let range = |argument, given: String, legal| Err(Broken::Range { argument, given, legal });
        match source {
            Source::Tex(8..) => return range("src_param", source.to_string(), "TEX0 to TEX7"),
            Source::TexCoord(7..) => {
                return range("src_param", source.to_string(), "TEXCOORD0 to TEXCOORD6");
            }
            Source::Color(2..) => {
                return range("src_param", source.to_string(), "COLOR0 and COLOR1");
            }
            Source::Pos | Source::Nrm | Source::Binrm | Source::Tangent => {}
            Source::Tex(_) | Source::TexCoord(_) | Source::Color(_) => {}
        }
        if matrix >= MATRIX_ROWS {
            return range("mat_idx", matrix.to_string(), "a row from 0 to 63");
        }
        match (function, source) {
            (Function::Bump(LIGHTS..), _) => {
                let legal = "BUMP0 to BUMP7, one for each of eight lights";
                range("func", function.to_string(), legal)
            }
            (Function::Mtx2x4 | Function::Mtx3x4, Source::TexCoord(_) | Source::Color(_)) => {
                Err(Broken::TransformSource { function, given: source })
            }
            (Function::Bump(_), Source::TexCoord(_)) if matrix != IDENTITY => {
                Err(Broken::BumpMatrix { function, matrix })
            }
            (Function::Mtx2x4, _) if matrix + 2 > MATRIX_ROWS => {
                Err(Broken::MatrixRows { function, matrix, rows: 2 })
            }
            (Function::Mtx3x4, _) if matrix + 3 > MATRIX_ROWS => {
                Err(Broken::MatrixRows { function, matrix, rows: 3 })
            }
            (Function::Bump(_), Source::TexCoord(_))
            | (Function::Srtg, Source::Color(_))
            | (Function::Mtx2x4 | Function::Mtx3x4, _) => Ok(Self { function, source, matrix }),
            (Function::Bump(_), _) => Err(Broken::BumpSource { function, given: source }),
            (Function::Srtg, _) => Err(Broken::ColorSource { given: source }),
        }
    }

    /// The function that generates the coordinate.
    #[must_use]
    pub fn function(&self) -> Function {
        self.function
    }

    /// Its source.
    #[must_use]
    pub fn source(&self) -> Source {
        self.source
    }

    /// The first row of its default matrix.
    #[must_use]
    pub fn matrix(&self) -> u8 {
        self.matrix
    }

    /// The register word; the module documentation lists its fields. The matrix has its own
    /// register.
    ///
    /// # Panics
    /// Never: every source and light fits its field.
    #[must_use]
    pub fn pack(&self) -> u32 {
        // The three components of a vector, or S and T followed by 1 and 1.
        let (row, form) = match self.source {
            Source::Pos => (0, 1),
            Source::Nrm => (1, 1),
            Source::Binrm => (3, 1),
            Source::Tangent => (4, 1),
            Source::Tex(i) => (ROW_TEX + u32::from(i), 0),
            // Emboss doesn't read it; drivers use this value.
            Source::TexCoord(_) => (ROW_TEX, 0),
            Source::Color(_) => (ROW_COLORS, 0),
        };
        let input = INPUT_FORM.put(form) | SOURCE_ROW.put(row);
        input
            | match (self.function, self.source) {
                (Function::Mtx2x4, _) => KIND.put(KIND_MATRIX),
                (Function::Mtx3x4, _) => KIND.put(KIND_MATRIX) | PROJECTION.put(1),
                (Function::Bump(light), Source::TexCoord(i)) => {
                    KIND.put(KIND_EMBOSS)
                        | BUMP_SOURCE.put(u32::from(i))
                        | BUMP_LIGHT.put(u32::from(light))
                }
                (Function::Srtg, Source::Color(i)) => KIND.put(KIND_COLOR + u32::from(i)),
                (Function::Bump(_) | Function::Srtg, _) => {
                    panic!("bug: {self:?} was never legal")
                }
            }
    }

    /// Decodes a register word; [`TexGen::pack`] returns the same word.
    ///
    /// # Errors
    /// If a field, or a bit outside all fields, has an invalid value.
    #[expect(clippy::missing_panics_doc, reason = "fields have five bits at most")]
    pub fn unpack(word: u32, matrix: u8) -> Result<Self, Broken> {
        let field = |bits, field, given, legal| Broken::Field { word, bits, field, given, legal };
        let (kind, row, form) = (KIND.get(word), SOURCE_ROW.get(word), INPUT_FORM.get(word));
        let small = |index: u32| u8::try_from(index).expect("bug: five bits at most");
        let source = match row {
            0 => Source::Pos,
            1 => Source::Nrm,
            ROW_COLORS => Source::Color(u8::from(kind == KIND_COLOR + 1)),
            3 => Source::Binrm,
            4 => Source::Tangent,
            ROW_TEX..=12 => Source::Tex(small(row - ROW_TEX)),
            _ => return Err(field("7-11", "row of the source", row, "0 to 12")),
        };
        let (function, source) = match kind {
            KIND_MATRIX if PROJECTION.get(word) == 0 => (Function::Mtx2x4, source),
            KIND_MATRIX => (Function::Mtx3x4, source),
            KIND_EMBOSS if row != ROW_TEX => {
                return Err(field("7-11", "row of the source", row, "5 with emboss"));
            }
            KIND_EMBOSS => {
                let i = BUMP_SOURCE.get(word);
                if i >= u32::from(COORDINATES) - 1 {
                    return Err(field("12-14", "displaced coordinate", i, "0 to 6"));
                }
                (Function::Bump(small(BUMP_LIGHT.get(word))), Source::TexCoord(small(i)))
            }
            2 | 3 => (Function::Srtg, source),
            _ => return Err(field("4-6", "kind", kind, "0 to 3")),
        };
        let read = Self::new(function, source, matrix)?;
        let differ = word ^ read.pack();
        let legal = "0 here";
        match differ {
            0 => Ok(read),
            _ if INPUT_FORM.get(differ) != 0 => {
                let legal = "1 for vectors, 0 for all else";
                Err(field("2-3", "form of the input", form, legal))
            }
            _ if PROJECTION.get(differ) != 0 => Err(field("1", "projection", 1, legal)),
            _ if BUMP_SOURCE.get(differ) != 0 => {
                Err(field("12-14", "displaced coordinate", BUMP_SOURCE.get(word), legal))
            }
            _ if BUMP_LIGHT.get(differ) != 0 => {
                Err(field("15-17", "light of emboss", BUMP_LIGHT.get(word), legal))
            }
            _ if differ & 1 != 0 => Err(field("0", "unused", 1, legal)),
            _ => Err(field("18-31", "unused", word >> 18, legal)),
        }
    }
}

/// A register and its word.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Register {
    /// Its content.
    pub name: String,
    /// Its address among those of the transform unit.
    pub address: u16,
    /// Its word.
    pub word: u32,
}

/// The state: how each coordinate is generated, if a call has set it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TexCoords {
    coordinates: [Option<TexGen>; COORDINATES as usize],
}

impl TexCoords {
    /// How a coordinate is generated.
    #[must_use]
    pub fn get(&self, destination: u8) -> Option<TexGen> {
        self.coordinates.get(usize::from(destination)).copied().flatten()
    }

    /// The coordinates that are set, from the lowest number.
    pub fn iter(&self) -> impl Iterator<Item = (u8, TexGen)> + '_ {
        (0..COORDINATES).filter_map(|i| Some((i, self.get(i)?)))
    }

    /// Sets how a coordinate is generated.
    ///
    /// # Errors
    /// If that breaks a rule; the state is unchanged.
    pub fn set(&mut self, destination: u8, generated: TexGen) -> Result<(), Broken> {
        let mut next = self.clone();
        let slot = next.coordinates.get_mut(usize::from(destination)).ok_or(Broken::Range {
            argument: "dst_coord",
            given: format!("TEXCOORD{destination}"),
            legal: "TEXCOORD0 to TEXCOORD7",
        })?;
        *slot = Some(generated);
        next.check()?;
        *self = next;
        Ok(())
    }

    /// Checks every rule between coordinates, except gaps, which later calls may fill.
    fn check(&self) -> Result<(), Broken> {
        for (destination, generated) in self.iter() {
            let Source::TexCoord(source_index) = generated.source else { continue };
            if source_index >= destination {
                return Err(Broken::SourceNotLower { destination, source_index });
            }
            if self.get(source_index).is_none() {
                return Err(Broken::SourceNotSet { destination, source_index });
            }
        }
        let set: Vec<(u8, TexGen)> = self.iter().collect();
        for pair in set.windows(2) {
            let ((earlier, before), (later, after)) = (pair[0], pair[1]);
            let (earlier_function, later_function) = (before.function, after.function);
            if earlier_function == Function::Srtg && later_function != Function::Srtg {
                return Err(Broken::Order { earlier, earlier_function, later, later_function });
            }
        }
        Ok(())
    }

    /// Departures from what the patents recommend.
    #[must_use]
    pub fn advice(&self) -> Vec<Advice> {
        let mut all = Vec::new();
        let set: Vec<(u8, TexGen)> = self.iter().collect();
        for pair in set.windows(2) {
            let ((earlier, before), (later, after)) = (pair[0], pair[1]);
            let (earlier_function, later_function) = (before.function, after.function);
            let transforms = matches!(later_function, Function::Mtx2x4 | Function::Mtx3x4);
            if transforms && matches!(earlier_function, Function::Bump(_)) {
                all.push(Advice::Order { earlier, earlier_function, later, later_function });
            }
        }
        for (destination, generated) in set {
            let Source::TexCoord(source_index) = generated.source else { continue };
            let between = (source_index + 1..destination).find_map(|between| {
                let is = self.get(between)?;
                // One more light over the same base, or over another light's result.
                let displaced = matches!(is.source, Source::TexCoord(i) if i >= source_index);
                (!displaced).then_some((between, is))
            });
            all.extend(between.map(|(between, is)| Advice::NotSequential {
                destination,
                source_index,
                between,
                is,
            }));
        }
        all
    }

    /// Checks what must hold once all calls are made.
    ///
    /// # Errors
    /// If a coordinate isn't set but a higher one is.
    #[expect(clippy::missing_panics_doc, reason = "there are eight coordinates")]
    pub fn finish(&self) -> Result<(), Broken> {
        for (missing, (above, _)) in self.iter().enumerate() {
            if missing < usize::from(above) {
                let missing = u8::try_from(missing).expect("bug: below eight");
                return Err(Broken::Gap { missing, above });
            }
        }
        Ok(())
    }

    /// Makes a call; returns what it did.
    ///
    /// # Errors
    /// If it breaks a rule; the state is unchanged.
    pub fn call(&mut self, call: &Call) -> Result<String, Broken> {
        let (to, generated) = match call {
            Call::SetTexCoordGen { dst_coord, func, src_param, mat_idx } => {
                let to = destination(dst_coord)?;
                let (function, source) = (Function::parse(func)?, Source::parse(src_param)?);
                (to, TexGen::new(function, source, mat_idx.row()?)?)
            }
            Call::LoadRegister { dst_coord, word, mat_idx } => {
                let word = u32::try_from(*word).map_err(|_| Broken::Range {
                    argument: "word",
                    given: word.to_string(),
                    legal: "a word of 32 bits, 0 to 0xffffffff",
                })?;
                let row = mat_idx.as_ref().map_or(Ok(IDENTITY), Matrix::row)?;
                (destination(dst_coord)?, TexGen::unpack(word, row)?)
            }
        };
        self.set(to, generated)?;
        let (source, matrix) = (generated.source, MatrixName(generated.matrix));
        Ok(match generated.function {
            Function::Mtx2x4 => format!("TEXCOORD{to} = {source} by the 2x4 matrix {matrix}"),
            Function::Mtx3x4 => format!("TEXCOORD{to} = {source} by the 3x4 matrix {matrix}"),
            Function::Bump(light) => format!("TEXCOORD{to} = {source} displaced by light {light}"),
            Function::Srtg => format!("TEXCOORD{to} = {source}"),
        })
    }

    /// The registers that hold the state: the number of coordinates, the word of each, and the
    /// indices of their matrices. Empty while there is a gap, since the number of coordinates
    /// couldn't express it.
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "there are eight coordinates")]
    pub fn registers(&self) -> Vec<Register> {
        let count = self.iter().count();
        if count == 0 || self.finish().is_err() {
            return Vec::new();
        }
        let mut matrices = [0_u32; 2];
        for (to, generated) in self.iter() {
            // The first field of the first register belongs to positions.
            let field = if to < 4 { to + 1 } else { to - 4 };
            matrices[usize::from(to / 4)] |= u32::from(generated.matrix) << (6 * field);
        }
        let register =
            |name: &str, address, word| Register { name: name.to_owned(), address, word };
        let mut registers = vec![
            register("matrices of TEXCOORD0 to 3", 0x1018, matrices[0]),
            register("matrices of TEXCOORD4 to 7", 0x1019, matrices[1]),
            register("coordinates", 0x103f, u32::try_from(count).expect("bug: eight at most")),
        ];
        registers.extend(self.iter().map(|(to, generated)| {
            register(&format!("TEXCOORD{to}"), 0x1040 + u16::from(to), generated.pack())
        }));
        registers
    }

    /// A configuration of the emboss unit for each displaced coordinate. The matrix includes the
    /// scale of the displacement, so both constants are 1.
    #[must_use]
    pub fn emboss(&self) -> Vec<Emboss> {
        let of = |(to, generated): (u8, TexGen)| match (generated.function, generated.source) {
            (Function::Bump(light), Source::TexCoord(from)) => Some(Emboss {
                setting: Setting::Gx,
                light: u32::from(light),
                source: u32::from(from),
                destination: u32::from(to),
                ks: 1.0,
                kt: 1.0,
            }),
            _ => None,
        };
        self.iter().filter_map(of).collect()
    }
}
