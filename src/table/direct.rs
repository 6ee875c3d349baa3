//! The direct scheme: the mean of the function at the first and last word of each cell, which has
//! half the worst error of the value at the left edge.

use super::cells::{Cells, Definition, Tables, entry, range};
use crate::netlist::{Builder, Column, NodeId, TableId};
use crate::number::function::{Combination, Function};

pub(super) const DEFINITION: Definition = Definition {
    name: "direct",
    applies: |_| true,
    tables,
    emit,
    balanced_int_bits: |addr_bits| addr_bits.saturating_sub(1) / 2,
};

fn tables(cells: &Cells<'_>) -> Tables {
    let column = |function: &Function| Column {
        name: function.name().to_owned(),
        format: cells.output,
        words: cells.each(&|i| mean(cells, function, i)).into(),
    };
    vec![("", cells.functions.iter().map(column).collect())]
}

fn mean(cells: &Cells<'_>, function: &Function, i: i64) -> i64 {
    let (first, last) = cells.ends(i);
    let terms = [(0.5, first), (0.5, last)];
    let output = cells.output;
    let range = range(output);
    entry(&Combination { function, terms: &terms, constant: 0.0, range }, output)
}

fn emit(
    b: &mut Builder,
    cells: &Cells<'_>,
    tables: &[TableId],
    which: usize,
    argument: NodeId,
) -> NodeId {
    let address = b.slice(argument, cells.cell_bits, cells.addr_bits);
    b.read(tables[0], which, address)
}
