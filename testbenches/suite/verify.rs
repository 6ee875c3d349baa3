//! Units in external simulators, at the committed settings and at random parameters.

use crate::committed::COMMITTED;
use crate::common;
use crate::engines::Random;
use crate::record::recorded;
use fixpath::emit::{Package, Settings};
use fixpath::hdl::Tables;
use fixpath::units::{Design, Kind, UNITS, Unit};
use fixpath::verify::{self, Request, Simulator};
use rayon::prelude::*;
use serde_json::json;
use std::collections::BTreeSet;
use std::time::Duration;

/// How thoroughly a design is checked.
#[derive(Clone, Copy)]
enum Effort {
    /// Every tool: 10^6 random vectors in Verilator, 10^3 in Icarus and GHDL. Recorded: 10^4 in the
    /// latter two, and the proof by Yosys. At settings that aren't committed all runs are recorded.
    Long,
    /// As [`Effort::Long`], with 10^5 vectors in Verilator.
    Normal,
    /// 10^5 in Verilator, 10^3 in Icarus and GHDL, all recorded: for hardware that differs in
    /// structure, but is driven in the same way.
    Brief,
}

/// Committed settings whose proof ends well within its limit; larger ones may not.
const PROVED: &[&str] = &[
    "rotation_exact",
    "rotation_exact_polar_table",
    "rotation_corrected",
    "rotation_printed",
    "rotation_corrected_shared",
    "illumination",
    "kugler",
    "sampler",
    "dot",
    "normalise",
    "rsqrt",
    "rsqrt_newton",
    "cross_product",
    "emboss_printed",
];

/// Random vectors for slow simulators in every run of the suite; recorded runs have more.
const BRIEF: u64 = 1_000;

/// A design's runs in some tools.
struct Check {
    simulators: Vec<Simulator>,
    random: u64,
    /// Time limit of the proof; 0 for none.
    proof_seconds: u64,
    /// The name of its record, if it is slow.
    record: Option<String>,
}

/// The tool runs for a design; each includes the whole hard-case list.
fn checks(effort: Effort, context: &str) -> Vec<Check> {
    use Simulator::{Ghdl, Icarus, Verilator, Yosys};
    let check = |simulators: &[Simulator], random| Check {
        simulators: simulators.to_vec(),
        random,
        proof_seconds: 0,
        record: None,
    };
    let fast = if matches!(effort, Effort::Long) { 1_000_000 } else { 100_000 };
    let is_committed = COMMITTED.iter().any(|(name, ..)| *name == context);
    let record = (!is_committed).then(|| format!("verilator {context}"));
    let mut checks = vec![Check { record, ..check(&[Verilator], fast) }];
    if !matches!(effort, Effort::Brief) {
        for simulator in [Ghdl, Icarus] {
            let record = Some(format!("{} {context}", simulator.name()));
            checks.push(Check { record, ..check(&[simulator], 10_000) });
        }
        // A proof that doesn't end shows nothing, so only settings with a known proof get a long
        // limit. The others have a record with another name, which stands for no proof.
        let (proof_seconds, kind) =
            if PROVED.contains(&context) { (300, "proof") } else { (5, "search") };
        let record = Some(format!("{kind} {context}"));
        checks.push(Check { proof_seconds, record, ..check(&[Yosys], 0) });
        checks.push(check(&[Yosys], 0));
    }
    if is_committed {
        checks.push(check(&[Ghdl, Icarus], BRIEF));
        return checks;
    }
    for simulator in [Ghdl, Icarus] {
        let record = Some(format!("{} brief {context}", simulator.name()));
        checks.push(Check { record, ..check(&[simulator], BRIEF) });
    }
    checks
}

/// All inputs on which the slow run of a check depends.
fn input_of(design: &Design, request: &Request) -> Vec<String> {
    let is_proof = request.simulators == [Simulator::Yosys];
    if is_proof {
        let proofs = verify::Proof::all(design).unwrap();
        return proofs.into_iter().flat_map(|proof| proof.files).map(|file| file.text).collect();
    }
    // The first vectors and their number stand for all: they are one stream.
    let random = request.vectors.unwrap();
    let settings = Settings {
        tables: request.tables,
        random: random.min(10_000),
        seed: request.seed,
        figures: false,
        ..Settings::default()
    };
    let mut package = Package::new(design, &settings).unwrap();
    let mut vectors = Vec::new();
    package.vectors.write(&mut vectors).unwrap();
    let files = package.hardware.iter().chain(&package.companions);
    let mut texts: Vec<String> = files.map(|file| file.text.clone()).collect();
    texts.push(String::from_utf8(vectors).unwrap());
    if random > 10_000 {
        texts.push(random.to_string());
    }
    texts
}

/// The tools of a check agree.
fn agrees(design: &Design, tables: Option<Tables>, check: &Check, context: &str) {
    let request = Request {
        simulators: check.simulators.clone(),
        vectors: Some(check.random),
        tables,
        limit: Duration::from_secs(1800),
        proof_limit: Duration::from_secs(check.proof_seconds),
        ..Request::default()
    };
    let hard: usize = design.hard.iter().map(|case| case.words.len()).sum();
    let is_due = check.proof_seconds > 0 && PROVED.contains(&context);
    let shown = match check.proof_seconds {
        0 => "agrees",
        _ if is_due => "proved",
        // Whether such a proof ends depends on the machine.
        _ => "no counterexample in time",
    };
    let run = || {
        for row in verify::verify(design, &request, &|_| {}).unwrap() {
            let is_proof = row.tool == Simulator::Yosys.name();
            let may_be_unproved = is_proof && !is_due;
            assert!(row.agrees() || may_be_unproved && row.is_unproved(), "{context}: {row:#?}");
            let vectors = if is_proof { 0 } else { hard as u64 + check.random };
            assert_eq!((row.vectors, row.mismatches), (vectors, 0), "{context}: {row:#?}");
        }
        json!(shown)
    };
    let Some(name) = &check.record else {
        run();
        return;
    };
    let input = input_of(design, &request);
    let input: Vec<&str> = input.iter().map(String::as_str).collect();
    let result = recorded(name, check.simulators[0].tools()[0], &input, run);
    assert_eq!(result, shown, "{context}");
}

/// Runs all checks of all designs as separate jobs, so that every core stays busy until the end.
fn all_agree(designs: Vec<(String, Design, Option<Tables>, Effort)>) {
    let jobs: Vec<_> = designs
        .iter()
        .flat_map(|(context, design, tables, effort)| {
            let checks = checks(*effort, context).into_iter();
            checks.map(move |check| (context, design, *tables, check))
        })
        .collect();
    jobs.into_par_iter().with_max_len(1).for_each(|(context, design, tables, check)| {
        agrees(design, tables, &check, context);
    });
}

#[test]
#[ignore = "needs verilator, iverilog, ghdl and yosys: testbenches/run installs them"]
fn committed_settings_agree_in_every_tool() {
    let design = |(name, unit, assignments): &(&str, &str, &[&str])| {
        let design = common::design(unit, assignments);
        let effort = if *unit == "rotation" { Effort::Long } else { Effort::Normal };
        ((*name).to_owned(), design, None, effort)
    };
    all_agree(COMMITTED.iter().map(design).collect());
}

/// A value for each parameter, legal by itself: ends of ranges, or any value. One assignment may be
/// given.
fn random_assignments(
    unit: &'static Unit,
    given: Option<&str>,
    random: &mut Random,
) -> Vec<String> {
    let assignment = |param: &fixpath::units::Param| {
        let value = match &param.kind {
            Kind::Choice(names) => names[random.below(names.len())].to_string(),
            Kind::Real { min, max } => {
                let share = f64::from(u32::try_from(random.below(1025)).unwrap()) / 1024.0;
                (min + (max - min) * share).to_string()
            }
            Kind::Int { auto: Some(_), .. } if random.below(2) == 0 => "auto".to_owned(),
            &Kind::Int { min, max, .. } => {
                // Large tables take long in slow simulators and show nothing new; a period of a
                // microsecond equals no limit.
                let max = match param.name.as_str() {
                    name if name.ends_with("addr_bits") => max.min(11),
                    "period_ps" => 10_000,
                    "stages" => 20,
                    // Usually some are shared.
                    name if name.starts_with("share_") => max.min(4),
                    "interval" => max.min(40),
                    _ => max,
                };
                let any = min + random.below((max - min + 1) as usize) as i64;
                [min, max, any, any, any, any][random.below(6)].to_string()
            }
        };
        format!("{}={value}", param.name)
    };
    let mut set: Vec<String> = unit.all_params().map(assignment).collect();
    if let Some((name, _)) = given.and_then(|given| given.split_once('=')) {
        let is_it = |set: &&mut String| set.split_once('=').is_some_and(|(of, _)| of == name);
        set.iter_mut().filter(is_it).for_each(|set| *set = given.unwrap().to_owned());
    }
    // Parameters of a schedule that isn't drawn would be refused.
    let shared = set.iter().any(|set| set == "schedule=shared");
    if !shared {
        set.retain(|set| !set.starts_with("share_") && !set.starts_with("interval="));
    }
    if !set.iter().any(|set| set == "schedule=flat") {
        set.retain(|set| !set.starts_with("stages="));
    }
    set
}

/// Legal sets of parameters drawn with a seed, each with its design.
fn random_designs(
    unit: &'static Unit,
    given: Option<&str>,
    count: usize,
    seed: u64,
) -> Vec<(Vec<String>, Design)> {
    let mut random = Random::new(seed);
    let mut designs = Vec::new();
    let mut draws = 0;
    while designs.len() < count {
        draws += 1;
        assert!(draws < 20_000, "{}: {given:?} is hardly ever legal", unit.name);
        let assignments = random_assignments(unit, given, &mut random);
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

const SEED: u64 = 7;

/// Settings of all units that together contain every choice of every parameter: a dozen of the
/// first unit, and for each other unit those that add a choice.
fn random_settings() -> Vec<(Vec<String>, Design)> {
    let mut seen = BTreeSet::new();
    let mut settings = Vec::new();
    for (number, unit) in UNITS.iter().enumerate() {
        let least = if number == 0 { 12 } else { 1 };
        let mut own = 0;
        let choices = choices_of(unit);
        for (set, design) in random_designs(unit, None, 40, SEED) {
            let added = set.iter().any(|c| choices.contains(c) && !seen.contains(c));
            if added || own < least {
                seen.extend(set.iter().cloned());
                settings.push((set, design));
                own += 1;
            }
        }
        // Choices that few settings allow are drawn separately.
        for choice in choices {
            if !seen.contains(&choice) {
                let mut drawn = random_designs(unit, Some(&choice), 1, SEED);
                seen.extend(drawn[0].0.iter().cloned());
                settings.append(&mut drawn);
            }
        }
    }
    settings
}

/// Every `name=choice` of a unit.
fn choices_of(unit: &'static Unit) -> BTreeSet<String> {
    let of = |param: &fixpath::units::Param| -> Vec<String> {
        match &param.kind {
            Kind::Choice(names) => {
                names.iter().map(|name| format!("{}={name}", param.name)).collect()
            }
            Kind::Int { .. } | Kind::Real { .. } => Vec::new(),
        }
    };
    let mut choices: BTreeSet<String> = unit.all_params().flat_map(of).collect();
    // A printed schedule exists for the unit's defaults or not at all.
    let printed = "schedule=printed";
    let has = unit.values(&[printed]).and_then(|values| values.build()?.rtl());
    if has.is_err() {
        choices.remove(printed);
    }
    choices
}

#[test]
fn random_settings_have_every_choice() {
    let settings = random_settings();
    assert!(settings.len() < 12 + 6 * UNITS.len(), "{} settings take too long", settings.len());
    let drawn: BTreeSet<&String> = settings.iter().flat_map(|(set, _)| set).collect();
    for unit in UNITS.iter() {
        for choice in choices_of(unit) {
            assert!(drawn.contains(&choice), "{}: {choice} was never drawn", unit.name);
        }
    }
}

/// Tables are placed in every possible way.
#[test]
#[ignore = "needs verilator, iverilog, ghdl and yosys: testbenches/run installs them"]
fn random_settings_agree_in_every_tool() {
    let places = [None, Some(Tables::Inline), Some(Tables::Files), Some(Tables::Case)];
    let designs = random_settings().into_iter().enumerate().map(|(number, (set, design))| {
        let first = design.values.unit().name == UNITS[0].name;
        let effort = if first { Effort::Long } else { Effort::Brief };
        (set.join(" "), design, places[number % places.len()], effort)
    });
    all_agree(designs.collect());
}

/// The command line of `hdl` and `verify`, with tools that are missing or give false reports.
mod commands {
    use crate::common::{self, refused, told};
    use assert_cmd::Command;
    use std::collections::BTreeMap;
    use std::fs;
    use std::path::Path;
    #[cfg(target_os = "linux")]
    use std::thread;
    #[cfg(target_os = "linux")]
    use std::time::Duration;
    use std::time::Instant;

    fn fixpath(args: &[&str]) -> Command {
        let mut command = common::fixpath();
        command.args(args);
        command
    }

    fn ended(command: &mut Command) -> (i32, String, String) {
        told(command.output().unwrap())
    }

    fn contents(folder: &Path) -> BTreeMap<String, String> {
        let file = |entry: std::io::Result<fs::DirEntry>| {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(path).unwrap())
        };
        // A hidden folder beside them records what was made.
        let is_file = |entry: &std::io::Result<fs::DirEntry>| {
            entry.as_ref().unwrap().file_type().unwrap().is_file()
        };
        fs::read_dir(folder).unwrap().filter(is_file).map(file).collect()
    }

    /// A program of our own in a folder that replaces all installed programs.
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
                assert!(told.contains(&format!("  {name}")), "{name} is not reported: {told}");
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
        // The head names the program and the settings that made it.
        for says in [
            "variant=corrected",
            "latency 11 cycles",
            "fixpath 0.1.0",
            "angle: mean",
            "largest seen",
        ] {
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
            "1048576 inline table rows; the limit is 65536: put tables into files",
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
        // A file in place of the folder.
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
            let says = format!("{tool} is not found: install it with `apt-get install {package}`");
            assert!(stderr.contains(&says), "{stderr}");
        }
        let mut command = fixpath(&["verify", "rotation"]);
        assert_eq!(ended(command.env("PATH", nothing.path())).0, 2);
        refused(
            &["verify", "rotation", "--with", "modelsim"],
            "no simulator `modelsim`: legal is icarus, verilator, ghdl, yosys",
        );
    }

    /// The simulator's verdict is believed, and its mismatch is shown decoded. Other tools are
    /// reported as missing.
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
            "install it with `apt-get install ghdl`",
            "first mismatch in icarus: vector 0",
            "phi_a = ",
            "y should be 10000 (word 65536, value 1)",
            "y is        0ffff (word 65535, value 0.9999847412109375)",
        ] {
            assert!(told.contains(says), "no `{says}` in {told}");
        }
        // The same in machine-readable form.
        let mut command = fixpath(&["verify", "rotation", "--with", "icarus", "--json"]);
        let (code, told, _) = ended(command.env("PATH", tools.path()));
        let json: serde_json::Value = serde_json::from_str(&told).unwrap();
        assert_eq!(code, 1);
        let row = &json["rows"][0];
        assert_eq!(row["mismatches"], 3);
        assert_eq!(row["verdict"]["disagrees"]["got"]["raw"], 65535);
        assert_eq!(row["verdict"]["disagrees"]["inputs"].as_array().unwrap().len(), 4);
    }

    /// A wrong verdict, a warning, an end without a verdict, and a run beyond the time limit.
    #[test]
    fn a_simulator_that_fails_is_no_agreement() {
        // Exit code 1 if the tool reports something about the hardware, otherwise 2.
        for (ends, iverilog, vvp, says) in [
            (1, "exit 0", "exit 0", "FAILED: vvp gave no verdict"),
            (1, "exit 0", "echo PASS 0 vectors", "FAILED: vvp read 0 of"),
            (1, "exit 0", "echo PASS; exit 3", "FAILED: vvp ended with status 3: PASS"),
            (1, "echo careful >&2", "exit 0", "FAILED: iverilog warns: careful"),
            (1, "echo no good >&2; exit 2", "", "FAILED: iverilog ended with status 2: no good"),
            (2, "exit 0", "while true; do :; done", "TIMED OUT: vvp ran past the limit"),
            (2, "exit 0", "echo no library >&2; exit 127", "COULD NOT RUN: vvp ended with status"),
            (2, "exit 0", "echo No space left on device; exit 1", "COULD NOT RUN: vvp ended with"),
            (2, "exit 0", "kill -15 $$", "COULD NOT RUN: vvp was killed by signal 15"),
            (2, "exit 0", "kill -9 $$", "OUT OF MEMORY: vvp ran out of memory"),
            // Failure of a program that the tool starts.
            (2, "sh -c 'kill -9 $$'; exit 137", "", "OUT OF MEMORY: iverilog ran out of memory"),
            (2, "exit 0", "exit 143", "COULD NOT RUN: vvp was killed by signal 15"),
            (
                2,
                "echo 'Killed signal terminated program x'; exit 2",
                "",
                "OUT OF MEMORY: iverilog ran out of memory",
            ),
            (
                2,
                "exit 0",
                "echo std::bad_alloc >&2; exit 1",
                "OUT OF MEMORY: vvp ran out of memory",
            ),
        ] {
            let tools = tempfile::tempdir().unwrap();
            let version = "if [ \"$1\" = -V ]; then echo 1.0; exit; fi";
            program(tools.path(), "iverilog", &format!("{version}; {iverilog}"));
            // Its version is queried too, with a limit of a minute.
            program(tools.path(), "vvp", &format!("{version}; {vvp}"));
            let args = ["verify", "rotation", "--with", "icarus", "--time-limit", "2"];
            let (code, told, stderr) = ended(fixpath(&args).env("PATH", tools.path()));
            assert_eq!(code, ends, "{told}{stderr}");
            assert!(told.contains(says), "no `{says}` in {told}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn memory_is_limited() {
        let eats = |gib: &str| {
            let tools = fake_icarus("exec perl -e '$word = \"x\" x (3 << 29); print \"PASS\\n\"'");
            let mut command = fixpath(&SMALL);
            command.args(["--with", "icarus", "--vectors", "0", "--memory-limit", gib]);
            let (code, told, _) = ended(command.env("PATH", before_the_system(tools.path())));
            (code, told)
        };
        let (code, told) = eats("1");
        assert!(
            code == 2 && told.contains("OUT OF MEMORY: vvp ran out of memory at 1.0 GiB"),
            "{told}"
        );
        // It gets enough memory, and reports no count of vectors.
        let (code, told) = eats("4");
        assert!(code == 1 && told.contains("FAILED: vvp gave no verdict: PASS"), "{told}");
    }

    /// The shells and makefiles of tools never see a path of the user.
    #[test]
    #[ignore = "needs iverilog and verilator: testbenches/run installs them"]
    fn no_folder_is_a_command() {
        let here = tempfile::tempdir().unwrap();
        for folder in ["d$(touch run)", "a b", "a;touch run;b", "quote'\"", "#$X"] {
            let mut command = fixpath(&SMALL);
            command.args(["--with", "icarus,verilator", "--vectors", "10", "--keep", folder]);
            let path = here.path().join(folder);
            fs::create_dir(&path).unwrap();
            command.env("TMPDIR", &path);
            let (code, told, stderr) = ended(command.current_dir(here.path()));
            assert_eq!(code, 0, "{folder}: {told}{stderr}");
            assert!(path.join("rotation.v").is_file(), "{folder}");
            assert!(path.join("obj_rotation/Vrotation").is_file(), "{folder}");
            assert!(!here.path().join("run").exists() && !path.join("run").exists(), "{folder}");
        }
    }

    /// Puts a folder of our own programs before the shell's.
    fn before_the_system(folder: &Path) -> String {
        format!("{}:/usr/bin:/bin", folder.display())
    }

    /// A design that builds very fast.
    const SMALL: [&str; 6] =
        ["verify", "rotation", "-p", "angle_bits=6", "-p", "table_addr_bits=4"];

    /// A fake Icarus: a compiler that does nothing, and a simulator that runs a script.
    fn fake_icarus(vvp: &str) -> tempfile::TempDir {
        let tools = tempfile::tempdir().unwrap();
        let version = "if [ \"$1\" = -V ]; then echo 1.0; exit; fi";
        program(tools.path(), "iverilog", version);
        program(tools.path(), "vvp", &format!("{version}\n{vvp}"));
        tools
    }

    /// Runs `verify --with icarus --vectors 0` with fake programs, and returns the time it took.
    fn with_fake_icarus(vvp: &str, more: &[&str]) -> (i32, String, f64) {
        let tools = fake_icarus(vvp);
        let mut command = fixpath(&SMALL);
        command.args(["--with", "icarus", "--vectors", "0"]).args(more);
        let start = Instant::now();
        let (code, told, stderr) = ended(command.env("PATH", before_the_system(tools.path())));
        (code, told + &stderr, start.elapsed().as_secs_f64())
    }

    /// A script that reports that all vectors of the file passed.
    const PASSES: &str = "echo PASS $(grep -c . rotation_vectors.txt) vectors";

    #[test]
    fn what_a_simulator_leaves_running_is_ended() {
        let (code, told, seconds) = with_fake_icarus(&format!("sleep 60 &\n{PASSES}"), &[]);
        assert_eq!(code, 0, "{told}");
        assert!(seconds < 30.0, "{seconds} s");
    }

    #[test]
    fn a_flood_of_words_ends_at_the_limit() {
        let (code, told, seconds) = with_fake_icarus("yes", &["--time-limit", "2"]);
        assert_eq!(code, 2, "{told}");
        assert!(told.contains("TIMED OUT: vvp ran past the limit of 2 s"), "{told}");
        assert!(told.contains("error: icarus did not finish"), "{told}");
        assert!(seconds < 15.0, "{seconds} s");
    }

    #[test]
    fn a_warning_beside_a_pass_is_no_agreement() {
        let (code, told, _) = with_fake_icarus(&format!("echo careful >&2; {PASSES}"), &[]);
        assert_eq!(code, 1, "{told}");
        assert!(told.contains("FAILED: vvp warns: careful"), "{told}");
    }

    /// A proof that doesn't end is reported as such, and is a failed check if a proof was
    /// requested.
    #[test]
    fn what_is_not_proved_is_no_agreement() {
        let tools = tempfile::tempdir().unwrap();
        let script = "case \"$*\" in -V) echo Yosys 0.23;; *equal.ys) exec /bin/sleep 60;; esac";
        program(tools.path(), "yosys", script);
        let proves = ["--time-limit", "1"];
        for (named, ends) in [(&["--with", "yosys"][..], 1), (&[], 0)] {
            let run = |more: &[&str]| {
                let mut command = fixpath(&SMALL);
                command.args(proves).args(named).args(more);
                ended(command.env("PATH", tools.path()))
            };
            let (code, told, stderr) = run(&[]);
            assert_eq!(code, ends, "{told}{stderr}");
            assert!(told.contains("NOT PROVED: no latch; not proved equal"), "{told}");
            assert!(!told.contains("agrees"), "{told}");
            let (code, json, _) = run(&["--json"]);
            assert_eq!(code, ends);
            let json: serde_json::Value = serde_json::from_str(&json).unwrap();
            let rows = json["rows"].as_array().unwrap();
            let row = rows.iter().find(|row| row["tool"] == "yosys").unwrap();
            assert!(row["verdict"]["unproved"].is_string(), "{row}");
        }
    }

    #[test]
    fn a_tool_of_a_tool_that_is_missing_is_named() {
        let tools = tempfile::tempdir().unwrap();
        program(tools.path(), "iverilog", "echo 1.0");
        let mut command = fixpath(&SMALL);
        command.args(["--with", "icarus"]);
        let (code, stdout, stderr) = ended(command.env("PATH", tools.path()));
        assert_eq!((code, stdout.as_str()), (2, ""), "{stderr}");
        let says = "vvp is not found: install it with `apt-get install iverilog`";
        assert!(stderr.contains(says), "{stderr}");
    }

    /// A tool that breaks has its own row, and the rows of the others remain.
    #[test]
    fn a_broken_tool_hides_no_mismatch() {
        let says = "mismatch: vector 0 y expected 10000 got 0ffff";
        let tools =
            fake_icarus(&format!("echo '{says}'; echo FAIL 1 mismatches in 5 vectors; exit 1"));
        let version = "if [ \"$1\" = --version ]; then echo GHDL 4.1; exit; fi";
        program(tools.path(), "ghdl", &format!("{version}; echo no library >&2; exit 127"));
        // Present but not executable.
        fs::write(tools.path().join("yosys"), "").unwrap();
        let (code, told, stderr) = ended(fixpath(&SMALL).env("PATH", tools.path()));
        assert_eq!((code, stderr.as_str()), (1, ""), "{told}");
        for (tool, says) in [
            ("icarus", "DISAGREES"),
            ("ghdl", "COULD NOT RUN: ghdl ended with status 127: no library"),
            ("verilator", "install it with `apt-get install verilator`"),
            ("yosys", "install it with `apt-get install yosys`"),
        ] {
            let row = told.lines().find(|line| line.trim().starts_with(tool));
            assert!(row.is_some_and(|row| row.contains(says)), "{tool}: no `{says}` in {told}");
        }
        assert!(told.contains("first mismatch in icarus: vector 0"), "{told}");
    }

    #[test]
    #[ignore = "needs verilator: testbenches/run installs it"]
    fn files_are_kept_in_a_folder_that_is_named_from_here() {
        let here = tempfile::tempdir().unwrap();
        let mut command = fixpath(&SMALL);
        command.args(["--with", "verilator", "--vectors", "10", "--keep", "kept/files"]);
        let (code, told, stderr) = ended(command.current_dir(here.path()));
        assert_eq!(code, 0, "{told}{stderr}");
        assert!(told.contains(" agrees"), "{told}");
        let kept = here.path().join("kept/files");
        for name in ["rotation.v", "rotation_harness.cpp", "rotation_vectors.txt"] {
            assert!(kept.join(name).is_file(), "{name} is not kept");
        }
        assert!(kept.join("obj_rotation/Vrotation").is_file(), "the program is not kept");
    }

    /// True for an existing process that hasn't ended.
    #[cfg(target_os = "linux")]
    fn is_running(id: &str) -> bool {
        let stat = fs::read_to_string(format!("/proc/{id}/stat")).unwrap_or_default();
        // Z: ended, but not yet waited for by its parent.
        stat.rsplit_once(") ").is_some_and(|(_, rest)| !rest.starts_with('Z'))
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_signal_ends_it_with_its_tools_and_files() {
        let told = tempfile::tempdir().unwrap();
        let scratch = tempfile::tempdir().unwrap();
        let ids = told.path().join("ids");
        // Written atomically: the file gets its final name when it contains both ids.
        let vvp = format!(
            ": > $TMPDIR/left.s\nsleep 300 &\necho $$ $! > {0}.new; mv {0}.new {0}; wait",
            ids.display()
        );
        let tools = fake_icarus(&vvp);
        let mut process = std::process::Command::new(assert_cmd::cargo::cargo_bin("fixpath"))
            .args(SMALL)
            .args(["--with", "icarus", "--vectors", "0"])
            .env("PATH", before_the_system(tools.path()))
            .env("TMPDIR", scratch.path())
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let start = Instant::now();
        while !ids.exists() {
            assert!(start.elapsed() < Duration::from_secs(60), "vvp has not started");
            thread::sleep(Duration::from_millis(20));
        }
        assert!(entries(scratch.path()) > 0, "its files are in TMPDIR");
        let ids = fs::read_to_string(&ids).unwrap();
        assert!(ids.split_whitespace().all(is_running), "{ids}");
        let id = process.id().to_string();
        let kill = std::process::Command::new("kill").args(["-TERM", &id]).status().unwrap();
        assert!(kill.success());
        let start = Instant::now();
        let status = loop {
            if let Some(status) = process.try_wait().unwrap() {
                break status;
            }
            if start.elapsed() > Duration::from_secs(20) {
                process.kill().unwrap();
                panic!("a signal doesn't end it");
            }
            thread::sleep(Duration::from_millis(20));
        };
        assert_eq!(status.code(), Some(143), "128 + SIGTERM");
        assert_eq!(entries(scratch.path()), 0, "files are left in TMPDIR");
        // A signal takes a moment to arrive.
        let start = Instant::now();
        while ids.split_whitespace().any(is_running) {
            assert!(start.elapsed() < Duration::from_secs(5), "one of {ids} still runs");
            thread::sleep(Duration::from_millis(20));
        }
    }

    #[cfg(target_os = "linux")]
    fn entries(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }
}
