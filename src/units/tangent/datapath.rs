//! The datapath: edges, the map of a vertex or of a facet, and the vectors it maps.

use super::bounds::bounds;
use super::golden::golden;
use super::switches::{AXES, Switches, mapped};
use super::triangle::{draw, hard_cases};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Design, Group, HardCase, Shape, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::units::basis::{component, rounded, vector_frac_bits};
use crate::units::cross::cross;
use crate::units::dot::{dot, vector_ports};
use crate::units::normalise::{Block, block, narrowed, unit_vector};
use crate::units::parts::plan::number;
use crate::units::rsqrt::Root;

/// Maximum integer bits of a coordinate.
pub(super) const MOST_INT_BITS: u32 = 22;

/// A signed format of positions or texture coordinates. It has few enough bits that differences,
/// and products of two differences, are exact in the golden's `f64`.
fn coordinate(values: &Values, int_bits: &str, frac_bits: &str) -> Result<Format> {
    let (whole, fraction) = (values.bits(int_bits), values.bits(frac_bits));
    if !(1..=23).contains(&(whole + fraction)) {
        let (least, most) =
            (1u32.saturating_sub(fraction), 23u32.saturating_sub(fraction).min(MOST_INT_BITS));
        let legal =
            format!("{least} to {most} with {frac_bits}={fraction}: words have 2 to 24 bits");
        return Err(values.refuse(int_bits, &legal));
    }
    number(whole, fraction)
}

/// Maximum bits of a position, a texture coordinate and a component together: N x T is exact.
const EXACT_BITS: u32 = 58;

/// Maximum bits of a component and its guard bits together, where N x T of a facet is exact.
const FACET_BITS: u32 = 31;

pub(super) fn design(values: &Values) -> Result<Design> {
    let switches = Switches::new(values);
    let position = coordinate(values, "position_int_bits", "position_frac_bits")?;
    let uv = coordinate(values, "uv_int_bits", "uv_frac_bits")?;
    let coordinates = position.bits() + uv.bits();
    if !switches.faceted && coordinates + values.bits("component_bits") > EXACT_BITS {
        let legal = format!(
            "2 to {} with positions of {} and texture coordinates of {} bits: N x T is exact, so \
             the three may have at most {EXACT_BITS} bits together",
            EXACT_BITS - coordinates,
            position.bits(),
            uv.bits()
        );
        return Err(values.refuse("component_bits", &legal));
    }
    // N x T of a facet: a difference of two products of unit vectors' words.
    let (component_bits, guard_bits) = (values.bits("component_bits"), values.bits("guard_bits"));
    if switches.faceted && switches.orthonormal && component_bits + guard_bits > FACET_BITS {
        let legal = format!(
            "0 to {} with component_bits={component_bits}, frame=faceted and basis=orthonormal: N x T is \
             exact, so the two may have at most {FACET_BITS} bits together",
            FACET_BITS - component_bits
        );
        return Err(values.refuse("guard_bits", &legal));
    }
    let mut b = values.builder("tangent");
    let p = ["p0", "p1", "p2"].map(|name| vector_ports(&mut b, name, position, Quantity::Number));
    let uv = ["uv0", "uv1", "uv2"].map(|name| {
        ["u", "v"].map(|axis| b.input(&format!("{name}_{axis}"), uv, Quantity::Number))
    });
    let normal = if switches.faceted {
        None
    } else {
        Some(vector_ports(&mut b, "normal", component(values)?, Quantity::Number))
    };
    let vector_bits = values.bits("vector_bits");
    let frac_bits =
        cast::signed_count(vector_bits - 1) - cast::signed_count(values.bits("vector_int_bits"));
    let format = Format::signed(vector_bits, frac_bits)?;
    let vectors: Vec<(String, [NodeId; 3])> = mapped(switches.lights)
        .map(|name| (format!("ts_{name}"), vector_ports(&mut b, &name, format, Quantity::Number)))
        .collect();

    let mut root = Root::new(values);
    let edges = b.scope("primitive", |b| edges(b, p, uv));
    let map = match normal {
        Some(n) => {
            let t = if switches.orthonormal {
                None
            } else {
                Some(b.scope("primitive", |b| printed_tangent(b, &mut root, &edges))?)
            };
            b.scope("vertex", |b| vertex_map(b, &mut root, switches, &edges, t, n))?
        }
        None => b.scope("primitive", |b| facet_map(b, &mut root, switches, &edges))?,
    };
    let mut names = Vec::new();
    for (row, name) in map.rows.iter().zip(["t", "b", "n"]) {
        names.push(name.to_owned());
        for (word, axis) in row.iter().zip(AXES) {
            b.output(&format!("{name}_{axis}"), *word);
        }
    }
    let format = mapped_format(values, switches)?;
    for (name, v) in vectors {
        let words = b.scope("vertex", |b| {
            [0, 1, 2].map(|i| {
                let exact = dot(b, &format!("{name}_{}", ["t", "b", "n"][i]), map.rows[i], v);
                let word = b.narrow(exact, format, root.round, Overflow::Saturate);
                b.name(word, &format!("{name}_{}", AXES[i]))
            })
        });
        for (word, axis) in words.into_iter().zip(AXES) {
            b.output(&format!("{name}_{axis}"), word);
        }
        names.push(name);
    }
    let mut flags = vec![
        ("mirrored", edges.mirrored),
        ("degenerate", map.degenerate),
        ("zero_uv", edges.zero_uv),
        ("zero_area", edges.zero_area),
    ];
    flags.extend(map.parallel.map(|flag| ("parallel", flag)));
    for (name, flag) in &flags {
        b.output(name, *flag);
    }
    let tabulated = root.tabulated;
    let netlist = b.build()?;
    let mut groups: Vec<Group> = names
        .into_iter()
        .enumerate()
        .map(|(at, name)| {
            let words = netlist.outputs()[3 * at..3 * at + 3].iter().map(|output| output.node);
            Group::new(name, Shape::Cartesian, words.collect())
        })
        .collect();
    groups.extend(Group::ports(&netlist, flags.iter().map(|(name, _)| *name))?);
    let mut hard = hard_cases(&netlist);
    hard.extend(HardCase::extremes(&netlist));
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(draw)
        .hard(hard)
        .bounds(bounds(switches))
        .tabulated(tabulated))
}

/// Exact values of a triangle.
struct Edges {
    e1: [NodeId; 3],
    e2: [NodeId; 3],
    duv1: [NodeId; 2],
    duv2: [NodeId; 2],
    /// `dv2 e1 - dv1 e2`: dP/du times det.
    tangent: [NodeId; 3],
    /// `e1 x e2`.
    area: [NodeId; 3],
    mirrored: NodeId,
    zero_uv: NodeId,
    zero_area: NodeId,
}

fn edges(b: &mut Builder, p: [[NodeId; 3]; 3], uv: [[NodeId; 2]; 3]) -> Edges {
    let [e1, e2] = [1, 2].map(|k| {
        [0, 1, 2].map(|i| {
            let edge = b.sub(p[k][i], p[0][i]);
            b.name(edge, &format!("e{k}_{}", AXES[i]))
        })
    });
    let [duv1, duv2] = [1, 2].map(|k| {
        [0, 1].map(|i| {
            let edge = b.sub(uv[k][i], uv[0][i]);
            b.name(edge, &format!("d{}{k}", ["u", "v"][i]))
        })
    });
    let det = determinant(b, "det", [duv1[0], duv2[1]], [duv2[0], duv1[1]]);
    let zero = b.constant(0, Format::FLAG);
    let zero_uv = b.equal(det, zero);
    let mirrored = b.negative(det);
    let tangent = [0, 1, 2]
        .map(|i| determinant(b, &format!("t_det_{}", AXES[i]), [duv2[1], e1[i]], [duv1[1], e2[i]]));
    let area = cross(b, "e1_cross_e2", e1, e2);
    let zero_area = is_zero(b, area);
    b.name(zero_uv, "zero_uv");
    b.name(zero_area, "zero_area");
    b.name(mirrored, "mirrored");
    Edges { e1, e2, duv1, duv2, tangent, area, mirrored, zero_uv, zero_area }
}

/// `a b - c d`.
fn determinant(b: &mut Builder, name: &str, plus: [NodeId; 2], minus: [NodeId; 2]) -> NodeId {
    let (plus, minus) = (b.mul(plus[0], plus[1]), b.mul(minus[0], minus[1]));
    let exact = b.sub(plus, minus);
    b.name(exact, name)
}

/// Flag: a vector is 0.
fn is_zero(b: &mut Builder, v: [NodeId; 3]) -> NodeId {
    let zero = b.constant(0, Format::FLAG);
    let [x, y, z] = v.map(|x| b.equal(x, zero));
    let both = b.and(x, y);
    b.and(both, z)
}

/// The map of a vertex or of a facet.
struct Map {
    rows: [[NodeId; 3]; 3],
    degenerate: NodeId,
    /// Only for a vertex.
    parallel: Option<NodeId>,
}

/// The rows, with their signs changed where the texture is mirrored.
fn map(
    b: &mut Builder,
    switches: Switches,
    edges: &Edges,
    degenerate: NodeId,
    rows: [[NodeId; 3]; 3],
) -> [[NodeId; 3]; 3] {
    let one = b.constant(1, Format::FLAG);
    let regular = b.xor(degenerate, one);
    let flag = b.and(edges.mirrored, regular);
    let turned = switches.turned();
    [0, 1, 2].map(|row| {
        rows[row].map(|word| {
            if !turned[row] {
                return word;
            }
            let opposite = b.neg(word);
            let either = b.mux(flag, opposite, word);
            // Components are up to 2√2. The most negative word has no opposite, but it is -2 or -4,
            // which no correct component is.
            let format = b.format(word);
            b.narrow(either, format, Round::Floor, Overflow::Saturate)
        })
    })
}

/// `flag ? v : w`, with v moved to the fraction bits of w: only its direction matters.
fn choose(b: &mut Builder, flag: NodeId, v: [NodeId; 3], w: [NodeId; 3]) -> [NodeId; 3] {
    [0, 1, 2].map(|i| {
        let left = b.format(v[i]).frac_bits() - b.format(w[i]).frac_bits();
        let moved = b.shift(v[i], left);
        b.mux(flag, moved, w[i])
    })
}

/// The unit vector of an axis, in LSBs of a format.
fn axis(b: &mut Builder, axis: usize, format: Format) -> [NodeId; 3] {
    [0, 1, 2].map(|i| b.constant(i64::from(i == axis), format))
}

/// Signed format of a unit vector's components, which holds 1.
fn unit_format(values: &Values) -> Result<Format> {
    let frac_bits = vector_frac_bits(values);
    Format::signed((frac_bits + 2).unsigned_abs(), frac_bits)
}

/// The triangle's tangent as the patent computes it.
struct Tangent {
    /// Exact: -1 to 1 with the largest component at least ½, times `2^raised`.
    words: [NodeId; 3],
    raised: i32,
    /// The reciprocal length of the words over `2^raised`.
    factor: NodeId,
    unit: [NodeId; 3],
}

fn printed_tangent(b: &mut Builder, root: &mut Root<'_>, edges: &Edges) -> Result<Tangent> {
    let format = unit_format(root.values)?;
    let round = root.round;
    let Block { words: exact, .. } = block(b, "t_block", edges.tangent);
    let words = narrowed(b, "t_norm", exact, root.norm_bits, round);
    let square = dot(b, "t_square", words, words);
    let factor = root.of_square(b, "t_length", square)?;
    let unit = words.map(|word| {
        let exact = b.mul(word, factor);
        b.narrow(exact, format, round, Overflow::Saturate)
    });
    // As many integer bits as the edges have, so that a multiplier shared by both is no wider than
    // either needs.
    let raised = b.format(edges.e1[0]).int_bits();
    let words = exact.map(|x| b.shift(x, raised));
    Ok(Tangent { words, raised, factor, unit })
}

/// T, B and N of a vertex, from the printed tangent of the triangle or from the exact one.
fn vertex_map(
    b: &mut Builder,
    root: &mut Root<'_>,
    switches: Switches,
    edges: &Edges,
    tangent: Option<Tangent>,
    n: [NodeId; 3],
) -> Result<Map> {
    // The axis used if there is no tangent, and N x that axis.
    let magnitudes = n.map(|x| b.abs(x));
    let along_x = b.less(magnitudes[1], magnitudes[0]);
    b.name(along_x, "along_x");
    let zero = b.constant(0, b.format(n[0]));
    let opposite = n.map(|x| b.neg(x));
    let n_cross_axis = [
        b.mux(along_x, opposite[2], zero),
        b.mux(along_x, zero, n[2]),
        b.mux(along_x, n[0], opposite[1]),
    ];
    let any = b.or(edges.zero_uv, edges.zero_area);
    let (frac_bits, round) = (vector_frac_bits(root.values), root.round);
    let flags = |b: &mut Builder, exact| {
        let parallel = is_zero(b, exact);
        b.name(parallel, "parallel");
        let degenerate = b.or(any, parallel);
        (parallel, b.name(degenerate, "degenerate"))
    };
    let format = unit_format(root.values)?;
    // A component is at most two components of N long, 2√2, and the words reach 3 or more.
    let long = number(2, frac_bits.unsigned_abs())?;
    let (t, binormal, parallel, degenerate) = if let Some(tangent) = tangent {
        // N x T times the reciprocal length of T, from the exact words of T.
        let exact = cross(b, "n_cross_t", n, tangent.words);
        let (parallel, degenerate) = flags(b, exact);
        let one = b.constant(1, Format::FLAG);
        let none = b.constant(0, Format::FLAG);
        let not_along_x = b.xor(along_x, one);
        let axis = [not_along_x, along_x, none];
        let t = [0, 1, 2].map(|i| {
            let either = b.mux(degenerate, axis[i], tangent.unit[i]);
            b.narrow(either, format, round, Overflow::Saturate)
        });
        let binormal = [0, 1, 2].map(|i| {
            let moved = b.shift(exact[i], -tangent.raised);
            let moved = rounded(b, moved, frac_bits, round);
            let exact = b.mul(moved, tangent.factor);
            let unit = b.narrow(exact, long, round, Overflow::Saturate);
            // N x the axis has components of N, so it is representable.
            let either = b.mux(degenerate, n_cross_axis[i], unit);
            b.narrow(either, long, round, Overflow::Saturate)
        });
        (t, binormal, parallel, degenerate)
    } else {
        let exact = cross(b, "n_cross_t", n, edges.tangent);
        let (parallel, degenerate) = flags(b, exact);
        let exact = choose(b, degenerate, n_cross_axis, exact);
        let (binormal, _) = unit_vector(b, root, "b", exact, format)?;
        let exact = cross(b, "b_cross_n", binormal, n);
        let t = exact.map(|x| b.narrow(x, long, round, Overflow::Saturate));
        (t, binormal, parallel, degenerate)
    };
    let rows = map(b, switches, edges, degenerate, [t, binormal, n]);
    Ok(Map { rows, degenerate, parallel: Some(parallel) })
}

/// T, B and N of a facet.
fn facet_map(
    b: &mut Builder,
    root: &mut Root<'_>,
    switches: Switches,
    edges: &Edges,
) -> Result<Map> {
    let format = unit_format(root.values)?;
    let degenerate = b.or(edges.zero_uv, edges.zero_area);
    b.name(degenerate, "degenerate");
    let mut direction = |b: &mut Builder, name: &str, exact: [NodeId; 3], edge, along: usize| {
        let exact = match edge {
            Some(edge) => choose(b, edges.zero_uv, edge, exact),
            None => exact,
        };
        let along = axis(b, along, b.format(exact[0]));
        let exact = choose(b, edges.zero_area, along, exact);
        Ok::<_, crate::base::error::Error>(unit_vector(b, root, name, exact, format)?.0)
    };
    let t = direction(b, "t", edges.tangent, Some(edges.e1), 0)?;
    let n = direction(b, "n", edges.area, None, 2)?;
    let binormal = if switches.orthonormal {
        let exact = cross(b, "n_cross_t", n, t);
        exact.map(|x| b.narrow(x, format, root.round, Overflow::Saturate))
    } else {
        let ([du1, _], [du2, _]) = (edges.duv1, edges.duv2);
        let exact = [0, 1, 2].map(|i| {
            let name = format!("s_det_{}", AXES[i]);
            determinant(b, &name, [du1, edges.e2[i]], [du2, edges.e1[i]])
        });
        direction(b, "b", exact, Some(edges.e2), 1)?
    };
    let rows = map(b, switches, edges, degenerate, [t, binormal, n]);
    Ok(Map { rows, degenerate, parallel: None })
}

/// Format of mapped vectors. The longest v has the length √3·2^vector_int_bits. A row has length 1,
/// or at most 2√3 as N. So results are up to √3, or 6, times 2^vector_int_bits. The largest word is
/// an ulp below a power of two: 8 times 2^vector_int_bits for 6. For √3 it is 2, if an ulp is at
/// most the difference of 0.26. Saturation then only removes errors beyond the golden.
fn mapped_format(values: &Values, switches: Switches) -> Result<Format> {
    let (whole, fraction) = (values.bits("vector_int_bits"), values.bits("out_frac_bits"));
    let more = match (switches.faceted, whole + fraction) {
        (false, _) => 3,
        (true, 2..) => 1,
        (true, _) => 2,
    };
    number(whole + more, fraction)
}
