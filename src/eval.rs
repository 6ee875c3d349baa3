//! A unit on a CSV of real inputs: one row in, one row out.
//!
//! Input columns are named by input port, in any order; others are left out. For each input
//! port `P` the output has its quantised value `P_q` and word `P_raw`, and for each output port
//! its value `P`, its word `P_raw` and the golden `P_golden` of the quantised inputs. Values are
//! written with as many digits as it takes to read the same `f64` back. Rows are read and
//! written in blocks, so files may be larger than memory.

use crate::cast;
use crate::error::{Error, Result};
use crate::measure::{quantize_inputs, values_of};
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::sim::batch::Program;
use crate::units::Design;
use std::f64::consts::TAU;
use std::io::{Read, Write};
use std::path::Path;

/// Rows that are held at a time.
const ROWS: usize = 1 << 12;

/// Unit of the angles in a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AngleUnit {
    /// 2π to the turn.
    Radians,
    /// 360 to the turn.
    Degrees,
    /// Turns.
    Turns,
}

impl AngleUnit {
    fn per_turn(self) -> f64 {
        match self {
            Self::Radians => TAU,
            Self::Degrees => 360.0,
            Self::Turns => 1.0,
        }
    }
}

/// Reads input columns from a CSV, block by block.
#[derive(Debug)]
pub struct InputFile<'a, R: Read> {
    reader: csv::Reader<R>,
    path: &'a Path,
    /// Position of each port's column.
    positions: Vec<usize>,
    names: Vec<String>,
    /// Values per unit of the file.
    scales: Vec<f64>,
    record: csv::StringRecord,
    rows: u64,
}

impl<'a, R: Read> InputFile<'a, R> {
    /// Reads the header.
    ///
    /// # Errors
    /// If there is none, or a port has no column or two.
    pub fn open(from: R, path: &'a Path, netlist: &Netlist, angle: AngleUnit) -> Result<Self> {
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(from);
        let header = reader.headers().map_err(|why| csv_error(path, &why))?.clone();
        let names: Vec<String> =
            (0..netlist.inputs().len()).map(|i| netlist.input_name(i).to_owned()).collect();
        let wanted = names.join(",");
        if header.is_empty() {
            let problem = format!("the file is empty; its first line should be {wanted}");
            return Err(Error::csv(path, 1, None, problem));
        }
        let mut positions = Vec::new();
        for name in &names {
            let mut found = header.iter().enumerate().filter(|(_, column)| column == name);
            let Some((position, _)) = found.next() else {
                let problem = format!("no such column; the header should name {wanted}");
                return Err(Error::csv(path, 1, Some(name), problem));
            };
            if found.next().is_some() {
                return Err(Error::csv(
                    path,
                    1,
                    Some(name),
                    "the column is there twice".to_owned(),
                ));
            }
            positions.push(position);
        }
        let scales = netlist
            .inputs()
            .iter()
            .map(|id| match netlist.node(*id).quantity {
                Quantity::Turns => angle.per_turn(),
                Quantity::Number | Quantity::Float20 => 1.0,
            })
            .collect();
        Ok(Self {
            reader,
            path,
            positions,
            names,
            scales,
            record: csv::StringRecord::new(),
            rows: 0,
        })
    }

    /// Reads up to `rows` rows into columns; fewer only at the end of the file.
    ///
    /// # Errors
    /// If a row is malformed, or a field is no finite number; names line and column.
    pub fn read(&mut self, rows: usize, columns: &mut Vec<Vec<f64>>) -> Result<usize> {
        columns.resize(self.positions.len(), Vec::new());
        columns.iter_mut().for_each(Vec::clear);
        for count in 0..rows {
            let more = self.reader.read_record(&mut self.record);
            if !more.map_err(|why| csv_error(self.path, &why))? {
                if self.rows == 0 {
                    let problem = "no rows after the header".to_owned();
                    return Err(Error::csv(self.path, 2, None, problem));
                }
                return Ok(count);
            }
            self.rows += 1;
            let line = self.record.position().map_or(self.rows + 1, csv::Position::line);
            for (i, column) in columns.iter_mut().enumerate() {
                let text = &self.record[self.positions[i]];
                let bad = |problem| Error::csv(self.path, line, Some(&self.names[i]), problem);
                let value: f64 =
                    text.parse().map_err(|_| bad(format!("`{}` is not a number", shown(text))))?;
                if !value.is_finite() {
                    return Err(bad(format!("`{}` is not a finite number", shown(text))));
                }
                column.push(value / self.scales[i]);
            }
        }
        Ok(rows)
    }
}

/// A field for a message: not too long, nothing that a terminal would act on.
fn shown(text: &str) -> String {
    let end = if text.chars().nth(40).is_some() { "…" } else { "" };
    text.chars().take(40).flat_map(char::escape_default).collect::<String>() + end
}

#[expect(clippy::wildcard_enum_match_arm, reason = "a foreign enum that may grow")]
fn csv_error(path: &Path, why: &csv::Error) -> Error {
    let line = why.position().map_or(1, csv::Position::line);
    let problem = match why.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("{len} fields where the header has {expected_len}")
        }
        csv::ErrorKind::Utf8 { .. } => "the text is not UTF-8".to_owned(),
        csv::ErrorKind::Io(why) => return Error::file(path, format!("can't read: {why}")),
        _ => why.to_string(),
    };
    Error::csv(path, line, None, problem)
}

/// Runs a design over a CSV; returns the number of rows.
///
/// # Errors
/// If the input is malformed, the output can't be written, or a `narrow` under overflow mode
/// `error` overflowed.
pub fn eval(
    design: &Design,
    from: impl Read,
    from_path: &Path,
    to: &mut dyn Write,
    to_path: &Path,
    angle: AngleUnit,
) -> Result<u64> {
    let netlist = &design.netlist;
    let mut input = InputFile::open(from, from_path, netlist, angle)?;
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(netlist, &outputs);
    let mut runner = program.runner();
    let written = |why: csv::Error| Error::io(to_path, "can't write", why.into());
    let mut writer = csv::Writer::from_writer(to);
    let mut header = Vec::new();
    for i in 0..netlist.inputs().len() {
        let name = netlist.input_name(i);
        header.extend([format!("{name}_q"), format!("{name}_raw")]);
    }
    for output in netlist.outputs() {
        let name = &output.name;
        header.extend([name.clone(), format!("{name}_raw"), format!("{name}_golden")]);
    }
    writer.write_record(&header).map_err(written)?;

    let scale = |id: &NodeId| match netlist.node(*id).quantity {
        Quantity::Turns => angle.per_turn(),
        Quantity::Number | Quantity::Float20 => 1.0,
    };
    let (mut values, mut words, mut quantised) = (Vec::new(), Vec::new(), Vec::new());
    let mut out_words = vec![Vec::new(); outputs.len()];
    let mut out_values = Vec::new();
    let mut golden = vec![Vec::new(); design.golden_columns()];
    let mut rows = 0;
    loop {
        let count = input.read(ROWS, &mut values)?;
        quantize_inputs(netlist, &values, &mut words)?;
        values_of(netlist, netlist.inputs(), &words, &mut quantised);
        let columns: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
        runner.run(&program, &columns, &mut out_words);
        runner.check(&program, netlist)?;
        values_of(netlist, &outputs, &out_words, &mut out_values);
        let columns: Vec<&[f64]> = quantised.iter().map(Vec::as_slice).collect();
        golden.iter_mut().for_each(|column| column.resize(count, 0.0));
        (design.golden)(&design.values, &columns, &mut golden);
        for row in 0..count {
            let mut fields = Vec::with_capacity(header.len());
            for (i, id) in netlist.inputs().iter().enumerate() {
                fields.push((quantised[i][row] * scale(id)).to_string());
                fields.push(words[i][row].to_string());
            }
            let golden: Vec<f64> = golden.iter().map(|column| column[row]).collect();
            let ports = design.of_golden(&golden);
            for (i, id) in outputs.iter().enumerate() {
                fields.push((out_values[i][row] * scale(id)).to_string());
                fields.push(out_words[i][row].to_string());
                fields.push((ports[i] * scale(id) + 0.0).to_string()); // -0 becomes 0
            }
            writer.write_record(&fields).map_err(written)?;
        }
        rows += cast::count_of(count);
        if count < ROWS {
            break;
        }
    }
    writer.flush().map_err(|why| Error::io(to_path, "can't write", why))?;
    Ok(rows)
}
