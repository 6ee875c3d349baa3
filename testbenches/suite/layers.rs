//! Folders name only those below them, so that data flows one way. Files inside a folder do
//! likewise.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The folders of `src/` from the bottom up: each names only those before it.
const FOLDERS: &[&str] = &[
    "base", "number", "netlist", "sim", "table", "schedule", "design", "measure", "hardware",
    "units", "shading", "report", "sweep", "cli",
];

/// Files that stand for the whole crate.
const ROOTS: &[&str] = &["lib", "main"];

/// Folders whose `mod.rs` holds more than the list of its files, so that it and its files name each
/// other. No other circles are allowed, and an entry without a circle must be deleted. To remove an
/// entry, move the content of its `mod.rs` to a file of its own.
const HEADS: &[&str] = &["design", "hardware/cost", "netlist", "schedule", "shading/scene"];

/// A module's names from the crate's root.
type Module = Vec<String>;

fn module(path: &str) -> Module {
    path.split('/').map(str::to_owned).collect()
}

/// The module of a file: `units/mod.rs` is `units`, `units/dot.rs` is `units/dot`.
fn module_of(source: &Path, file: &Path) -> Module {
    let inside = file.strip_prefix(source).unwrap().with_extension("");
    let names = inside.iter().map(|name| name.to_str().unwrap().to_owned());
    names.filter(|name| name != "mod").collect()
}

/// Source without comments, string literals and test modules, which may name anything.
fn code_of(text: &str) -> String {
    let mut code = String::new();
    let mut lines = text.lines();
    let mut is_test = false;
    while let Some(line) = lines.next() {
        if is_test && line.starts_with("mod ") && line.ends_with('{') {
            lines.by_ref().find(|line| *line == "}");
        }
        is_test = line == "#[cfg(test)]" || is_test && line.starts_with("#[");
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

/// The paths that a text starts with: a single one, or those of a group in braces.
fn paths(text: &str) -> Vec<Module> {
    let text = text.trim_start();
    let Some(group) = text.strip_prefix('{') else {
        let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
        let (name, rest) = text.split_at(end);
        let tails = rest.strip_prefix("::").map(paths).unwrap_or_default();
        if name.is_empty() {
            return Vec::new();
        }
        let tails = if tails.is_empty() { vec![Vec::new()] } else { tails };
        return tails.into_iter().map(|tail| [vec![name.to_owned()], tail].concat()).collect();
    };
    let mut found = Vec::new();
    let (mut depth, mut is_start) = (0, true);
    for (i, c) in group.char_indices() {
        match c {
            '}' if depth == 0 => break,
            '{' if depth > 0 || !is_start => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => is_start = true,
            c if is_start && !c.is_whitespace() => {
                found.extend(paths(&group[i..]));
                is_start = false;
            }
            _ => {}
        }
    }
    found
}

/// The text after each `word::` that isn't itself inside a path, except for `pub(in …)`.
fn after<'a>(code: &'a str, word: &str) -> Vec<&'a str> {
    let start = format!("{word}::");
    let is_whole = |at: usize| {
        let before = &code[..at];
        !before.ends_with(|c: char| c.is_alphanumeric() || ['_', '$', ':', '.'].contains(&c))
            && !before.ends_with("pub(in ")
    };
    let found = code.match_indices(&start).filter(|(at, _)| is_whole(*at));
    found.map(|(at, _)| &code[at + start.len()..]).collect()
}

/// The paths that a file names from the crate's root: by `crate`, by `super`, and through its own
/// submodules.
fn named(of: &[String], code: &str) -> BTreeSet<Module> {
    let mut names: BTreeSet<Module> = after(code, "crate").into_iter().flat_map(paths).collect();
    for mut path in after(code, "super").into_iter().flat_map(paths) {
        let mut up = of.len().saturating_sub(1);
        while path.first().is_some_and(|name| name == "super") {
            path.remove(0);
            up = up.saturating_sub(1);
        }
        names.insert([&of[..up], &path].concat());
    }
    for line in code.lines() {
        let declared = line.trim_start_matches("pub ").trim_start_matches("pub(crate) ");
        let Some(child) = declared.strip_prefix("mod ").and_then(|rest| rest.strip_suffix(';'))
        else {
            continue;
        };
        if !after(code, child).is_empty() {
            names.insert([of, &[child.to_owned()]].concat());
        }
    }
    names
}

fn may_name(folder: &str, other: &str) -> bool {
    let place = |name: &str| FOLDERS.iter().position(|folder| *folder == name);
    let found =
        place(folder).unwrap_or_else(|| panic!("src/{folder} has no place: put it into FOLDERS"));
    place(other).is_some_and(|other| other <= found)
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

/// Every file of the crate except its roots and tests, with the paths that it names.
fn crate_files() -> BTreeMap<Module, BTreeSet<Module>> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    assert!(files.len() > 100, "{files:?}");
    let modules = files.iter().map(|file| (module_of(&source, file), file));
    let real = modules.filter(|(module, _)| {
        !ROOTS.contains(&module[0].as_str()) && module.last().is_none_or(|name| name != "tests")
    });
    real.map(|(module, file)| {
        let names = named(&module, &code_of(&fs::read_to_string(file).unwrap()));
        (module, names)
    })
    .collect()
}

/// The files that each file names.
fn graph(files: &BTreeMap<Module, BTreeSet<Module>>) -> BTreeMap<Module, BTreeSet<Module>> {
    let file_of = |path: &Module| {
        let mut starts = (1..=path.len()).rev().map(|end| path[..end].to_vec());
        starts.find(|start| files.contains_key(start))
    };
    let edges = files.iter().map(|(file, names)| {
        (file.clone(), names.iter().filter_map(file_of).filter(|other| other != file).collect())
    });
    edges.collect()
}

/// Groups of files that reach each other.
fn circles(graph: &BTreeMap<Module, BTreeSet<Module>>) -> BTreeSet<BTreeSet<Module>> {
    let reached = |from: &Module| -> BTreeSet<Module> {
        let mut seen = BTreeSet::new();
        let mut next: Vec<&Module> = graph[from].iter().collect();
        while let Some(file) = next.pop() {
            if seen.insert(file.clone()) {
                next.extend(&graph[file]);
            }
        }
        seen
    };
    let reach: BTreeMap<&Module, BTreeSet<Module>> =
        graph.keys().map(|file| (file, reached(file))).collect();
    let circle = |file: &Module| -> BTreeSet<Module> {
        reach[file].iter().filter(|other| reach[*other].contains(file)).cloned().collect()
    };
    graph.keys().map(circle).filter(|circle| !circle.is_empty()).collect()
}

fn told(circle: &BTreeSet<Module>) -> String {
    circle.iter().map(|module| module.join("/")).collect::<Vec<_>>().join(", ")
}

#[test]
fn folders_name_only_those_below() {
    let mut wrong = Vec::new();
    for (file, names) in crate_files() {
        for name in names {
            if !may_name(&file[0], &name[0]) {
                wrong.push(format!("src/{} names {}", file.join("/"), name.join("::")));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn files_of_a_folder_name_each_other_in_no_circle() {
    let files = crate_files();
    let graph = graph(&files);
    let is_head = |file: &Module| {
        files.keys().any(|other| other.len() > file.len() && other.starts_with(file))
    };

    let mut heads: BTreeSet<Module> =
        circles(&graph).into_iter().flatten().filter(|file| is_head(file)).collect();
    let allowed: BTreeSet<Module> = HEADS.iter().map(|head| module(head)).collect();
    assert!(
        heads.is_subset(&allowed),
        "mod.rs in a circle with its files: {}",
        told(&(&heads - &allowed))
    );
    heads = &allowed - &heads;
    assert!(heads.is_empty(), "no longer in a circle, delete from HEADS: {}", told(&heads));

    let without_heads = graph.iter().filter(|(file, _)| !is_head(file)).map(|(file, others)| {
        (file.clone(), others.iter().filter(|other| !is_head(other)).cloned().collect())
    });
    let found: Vec<String> = circles(&without_heads.collect()).iter().map(told).collect();
    assert!(found.is_empty(), "these name each other in a circle: {found:#?}");
}

#[test]
fn the_check_sees_every_way_to_name_a_module() {
    let code = code_of(
        "use crate::base::error::{Error, Result};\n\
         use crate::{number::{format::{Format, Round}, trig}, netlist::{self, op::Op}};\n\
         use super::super::record;\n\
         mod bounds;\n\
         pub(crate) mod passed;\n\
         pub use passed::Thing;\n\
         mod silent;\n\
         // crate::cli is only talked of\n\
         //! [`crate::main`]\n\
         pub(in crate::units) fn f() {}\n\
         let x = crate::measure::angle(\"crate::wave\", super::rtl::X, bounds::y);\n\
         $crate::nothing\n\
         #[cfg(test)]\n\
         mod tests {\n    use crate::sweep::Sweep;\n}\n",
    );
    let names = named(&module("measure/inputs/x"), &code);
    let names: Vec<String> = names.iter().map(|name| name.join("::")).collect();
    assert_eq!(
        names,
        [
            "base::error::Error",
            "base::error::Result",
            "measure::angle",
            "measure::inputs::rtl::X",
            "measure::inputs::x::bounds",
            "measure::inputs::x::passed",
            "measure::record",
            "netlist::op::Op",
            "netlist::self",
            "number::format::Format",
            "number::format::Round",
            "number::trig",
        ]
    );
    assert!(may_name("sim", "netlist") && may_name("sim", "sim"));
    assert!(!may_name("netlist", "sim") && !may_name("cli", "format"));
    let source = Path::new("a/src");
    assert_eq!(module_of(source, Path::new("a/src/units/polar.rs")), ["units", "polar"]);
    assert_eq!(module_of(source, Path::new("a/src/units/mod.rs")), ["units"]);
}

#[test]
fn the_check_sees_circles() {
    let edges = [("a", &["b"][..]), ("b", &["c", "d"]), ("c", &["a"]), ("d", &[])];
    let set = |names: &[&str]| names.iter().map(|name| module(name)).collect::<BTreeSet<_>>();
    let graph = edges.into_iter().map(|(file, others)| (module(file), set(others))).collect();
    assert_eq!(circles(&graph), BTreeSet::from([set(&["a", "b", "c"])]));
}

#[test]
fn the_pages_tell_where_every_file_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let page = fs::read_to_string(root.join("docs/design.md")).unwrap();
    let row = |folder: &str| {
        let start = format!("| `src/{folder}` |");
        page.lines()
            .find(|line| line.starts_with(&start))
            .unwrap_or_else(|| panic!("docs/design.md has no row {start}"))
    };
    for folder in FOLDERS {
        let told = row(&format!("{folder}/"));
        for entry in fs::read_dir(root.join("src").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let module = name.trim_end_matches(".rs");
            let is_told =
                ["", ".rs", "/"].iter().any(|end| told.contains(&format!("`{module}{end}`")));
            assert!(
                is_told || ["mod.rs", "tests.rs"].contains(&name.as_str()),
                "docs/design.md doesn't describe src/{folder}/{name}"
            );
        }
    }
    for entry in fs::read_dir(root.join("src")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let is_known =
            FOLDERS.contains(&name.as_str()) || ROOTS.contains(&name.trim_end_matches(".rs"));
        assert!(is_known, "src/{name} has no place");
    }
    for command in ["cargo run --release -- demo", "testbenches/run"] {
        assert!(readme.contains(&format!("```sh\n{command}\n```")), "README.md lacks {command}");
    }
}
