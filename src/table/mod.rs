//! Table schemes: the words of a table for a real function, and the nodes around it.
//!
//! A [`Spec`] describes the table; [`emit`] adds tables and logic to a netlist and returns one node
//! per function. The address is the top bits of the argument's word, so an entry serves a *cell* of
//! consecutive words. Every entry is a stated combination of function values, correctly rounded
//! ([`Combination`]). Each scheme has its own file.
//!
//! Values outside the output format, including poles, saturate to its ends. Cells with such values
//! have no slope in the linear and the bipartite scheme, and are as in the direct scheme. (Values
//! outside by only one ulp don't count, such as 1.0 in a format of fractions.)

mod bipartite;
mod cells;
mod direct;
pub(crate) mod figures;
mod linear;
mod scheme;

pub use scheme::Scheme;

use crate::base::cast;
use crate::base::error::Error;
use crate::netlist::{Builder, NodeId, Part, Table, TableId};
use crate::number::format::{Format, Round};
use crate::number::function::{Combination, Function};
use cells::{Cells, entry, range};

/// Largest width of a result: sums have a few more bits.
const MAX_BITS: u32 = 56;
/// Largest sum of a result's fraction bits and the argument's bits: slopes have both and a few
/// more.
const MAX_FRAC_BITS: i32 = 120;

/// A function to tabulate, or several at one address.
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
    /// Value of the argument's word 0.
    pub origin: f64,
    /// Format of the result.
    pub output: Format,
    /// Rounding of the sums in linear and bipartite schemes.
    pub round: Round,
}

/// A table scheme as a design uses it: everything needed to judge it on its own.
#[derive(Clone, Debug)]
pub struct Tabulated {
    /// Name of the table and of its scope.
    pub name: String,
    /// Its functions.
    pub functions: Vec<Function>,
    /// Scheme.
    pub scheme: Scheme,
    /// Address bits requested.
    pub addr_bits: u32,
    /// Whether quarter-wave folding was requested.
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

/// The scheme of a table: the recipe's, unless the table's name is
/// [overridden](crate::netlist::Overrides).
pub fn chosen(b: &mut Builder, table: &str, scheme: Scheme) -> Scheme {
    let name = b.table_scheme(table, scheme.name());
    let known = Scheme::ALL.iter().copied().find(|known| known.name() == name);
    known.unwrap_or_else(|| {
        let names: Vec<&str> = Scheme::ALL.iter().map(|scheme| scheme.name()).collect();
        let names = names.join(", ");
        b.fail(Error::usage(format!(
            "table `{table}`: `{name}` is not a scheme: legal are {names}"
        )));
        scheme
    })
}

/// Adds the tables and logic that approximate `spec.functions` at `argument`.
///
/// Returns one node of format `spec.output` per function. On reals, each node stands for its
/// function of `argument` (or has no value, if the spec has an origin).
pub fn emit(b: &mut Builder, spec: &Spec<'_>, argument: NodeId) -> Vec<NodeId> {
    let folds = spec.quarter_wave
        && spec.addr_bits > 2
        && b.format(argument).bits() > 3
        && spec.output.is_signed()
        && spec.functions.iter().all(|function| function.quarter_wave().is_some());
    b.part(Part::Scheme, spec.name, |b| {
        spec.functions
            .iter()
            .enumerate()
            .map(|(i, function)| {
                let node = if folds {
                    emit_folded(b, spec, function, argument)
                } else {
                    emit_cells(b, spec, i, argument)
                };
                if spec.origin == 0.0 {
                    b.means(node, [argument], |[x]| function.of(&x));
                }
                node
            })
            .collect()
    })
}

/// Quarter-wave folding: f(½-x) = f(x), f(x+½) = -f(x), and cos(x) = sin(x+¼).
fn emit_folded(b: &mut Builder, spec: &Spec<'_>, function: &Function, argument: NodeId) -> NodeId {
    let (base, advanced) = function.quarter_wave().expect("bug: checked by the caller");
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
        functions: std::slice::from_ref(base),
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
        // The netlist has already failed: building large tables would only take time.
        return b.constant(0, spec.output);
    }
    let argument_format = b.format(argument);
    let addr_bits = spec.addr_bits.min(argument_format.bits());
    let cells = Cells {
        name: spec.name,
        functions: spec.functions,
        origin: spec.origin,
        output: spec.output,
        round: spec.round,
        argument: argument_format,
        addr_bits,
        cell_bits: argument_format.bits() - addr_bits,
    };
    let bits = spec.output.bits();
    let frac_bits = spec.output.frac_bits() + cast::signed_count(b.format(argument).bits());
    let problem = if bits > MAX_BITS {
        Some(format!("words of tables have at most {MAX_BITS} bits"))
    } else if frac_bits.abs() > MAX_FRAC_BITS {
        let most = MAX_FRAC_BITS;
        Some(format!("fraction bits of words and bits of the argument are at most {most} together"))
    } else if spec.addr_bits.min(b.format(argument).bits()) > Table::MAX_ADDR_BITS {
        let most = Table::MAX_ADDR_BITS;
        Some(format!("{} address bits, but tables have at most {most}", spec.addr_bits))
    } else {
        spec.functions.iter().find_map(Function::problem)
    };
    if let Some(problem) = problem {
        b.fail(Error::usage(format!("table `{}` of {}: {problem}", spec.name, spec.output)));
        return b.constant(0, spec.output);
    }
    // If there is nothing between the entries, a scheme is the direct one.
    let applies = (spec.scheme.definition().applies)(&cells);
    let scheme = if applies { spec.scheme } else { Scheme::Direct };
    let tables: Vec<TableId> =
        cells.tables(scheme.definition()).into_iter().map(|table| b.table(table)).collect();
    (scheme.definition().emit)(b, &cells, &tables, which, argument)
}
