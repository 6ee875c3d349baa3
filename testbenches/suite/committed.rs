//! The generated hardware of every unit at its defaults, and of some other settings, doesn't change
//! unnoticed: a few settings are committed in full in `hdl_out/` and `testbenches/`, the others as
//! a digest of each file.

use crate::common::design;
use fixpath::emit::{Package, Settings};
use fixpath::hdl::testbench::vectors_file;
use fixpath::units::UNITS;
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::fmt::Write as _;
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

/// The settings committed in full, for readers: tables without a multiplier, a time-shared
/// multiplier, dot products, a root by table.
const IN_FULL: &[&str] = &["rotation_exact", "rotation_corrected_shared", "emboss", "rsqrt"];

/// The digests of the files of all other settings, in the format of `sha256sum`.
const DIGESTS: &str = "hdl_out/digests.txt";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Files of a setting, with paths from the root: netlist, module in both languages and tables in
/// `hdl_out`, their testbenches in a folder of `testbenches`.
pub(crate) fn files(name: &str, unit: &str, assignments: &[&str]) -> Vec<(PathBuf, String)> {
    let design = design(unit, assignments);
    let settings = Settings {
        name: Some(name.to_owned()),
        random: 200,
        hard_per_group: Some(10),
        ..Settings::default()
    };
    let mut package = Package::new(&design, &settings).unwrap();
    let (hardware, bench) = (PathBuf::from("hdl_out"), Path::new("testbenches").join(name));
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
    let rewrite = "FIXPATH_BLESS=1 cargo test committed rewrites it";
    let mut made = BTreeSet::new();
    let mut check = |path: &Path, text: &str| {
        let whole = root().join(path);
        if bless {
            fs::create_dir_all(whole.parent().unwrap()).unwrap();
            fs::write(&whole, text).unwrap();
        }
        let committed = fs::read_to_string(&whole).unwrap_or_default();
        // Not assert_eq: a table is a long text.
        assert!(committed == text, "{} is out of date: {rewrite}", path.display());
        made.insert(path.to_owned());
    };
    let mut digests = String::new();
    for (name, unit, assignments) in COMMITTED {
        for (path, text) in files(name, unit, assignments) {
            if IN_FULL.contains(name) {
                check(&path, &text);
                continue;
            }
            for byte in Sha256::digest(&text) {
                write!(digests, "{byte:02x}").unwrap();
            }
            writeln!(digests, "  {}", path.display()).unwrap();
        }
    }
    let committed = fs::read_to_string(root().join(DIGESTS)).unwrap_or_default();
    let changed = digests.lines().find(|line| !committed.lines().any(|old| old == *line));
    let changed = changed.unwrap_or("a file less");
    assert!(bless || committed == digests, "{DIGESTS} is out of date: {changed}: {rewrite}");
    check(Path::new(DIGESTS), &digests);
    // No file may remain that is no longer generated.
    let mut folders = vec![PathBuf::from("hdl_out")];
    folders.extend(IN_FULL.iter().map(|name| Path::new("testbenches").join(name)));
    // Outputs of makefiles beside testbenches are ignored, as git does.
    let is_left = |path: &Path| {
        let extension = path.extension().and_then(|extension| extension.to_str());
        let bench = path.parent() != Some(&folders[0]);
        bench && (root().join(path).is_dir() || matches!(extension, Some("hex" | "vvp" | "vcd")))
    };
    let names = |folder: &PathBuf| {
        let entries: Vec<_> = fs::read_dir(root().join(folder)).unwrap().collect();
        let folder = folder.clone();
        entries.into_iter().map(move |entry| folder.join(entry.unwrap().file_name()))
    };
    for entry in fs::read_dir(root().join("testbenches")).unwrap().map(Result::unwrap) {
        let folder = Path::new("testbenches").join(entry.file_name());
        let kept = folders.contains(&folder) || folder.ends_with("suite") || entry.path().is_file();
        assert!(kept, "{} is no longer generated", folder.display());
    }
    for path in folders.iter().flat_map(names).filter(|path| !is_left(path)) {
        if bless && !made.contains(&path) {
            fs::remove_file(root().join(&path)).unwrap();
        }
        assert!(bless || made.contains(&path), "{} is no longer generated", path.display());
    }
}
