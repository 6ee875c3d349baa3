//! Units in outside simulators, at what is committed and at random parameters.

use crate::committed::COMMITTED;
use crate::engines::Random;
use fixpath::hdl::Tables;
use fixpath::units::{Design, Kind, UNITS, Unit};
use fixpath::verify::{self, Request};
use std::collections::BTreeSet;
use std::time::Duration;

/// All tools take a design, and each of them agrees.
fn agrees(design: &Design, tables: Option<Tables>, context: &str) {
    let limit = Duration::from_secs(900);
    let request = Request { tables, limit, ..Request::default() };
    let rows = verify::verify(design, &request, &|_| {}).unwrap();
    for row in &rows {
        assert!(row.agrees(), "{context}: {row:#?}");
    }
    let hard: usize = design.hard.iter().map(|case| case.words.len()).sum();
    for (row, random) in rows.iter().zip([10_000, 1_000_000, 10_000]) {
        assert_eq!((row.vectors, row.mismatches), (hard as u64 + random, 0), "{context}: {row:#?}");
    }
}

/// The whole hard-case list, 10^6 random vectors in Verilator, 10^4 in Icarus and GHDL.
#[test]
#[ignore = "needs verilator, iverilog, ghdl and yosys: testbenches/run installs them"]
fn committed_settings_agree_in_every_tool() {
    for (name, unit, assignments) in COMMITTED {
        let design = Unit::find(unit).unwrap().values(assignments).unwrap().build().unwrap();
        agrees(&design, None, name);
    }
}

/// A value for each parameter, legal alone: the ends of ranges, and any.
fn random_assignments(unit: &'static Unit, random: &mut Random) -> Vec<String> {
    let assignment = |param: &fixpath::units::Param| {
        let value = match param.kind {
            Kind::Choice(names) => names[random.below(names.len())].to_owned(),
            Kind::Int { auto: Some(_), .. } if random.below(2) == 0 => "auto".to_owned(),
            Kind::Int { min, max, .. } => {
                // Large tables take long in slow simulators and show nothing new; a period of
                // a microsecond is as good as none.
                let max = match param.name {
                    name if name.ends_with("addr_bits") => max.min(11),
                    "period_ps" => 10_000,
                    "stages" => 20,
                    _ => max,
                };
                let any = min + random.below((max - min + 1) as usize) as i64;
                [min, max, any, any, any, any][random.below(6)].to_string()
            }
        };
        format!("{}={value}", param.name)
    };
    unit.all_params().map(assignment).collect()
}

/// Legal sets of parameters that are drawn with a seed, each with its design.
fn random_designs(unit: &'static Unit, count: usize, seed: u64) -> Vec<(Vec<String>, Design)> {
    let mut random = Random::new(seed);
    let mut designs = Vec::new();
    while designs.len() < count {
        let assignments = random_assignments(unit, &mut random);
        let design = unit.values(&assignments).and_then(|values| values.build());
        // Widths that don't go together, or too few stages.
        if let Ok(design) = design
            && design.rtl().is_ok()
        {
            designs.push((assignments, design));
        }
    }
    designs
}

const SETS: usize = 12;
const SEED: u64 = 7;

/// The sets drawn have every choice of every parameter among them.
#[test]
fn random_parameters_have_every_choice() {
    for unit in UNITS {
        let drawn: BTreeSet<String> =
            random_designs(unit, SETS, SEED).into_iter().flat_map(|(set, _)| set).collect();
        for param in unit.all_params() {
            if let Kind::Choice(names) = param.kind {
                for name in names {
                    let choice = format!("{}={name}", param.name);
                    assert!(drawn.contains(&choice), "{}: {choice} was never drawn", unit.name);
                }
            }
        }
    }
}

/// Tables stand in every place that they can.
#[test]
#[ignore = "needs verilator, iverilog, ghdl and yosys: testbenches/run installs them"]
fn random_parameters_agree_in_every_tool() {
    let places = [None, Some(Tables::Inline), Some(Tables::Files), Some(Tables::Case)];
    for unit in UNITS {
        for (number, (set, design)) in random_designs(unit, SETS, SEED).iter().enumerate() {
            agrees(design, places[number % places.len()], &set.join(" "));
        }
    }
}

/// The command line of `hdl` and `verify`, with tools that are missing or lie.
mod commands {
    use assert_cmd::Command;
    use std::collections::BTreeMap;
    use std::fs;
    use std::path::Path;

    fn fixpath(args: &[&str]) -> Command {
        let mut command = Command::cargo_bin("fixpath").unwrap();
        command.args(args);
        command
    }

    fn ended(command: &mut Command) -> (i32, String, String) {
        let output = command.output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
        (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
    }

    fn refused(args: &[&str], says: &str) {
        let (code, stdout, stderr) = ended(&mut fixpath(args));
        assert_eq!((code, stdout.as_str()), (2, ""), "{args:?}: {stderr}");
        assert_eq!(stderr.trim_end().lines().count(), 1, "{args:?}: {stderr}");
        assert!(stderr.contains(says), "{args:?}: {stderr}");
    }

    fn contents(folder: &Path) -> BTreeMap<String, String> {
        let file = |entry: std::io::Result<fs::DirEntry>| {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(path).unwrap())
        };
        fs::read_dir(folder).unwrap().map(file).collect()
    }

    /// A program of our own in a folder that stands for all that is installed.
    fn program(folder: &Path, name: &str, script: &str) {
        use std::os::unix::fs::PermissionsExt;
        let path = folder.join(name);
        fs::write(&path, format!("#!/bin/sh\n{script}\n")).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    }

    #[test]
    fn hdl_writes_the_same_files_in_every_run_and_names_them_all() {
        let made = [(), ()].map(|()| {
            let folder = tempfile::tempdir().unwrap();
            let out = folder.path().join("new/rtl");
            let args = ["hdl", "rotation", "-p", "variant=corrected", "--vectors", "20", "--out"];
            let mut command = fixpath(&args);
            let (code, told, stderr) = ended(command.arg(&out));
            assert_eq!((code, stderr.as_str()), (0, ""));
            let files = contents(&out);
            for name in files.keys() {
                assert!(told.contains(&format!("  {name}")), "{name} is not told: {told}");
            }
            files
        });
        assert!(made[0] == made[1], "a file changes from run to run");
        let [files, _] = made;
        for name in [
            "rotation.v",
            "rotation.vhd",
            "rotation_tb.v",
            "rotation_tb.vhd",
            "rotation_harness.cpp",
            "rotation_icarus.mk",
            "rotation_verilator.mk",
            "rotation_ghdl.mk",
            "rotation.ys",
            "rotation_files.txt",
            "rotation_vectors.txt",
            "rotation_sincos.hex",
        ] {
            assert!(files.contains_key(name), "{name} is missing");
            let listed = files["rotation_files.txt"].lines().any(|line| line == name);
            assert!(listed || name == "rotation_files.txt", "{name} is not in the list");
        }
        // The head says what made it.
        for says in
            ["variant=corrected", "latency 11 cycles", "fixpath 0.1.0", "angle: mean", "at most"]
        {
            assert!(files["rotation.v"].contains(says), "the head lacks {says}");
        }
    }

    #[test]
    fn hdl_refuses_and_leaves_what_was_there() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_str().unwrap();
        fs::write(folder.path().join("rotation.v"), "mine").unwrap();
        refused(
            &[
                "hdl",
                "rotation",
                "--out",
                out,
                "--tables",
                "inline",
                "-p",
                "table_addr_bits=20",
                "-p",
                "angle_bits=22",
            ],
            "1048576 table rows in line and 65536 is the most: put tables into files",
        );
        refused(
            &["hdl", "rotation", "--out", out, "-p", "stages=0"],
            "parameter `stages` = `0`: legal is 1 or more with rom=block, or rom=distributed",
        );
        for name in ["Rotation", "2nd", "a__b", "a_", "", "a b", "../a", "module", "entity", "clk"]
        {
            refused(&["hdl", "rotation", "--out", out, "--name", name], &format!("`{name}` is "));
        }
        refused(&["hdl", "rotation", "--out", out, "--language", "systemc"], "verilog, vhdl");
        let file = folder.path().join("rotation.v");
        assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
        assert_eq!(contents(folder.path()).len(), 1);
        // A file where the folder should be.
        refused(&["hdl", "rotation", "--out", file.to_str().unwrap()], "can't make the folder");
    }

    #[test]
    fn a_missing_tool_is_named_with_its_package() {
        let nothing = tempfile::tempdir().unwrap();
        for (tool, package) in [
            ("icarus", "iverilog"),
            ("verilator", "verilator"),
            ("ghdl", "ghdl"),
            ("yosys", "yosys"),
        ] {
            let mut command = fixpath(&["verify", "rotation", "--with", tool]);
            let (code, stdout, stderr) = ended(command.env("PATH", nothing.path()));
            assert_eq!((code, stdout.as_str()), (2, ""), "{stderr}");
            let says = format!("{tool} is not found: `apt-get install {package}` brings it");
            assert!(stderr.contains(&says), "{stderr}");
        }
        let mut command = fixpath(&["verify", "rotation"]);
        assert_eq!(ended(command.env("PATH", nothing.path())).0, 2);
        refused(
            &["verify", "rotation", "--with", "modelsim"],
            "parameter `with` = `modelsim`: legal is icarus, verilator, ghdl, yosys",
        );
    }

    /// What a simulator says is believed, and shown decoded; the others are named as missing.
    #[test]
    fn a_mismatch_is_shown_with_its_input_decoded_and_ends_with_1() {
        let tools = tempfile::tempdir().unwrap();
        program(tools.path(), "iverilog", "echo 'Icarus Verilog version 99.5 (fake)'");
        let says = "mismatch: vector 0 y expected 10000 got 0ffff";
        program(
            tools.path(),
            "vvp",
            &format!("echo '{says}'; echo 'FAIL 3 mismatches in 7 vectors'; exit 1"),
        );
        let mut command = fixpath(&["verify", "rotation"]);
        let (code, told, stderr) = ended(command.env("PATH", tools.path()));
        assert_eq!((code, stderr.as_str()), (1, ""), "{told}");
        let row = told.lines().find(|line| line.trim().starts_with("icarus")).unwrap();
        let row: Vec<&str> = row.split_whitespace().collect();
        assert_eq!(row[..4], ["icarus", "99.5", "7", "3"]);
        assert_eq!(row[5], "DISAGREES");
        for says in [
            "`apt-get install ghdl` brings it",
            "first mismatch in icarus: vector 0",
            "phi_a = ",
            "y should be 10000 (word 65536, value 1)",
            "y is        0ffff (word 65535, value 0.9999847412109375)",
        ] {
            assert!(told.contains(says), "no `{says}` in {told}");
        }
        // The same for programs to read.
        let mut command = fixpath(&["verify", "rotation", "--with", "icarus", "--json"]);
        let (code, told, _) = ended(command.env("PATH", tools.path()));
        let json: serde_json::Value = serde_json::from_str(&told).unwrap();
        assert_eq!(code, 1);
        let row = &json["rows"][0];
        assert_eq!(row["mismatches"], 3);
        assert_eq!(row["verdict"]["disagrees"]["got"]["raw"], 65535);
        assert_eq!(row["verdict"]["disagrees"]["inputs"].as_array().unwrap().len(), 4);
    }

    /// A verdict that isn't one, a warning, an end without one, and a run past the limit.
    #[test]
    fn a_simulator_that_fails_is_no_agreement() {
        for (iverilog, vvp, says) in [
            ("exit 0", "exit 0", "FAILED: vvp gave no verdict"),
            ("exit 0", "echo PASS 0 vectors", "FAILED: vvp took 0 of"),
            ("exit 0", "echo PASS; exit 3", "FAILED: vvp ended with status 3: PASS"),
            ("echo careful >&2", "exit 0", "FAILED: iverilog warns: careful"),
            ("echo no good >&2; exit 2", "exit 0", "FAILED: iverilog ended with status 2: no good"),
            ("exit 0", "while true; do :; done", "TIMED OUT: vvp ran past the limit"),
        ] {
            let tools = tempfile::tempdir().unwrap();
            let version = "if [ \"$1\" = -V ]; then echo 1.0; exit; fi";
            program(tools.path(), "iverilog", &format!("{version}; {iverilog}"));
            program(tools.path(), "vvp", vvp);
            let args = ["verify", "rotation", "--with", "icarus", "--time-limit", "2"];
            let (code, told, stderr) = ended(fixpath(&args).env("PATH", tools.path()));
            assert_eq!(code, 1, "{told}{stderr}");
            assert!(told.contains(says), "no `{says}` in {told}");
        }
    }
}
