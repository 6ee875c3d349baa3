//! Sweeps over a scene, and ladders of whole pipelines, as scripts use them.

use crate::common::{done, json, refused};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// A small scene of two lights and two materials, as a file in a folder.
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

/// Figures of `fixpath render` with one pipeline.
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

/// Points without their run times.
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
    assert!(told.contains("by largest difference (1/255) against the golden picture"), "{told}");
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

    // Ranking by another measure needs no new picture.
    let before = fs::read_to_string(out.join("sweep.json")).unwrap();
    let told = done(&[&args[..], &["--error", "flip"]].concat());
    assert!(told.contains("by FLIP (0 to 1) against the golden picture"), "{told}");
    let after = fs::read_to_string(out.join("sweep.json")).unwrap();
    assert_eq!(after.replace("\"error\": \"flip\"", "\"error\": \"max\""), before);

    // A missing point is measured again.
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
    // The same name, with another exponent in the file.
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
        "unit `rotation` can't shade a scene by itself: leave --scene out",
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

#[test]
fn a_ladder_has_the_figures_of_its_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let path = scene(folder.path(), "a.toml", [32, 8]);
    let out = folder.path().join("ladder");
    let out_text = out.to_str().unwrap();
    let told = done(&[
        "render",
        &path,
        "--ladder=6,9,12",
        "--pipelines",
        "corrected,exact-polar,exact-cartesian",
        "--exponents",
        "1,120",
        "-p",
        "light_bits=14",
        "--out",
        out_text,
    ]);
    let record = json(&out.join("ladder.json"));
    let rungs = record["rungs"].as_array().unwrap();
    assert_eq!(rungs.len(), 9);
    let max = |point: &Value| figure(point, "picture")["max"].as_f64().unwrap();
    for rung in rungs {
        let width = rung["width_bits"].as_u64().unwrap();
        let pipeline = rung["pipeline"].as_str().unwrap();
        let mut params = vec!["light_bits=14".to_owned()];
        params.extend(["angle_bits", "frac_bits"].map(|key| format!("{key}={width}")));
        let tables = ["table_addr_bits", "diffuse_addr_bits", "specular_addr_bits"];
        params.extend(tables.map(|key| format!("{key}={}", width - 2)));
        same(rung, &rendered(&path, pipeline, &params, &folder.path().join("render")));
        for count in ["rom_bits", "rom_bits_dual_port", "latency_cycles", "datapath_multipliers"] {
            assert!(rung["measured"]["counts"][count].as_u64().unwrap() > 0, "{count}");
        }
        assert!(
            rung["measured"]["speed"]["engine_samples_per_second_per_thread"].as_f64() > Some(0.0)
        );
        assert!(told.lines().any(|line| line.trim_start().starts_with(pipeline)));
    }
    // Where the method is exact, wider is better.
    for pipeline in rungs.chunks(3).skip(1) {
        assert!(max(&pipeline[0]) > 2.0 * max(&pipeline[1]));
        assert!(max(&pipeline[1]) > 2.0 * max(&pipeline[2]));
    }

    let lights = record["exponents"].as_array().unwrap();
    assert_eq!(lights.len(), 2 * 9);
    assert_eq!(record["header"]["light_pipeline"], "exact-cartesian");
    let at = |scheme: &str, exponent: u64, addr_bits: u64| {
        let found = lights.iter().find(|light| {
            light["scheme"] == scheme
                && light["exponent"] == exponent
                && light["addr_bits"] == addr_bits
        });
        max(found.unwrap())
    };
    // A direct table's error grows with the exponent; interpolation is the remedy.
    assert!(at("direct", 120, 8) > 10.0 * at("direct", 1, 8));
    assert!(at("direct", 120, 8) > 4.0 * at("linear", 120, 8));
    assert!(at("direct", 120, 12) < at("direct", 120, 8) / 4.0);
    // Such a point is a picture of the scene with that exponent.
    let light = lights
        .iter()
        .find(|l| l["scheme"] == "bipartite" && l["exponent"] == 120 && l["addr_bits"] == 10);
    let other = scene(folder.path(), "other.toml", [120; 2]);
    let params = [
        "angle_bits=18",
        "frac_bits=18",
        "scheme=linear",
        "table_addr_bits=12",
        "light_bits=14",
        "light_scheme=bipartite",
        "diffuse_addr_bits=10",
        "specular_addr_bits=10",
    ];
    let params = params.map(str::to_owned);
    same(
        light.unwrap(),
        &rendered(&other, "exact-cartesian", &params, &folder.path().join("render")),
    );

    let csv = fs::read_to_string(out.join("ladder.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + rungs.len());
    assert!(csv.starts_with("pipeline,unit,width_bits,angle_bits,"), "{csv}");
    assert!(csv.lines().nth(1).unwrap().starts_with("corrected,bump,6,6,6,14,4,4,4,"), "{csv}");
    let csv = fs::read_to_string(out.join("exponents.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + lights.len());
    let report = fs::read_to_string(out.join("ladder.md")).unwrap();
    for plot in ["ladder_error_vs_rom.svg", "ladder_error_vs_speed.svg", "exponents.svg"] {
        assert!(report.contains(&format!("]({plot})")), "{report}");
        let svg = fs::read_to_string(out.join(plot)).unwrap();
        assert!(svg.starts_with("<svg") && svg.contains("largest difference (1/255)"));
    }
    assert!(report.contains("At exponent 120, the picture is off by up to"), "{report}");
}

#[test]
fn ladders_of_unfit_rungs_and_dull_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let out_text = out.to_str().unwrap();
    let cases: [(&[&str], &str); 7] = [
        (&["--ladder=3"], "width `3`: legal are whole numbers from 4 to 22"),
        (&["--ladder=8,x"], "width `x`: legal are"),
        (&["--ladder=8,8"], "width 8 is given twice"),
        (
            &["--ladder", "--exponents", "256"],
            "exponent `256`: legal are whole numbers from 0 to 255",
        ),
        (&["--exponents", "8"], "--ladder"),
        (&["--ladder", "-p", "exponent=8"], "comes from the scene's [material]"),
        (&["--ladder", "--pipelines", "exact"], "no pipeline `exact`"),
    ];
    for (args, message) in cases {
        refused(&[&["render", "plane", "--out", out_text], args].concat(), message);
    }
    assert!(!out.exists());
    // Without specular light there are no light tables to judge.
    let dull = folder.path().join("dull.toml");
    let text = "[image]\nwidth = 16\nheight = 16\n[material]\nspecular = 0.0\n[[object]]\nshape = \"cube\"\n";
    fs::write(&dull, text).unwrap();
    let dull = dull.to_str().unwrap();
    // With all these guard bits, a width of 22 exceeds the 63 bits of a product in that unit.
    let args = ["render", dull, "--pipelines", "printed", "--ladder=5,22", "--json"];
    let told = done(
        &[&args[..], &["-p", "guard_bits=8", "-p", "table_addr_bits=4", "--out", out_text]]
            .concat(),
    );
    let record: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(record["exponents"].as_array().unwrap().len(), 0);
    assert_eq!(record["header"]["light_pipeline"], Value::Null);
    assert!(record["rungs"][0]["measured"].is_object(), "{record}");
    let why = record["rungs"][1]["error"].as_str().unwrap();
    assert!(why.contains("words have at most 63"), "{why}");
    assert_eq!(record["rungs"][1]["measured"], Value::Null);
    assert_eq!(record, json(&out.join("ladder.json")));
}
