//! What commands do to files: inputs stay unchanged, outputs are complete and of one run, and other
//! files stay.
#![cfg(unix)]

use assert_cmd::cargo::cargo_bin;
use std::collections::BTreeSet;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const CSV: &str = "phi_a,theta_a,phi_n,theta_n\n1,2,3,4\n";
const SCENE: &str = "[image]\nwidth = 8\nheight = 8\n[[object]]\nshape = \"plane\"\n";

/// A command in a folder, with default signal handling.
fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new("env");
    command.arg("--default-signal=INT,HUP,TERM").arg(cargo_bin("fixpath"));
    command.current_dir(folder).args(args);
    command
}

/// Exit code, or none after a signal, and both streams.
fn ended(output: &Output) -> (Option<i32>, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout) + &text(&output.stderr))
}

fn run(folder: &Path, args: &[&str]) -> (Option<i32>, String) {
    ended(&command(folder, args).output().unwrap())
}

fn works(folder: &Path, args: &[&str]) {
    let (code, told) = run(folder, args);
    assert_eq!(code, Some(0), "{args:?}: {told}");
}

fn refused(folder: &Path, args: &[&str], message: &str) {
    let (code, told) = run(folder, args);
    assert_eq!(code, Some(2), "{args:?}: {told}");
    assert!(told.contains(message), "{args:?}: {told}");
}

fn start(folder: &Path, args: &[&str]) -> Child {
    command(folder, args).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

fn send(child: &Child, signal: &str) {
    let id = child.id().to_string();
    assert!(Command::new("kill").args([signal, &id]).status().unwrap().success());
}

fn wait_for(what: &str, there: impl Fn() -> bool) {
    let start = Instant::now();
    while !there() {
        assert!(start.elapsed() < Duration::from_secs(60), "{what}");
        sleep(Duration::from_millis(5));
    }
}

fn names(folder: &Path) -> BTreeSet<String> {
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    fs::read_dir(folder).unwrap().map(|entry| name(entry).into_string().unwrap()).collect()
}

/// All temporary files that runs have not renamed.
fn left(folder: &Path) -> Vec<String> {
    let is_temporary =
        |name: &String| [".fixpath-", "fixpath-", "new-"].iter().any(|p| name.starts_with(p));
    let mut left: Vec<String> = names(folder).into_iter().filter(is_temporary).collect();
    for name in names(folder) {
        if folder.join(&name).is_dir() {
            left.extend(self::left(&folder.join(&name)));
        }
    }
    left
}

#[test]
fn no_command_writes_over_what_it_reads() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let write = |name: &str, text: &str| fs::write(here.join(name), text).unwrap();
    write("in.csv", CSV);
    write("in.gtkw", CSV);
    symlink("in.csv", here.join("link.csv")).unwrap();
    fs::hard_link(here.join("in.csv"), here.join("second.csv")).unwrap();
    for out in ["in.csv", "./in.csv", "link.csv", "second.csv"] {
        for unit in [&["eval", "rotation"][..], &["wave", "rotation"]] {
            let args = [unit, &["--in", "in.csv", "--out", out]].concat();
            refused(here, &args, &format!("{out}: is the input"));
        }
    }
    // The save file beside a VCD, which isn't named on the command line.
    let args = ["wave", "rotation", "--in", "in.gtkw", "--out", "in.vcd"];
    refused(here, &args, "in.gtkw: is the input");
    assert!(!here.join("in.vcd").exists());
    // Streams redirected by the shell.
    let script = "\"$0\" eval rotation --in - --out in.csv < in.csv";
    let append = "\"$0\" eval rotation --in in.csv --out - >> in.csv";
    for script in [script, append] {
        let mut bash = Command::new("bash");
        bash.args(["-c", script]).arg(cargo_bin("fixpath")).current_dir(here);
        assert_eq!(ended(&bash.output().unwrap()).0, Some(2), "{script}");
    }
    for name in ["in.csv", "in.gtkw"] {
        assert_eq!(fs::read_to_string(here.join(name)).unwrap(), CSV, "{name}");
    }

    // The inputs of a scene: the file itself, its pictures, its meshes.
    let plane = "[image]\nwidth = 8\nheight = 8\n[[object]]\nshape = \"plane\"\n";
    let grey = "[texture]\nsource = \"constant\"\ncolor = [0.5, 0.5, 0.5]\n";
    write("grey.toml", &format!("{plane}{grey}"));
    works(here, &["render", "grey.toml", "--out", "first", "--pipelines", "printed"]);
    let golden = fs::read(here.join("first/golden.png")).unwrap();
    let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n";
    write("first/mesh.obj", mesh);
    fs::create_dir(here.join("second")).unwrap();
    symlink("../first/mesh.obj", here.join("second/figures.txt")).unwrap();
    write("texture.toml", &format!("{plane}[texture]\nfile = \"first/golden.png\"\n"));
    write("height.toml", &format!("{plane}[height]\nfile = \"first/printed.png\"\n"));
    let huge = plane.replace("= 8", "= 4096");
    write("huge.toml", &format!("{huge}[texture]\nfile = \"first/golden.png\"\n"));
    let of_mesh =
        "[image]\nwidth = 8\nheight = 8\n[[object]]\nshape = \"mesh\"\nfile = \"first/mesh.obj\"\n";
    write("mesh.toml", of_mesh);
    for (scene, out, taken) in [
        ("texture.toml", "first", "first/golden.png"),
        ("height.toml", "first", "first/printed.png"),
        ("mesh.toml", "second", "second/figures.txt"),
        ("huge.toml", "first", "first/golden.png"),
    ] {
        let args = ["render", scene, "--out", out, "--pipelines", "printed"];
        let start = Instant::now();
        refused(here, &args, &format!("{taken}: is the input"));
        // Refused before the work starts: the huge scene would take long.
        assert!(start.elapsed() < Duration::from_secs(20), "{scene}");
    }
    assert_eq!(fs::read(here.join("first/golden.png")).unwrap(), golden);
    assert_eq!(fs::read_to_string(here.join("first/mesh.obj")).unwrap(), mesh);
    assert_eq!(names(&here.join("second")), BTreeSet::from(["figures.txt".to_owned()]));
    // A run doesn't remove a file that it no longer makes if that file is now an input.
    let args = ["render", "height.toml", "--out", "first", "--pipelines", "exact-cartesian"];
    works(here, &args);
    assert!(
        here.join("first/printed.png").exists() && !here.join("first/printed_signed.png").exists()
    );
    // Reports.
    write("scene.md", SCENE);
    let args = ["compare", "--samples", "100", "--scenes", "scene.md", "--out", "scene.md"];
    refused(here, &args, "scene.md: is the input");
    write("report.md", SCENE);
    let args = ["sweep", "bump", "--axis", "angle_bits=8", "--scene", "report.md", "--fresh"];
    refused(here, &[&args[..], &["--out", "."]].concat(), "report.md: is the input");
    assert_eq!(fs::read_to_string(here.join("report.md")).unwrap(), SCENE);
    assert_eq!(left(here), [""; 0]);
}

#[test]
fn a_run_takes_away_what_an_earlier_one_made_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::write(here.join("scene.toml"), SCENE).unwrap();
    fs::write(
        here.join("moving.toml"),
        format!("{SCENE}[[light]]\nkind = \"point\"\nposition = [0, 1, 3]\n[orbit]\nframes = 3\n"),
    )
    .unwrap();
    let texels = "[height]\nwidth = 4\nheight = 4\n";
    fs::write(here.join("emboss.toml"), format!("{SCENE}{texels}")).unwrap();
    let clean = |words: &[&str]| {
        works(here, &[words, &["--out", "clean"]].concat());
        let names = names(&here.join("clean"));
        fs::remove_dir_all(here.join("clean")).unwrap();
        names
    };
    let hdl = |set: &'static [&str]| [&["hdl", "rotation", "--vectors", "10"], set].concat();
    let of = |scene: &'static str, name: &'static str| vec!["render", scene, "--pipelines", name];
    let runs = [
        (hdl(&["--tables", "files"]), hdl(&["--tables", "inline", "--language", "verilog"])),
        (of("scene.toml", "printed"), of("scene.toml", "exact-polar")),
        (of("moving.toml", "printed"), of("scene.toml", "corrected")),
        (
            [of("scene.toml", "printed"), vec!["--ladder=8"]].concat(),
            [of("emboss.toml", "emboss-nv"), vec!["--ladder=8"]].concat(),
        ),
    ];
    for (first, second) in runs {
        let out = here.join("out");
        fs::create_dir(&out).unwrap();
        fs::write(out.join("mine.hex"), "precious").unwrap();
        works(here, &[&first[..], &["--out", "out"]].concat());
        let before = names(&out);
        works(here, &[&second[..], &["--out", "out"]].concat());
        let mut should = clean(&second);
        assert!(!before.is_subset(&should), "{first:?}: nothing was to be removed");
        should.insert("mine.hex".to_owned());
        assert_eq!(names(&out), should, "{first:?} {second:?}");
        assert_eq!(fs::read_to_string(out.join("mine.hex")).unwrap(), "precious");
        fs::remove_dir_all(&out).unwrap();
    }
    // Modules of other names are other designs.
    works(here, &[&hdl(&["--name", "a"])[..], &["--out", "out"]].concat());
    works(here, &[&hdl(&["--name", "b"])[..], &["--out", "out"]].concat());
    assert!(["a.v", "b.v"].iter().all(|name| here.join("out").join(name).exists()));
    // A list that names files elsewhere removes nothing there.
    fs::write(here.join("keep.txt"), "precious").unwrap();
    let there = fs::metadata(here.join("keep.txt")).unwrap();
    let time = there.modified().unwrap().duration_since(std::time::UNIX_EPOCH).unwrap().as_nanos();
    let keep = format!("{} {time}", there.len());
    let list = format!("{keep} ../keep.txt\n{keep} {}\n", here.join("keep.txt").display());
    fs::write(here.join("out/.fixpath/hdl-a"), list).unwrap();
    works(here, &[&hdl(&["--name", "a"])[..], &["--out", "out"]].concat());
    assert!(here.join("keep.txt").exists());
}

#[test]
fn of_two_runs_at_once_one_is_refused_and_a_dead_one_refuses_nobody() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let long = ["sweep", "rotation", "--axis", "frac_bits=8..20", "--samples", "3000000"];
    let short = ["sweep", "rotation", "--axis", "angle_bits=8", "--samples", "10"];
    let mut first = start(here, &[&long[..], &["--out", "out"]].concat());
    wait_for("the list is there", || here.join("out/.fixpath/sweep").exists());
    sleep(Duration::from_millis(100));
    refused(here, &[&short[..], &["--out", "out"]].concat(), "out: another run is writing to it");
    refused(
        here,
        &[&short[..], &["--fresh", "--out", "./out"]].concat(),
        "another run is writing to it",
    );
    first.kill().unwrap();
    first.wait().unwrap();
    works(here, &[&short[..], &["--fresh", "--out", "out"]].concat());
    assert_eq!(left(here), [""; 0]);

    let scene = "[image]\nwidth = 2000\nheight = 2000\n[[object]]\nshape = \"sphere\"\n";
    fs::write(here.join("large.toml"), scene).unwrap();
    fs::write(here.join("small.toml"), SCENE).unwrap();
    let args = |scene| ["render", scene, "--out", "pictures", "--pipelines", "printed"];
    let mut first = start(here, &args("large.toml"));
    wait_for("the list is there", || here.join("pictures/.fixpath/render").exists());
    sleep(Duration::from_millis(100));
    refused(here, &args("small.toml"), "pictures: another run is writing to it");
    first.kill().unwrap();
    first.wait().unwrap();
    works(here, &args("small.toml"));
    assert_eq!(left(here), [""; 0]);

    // An interrupt of the first run leaves nothing.
    let mut first = start(here, &["render", "large.toml", "--out", "none"]);
    wait_for("the list is there", || here.join("none/.fixpath/render").exists());
    sleep(Duration::from_millis(100));
    send(&first, "-INT");
    assert_eq!(first.wait().unwrap().code(), Some(130));
    assert!(!here.join("none").exists());
}

#[test]
fn a_signal_that_is_ignored_stays_so_and_others_end_with_their_code() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let args = ["wave", "rotation", "--samples", "3000000", "--out", "w.vcd"];
    for (signal, code) in [("-INT", 130), ("-TERM", 143), ("-HUP", 129)] {
        let mut child = start(here, &args);
        wait_for("it writes", || !left(here).is_empty());
        send(&child, signal);
        assert_eq!(child.wait().unwrap().code(), Some(code), "{signal}");
        assert!(names(here).is_empty(), "{signal}");
    }
    for name in ["INT", "HUP", "TERM"] {
        let mut env = Command::new("env");
        env.arg(format!("--ignore-signal={name}")).arg(cargo_bin("fixpath"));
        let mut child = env.current_dir(here).args(args).spawn().unwrap();
        wait_for("it writes", || !left(here).is_empty());
        send(&child, &format!("-{name}"));
        sleep(Duration::from_millis(300));
        assert!(child.try_wait().unwrap().is_none(), "ended by {name}");
        child.kill().unwrap();
        child.wait().unwrap();
        fs::remove_dir_all(here.join(&left(here)[0])).unwrap();
    }
}

#[test]
fn what_a_kill_left_goes_with_the_next_run_and_modes_stay() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::create_dir(here.join("tmp")).unwrap();
    let mut child = start(here, &["wave", "rotation", "--samples", "3000000", "--out", "w.vcd"]);
    wait_for("it writes", || !left(here).is_empty());
    // A run leaves the files of a live run alone.
    fs::write(here.join("in.csv"), CSV).unwrap();
    let eval = ["eval", "rotation", "--in", "in.csv", "--out", "out.csv"];
    works(here, &eval);
    assert_eq!(left(here).len(), 1);
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(left(here).len(), 1, "a kill leaves it");
    fs::write(here.join(".fixpath-mine"), "precious").unwrap();
    fs::set_permissions(here.join("out.csv"), fs::Permissions::from_mode(0o640)).unwrap();
    works(here, &eval);
    assert_eq!(left(here), [".fixpath-mine"]);
    let mode = |name: &str| fs::metadata(here.join(name)).unwrap().permissions().mode() & 0o7777;
    assert_eq!(mode("out.csv"), 0o640);
    // Files of sets, too.
    let hdl = ["hdl", "dot", "--vectors", "10", "--out", "hdl"];
    works(here, &hdl);
    fs::set_permissions(here.join("hdl/dot.v"), fs::Permissions::from_mode(0o604)).unwrap();
    works(here, &hdl);
    assert_eq!(mode("hdl/dot.v"), 0o604);
    // A new file has the usual mode.
    fs::write(here.join("other"), "").unwrap();
    assert_eq!(mode("hdl/dot.vhd"), mode("other"));
}

#[test]
fn a_pipe_is_waited_for_where_a_command_names_it_and_else_refused() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let fifo = |name: &str| {
        assert!(Command::new("mkfifo").arg(here.join(name)).status().unwrap().success());
    };
    ["p", "p.png", "p.obj", "p.bin"].into_iter().for_each(fifo);
    let write = |name: &str, text: &str| fs::write(here.join(name), text).unwrap();
    write("in.csv", CSV);
    write("texture.toml", &format!("{SCENE}[texture]\nfile = \"p.png\"\n"));
    write("height.toml", &format!("{SCENE}[height]\nfile = \"p.png\"\n"));
    let mesh = |file: &str| format!("[[object]]\nshape = \"mesh\"\nfile = \"{file}\"\n");
    write("mesh.toml", &mesh("p.obj"));
    write("buffer.toml", &mesh("a.gltf"));
    let buffer =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"p.bin\",\"byteLength\":4}]}";
    write("a.gltf", buffer);
    for (scene, file) in [
        ("texture.toml", "p.png"),
        ("height.toml", "p.png"),
        ("mesh.toml", "p.obj"),
        ("buffer.toml", "p.bin"),
    ] {
        let message = format!("{file}: can't read: it is a pipe; a regular file is needed");
        refused(here, &["render", scene, "--out", "out"], &message);
    }
    // The program waits for a late reader or writer, here until the note appears; a signal ends the
    // wait.
    let late = "exec 2>err; mkfifo q r; \
                told() { until grep -q \"note: $1: waiting for the other end of this pipe\" err; do sleep 0.1; done; }; \
                \"$0\" eval rotation --in p --out - | grep -c , & told p; cat in.csv > p; wait; \
                \"$0\" eval rotation --in in.csv --out q & told q; grep -c , q; wait; \
                \"$0\" texgen r & told r; kill $!; wait $!; echo $?";
    let mut bash = Command::new("timeout");
    bash.args(["300", "bash", "-c", late]).arg(cargo_bin("fixpath")).current_dir(here);
    assert_eq!(ended(&bash.output().unwrap()), (Some(0), "2\n2\n143\n".to_owned()));
    // With a process at the other end it is like any file.
    let script = "cat in.csv > p & \"$0\" eval rotation --in p --out - | grep -c , ; \
                  cat p > copy & \"$0\" eval rotation --in in.csv --out p; wait; grep -c , copy";
    let mut bash = Command::new("bash");
    bash.args(["-c", script]).arg(cargo_bin("fixpath")).current_dir(here);
    assert_eq!(ended(&bash.output().unwrap()), (Some(0), "2\n2\n".to_owned()));
}

#[test]
fn errors_of_the_system_keep_their_words() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::write(here.join("in.csv"), CSV).unwrap();
    let eval = |out| ["eval", "rotation", "--in", "in.csv", "--out", out];
    refused(
        here,
        &eval("no/out.csv"),
        "no/out.csv: can't write: No such file or directory (os error 2)",
    );
    refused(here, &eval("in.csv/out.csv"), "can't write: Not a directory (os error 20)");
    let long = "x".repeat(300);
    refused(here, &eval(&long), "can't write: File name too long (os error 36)");
    // A limit is reported with the requested file, not with its temporary file.
    let script = "ulimit -f 1; \"$0\" hdl rotation --out out";
    let mut bash = Command::new("bash");
    bash.args(["-c", script]).arg(cargo_bin("fixpath")).current_dir(here);
    let (code, told) = ended(&bash.output().unwrap());
    assert_eq!(code, Some(2), "{told}");
    assert!(told.starts_with("error: out/rotation"), "{told}");
    assert!(told.ends_with("can't write: File too large (os error 27)\n"), "{told}");
    assert_eq!(names(here), BTreeSet::from(["in.csv".to_owned()]));
}

#[test]
fn commands_to_copy_are_quoted() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let (_, told) = run(here, &["wave", "rotation", "--samples", "9", "--out", "it's $(x).vcd"]);
    assert!(told.contains("gtkwave 'it'\\''s $(x).vcd' 'it'\\''s $(x).gtkw'"), "{told}");
    let (_, told) = run(here, &["hdl", "dot", "--vectors", "9", "--out", "a b"]);
    assert!(told.contains("make -C 'a b' -f dot_icarus.mk"), "{told}");
}

/// Runs killed at random moments, full disks, closed streams; `testbenches/faults 3600` runs
/// longer.
#[test]
fn faults_lose_nothing() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut faults = Command::new(root.join("testbenches/faults"));
    let output = faults.arg("10").env("FIXPATH", cargo_bin("fixpath")).output().unwrap();
    assert!(output.status.success(), "{}", ended(&output).1);
}
