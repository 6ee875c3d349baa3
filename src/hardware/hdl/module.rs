//! A module: words of plain bits and one statement each, stage by stage.

use crate::base::cast;
use crate::hardware::rtl::Signal;
use crate::netlist::Rate;
use crate::number::format::Format;
use std::collections::BTreeMap;

/// Where the words of tables stand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tables {
    /// In the module: an array that is filled at the start.
    Inline,
    /// In files of hexadecimal rows beside it, read at the start.
    Files,
    /// In the module: a function with one case for each address. Simulators are slower with it,
    /// and each read is a table of its own: no two of them share a block RAM.
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
    /// The user of the module.
    Input,
    /// A statement.
    Logic,
    /// A clock edge.
    Register,
    /// A clock edge, and it is an output port.
    OutputRegister,
}

/// A named vector of bits.
#[derive(Clone, Debug)]
pub struct Word {
    /// Name: no keyword of any language, unlike every other in lower case.
    pub name: String,
    /// Bits; helpers can have more than a format has.
    pub bits: u32,
    /// True if its top bit counts negative.
    pub signed: bool,
    /// Bits after the binary point; its least index is minus this where the language allows.
    pub frac: i32,
    /// Format of a node's word; helpers have none.
    pub format: Option<Format>,
    /// What drives it.
    pub driver: Driver,
    /// Which of its bits are used, from bit 0.
    pub used: Vec<bool>,
}

/// Part of a word, brought to a number of bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct View {
    /// The word.
    pub word: WordId,
    /// Least bit that is taken.
    pub lo: u32,
    /// Zero bits put below.
    pub zeros: u32,
    /// Bits in the end: extended by the word's sign, or cut.
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
    /// Bit, counted from the least.
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

/// What a statement computes. Operands have the bits of the word that takes the result, if
/// nothing else is said; sums are modulo two to that.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Expr {
    /// The operand itself.
    Copy(Operand),
    /// `a + b`.
    Add(Operand, Operand),
    /// `a - b`.
    Sub(Operand, Operand),
    /// `a + b`, and one more where the bit is set.
    AddCarry(Operand, Operand, Bit),
    /// Every bit inverted where the bit is set.
    InvertIf(Bit, Operand),
    /// `-a`.
    Negate(Operand),
    /// The product of two whole words by their signs, which the result holds exactly.
    Multiply(WordId, WordId),
    /// Bit by bit.
    Bitwise(Bitwise, WordId, WordId),
    /// Flag: equal; operands have the same bits.
    Equal(Operand, Operand),
    /// Flag: `a < b` by the sign given; operands have the same bits.
    Less {
        /// Left side.
        a: Operand,
        /// Right side.
        b: Operand,
        /// True if top bits count negative.
        signed: bool,
    },
    /// The operand of the first condition that holds, else the default.
    Choose {
        /// Conditions with their operands.
        cases: Vec<(Bit, Operand)>,
        /// Where none holds.
        default: Operand,
    },
    /// Operands side by side, the first at the top.
    Concat(Vec<Operand>),
    /// `a * 2^count`.
    ShiftLeft(Operand, WordId),
    /// Flag: a word is at least 2^keep of its last place; `keep` is below its bits.
    Above {
        /// The word.
        word: WordId,
        /// Exponent.
        keep: u32,
    },
    /// Flag: a signed word is below -2^keep of its last place.
    Below {
        /// The word.
        word: WordId,
        /// Exponent.
        keep: u32,
    },
    /// A row of a table, without a clock.
    Read(usize, WordId),
}

/// What a register takes at a clock edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Next {
    /// A word.
    Word(WordId),
    /// The row of a table at an address: the output register of a block RAM.
    Read(usize, WordId),
}

/// A line of a stage.
#[derive(Clone, Debug)]
pub enum Item {
    /// The scope that the following belong to, from the outermost in.
    Scope(String),
    /// A statement.
    Assign(WordId, Expr),
}

/// What drives a register.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Register {
    /// Its word.
    pub word: WordId,
    /// What it takes.
    pub next: Next,
    /// The flag that it takes it under; at each edge if `None`.
    pub load: Option<Bit>,
    /// The valid bit that it takes it under besides, if it takes data only.
    pub valid: Option<String>,
    /// True if the reset clears it.
    pub reset: bool,
}

/// Flag and valid bit that registers take their words under.
pub(super) type Enable = (Option<Bit>, Option<String>);

/// A valid bit, which the reset clears.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Valid {
    /// Name of what it takes: the port or another valid bit.
    pub from: String,
    /// Its name.
    pub to: String,
    /// The flag that it takes it under; at each edge if `None`.
    pub load: Option<Bit>,
}

/// Some logic, and the registers behind it.
#[derive(Clone, Debug, Default)]
pub struct Stage {
    /// What it is.
    pub title: String,
    /// Words that are used before they are driven.
    pub declared: Vec<WordId>,
    /// Logic in order.
    pub items: Vec<Item>,
    /// Registers that take their words at its end.
    pub registers: Vec<Register>,
    /// The valid bits beside them: one for each rate that has samples on their way here.
    pub valid: Vec<Valid>,
}

impl Stage {
    /// True if there is nothing in it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let statement = |item: &Item| matches!(item, Item::Assign(..));
        self.declared.is_empty()
            && !self.items.iter().any(statement)
            && self.registers.is_empty()
            && self.valid.is_empty()
    }

    /// Registers in groups that take their words under the same flag, in the order of their first.
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
    /// What it takes its word under.
    pub(super) fn enable(&self) -> Enable {
        (self.load, self.valid.clone())
    }
}

/// Where the words of memories stand.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Memories {
    /// Outside of the module: an address port and data ports for each address that is read at.
    #[default]
    Ports,
    /// In the module: a RAM with a write port.
    Ram,
}

/// A rate of ports that is slower than the fastest.
#[derive(Clone, Debug)]
pub struct SlowRate {
    /// The rate.
    pub rate: Rate,
    /// Stage that its words enter in.
    pub entry: u32,
    /// Cycles from its words to the next.
    pub interval: u32,
    /// Port of its valid bit.
    pub valid: String,
    /// Port that says when its words are taken, and its flag, where it isn't that of the next faster rate.
    pub ready: Option<(String, Bit)>,
}

/// A memory of a module.
#[derive(Clone, Debug)]
pub struct MemoryPorts {
    /// Its rows, of the columns that are read; they have the words that are bound to it.
    pub table: RomTable,
    /// Cycles from the address to the words.
    pub latency: u32,
    /// Where it is outside: address port, the word behind it, and data ports by column.
    pub reads: Vec<(String, WordId, Vec<WordId>)>,
    /// Where it is a RAM: its write port.
    pub write: Option<WritePort>,
}

/// The write port of a RAM: it takes a row at each clock edge, whether the pipeline stands still or not.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WritePort {
    /// One bit: a row is written.
    pub enable: WordId,
    /// Its address.
    pub address: WordId,
    /// Its words by column.
    pub data: Vec<WordId>,
}

/// A table; a row is its columns side by side.
#[derive(Clone, Debug)]
pub struct RomTable {
    /// Name of the array.
    pub name: String,
    /// Its name in the netlist, with a number where another table has it.
    pub title: String,
    /// Address bits.
    pub addr_bits: u32,
    /// Bits of a row.
    pub row_bits: u32,
    /// Columns from the top bits down: name, format and words.
    pub columns: Vec<crate::netlist::Column>,
    /// Position of the table that this is a copy of: a block RAM has
    /// [`RAM_PORTS`](crate::netlist::RAM_PORTS), and synthesisers take long and much memory to find
    /// how many they need.
    pub copy_of: Option<usize>,
    /// The write port of one that is a RAM, which has no words at the start.
    pub write: Option<WritePort>,
}

impl RomTable {
    /// Rows as hexadecimal digits, from address 0.
    #[expect(clippy::missing_panics_doc, reason = "four bits are a digit")]
    pub fn rows(&self) -> impl Iterator<Item = String> + '_ {
        (0..1usize << self.addr_bits).map(|row| {
            let mut digits = String::new();
            // Bits above the last whole digit come first: the row is padded at the top.
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

    /// Never: a table has a row at least.
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
    /// Lines for its head.
    pub header: Vec<String>,
    /// Cycles from inputs to outputs; 0 is combinational, without clock, reset and enable.
    pub latency: u32,
    /// Cycles from one vector of the fastest rate to the next; with more than one there is an output `ready`.
    pub interval: u32,
    /// Cycles from one vector of the slowest rate to the next.
    pub phases: u32,
    /// True if tables are read on the clock.
    pub block_rom: bool,
    /// All words.
    pub words: Vec<Word>,
    /// Input ports.
    pub inputs: Vec<WordId>,
    /// Rate of each.
    pub input_rates: Vec<Rate>,
    /// Output ports: name, and the word behind it, which may be the port itself.
    pub outputs: Vec<(String, WordId)>,
    /// Tables.
    pub tables: Vec<RomTable>,
    /// Where their words stand.
    pub tables_in: Tables,
    /// Memories.
    pub memories: Vec<MemoryPorts>,
    /// Slower rates than the fastest, from the slowest.
    pub rates: Vec<SlowRate>,
    /// Which of those valid bits nothing depends on.
    pub(super) idle_rates: Vec<String>,
    /// Stage that the words of the fastest rate enter in.
    pub entry: u32,
    /// True if registers keep words from one sample to the next.
    pub has_state: bool,
    /// Stages from the inputs on; one more than there are registers in a row. A time-shared
    /// module has others before and after them.
    pub stages: Vec<Stage>,
    /// The flag of the cycles at whose end inputs are taken; all of them if `None`.
    pub ready: Option<Bit>,
    /// Name of the valid bit of the outputs, and the flag of the cycles in which it is theirs.
    pub valid: (String, Option<Bit>),
    /// Ports, words and tables that are named otherwise than in the netlist, since a language or
    /// another word has the name: both names.
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
    /// Its word; a control bit has none.
    pub word: Option<&'a Word>,
    /// What to say beside it.
    pub comment: String,
}

impl Port<'_> {
    /// True for an output port that is a register itself.
    #[must_use]
    pub fn is_register(&self) -> bool {
        self.is_output && self.word.is_some_and(|word| word.name == self.name)
    }
}

/// A number of cycles in words.
pub(crate) fn cycles(count: u32) -> String {
    format!("{count} cycle{}", if count == 1 { "" } else { "s" })
}

/// Port that says when a time-shared module takes its inputs.
pub(super) const READY: &str = "ready";

/// Name of the valid bit beside the words of a stage.
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
    /// What is in it.
    pub text: String,
}

impl Module {
    /// One word.
    #[must_use]
    pub fn word(&self, id: WordId) -> &Word {
        &self.words[id.index()]
    }

    /// All ports in the order of their declaration. A combinational module has no clock, reset
    /// and enable.
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

    /// Flags that say when words are taken: ports, and what drives them.
    pub(super) fn readies(&self) -> impl Iterator<Item = (&str, Bit)> {
        let slow = self.rates.iter().filter_map(|rate| rate.ready.as_ref());
        let slow = slow.map(|(port, flag)| (port.as_str(), *flag));
        self.ready.map(|flag| (READY, flag)).into_iter().chain(slow)
    }

    /// Output ports with the words that drive them: outputs, and addresses of memories.
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

    /// Names of the files with the rows of tables: none if they don't stand in files.
    #[must_use]
    pub fn table_file_names(&self) -> Vec<String> {
        match self.tables_in {
            Tables::Files => self.originals().map(|table| self.table_file(table)).collect(),
            Tables::Inline | Tables::Case => Vec::new(),
        }
    }

    /// The files with the rows of tables, if they stand in files. Each ends in a line feed: some
    /// readers drop a last row without one.
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

    /// True if a testbench reaches it through a bench, which stands for what is outside: memories, or the source of words of
    /// slow rates.
    #[must_use]
    pub fn takes_bench(&self) -> bool {
        !self.memories.is_empty() || !self.rates.is_empty()
    }
}

pub(super) fn new_word_id(index: usize) -> WordId {
    WordId(cast::id_of(index))
}
