//! Emitted hardware in outside simulators, on random netlists.

use crate::engines::{Random, random_netlist};
use fixpath::emit::vectors::Vectors;
use fixpath::hdl::{LANGUAGES, Module, Options, Tables, testbench};
use fixpath::netlist::Netlist;
use fixpath::rtl::Rtl;
use fixpath::schedule::{Depth, Rom, Schedule};
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

/// Some depth for a netlist, by its seed.
pub(crate) fn some_rtl(netlist: &Arc<Netlist>, seed: u64) -> Arc<Rtl> {
    let rom = if seed.is_multiple_of(3) { Rom::Distributed } else { Rom::Block };
    let depth = match seed % 4 {
        0 => Depth::Stages(0),
        1 => Depth::Stages(1),
        2 => Depth::Period(3000),
        _ => Depth::Period(100),
    };
    let schedule = Schedule::pipeline(netlist, rom, depth)
        .unwrap_or_else(|_| Schedule::pipeline(netlist, rom, Depth::Period(1000)).unwrap());
    Arc::new(Rtl::new(Arc::clone(netlist), schedule))
}

/// Writes everything for a netlist into a folder; gives the module.
pub(crate) fn emit(rtl: &Arc<Rtl>, tables: Option<Tables>, vectors: u64, folder: &Path) -> Module {
    let options = Options { name: None, tables, header: vec!["a random netlist".to_owned()] };
    let module = Module::new(rtl, &options).unwrap();
    let mut files: Vec<_> = LANGUAGES.iter().map(|language| module.file(*language)).collect();
    files.extend(module.table_files());
    files.extend(testbench::companions(&module, LANGUAGES, vectors));
    for file in files {
        fs::write(folder.join(file.name), file.text).unwrap();
    }
    let mut text = Vec::new();
    let mut stream = Vectors::of_netlist(rtl.netlist(), Vec::new(), vectors, 7);
    stream.write(&mut text).unwrap();
    fs::write(folder.join(testbench::vectors_file(&module)), text).unwrap();
    module
}

#[test]
fn random_netlists_in_icarus() {
    for seed in 0..std::env::var("N").map_or(40, |n| n.parse().unwrap()) {
        let netlist = Arc::new(random_netlist(seed));
        let folder = tempfile::tempdir().unwrap();
        let tables = [None, Some(Tables::Files), Some(Tables::Case)][(seed % 3) as usize];
        let _ = Random::new(seed);
        emit(&some_rtl(&netlist, seed / 3), tables, 400, folder.path());
        let output = Command::new("make")
            .args(["-f", "random_icarus.mk"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        let stdout = String::from_utf8_lossy(&output.stdout);
        let stderr = String::from_utf8_lossy(&output.stderr);
        if !stdout.trim_end().ends_with("PASS 400 vectors") || !stderr.is_empty() {
            let kept = folder.keep();
            panic!("seed {seed} {}\n{stdout}\n{stderr}", kept.display());
        }
    }
}

#[test]
fn dump_for_fuzz() {
    let Ok(dir) = std::env::var("FUZZ_DIR") else { return };
    for seed in 0..200 {
        let folder = Path::new(&dir).join(seed.to_string());
        fs::create_dir_all(&folder).unwrap();
        let netlist = Arc::new(random_netlist(seed));
        let tables = [None, Some(Tables::Files), Some(Tables::Case)][(seed % 3) as usize];
        emit(&some_rtl(&netlist, seed / 3), tables, 400, &folder);
    }
}
