//! README and `docs/`: every command runs, every link leads somewhere.

use crate::own_units::EXAMPLES;
use assert_cmd::cargo::cargo_bin;
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// Languages of code blocks: commands, which are run; example files, which the tests of their
/// readers read; printed output. Rust is run by `cargo test`, in `src/lib.rs`.
const LANGUAGES: [&str; 5] = ["sh", "rust", "toml", "csv", "text"];

fn pages() -> Vec<PathBuf> {
    let root = Path::new(ROOT);
    let folders = ["docs", "docs/files"].map(|folder| fs::read_dir(root.join(folder)).unwrap());
    let docs = folders.into_iter().flatten().map(|entry| entry.unwrap().path());
    let mut pages: Vec<PathBuf> =
        docs.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.extend(["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root.join(name)));
    pages.sort();
    pages
}

/// The parts of a page: code blocks with their languages, inline code, links, and anchors of
/// headings.
#[derive(Default)]
struct Page {
    blocks: Vec<(String, String)>,
    codes: Vec<String>,
    links: Vec<String>,
    anchors: BTreeSet<String>,
}

/// The anchor of a heading on the sites that show such pages.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn read(text: &str) -> Page {
    let mut page = Page::default();
    let (mut block, mut heading): (Option<(String, String)>, Option<String>) = (None, None);
    for event in Parser::new(text) {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                let language = match kind {
                    CodeBlockKind::Fenced(language) => language.to_string(),
                    CodeBlockKind::Indented => String::new(),
                };
                block = Some((language, String::new()));
            }
            Event::End(TagEnd::CodeBlock) => page.blocks.extend(block.take()),
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => {
                page.anchors.extend(heading.take().map(|text| anchor(&text)));
            }
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                page.links.push(dest_url.to_string());
            }
            Event::Text(text) => {
                if let Some((_, block)) = &mut block {
                    block.push_str(&text);
                }
                if let Some(heading) = &mut heading {
                    heading.push_str(&text);
                }
            }
            Event::Code(code) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&code);
                }
                page.codes.push(code.to_string());
            }
            Event::Start(_)
            | Event::End(_)
            | Event::InlineMath(_)
            | Event::DisplayMath(_)
            | Event::Html(_)
            | Event::InlineHtml(_)
            | Event::FootnoteReference(_)
            | Event::SoftBreak
            | Event::HardBreak
            | Event::Rule
            | Event::TaskListMarker(_) => {}
        }
    }
    page
}

#[test]
fn links_lead_somewhere() {
    for path in pages() {
        for link in read(&fs::read_to_string(&path).unwrap()).links {
            if link.starts_with("https://") {
                continue;
            }
            let (file, part) = link.split_once('#').unwrap_or((&link, ""));
            let target =
                if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            assert!(target.exists(), "{}: {link}", path.display());
            if !part.is_empty() {
                let anchors = read(&fs::read_to_string(&target).unwrap()).anchors;
                assert!(
                    anchors.contains(part),
                    "{}: {link} is none of {anchors:?}",
                    path.display()
                );
            }
        }
    }
}

/// A command line as a shell would run it, as far as pages use the syntax: words, and `>` into a
/// file.
fn command(line: &str, folder: &Path) -> Option<Command> {
    let (line, output) = line.split_once('>').unwrap_or((line, ""));
    let words: Vec<&str> = line.split_whitespace().collect();
    let (program, rest) = match &words[..] {
        ["fixpath", rest @ ..] | ["cargo", "run", "--release", "--", rest @ ..] => {
            (cargo_bin("fixpath"), rest)
        }
        ["cargo", "run", "--release", "--example", name, rest @ ..] => {
            (EXAMPLES.join(name), rest.strip_prefix(&["--"]).unwrap_or(rest))
        }
        ["make", rest @ ..] => (PathBuf::from("make"), rest),
        // gtkwave opens a window; the wave tests run it without a screen. Only its files are
        // checked.
        ["gtkwave", rest @ ..] => {
            rest.iter().for_each(|file| assert!(folder.join(file).exists(), "{file}"));
            return None;
        }
        // The command that runs this suite; CI runs it too.
        ["testbenches/run"] => return None,
        _ => panic!("how is `{line}` run?"),
    };
    if rest == ["demo"] {
        let ci = fs::read_to_string(Path::new(ROOT).join(".ci/run")).unwrap();
        assert!(ci.contains("fixpath\" demo"));
        return None;
    }
    let mut command = Command::new(program);
    command.args(rest).current_dir(folder).stdin(Stdio::null());
    if !output.is_empty() {
        command.stdout(fs::File::create(folder.join(output.trim())).unwrap());
    }
    Some(command)
}

#[test]
#[ignore = "needs simulators: testbenches/run installs them"]
fn commands_run() {
    let ran: usize = pages()
        .par_iter()
        .map(|path| {
            let folder = tempfile::tempdir().unwrap();
            let examples = folder.path().join("examples");
            fs::create_dir(&examples).unwrap();
            for entry in fs::read_dir(Path::new(ROOT).join("examples")).unwrap() {
                let entry = entry.unwrap();
                fs::copy(entry.path(), examples.join(entry.file_name())).unwrap();
            }
            let mut ran = 0;
            for (language, block) in read(&fs::read_to_string(path).unwrap()).blocks {
                assert!(LANGUAGES.contains(&&language[..]), "{}: `{language}`", path.display());
                // The one page whose Rust `src/lib.rs` runs.
                assert!(language != "rust" || path.ends_with("library.md"), "{}", path.display());
                if language != "sh" || path.ends_with("CONTRIBUTING.md") {
                    continue;
                }
                for line in block.lines() {
                    let Some(mut command) = command(line, folder.path()) else { continue };
                    let output = command.output().unwrap();
                    let told = String::from_utf8_lossy(&output.stderr);
                    assert!(output.status.success(), "{}: {line}\n{told}", path.display());
                    ran += 1;
                }
            }
            ran
        })
        .sum();
    assert!(ran > 15, "{ran}");
}

/// A new reader decides by the README: what doesn't fit goes to `docs/`.
#[test]
fn the_readme_stays_short() {
    let lines = fs::read_to_string(Path::new(ROOT).join("README.md")).unwrap().lines().count();
    assert!(lines <= 150, "{lines}");
}

/// Commands in inline code exist, and so do their options and parameters.
#[test]
fn commands_within_text_are_known() {
    let mut known = 0;
    for path in pages() {
        for code in read(&fs::read_to_string(&path).unwrap()).codes {
            let words: Vec<&str> = code.split_whitespace().collect();
            if words.first() != Some(&"fixpath") || words.len() < 2 || words[1].contains('-') {
                continue;
            }
            let context = format!("{}: {code}", path.display());
            let mut program = fixpath::cli::command();
            assert!(program.find_subcommand(words[1]).is_some(), "{context}");
            known += 1;
            // Placeholders stand for anything.
            let written_out = |word: &&str| !word.contains(['[', '…', '|']);
            if !words.iter().all(written_out) {
                continue;
            }
            use clap::error::ErrorKind;
            if let Err(why) = program.try_get_matches_from_mut(&words) {
                let cut = matches!(
                    why.kind(),
                    ErrorKind::MissingRequiredArgument | ErrorKind::DisplayHelp
                );
                assert!(cut, "{context}: {why}");
            }
            let unit = words.get(2).and_then(|name| fixpath::units::Unit::find(name).ok());
            let set = words.windows(2).filter(|pair| pair[0] == "-p" && pair[1].contains('='));
            let set: Vec<&str> = set.map(|pair| pair[1]).collect();
            if let Some(unit) = unit
                && let Err(why) = unit.values(&set)
            {
                panic!("{context}: {why}");
            }
        }
    }
    assert!(known > 10, "{known}");
}
