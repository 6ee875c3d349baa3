//! Tables, their copies and the rows that are read of them.

use super::words::Lowering;
use crate::hardware::hdl::module::{Driver, Next, Register, RomTable, Tables, WordId};
use crate::hardware::hdl::names::Names;
use crate::hardware::rtl::Signal;
use crate::netlist::op::Op;
use crate::netlist::{NodeId, RAM_PORTS, Table, TableId};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

impl Lowering {
    /// Tables with the columns that are read; for the whole and for each unit, the position of
    /// each of its tables in the module. What several read is one table.
    pub(super) fn tables(&mut self) -> Vec<BTreeMap<TableId, usize>> {
        let whole = Arc::clone(&self.at.rtl);
        let mut read: Vec<(Table, BTreeSet<u32>)> = Vec::new();
        let mut all = Vec::new();
        for rtl in [&whole].into_iter().chain(whole.units().iter().map(|unit| &unit.rtl)) {
            let netlist = rtl.netlist();
            let mut own: BTreeMap<TableId, BTreeSet<u32>> = BTreeMap::new();
            for id in netlist.ids().filter(|id| rtl.is_free(*id)) {
                if let Op::Read { table, column } = netlist.node(id).op {
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
        // Files are named by titles, so no two tables may share one.
        let mut titles = Names::default();
        for (at, (table, columns)) in read.into_iter().enumerate() {
            let index = |column: u32| usize::try_from(column).expect("bug: small");
            let formats = columns.iter().map(|c| table.columns[index(*c)].format.bits());
            let row_bits: u32 = formats.sum();
            let mut lo = row_bits;
            for column in &columns {
                lo -= table.columns[index(*column)].format.bits();
                self.columns.insert((at, *column), lo);
            }
            let title = titles.take(&table.name);
            let name = self.names.take(&format!("{title}_rom"));
            let wanted = format!("{}_rom", table.name);
            if name != wanted {
                self.module.renamed.push((wanted, name.clone()));
            }
            self.module.tables.push(RomTable {
                name,
                title,
                addr_bits: table.addr_bits,
                row_bits,
                columns: columns.iter().map(|c| table.columns[index(*c)].clone()).collect(),
                copy_of: None,
            });
        }
        all
    }

    /// The table or its copy that one more port on the clock reads.
    fn port_of(&mut self, rom: usize) -> usize {
        let (ports, latest) = self.ports.entry(rom).or_insert((0, rom));
        if *ports > 0 && *ports % RAM_PORTS == 0 && self.module.tables_in != Tables::Case {
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

    /// The register that a read on a clock goes through, one for all columns of an address.
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
        let register = Register { word: row, next, load: None, reset: false };
        self.module.stages[self.stage].registers.push(register);
        self.at.rows.insert(key, row);
    }

    pub(super) fn row_word(&mut self, rom: usize, driver: Driver) -> WordId {
        let wanted = format!("{}{}_row", self.at.prefix, self.module.tables[rom].title);
        self.word(&wanted, self.module.tables[rom].row_bits, false, 0, driver)
    }
}
