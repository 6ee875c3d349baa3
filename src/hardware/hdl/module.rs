//! A module: words of plain bits, each driven by one statement, stage by stage.

use crate::base::cast;
use crate::hardware::rtl::Signal;
use crate::netlist::Rate;
use crate::number::format::Format;
use std::collections::BTreeMap;

/// Where table words are placed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tables {
    /// In the module: an array with initial values.
    Inline,
    /// In separate files of hexadecimal rows, read at the start.
    Files,
    /// In the module: a function with one case per address. It slows down simulators, and each read
    /// is a table of its own: reads never share a block RAM.
    Case,
}

impl Tables {
    /// Names on the command line.
    pub const ALL: &'static [(Self, &'static str)] =
        &[(Self::Inline, "inline"), (Self::Files, "files"), (Self::Case, "case")];
}

/// Index of a word in its module.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct WordId(u32);

impl WordId {
    /// Position in [`Module::words`].
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}

/// What drives a word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Driver {
    /// An input port.
    Input,
    /// A statement.
    Logic,
    /// A clock edge.
    Register,
    /// A clock edge; the word is an output port.
    OutputRegister,
}

/// A named vector of bits.
#[derive(Clone, Debug)]
pub struct Word {
    /// Name: not a keyword of any language, and unique among all names in lower case.
    pub name: String,
    /// Bits; a helper can have more than any format.
    pub bits: u32,
    /// True if the top bit has a negative weight.
    pub signed: bool,
    /// Bits after the binary point. Where the language allows, the least index is minus this.
    pub frac: i32,
    /// Format of a node's word; helpers have none.
    pub format: Option<Format>,
    /// What drives it.
    pub driver: Driver,
    /// True for each bit that is used, from bit 0.
    pub used: Vec<bool>,
}

/// Part of a word, adjusted to a number of bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct View {
    /// The word.
    pub word: WordId,
    /// Lowest bit of the part.
    pub lo: u32,
    /// Zero bits appended below.
    pub zeros: u32,
    /// Final number of bits: the part is extended by the word's sign, or cut.
    pub bits: u32,
}

/// An operand of a statement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operand {
    /// Bits of a word.
    View(View),
    /// A constant pattern.
    Literal {
        /// The pattern.
        pattern: u128,
        /// Its bits.
        bits: u32,
    },
}

/// One bit of a word, as a condition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bit {
    /// The word.
    pub word: WordId,
    /// Bit index, from the least significant.
    pub bit: u32,
}

/// A bitwise operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bitwise {
    /// Both.
    And,
    /// Either.
    Or,
    /// Not equal.
    Xor,
}

/// The expression of a statement. Unless stated otherwise, operands have the n bits of the result,
/// and sums are modulo 2^n.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Expr {
    /// The operand itself.
    Copy(Operand),
    /// `a + b`.
    Add(Operand, Operand),
    /// `a - b`.
    Sub(Operand, Operand),
    /// `a + b`, plus one where the bit is set.
    AddCarry(Operand, Operand, Bit),
    /// Every bit is inverted where the bit is set.
    InvertIf(Bit, Operand),
    /// `-a`.
    Negate(Operand),
    /// The product of two whole words with their signs; the result holds it exactly.
    Multiply(WordId, WordId),
    /// Bit by bit.
    Bitwise(Bitwise, WordId, WordId),
    /// Flag: equal. Both operands have the same number of bits.
    Equal(Operand, Operand),
    /// Flag: `a < b`, signed or not. Both operands have the same number of bits.
    Less {
        /// Left side.
        a: Operand,
        /// Right side.
        b: Operand,
        /// True if top bits have a negative weight.
        signed: bool,
    },
    /// The operand of the first condition that holds, otherwise the default.
    Choose {
        /// Conditions with their operands.
        cases: Vec<(Bit, Operand)>,
        /// The operand if no condition holds.
        default: Operand,
    },
    /// Concatenated operands, the first at the top.
    Concat(Vec<Operand>),
    /// `a * 2^count`.
    ShiftLeft(Operand, WordId),
    /// Flag: a word, read as an integer, is at least 2^keep; `keep` is less than its number of
    /// bits.
    Above {
        /// The word.
        word: WordId,
        /// Exponent.
        keep: u32,
    },
    /// Flag: a signed word, read as an integer, is below -2^keep.
    Below {
        /// The word.
        word: WordId,
        /// Exponent.
        keep: u32,
    },
    /// A row of a table, read without a clock.
    Read(usize, WordId),
}

/// What a register loads at a clock edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Next {
    /// A word.
    Word(WordId),
    /// The table row at an address: the output register of a block RAM.
    Read(usize, WordId),
}

/// An item of a stage.
#[derive(Clone, Debug)]
pub enum Item {
    /// The scope of the items that follow: names joined by dots, outermost first.
    Scope(String),
    /// A statement.
    Assign(WordId, Expr),
}

/// A register.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Register {
    /// Its word.
    pub word: WordId,
    /// What it loads.
    pub next: Next,
    /// The flag that enables it; enabled at each edge if `None`.
    pub load: Option<Bit>,
    /// The valid bit that also enables it, if it loads only data.
    pub valid: Option<String>,
    /// True if a reset clears it.
    pub reset: bool,
}

/// Flag and valid bit that enable registers.
pub(super) type Enable = (Option<Bit>, Option<String>);

/// A valid bit; a reset clears it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Valid {
    /// Name of its source: the port or another valid bit.
    pub from: String,
    /// Its name.
    pub to: String,
    /// The flag that enables it; enabled at each edge if `None`.
    pub load: Option<Bit>,
}

/// Some logic, and the registers after it.
#[derive(Clone, Debug, Default)]
pub struct Stage {
    /// Title for a comment.
    pub title: String,
    /// Words that are used before they are driven.
    pub declared: Vec<WordId>,
    /// Scopes and statements in order.
    pub items: Vec<Item>,
    /// Registers that load at the end of the stage.
    pub registers: Vec<Register>,
    /// The valid bits that load with them: one for each rate that has samples in flight here.
    pub valid: Vec<Valid>,
}

impl Stage {
    /// True if the stage has no contents.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let statement = |item: &Item| matches!(item, Item::Assign(..));
        self.declared.is_empty()
            && !self.items.iter().any(statement)
            && self.registers.is_empty()
            && self.valid.is_empty()
    }

    /// Registers grouped by their enable, in the order of each group's first register.
    pub(super) fn groups(&self) -> Vec<(Enable, Vec<&Register>)> {
        let mut groups: Vec<(Enable, Vec<&Register>)> = Vec::new();
        for register in self.registers.iter().filter(|register| !register.reset) {
            let enable = register.enable();
            match groups.iter_mut().find(|(known, _)| *known == enable) {
                Some((_, group)) => group.push(register),
                None => groups.push((enable, vec![register])),
            }
        }
        groups
    }
}

impl Register {
    /// The flag and valid bit that enable it.
    pub(super) fn enable(&self) -> Enable {
        (self.load, self.valid.clone())
    }
}

/// Where memories are placed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Memories {
    /// Outside the module: an address port and data ports for each address that is read.
    #[default]
    Ports,
    /// In the module: a RAM with a write port.
    Ram,
}

/// A rate of the ports that is slower than the fastest.
#[derive(Clone, Debug)]
pub struct SlowRate {
    /// The rate.
    pub rate: Rate,
    /// Stage in which its words enter.
    pub entry: u32,
    /// Cycles from one of its words to the next.
    pub interval: u32,
    /// Port of its valid bit.
    pub valid: String,
    /// Port that reports when its words are accepted, and the flag that drives it; `None` if they
    /// are accepted together with those of the next faster rate.
    pub ready: Option<(String, Bit)>,
}

/// A memory of a module.
#[derive(Clone, Debug)]
pub struct MemoryPorts {
    /// Its rows, with only the columns that are read; they hold the words bound to it.
    pub table: RomTable,
    /// Cycles from the address to the words.
    pub latency: u32,
    /// For a memory outside the module: address port, the word that drives it, and data ports by
    /// column.
    pub reads: Vec<(String, WordId, Vec<WordId>)>,
    /// For a RAM: its write port.
    pub write: Option<WritePort>,
}

/// The write port of a RAM. It can write a row at each clock edge, even while the pipeline is
/// stalled.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WritePort {
    /// One bit: write a row.
    pub enable: WordId,
    /// The row's address.
    pub address: WordId,
    /// The row's words, by column.
    pub data: Vec<WordId>,
}

/// A table; a row is its columns, concatenated.
#[derive(Clone, Debug)]
pub struct RomTable {
    /// Name of the array.
    pub name: String,
    /// Its name in the netlist, with a number if another table has the same name.
    pub title: String,
    /// Address bits.
    pub addr_bits: u32,
    /// Bits of a row.
    pub row_bits: u32,
    /// Columns from the top bits down: name, format and words.
    pub columns: Vec<crate::netlist::Column>,
    /// Index of the table that this one copies: a block RAM has
    /// [`RAM_PORTS`](crate::netlist::RAM_PORTS), and synthesisers need much time and memory to find
    /// out how many copies are needed.
    pub copy_of: Option<usize>,
    /// The write port if it is a RAM, which has no initial words.
    pub write: Option<WritePort>,
}

impl RomTable {
    /// Rows as hexadecimal digits, from address 0.
    #[expect(clippy::missing_panics_doc, reason = "four bits are a digit")]
    pub fn rows(&self) -> impl Iterator<Item = String> + '_ {
        (0..1usize << self.addr_bits).map(|row| {
            let mut digits = String::new();
            // The top digit may hold fewer than four bits: the row is padded at the top.
            let (mut digit, mut left) = (0u32, self.row_bits);
            for column in &self.columns {
                let pattern = column.format.pattern(column.words[row]);
                for bit in (0..column.format.bits()).rev() {
                    left -= 1;
                    digit = digit << 1 | u32::from(pattern >> bit & 1 == 1);
                    if left.is_multiple_of(4) {
                        digits.push(char::from_digit(digit, 16).expect("bug: four bits"));
                        digit = 0;
                    }
                }
            }
            digits
        })
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> u64 {
        1 << self.addr_bits
    }

    /// Always false: a table has at least one row.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }
}

/// A unit as hardware: words, and the statements and registers that drive them.
#[derive(Clone, Debug)]
pub struct Module {
    /// Name.
    pub name: String,
    /// Lines for the head of the file.
    pub header: Vec<String>,
    /// Cycles from inputs to outputs. A module with latency 0 is combinational, without clock,
    /// reset and enable.
    pub latency: u32,
    /// Cycles from one vector of the fastest rate to the next; if more than one, there is an output
    /// `ready`.
    pub interval: u32,
    /// Cycles from one vector of the slowest rate to the next.
    pub phases: u32,
    /// True if tables are read with a clock.
    pub block_rom: bool,
    /// All words.
    pub words: Vec<Word>,
    /// Input ports.
    pub inputs: Vec<WordId>,
    /// Rate of each input port.
    pub input_rates: Vec<Rate>,
    /// Output ports: name, and the word that drives it, which may be the port itself.
    pub outputs: Vec<(String, WordId)>,
    /// Tables.
    pub tables: Vec<RomTable>,
    /// Where table words are placed.
    pub tables_in: Tables,
    /// Memories.
    pub memories: Vec<MemoryPorts>,
    /// The rates that are slower than the fastest, slowest first.
    pub rates: Vec<SlowRate>,
    /// Valid bits of those rates that nothing depends on.
    pub(super) idle_rates: Vec<String>,
    /// Stage in which words of the fastest rate enter.
    pub entry: u32,
    /// True if registers keep words from sample to sample.
    pub has_state: bool,
    /// Stages from the inputs on; one more than there are registers in a row. A time-shared module
    /// has further stages before and after them.
    pub stages: Vec<Stage>,
    /// The flag of the cycles at whose end inputs are accepted; `None` if that is every cycle.
    pub ready: Option<Bit>,
    /// Name of the outputs' valid bit, and the flag of the cycles in which it applies to them.
    pub valid: (String, Option<Bit>),
    /// Ports, words and tables whose name differs from that in the netlist, because a language
    /// reserves the name or another word has it: both names.
    pub renamed: Vec<(String, String)>,
    /// Word of each signal of the hardware.
    pub(super) signals: BTreeMap<Signal, WordId>,
}

/// A port of a module.
#[derive(Clone, Debug)]
pub struct Port<'a> {
    /// Name.
    pub name: &'a str,
    /// True if the module drives it.
    pub is_output: bool,
    /// Its word; `None` for a control bit.
    pub word: Option<&'a Word>,
    /// Comment beside it.
    pub comment: String,
}

impl Port<'_> {
    /// True for an output port that is itself a register.
    #[must_use]
    pub fn is_register(&self) -> bool {
        self.is_output && self.word.is_some_and(|word| word.name == self.name)
    }
}

/// A number of cycles in words.
pub(crate) fn cycles(count: u32) -> String {
    format!("{count} cycle{}", if count == 1 { "" } else { "s" })
}

/// Port that reports when a time-shared module accepts inputs.
pub(super) const READY: &str = "ready";

/// Name of the valid bit of a stage's words.
pub(super) fn valid_bit(stage: usize) -> String {
    match stage {
        0 => "valid_in".to_owned(),
        _ => format!("valid_s{stage}"),
    }
}

/// A file to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Name, without a folder.
    pub name: String,
    /// Its contents.
    pub text: String,
}

impl Module {
    /// One word.
    #[must_use]
    pub fn word(&self, id: WordId) -> &Word {
        &self.words[id.index()]
    }

    /// All ports in order of declaration. A combinational module has no clock, reset and enable.
    #[must_use]
    pub fn ports(&self) -> Vec<Port<'_>> {
        let bit = |name, is_output, comment: &str| Port {
            name,
            is_output,
            word: None,
            comment: comment.to_owned(),
        };
        let port = |name, is_output, word| Port {
            name,
            is_output,
            word: Some(word),
            comment: word.format.map(|format| format.to_string()).unwrap_or_default(),
        };
        let mut ports = Vec::new();
        if self.latency > 0 {
            ports.push(bit("clk", false, ""));
            let clears = match (self.phases, self.has_state) {
                (1, false) => "clears the valid bits",
                (1, true) => "clears the valid bits and delays",
                (_, false) => "clears the valid bits and the phase",
                (_, true) => "clears the valid bits, delays and the phase",
            };
            ports.push(bit("rst", false, clears));
            ports.push(bit("ce", false, "the pipeline stands still without"));
        }
        ports.push(bit("valid_in", false, ""));
        for (place, SlowRate { rate, entry, valid, ready, .. }) in self.rates.iter().enumerate() {
            let faster = &self.rates[place + 1..];
            let (next, its_entry) =
                faster.first().map_or(("valid_in", self.entry), |r| (&r.valid[..], r.entry));
            let later = cycles(its_entry - entry);
            let mut comment = format!(
                "words of rate {rate} are data: they count from what comes at {next} {later} later on"
            );
            if ready.is_none() {
                let shared =
                    faster.iter().find_map(|r| r.ready.as_ref().map(|(name, _)| &name[..]));
                if let Some(port) = shared.or(self.ready.as_ref().map(|_| READY)) {
                    comment.push_str(&format!("; taken with {port}"));
                }
            }
            ports.push(Port { name: valid, is_output: false, word: None, comment });
            if let Some((name, _)) = ready {
                ports.push(bit(name, true, "they are taken at this edge"));
            }
        }
        if self.ready.is_some() {
            ports.push(bit(READY, true, "inputs are taken at this edge"));
        }
        let inputs = self.inputs.iter().map(|id| self.word(*id));
        ports.extend(inputs.map(|word| port(word.name.as_str(), false, word)));
        ports.push(bit("valid_out", true, ""));
        let outputs = self.outputs.iter();
        ports.extend(outputs.map(|(name, id)| port(name.as_str(), true, self.word(*id))));
        for memory in &self.memories {
            let title = &memory.table.title;
            for (name, address, data) in &memory.reads {
                let later = cycles(memory.latency);
                let comment =
                    format!("{title}: its words come {later} later; it stands still without ce");
                let word = Some(self.word(*address));
                ports.push(Port { name, is_output: true, word, comment });
                ports.extend(
                    data.iter().map(|id| self.word(*id)).map(|word| port(&word.name, false, word)),
                );
            }
            if let Some(WritePort { enable, address, data }) = &memory.write {
                let mut input = |id: &WordId, comment: String| {
                    let word = self.word(*id);
                    ports.push(Port {
                        name: &word.name,
                        is_output: false,
                        word: Some(word),
                        comment,
                    });
                };
                input(
                    enable,
                    format!("{title}: writes a row, also while the pipeline stands still"),
                );
                input(address, String::new());
                for (id, column) in data.iter().zip(&memory.table.columns) {
                    input(id, column.format.to_string());
                }
            }
        }
        ports
    }

    /// Ports that report when words are accepted, and the flags that drive them.
    pub(super) fn readies(&self) -> impl Iterator<Item = (&str, Bit)> {
        let slow = self.rates.iter().filter_map(|rate| rate.ready.as_ref());
        let slow = slow.map(|(port, flag)| (port.as_str(), *flag));
        self.ready.map(|flag| (READY, flag)).into_iter().chain(slow)
    }

    /// Output ports and the words that drive them: outputs, and addresses of memories.
    pub fn driven(&self) -> impl Iterator<Item = (&str, WordId)> {
        let addresses = self.memories.iter().flat_map(|memory| &memory.reads);
        let addresses = addresses.map(|(name, word, _)| (name.as_str(), *word));
        self.outputs.iter().map(|(name, word)| (name.as_str(), *word)).chain(addresses)
    }

    /// The word of a signal, if the module has one.
    #[must_use]
    pub fn signal(&self, signal: Signal) -> Option<&Word> {
        self.signals.get(&signal).map(|id| self.word(*id))
    }

    /// Name of the file with a table's rows.
    #[must_use]
    pub fn table_file(&self, table: &RomTable) -> String {
        format!("{}_{}.hex", self.name, table.title)
    }

    /// Names of the files with table rows; empty unless tables are placed in files.
    #[must_use]
    pub fn table_file_names(&self) -> Vec<String> {
        match self.tables_in {
            Tables::Files => self.originals().map(|table| self.table_file(table)).collect(),
            Tables::Inline | Tables::Case => Vec::new(),
        }
    }

    /// The files with table rows, empty unless tables are placed in files. Each ends with a line
    /// feed, since some readers drop a last row without one.
    #[must_use]
    pub fn table_files(&self) -> Vec<File> {
        if self.tables_in != Tables::Files {
            return Vec::new();
        }
        let file = |table: &RomTable| {
            let mut text = String::new();
            for row in table.rows() {
                text.push_str(&row);
                text.push('\n');
            }
            File { name: self.table_file(table), text }
        };
        self.originals().map(file).collect()
    }

    /// Tables without their copies and without RAMs.
    fn originals(&self) -> impl Iterator<Item = &RomTable> {
        self.tables.iter().filter(|table| table.copy_of.is_none() && table.write.is_none())
    }

    /// True if testbenches use a bench around the module, which replaces its surroundings:
    /// memories, or the source of slow words.
    #[must_use]
    pub fn takes_bench(&self) -> bool {
        !self.memories.is_empty() || !self.rates.is_empty()
    }
}

pub(super) fn new_word_id(index: usize) -> WordId {
    WordId(cast::id_of(index))
}
