//! Tables of values: samples from a CSV, one per row. Every command that reads values uses these
//! rules.
//!
//! Rows are read in blocks of as many as are available. A pipe therefore gets each answer at once,
//! and files may be larger than memory.
//!
#![doc = include_str!("../../../docs/files/samples.md")]

mod records;

use crate::base::error::{Error, Result, nearest};
use crate::base::escape;
use crate::base::input::check_encoding;
use crate::design::Design;
use crate::measure::bounds::case_columns;
use crate::measure::inputs::quantize_input;
use crate::netlist::{Netlist, Quantity};
use records::{DELIMITERS, Next, ROW_BYTES, Records, Stop};
use std::f64::consts::TAU;
use std::io::Read;
use std::path::Path;

/// The column that names the ports whose value was clipped.
pub const CLIPPED: &str = "clipped";

/// Largest number of rows in a block.
const ROWS: usize = 1 << 12;

/// Unit of the angles in a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AngleUnit {
    /// 2π per turn.
    Radians,
    /// 360 per turn.
    Degrees,
    /// Turns.
    Turns,
}

impl AngleUnit {
    /// The factor from values of a quantity to those in a file.
    #[must_use]
    pub fn scale(self, quantity: Quantity) -> f64 {
        match (quantity, self) {
            (Quantity::Turns, Self::Radians) => TAU,
            (Quantity::Turns, Self::Degrees) => 360.0,
            (Quantity::Turns, Self::Turns) | (Quantity::Number | Quantity::Float20, _) => 1.0,
        }
    }
}

/// Names of an input port's columns: word, quantised value, real.
#[must_use]
pub fn input_columns(port: &str) -> [String; 3] {
    [format!("{port}_raw"), format!("{port}_q"), port.to_owned()]
}

/// Names of an output port's columns: value, word, golden.
#[must_use]
pub fn output_columns(port: &str) -> [String; 3] {
    [port.to_owned(), format!("{port}_raw"), format!("{port}_golden")]
}

/// Consecutive samples.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// Words by port.
    pub words: Vec<Vec<i64>>,
    /// Row of the block and port of each clipped value, in order.
    pub clipped: Vec<(usize, usize)>,
}

/// A column that gives an input port.
#[derive(Clone, Debug)]
struct Source {
    position: usize,
    name: String,
    is_word: bool,
}

/// Reads samples from a CSV, block by block.
#[derive(Debug)]
pub struct SampleFile<'a, R: Read> {
    records: Records<R>,
    path: &'a Path,
    netlist: &'a Netlist,
    angle: AngleUnit,
    /// Columns by port, the one that counts first.
    sources: Vec<Vec<Source>>,
    /// Number of fields in the header.
    columns: usize,
    decimal_comma: bool,
    rows: u64,
    /// Number of clipped values by port, and the line of the first.
    clipped: Vec<u64>,
    first_clipped: u64,
}

impl<'a, R: Read> SampleFile<'a, R> {
    /// Reads the header.
    ///
    /// # Errors
    /// If there is no header, a port has no column or the same one twice, or a column has no
    /// meaning and isn't to be ignored.
    pub fn open(
        from: R,
        path: &'a Path,
        design: &'a Design,
        angle: AngleUnit,
        ignore_columns: bool,
    ) -> Result<Self> {
        let netlist = &*design.netlist;
        let ports: Vec<[String; 3]> =
            (0..netlist.inputs().len()).map(|i| input_columns(netlist.input_name(i))).collect();
        let written = netlist.outputs().iter().flat_map(|output| output_columns(&output.name));
        let (group, results) = case_columns(design);
        let written = written.chain([CLIPPED.to_owned(), group.to_owned()]).chain(results);
        let written: Vec<String> = written.collect();
        let known = || ports.iter().flatten().chain(&written).map(String::as_str);
        let wanted: Vec<&str> = ports.iter().map(|[_, _, port]| port.as_str()).collect();
        let wanted = wanted.join(",");

        let mut delimiter = DELIMITERS[0];
        let records = Records::open(from, |line| {
            delimiter = delimiter_of(line, |name| known().any(|known| known == name));
            delimiter
        });
        let mut records = records.map_err(|why| stopped(path, why))?;
        let first = records.next(true).map_err(|why| stopped(path, why))?;
        let line = records.line();
        let header = |name: Option<&str>, problem| Error::csv(path, line, name, problem);
        if first != Next::Row {
            let problem = format!("the file is empty; its first line should be {wanted}");
            return Err(header(None, problem));
        }
        let names: Option<Vec<String>> = (0..records.len())
            .map(|at| std::str::from_utf8(records.field(at)).ok().map(str::to_owned))
            .collect();
        let names = names.ok_or_else(|| {
            let other = check_encoding(records.field(0));
            header(None, other.err().unwrap_or_else(|| NOT_UTF8.to_owned()))
        })?;
        let mut sources: Vec<[Option<Source>; 3]> = vec![[None, None, None]; ports.len()];
        for (position, name) in names.iter().enumerate() {
            let place = ports.iter().enumerate().find_map(|(port, columns)| {
                Some((port, columns.iter().position(|column| column == name)?))
            });
            if let Some((port, form)) = place {
                let source = Source { position, name: name.clone(), is_word: form == 0 };
                if sources[port][form].replace(source).is_some() {
                    return Err(header(Some(name), "the column occurs twice".to_owned()));
                }
            } else if !ignore_columns && !written.contains(name) {
                // Columns that are already present can't be the intended ones.
                let missing = known().filter(|known| !names.iter().any(|name| name == known));
                let hint = nearest(name, missing);
                let problem = format!(
                    "column {} has no meaning here{hint}: the header should name {wanted}, \
                     and --ignore-columns skips others",
                    position + 1
                );
                return Err(header(Some(&escape::short(name)), problem));
            }
        }
        let sources: Vec<Vec<Source>> =
            sources.into_iter().map(|forms| forms.into_iter().flatten().collect()).collect();
        if let Some(port) = sources.iter().position(Vec::is_empty) {
            let problem = format!("no such column; the header should name {wanted}");
            return Err(header(Some(netlist.input_name(port)), problem));
        }
        Ok(Self {
            records,
            path,
            netlist,
            angle,
            columns: names.len(),
            decimal_comma: delimiter != b',',
            rows: 0,
            clipped: vec![0; sources.len()],
            first_clipped: 0,
            sources,
        })
    }

    /// Path of the file, for messages.
    #[must_use]
    pub fn path(&self) -> &'a Path {
        self.path
    }

    /// Unit of its angles.
    #[must_use]
    pub fn angle(&self) -> AngleUnit {
        self.angle
    }

    /// Reads the available rows, waiting only for the first. Returns their number, which is 0 at
    /// the end.
    ///
    /// # Errors
    /// If a row is malformed, a field is not a finite number or not a word of its port, or the
    /// columns of a port disagree. The message names line and column.
    pub fn read(&mut self, block: &mut Block) -> Result<usize> {
        block.words.resize(self.sources.len(), Vec::new());
        block.words.iter_mut().for_each(Vec::clear);
        block.clipped.clear();
        let mut count = 0;
        while count < ROWS {
            match self.records.next(count == 0).map_err(|why| stopped(self.path, why))? {
                Next::Row => self.row(count, block)?,
                Next::Later => break,
                Next::End if self.rows == 0 => {
                    let problem = "no rows after the header".to_owned();
                    return Err(Error::csv(self.path, self.records.line().max(2), None, problem));
                }
                Next::End => break,
            }
            count += 1;
            self.rows += 1;
        }
        Ok(count)
    }

    /// Appends the current row to the block.
    fn row(&mut self, row: usize, block: &mut Block) -> Result<()> {
        let fields = self.records.len();
        if fields != self.columns {
            let problem = format!("{fields} fields where the header has {}", self.columns);
            return Err(Error::csv(self.path, self.records.line(), None, problem));
        }
        for (port, words) in block.words.iter_mut().enumerate() {
            let (word, clipped) = self.word(port)?;
            words.push(word);
            if clipped {
                block.clipped.push((row, port));
                self.clipped[port] += 1;
                if self.first_clipped == 0 {
                    self.first_clipped = self.records.line();
                }
            }
        }
        Ok(())
    }

    /// The word of a port in the row, and whether a value was clipped to it.
    fn word(&self, port: usize) -> Result<(i64, bool)> {
        let (first, others) = self.sources[port].split_first().expect("bug: checked in `open`");
        let (word, mut clipped) = self.word_of(port, first)?;
        for other in others {
            let (same, far) = self.word_of(port, other)?;
            if same != word {
                let problem = format!(
                    "`{}` is word {same}, but `{}` gives {word}: correct one, or leave its column out",
                    escape::short(self.text(other)?),
                    first.name
                );
                return Err(self.error(other, problem));
            }
            clipped |= far;
        }
        Ok((word, clipped))
    }

    /// The same from one column.
    fn word_of(&self, port: usize, source: &Source) -> Result<(i64, bool)> {
        let node = self.netlist.node(self.netlist.inputs()[port]);
        let text = self.text(source)?;
        let bad = |what: &str| {
            let remedy = if self.decimal_comma && text.contains(',') {
                ": write a decimal point"
            } else {
                ""
            };
            self.error(source, format!("`{}` is not a {what}{remedy}", escape::short(text)))
        };
        if source.is_word {
            let word: i64 = text.parse().map_err(|_| bad("whole number"))?;
            let (least, most) = (node.format.min_raw(), node.format.max_raw());
            if !(least..=most).contains(&word) {
                let problem = format!(
                    "{word} is not a word of format {}: legal is {least} to {most}",
                    node.format
                );
                return Err(self.error(source, problem));
            }
            return Ok((word, false));
        }
        let value: f64 = text.parse().map_err(|_| bad("number"))?;
        if !value.is_finite() {
            return Err(bad("finite number"));
        }
        quantize_input(node, value / self.angle.scale(node.quantity))
    }

    fn text(&self, source: &Source) -> Result<&str> {
        std::str::from_utf8(self.records.field(source.position))
            .map_err(|_| Error::csv(self.path, self.records.line(), None, NOT_UTF8.to_owned()))
    }

    fn error(&self, source: &Source, problem: String) -> Error {
        Error::csv(self.path, self.records.line(), Some(&source.name), problem)
    }

    /// A note on the values clipped so far, if any.
    #[must_use]
    pub fn clipped_note(&self) -> Option<String> {
        let total: u64 = self.clipped.iter().sum();
        let ports = self.clipped.iter().enumerate().filter(|(_, count)| **count > 0);
        let port = |(port, count): (usize, &u64)| {
            let format = self.netlist.node(self.netlist.inputs()[port]).format;
            let (least, most) = (format.value(format.min_raw()), format.value(format.max_raw()));
            format!("{} {count} times ({least} to {most})", self.netlist.input_name(port))
        };
        let ports: Vec<String> = ports.map(port).collect();
        (total > 0).then(|| {
            format!(
                "{}: {total} values were clipped to the range of their port, the first in line {}: {}",
                self.path.display(),
                self.first_clipped,
                ports.join(", ")
            )
        })
    }
}

const NOT_UTF8: &str = "the text is not UTF-8: save the file as UTF-8";

/// The delimiter that gives the most known names in a header. Ties go to the one that occurs most
/// often, then to the likeliest.
fn delimiter_of(header: &[u8], is_known: impl Fn(&str) -> bool) -> u8 {
    let score = |delimiter: &u8| {
        let fields = header.split(|byte| byte == delimiter);
        let names = fields.clone().filter_map(|field| std::str::from_utf8(field).ok());
        let known = names.filter(|name| is_known(name.trim().trim_matches('"').trim())).count();
        (known, fields.count())
    };
    // `max_by_key` returns the last of equals.
    DELIMITERS.into_iter().rev().max_by_key(score).expect("bug: there are some")
}

fn stopped(path: &Path, why: Stop) -> Error {
    match why {
        Stop::Io(why) => Error::io(path, "can't read", why),
        Stop::TooLong(line) => {
            let problem = format!(
                "the row has more than {ROW_BYTES} bytes: is this a CSV, and is every quote closed?"
            );
            Error::csv(path, line, None, problem)
        }
    }
}
