//! Exact statistics of table schemes, over every word of their arguments.

use crate::base::cast;
use crate::base::error::Result;
use crate::base::json;
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Round};
use crate::number::function::{Function, Number};
use crate::sim::batch::Program;
use crate::table;
use crate::table::{Scheme, Tabulated};
use quick_cache::sync::Cache;
use rayon::prelude::*;
use serde::Serialize;
use std::sync::{Arc, LazyLock};

/// Exact statistics of one function of a table scheme, over every word of its argument.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TableFigures {
    /// Table and function.
    pub table: String,
    /// Function.
    pub function: String,
    /// Largest absolute error against the function saturated to the output format.
    #[serde(serialize_with = "json::real")]
    pub worst: f64,
    /// The same in ulp of the output.
    #[serde(serialize_with = "json::real")]
    pub worst_ulp: f64,
    /// Argument word that gives it.
    pub witness_raw: i64,
    /// Its value.
    #[serde(serialize_with = "json::real")]
    pub witness: f64,
    /// Number of pairs of neighbouring words between which table and function go in opposite
    /// directions.
    pub not_monotone: u64,
    /// Largest jump between neighbouring words in excess of the function's own step.
    #[serde(serialize_with = "json::real")]
    pub jump: f64,
    /// Upper word of that jump.
    pub jump_raw: i64,
}

/// The widest argument whose words are enumerated.
pub const TABLE_ARGUMENT_BITS: u32 = 26;

/// Enumerates every word of a table scheme's argument; `None` if the argument has more than
/// [`TABLE_ARGUMENT_BITS`] bits.
///
/// # Errors
/// If the scheme has a word wider than 63 bits.
///
/// # Panics
/// If a thread panicked.
pub fn table_figures(tabulated: &Tabulated) -> Result<Option<Vec<TableFigures>>> {
    if tabulated.argument.bits() > TABLE_ARGUMENT_BITS {
        return Ok(None);
    }
    let Tabulated { name, functions, scheme, addr_bits, .. } = tabulated;
    let Tabulated { quarter_wave, origin, output, round, argument, .. } = *tabulated;
    let folded: Vec<Option<(Function, bool)>> = functions
        .iter()
        .filter(|_| quarter_wave)
        .map(|function| function.quarter_wave().map(|(of, on)| (of.clone(), on)))
        .collect();
    let size = (*scheme, *addr_bits, folded, Number::from(origin));
    let key = (functions.clone(), size, output, round, argument);
    let found = match GONE_THROUGH.get(&key) {
        Some(found) => found,
        None => {
            let found: Arc<[TableFigures]> = go_through(tabulated)?.into();
            GONE_THROUGH.insert(key, Arc::clone(&found));
            found
        }
    };
    let named = |figures: &TableFigures| TableFigures { table: name.clone(), ..figures.clone() };
    Ok(Some(found.iter().map(named).collect()))
}

/// Results so far: points of a sweep share most of their schemes.
static GONE_THROUGH: LazyLock<Cache<Key, Arc<[TableFigures]>>> = LazyLock::new(|| Cache::new(4096));

/// Everything that defines a scheme, except its name.
type Key = (Vec<Function>, Size, Format, Round, Format);
/// Scheme, address bits, the folded functions, origin.
type Size = (Scheme, u32, Vec<Option<(Function, bool)>>, Number);

fn go_through(tabulated: &Tabulated) -> Result<Vec<TableFigures>> {
    let mut b = Builder::new("table");
    let argument = b.input("argument", tabulated.argument, Quantity::Number);
    let nodes = table::emit(&mut b, &tabulated.spec(), argument);
    for (i, node) in nodes.iter().enumerate() {
        b.output(&format!("f{i}"), *node);
    }
    let netlist = b.build()?;
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(&netlist, &outputs);
    let (lo, hi) = (tabulated.argument.min_raw(), tabulated.argument.max_raw());
    let starts: Vec<i64> = (lo..=hi).step_by(cast::index_of(CHUNK_WORDS)).collect();
    let parts: Vec<Vec<TableFigures>> = starts
        .par_iter()
        .map_init(
            || program.runner(),
            |runner, start| {
                // Include one word before the chunk, so that every joint is covered.
                let first = (start - 1).max(lo);
                let last = (start + CHUNK_WORDS - 1).min(hi);
                let words: Vec<i64> = (first..=last).collect();
                let mut columns = vec![Vec::new(); nodes.len()];
                let ran = runner.run(&program, &[&words], &mut columns);
                ran.expect("bug: words are of their ports' formats");
                tabulated
                    .functions
                    .iter()
                    .zip(&columns)
                    .map(|(function, column)| part_figures(tabulated, function, &words, column))
                    .collect()
            },
        )
        .collect();
    let mut parts = parts.into_iter();
    let mut total = parts.next().expect("bug: arguments have words");
    for part in parts {
        for (total, part) in total.iter_mut().zip(part) {
            if part.worst > total.worst {
                total.worst = part.worst;
                total.worst_ulp = part.worst_ulp;
                total.witness_raw = part.witness_raw;
                total.witness = part.witness;
            }
            if part.jump > total.jump {
                total.jump = part.jump;
                total.jump_raw = part.jump_raw;
            }
            total.not_monotone += part.not_monotone;
        }
    }
    Ok(total)
}

/// Words per task in [`table_figures`].
const CHUNK_WORDS: i64 = 1 << 14;

fn part_figures(
    tabulated: &Tabulated,
    function: &Function,
    words: &[i64],
    column: &[i64],
) -> TableFigures {
    let (output, argument) = (tabulated.output, tabulated.argument);
    let (lo, hi) = (output.value(output.min_raw()), output.value(output.max_raw()));
    let mut figures = TableFigures {
        table: tabulated.name.clone(),
        function: function.name().to_owned(),
        worst: -1.0,
        worst_ulp: 0.0,
        witness_raw: 0,
        witness: 0.0,
        not_monotone: 0,
        jump: 0.0,
        jump_raw: 0,
    };
    let mut before: Option<(f64, f64)> = None;
    for (word, raw) in words.iter().zip(column) {
        let x = tabulated.origin + argument.value(*word);
        let (is, should) = (output.value(*raw), function.eval(x).clamp(lo, hi));
        let error = (is - should).abs();
        if error > figures.worst {
            figures.worst = error;
            figures.worst_ulp = error / output.ulp();
            figures.witness_raw = *word;
            figures.witness = x;
        }
        if let Some((is_before, should_before)) = before {
            let (step, own) = (is - is_before, should - should_before);
            // If a pole lies between the words, the jump is the function's own.
            if (step - own).abs() > figures.jump {
                figures.jump = (step - own).abs();
                figures.jump_raw = *word;
            }
            figures.not_monotone += u64::from(step * own < 0.0);
        }
        before = Some((is, should));
    }
    figures
}
