//! The command line as scripts use it: results, exit codes, messages, and complete files.

use crate::common::{fixpath, refused, run};
use std::fs;
use std::path::Path;

fn is_empty(folder: &Path) -> bool {
    fs::read_dir(folder).unwrap().next().is_none()
}

#[test]
fn units_and_parameters_are_checked_and_the_nearest_is_named() {
    refused(
        &["show", "rotatoin"],
        "error: no unit `rotatoin`, did you mean `rotation`: `fixpath list` names them all",
    );
    refused(
        &["show", "rotation", "-p", "angel_bits=8"],
        "error: unit `rotation` has no parameter `angel_bits`, did you mean `angle_bits`: `fixpath list rotation` names them all",
    );
    refused(
        &["show", "rotation", "-p", "angle_bits=0"],
        "error: parameter `angle_bits` = `0`: legal is 2 to 24",
    );
    refused(
        &["sim", "rotation", "-p", "frac_bits=64"],
        "error: parameter `frac_bits` = `64`: legal is 2 to 32",
    );
    refused(
        &["sim", "rotation", "-p", "table_addr_bits=40"],
        "error: parameter `table_addr_bits` = `40`: legal is 2 to 20",
    );
    refused(
        &["sim", "rotation", "-p", "scheme=cubic"],
        "error: parameter `scheme` = `cubic`: legal is direct, linear, bipartite",
    );
    refused(&["sim", "rotation", "-p", "scheme"], "error: `scheme` is not of the form key=value");
    refused(
        &["sim", "rotation", "-p", "angle_bits=99999999999999999999"],
        "error: parameter `angle_bits` = `99999999999999999999`: legal is 2 to 24",
    );
    refused(
        &["sim", "rotation", "-p", "variant=corrected", "-p", "output=cartesian"],
        "error: parameter `output` = `cartesian`: legal is auto or polar-table when variant=corrected",
    );
}

#[test]
fn a_shared_schedule_is_printed_and_its_figures_agree() {
    let set = ["-p", "schedule=shared", "-p", "share_mul=1", "-p", "share_add=2"];
    let with = |more: &[&'static str]| {
        let args: Vec<&str> =
            ["schedule", "illumination"].iter().chain(&set).chain(more).copied().collect();
        run(&args)
    };
    let (code, text, _) = with(&[]);
    assert_eq!(code, 0);
    assert!(text.contains("Cycle #") && text.contains("effect of one more unit"), "{text}");
    let (_, json, _) = with(&["--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    // Two products on one multiplier, 13 sums on two adders.
    assert_eq!(json["interval_cycles"], 7);
    assert_eq!(json["operators"]["multipliers"], 1);
    assert_eq!(json["operators"]["adders"], 2);
    assert!(text.contains("interval 7 cycles (shortest for these units: 7)"), "{text}");
    let units = json["units"].as_array().unwrap();
    let issued: usize = units.iter().map(|u| u["operations"].as_array().unwrap().len()).sum();
    assert_eq!((units.len(), issued), (3, 15));
    for (unit, title) in units.iter().zip(json["table"]["units"].as_array().unwrap()) {
        assert_eq!(unit["title"], *title);
        let column = json["table"]["units"].as_array().unwrap().iter().position(|t| t == title);
        for operation in unit["operations"].as_array().unwrap() {
            let row = operation["issue_cycle"].as_u64().unwrap() as usize - 1;
            let cell = json["table"]["rows"][row][column.unwrap()].as_str().unwrap();
            assert!(cell.contains(operation["formula"].as_str().unwrap()), "{cell}: {operation}");
        }
    }
    let (code, _, stderr) = with(&["-p", "interval=6"]);
    assert_eq!(code, 2);
    assert!(
        stderr.contains("parameter `interval` = `6`: legal is 7 or more: 13 operations"),
        "{stderr}"
    );
}

#[test]
fn words_past_63_bits_are_refused_with_the_node() {
    let args = ["-p", "variant=corrected", "-p", "frac_bits=32", "-p", "guard_bits=8"];
    refused(
        &[&["show", "rotation"], &args[..]].concat(),
        "words have at most 63: lower `frac_bits` or `guard_bits` or `recip_int_bits`",
    );
}

#[test]
fn every_parameter_at_both_ends_of_its_range_builds_or_says_why_not() {
    let (code, text, _) = run(&["list", "rotation", "--json"]);
    assert_eq!(code, 0);
    let units: serde_json::Value = serde_json::from_str(&text).unwrap();
    for param in units[0]["parameters"].as_array().unwrap() {
        let name = param["name"].as_str().unwrap();
        let choices = match param.get("choices") {
            Some(choices) => choices.as_array().unwrap().clone(),
            None => vec![param["min"].clone(), param["max"].clone()],
        };
        for choice in choices {
            let value = choice.as_str().map_or_else(|| choice.to_string(), str::to_owned);
            for variant in ["printed", "corrected", "exact"] {
                let set = format!("{name}={value}");
                let variant = format!("variant={variant}");
                let args = ["sim", "rotation", "--samples", "200", "-p", &variant, "-p", &set];
                let (code, _, stderr) = run(&args);
                let fine = code == 0 || code == 2 && stderr.starts_with("error: ");
                // Overflow mode `error` may stop a run, which is its purpose.
                let stopped = code == 1 && set == "overflow=error";
                assert!(fine || stopped, "{args:?}: {code} {stderr}");
            }
        }
    }
}

#[test]
fn eval_writes_words_values_and_golden() {
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    // Columns in another order, one more than needed, and with spaces.
    fs::write(&input, "note,theta_n,phi_n,theta_a,phi_a\na, 0, 0, 90, 90\nb,0,0,45,-360\n")
        .unwrap();
    let args =
        ["eval", "rotation", "-p", "scheme=linear", "--angle", "degrees", "--ignore-columns"];
    fixpath().args(args).arg("--in").arg(&input).arg("--out").arg(&out).assert().success();
    let text = fs::read_to_string(&out).unwrap();
    let mut lines = text.lines();
    assert_eq!(
        lines.next().unwrap(),
        "phi_a_q,phi_a_raw,theta_a_q,theta_a_raw,phi_n_q,phi_n_raw,theta_n_q,theta_n_raw,\
         x,x_raw,x_golden,y,y_raw,y_golden,z,z_raw,z_golden,clipped"
    );
    let row: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(row[..4], ["90.0", "16384", "90.0", "16384"]);
    let number = |i: usize| row[i].parse::<f64>().unwrap();
    assert!((number(11) - 1.0).abs() < 2e-5 && (number(13) - 1.0).abs() < 1e-15, "y is 1: {row:?}");
    assert_eq!(number(11), number(12) / 65536.0);
    let row: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(row[..2], ["0.0", "0"], "a whole turn is none");
    assert_eq!(lines.next(), None);
}

#[test]
fn eval_is_the_reference_on_every_hard_case() {
    use fixpath::units::rotation;
    let folder = tempfile::tempdir().unwrap();
    for assignments in [
        &["scheme=linear"][..],
        &["variant=corrected"],
        &["variant=printed"],
        &["output=polar-cordic"],
        &["output=polar-table", "scheme=bipartite"],
    ] {
        let design = rotation::unit().values(assignments).unwrap().build().unwrap();
        let rows: Vec<&Vec<i64>> = design.hard.iter().flat_map(|case| &case.words).collect();
        let mut csv = "phi_a,theta_a,phi_n,theta_n\n".to_owned();
        for row in &rows {
            let turns: Vec<String> =
                row.iter().map(|w| (*w as f64 / 65536.0).to_string()).collect();
            csv += &(turns.join(",") + "\n");
        }
        let (input, out) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
        fs::write(&input, csv).unwrap();
        let mut command = fixpath();
        command.args(["eval", "rotation", "--angle", "turns", "--in"]).arg(&input);
        for set in assignments {
            command.args(["-p", set]);
        }
        command.arg("--out").arg(&out).assert().success();
        let mut reader = csv::Reader::from_path(&out).unwrap();
        let mut count = 0;
        for (record, words) in reader.records().zip(&rows) {
            let record = record.unwrap();
            let (reference, _) = design.netlist.eval(words).unwrap();
            for (i, output) in design.netlist.outputs().iter().enumerate() {
                assert_eq!(record[8 + 3 * i + 1], reference[output.node.index()].to_string());
            }
            count += 1;
        }
        assert_eq!(count, rows.len());
    }
}

#[test]
fn malformed_csv_names_line_and_column_and_leaves_nothing() {
    let header = "phi_a,theta_a,phi_n,theta_n\n";
    let cases: [(&[u8], &str); 12] = [
        (
            b"",
            "in.csv, line 1: the file is empty; its first line should be phi_a,theta_a,phi_n,theta_n",
        ),
        (b"phi_a,theta_a,phi_n,theta_n\n", "in.csv, line 2: no rows after the header"),
        (b"phi_a,theta_a,phi_n\n1,2,3\n", "line 1, column `theta_n`: no such column"),
        (
            b"phi_a,phi_a,theta_a,phi_n,theta_n\n1,2,3,4,5\n",
            "line 1, column `phi_a`: the column occurs twice",
        ),
        (
            b"phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n1,2,3\n",
            "line 3: 3 fields where the header has 4",
        ),
        (b"phi_a,theta_a,phi_n,theta_n\n1,2,x,4\n", "line 2, column `phi_n`: `x` is not a number"),
        (b"phi_a,theta_a,phi_n,theta_n\n1,2,,4\n", "line 2, column `phi_n`: `` is not a number"),
        (
            b"phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n1,NaN,3,4\n",
            "line 3, column `theta_a`: `NaN` is not a finite number",
        ),
        (
            b"phi_a,theta_a,phi_n,theta_n\n1,2,3,-inf\n",
            "line 2, column `theta_n`: `-inf` is not a finite number",
        ),
        (
            b"phi_a,theta_a,phi_n,theta_n\n1,2,3,1e999\n",
            "line 2, column `theta_n`: `1e999` is not a finite number",
        ),
        (b"phi_a,theta_a,phi_n,theta_n\n1,2,3,\xff\n", "line 2: the text is not UTF-8"),
        (b"\xff\xfep\0h\0i\0", "line 1: the text is UTF-16: save it as UTF-8"),
    ];
    for (body, message) in cases {
        let folder = tempfile::tempdir().unwrap();
        let (input, out) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
        fs::write(&input, body).unwrap();
        let (input, out) = (input.to_str().unwrap(), out.to_str().unwrap());
        refused(&["eval", "rotation", "--in", input, "--out", out], message);
        refused(&["wave", "rotation", "--in", input, "--out", out], message);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "only the input is there");
    }
    // The previous file stays.
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    fs::write(&input, format!("{header}1,2,3,4\n1,2,3,oops\n")).unwrap();
    fs::write(&out, "precious").unwrap();
    fixpath()
        .args(["eval", "rotation", "--in"])
        .arg(&input)
        .arg("--out")
        .arg(&out)
        .assert()
        .code(2);
    assert_eq!(fs::read_to_string(&out).unwrap(), "precious");
}

#[test]
fn files_that_cannot_be_read_or_written_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path().to_str().unwrap();
    let input = folder.path().join("in.csv");
    fs::write(&input, "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n").unwrap();
    let input = input.to_str().unwrap();
    refused(
        &["eval", "rotation", "--in", "/no/such.csv", "--out", "o.csv"],
        "/no/such.csv: can't read: ",
    );
    refused(&["eval", "rotation", "--in", here, "--out", "o.csv"], "can't read: it is a folder");
    refused(
        &["eval", "rotation", "--in", input, "--out", "/no/such/out.csv"],
        "/no/such/out.csv: can't write: ",
    );
    refused(&["wave", "rotation", "--out", "/no/such/out.vcd"], "/no/such/out.vcd: can't write: ");
    let blocked = format!("{input}/sweep");
    refused(
        &["sweep", "rotation", "--axis", "angle_bits=8", "--samples", "10", "--out", &blocked],
        "sweep",
    );
    refused(&["demo", "--out", &blocked], "can't make the folder");
    assert!(!Path::new("o.csv").exists());
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_one_clear_line() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("in.csv");
    fs::write(&input, "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n").unwrap();
    let input = input.to_str().unwrap();
    // /dev/full is always full, and it stays a device.
    refused(
        &["eval", "rotation", "--in", input, "--out", "/dev/full"],
        "/dev/full: can't write: No space left",
    );
    refused(&["wave", "rotation", "--out", "/dev/full"], "no place for the save file");
    assert!(!Path::new("/dev/full.gtkw").exists());
    use std::os::unix::fs::FileTypeExt;
    assert!(fs::metadata("/dev/full").unwrap().file_type().is_char_device());
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    use std::process::Stdio;
    let mut child = std::process::Command::new(assert_cmd::cargo::cargo_bin("fixpath"))
        .args(["show", "rotation", "-p", "output=polar-cordic", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}

#[test]
fn sim_is_the_same_on_any_number_of_threads() {
    let figures = |threads: &str| {
        let args = ["--threads", threads, "sim", "rotation", "-p", "variant=corrected"];
        let args = [&args[..], &["--samples", "150000", "--seed", "9", "--json"]].concat();
        let (code, text, stderr) = run(&args);
        assert_eq!((code, stderr.as_str()), (0, ""), "no progress in a pipe");
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        value.as_object_mut().unwrap().remove("speed");
        value
    };
    let one = figures("1");
    assert_eq!(one, figures("2"));
    assert_eq!(one, figures("5"));
    assert_eq!(one["inputs"]["samples"], 150_000);
}

#[test]
fn sim_tells_bounds_verdicts_and_overflows() {
    let (code, text, _) = run(&["sim", "rotation", "-p", "scheme=linear", "--hard", "--json"]);
    assert_eq!(code, 0);
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["bound"]["holds"], true);
    let cases = value["hard_cases"].as_array().unwrap();
    assert!(cases.len() >= 10 && cases.iter().all(|case| case["holds"] == true));
    let (code, text, _) =
        run(&["sim", "rotation", "-p", "variant=corrected", "--samples", "20000"]);
    assert_eq!(code, 0);
    assert!(text.contains("no bound is stated: asin, 1/sin and 1/cos have infinite slopes"));
    assert!(text.contains("tan_phi"), "saturations are counted: {text}");
}

#[test]
fn overflow_mode_error_stops_with_exit_code_1() {
    let args = ["sim", "rotation", "-p", "overflow=error", "--samples", "1000"];
    let (code, _, stderr) = run(&args);
    assert_eq!((code, stderr.as_str()), (0, ""), "with an integer bit nothing overflows");
    let args = ["sim", "rotation", "-p", "overflow=error", "-p", "int_bits=0", "--hard"];
    let (code, stdout, stderr) = run(&args);
    assert_eq!((code, stdout.as_str()), (1, ""));
    assert!(stderr.starts_with("error: node `x` overflowed "), "{stderr}");
}

#[test]
fn an_exhaustive_run_that_is_too_long_is_refused() {
    refused(
        &["sim", "rotation", "--sampler", "exhaustive"],
        "the inputs have 2^64 combinations but an exhaustive run is limited to 2^32",
    );
    let (code, text, _) =
        run(&["sim", "rotation", "-p", "angle_bits=3", "--sampler", "exhaustive", "--json"]);
    assert_eq!(code, 0);
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["inputs"]["samples"], 4096);
}

#[test]
fn show_counts_what_the_seed_prints() {
    let counts = |variant: &str| -> serde_json::Value {
        let (code, text, _) =
            run(&["show", "rotation", "-p", &format!("variant={variant}"), "--json"]);
        assert_eq!(code, 0);
        serde_json::from_str::<serde_json::Value>(&text).unwrap()["counts"].clone()
    };
    for variant in ["printed", "corrected"] {
        let counts = counts(variant);
        assert_eq!(counts["datapath"]["multipliers"], 3);
        assert_eq!(counts["datapath"]["adders"], 8);
        assert_eq!(counts["tables"], 6);
    }
    assert_eq!(counts("exact")["datapath"]["multipliers"], 0);
    let (_, dot, _) = run(&["show", "rotation", "--dot"]);
    assert!(dot.starts_with("digraph rotation {") && dot.trim_end().ends_with('}'));
}

#[test]
fn wave_writes_a_pair_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("r.vcd");
    fixpath().args(["wave", "rotation", "--samples", "50", "--out"]).arg(&out).assert().success();
    assert!(fs::read_to_string(&out).unwrap().contains("$var wire 18"));
    let save = fs::read_to_string(folder.path().join("r.gtkw")).unwrap();
    assert!(save.contains("[dumpfile] \"r.vcd\"") && save.contains("rotation.x[1:-16]"));
    let out = folder.path().join("s.vcd");
    let out = out.to_str().unwrap();
    refused(&["wave", "rotation", "--signals", "nope*", "--out", out], "no signal matches `nope*`");
    assert!(!Path::new(out).exists());
}

#[test]
fn help_has_examples() {
    for command in ["list", "show", "eval", "sim", "wave", "sweep", "demo"] {
        let (code, text, _) = run(&[command, "--help"]);
        assert_eq!(code, 0);
        assert!(text.contains("Example"), "{command}: {text}");
    }
}

#[test]
fn an_empty_folder_stays_empty_when_nothing_is_asked_right() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("o");
    let out = out.to_str().unwrap();
    refused(&["sweep", "rotation", "--axis", "angle_bits=99", "--out", out], "angle_bits");
    refused(&["sweep", "rotation", "--axis", "nope=1", "--out", out], "no parameter `nope`");
    refused(&["sweep", "rotation", "--axis", "variant", "--out", out], "variant");
    assert!(is_empty(folder.path()));
}

#[test]
fn contradictions_are_refused() {
    refused(
        &["sim", "rotation", "-p", "angle_bits=8", "-p", "angle_bits=9"],
        "error: parameter `angle_bits` is given twice",
    );
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("o");
    let out = out.to_str().unwrap();
    let args = ["sweep", "rotation", "-p", "angle_bits=8", "--axis", "angle_bits=9", "--out", out];
    refused(&args, "error: parameter `angle_bits` is set with -p and swept by an axis");
    let input = folder.path().join("in.csv");
    fs::write(&input, "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n").unwrap();
    let input = input.to_str().unwrap();
    refused(&["eval", "rotation", "--in", input, "--out", input], "in.csv: is the input");
    assert!(fs::read_to_string(input).unwrap().starts_with("phi_a"));
    for args in [
        &["sim", "rotation", "--samples", "0"][..],
        &["--threads", "0", "list"],
        &["wave", "rotation", "--cycles", "5..2", "--out", "w.vcd"],
        &["wave", "rotation", "--samples", "0", "--out", "w.vcd"],
        &["lisst"],
        &["eval", "rotation", "--in", "a", "--out", "b", "--angle", "grad"],
    ] {
        refused(args, "error: ");
    }
}

#[test]
fn a_wave_is_a_pair_or_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    refused(&["wave", "rotation", "--out", &at("a.gtkw")], "no place for the save file");
    refused(
        &["wave", "rotation", "--samples", "20", "--cycles", "1000..2000", "--out", &at("b.vcd")],
        "cycles 1000..2000 are past the end",
    );
    assert!(is_empty(folder.path()));
    fs::create_dir(at("c.gtkw")).unwrap();
    fs::write(at("c.vcd"), "old").unwrap();
    refused(&["wave", "rotation", "--out", &at("c.vcd")], "c.gtkw: can't write");
    assert_eq!(fs::read_to_string(at("c.vcd")).unwrap(), "old");
    // A pattern of many stars is matched in linear time, and a window needs only its own samples.
    let stars = "*".repeat(40) + "q";
    refused(&["wave", "rotation", "--signals", &stars, "--out", &at("d.vcd")], "no signal matches");
    let args = ["wave", "rotation", "--samples", "10000000", "--cycles", "0..5", "--out"];
    fixpath().args(args).arg(at("e.vcd")).assert().success();
}

#[test]
#[cfg(unix)]
fn links_stay_links_and_temporary_names_stay_hidden() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("in.csv"), "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n").unwrap();
    std::os::unix::fs::symlink("there.csv", at("link.csv")).unwrap();
    let eval = |out: &str| {
        let mut command = fixpath();
        command.args(["eval", "rotation", "--in"]).arg(at("in.csv")).arg("--out").arg(at(out));
        command.output().unwrap()
    };
    for _ in 0..2 {
        assert!(eval("link.csv").status.success());
        assert!(fs::symlink_metadata(at("link.csv")).unwrap().is_symlink());
        assert!(fs::read_to_string(at("there.csv")).unwrap().starts_with("phi_a_q"));
    }
    let output = eval("none/out.csv");
    assert_eq!(output.status.code(), Some(2));
    assert!(!String::from_utf8(output.stderr).unwrap().contains(".fixpath-"));
}

#[test]
fn a_wave_stops_at_a_forbidden_overflow() {
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("in.csv"), folder.path().join("o.vcd"));
    // A along N: z is 1, which isn't representable without an integer bit.
    fs::write(&input, "phi_a,theta_a,phi_n,theta_n\n0,0.25,0,0\n0,0,0,0\n").unwrap();
    let args = ["wave", "rotation", "-p", "int_bits=0", "-p", "overflow=error", "--angle", "turns"];
    let mut command = fixpath();
    command.args(args).arg("--in").arg(&input).arg("--out").arg(&out);
    let output = command.output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(stderr.contains("overflowed") && !out.exists(), "{stderr}");
}

#[test]
fn a_run_that_overflows_stops_at_the_same_place_on_any_number_of_threads() {
    let message = |threads: &str| {
        let args = ["-p", "int_bits=0", "-p", "overflow=error", "--samples", "3000000"];
        let (code, _, stderr) =
            run(&[&["--threads", threads, "sim", "rotation"], &args[..]].concat());
        assert_eq!(code, 1);
        stderr
    };
    assert_eq!(message("1"), message("4"));
}

#[test]
fn every_hard_case_can_be_had_as_csv() {
    let folder = tempfile::tempdir().unwrap();
    let cases = folder.path().join("cases.csv");
    let args = ["sim", "rotation", "--hard", "-p", "table_addr_bits=6", "--json", "--cases"];
    let output = fixpath().args(args).arg(&cases).output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let mut worst = std::collections::BTreeMap::<String, f64>::new();
    let mut count = 0;
    for record in csv::Reader::from_path(&cases).unwrap().records() {
        let record = record.unwrap();
        let error: f64 = record[14].parse().unwrap();
        let entry = worst.entry(record[0].to_owned()).or_default();
        *entry = entry.max(error);
        assert_eq!(&record[17], "true");
        count += 1;
    }
    assert_eq!(value["inputs"]["samples"], count);
    // No random inputs are drawn.
    assert_eq!(value["inputs"]["seed"], serde_json::Value::Null);
    // The cases are usable as inputs unchanged.
    let to = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let cases = cases.to_str().unwrap();
    for (command, out) in [("eval", to("out.csv")), ("wave", to("out.vcd"))] {
        let args = [command, "rotation", "-p", "table_addr_bits=6", "--in", cases, "--out", &out];
        let (code, _, stderr) = run(&args);
        assert_eq!((code, stderr.as_str()), (0, ""), "{command}");
    }
    let read = csv::Reader::from_path(to("out.csv")).unwrap().records().count();
    assert_eq!(read, count);
    for case in value["hard_cases"].as_array().unwrap() {
        assert_eq!(case["error"].as_f64().unwrap(), worst[case["name"].as_str().unwrap()]);
    }
}

#[test]
fn a_sweep_leaves_somebodys_files_alone() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("report.md"), "mine").unwrap();
    let here = folder.path().to_str().unwrap();
    let args = ["sweep", "rotation", "--axis", "angle_bits=8", "--samples", "10", "--out", here];
    refused(&args, "report.md: is in the way and not from a sweep");
    assert_eq!(fs::read_to_string(folder.path().join("report.md")).unwrap(), "mine");
}

/// All options accept whole numbers in the same forms. A refused number is reported with its value
/// and the accepted forms.
#[test]
fn numbers_are_read_in_the_forms_that_people_write() {
    let sim = |samples: &str, seed: &str| {
        let args = ["sim", "rotation", "--json", "--samples", samples, "--seed", seed];
        let (code, text, stderr) = run(&args);
        assert_eq!((code, stderr.as_str()), (0, ""));
        serde_json::from_str::<serde_json::Value>(&text).unwrap()["inputs"].clone()
    };
    let should = sim("4096", "1000");
    assert_eq!(should["samples"], 4096);
    for (samples, seed) in [("4_096", "1e3"), ("2^12", "1_000"), ("4.096e3", "10^3")] {
        assert_eq!(sim(samples, seed), should);
    }
    for (args, option, legal) in [
        (&["sim", "rotation", "--samples"][..], "--samples <N>", "from 1 to 2^64-1"),
        (&["sim", "rotation", "--seed"], "--seed <N>", "from 0 to 2^64-1"),
        (&["sweep", "rotation", "--samples"], "--samples <N>", "from 1 to 2^64-1"),
        (&["wave", "rotation", "--samples"], "--samples <N>", "from 1 to 10000000"),
        (&["wave", "rotation", "--seed"], "--seed <N>", "from 0 to 2^64-1"),
        (&["hdl", "rotation", "--vectors"], "--vectors <N>", "from 0 to 100000000"),
        (&["hdl", "rotation", "--seed"], "--seed <N>", "from 0 to 2^64-1"),
        (&["verify", "rotation", "--vectors"], "--vectors <N>", "from 0 to 1000000000"),
        (&["verify", "rotation", "--time-limit"], "--time-limit <S>", "from 1 to 86400"),
        (&["cost", "rotation", "--time-limit"], "--time-limit <S>", "from 1 to 86400"),
        (&["compare", "--samples"], "--samples <N>", "from 1 to 2^64-1"),
        (&["compare", "--seed"], "--seed <N>", "from 0 to 2^64-1"),
        (&["--threads"], "--threads <N>", "from 1 to 1024"),
    ] {
        for value in ["many", "1.5", "-1", "1e99", ""] {
            let message = format!(
                "invalid value '{value}' for '{option}': write a whole number {legal}: in digits, or as 1_000, 1e3 or 2^10"
            );
            refused(&[args, &[value]].concat(), &message);
        }
    }
    refused(
        &["wave", "rotation", "--out", "w.vcd", "--cycles", "-5..2"],
        "invalid value '-5..2' for '--cycles <A..B>': write FIRST..END with FIRST below END",
    );
    refused(
        &["render", "plane", "--out", "o", "--pixels-per-degree", "many"],
        "invalid value 'many' for '--pixels-per-degree <X>': write a number, such as 60",
    );
}

/// A sampler or seed that has no effect is noted, and changes no result.
#[test]
fn samples_and_seeds_without_a_use_are_noted() {
    let sim = ["sim", "rotation", "-p", "angle_bits=3", "--json"];
    let hard = [&sim[..], &["--hard"]].concat();
    let exhaustive = [&sim[..], &["--sampler", "exhaustive"]].concat();
    let given = ["--samples", "10", "--seed", "7"];
    let figures =
        |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap()["figures"].clone();
    for (args, sampler) in [(hard, "hard"), (exhaustive, "exhaustive")] {
        let (code, without, stderr) = run(&args);
        assert_eq!((code, stderr.as_str()), (0, ""));
        let (code, with, stderr) = run(&[&args[..], &given].concat());
        assert_eq!((code, figures(&with)), (0, figures(&without)));
        let should = format!(
            "note: --samples has no effect: sampler {sampler} draws no random samples\n\
             note: --seed has no effect: sampler {sampler} draws no random samples\n"
        );
        assert_eq!(stderr, should);
    }
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("in.csv"), folder.path().join("o.vcd"));
    fs::write(&input, "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n").unwrap();
    let (input, out) = (input.to_str().unwrap(), out.to_str().unwrap());
    let (code, _, stderr) = run(&["wave", "rotation", "--in", input, "--seed", "7", "--out", out]);
    assert_eq!(
        (code, stderr.as_str()),
        (0, "note: --seed has no effect: --in gives the samples\n")
    );
}

/// A coarse input looks good against its own golden, so such sweeps are ranked end to end.
#[test]
fn a_sweep_over_input_widths_is_ranked_end_to_end() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("o");
    let args = ["sweep", "rotation", "-p", "table_addr_bits=8", "--axis", "angle_bits=8,12"];
    let output =
        fixpath().args(args).args(["--samples", "5000", "--out"]).arg(&out).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("end-to-end error") && text.contains("  12 "), "{text}");
    assert!(fs::read_to_string(out.join("report.md")).unwrap().contains("real inputs"));
}

/// An interrupt leaves finished points and no incomplete file.
#[test]
#[cfg(unix)]
fn an_interrupt_leaves_nothing_half_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("big.vcd");
    // The suite itself may run with signals ignored.
    let mut child = std::process::Command::new("env")
        .arg("--default-signal=INT")
        .arg(assert_cmd::cargo::cargo_bin("fixpath"))
        .args(["wave", "rotation", "--samples", "3000000", "--out"])
        .arg(&out)
        .spawn()
        .unwrap();
    // Wait until it writes, then interrupt it.
    while is_empty(folder.path()) {
        assert!(child.try_wait().unwrap().is_none(), "still running");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let id = child.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(is_empty(folder.path()));
}

/// `--profile` reports the time of each part, and the parts add up to the total.
#[test]
fn a_profile_tells_the_share_of_each_part() {
    let run = |args: &[&str]| {
        let output = fixpath().args(args).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let shares = |told: &str| {
        let line = told.lines().find(|line| line.starts_with("time of all threads")).unwrap();
        let parts = line.split_once(": ").unwrap().1.split(", ");
        let share = |part: &str| {
            let (name, share) = part.strip_suffix(" %").unwrap().rsplit_once(' ').unwrap();
            (name.to_owned(), share.parse::<f64>().unwrap())
        };
        parts.map(share).collect::<Vec<_>>()
    };
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let sim = ["sim", "rotation", "--samples", "20000", "--profile"];
    let sweep = ["sweep", "rotation", "--axis", "frac_bits=10,12", "--samples", "20000"];
    for args in [&sim[..], &[&sweep[..], &["--out", out, "--profile"]].concat()] {
        let shares = shares(&run(args));
        assert!(["engine", "golden"].iter().all(|name| shares.iter().any(|(n, _)| n == name)));
        let whole: f64 = shares.iter().map(|(_, share)| share).sum();
        assert!((whole - 100.0).abs() <= 0.05 * shares.len() as f64, "{shares:?}");
    }
    let json: serde_json::Value =
        serde_json::from_str(&run(&[&sim[..], &["--json"]].concat())).unwrap();
    assert!(json["profile_seconds"]["engine"].as_f64().unwrap() > 0.0);
}

/// With fewer bases the remaining figures are unchanged, on any inputs; total is always among them.
#[test]
fn fewer_bases_give_the_same_figures() {
    let figures = |sampler: &[&str], basis: &[&str]| -> Vec<serde_json::Value> {
        let args = ["sim", "rotation", "-p", "angle_bits=8", "-p", "table_addr_bits=6", "--json"];
        let args = [&args[..], sampler, basis].concat();
        let output = fixpath().args(&args).output().unwrap();
        assert!(output.stderr.is_empty(), "{args:?}");
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        json["figures"].as_array().unwrap().clone()
    };
    for sampler in [&["--samples", "9000"][..], &["--hard"]] {
        let all = figures(sampler, &[]);
        for (bases, kept) in [
            ("total", &["total"][..]),
            ("arithmetic", &["total", "arithmetic"]),
            ("end-to-end,algorithm", &["total", "algorithm", "end-to-end"]),
            ("end-to-end", &["total", "end-to-end"]),
        ] {
            let should: Vec<_> =
                all.iter().filter(|f| kept.contains(&f["basis"].as_str().unwrap())).collect();
            let is = figures(sampler, &["--basis", bases]);
            assert!(!should.is_empty());
            assert_eq!(is.iter().collect::<Vec<_>>(), should, "{sampler:?} {bases}");
        }
    }
    let mut wrong = fixpath();
    let wrong = wrong.args(["sim", "rotation", "--basis", "relative"]).output().unwrap();
    assert_eq!(wrong.status.code(), Some(2));
    let told = String::from_utf8(wrong.stderr).unwrap();
    assert!(told.contains("total, arithmetic, algorithm, end-to-end"), "{told}");
}

/// A wrong scene or option is refused with its place, before anything is written.
#[test]
fn a_render_that_is_wrong_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let write = |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).unwrap();
    let out = at("out");
    let refused_with = |scene: &str, options: &[&str], message: &str| {
        let args = [&["render", scene, "--out", &out], options].concat();
        refused(&args, message);
        assert!(!Path::new(&out).exists(), "{message}");
    };
    let wrong = |name: &str, text: &str, message: &str| {
        write(name, text.as_bytes());
        refused_with(&at(name), &[], message);
    };
    write("corrupt.png", b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x04\0\0");
    let mut huge = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    huge.extend_from_slice(&[0, 1, 0x86, 0xa0, 0, 1, 0x86, 0xa0, 8, 2, 0, 0, 0]);
    write("huge.png", &huge);
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";
    for (name, face) in [
        ("points.obj", "f 1 2 9"),
        ("nan.obj", "v 0 NaN 1\nf 1 2 5"),
        ("thin.obj", "f 1/1/1 2/2/1 4/3/1"),
    ] {
        write(name, format!("{points}{face}\n").as_bytes());
    }
    let plane = "[[object]]\nshape = \"plane\"\n";
    let mesh = |file: &str| format!("[[object]]\nshape = \"mesh\"\nfile = \"{file}\"\n");
    wrong("a.toml", &format!("{plane}[texture]\nfile = \"no.png\""), "no.png: can't read: ");
    wrong(
        "a.toml",
        &format!("{plane}[texture]\nfile = \"corrupt.png\""),
        "corrupt.png: can't be decoded",
    );
    wrong(
        "a.toml",
        &format!("{plane}[height]\nfile = \"huge.png\""),
        "huge.png: the map has 100000 x 100000 texels: legal are sides of 1 to 8192",
    );
    wrong("a.toml", &mesh("no.obj"), "no.obj: can't read: ");
    wrong(
        "a.toml",
        &mesh("points.obj"),
        "points.obj, line 9: corner `9` refers to point 9, but up to here there are 4",
    );
    wrong("a.toml", &mesh("nan.obj"), "nan.obj, line 10: point 5 has NaN");
    wrong(
        "a.toml",
        &mesh("thin.obj"),
        "thin.obj: has no triangles; triangles without area left out: 1, the first in line 9",
    );
    wrong(
        "a.toml",
        &format!("{plane}\n[[light]]\ncolour = 1"),
        "a.toml, line 5: unknown field `colour`",
    );
    wrong(
        "a.toml",
        "[image]\nwidth = 0\nheight = 0\n",
        "a.toml, line 2: `width` = 0: legal are whole numbers 1 to 4096",
    );
    wrong(
        "a.toml",
        "[image]\nheight = 1000000000\n",
        "a.toml, line 2: `height` = 1000000000: legal",
    );
    refused_with(&at("none.toml"), &[], "none.toml: can't read: ");
    refused_with("shpere", &[], "no built-in scene `shpere`: there are plane, cube, sphere");

    write("good.toml", format!("[image]\nwidth = 4\nheight = 4\n{plane}").as_bytes());
    let good = at("good.toml");
    for (options, message) in [
        (
            &["--pipelines", "exact-polr"][..],
            "no pipeline `exact-polr`, did you mean `exact-polar`: legal is printed,",
        ),
        (&["--pipelines", ""], "no pipeline ``: legal is"),
        (&["--pipelines", "printed,printed"], "pipeline `printed` is named twice"),
        (
            &["-p", "angel_bits=8"],
            "no parameter `angel_bits` in any of the pipelines printed, corrected, exact-polar, exact-cartesian, did you mean `angle_bits`",
        ),
        (&["-p", "angle_bits=99"], "parameter `angle_bits` = `99`: legal is 2 to 24"),
        (&["-p", "angle_bits"], "`angle_bits` is not of the form key=value"),
        (
            &["-p", "exponent=3"],
            "parameter `exponent` comes from the scene's [material] and lights",
        ),
        (&["-p", "diffuse=0.5"], "parameter `diffuse` comes from the scene's"),
        (&["-p", "pipeline=printed"], "parameter `pipeline` comes from the names of the pipelines"),
        (
            &["--pixels-per-degree", "0"],
            "parameter `pixels_per_degree` = `0.0`: legal is a number from 1 to 1000",
        ),
        (&["--pixels-per-degree", "1e-300"], "= `1e-300`: legal is a number from 1 to 1000"),
        (&["--pixels-per-degree", "NaN"], "= `NaN`: legal"),
        (&["--pixels-per-degree", "inf"], "= `inf`: legal"),
        (&["--pixels-per-degree", "many"], "invalid value 'many'"),
    ] {
        refused_with(&good, options, message);
    }
    refused(
        &["render", &good, "--out", &good],
        "good.toml: is not a folder, and pictures go into one",
    );
    refused(&["render", &good, "--out", &format!("{good}/out")], "can't make the folder");
    assert!(fs::read_to_string(&good).unwrap().starts_with("[image]"));

    // A folder with the name of an output file is no obstacle: an earlier run may have written it.
    fs::create_dir(folder.path().join("plane")).unwrap();
    let mut command = fixpath();
    command.current_dir(folder.path()).args([
        "render",
        "plane",
        "--out",
        "plane",
        "-p",
        "angle_bits=99",
    ]);
    let stderr = String::from_utf8(command.output().unwrap().stderr).unwrap();
    assert!(stderr.contains("angle_bits"), "{stderr}");
    command = fixpath();
    command.current_dir(folder.path()).args(["render", "plane", "--out", "good.toml"]);
    let stderr = String::from_utf8(command.output().unwrap().stderr).unwrap();
    assert!(stderr.contains("good.toml: is not a folder"), "{stderr}");
}

/// Figures of different machines are compared side by side. The system library takes other code
/// paths on processors with fused multiply-add; with these disabled, no figure may change.
#[test]
fn figures_do_not_depend_on_fused_multiply_add() {
    for unit in ["illumination", "bump", "kim", "kugler", "basis", "emboss", "tangent"] {
        let sim = |tunables: &str| {
            let args = ["sim", unit, "--samples", "20000", "--json"];
            let output = fixpath().args(args).env("GLIBC_TUNABLES", tunables).output().unwrap();
            let text = String::from_utf8(output.stdout).unwrap();
            let (figures, _) = text.split_once("\"speed\"").unwrap();
            figures.to_owned()
        };
        let with = sim("");
        let without = sim("glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX512F");
        assert!(with == without, "{unit}: {with}\n{without}");
    }
}
