//! Table schemes: the words of a table from a real function, and the nodes around it.
//!
//! A [`Spec`] says what to tabulate; [`emit`] adds tables and logic to a netlist and
//! returns one node per function. The address is the top bits of the argument's word,
//! so an entry serves a *cell* of consecutive words. Every entry is a stated
//! combination of function values, correctly rounded ([`Combination`]):
//!
//! - *direct*: the mean of the function at the first and last word of the cell, which
//!   halves the worst error of the left edge;
//! - *linear*: the chord's slope, and the base that puts the deviation's two extremes
//!   at equal distance (over up to 33 evenly spaced words of the cell);
//! - *bipartite*: a table of initial values at 2^n cells and a table of offsets, addressed
//!   by the top bits and by the bits below the cell; one addition, no multiplier.
//!
//! Values outside the output format, poles among them, saturate to its ends. Where they do, the
//! linear and the bipartite scheme have no slope: those cells are as in the direct scheme. (Not
//! where it is by one place only, as 1.0 in a format of fractions.)

pub(crate) mod figures;

use crate::base::cast;
use crate::netlist::op::Meaning;
use crate::netlist::{Builder, Column, NodeId, Part, Table};
use crate::number::format::{Format, Overflow, Round, word_mask};
use crate::number::function::{Combination, Function};
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

/// How a function is approximated from tables.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Scheme {
    /// One word per cell.
    Direct,
    /// Base plus slope times position in the cell: one multiplier.
    Linear,
    /// Initial value plus offset: two tables, one adder.
    Bipartite,
}

impl Scheme {
    /// Every scheme.
    pub const ALL: &'static [Self] = &[Self::Direct, Self::Linear, Self::Bipartite];

    /// Name on the command line and in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::Linear => "linear",
            Self::Bipartite => "bipartite",
        }
    }
}

impl fmt::Display for Scheme {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Extra fraction bits of the words that linear and bipartite schemes add up.
const SUM_GUARD_BITS: i32 = 2;
/// Words of a cell at which the linear scheme looks for the largest deviation.
const CELL_SAMPLES: i64 = 33;

/// A function (or several at one address) to be tabulated.
#[derive(Clone, Copy, Debug)]
pub struct Spec<'a> {
    /// Name of the table, and of the scope of its logic.
    pub name: &'a str,
    /// The functions; they share rows.
    pub functions: &'a [Function],
    /// Scheme.
    pub scheme: Scheme,
    /// Address bits of a table over the whole domain; at most the argument's bits are used.
    pub addr_bits: u32,
    /// Store a quarter turn only; for functions of angles that span a whole turn.
    pub quarter_wave: bool,
    /// Real number that word 0 of the argument stands for, where it isn't 0.
    pub origin: f64,
    /// Format of the result.
    pub output: Format,
    /// Rounding of the sums in linear and bipartite schemes.
    pub round: Round,
}

/// A table scheme as a design uses it: what is needed to judge it alone.
#[derive(Clone, Debug)]
pub struct Tabulated {
    /// Name of the table and of its scope.
    pub name: String,
    /// Its functions.
    pub functions: Vec<Function>,
    /// Scheme.
    pub scheme: Scheme,
    /// Address bits asked for.
    pub addr_bits: u32,
    /// Quarter-wave folding asked for.
    pub quarter_wave: bool,
    /// Value of the argument's word 0.
    pub origin: f64,
    /// Format of the result.
    pub output: Format,
    /// Rounding of its sums.
    pub round: Round,
    /// Format of the argument.
    pub argument: Format,
}

impl Tabulated {
    /// The specification for [`emit`].
    #[must_use]
    pub fn spec(&self) -> Spec<'_> {
        Spec {
            name: &self.name,
            functions: &self.functions,
            scheme: self.scheme,
            addr_bits: self.addr_bits,
            quarter_wave: self.quarter_wave,
            origin: self.origin,
            output: self.output,
            round: self.round,
        }
    }
}

/// Adds the tables and logic that approximate `spec.functions` at `argument`.
///
/// Returns one node of format `spec.output` per function, each of which stands on reals
/// for its function of `argument` (or for nothing, if the spec has an origin).
pub fn emit(b: &mut Builder, spec: &Spec<'_>, argument: NodeId) -> Vec<NodeId> {
    let folds = spec.quarter_wave
        && spec.addr_bits > 2
        && b.format(argument).bits() > 3
        && spec.output.is_signed()
        && spec.functions.iter().all(|function| quarter_wave_of(*function).is_some());
    b.part(Part::Scheme, spec.name, |b| {
        spec.functions
            .iter()
            .enumerate()
            .map(|(i, function)| {
                let node = if folds {
                    emit_folded(b, spec, *function, argument)
                } else {
                    emit_cells(b, spec, i, argument)
                };
                if spec.origin == 0.0 {
                    b.means(node, Meaning::Apply(*function, argument));
                }
                node
            })
            .collect()
    })
}

/// The function on the first quarter turn that gives this one by symmetry, and whether it is
/// this one a quarter turn on.
fn quarter_wave_of(function: Function) -> Option<(Function, bool)> {
    match function {
        Function::Sin => Some((Function::Sin, false)),
        Function::Cos => Some((Function::Sin, true)),
        Function::HalfRecipSin => Some((Function::HalfRecipSin, false)),
        Function::HalfRecipCos => Some((Function::HalfRecipSin, true)),
        Function::Asin
        | Function::Atan
        | Function::Prop
        | Function::Recip
        | Function::Secant
        | Function::Sqrt
        | Function::RecipSqrt
        | Function::Light { .. } => None,
    }
}

/// Quarter-wave folding: f(½-x) = f(x), f(x+½) = -f(x), and cos(x) = sin(x+¼).
fn emit_folded(b: &mut Builder, spec: &Spec<'_>, function: Function, argument: NodeId) -> NodeId {
    let (base, advanced) = quarter_wave_of(function).expect("bug: checked by the caller");
    let bits = b.format(argument).bits();
    let low = bits - 2;
    let within = b.slice(argument, 0, low);
    let odd = b.slice(argument, low, 1);
    let half = b.slice(argument, low + 1, 1);
    let one = b.constant(1, Format::FLAG);
    let (mirror, sign) = if advanced { (b.xor(odd, one), b.xor(odd, half)) } else { (odd, half) };
    // 0 <= folded <= 2^low: the upper end, a full quarter turn, is a constant of its own.
    let integer = Format::integer(low + 1);
    let integer = b.checked(integer);
    let quarter = b.constant(1 << low, integer);
    let mirrored = b.sub(quarter, within);
    let folded = b.mux(mirror, mirrored, within);
    let at_end = b.slice(folded, low, 1);
    let index = b.slice(folded, 0, low);
    let index = b.shift(index, -cast::signed_count(bits));
    let magnitude = Format::unsigned(spec.output.bits() - 1, spec.output.frac_bits());
    let magnitude = b.checked(magnitude);
    let name = format!("{}_quarter", base.name());
    let quarter_spec = Spec {
        name: &name,
        functions: &[base],
        addr_bits: (spec.addr_bits - 2).min(low),
        quarter_wave: false,
        output: magnitude,
        ..*spec
    };
    let inside = emit_cells(b, &quarter_spec, 0, index);
    let end = entry(
        &Combination {
            function: base,
            terms: &[(1.0, 0.25)],
            constant: 0.0,
            range: range(magnitude),
        },
        magnitude,
    );
    let end = b.constant(end, magnitude);
    let value = b.mux(at_end, end, inside);
    let negated = b.neg(value);
    b.mux(sign, negated, value)
}

/// The scheme over the argument's own cells, for function `which` of the spec.
fn emit_cells(b: &mut Builder, spec: &Spec<'_>, which: usize, argument: NodeId) -> NodeId {
    if b.has_failed() {
        // Nothing will come of this netlist: large tables would only take time.
        return b.constant(0, spec.output);
    }
    let cells = Cells::new(spec, b.format(argument));
    let tables = cells.tables(spec);
    let address = b.slice(argument, cells.cell_bits, cells.addr_bits);
    match cells.split {
        Split::Direct => {
            let table = b.table(tables[0].clone());
            b.read(table, which, address)
        }
        Split::Linear => {
            let table = b.table(tables[0].clone());
            let base = b.read(table, 2 * which, address);
            let slope = b.read(table, 2 * which + 1, address);
            let position = b.slice(argument, 0, cells.cell_bits);
            let rise = b.mul(slope, position);
            let sum = b.add(base, rise);
            b.narrow(sum, spec.output, spec.round, Overflow::Saturate)
        }
        Split::Bipartite { offset_bits } => {
            let values = b.table(tables[0].clone());
            let offsets = b.table(tables[1].clone());
            let coarse_bits = cells.addr_bits - offset_bits;
            let coarse = b.slice(argument, cells.bits() - coarse_bits, coarse_bits);
            let fine = b.slice(argument, cells.cell_bits - offset_bits, offset_bits);
            let offset_address = b.concat(coarse, fine);
            let value = b.read(values, which, address);
            let offset = b.read(offsets, which, offset_address);
            let sum = b.add(value, offset);
            b.narrow(sum, spec.output, spec.round, Overflow::Saturate)
        }
    }
}

/// How the argument's word is divided.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Split {
    Direct,
    Linear,
    Bipartite { offset_bits: u32 },
}

/// The division of an argument's words into cells.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct Cells {
    argument: Format,
    addr_bits: u32,
    /// Bits of the position inside a cell.
    cell_bits: u32,
    split: Split,
    /// Bit pattern of the real number of word 0.
    origin_bits: u64,
}

type Key = (Vec<Function>, Cells, Format, String);

/// Tables built so far: a sweep asks for the same ones again and again.
static BUILT: LazyLock<Mutex<HashMap<Key, Vec<Table>>>> = LazyLock::new(Mutex::default);
/// Words that may be kept; past that the collection starts anew.
const BUILT_WORDS: usize = 1 << 24;

impl Cells {
    fn new(spec: &Spec<'_>, argument: Format) -> Self {
        let addr_bits = spec.addr_bits.min(argument.bits());
        let cell_bits = argument.bits() - addr_bits;
        // Both tables of the bipartite scheme have 2^addr_bits entries at most.
        let offset_bits = cell_bits.min(addr_bits / 2);
        let split = match spec.scheme {
            Scheme::Linear if cell_bits > 0 => Split::Linear,
            Scheme::Bipartite if offset_bits > 0 => Split::Bipartite { offset_bits },
            Scheme::Direct | Scheme::Linear | Scheme::Bipartite => Split::Direct,
        };
        Self { argument, addr_bits, cell_bits, split, origin_bits: spec.origin.to_bits() }
    }

    fn bits(self) -> u32 {
        self.argument.bits()
    }

    /// Value of the word whose pattern is `pattern`.
    fn at(self, pattern: i64) -> f64 {
        f64::from_bits(self.origin_bits) + self.argument.value(self.argument.wrap(pattern))
    }

    /// Value `words` after the start of cell `i` of 2^bits words, without wrapping at the end.
    fn after(self, i: i64, bits: u32, words: i64) -> f64 {
        self.at(i << bits) + cast::f64_of(words) * self.argument.ulp()
    }

    fn tables(self, spec: &Spec<'_>) -> Vec<Table> {
        let key = (spec.functions.to_vec(), self, spec.output, spec.name.to_owned());
        // Another thread's panic leaves the map whole: entries are inserted complete.
        let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(tables) = built.get(&key) {
            return tables.clone();
        }
        let held: usize = built.values().flatten().map(|t| t.columns.len() << t.addr_bits).sum();
        if held > BUILT_WORDS {
            built.clear();
        }
        let tables = self.build(spec);
        built.insert(key, tables.clone());
        tables
    }

    fn build(self, spec: &Spec<'_>) -> Vec<Table> {
        let cells = 0..1i64 << self.addr_bits;
        let named = |function: Function, part: &str| format!("{}{part}", function.name());
        let sum_frac = spec.output.frac_bits() + SUM_GUARD_BITS;
        match self.split {
            Split::Direct => {
                let column = |function: &Function| Column {
                    name: named(*function, ""),
                    format: spec.output,
                    words: cells.clone().map(|i| self.direct(spec, *function, i)).collect(),
                };
                vec![Table {
                    name: spec.name.to_owned(),
                    addr_bits: self.addr_bits,
                    columns: spec.functions.iter().map(column).collect(),
                }]
            }
            Split::Linear => {
                let mut columns = Vec::new();
                for function in spec.functions {
                    let slope_frac = sum_frac + cast::signed_count(self.cell_bits);
                    let slopes: Vec<i64> =
                        cells.clone().map(|i| self.slope(spec, *function, i, slope_frac)).collect();
                    let bases: Vec<i64> = cells
                        .clone()
                        .zip(&slopes)
                        .map(|(i, slope)| {
                            let slope = cast::f64_of(*slope) * 2f64.powi(-slope_frac);
                            self.base(spec, *function, i, slope).round(sum_frac)
                        })
                        .collect();
                    columns.push(column(named(*function, "_base"), bases, sum_frac));
                    columns.push(column(named(*function, "_slope"), slopes, slope_frac));
                }
                vec![Table { name: spec.name.to_owned(), addr_bits: self.addr_bits, columns }]
            }
            Split::Bipartite { offset_bits } => {
                let (mut values, mut offsets) = (Vec::new(), Vec::new());
                for function in spec.functions {
                    let offset: Vec<i64> = cells
                        .clone()
                        .map(|i| self.offset(spec, *function, i, offset_bits).round(sum_frac))
                        .collect();
                    let value: Vec<i64> = cells
                        .clone()
                        .map(|i| {
                            let coarse = i >> offset_bits << offset_bits;
                            let last = coarse | word_mask(offset_bits);
                            let ends =
                                offset[cast::index_of(coarse)] + offset[cast::index_of(last)];
                            self.initial(spec, *function, i, ends, sum_frac)
                        })
                        .collect();
                    values.push(column(function.name().to_owned(), value, sum_frac));
                    offsets.push(column(named(*function, "_offset"), offset, sum_frac));
                }
                let table = |part: &str, columns| Table {
                    name: format!("{}_{part}", spec.name),
                    addr_bits: self.addr_bits,
                    columns,
                };
                vec![table("initial", values), table("offset", offsets)]
            }
        }
    }

    /// First and last value of cell `i`.
    fn ends(self, i: i64) -> (f64, f64) {
        (self.after(i, self.cell_bits, 0), self.after(i, self.cell_bits, word_mask(self.cell_bits)))
    }

    fn direct(self, spec: &Spec<'_>, function: Function, i: i64) -> i64 {
        let (first, last) = self.ends(i);
        let terms = [(0.5, first), (0.5, last)];
        entry(
            &Combination { function, terms: &terms, constant: 0.0, range: range(spec.output) },
            spec.output,
        )
    }

    /// True if the function saturates within the `2^bits` words from cell `i`, or has a pole
    /// there. A line through such words could have the wrong sign where the function is small. A
    /// place past the end is no more than rounding: 1.0 where that has no code.
    fn saturates(self, spec: &Spec<'_>, function: Function, i: i64, bits: u32) -> bool {
        let ((lo, hi), ulp) = (range(spec.output), spec.output.ulp());
        [0, word_mask(bits), 1 << bits].into_iter().any(|words| {
            let value = function.eval(self.after(i, bits, words));
            value < lo - ulp || value > hi + ulp
        })
    }

    /// Terms of the rise of the function over the `2^bits` words from cell `i`; none where it
    /// saturates.
    fn rise(self, spec: &Spec<'_>, function: Function, i: i64, bits: u32) -> [(f64, f64); 2] {
        let weight = if self.saturates(spec, function, i, bits) { 0.0 } else { 1.0 };
        [(-weight, self.after(i, bits, 0)), (weight, self.after(i, bits, 1 << bits))]
    }

    /// The chord's slope per word, in units of 2^-slope_frac.
    fn slope(self, spec: &Spec<'_>, function: Function, i: i64, slope_frac: i32) -> i64 {
        let terms = self.rise(spec, function, i, self.cell_bits);
        Combination { function, terms: &terms, constant: 0.0, range: range(spec.output) }
            .round(slope_frac - cast::signed_count(self.cell_bits))
    }

    /// The base that centres the deviation from a line of this slope per word.
    fn base(self, spec: &Spec<'_>, function: Function, i: i64, slope: f64) -> BaseEntry {
        let range = range(spec.output);
        let words = word_mask(self.cell_bits);
        let samples = CELL_SAMPLES.min(words + 1);
        let (mut least, mut most) = ((f64::INFINITY, 0), (f64::NEG_INFINITY, 0));
        for sample in 0..samples {
            let word = sample * words / (samples - 1);
            let x = self.after(i, self.cell_bits, word);
            let deviation = function.eval(x).clamp(range.0, range.1) - slope * cast::f64_of(word);
            if deviation < least.0 {
                least = (deviation, word);
            }
            if deviation > most.0 {
                most = (deviation, word);
            }
        }
        let at = |word| self.after(i, self.cell_bits, word);
        BaseEntry {
            function,
            terms: [(0.5, at(least.1)), (0.5, at(most.1))],
            constant: -slope * 0.5 * cast::f64_of(least.1 + most.1),
            range,
        }
    }

    /// Entry `i` of the offset table: the coarse cell's slope times the distance of the fine
    /// cell's centre from the middle.
    fn offset(self, spec: &Spec<'_>, function: Function, i: i64, offset_bits: u32) -> BaseEntry {
        let coarse_words_bits = self.cell_bits + offset_bits;
        let terms = self.rise(spec, function, i >> offset_bits, coarse_words_bits);
        let fine = i & word_mask(offset_bits);
        let fine_words = 1i64 << (self.cell_bits - offset_bits);
        // Twice the distance in words, so that it is whole.
        let twice = 2 * fine * fine_words + (fine_words - 1) - word_mask(self.cell_bits);
        let weight = cast::f64_of(twice) * 2f64.powi(-cast::signed_count(coarse_words_bits) - 1);
        BaseEntry {
            function,
            terms: terms.map(|(c, x)| (c * weight, x)),
            constant: 0.0,
            range: range(spec.output),
        }
    }

    /// Entry `i` of the table of initial values: the mean of what is left at the cell's ends.
    fn initial(self, spec: &Spec<'_>, function: Function, i: i64, offsets: i64, frac: i32) -> i64 {
        let (first, last) = self.ends(i);
        let terms = [(0.5, first), (0.5, last)];
        let constant = -0.5 * cast::f64_of(offsets) * 2f64.powi(-frac);
        Combination { function, terms: &terms, constant, range: range(spec.output) }.round(frac)
    }
}

/// A combination of two values that owns its terms; past 53 bits its constant is the nearest `f64`.
struct BaseEntry {
    function: Function,
    terms: [(f64, f64); 2],
    constant: f64,
    range: (f64, f64),
}

impl BaseEntry {
    fn round(&self, frac_bits: i32) -> i64 {
        let Self { function, ref terms, constant, range } = *self;
        Combination { function, terms, constant, range }.round(frac_bits)
    }
}

/// A column in the smallest format that holds its words.
fn column(name: String, words: Vec<i64>, frac_bits: i32) -> Column {
    let lo = words.iter().copied().min().expect("bug: tables have entries");
    let hi = words.iter().copied().max().expect("bug: tables have entries");
    let format = Format::spanning(i128::from(lo), i128::from(hi), frac_bits);
    Column { name, format: format.expect("bug: entries are words"), words: Arc::from(words) }
}

/// The values between which a format's words lie.
fn range(format: Format) -> (f64, f64) {
    (format.value(format.min_raw()), format.value(format.max_raw()))
}

/// The nearest word of a format to a combination.
fn entry(combination: &Combination<'_>, format: Format) -> i64 {
    combination.round(format.frac_bits()).clamp(format.min_raw(), format.max_raw())
}
