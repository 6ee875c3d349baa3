//! Testbenches and what else goes with a module: templates in `templates/`, filled with its
//! ports, latency and names.

use super::language::Language;
use super::module::{File, Module, Word};
use crate::number::format::Format;
use minijinja::{Environment, UndefinedBehavior, context};
use serde::Serialize;
use std::fmt::Write as _;

/// How many vectors go through a second time, with stalls and gaps.
const AGAIN: u64 = 1000;

/// A port as templates see it.
#[derive(Debug, Serialize)]
struct Port {
    name: String,
    /// Sign and range as the language declares them.
    shape: String,
    signed: bool,
    bits: u32,
    /// All bits set, for C++.
    mask: String,
    /// Bits in a vector of all ports of this side, the first at the top.
    top: u32,
    low: u32,
    slice: String,
}

fn ports<'a>(
    words: impl Iterator<Item = (&'a str, &'a Word)>,
    shape: &dyn Fn(&Word) -> String,
) -> (Vec<Port>, u32) {
    let words: Vec<_> = words.collect();
    let all_bits = words.iter().map(|(_, word)| word.bits).sum();
    let mut low = all_bits;
    let port = |(name, word): &(&str, &Word)| {
        let top = low - 1;
        low -= word.bits;
        Port {
            name: (*name).to_owned(),
            shape: shape(word),
            signed: word.signed,
            bits: word.bits,
            mask: format!("{:#x}", u64::MAX >> (u64::BITS - word.bits)),
            top,
            low,
            slice: format!("[{top}:{low}]"),
        }
    };
    (words.iter().map(port).collect(), all_bits)
}

/// Name of the file with vectors.
#[must_use]
pub fn vectors_file(module: &Module) -> String {
    format!("{}_vectors.txt", module.name)
}

/// Name of the combinational reference that a module is proved equal to.
#[must_use]
pub fn reference_name(module: &Module) -> String {
    format!("{}_reference", module.name)
}

/// Adds a line of vectors: patterns of words in hexadecimal.
#[expect(clippy::missing_panics_doc, reason = "words have at most 16 digits")]
pub fn push_vector<'a>(line: &mut String, words: impl Iterator<Item = (i64, Format)> + 'a) {
    for (number, (word, format)) in words.enumerate() {
        let space = if number == 0 { "" } else { " " };
        let digits = usize::try_from(format.bits().div_ceil(4)).expect("bug: at most 16");
        let _ = write!(line, "{space}{:0digits$x}", format.pattern(word));
    }
    line.push('\n');
}

/// Fills a template; `shape` declares a word in its language.
pub(super) fn render(
    template: &str,
    module: &Module,
    vectors: u64,
    shape: &dyn Fn(&Word) -> String,
) -> String {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_keep_trailing_newline(true);
    let inputs = module.inputs.iter().map(|id| (module.word(*id).name.as_str(), module.word(*id)));
    let outputs = module.outputs.iter().map(|(name, id)| (name.as_str(), module.word(*id)));
    let (inputs, input_bits) = ports(inputs, shape);
    let (outputs, output_bits) = ports(outputs, shape);
    let context = context! {
        name => module.name,
        header => module.header,
        title => module.header.first(),
        latency => module.latency,
        interval => module.interval,
        reference => reference_name(module),
        vectors => vectors_file(module),
        tables => module.table_file_names(),
        count => vectors,
        again => vectors.clamp(1, AGAIN),
        inputs, input_bits, outputs, output_bits,
    };
    environment.render_str(template, context).expect("bug: templates fit their context")
}

/// What goes with a module and its tables: testbenches, Verilator's harness, a makefile for each
/// simulator, a Yosys script and a file list. `vectors` is how many there will be.
#[must_use]
pub fn companions(module: &Module, languages: &[&dyn Language], vectors: u64) -> Vec<File> {
    let name = &module.name;
    let mut files: Vec<File> =
        languages.iter().flat_map(|language| language.companions(module, vectors)).collect();
    let mut list = String::new();
    for language in languages {
        let _ = writeln!(list, "{name}.{}", language.extension());
    }
    let _ = writeln!(list, "{}", vectors_file(module));
    let companions = files.iter().map(|file| &file.name);
    for name in module.table_file_names().iter().chain(companions) {
        let _ = writeln!(list, "{name}");
    }
    files.push(File { name: format!("{name}_files.txt"), text: list });
    files
}

/// A companion made from a template without words of the language.
pub(super) fn companion(module: &Module, suffix: &str, template: &str, vectors: u64) -> File {
    File {
        name: format!("{}{suffix}", module.name),
        text: render(template, module, vectors, &|_| String::new()),
    }
}
