//! Emitted VHDL in GHDL.

use crate::committed::{COMMITTED, files};
use crate::engines::random_netlist;
use crate::hdl::{
    Ended, PLACES, emit, emit_with, every_operation, fails, faulty_vectors, figure_8_rtl, little,
    put, replaced, some_rtl, some_shared, tool,
};
use fixpath::format::{Format, Overflow, Round};
use fixpath::hdl::Tables;
use fixpath::netlist::{Builder, Column, Quantity, Table};
use fixpath::rtl::Rtl;
use fixpath::schedule::{Depth, Rom, Schedule};
use fixpath::units::Unit;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::Arc;

fn ghdl(folder: &Path, name: &str) -> Output {
    let makefile = format!("{name}_ghdl.mk");
    Command::new("make").args(["-s", "-f", &makefile]).current_dir(folder).output().unwrap()
}

/// Runs a folder's testbench: it must report success, and nothing else.
pub(crate) fn check(folder: tempfile::TempDir, name: &str, vectors: u64, what: &str) {
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
    for seed in 0..40 {
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
fn shared_hardware_in_ghdl() {
    let mut runs = some_shared(20);
    runs.push((0, figure_8_rtl()));
    for (seed, rtl) in runs {
        let folder = tempfile::tempdir().unwrap();
        let tables = PLACES[seed as usize % PLACES.len()];
        let module = emit(&rtl, tables, 400, folder.path());
        check(folder, &module.name, 400, &format!("shared, seed {seed}"));
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

/// GHDL synthesises everything that is emitted: every operation, and every committed unit with its
/// table placement.
#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn ghdl_synthesises_every_operation_and_unit() {
    let synthesises = |source: &Path, name: &str, tables: &Path| {
        let work = tempfile::tempdir().unwrap();
        let library = format!("--workdir={}", work.path().display());
        for arguments in [
            &["-a", "--std=08", &library, source.to_str().unwrap()] as &[&str],
            &["--synth", "--std=08", &library, name],
        ] {
            let ended = tool(tables, "ghdl", arguments);
            assert!(ended.well, "{name}: {arguments:?}\n{}", ended.stderr);
        }
    };
    let schedule = |netlist| Schedule::pipeline(netlist, Rom::Block, Depth::Stages(1)).unwrap();
    let netlist = Arc::new(every_operation());
    let folder = tempfile::tempdir().unwrap();
    let rtl = Rtl::new(Arc::clone(&netlist), schedule(&netlist));
    let module = emit(&Arc::new(rtl), None, 1, folder.path());
    let source = folder.path().join(format!("{}.vhd", module.name));
    synthesises(&source, &module.name, folder.path());
    for (name, unit, assignments) in COMMITTED {
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in files(name, unit, assignments) {
            fs::write(folder.path().join(path.file_name().unwrap()), text).unwrap();
        }
        synthesises(&folder.path().join(format!("{name}.vhd")), name, folder.path());
    }
}

/// A table read without a clock never becomes block RAM, in either language, even with a register
/// next to it on either side.
#[test]
#[ignore = "needs ghdl and yosys: testbenches/run installs them"]
fn tables_without_a_clock_take_no_block_ram_from_either_language() {
    let format = Format::integer(9).unwrap();
    let words: Arc<[i64]> = (0..512).map(|x: i64| (x * x * 7 + x) % 512).collect();
    let mut b = Builder::new("squares");
    let column = Column { name: "square".to_owned(), format, words };
    let id = b.table(Table {
        name: "squares".to_owned(),
        addr_bits: 9,
        columns: vec![column],
        memory: None,
    });
    for port in ["x", "z"] {
        let address = b.input(port, format, Quantity::Number);
        let other = b.input(&format!("{port}_mask"), format, Quantity::Number);
        // The address is ready one stage before it is needed.
        let address = b.xor(address, other);
        let row = b.read(id, 0, address);
        b.output(&format!("{port}_square"), row);
    }
    let netlist = Arc::new(b.build().unwrap());
    let schedule = Schedule::pipeline(&netlist, Rom::Distributed, Depth::Stages(3)).unwrap();
    let rtl = Arc::new(Rtl::new(netlist, schedule));
    for tables in [Tables::Inline, Tables::Files, Tables::Case] {
        let folder = tempfile::tempdir().unwrap();
        let module = emit(&rtl, Some(tables), 1, folder.path());
        let (verilog, vhdl) = (format!("{}.v", module.name), format!("{}.vhd", module.name));
        let arguments = ["--synth", "--std=08", "--out=verilog", &vhdl, "-e", &module.name];
        let ghdl = Command::new("ghdl").args(arguments).current_dir(folder.path()).output();
        fs::write(folder.path().join("from_vhdl.v"), ghdl.unwrap().stdout).unwrap();
        for source in [verilog.as_str(), "from_vhdl.v"] {
            for (target, ram) in
                [("ice40", "SB_RAM40_4K"), ("ecp5", "DP16KD"), ("xilinx", "RAMB18E1")]
            {
                // Yosys takes long for what GHDL makes of cases, so one family suffices.
                if tables == Tables::Case && source != verilog && target != "ecp5" {
                    continue;
                }
                // Up to the mapping of memories.
                let script = format!(
                    "read_verilog {source}; synth_{target} -top {} -run :map_ffram; \
                     select -assert-none t:{ram} t:*RAMB36* t:*TDP*; select -assert-min 1 t:$dff*",
                    module.name
                );
                let ended = tool(folder.path(), "yosys", &["-q", "-p", &script]);
                assert!(ended.well, "{tables:?} {source} {target}: {}", ended.stderr);
            }
        }
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
        "rom_block",
        "romstyle",
        "syn_romstyle",
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
    let table =
        b.table(Table { name: "x".to_owned(), addr_bits: 3, columns: vec![column], memory: None });
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

/// Ties and limits are rare among words of wide formats. Here all words of small formats occur.
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

/// A run through make, without the line that GHDL adds to a failure.
fn run(folder: &Path, name: &str) -> Ended {
    let ended = tool(folder, "make", &["-s", "-f", &format!("{name}_ghdl.mk")]);
    let is_ghdls = |line: &&str| line.starts_with("simulation finished");
    let lines = ended.stdout.lines().filter(|line| !is_ghdls(line));
    Ended { stdout: lines.map(|line| format!("{line}\n")).collect(), ..ended }
}

#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn the_vhdl_testbench_can_fail() {
    let folder = tempfile::tempdir().unwrap();
    let module = emit(&little(), Some(Tables::Files), 200, folder.path());
    let at = |name: &str| folder.path().join(name);
    let vectors = at("little_vectors.txt");
    let good = fs::read_to_string(&vectors).unwrap();
    assert_eq!(run(folder.path(), "little").last(), "PASS 200 vectors");
    for (what, text, says) in faulty_vectors(&good) {
        put(&vectors, text.as_deref());
        // make exits with 2 for any failure.
        fails(&run(folder.path(), "little"), 2, what, says);
        put(&vectors, Some(&good));
    }
    let row = module.table_files().remove(0);
    let source = fs::read_to_string(at("little.vhd")).unwrap();
    let bench = fs::read_to_string(at("little_tb.vhd")).unwrap();
    let latency = |cycles: u32| {
        let constant = "constant latency : natural := ";
        replaced(&bench, &format!("{constant}4"), &format!("{constant}{cycles}"))
    };
    let hardware = |from: &str, to: &str| replaced(&source, from, to);
    let register = source.lines().find(|line| line.trim_start().starts_with("x_s2 <= ")).unwrap();
    let reset = "if rst = '1' then\n                valid_s2 <= '0';\n            elsif ce";
    for (what, file, text, says) in [
        ("a wrong row", row.name.as_str(), replaced(&row.text, "0df\n", "0de\n"), "sum expected"),
        ("latency 5", "little_tb.vhd", latency(5), "valid_out"),
        ("latency 3", "little_tb.vhd", latency(3), "valid_out"),
        (
            "valid a cycle early",
            "little.vhd",
            hardware("valid_out <= valid_s4", "valid_out <= valid_s3"),
            "valid_out",
        ),
        ("a register too few", "little.vhd", hardware(register, ""), "expected"),
        (
            "a register that does not stand still",
            "little.vhd",
            hardware("if ce = '1' then", "if true then"),
            "expected",
        ),
        ("a valid bit without a reset", "little.vhd", hardware(reset, "if ce"), "valid_out"),
        (
            "a reset that a stall holds up",
            "little.vhd",
            hardware("if rst = '1' then", "if rst = '1' and ce = '1' then"),
            "valid_out",
        ),
        ("a wrong sum", "little.vhd", hardware(" + ", " - "), "expected"),
    ] {
        let right = fs::read_to_string(at(file)).unwrap();
        fs::write(at(file), text).unwrap();
        // Independent of the file system's clock.
        fs::remove_dir_all(at("ghdl_little")).unwrap();
        fails(&run(folder.path(), "little"), 2, what, says);
        fs::write(at(file), right).unwrap();
    }
    fs::remove_dir_all(at("ghdl_little")).unwrap();
    assert_eq!(run(folder.path(), "little").last(), "PASS 200 vectors");
}

/// A count is a word of any width, while GHDL's integers have 32 bits. No word may be too large.
#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn counts_wider_than_integers_in_ghdl() {
    let count_format = Format::unsigned(40, 0).unwrap();
    let mut b = Builder::new("shifts");
    let inputs = [
        b.input("a", Format::signed(12, 4).unwrap(), Quantity::Number),
        b.input("u", Format::unsigned(7, 0).unwrap(), Quantity::Number),
    ];
    let count = b.input("count", count_format, Quantity::Number);
    for (at, input) in inputs.into_iter().enumerate() {
        for max in [1, 2, 3, 5, 8, 20] {
            let shifted = b.shift_left(input, count, max);
            b.output(&format!("y{at}_{max}"), shifted);
        }
    }
    let netlist = Arc::new(b.build().unwrap());
    let mut first = Vec::new();
    for count in (0..25).chain([1 << 31, 1 << 32, (1 << 32) + 2, 1 << 39, 3 << 38]) {
        for count in [count, (1 << 40) - 1 - count, (count + (1 << 31)) - 1] {
            for (a, u) in [(-2048, 127), (2047, 64), (-1, 1)] {
                first.push(vec![a, u, count]);
            }
        }
    }
    let vectors = first.len() as u64 + 500;
    for (depth, rom) in [(0, Rom::Distributed), (2, Rom::Block)] {
        let schedule = Schedule::pipeline(&netlist, rom, Depth::Stages(depth)).unwrap();
        let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
        let folder = tempfile::tempdir().unwrap();
        let module = emit_with(&rtl, None, first.clone(), 500, folder.path());
        check(folder, &module.name, vectors, &format!("{depth} stages"));
    }
}
