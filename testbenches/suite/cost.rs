//! Synthesis figures: parsing of tool output, the estimate, and its deviation from Yosys.

use crate::committed::COMMITTED;
use crate::common::design;
use crate::record::recorded;
use fixpath::cost::{
    Cost, DEVIATIONS, DEVIATIONS_SETTINGS, DEVIATIONS_YOSYS, Target, cells_of, estimate, of_module,
    route, synthesize,
};
use fixpath::format::{Format, Overflow, Round};
use fixpath::hdl::{Module, Options, Tables, Verilog};
use fixpath::netlist::{Builder, Quantity};
use fixpath::outside::{self, Limits};
use fixpath::rtl::Rtl;
use fixpath::schedule::{Depth, Rom, Schedule};
use rayon::prelude::*;
use serde_json::json;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

fn limits() -> Limits {
    Limits::of_time(Duration::from_secs(900))
}

const SMALL: &[&str] = &["angle_bits=10", "table_addr_bits=8", "frac_bits=8"];

fn rtl_of(assignments: &[&str]) -> Arc<Rtl> {
    Arc::new(design("rotation", assignments).rtl().unwrap())
}

fn module_of(assignments: &[&str]) -> Module {
    Module::new(&rtl_of(assignments), &Options::default()).unwrap()
}

/// The code that makes the tools' scripts, arguments and test bench, and that parses their output.
const COST: &str = include_str!("../../src/hardware/cost/mod.rs");

/// All texts that tools receive for a module.
fn texts_of(module: &Module) -> Vec<String> {
    let mut files = module.table_files();
    files.push(module.file(&Verilog));
    files.into_iter().map(|file| file.text).chain([COST.to_owned()]).collect()
}

/// Yosys's result for a module: its cells, from the record if there.
fn cells_in(name: &str, module: &Module, target: Target) -> BTreeMap<String, u64> {
    let texts = texts_of(module);
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let name = format!("{} {name}", target.name());
    let made = || json!(synthesize(module, target, limits()).unwrap().cells);
    serde_json::from_value(recorded(&name, &outside::YOSYS, &texts, made)).unwrap()
}

fn cost_in(name: &str, module: &Module, target: Target) -> Cost {
    Cost::of_cells(&cells_in(name, module, target))
}

/// nextpnr's result for a module on iCE40, from the record if there.
fn clock_in(name: &str, module: &Module) -> serde_json::Value {
    let mut texts = texts_of(module);
    texts.extend(outside::YOSYS.version());
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let made = || {
        let cost = synthesize(module, Target::Ice40, limits()).unwrap().cost;
        json!(route(module, Target::Ice40, cost, 5000, limits()).unwrap())
    };
    recorded(&format!("nextpnr {name}"), &outside::NEXTPNR_ICE40, &texts, made)
}

/// `a + b` and `a * b` of two words with these bits, rounded to half of them.
fn arithmetic(bits: u32) -> Arc<Rtl> {
    let mut b = Builder::new("arithmetic");
    let format = Format::signed(bits, 4).unwrap();
    let x = b.input("x", format, Quantity::Number);
    let y = b.input("y", format, Quantity::Number);
    let sum = b.add(x, y);
    b.output("sum", sum);
    let product = b.mul(x, y);
    let product = b.narrow(product, format, Round::HalfUp, Overflow::Saturate);
    b.output("product", product);
    let netlist = Arc::new(b.build().unwrap());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Period(5000)).unwrap();
    Arc::new(Rtl::new(netlist, schedule))
}

#[test]
fn cells_are_read_and_counted() {
    let text = r#"{"creator": "Yosys", "modules": {}, "design": {"num_cells": 9,
        "num_cells_by_type": {"CCU2C": 3, "LUT4": 5, "TRELLIS_FF": 7, "PFUMX": 2, "DP16KD": 1,
        "MULT18X18D": 4}}}"#;
    let cells = cells_of(text).unwrap();
    assert_eq!(cells["PFUMX"], 2);
    let cost = Cost::of_cells(&cells);
    assert_eq!(cost, Cost { luts: 11, flip_flops: 7, block_rams: 1, dsps: 4 });
    let cells = |list: &[(&str, u64)]| -> BTreeMap<String, u64> {
        list.iter().map(|(cell, count)| ((*cell).to_owned(), *count)).collect()
    };
    let xilinx = cells(&[
        ("BUFG", 1),
        ("CARRY4", 9),
        ("DSP48E1", 2),
        ("FDRE", 5),
        ("FDSE", 6),
        ("IBUF", 70),
        ("INV", 1),
        ("LUT2", 2),
        ("LUT6", 3),
        ("MUXF7", 4),
        ("RAMB18E1", 5),
        ("RAMB36E1", 6),
        ("SRL16E", 7),
    ]);
    let cost = Cost::of_cells(&xilinx);
    assert_eq!(cost, Cost { luts: 13, flip_flops: 11, block_rams: 17, dsps: 2 });
    let ice40 = cells(&[
        ("SB_CARRY", 9),
        ("SB_DFF", 1),
        ("SB_DFFE", 2),
        ("SB_DFFESR", 3),
        ("SB_LUT4", 4),
        ("SB_MAC16", 5),
        ("SB_RAM40_4K", 6),
    ]);
    let cost = Cost::of_cells(&ice40);
    assert_eq!(cost, Cost { luts: 4, flip_flops: 6, block_rams: 6, dsps: 5 });
}

#[test]
fn malformed_counts_are_refused() {
    for (text, why) in [
        ("", "can't be read: EOF"),
        ("[]", "design.num_cells_by_type is missing"),
        ("{\"design\": {}}", "design.num_cells_by_type is missing"),
        ("{\"design\": {\"num_cells_by_type\": {\"LUT4\": -1}}}", "`LUT4` has no count"),
        ("{\"design\": {\"num_cells_by_type\": {\"LUT4\": \"x\"}}}", "`LUT4` has no count"),
    ] {
        let error = cells_of(text).unwrap_err().to_string();
        assert!(
            error.contains("what Yosys counted can't be read") && error.contains(why),
            "{error}"
        );
    }
}

#[test]
fn block_rams_take_their_best_shape() {
    for (target, addr_bits, columns, count) in [
        (Target::Ice40, 10, 40, 10),
        (Target::Ice40, 8, 16, 1),
        (Target::Ice40, 8, 17, 2),
        (Target::Ice40, 9, 16, 2),
        (Target::Ice40, 4, 40, 3),
        (Target::Ice40, 11, 2, 1),
        (Target::Ice40, 12, 2, 2),
        (Target::Ecp5, 10, 40, 3),
        (Target::Ecp5, 10, 18, 1),
        (Target::Ecp5, 11, 18, 2),
        (Target::Ecp5, 14, 1, 1),
        (Target::Xilinx, 10, 36, 2),
        (Target::Xilinx, 15, 1, 2),
    ] {
        assert_eq!(
            target.block_rams(addr_bits, columns),
            count,
            "{target:?} {addr_bits} {columns}"
        );
    }
    // Eight ports, two of which read one column; one copy per port or per two ports.
    let rtl = rtl_of(&[]);
    for (target, count) in [(Target::Ice40, 70), (Target::Ecp5, 11), (Target::Xilinx, 11)] {
        assert_eq!(estimate(&rtl, target).unwrap().block_rams, count, "{target:?}");
    }
    let rtl = rtl_of(&["rom=distributed"]);
    for (target, _) in Target::ALL {
        let cost = estimate(&rtl, *target).unwrap();
        assert_eq!(cost.block_rams, 0);
        assert!(cost.luts > 1000, "{target:?}: {cost:?}");
    }
}

#[test]
fn wider_words_never_cost_less() {
    for (target, name) in Target::ALL {
        let mut before = Cost::default();
        for bits in 5..=20 {
            let cost = estimate(&arithmetic(bits), *target).unwrap();
            assert!(
                cost.luts + 400 * cost.dsps >= before.luts + 400 * before.dsps,
                "{name} {bits}"
            );
            assert!(cost.dsps >= before.dsps, "{name} {bits}");
            before = cost;
        }
        assert!(
            before.luts > 20 && before.flip_flops > 20 && before.dsps > 0,
            "{name}: {before:?}"
        );
        let mut before = Cost::default();
        for frac_bits in (6..=20).step_by(2) {
            let cost = estimate(&rtl_of(&[&format!("frac_bits={frac_bits}")]), *target).unwrap();
            let pairs = cost.columns().into_iter().zip(before.columns());
            assert!(pairs.into_iter().all(|(now, before)| now >= before), "{name} {frac_bits}");
            before = cost;
        }
    }
}

#[test]
fn show_tells_the_estimate_and_how_far_it_is() {
    let run = |args: &[&str]| {
        let output = crate::common::fixpath().args(args).output().unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let text = run(&["show", "rotation"]);
    let stated = format!(
        "from Yosys {DEVIATIONS_YOSYS} over the {DEVIATIONS_SETTINGS} committed settings of this unit"
    );
    assert!(text.contains(&stated) && text.contains("other settings can deviate more"), "{text}");
    assert_eq!(fitted().count(), DEVIATIONS_SETTINGS);
    let other = run(&["show", "illumination"]);
    assert!(other.contains("measured for the rotation unit only") && !other.contains("(N %)"));
    let json: serde_json::Value =
        serde_json::from_str(&run(&["show", "rotation", "--json"])).unwrap();
    for (target, deviations) in DEVIATIONS {
        let entry = &json["cost_estimate"][target.name()];
        let cost = estimate(&rtl_of(&[]), *target).unwrap();
        assert_eq!(entry["luts"], cost.luts);
        assert_eq!(entry["within_percent_of_yosys"], serde_json::json!(deviations));
        let row = text.lines().find(|line| line.trim_start().starts_with(target.name())).unwrap();
        assert!(row.contains(&format!(" {} ({} %)", cost.luts, deviations[0])), "{row}");
    }
    // The two counts of flip-flops are distinguished.
    let registers = rtl_of(&[]).register_bits();
    assert!(text.contains(&format!("{registers} register bits")), "{text}");
    assert!(text.contains("flip-flops: register bits of the pipeline, without"), "{text}");
}

/// Settings that the deviations cover: time-shared hardware isn't estimated.
fn fitted() -> impl Iterator<Item = &'static [&'static str]> + Clone {
    let flat = |set: &[&str]| !set.contains(&"schedule=shared");
    let rotations = COMMITTED.iter().filter(move |(_, unit, set)| *unit == "rotation" && flat(set));
    rotations.map(|(_, _, set)| *set)
}

#[test]
fn a_missing_yosys_is_named_with_what_brings_it() {
    let output = assert_cmd::Command::cargo_bin("fixpath")
        .unwrap()
        .args(["cost", "rotation", "--target", "ice40"])
        .env("PATH", "/nowhere")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(stderr.trim(), "error: yosys is not found: install it with `apt-get install yosys`");
}

/// The stated deviations hold for every committed setting of the rotation unit, and are tight.
#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn the_stated_deviations_are_true() {
    let version = outside::YOSYS.version();
    let again = "the stated deviations are of another Yosys: measure them again";
    assert_eq!(version.as_deref(), Some(DEVIATIONS_YOSYS), "{again}");
    let cases: Vec<(Target, &[&str])> =
        DEVIATIONS.iter().flat_map(|(target, _)| fitted().map(|set| (*target, set))).collect();
    let far = |(target, set): &(Target, &[&str])| -> [u32; 4] {
        let name = if set.is_empty() { "defaults".to_owned() } else { set.join(" ") };
        let is = cost_in(&name, &module_of(set), *target).columns();
        let guess = estimate(&rtl_of(set), *target).unwrap().columns();
        std::array::from_fn(|at| match (is[at], guess[at]) {
            (is, guess) if is == guess => 0,
            (is, guess) => (100.0 * is.abs_diff(guess) as f64 / is as f64).ceil() as u32,
        })
    };
    let far: Vec<[u32; 4]> = cases.par_iter().map(far).collect();
    for (target, stated) in DEVIATIONS {
        let mut worst = [0; 4];
        for (_, far) in cases.iter().zip(&far).filter(|((of, _), _)| of == target) {
            worst = std::array::from_fn(|at| worst[at].max(far[at]));
        }
        assert_eq!(&worst, stated, "{}", target.name());
    }
}

#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn tables_go_where_they_are_asked_and_nothing_latches() {
    for (target, name) in Target::ALL {
        for (rom, block) in [("rom=block", true), ("rom=distributed", false)] {
            let module = module_of(&[SMALL, &[rom]].concat());
            let cells = cells_in(&format!("small {rom}"), &module, *target);
            assert_eq!(Cost::of_cells(&cells).block_rams > 0, block, "{name} {rom}: {cells:?}");
            let latch = |cell: &String| {
                let cell = cell.to_lowercase();
                cell.contains("latch") || cell.starts_with("ld") || cell.starts_with('$')
            };
            assert!(!cells.keys().any(latch), "{name} {rom}: {cells:?}");
        }
    }
}

/// Yosys used up all memory of a machine on memories with many ports.
#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn tables_of_many_ports_are_synthesised() {
    let module = module_of(&["scheme=linear", "table_addr_bits=7", "quarter_wave=on"]);
    for target in [Target::Ecp5, Target::Xilinx] {
        let limits = Limits { memory_bytes: 1 << 30, ..limits() };
        let made = synthesize(&module, target, limits).unwrap().cost;
        assert_eq!(made.block_rams, of_module(&module, target).unwrap().block_rams, "{target:?}");
    }
}

/// Functions with one case per address share no block RAM, and the estimate accounts for that.
#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn tables_as_cases_take_a_block_ram_for_each_read() {
    let rtl = rtl_of(&["angle_bits=11", "table_addr_bits=9", "frac_bits=8", "rom=block"]);
    let of = |tables| {
        let module = Module::new(&rtl, &Options { tables: Some(tables), ..Options::default() });
        let module = module.unwrap();
        let made = cost_in(&format!("{tables:?}"), &module, Target::Ecp5).block_rams;
        assert_eq!(made, of_module(&module, Target::Ecp5).unwrap().block_rams, "{tables:?}");
        made
    };
    assert!(of(Tables::Inline) < of(Tables::Case));
}

#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn nextpnr_reaches_a_clock_or_says_what_does_not_fit() {
    let clock = clock_in("small", &module_of(SMALL));
    assert_eq!(clock["reached"]["device"], "hx8k", "{clock}");
    let mhz = clock["reached"]["mhz"].as_f64().unwrap();
    assert!((20.0..500.0).contains(&mhz), "{mhz}");
    let clock = clock_in("large", &module_of(&[]));
    assert_eq!(clock["too_large"]["device"], "hx8k", "{clock}");
    assert_eq!(clock["too_large"]["why"], "70 of 32 block RAMs");
    // A combinational design is timed between the registers around it.
    let still = module_of(&[SMALL, &["rom=distributed", "stages=0"]].concat());
    let clock = clock_in("still", &still);
    assert!(clock["reached"]["mhz"].is_f64(), "{clock}");
}

#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn a_time_limit_ends_the_tools() {
    let module = module_of(&["output=polar-cordic"]);
    let limits = Limits::of_time(Duration::from_millis(500));
    let error = synthesize(&module, Target::Ice40, limits).unwrap_err();
    assert!(error.to_string().contains("yosys ran past the limit of 0 s"), "{error}");
}

#[cfg(target_os = "linux")]
#[test]
#[ignore = "needs yosys and nextpnr-ice40: testbenches/run installs them"]
fn a_memory_limit_ends_the_tools() {
    let module = module_of(&["table_addr_bits=12"]);
    let limits = Limits { memory_bytes: 40 << 20, ..limits() };
    let error = synthesize(&module, Target::Ecp5, limits).unwrap_err();
    assert!(error.to_string().contains("yosys ran out of memory at 0.0 GiB"), "{error}");
}
