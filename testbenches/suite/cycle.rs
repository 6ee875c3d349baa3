//! Pipelines: at every depth the words are those of the reference, delayed by the latency.

use crate::engines::random_netlist;
use fixpath::cycle::Cycle;
use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Netlist, Quantity};
use fixpath::rtl::Rtl;
use fixpath::schedule::{Depth, Rom, Schedule};
use fixpath::units::rotation;
use std::sync::Arc;

/// Words for input ports: a hash of sample and port, and sometimes the ends of the format.
fn stimulus(netlist: &Netlist, sample: u64) -> Vec<i64> {
    let word = |(port, id): (usize, &fixpath::netlist::NodeId)| {
        let format = netlist.node(*id).format;
        let mut hash = (sample * 64 + port as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        hash ^= hash >> 29;
        match hash % 7 {
            0 => format.min_raw(),
            1 => format.max_raw(),
            _ => format.wrap((hash.wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 1) as i64),
        }
    };
    netlist.inputs().iter().enumerate().map(word).collect()
}

/// Feeds samples with occasional gaps and compares each valid result with the reference.
fn check(netlist: &Arc<Netlist>, schedule: Schedule, context: &str) {
    let latency = schedule.latency();
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(netlist), schedule)));
    let mut expected = std::collections::VecDeque::new();
    let mut seen = 0;
    for at in 0..u64::from(latency) + 24 {
        let valid = at < 24 && at % 5 != 3;
        let words = stimulus(netlist, at);
        cycle.settle(&words, valid).unwrap();
        let (reference, _) = netlist.eval(&words).unwrap();
        let outputs = netlist.outputs().iter().map(|o| reference[o.node.index()]).collect();
        expected.push_back(valid.then_some(outputs));
        if expected.len() > latency as usize {
            let should: Option<Vec<i64>> = expected.pop_front().unwrap();
            assert_eq!(cycle.outputs(), should, "{context}, cycle {at}");
            seen += usize::from(should.is_some());
        } else {
            assert_eq!(cycle.outputs(), None, "{context}: data before the latency");
        }
        cycle.clock();
    }
    assert_eq!(seen, 19, "{context}: every valid sample came out");
}

#[test]
fn random_netlists_at_every_depth() {
    for seed in 0..60 {
        let netlist = Arc::new(random_netlist(seed));
        for rom in [Rom::Block, Rom::Distributed] {
            for stages in 0..12 {
                let schedule = Schedule::pipeline(&netlist, rom, Depth::Stages(stages));
                let Ok(schedule) = schedule else {
                    let clocked = rom == Rom::Block && !netlist.tables().is_empty();
                    assert!(clocked, "only clocked reads require a latency");
                    continue;
                };
                assert_eq!(schedule.latency(), stages);
                check(&netlist, schedule, &format!("netlist {seed}, {rom}, {stages} stages"));
            }
            for period_ps in [100, 1000, 3000, 8000] {
                let schedule = Schedule::pipeline(&netlist, rom, Depth::Period(period_ps)).unwrap();
                check(&netlist, schedule, &format!("netlist {seed}, {rom}, {period_ps} ps"));
            }
        }
    }
}

#[test]
fn rotation_at_several_depths() {
    for variant in ["printed", "corrected", "exact"] {
        for rom in ["block", "distributed"] {
            for stages in ["auto", "8", "15"] {
                let assignments = [
                    format!("variant={variant}"),
                    format!("rom={rom}"),
                    format!("stages={stages}"),
                ];
                let design = rotation::unit().values(&assignments).unwrap().build().unwrap();
                let schedule = design.rtl().unwrap().schedule().clone();
                check(&design.netlist, schedule, &assignments.join(" "));
            }
        }
    }
}

#[test]
fn the_model_period_meets_the_target_where_no_operation_is_slower() {
    let design = rotation::unit().values(&["scheme=linear"]).unwrap().build().unwrap();
    let mut latency = 0;
    for period_ps in [12_000, 8_000, 6_000, 5_000] {
        let depth = Depth::Period(period_ps);
        let schedule = Schedule::pipeline(&design.netlist, Rom::Block, depth).unwrap();
        assert!(schedule.period_ps() <= period_ps, "{} > {period_ps}", schedule.period_ps());
        assert!(schedule.latency() >= latency, "a shorter period takes as many stages or more");
        latency = schedule.latency();
    }
}

#[test]
fn stages_taken_over_by_hand_have_the_same_period() {
    for variant in ["printed", "corrected", "exact"] {
        for rom in [Rom::Block, Rom::Distributed] {
            let variant = format!("variant={variant}");
            let netlist = rotation::unit()
                .values(&[variant, "scheme=linear".into()])
                .unwrap()
                .build()
                .unwrap()
                .netlist;
            let schedule = Schedule::pipeline(&netlist, rom, Depth::Period(4000)).unwrap();
            let stages = netlist.ids().map(|id| schedule.stage(id)).collect();
            let by_hand = Schedule::from_stages(&netlist, rom, stages, schedule.latency()).unwrap();
            assert_eq!(by_hand, schedule);
        }
    }
}

/// x -> (x + 1) * x, saturated.
fn small() -> Netlist {
    let mut b = Builder::new("small");
    let x = b.input("x", Format::signed(8, 4).unwrap(), Quantity::Number);
    let one = b.constant(16, Format::unsigned(5, 4).unwrap());
    let sum = b.add(x, one);
    let product = b.mul(sum, x);
    let y = b.narrow(product, Format::signed(8, 4).unwrap(), Round::HalfUp, Overflow::Saturate);
    b.output("y", y);
    b.build().unwrap()
}

#[test]
fn stages_by_hand_are_taken_or_refused() {
    let netlist = Arc::new(small());
    // input, constant, sum, product, narrow
    let by_hand = |stages: Vec<u32>, latency| {
        Schedule::from_stages(&netlist, Rom::Distributed, stages, latency)
    };
    check(&netlist, by_hand(vec![0, 0, 1, 3, 3], 5).unwrap(), "by hand");
    let early = by_hand(vec![0, 0, 2, 1, 3], 3).unwrap_err().to_string();
    assert_eq!(early, "node `%3`: stage 1 is before its operand `%2` in stage 2");
    let late = by_hand(vec![0, 0, 1, 2, 3], 2).unwrap_err().to_string();
    assert_eq!(late, "node `y`: is ready after the latency of 2");
    let input = by_hand(vec![1, 0, 1, 2, 3], 3).unwrap_err().to_string();
    assert_eq!(input, "node `x`: input ports must be in stage 0");
    let short = by_hand(vec![0], 1).unwrap_err().to_string();
    assert_eq!(short, "node `small`: 1 stages for 5 nodes");
}

#[test]
fn reset_drops_data_in_flight() {
    let netlist = Arc::new(small());
    let schedule = Schedule::pipeline(&netlist, Rom::Block, Depth::Stages(3)).unwrap();
    let mut cycle = Cycle::new(Arc::new(Rtl::new(Arc::clone(&netlist), schedule)));
    cycle.settle(&[1], true).unwrap();
    cycle.clock();
    cycle.reset();
    for _ in 0..6 {
        cycle.settle(&[2], false).unwrap();
        assert_eq!(cycle.outputs(), None);
        cycle.clock();
    }
    cycle.settle(&[3], true).unwrap();
    for _ in 0..3 {
        cycle.clock();
        cycle.settle(&[0], false).unwrap();
    }
    let (reference, _) = netlist.eval(&[3]).unwrap();
    assert_eq!(cycle.outputs(), Some(vec![reference[4]]));
}

#[test]
fn a_combinational_unit_with_clocked_tables_is_refused() {
    let design = rotation::unit().values(&["stages=0"]).unwrap().build().unwrap();
    let error = design.rtl().unwrap_err().to_string();
    assert_eq!(
        error,
        "parameter `stages` = `0`: legal is 1 or more with rom=block, or rom=distributed"
    );
    let design =
        rotation::unit().values(&["variant=corrected", "stages=2"]).unwrap().build().unwrap();
    let error = design.rtl().unwrap_err().to_string();
    assert!(error.starts_with("parameter `stages` = `2`: legal is "), "{error}");
}
