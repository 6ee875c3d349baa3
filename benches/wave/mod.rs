//! Waves compared with Verilator's: the same vectors through the same pipeline, with every signal
//! in a VCD file.

use crate::{Stimulus, mixed};
use fixpath::units::Design;
use fixpath::wave::{Options, Wave};
use std::collections::HashMap;
use std::fs;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Vectors of a wave.
pub(crate) const VECTORS: usize = 100_000;

/// A way to write a wave.
pub(crate) struct Row<'a> {
    pub(crate) name: &'static str,
    /// The file, which is rewritten each time.
    pub(crate) file: PathBuf,
    words_only: bool,
    design: &'a Design,
}

/// The ways: the signals that Verilator writes, and these with reals.
pub(crate) fn rows<'a>(design: &'a Design, folder: &Path) -> Vec<Row<'a>> {
    let row = |name, file, words_only| Row { name, file: folder.join(file), words_only, design };
    vec![
        row("wave, VCD of all signals", "words.vcd", true),
        row("wave, VCD of all signals and reals", "reals.vcd", false),
    ]
}

/// The vectors of a wave, sample by sample.
pub(crate) fn samples(stimulus: &Stimulus) -> Vec<Vec<i64>> {
    (0..VECTORS).map(|i| stimulus.wide.iter().map(|column| column[i]).collect()).collect()
}

impl Row<'_> {
    /// Writes the file and returns the seconds it took, including pipelining and the choice of
    /// signals.
    pub(crate) fn write(&self, samples: &[Vec<i64>]) -> f64 {
        let _ = fs::remove_file(&self.file);
        let start = Instant::now();
        let options = Options { all: true, words_only: self.words_only, ..Options::default() };
        let wave = Wave::new(self.design, options).expect("a pipeline");
        let mut file = fs::File::create(&self.file).expect("a file");
        wave.write(samples, &mut file, &self.file).expect("a wave");
        drop(file);
        start.elapsed().as_secs_f64()
    }
}

/// The contents of a VCD file.
pub(crate) struct Contents {
    pub(crate) bytes: u64,
    /// Number of identifiers: several names of one signal count once.
    pub(crate) variables: usize,
    /// Number of changes of words, and of reals.
    pub(crate) changes: u64,
    pub(crate) reals: u64,
    /// Checksum of the words at the output ports after each rising edge with valid data, as for the
    /// other rows.
    pub(crate) checksum: u64,
}

impl Contents {
    pub(crate) fn of(path: &Path, design: &Design) -> Self {
        let mut contents = Self {
            bytes: fs::metadata(path).expect("it was written").len(),
            variables: 0,
            changes: 0,
            reals: 0,
            checksum: 0,
        };
        let netlist = &design.netlist;
        let names: Vec<&str> = netlist.outputs().iter().map(|o| o.name.as_str()).collect();
        let mut codes: HashMap<Vec<u8>, String> = HashMap::new();
        let (mut words, mut clk, mut valid) = (vec![0; names.len()], false, false);
        let (mut samples, mut rose) = (0, false);
        let mut reader = BufReader::with_capacity(1 << 20, fs::File::open(path).expect("a file"));
        let mut line = Vec::new();
        loop {
            line.clear();
            if reader.read_until(b'\n', &mut line).expect("readable") == 0 {
                break;
            }
            let line = line.trim_ascii();
            let (value, code) = match line.first() {
                Some(b'#') => {
                    // The changes before this time stamp form one moment.
                    if rose && valid && samples < VECTORS {
                        contents.checksum =
                            words.iter().fold(contents.checksum, |sum, word| mixed(sum, *word));
                        samples += 1;
                    }
                    rose = false;
                    continue;
                }
                Some(b'0' | b'1' | b'x') => line.split_at(1),
                Some(b'b' | b'r') => {
                    let blank = line.iter().position(|byte| *byte == b' ').expect("a change");
                    (&line[..blank], &line[blank + 1..])
                }
                _ => {
                    let text = std::str::from_utf8(line).expect("plain text");
                    let parts: Vec<&str> = text.split_whitespace().collect();
                    if let ["$var", _, _, code, name, ..] = parts[..] {
                        // The first of several names is the outermost: the port.
                        codes.entry(code.into()).or_insert_with(|| name.to_owned());
                    }
                    continue;
                }
            };
            if value[0] == b'r' {
                contents.reals += 1;
                continue;
            }
            contents.changes += 1;
            let set = value.ends_with(b"1");
            let name = codes.get(code).expect("a declared code").as_str();
            if name == "clk" {
                (rose, clk) = (set && !clk, set);
            } else if name == "valid_out" {
                valid = set;
            } else if let Some(port) = names.iter().position(|known| *known == name) {
                let format = netlist.node(netlist.outputs()[port].node).format;
                let bits = std::str::from_utf8(&value[1..]).expect("plain text");
                // Initially unknown.
                let pattern = i64::from_str_radix(bits, 2).unwrap_or(0);
                words[port] = i32::try_from(format.wrap(pattern)).expect("a narrow port");
            }
        }
        assert_eq!(samples, VECTORS, "results in {}", path.display());
        contents.variables = codes.len();
        contents
    }
}
