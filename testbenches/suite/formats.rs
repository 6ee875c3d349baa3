//! Formats of files: what `fixpath help` and `docs/files` say of them holds.

use crate::common::{refused, run};
use fixpath::format::{Overflow, Round};
use fixpath::netlist::{Netlist, Part, Quantity, Rate};
use fixpath::op::Op;
use fixpath::real::Primitive;
use fixpath::scene::Scene;
use std::fs;
use std::path::{Path, PathBuf};

const TOPICS: [&str; 5] = ["scene", "netlist", "samples", "memory", "texgen"];

fn page(topic: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/files/{topic}.md"));
    fs::read_to_string(path).unwrap()
}

/// The blocks of a language.
fn blocks(page: &str, language: &str) -> Vec<String> {
    let start = format!("```{language}\n");
    let parts = page.split(&start).skip(1);
    parts.map(|part| part.split_once("```").unwrap().0.to_owned()).collect()
}

fn scene(text: &str) -> fixpath::error::Result<Scene> {
    Scene::parse(text, Path::new("scene.toml"))
}

#[test]
fn help_prints_each_page() {
    for topic in TOPICS {
        let page = page(topic);
        assert!(page.lines().all(|line| line.chars().count() <= 100 || line.starts_with('|')));
        let (code, text, _) = run(&["help", topic]);
        assert_eq!(code, 0);
        assert!(text.contains(page.trim()), "{topic}");
    }
    let (_, whole, _) = run(&["--help"]);
    assert!(TOPICS.iter().all(|topic| whole.contains(topic)), "{whole}");
    assert_eq!(run(&["help"]), run(&["--help"]));
    assert_eq!(run(&["help", "sim"]), run(&["sim", "--help"]));
    refused(&["help", "scenes"], "there is no help on `scenes`, did you mean `scene`");
}

#[test]
fn defaults_of_scenes_are_those_of_the_page() {
    let page = page("scene");
    let [least, every, off] = &blocks(&page, "toml")[..] else { panic!() };
    let object = "[[object]]\nshape = \"sphere\"\n";
    assert_eq!(least, object);
    let debug = |text: &str| format!("{:?}", scene(text).unwrap());
    assert_eq!(debug(every), debug(least));
    // Sections that do something by being there.
    assert_eq!(debug(&format!("{off}{object}")), debug(&format!("[emboss]\n[orbit]\n{object}")));
}

/// Every key that a section takes is on the page, and no other.
#[test]
fn every_key_of_scenes_is_on_the_page() {
    let page = page("scene");
    let blocks = blocks(&page, "toml");
    let text = blocks[1..].concat();
    // Sections with their keys, written out or commented.
    let mut sections: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') {
            sections.push((line.split(' ').next().unwrap(), Vec::new()));
        } else if let Some((key, _)) = line.trim_start_matches("# ").split_once(" = ")
            && key.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        {
            sections.last_mut().unwrap().1.push(key);
        }
    }
    let legal = |text: &str| -> Vec<String> {
        let told = scene(text).unwrap_err().to_string();
        let list = told.split_once("expected one of ").map(|(_, list)| list);
        let list = list.or_else(|| told.split_once("expected ").map(|(_, list)| list)).unwrap();
        let list = list.split(" in `").next().unwrap();
        list.split('`').skip(1).step_by(2).map(str::to_owned).collect()
    };
    for (section, keys) in &sections {
        let needs = if *section == "[[object]]" { "shape = \"mesh\"\n" } else { "" };
        let mut keys: Vec<String> = keys.iter().map(|key| (*key).to_owned()).collect();
        keys.sort();
        keys.dedup();
        let mut known = legal(&format!("{section}\n{needs}nonsense = 1\n"));
        // Both sections of maps read one type; each refuses the other's own key.
        let foreign = match *section {
            "[texture]" => "scale",
            "[height]" => "color",
            _ => "",
        };
        known.retain(|key| key != foreign);
        known.sort();
        assert_eq!(keys, known, "{section}");
    }
    let mut given: Vec<&str> =
        sections.iter().map(|(section, _)| section.trim_matches(['[', ']'])).collect();
    given.sort_unstable();
    let mut known = legal("nonsense = 1\n");
    known.sort();
    assert_eq!(given, known);
}

#[test]
fn netlists_are_as_their_page_says() {
    let page = page("netlist");
    let [example] = &blocks(&page, "text")[..] else { panic!() };
    let netlist = Netlist::parse(example, Path::new("square.netlist")).unwrap();
    assert_eq!(netlist.name(), "square");
    let mut named: Vec<&str> = Op::ALL.iter().map(|op| op.name()).collect();
    named.extend(Primitive::ALL.iter().map(|primitive| primitive.name()));
    named.extend(Round::ALL.iter().map(|round| round.name()));
    named.extend(Overflow::ALL.iter().map(|overflow| overflow.name()));
    named.extend(Part::ALL.iter().map(|part| part.name()));
    named.extend(Quantity::ALL.iter().map(|quantity| quantity.name()));
    named.extend(Rate::ALL.iter().map(|rate| rate.name()));
    for name in named {
        let found = [" ", "`", "(", "["].iter().any(|end| page.contains(&format!("`{name}{end}")))
            || page.contains(&format!(", `{name}"));
        assert!(found, "{name}");
    }
}

/// The examples of tables are read; that of words is one of too few.
#[test]
fn tables_are_as_their_pages_say() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, topic: &str| -> PathBuf {
        let [block] = &blocks(&page(topic), "csv")[..] else { panic!("{topic}") };
        let path = folder.path().join(name);
        fs::write(&path, block).unwrap();
        path
    };
    let samples = put("samples.csv", "samples");
    let (code, text, _) =
        run(&["eval", "rotation", "--in", samples.to_str().unwrap(), "--out", "-"]);
    assert_eq!((code, text.lines().count()), (0, 3), "{text}");
    let words = put("words.csv", "memory");
    let netlist = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/fetch.netlist");
    let binding = format!("memory.map={}", words.display());
    refused(&["sim", netlist.to_str().unwrap(), "-p", &binding], "64");
}
