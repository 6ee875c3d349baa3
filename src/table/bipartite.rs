//! The bipartite scheme: a table of initial values for 2^n cells and a table of offsets, addressed
//! by the top bits and by the bits below the cell. One addition, no multiplier.

use super::cells::{Cells, Definition, Entry, Tables, column, range};
use crate::base::cast;
use crate::netlist::{Builder, NodeId, TableId};
use crate::number::format::{Overflow, word_mask};
use crate::number::function::{Combination, Function};

pub(super) const DEFINITION: Definition = Definition {
    name: "bipartite",
    applies: |cells| offset_bits(cells) > 0,
    tables,
    emit,
    balanced_int_bits: |addr_bits| addr_bits / 2,
};

/// Number of bits below the cell that address the offsets: both tables have at most 2^addr_bits
/// entries.
fn offset_bits(cells: &Cells<'_>) -> u32 {
    cells.cell_bits.min(cells.addr_bits / 2)
}

fn tables(cells: &Cells<'_>) -> Tables {
    let (sum_frac, offset_bits) = (cells.sum_frac(), offset_bits(cells));
    let (mut values, mut offsets) = (Vec::new(), Vec::new());
    for function in cells.functions {
        let each = cells.each(&|i| offset(cells, function, i, offset_bits).round(sum_frac));
        let value = cells.each(&|i| {
            let coarse = i >> offset_bits << offset_bits;
            let last = coarse | word_mask(offset_bits);
            let ends = each[cast::index_of(coarse)] + each[cast::index_of(last)];
            initial(cells, function, i, ends, sum_frac)
        });
        values.push(column(function.name().to_owned(), value, sum_frac));
        offsets.push(column(format!("{}_offset", function.name()), each, sum_frac));
    }
    vec![("_initial", values), ("_offset", offsets)]
}

/// Entry `i` of the offset table: the coarse cell's slope times the distance of the fine cell's
/// centre from the middle.
fn offset<'f>(cells: &Cells<'_>, function: &'f Function, i: i64, offset_bits: u32) -> Entry<'f> {
    let coarse_words_bits = cells.cell_bits + offset_bits;
    let terms = cells.rise(function, i >> offset_bits, coarse_words_bits);
    let fine = i & word_mask(offset_bits);
    let fine_words = 1i64 << (cells.cell_bits - offset_bits);
    // Twice the distance in words, which is a whole number.
    let twice = 2 * fine * fine_words + (fine_words - 1) - word_mask(cells.cell_bits);
    let weight = cast::f64_of(twice) * 2f64.powi(-cast::signed_count(coarse_words_bits) - 1);
    Entry {
        function,
        terms: terms.map(|(c, x)| (c * weight, x)),
        constant: 0.0,
        range: range(cells.output),
    }
}

/// Entry `i` of the table of initial values: the mean of the residuals at the cell's ends.
fn initial(cells: &Cells<'_>, function: &Function, i: i64, offsets: i64, frac: i32) -> i64 {
    let (first, last) = cells.ends(i);
    let terms = [(0.5, first), (0.5, last)];
    let constant = -0.5 * cast::f64_of(offsets) * 2f64.powi(-frac);
    Combination { function, terms: &terms, constant, range: range(cells.output) }.round(frac)
}

fn emit(
    b: &mut Builder,
    cells: &Cells<'_>,
    tables: &[TableId],
    which: usize,
    argument: NodeId,
) -> NodeId {
    let offset_bits = offset_bits(cells);
    let address = b.slice(argument, cells.cell_bits, cells.addr_bits);
    let coarse_bits = cells.addr_bits - offset_bits;
    let coarse = b.slice(argument, cells.bits() - coarse_bits, coarse_bits);
    let fine = b.slice(argument, cells.cell_bits - offset_bits, offset_bits);
    let offset_address = b.concat(coarse, fine);
    let value = b.read(tables[0], which, address);
    let offset = b.read(tables[1], which, offset_address);
    let sum = b.add(value, offset);
    b.narrow(sum, cells.output, cells.round, Overflow::Saturate)
}
