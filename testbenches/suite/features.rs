//! Features: the core stands on few crates.

use std::collections::BTreeSet;
use std::process::Command;

/// The packages that a build takes, with versions, this one included.
fn crates(features: &str) -> BTreeSet<String> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    // `testbenches/timed` sets it.
    cargo.env_remove("RUSTC_BOOTSTRAP");
    cargo.args(["tree", "--locked", "--offline", "--edges", "normal", "--prefix", "none"]);
    cargo.args(["--no-default-features", "--features", features]);
    let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    let text = String::from_utf8(output.stdout).unwrap();
    let package = |line: &str| line.split(' ').take(2).collect::<Vec<_>>().join(" ");
    text.lines().map(package).collect()
}

/// Other systems need other crates.
#[cfg(target_os = "linux")]
#[test]
fn the_page_tells_how_many_crates_each_feature_takes() {
    let page = include_str!("../../docs/library.md");
    let row = |title: &str| {
        let start = format!("| {title}");
        let line = page.lines().find(|line| line.starts_with(&start)).unwrap();
        line.trim_end_matches(" |").rsplit(' ').next().unwrap().parse::<usize>().unwrap()
    };
    for (title, feature) in
        [("none", ""), ("`pictures`", "pictures"), ("`sweeps`", "sweeps"), ("`cli`", "cli")]
    {
        assert_eq!(crates(feature).len(), row(title), "{title}");
    }
}

#[test]
fn the_core_takes_no_command_line_picture_or_plot() {
    let core = crates("");
    for name in ["clap", "indicatif", "image", "png", "plotters", "toml"] {
        let start = format!("{name} ");
        assert!(!core.iter().any(|package| package.starts_with(&start)), "{name}");
    }
    assert!(core.iter().any(|package| package.starts_with("rayon ")));
}
