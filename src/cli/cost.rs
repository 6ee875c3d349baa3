//! `fixpath cost`: what a unit takes on an FPGA, and the clock that it reaches.

use super::{UnitArgs, pretty, text};
use crate::cost::{self, Clock, Cost, Synthesis, Target};
use crate::error::Result;
use crate::hdl::{Module, Options};
use crate::units::Design;
use clap::{Args, ValueEnum};
use indicatif::ProgressBar;
use serde_json::json;
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Duration;

#[derive(Args)]
pub(super) struct CostArgs {
    #[command(flatten)]
    unit: UnitArgs,
    /// Families of FPGAs.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "ice40,ecp5,xilinx")]
    target: Vec<TargetArg>,
    /// Leave out placing and routing: no clock.
    #[arg(long)]
    no_route: bool,
    /// Longest run of a tool in s.
    #[arg(long, value_name = "S", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..=86_400))]
    time_limit: u64,
    /// As JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum TargetArg {
    /// Lattice iCE40.
    Ice40,
    /// Lattice ECP5.
    Ecp5,
    /// Xilinx 7 series.
    Xilinx,
}

impl TargetArg {
    fn target(self) -> Target {
        match self {
            Self::Ice40 => Target::Ice40,
            Self::Ecp5 => Target::Ecp5,
            Self::Xilinx => Target::Xilinx,
        }
    }
}

/// What is known of a unit on one target.
struct Found {
    target: Target,
    synthesis: Synthesis,
    estimate: Cost,
    clock: Option<Clock>,
}

/// Runs the tools; returns what to tell.
pub(super) fn run(args: &CostArgs) -> Result<String> {
    let design = args.unit.design()?;
    let rtl = Arc::new(design.rtl()?);
    let module = Module::new(&rtl, &Options::default())?;
    let limit = Duration::from_secs(args.time_limit);
    let mut found: Vec<Found> = Vec::new();
    for target in args.target.iter().map(|target| target.target()) {
        if found.iter().any(|known| known.target == target) {
            continue;
        }
        let bar = ProgressBar::new_spinner();
        bar.enable_steady_tick(Duration::from_millis(200));
        bar.set_message(format!("Yosys for {}", target.name()));
        let synthesis = cost::synthesize(&module, target, limit)?;
        bar.set_message(format!("nextpnr for {}", target.name()));
        let clock = if args.no_route { None } else { Some(cost::route(&module, target, limit)?) };
        bar.finish_and_clear();
        let estimate = cost::of_module(&module, target);
        found.push(Found { target, synthesis, estimate, clock });
    }
    Ok(if args.json { pretty(&json_of(&design, &found)) } else { told(&design, &found) })
}

fn told(design: &Design, found: &[Found]) -> String {
    let mut told =
        format!("{}: {}\n", design.values.unit().name, text::parameter_line(&design.values));
    let mut rows = Vec::new();
    for Found { target, synthesis, estimate, .. } in found {
        for (what, cost) in [
            (format!("Yosys {}", synthesis.version), synthesis.cost),
            ("estimate".to_owned(), *estimate),
        ] {
            let mut row = vec![target.name().to_owned(), what];
            row.extend(cost.columns().map(|count| count.to_string()));
            rows.push(row);
        }
    }
    let headings: Vec<String> = Cost::COLUMNS.iter().map(|heading| format!(">{heading}")).collect();
    let mut all = vec!["target", "by"];
    all.extend(headings.iter().map(String::as_str));
    told.push_str(&text::table(&all, &rows));
    for Found { target, clock, .. } in found {
        let _ = match clock {
            None => Ok(()),
            Some(Clock::Reaches { device, version, mhz }) => writeln!(
                told,
                "{}: {mhz:.1} MHz between registers on {device} (nextpnr {version}, seed 1)",
                target.name()
            ),
            Some(Clock::DoesNotFit { device, why }) => {
                writeln!(told, "{}: does not fit {device}: {why}", target.name())
            }
            Some(Clock::Unknown(why)) => writeln!(told, "{}: no clock: {why}", target.name()),
        };
    }
    told
}

fn json_of(design: &Design, found: &[Found]) -> serde_json::Value {
    let target = |found: &Found| {
        json!({
            "target": found.target.name(),
            "yosys": found.synthesis,
            "estimate": found.estimate,
            "clock": found.clock,
        })
    };
    json!({
        "tool": "fixpath",
        "version": env!("CARGO_PKG_VERSION"),
        "unit": design.values.unit().name,
        "parameters": text::parameters(&design.values),
        "targets": found.iter().map(target).collect::<Vec<_>>(),
    })
}
