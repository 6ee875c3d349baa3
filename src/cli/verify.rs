//! `fixpath verify`: a unit's hardware in outside simulators.

use super::hardware::{MemoriesArg, TablesArg, with_memories};
use super::options::UnitArgs;
use super::print::note_unused;
use super::{number, text};
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::base::outside;
use crate::design::Design;
use crate::hardware::verify::{self, Decoded, Mismatch, Request, Row, Simulator, Verdict};
use clap::Args;
use indicatif::ProgressBar;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

#[derive(Args)]
pub(super) struct VerifyArgs {
    #[command(flatten)]
    unit: UnitArgs,
    /// Use only these tools, which must be installed: icarus, verilator, ghdl, yosys.
    #[arg(long = "with", value_name = "TOOLS", value_delimiter = ',')]
    with: Vec<String>,
    /// Random vectors after the hard-case list; default: 1000000 in Verilator, 10000 in Icarus and
    /// GHDL.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(0..=1_000_000_000))]
    vectors: Option<u64>,
    /// Seed of the random vectors; default 1.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = number::whole(0..=u64::MAX))]
    seed: Option<u64>,
    /// Where the words of tables are stored.
    #[arg(long, value_enum, default_value = "auto")]
    tables: TablesArg,
    /// Where memories are placed; their words aren't part of the datapath.
    #[arg(long, value_enum, default_value = "ports")]
    memories: MemoriesArg,
    /// Time limit of each tool run, in s.
    #[arg(long, value_name = "S", default_value_t = 600, allow_negative_numbers = true, value_parser = number::whole(1..=86_400))]
    time_limit: u64,
    /// Memory limit of each process of a tool, in GiB (Linux); default: 4, or half of the machine's
    /// memory if that is less.
    #[arg(long, value_name = "GIB", allow_negative_numbers = true, value_parser = number::whole(1..=4096))]
    memory_limit: Option<u64>,
    /// Keep the generated files in this folder.
    #[arg(long, value_name = "DIR")]
    keep: Option<PathBuf>,
    /// As JSON.
    #[arg(long)]
    pub(super) json: bool,
}

/// Runs the tools. Returns the text to print, and whether all tools that ran agree. The latter is
/// an error if none disagrees but one didn't finish.
pub(super) fn run(args: &VerifyArgs) -> Result<(String, Result<bool>)> {
    let simulators = if args.with.is_empty() {
        Simulator::ALL.to_vec()
    } else {
        verify::simulators_of(&args.with)?
    };
    if simulators == [Simulator::Yosys] {
        let why = "Yosys proves equality and draws no vectors";
        note_unused(&[("--vectors", args.vectors), ("--seed", args.seed)], why);
    } else if args.vectors == Some(0) {
        note_unused(&[("--seed", args.seed)], "no vectors are drawn");
    }
    let request = Request {
        simulators,
        vectors: args.vectors,
        seed: args.seed.unwrap_or(1),
        tables: args.tables.tables(),
        memories: args.memories.memories(),
        limit: Duration::from_secs(args.time_limit),
        memory_bytes: outside::memory_bytes(args.memory_limit),
        keep: args.keep.clone(),
        ..Request::default()
    };
    let design = with_memories(args.unit.design()?)?;
    // Tools named by the user must be installed: check before anything runs.
    if !args.with.is_empty() {
        for simulator in &request.simulators {
            simulator.version().map_err(Error::usage)?;
        }
    }
    let bar = ProgressBar::new_spinner();
    let names: Vec<&str> = request.simulators.iter().map(|simulator| simulator.name()).collect();
    bar.set_message(format!("{} at work", names.join(", ")));
    super::progress::tick(&bar);
    let rows = verify::verify(&design, &request, &|row| {
        bar.println(format!("{}: {:.1} s", row.tool, row.seconds));
    })?;
    bar.finish_and_clear();
    if rows.iter().all(Row::is_missing) {
        let missing: Vec<String> = rows.iter().map(|row| verdict(&row.verdict)).collect();
        return Err(Error::usage(missing.join("; ")));
    }
    // Tools named by the user must also complete their proof.
    let is_well =
        |row: &Row| row.agrees() || row.is_missing() || row.is_unproved() && args.with.is_empty();
    let ended = if !rows.iter().all(|row| is_well(row) || row.is_unfinished()) {
        Ok(false)
    } else if let Some(row) = rows.iter().find(|row| row.is_unfinished()) {
        let text = format!("{} did not finish, so its verdict is unknown", row.tool);
        Err(Error::usage(text))
    } else {
        Ok(true)
    };
    let told = if args.json { json::text(&json_of(&design, &rows)) } else { told(&design, &rows) };
    Ok((told, ended))
}

fn verdict(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Agrees(how) if how.is_empty() => "agrees".to_owned(),
        Verdict::Agrees(how) => how.clone(),
        Verdict::Unproved(why) => format!("NOT PROVED: {why}"),
        Verdict::Disagrees(_) => "DISAGREES".to_owned(),
        Verdict::Failed(why) => format!("FAILED: {why}"),
        Verdict::TimedOut(why) => format!("TIMED OUT: {why}"),
        Verdict::OutOfMemory(why) => format!("OUT OF MEMORY: {why}"),
        Verdict::Unusable(why) => format!("COULD NOT RUN: {why}"),
        Verdict::Missing(how) => how.clone(),
    }
}

fn told(design: &Design, rows: &[Row]) -> String {
    let mut text =
        format!("{}: {}\n", design.values.unit().name, text::parameter_line(&design.values));
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            // A tool that ran no vectors compared none.
            let compared = row.vectors > 0;
            let count = |n: u64| if compared { n.to_string() } else { "-".to_owned() };
            vec![
                row.tool.to_owned(),
                row.version.clone(),
                count(row.vectors),
                count(row.mismatches),
                format!("{:.1}", row.seconds),
                verdict(&row.verdict),
            ]
        })
        .collect();
    let headings = ["tool", "version", ">vectors", ">mismatches", ">seconds", "verdict"];
    text.push_str(&text::table(&headings, &cells));
    for row in rows {
        if let Verdict::Disagrees(Some(mismatch)) = &row.verdict {
            text.push_str(&told_mismatch(row.tool, mismatch));
        }
    }
    text
}

fn word(word: &Decoded) -> String {
    match (word.raw, word.value) {
        (Some(raw), Some(value)) => format!("{} (word {raw}, value {value})", word.pattern),
        (Some(_) | None, _) => word.pattern.clone(),
    }
}

fn told_mismatch(tool: &str, mismatch: &Mismatch) -> String {
    let mut text = format!("\nfirst mismatch in {tool}: vector {}\n", mismatch.vector);
    for input in &mismatch.inputs {
        let _ = writeln!(text, "  {} = {}", input.port, word(input));
    }
    let _ = writeln!(text, "  {} should be {}", mismatch.port, word(&mismatch.expected));
    let _ = writeln!(text, "  {} is        {}", mismatch.port, word(&mismatch.got));
    text
}

fn json_of(design: &Design, rows: &[Row]) -> Value {
    json::document(
        "verify",
        json!({
            "unit": design.values.unit().name,
            "parameters": text::parameters(&design.values),
            "rows": rows,
        }),
    )
}
