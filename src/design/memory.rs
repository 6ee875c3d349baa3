//! Words of memories, from files.

use super::{Design, Values};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::{escape, input};
use crate::netlist::{Column, Netlist, Table};
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Largest file of words, in bytes.
const MAX_BYTES: u64 = 1 << 32;
/// Largest memory that gets random words, in bits.
const RANDOM_BITS: u64 = 1 << 28;

/// Words of a memory from a CSV file with a heading for each column and a line of words for each
/// address.
#[derive(Clone, Debug)]
pub(super) struct MemoryFile {
    path: PathBuf,
    columns: Vec<FileColumn>,
}

#[derive(Clone, Debug, Default)]
struct FileColumn {
    name: String,
    words: Vec<i64>,
    /// The first field that is not a word, and its line. It is an error only if a memory uses the
    /// column.
    wrong: Option<(u64, String)>,
}

impl MemoryFile {
    pub(super) fn read(path: &Path) -> Result<Self> {
        let bytes = input::read(input::open_regular(path)?, path, MAX_BYTES)?;
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(&bytes[..]);
        let malformed = |error: csv::Error| {
            let line = error.position().map_or(1, csv::Position::line);
            Error::line(path, line, error.to_string())
        };
        let column = |name: &str| FileColumn { name: name.to_owned(), ..FileColumn::default() };
        let mut columns: Vec<FileColumn> =
            reader.headers().map_err(malformed)?.iter().map(column).collect();
        if columns.is_empty() {
            let problem = "the file is empty: it needs a line of headings, then a line of words for each address";
            return Err(Error::file(path, problem.to_owned()));
        }
        let mut known = HashSet::new();
        if let Some(twice) = columns.iter().find(|column| !known.insert(&column.name)) {
            let problem = format!("two columns are called `{}`", escape::short(&twice.name));
            return Err(Error::line(path, 1, problem));
        }
        let mut record = csv::StringRecord::new();
        while reader.read_record(&mut record).map_err(malformed)? {
            let line = record.position().map_or(1, csv::Position::line);
            for (column, field) in columns.iter_mut().zip(&record) {
                match field.parse() {
                    Ok(word) => column.words.push(word),
                    Err(_) if column.wrong.is_some() => {}
                    Err(_) => column.wrong = Some((line, field.to_owned())),
                }
            }
        }
        Ok(Self { path: path.to_owned(), columns })
    }

    /// Its words, in the order of a memory's columns. Columns that the memory doesn't have may hold
    /// anything.
    fn words(&self, memory: &Table) -> Result<Vec<Arc<[i64]>>> {
        let of = |wanted: &Column| {
            let Some(column) = self.columns.iter().find(|column| column.name == wanted.name) else {
                let names: Vec<&str> = self.columns.iter().map(|column| &column.name[..]).collect();
                return Err(Error::usage(format!(
                    "memory `{}`: its file has no column `{}`: it has {}",
                    memory.name,
                    wanted.name,
                    names.join(", ")
                )));
            };
            if let Some((line, field)) = &column.wrong {
                let problem =
                    format!("`{}` is not a word: write a whole number", escape::short(field));
                return Err(Error::csv(&self.path, *line, Some(&column.name), problem));
            }
            Ok(Arc::from(&column.words[..]))
        };
        memory.columns.iter().map(of).collect()
    }
}

impl Values {
    /// A netlist with the words that were set for its memories.
    ///
    /// # Errors
    /// If the netlist has no memory of a given name, or a file's words don't fit it.
    pub(super) fn bound(&self, netlist: &Netlist) -> Result<Netlist> {
        let mut bound = netlist.clone();
        for (name, file) in self.memory_files() {
            let memory =
                netlist.memories().find(|memory| memory.name == name).ok_or_else(|| {
                    let known: Vec<&str> =
                        netlist.memories().map(|memory| &memory.name[..]).collect();
                    Error::unknown_memory(netlist.name(), name, &known)
                })?;
            bound = bound.bind(name, &file.words(memory)?)?;
        }
        Ok(bound)
    }
}

impl Design {
    /// Sets the words of a memory, one list per column, unless `memory.NAME=FILE` sets others.
    #[must_use]
    pub fn memory(mut self, name: &str, columns: &[Arc<[i64]>]) -> Self {
        if self.values.memory_files().all(|(known, _)| known != name) {
            match self.netlist.bind(name, columns) {
                Ok(bound) => self.netlist = Arc::new(bound),
                Err(wrong) => {
                    self.made.wrong.get_or_insert(wrong);
                }
            }
        }
        self
    }

    /// Binds random words to memories that have none, so that the hardware can be compared with the
    /// engine. Returns their names.
    ///
    /// # Errors
    /// If a memory is too large for random words.
    pub(crate) fn fill_memories(&mut self) -> Result<Vec<String>> {
        let mut netlist = (*self.netlist).clone();
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        let mut filled = Vec::new();
        for memory in self.netlist.memories().filter(|memory| memory.is_unbound()) {
            if memory.rom_bits() > RANDOM_BITS {
                return Err(Error::usage(format!(
                    "memory `{}` has {} bits, and random words are limited to {RANDOM_BITS} bits: bind words with -p memory.{}=FILE.csv",
                    memory.name,
                    memory.rom_bits(),
                    memory.name
                )));
            }
            let mut word =
                |column: &Column| column.format.wrap(cast::word_of_bits(rng.next_u64() >> 1));
            let rows = 0..1u64 << memory.addr_bits;
            let columns: Vec<Arc<[i64]>> = memory
                .columns
                .iter()
                .map(|column| rows.clone().map(|_| word(column)).collect())
                .collect();
            netlist =
                netlist.bind(&memory.name, &columns).expect("bug: words are of their formats");
            filled.push(memory.name.clone());
        }
        self.made.filled |= !filled.is_empty();
        self.netlist = Arc::new(netlist);
        Ok(filled)
    }

    /// True if a memory has random words: then errors are meaningless.
    pub(crate) fn is_filled(&self) -> bool {
        self.made.filled
    }

    /// Refuses a design that can't be judged sample by sample.
    pub(crate) fn check_samples(&self) -> Result<()> {
        self.netlist.check_bound()?;
        match self.netlist.first_delay() {
            None => Ok(()),
            Some(id) => Err(Error::earlier_samples(self.netlist.label(id))),
        }
    }
}
