//! The linear scheme: the chord's slope, and the base that makes the two extreme deviations equal
//! in size (over up to 33 evenly spaced words of the cell). One multiplier.

use super::cells::{Cells, Definition, Entry, Tables, column, range};
use crate::base::cast;
use crate::netlist::{Builder, NodeId, TableId};
use crate::number::format::{Overflow, word_mask};
use crate::number::function::{Combination, Function};

pub(super) const DEFINITION: Definition = Definition {
    name: "linear",
    applies: |cells| cells.cell_bits > 0,
    tables,
    emit,
    balanced_int_bits: |addr_bits| 2 * addr_bits / 3,
};

/// Number of words of a cell that are searched for the largest deviation.
const CELL_SAMPLES: i64 = 33;

fn tables(cells: &Cells<'_>) -> Tables {
    let sum_frac = cells.sum_frac();
    let slope_frac = sum_frac + cast::signed_count(cells.cell_bits);
    let mut columns = Vec::new();
    for function in cells.functions {
        let slopes = cells.each(&|i| slope(cells, function, i, slope_frac));
        let bases = cells.each(&|i| {
            let slope = cast::f64_of(slopes[cast::index_of(i)]) * 2f64.powi(-slope_frac);
            base(cells, function, i, slope).round(sum_frac)
        });
        columns.push(column(format!("{}_base", function.name()), bases, sum_frac));
        columns.push(column(format!("{}_slope", function.name()), slopes, slope_frac));
    }
    vec![("", columns)]
}

/// The chord's slope per word, in units of 2^-slope_frac.
fn slope(cells: &Cells<'_>, function: &Function, i: i64, slope_frac: i32) -> i64 {
    let terms = cells.rise(function, i, cells.cell_bits);
    Combination { function, terms: &terms, constant: 0.0, range: range(cells.output) }
        .round(slope_frac - cast::signed_count(cells.cell_bits))
}

/// The base that centres the deviation from a line with this slope per word.
fn base<'f>(cells: &Cells<'_>, function: &'f Function, i: i64, slope: f64) -> Entry<'f> {
    let range = range(cells.output);
    let words = word_mask(cells.cell_bits);
    let samples = CELL_SAMPLES.min(words + 1);
    let (mut least, mut most) = ((f64::INFINITY, 0), (f64::NEG_INFINITY, 0));
    for sample in 0..samples {
        let word = sample * words / (samples - 1);
        let x = cells.after(i, cells.cell_bits, word);
        let deviation = function.eval(x).clamp(range.0, range.1) - slope * cast::f64_of(word);
        if deviation < least.0 {
            least = (deviation, word);
        }
        if deviation > most.0 {
            most = (deviation, word);
        }
    }
    let at = |word| cells.after(i, cells.cell_bits, word);
    Entry {
        function,
        terms: [(0.5, at(least.1)), (0.5, at(most.1))],
        constant: -slope * 0.5 * cast::f64_of(least.1 + most.1),
        range,
    }
}

fn emit(
    b: &mut Builder,
    cells: &Cells<'_>,
    tables: &[TableId],
    which: usize,
    argument: NodeId,
) -> NodeId {
    let address = b.slice(argument, cells.cell_bits, cells.addr_bits);
    let base = b.read(tables[0], 2 * which, address);
    let slope = b.read(tables[0], 2 * which + 1, address);
    let position = b.slice(argument, 0, cells.cell_bits);
    let rise = b.mul(slope, position);
    let sum = b.add(base, rise);
    b.narrow(sum, cells.output, cells.round, Overflow::Saturate)
}
