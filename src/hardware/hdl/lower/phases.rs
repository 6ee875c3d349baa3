//! The phase counter of a time-shared module, and the flags of its phases.

use super::words::Lowering;
use crate::base::cast;
use crate::hardware::hdl::module::{Bit, Bitwise, Driver, Expr, Next, Operand, Register};
use std::collections::BTreeSet;

impl Lowering {
    /// The phase counter, where there is more than one phase.
    pub(super) fn phases(&mut self) {
        let interval = self.module.interval;
        if interval == 1 {
            return;
        }
        self.open("phase".to_owned());
        let bits = self.at.rtl.phase_bits();
        let phase = self.word("phase", bits, false, 0, Driver::Register);
        self.module.stages[self.stage].declared.push(phase);
        let literal = |number: u32| Operand::Literal { pattern: number.into(), bits };
        let more = Expr::Add(self.resized(phase, bits), literal(1));
        let mut next = self.plain(phase, "more", bits, more);
        if !interval.is_power_of_two() {
            let last = Expr::Equal(self.resized(phase, bits), literal(interval - 1));
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
        let ready = self.flags[&vec![0]];
        self.use_bits(ready.word, ready.bit, 1);
        self.module.ready = Some(ready);
    }

    /// Phases that something depends on.
    fn phases_at_work(&self) -> BTreeSet<u32> {
        let rtl = &self.at.rtl;
        let loads = rtl.netlist().ids().flat_map(|id| rtl.registers(id));
        let ports = rtl.units().iter().flat_map(|unit| &unit.ports);
        let several = ports.filter(|port| port.registered || port.cases.len() > 1);
        let mut phases: BTreeSet<u32> = loads.map(|register| rtl.load_phase(register)).collect();
        phases.extend(several.flat_map(|port| port.cases.iter().map(|case| case.phase)));
        phases.extend([0, rtl.schedule().phase(rtl.schedule().latency())]);
        phases
    }

    /// The flag of some phases in ascending order; none if they are all that there are.
    pub(super) fn during(&mut self, phases: &[u32]) -> Option<Bit> {
        if phases.len() == cast::index_of_u32(self.module.interval) {
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

    /// The flag of a phase at whose end something happens.
    pub(super) fn load(&mut self, phase: u32) -> Option<Bit> {
        // The inside of a unit works in every phase.
        let flat = self.at.rtl.schedule().interval() == 1;
        let flag = if flat { None } else { self.during(&[phase]) };
        if let Some(flag) = flag {
            self.use_bits(flag.word, flag.bit, 1);
        }
        flag
    }
}
