//! The schedule that US 6,980,218 prints.

use super::switches::Switches;
use crate::schedule::{Binding, BoundOperation, BoundUnit, Kind as Shared};

/// The schedule that US 6,980,218 prints for the hardware of its figure 8. Cycles 1 to 19 are the
/// patent's; later operations run as early as they can.
pub(super) fn figure_8(switches: Switches) -> Binding {
    let unit =
        |name: &str, title: &str, kind, latency, registered: &[bool], load: &str| BoundUnit {
            name: name.to_owned(),
            title: title.to_owned(),
            kind,
            latency,
            registered: registered.to_vec(),
            load: load.to_owned(),
        };
    let units = vec![
        // The matrix rows come straight from matrix memory.
        unit("dot1", "Vector Dot Unit #1", Shared::Dot, Some(9), &[false, true], "Load"),
        unit("vfadder", "VFAdder", Shared::Adder, Some(0), &[], ""),
        unit("dot2", "Vector Dot Unit #2", Shared::Dot, Some(0), &[true, true], "Ld"),
        unit("inverse_root", "Inverse Root", Shared::Root, None, &[], ""),
        unit("multiplier", "Multiplier", Shared::Multiplier, None, &[], ""),
        unit("adder", "Adder", Shared::Adder, Some(0), &[], ""),
    ];
    let mut operations = Vec::new();
    let mut bind = |label: &str, unit, cycle, result: &str, formula: &str, of: &[&str]| {
        operations.push(BoundOperation {
            label: label.to_owned(),
            unit,
            cycle,
            result: result.to_owned(),
            formula: formula.to_owned(),
            operands: of.iter().map(|side| (*side).to_owned()).collect(),
        });
    };
    for (i, axis) in (0u32..).zip(["x", "y", "z"]) {
        let m = format!("M{i}");
        for (name, vector, first) in [("t", "T", 2), ("b", "B", 6)] {
            let formula = format!("{m} · {vector}");
            let result = format!("{vector}e{axis}");
            let cycle = Some(first + i);
            bind(&format!("{name}_{axis}"), 0, cycle, &result, &formula, &[&m, vector]);
        }
        let (to, from) = if switches.vertex_light { ("Ve", "Lp") } else { ("Lp", "Ve") };
        let formula = format!("{to}{axis} − {from}{axis}");
        bind(&format!("l_{axis}"), 1, Some(8 + i), &format!("L{axis}"), &formula, &[]);
    }
    bind("t_dot_l", 2, Some(15), "Te · L", "", &["Te", "L"]);
    bind("l_dot_l", 2, Some(16), "L²", "", &["L", "L"]);
    bind("b_dot_l", 2, Some(19), "Be · L", "", &["Be", "L"]);
    bind("reciprocal_length", 3, None, "1/‖L‖", "1/√L²", &[]);
    for (axis, vector) in [("s", "Te"), ("t", "Be")] {
        let (delta, coordinate) = (format!("Δ{axis}"), axis.to_uppercase());
        let product = format!("{vector} · L / ‖L‖");
        bind(&format!("d{axis}_product"), 4, None, &delta, &product, &[]);
        let sum = format!("{coordinate}0 + {delta}");
        bind(&format!("{axis}1_sum"), 5, None, &format!("{coordinate}1"), &sum, &[]);
    }
    Binding { interval: 8, units, operations }
}
