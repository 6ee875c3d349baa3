//! How each tool is run, and how its output is judged.

use super::mismatch::mismatch;
use super::request::{Job, Simulator};
use super::row::{Row, Verdict};
use crate::base::error::{Error, Result};
use crate::base::output::{Scratch, write_text};
use crate::base::outside::{self, End, Limits, Outcome};
use crate::design::{Design, Kind, Role, Value};
use crate::hardware::emit::vectors::Vectors;
use crate::hardware::hdl::proof;
use crate::hardware::hdl::testbench::{reference_name, top_name};
use crate::hardware::hdl::{File, Module, Options, Tables, Verilog};
use crate::hardware::rtl::Rtl;
use crate::schedule::{Depth, Rom, Schedule};
use std::io::Write;
use std::sync::Arc;
use std::time::Instant;

/// Widths of Yosys's proofs: the larger one first; the smaller one if that takes too long.
const PROOF_BITS: [i64; 2] = [4, 3];
/// Iterations in these proofs.
const PROOF_ITERATIONS: i64 = 3;

/// The row of a tool that hasn't run.
fn row(simulator: Simulator, verdict: Verdict) -> Row {
    let (vectors, mismatches, seconds) = (0, 0, 0.0);
    Row { tool: simulator.name(), version: String::new(), vectors, mismatches, seconds, verdict }
}

/// The row of a tool that can't be run here.
pub(super) fn unusable(simulator: Simulator, why: Error) -> Row {
    row(simulator, could_not(why))
}

/// Runs a tool on a job.
pub(super) fn run(job: &Job<'_>, simulator: Simulator) -> Row {
    let mut row = row(simulator, Verdict::Missing(String::new()));
    match simulator.version() {
        Ok(version) => row.version = version,
        Err(missing) => {
            row.verdict = Verdict::Missing(missing);
            return row;
        }
    }
    let start = Instant::now();
    let ended = match simulator {
        Simulator::Icarus => icarus(job, &mut row),
        Simulator::Verilator => verilator(job, &mut row),
        Simulator::Ghdl => ghdl(job, &mut row),
        Simulator::Yosys => yosys(job),
    };
    row.seconds = start.elapsed().as_secs_f64();
    row.verdict = match ended {
        Ok(verdict) | Err(verdict) => verdict,
    };
    row
}

/// A verdict, or in `Err` the verdict that ended the run early.
type Ended<T = Verdict> = std::result::Result<T, Verdict>;

/// An error that keeps a tool from running says nothing about the hardware.
fn could_not(why: Error) -> Verdict {
    Verdict::Unusable(why.to_string())
}

fn limits(job: &Job<'_>) -> Limits {
    Limits { time: job.request.limit, memory_bytes: job.request.memory_bytes }
}

/// Runs one step within the limits.
fn run_step(job: &Job<'_>, program: &str, arguments: &[&str]) -> Ended<Outcome> {
    outside::run(program, arguments, job.folder, limits(job), None).map_err(could_not)
}

/// Runs one step, which must succeed without output on stderr. The makefiles for users aren't used:
/// here each step has its own limit, and its messages are reported.
fn step(job: &Job<'_>, program: &str, arguments: &[&str]) -> Ended<Outcome> {
    let outcome = run_step(job, program, arguments)?;
    if let Some(verdict) = failure(&outcome, program) {
        return Err(verdict);
    }
    silent(&outcome.stderr, program)?;
    Ok(outcome)
}

/// A warning counts as a failure.
fn silent(said: &str, program: &str) -> Ended<()> {
    if said.trim().is_empty() {
        return Ok(());
    }
    Err(Verdict::Failed(format!("{program} warns: {}", first_line(said))))
}

/// Messages of programs that the machine, not their input, stops.
const NO_ROOM: [&str; 4] = [
    "disk quota exceeded",
    "no space left on device",
    "read-only file system",
    "too many open files",
];

/// Statuses of shells for programs that can't be started, for example for lack of a library.
const CANNOT_START: std::ops::RangeInclusive<i32> = 126..=127;

fn failure(outcome: &Outcome, program: &str) -> Option<Verdict> {
    let cut_short = outcome.cut_short(program).unwrap_or_default();
    let status = match outcome.end {
        End::Status(0) => return None,
        End::Status(status) => status,
        End::Signal(_) => return Some(Verdict::Unusable(cut_short)),
        End::OutOfTime => return Some(Verdict::TimedOut(cut_short)),
        End::OutOfMemory => return Some(Verdict::OutOfMemory(cut_short)),
    };
    let said = if outcome.stderr.trim().is_empty() { &outcome.stdout } else { &outcome.stderr };
    let text = format!("{program} ended with status {status}: {}", first_line(said));
    let lower = said.to_lowercase();
    let machine =
        CANNOT_START.contains(&status) || NO_ROOM.iter().any(|words| lower.contains(words));
    Some(if machine { Verdict::Unusable(text) } else { Verdict::Failed(text) })
}

/// The first non-empty line.
fn first_line(text: &str) -> &str {
    text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("(no output)")
}

/// The verdict of a testbench or harness.
fn judged(
    job: &Job<'_>,
    row: &mut Row,
    outcome: &Outcome,
    program: &str,
    vectors: Vectors,
) -> Ended {
    let count = |text: &str| text.parse().unwrap_or(0);
    let is_verdict = |line: &&str| line.starts_with("PASS ") || line.starts_with("FAIL ");
    // GHDL appends a line of its own to a failure.
    let last = outcome.stdout.lines().rev().find(is_verdict).unwrap_or_default();
    match last.split(' ').collect::<Vec<_>>().as_slice() {
        ["PASS", seen, "vectors"] if outcome.success() => {
            row.vectors = count(seen);
            // Any output besides the verdict is a warning.
            let others: Vec<&str> = outcome.stdout.lines().filter(|line| *line != last).collect();
            silent(&(others.join("\n") + &outcome.stderr), program)?;
            let all = vectors.count();
            if row.vectors != all {
                let text = format!("{program} read {} of {all} vectors", row.vectors);
                return Err(Verdict::Failed(text));
            }
            Ok(Verdict::Agrees(String::new()))
        }
        ["FAIL", mismatches, "mismatches", "in", seen, "vectors"] => {
            row.mismatches = count(mismatches);
            row.vectors = count(seen);
            let line = outcome.stdout.lines().find(|line| line.starts_with("mismatch: "));
            Err(match line {
                Some(line) if line.starts_with("mismatch: vector ") => {
                    Verdict::Disagrees(mismatch(job, line, vectors).map(Box::new))
                }
                Some(line) => Verdict::Failed(line.to_owned()),
                None => Verdict::Disagrees(None),
            })
        }
        _ => Err(failure(outcome, program).unwrap_or_else(|| {
            Verdict::Failed(format!("{program} gave no verdict: {}", first_line(&outcome.stdout)))
        })),
    }
}

fn random(job: &Job<'_>, simulator: Simulator) -> u64 {
    job.request.vectors.unwrap_or(simulator.default_vectors())
}

/// The files of a module, and of its bench if it needs one.
fn sources(job: &Job<'_>, extension: &str) -> Vec<String> {
    let module = &job.package.module;
    let bench = module.takes_bench().then(|| top_name(module));
    let names = [module.name.clone()].into_iter().chain(bench);
    names.map(|name| format!("{name}.{extension}")).collect()
}

fn icarus(job: &Job<'_>, row: &mut Row) -> Ended {
    let name = &job.package.module.name;
    let (sources, testbench) = (sources(job, "v"), format!("{name}_tb.v"));
    let program = format!("{name}_tb.vvp");
    let mut arguments = vec!["-g2005", "-Wall", "-o", &program];
    arguments.extend(sources.iter().map(String::as_str));
    arguments.push(&testbench);
    step(job, "iverilog", &arguments)?;
    let outcome = run_step(job, "vvp", &["-n", &program])?;
    judged(job, row, &outcome, "vvp", job.vectors(random(job, Simulator::Icarus)))
}

fn verilator(job: &Job<'_>, row: &mut Row) -> Ended {
    let name = &job.package.module.name;
    let (sources, harness) = (sources(job, "v"), format!("{name}_harness.cpp"));
    let module = top_name(&job.package.module);
    let (objects, makefile) = (format!("obj_{name}"), format!("V{module}.mk"));
    let top = format!("V{module}");
    // Building takes longer than running: use -O1.
    let mut translate = vec!["--cc", "--exe", "-Wall", "--Mdir", &objects, "-CFLAGS", "-O1"];
    if sources.len() > 1 {
        translate.extend(["--top-module", &module]);
    }
    translate.extend(sources.iter().map(String::as_str));
    translate.push(&harness);
    step(job, "verilator", &translate)?;
    // Verilator's makefile would add -Os, which overrides that. Warnings of g++ about Verilator's
    // code don't count.
    let flags = ["OPT_FAST=", "OPT_SLOW=", "OPT_GLOBAL="];
    let make = ["-s", "-C", &objects, "-f", &makefile, &top];
    let built = run_step(job, "make", &[&make[..], &flags[..]].concat())?;
    if let Some(verdict) = failure(&built, "make") {
        return Err(verdict);
    }
    let count = random(job, Simulator::Verilator);
    let program = job.folder.join(&objects).join(&top);
    let mut vectors = job.vectors(count);
    let mut feed = |to: &mut dyn Write| vectors.write(to);
    let program = program.to_string_lossy();
    let outcome =
        outside::run(&program, &[], job.folder, limits(job), Some(&mut feed)).map_err(could_not)?;
    judged(job, row, &outcome, &top, job.vectors(count))
}

fn ghdl(job: &Job<'_>, row: &mut Row) -> Ended {
    let name = &job.package.module.name;
    let (sources, testbench) = (sources(job, "vhd"), format!("{name}_tb.vhd"));
    let top = format!("{name}_tb");
    let mut arguments = vec!["-a", "--std=08"];
    arguments.extend(sources.iter().map(String::as_str));
    arguments.push(&testbench);
    step(job, "ghdl", &arguments)?;
    step(job, "ghdl", &["-e", "--std=08", &top])?;
    let outcome = run_step(job, "ghdl", &["-r", "--std=08", &top])?;
    judged(job, row, &outcome, "ghdl", job.vectors(random(job, Simulator::Ghdl)))
}

fn yosys(job: &Job<'_>) -> Ended {
    let script = format!("{}.ys", job.package.module.name);
    step(job, "yosys", &["-q", &script])?;
    let netlist = &job.design.netlist;
    let why = if netlist.memories().next().is_some() {
        Some("the unit has a memory")
    } else if netlist.rates().len() > 1 {
        Some("the unit has slow rates")
    } else if netlist.first_delay().is_some() {
        Some("the unit has delays")
    } else {
        None
    };
    if let Some(why) = why {
        let text =
            format!("no latch; not proved: {why}, which a combinational reference can't model");
        return Ok(Verdict::Unproved(text));
    }
    let time = job.request.proof_limit.min(job.request.limit);
    let limits = Limits { time, ..limits(job) };
    for proof in Proof::all(job.design).map_err(could_not)? {
        if time.is_zero() {
            break;
        }
        let outcome = proof.run(limits).map_err(could_not)?;
        if matches!(outcome.end, End::OutOfTime | End::OutOfMemory) {
            continue;
        }
        let at = format!("with a latency of {} cycles, at {}", proof.latency, proof.widths);
        if outcome.stderr.contains("proof did fail") {
            let text = format!("the pipeline is NOT equal to its combinational reference {at}");
            return Err(Verdict::Failed(text));
        }
        if let Some(verdict) = failure(&outcome, "yosys") {
            return Err(verdict);
        }
        silent(&outcome.stderr, "yosys")?;
        let text = format!("no latch; proved equal to its combinational reference {at}");
        return Ok(Verdict::Agrees(text));
    }
    Ok(Verdict::Unproved(format!(
        "no latch; not proved equal to its combinational reference: no small widths are legal with the other parameters, or {} s were too short",
        time.as_secs()
    )))
}

/// The design with all widths capped, and a text that lists the changed parameters.
fn small(design: &Design, bits: i64) -> Option<(Design, String)> {
    let mut values = design.values.clone();
    let unit = values.unit().clone();
    let mut names = Vec::new();
    for param in &unit.params {
        let Kind::Int { min, max, .. } = param.kind else { continue };
        let cap = if matches!(param.role, Role::Width | Role::TableSize) {
            bits
        } else if param.role == Role::Iterations {
            PROOF_ITERATIONS
        } else {
            continue;
        };
        let cap = cap.clamp(min, max);
        let large = match values.get(&param.name) {
            Value::Int(given) => *given > cap,
            // `auto` may stand for a large number: iterations are always set.
            Value::Auto => param.role == Role::Iterations,
            Value::Real(_) | Value::Choice(_) => false,
        };
        if large {
            values.set(&param.name, &cap.to_string()).ok()?;
            names.push(format!("{}={cap}", param.name));
        }
    }
    let small = values.build().ok()?;
    // The requested latency may be too short for the hardware.
    small.rtl().ok()?;
    let text = if names.is_empty() { "these widths".to_owned() } else { names.join(" ") };
    Some((small, text))
}

/// A proof by Yosys that a pipeline equals its combinational reference.
#[derive(Debug)]
pub struct Proof {
    /// Its files; the last one is the script.
    pub files: Vec<File>,
    /// Latency of the pipeline in cycles.
    latency: u32,
    /// The widths of the proof.
    widths: String,
}

impl Proof {
    /// The proofs of a design: at larger widths first, then at smaller ones in case those take too
    /// long. Widths that aren't legal with the other parameters are left out.
    ///
    /// # Errors
    /// If the hardware can't be built.
    pub fn all(design: &Design) -> Result<Vec<Self>> {
        let widths = PROOF_BITS.iter().filter_map(|bits| small(design, *bits));
        widths.map(|(design, widths)| Self::new(&design, widths)).collect()
    }

    fn new(design: &Design, widths: String) -> Result<Self> {
        let inline = |name| Options { name, tables: Some(Tables::Inline), ..Options::default() };
        let module = Module::new(&Arc::new(design.rtl()?), &inline(None))?;
        let schedule = Schedule::pipeline(&design.netlist, Rom::Distributed, Depth::Stages(0))?;
        let rtl = Arc::new(Rtl::new(Arc::clone(&design.netlist), schedule));
        let reference = Module::new(&rtl, &inline(Some(reference_name(&module))))?;
        let [comparison, script] = proof(&module);
        let files = vec![module.file(&Verilog), reference.file(&Verilog), comparison, script];
        Ok(Self { files, latency: module.latency, widths })
    }

    fn run(&self, limits: Limits) -> Result<Outcome> {
        let scratch = Scratch::new()?;
        for file in &self.files {
            write_text(&scratch.path().join(&file.name), &file.text)?;
        }
        let script = &self.files.last().expect("bug: a proof has a script").name;
        outside::run("yosys", &["-Q", "-T", script], scratch.path(), limits, None)
    }
}
