//! Modules name only those above them, so that data flows one way.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// From the top down. Modules on one line don't name each other, but for those of `FRIENDS`.
const LAYERS: &[&[&str]] = &[
    &["cast", "columns", "error", "escape", "input", "json", "output", "simd", "whole"],
    &["outside", "document"],
    &["format", "texgen"],
    &["trig", "srgb"],
    &["function"],
    &["op", "netlist"],
    &["lut"],
    &["schedule", "specialise", "picture", "scene"],
    &["rtl"],
    &["units", "timetable"],
    &["sim", "hdl"],
    &["measure"],
    &["render", "samples", "wave"],
    &["report", "eval", "emit"],
    &["sweep", "ladder", "verify", "cost", "compare"],
    &["cli"],
];

/// An operation names tables and nodes, a netlist holds operations.
const FRIENDS: &[&str] = &["op", "netlist"];

/// Files that stand for the whole crate.
const ROOTS: &[&str] = &["lib", "main"];

fn layer(module: &str) -> usize {
    let found = LAYERS.iter().position(|layer| layer.contains(&module));
    found.unwrap_or_else(|| panic!("module `{module}` has no layer: put it into LAYERS"))
}

fn may_name(module: &str, other: &str) -> bool {
    // Anything may use the top line: numbers, errors, files.
    module == other
        || layer(other) < layer(module)
        || (layer(other) == 0 && layer(module) == 0)
        || (FRIENDS.contains(&module) && FRIENDS.contains(&other))
}

/// Source without comments and string literals, so that docs may name what they like.
fn code_of(text: &str) -> String {
    let mut code = String::new();
    for line in text.lines() {
        let mut in_string = false;
        let mut before = ' ';
        let mut chars = line.chars().peekable();
        while let Some(c) = chars.next() {
            match c {
                '"' if before != '\\' && before != '\'' => in_string = !in_string,
                '/' if !in_string && chars.peek() == Some(&'/') => break,
                _ if in_string => {}
                _ => code.push(c),
            }
            before = if before == '\\' { ' ' } else { c };
        }
        code.push('\n');
    }
    code
}

/// First path segments after `crate::`, grouped imports included.
fn named(code: &str) -> BTreeSet<String> {
    let segment = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let mut names = BTreeSet::new();
    for (at, found) in code.match_indices("crate::") {
        if code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$') {
            continue;
        }
        let rest = &code[at + found.len()..];
        let Some(group) = rest.trim_start().strip_prefix('{') else {
            names.insert(segment(rest));
            continue;
        };
        let mut depth = 0;
        let mut start = true;
        for (i, c) in group.char_indices() {
            match c {
                '}' if depth == 0 => break,
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => start = true,
                c if start && !c.is_whitespace() => {
                    names.insert(segment(&group[i..]));
                    start = false;
                }
                _ => {}
            }
        }
    }
    names
}

fn rust_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// The top-level module of a file: `units/polar.rs` is part of `units`.
fn module_of(source: &Path, file: &Path) -> String {
    let inside = file.strip_prefix(source).unwrap();
    let first = inside.components().next().unwrap().as_os_str().to_str().unwrap();
    first.trim_end_matches(".rs").to_owned()
}

#[test]
fn modules_name_only_those_above() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    assert!(files.len() > 10, "{files:?}");
    let mut wrong = Vec::new();
    for file in &files {
        let module = module_of(&source, file);
        if ROOTS.contains(&module.as_str()) {
            continue;
        }
        layer(&module);
        let code = code_of(&fs::read_to_string(file).unwrap());
        for other in named(&code) {
            if !may_name(&module, &other) {
                wrong.push(format!("{} names {other}", file.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_check_sees_every_way_to_name_a_module() {
    let code = code_of(
        "use crate::error::{Error, Result};\n\
         use crate::{format::{Format, Round}, op, netlist::Netlist};\n\
         // crate::cli is only talked of\n\
         //! [`crate::main`]\n\
         let x = crate::measure::angle(\"crate::wave\", crate::rtl::X);\n\
         $crate::nothing\n",
    );
    let names: Vec<String> = named(&code).into_iter().collect();
    assert_eq!(names, ["error", "format", "measure", "netlist", "op", "rtl"]);
    assert!(may_name("op", "netlist") && may_name("netlist", "op"));
    assert!(may_name("sim", "error") && may_name("measure", "sim"));
    assert!(
        !may_name("format", "op") && !may_name("measure", "wave") && !may_name("sim", "measure")
    );
    assert_eq!(module_of(Path::new("a/src"), Path::new("a/src/units/polar.rs")), "units");
}

#[test]
fn the_readme_tells_where_every_file_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    for entry in fs::read_dir(root.join("src")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let module = name.trim_end_matches(".rs");
        let told = readme.contains(&format!("`src/{module}.rs`"))
            || readme.contains(&format!("`src/{module}/`"))
            || readme.contains(&format!("`src/{name}`"));
        assert!(told || name == "lib.rs", "README.md doesn't say what src/{name} holds");
    }
    for command in ["cargo run --release -- demo", "testbenches/run"] {
        assert!(readme.contains(&format!("```sh\n{command}\n```")), "README.md lacks {command}");
    }
}
