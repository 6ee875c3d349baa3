//! The readers of the fuzz targets on their seeds: regressions of what fuzzing found.

#[path = "../../fuzz/readers.rs"]
mod readers;

use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

/// Each seed goes through its reader unchanged, truncated, and with a bit flipped.
#[test]
fn seeds_of_the_fuzz_targets() {
    let seeds = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds");
    let mut folders: Vec<_> =
        fs::read_dir(&seeds).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    folders.sort();
    assert!(folders.iter().eq(readers::READERS.iter().map(|(name, _)| *name)), "{folders:?}");
    for (name, reader) in readers::READERS {
        let mut files: Vec<_> =
            fs::read_dir(seeds.join(name)).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        assert!(!files.is_empty(), "{name}");
        for file in files {
            let seed = fs::read(&file).unwrap();
            let tried = |what: &str, bytes: &[u8]| {
                if catch_unwind(|| reader(bytes)).is_err() {
                    panic!("{}: {what}", file.display());
                }
            };
            tried("whole", &seed);
            for part in 1..4 {
                let end = seed.len() * part / 4;
                tried("cut off", &seed[..end]);
                let mut wrong = seed.clone();
                if let Some(byte) = wrong.get_mut(end) {
                    *byte ^= 1 << (part + 1);
                }
                tried("with a wrong bit", &wrong);
            }
        }
    }
}

/// Each reader is a target, and each target is a reader.
#[test]
fn targets_are_the_readers() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz");
    let mut targets: Vec<String> = fs::read_dir(fuzz.join("targets"))
        .unwrap()
        .map(|entry| entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    targets.sort();
    let manifest = fs::read_to_string(fuzz.join("Cargo.toml")).unwrap();
    assert!(targets.iter().eq(readers::READERS.iter().map(|(name, _)| name)), "{targets:?}");
    for target in targets {
        assert!(manifest.contains(&format!("path = \"targets/{target}.rs\"")), "{target}");
        let text = fs::read_to_string(fuzz.join(format!("targets/{target}.rs"))).unwrap();
        assert!(text.contains(&format!("readers::{target}(bytes)")), "{target}");
    }
}
