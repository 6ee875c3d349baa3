//! Sweeps over a scene, and ladders of whole pipelines, as scripts use them.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Runs and gives exit code, standard output and standard error.
fn run(args: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("fixpath").unwrap().args(args).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

fn done(args: &[&str]) -> String {
    let (code, stdout, stderr) = run(args);
    assert_eq!((code, stderr.as_str()), (0, ""), "{args:?}");
    stdout
}

/// Expects wrong use: exit code 2, nothing on standard output, one line that says `message`.
fn refused(args: &[&str], message: &str) {
    let (code, stdout, stderr) = run(args);
    assert_eq!((code, stdout.as_str()), (2, ""), "{args:?}: {stderr}");
    assert_eq!(stderr.trim_end().lines().count(), 1, "{args:?}: {stderr}");
    assert!(stderr.contains(message), "{args:?}: {stderr}");
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// A small scene of two lights and two materials, in a file of a folder.
fn scene(folder: &Path, name: &str, exponents: [u32; 2]) -> String {
    let path = folder.join(name);
    let text = format!(
        "[image]\nwidth = 32\nheight = 32\n\
         [camera]\neye = [5.0, -3.0, 2.0]\nfov_degrees = 30.0\n\
         [[light]]\ndirection = [0.9, -0.35, 0.55]\nintensity = 0.8\n\
         [[light]]\ndirection = [0.2, -0.9, 0.3]\nintensity = 0.5\n\
         [texture]\nsource = \"brick\"\n[height]\nsource = \"brick\"\n\
         [[object]]\nshape = \"sphere\"\nmaterial = {{ specular = 0.6, exponent = {} }}\n\
         [[object]]\nshape = \"cube\"\ntranslate = [0.0, -1.2, 0.0]\nscale = 0.5\n\
         material = {{ specular = 0.4, exponent = {} }}\n",
        exponents[0], exponents[1]
    );
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Figures of `fixpath render` by one pipeline.
fn rendered(scene: &str, pipeline: &str, params: &[String], out: &Path) -> Value {
    let out_text = out.to_str().unwrap();
    let mut args = vec!["render", scene, "--pipelines", pipeline, "--out", out_text];
    args.extend(params.iter().flat_map(|param| ["-p", param.as_str()]));
    done(&args);
    json(&out.join("figures.json"))["pipelines"][0].clone()
}

fn figure<'a>(point: &'a Value, quantity: &str) -> &'a Value {
    let figures = point["measured"]["figures"].as_array().unwrap();
    let found: Vec<&Value> = figures.iter().filter(|f| f["quantity"] == quantity).collect();
    assert_eq!(found.len(), 1, "{quantity}");
    assert_eq!(found[0]["basis"], "end-to-end");
    found[0]
}

/// A point has the figures of `fixpath render`, to the last bit.
fn same(point: &Value, render: &Value) {
    let (picture, difference) = (figure(point, "picture"), &render["difference"]);
    assert_eq!(picture["max"], difference["max"]["difference"]);
    assert_eq!(picture["mean"], difference["mean"]);
    let psnr = -20.0 * picture["rms"].as_f64().unwrap().log10();
    assert!((psnr - difference["psnr_db"].as_f64().unwrap()).abs() < 1e-9, "{psnr}");
    for name in ["psnr_db", "ssim", "flip", "srgb8_differing", "srgb8_max_codes"] {
        assert_eq!(point["measured"]["picture"][name], difference[name], "{name}");
    }
    for name in ["x_px", "y_px", "channel"] {
        assert_eq!(point["measured"]["picture"][name], difference["max"][name], "{name}");
    }
    let angle = figure(point, "lt_angle");
    assert_eq!(angle["max"], render["vectors"]["max_rad"]);
    assert_eq!(angle["mean"], render["vectors"]["mean_rad"]);
    assert_eq!(point["measured"]["samples"], render["samples"]);
    let quantiles = ["p50", "p99", "p999", "max"].map(|name| picture[name].as_f64().unwrap());
    assert!(quantiles.is_sorted(), "{quantiles:?}");
}

/// Points without the time that they took.
fn timeless(record: &Value) -> Vec<Value> {
    let mut points = record["points"].as_array().unwrap().clone();
    for point in &mut points {
        point["measured"].as_object_mut().unwrap().remove("speed");
    }
    points
}

#[test]
fn a_sweep_over_a_scene_has_the_figures_of_its_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path(), "two.toml", [32, 8]);
    let out = folder.path().join("sweep");
    let out_text = out.to_str().unwrap();
    let args = [
        "sweep",
        "bump",
        "--scene",
        &scene,
        "-p",
        "scheme=linear",
        "--axis",
        "angle_bits=7,12",
        "--axis",
        "pipeline=exact-polar,exact-cartesian",
        "--out",
        out_text,
    ];
    let told = done(&args);
    assert!(told.contains("by the largest difference (1/255) to the golden picture"), "{told}");
    let record = json(&out.join("sweep.json"));
    assert_eq!(record["header"]["sampler"], "scene");
    assert_eq!(record["header"]["scene"]["name"], "two.toml");
    assert_eq!(record["header"]["base"]["exponent"], "scene");
    let points = record["points"].as_array().unwrap();
    assert_eq!(points.len(), 4);
    for point in points {
        let pipeline = point["parameters"]["pipeline"].as_str().unwrap();
        let bits = format!("angle_bits={}", point["parameters"]["angle_bits"]);
        let params = ["scheme=linear".to_owned(), bits];
        same(point, &rendered(&scene, pipeline, &params, &folder.path().join("render")));
    }
    let csv = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let heads: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    for name in [
        "picture_end_to_end_max_abs",
        "lt_angle_end_to_end_mean_rad",
        "picture_psnr_db",
        "picture_ssim",
        "picture_flip",
        "picture_srgb8_differing",
        "picture_witness",
        "rom_bits_dual_port",
    ] {
        assert!(heads.contains(&name), "{name} in {heads:?}");
    }
    assert_eq!(csv.lines().count(), 5);
    let report = fs::read_to_string(out.join("report.md")).unwrap();
    assert!(report.contains("PSNR (dB)") && report.contains("the golden picture"), "{report}");
    for plot in ["error_vs_axis.svg", "error_vs_rom.svg", "error_vs_speed.svg"] {
        assert!(fs::read_to_string(out.join(plot)).unwrap().contains("largest difference (1/255)"));
    }

    // Ranked by something else, without a picture anew.
    let before = fs::read_to_string(out.join("sweep.json")).unwrap();
    let told = done(&[&args[..], &["--error", "flip"]].concat());
    assert!(told.contains("by the FLIP"), "{told}");
    let after = fs::read_to_string(out.join("sweep.json")).unwrap();
    assert_eq!(after.replace("\"error\": \"flip\"", "\"error\": \"max\""), before);

    // A point that is missing is measured again.
    let mut cut = record.clone();
    cut["points"].as_array_mut().unwrap().remove(2);
    fs::write(out.join("sweep.json"), cut.to_string()).unwrap();
    done(&args);
    assert_eq!(timeless(&json(&out.join("sweep.json"))), timeless(&record));
}

#[test]
fn a_sweep_refuses_to_mix_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let path = scene(folder.path(), "a.toml", [32, 8]);
    let out = folder.path().join("sweep");
    let out_text = out.to_str().unwrap();
    let out_args = ["--out", out_text];
    let with = |scene: &str, more: &[&str]| -> Vec<String> {
        let args = ["sweep", "bump", "--scene", scene, "--axis", "angle_bits=6,7"];
        let all = args.iter().chain(more).chain(&out_args);
        all.map(|text| (*text).to_owned()).collect()
    };
    let refused_with = |args: Vec<String>, message: &str| {
        refused(&args.iter().map(String::as_str).collect::<Vec<_>>(), message);
    };
    done(&with(&path, &[]).iter().map(String::as_str).collect::<Vec<_>>());
    let before = fs::read(out.join("sweep.json")).unwrap();
    // The same name, another exponent in the file.
    scene(folder.path(), "a.toml", [33, 8]);
    refused_with(with(&path, &[]), "holds another sweep: scene is a.toml (32 x 32 px, fingerprint");
    scene(folder.path(), "a.toml", [32, 8]);
    refused_with(with(&path, &["-p", "exponent=32"]), "exponent is scene there and 32 here");
    refused(
        &["sweep", "bump", "--axis", "angle_bits=6,7", "--out", out_text],
        "holds another sweep: sampler is scene there and lit here",
    );
    assert_eq!(fs::read(out.join("sweep.json")).unwrap(), before);
    refused_with(with(&path, &["--samples", "10"]), "cannot be used with");
    refused_with(with(&path, &["-p", "angle_bits=9"]), "is set with -p and swept by an axis");
    refused_with(with("nowhere.toml", &[]), "nowhere.toml");
    let none = folder.path().join("none");
    let none = none.to_str().unwrap();
    refused(
        &["sweep", "bump", "--error", "flip", "--axis", "angle_bits=6,7", "--out", none],
        "--scene",
    );
    refused(
        &["sweep", "rotation", "--scene", "plane", "--axis", "angle_bits=6,7", "--out", none],
        "unit `rotation` can't shade a scene: it has no parameter `ambient`",
    );
    assert!(!Path::new(none).exists());
}

#[test]
fn what_is_given_of_the_material_takes_the_place_of_the_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let path = scene(folder.path(), "a.toml", [32, 8]);
    let out = folder.path().join("sweep");
    let args = ["sweep", "bump", "--scene", &path, "--axis", "exponent=5,90"];
    done(&[&args[..], &["--out", out.to_str().unwrap()]].concat());
    for point in json(&out.join("sweep.json"))["points"].as_array().unwrap() {
        let exponent = u32::try_from(point["parameters"]["exponent"].as_u64().unwrap()).unwrap();
        assert_eq!(point["parameters"]["specular"], "scene");
        // The same scene with that exponent written into its file.
        let other = scene(folder.path(), "other.toml", [exponent; 2]);
        same(point, &rendered(&other, "exact-polar", &[], &folder.path().join("render")));
    }
}
