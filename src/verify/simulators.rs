//! How each tool is run, and what it says.

use super::{Job, Row, Simulator, Verdict, mismatch};
use crate::emit::vectors::Vectors;
use crate::error::Result;
use crate::hdl::testbench::{proof, reference_name};
use crate::hdl::{Module, Options, Tables, Verilog};
use crate::output::{Scratch, write_text};
use crate::outside::{self, Outcome};
use crate::rtl::Rtl;
use crate::schedule::{Depth, Rom, Schedule};
use crate::units::{Design, Kind, Value};
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Widths at which Yosys proves: larger ones first, smaller ones where those take too long.
const PROOF_BITS: [i64; 2] = [4, 3];
/// Longest proof at one of them.
const PROOF_LIMIT: Duration = Duration::from_secs(60);
/// Iterations at which it proves.
const PROOF_ITERATIONS: i64 = 3;

/// Runs a tool on a job.
pub(super) fn run(job: &Job<'_>, simulator: Simulator) -> Result<Row> {
    let mut row = Row {
        tool: simulator.name(),
        version: String::new(),
        vectors: 0,
        mismatches: 0,
        seconds: 0.0,
        verdict: Verdict::Missing(String::new()),
    };
    for tool in simulator.tools() {
        match tool.version() {
            None => {
                row.verdict = Verdict::Missing(tool.missing());
                return Ok(row);
            }
            Some(version) if row.version.is_empty() => row.version = version,
            Some(_) => {}
        }
    }
    let start = Instant::now();
    let ended = match simulator {
        Simulator::Icarus => icarus(job, &mut row)?,
        Simulator::Verilator => verilator(job, &mut row)?,
        Simulator::Ghdl => ghdl(job, &mut row)?,
        Simulator::Yosys => yosys(job)?,
    };
    row.seconds = start.elapsed().as_secs_f64();
    row.verdict = match ended {
        Ok(verdict) | Err(verdict) => verdict,
    };
    Ok(row)
}

/// A verdict, or the one that ended the run before its time.
type Ended = Result<std::result::Result<Verdict, Verdict>>;

/// Runs one step, which has to end well and in silence.
fn step(
    job: &Job<'_>,
    folder: &Path,
    program: &str,
    arguments: &[&str],
) -> Result<std::result::Result<Outcome, Verdict>> {
    let outcome = outside::run(program, arguments, folder, job.request.limit, None)?;
    Ok(match failure(&outcome, program) {
        Some(verdict) => Err(verdict),
        None if outcome.stderr.trim().is_empty() => Ok(outcome),
        None => Err(Verdict::Failed(format!("{program} warns: {}", first_line(&outcome.stderr)))),
    })
}

fn failure(outcome: &Outcome, program: &str) -> Option<Verdict> {
    if outcome.timed_out {
        let text = format!("{program} ran past the limit of {:.0} s", outcome.seconds);
        return Some(Verdict::TimedOut(text));
    }
    if outcome.success() {
        return None;
    }
    let said = if outcome.stderr.trim().is_empty() { &outcome.stdout } else { &outcome.stderr };
    let how = match outcome.status {
        Some(status) => format!("status {status}"),
        None => "a signal".to_owned(),
    };
    Some(Verdict::Failed(format!("{program} ended with {how}: {}", first_line(said))))
}

/// The first line that says something.
fn first_line(text: &str) -> &str {
    text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("(it said nothing)")
}

/// What a testbench or harness told.
fn judged(
    job: &Job<'_>,
    row: &mut Row,
    outcome: &Outcome,
    program: &str,
    vectors: Vectors,
) -> Verdict {
    let count = |text: Option<&str>| text.and_then(|text| text.parse().ok());
    // GHDL adds a line of its own.
    let mut lines = outcome.stdout.lines().rev();
    let last = lines.find(|line| line.starts_with("PASS ") || line.starts_with("FAIL "));
    let last: Vec<&str> = last.unwrap_or_default().split(' ').collect();
    match last.as_slice() {
        ["PASS", vectors_seen, "vectors"] if outcome.success() => {
            row.vectors = count(Some(vectors_seen)).unwrap_or(0);
            if row.vectors == vectors.count() {
                Verdict::Agrees(String::new())
            } else {
                let all = vectors.count();
                Verdict::Failed(format!("{program} took {} of {all} vectors", row.vectors))
            }
        }
        ["FAIL", mismatches, "mismatches", "in", vectors_seen, "vectors"] => {
            row.mismatches = count(Some(mismatches)).unwrap_or(0);
            row.vectors = count(Some(vectors_seen)).unwrap_or(0);
            let line = outcome.stdout.lines().find(|line| line.starts_with("mismatch: "));
            match line {
                Some(line) if line.starts_with("mismatch: vector ") => {
                    Verdict::Disagrees(mismatch(job, line, vectors).map(Box::new))
                }
                Some(line) => Verdict::Failed(line.to_owned()),
                None => Verdict::Disagrees(None),
            }
        }
        _ => failure(outcome, program).unwrap_or_else(|| {
            Verdict::Failed(format!("{program} gave no verdict: {}", first_line(&outcome.stdout)))
        }),
    }
}

/// Unwraps a step, or ends the run with its verdict.
macro_rules! ended {
    ($step:expr) => {
        match $step? {
            Ok(outcome) => outcome,
            Err(verdict) => return Ok(Err(verdict)),
        }
    };
}

fn random(job: &Job<'_>, simulator: Simulator) -> u64 {
    job.request.vectors.unwrap_or(simulator.default_vectors())
}

fn icarus(job: &Job<'_>, row: &mut Row) -> Ended {
    let name = &job.package.module.name;
    let (module, testbench) = (format!("{name}.v"), format!("{name}_tb.v"));
    let program = format!("{name}_tb.vvp");
    let arguments = ["-g2005", "-Wall", "-o", &program, &module, &testbench];
    ended!(step(job, job.folder, "iverilog", &arguments));
    let outcome = outside::run("vvp", &["-n", &program], job.folder, job.request.limit, None)?;
    let vectors = job.vectors(random(job, Simulator::Icarus));
    Ok(Ok(judged(job, row, &outcome, "vvp", vectors)))
}

fn verilator(job: &Job<'_>, row: &mut Row) -> Ended {
    let name = &job.package.module.name;
    let (module, harness) = (format!("{name}.v"), format!("{name}_harness.cpp"));
    let (objects, makefile) = (format!("obj_{name}"), format!("V{name}.mk"));
    let top = format!("V{name}");
    ended!(step(
        job,
        job.folder,
        "verilator",
        &["--cc", "--exe", "-Wall", "--Mdir", &objects, "-CFLAGS", "-O1", &module, &harness],
    ));
    // What it would add, -Os, undoes ours.
    let flags = ["OPT_FAST=", "OPT_SLOW=", "OPT_GLOBAL="];
    let arguments = ["-s", "-C", &objects, "-f", &makefile, &top, flags[0], flags[1], flags[2]];
    let built = outside::run("make", &arguments, job.folder, job.request.limit, None)?;
    if let Some(verdict) = failure(&built, "make") {
        return Ok(Err(verdict));
    }
    let mut vectors = job.vectors(random(job, Simulator::Verilator));
    let program = job.folder.join(&objects).join(&top);
    let program = program.to_string_lossy().into_owned();
    let mut feed = |to: &mut dyn Write| vectors.write(to);
    let outcome = outside::run(&program, &[], job.folder, job.request.limit, Some(&mut feed))?;
    let vectors = job.vectors(random(job, Simulator::Verilator));
    Ok(Ok(judged(job, row, &outcome, &top, vectors)))
}

fn ghdl(job: &Job<'_>, row: &mut Row) -> Ended {
    let name = &job.package.module.name;
    let (module, testbench) = (format!("{name}.vhd"), format!("{name}_tb.vhd"));
    let top = format!("{name}_tb");
    ended!(step(job, job.folder, "ghdl", &["-a", "--std=08", &module, &testbench]));
    ended!(step(job, job.folder, "ghdl", &["-e", "--std=08", &top]));
    let arguments = ["-r", "--std=08", &top];
    let outcome = outside::run("ghdl", &arguments, job.folder, job.request.limit, None)?;
    let vectors = job.vectors(random(job, Simulator::Ghdl));
    let verdict = judged(job, row, &outcome, "ghdl", vectors);
    if matches!(verdict, Verdict::Agrees(_)) && outcome.stdout.trim().lines().count() > 1 {
        let warning = first_line(&outcome.stdout);
        return Ok(Err(Verdict::Failed(format!("ghdl warns: {warning}"))));
    }
    Ok(Ok(verdict))
}

fn yosys(job: &Job<'_>) -> Ended {
    let script = format!("{}.ys", job.package.module.name);
    ended!(step(job, job.folder, "yosys", &["-q", &script]));
    for bits in PROOF_BITS {
        let Some((design, shrunk)) = small(job.design, bits) else { continue };
        let outcome = prove(job, &design)?;
        if outcome.timed_out {
            continue;
        }
        if let Some(verdict) = failure(&outcome, "yosys") {
            if outcome.stdout.contains("model found: FAIL") {
                let text =
                    format!("the pipeline is NOT equal to its combinational reference at {shrunk}");
                return Ok(Err(Verdict::Failed(text)));
            }
            return Ok(Err(verdict));
        }
        let text = format!("no latch; proved equal to its combinational reference at {shrunk}");
        return Ok(Ok(Verdict::Agrees(text)));
    }
    let seconds = PROOF_LIMIT.as_secs();
    let text = format!(
        "no latch; not proved equal to its combinational reference: no small widths are legal with the other parameters, or {seconds} s are too short"
    );
    Ok(Ok(Verdict::Agrees(text)))
}

/// The design with every width capped, and what that makes of its parameters.
fn small(design: &Design, bits: i64) -> Option<(Design, String)> {
    let mut values = design.values.clone();
    let unit = values.unit();
    let mut names = Vec::new();
    for param in unit.params {
        let Kind::Int { min, max, .. } = param.kind else { continue };
        let cap = if param.name.ends_with("_bits") {
            bits
        } else if param.name.ends_with("_iterations") {
            PROOF_ITERATIONS
        } else {
            continue;
        };
        let cap = cap.clamp(min, max);
        let large = match values.get(param.name) {
            Value::Int(given) => given > cap,
            // What `auto` stands for may be large: a count of steps is set.
            Value::Auto => param.name.ends_with("_iterations"),
            Value::Choice(_) => false,
        };
        if large {
            values.set(param.name, &cap.to_string()).ok()?;
            names.push(format!("{}={cap}", param.name));
        }
    }
    let small = values.build().ok()?;
    // A latency that was asked for may be too short or too long for nothing that is built.
    small.rtl().ok()?;
    let text = if names.is_empty() { "these widths".to_owned() } else { names.join(" ") };
    Some((small, text))
}

/// Runs Yosys's proof for a design.
fn prove(job: &Job<'_>, design: &Design) -> Result<Outcome> {
    let scratch = Scratch::new()?;
    let module = Module::new(
        &Arc::new(design.rtl()?),
        &Options { tables: Some(Tables::Inline), ..Options::default() },
    )?;
    let schedule = Schedule::pipeline(&design.netlist, Rom::Distributed, Depth::Stages(0))?;
    let rtl = Arc::new(Rtl::new(Arc::clone(&design.netlist), schedule));
    let reference = Options {
        name: Some(reference_name(&module)),
        tables: Some(Tables::Inline),
        ..Options::default()
    };
    let mut files = vec![module.file(&Verilog), Module::new(&rtl, &reference)?.file(&Verilog)];
    let [comparison, script] = proof(&module);
    let script_name = script.name.clone();
    files.extend([comparison, script]);
    for file in files {
        write_text(&scratch.path().join(file.name), &file.text)?;
    }
    let limit = PROOF_LIMIT.min(job.request.limit);
    outside::run("yosys", &["-Q", "-T", &script_name], scratch.path(), limit, None)
}
