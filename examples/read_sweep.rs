//! Reads a sweep and picks the setting with the least ROM within an error:
//!
//! ```text
//! fixpath sweep rotation --axis scheme=direct,bipartite,linear --axis table_addr_bits=6..12:2 --out sweep
//! cargo run --release --example read_sweep -- sweep/sweep.json 0.01
//! ```
//!
//! Other languages read `sweep.csv`, or `sweep.json` by the schema that `fixpath schema` prints.

use fixpath::error::{Error, Result};
use fixpath::measure::Basis;
use fixpath::report::record::Record;
use std::path::Path;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, limit] = &arguments[..] else {
        return Err(Error::usage("usage: read_sweep SWEEP.JSON LIMIT".to_owned()));
    };
    let limit: f64 =
        limit.parse().map_err(|_| Error::usage(format!("LIMIT = {limit} is not a number")))?;
    let record = Record::load(Path::new(path))?
        .ok_or_else(|| Error::usage(format!("{path} doesn't exist: run `fixpath sweep` first")))?;
    let lead = record.lead(); // the quantity that the sweep ranks by, and its unit
    let within = record.points.iter().filter_map(|point| {
        let measured = point.measured.as_ref()?; // None: the point failed, and point.error says why
        let error = record.error(measured, Basis::Total);
        let rom_bits = measured.count("rom_bits_dual_port")?;
        (error <= limit).then_some((rom_bits, error, point, measured))
    });
    let Some((rom_bits, error, point, measured)) = within.min_by_key(|(rom_bits, ..)| *rom_bits)
    else {
        println!("no point has a {} within {limit} {}", lead.what, lead.unit);
        return Ok(());
    };
    let axes =
        record.header.axes.iter().map(|axis| format!("{}={}", axis.key, point.text(&axis.key)));
    println!("{}", axes.collect::<Vec<_>>().join(" "));
    println!("  {}: {error:.5} {}", lead.what, lead.unit);
    println!("  ROM bits with copies: {rom_bits}");
    println!("  worst input: {}", measured.witness());
    Ok(())
}
