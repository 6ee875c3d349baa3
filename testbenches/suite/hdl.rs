//! Emitted hardware in external tools: simulators give the reference's words, no tool warns, and
//! testbenches fail when they should.

use crate::engines::{random_netlist, random_netlist_of, random_words};
use crate::lower::{badly_named, shared_rtl};
use crate::shared::{emboss_netlist, figure_8};
use crate::wave::ReadBack;
use fixpath::cycle::Cycle;
use fixpath::emit::vectors::Vectors;
use fixpath::format::{Format, Overflow, Round};
use fixpath::hdl::{LANGUAGES, Module, Options, Tables, Verilog, testbench};
use fixpath::netlist::{Builder, Column, Netlist, Quantity, Table};
use fixpath::op::Op;
use fixpath::rtl::{Rtl, Signal};
use fixpath::schedule::{Depth, Kind, Plan, Rom, Schedule, Share};
use fixpath::units::rotation;
use fixpath::wave::{self, Wave};
use rayon::prelude::*;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;
use tempfile::TempDir;

/// A depth for a netlist, chosen by its seed.
pub(crate) fn some_rtl(netlist: &Arc<Netlist>, seed: u64) -> Arc<Rtl> {
    let rom = if seed.is_multiple_of(3) { Rom::Distributed } else { Rom::Block };
    let depth = match seed % 4 {
        0 => Depth::Stages(0),
        1 => Depth::Stages(1),
        2 => Depth::Period(3000),
        _ => Depth::Period(100),
    };
    let schedule = Schedule::pipeline(netlist, rom, depth)
        .unwrap_or_else(|_| Schedule::pipeline(netlist, rom, Depth::Period(1000)).unwrap());
    Arc::new(Rtl::new(Arc::clone(netlist), schedule))
}

/// Writes everything for a netlist into a folder and returns the module. The vectors are `first`,
/// then random ones.
pub(crate) fn emit_with(
    rtl: &Arc<Rtl>,
    tables: Option<Tables>,
    first: Vec<Vec<i64>>,
    random: u64,
    folder: &Path,
) -> Module {
    emit_options(rtl, Options { tables, ..Options::default() }, first, random, folder)
}

/// Like [`emit_with`], with more options.
pub(crate) fn emit_options(
    rtl: &Arc<Rtl>,
    options: Options,
    first: Vec<Vec<i64>>,
    random: u64,
    folder: &Path,
) -> Module {
    let options = Options { header: vec!["a netlist under test".to_owned()], ..options };
    let module = Module::new(rtl, &options).unwrap();
    let mut stream = Vectors::of_netlist(rtl.netlist(), first, random, 7);
    let mut files: Vec<_> = LANGUAGES.iter().map(|language| module.file(*language)).collect();
    files.extend(module.table_files());
    files.extend(testbench::companions(&module, LANGUAGES, stream.count()));
    for file in files {
        fs::write(folder.join(file.name), file.text).unwrap();
    }
    let mut text = Vec::new();
    stream.write(&mut text).unwrap();
    fs::write(folder.join(testbench::vectors_file(&module)), text).unwrap();
    module
}

/// Like [`emit_with`], with random vectors only.
pub(crate) fn emit(rtl: &Arc<Rtl>, tables: Option<Tables>, vectors: u64, folder: &Path) -> Module {
    emit_with(rtl, tables, Vec::new(), vectors, folder)
}

pub(crate) const PLACES: [Option<Tables>; 3] = [None, Some(Tables::Files), Some(Tables::Case)];

pub(crate) fn place(seed: u64) -> Option<Tables> {
    PLACES[(seed % 3) as usize]
}

/// How a program ended: success, its output, and its errors.
pub(crate) struct Ended {
    pub(crate) well: bool,
    pub(crate) status: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Ended {
    pub(crate) fn last(&self) -> &str {
        // make reports a failure on the other stream.
        self.stdout.lines().last().unwrap_or_default()
    }
}

pub(crate) fn tool(folder: &Path, program: &str, arguments: &[&str]) -> Ended {
    let output = Command::new(program).args(arguments).current_dir(folder).output();
    let output = output.unwrap_or_else(|why| panic!("{program}: {why}"));
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Ended {
        well: output.status.success(),
        status: output.status.code(),
        stdout: text(&output.stdout),
        stderr: text(&output.stderr),
    }
}

/// Panics with the program's whole output, and keeps the files.
fn give_up(folder: TempDir, what: &str, ended: &Ended) -> ! {
    let kept = folder.keep();
    let Ended { status, stdout, stderr, .. } = ended;
    panic!("{what} in {}: status {status:?}\n{stdout}\n{stderr}", kept.display());
}

/// A run that should pass without any warning.
pub(crate) fn passes(folder: TempDir, make: &str, vectors: u64, what: &str) -> TempDir {
    let ended = tool(folder.path(), "make", &["-s", "-f", make]);
    let quiet = ended.stderr.is_empty();
    if !ended.well || !quiet || ended.last() != format!("PASS {vectors} vectors") {
        give_up(folder, what, &ended);
    }
    folder
}

/// Verilator and Yosys must not warn.
pub(crate) fn lints(folder: TempDir, module: &Module, allowed: &[&str], what: &str) {
    let name = &module.name;
    let (file, top) = (format!("{name}.v"), testbench::top_name(module));
    let bench = format!("{top}.v");
    let mut arguments = vec!["--lint-only", "-Wall", "--top-module", &top];
    arguments.extend(allowed);
    arguments.push(&file);
    if top != *name {
        arguments.push(&bench);
    }
    let verilator = tool(folder.path(), "verilator", &arguments);
    if !verilator.well || !verilator.stdout.is_empty() || !verilator.stderr.is_empty() {
        give_up(folder, &format!("{what}: verilator"), &verilator);
    }
    let yosys = tool(folder.path(), "yosys", &["-q", &format!("{name}.ys")]);
    // A quiet run prints only the counts of cells.
    let complains = format!("{}{}", yosys.stdout, yosys.stderr).to_lowercase().contains("warning");
    if !yosys.well || complains || !yosys.stderr.is_empty() {
        give_up(folder, &format!("{what}: yosys"), &yosys);
    }
}

#[test]
#[ignore = "needs iverilog: testbenches/run installs it"]
fn random_netlists_in_icarus() {
    (0..60u64).into_par_iter().for_each(|seed| {
        let netlist = Arc::new(random_netlist(seed));
        let folder = tempfile::tempdir().unwrap();
        emit(&some_rtl(&netlist, seed / 3), place(seed), 400, folder.path());
        passes(folder, "random_icarus.mk", 400, &format!("seed {seed}"));
    });
}

#[test]
#[ignore = "needs verilator and yosys: testbenches/run installs them"]
fn no_tool_warns_of_random_netlists() {
    (0..100u64).into_par_iter().for_each(|seed| {
        let netlist = Arc::new(random_netlist(seed));
        let folder = tempfile::tempdir().unwrap();
        let module = emit(&some_rtl(&netlist, seed / 3), place(seed), 1, folder.path());
        // Verilator folds constants through wires and warns if a comparison becomes constant.
        // Random netlists compare constants; the units don't.
        // constant. Random netlists compare constants; the units don't.
        lints(folder, &module, &["-Wno-UNSIGNED", "-Wno-CMPCONST"], &format!("seed {seed}"));
    });
}

/// The printed binding of US 6,980,218.
pub(crate) fn figure_8_rtl() -> Arc<Rtl> {
    let netlist = emboss_netlist();
    let schedule = Schedule::bound(&netlist, Rom::Block, 6000, &figure_8()).unwrap();
    Arc::new(Rtl::new(netlist, schedule))
}

/// Hardware that shares, for the first seeds for which a schedule is found.
pub(crate) fn some_shared(count: usize) -> Vec<(u64, Arc<Rtl>)> {
    let found = (0u64..).filter_map(|seed| Some((seed, shared_rtl(seed)?)));
    found.filter(|(_, rtl)| rtl.schedule().interval() > 1).take(count).collect()
}

#[test]
#[ignore = "needs iverilog, verilator and yosys: testbenches/run installs them"]
fn shared_hardware_in_icarus_and_without_a_warning() {
    let mut runs = some_shared(40);
    runs.push((0, figure_8_rtl()));
    runs.into_par_iter().for_each(|(seed, rtl)| {
        let folder = tempfile::tempdir().unwrap();
        let module = emit(&rtl, place(seed), 400, folder.path());
        let what = format!("shared, seed {seed}");
        let folder = passes(folder, &format!("{}_icarus.mk", module.name), 400, &what);
        lints(folder, &module, &["-Wno-UNSIGNED", "-Wno-CMPCONST"], &what);
    });
}

#[test]
#[ignore = "needs verilator: testbenches/run installs it"]
fn shared_hardware_in_verilator() {
    let mut runs = some_shared(3);
    runs.push((0, figure_8_rtl()));
    runs.into_par_iter().for_each(|(seed, rtl)| {
        let folder = tempfile::tempdir().unwrap();
        let module = emit(&rtl, place(seed), 5000, folder.path());
        let make = format!("{}_verilator.mk", module.name);
        let ended = tool(folder.path(), "make", &["-s", "-f", &make]);
        if !ended.well || ended.last() != "PASS 5000 vectors" {
            give_up(folder, &format!("shared, seed {seed}"), &ended);
        }
    });
}

/// One product serves three: registers at its ports, two internal cycles, and a delay FIFO beside
/// it.
pub(crate) fn little_shared() -> Arc<Rtl> {
    let format = Format::signed(6, 4).unwrap();
    let mut b = Builder::new("little");
    let [x, y] = ["x", "y"].map(|name| b.input(name, format, Quantity::Number));
    let square = b.mul(x, x);
    b.name(square, "square");
    let narrow = b.narrow(square, format, Round::HalfUp, Overflow::Saturate);
    b.name(narrow, "narrow");
    let cube = b.mul(narrow, x);
    b.name(cube, "cube");
    let both = b.mul(narrow, y);
    b.name(both, "both");
    let sum = b.add(cube, both);
    b.output("sum", sum);
    b.output("passed", y);
    let netlist = Arc::new(b.build().unwrap());
    let shares = vec![Share { kind: Kind::Multiplier, units: 1, latency: Some(2), loads: true }];
    let plan = Plan { shares, interval: None };
    let schedule = Schedule::shared(&netlist, Rom::Block, 5000, &plan).unwrap();
    Arc::new(Rtl::new(netlist, schedule))
}

#[test]
#[ignore = "needs iverilog and verilator: testbenches/run installs them"]
fn faults_of_shared_hardware_are_found() {
    let right = Module::new(&little_shared(), &Options::default()).unwrap();
    assert!(right.interval == 3, "{}", right.interval);
    let source = right.file(&Verilog).text;
    let load = "if (ce & phase_1) begin\n            cube_s8 <= cube;";
    let early = load.replace("phase_1", "phase_0");
    let choice = source.lines().find(|line| line.contains("mul1_in1_next =")).unwrap();
    let other = choice.replacen("phase_", "!phase_", 1);
    [
        ("a load in another phase", replaced(&source, load, &early), " expected"),
        ("another choice", replaced(&source, choice, &other), " expected"),
        (
            "a phase that no reset clears",
            replaced(&source, "if (rst) phase <= 2'h0;", "if (rst && ce) phase <= 2'h0;"),
            "ready expected",
        ),
        (
            "a counter that a stall doesn't hold up",
            replaced(&source, "else if (ce) phase <= ", "else phase <= "),
            "ready expected",
        ),
        (
            "inputs taken in any phase",
            replaced(&source, "else if (ce & phase_0) valid_s1", "else if (ce) valid_s1"),
            "valid_out expected",
        ),
        ("always ready", replaced(&source, "ready = phase_0", "ready = 1'b1"), "ready expected"),
        (
            "valid for all of an interval",
            replaced(
                &source,
                &format!("valid_out = {} & ", right.valid.0),
                &format!("valid_out = {} | 0 & ", right.valid.0),
            ),
            "valid_out expected",
        ),
    ]
    .into_par_iter()
    .for_each(|(what, text, says)| {
        let folder = tempfile::tempdir().unwrap();
        emit(&little_shared(), None, 300, folder.path());
        for make in ["little_icarus.mk", "little_verilator.mk"] {
            fs::write(folder.path().join("little.v"), &source).unwrap();
            let ended = tool(folder.path(), "make", &["-s", "-f", make]);
            assert_eq!(ended.last(), "PASS 300 vectors", "{make}");
            let _ = fs::remove_file(folder.path().join("little_tb.vvp"));
            let _ = fs::remove_dir_all(folder.path().join("obj_little"));
            fs::write(folder.path().join("little.v"), &text).unwrap();
            // Here warnings don't stop the build.
            let makefile = folder.path().join(make);
            let mut lines = fs::read_to_string(&makefile).unwrap();
            lines = lines.replace("-Wall --Mdir", "-Wno-fatal --Mdir");
            fs::write(&makefile, lines).unwrap();
            let ended = tool(folder.path(), "make", &["-s", "-f", make]);
            fails(&ended, 2, &format!("{what}, {make}"), says);
        }
    });
}

const ROTATIONS: [&[&str]; 5] = [
    &["variant=exact"],
    &["variant=exact", "output=polar-cordic"],
    &["variant=exact", "output=polar-table"],
    &["variant=corrected"],
    &["variant=printed"],
];

#[test]
#[ignore = "needs verilator and yosys: testbenches/run installs them"]
fn no_tool_warns_of_rotation() {
    ROTATIONS.into_par_iter().enumerate().for_each(|(number, assignments)| {
        let mut assignments = assignments.to_vec();
        // Small tables: this test is about their placement, not their size.
        assignments.push("scheme=linear");
        let design = rotation::unit().values(&assignments).unwrap().build().unwrap();
        let rtl = Arc::new(design.rtl().unwrap());
        for tables in [place(number as u64), place(number as u64 + 1)] {
            let folder = tempfile::tempdir().unwrap();
            let module = emit(&rtl, tables, 1, folder.path());
            lints(folder, &module, &[], &assignments.join(" "));
        }
    });
}

/// The first netlist of the requested kind without constants, which Verilator would fold.
fn first_netlist(is_asked: impl Fn(&Netlist) -> bool) -> (u64, Arc<Netlist>) {
    let folds =
        |netlist: &Netlist| netlist.nodes().iter().any(|node| matches!(node.op, Op::Const { .. }));
    (0..)
        .map(|seed| (seed, Arc::new(random_netlist_of(seed, 25))))
        .find(|(_, netlist)| !folds(netlist) && netlist.nodes().len() > 15 && is_asked(netlist))
        .unwrap()
}

#[test]
#[ignore = "needs verilator: testbenches/run installs it"]
fn random_netlists_in_verilator() {
    let bits = |netlist: &Netlist, node| netlist.node(node).format.bits();
    let wide = |n: &Netlist| {
        n.inputs().iter().any(|id| bits(n, *id) == 63)
            && n.outputs().iter().any(|output| bits(n, output.node) == 63)
    };
    let runs: Vec<(_, Rom, Depth, Option<Tables>)> = vec![
        (first_netlist(wide), Rom::Block, Depth::Period(3000), None),
        (first_netlist(|n| n.tables().len() > 1), Rom::Block, Depth::Period(2000), PLACES[1]),
        (first_netlist(|n| n.inputs().len() > 3), Rom::Distributed, Depth::Stages(0), None),
        (first_netlist(|n| n.outputs().len() > 4), Rom::Distributed, Depth::Period(100), PLACES[2]),
    ];
    runs.into_par_iter().for_each(|((seed, netlist), rom, depth, tables)| {
        let schedule = Schedule::pipeline(&netlist, rom, depth).unwrap();
        let folder = tempfile::tempdir().unwrap();
        emit(&Arc::new(Rtl::new(Arc::clone(&netlist), schedule)), tables, 5000, folder.path());
        let ended = tool(folder.path(), "make", &["-s", "-f", "random_verilator.mk"]);
        let quiet = !format!("{}{}", ended.stdout, ended.stderr).contains("%Warning");
        if !ended.well || !quiet || ended.last() != "PASS 5000 vectors" {
            give_up(folder, &format!("seed {seed}"), &ended);
        }
    });
}

/// Runs Icarus's testbench with a wave; returns it and the time of the first vector.
fn icarus_wave(folder: TempDir, name: &str, what: &str) -> (ReadBack, u64) {
    let ended = tool(folder.path(), "make", &["-s", "-f", &format!("{name}_icarus.mk"), "wave"]);
    if !ended.well || !ended.last().starts_with("PASS") || !ended.stderr.is_empty() {
        give_up(folder, what, &ended);
    }
    let read = ReadBack::open(&folder.path().join(format!("{name}_tb.vcd")));
    let valid_in = &read.signals[&format!("{name}_tb.dut.valid_in")];
    let first = valid_in.iter().find(|(_, value)| *value == "1").map(|(time, _)| *time).unwrap();
    (read, first)
}

/// The testbench's clock period in its own units.
const PERIOD: u64 = 10;

#[test]
#[ignore = "needs iverilog: testbenches/run installs it"]
fn the_hardware_moves_as_our_wave_shows_it() {
    ROTATIONS.into_par_iter().for_each(|assignments| {
        let what = assignments.join(" ");
        let design = rotation::unit().values(assignments).unwrap().build().unwrap();
        let rows: Vec<Vec<i64>> = {
            let columns = random_words(&design.netlist, 11, 60);
            (0..60).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
        };
        let folder = tempfile::tempdir().unwrap();
        let rtl = Arc::new(design.rtl().unwrap());
        let name = emit_with(&rtl, None, rows.clone(), 0, folder.path()).name;
        let path = folder.path().join("ours.vcd");
        let options = wave::Options { all: true, words_only: true, ..wave::Options::default() };
        let ours = Wave::new(&design, options).unwrap();
        ours.write(&rows, &mut fs::File::create(&path).unwrap(), &path).unwrap();
        let read = ReadBack::open(&path);
        let period = read.times[2] - read.times[0];
        let (theirs, first) = icarus_wave(folder, &name, &what);
        let latency = u64::from(rtl.schedule().latency());
        let mut compared = 0;
        let mut inner = 0;
        let here: Vec<_> = ours.signals().collect();
        for at in 0..rows.len() as u64 + latency {
            // Just before the next edge.
            let then = first + PERIOD * at + PERIOD - 1;
            let now = period * at;
            for (path, _, stage) in &here {
                let ours = format!("rotation.{path}");
                let flat = path.replace('.', "_");
                let theirs_name = format!("{name}_tb.dut.{flat}");
                assert!(theirs.signals.contains_key(&theirs_name), "{what}: no {theirs_name}");
                // After the last vector the testbench sends unknown words, and our wave sends
                // zeros.
                let stage = u64::from(*stage);
                if at >= stage && at - stage < rows.len() as u64 {
                    let (should, is) = (read.at(&ours, now), theirs.at(&theirs_name, then));
                    assert_eq!(is, should, "{what}: {path} in cycle {at}");
                    compared += 1;
                    inner += u64::from(path.contains('.'));
                }
            }
            for valid in ["valid_in", "valid_out"] {
                let should = read.at(&format!("rotation.{valid}"), now);
                let is = theirs.at(&format!("{name}_tb.dut.{valid}"), then);
                assert_eq!(is, should, "{what}: {valid} in cycle {at}");
            }
        }
        assert!(compared > 2000 && inner > 1000, "{what}: {compared} words, {inner} inside");
    });
}

#[test]
#[ignore = "needs iverilog: testbenches/run installs it"]
fn random_hardware_moves_as_the_cycle_simulator() {
    (100..110u64).into_par_iter().for_each(|seed| {
        let netlist = Arc::new(random_netlist(seed));
        let rtl = some_rtl(&netlist, seed);
        let folder = tempfile::tempdir().unwrap();
        let columns = random_words(&netlist, seed, 30);
        let rows: Vec<Vec<i64>> =
            (0..30).map(|i| columns.iter().map(|column| column[i]).collect()).collect();
        emit_with(&rtl, place(seed), rows.clone(), 0, folder.path());
        let (theirs, first) = icarus_wave(folder, "random", &format!("seed {seed}"));
        let mut signals: Vec<(String, Signal)> = Vec::new();
        for output in netlist.outputs() {
            signals.push((output.name.clone(), rtl.output(output.node)));
        }
        for id in netlist.ids() {
            let mut all = vec![Signal { node: id, stage: rtl.schedule().stage(id) }];
            all.extend(rtl.registers(id));
            // A port's register has the port's name.
            all.retain(|signal| {
                !signals.iter().any(|(_, port)| port == signal && signal.stage > 0)
            });
            signals.extend(all.into_iter().map(|signal| (rtl.local_name(signal), signal)));
        }
        let mut cycle = Cycle::new(Arc::clone(&rtl));
        let latency = rtl.schedule().latency() as usize;
        let mut compared = 0;
        for at in 0..rows.len() + latency {
            let then = first + PERIOD * at as u64 + PERIOD - 1;
            cycle.settle(rows.get(at).unwrap_or(&rows[0]), at < rows.len()).unwrap();
            for (name, signal) in &signals {
                let format = netlist.node(signal.node).format;
                let stage = signal.stage as usize;
                if at >= stage && at - stage < rows.len() {
                    let width = format.bits() as usize;
                    let should = format!("{:0width$b}", format.pattern(cycle.word(*signal)));
                    let full = format!("random_tb.dut.{name}");
                    assert_eq!(theirs.at(&full, then), should, "seed {seed}: {name} at {at}");
                    compared += 1;
                }
            }
            cycle.clock();
        }
        assert!(compared > 100, "seed {seed}: {compared} words");
    });
}

/// A unit with a table in a file, registers and two outputs.
pub(crate) fn little() -> Arc<Rtl> {
    let format = Format::signed(12, 8).unwrap();
    let mut b = Builder::new("little");
    let x = b.input("x", format, Quantity::Number);
    let z = b.input("z", format, Quantity::Number);
    // No two rows are equal.
    let words = (0..16i64).map(|i| 37 * i + 1).collect();
    let column = Column { name: "c".to_owned(), format, words };
    let t =
        b.table(Table { name: "t".to_owned(), addr_bits: 4, columns: vec![column], memory: None });
    let address = b.slice(z, 8, 4);
    let read = b.read(t, 0, address);
    let sum = b.add(x, read);
    let product = b.mul(sum, x);
    let y = b.narrow(product, format, Round::HalfEven, Overflow::Saturate);
    b.output("y", y);
    b.output("sum", sum);
    let netlist = Arc::new(b.build().unwrap());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Stages(4)).unwrap();
    Arc::new(Rtl::new(netlist, schedule))
}

/// Vectors with a fault, and the expected message.
pub(crate) fn faulty_vectors(good: &str) -> Vec<(&'static str, Option<String>, &'static str)> {
    let lines: Vec<&str> = good.lines().collect();
    let with = |line: usize, text: String| {
        let mut lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        lines[line] = text;
        Some(lines.join("\n") + "\n")
    };
    // The least significant bit of a field.
    let flipped = |line: usize, field: usize| {
        let mut fields: Vec<String> = lines[line].split(' ').map(str::to_owned).collect();
        let word = u64::from_str_radix(&fields[field], 16).unwrap() ^ 1;
        fields[field] = format!("{word:0width$x}", width = fields[field].len());
        with(line, fields.join(" "))
    };
    let last = lines.len() - 1;
    let cut = lines[last].rsplit_once(' ').unwrap().0.to_owned();
    let more = format!("{good}{}\n", lines[0].split_once(' ').unwrap().0);
    // The expected outputs of two lines, swapped; the first two fields are inputs.
    let swapped = {
        let parts =
            |line: usize| lines[line].split_at(lines[line].match_indices(' ').nth(1).unwrap().0);
        let mut lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        let ((tenth, out), (eleventh, next)) = (parts(10), parts(11));
        lines[10] = format!("{tenth}{next}");
        lines[11] = format!("{eleventh}{out}");
        Some(lines.join("\n") + "\n")
    };
    vec![
        ("a wrong bit in the first", flipped(0, 2), "vector 0 y expected"),
        ("a wrong bit in one", flipped(17, 3), "vector 17 sum expected"),
        ("a wrong bit in the last", flipped(last, 2), "vector 199 y expected"),
        ("a wrong input word", flipped(50, 0), "vector 50 sum expected"),
        ("a last line cut short", with(last, cut), "cut short after vector 199"),
        ("one word too many", Some(more), "cut short after vector 200"),
        ("a file cut at a line's end", Some(lines[..150].join("\n") + "\n"), "should hold 200"),
        ("no vector", Some(String::new()), " vector"),
        ("no file", None, "can't be read"),
        ("two in the other order", swapped, "vector 10 "),
    ]
}

pub(crate) fn put(path: &Path, text: Option<&str>) {
    match text {
        Some(text) => fs::write(path, text).unwrap(),
        None => fs::remove_file(path).unwrap(),
    }
}

/// The text with the first of some words replaced; it must occur.
pub(crate) fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "`{from}` is not in the file");
    text.replacen(from, to, 1)
}

/// The last line is FAIL, the status is not 0, and some line names the fault.
pub(crate) fn fails(ended: &Ended, status: i32, what: &str, says: &str) {
    let Ended { stdout, stderr, .. } = ended;
    assert_eq!(ended.status, Some(status), "{what}\n{stdout}\n{stderr}");
    assert!(ended.last().starts_with("FAIL"), "{what}\n{stdout}\n{stderr}");
    assert!(stdout.lines().any(|line| line.contains(says)), "{what}: no `{says}`\n{stdout}");
}

#[test]
#[ignore = "needs iverilog: testbenches/run installs it"]
fn the_testbench_can_fail() {
    let folder = tempfile::tempdir().unwrap();
    let module = emit(&little(), Some(Tables::Files), 200, folder.path());
    let at = |name: &str| folder.path().join(name);
    let vectors = at("little_vectors.txt");
    let good = fs::read_to_string(&vectors).unwrap();
    let run = || {
        // make exits with 2 for any failure.
        let ended = tool(folder.path(), "make", &["-f", "little_icarus.mk"]);
        Ended { stdout: ended.stdout.lines().map(|l| format!("{l}\n")).collect(), ..ended }
    };
    assert_eq!(run().last(), "PASS 200 vectors");
    for (what, text, says) in faulty_vectors(&good) {
        put(&vectors, text.as_deref());
        fails(&run(), 2, what, says);
        let alone = tool(folder.path(), "vvp", &["-n", "little_tb.vvp"]);
        fails(&alone, 1, what, says);
        put(&vectors, Some(&good));
    }
    // Faults in the hardware: a wrong row, another latency, a missing register, a wrong sign.
    let row = module.table_files().remove(0);
    let source = fs::read_to_string(at("little.v")).unwrap();
    let bench = fs::read_to_string(at("little_tb.v")).unwrap();
    let register = source.lines().find(|line| line.trim_start().starts_with("x_s2 <= ")).unwrap();
    for (what, file, text, says) in [
        ("a wrong row", row.name.as_str(), replaced(&row.text, "0df\n", "0de\n"), "sum expected"),
        ("a row too few", &row.name, replaced(&row.text, "0df\n", ""), " expected"),
        (
            "another latency",
            "little_tb.v",
            replaced(&bench, "LATENCY = 4", "LATENCY = 5"),
            "valid_out",
        ),
        (
            "another latency",
            "little_tb.v",
            replaced(&bench, "LATENCY = 4", "LATENCY = 3"),
            "valid_out",
        ),
        (
            "valid a cycle early",
            "little.v",
            replaced(&source, "valid_out = valid_s4", "valid_out = valid_s3"),
            "valid_out",
        ),
        ("a register too few", "little.v", replaced(&source, register, ""), "expected"),
        (
            "a register that does not stand still",
            "little.v",
            replaced(
                &source,
                "always @(posedge clk)\n        if (ce) begin",
                "always @(posedge clk)\n        begin",
            ),
            "expected",
        ),
        (
            "a valid bit without a reset",
            "little.v",
            replaced(&source, "if (rst) valid_s2 <= 1'b0;\n        else if (ce)", "if (ce)"),
            "valid_out",
        ),
        (
            "a reset that a stall holds up",
            "little.v",
            replaced(&source, "if (rst) valid_s", "if (rst && ce) valid_s"),
            "valid_out",
        ),
        ("a wrong sum", "little.v", replaced(&source, " + ", " - "), "expected"),
    ] {
        let right = fs::read_to_string(at(file)).unwrap();
        fs::write(at(file), text).unwrap();
        // Independent of the file system's clock.
        fs::remove_file(at("little_tb.vvp")).unwrap();
        let ended = run();
        fails(&ended, 2, what, says);
        fs::write(at(file), right).unwrap();
    }
    fs::remove_file(at("little_tb.vvp")).unwrap();
    assert_eq!(run().last(), "PASS 200 vectors");
}

#[test]
#[ignore = "needs verilator: testbenches/run installs it"]
fn the_harness_can_fail() {
    let folder = tempfile::tempdir().unwrap();
    let module = emit(&little(), Some(Tables::Files), 200, folder.path());
    let folder = passes_build(folder);
    let vectors = folder.path().join("little_vectors.txt");
    let good = fs::read_to_string(&vectors).unwrap();
    let run = || tool(folder.path(), "obj_little/Vlittle", &["little_vectors.txt"]);
    assert_eq!(run().last(), "PASS 200 vectors");
    for (what, text, says) in faulty_vectors(&good) {
        // It accepts any number of vectors, also through a pipe; its PASS reports how many.
        if says.starts_with("should hold") {
            put(&vectors, text.as_deref());
            assert_eq!(run().last(), "PASS 150 vectors");
            put(&vectors, Some(&good));
            continue;
        }
        put(&vectors, text.as_deref());
        fails(&run(), 1, what, says);
        put(&vectors, Some(&good));
    }
    let row = module.table_files().remove(0);
    fs::write(folder.path().join(&row.name), row.text.replacen("0df\n", "0de\n", 1)).unwrap();
    fails(&run(), 1, "a wrong row", "sum expected");
    // Faults that show only with a stall, a reset or the latency.
    let still = "always @(posedge clk)\n        if (ce) begin";
    let faults = [
        ("little_harness.cpp", "kLatency = 4", "kLatency = 5", "valid_out expected"),
        ("little_harness.cpp", "kLatency = 4", "kLatency = 3", "valid_out expected"),
        ("little.v", still, "always @(posedge clk)\n        begin", " expected"),
        ("little.v", "if (rst) valid_s", "if (rst && ce) valid_s", "valid_out expected"),
    ];
    faults.into_par_iter().for_each(|(file, right, wrong, says)| {
        let folder = tempfile::tempdir().unwrap();
        emit(&little(), Some(Tables::Files), 200, folder.path());
        let path = folder.path().join(file);
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, replaced(&text, right, wrong)).unwrap();
        let ended = tool(folder.path(), "make", &["-s", "-f", "little_verilator.mk"]);
        // make exits with 2 for any failure.
        fails(&ended, 2, wrong, says);
    });
}

fn passes_build(folder: TempDir) -> TempDir {
    let ended = tool(folder.path(), "make", &["-s", "-f", "little_verilator.mk"]);
    if !ended.well || ended.last() != "PASS 200 vectors" {
        give_up(folder, "the harness", &ended);
    }
    folder
}

#[test]
#[ignore = "needs iverilog, verilator and yosys: testbenches/run installs them"]
fn bad_names_in_every_tool() {
    // Keywords of every language, and names that back ends declare themselves.
    let words = [
        "wire", "begin", "signal", "entity", "class", "clk", "ce", "rst", "valid_in", "unused",
        "valid", "valid_s1", "valid_s2", "address", "t_row", "names", "do", "priority", "final",
        "x", "y", "i", "file", "sent", "lfsr", "vector", "near", "complex", "list", "queue",
        "mailbox", "linux", "wone", "inherit",
    ];
    let netlist = Arc::new(badly_named(&words));
    PLACES.into_par_iter().for_each(|tables| {
        let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Stages(5)).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
        let module = emit(&rtl, tables, 100, folder.path());
        let folder = passes(folder, "names_icarus.mk", 100, "bad names");
        lints(folder, &module, &[], "bad names");
    });
}

#[test]
#[ignore = "needs iverilog and verilator: testbenches/run installs them"]
fn ports_may_be_called_as_testbenches_call_things() {
    let format = Format::signed(8, 4).unwrap();
    let mut b = Builder::new("ports");
    let names = [
        "i", "q", "valid", "number", "expected", "x", "next_x", "port_x", "sent", "dut", "check",
        "eval", "name", "trace", "random", "head", "pipe", "more", "vector", "far", "queue",
        "mailbox", "unix", "errno", "uint8_t", "wreal",
    ];
    let inputs: Vec<_> = names.map(|name| b.input(name, format, Quantity::Number)).to_vec();
    let sum = inputs.iter().copied().reduce(|sum, x| b.add(sum, x)).unwrap();
    b.output("lfsr", sum);
    b.output("vectors", inputs[0]);
    let netlist = Arc::new(b.build().unwrap());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Stages(2)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    emit(&Arc::new(Rtl::new(netlist, schedule)), None, 50, folder.path());
    let folder = passes(folder, "ports_icarus.mk", 50, "ports");
    let ended = tool(folder.path(), "make", &["-s", "-f", "ports_verilator.mk"]);
    if !ended.well || ended.last() != "PASS 50 vectors" {
        give_up(folder, "ports", &ended);
    }
}

/// Every operation on every pair of some words, each as an output.
pub(crate) fn every_operation() -> Netlist {
    let mut b = Builder::new("operations");
    let formats = [(true, 4, 1), (false, 5, 2), (true, 3, 0), (false, 4, -1), (true, 1, 0)];
    let inputs: Vec<_> = formats
        .iter()
        .enumerate()
        .map(|(i, (signed, bits, frac))| {
            let format = Format::new(*signed, *bits, *frac).unwrap();
            b.input(&format!("x{i}"), format, Quantity::Number)
        })
        .collect();
    let flag = b.input("flag", Format::FLAG, Quantity::Number);
    let mut results = Vec::new();
    for x in &inputs {
        for y in &inputs {
            results.extend([b.add(*x, *y), b.sub(*x, *y), b.mul(*x, *y), b.equal(*x, *y)]);
            results.extend([b.less(*x, *y), b.mux(flag, *x, *y), b.addsub(flag, *x, *y)]);
        }
        let (neg, abs) = (b.neg(*x), b.abs(*x));
        let (zeros, shifted) = (b.leading_zeros(abs), b.slice(*x, 0, 1));
        results.extend([neg, abs, zeros, b.shift_left(*x, shifted, 1), b.mul(flag, *x)]);
        for (signed, bits, frac) in [(true, 3, 0), (false, 2, -1), (true, 2, 6), (true, 8, -3)] {
            let to = Format::new(signed, bits, frac).unwrap();
            for round in Round::ALL {
                for overflow in Overflow::ALL {
                    results.push(b.narrow(*x, to, *round, *overflow));
                }
            }
        }
    }
    for (i, result) in results.into_iter().enumerate() {
        b.output(&format!("y{i}"), result);
    }
    b.build().unwrap()
}

#[test]
#[ignore = "needs iverilog, verilator and yosys: testbenches/run installs them"]
fn every_operation_in_icarus() {
    let netlist = Arc::new(every_operation());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Stages(1)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
    let module = emit(&rtl, None, 3000, folder.path());
    let folder = passes(folder, "operations_icarus.mk", 3000, "operations");
    lints(folder, &module, &[], "operations");
}

/// Yosys proves a pipeline equal to its reference, and finds any kind of fault in it.
#[test]
#[ignore = "needs yosys: testbenches/run installs it"]
fn the_proof_can_fail() {
    let assignments = ["angle_bits=4", "table_addr_bits=4", "frac_bits=4"];
    let design = rotation::unit().values(&assignments).unwrap().build().unwrap();
    let inline = |name| Options { name, tables: Some(Tables::Inline), ..Options::default() };
    let module = Module::new(&Arc::new(design.rtl().unwrap()), &inline(None)).unwrap();
    assert!(module.latency > 1, "there are registers to lose");
    let schedule = Schedule::pipeline(&design.netlist, Rom::Distributed, Depth::Stages(0)).unwrap();
    let rtl = Arc::new(Rtl::new(Arc::clone(&design.netlist), schedule));
    let name = testbench::reference_name(&module);
    let reference = Module::new(&rtl, &inline(Some(name))).unwrap();
    let [comparison, script] = fixpath::hdl::proof(&module);
    let good = module.file(&Verilog);
    let last = module.latency;
    let valid = |stage: u32| format!("assign valid_out = valid_s{stage};");
    let register = good.text.lines().find(|line| line.trim_start().starts_with("y <= ")).unwrap();
    let early = register.replace(&format!("_s{};", last - 1), ";");
    assert_ne!(register, early, "y waits in a register before it goes out");
    // One bit of the last row but one.
    let row = good.text.lines().find(|line| line.contains("sincos_rom[14] = 16'h")).unwrap();
    let at = row.find("sincos_rom[14]").unwrap();
    let digit_at = at + "sincos_rom[14] = 16'h".len() + 3;
    let digit = u8::from_str_radix(&row[digit_at..=digit_at], 16).unwrap() ^ 4;
    let wrong_row = format!("{}{digit:x}{}", &row[..digit_at], &row[digit_at + 1..]);
    let runs = [
        ("as it is", good.text.clone()),
        ("a wrong bit in a table", replaced(&good.text, row, &wrong_row)),
        ("a register too few", replaced(&good.text, register, &early)),
        ("valid a cycle early", replaced(&good.text, &valid(last), &valid(last - 1))),
    ];
    runs.into_par_iter().enumerate().for_each(|(number, (what, text))| {
        let folder = tempfile::tempdir().unwrap();
        for file in [&reference.file(&Verilog), &comparison, &script] {
            fs::write(folder.path().join(&file.name), &file.text).unwrap();
        }
        fs::write(folder.path().join(&good.name), text).unwrap();
        let ended = tool(folder.path(), "yosys", &["-Q", "-T", &script.name]);
        let fails = ended.stderr.contains("proof did fail");
        let ends_as_it_should =
            if number == 0 { ended.well && !fails } else { !ended.well && fails };
        if !ends_as_it_should {
            give_up(folder, what, &ended);
        }
    });
}
