//! The batch engine compared with its alternatives, on the rotation unit:
//!
//! ```sh
//! cargo bench --bench engine            # a table; `-- --json FILE` writes it as JSON too
//! ```
//!
//! Every row does the same work on the same 2^20 vectors of random words, on one thread, and must
//! give the same checksum. The rows are the engine, the reference interpreter, hand-written kernels
//! for this one setting (with `fixed`'s types, and in vectorised passes over blocks), and, if
//! installed, Verilator on the emitted Verilog, built with its best flags. Slow rows use fewer
//! vectors. Waves of the first 10^5 vectors with every signal are written to files in one folder by
//! `fixpath wave`'s code and by Verilator's tracing. Each is timed from before its file is created
//! to after it is closed, and the contents of the files are counted. The whole of `sim`, on one
//! thread and on all, draws its own vectors. Rows take turns, round by round. Each row's stimulus
//! is timed in pieces, and the best time of each piece over all rounds counts, to exclude other
//! load on the machine.
#![allow(
    missing_docs,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::disallowed_methods
)]

use fixed::types::{I14F18, I46F18};
use fixpath::emit::{Package, Settings};
use fixpath::measure::{Basis, Inputs, measure_on};
use fixpath::netlist::{Netlist, NodeId};
use fixpath::op::Op;
use fixpath::outside::VERILATOR;
use fixpath::sim::batch::{Features, Program, Runner};
use fixpath::units::{Design, Sampler, Unit};
use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

mod wave;

/// Vectors of the stimulus.
const SAMPLES: usize = 1 << 20;
/// Vectors per timed piece.
const PIECE: usize = 1 << 14;
/// Vectors of slow rows.
const FEW: usize = 1 << 16;
/// Number of rounds.
const ROUNDS: usize = 9;
/// Vectors per block of the hand-written kernels.
const BLOCK: usize = 512;

fn main() {
    let mut args = std::env::args().skip(1);
    let mut json = None;
    let mut rounds = ROUNDS;
    let mut only = String::new();
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--json" => json = Some(PathBuf::from(args.next().expect("--json FILE"))),
            "--rounds" => {
                rounds = args.next().and_then(|n| n.parse().ok()).expect("--rounds N");
            }
            "--rows" => only = args.next().expect("--rows TEXT"),
            "--bench" => {}
            other => panic!("unknown argument {other}: --json FILE, --rounds N, --rows TEXT"),
        }
    }
    let mut all = serde_json::json!({
        "version": env!("CARGO_PKG_VERSION"),
        "processor": processor(),
        "cores": std::thread::available_parallelism().map_or(1, usize::from),
        "verilator": VERILATOR.version(),
        "rounds": rounds,
    });
    for variant in ["corrected", "exact"] {
        all[variant] = bench(variant, rounds, &only);
    }
    if let Some(path) = json {
        let text = serde_json::to_string_pretty(&all).expect("plain values");
        fs::write(&path, text + "\n").expect("the JSON file can't be written");
    }
}

/// The processor's model, on Linux.
fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// Times every row for one variant.
fn bench(variant: &str, rounds: usize, only: &str) -> serde_json::Value {
    let unit = Unit::find("rotation").expect("listed");
    let design = unit.values(&[format!("variant={variant}")]).unwrap().build().unwrap();
    let netlist = &design.netlist;
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let stimulus = Stimulus::new();

    let times: Vec<f64> = (0..50)
        .map(|_| {
            let start = Instant::now();
            black_box(Program::compile(netlist, &outputs));
            start.elapsed().as_secs_f64()
        })
        .collect();
    let compile_us = times.iter().copied().fold(f64::INFINITY, f64::min) * 1e6;

    let program = Program::compile(netlist, &outputs);
    let tables = Tables::new(netlist);
    let corrected = variant == "corrected";
    let mut rows: Vec<Row<'_>> = vec![
        Row::new("engine, narrow columns", SAMPLES, {
            let (mut runner, program) = (program.runner(), &program);
            move |at: &Piece<'_>, to| narrow_columns(&mut runner, program, at, to)
        }),
        Row::new("engine, 64-bit columns", SAMPLES, {
            let (mut runner, program) = (program.runner(), &program);
            let mut columns = vec![Vec::new(); outputs.len()];
            move |at: &Piece<'_>, to| {
                runner.run(program, &at.wide, &mut columns).unwrap();
                for (to, column) in to.iter_mut().zip(&columns) {
                    // This isn't part of the engine's work, but the columns must be used.
                    black_box(column);
                    if at.checked {
                        to.iter_mut().zip(column).for_each(|(to, word)| *to = *word as i32);
                    }
                }
            }
        }),
        Row::new("by hand, `fixed` types, scalar", SAMPLES, {
            let tables = &tables;
            move |at: &Piece<'_>, to| with_fixed(tables, corrected, at, to)
        }),
        Row::new("reference interpreter", FEW, {
            let ports: Vec<NodeId> = outputs.clone();
            move |at: &Piece<'_>, to| reference(netlist, &ports, at, to)
        }),
    ];
    for features in Features::here() {
        let (mut blocks, tables) = (Blocks::default(), &tables);
        rows.push(Row::new(&format!("by hand, block passes, {features:?}"), SAMPLES, {
            move |at: &Piece<'_>, to| by_hand(*features, &mut blocks, tables, corrected, at, to)
        }));
        let (mut runner, program) = (program.runner_for(*features), &program);
        rows.push(Row::new(&format!("engine, narrow columns, {features:?}"), SAMPLES, {
            move |at: &Piece<'_>, to| narrow_columns(&mut runner, program, at, to)
        }));
    }
    let folder = tempfile::tempdir().expect("a folder for temporary files");
    // The first row is the reference for the others.
    let mut first = true;
    rows.retain(|row| std::mem::take(&mut first) || row.name.contains(only));
    let verilated = Verilated::build_all(&design, &stimulus, folder.path(), only);
    let mut best: Vec<Vec<f64>> =
        rows.iter().map(|row| vec![f64::INFINITY; row.pieces()]).collect();
    let mut outside: Vec<Vec<f64>> =
        verilated.iter().map(|v| vec![f64::INFINITY; v.samples / v.piece]).collect();
    let waves: Vec<wave::Row<'_>> =
        wave::rows(&design, folder.path()).into_iter().filter(|w| w.name.contains(only)).collect();
    let samples = if waves.is_empty() { Vec::new() } else { wave::samples(&stimulus) };
    let mut best_waves = vec![f64::INFINITY; waves.len()];
    for _ in 0..rounds {
        for (row, best) in rows.iter_mut().zip(&mut best) {
            row.round(&stimulus, outputs.len(), best);
        }
        for (verilated, best) in verilated.iter().zip(&mut outside) {
            verilated.round(best);
        }
        for (wave, best) in waves.iter().zip(&mut best_waves) {
            *best = best.min(wave.write(&samples));
        }
    }
    let checksums: Vec<u64> =
        rows.iter_mut().map(|row| row.checksum(&stimulus, outputs.len())).collect();
    let few = rows[0].checksum_of(&stimulus, outputs.len(), FEW);
    for (row, checksum) in rows.iter().zip(&checksums) {
        let should = if row.samples == SAMPLES { checksums[0] } else { few };
        assert_eq!(*checksum, should, "{} gave other words", row.name);
    }
    let mut table: Vec<(String, f64)> = rows
        .iter()
        .zip(&best)
        .map(|(row, best)| (row.name.clone(), row.samples as f64 / best.iter().sum::<f64>() / 1e6))
        .collect();
    for (verilated, best) in verilated.iter().zip(&outside) {
        let should = rows[0].checksum_of(&stimulus, outputs.len(), verilated.samples);
        assert_eq!(verilated.checksum(), should, "{} gave other words", verilated.name);
        table.push((
            verilated.name.to_owned(),
            verilated.samples as f64 / best.iter().sum::<f64>() / 1e6,
        ));
    }
    let should = rows[0].checksum_of(&stimulus, outputs.len(), wave::VECTORS);
    let traced = verilated.iter().zip(&outside).filter(|(verilated, _)| verilated.is_traced());
    let files = waves
        .iter()
        .zip(&best_waves)
        .map(|(wave, best)| (wave.name, wave.file.clone(), *best))
        .chain(traced.map(|(v, best)| (v.name, v.folder.join("trace.vcd"), best[0])));
    let files: Vec<(&str, wave::Contents, f64)> =
        files.map(|(name, file, best)| (name, wave::Contents::of(&file, &design), best)).collect();
    for (name, contents, best) in &files {
        assert_eq!(contents.checksum, should, "{name} shows other words");
        if !table.iter().any(|(known, _)| known == name) {
            table.push(((*name).to_owned(), wave::VECTORS as f64 / best / 1e6));
        }
    }
    let whole = "whole sim".contains(only).then(|| Whole::time(&design, rounds));
    let engine = table[0].1;
    println!(
        "\nrotation variant={variant}, million vectors per second on one thread; engine compiled in {compile_us:.0} us"
    );
    for (name, rate) in &table {
        println!("  {name:<40} {rate:>9.3}   engine / this {:>8.2}", engine / rate);
    }
    if let Some(whole) = &whole {
        println!("{}", whole.text());
    }
    let theirs = files.iter().find(|(name, ..)| name.starts_with("verilator"));
    let theirs = theirs.map(|(_, _, best)| *best);
    if !files.is_empty() {
        println!("VCD files of {} vectors", wave::VECTORS);
    }
    for (name, contents, best) in &files {
        println!(
            "  {name:<40} {best:>6.3} s {:>4} MB, {:>3} variables, {} changes of words and {} of reals{}",
            contents.bytes / 1_000_000,
            contents.variables,
            contents.changes,
            contents.reals,
            theirs
                .map(|theirs| format!("   Verilator's time / this {:.2}", theirs / best))
                .unwrap_or_default(),
        );
    }
    serde_json::json!({
        "unit": "rotation",
        "samples": SAMPLES,
        "compile_us": compile_us,
        "checksum": format!("{:016x}", checksums[0]),
        "rows": table.iter().map(|(name, rate)| serde_json::json!({
            "name": name,
            "million_samples_per_second": rate,
            "engine_over_this": engine / rate,
        })).collect::<Vec<_>>(),
        "whole_sim": whole.map(|whole| whole.json()),
        "waves": files.iter().map(|(name, contents, best)| serde_json::json!({
            "name": name,
            "vectors": wave::VECTORS,
            "seconds": best,
            "verilator_time_over_this": theirs.map(|theirs| theirs / best),
            "bytes": contents.bytes,
            "variables": contents.variables,
            "word_changes": contents.changes,
            "real_changes": contents.reals,
        })).collect::<Vec<_>>(),
    })
}

/// The work of `sim`: drawing vectors, running engine, golden model and reals, and counting errors
/// on four bases.
struct Whole {
    /// Million vectors per second, on one thread and on all.
    rates: Vec<(usize, f64)>,
    /// On one thread, with errors on the basis total only.
    total: f64,
    /// The engine alone, in the same runs on one thread.
    engine: f64,
    /// Share of each part in the time on one thread.
    shares: Vec<(&'static str, f64)>,
}

impl Whole {
    /// The best of several runs.
    fn time(design: &Design, rounds: usize) -> Self {
        let inputs = Inputs { sampler: Sampler::Lit, samples: 1 << 22, seed: 1 };
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let mut whole = Self { rates: Vec::new(), total: 0.0, engine: 0.0, shares: Vec::new() };
        for threads in if cores > 1 { vec![1, cores] } else { vec![1] } {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            let pool = pool.expect("threads");
            let speed = |bases: &[Basis]| {
                let reports = pool.install(|| measure_on(bases, &[design], &inputs, &|_| ()));
                reports.expect("nothing overflows").remove(0).speed
            };
            let mut best = 0.0;
            for _ in 0..rounds {
                if threads == 1 {
                    let total = speed(&[Basis::Total]).samples_per_second / 1e6;
                    whole.total = whole.total.max(total);
                }
                let speed = speed(&Basis::ALL);
                if threads == 1 && speed.samples_per_second > best {
                    whole.engine = speed.engine_samples_per_second_per_thread / 1e6;
                    let parts = speed.profile.parts();
                    let total: f64 = parts.iter().map(|(_, seconds)| seconds).sum();
                    let share = |(name, seconds)| (name, seconds / total);
                    whole.shares = parts.into_iter().map(share).collect();
                }
                best = speed.samples_per_second.max(best);
            }
            whole.rates.push((threads, best / 1e6));
        }
        whole
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for (threads, rate) in &self.rates {
            let _ = writeln!(
                text,
                "  whole sim, {threads} threads{:<21} {rate:>9.3}   one thread / this {:>8.2}",
                "",
                self.rates[0].1 / rate
            );
        }
        let _ = writeln!(
            text,
            "  whole sim --basis total, 1 threads         {:>9.3}   all bases / this {:>8.2}",
            self.total,
            self.rates[0].1 / self.total
        );
        let _ = write!(
            text,
            "  its engine {:.0} on 64-bit columns, so the whole takes {:.1} times as long:",
            self.engine,
            self.engine / self.rates[0].1
        );
        for (name, share) in &self.shares {
            let _ = write!(text, " {name} {:.0} %", 100.0 * share);
        }
        text
    }

    fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "million_samples_per_second": self.rates.iter().map(|(threads, rate)| serde_json::json!({"threads": threads, "rate": rate})).collect::<Vec<_>>(),
            "total_only_million_samples_per_second": self.total,
            "engine_million_samples_per_second": self.engine,
            "whole_time_over_engine_time": self.engine / self.rates[0].1,
            "shares": self.shares.iter().map(|(name, share)| (*name, *share)).collect::<std::collections::BTreeMap<_, _>>(),
        })
    }
}

/// Input words of 16 bits.
struct Stimulus {
    narrow: [Vec<u16>; 4],
    wide: [Vec<i64>; 4],
}

impl Stimulus {
    fn new() -> Self {
        let mut state = 1u64;
        let mut bits = || {
            // splitmix64
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        };
        let narrow: [Vec<u16>; 4] =
            std::array::from_fn(|_| (0..SAMPLES).map(|_| bits() as u16).collect());
        let wide = std::array::from_fn(|i| narrow[i].iter().map(|word| i64::from(*word)).collect());
        Self { narrow, wide }
    }

    fn piece(&self, start: usize, checked: bool) -> Piece<'_> {
        Piece {
            narrow: std::array::from_fn(|i| &self.narrow[i][start..start + PIECE]),
            wide: std::array::from_fn(|i| &self.wide[i][start..start + PIECE]),
            checked,
        }
    }
}

/// The vectors timed at once.
struct Piece<'a> {
    narrow: [&'a [u16]; 4],
    wide: [&'a [i64]; 4],
    /// True if the words are checked; false if the run is timed.
    checked: bool,
}

type Work<'a> = Box<dyn FnMut(&Piece<'_>, &mut [Vec<i32>]) + 'a>;

struct Row<'a> {
    name: String,
    samples: usize,
    run: Work<'a>,
}

impl<'a> Row<'a> {
    fn new(name: &str, samples: usize, run: impl FnMut(&Piece<'_>, &mut [Vec<i32>]) + 'a) -> Self {
        Self { name: name.to_owned(), samples, run: Box::new(run) }
    }

    fn pieces(&self) -> usize {
        self.samples / PIECE
    }

    fn round(&mut self, stimulus: &Stimulus, outputs: usize, best: &mut [f64]) {
        let mut to = vec![vec![0; PIECE]; outputs];
        for (i, best) in best.iter_mut().enumerate() {
            let piece = stimulus.piece(i * PIECE, false);
            let start = Instant::now();
            (self.run)(&piece, &mut to);
            *best = best.min(start.elapsed().as_secs_f64());
            black_box(&to);
        }
    }

    fn checksum(&mut self, stimulus: &Stimulus, outputs: usize) -> u64 {
        self.checksum_of(stimulus, outputs, self.samples)
    }

    fn checksum_of(&mut self, stimulus: &Stimulus, outputs: usize, samples: usize) -> u64 {
        let mut to = vec![vec![0; PIECE]; outputs];
        let mut sum = 0;
        for i in 0..samples.div_ceil(PIECE) {
            (self.run)(&stimulus.piece(i * PIECE, true), &mut to);
            for at in 0..PIECE.min(samples - i * PIECE) {
                for column in &to {
                    sum = mixed(sum, column[at]);
                }
            }
        }
        sum
    }
}

/// One step of the checksum, which depends on every word and its position.
fn mixed(sum: u64, word: i32) -> u64 {
    (sum ^ u64::from(word as u32)).wrapping_mul(0x100_0000_01b3)
}

fn narrow_columns(runner: &mut Runner, program: &Program, at: &Piece<'_>, to: &mut [Vec<i32>]) {
    runner.run_words(program, &at.narrow, to).expect("bug: words are of their ports' formats");
}

fn reference(netlist: &Netlist, ports: &[NodeId], at: &Piece<'_>, to: &mut [Vec<i32>]) {
    for i in 0..PIECE {
        let (words, _) = netlist.eval(&at.wide.map(|column| column[i])).unwrap();
        for (to, id) in to.iter_mut().zip(ports) {
            to[i] = words[id.index()] as i32;
        }
    }
}

/// The tables of both variants, as the hand-written kernels store them.
struct Tables {
    /// Two 32-bit words, side by side.
    sincos: Vec<u64>,
    cos: Vec<i32>,
    asin: Vec<i32>,
    recip: Vec<u64>,
    atan: Vec<i32>,
    prop: Vec<i32>,
}

impl Tables {
    fn new(netlist: &Netlist) -> Self {
        let words = |table: &str, column: usize| -> Vec<i32> {
            let found = netlist.tables().iter().find(|known| known.name == table);
            found.map_or_else(
                || vec![0; 1024],
                |table| table.columns[column].words.iter().map(|word| *word as i32).collect(),
            )
        };
        let pair = |a: Vec<i32>, b: Vec<i32>| {
            let both = |(a, b): (i32, i32)| u64::from(a as u32) | u64::from(b as u32) << 32;
            a.into_iter().zip(b).map(both).collect()
        };
        let reads = netlist.nodes().iter().filter(|node| matches!(node.op, Op::Read { .. }));
        assert!(reads.count() >= 9, "the tables of a rotation");
        Self {
            sincos: pair(words("sincos", 0), words("sincos", 1)),
            cos: words("sincos", 1),
            asin: words("asin", 0),
            recip: pair(words("recip_sin", 0), words("recip_cos", 0)),
            atan: words("atan", 0),
            prop: words("prop", 0),
        }
    }
}

/// Columns of one block, aligned to a cache line like the engine's.
#[repr(align(64))]
struct Blocks {
    index: [[u16; BLOCK]; 8],
    words: [[i32; BLOCK]; 14],
}

impl Default for Blocks {
    fn default() -> Self {
        Self { index: [[0; BLOCK]; 8], words: [[0; BLOCK]; 14] }
    }
}

fn by_hand(
    features: Features,
    blocks: &mut Blocks,
    tables: &Tables,
    corrected: bool,
    at: &Piece<'_>,
    to: &mut [Vec<i32>],
) {
    // Features that this processor lacks have no row.
    assert!(Features::here().contains(&features), "bug: {features:?} isn't here");
    match features {
        // SAFETY: safe code, called only where the processor has the features it is compiled for.
        #[cfg(target_arch = "x86_64")]
        Features::Avx512 => unsafe { by_hand_avx512(blocks, tables, corrected, at, to) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Features::Avx2 => unsafe { by_hand_avx2(blocks, tables, corrected, at, to) },
        _ => by_hand_body(blocks, tables, corrected, at, to),
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi2")]
fn by_hand_avx2(
    blocks: &mut Blocks,
    tables: &Tables,
    corrected: bool,
    at: &Piece<'_>,
    to: &mut [Vec<i32>],
) {
    by_hand_body(blocks, tables, corrected, at, to);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512bw,avx512dq,avx512vl,bmi2")]
fn by_hand_avx512(
    blocks: &mut Blocks,
    tables: &Tables,
    corrected: bool,
    at: &Piece<'_>,
    to: &mut [Vec<i32>],
) {
    by_hand_body(blocks, tables, corrected, at, to);
}

#[inline(always)]
fn by_hand_body(
    blocks: &mut Blocks,
    tables: &Tables,
    corrected: bool,
    at: &Piece<'_>,
    to: &mut [Vec<i32>],
) {
    for start in (0..PIECE).step_by(BLOCK) {
        let input = at.narrow.map(|column| column[start..start + BLOCK].try_into().unwrap());
        if corrected {
            let [phi, theta] = to else { panic!("two outputs") };
            let phi = (&mut phi[start..start + BLOCK]).try_into().unwrap();
            let theta = (&mut theta[start..start + BLOCK]).try_into().unwrap();
            corrected_block(blocks, tables, input, phi, theta);
        } else {
            let [x, y, z] = to else { panic!("three outputs") };
            let x = (&mut x[start..start + BLOCK]).try_into().unwrap();
            let y = (&mut y[start..start + BLOCK]).try_into().unwrap();
            let z = (&mut z[start..start + BLOCK]).try_into().unwrap();
            exact_block(blocks, tables, input, [x, y, z]);
        }
    }
}

/// Four indices in one load.
#[inline(always)]
fn four(index: &[u16; 4]) -> [usize; 4] {
    let [a, b, c, d] = index.map(u16::to_le_bytes);
    let all = u64::from_le_bytes([a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]]);
    [0, 16, 32, 48].map(|shift| (all >> shift & 1023) as usize)
}

#[inline(always)]
fn single(table: &[i32], index: &[u16; BLOCK], to: &mut [i32; BLOCK]) {
    let table: &[i32; 1024] = table.try_into().unwrap();
    for (to, index) in to.as_chunks_mut::<4>().0.iter_mut().zip(index.as_chunks::<4>().0) {
        *to = four(index).map(|index| table[index]);
    }
}

#[inline(always)]
fn pair(table: &[u64], index: &[u16; BLOCK], a: &mut [i32; BLOCK], b: &mut [i32; BLOCK]) {
    let table: &[u64; 1024] = table.try_into().unwrap();
    let to = a.as_chunks_mut::<4>().0.iter_mut().zip(b.as_chunks_mut::<4>().0);
    for ((a, b), index) in to.zip(index.as_chunks::<4>().0) {
        let index = four(index);
        for lane in 0..4 {
            let both = table[index[lane]];
            (a[lane], b[lane]) = (both as i32, (both >> 32) as i32);
        }
    }
}

/// Rounds half up, dropping `S` bits.
#[inline(always)]
fn half_up<const S: u32>(x: i32) -> i32 {
    x.wrapping_add(1 << (S - 1)) >> S
}

/// A sum of words that are far from the ends of their lanes: an overflow check would prevent
/// vectorisation.
#[inline(always)]
fn sum(words: [i32; 4]) -> i32 {
    words[0].wrapping_add(words[1]).wrapping_add(words[2].wrapping_add(words[3]))
}

#[inline(always)]
fn difference(a: i32, b: i32) -> i32 {
    a.wrapping_sub(b)
}

#[inline(always)]
fn clamp(x: i32, bits: u32) -> i32 {
    let (lo, hi) = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1);
    let x = if x < lo { lo } else { x };
    if x > hi { hi } else { x }
}

#[inline(always)]
fn exact_block(
    blocks: &mut Blocks,
    tables: &Tables,
    [pa, ta, pn, tn]: [&[u16; BLOCK]; 4],
    [x, y, z]: [&mut [i32; BLOCK]; 3],
) {
    let Blocks { index, words } = blocks;
    for i in 0..BLOCK {
        let (ta, tn) = (ta[i], tn[i]);
        let d = pa[i].wrapping_sub(pn[i]);
        let (ang_x, ang_y) = (ta.wrapping_add(d), ta.wrapping_sub(d));
        index[0][i] = ang_y >> 6;
        index[1][i] = ang_x >> 6;
        index[2][i] = ang_x.wrapping_add(tn) >> 6;
        index[3][i] = ang_x.wrapping_sub(tn) >> 6;
        index[4][i] = ang_y.wrapping_add(tn) >> 6;
        index[5][i] = ang_y.wrapping_sub(tn) >> 6;
        index[6][i] = ta.wrapping_add(tn) >> 6;
        index[7][i] = ta.wrapping_sub(tn) >> 6;
    }
    let [cy, cx, sxp, cxp, sxm, cxm, syp, cyp, sym, cym, sap, cap, sam, cam] = words;
    single(&tables.cos, &index[0], cy);
    single(&tables.cos, &index[1], cx);
    pair(&tables.sincos, &index[2], sxp, cxp);
    pair(&tables.sincos, &index[3], sxm, cxm);
    pair(&tables.sincos, &index[4], syp, cyp);
    pair(&tables.sincos, &index[5], sym, cym);
    pair(&tables.sincos, &index[6], sap, cap);
    pair(&tables.sincos, &index[7], sam, cam);
    for i in 0..BLOCK {
        // 20 fraction bits.
        let quarter_x = sum([sxp[i], sxm[i], syp[i], sym[i]]);
        let half_x = difference(sap[i], sam[i]) << 1;
        x[i] = clamp(half_up::<4>(difference(quarter_x, half_x)), 18);
        y[i] = clamp(half_up::<3>(difference(cy[i], cx[i])), 18);
        let quarter_z = difference(difference(cxm[i], cxp[i]), difference(cyp[i], cym[i]));
        let half_z = cap[i].wrapping_add(cam[i]) << 1;
        z[i] = clamp(half_up::<4>(quarter_z.wrapping_add(half_z)), 18);
    }
}

#[inline(always)]
fn corrected_block(
    blocks: &mut Blocks,
    tables: &Tables,
    [pa, ta, pn, tn]: [&[u16; BLOCK]; 4],
    phi: &mut [i32; BLOCK],
    theta: &mut [i32; BLOCK],
) {
    let Blocks { index, words } = blocks;
    let [ix, iy, ia, ir, it, ip, ..] = index;
    let [sx, cx, sy, cy, asin, double, z, rs, rc, atan, prop, ..] = words;
    for i in 0..BLOCK {
        let d = pa[i].wrapping_sub(pn[i]);
        ix[i] = ta[i].wrapping_add(d) >> 6;
        iy[i] = ta[i].wrapping_sub(d) >> 6;
    }
    pair(&tables.sincos, ix, sx, cx);
    pair(&tables.sincos, iy, sy, cy);
    for i in 0..BLOCK {
        let sine = clamp(half_up::<1>(sx[i].wrapping_add(sy[i])), 19);
        ia[i] = (sine >> 9) as u16 & 1023;
        double[i] = difference(cy[i], cx[i]);
    }
    single(&tables.asin, ia, asin);
    for i in 0..BLOCK {
        let behind = ta[i] > 16384 && ta[i] < 49152;
        let theta_x = if behind { asin[i].wrapping_neg() ^ 131_072 } else { asin[i] };
        let turned = difference(theta_x, i32::from(tn[i]) << 2);
        z[i] = turned << 14 >> 14;
        ir[i] = (z[i] >> 8) as u16 & 1023;
    }
    pair(&tables.recip, ir, rs, rc);
    for i in 0..BLOCK {
        let times = |by: i32| {
            let product = i64::from(double[i]).wrapping_mul(i64::from(by));
            (product.wrapping_add(1 << 17) >> 18) as i32
        };
        it[i] = (clamp(times(rs[i]), 23) >> 13) as u16 & 1023;
        let size = clamp(times(rc[i]), 19).wrapping_abs();
        ip[i] = (if size > 262_143 { 262_143 } else { size } >> 8) as u16;
    }
    single(&tables.atan, it, atan);
    single(&tables.prop, ip, prop);
    for i in 0..BLOCK {
        let turned = if z[i] < 0 { atan[i] ^ 131_072 } else { atan[i] } & 262_143;
        phi[i] = half_up::<2>(turned) & 65535;
        let size = z[i].wrapping_abs();
        let part = i64::from(difference(65536, size)).wrapping_mul(i64::from(prop[i]));
        let whole = (i64::from(size) << 18).wrapping_add(part);
        theta[i] = (whole.wrapping_add(1 << 19) >> 20) as i32 & 65535;
    }
}

fn halves(both: u64) -> [i32; 2] {
    [both as i32, (both >> 32) as i32]
}

/// The straightforward version with `fixed`'s types, sample by sample.
fn with_fixed(tables: &Tables, corrected: bool, at: &Piece<'_>, to: &mut [Vec<i32>]) {
    type Word = I14F18;
    let half_up = |x: I46F18, drop: u32| (x.to_bits() + (1 << (drop - 1))) >> drop;
    for i in 0..PIECE {
        let [pa, ta, pn, tn] = at.narrow.map(|column| column[i]);
        let d = pa.wrapping_sub(pn);
        let (ang_x, ang_y) = (ta.wrapping_add(d), ta.wrapping_sub(d));
        let sincos = |angle: u16| {
            halves(tables.sincos[usize::from(angle >> 6)])
                .map(|word| I46F18::from(Word::from_bits(word)))
        };
        if corrected {
            let ([sx, cx], [sy, cy]) = (sincos(ang_x), sincos(ang_y));
            let sine = half_up(sx + sy, 1).clamp(-(1 << 18), (1 << 18) - 1);
            let asin = I46F18::from_bits(tables.asin[(sine >> 9 & 1023) as usize].into());
            let behind = ta > 16384 && ta < 49152;
            let theta_x = if behind { -asin + I46F18::from_num(0.5) } else { asin };
            let turned = theta_x - I46F18::from_bits(i64::from(tn) << 2);
            let z = I46F18::from_bits(turned.to_bits() << 46 >> 46);
            let [rs, rc] = halves(tables.recip[(z.to_bits() >> 8 & 1023) as usize]);
            let double = cy - cx;
            let times = |by: i32| {
                // 2^-36, as separate `i64` words.
                let product = I46F18::from_bits(double.to_bits() * i64::from(by));
                half_up(product, 18)
            };
            let tan = times(rs).clamp(-(1 << 22), (1 << 22) - 1);
            let y_k = times(rc).clamp(-(1 << 18), (1 << 18) - 1).abs().min((1 << 18) - 1);
            let atan = tables.atan[(tan >> 13 & 1023) as usize];
            let prop = tables.prop[(y_k >> 8) as usize];
            let phi = if z < 0 { atan ^ 131_072 } else { atan } & 262_143;
            to[0][i] = (phi + 2) >> 2 & 65535;
            let size = z.abs();
            let rest = I46F18::from_num(0.25) - size;
            let part = rest.to_bits() * i64::from(prop);
            let theta = I46F18::from_bits((size.to_bits() << 18) + part);
            to[1][i] = (half_up(theta, 20) & 65535) as i32;
        } else {
            let [[sxp, cxp], [sxm, cxm]] =
                [ang_x.wrapping_add(tn), ang_x.wrapping_sub(tn)].map(sincos);
            let [[syp, cyp], [sym, cym]] =
                [ang_y.wrapping_add(tn), ang_y.wrapping_sub(tn)].map(sincos);
            let [[sap, cap], [sam, cam]] = [ta.wrapping_add(tn), ta.wrapping_sub(tn)].map(sincos);
            let two = |x: I46F18| x + x;
            let x = sxp + sxm + syp + sym - two(sap - sam);
            let y = sincos(ang_y)[1] - sincos(ang_x)[1];
            let z = cxm - cxp + cym - cyp + two(cap + cam);
            let word =
                |sum: I46F18, drop| half_up(sum, drop).clamp(-(1 << 17), (1 << 17) - 1) as i32;
            to[0][i] = word(x, 4);
            to[1][i] = word(y, 3);
            to[2][i] = word(z, 4);
        }
    }
}

/// The emitted Verilog, built by Verilator with a timing harness.
struct Verilated {
    name: &'static str,
    program: PathBuf,
    folder: PathBuf,
    samples: usize,
    /// Vectors timed at once; with tracing all, from before the file is created to after it is
    /// closed.
    piece: usize,
}

impl Verilated {
    fn is_traced(&self) -> bool {
        self.piece == self.samples
    }

    /// Builds those whose names contain a text.
    fn build_all(design: &Design, stimulus: &Stimulus, folder: &Path, only: &str) -> Vec<Self> {
        let rows = [
            ("verilator, pipelined", SAMPLES, false),
            ("verilator, pipelined, VCD of all signals", wave::VECTORS, true),
        ];
        let rows: Vec<_> = rows.into_iter().filter(|(name, ..)| name.contains(only)).collect();
        if rows.is_empty() {
            return Vec::new();
        }
        if VERILATOR.version().is_none() {
            println!("verilator isn't installed: its rows are left out");
            return Vec::new();
        }
        let mut bytes = Vec::with_capacity(SAMPLES * 8);
        for i in 0..SAMPLES {
            for column in &stimulus.narrow {
                bytes.extend(column[i].to_le_bytes());
            }
        }
        fs::write(folder.join("stimulus"), bytes).expect("the stimulus can't be written");
        let settings = Settings { figures: false, ..Settings::default() };
        let package = Package::new(design, &settings).expect("the unit lowers");
        package.write_texts(folder, folder).expect("the module can't be written");
        let latency = package.rtl.schedule().latency();
        rows.into_iter()
            .map(|(name, samples, traced)| {
                let harness = harness(design, latency as usize, samples, traced);
                let (source, object) =
                    if traced { ("traced.cpp", "obj_traced") } else { ("plain.cpp", "obj_plain") };
                fs::write(folder.join(source), harness).expect("the harness can't be written");
                let mut command = Command::new("verilator");
                command.current_dir(folder).args([
                    "--cc",
                    "--exe",
                    "--build",
                    "-O3",
                    "--x-assign",
                    "fast",
                    "--x-initial",
                    "fast",
                    "--noassert",
                    "-CFLAGS",
                    "-O3 -march=native",
                    "-MAKEFLAGS",
                    "OPT_FAST= OPT_SLOW= OPT_GLOBAL=",
                    "--Mdir",
                    object,
                    "--top-module",
                    "rotation",
                ]);
                if traced {
                    command.arg("--trace");
                }
                let output = command.args(["rotation.v", source]).output().expect("verilator runs");
                let text = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "verilator failed: {text}");
                let program = folder.join(object).join("Vrotation");
                let piece = if traced { samples } else { PIECE };
                Self { name, program, folder: folder.to_owned(), samples, piece }
            })
            .collect()
    }

    fn run(&self) -> String {
        // Missing without tracing.
        let _ = fs::remove_file(self.folder.join("trace.vcd"));
        let output = Command::new(&self.program)
            .current_dir(&self.folder)
            .output()
            .expect("the harness runs");
        assert!(output.status.success(), "the harness of {} failed", self.name);
        String::from_utf8(output.stdout).expect("plain text")
    }

    fn round(&self, best: &mut [f64]) {
        let text = self.run();
        let times = text.lines().filter_map(|line| line.strip_prefix("seconds "));
        for (best, time) in best.iter_mut().zip(times) {
            *best = best.min(time.parse().expect("a number"));
        }
    }

    fn checksum(&self) -> u64 {
        let text = self.run();
        let line = text.lines().find_map(|line| line.strip_prefix("checksum "));
        u64::from_str_radix(line.expect("a checksum"), 16).expect("a number")
    }
}

/// C++ that runs the stimulus through the module, one vector per cycle, and times each piece.
fn harness(design: &Design, latency: usize, samples: usize, traced: bool) -> String {
    let netlist = &design.netlist;
    let ports: Vec<&str> = (0..netlist.inputs().len()).map(|i| netlist.input_name(i)).collect();
    let mut text = String::from(
        "#include \"Vrotation.h\"\n#include \"verilated.h\"\n#include <chrono>\n#include <cstdint>\n#include <cstdio>\n#include <vector>\n",
    );
    if traced {
        text += "#include \"verilated_vcd_c.h\"\n";
    }
    let outputs = netlist.outputs();
    let mut put = String::new();
    for (i, port) in ports.iter().enumerate() {
        let _ = write!(put, "dut.{port} = in[4 * at + {i}]; ");
    }
    let mut get = String::new();
    for (i, output) in outputs.iter().enumerate() {
        let format = netlist.node(output.node).format;
        let shift = 32 - format.bits();
        let word = if format.is_signed() {
            format!("int32_t(uint32_t(dut.{}) << {shift}) >> {shift}", output.name)
        } else {
            format!("int32_t(dut.{})", output.name)
        };
        let _ = write!(get, "out[{i}][n] = {word}; ");
    }
    let (open, dump, close) = if traced {
        (
            "context.traceEverOn(true); VerilatedVcdC vcd; dut.trace(&vcd, 99); vcd.open(\"trace.vcd\"); uint64_t time = 0;",
            "vcd.dump(time++);",
            "vcd.close();",
        )
    } else {
        ("", "", "")
    };
    let count = outputs.len();
    let start = "const auto start = std::chrono::steady_clock::now();";
    let stop = "const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start; printf(\"seconds %.9f\\n\", took.count());";
    // A wave is timed as a whole.
    let (piece, [all_start, all_stop, piece_start, piece_stop]) =
        if traced { (samples, [start, stop, "", ""]) } else { (PIECE, ["", "", start, stop]) };
    let _ = write!(
        text,
        "int main() {{\n\
         VerilatedContext context; Vrotation dut{{&context}};\n\
         const size_t samples = {samples}, piece = {piece}, latency = {latency};\n\
         std::vector<uint16_t> in(4 * samples);\n\
         FILE* file = fopen(\"stimulus\", \"rb\");\n\
         if (!file || fread(in.data(), 2, in.size(), file) != in.size()) return 1;\n\
         std::vector<int32_t> out[{count}]; for (auto& o : out) o.resize(samples);\n\
         {all_start}\n\
         {open}\n\
         dut.rst = 0; dut.ce = 1; dut.valid_in = 1; dut.clk = 0; dut.eval();\n\
         for (size_t first = 0; first < samples; first += piece) {{\n\
           {piece_start}\n\
           const size_t end = first + piece + (first + piece == samples ? latency : 0);\n\
           for (size_t cycle = first; cycle < end; ++cycle) {{\n\
             const size_t at = cycle < samples ? cycle : samples - 1;\n\
             {put}\n\
             dut.clk = 0; dut.eval(); {dump}\n\
             if (cycle >= latency) {{ const size_t n = cycle - latency; {get} }}\n\
             dut.clk = 1; dut.eval(); {dump}\n\
           }}\n\
           {piece_stop}\n\
         }}\n\
         {close}\n\
         {all_stop}\n\
         dut.final();\n\
         uint64_t sum = 0;\n\
         for (size_t n = 0; n < samples; ++n)\n\
           for (auto& o : out) sum = (sum ^ uint64_t(uint32_t(o[n]))) * UINT64_C(0x100000001b3);\n\
         printf(\"checksum %016llx\\n\", (unsigned long long)sum);\n\
         return 0;\n}}\n"
    );
    text
}
