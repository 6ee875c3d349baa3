//! The order of the instructions, and their sharing of columns.

use super::compile::Compiler;
use super::program::{Action, Column, Instruction, Program, slot_of};
use crate::sim::lanes::Width;
use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::mem::take;

impl Compiler<'_> {
    /// Orders the instructions so that few columns are live. Among those whose operands are ready,
    /// the next is the one that frees the most bits net of its own result.
    fn ordered(&self, outputs: &[(usize, bool)]) -> Vec<Instruction> {
        /// Number of ready instructions considered: enough for short lives, and few enough for long
        /// programs.
        const WINDOW: usize = 64;
        let operands = |at: usize| {
            let mut of = self.instructions[at].of[..self.instructions[at].operands].to_vec();
            of.sort_unstable();
            of.dedup();
            of
        };
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); self.widths.len()];
        let mut left = vec![0; self.widths.len()];
        let mut maker = vec![None; self.widths.len()];
        for (at, instruction) in self.instructions.iter().enumerate() {
            for column in operands(at) {
                users[column].push(at);
                left[column] += 1;
            }
            maker[instruction.to.slot] = Some(at);
            if let Action::ReadPair { second, .. } = instruction.action {
                maker[second] = Some(at);
            }
        }
        // Outputs are never freed.
        for (column, _) in outputs {
            left[*column] += 1;
        }
        let mut missing: Vec<usize> = (0..self.instructions.len())
            .map(|at| operands(at).into_iter().filter(|column| maker[*column].is_some()).count())
            .collect();
        let mut ready: BTreeSet<usize> =
            (0..missing.len()).filter(|at| missing[*at] == 0).collect();
        let mut order = Vec::with_capacity(missing.len());
        let bits = |column: usize| i64::from(self.widths[column].bits());
        while !ready.is_empty() {
            let gain = |at: &usize| {
                let freed = operands(*at).into_iter().filter(|column| {
                    // Ports and constants keep their columns.
                    left[*column] == 1 && maker[*column].is_some()
                });
                let freed: i64 = freed.map(bits).sum();
                let instruction = &self.instructions[*at];
                let pair = matches!(instruction.action, Action::ReadPair { .. });
                freed - bits(instruction.to.slot) * if pair { 2 } else { 1 }
            };
            let candidates = ready.iter().take(WINDOW);
            let best = candidates.max_by_key(|at| (gain(at), Reverse(**at)));
            let at = *best.expect("bug: something is ready");
            ready.remove(&at);
            let instruction = self.instructions[at];
            for column in operands(at) {
                left[column] -= 1;
            }
            let mut made = vec![instruction.to.slot];
            if let Action::ReadPair { second, .. } = instruction.action {
                made.push(second);
            }
            for user in made.into_iter().flat_map(|column| &users[column]) {
                missing[*user] -= 1;
                if missing[*user] == 0 {
                    ready.insert(*user);
                }
            }
            order.push(instruction);
        }
        assert_eq!(order.len(), self.instructions.len(), "bug: an instruction waits for itself");
        order
    }

    /// Gives columns to nodes, and reuses a column once all its users are done. Constants, which
    /// are filled once, and ports, which are filled before the first instruction, keep theirs.
    pub(super) fn finish(mut self, outputs: &[(usize, bool)]) -> Program {
        self.instructions = self.ordered(outputs);
        // Repeated instructions come first, in unchanged order. Without a repeating port none is
        // repeated, not even those that read only constants: the last block may be short, and
        // overflows are counted.
        let mut repeats = vec![self.program.repeats.contains(&true); self.widths.len()];
        for (input, port) in self.program.inputs.iter().zip(&self.program.repeats) {
            if let Some(input) = input {
                repeats[input.slot] = *port;
            }
        }
        let (mut first, mut rest) = (Vec::new(), Vec::new());
        for instruction in take(&mut self.instructions) {
            let all = instruction.of[..instruction.operands].iter().all(|column| repeats[*column])
                && !matches!(instruction.action, Action::Delay { .. });
            repeats[instruction.to.slot] = all;
            if let Action::ReadPair { second, .. } = instruction.action {
                repeats[second] = all;
            }
            if all { first.push(instruction) } else { rest.push(instruction) }
        }
        self.program.repeated = first.len();
        first.append(&mut rest);
        self.instructions = first;
        let mut last_use = vec![0; self.widths.len()];
        for (at, instruction) in self.instructions.iter().enumerate() {
            for column in &instruction.of[..instruction.operands] {
                // Results of repeated instructions are kept for the next block.
                let kept = repeats[*column] && at >= self.program.repeated;
                last_use[*column] = if kept { usize::MAX } else { at };
            }
        }
        let mut slots = vec![usize::MAX; self.widths.len()];
        let mut count = [0; 3];
        let mut fresh = |width: Width| {
            count[slot_of(width)] += 1;
            count[slot_of(width)] - 1
        };
        let mut kept: Vec<usize> = outputs.iter().map(|(column, _)| *column).collect();
        for input in self.program.inputs.iter_mut().flatten() {
            kept.push(input.slot);
            slots[input.slot] = fresh(input.width);
            input.slot = slots[input.slot];
        }
        let mut constants: Vec<((i64, Width), usize)> = self.constants.into_iter().collect();
        constants.sort_unstable_by_key(|(_, column)| *column);
        for ((raw, width), column) in constants {
            kept.push(column);
            slots[column] = fresh(width);
            self.program.constants.push((Column { width, slot: slots[column] }, raw));
        }
        for column in kept {
            last_use[column] = usize::MAX;
        }
        let mut free: [Vec<usize>; 3] = Default::default();
        for (at, mut instruction) in self.instructions.into_iter().enumerate() {
            let width = instruction.to.width;
            let mut give = |column: usize| {
                if slots[column] == usize::MAX {
                    slots[column] = free[slot_of(width)].pop().unwrap_or_else(|| fresh(width));
                }
                slots[column]
            };
            let to = instruction.to.slot;
            instruction.to.slot = give(to);
            let mut made = vec![to];
            if let Action::ReadPair { second, .. } = &mut instruction.action {
                made.push(*second);
                *second = give(*second);
            }
            let mut done: Vec<usize> = instruction.of[..instruction.operands].to_vec();
            for column in &mut instruction.of[..instruction.operands] {
                *column = slots[*column];
            }
            done.sort_unstable();
            done.dedup();
            done.retain(|column| last_use[*column] == at);
            // Columns that nothing reads are free at once.
            made.retain(|column| last_use[*column] <= at);
            for column in done.into_iter().chain(made) {
                free[slot_of(self.widths[column])].push(slots[column]);
            }
            self.program.instructions.push(instruction);
        }
        self.program.outputs = outputs
            .iter()
            .map(|(column, zero)| {
                (Column { width: self.widths[*column], slot: slots[*column] }, *zero)
            })
            .collect();
        self.program.slots = count;
        self.program
    }
}
