//! `fixpath cost`: the FPGA resources of a unit.

use super::options::UnitArgs;
use super::{number, text};
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::base::outside::{self, Limits};
use crate::design::Design;
use crate::hardware::cost::{
    self, Clock, Cost, DEVIATIONS, DEVIATIONS_SETTINGS, DEVIATIONS_YOSYS, Synthesis, Target,
    estimate, route, synthesize,
};
use crate::hardware::hdl::{Module, Options};
use crate::hardware::rtl::Rtl;
use clap::{Args, ValueEnum};
use indicatif::ProgressBar;
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Duration;

#[derive(Args)]
pub(super) struct CostArgs {
    #[command(flatten)]
    unit: UnitArgs,
    /// FPGA families.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "ice40,ecp5,xilinx")]
    target: Vec<TargetArg>,
    /// Time limit of each tool run, in s.
    #[arg(long, value_name = "S", default_value_t = 300, allow_negative_numbers = true, value_parser = number::whole(1..=86_400))]
    time_limit: u64,
    /// Memory limit of a tool in GiB (Linux); default: 4, or half of the machine's memory if that
    /// is less.
    #[arg(long, value_name = "GIB", allow_negative_numbers = true, value_parser = number::whole(1..=4096))]
    memory_limit: Option<u64>,
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

/// Results for one target.
struct Row {
    target: Target,
    synthesis: Synthesis,
    estimate: Option<Cost>,
    clock: Clock,
}

/// Runs the tools; returns the text to print.
pub(super) fn run(args: &CostArgs) -> Result<String> {
    let design = args.unit.design()?;
    let rtl = Arc::new(design.rtl()?);
    let module = Module::new(&rtl, &Options::default())?;
    let limits = Limits {
        time: Duration::from_secs(args.time_limit),
        memory_bytes: outside::memory_bytes(args.memory_limit),
    };
    let mut targets: Vec<Target> = args.target.iter().map(|target| target.target()).collect();
    targets.sort_unstable();
    targets.dedup();
    let tool = &outside::YOSYS;
    let missing = || Error::usage(format!("{} is {}", tool.name, tool.missing()));
    let yosys = tool.version().ok_or_else(missing)?;
    let bar = ProgressBar::new_spinner();
    let names: Vec<&str> = targets.iter().map(|target| target.name()).collect();
    bar.set_message(format!("synthesis for {}", names.join(", ")));
    super::progress::tick(&bar);
    let period_ps = rtl.schedule().period_ps();
    let row = |target: &Target| {
        let target = *target;
        let named = |why| Error::usage(format!("{}: {why}", target.name()));
        let synthesis = synthesize(&module, target, limits).map_err(named)?;
        bar.println(format!("{}: counted", target.name()));
        let clock = route(&module, target, synthesis.cost, period_ps, limits).map_err(named)?;
        bar.println(format!("{}: done", target.name()));
        Ok(Row { target, estimate: cost::of_module(&module, target).ok(), synthesis, clock })
    };
    let rows: Result<Vec<Row>> = targets.par_iter().map(row).collect();
    bar.finish_and_clear();
    let rows = rows?;
    Ok(if args.json {
        json::text(&json_of(&design, &rows, &yosys))
    } else {
        told(&design, &rows, &yosys)
    })
}

fn clock(clock: &Clock) -> String {
    match clock {
        Clock::Reached { device, mhz } => format!("{mhz:.1} MHz on {device}"),
        Clock::TooLarge { device, why } => format!("does not fit {device}: {why}"),
        Clock::CutShort { device, why } => format!("unknown on {device}: {why}"),
        Clock::Missing(how) => format!("nextpnr {how}"),
        Clock::Unsupported => "not routed (nextpnr covers iCE40 and ECP5)".to_owned(),
    }
}

fn figures(target: &str, from: &str, cost: Cost, last: String) -> Vec<String> {
    let mut cells = vec![target.to_owned(), from.to_owned()];
    cells.extend(cost.columns().map(|count| count.to_string()));
    cells.push(last);
    cells
}

fn told(design: &Design, rows: &[Row], yosys: &str) -> String {
    let mut text =
        format!("{}: {}\n", design.values.unit().name, text::parameter_line(&design.values));
    let mut cells = Vec::new();
    for row in rows {
        let name = row.target.name();
        cells.push(figures(name, &format!("Yosys {yosys}"), row.synthesis.cost, clock(&row.clock)));
        if let Some(estimate) = row.estimate {
            cells.push(figures("", "estimate", estimate, String::new()));
        }
    }
    text.push_str(&text::table(
        &["target", "", ">LUTs", ">flip-flops", ">block RAMs", ">DSPs", "clock"],
        &cells,
    ));
    text.push_str("  the clock is that of the unit between registers, placed with seed 1\n");
    text
}

fn json_of(design: &Design, rows: &[Row], yosys: &str) -> Value {
    let row = |row: &Row| {
        json!({
            "target": row.target.name(),
            "synthesis": row.synthesis,
            "estimate": row.estimate,
            "clock": row.clock,
        })
    };
    json::document(
        "cost",
        json!({
            "unit": design.values.unit().name,
            "parameters": text::parameters(&design.values),
            "yosys": yosys,
            "targets": rows.iter().map(row).collect::<Vec<_>>(),
        }),
    )
}

/// True for the unit over which [`DEVIATIONS`] were measured.
fn is_measured(rtl: &Rtl) -> bool {
    rtl.netlist().name() == "rotation" && rtl.units().is_empty()
}

/// The estimate for every target, for `show`.
pub(super) fn estimates(rtl: &Arc<Rtl>) -> String {
    let mut text = "\ncost estimate, without synthesis tools\n".to_owned();
    let mut rows = Vec::new();
    for (target, deviations) in DEVIATIONS {
        let cost = match estimate(rtl, *target) {
            Ok(cost) => cost,
            Err(why) => return format!("{text}  none: {why}\n"),
        };
        let mut cells = vec![target.name().to_owned()];
        for (count, percent) in cost.columns().iter().zip(deviations) {
            let fitted = if is_measured(rtl) { format!("({percent} %)") } else { String::new() };
            cells.extend([count.to_string(), fitted]);
        }
        rows.push(cells);
    }
    text.push_str(&text::table(
        &["target", ">LUTs", "", ">flip-flops", "", ">block RAMs", "", ">DSPs", ""],
        &rows,
    ));
    text.push_str(
        "  flip-flops: register bits of the pipeline, without duplicates, unused ones and those absorbed by block RAMs,\n  \
         DSPs and LUTs used as delays\n",
    );
    let how_far = if is_measured(rtl) {
        format!(
            "(N %): worst deviation from Yosys {DEVIATIONS_YOSYS} over the {DEVIATIONS_SETTINGS} committed settings of this unit, to which the\n  \
             estimate was fitted; other settings can deviate more"
        )
    } else {
        "its deviation from Yosys was measured for the rotation unit only".to_owned()
    };
    let _ = writeln!(text, "  {how_far}; `fixpath cost` runs Yosys itself");
    text
}

/// The same as JSON.
pub(super) fn estimates_json(rtl: &Arc<Rtl>) -> Value {
    let mut targets = Map::new();
    for (target, deviations) in DEVIATIONS {
        // A design that can't be built as a module has no estimate.
        let Ok(cost) = estimate(rtl, *target) else { return Value::Null };
        let mut entry = json!(cost);
        if is_measured(rtl) {
            entry["within_percent_of_yosys"] = json!(deviations);
            entry["within_percent_over_settings"] = json!(DEVIATIONS_SETTINGS);
        }
        targets.insert(target.name().to_owned(), entry);
    }
    Value::Object(targets)
}
