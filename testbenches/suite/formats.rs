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
    let commands: Vec<&str> = whole
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next())
        .filter(|name| !name.is_empty())
        .collect();
    assert!(commands.len() > 12, "{commands:?}");
    for command in commands {
        assert_eq!(run(&["help", command]), run(&[command, "--help"]), "{command}");
    }
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
    // Keys that only some values of others allow.
    let given = |start: &str| {
        let line = every.lines().chain(off.lines()).find(|line| line.starts_with(start));
        line.unwrap_or_else(|| panic!("no line `{start}`")).trim_start_matches("# ").to_owned()
    };
    for (before, key) in [
        ("[camera]\nprojection = \"orthographic\"\n", "# height = "),
        ("[[light]]\nkind = \"point\"\n", "# position = "),
        ("[[light]]\nkind = \"point\"\n[orbit]\n", "# center = "),
    ] {
        let with = format!("{before}{}\n{object}", given(key));
        assert_eq!(debug(&with), debug(&format!("{before}{object}")), "{key}");
    }
    // Sections that do something by being there.
    assert_eq!(debug(&format!("{off}{object}")), debug(&format!("[emboss]\n[orbit]\n{object}")));
}

/// A value at each end of a range that the page gives is taken, and one beyond is refused.
#[test]
fn ranges_of_scenes_are_those_of_the_page() {
    let page = page("scene");
    let blocks = blocks(&page, "toml");
    let (mut section, mut ranges) = ("", 0);
    for line in blocks[1..].iter().flat_map(|block| block.lines()) {
        if line.starts_with('[') {
            section = line.split(' ').next().unwrap();
        }
        let Some((key, rest)) = line.trim_start_matches("# ").split_once(" = ") else { continue };
        let Some((value, told)) = rest.split_once('#') else { continue };
        let number = |word: &str| word.trim_end_matches([',', ';']).parse::<f64>().ok();
        let words: Vec<&str> = told.split_whitespace().collect();
        let to = words.iter().position(|word| *word == "to");
        // It needs a mesh.
        if key == "crease_degrees" {
            continue;
        }
        let Some((low, high)) = to
            .filter(|at| *at > 0)
            .and_then(|at| Some((number(words[at - 1])?, number(words[at + 1])?)))
        else {
            continue;
        };
        let with = |x: f64| {
            let whole = !value.contains('.');
            let x = if whole { format!("{x}") } else { format!("{x:?}") };
            // Colours are three of them.
            let value = if value.trim().starts_with('[') { format!("[{x}, {x}, {x}]") } else { x };
            let needs = match (section, key) {
                ("[camera]", "height") => "projection = \"orthographic\"\n",
                // A map of a single row or column, so that only the side is too long.
                ("[texture]", "width") => "height = 1\n",
                ("[texture]", "height") => "width = 1\n",
                ("[[object]]", _) => "shape = \"sphere\"\n",
                _ => "",
            };
            let object = "\n[[object]]\nshape = \"sphere\"\n";
            scene(&format!("{section}\n{needs}{key} = {value}{object}"))
        };
        let step = if value.contains('.') { 1e-7_f64.max(high.abs() * 1e-9) } else { 1.0 };
        for end in [low, high] {
            assert!(with(end).is_ok(), "{section} {key} = {end}: {}", with(end).unwrap_err());
        }
        // A scale may be negative.
        let below = (key != "scale").then_some(low - step);
        for beyond in [Some(high + step), below].into_iter().flatten() {
            assert!(with(beyond).is_err(), "{section} {key} = {beyond}");
        }
        ranges += 1;
    }
    assert!(ranges > 15, "{ranges}");
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
    // A node is a number unless its line says otherwise, whatever its operands are.
    let turns = example.replace("u2f0 @a", "u2f0 turns @a");
    let netlist = Netlist::parse(&turns, Path::new("turns.netlist")).unwrap();
    let quantities: Vec<Quantity> = netlist.nodes().iter().map(|node| node.quantity).collect();
    assert_eq!(quantities[0], Quantity::Turns);
    assert!(quantities[1..].iter().all(|quantity| *quantity == Quantity::Number));
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
    refused(
        &["sim", netlist.to_str().unwrap(), "-p", &binding],
        "has 3 words and must have one for each of 64 addresses",
    );
}
