//! Memories, ports of several rates, and delays: features that reach beyond the words of one
//! sample.

use crate::common::{refused, run, written};
use crate::engines::{Random, random_machine};
use crate::hdl::{emit_options, lints, passes, place};
use crate::hdl_vhdl;
use fixpath::cycle::Cycle;
use fixpath::format::{Format, Overflow, Round};
use fixpath::hdl::{Memories, Options, Tables};
use fixpath::measure::{Inputs, measure};
use fixpath::netlist::{Builder, Memory, Netlist, NodeId, Quantity, Rate, State, Wires};
use fixpath::op::Op;
use fixpath::rtl::{Rtl, Signal};
use fixpath::schedule::{Depth, Kind, Plan, Rom, Schedule, Share};
use fixpath::sim::batch::Program;
use fixpath::units::{Golden, Sampler, Unit};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::sync::Arc;

fn format(text: &str) -> Format {
    text.parse().unwrap()
}

fn read(text: &str) -> Result<Netlist, String> {
    Netlist::parse(text, std::path::Path::new("n.netlist")).map_err(|error| error.to_string())
}

/// Hardware of a netlist, flat or shared depending on the seed.
fn some_rtl(netlist: &Arc<Netlist>, seed: u64) -> Option<Rtl> {
    let mut random = Random::new(seed ^ 0x717);
    let rom = random.pick(&[Rom::Block, Rom::Distributed]);
    let schedule = if random.chance(35) {
        let period = random.pick(&[100, 1500, 3000, 20_000]);
        Schedule::pipeline(netlist, rom, Depth::Period(period)).unwrap()
    } else {
        let share = |kind| Share { kind, units: 1, latency: None, loads: seed.is_multiple_of(3) };
        let kinds = [Kind::Multiplier, Kind::Adder, Kind::Table];
        let shares = kinds.into_iter().filter(|_| random.chance(60)).map(share).collect();
        let plan = Plan { shares, interval: None };
        Schedule::shared(netlist, rom, 4000, &plan).ok()?
    };
    Some(Rtl::new(Arc::clone(netlist), schedule))
}

/// Feeds the cycle simulator as its schedule says, each rate at its own times. Each valid result
/// must be the reference's. A sample uses the latest slower sample that was present when it
/// entered, and whatever that one uses.
fn check_cycles(netlist: &Netlist, rtl: Rtl, seed: u64) -> usize {
    const SLOTS: u64 = 80;
    let schedule = rtl.schedule().clone();
    let (interval, latency) = (u64::from(schedule.interval()), u64::from(schedule.latency()));
    let mut cycle = Cycle::new(Arc::new(rtl));
    let timings = schedule.timings();
    let rate_of: Vec<usize> = netlist
        .inputs()
        .iter()
        .map(|id| timings.iter().position(|t| t.rate == netlist.node(*id).rate).unwrap())
        .collect();
    let mut random = Random::new(seed);
    // By slot, one for each sample of the fastest rate: the words, and which rates have valid data.
    let mut slots: Vec<(Vec<i64>, Vec<bool>)> = Vec::new();
    // By rate: its last sample, with the words of slower rates that it uses.
    let mut samples: Vec<Vec<i64>> = vec![vec![0; rate_of.len()]; timings.len()];
    let mut state = State::new(netlist);
    let mut expected: VecDeque<Option<Vec<i64>>> = VecDeque::new();
    for slot in 0..SLOTS {
        let words: Vec<i64> =
            netlist.inputs().iter().map(|id| random.word(netlist.node(*id).format)).collect();
        let mut data = Vec::new();
        for (rate, timing) in timings.iter().enumerate() {
            let faster = timings.len() - 1 - rate;
            let may = (slot * interval).is_multiple_of(timing.interval.into());
            data.push(may && (slot == 0 || random.chance(75 >> faster)));
            if data[rate] {
                let slower = rate.checked_sub(1).map(|slower| samples[slower].clone());
                let goes_with = slower.unwrap_or_else(|| words.clone());
                let own = |port: usize| rate_of[port] == rate;
                samples[rate] = (0..words.len())
                    .map(|port| if own(port) { words[port] } else { goes_with[port] })
                    .collect();
            }
        }
        expected.push_back(data[timings.len() - 1].then(|| {
            let (words, _) = netlist.eval_next(&mut state, &samples[timings.len() - 1]).unwrap();
            netlist.outputs().iter().map(|output| words[output.node.index()]).collect()
        }));
        slots.push((words, data));
    }
    let mut seen = 0;
    for at in 0..SLOTS * interval + latency {
        let slot = |rate: usize| {
            let since = at.checked_sub(timings[rate].entry.into())?;
            slots.get((since / interval) as usize).filter(|_| since.is_multiple_of(interval))
        };
        let words: Vec<i64> = netlist
            .inputs()
            .iter()
            .enumerate()
            .map(|(port, id)| match slot(rate_of[port]) {
                Some((words, data)) if data[rate_of[port]] => words[port],
                // Words that aren't valid data are random.
                Some(_) | None => random.word(netlist.node(*id).format),
            })
            .collect();
        // A rate that isn't ready takes no data.
        let ready: Vec<bool> = (0..timings.len()).map(|rate| cycle.ready_of(rate)).collect();
        let valid =
            |rate: usize| slot(rate).map_or(!ready[rate], |(_, data)| data[rate] || !ready[rate]);
        cycle.settle_rates(&words, valid).unwrap();
        let should = match at.checked_sub(latency) {
            Some(since) if since % interval == 0 => expected.pop_front().flatten(),
            Some(_) | None => None,
        };
        assert_eq!(cycle.outputs(), should, "seed {seed}, cycle {at}\n{}", netlist.to_text());
        seen += usize::from(should.is_some());
        cycle.clock();
    }
    seen
}

/// Products and sums of several rates, with more of the slow ones than in random netlists.
fn layered(seed: u64) -> Netlist {
    let mut random = Random::new(seed);
    let mut b = Builder::new("layered");
    let map = b.memory("map", 3, &[("c", format("s5f2"))], 1 + (seed % 4) as u32);
    let mut rates: Vec<Rate> = (0..2 + random.below(2)).map(|_| random.pick(Rate::ALL)).collect();
    rates.sort_unstable();
    let mut nodes: Vec<NodeId> = Vec::new();
    for (place, rate) in rates.iter().enumerate() {
        let start = nodes.len();
        for port in 0..1 + random.below(2) {
            let id = b.input(&format!("in{place}_{port}"), format("s5f2"), Quantity::Number);
            nodes.push(b.rate(id, *rate));
        }
        for _ in 0..2 + random.below(6) {
            // One operand of this rate, and one of any rate so far.
            let own = nodes[start + random.below(nodes.len() - start)];
            let any = random.pick(&nodes);
            let made = match random.below(6) {
                0..=2 => b.mul(own, any),
                3 => b.sub(any, own),
                4 if place + 1 == rates.len() => b.delay(own, 1 + random.below(3) as u32),
                _ => {
                    let address = b.slice(own, random.below(2) as u32, 3);
                    b.read(map, 0, address)
                }
            };
            nodes.push(b.narrow(made, format("s5f2"), Round::HalfEven, Overflow::Wrap));
        }
    }
    for (number, node) in nodes.iter().rev().step_by(3).enumerate() {
        b.output(&format!("out{number}"), *node);
    }
    let netlist = b.build().unwrap();
    if netlist.memories().next().is_none() {
        return netlist;
    }
    netlist.bind("map", &[(0..8).map(|_| random.word(format("s5f2"))).collect()]).unwrap()
}

/// A machine of some kind.
fn machine(seed: u64) -> Arc<Netlist> {
    Arc::new(if seed.is_multiple_of(3) { layered(seed) } else { random_machine(seed) })
}

#[test]
fn cycles_give_the_words_of_the_reference() {
    let (mut seen, mut shared, mut mixed, mut slow, mut units) = (0, 0, 0, 0, 0);
    for seed in 0..1500 {
        let netlist = machine(seed);
        let Some(rtl) = some_rtl(&netlist, seed) else { continue };
        shared += usize::from(rtl.schedule().interval() > 1);
        mixed += usize::from(rtl.schedule().interval() > 1 && netlist.rates().len() > 1);
        slow += usize::from(rtl.schedule().phases() > rtl.schedule().interval());
        units += rtl.units().len();
        seen += check_cycles(&netlist, rtl, seed);
    }
    assert!(
        seen > 50_000 && shared > 60 && mixed > 20 && slow > 50 && units > 300,
        "{seen} {shared} {mixed} {slow} {units}"
    );
}

/// After a reset, delays restart and slow words have to be sent again.
#[test]
fn a_reset_forgets_samples() {
    let w = Wires::new("steps");
    let x = w.input("x", format("s8f7"));
    w.output("y", &(&x - x.delay(2)));
    let netlist = Arc::new(w.build().unwrap());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Stages(3)).unwrap();
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(&netlist), schedule)));
    let results = |cycle: &mut Cycle, words: &[i64]| {
        let mut given = Vec::new();
        for at in 0..words.len() + 3 {
            let word = words.get(at);
            cycle.settle(&[word.copied().unwrap_or(5)], word.is_some()).unwrap();
            given.extend(cycle.outputs().map(|outputs| outputs[0]));
            cycle.clock();
        }
        given
    };
    assert_eq!(results(&mut cycle, &[1, 2, 4, 8]), [1, 2, 3, 6]);
    assert_eq!(results(&mut cycle, &[16]), [12], "words stay until new ones come");
    cycle.reset();
    assert_eq!(results(&mut cycle, &[16, 3]), [16, 3]);
    let mut state = State::new(&netlist);
    let eval = |state: &mut State, word| {
        let words = netlist.eval_next(state, &[word]).unwrap().0;
        words[netlist.outputs()[0].node.index()]
    };
    assert_eq!([1, 2, 4, 8].map(|word| eval(&mut state, word)), [1, 2, 3, 6]);
    assert_eq!(eval(&mut State::new(&netlist), 16), 16);
}

fn options(seed: u64) -> Options {
    let memories = if seed.is_multiple_of(2) { Memories::Ports } else { Memories::Ram };
    Options { tables: place(seed / 2), memories, ..Options::default() }
}

/// Seeds with hardware, for machines that are flat or shared.
fn some_hardware(seeds: std::ops::Range<u64>) -> Vec<(u64, Arc<Rtl>)> {
    let rtl = |seed| Some((seed, Arc::new(some_rtl(&machine(seed), seed)?)));
    seeds.filter_map(rtl).collect()
}

#[test]
#[ignore = "needs iverilog, verilator and yosys: testbenches/run installs them"]
fn machines_in_icarus_and_without_a_warning() {
    some_hardware(0..60).into_par_iter().for_each(|(seed, rtl)| {
        let folder = tempfile::tempdir().unwrap();
        let module = emit_options(&rtl, options(seed), Vec::new(), 300, folder.path());
        let what = format!("machine, seed {seed}");
        let folder = passes(folder, &format!("{}_icarus.mk", module.name), 300, &what);
        lints(folder, &module, &["-Wno-UNSIGNED", "-Wno-CMPCONST"], &what);
    });
}

#[test]
#[ignore = "needs ghdl: testbenches/run installs it"]
fn machines_in_ghdl() {
    for (seed, rtl) in some_hardware(0..40) {
        let folder = tempfile::tempdir().unwrap();
        let module = emit_options(&rtl, options(seed), Vec::new(), 300, folder.path());
        hdl_vhdl::check(folder, &module.name, 300, &format!("machine, seed {seed}"));
    }
}

#[test]
#[ignore = "needs verilator: testbenches/run installs it"]
fn machines_in_verilator() {
    // Verilator warns about comparisons of constants, which it folds.
    let folds = |rtl: &Rtl| rtl.netlist().nodes().iter().any(|n| matches!(n.op, Op::Const { .. }));
    let all = some_hardware(0..200).into_iter().filter(|(_, rtl)| !folds(rtl));
    let several = all.filter(|(_, rtl)| rtl.netlist().memories().next().is_some());
    several.take(4).collect::<Vec<_>>().into_par_iter().for_each(|(seed, rtl)| {
        let folder = tempfile::tempdir().unwrap();
        let module = emit_options(&rtl, options(seed), Vec::new(), 3000, folder.path());
        passes(folder, &format!("{}_verilator.mk", module.name), 3000, &format!("seed {seed}"));
    });
}

/// gain * scale + height: one gain per object, one scale per face, and a word of a map per pixel.
fn mixed() -> Netlist {
    let mut b = Builder::new("mixed");
    let input = |b: &mut Builder, name, rate| {
        let id = b.input(name, format("s8f6"), Quantity::Number);
        b.rate(id, rate)
    };
    let gain = input(&mut b, "gain", Rate::Object);
    let scale = input(&mut b, "scale", Rate::Face);
    let u = b.input("u", format("u4f0"), Quantity::Number);
    let map = b.memory("map", 4, &[("height", format("s8f7"))], 3);
    let both = b.mul(gain, scale);
    b.name(both, "both");
    let height = b.read(map, 0, u);
    b.name(height, "height");
    let sum = b.add(both, height);
    let y = b.narrow(sum, format("s12f8"), Round::HalfEven, Overflow::Saturate);
    b.output("y", y);
    b.build().unwrap()
}

#[test]
fn slow_rates_come_first_and_are_held() {
    let netlist = mixed();
    assert_eq!(netlist.rates(), [Rate::Object, Rate::Face, Rate::Pixel]);
    let node = |name: &str| {
        netlist.ids().find(|id| netlist.node(*id).name.as_deref() == Some(name)).unwrap()
    };
    assert_eq!(netlist.node(node("both")).rate, Rate::Face);
    assert_eq!(netlist.node(netlist.outputs()[0].node).rate, Rate::Pixel);
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Period(2000)).unwrap();
    // Of 2000 ps, 1500 ps are for logic. gain is held after one cycle, the product of 2300 ps takes
    // one cycle of its own, and the memory takes three cycles, plus one for its address.
    let timings: Vec<[u32; 3]> =
        schedule.timings().iter().map(|t| [t.entry, t.latency, t.interval]).collect();
    assert_eq!(timings[..2], [[0, 1, 1], [1, 1, 1]]);
    assert_eq!(timings[2], [2, schedule.latency() - 2, 1]);
    assert_eq!(schedule.stage(node("both")), 1);
    assert_eq!(schedule.stage(node("height")), 2 + 3);
    let rtl = Rtl::new(Arc::new(netlist.clone()), schedule);
    let register = |name: &str, stage| Signal { node: node(name), stage };
    assert_eq!(rtl.holds(register("gain", 1)), Some(Rate::Object));
    assert_eq!(rtl.holds(register("both", 2)), Some(Rate::Face));
    assert_eq!(rtl.holds(register("both", 3)), None, "from there it goes along with the pixel");
    // One valid bit for the object's words, one for the face's, and those of the pixels.
    assert_eq!(rtl.valid_bits(), rtl.schedule().latency() - 2);
    let error = Schedule::pipeline(&netlist, Rom::Distributed, Depth::Stages(0)).unwrap_err();
    assert!(error.to_string().contains("the words of a memory arrive on a clock edge"), "{error}");
    let by_hand = Schedule::from_stages(&netlist, Rom::Block, vec![0; 8], 9).unwrap_err();
    assert!(by_hand.to_string().contains("ports of a single rate"), "{by_hand}");
}

/// A product of slow words is computed once for any number of pixels. In between, the multiplier's
/// ports may carry anything.
#[test]
fn held_words_stay_while_slow_ports_carry_anything() {
    let netlist = Arc::new(mixed().bind("map", &[Arc::from(vec![0; 16])]).unwrap());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Period(5000)).unwrap();
    let face = schedule.entry(Rate::Face);
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(&netlist), schedule)));
    let mut given = Vec::new();
    for at in 0..40 {
        let (object, face) = (at == 0, at == face);
        let words = [if object { 64 } else { 3 }, if face { 32 } else { -7 }, 1];
        cycle.settle_rates(&words, |rate| [object, face, at > 10][rate]).unwrap();
        given.extend(cycle.outputs());
        cycle.clock();
    }
    assert!(given.len() > 20 && given.iter().all(|words| words == &[128]), "{given:?}");
}

#[test]
fn words_are_bound_once_and_checked() {
    let netlist = mixed();
    let words: Arc<[i64]> = (0..16).map(|i| i * 7 - 50).collect();
    let bound = netlist.bind("map", &[Arc::clone(&words)]).unwrap();
    assert!(bound == netlist, "bound words are not part of the datapath");
    assert!(bound.unbound() == netlist && bound.unbound().eval(&[0, 0, 0]).is_err());
    let y = bound.outputs()[0].node;
    for u in 0..16 {
        let (is, _) = bound.eval(&[64, 32, u]).unwrap();
        assert_eq!(is[y.index()], 128 + 2 * words[u as usize]);
        assert_eq!(
            bound.eval_reals(&[1.0, 0.5, u as f64 + 0.9])[y.index()],
            0.5 + words[u as usize] as f64 / 128.0
        );
    }
    assert!(bound.node(y).real.is_some() && netlist.node(y).real.is_none());
    let wrong = |name: &str, columns: &[Arc<[i64]>], part: &str| {
        let error = netlist.bind(name, columns).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    };
    wrong("mp", &[Arc::clone(&words)], "netlist `mixed` has no memory `mp`: there is map");
    wrong("maps", &[Arc::clone(&words)], "did you mean `map`");
    wrong("map", &[], "memory `map`: 0 columns are given: it takes one for each of height");
    wrong(
        "map",
        &[Arc::from([1, 2])],
        "column `height` has 2 words and must have one for each of 16 addresses",
    );
    wrong("map", &[Arc::from([200; 16])], "word 200 at address 0, outside s8f7");
    // Simulation without words reports which memories lack them.
    let missing = "no words are bound to memory `map`";
    assert!(netlist.eval(&[0; 3]).unwrap_err().to_string().contains(missing));
    let program = Program::compile(&netlist, &[y]);
    let columns: [&[i64]; 3] = [&[0], &[0], &[0]];
    let ran = program.runner().run(&program, &columns, &mut [Vec::new()]);
    assert!(ran.unwrap_err().to_string().contains(missing));
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Period(5000)).unwrap();
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::new(netlist), schedule)));
    assert!(cycle.settle(&[0; 3], true).unwrap_err().to_string().contains(missing));
}

#[test]
fn what_a_builder_refuses() {
    type Make = fn(&mut Builder, NodeId) -> NodeId;
    let cases: &[(Make, &str)] = &[
        (|b, x| b.delay(x, 4097), "`delay of x (s8f7)`: 4097 samples: legal is 1 to 4096"),
        (
            |b, x| {
                let y = b.neg(x);
                b.rate(y, Rate::Face)
            },
            "only ports can be given a rate",
        ),
        (
            |b, x| {
                let m = b.memory("m", 3, &[("c", format("s4f0"))], 0);
                b.read(m, 0, x)
            },
            "table `m`: a latency of 0 cycles: legal is 1 to 64",
        ),
        (
            |b, x| {
                let m = b.memory("m", 3, &[("c", format("s4f0"))], Memory::MAX_LATENCY + 1);
                b.read(m, 0, x)
            },
            "legal is 1 to 64",
        ),
        (
            |b, x| {
                let m = b.memory("m", 3, &[], 1);
                b.read(m, 0, x)
            },
            "it has no column",
        ),
        (
            |b, x| {
                let m = b.memory("m", 3, &[("c", format("s4f0")), ("c", format("s4f0"))], 1);
                b.read(m, 0, x)
            },
            "two columns are called `c`",
        ),
        (
            |b, x| {
                let m = b.memory("m", 3, &[("c", format("s4f0"))], 1);
                b.memory("m", 4, &[("c", format("s4f0"))], 1);
                b.read(m, 0, x)
            },
            "memory `m`: another memory has this name",
        ),
        (
            |b, x| {
                let m = b.memory("m", 31, &[("c", format("s4f0"))], 1);
                b.read(m, 0, x)
            },
            "31 address bits: legal is 1 to 30",
        ),
    ];
    for (make, part) in cases {
        let mut b = Builder::new("wrong");
        let x = b.input("x", format("s8f7"), Quantity::Number);
        let y = make(&mut b, x);
        b.output("y", y);
        let error = b.build().unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn malformed_files_name_the_place() {
    let good = mixed().to_file();
    assert!(good.contains("memory map 4 latency 3 height:s8f7\n"), "{good}");
    assert!(good.contains("%1 = input : s8f6 per face @scale\n"), "{good}");
    let cases = [
        ("latency 3", "latency three", "line 3, column 22: `three` is not a number of cycles"),
        ("latency 3 ", "", "expected `latency` before `height:s8f7`"),
        ("latency 3", "latency 65", "a latency of 65 cycles: legal is 1 to 64"),
        (" height:s8f7", "", "a table needs a column: write NAME:FORMAT"),
        ("height:s8f7", "height", "`height` is not a column"),
        (
            "per face",
            "per triangle",
            "`triangle` is not a rate: legal are scene, object, face, vertex, pixel",
        ),
        ("per face", "per face per object", "a port has only one rate"),
        ("per face", "per", "`@scale` is not a rate"),
        (": s12f8", ": s12f8 per face", "only ports have a rate"),
        ("memory map", "memory map!", "`map!` is not a name"),
    ];
    for (was, is, part) in cases {
        assert!(good.contains(was), "{was} in {good}");
        let error = read(&good.replacen(was, is, 1)).expect_err(part);
        assert!(error.contains(part), "{is}: {error}");
    }
    let delay =
        "fixpath netlist 1\nname d\n%0 = input : s8f7 @x\n%1 = delay 2 %0 : s8f7\noutput y = %1\n";
    assert_eq!(read(delay).unwrap().to_file(), delay);
    for (is, part) in [
        ("delay %0", "`%0` is not a number of samples"),
        ("delay 0 %0", "0 samples: legal is 1 to 4096"),
        ("delay 5000 %0", "5000 samples"),
        ("delay 2", "takes 1 operands, and 0 are given"),
    ] {
        let error = read(&delay.replace("delay 2 %0", is)).expect_err(part);
        assert!(error.contains(part), "{is}: {error}");
    }
}

/// A unit that provides words for its memory, and accepts others.
fn blend() -> Unit {
    Unit::new("blend", "half of a word of a map, and half of x").design(|p| {
        let mut b = p.builder("blend");
        let x = b.input("x", format("s8f7"), Quantity::Number);
        let u = b.input("u", format("u3f0"), Quantity::Number);
        let map = b.memory("map", 3, &[("value", format("s8f7"))], 1);
        let value = b.read(map, 0, u);
        let sum = b.add(x, value);
        let half = b.shift(sum, -1);
        let y = b.narrow(half, format("s8f7"), Round::HalfEven, Overflow::Saturate);
        b.output("y", y);
        let words: Arc<[i64]> = (0..8).map(|i| 16 * i - 60).collect();
        let design = fixpath::units::Design::new(p, b.build()?).memory("map", &[words]);
        let table = design.netlist.memories().next().unwrap().clone();
        Ok(design.golden(move |_| {
            Golden::each(move |[x, u]: [f64; 2]| {
                [(x + table.columns[0].words[u as usize] as f64 / 128.0) / 2.0]
            })
        }))
    })
}

#[test]
fn a_unit_brings_words_and_takes_others() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..8).map(|i| format!("{i},{}\n", 100 - i)).collect();
    let file = written(folder.path(), "map.csv", &format!("other,value\n{rows}"));
    let set = format!("memory.map={}", file.display());
    let inputs = Inputs { sampler: Sampler::Exhaustive, samples: 1, seed: 1 };
    for assignments in [vec![], vec![set]] {
        let design = blend().values(&assignments).unwrap().build().unwrap();
        let words = &design.netlist.memories().next().unwrap().columns[0].words;
        assert_eq!(words[1], if assignments.is_empty() { -44 } else { 99 });
        let report = measure(&[&design], &inputs, &|_| ()).unwrap().remove(0);
        for figures in &report.figures {
            // Half a unit in the last place, where an odd sum is halved.
            assert!(figures.max <= 0.5 / 128.0, "{} {}", figures.quantity, figures.max);
        }
        assert!(report.figures.iter().any(|figures| figures.max == 0.5 / 128.0));
    }
}

const FETCH: &str = "fixpath netlist 1
name fetch
memory map 2 latency 2 height:s8f7 slope:s6f4
%0 = input : u2f0 @u
%1 = input : s8f6 per face @scale
%2 = read map.height %0 : s8f7
%3 = read map.slope %0 : s6f4
%4 = mul %2 %1 : s16f13
%5 = add %4 %3 : s17f13
output y = %5
";

#[test]
fn memories_and_rates_on_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let of = |name: &str, text: &str| written(folder.path(), name, text).display().to_string();
    let unit = of("fetch.netlist", FETCH);
    let map = format!(
        "memory.map={}",
        of("map.csv", "slope,note,height\n1,a,10\n-2,b,20\n3,,-30\n-4,,127\n")
    );
    refused(
        &["sim", &unit],
        "no words are bound to memory `map`: bind them with -p memory.map=FILE.csv",
    );
    refused(&["wave", &unit, "--out", &of("a.vcd", "")], "no words are bound to memory `map`");
    let bad = |text: &str, part: &str| {
        let set = format!("memory.map={}", of("bad.csv", text));
        refused(&["sim", &unit, "-p", &set], part);
    };
    bad("", "bad.csv: the file is empty: it needs a line of headings");
    bad("height,height\n1,1\n", "line 1: two columns are called `height`");
    bad("height\n1\n2\n3\n4\n", "its file has no column `slope`: it has height");
    bad(
        "height,slope\n1,1\n2,2\n",
        "column `height` has 2 words and must have one for each of 4 addresses",
    );
    bad("height,slope\n1,1\n2,x\n3,y\n4,4\n", "bad.csv, line 3, column `slope`: `x` is not a word");
    bad("height,slope\n1,1\n2\n3,3\n4,4\n", "line 3");
    bad("height,slope\n1,1\n2,2\n300,3\n4,4\n", "word 300 at address 2, outside s8f7");
    refused(&["sim", &unit, "-p", "memory.map=nothing.csv"], "nothing.csv: can't read");
    refused(&["sim", &unit, "-p", "memory.map="], "legal is the path of a CSV file");
    refused(
        &["sim", "rotation", "-p", &map],
        "netlist `rotation` has no memory `map`: there is none",
    );
    let (code, told, _) = run(&["sim", &unit, "-p", &map, "--sampler", "exhaustive"]);
    assert_eq!(code, 0, "{told}");
    let (_, shown, _) = run(&["show", &unit, "-p", &map]);
    for part in [
        "memories (-p memory.NAME",
        "map        4",
        "scale s8f6   number   face",
        "face  scale     0",
    ] {
        assert!(shown.contains(part), "{part} in\n{shown}");
    }
    let (_, json, _) = run(&["schedule", &unit, "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["rates"][0]["rate"], "face");
    let out = folder.path().join("hdl").display().to_string();
    let (code, _, note) = run(&["hdl", &unit, "--out", &out, "--vectors", "10"]);
    assert!(code == 0 && note.contains("the vectors use random ones"), "{note}");
    let wave = folder.path().join("f.vcd").display().to_string();
    let (code, told, _) = run(&["wave", &unit, "-p", &map, "--out", &wave, "--samples", "20"]);
    assert_eq!(code, 0, "{told}");
    let vcd = std::fs::read_to_string(&wave).unwrap();
    assert!(vcd.contains("valid_face"));
    // Samples that depend on words of earlier samples aren't judged separately.
    let delay = FETCH.replace("per face ", "").replace(
        "%5 = add %4 %3 : s17f13\noutput y = %5",
        "%5 = delay 3 %4 : s16f13\noutput y = %5",
    );
    let delay = of("delay.netlist", &delay);
    refused(&["sim", &delay, "-p", &map], "errors can't be measured on independent samples");
}

/// A module's ports may have the names of its test bench's objects; tables and memories have files
/// of their own.
#[test]
#[ignore = "needs iverilog, ghdl and verilator: testbenches/run installs them"]
fn names_that_meet_those_of_the_bench() {
    let text = "fixpath netlist 1
name foo
table map 1 c:s6f0
  5
  -3
memory map_m named map 1 latency 1 addr:s6f0 we:u1f0 waddr:u3f0
%0 = input : u1f0 @foo_bench
%1 = input : s6f0 per face @dut
%2 = input : s6f0 per face @valid_face
%3 = read map.c %0 : s6f0
%4 = read map_m.addr %0 : s6f0
%5 = read map_m.waddr %0 : u3f0
%6 = add %1 %2 : s7f0
%7 = add %3 %4 : s7f0
%8 = add %6 %7 : s8f0
%9 = xor %5 %5 : u3f0
%10 = slice[0:0] %2 : u1f0
%11 = read map_m.addr %10 : s6f0
output ready = %8
output map_addr = %9
output map_we = %11
";
    let netlist = read(text).unwrap();
    let words: [Arc<[i64]>; 3] = [Arc::from([7, -8]), Arc::from([0, 1]), Arc::from([3, 6])];
    let netlist = Arc::new(netlist.bind("map", &words).unwrap());
    for (tables, memories) in
        [(Some(Tables::Files), Memories::Ports), (Some(Tables::Inline), Memories::Ram)]
    {
        let depth = Depth::Period(3000);
        let schedule = Schedule::pipeline(&netlist, Rom::Block, depth).unwrap();
        let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
        for make in ["icarus", "ghdl", "verilator"] {
            let folder = tempfile::tempdir().unwrap();
            let options = Options { tables, memories, ..Options::default() };
            emit_options(&rtl, options, Vec::new(), 200, folder.path());
            passes(folder, &format!("foo_{make}.mk"), 200, make);
        }
    }
}

/// A word that is used late is kept until then, whatever shares its unit.
#[test]
fn words_that_are_late_wait_for_their_unit() {
    let w = Wires::new("late");
    let [a, b, c] = ["a", "b", "c"].map(|name| w.input(name, format("s6f0")));
    let product = &a * &b;
    w.output("y", &(&c * &product));
    w.output("z", &(&b * &c));
    let netlist = Arc::new(w.build().unwrap());
    for (units, latency, loads) in
        [(1, None, false), (1, Some(2), true), (2, Some(0), false), (2, Some(1), true)]
    {
        let shares = vec![Share { kind: Kind::Multiplier, units, latency, loads }];
        let plan = Plan { shares, interval: Some(3) };
        let schedule = Schedule::shared(&netlist, Rom::Block, 4000, &plan).unwrap();
        let units = schedule.units().iter().flat_map(|unit| &unit.operations);
        let issues: Vec<u32> = units.map(|operation| operation.issue).collect();
        assert_eq!(issues.len(), 3);
        check_cycles(&netlist, Rtl::new(Arc::clone(&netlist), schedule), 1);
    }
}

/// A product per object shares a multiplier over more cycles than a pixel's product.
#[test]
fn slow_rates_share_units_over_a_longer_time() {
    let w = Wires::new("slow");
    let slow = |name: &str| w.input(name, format("s8f7")).per(Rate::Face);
    let [a, b, c] = ["a", "b", "c"].map(slow);
    let x = w.input("x", format("s8f7"));
    w.output("y", &(&(&a * &b + &b * &c + &c * &a) + &x));
    let netlist = Arc::new(w.build().unwrap());
    let shares = vec![Share { kind: Kind::Multiplier, units: 1, latency: None, loads: false }];
    let plan = Plan { shares, interval: None };
    let schedule = Schedule::shared(&netlist, Rom::Block, 5000, &plan).unwrap();
    let intervals: Vec<u32> = schedule.timings().iter().map(|timing| timing.interval).collect();
    assert_eq!(intervals, [3, 1]);
    assert_eq!((schedule.interval(), schedule.phases(), schedule.units().len()), (1, 3, 1));
    let rtl = Rtl::new(Arc::clone(&netlist), schedule.clone());
    assert_eq!(rtl.counts().operators.datapath.multipliers, 1);
    assert!(check_cycles(&netlist, rtl, 7) > 40);
    // If an interval is requested for all, a face may take no longer.
    let plan = Plan { interval: Some(2), ..plan };
    let schedule = Schedule::shared(&netlist, Rom::Block, 5000, &plan).unwrap();
    let intervals: Vec<u32> = schedule.timings().iter().map(|timing| timing.interval).collect();
    assert_eq!(intervals, [4, 2], "a multiple of the faster interval");
    check_cycles(&netlist, Rtl::new(Arc::clone(&netlist), schedule), 8);
}
