//! Emitted VHDL in GHDL.

use crate::engines::random_netlist;
use crate::hdl::{emit, some_rtl};
use fixpath::format::{Format, Overflow, Round};
use fixpath::hdl::Tables;
use fixpath::netlist::{Builder, Column, Quantity, Table};
use fixpath::units::Unit;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::Arc;

fn ghdl(folder: &Path, name: &str) -> Output {
    let makefile = format!("{name}_ghdl.mk");
    Command::new("make").args(["-s", "-f", &makefile]).current_dir(folder).output().unwrap()
}

/// Runs a folder's testbench: it says that all is well, and nothing else.
fn check(folder: tempfile::TempDir, name: &str, vectors: u64, what: &str) {
    let output = ghdl(folder.path(), name);
    let stdout = String::from_utf8_lossy(&output.stdout);
    let stderr = String::from_utf8_lossy(&output.stderr);
    let pass = format!("PASS {vectors} vectors\n");
    if stdout != pass || !stderr.is_empty() || !output.status.success() {
        panic!("{what} {}\n{stdout}\n{stderr}", folder.keep().display());
    }
}

#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn random_netlists_in_ghdl() {
    for seed in 0..std::env::var("N").map_or(40, |n| n.parse().unwrap()) {
        let netlist = Arc::new(random_netlist(seed));
        let folder = tempfile::tempdir().unwrap();
        let tables =
            [Some(Tables::Inline), Some(Tables::Files), Some(Tables::Case)][(seed % 3) as usize];
        emit(&some_rtl(&netlist, seed / 3), tables, 400, folder.path());
        check(folder, "random", 400, &format!("seed {seed}"));
    }
}

#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn rotations_in_ghdl() {
    let variants: [&[&str]; 5] = [
        &["variant=exact"],
        &["variant=exact", "output=polar-cordic"],
        &["variant=exact", "output=polar-table"],
        &["variant=corrected"],
        &["variant=printed"],
    ];
    for values in variants {
        let unit = Unit::find("rotation").unwrap();
        let rtl = Arc::new(unit.values(values).unwrap().build().unwrap().rtl().unwrap());
        let folder = tempfile::tempdir().unwrap();
        let module = emit(&rtl, None, 1000, folder.path());
        check(folder, &module.name, 1000, &values.join(" "));
    }
}

/// Ports and nodes with the names of everything that modules, tables and testbenches declare.
#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn any_name_is_a_word_in_ghdl() {
    let inputs = [
        "i",
        "sent",
        "address",
        "row",
        "source",
        "rtl",
        "valid_s1",
        "read_mode",
        "rom_style",
        "done",
        "test",
        "number",
        "dut",
        "next_i",
        "dut_i",
        "hex",
        "print",
        "lfsr",
    ];
    let mut b = Builder::new("rtl_tb");
    let format = Format::new(true, 5, 2).unwrap();
    let mut sum = b.constant(3, format);
    for name in inputs {
        let input = b.input(name, format, Quantity::Number);
        sum = b.add(sum, input);
    }
    let address = b.slice(sum, 0, 3);
    b.name(address, "x_rom_rows");
    let column = Column { name: "c".to_owned(), format, words: (-4..4).collect() };
    let table = b.table(Table { name: "x".to_owned(), addr_bits: 3, columns: vec![column] });
    let read = b.read(table, 0, address);
    b.name(read, "x_rom_file");
    let product = b.mul(read, read);
    b.output("latency", sum);
    b.output("checked", product);
    let netlist = Arc::new(b.build().unwrap());
    for (tables, _) in Tables::ALL {
        for depth in [0, 3] {
            let folder = tempfile::tempdir().unwrap();
            let module = emit(&some_rtl(&netlist, depth), Some(*tables), 50, folder.path());
            check(folder, &module.name, 50, &format!("{tables:?} {depth}"));
        }
    }
}

/// Ties and limits are rare among the words of wide formats: here all words of small ones occur.
#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn every_rounding_and_limit_in_ghdl() {
    let mut b = Builder::new("narrowings");
    let format = |signed, bits, frac| Format::new(signed, bits, frac).unwrap();
    let inputs = [true, false].map(|signed| {
        b.input(if signed { "a" } else { "u" }, format(signed, 5, 2), Quantity::Number)
    });
    let mut count = 0;
    for (round, overflow) in
        Round::ALL.iter().flat_map(|r| Overflow::ALL.iter().map(move |o| (r, o)))
    {
        for input in inputs {
            for to in [format(true, 3, 0), format(false, 3, 1), format(true, 2, -3)] {
                let narrowed = b.narrow(input, to, *round, *overflow);
                b.output(&format!("out{count}"), narrowed);
                count += 1;
            }
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let netlist = Arc::new(b.build().unwrap());
    let module = emit(&some_rtl(&netlist, 0), None, 1000, folder.path());
    check(folder, &module.name, 1000, "narrowings");
}
