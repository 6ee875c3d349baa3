//! What to verify, and with which tools.

use crate::base::error::{Error, Result};
use crate::base::outside::{self, Tool};
use crate::design::Design;
use crate::hardware::emit::Package;
use crate::hardware::emit::vectors::Vectors;
use crate::hardware::hdl::{Memories, Tables};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Random vectors for a slow simulator, by default.
pub const SLOW_VECTORS: u64 = 10_000;
/// Random vectors for a fast simulator, by default.
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
    /// All simulators.
    pub const ALL: &'static [Self] = &[Self::Icarus, Self::Verilator, Self::Ghdl, Self::Yosys];

    /// Name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.tools()[0].name
    }

    /// The tools that it needs, itself first.
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
    /// If one of its tools isn't installed: how to install it.
    pub fn version(self) -> std::result::Result<String, String> {
        let mut versions = Vec::new();
        for tool in self.tools() {
            let missing = || format!("{} is {}", tool.name, tool.missing());
            versions.push(tool.version().ok_or_else(missing)?);
        }
        Ok(versions.swap_remove(0))
    }

    /// Number of random vectors if none was requested.
    #[must_use]
    pub fn default_vectors(self) -> u64 {
        match self {
            Self::Verilator => FAST_VECTORS,
            Self::Icarus | Self::Ghdl => SLOW_VECTORS,
            Self::Yosys => 0,
        }
    }
}

/// The simulators with these names.
///
/// # Errors
/// If a name is unknown.
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

/// What to verify.
#[derive(Clone, Debug)]
pub struct Request {
    /// The tools to run.
    pub simulators: Vec<Simulator>,
    /// Random vectors after the hard cases, for all tools; each tool's default if `None`.
    pub vectors: Option<u64>,
    /// Seed of the random vectors.
    pub seed: u64,
    /// Where table words are placed; chosen by their number if `None`.
    pub tables: Option<Tables>,
    /// Where memories are placed.
    pub memories: Memories,
    /// Time limit of each tool.
    pub limit: Duration,
    /// Memory limit of each process of a tool, in bytes.
    pub memory_bytes: u64,
    /// Time limit of Yosys's proof at each of the widths that it tries, capped by `limit`; at 0
    /// none is tried.
    pub proof_limit: Duration,
    /// Folder in which the files are kept; a scratch folder if `None`.
    pub keep: Option<PathBuf>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            simulators: Simulator::ALL.to_vec(),
            vectors: None,
            seed: 1,
            tables: None,
            memories: Memories::default(),
            limit: Duration::from_secs(600),
            memory_bytes: outside::default_memory_bytes(),
            proof_limit: Duration::from_secs(60),
            keep: None,
        }
    }
}

/// What the runs of all tools share.
pub(super) struct Job<'a> {
    pub(super) design: &'a Design,
    pub(super) request: &'a Request,
    pub(super) package: &'a Package,
    pub(super) folder: &'a Path,
}

impl Job<'_> {
    /// The vectors for a tool.
    pub(super) fn vectors(&self, random: u64) -> Vectors {
        Vectors::new(self.design, usize::MAX, random, self.request.seed)
    }
}
