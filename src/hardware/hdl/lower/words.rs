//! The words of a module under construction: names, helpers, and which bits are used.

use crate::hardware::hdl::module::{
    Bit, Driver, Expr, Item, Memories, Module, Operand, View, Word, WordId, new_word_id,
};
use crate::hardware::hdl::names::Names;
use crate::hardware::rtl::{Rtl, Signal};
use crate::netlist::{NodeId, Rate, TableId};
use crate::number::format::Format;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Hardware being lowered: the whole, or the inside of a unit.
pub(super) struct Context {
    pub(super) rtl: Arc<Rtl>,
    /// Prefix of its names.
    pub(super) prefix: String,
    /// Word of each of its signals.
    pub(super) signals: BTreeMap<Signal, WordId>,
    /// Position of each of its tables in the module.
    pub(super) roms: BTreeMap<TableId, usize>,
    /// Word of a row by table, address and stage.
    pub(super) rows: BTreeMap<(TableId, Signal, u32), WordId>,
}

/// A read of a memory outside the module.
pub(super) struct Fetch {
    /// Index of the memory in the module, and of the read in the memory.
    pub(super) memory: usize,
    pub(super) read: usize,
    /// Words by column.
    pub(super) data: BTreeMap<u32, WordId>,
}

pub(super) struct Lowering {
    pub(super) at: Context,
    pub(super) names: Names,
    /// Names of tables and memories in files; all different.
    pub(super) titles: Names,
    pub(super) module: Module,
    /// Index of the stage that receives statements.
    pub(super) stage: usize,
    /// Scope of the latest statement.
    pub(super) scope: String,
    /// Lowest bit of each column in its table's rows, by the table's index in the module.
    pub(super) columns: BTreeMap<(usize, u32), u32>,
    /// Flags that are set in some phases, by those phases.
    pub(super) flags: BTreeMap<Vec<u32>, Bit>,
    /// By table: the number of clocked ports so far, and the copy that the latest one uses.
    pub(super) ports: BTreeMap<usize, (u64, usize)>,
    /// Where memories are placed.
    pub(super) memories: Memories,
    /// Reads of memories outside the module, by table, address and stage.
    pub(super) reads: BTreeMap<(TableId, Signal, u32), Fetch>,
    /// Valid bits of slower rates, slowest first: the bit of the latest stage.
    pub(super) valids: Vec<(Rate, String)>,
}

impl Lowering {
    /// Scope and local name in one name.
    pub(super) fn flat_name(&self, signal: Signal) -> String {
        let netlist = self.at.rtl.netlist();
        let mut path = netlist.scope_path(netlist.node(signal.node).scope).join("_");
        if !path.is_empty() {
            path.push('_');
        }
        self.at.prefix.clone() + &path + &self.at.rtl.local_name(signal)
    }

    pub(super) fn node_word(&mut self, wanted: &str, format: Format, driver: Driver) -> WordId {
        let name = self.take(wanted);
        let (bits, signed, frac) = (format.bits(), format.is_signed(), format.frac_bits());
        self.push(Word { name, bits, signed, frac, format: Some(format), driver, used: Vec::new() })
    }

    /// Takes a name that the netlist wants; if it has to change, both names are recorded.
    pub(super) fn take(&mut self, wanted: &str) -> String {
        let name = self.names.take(wanted);
        if name != wanted {
            self.module.renamed.push((wanted.to_owned(), name.clone()));
        }
        name
    }

    pub(super) fn word(
        &mut self,
        wanted: &str,
        bits: u32,
        signed: bool,
        frac: i32,
        driver: Driver,
    ) -> WordId {
        let name = self.names.take(wanted);
        self.push(Word { name, bits, signed, frac, format: None, driver, used: Vec::new() })
    }

    /// Adds a word without used bits.
    fn push(&mut self, word: Word) -> WordId {
        let used = vec![false; usize::try_from(word.bits).expect("bug: 32 bits fit")];
        self.module.words.push(Word { used, ..word });
        new_word_id(self.module.words.len() - 1)
    }

    /// A helper of a node's word, named after it.
    pub(super) fn helper(
        &mut self,
        of: WordId,
        what: &str,
        bits: u32,
        signed: bool,
        expr: Expr,
    ) -> WordId {
        let (name, frac) = (self.module.word(of).name.clone(), self.module.word(of).frac);
        let word = self.word(&format!("{name}_{what}"), bits, signed, frac, Driver::Logic);
        self.assign(word, expr);
        word
    }

    pub(super) fn flag(&mut self, of: WordId, what: &str, expr: Expr) -> Bit {
        let word = self.helper(of, what, 1, false, expr);
        self.module.words[word.index()].frac = 0;
        Bit { word, bit: 0 }
    }

    pub(super) fn use_bits(&mut self, word: WordId, lo: u32, bits: u32) {
        let used = &mut self.module.words[word.index()].used;
        let skip = usize::try_from(lo).expect("bug: 32 bits fit");
        let count = usize::try_from(bits).expect("bug: 32 bits fit");
        used.iter_mut().skip(skip).take(count).for_each(|bit| *bit = true);
    }

    fn use_operand(&mut self, operand: Operand) {
        if let Operand::View(view) = operand {
            self.use_bits(view.word, view.lo, view.bits.saturating_sub(view.zeros));
        }
    }

    pub(super) fn assign(&mut self, word: WordId, expr: Expr) {
        match &expr {
            Expr::Copy(a) | Expr::Negate(a) => self.use_operand(*a),
            Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Equal(a, b) | Expr::Less { a, b, .. } => {
                self.use_operand(*a);
                self.use_operand(*b);
            }
            Expr::AddCarry(a, b, bit) => {
                self.use_operand(*a);
                self.use_operand(*b);
                self.use_bits(bit.word, bit.bit, 1);
            }
            Expr::InvertIf(bit, a) => {
                self.use_bits(bit.word, bit.bit, 1);
                self.use_operand(*a);
            }
            Expr::Multiply(a, b) | Expr::Bitwise(_, a, b) => {
                self.use_bits(*a, 0, u32::MAX);
                self.use_bits(*b, 0, u32::MAX);
            }
            Expr::Choose { cases, default } => {
                for (bit, operand) in cases.clone() {
                    self.use_bits(bit.word, bit.bit, 1);
                    self.use_operand(operand);
                }
                self.use_operand(*default);
            }
            Expr::Concat(parts) => parts.clone().into_iter().for_each(|p| self.use_operand(p)),
            Expr::ShiftLeft(a, count) => {
                self.use_operand(*a);
                self.use_bits(*count, 0, u32::MAX);
            }
            Expr::Above { word, keep } | Expr::Below { word, keep } => {
                self.use_bits(*word, *keep, u32::MAX);
            }
            Expr::Read(_, address) => self.use_bits(*address, 0, u32::MAX),
        }
        self.module.stages[self.stage].items.push(Item::Assign(word, expr));
    }

    /// A whole word with its binary point moved to `frac`, extended or cut to `bits`.
    pub(super) fn aligned(&self, word: WordId, frac: i32, bits: u32) -> Operand {
        let zeros = (frac - self.module.word(word).frac).unsigned_abs();
        Operand::View(View { word, lo: 0, zeros, bits })
    }

    /// A whole word extended or cut to `bits`.
    pub(super) fn resized(&self, word: WordId, bits: u32) -> Operand {
        self.aligned(word, self.module.word(word).frac, bits)
    }

    /// The word of operand `i` of `user`.
    pub(super) fn operand(&self, user: NodeId, i: usize) -> WordId {
        let operand = self.at.rtl.netlist().node(user).operands[i];
        self.at.signals[&self.at.rtl.operand(user, operand)]
    }

    /// A helper without a binary point.
    pub(super) fn plain(&mut self, of: WordId, what: &str, bits: u32, expr: Expr) -> WordId {
        let word = self.helper(of, what, bits, false, expr);
        self.module.words[word.index()].frac = 0;
        word
    }
}
