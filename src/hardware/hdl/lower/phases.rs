//! The phase counter of a time-shared module, and the flags of its phases.

use super::words::Lowering;
use crate::base::cast;
use crate::hardware::hdl::module::{Bit, Bitwise, Driver, Expr, Next, Operand, Register, SlowRate};
use std::collections::BTreeSet;

impl Lowering {
    /// The phase counter, if there is more than one phase.
    pub(super) fn phases(&mut self) {
        let count = self.module.phases;
        if count == 1 {
            return;
        }
        self.open("phase".to_owned());
        let bits = self.at.rtl.phase_bits();
        let phase = self.word("phase", bits, false, 0, Driver::Register);
        self.module.stages[self.stage].declared.push(phase);
        let literal = |number: u32| Operand::Literal { pattern: number.into(), bits };
        let more = Expr::Add(self.resized(phase, bits), literal(1));
        let mut next = self.plain(phase, "more", bits, more);
        if !count.is_power_of_two() {
            let last = Expr::Equal(self.resized(phase, bits), literal(count - 1));
            let last = self.flag(phase, "last", last);
            let cases = vec![(last, literal(0))];
            let around = Expr::Choose { cases, default: self.resized(next, bits) };
            next = self.plain(phase, "next", bits, around);
        }
        self.use_bits(next, 0, u32::MAX);
        for number in self.phases_at_work() {
            let is = Expr::Equal(self.resized(phase, bits), literal(number));
            let word = self.word(&format!("phase_{number}"), 1, false, 0, Driver::Logic);
            self.assign(word, is);
            self.flags.insert(vec![number], Bit { word, bit: 0 });
        }
        self.module.stages[self.stage].registers.push(Register {
            word: phase,
            next: Next::Word(next),
            load: None,
            valid: None,
            reset: true,
        });
        self.module.ready = self.ready(self.module.interval);
        for place in 0..self.module.rates.len() {
            // A rate whose words are accepted as often as those of the next faster rate shares its
            // ready port.
            let faster =
                self.module.rates.get(place + 1).map_or(self.module.interval, |r| r.interval);
            let SlowRate { rate, interval, .. } = self.module.rates[place];
            if interval > faster {
                let port = self.names.take(&format!("ready_{rate}"));
                let flag = self.ready(interval).expect("bug: it has phases between");
                self.module.rates[place].ready = Some((port, flag));
            }
        }
    }

    /// The flag of the phases in which words of a rate with this interval are accepted.
    fn ready(&mut self, interval: u32) -> Option<Bit> {
        let phases: Vec<u32> = self.at.rtl.schedule().phases_of(0, interval).collect();
        let flag = self.during(&phases)?;
        self.use_bits(flag.word, flag.bit, 1);
        Some(flag)
    }

    /// Phases that need a flag: those of events that don't happen in every phase.
    fn phases_at_work(&self) -> BTreeSet<u32> {
        let (rtl, schedule) = (&self.at.rtl, self.at.rtl.schedule());
        let mut phases = BTreeSet::new();
        let mut some = |among: Vec<u32>| {
            if among.len() < cast::index_of_u32(schedule.phases()) {
                phases.extend(among);
            }
        };
        for register in rtl.netlist().ids().flat_map(|id| rtl.registers(id)) {
            some(rtl.load_phases(register).collect());
        }
        for unit in rtl.units() {
            for port in &unit.ports {
                if port.registered || port.cases.len() > 1 {
                    let cases = port.cases.iter();
                    cases.for_each(|case| {
                        some(schedule.phases_of(case.phase, unit.interval).collect())
                    });
                }
            }
        }
        for timing in schedule.timings() {
            some(schedule.phases_of(0, timing.interval).collect());
        }
        for stage in rtl.netlist().ids().filter(|id| rtl.is_state(*id)).map(|id| schedule.stage(id))
        {
            some(schedule.phases_of(stage, schedule.interval()).collect());
        }
        some(schedule.phases_of(schedule.latency(), schedule.interval()).collect());
        phases
    }

    /// The flag of some phases, in ascending order; `None` if these are all phases.
    pub(super) fn during(&mut self, phases: &[u32]) -> Option<Bit> {
        if phases.len() == cast::index_of_u32(self.module.phases) {
            return None;
        }
        if let Some(flag) = self.flags.get(phases) {
            return Some(*flag);
        }
        let (last, before) = phases.split_last().expect("bug: some phase");
        let before = self.during(before).expect("bug: fewer phases than there are");
        let last = self.flags[&vec![*last]];
        let numbers: Vec<String> = phases.iter().map(u32::to_string).collect();
        let wanted = format!("phase_{}", numbers.join("_"));
        let word = self.word(&wanted, 1, false, 0, Driver::Logic);
        self.assign(word, Expr::Bitwise(Bitwise::Or, before.word, last.word));
        let flag = Bit { word, bit: 0 };
        self.flags.insert(phases.to_vec(), flag);
        Some(flag)
    }

    /// The flag of the phases at whose end something loads; `None` if that is every phase.
    pub(super) fn load(&mut self, phases: impl Iterator<Item = u32>) -> Option<Bit> {
        // The inside of a unit works in every phase.
        let flat = self.at.rtl.schedule().phases() == 1;
        let flag = if flat { None } else { self.during(&phases.collect::<Vec<_>>()) };
        if let Some(flag) = flag {
            self.use_bits(flag.word, flag.bit, 1);
        }
        flag
    }
}
