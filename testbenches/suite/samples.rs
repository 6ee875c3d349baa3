//! Tables of values: the same rules for every command that reads them.

use crate::common::{fixpath, told};
use assert_cmd::cargo::cargo_bin;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::Stdio;

/// Runs with this standard input; returns exit code, standard output and standard error.
fn run(args: &[&str], input: impl Into<Vec<u8>>) -> (i32, String, String) {
    told(fixpath().args(args).write_stdin(input).output().unwrap())
}

const DEGREES: [&str; 8] = ["eval", "rotation", "--angle", "degrees", "--in", "-", "--out", "-"];
const DOT: [&str; 6] = ["eval", "dot", "--in", "-", "--out", "-"];

/// The result of a valid table.
fn eval(args: &[&str], input: &str) -> String {
    let (code, text, stderr) = run(args, input);
    assert_eq!((code, stderr.as_str()), (0, ""), "{input}");
    text
}

/// The message about an invalid table, on which `eval` and `wave` agree.
fn refused(args: &[&str], input: impl Into<Vec<u8>>) -> String {
    let input = input.into();
    let (code, stdout, stderr) = run(args, input.clone());
    assert_eq!(code, 2, "{stdout}{stderr}");
    assert_eq!(stderr.trim_end().lines().count(), 1, "{stderr}");
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("o.vcd");
    let mut wave: Vec<&str> =
        args.iter().map(|arg| if *arg == "eval" { "wave" } else { arg }).collect();
    *wave.last_mut().unwrap() = out.to_str().unwrap();
    let (code, _, waved) = run(&wave, input);
    assert_eq!((code, &waved), (2, &stderr));
    assert!(fs::read_dir(folder.path()).unwrap().next().is_none());
    stderr
}

/// The columns of a table with these names, in this order.
fn columns(table: &str, names: &[&str]) -> String {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header = reader.headers().unwrap().clone();
    let at: Vec<usize> =
        names.iter().map(|name| header.iter().position(|n| n == *name).unwrap()).collect();
    let rows = reader.records().map(|row| {
        let row = row.unwrap();
        at.iter().map(|at| row[*at].to_owned()).collect::<Vec<_>>().join(",") + "\n"
    });
    names.join(",") + "\n" + &rows.collect::<String>()
}

const VECTORS: &str =
    "phi_a,theta_a,phi_n,theta_n\n12.3,45,0,0\n-30,60,10.5,20\n359.99,10,-10,170\n";

#[test]
fn words_quantised_values_and_reals_are_the_same_samples() {
    let should = eval(&DEGREES, VECTORS);
    let words = ["phi_a_raw", "theta_a_raw", "phi_n_raw", "theta_n_raw"];
    let quantised = ["phi_a_q", "theta_a_q", "phi_n_q", "theta_n_q"];
    let mixed = ["theta_n_q", "phi_a_raw", "theta_a_q", "phi_n_raw", "phi_a_q"];
    for names in [&words[..], &quantised, &mixed] {
        assert_eq!(eval(&DEGREES, &columns(&should, names)), should, "{names:?}");
    }
    // Its own output, also in the forms that spreadsheets and notebooks write.
    assert_eq!(eval(&DEGREES, &should), should);
    assert_eq!(eval(&DEGREES, &should.replace(',', ";")), should);
    assert_eq!(eval(&DEGREES, &should.replace(',', "\t")), should);
    assert_eq!(eval(&DEGREES, &should.replace('\n', "\r\n")), should);
    assert_eq!(eval(&DEGREES, &should.replace('\n', "\r")), should);
    assert_eq!(eval(&DEGREES, &format!("\u{feff}{should}")), should);
    assert_eq!(eval(&DEGREES, &format!("\n\n{}", should.trim_end().replace('\n', "\n\n"))), should);
    let quoted = should.replace('\n', "\"\n\"").replace(',', "\" ; \"");
    let quoted = format!("\"{}", quoted.strip_suffix('"').unwrap()).replace("\" ; \"", "\";\"");
    assert_eq!(eval(&DEGREES, &quoted), should);
    // The real inputs beside the words they were quantised to.
    let both: String = VECTORS
        .lines()
        .zip(columns(&should, &words).lines())
        .map(|(real, words)| format!("{real},{words}\n"))
        .collect();
    assert_eq!(eval(&DEGREES, &both), should);
}

#[test]
fn columns_that_disagree_are_refused_with_the_row() {
    let table = "phi_a_raw,phi_a,theta_a,phi_n,theta_n\n16384,90,1,2,3\n\n16384,90.01,1,2,3\n";
    assert_eq!(
        refused(&DEGREES, table),
        "error: standard input, line 4, column `phi_a`: `90.01` is word 16386, but `phi_a_raw` gives 16384: \
         correct one, or leave its column out\n"
    );
    let table = "phi_a,phi_a_q,theta_a,phi_n,theta_n\n90,91,1,2,3\n";
    assert!(refused(&DEGREES, table).contains("line 2, column `phi_a`: `90` is word 16384, but"));
}

#[test]
fn words_are_words_of_their_port() {
    for (word, message) in [
        ("65536", "65536 is not a word of format u16f16: legal is 0 to 65535"),
        ("-1", "-1 is not a word of format u16f16"),
        ("1.5", "`1.5` is not a whole number"),
        ("", "`` is not a whole number"),
        ("99999999999999999999", "`99999999999999999999` is not a whole number"),
    ] {
        let told = refused(&DEGREES, format!("phi_a_raw,theta_a,phi_n,theta_n\n{word},1,2,3\n"));
        assert!(told.contains(&format!("line 2, column `phi_a_raw`: {message}")), "{told}");
    }
}

#[test]
fn unknown_columns_are_refused_with_the_nearest_unless_ignored() {
    let told = refused(&DEGREES, "phi_a,theta_a,phi_m,theta_n\n1,2,3,4\n");
    assert_eq!(
        told,
        "error: standard input, line 1, column `phi_m`: column 3 has no meaning here, did you mean `phi_n`: \
         the header should name phi_a,theta_a,phi_n,theta_n, and --ignore-columns skips others\n"
    );
    let noted = "note;phi_a;theta_a;phi_n;theta_n;phi_a_deg\n\"a;\nb\";1;2;3;4;?\n";
    assert!(refused(&DEGREES, noted).contains("column `note`: column 1 has no meaning here:"));
    let ignoring = [&["eval", "rotation", "--ignore-columns"], &DEGREES[2..]].concat();
    let plain = "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n";
    assert_eq!(eval(&ignoring, noted), eval(&DEGREES, plain));
    // Text in another encoding isn't read in an ignored column.
    let (code, text, _) =
        run(&ignoring, b"note,phi_a,theta_a,phi_n,theta_n\n\xe4,1,2,3,4\n".to_vec());
    assert_eq!((code, text), (0, eval(&DEGREES, plain)));
    // A column without a name, such as an index.
    assert!(refused(&DEGREES, format!(",{plain}")).contains("column ``: column 1 has no meaning"));
    let told = refused(&ignoring, "phi_a,theta_a,phi_m,theta_n\n1,2,3,4\n");
    assert!(told.contains("line 1, column `phi_n`: no such column"), "{told}");
}

#[test]
fn a_decimal_comma_is_told() {
    let told = refused(&DEGREES, "phi_a;theta_a;phi_n;theta_n\n0,5;2;3;4\n");
    assert!(
        told.contains("column `phi_a`: `0,5` is not a number: write a decimal point"),
        "{told}"
    );
    assert!(!refused(&DEGREES, "phi_a,theta_a,phi_n,theta_n\n\"0,5\",2,3,4\n").contains("point"));
}

#[test]
fn clipped_values_are_named_in_their_row_and_counted() {
    let table = "v_x,v_y,v_z,w_x,w_y,w_z\n1,-1,0,0.5,0,0\n1e300,0,-5,1,0,1\n0,0,0,0,0,9\n";
    let (code, text, stderr) = run(&DOT, table);
    assert_eq!(code, 0);
    let names = columns(&text, &["clipped"]);
    let names: Vec<&str> = names.lines().skip(1).collect();
    let own = |row: usize| names[row].trim_matches('"');
    // Values that fit are in the words: a value within half an LSB of its word wasn't clipped.
    let words = columns(&text, &["v_x_raw", "v_x_q"]);
    let most: f64 = words.lines().nth(2).unwrap().split_once(',').unwrap().1.parse().unwrap();
    assert_eq!(own(1).contains("v_x"), 1e300 > most);
    assert_eq!((own(1).split(' ').next(), own(2)), (Some("v_x"), "w_z"));
    assert!(own(1).split(' ').any(|name| name == "v_z"), "{text}");
    let total: usize = names.iter().filter(|n| !n.is_empty()).map(|n| n.split(' ').count()).sum();
    let first = 2 + names.iter().position(|names| !names.is_empty()).unwrap();
    let told = format!(
        "note: standard input: {total} values were clipped to the range of their port, the first in line {first}: "
    );
    assert!(stderr.starts_with(&told) && stderr.contains("v_z 1 times ("), "{stderr}");
    // Its own words fit: the output is a table without clipping, and otherwise the same.
    let (code, again, stderr) = run(&DOT, text.clone());
    assert_eq!((code, stderr.as_str()), (0, ""));
    let all = ["v_x_raw", "v_z_q", "w_z_raw"];
    assert_eq!(columns(&again, &all), columns(&text, &all));
    // `wave` reports it, too.
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("o.vcd");
    let wave = ["wave", "dot", "--in", "-", "--out", out.to_str().unwrap()];
    let (code, _, waved) = run(&wave, table);
    assert_eq!(code, 0);
    assert!(waved.starts_with(&told), "{waved}");
    // Angles can't be clipped.
    eval(&DEGREES, "phi_a,theta_a,phi_n,theta_n\n1e9,-7200,3,4\n");
}

/// Inputs as 20-bit floats are clipped like others, even beyond the range of those floats.
#[test]
fn short_floats_are_clipped_too() {
    let unit = fixpath::units::Unit::find("emboss").unwrap();
    let netlist = unit.values(&["input20=on"]).unwrap().build().unwrap().netlist;
    let names: Vec<&str> =
        (0..netlist.inputs().len()).map(|port| netlist.input_name(port)).collect();
    for (port, id) in netlist.inputs().iter().enumerate() {
        if netlist.node(*id).quantity != fixpath::netlist::Quantity::Float20 {
            continue;
        }
        for value in ["1e30", "-1e300"] {
            let fields: Vec<&str> =
                (0..names.len()).map(|at| if at == port { value } else { "0" }).collect();
            let table = format!("{}\n{}\n", names.join(","), fields.join(","));
            let args = ["eval", "emboss", "-p", "input20=on", "--in", "-", "--out", "-"];
            let (code, text, stderr) = run(&args, table);
            assert_eq!(code, 0, "{stderr}");
            let told = columns(&text, &["clipped"]);
            assert_eq!(told, format!("clipped\n{}\n", names[port]));
        }
        return;
    }
    panic!("no port takes a short float");
}

/// The ends of a port's range: a value that rounds to a word fits, a value that rounds beyond the
/// last word doesn't.
#[test]
fn a_value_is_clipped_where_its_rounding_is_past_the_range() {
    let design = fixpath::units::Unit::find("dot").unwrap().defaults().build().unwrap();
    let format = design.netlist.node(design.netlist.inputs()[0]).format;
    let (ulp, least, most) =
        (format.ulp(), format.value(format.min_raw()), format.value(format.max_raw()));
    for (value, clipped) in [
        (most, false),
        (most + 0.499 * ulp, false),
        (most + 0.5 * ulp, true), // to even, which is beyond the odd last word
        (most + ulp, true),
        (least, false),
        (least - 0.5 * ulp, false),
        (least - 0.501 * ulp, true),
        (f64::MAX, true),
    ] {
        let table = format!("v_x,v_y,v_z,w_x,w_y,w_z\n{value},0,0,0,0,0\n");
        let (_, text, _) = run(&DOT, table);
        let names = columns(&text, &["clipped"]);
        assert_eq!(names.trim_end() == "clipped\nv_x", clipped, "{value}: {names}");
    }
}

#[test]
fn a_row_without_an_end_is_refused_and_not_held() {
    let long = "7".repeat(3 << 20);
    let header = "phi_a,theta_a,phi_n,theta_n\n";
    for (table, line) in [
        (long.clone(), 1),
        (format!("{header}1,2,3,4\n1,2,3,{long}"), 3),
        (format!("{header}1,2,3,\"4\n{}", "1,2,3,4\n".repeat(1 << 18)), 2),
        (format!("{header}{}", ",".repeat(3 << 20)), 2),
        (format!("{header}1,2,3,4\n{}", " ".repeat(3 << 20)), 3),
    ] {
        let told = refused(&DEGREES, table);
        let should = format!(
            "error: standard input, line {line}: the row has more than 1048576 bytes: is this a CSV, and is \
             every quote closed?\n"
        );
        assert_eq!(told, should);
    }
    // Many columns are handled.
    let many = format!("{}phi_a,theta_a,phi_n,theta_n\n", "x,".repeat(200_000));
    let row = format!("{}1,2,3,4\n", ",".repeat(200_000));
    let ignoring = [&["eval", "rotation", "--ignore-columns"], &DEGREES[2..]].concat();
    let should = eval(&DEGREES, &format!("{header}1,2,3,4\n"));
    assert_eq!(eval(&ignoring, &(many + &row)), should);
}

/// A program that asks row by row gets each answer before it sends the next row.
#[test]
fn each_row_is_answered_before_the_next_is_waited_for() {
    let mut child = std::process::Command::new(cargo_bin("fixpath"))
        .args(DEGREES)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut to = child.stdin.take().unwrap();
    let mut from = BufReader::new(child.stdout.take().unwrap());
    let mut answer = || {
        let mut line = String::new();
        from.read_line(&mut line).unwrap();
        line
    };
    let should = eval(&DEGREES, VECTORS);
    let (header, rows) = VECTORS.split_once('\n').unwrap();
    let mut should = should.split_inclusive('\n');
    to.write_all(format!("{header}\n").as_bytes()).unwrap();
    assert_eq!(Some(answer().as_str()), should.next());
    for row in rows.split_inclusive('\n') {
        // A row may arrive in parts.
        let (a, b) = row.split_at(5);
        to.write_all(a.as_bytes()).unwrap();
        std::thread::sleep(std::time::Duration::from_millis(20));
        to.write_all(b.as_bytes()).unwrap();
        assert_eq!(Some(answer().as_str()), should.next());
    }
    drop(to);
    assert_eq!(answer(), "");
    assert!(child.wait().unwrap().success());
}

/// Many rows at once give the same as the rows one by one.
#[test]
fn a_long_table_is_the_same_in_blocks() {
    let rows: String =
        (0..20_000).map(|i| format!("{},{},{i},0\n", i * 7 % 360, i % 180)).collect();
    let all = eval(&DEGREES, &format!("phi_a,theta_a,phi_n,theta_n\n{rows}"));
    assert_eq!(all.lines().count(), 20_001);
    for at in [0, 1, 4095, 4096, 8191, 19_999] {
        let row = rows.lines().nth(at).unwrap();
        let one = eval(&DEGREES, &format!("phi_a,theta_a,phi_n,theta_n\n{row}\n"));
        assert_eq!(all.lines().nth(at + 1), one.lines().nth(1), "row {at}");
    }
}

#[test]
fn a_reader_that_stops_early_is_no_error() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("in.csv");
    fs::write(&input, format!("phi_a,theta_a,phi_n,theta_n\n{}", "1,2,3,4\n".repeat(100_000)))
        .unwrap();
    let input = input.to_str().unwrap();
    for args in [
        &["eval", "rotation", "--in", input, "--out", "-"][..],
        &["eval", "rotation", "--in", input, "--out", "/dev/stdout"],
        &["sim", "rotation", "--hard", "--cases", "/dev/stdout"],
    ] {
        let mut child = std::process::Command::new(cargo_bin("fixpath"))
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut first = String::new();
        BufReader::with_capacity(64, child.stdout.take().unwrap()).read_line(&mut first).unwrap();
        let mut stderr = String::new();
        child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
        assert_eq!((child.wait().unwrap().code(), stderr.as_str()), (Some(0), ""), "{args:?}");
    }
}

/// Output of `eval` gives the same samples in `wave`, which reads standard input too.
#[test]
fn a_wave_reads_what_eval_writes() {
    let folder = tempfile::tempdir().unwrap();
    let wave = |name: &str, table: &str| {
        let out = folder.path().join(name);
        let args = ["wave", "rotation", "--angle", "degrees", "--in", "-", "--out"];
        let (code, _, stderr) = run(&[&args[..], &[out.to_str().unwrap()]].concat(), table);
        assert_eq!((code, stderr.as_str()), (0, ""));
        fs::read(out).unwrap()
    };
    assert_eq!(wave("a.vcd", VECTORS), wave("b.vcd", &eval(&DEGREES, VECTORS)));
}
