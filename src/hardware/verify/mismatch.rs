//! A word on which a tool and the engine disagree.

use super::request::Job;
use crate::hardware::emit::vectors::Vectors;
use crate::netlist::Netlist;
use serde::Serialize;

/// A wrong output word.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mismatch {
    /// Number of the vector, from 0; the hard cases come first.
    pub vector: u64,
    /// Input words by port.
    pub inputs: Vec<Decoded>,
    /// Output port, or `valid_out`.
    pub port: String,
    /// The expected word.
    pub expected: Decoded,
    /// The simulator's word.
    pub got: Decoded,
}

/// A word of a port.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Decoded {
    /// The port.
    pub port: String,
    /// The pattern in hexadecimal, as the simulator prints it; unknown bits are x.
    pub pattern: String,
    /// The word; `None` if some bits are unknown.
    pub raw: Option<i64>,
    /// Its value.
    pub value: Option<f64>,
}

/// A port's word from its pattern as a simulator prints it.
fn decoded(netlist: &Netlist, node: crate::netlist::NodeId, port: &str, pattern: &str) -> Decoded {
    let format = netlist.node(node).format;
    let bits = u64::from_str_radix(pattern, 16).ok();
    let raw = bits.map(|bits| format.wrap(crate::base::cast::word_of_bits(bits & (u64::MAX >> 1))));
    Decoded {
        port: port.to_owned(),
        pattern: pattern.to_owned(),
        raw,
        value: raw.map(|raw| format.value(raw)),
    }
}

/// The mismatch that a line of a testbench reports, with its inputs.
pub(super) fn mismatch(job: &Job<'_>, line: &str, vectors: Vectors) -> Option<Mismatch> {
    let netlist = &job.design.netlist;
    let mut words = line.strip_prefix("mismatch: vector ")?.split_whitespace();
    let number = words.next()?.parse().ok()?;
    let port = words.next()?.to_owned();
    let (expected, got) = match (words.next()?, words.next()?, words.next()?, words.next()?) {
        ("expected", expected, "got", got) => (expected, got),
        _ => return None,
    };
    let output = netlist
        .outputs()
        .iter()
        .zip(&job.package.module.outputs)
        .find(|(_, (name, _))| *name == port);
    let word = |pattern: &str| match output {
        Some((output, _)) => decoded(netlist, output.node, &port, pattern),
        None => Decoded {
            port: port.clone(),
            pattern: pattern.to_owned(),
            raw: pattern.parse().ok(),
            value: None,
        },
    };
    let (inputs, _) = vectors.vector(number)?;
    let inputs = inputs.iter().zip(netlist.inputs()).enumerate().map(|(at, (raw, id))| {
        let format = netlist.node(*id).format;
        let pattern = format!("{:x}", format.pattern(*raw));
        decoded(netlist, *id, netlist.input_name(at), &pattern)
    });
    Some(Mismatch {
        vector: number,
        inputs: inputs.collect(),
        expected: word(expected),
        got: word(got),
        port,
    })
}
