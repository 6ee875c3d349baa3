//! Results of slow tools, kept by the digest of all their inputs.
//!
//! A tool gives the same result for the same input. `testbenches/records.json` holds, by name, the
//! digest of an input and its result. A run is repeated if its input has changed.
//! `testbenches/run --long` always repeats it, and compares. FIXPATH_BLESS=1 rewrites the file.

use fixpath::outside::Tool;
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use std::fs;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/testbenches/records.json");

/// Held while the file is read or rewritten.
static LOCK: Mutex<()> = Mutex::new(());

fn records() -> Map<String, Value> {
    let text = fs::read_to_string(FILE).unwrap_or_else(|_| "{}".to_owned());
    serde_json::from_str(&text).expect("records.json is an object")
}

/// A text without the lines that are comments in Verilog, VHDL, Rust, makefiles or scripts: no
/// result depends on them.
fn code_of(text: &str) -> String {
    // Some tools obey comments that name them.
    let obeyed =
        |line: &str| ["verilator", "synthesis", "pragma"].iter().any(|tool| line.contains(tool));
    let is_code = |line: &&str| {
        let start = line.trim_start();
        obeyed(start) || !["// ", "-- ", "# "].iter().any(|mark| start.starts_with(mark))
    };
    text.split_inclusive('\n').filter(is_code).collect()
}

/// Digest of texts without their comments, and of the tool's version.
fn digest(tool: &Tool, input: &[&str]) -> String {
    let version = tool.version().unwrap_or_else(|| panic!("{} is {}", tool.name, tool.missing()));
    let mut hash = Sha256::new();
    let input = input.iter().map(|text| code_of(text));
    for text in [tool.name.to_owned(), version].into_iter().chain(input) {
        // The length separates neighbouring texts.
        hash.update(text.len().to_le_bytes());
        hash.update(text.as_bytes());
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The result of `make` with a tool for an input, taken from the record if that has the same input.
pub(crate) fn recorded(
    name: &str,
    tool: &Tool,
    input: &[&str],
    make: impl FnOnce() -> Value,
) -> Value {
    let digest = digest(tool, input);
    let known = {
        let _lock = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
        records().remove(name).filter(|record| record["input"] == digest.as_str())
    };
    let long = std::env::var_os("FIXPATH_LONG").is_some();
    if let Some(record) = &known
        && !long
    {
        return record["result"].clone();
    }
    let result = make();
    if std::env::var_os("FIXPATH_BLESS").is_some() {
        let _lock = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
        let mut all: std::collections::BTreeMap<String, Value> = records().into_iter().collect();
        all.insert(name.to_owned(), json!({ "input": digest, "result": result }));
        let text = serde_json::to_string_pretty(&all).unwrap() + "\n";
        let folder = Path::new(FILE).parent().unwrap();
        let mut file = tempfile::NamedTempFile::new_in(folder).unwrap();
        std::io::Write::write_all(&mut file, text.as_bytes()).unwrap();
        file.persist(FILE).unwrap();
    } else if let Some(record) = known {
        assert_eq!(record["result"], result, "{name}: the record is wrong");
    } else {
        eprintln!("{name} is new or changed: FIXPATH_BLESS=1 testbenches/run keeps its result");
    }
    result
}

#[test]
fn a_digest_tells_inputs_apart() {
    let tool = Tool { name: "echo", program: "echo", install: "", version: &["1.2"] };
    let other = Tool { name: "echo", program: "echo", install: "", version: &["1.3"] };
    let all = [
        digest(&tool, &["ab", "c"]),
        digest(&tool, &["a", "bc"]),
        digest(&tool, &["ab", "c", ""]),
        digest(&other, &["ab", "c"]),
        digest(&tool, &["ab // c", "c"]),
        digest(&tool, &["--x;\nab", "c"]),
        digest(&tool, &["// verilator lint_off WIDTH\nab", "c"]),
    ];
    let different: std::collections::BTreeSet<&String> = all.iter().collect();
    assert_eq!(different.len(), all.len());
    assert_eq!(all[0], digest(&tool, &["ab", "c"]));
    assert_eq!(all[0], digest(&tool, &["// a\n  -- b\n# c\nab", "c"]), "comments don't count");
}
