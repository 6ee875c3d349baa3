//! Specialises a netlist, and reports the savings.

use super::known::Known;
use super::reduced::{Reduced, Source};
use super::report::{PartReport, Report, Specialised};
use super::simplify::{Tally, simplify};
use super::split::split;
use super::tables;
use crate::netlist::Rate;
use crate::netlist::ranges::ranges;
use crate::netlist::words::Words;
use crate::netlist::{Netlist, NodeId};
use std::collections::BTreeSet;

/// Reduces a netlist to the wanted outputs and to the words that occur at its inputs.
///
/// # Panics
/// If there isn't one `Known` per input, with words of its format, if `outputs` is empty, or if a
/// name in it isn't that of an output.
#[must_use]
pub fn specialise(netlist: &Netlist, inputs: &[Known], outputs: &[&str]) -> Specialised {
    assert!(!outputs.is_empty(), "bug: no output of `{}` is wanted", netlist.name());
    let wanted = netlist.outputs().iter().filter(|output| outputs.contains(&output.name.as_str()));
    let wanted: Vec<(String, NodeId)> =
        wanted.map(|output| (output.name.clone(), output.node)).collect();
    let names: BTreeSet<&str> = outputs.iter().copied().collect();
    assert!(wanted.len() == names.len(), "bug: `{}` lacks one of {names:?}", netlist.name());
    let given: Vec<Words> = inputs.iter().map(|known| known.words.clone()).collect();
    let words = ranges(netlist, &given);

    let mut tally = Tally::default();
    let simple = simplify(netlist, &words, &wanted, &mut tally);
    let rates: Vec<Rate> =
        simple.inputs.iter().map(|source| inputs[port_of(*source)].rate).collect();
    let mut words_of_face = Vec::new();
    let (parts, hoisted) = match split(&simple, &rates) {
        None => (None, Vec::new()),
        Some(cut) => {
            let given = known_words(&simple, &given, &[]);
            let words = ranges(&simple.netlist, &given);
            words_of_face = cut.frontier.iter().map(|id| words[id.index()].clone()).collect();
            (Some((cut.face, cut.pixel)), cut.hoisted)
        }
    };
    let finish = |part: &Reduced| {
        let words = known_words(part, &given, &words_of_face);
        let (reduced, cuts) = tables::cut(part, &ranges(&part.netlist, &words));
        let report = PartReport {
            inputs: (0..reduced.inputs.len())
                .map(|i| reduced.netlist.input_name(i).to_owned())
                .collect(),
            outputs: reduced.netlist.outputs().iter().map(|output| output.name.clone()).collect(),
            counts: reduced.netlist.counts(),
            tables: cuts,
        };
        (reduced, report)
    };
    let (whole, whole_report) = finish(&simple);
    let (face, pixel) = match parts {
        None => (None, (whole.clone(), whole_report.clone())),
        Some((face, pixel)) => (Some(finish(&face)), finish(&pixel)),
    };
    let (face, face_report) = face.unzip();
    let removed_inputs = (0..netlist.inputs().len())
        .filter(|port| !whole.inputs.contains(&Source::Port(*port)))
        .map(|port| netlist.input_name(port).to_owned())
        .collect();
    let removed_outputs = netlist
        .outputs()
        .iter()
        .filter(|output| !outputs.contains(&output.name.as_str()))
        .map(|output| output.name.clone())
        .collect();
    Specialised {
        report: Report {
            before: netlist.counts(),
            whole: whole_report,
            face: face_report,
            pixel: pixel.1,
            removed_inputs,
            removed_outputs,
            folded: tally.folded,
            folded_nodes: tally.folded_nodes,
            simplified_nodes: tally.simplified_nodes,
            unlimited_narrows: tally.unlimited_narrows,
            hoisted,
        },
        whole,
        face,
        pixel: pixel.0,
    }
}

fn port_of(source: Source) -> usize {
    match source {
        Source::Port(port) => port,
        Source::Face(_) => panic!("bug: the whole datapath has no face"),
    }
}

/// The words that occur at each input of a part.
fn known_words(part: &Reduced, ports: &[Words], face: &[Words]) -> Vec<Words> {
    let words = |source: &Source| match source {
        Source::Port(port) => ports[*port].clone(),
        Source::Face(output) => face[*output].clone(),
    };
    part.inputs.iter().map(words).collect()
}
