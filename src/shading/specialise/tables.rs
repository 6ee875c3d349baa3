//! Tables cut to the rows and columns that are read.
//!
//! A row is stored at the low bits of its address. As many bits are used as distinguish all
//! addresses that occur: rows within any 2^k consecutive ones, also across the wrap-around, differ
//! in their low k bits. So a cut costs no operation, wherever the range begins.

use super::rebuild::Rebuild;
use super::reduced::Reduced;
use crate::base::cast;
use crate::netlist::op::Op;
use crate::netlist::words::Words;
use crate::netlist::{Column, Netlist, NodeId, Table, TableId};
use crate::number::format::word_mask;
use std::collections::{BTreeMap, BTreeSet};

/// How a table was cut.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct TableCut {
    /// Its name.
    pub table: String,
    /// Its rows.
    pub rows: u64,
    /// Its stored bits.
    pub rom_bits: u64,
    /// The tables that replace it.
    pub into: Vec<CutTable>,
}

/// A table after the cut.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct CutTable {
    /// Its name.
    pub table: String,
    /// The addresses of the general table that occur.
    pub addresses: String,
    /// Its rows: a power of two.
    pub rows: u64,
    /// Its columns.
    pub columns: Vec<String>,
    /// Number of addresses that read it.
    pub ports: u64,
    /// Its stored bits.
    pub rom_bits: u64,
}

/// Ports of one table that share the rows of one cut table.
#[derive(Clone)]
struct Group {
    addresses: BTreeSet<NodeId>,
    columns: BTreeSet<u32>,
    words: Words,
}

impl Group {
    fn joined(&self, other: &Self) -> Self {
        Self {
            addresses: &self.addresses | &other.addresses,
            columns: &self.columns | &other.columns,
            words: self.words.union(&other.words),
        }
    }

    fn addr_bits(&self, table: &Table) -> u32 {
        self.words.telling_bits(table.addr_bits)
    }

    fn rom_bits(&self, table: &Table) -> u64 {
        let row: u32 =
            self.columns.iter().map(|column| of_table(table, *column).format.bits()).sum();
        u64::from(row) << self.addr_bits(table)
    }

    /// Stored bits with one copy for every two ports, as dual-port RAM needs to serve each port
    /// every cycle.
    fn cost(&self, table: &Table) -> u64 {
        self.rom_bits(table) * cast::count_of(self.addresses.len()).div_ceil(2)
    }

    /// Bits saved by one table in place of two, including copies. `None` if it is larger than the
    /// two, or if it saves nothing and has more rows than both.
    fn saved(&self, other: &Self, table: &Table) -> Option<u64> {
        let joined = self.joined(other);
        let rows = |group: &Self| group.addr_bits(table);
        let apart = self.cost(table) + other.cost(table);
        let saved = apart.checked_sub(joined.cost(table))?;
        (saved > 0 || rows(&joined) == rows(self).max(rows(other))).then_some(saved)
    }

    fn cut(&self, table: &Table, name: String) -> Table {
        let addr_bits = self.addr_bits(table);
        let (mask, all) = (word_mask(addr_bits), word_mask(table.addr_bits));
        // Slots of rows that never occur get the rows that follow the first one, as in the original
        // table.
        let first = start(&self.words, table);
        let mut rows: Vec<i64> =
            (0..=mask).map(|slot| (first + ((slot - first) & mask)) & all).collect();
        for (lo, hi) in self.words.intervals() {
            (*lo..=*hi).for_each(|address| rows[cast::index_of(address & mask)] = address);
        }
        let column = |column: &u32| {
            let Column { name, format, words } = of_table(table, *column);
            let words = rows.iter().map(|row| words[cast::index_of(*row)]).collect();
            Column { name: name.clone(), format: *format, words }
        };
        Table { name, addr_bits, columns: self.columns.iter().map(column).collect(), memory: None }
    }
}

/// The first address after the largest gap, with wrap-around.
fn start(words: &Words, table: &Table) -> i64 {
    let intervals = words.intervals();
    let around = (words.lo() + word_mask(table.addr_bits) - words.hi(), words.lo());
    let gaps = intervals.windows(2).map(|pair| (pair[1].0 - pair[0].1, pair[1].0));
    gaps.fold(around, |widest, gap| if gap.0 > widest.0 { gap } else { widest }).1
}

fn of_table(table: &Table, column: u32) -> &Column {
    &table.columns[usize::try_from(column).expect("bug: small")]
}

/// The ports of a table in groups, each with its own table. Two groups are joined if their common
/// table has fewer bits than theirs together, the best pair first, or as many bits and no more
/// rows. Bits include one copy for every two ports.
fn groups(netlist: &Netlist, words: &[Words]) -> BTreeMap<TableId, Vec<Group>> {
    let mut ports: BTreeMap<TableId, BTreeMap<NodeId, BTreeSet<u32>>> = BTreeMap::new();
    for (id, node) in netlist.ids().zip(netlist.nodes()) {
        // A memory's words aren't part of the datapath and can't be cut.
        if let Op::Read { table, column } = node.op
            && netlist.memory(id).is_none()
        {
            ports.entry(table).or_default().entry(node.operands[0]).or_default().insert(column);
        }
    }
    let of_one = |(id, ports): (TableId, BTreeMap<NodeId, BTreeSet<u32>>)| {
        let table = &netlist.tables()[id.index()];
        let single = |(address, columns): (NodeId, _)| Group {
            addresses: BTreeSet::from([address]),
            columns,
            words: words[address.index()].clone(),
        };
        let mut groups: Vec<Group> = ports.into_iter().map(single).collect();
        let best = |groups: &[Group]| {
            let pairs = (0..groups.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
            pairs
                .filter_map(|(i, j)| Some((groups[i].saved(&groups[j], table)?, i, j)))
                .max_by_key(|(saved, ..)| *saved)
        };
        while let Some((_, i, j)) = best(&groups) {
            let other = groups.remove(j);
            groups[i] = groups[i].joined(&other);
        }
        (id, groups)
    };
    ports.into_iter().map(of_one).collect()
}

/// The netlist with its tables cut, for the words that its nodes can have.
pub(super) fn cut(part: &Reduced, words: &[Words]) -> (Reduced, Vec<TableCut>) {
    let netlist = &part.netlist;
    let mut new = Rebuild::new(part, netlist.name());
    let mut reports = Vec::new();
    let mut made: Vec<(Table, TableId)> = Vec::new();
    let mut reads: BTreeMap<(TableId, NodeId), (TableId, Vec<u32>)> = BTreeMap::new();
    let mut taken: BTreeSet<String> =
        netlist.tables().iter().map(|table| table.name.clone()).collect();
    for (id, groups) in groups(netlist, words) {
        let table = &netlist.tables()[id.index()];
        let mut into = Vec::new();
        for (i, group) in groups.iter().enumerate() {
            let free = || (2..).map(|n| format!("{}_{n}", table.name)).find(|n| !taken.contains(n));
            let name = if i == 0 { table.name.clone() } else { free().expect("bug: endless") };
            let cut = group.cut(table, name);
            // Tables with equal rows are stored once, whatever their names.
            let same = |(known, _): &&(Table, TableId)| {
                let words = |table: &Table| -> Vec<_> {
                    table.columns.iter().map(|c| (c.format, c.words.clone())).collect()
                };
                known.addr_bits == cut.addr_bits && words(known) == words(&cut)
            };
            let found = made.iter().find(same).cloned();
            let (cut, cut_id) = found.unwrap_or_else(|| {
                taken.insert(cut.name.clone());
                let id = new.builder().table(cut.clone());
                made.push((cut.clone(), id));
                (cut, id)
            });
            for address in &group.addresses {
                let columns = group.columns.iter().copied().collect();
                reads.insert((id, *address), (cut_id, columns));
            }
            into.push(CutTable {
                addresses: group.words.to_string(),
                rows: 1 << cut.addr_bits,
                columns: cut.columns.iter().map(|column| column.name.clone()).collect(),
                ports: cast::count_of(group.addresses.len()),
                rom_bits: cut.rom_bits(),
                table: cut.name,
            });
        }
        reports.push(TableCut {
            table: table.name.clone(),
            rows: 1 << table.addr_bits,
            rom_bits: table.rom_bits(),
            into,
        });
    }
    for id in netlist.ids() {
        if let Op::Read { table, column } = netlist.node(id).op
            && netlist.memory(id).is_none()
        {
            let (table, columns) = &reads[&(table, netlist.node(id).operands[0])];
            let column = columns.iter().position(|known| *known == column);
            new.read(id, *table, cast::id_of(column.expect("bug: it is read")));
        } else {
            new.copy(id);
        }
    }
    let outputs: Vec<(String, NodeId)> =
        netlist.outputs().iter().map(|output| (output.name.clone(), output.node)).collect();
    (new.finish(&outputs), reports)
}
