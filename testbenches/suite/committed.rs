//! `hdl_out/` and `testbenches/` hold what the code generates for the committed settings of every
//! unit.

use crate::common::design;
use fixpath::emit::{Package, Settings};
use fixpath::hdl::testbench::vectors_file;
use fixpath::units::UNITS;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Name, unit and parameters of every committed setting.
pub(crate) const COMMITTED: &[(&str, &str, &[&str])] = &[
    ("rotation_exact", "rotation", &[]),
    ("rotation_exact_polar_cordic", "rotation", &["output=polar-cordic"]),
    ("rotation_exact_polar_table", "rotation", &["output=polar-table"]),
    ("rotation_corrected", "rotation", &["variant=corrected"]),
    ("rotation_printed", "rotation", &["variant=printed"]),
    (
        "rotation_corrected_shared",
        "rotation",
        &["variant=corrected", "schedule=shared", "share_mul=1"],
    ),
    ("illumination", "illumination", &[]),
    ("bump", "bump", &[]),
    ("peercy", "peercy", &[]),
    ("ernst", "ernst", &[]),
    ("kim", "kim", &[]),
    ("kugler", "kugler", &[]),
    ("dot", "dot", &[]),
    ("normalise", "normalise", &[]),
    ("rsqrt", "rsqrt", &[]),
    ("rsqrt_newton", "rsqrt", &["root_scheme=newton", "root_addr_bits=7"]),
    ("cross_product", "cross_product", &[]),
    ("basis", "basis", &[]),
    ("emboss", "emboss", &[]),
    ("emboss_nv", "emboss", &["setting=nv"]),
    ("emboss_printed", "emboss", &["schedule=printed", "period_ps=6000", "l_sign=vertex-light"]),
    ("sampler", "sampler", &[]),
    ("combine", "combine", &[]),
    ("tangent", "tangent", &[]),
    ("tangent_faceted", "tangent", &["frame=faceted"]),
];

/// The netlist, the modules in both languages and the tables go to `hdl_out`; their testbenches go
/// to a folder in `testbenches`.
fn files(name: &str, unit: &str, assignments: &[&str]) -> Vec<(PathBuf, String)> {
    let design = design(unit, assignments);
    let settings = Settings {
        name: Some(name.to_owned()),
        random: 200,
        hard_per_group: Some(10),
        ..Settings::default()
    };
    let mut package = Package::new(&design, &settings).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (hardware, bench) = (root.join("hdl_out"), root.join("testbenches").join(name));
    let mut files = vec![(hardware.join(format!("{name}.txt")), design.netlist.to_text())];
    for file in &package.hardware {
        files.push((hardware.join(&file.name), file.text.clone()));
    }
    for file in &package.companions {
        // Yosys's script is beside the files that it reads; the list covers one folder.
        let folder = if file.name.ends_with(".ys") { &hardware } else { &bench };
        if !file.name.ends_with("_files.txt") {
            files.push((folder.join(&file.name), file.text.clone()));
        }
    }
    let mut vectors = Vec::new();
    package.vectors.write(&mut vectors).unwrap();
    let path = bench.join(vectors_file(&package.module));
    files.push((path, String::from_utf8(vectors).unwrap()));
    files
}

#[test]
fn every_unit_is_committed_at_its_defaults() {
    for unit in UNITS.iter() {
        let there = |(_, name, set): &(_, &str, &[&str])| *name == unit.name && set.is_empty();
        assert!(COMMITTED.iter().any(there), "{} is not in COMMITTED", unit.name);
    }
}

/// FIXPATH_BLESS=1 rewrites them.
#[test]
fn committed_hardware_is_up_to_date() {
    let bless = std::env::var_os("FIXPATH_BLESS").is_some();
    let mut made = BTreeSet::new();
    for (name, unit, assignments) in COMMITTED {
        for (path, text) in files(name, unit, assignments) {
            if bless {
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(&path, &text).unwrap();
            }
            let committed = fs::read_to_string(&path).unwrap_or_default();
            // Not assert_eq, which would print a long table.
            let old = format!("{} is old: FIXPATH_BLESS=1 cargo test rewrites it", path.display());
            assert!(committed == text, "{old}");
            made.insert(path);
        }
    }
    // No file may remain that is no longer generated.
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders = vec![root.join("hdl_out")];
    folders.extend(COMMITTED.iter().map(|(name, _, _)| root.join("testbenches").join(name)));
    // Outputs of makefiles beside testbenches are ignored, as git does.
    let is_left = |path: &Path| {
        let extension = path.extension().and_then(|extension| extension.to_str());
        let bench = path.parent() != Some(&folders[0]);
        bench && (path.is_dir() || matches!(extension, Some("hex" | "vvp" | "vcd")))
    };
    let entries = folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    for path in entries.map(|entry| entry.unwrap().path()).filter(|path| !is_left(path)) {
        if bless && !made.contains(&path) {
            fs::remove_file(&path).unwrap();
        }
        assert!(bless || made.contains(&path), "{} is no longer generated", path.display());
    }
}
