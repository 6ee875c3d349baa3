//! Runs a unit on a table of values: one row in, one row out.
//!
//! Rows are read by the rules of [`crate::measure::samples`]. For each input port `P` the output
//! has its quantised value `P_q` and word `P_raw`. For each output port it has the value `P`, the
//! word `P_raw` and the golden value `P_golden` of the quantised inputs. The last column,
//! `clipped`, names the input ports whose value was out of range. Values have as many digits as are
//! needed to read the same `f64` back. Rows are read and written in blocks, and pending output is
//! written before waiting for more input.

use crate::base::cast;
use crate::base::columns::Field;
use crate::base::error::Result;
use crate::base::output;
use crate::design::Design;
use crate::measure::inputs::values_of;
use crate::measure::samples::{Block, CLIPPED, SampleFile, input_columns, output_columns};
use crate::netlist::NodeId;
use crate::sim::batch::Program;
use std::io::{Read, Write};
use std::path::Path;

/// Runs a design over samples of its own netlist; returns the number of rows.
///
/// # Errors
/// If the input is malformed, the output can't be written, or a `narrow` under overflow mode
/// `error` overflowed.
pub fn eval(
    design: &Design,
    samples: &mut SampleFile<'_, impl Read>,
    to: &mut dyn Write,
    to_path: &Path,
) -> Result<u64> {
    let netlist = &design.netlist;
    let angle = samples.angle();
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(netlist, &outputs);
    let mut runner = program.runner();
    let written = output::csv_at(to_path);
    let mut writer = csv::Writer::from_writer(to);
    let mut header = Vec::new();
    for i in 0..netlist.inputs().len() {
        let [word, quantised, _] = input_columns(netlist.input_name(i));
        header.extend([quantised, word]);
    }
    header.extend(netlist.outputs().iter().flat_map(|output| output_columns(&output.name)));
    header.push(CLIPPED.to_owned());
    writer.write_record(&header).map_err(written)?;

    let scale = |id: &NodeId| angle.scale(netlist.node(*id).quantity);
    let (mut block, mut quantised) = (Block::default(), Vec::new());
    let mut out_words = vec![Vec::new(); outputs.len()];
    let mut out_values = Vec::new();
    let mut golden = vec![Vec::new(); design.golden_columns()];
    let mut rows = 0;
    loop {
        // A reader gets the rows done so far before this waits for more.
        writer.flush().map_err(output::at(to_path))?;
        let count = samples.read(&mut block)?;
        if count == 0 {
            return Ok(rows);
        }
        values_of(netlist, netlist.inputs(), &block.words, &mut quantised);
        let columns: Vec<&[i64]> = block.words.iter().map(Vec::as_slice).collect();
        runner.run(&program, &columns, &mut out_words)?;
        runner.check(&program, netlist)?;
        values_of(netlist, &outputs, &out_words, &mut out_values);
        let columns: Vec<&[f64]> = quantised.iter().map(Vec::as_slice).collect();
        golden.iter_mut().for_each(|column| column.resize(count, 0.0));
        design.golden.run(&columns, &mut golden);
        let mut clipped = block.clipped.iter().peekable();
        for row in 0..count {
            let mut fields = Vec::with_capacity(header.len());
            for (i, id) in netlist.inputs().iter().enumerate() {
                fields.push(Field::Real(quantised[i][row] * scale(id)).to_string());
                fields.push(block.words[i][row].to_string());
            }
            let golden: Vec<f64> = golden.iter().map(|column| column[row]).collect();
            let ports = design.of_golden(&golden);
            for (i, id) in outputs.iter().enumerate() {
                fields.push(Field::Real(out_values[i][row] * scale(id)).to_string());
                fields.push(out_words[i][row].to_string());
                fields.push(Field::Real(ports[i] * scale(id) + 0.0).to_string()); // -0 becomes 0
            }
            let mut names = Vec::new();
            while let Some((_, port)) = clipped.next_if(|(at, _)| *at == row) {
                names.push(netlist.input_name(*port));
            }
            fields.push(names.join(" "));
            writer.write_record(&fields).map_err(written)?;
        }
        rows += cast::count_of(count);
    }
}
