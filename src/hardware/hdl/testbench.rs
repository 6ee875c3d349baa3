//! Testbenches and other files that accompany a module: templates in `templates/`, filled in with
//! its ports, latency and names.

use super::language::Language;
use super::module::{File, MemoryPorts, Module, SlowRate, Word, WordId};
use crate::number::format::Format;
use minijinja::{Environment, UndefinedBehavior, context};
use serde::Serialize;
use std::fmt::Write as _;

/// Number of vectors that are sent a second time, with stalls and gaps.
const AGAIN: u64 = 1000;

/// A port, as seen by templates.
#[derive(Debug, Serialize)]
struct Port {
    name: String,
    /// Sign and range as the language declares them.
    shape: String,
    signed: bool,
    bits: u32,
    /// All bits set, for C++.
    mask: String,
    /// Bit positions in a vector of all ports of this side, the first port at the top.
    top: u32,
    low: u32,
    slice: String,
    /// Stage in which it enters.
    entry: u32,
}

/// A slower rate, as seen by templates.
#[derive(Debug, Serialize)]
struct Rate {
    name: &'static str,
    entry: u32,
    /// Port of its valid bit.
    port: String,
    /// Port that reports when its words are accepted.
    ready: Option<String>,
    /// True if words of all rates are accepted then.
    is_all: bool,
    /// Ports of this rate and of slower ones, and the sum of their bits.
    ports: Vec<String>,
    bits: u32,
}

/// A memory, as seen by templates.
#[derive(Debug, Serialize)]
struct Memory {
    title: String,
    file: String,
    addr_bits: u32,
    row_bits: u32,
    /// The last address.
    last: u64,
    latency: u32,
    reads: Vec<Read>,
    write: Option<Write>,
}

/// Ports for the words read at an address.
#[derive(Debug, Serialize)]
struct Read {
    address: String,
    data: Vec<Port>,
}

/// The write port of a RAM.
#[derive(Debug, Serialize)]
struct Write {
    enable: String,
    address: String,
    data: Vec<Port>,
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
            entry: 0,
        }
    };
    (words.iter().map(port).collect(), all_bits)
}

fn memories(module: &Module, shape: &dyn Fn(&Word) -> String) -> Vec<Memory> {
    let data = |ids: &[WordId]| {
        let words = ids.iter().map(|id| (module.word(*id).name.as_str(), module.word(*id)));
        ports(words, shape).0
    };
    let name = |id: &WordId| module.word(*id).name.clone();
    let memory = |memory: &MemoryPorts| Memory {
        title: memory.table.title.clone(),
        file: module.table_file(&memory.table),
        addr_bits: memory.table.addr_bits,
        row_bits: memory.table.row_bits,
        last: memory.table.len() - 1,
        latency: memory.latency,
        reads: memory
            .reads
            .iter()
            .map(|(address, _, words)| Read { address: address.clone(), data: data(words) })
            .collect(),
        write: memory.write.as_ref().map(|write| Write {
            enable: name(&write.enable),
            address: name(&write.address),
            data: data(&write.data),
        }),
    };
    module.memories.iter().map(memory).collect()
}

fn rates(module: &Module) -> Vec<Rate> {
    let rate = |slow: &SlowRate| {
        let ports = module.inputs.iter().zip(&module.input_rates);
        let ports: Vec<&Word> =
            ports.filter(|(_, of)| **of <= slow.rate).map(|(id, _)| module.word(*id)).collect();
        Rate {
            name: slow.rate.name(),
            entry: slow.entry,
            port: slow.valid.clone(),
            ready: slow.ready.as_ref().map(|(port, _)| port.clone()),
            is_all: slow.interval == module.phases,
            bits: ports.iter().map(|word| word.bits).sum(),
            ports: ports.iter().map(|word| word.name.clone()).collect(),
        }
    };
    module.rates.iter().map(rate).collect()
}

/// Name of the unit under test: the module, or the bench around it.
#[must_use]
pub fn top_name(module: &Module) -> String {
    if module.takes_bench() { bench_name(&module.name) } else { module.name.clone() }
}

/// Name of the bench around a module.
pub(super) fn bench_name(module: &str) -> String {
    format!("{module}_bench")
}

/// The bench around a module in a language, if the module needs one.
pub(super) fn bench(
    module: &Module,
    extension: &str,
    template: &str,
    shape: &dyn Fn(&Word) -> String,
) -> Option<File> {
    let name = format!("{}.{extension}", top_name(module));
    module.takes_bench().then(|| File { name, text: render(template, module, 0, shape) })
}

/// The files with the rows of memories.
fn memory_files(module: &Module) -> impl Iterator<Item = File> {
    module.memories.iter().map(|memory| {
        let mut text = String::new();
        for row in memory.table.rows() {
            text.push_str(&row);
            text.push('\n');
        }
        File { name: module.table_file(&memory.table), text }
    })
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

/// Appends a line of vectors: the words' patterns in hexadecimal.
#[expect(clippy::missing_panics_doc, reason = "words have at most 16 digits")]
pub fn push_vector<'a>(line: &mut String, words: impl Iterator<Item = (i64, Format)> + 'a) {
    for (number, (word, format)) in words.enumerate() {
        let space = if number == 0 { "" } else { " " };
        let digits = usize::try_from(format.bits().div_ceil(4)).expect("bug: at most 16");
        let _ = write!(line, "{space}{:0digits$x}", format.pattern(word));
    }
    line.push('\n');
}

/// Fills in a template; `shape` declares a word in its language.
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
    let (mut inputs, input_bits) = ports(inputs, shape);
    for (port, rate) in inputs.iter_mut().zip(&module.input_rates) {
        let slow = module.rates.iter().find(|slow| slow.rate == *rate);
        port.entry = slow.map_or(module.entry, |slow| slow.entry);
    }
    let (outputs, output_bits) = ports(outputs, shape);
    let written = module.memories.iter().filter(|memory| memory.write.is_some());
    let context = context! {
        name => module.name,
        top => top_name(module),
        bench => module.takes_bench(),
        entry => module.entry,
        rates => rates(module),
        memories => memories(module, shape),
        state => module.has_state,
        resets => written.map(|memory| memory.table.len()).max().unwrap_or(1),
        header => module.header,
        title => module.header.first(),
        latency => module.latency,
        // A vector has words of all rates.
        interval => module.phases,
        unit_interval => module.interval,
        reference => reference_name(module),
        vectors => vectors_file(module),
        tables => module.table_file_names(),
        count => vectors,
        again => vectors.clamp(1, AGAIN),
        inputs, input_bits, outputs, output_bits,
    };
    environment.render_str(template, context).expect("bug: templates fit their context")
}

/// The files that accompany a module and its tables: testbenches, Verilator's harness, a makefile
/// for each simulator, a Yosys script and a file list. `vectors` is the number of test vectors.
#[must_use]
pub fn companions(module: &Module, languages: &[&dyn Language], vectors: u64) -> Vec<File> {
    let name = &module.name;
    let mut files: Vec<File> =
        languages.iter().flat_map(|language| language.companions(module, vectors)).collect();
    files.extend(memory_files(module));
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

/// A file made from a template that doesn't declare words.
pub(super) fn companion(module: &Module, suffix: &str, template: &str, vectors: u64) -> File {
    File {
        name: format!("{}{suffix}", module.name),
        text: render(template, module, vectors, &|_| String::new()),
    }
}
