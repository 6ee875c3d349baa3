//! A program of another crate, with its own units in every command (`examples/own_units.rs`, which
//! uses only the public interface).

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// The folder of the examples, built like this suite.
pub(crate) static EXAMPLES: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = cargo_bin("fixpath").parent().unwrap().to_owned();
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["build", "--quiet", "--examples"]);
    if folder.ends_with("release") {
        cargo.arg("--release");
    }
    // `testbenches/timed` sets it, and with it everything would be built again.
    cargo.env_remove("RUSTC_BOOTSTRAP");
    cargo.current_dir(env!("CARGO_MANIFEST_DIR")).assert().success();
    folder.join("examples")
});

/// A program with units of its own.
static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| EXAMPLES.join("own_units"));

const OWN: [&str; 3] = ["sigmoid", "complex_product", "biquad_step"];

/// Output of a command.
fn done(args: &[&str]) -> String {
    let output = Command::new(&*PROGRAM).args(args).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{args:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&done(&[args, &["--json"]].concat())).unwrap()
}

#[test]
fn its_units_are_listed_beside_the_others() {
    let all = json(&["list"]);
    let names: Vec<&str> =
        all.as_array().unwrap().iter().map(|u| u["name"].as_str().unwrap()).collect();
    let built_in = fixpath::units::UNITS.iter().map(|unit| unit.name.as_str());
    assert_eq!(names, built_in.chain(OWN).collect::<Vec<_>>());
    let one = done(&["list", "complex_product"]);
    assert!(one.starts_with("complex_product: product of two complex numbers\n  inputs: a_re, a_im, b_re, b_im\n  outputs: re, im\n"), "{one}");
    assert!(one.contains("  frac_bits 15      2 to 24 "), "{one}");
    let output = Command::new(&*PROGRAM).args(["show", "complex_produkt"]).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(
        message,
        "error: no unit `complex_produkt`, did you mean `complex_product`: `fixpath list` names them all\n"
    );
}

#[test]
fn every_command_takes_its_units() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for unit in OWN {
        assert!(done(&["show", unit]).starts_with(&format!("{unit}: ")));
        assert!(
            done(&["schedule", unit, "-p", "schedule=shared", "-p", "share_add=1"]).contains("add")
        );
        // Figures with witnesses, and a bound that holds and is near the errors seen.
        for inputs in [&["--samples", "20000"][..], &["--hard"]] {
            let sim = json(&[&["sim", unit], inputs].concat());
            let bound = &sim["bounds"][0];
            assert_eq!(bound["holds"], true, "{unit}: {bound}");
            assert!(!sim["figures"][0]["witness"]["words"].as_array().unwrap().is_empty());
            if inputs[0] == "--samples" {
                let [seen, stated] = ["seen", "bound"].map(|key| bound[key].as_f64().unwrap());
                assert!(0.1 * stated < seen, "{unit}: {seen} of {stated}");
                continue;
            }
            // One of them has a golden in single precision; `sim` reports which units aren't judged
            // in it.
            let known = unit == "complex_product";
            assert_eq!(sim["hard_cases"][0]["float32"].is_array(), known, "{unit}");
            assert_eq!(sim["hard_cases"][0]["float32_worst"].is_number(), known, "{unit}");
            let told = done(&["sim", unit, "--hard", "--cases", &path("cases.csv")]);
            assert_eq!(
                told.contains("f32 is not judged: the unit has no golden model in f32"),
                !known
            );
            assert!(fs::read_to_string(path("cases.csv")).unwrap().lines().count() > 10);
        }
        done(&["wave", unit, "--out", &path("a.vcd"), "--samples", "20"]);
        assert!(fs::read_to_string(path("a.vcd")).unwrap().contains(&format!("unit {unit}")));
        let hdl = path(unit);
        done(&["hdl", unit, "--out", &hdl, "--language", "verilog,vhdl"]);
        for end in ["v", "vhd"] {
            assert!(Path::new(&hdl).join(format!("{unit}.{end}")).exists(), "{unit}.{end}");
        }
    }
}

/// A table of a function of its own, with each scheme: its error is the exact error of the scheme.
#[test]
fn its_function_is_tabulated_by_every_scheme() {
    for scheme in fixpath::table::Scheme::ALL {
        let set = format!("scheme={scheme}");
        let sim = json(&["sim", "sigmoid", "-p", &set, "--sampler", "exhaustive"]);
        let [seen, stated] = ["seen", "bound"].map(|key| sim["bounds"][0][key].as_f64().unwrap());
        assert!(seen <= stated && stated < 1.001 * seen, "{scheme}: {seen} of {stated}");
    }
}

/// Points whose goldens read different parameters don't share golden values: each has the error
/// that it has alone.
#[test]
fn its_sweeps_have_goldens_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    done(&["sweep", "biquad_step", "--axis", "b0=-1,0.25,1.5", "--samples", "5000", "--out", out]);
    let record: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("sweep.json")).unwrap())
            .unwrap();
    assert!(folder.path().join("report.md").exists());
    for point in record["points"].as_array().unwrap() {
        let b0 = point["parameters"]["b0"].as_f64().unwrap();
        let set = format!("b0={b0}");
        let alone = json(&["sim", "biquad_step", "-p", &set, "--samples", "5000"]);
        let max = |figures: &Value| {
            let all = figures.as_array().unwrap();
            all.iter().find(|f| f["basis"] == "total").unwrap()["max"].as_f64().unwrap()
        };
        let [swept, alone] = [&point["measured"]["figures"], &alone["figures"]].map(max);
        assert_eq!(swept, alone, "{b0}");
        assert!(alone < 1e-3, "{alone}");
    }
}
