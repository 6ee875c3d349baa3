//! Tables, their copies, and the rows read from them.

use super::words::{Fetch, Lowering};
use crate::base::cast;
use crate::hardware::hdl::module::{
    Driver, Memories, MemoryPorts, Next, Register, RomTable, Tables, WordId, WritePort, new_word_id,
};
use crate::hardware::rtl::Signal;
use crate::netlist::op::Op;
use crate::netlist::{Column, Memory, NodeId, RAM_PORTS, Table, TableId};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

impl Lowering {
    /// Adds the tables, with the columns that are read. Returns the position in the module of each
    /// table, for the whole and for each unit. Equal tables become one.
    pub(super) fn tables(&mut self) -> Vec<BTreeMap<TableId, usize>> {
        let whole = Arc::clone(&self.at.rtl);
        let mut read: Vec<(Table, BTreeSet<u32>)> = Vec::new();
        let mut all = Vec::new();
        for rtl in [&whole].into_iter().chain(whole.units().iter().map(|unit| &unit.rtl)) {
            let netlist = rtl.netlist();
            let mut own: BTreeMap<TableId, BTreeSet<u32>> = BTreeMap::new();
            for id in netlist.ids().filter(|id| rtl.is_free(*id)) {
                if let Op::Read { table, column } = netlist.node(id).op
                    && (self.memories == Memories::Ram || netlist.memory(id).is_none())
                {
                    own.entry(table).or_default().insert(column);
                }
            }
            let mut roms = BTreeMap::new();
            for (id, columns) in own {
                let table = &netlist.tables()[id.index()];
                let known = read.iter().position(|(known, _)| known == table);
                let at = known.unwrap_or_else(|| {
                    read.push((table.clone(), BTreeSet::new()));
                    read.len() - 1
                });
                read[at].1.extend(columns);
                roms.insert(id, at);
            }
            all.push(roms);
        }
        for (at, (table, columns)) in read.into_iter().enumerate() {
            let index = |column: u32| usize::try_from(column).expect("bug: small");
            let formats = columns.iter().map(|c| table.columns[index(*c)].format.bits());
            let row_bits: u32 = formats.sum();
            let mut lo = row_bits;
            for column in &columns {
                lo -= table.columns[index(*column)].format.bits();
                self.columns.insert((at, *column), lo);
            }
            let title = self.titles.take(&table.name);
            let kind = if table.memory.is_some() { "ram" } else { "rom" };
            let name = self.names.take(&format!("{title}_{kind}"));
            let wanted = format!("{}_{kind}", table.name);
            if name != wanted {
                self.module.renamed.push((wanted, name.clone()));
            }
            let columns: Vec<_> =
                columns.iter().map(|c| table.columns[index(*c)].clone()).collect();
            let addr_bits = table.addr_bits;
            let (copy_of, write) = (None, None);
            let mut rows = RomTable { name, title, addr_bits, row_bits, columns, copy_of, write };
            if let Some(Memory { latency }) = table.memory {
                let write = self.write_port(&table, &rows);
                rows.write = Some(write.clone());
                let (table, write) = (rows.clone(), Some(write));
                let reads = Vec::new();
                self.module.memories.push(MemoryPorts { table, latency, reads, write });
            }
            self.module.tables.push(rows);
        }
        all
    }

    /// Ports for writing a RAM.
    fn write_port(&mut self, memory: &Table, rows: &RomTable) -> WritePort {
        let name = &memory.name;
        let enable = self.word(&format!("{name}_we"), 1, false, 0, Driver::Input);
        let address = memory.address_format();
        let address = self.node_word(&format!("{name}_waddr"), address, Driver::Input);
        let column = |column: &Column| {
            self.node_word(&format!("{name}_w_{}", column.name), column.format, Driver::Input)
        };
        let data: Vec<WordId> = rows.columns.iter().map(column).collect();
        for word in [enable, address].iter().chain(&data) {
            self.use_bits(*word, 0, u32::MAX);
        }
        WritePort { enable, address, data }
    }

    /// Ports of the memories outside: for each address that is read, the address and a word for
    /// each column.
    pub(super) fn memory_ports(&mut self) {
        let rtl = Arc::clone(&self.at.rtl);
        let netlist = rtl.netlist();
        if self.memories == Memories::Ram {
            return;
        }
        let mut read: BTreeMap<TableId, BTreeSet<u32>> = BTreeMap::new();
        for id in netlist.ids().filter(|id| netlist.memory(*id).is_some()) {
            if let Op::Read { table, column } = netlist.node(id).op {
                read.entry(table).or_default().insert(column);
            }
        }
        for (id, columns) in read {
            let memory = &netlist.tables()[id.index()];
            let column = |column: &u32| memory.columns[cast::index_of_u32(*column)].clone();
            let rows: Vec<Column> = columns.iter().map(column).collect();
            let title = self.titles.take(&memory.name);
            let table = RomTable {
                name: title.clone(),
                title,
                addr_bits: memory.addr_bits,
                row_bits: rows.iter().map(|column| column.format.bits()).sum(),
                columns: rows,
                copy_of: None,
                write: None,
            };
            let latency = memory.memory.map_or(0, |memory| memory.latency);
            let place = self.module.memories.len();
            let (reads, write) = (Vec::new(), None);
            self.module.memories.push(MemoryPorts { table, latency, reads, write });
            for node in netlist.ids().filter(|node| netlist.memory(*node).is_some()) {
                let Op::Read { table, .. } = netlist.node(node).op else { continue };
                let key = (id, self.address(node), rtl.schedule().stage(node));
                if table != id || self.reads.contains_key(&key) {
                    continue;
                }
                let number = self.module.memories[place].reads.len() + 1;
                let name = match number {
                    1 => memory.name.clone(),
                    _ => format!("{}_{number}", memory.name),
                };
                let address = self.take(&format!("{name}_addr"));
                let data = columns.iter().map(|number| {
                    let Column { name: own, format, .. } = column(number);
                    (*number, self.node_word(&format!("{name}_{own}"), format, Driver::Input))
                });
                let data: BTreeMap<u32, WordId> = data.collect();
                let words = data.values().copied().collect();
                // The word that drives the address isn't known yet.
                self.module.memories[place].reads.push((address, new_word_id(0), words));
                let read = number - 1;
                self.reads.insert(key, Fetch { memory: place, read, data });
            }
        }
    }

    /// The word at a port of a memory outside the module; `None` for other reads.
    pub(super) fn fetched(&self, read: NodeId) -> Option<WordId> {
        let netlist = self.at.rtl.netlist();
        let Op::Read { table, column } = netlist.node(read).op else { return None };
        netlist.memory(read)?;
        let key = (table, self.address(read), self.at.rtl.schedule().stage(read));
        Some(self.reads.get(&key)?.data[&column])
    }

    /// Drives the address ports of memories outside the module.
    pub(super) fn memory_addresses(&mut self) {
        for ((_, address, _), Fetch { memory, read, .. }) in std::mem::take(&mut self.reads) {
            let word = self.at.signals[&address];
            self.module.memories[memory].reads[read].1 = word;
            self.use_bits(word, 0, u32::MAX);
        }
    }

    /// The table, or a copy of it, that serves one more clocked port.
    fn port_of(&mut self, rom: usize) -> usize {
        let (ports, latest) = self.ports.entry(rom).or_insert((0, rom));
        // The other port of a RAM is its write port.
        let most = if self.module.tables[rom].write.is_some() { 1 } else { RAM_PORTS };
        let in_case =
            self.module.tables_in == Tables::Case && self.module.tables[rom].write.is_none();
        if *ports > 0 && *ports % most == 0 && !in_case {
            let name = self.names.take(&self.module.tables[rom].name);
            let copy = RomTable { name, copy_of: Some(rom), ..self.module.tables[rom].clone() };
            *latest = self.module.tables.len();
            self.module.tables.push(copy);
        }
        *ports += 1;
        *latest
    }

    pub(super) fn address(&self, read: NodeId) -> Signal {
        self.at.rtl.operand(read, self.at.rtl.netlist().node(read).operands[0])
    }

    /// The register of a clocked read, one for all columns at an address.
    pub(super) fn row_register(&mut self, read: NodeId) {
        let Op::Read { table, .. } = self.at.rtl.netlist().node(read).op else { return };
        let address = self.address(read);
        let key = (table, address, self.at.rtl.schedule().stage(read));
        if self.at.rows.contains_key(&key) {
            return;
        }
        let rom = self.at.roms[&table];
        let from = self.at.signals[&address];
        let row = self.row_word(rom, Driver::Register);
        self.use_bits(from, 0, u32::MAX);
        let next = Next::Read(self.port_of(rom), from);
        self.register(row, next);
        self.at.rows.insert(key, row);
    }

    /// The next register after that of a RAM's row, if its words take more than one cycle.
    pub(super) fn later_row(&mut self, read: NodeId) {
        let Op::Read { table, .. } = self.at.rtl.netlist().node(read).op else { return };
        let key = (table, self.address(read), self.at.rtl.schedule().stage(read));
        let before = self.at.rows[&key];
        let row = self.row_word(self.at.roms[&table], Driver::Register);
        self.use_bits(before, 0, u32::MAX);
        self.register(row, Next::Word(before));
        self.at.rows.insert(key, row);
    }

    /// Adds a register that loads a word at each edge.
    fn register(&mut self, word: WordId, next: Next) {
        let register = Register { word, next, load: None, valid: None, reset: false };
        self.module.stages[self.stage].registers.push(register);
    }

    pub(super) fn row_word(&mut self, rom: usize, driver: Driver) -> WordId {
        let wanted = format!("{}{}_row", self.at.prefix, self.module.tables[rom].title);
        self.word(&wanted, self.module.tables[rom].row_bits, false, 0, driver)
    }
}
