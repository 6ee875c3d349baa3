//! Splits a datapath in two: a part once per face, and a part for every sample.

use super::rebuild::{self, Rebuild};
use super::reduced::{Reduced, Source};
use super::report::Hoisted;
use crate::netlist::op::Op;
use crate::netlist::{NodeId, Rate};
use std::collections::BTreeSet;

/// A datapath in two parts.
pub(super) struct Halves {
    pub(super) face: Reduced,
    pub(super) pixel: Reduced,
    /// The nodes that cross from the face part to the pixel part, in the order of the face's
    /// outputs.
    pub(super) frontier: Vec<NodeId>,
    pub(super) hoisted: Vec<Hoisted>,
}

/// Splits nodes that depend on inputs of [`Rate::Pixel`] from those that don't; `None` if only
/// ports and constants don't.
pub(super) fn split(whole: &Reduced, rates: &[Rate]) -> Option<Halves> {
    let netlist = &whole.netlist;
    let outputs: Vec<(String, NodeId)> =
        netlist.outputs().iter().map(|output| (output.name.clone(), output.node)).collect();
    let mut ports = rates.iter();
    let mut per_pixel = Vec::with_capacity(netlist.nodes().len());
    for node in netlist.nodes() {
        let own = node.op == Op::Input && ports.next() == Some(&Rate::Pixel);
        // A delay counts samples.
        let own = own || matches!(node.op, Op::Delay { .. });
        per_pixel.push(own || node.operands.iter().any(|id| per_pixel[id.index()]));
    }
    let mut crosses = vec![false; netlist.nodes().len()];
    let pixel_users = netlist.nodes().iter().zip(&per_pixel).filter(|(_, per_pixel)| **per_pixel);
    let used = pixel_users.flat_map(|(node, _)| &node.operands);
    for id in used.chain(outputs.iter().map(|(_, id)| id)) {
        let stays = matches!(netlist.node(*id).op, Op::Input | Op::Const { .. });
        crosses[id.index()] = !stays && !per_pixel[id.index()];
    }
    let frontier: Vec<NodeId> = netlist.ids().filter(|id| crosses[id.index()]).collect();
    if frontier.is_empty() {
        return None;
    }

    let mut taken: BTreeSet<String> = outputs.iter().map(|(name, _)| name.clone()).collect();
    taken.extend((0..netlist.inputs().len()).map(|port| netlist.input_name(port).to_owned()));
    let crossing: Vec<(String, NodeId)> =
        frontier.iter().map(|id| (rebuild::port_name(netlist, *id, &mut taken), *id)).collect();

    let mut face = Rebuild::new(whole, &format!("{}_face", netlist.name()));
    let mut pixel = Rebuild::new(whole, &format!("{}_pixel", netlist.name()));
    let operands = |id: NodeId| netlist.node(id).operands.as_slice();
    let face_live = rebuild::live(netlist, frontier.iter().copied(), operands);
    let operands = |id: NodeId| if crosses[id.index()] { &[] } else { operands(id) };
    let pixel_live = rebuild::live(netlist, outputs.iter().map(|(_, id)| *id), operands);
    for id in netlist.ids() {
        if face_live[id.index()] {
            face.copy(id);
        }
        if pixel_live[id.index()] {
            match crossing.iter().position(|(_, crossing)| *crossing == id) {
                Some(output) => pixel.port(id, &crossing[output].0, Source::Face(output)),
                None => pixel.copy(id),
            }
        }
    }
    let hoisted = crossing.iter().map(|(port, id)| Hoisted {
        node: netlist.label(*id),
        port: port.clone(),
        format: netlist.node(*id).format.to_string(),
    });
    Some(Halves {
        hoisted: hoisted.collect(),
        face: face.finish(&crossing),
        pixel: pixel.finish(&outputs),
        frontier,
    })
}
