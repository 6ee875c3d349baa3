//! A picture's figures cover the pixels that see an object; with no such pixel there is no result.

use crate::common::{done, json, refused, written};
use fixpath::picture::{Difference, PIXELS_PER_DEGREE};
use fixpath::render::{Pipeline, render};
use fixpath::scene::{Fragments, Scene};
use std::fs;
use std::path::{Path, PathBuf};

const SMALL: &str = "[image]\nwidth = 24\nheight = 16\n[height]\nsource = \"brick\"\nscale = 3.0\n";

/// A cube seen from inside, a cube behind the camera, and a cube whose normals point away.
fn empty_scenes(folder: &Path) -> Vec<PathBuf> {
    let camera = |eye: &str, target: &str| {
        format!("{SMALL}[camera]\neye = {eye}\ntarget = {target}\nfov_degrees = 60.0\n")
    };
    let cube = "[[object]]\nshape = \"cube\"\n";
    let triangle =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 -1\nf 1/1/1 3/3/1 2/2/1\n";
    written(folder, "back.obj", triangle);
    let mesh = "[[object]]\nshape = \"mesh\"\nfile = \"back.obj\"\n";
    let inside = camera("[0.0, 0.0, 0.0]", "[1.0, 0.0, 0.0]") + cube;
    let away = camera("[9.0, 0.0, 0.0]", "[20.0, 0.0, 0.0]") + cube;
    let turned = camera("[0.2, 0.2, 5.0]", "[0.2, 0.2, 0.0]") + "up = [0.0, 1.0, 0.0]\n" + mesh;
    let moving = format!("{inside}[[light]]\nkind = \"point\"\nposition = [0.5, 0.0, 0.0]\n");
    [("inside.toml", inside), ("away.toml", away), ("turned.toml", turned), ("lit.toml", moving)]
        .map(|(name, text)| written(folder, name, &text))
        .to_vec()
}

#[test]
fn nothing_in_view_is_no_result() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let out_text = out.to_str().unwrap();
    let report = folder.path().join("table.md");
    let message = "nothing is in view: no pixel sees an object";
    for scene in empty_scenes(folder.path()) {
        let scene = scene.to_str().unwrap();
        for command in [
            vec!["render", scene, "--out", out_text],
            vec!["render", scene, "--pipelines", "exact-polar", "--specialise", "--out", out_text],
            vec!["render", scene, "--pipelines", "tangent-faceted", "--out", out_text],
            vec!["render", scene, "--ladder=8", "--out", out_text],
            vec!["render", scene, "--ladder=8", "--pipelines", "emboss-gx", "--out", out_text],
            vec!["sweep", "bump", "--scene", scene, "--axis", "angle_bits=6,16", "--out", out_text],
            vec![
                "compare",
                "--samples",
                "100",
                "--scenes",
                scene,
                "--out",
                report.to_str().unwrap(),
            ],
        ] {
            refused(&command, message);
            assert!(!out.exists() && !report.exists(), "{command:?}");
        }
    }
}

#[test]
fn figures_of_pixels_are_over_the_covered_ones() {
    let scene = Scene::builtin("sphere").unwrap();
    let pipelines = [Pipeline::named("exact-polar").unwrap()];
    let rendered = render(&scene, &pipelines, true, &|_| ()).unwrap();
    let mut fragments = Fragments::default();
    scene.trace(0..scene.image.height, &mut fragments);
    let (covered, all) = (fragments.len() as f64, rendered.golden.pixels().len() as f64);
    assert!(covered > 1000.0 && covered < 0.9 * all);
    let shot = &rendered.shots[0];
    let over = rendered.difference(&shot.picture, &rendered.golden, PIXELS_PER_DEGREE).unwrap();
    // The background is equal in both: it adds nothing to sums but adds pixels to divide by.
    let whole = Difference::between(&shot.picture, &rendered.golden, PIXELS_PER_DEGREE).unwrap();
    assert_eq!((over.covered_px as f64, over.background_px as f64), (covered, all - covered));
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12 * b.abs(), "{a} and {b}");
    near(over.mean, whole.mean * all / covered);
    near(over.channels[1].mean, whole.channels[1].mean * all / covered);
    near(over.srgb8_differing, whole.srgb8_differing * all / covered);
    near(over.psnr_db, whole.psnr_db - 10.0 * (all / covered).log10());
    assert_eq!((over.max, over.ssim, over.flip), (whole.max, whole.ssim, whole.flip));
    // This holds for quantiles too: more than a third of the picture is background, but its median
    // isn't 0.
    let report = rendered.report(shot, &over);
    assert!(report.figures[0].p50 > 0.0 && report.figures[0].mean == over.mean);
    let squares = f64::powi(report.figures[0].rms, 2);
    near(-10.0 * squares.log10(), over.psnr_db);
}

#[test]
fn every_report_tells_how_many_pixels_are_covered() {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{SMALL}[[object]]\nshape = \"sphere\"\n");
    let path = written(folder.path(), "small.toml", &text);
    let scene = Scene::open(&path).unwrap();
    let mut fragments = Fragments::default();
    scene.trace(0..scene.image.height, &mut fragments);
    let told = format!("{} of 384 pixels are covered", fragments.len());
    let scene = path.to_str().unwrap();
    let out = |name: &str| folder.path().join(name);
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let run_into =
        |args: &[&str], name: &str| done(&[args, &["--out", out(name).to_str().unwrap()]].concat());

    let stdout = run_into(&["render", scene, "--pipelines", "exact-polar,tangent-faceted"], "r");
    assert!(stdout.contains(&told) && text("r/figures.txt").contains(&told), "{stdout}");
    let figures = json(&out("r/figures.json"));
    assert_eq!(figures["covered_px"], fragments.len());
    assert_eq!(figures["background_px"], 384 - fragments.len());
    for part in ["difference", "arithmetic", "algorithm"] {
        assert_eq!(figures["pipelines"][1][part]["covered_px"], fragments.len(), "{part}");
    }

    let args = ["sweep", "bump", "--scene", scene, "--axis", "angle_bits=6,16"];
    let stdout = run_into(&args, "s");
    assert!(stdout.contains(&told) && text("s/report.md").contains(&told), "{stdout}");
    let csv = text("s/sweep.csv");
    let at = csv.lines().next().unwrap().split(',').position(|c| c == "picture_covered_px");
    for row in csv.lines().skip(1) {
        assert_eq!(row.split(',').nth(at.unwrap()), Some(&*fragments.len().to_string()));
    }

    let args = ["render", scene, "--ladder=8", "--pipelines", "exact-polar", "--exponents", "8"];
    let stdout = run_into(&args, "l");
    assert!(stdout.contains(&told) && text("l/ladder.md").contains(&told), "{stdout}");
    assert_eq!(json(&out("l/ladder.json"))["header"]["covered_px"], fragments.len());

    let table = out("table.md");
    let args = ["compare", "--samples", "100", "--scenes", scene];
    let stdout = done(&[&args[..], &["--out", table.to_str().unwrap()]].concat());
    assert!(stdout.contains(&told) && text("table.md").contains(&told), "{stdout}");
}

#[test]
fn a_refused_setting_says_why_in_its_row() {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{SMALL}[[object]]\nshape = \"cube\"\n");
    let path = written(folder.path(), "small.toml", &text);
    let out = folder.path().join("out");
    let args = ["render", path.to_str().unwrap(), "--pipelines", "printed", "--ladder=5,22"];
    let more = ["-p", "guard_bits=8", "-p", "table_addr_bits=4", "--exponents", "8"];
    let stdout = done(&[&args[..], &more, &["--out", out.to_str().unwrap()]].concat());
    let why = "words have at most 63";
    let report = fs::read_to_string(out.join("ladder.md")).unwrap();
    for text in [&stdout, &report] {
        let row = text.lines().find(|line| line.contains("printed") && line.contains(" 22 "));
        assert!(row.unwrap().contains(why), "{text}");
        assert!(text.contains("refused because"), "{text}");
    }
    // A refused setting still has its parameters, and numbers are JSON numbers.
    let record = json(&out.join("ladder.json"));
    assert_eq!(record["rungs"][1]["parameters"]["guard_bits"], 8);
    assert_eq!(record["rungs"][1]["parameters"]["angle_bits"], 22);
}

#[test]
fn what_another_command_does_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let out_args = ["--out", out.to_str().unwrap()];
    let with =
        |args: &[&'static str]| [args, &out_args[..]].concat().into_iter().map(str::to_owned);
    let refused_with = |args: &[&'static str], message: &str| {
        let args: Vec<String> = with(args).collect();
        refused(&args.iter().map(String::as_str).collect::<Vec<_>>(), message);
        assert!(!out.exists());
    };
    refused_with(
        &["render", "lettering-raised", "--specialise"],
        "--specialise is for pipelines that shade bumps, and the scene has an [emboss] section: name some that shade bumps, such as --pipelines printed,corrected,exact-polar,exact-cartesian",
    );
    refused_with(
        &["sweep", "emboss", "--scene", "lettering-raised", "--axis", "component_bits=8,9"],
        "`fixpath render SCENE --pipelines emboss-gx,emboss-nv --ladder` measures",
    );
    refused_with(
        &["sweep", "tangent", "--scene", "mirrored", "--axis", "component_bits=8,9"],
        "`fixpath render SCENE --pipelines tangent-smooth,tangent-faceted -p key=value`",
    );
    refused_with(
        &["sweep", "rotation", "--scene", "plane", "--axis", "angle_bits=8,9"],
        "leave --scene out, or use one of bump, ernst, kim, kugler",
    );
}
