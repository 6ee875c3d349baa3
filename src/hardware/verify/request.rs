//! What to verify, and with which tools.

use crate::base::error::{Error, Result};
use crate::base::outside::{self, Tool};
use crate::design::Design;
use crate::hardware::emit::Package;
use crate::hardware::emit::vectors::Vectors;
use crate::hardware::hdl::{Memories, Tables};
use std::path::{Path, PathBuf};
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
    /// Where memories are.
    pub memories: Memories,
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
    /// The vectors that a tool gets.
    pub(super) fn vectors(&self, random: u64) -> Vectors {
        Vectors::new(self.design, usize::MAX, random, self.request.seed)
    }
}
