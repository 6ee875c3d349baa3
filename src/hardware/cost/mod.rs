//! Cost of a unit on an FPGA: LUTs, flip-flops, block RAMs and DSPs.
//!
//! [`synthesize`] runs Yosys, [`route`] runs nextpnr for the clock, and [`estimate()`] gives an
//! estimate without tools. [`DEVIATIONS`] lists how far the estimate is from Yosys over the
//! settings that it was fitted to.
//!
//! # What is counted
//!
//! | | iCE40 (`synth_ice40 -dsp`) | ECP5 (`synth_ecp5`) | Xilinx 7 (`synth_xilinx`) |
//! |---|---|---|---|
//! | LUTs | `SB_LUT4` | `LUT4`, and two for each `CCU2C`, which takes the place of two | `LUT1` to `LUT6`, `INV`; `SRL16E` and `SRLC32E` too, which are LUTs as delays |
//! | flip-flops | `SB_DFF…` | `TRELLIS_FF` | `FD…` |
//! | block RAMs | `SB_RAM40_4K` (4 Kbit) | `DP16KD` (18 Kbit) | `RAMB18E1` (18 Kbit), and two for each `RAMB36E1` |
//! | DSPs | `SB_MAC16` (16×16) | `MULT18X18D` (18×18) | `DSP48E1` (25×18) |
//!
//! Carries (`SB_CARRY`) share the cells of their LUTs. Wide multiplexers (`PFUMX`, `L6MUX21`,
//! `MUXF7`, `MUXF8`) and `CARRY4` lie beside the LUTs: they aren't counted as LUTs and appear only
//! among the cells. Input, output and clock buffers aren't part of the unit.

mod estimate;

pub use estimate::{estimate, of_module};

use crate::base::error::{Error, Result};
use crate::base::output::{Scratch, write_text};
use crate::base::outside::{self, Limits, Outcome, Tool};
use crate::hardware::hdl::{Module, Port, Verilog};
use estimate::{Adds, Dsp, Rules, Sum};
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

/// A family of FPGAs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Target {
    /// Lattice iCE40.
    Ice40,
    /// Lattice ECP5.
    Ecp5,
    /// Xilinx 7 series.
    Xilinx,
}

impl Target {
    /// Names on the command line.
    pub const ALL: &'static [(Self, &'static str)] =
        &[(Self::Ice40, "ice40"), (Self::Ecp5, "ecp5"), (Self::Xilinx, "xilinx")];

    /// Name on the command line.
    ///
    /// # Panics
    /// Never: every target is listed.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(known, _)| *known == self).expect("bug: every target is listed").1
    }

    /// The Yosys command.
    #[must_use]
    pub fn command(self) -> &'static str {
        match self {
            Self::Ice40 => "synth_ice40 -dsp",
            Self::Ecp5 => "synth_ecp5",
            Self::Xilinx => "synth_xilinx",
        }
    }

    /// Block RAMs for one read port of a table.
    #[must_use]
    pub fn block_rams(self, addr_bits: u32, columns: u32) -> u64 {
        estimate::block_rams(self.rules().ram, addr_bits, columns)
    }

    fn rules(self) -> Rules {
        const EIGHTEEN: &[(u32, u32)] = &[(10, 18), (11, 9), (12, 4), (13, 2), (14, 1)];
        match self {
            Self::Ice40 => Rules {
                inputs: 4,
                inverters: true,
                sum: Sum::Used,
                shift_levels: 1,
                rom_share: 0.27,
                ram: &[(8, 16), (9, 8), (10, 4), (11, 2)],
                ram_ports: 1,
                lone_ram: &[],
                dsp: Dsp {
                    long_bits: 16,
                    short_bits: 16,
                    part_bits: 16,
                    signed_only: false,
                    least_bits: 11,
                    registers: 1,
                    adds: Adds::Rows,
                },
                shift_registers: None,
            },
            Self::Ecp5 => Rules {
                inputs: 4,
                inverters: false,
                sum: Sum::Pairs,
                shift_levels: 1,
                rom_share: 0.26,
                ram: EIGHTEEN,
                ram_ports: 2,
                lone_ram: &[(9, 36)],
                dsp: Dsp {
                    long_bits: 18,
                    short_bits: 18,
                    part_bits: 18,
                    signed_only: false,
                    least_bits: 4,
                    registers: 0,
                    adds: Adds::None,
                },
                shift_registers: None,
            },
            Self::Xilinx => Rules {
                inputs: 6,
                inverters: false,
                sum: Sum::Two,
                shift_levels: 2,
                rom_share: 0.75,
                ram: EIGHTEEN,
                ram_ports: 2,
                lone_ram: &[(9, 36)],
                dsp: Dsp {
                    long_bits: 25,
                    short_bits: 18,
                    part_bits: 18,
                    signed_only: true,
                    least_bits: 9,
                    registers: 2,
                    adds: Adds::All,
                },
                shift_registers: Some(3),
            },
        }
    }
}

/// Resources of a unit; the module's documentation defines what is counted.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Cost {
    /// Look-up tables.
    pub luts: u64,
    /// Flip-flops.
    pub flip_flops: u64,
    /// Block RAMs.
    pub block_rams: u64,
    /// Multipliers.
    pub dsps: u64,
}

impl Cost {
    /// Headings of [`Cost::columns`].
    pub const COLUMNS: [&'static str; 4] = ["LUTs", "flip-flops", "block RAMs", "DSPs"];

    /// Its figures in the order of [`Cost::COLUMNS`].
    #[must_use]
    pub fn columns(self) -> [u64; 4] {
        [self.luts, self.flip_flops, self.block_rams, self.dsps]
    }

    /// Counts cells by their types.
    #[must_use]
    pub fn of_cells(cells: &BTreeMap<String, u64>) -> Self {
        let mut cost = Self::default();
        for (cell, count) in cells {
            match cell.as_str() {
                "SB_LUT4" | "LUT1" | "LUT2" | "LUT3" | "LUT4" | "LUT5" | "LUT6" | "INV"
                | "SRL16E" | "SRLC32E" => cost.luts += count,
                "CCU2C" => cost.luts += 2 * count,
                "TRELLIS_FF" => cost.flip_flops += count,
                "SB_RAM40_4K" | "DP16KD" | "RAMB18E1" => cost.block_rams += count,
                "RAMB36E1" => cost.block_rams += 2 * count,
                "SB_MAC16" | "MULT18X18D" | "DSP48E1" => cost.dsps += count,
                cell if cell.starts_with("SB_DFF") || cell.starts_with("FD") => {
                    cost.flip_flops += count;
                }
                _ => {}
            }
        }
        cost
    }
}

/// Largest deviation of [`estimate()`] from Yosys 0.23, in %, in the order of [`Cost::COLUMNS`],
/// over the [`DEVIATIONS_SETTINGS`] committed flat settings of the rotation unit. The rules were
/// fitted to these settings; other settings can deviate more. A test measures the deviations again.
pub const DEVIATIONS: &[(Target, [u32; 4])] = &[
    (Target::Ice40, [10, 2, 0, 0]),
    (Target::Ecp5, [12, 3, 0, 0]),
    (Target::Xilinx, [20, 21, 0, 0]),
];

/// Number of settings behind [`DEVIATIONS`].
pub const DEVIATIONS_SETTINGS: usize = 5;

/// The Yosys version behind [`DEVIATIONS`].
pub const DEVIATIONS_YOSYS: &str = "0.23";

/// Yosys's result for a unit.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Synthesis {
    /// The figures.
    #[serde(flatten)]
    pub cost: Cost,
    /// All cells by their types.
    pub cells: BTreeMap<String, u64>,
}

/// nextpnr's result for a unit.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Clock {
    /// The highest clock between registers, in MHz.
    Reached {
        /// The device.
        device: &'static str,
        /// The clock.
        mhz: f64,
    },
    /// The unit is too large for the device.
    TooLarge {
        /// The device.
        device: &'static str,
        /// The resources that are missing.
        why: String,
    },
    /// The tool was stopped.
    CutShort {
        /// The device.
        device: &'static str,
        /// The limit of time or memory, or the signal, that stopped it.
        why: String,
    },
    /// The tool isn't installed: how to install it.
    Missing(String),
    /// No open tool supports this target.
    Unsupported,
}

/// Runs Yosys on a module.
///
/// # Errors
/// If Yosys isn't installed, fails or runs past a limit, or files can't be written.
pub fn synthesize(module: &Module, target: Target, limits: Limits) -> Result<Synthesis> {
    let folder = Scratch::new()?;
    write_module(module, folder.path())?;
    let name = &module.name;
    let script = format!(
        "read_verilog {name}.v\n{} -top {name}\ntee -o stat.json stat -json\n",
        target.command()
    );
    yosys(&script, folder.path(), limits)?;
    let path = folder.path().join("stat.json");
    let text = std::fs::read_to_string(&path).map_err(|why| Error::io(&path, "can't read", why))?;
    let cells = cells_of(&text)?;
    Ok(Synthesis { cost: Cost::of_cells(&cells), cells })
}

/// Cells by type, from the output of Yosys's `stat -json`.
///
/// # Errors
/// If the text doesn't have that form.
pub fn cells_of(text: &str) -> Result<BTreeMap<String, u64>> {
    let bad = |why: &str| Error::usage(format!("what Yosys counted can't be read: {why}"));
    let value: Value = serde_json::from_str(text).map_err(|why| bad(&why.to_string()))?;
    let design = &value["design"];
    let cells = design["num_cells_by_type"].as_object();
    let cells = cells.ok_or_else(|| bad("design.num_cells_by_type is missing"))?;
    cells
        .iter()
        .map(|(cell, count)| {
            let count = count.as_u64().ok_or_else(|| bad(&format!("`{cell}` has no count")))?;
            Ok((cell.clone(), count))
        })
        .collect()
}

/// Places and routes a module between registers on a suitable device, and reads the clock. Inputs
/// come from a shift register on one pin, and outputs go through another one to one pin, so that
/// every path runs from register to register and no unit has too many pins. `period_ps` is the
/// target.
///
/// iCE40: an HX8K, or an UP5K if the unit has DSPs. ECP5: an LFE5U-25F. The seed is 1.
///
/// # Errors
/// If a tool fails, Yosys runs past a limit, or files can't be written.
pub fn route(
    module: &Module,
    target: Target,
    cost: Cost,
    period_ps: u32,
    limits: Limits,
) -> Result<Clock> {
    let (device, tools, mut arguments): (_, &[&Tool], Vec<&str>) = match target {
        Target::Ice40 => {
            let tools: &[&Tool] = &[&outside::NEXTPNR_ICE40];
            let free = "--pcf-allow-unconstrained";
            if cost.dsps > 0 {
                ("up5k", tools, vec!["--up5k", "--package", "sg48", free])
            } else {
                ("hx8k", tools, vec!["--hx8k", "--package", "ct256", free])
            }
        }
        Target::Ecp5 => {
            let free = "--lpf-allow-unconstrained";
            let arguments = vec!["--25k", "--package", "CABGA381", free];
            ("25k", &[&outside::NEXTPNR_ECP5, &outside::YOWASP_ECP5], arguments)
        }
        Target::Xilinx => return Ok(Clock::Unsupported),
    };
    let Some(tool) = tools.iter().find(|tool| tool.version().is_some()) else {
        return Ok(Clock::Missing(tools[0].missing()));
    };
    let folder = Scratch::new()?;
    write_module(module, folder.path())?;
    write_text(&folder.path().join("fixpath_bench.v"), &bench(module))?;
    let script = format!(
        "read_verilog {}.v fixpath_bench.v\n{} -top {BENCH} -json bench.json\n",
        module.name,
        target.command()
    );
    yosys(&script, folder.path(), limits)?;
    let mhz = format!("{:.3}", 1e6 / f64::from(period_ps.max(1)));
    arguments.extend(["--json", "bench.json", "--seed", "1", "--timing-allow-fail"]);
    arguments.extend(["--freq", &mhz]);
    let outcome = outside::run(tool.program, &arguments, folder.path(), limits, None)?;
    if let Some(why) = outcome.cut_short(tool.name) {
        return Ok(Clock::CutShort { device, why });
    }
    if let Some(why) = too_large(&outcome.stderr) {
        return Ok(Clock::TooLarge { device, why });
    }
    let reached = outcome.stderr.lines().rev().find_map(clock_mhz);
    match reached {
        Some(mhz) if outcome.success() => Ok(Clock::Reached { device, mhz }),
        Some(_) | None => Err(failed(tool.name, &outcome)),
    }
}

/// Name of the module around the unit; no unit has two underscores in a row in its name.
const BENCH: &str = "fixpath__bench";

fn write_module(module: &Module, folder: &Path) -> Result<()> {
    let mut files = module.table_files();
    files.push(module.file(&Verilog));
    files.iter().try_for_each(|file| write_text(&folder.join(&file.name), &file.text))
}

fn yosys(script: &str, folder: &Path, limits: Limits) -> Result<()> {
    let tool = &outside::YOSYS;
    if tool.version().is_none() {
        return Err(Error::usage(format!("{} is {}", tool.name, tool.missing())));
    }
    write_text(&folder.join("script.ys"), script)?;
    let outcome = outside::run(tool.program, &["-q", "-s", "script.ys"], folder, limits, None)?;
    if let Some(why) = outcome.cut_short(tool.name) {
        return Err(Error::usage(why));
    }
    if outcome.success() { Ok(()) } else { Err(failed(tool.name, &outcome)) }
}

/// An error with the last lines of a tool's output.
fn failed(name: &str, outcome: &Outcome) -> Error {
    let lines: Vec<&str> = outcome
        .stdout
        .lines()
        .chain(outcome.stderr.lines())
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect();
    let last = lines[lines.len().saturating_sub(3)..].join("; ");
    Error::usage(format!("{name} failed: {last}"))
}

/// The unit between shift registers.
fn bench(module: &Module) -> String {
    // A control bit has one bit; ports that the bench names itself aren't shifted.
    let bits = |port: &Port<'_>| port.word.map_or(1, |word| word.bits);
    let ports = module.ports();
    let shifted = |is_output: bool| -> Vec<(&str, u32)> {
        let own = ["clk", "rst", "ce", "valid_in", "valid_out"];
        let is_own =
            |port: &&Port<'_>| own.contains(&port.name) || port.word.is_none() && port.is_output;
        let ports = ports.iter().filter(|port| port.is_output == is_output && !is_own(port));
        ports.map(|port| (port.name, bits(port))).collect()
    };
    let (inputs, outputs) = (shifted(false), shifted(true));
    let top = |ports: &[(&str, u32)]| ports.iter().map(|(_, bits)| bits).sum::<u32>();
    let (top_in, top_out) = (top(&inputs), top(&outputs));
    let mut text = format!(
        "module {BENCH} (input wire clk, input wire rst, input wire ce, input wire d, output wire q);\n    \
         reg [{top_in}:0] given;\n    always @(posedge clk) given <= {{given, d}};\n    \
         wire [{top_out}:0] made;\n    reg [{top_out}:0] taken, chain;\n    \
         always @(posedge clk) begin\n        taken <= made;\n        \
         chain <= {{chain, 1'b0}} ^ taken;\n    end\n    assign q = chain[{top_out}];\n    \
         {} unit (\n",
        module.name
    );
    if module.latency > 0 {
        text.push_str("        .clk(clk), .rst(rst), .ce(ce),\n");
    }
    let _ = write!(text, "        .valid_in(given[0]), .valid_out(made[0])");
    for (ports, word) in [(inputs, "given"), (outputs, "made")] {
        let mut lo = 1;
        for (name, bits) in ports {
            let _ = write!(text, ",\n        .{name}({word}[{}:{lo}])", lo + bits - 1);
            lo += bits;
        }
    }
    text.push_str("\n    );\nendmodule\n");
    text
}

/// The resources that a device lacks, from nextpnr's list of used resources.
fn too_large(log: &str) -> Option<String> {
    let mut missing = Vec::new();
    for line in log.lines().filter_map(|line| line.strip_prefix("Info:")) {
        // `ICESTORM_RAM:    70/   32   218%`
        let Some((name, rest)) = line.trim().split_once(':') else { continue };
        let Some((used, rest)) = rest.split_once('/') else { continue };
        let Some(have) = rest.split_whitespace().next() else { continue };
        let (Ok(used), Ok(have)) = (used.trim().parse::<u64>(), have.parse::<u64>()) else {
            continue;
        };
        let name = match name {
            "ICESTORM_LC" => "logic cells",
            "ICESTORM_RAM" | "DP16KD" => "block RAMs",
            "ICESTORM_DSP" | "MULT18X18D" => "DSPs",
            "TRELLIS_COMB" => "LUTs",
            "TRELLIS_FF" => "flip-flops",
            "TRELLIS_SLICE" => "slices",
            other => other,
        };
        if used > have {
            missing.push(format!("{used} of {have} {name}"));
        }
    }
    (!missing.is_empty()).then(|| missing.join(", "))
}

/// The clock in a line of nextpnr's output.
fn clock_mhz(line: &str) -> Option<f64> {
    let (_, rest) = line.split_once("Max frequency for clock")?;
    // The clock's name is in quotes and may contain a colon.
    let (_, rest) = rest.rsplit_once("': ")?;
    rest.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_nextpnr_are_read() {
        let line =
            "Info: Max frequency for clock 'clk$SB_IO_IN_$glb_clk': 61.87 MHz (FAIL at 200.00 MHz)";
        assert_eq!(clock_mhz(line), Some(61.87));
        assert_eq!(clock_mhz("Info: Max delay <async> -> posedge clk: 3.86 ns"), None);
        let log = "Info: Device utilisation:\nInfo: \t         ICESTORM_LC:   977/ 7680    12%\n\
                   Info: \t        ICESTORM_RAM:    70/   32   218%\nERROR: no Bels remaining";
        assert_eq!(too_large(log).as_deref(), Some("70 of 32 block RAMs"));
        assert_eq!(too_large("Info: \t ICESTORM_RAM: 32/ 32 100%"), None);
    }
}
