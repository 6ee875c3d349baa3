//! Agreement with outside simulators: the emitted hardware runs in them on the batch engine's
//! vectors, and every bit of every output and the latency have to agree.

mod simulators;

pub use simulators::Proof;

use crate::base::error::{Error, Result};
use crate::base::output::{Scratch, Set, copy_folder};
use crate::base::outside::{self, Tool};
use crate::design::Design;
use crate::hardware::emit::vectors::Vectors;
use crate::hardware::emit::{Package, Settings};
use crate::hardware::hdl::Tables;
use crate::netlist::Netlist;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Random vectors for a slow simulator.
pub const SLOW_VECTORS: u64 = 10_000;
/// Random vectors for a fast one.
pub const FAST_VECTORS: u64 = 1_000_000;

/// An outside tool that hardware is checked with.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Simulator {
    /// Icarus Verilog runs the Verilog testbench.
    Icarus,
    /// Verilator builds the Verilog with a C++ harness.
    Verilator,
    /// GHDL runs the VHDL testbench.
    Ghdl,
    /// Yosys elaborates and checks the Verilog, and proves the pipeline equal to its
    /// combinational reference at small widths.
    Yosys,
}

impl Simulator {
    /// Every one.
    pub const ALL: &'static [Self] = &[Self::Icarus, Self::Verilator, Self::Ghdl, Self::Yosys];

    /// Name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.tools()[0].name
    }

    /// The tools that it takes, itself first.
    #[must_use]
    pub fn tools(self) -> &'static [&'static Tool] {
        match self {
            Self::Icarus => &[&outside::ICARUS, &outside::VVP],
            Self::Verilator => &[&outside::VERILATOR, &outside::MAKE, &outside::CXX],
            Self::Ghdl => &[&outside::GHDL],
            Self::Yosys => &[&outside::YOSYS],
        }
    }

    /// Its version.
    ///
    /// # Errors
    /// If one of its tools isn't there: what brings it.
    pub fn version(self) -> std::result::Result<String, String> {
        let mut versions = Vec::new();
        for tool in self.tools() {
            let missing = || format!("{} is {}", tool.name, tool.missing());
            versions.push(tool.version().ok_or_else(missing)?);
        }
        Ok(versions.swap_remove(0))
    }

    /// Random vectors if no number was asked for.
    #[must_use]
    pub fn default_vectors(self) -> u64 {
        match self {
            Self::Verilator => FAST_VECTORS,
            Self::Icarus | Self::Ghdl => SLOW_VECTORS,
            Self::Yosys => 0,
        }
    }
}

/// What to verify.
#[derive(Clone, Debug)]
pub struct Request {
    /// With which tools.
    pub simulators: Vec<Simulator>,
    /// Random vectors after the hard-case list, for all; each tool's own number if `None`.
    pub vectors: Option<u64>,
    /// Their seed.
    pub seed: u64,
    /// Where tables stand; by their number if `None`.
    pub tables: Option<Tables>,
    /// Longest run of a tool.
    pub limit: Duration,
    /// Largest memory of each process of a tool, in bytes.
    pub memory_bytes: u64,
    /// Longest proof of Yosys's at one of the widths that it tries, within that; none is tried at 0.
    pub proof_limit: Duration,
    /// Folder to keep the files in; a scratch folder if `None`.
    pub keep: Option<PathBuf>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            simulators: Simulator::ALL.to_vec(),
            vectors: None,
            seed: 1,
            tables: None,
            limit: Duration::from_secs(600),
            memory_bytes: outside::default_memory_bytes(),
            proof_limit: Duration::from_secs(60),
            keep: None,
        }
    }
}

/// A word that came out wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mismatch {
    /// Number of the vector, from 0: the hard cases come first.
    pub vector: u64,
    /// Input words by port.
    pub inputs: Vec<Decoded>,
    /// Output port, or `valid_out`.
    pub port: String,
    /// What should have come out.
    pub expected: Decoded,
    /// What did.
    pub got: Decoded,
}

/// A word of a port.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Decoded {
    /// The port.
    pub port: String,
    /// The pattern in hexadecimal, as the simulator has it; unknown bits are x.
    pub pattern: String,
    /// The word; `None` if bits of it are unknown.
    pub raw: Option<i64>,
    /// Its value.
    pub value: Option<f64>,
}

/// How a tool's run ended.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// All agrees; what was done, where that isn't plain.
    Agrees(String),
    /// No fault was found, and what was to be proved is not: why.
    Unproved(String),
    /// Words differ; the first of them, if one was named.
    Disagrees(Option<Box<Mismatch>>),
    /// It refused the hardware, or warned: what it said.
    Failed(String),
    /// It ran past the limit of time.
    TimedOut(String),
    /// It ran past the limit of memory, or the machine has too little.
    OutOfMemory(String),
    /// It could not be started, was killed, or had no room for its files: that says nothing of the
    /// hardware.
    Unusable(String),
    /// It isn't there, and what brings it.
    Missing(String),
}

/// What a tool found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The tool.
    pub tool: &'static str,
    /// Its version; empty if it isn't there.
    pub version: String,
    /// Vectors compared.
    pub vectors: u64,
    /// Words that differed.
    pub mismatches: u64,
    /// Time that it took, with building.
    pub seconds: f64,
    /// How it ended.
    pub verdict: Verdict,
}

impl Row {
    /// True if the tool ran and agreed.
    #[must_use]
    pub fn agrees(&self) -> bool {
        matches!(self.verdict, Verdict::Agrees(_))
    }

    /// True if the tool could not finish, which says nothing of the hardware.
    #[must_use]
    pub fn is_unfinished(&self) -> bool {
        matches!(
            self.verdict,
            Verdict::TimedOut(_) | Verdict::OutOfMemory(_) | Verdict::Unusable(_)
        )
    }

    /// True if the tool found no fault, and not the proof that it looked for.
    #[must_use]
    pub fn is_unproved(&self) -> bool {
        matches!(self.verdict, Verdict::Unproved(_))
    }

    /// True if the tool isn't there.
    #[must_use]
    pub fn is_missing(&self) -> bool {
        matches!(self.verdict, Verdict::Missing(_))
    }
}

/// Runs a design's hardware in outside simulators, all at once; `progress` gets each row as it
/// is there. Rows are in the order asked for.
///
/// # Errors
/// If the hardware can't be made, or files can't be written.
///
/// # Panics
/// If a simulator's thread did.
pub fn verify(design: &Design, request: &Request, progress: &dyn Fn(&Row)) -> Result<Vec<Row>> {
    let scratch = Scratch::new()?;
    let folder = scratch.path();
    let settings = Settings {
        tables: request.tables,
        random: request.vectors.unwrap_or(SLOW_VECTORS),
        seed: request.seed,
        figures: false,
        ..Settings::default()
    };
    let mut package = Package::new(design, &settings)?;
    // Before long work: files that are kept can be written, in place of what `hdl` wrote of this name.
    let set = package.set_name();
    let kept = request.keep.as_deref().map(|keep| Set::open(keep, &set)).transpose()?;
    package.write_texts(folder, folder)?;
    let reads_file = |simulator: &Simulator| match simulator {
        Simulator::Icarus | Simulator::Ghdl => true,
        // It gets them through a pipe; a proof takes none.
        Simulator::Verilator | Simulator::Yosys => false,
    };
    if request.keep.is_some() || request.simulators.iter().any(reads_file) {
        package.write_vectors(folder)?;
    }
    let job = Job { design, request, package: &package, folder };
    let mut rows: Vec<(usize, Row)> = Vec::new();
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for (at, simulator) in request.simulators.iter().enumerate() {
            let (sender, job) = (sender.clone(), &job);
            let again = sender.clone();
            let started = outside::new_thread().spawn_scoped(scope, move || {
                let row = simulators::run(job, *simulator);
                sender.send((at, row)).expect("bug: the receiver takes all rows");
            });
            if let Err(why) = started {
                let row = simulators::unusable(*simulator, outside::no_thread(&why));
                again.send((at, row)).expect("bug: the receiver takes all rows");
            }
        }
        drop(sender);
        for (at, row) in receiver {
            progress(&row);
            rows.push((at, row));
        }
    });
    if let Some(kept) = kept {
        copy_folder(folder, &kept.path())?;
        kept.commit()?;
    }
    assert_eq!(rows.len(), request.simulators.len(), "bug: one row a simulator");
    rows.sort_by_key(|(at, _)| *at);
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}

/// What the runs of all tools share.
struct Job<'a> {
    design: &'a Design,
    request: &'a Request,
    package: &'a Package,
    folder: &'a Path,
}

impl Job<'_> {
    /// The vectors that a tool gets.
    fn vectors(&self, random: u64) -> Vectors {
        Vectors::new(self.design, usize::MAX, random, self.request.seed)
    }
}

/// A port's word from its pattern as a simulator prints it.
fn decoded(netlist: &Netlist, node: crate::netlist::NodeId, port: &str, pattern: &str) -> Decoded {
    let format = netlist.node(node).format;
    let bits = u64::from_str_radix(pattern, 16).ok();
    let raw = bits.map(|bits| format.wrap(crate::base::cast::word_of_bits(bits & (u64::MAX >> 1))));
    Decoded {
        port: port.to_owned(),
        pattern: pattern.to_owned(),
        raw,
        value: raw.map(|raw| format.value(raw)),
    }
}

/// The mismatch that a line of a testbench tells, with its inputs.
fn mismatch(job: &Job<'_>, line: &str, vectors: Vectors) -> Option<Mismatch> {
    let netlist = &job.design.netlist;
    let mut words = line.strip_prefix("mismatch: vector ")?.split_whitespace();
    let number = words.next()?.parse().ok()?;
    let port = words.next()?.to_owned();
    let (expected, got) = match (words.next()?, words.next()?, words.next()?, words.next()?) {
        ("expected", expected, "got", got) => (expected, got),
        _ => return None,
    };
    let output = netlist
        .outputs()
        .iter()
        .zip(&job.package.module.outputs)
        .find(|(_, (name, _))| *name == port);
    let word = |pattern: &str| match output {
        Some((output, _)) => decoded(netlist, output.node, &port, pattern),
        None => Decoded {
            port: port.clone(),
            pattern: pattern.to_owned(),
            raw: pattern.parse().ok(),
            value: None,
        },
    };
    let (inputs, _) = vectors.vector(number)?;
    let inputs = inputs.iter().zip(netlist.inputs()).enumerate().map(|(at, (raw, id))| {
        let format = netlist.node(*id).format;
        let pattern = format!("{:x}", format.pattern(*raw));
        decoded(netlist, *id, netlist.input_name(at), &pattern)
    });
    Some(Mismatch {
        vector: number,
        inputs: inputs.collect(),
        expected: word(expected),
        got: word(got),
        port,
    })
}

/// The simulators of these names.
///
/// # Errors
/// If there is none of a name.
pub fn simulators_of(names: &[String]) -> Result<Vec<Simulator>> {
    let mut found = Vec::new();
    for name in names {
        let known = Simulator::ALL.iter().find(|simulator| simulator.name() == name);
        let Some(simulator) = known else {
            let all: Vec<&str> = Simulator::ALL.iter().map(|s| s.name()).collect();
            return Err(Error::usage(format!(
                "no simulator `{name}`: legal is {}",
                all.join(", ")
            )));
        };
        if !found.contains(simulator) {
            found.push(*simulator);
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Unit;

    #[test]
    fn a_tool_without_a_thread_is_unfinished() {
        let design = Unit::find("dot").unwrap().defaults().build().unwrap();
        let request =
            Request { simulators: Simulator::ALL.to_vec(), vectors: Some(1), ..Request::default() };
        outside::NO_THREADS.set(true);
        let rows = verify(&design, &request, &|_| ());
        outside::NO_THREADS.set(false);
        let rows = rows.unwrap();
        assert_eq!(rows.len(), Simulator::ALL.len());
        for row in rows {
            assert!(row.is_unfinished(), "{row:?}");
            let Verdict::Unusable(why) = row.verdict else { panic!("{}: it ran", row.tool) };
            assert!(why.starts_with("can't start a thread: "), "{why}");
        }
    }
}
