//! Time-shared schedules: every schedule gives the reference's words, in the stated cycle.

use crate::engines::{Random, random_netlist_within};
use crate::wave::ReadBack;
use fixpath::cycle::Cycle;
use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Netlist, NodeId, Part, Quantity};
use fixpath::rtl::Rtl;
use fixpath::schedule::{Binding, Depth, Kind, Operand, Plan, Rom, Schedule, Share};
use fixpath::timetable::Timetable;
use fixpath::units::{Design, Unit};
use fixpath::wave::{Options, Wave};
use std::collections::VecDeque;
use std::sync::Arc;

pub(crate) type Vector = [NodeId; 3];

/// The emboss unit with the light vector as the patent prints it.
fn emboss(assignments: &[&str]) -> Design {
    let assignments = [&["l_sign=vertex-light"], assignments].concat();
    fixpath::units::emboss::unit().values(&assignments).unwrap().build().unwrap()
}

/// The datapath of US 6,980,218, figure 8.
pub(crate) fn emboss_netlist() -> Arc<Netlist> {
    emboss(&[]).netlist
}

/// Its printed schedule.
pub(crate) fn figure_8() -> Binding {
    emboss(&[]).binding.unwrap()
}

/// A dot product of three as one part.
fn dot(b: &mut Builder, name: &str, m: Vector, v: Vector) -> NodeId {
    b.part(Part::Dot, name, |b| {
        let products = [b.mul(m[0], v[0]), b.mul(m[1], v[1]), b.mul(m[2], v[2])];
        let sum = b.add(products[0], products[1]);
        b.add(sum, products[2])
    })
}

/// Words for input ports, sometimes the ends of the format.
pub(crate) fn stimulus(netlist: &Netlist, random: &mut Random) -> Vec<i64> {
    let word = |id: &NodeId| random.word(netlist.node(*id).format);
    netlist.inputs().iter().map(word).collect()
}

/// Feeds a sample each interval, with occasional gaps and with other words outside phase 0.
/// Compares each valid result, and its cycle, with the reference.
pub(crate) fn check(netlist: &Arc<Netlist>, schedule: &Schedule, seed: u64) -> Result<(), String> {
    let mut random = Random::new(seed);
    let (latency, interval) = (schedule.latency(), schedule.interval());
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(netlist), schedule.clone())));
    let mut expected: VecDeque<(u64, Vec<i64>)> = VecDeque::new();
    let samples = 12;
    for at in 0..u64::from(latency) + samples * u64::from(interval) {
        let words = stimulus(netlist, &mut random);
        let offered = at < samples * u64::from(interval) && random.chance(80);
        let ready = at % u64::from(interval) == 0;
        cycle.settle(&words, offered).unwrap();
        if cycle.ready() != ready {
            return Err(format!("cycle {at}: ready is {}", cycle.ready()));
        }
        if offered && ready {
            let (reference, _) = netlist.eval(&words).unwrap();
            let outputs = netlist.outputs().iter().map(|o| reference[o.node.index()]).collect();
            expected.push_back((at + u64::from(latency), outputs));
        }
        let should = expected.front().filter(|(when, _)| *when == at).map(|(_, words)| words);
        let got = cycle.outputs();
        if got.as_ref() != should {
            return Err(format!("cycle {at}: {got:?}, and should be {should:?}"));
        }
        if got.is_some() {
            expected.pop_front();
        }
        cycle.clock();
    }
    if expected.is_empty() {
        Ok(())
    } else {
        Err(format!("{} results are missing", expected.len()))
    }
}

pub(crate) fn share(kind: Kind, units: u32) -> Share {
    Share { kind, units, latency: None, loads: false }
}

#[test]
fn the_binding_of_figure_8_gives_the_reference() {
    let netlist = emboss_netlist();
    let schedule = Schedule::bound(&netlist, Rom::Block, 6000, &figure_8()).unwrap();
    assert_eq!(schedule.interval(), 8);
    for seed in 0..20 {
        check(&netlist, &schedule, seed).unwrap();
    }
}

#[test]
fn found_schedules_give_the_reference() {
    let netlist = emboss_netlist();
    for dots in 1..=9 {
        for (mul, add, loads) in [(1, 1, false), (2, 5, true), (1, 2, true)] {
            let mut shares =
                vec![share(Kind::Dot, dots), share(Kind::Multiplier, mul), share(Kind::Adder, add)];
            shares.push(share(Kind::Root, 1));
            shares.iter_mut().for_each(|share| share.loads = loads);
            let plan = Plan { shares, interval: None };
            let schedule = Schedule::shared(&netlist, Rom::Block, 5000, &plan).unwrap();
            let shortest = 9u32.div_ceil(dots).max(2u32.div_ceil(mul)).max(5u32.div_ceil(add));
            assert_eq!(schedule.interval(), shortest, "{dots} dot units");
            check(&netlist, &schedule, u64::from(dots)).unwrap();
        }
    }
}

/// Random netlists that include dot products.
pub(crate) fn with_dots(seed: u64) -> Netlist {
    let mut random = Random::new(seed);
    let mut b = Builder::new("dots");
    let mut nodes: Vec<NodeId> = (0..5)
        .map(|i| {
            let bits = 2 + random.below(6) as u32;
            let frac = random.within(-1, 4) as i32;
            let format = Format::new(random.chance(60), bits, frac).unwrap();
            b.input(&format!("in{i}"), format, Quantity::Number)
        })
        .collect();
    for i in 0..3 + random.below(8) {
        let mut pick = || nodes[random.below(nodes.len())];
        let (m, v) = ([pick(), pick(), pick()], [pick(), pick(), pick()]);
        let sum = match i % 3 {
            0 | 1 => dot(&mut b, &format!("d{i}"), m, v),
            _ => {
                let product = b.mul(m[0], v[0]);
                b.sub(product, v[1])
            }
        };
        let format = Format::new(random.chance(60), 2 + random.below(6) as u32, 2).unwrap();
        let round = random.pick(Round::ALL);
        let narrow = b.narrow(sum, format, round, random.pick(Overflow::ALL));
        nodes.extend([sum, narrow].into_iter().filter(|id| b.format(*id).bits() < 16));
    }
    for (i, node) in nodes.iter().rev().take(3).enumerate() {
        b.output(&format!("out{i}"), *node);
    }
    b.build().unwrap()
}

pub(crate) fn random_plan(random: &mut Random) -> Plan {
    let mut shares = Vec::new();
    for (kind, _) in Kind::ALL {
        if random.chance(60) {
            let latency = random.chance(50).then(|| random.below(5) as u32);
            let units = 1 + random.below(3) as u32;
            shares.push(Share { kind: *kind, units, latency, loads: random.chance(40) });
        }
    }
    let interval = random.chance(40).then(|| 1 + random.below(20) as u32);
    Plan { shares, interval }
}

#[test]
fn random_netlists_under_random_plans() {
    let (mut checked, mut shared, mut latest) = (0, 0, 0);
    for seed in 0..600 {
        let mut random = Random::new(seed ^ 0xabcd);
        let netlist = Arc::new(if random.chance(50) {
            with_dots(seed)
        } else {
            random_netlist_within(seed, 4 + random.below(40), random.pick(&[6, 8, 12]))
        });
        let plan = random_plan(&mut random);
        let rom = random.pick(&[Rom::Block, Rom::Distributed]);
        let period = random.pick(&[100, 2000, 4000, 8000]);
        let schedule = match Schedule::shared(&netlist, rom, period, &plan) {
            Ok(schedule) => schedule,
            Err(why) => {
                let why = why.to_string();
                let known = [
                    "would need words of",
                    "or more: ",
                    "can't have a latency of",
                    "bits and words have at most",
                ];
                assert!(known.iter().any(|text| why.contains(text)), "seed {seed}: {why}");
                continue;
            }
        };
        checked += 1;
        shared += u32::from(schedule.units().iter().any(|unit| unit.operations.len() > 1));
        latest = latest.max(schedule.latency() / schedule.interval());
        if let Err(why) = check(&netlist, &schedule, seed) {
            panic!("seed {seed}, {rom}, {period} ps, {plan:?}: {why}\n{}", netlist.to_text());
        }
        let flat = Schedule::pipeline(&netlist, rom, Depth::Period(period)).unwrap();
        check(&netlist, &flat, seed).unwrap();
    }
    assert!(checked > 300 && shared > 200 && latest >= 3, "{checked} {shared} {latest}");
}

/// Rows of the patent's table: cycle and the cells of its three units.
pub(crate) fn printed() -> Vec<(usize, [String; 3])> {
    let lines = include_str!("figure_8.txt").lines().filter(|line| !line.starts_with('#'));
    let row = |line: &str| {
        let line = line.split('#').next().unwrap();
        let cells: Vec<String> = line.split('|').map(|cell| cell.trim().to_owned()).collect();
        let [cycle, dot1, adder, dot2] = cells.try_into().unwrap();
        (cycle.parse().unwrap(), [dot1, adder, dot2])
    };
    lines.map(row).collect()
}

/// `Out X`, `X = Y` and each name of a load, as separate events.
fn events(cell: &str) -> Vec<String> {
    let parts = cell.split("; ").filter(|part| !part.is_empty());
    let events = parts.flat_map(|part| match part.split_once(' ') {
        Some((load @ ("Ld" | "Load"), names)) => {
            names.split(", ").map(|name| format!("{load} {name}")).collect()
        }
        _ => vec![part.to_owned()],
    });
    events.collect()
}

#[test]
fn the_printed_table_event_by_event() {
    let netlist = emboss_netlist();
    let schedule = Schedule::bound(&netlist, Rom::Block, 6000, &figure_8()).unwrap();
    let rtl = Rtl::new(Arc::clone(&netlist), schedule);
    let table = Timetable::new(&rtl, Some(&figure_8()));
    let columns = ["Vector Dot Unit #1", "VFAdder", "Vector Dot Unit #2"];
    let rows = printed();
    assert_eq!(
        rows.iter().map(|(cycle, _)| *cycle).collect::<Vec<_>>(),
        (1..=19).collect::<Vec<_>>()
    );
    let mut compared = 0;
    for (at, title) in columns.iter().enumerate() {
        let column = table.titles.iter().position(|known| known == title).unwrap();
        for (cycle, cells) in &rows {
            let (should, got) = (events(&cells[at]), events(&table.rows[cycle - 1][column]));
            assert_eq!(got, should, "cycle {cycle}, {title}");
            compared += should.len();
        }
        // These units have nothing after the last printed cycle.
        assert!(table.rows[19..].iter().all(|row| row[column].is_empty()), "{title}");
    }
    assert_eq!(compared, 24);
    // Operations that the figure shows after that: inverse root, one multiplier, one adder.
    for (result, unit) in [("1/‖L‖", 3), ("Δs", 4), ("Δt", 4), ("S1", 5), ("T1", 5)] {
        assert_eq!(table.names[unit].iter().filter(|name| name.result == result).count(), 1);
    }
    // The delay FIFO of (S0, T0).
    for port in ["s0", "t0"] {
        let id = netlist.ids().find(|id| netlist.label(*id) == port).unwrap();
        assert!(rtl.registers(id).count() >= 2, "{port} waits for its displacement");
    }
    let counts = rtl.counts();
    let dots = ["dot1", "dot2"].map(|name| counts.units[name].datapath);
    assert_eq!(dots.map(|o| (o.multipliers, o.adders)), [(3, 2), (3, 2)]);
    assert_eq!(counts.units["multiplier"].datapath.multipliers, 1);
    assert_eq!(counts.operators.datapath.multipliers, 7);
    assert_eq!(counts.operators.datapath.adders, 6);
    assert_eq!(netlist.counts().datapath.multipliers, 29);
}

/// In each cycle the waves name the table's entries, and hold the named words.
#[test]
fn waves_show_the_table() {
    let design = emboss(&["schedule=printed", "period_ps=6000"]);
    let netlist = &design.netlist;
    let mut random = Random::new(7);
    let rows: Vec<Vec<i64>> = (0..5).map(|_| stimulus(netlist, &mut random)).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("emboss.vcd");
    let wave = Wave::new(&design, Options::default()).unwrap();
    wave.write(&rows, &mut std::fs::File::create(&path).unwrap(), &path).unwrap();
    wave.write_gtkw(&path, &mut std::fs::File::create(path.with_extension("gtkw")).unwrap())
        .unwrap();
    let read = ReadBack::open(&path);
    let period = read.times[2] - read.times[0];
    let at = |name: &str, cycle: usize| {
        read.at(&format!("emboss.{name}"), cycle as u64 * period).to_owned()
    };
    let latency = wave.rtl().schedule().latency() as usize;
    for cycle in 0..wave.cycles(rows.len()) as usize {
        assert_eq!(at("phase", cycle), format!("{:03b}", cycle % 8));
        assert_eq!(at("ready", cycle) == "1", cycle % 8 == 0);
        assert_eq!(at("valid_in", cycle) == "1", cycle % 8 == 0 && cycle < 8 * rows.len());
        let out = cycle.checked_sub(latency).is_some_and(|since| since % 8 == 0);
        assert_eq!(at("valid_out", cycle) == "1", out, "cycle {cycle}");
    }
    // The events of the table, at its cycles, for each sample.
    let tight =
        |text: &str| text.replace(' ', "").replace('·', "*").replace('−', "-").replace('²', "^2");
    let mut seen = 0;
    for sample in 0..rows.len() {
        for (cycle, cells) in printed() {
            let now = cycle - 1 + 8 * sample;
            for (unit, cell) in ["dot1", "vfadder", "dot2"].iter().zip(&cells) {
                let loads = events(cell)
                    .iter()
                    .filter_map(|e| e.strip_prefix("Ld ").or(e.strip_prefix("Load ")).map(tight))
                    .collect::<Vec<_>>();
                if !loads.is_empty() {
                    assert_eq!(at(&format!("units.{unit}.load"), now), loads.join(","), "{cycle}");
                    seen += 1;
                }
                for event in cell.split("; ") {
                    if let Some(name) = event.strip_prefix("Out ") {
                        assert_eq!(at(&format!("units.{unit}.out"), now), tight(name), "{cycle}");
                        seen += 1;
                    } else if event.contains('=') {
                        assert_eq!(
                            at(&format!("units.{unit}.issue"), now),
                            tight(event),
                            "{cycle}"
                        );
                        seen += 1;
                    }
                }
            }
        }
    }
    assert_eq!(seen, 23 * rows.len());
    // The ASCII form of a name loses nothing.
    for (name, changes) in read.signals.iter().filter(|(name, _)| name.starts_with("emboss.units."))
    {
        assert!(changes.values().all(|text| !text.contains('?')), "{name}");
    }
    // The shown words are the reference's for their sample.
    let mut compared = 0;
    for (name, node, stage) in wave.signals() {
        let format = netlist.node(node).format;
        for (sample, words) in rows.iter().enumerate() {
            let (reference, _) = netlist.eval(words).unwrap();
            let should = format!(
                "{:0width$b}",
                format.pattern(reference[node.index()]),
                width = format.bits() as usize
            );
            let now = stage as usize + 8 * sample;
            assert_eq!(at(&name, now), should, "{name} of sample {sample}");
            let is_own = stage == wave.rtl().schedule().stage(node);
            let next = at(&name, now + 1);
            if is_own {
                assert!(next.chars().all(|c| c == 'x'), "{name}: {next} after its phase");
            } else if now + 7 < wave.cycles(rows.len()) as usize {
                assert_eq!(at(&name, now + 7), should, "{name} is held");
            }
            let value = read.signals.get(&format!("emboss.{name}_value"));
            if let Some(changes) = value {
                let (_, text) = changes.range(..=now as u64 * period).next_back().unwrap();
                assert_eq!(text.parse::<f64>().unwrap(), format.value(reference[node.index()]));
            }
            compared += 1;
        }
    }
    assert!(compared > 200, "{compared}");
}

/// A constant that is the same in every operation of a unit isn't one of its ports, but the report
/// shows it.
#[test]
fn formulas_have_their_constants() {
    let set = ["schedule=shared", "share_add=40"];
    let design = fixpath::units::sampler::unit().values(&set).unwrap().build().unwrap();
    let rtl = design.rtl().unwrap();
    let table = Timetable::new(&rtl, None);
    let mut constants = 0;
    for (unit, names) in table.names.iter().enumerate() {
        for (name, operation) in names.iter().zip(rtl.operations(unit)) {
            let [_, a, b] = &name.operands[..] else { panic!("an adder's sides: {name:?}") };
            assert!(!a.is_empty() && !b.is_empty(), "{name:?}");
            let is_constant = |operand: &Operand| matches!(operand, Operand::Constant { .. });
            constants += usize::from(operation.operands[1..].iter().any(is_constant));
        }
    }
    assert!(constants > 0, "no constant among them");
}

#[test]
fn an_interval_too_short_names_kind_operations_and_remedy() {
    let netlist = emboss_netlist();
    let shared = |shares: Vec<Share>, interval| {
        let plan = Plan { shares, interval };
        Schedule::shared(&netlist, Rom::Block, 5000, &plan)
    };
    let error = shared(vec![share(Kind::Dot, 2)], Some(4)).unwrap_err().to_string();
    assert_eq!(
        error,
        "parameter `interval` = `4`: legal is 5 or more: 9 operations (t_x, t_y, t_z, b_x, b_y, b_z, t_dot_l, l_dot_l, b_dot_l) \
         share 2 units of kind dot (dot1, dot2); or share_dot=3"
    );
    // A longer interval is accepted; one more unit gives what the message promises.
    let schedule = shared(vec![share(Kind::Dot, 2), share(Kind::Adder, 1)], Some(11)).unwrap();
    assert_eq!((schedule.interval(), schedule.shortest_interval()), (11, 5));
    let loads: Vec<(u32, u32)> =
        schedule.loads().iter().map(|load| (load.interval(), load.interval_with(1))).collect();
    assert_eq!(loads, [(5, 3), (5, 3)]);
    let read = Share { latency: Some(0), ..share(Kind::Root, 1) };
    let error = shared(vec![read], None).unwrap_err().to_string();
    assert_eq!(
        error,
        "unit `root1` can't have a latency of 0 cycles: its longest chain of clocked reads needs 1; \
         raise share_latency, or use rom=distributed"
    );
}

/// A shared unit with too wide words names the parameters that cure it, as a flat datapath does.
#[test]
fn a_shared_unit_that_is_too_wide_names_parameters_whose_change_cures_it() {
    let wide = ["position_bits=30", "norm_bits=24", "component_bits=24", "dot_frac_bits=24"];
    let shared = ["root_frac_bits=22", "schedule=shared", "share_mul=1"];
    let unit = Unit::find("emboss").unwrap();
    let mut values = unit.values(&[&wide[..], &shared[..]].concat()).unwrap();
    let mut tries = 0;
    while let Err(error) = values.build().unwrap().rtl() {
        let message = error.to_string();
        let (head, tail) = message.split_once(" bits and words have at most 63: lower `").unwrap();
        assert!(head.starts_with("unit `mul`, shared by t_x.%"), "{message}");
        let (names, share) = tail.rsplit_once("`, or leave ").unwrap();
        assert_eq!(share, "share_mul=auto", "{message}");
        let name = names.split("` or `").next().unwrap();
        let less = values.int(name).unwrap() - 1;
        values.set(name, &less.to_string()).unwrap();
        tries += 1;
        assert!(tries < 20, "no end of {message}");
    }
    assert!(tries > 0, "nothing was too wide");
}

#[test]
fn a_hull_past_63_bits_names_the_unit_and_a_remedy() {
    let mut b = Builder::new("wide");
    let fine = b.input("fine", Format::signed(40, 39).unwrap(), Quantity::Number);
    let large = b.input("large", Format::signed(40, 0).unwrap(), Quantity::Number);
    let small = b.input("small", Format::signed(4, 0).unwrap(), Quantity::Number);
    let (p, q) = (b.mul(fine, small), b.mul(large, small));
    b.output("p", p);
    b.output("q", q);
    let plan = Plan { shares: vec![share(Kind::Multiplier, 1)], interval: None };
    let error = Schedule::shared(&b.build().unwrap(), Rom::Block, 5000, &plan).unwrap_err();
    assert_eq!(
        error.to_string(),
        "unit `mul`, shared by p, q, would need words of 79 bits and words have at most 63: \
         narrow its operands, or leave share_mul=auto"
    );
}

#[test]
fn bindings_that_are_wrong_say_how() {
    let netlist = emboss_netlist();
    let wrong = |change: &dyn Fn(&mut Binding)| {
        let mut binding = figure_8();
        change(&mut binding);
        Schedule::bound(&netlist, Rom::Block, 6000, &binding).unwrap_err().to_string()
    };
    let early = wrong(&|b| {
        b.operations.iter_mut().find(|o| o.label == "t_dot_l").unwrap().cycle = Some(14)
    });
    assert_eq!(
        early,
        "node `t_dot_l`: is bound to cycle 14, but `t_eye_z` is ready for cycle 15 at this period: \
         bind it later, or raise period_ps"
    );
    let twice = wrong(&|b| {
        b.operations.iter_mut().find(|o| o.label == "l_dot_l").unwrap().cycle = Some(23)
    });
    assert_eq!(
        twice,
        "node `l_dot_l`: uses dot2 in the same phase as `t_dot_l`: the schedule repeats every 8 cycles"
    );
    let unknown = wrong(&|b| b.operations[0].label = "t_w".to_owned());
    assert!(
        unknown
            .starts_with("node `dot1`: there is no operation `t_w` of this kind: there are t_x, "),
        "{unknown}"
    );
    let short = wrong(&|b| b.interval = 5);
    assert!(
        short.starts_with("parameter `interval` = `5`: legal is 6 or more: 6 operations"),
        "{short}"
    );
}

#[test]
fn parameters_that_do_not_count_are_refused() {
    let error = |set: &[&str]| {
        let design = fixpath::units::rotation::unit().values(set).unwrap().build().unwrap();
        design.rtl().unwrap_err().to_string()
    };
    assert_eq!(
        error(&["share_mul=2"]),
        "parameter `share_mul` = `2`: legal is auto with schedule=flat; it applies only to schedule=shared"
    );
    assert_eq!(
        error(&["schedule=printed"]),
        "parameter `schedule` = `printed`: legal is flat or shared: rotation has no printed schedule for these parameters; \
         that of emboss needs setting=gx and every auto switch left at auto"
    );
    assert_eq!(
        error(&["schedule=shared", "stages=4"]),
        "parameter `stages` = `4`: legal is auto with schedule=shared: the schedule sets the latency"
    );
}

/// Units at their committed settings, shared as far as possible.
#[test]
fn every_unit_shared() {
    for unit in fixpath::units::UNITS.iter() {
        for rom in ["block", "distributed"] {
            let set = ["schedule=shared", "share_add=2", "share_mul=1", "share_table=1"];
            let mut set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
            set.push(format!("rom={rom}"));
            let design = unit.values(&set).unwrap().build().unwrap();
            let rtl = match design.rtl() {
                Ok(rtl) => rtl,
                Err(why) => {
                    assert!(why.to_string().contains("bits and words have at most 63"), "{why}");
                    continue;
                }
            };
            check(&design.netlist, rtl.schedule(), 3)
                .unwrap_or_else(|why| panic!("{}: {why}", unit.name));
        }
    }
}

/// With overflow mode `error`, a `narrow` reports which node of which operation overflowed, for
/// valid data only.
#[test]
fn a_forbidden_overflow_in_a_shared_unit_names_the_node() {
    let mut b = Builder::new("forbidden");
    let format = Format::signed(6, 0).unwrap();
    let inputs = [0, 1].map(|i| b.input(&format!("in{i}"), format, Quantity::Number));
    for (i, input) in inputs.iter().enumerate() {
        let narrow = b.part(Part::Dot, &format!("d{i}"), |b| {
            let product = b.mul(*input, *input);
            let format = Format::signed(8, 0).unwrap();
            let narrow = b.narrow(product, format, Round::Floor, Overflow::Error);
            b.name(narrow, "square")
        });
        b.output(&format!("out{i}"), narrow);
    }
    let netlist = Arc::new(b.build().unwrap());
    let plan = Plan { shares: vec![share(Kind::Dot, 1)], interval: None };
    let schedule = Schedule::shared(&netlist, Rom::Block, 5000, &plan).unwrap();
    assert_eq!(schedule.interval(), 2);
    let run = |valid: bool| {
        let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(&netlist), schedule.clone())));
        for at in 0..12 {
            cycle.settle(&[3, 31], valid && at % 2 == 0).unwrap();
            cycle.clock();
        }
        cycle.forbidden_overflow().map(|id| netlist.label(id))
    };
    assert_eq!(run(true), Some("d1.square".to_owned()));
    assert_eq!(run(false), None);
}
