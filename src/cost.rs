//! What a unit costs on an FPGA: LUTs, flip-flops, block RAMs and DSPs.
//!
//! [`synthesize`] asks Yosys, [`route`] asks nextpnr for the clock, and [`estimate()`] gives an
//! estimate without tools. [`DEVIATIONS`] says how far that is from Yosys over the committed
//! units.
//!
//! # What counts as what
//!
//! | | iCE40 (`synth_ice40 -dsp`) | ECP5 (`synth_ecp5`) | Xilinx 7 (`synth_xilinx`) |
//! |---|---|---|---|
//! | LUTs | `SB_LUT4` | `LUT4`, and two for each `CCU2C`, which takes the place of two | `LUT1` to `LUT6`, `INV`; `SRL16E` and `SRLC32E` too, which are LUTs as delays |
//! | flip-flops | `SB_DFF…` | `TRELLIS_FF` | `FD…` |
//! | block RAMs | `SB_RAM40_4K` (4 Kbit) | `DP16KD` (18 Kbit) | `RAMB18E1` (18 Kbit), and two for each `RAMB36E1` |
//! | DSPs | `SB_MAC16` (16×16) | `MULT18X18D` (18×18) | `DSP48E1` (25×18) |
//!
//! Carries (`SB_CARRY`) share the cells of their LUTs, and wide multiplexers (`PFUMX`,
//! `L6MUX21`, `MUXF7`, `MUXF8`) and `CARRY4` stand beside LUTs: they are no LUTs and are listed
//! among the cells only. Input, output and clock buffers aren't part of the unit.

mod estimate;

pub use estimate::{estimate, of_module};

use crate::error::{Error, Result};
use crate::hdl::{Module, Verilog};
use crate::output::{Scratch, write_text};
use crate::outside::{self, Outcome, Tool};
use estimate::{Adds, Dsp, Rules, Sum};
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Duration;

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

    /// The command of Yosys.
    #[must_use]
    pub fn command(self) -> &'static str {
        match self {
            Self::Ice40 => "synth_ice40 -dsp",
            Self::Ecp5 => "synth_ecp5",
            Self::Xilinx => "synth_xilinx",
        }
    }

    /// Block RAMs that one read port of a table takes.
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
                dsp: Dsp {
                    long_bits: 16,
                    short_bits: 16,
                    part_bits: 16,
                    signed_only: false,
                    least_bits: 11,
                    adds: Adds::Rows,
                },
                dsp_registers: true,
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
                dsp: Dsp {
                    long_bits: 18,
                    short_bits: 18,
                    part_bits: 18,
                    signed_only: false,
                    least_bits: 4,
                    adds: Adds::None,
                },
                dsp_registers: false,
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
                dsp: Dsp {
                    long_bits: 25,
                    short_bits: 18,
                    part_bits: 18,
                    signed_only: true,
                    least_bits: 9,
                    adds: Adds::All,
                },
                dsp_registers: true,
                shift_registers: Some(3),
            },
        }
    }
}

/// What a unit takes; see the module's documentation for what counts as what.
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

/// How far [`estimate()`] is from Yosys 0.23 at most, in % of its figure, over the settings that
/// `hdl_out` holds: LUTs, flip-flops, block RAMs, DSPs. A test holds them true.
pub const DEVIATIONS: [(Target, [u32; 4]); 3] = [
    (Target::Ice40, [10, 3, 0, 0]),
    (Target::Ecp5, [20, 4, 0, 0]),
    (Target::Xilinx, [40, 60, 0, 0]),
];

impl Cost {
    /// Headings of [`Cost::columns`].
    pub const COLUMNS: [&'static str; 4] = ["LUTs", "flip-flops", "block RAMs", "DSPs"];

    /// Its figures in order.
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

/// Runs Yosys on a module, in a folder of its own.
///
/// # Errors
/// If Yosys isn't there, fails, or runs past `limit`.
pub fn synthesize(module: &Module, target: Target, limit: Duration) -> Result<Synthesis> {
    let version = outside::YOSYS.version().ok_or_else(|| {
        Error::usage(format!("{} is {}", outside::YOSYS.name, outside::YOSYS.missing()))
    })?;
    let scratch = Scratch::new()?;
    write_module(module, scratch.path())?;
    let script = format!(
        "read_verilog {0}.v\n{1} -top {0}\ntee -q -o cells.json stat -json\n",
        module.name,
        target.command()
    );
    let cells = cells_of(&script, scratch.path(), limit)?;
    Ok(Synthesis { version, cost: Cost::of_cells(&cells), cells })
}

/// What a synthesiser made of a module.
#[derive(Clone, Debug, Serialize)]
pub struct Synthesis {
    /// Version of Yosys.
    pub version: String,
    /// What it takes.
    #[serde(flatten)]
    pub cost: Cost,
    /// Every cell by its type.
    pub cells: BTreeMap<String, u64>,
}

fn write_module(module: &Module, folder: &Path) -> Result<()> {
    let mut files = module.table_files();
    files.push(module.file(&Verilog));
    for file in files {
        write_text(&folder.join(file.name), &file.text)?;
    }
    Ok(())
}

/// The error of a tool that didn't end well.
fn check(outcome: &Outcome, tool: &Tool) -> Result<()> {
    if outcome.timed_out {
        let text = format!("{} ran past the limit of {:.0} s", tool.name, outcome.seconds);
        return Err(Error::usage(format!("{text}: give it more with --time-limit")));
    }
    if outcome.success() {
        return Ok(());
    }
    let said = if outcome.stderr.trim().is_empty() { &outcome.stdout } else { &outcome.stderr };
    let last = said.trim_end().lines().last().unwrap_or("nothing");
    Err(Error::usage(format!("{} failed and said: {last}", tool.name)))
}

/// Runs a script of Yosys that leaves its statistics in `cells.json`.
fn cells_of(script: &str, folder: &Path, limit: Duration) -> Result<BTreeMap<String, u64>> {
    write_text(&folder.join("script.ys"), script)?;
    let yosys = &outside::YOSYS;
    let outcome = outside::run(yosys.program, &["-q", "script.ys"], folder, limit, None)?;
    check(&outcome, yosys)?;
    let path = folder.join("cells.json");
    let text = std::fs::read_to_string(&path).map_err(|why| Error::io(&path, "can't read", why))?;
    cells(&text).ok_or_else(|| {
        Error::usage(
            "the statistics of Yosys are in no form that is known: cost takes 0.23 or later"
                .to_owned(),
        )
    })
}

/// Cells by type from what `stat -json` writes; `None` if it isn't that.
#[must_use]
pub fn cells(statistics: &str) -> Option<BTreeMap<String, u64>> {
    let json: Value = serde_json::from_str(statistics).ok()?;
    // Newer versions have the design's own totals; both list every module.
    let modules = json.get("modules")?.as_object()?;
    let counted = json
        .get("design")
        .or_else(|| modules.values().next())?
        .get("num_cells_by_type")?
        .as_object()?;
    counted.iter().map(|(name, count)| Some((name.clone(), count.as_u64()?))).collect()
}

/// The clock that a unit reaches between registers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Clock {
    /// It was placed and routed.
    Reaches {
        /// Device and package.
        device: &'static str,
        /// Version of nextpnr.
        version: String,
        /// The clock in MHz.
        mhz: f64,
    },
    /// It takes more than the device has.
    DoesNotFit {
        /// Device and package.
        device: &'static str,
        /// What it has too few of.
        why: String,
    },
    /// It could not be tried, and why.
    Unknown(String),
}

/// A device to be placed and routed on.
struct Device {
    name: &'static str,
    arguments: &'static [&'static str],
    /// Programs that do it: the tool, and the same from another source.
    tools: [&'static Tool; 2],
    /// Command of Yosys that writes what it reads.
    synthesis: &'static str,
    /// Option that names its input.
    input: &'static str,
}

/// Devices in order of size; the first that a unit fits on is taken.
fn devices(target: Target) -> &'static [Device] {
    const ICE40: [&Tool; 2] = [&outside::NEXTPNR_ICE40, &outside::YOWASP_ICE40];
    const ECP5: [&Tool; 2] = [&outside::NEXTPNR_ECP5, &outside::YOWASP_ECP5];
    match target {
        Target::Ice40 => &[
            Device {
                name: "iCE40 HX8K",
                arguments: &["--hx8k", "--package", "ct256"],
                tools: ICE40,
                synthesis: "synth_ice40 -json top.json",
                input: "--json",
            },
            Device {
                name: "iCE40 UP5K",
                arguments: &["--up5k", "--package", "sg48"],
                tools: ICE40,
                synthesis: "synth_ice40 -dsp -json top.json",
                input: "--json",
            },
        ],
        Target::Ecp5 => &[Device {
            name: "ECP5 25K",
            arguments: &["--25k", "--package", "CABGA381", "--speed", "6"],
            tools: ECP5,
            synthesis: "synth_ecp5 -json top.json",
            input: "--json",
        }],
        Target::Xilinx => &[],
    }
}

/// Places and routes a module between registers, and gives the clock that it reaches.
///
/// A unit has more ports than a package has pins, and its first stage takes its inputs directly:
/// so the words of its inputs come from a shift register, and those of its outputs go through
/// registers into one pin. Every path of the unit is from register to register then.
///
/// # Errors
/// If files can't be written or read, or a tool fails.
#[expect(clippy::missing_panics_doc, reason = "a target has a device, or was left above")]
pub fn route(module: &Module, target: Target, limit: Duration) -> Result<Clock> {
    if module.latency == 0 {
        return Ok(Clock::Unknown("a combinational unit has no clock".to_owned()));
    }
    let devices = devices(target);
    let Some(first) = devices.first() else {
        return Ok(Clock::Unknown(format!("there is no nextpnr for {}", target.name())));
    };
    let Some((tool, version)) =
        first.tools.iter().find_map(|tool| tool.version().map(|version| (*tool, version)))
    else {
        return Ok(Clock::Unknown(format!("{} {}", first.tools[0].name, first.tools[0].missing())));
    };
    let mut misfit = None;
    for device in devices {
        let scratch = Scratch::new()?;
        write_module(module, scratch.path())?;
        write_text(&scratch.path().join("top.v"), &wrapper(module))?;
        let script = format!(
            "read_verilog {}.v top.v\n{} -top top\ntee -q -o cells.json stat -json\n",
            module.name, device.synthesis
        );
        cells_of(&script, scratch.path(), limit)?;
        let mut arguments = device.arguments.to_vec();
        arguments.extend([
            device.input,
            "top.json",
            "--seed",
            "1",
            "--timing-allow-fail",
            "--quiet",
        ]);
        let report = ["--report", "report.json", "--freq", "100"];
        arguments.extend(report);
        if target == Target::Ice40 {
            arguments.push("--pcf-allow-unconstrained");
        }
        let outcome = outside::run(tool.program, &arguments, scratch.path(), limit, None)?;
        let said = format!("{}{}", outcome.stdout, outcome.stderr);
        let shortage = if outcome.timed_out { None } else { shortage(&said) };
        if let Some(why) = shortage.filter(|_| !outcome.success()) {
            misfit.get_or_insert(Clock::DoesNotFit { device: device.name, why });
            continue;
        }
        check(&outcome, tool)?;
        let path = scratch.path().join("report.json");
        let text =
            std::fs::read_to_string(&path).map_err(|why| Error::io(&path, "can't read", why))?;
        let mhz = clock_of(&text)
            .ok_or_else(|| Error::usage(format!("the report of {} names no clock", tool.name)))?;
        return Ok(Clock::Reaches { device: device.name, version, mhz });
    }
    Ok(misfit.expect("bug: every device was tried"))
}

/// The slowest clock of nextpnr's report in MHz.
#[must_use]
pub fn clock_of(report: &str) -> Option<f64> {
    let json: Value = serde_json::from_str(report).ok()?;
    let clocks = json.get("fmax")?.as_object()?.values();
    clocks.filter_map(|clock| clock.get("achieved")?.as_f64()).reduce(f64::min)
}

/// What a device has too few of, by nextpnr's name for it.
fn shortage(said: &str) -> Option<String> {
    let line = said.lines().find(|line| line.contains("no BELs remaining"))?;
    let (_, rest) = line.split_once("cell type '")?;
    Some(format!("it has too few {}", rest.trim_end_matches('\'')))
}

/// The unit with its inputs from a shift register and its outputs into one pin.
#[must_use]
pub fn wrapper(module: &Module) -> String {
    let (mut input_bits, mut output_bits) = (1, 1);
    let mut ports = String::new();
    for id in &module.inputs {
        let word = module.word(*id);
        let (lo, hi) = (input_bits, input_bits + word.bits - 1);
        let _ = write!(ports, ",\n        .{}(in[{hi}:{lo}])", word.name);
        input_bits += word.bits;
    }
    for (name, id) in &module.outputs {
        let (lo, hi) = (output_bits, output_bits + module.word(*id).bits - 1);
        let _ = write!(ports, ",\n        .{name}(out[{hi}:{lo}])");
        output_bits += module.word(*id).bits;
    }
    format!(
        "module top (input wire clk, input wire rst, input wire ce, input wire serial, output reg parity);
    reg [{0}:0] in;
    wire [{1}:0] out;
    reg [{1}:0] held;
    {2} unit (
        .clk(clk), .rst(rst), .ce(ce), .valid_in(in[0]), .valid_out(out[0]){ports}
    );
    always @(posedge clk) begin
        in <= {{in, serial}};
        // Every bit matters: they go out one by one.
        if (ce) held <= out;
        else held <= {{held[0], held[{1}:1]}};
        parity <= held[0];
    end
endmodule
",
        input_bits - 1,
        output_bits - 1,
        module.name
    )
}
