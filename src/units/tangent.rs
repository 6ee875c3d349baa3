//! The set-up of tangent-space bump mapping: from one triangle and one of its vertices to the map from
//! object space to texture space, and the view vector and lights through it (seed 004, US 7,843,463).
//!
//! With edges `e1 = p1 - p0`, `e2 = p2 - p0` and those of the texture `(du1, dv1)`, `(du2, dv2)`, position
//! changes along the axes of the texture as
//!
//! ```text
//! dP/du = (dv2 e1 - dv1 e2)/det    dP/dv = (du1 e2 - du2 e1)/det    det = du1 dv2 - du2 dv1
//! ```
//!
//! The tangent T is the direction of dP/du; B = N x T with the normal N of the vertex; the rows of the map are
//! T, B, N, and a vector of the texture is their dot products with one of the object. With
//! `frame=faceted` N isn't given: the second tangent is the direction of dP/dv and N that of their cross
//! product. `dP/du x dP/dv = (e1 x e2)/det`, so the hardware takes the exact `e1 x e2`, and slivers, whose
//! tangents are nearly parallel, lose nothing.
//!
//! Triangles are wound so that N is on the side of `e1 x e2`: counterclockwise as seen from outside,
//! `N·(e1 x e2) > 0`. With an N on the other side, B points against dP/dv, and bumps along v are dents.
//!
//! # What the seed prints, and what isn't right
//!
//! - **Mirrored textures.** (dP/du, dP/dv, N) is right-handed where det > 0 and left-handed where det < 0. There N x T
//!   points along -dP/dv. The seed negates the tangent there (`mirror=printed`): then B points along
//!   dP/dv, and T along -dP/du. A map [T; N x T; N] is right-handed whatever T is, so no sign of T makes
//!   both right: it only moves the fault from one axis to the other. Bumps along u are lit from the wrong side.
//!   With `mirror=off` they are along v. `mirror=handed` has T = dP/du and B = sign(det) N x T: both right.
//! - **Mirrored facets.** T x dP/dv points inward where det < 0: with `mirror=off` the facet is lit from behind. The
//!   seed's negated tangent mends the normal, and bumps along u are wrong. `mirror=handed` takes
//!   N = sign(det) T x dP/dv: all three right.
//! - **"Orthonormal".** The seed calls the map so, and it isn't where T isn't at right angles to N, as with
//!   every vertex normal that isn't the face's: then B is shorter than 1 and light leaks from N to T. With
//!   `basis=printed` it is as printed: T as it is, B = N x T as long as it comes, of a facet dP/dv as it is.
//!   `basis=orthonormal` takes B = N x T over its length and T = B x N, which has the direction of T's part
//!   at right angles to N, and the length of N; of a facet B = N x T, which is the part of dP/dv at right angles to T.
//!
//! # Without a frame
//!
//! Differences and products are exact, so that "zero" is exactly zero of the given words. `degenerate` is the
//! or of three flags: `zero_uv`, det is 0; `zero_area`, `e1 x e2` is 0; with vertex normals
//! `parallel`, `N x (dv2 e1 - dv1 e2)` is 0. Then nothing is mirrored, and
//!
//! - a vertex has T along the x axis, or the y axis where |N_x| > |N_y|, and B = N x T, made orthonormal as
//!   `basis` says: a frame that depends on N alone. With N = 0, B is 0, and so is an orthonormal T.
//! - a facet without uv area has T along e1 (and, with `basis=printed`, e2 for dP/dv) and its own
//!   normal; one without area has T, B, N along x, y, z.
//!
//! Next to zero nothing happens: bounds hold for the least det and slivers of any length, since vectors are
//! block-normalised from exact words and N x T is taken of the exact T.

use super::basis::{
    component, component_bits, dot_frac_bits, golden_unit, guard_bits, longest, rounded,
    unit_error, vector_frac_bits, vector_rounding,
};
use super::cross::cross;
use super::dot::{dot, vector_ports};
use super::normalise::{Block, block, direction_error, narrowed, norm_bits, unit_vector};
use super::parts::plan::{number, rounding_ulp};
use super::rsqrt::{Root, length_error, root_addr_bits, root_frac_bits, root_scheme};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Draw, Golden, Group, HardCase, InputPorts, Param, Role, Sampler, Shape,
    Uniform, Unit, Values,
};
use crate::netlist::{Builder, Netlist, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::number::trig::{Real, sin_cos_turns};
use glam::{DVec2, DVec3};

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("tangent", "tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space")
        .source("seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended")
        .params([
            Param::choice("frame", ["smooth", "faceted"])
                .role(Role::Pipeline)
                .help("a map per vertex with its normal, or one for the triangle with a second tangent"),
            Param::choice("mirror", ["handed", "printed", "off"])
                .help("mirrored textures: B (of a facet N) turned, T turned as the seed has it, or nothing; \
               errors are against the golden of the same rule"),
            Param::choice("basis", ["orthonormal", "printed"])
                .help("T, B, N made orthonormal, or T and N x T (of a facet dP/dv) as they are; \
               errors are against the golden of the same rule"),
            Param::int("lights", 1..=MOST_LIGHTS.into()).role(Role::Count).help("number of lights"),
            Param::bits("position_int_bits", 0..=MOST_INT_BITS)
                .default(4)
                .help("positions are from -2^position_int_bits to 2^position_int_bits"),
            Param::bits("position_frac_bits", 0..=23)
                .default(11)
                .help("fraction bits of positions; with sign and whole bits 2 to 24"),
            Param::bits("uv_int_bits", 0..=MOST_INT_BITS)
                .default(2)
                .help("texture coordinates are from -2^uv_int_bits to 2^uv_int_bits"),
            Param::bits("uv_frac_bits", 0..=23)
                .default(13)
                .help("fraction bits of texture coordinates; with sign and whole bits 2 to 24"),
            component_bits(),
            guard_bits().default(2),
            Param::bits("vector_int_bits", 0..=20)
                .default(1)
                .help("view vector and lights are from -2^vector_int_bits to 2^vector_int_bits"),
            Param::bits("vector_bits", 2..=24).default(16).help("bits of their components, signed"),
            Param::bits("out_frac_bits", 0..=30)
                .default(14)
                .help("fraction bits of view vector and lights in texture space"),
            norm_bits(),
            dot_frac_bits(),
            root_scheme(),
            root_addr_bits().default(8),
            root_frac_bits(),
            Param::rounding("rounding"),
        ])
        .inputs("p0_x … p2_z: positions of the triangle's vertices in object space, counterclockwise as seen from outside, where N points: \
             N·(e1 x e2) > 0, else B is against dP/dv and bumps along v are dents; \
             uv0_u … uv2_v: their texture coordinates; with frame=smooth normal_x … normal_z: unit normal of the vertex, from -2 to 2; \
             view_x … view_z, light0_x … : vectors from the vertex to the eye and each of `lights` lights in object space, of any length. \
             The sampler lit draws triangles with no angle below 30° and N at most 45° off theirs; sphere draws any")
        .outputs("t_x … t_z, b_x … b_z, n_x … n_z: rows of the map; ts_view_x … , ts_light0_x … : view vector and lights in texture space, \
              along T, B and N, as long as they come; mirrored: 1 where the texture's determinant is negative (with degenerate 1, too, \
              where it turns nothing); degenerate: 1 where a fixed frame is taken; why: zero_uv, zero_area and, with frame=smooth, parallel")
        .design(design)
}

/// What mirrored textures turn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Mirror {
    Handed,
    Printed,
    Off,
}

/// The switches.
#[derive(Clone, Copy, Debug)]
struct Switches {
    faceted: bool,
    mirror: Mirror,
    orthonormal: bool,
    lights: usize,
}

impl Switches {
    fn new(values: &Values) -> Self {
        Self {
            faceted: values.choice("frame") == "faceted",
            mirror: match values.choice("mirror") {
                "handed" => Mirror::Handed,
                "printed" => Mirror::Printed,
                _ => Mirror::Off,
            },
            orthonormal: values.choice("basis") == "orthonormal",
            lights: cast::index_of(i64::from(values.bits("lights"))),
        }
    }

    /// Which rows of the map change their sign where the texture is mirrored, if they come of the
    /// tangent `dv2 e1 - dv1 e2`, which has that of det in it already, of `N x` that or of
    /// `du1 e2 - du2 e1`, and of `e1 x e2`.
    fn turned(self) -> [bool; 3] {
        let t = self.mirror != Mirror::Printed;
        match (self.faceted, self.orthonormal) {
            (false, _) => [t, self.mirror == Mirror::Off, false],
            // N x T is dP/dv already, in the sign of the exact e1 x e2.
            (true, true) => [t, false, self.mirror == Mirror::Off],
            (true, false) => [t, true, self.mirror == Mirror::Off],
        }
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The most lights.
const MOST_LIGHTS: u8 = 8;

/// Names of the vectors that are mapped: the view vector, then each light.
fn mapped(lights: usize) -> impl Iterator<Item = String> {
    std::iter::once("view".to_owned()).chain((0..lights).map(|light| format!("light{light}")))
}

/// Names of the quantities of a vector whose error is bounded.
fn quantities(name: &str) -> [String; 4] {
    ["x", "y", "z", "dot"].map(|part| format!("{name}_{part}"))
}

/// The most whole bits of a coordinate.
const MOST_INT_BITS: u32 = 22;

/// A signed format of positions or texture coordinates: no more bits than make the golden's
/// differences and products of two exact in an `f64`.
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

/// The most bits that a position, a texture coordinate and a component have together: N x T is exact.
const EXACT_BITS: u32 = 58;

/// The most bits that a component and its guard bits have together where N x T of a facet is exact.
const FACET_BITS: u32 = 31;

fn design(values: &Values) -> Result<Design> {
    let switches = Switches::new(values);
    let position = coordinate(values, "position_int_bits", "position_frac_bits")?;
    let uv = coordinate(values, "uv_int_bits", "uv_frac_bits")?;
    let coordinates = position.bits() + uv.bits();
    if !switches.faceted && coordinates + values.bits("component_bits") > EXACT_BITS {
        let legal = format!(
            "2 to {} with positions of {} and texture coordinates of {} bits: N x T is exact, and \
             {EXACT_BITS} bits of the three together make 63",
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
             exact, and {FACET_BITS} bits of the two together make 63",
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

/// What a triangle gives, exact.
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

/// The map of a vertex or a facet.
struct Map {
    rows: [[NodeId; 3]; 3],
    degenerate: NodeId,
    /// Of a vertex.
    parallel: Option<NodeId>,
}

/// The rows with their signs where the texture is mirrored.
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
            // Components are up to 2√2: the most negative word, which has no opposite, is -2 or -4, and never right.
            let format = b.format(word);
            b.narrow(either, format, Round::Floor, Overflow::Saturate)
        })
    })
}

/// `flag ? v : w`, v moved to the fraction bits of w: only the direction counts.
fn choose(b: &mut Builder, flag: NodeId, v: [NodeId; 3], w: [NodeId; 3]) -> [NodeId; 3] {
    [0, 1, 2].map(|i| {
        let left = b.format(v[i]).frac_bits() - b.format(w[i]).frac_bits();
        let moved = b.shift(v[i], left);
        b.mux(flag, moved, w[i])
    })
}

/// An axis as a vector of the least words of a format.
fn axis(b: &mut Builder, axis: usize, format: Format) -> [NodeId; 3] {
    [0, 1, 2].map(|i| b.constant(i64::from(i == axis), format))
}

/// Signed format of a vector's components that holds 1.
fn unit_format(values: &Values) -> Result<Format> {
    let frac_bits = vector_frac_bits(values);
    Format::signed((frac_bits + 2).unsigned_abs(), frac_bits)
}

/// The triangle's tangent as the seed has it.
struct Tangent {
    /// Exact: -1 to 1, its largest component ½ or more, times `2^raised`.
    words: [NodeId; 3],
    raised: i32,
    /// The reciprocal length of what the words are over that.
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
    // As many whole bits as the edges have, so that multipliers that both share aren't wider than either.
    let raised = b.format(edges.e1[0]).int_bits();
    let words = exact.map(|x| b.shift(x, raised));
    Ok(Tangent { words, raised, factor, unit })
}

/// T, B and N of a vertex; of the triangle's own tangent, or of the exact one.
fn vertex_map(
    b: &mut Builder,
    root: &mut Root<'_>,
    switches: Switches,
    edges: &Edges,
    tangent: Option<Tangent>,
    n: [NodeId; 3],
) -> Result<Map> {
    // The axis that is used without a tangent, and N x it.
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
    // No component is longer than two of N's, 2√2: words end at 3 or above.
    let long = number(2, frac_bits.unsigned_abs())?;
    let (t, binormal, parallel, degenerate) = if let Some(tangent) = tangent {
        // N x T by the reciprocal length of T, from the exact words of T.
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
            // N x the axis is a component of N: it has a code.
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

/// Format of what is mapped. The longest v has √3·2^vector_int_bits, a row is 1 long, or as long as
/// the longest N, 2√3: results are up to √3, or 6, of 2^vector_int_bits. The largest word is an ulp below
/// a power of two, 8 of these for 6; for √3 it is 2, where an ulp is no more than the 0.26 between. Then
/// saturation only takes away what an error has put past the golden.
fn mapped_format(values: &Values, switches: Switches) -> Result<Format> {
    let (whole, fraction) = (values.bits("vector_int_bits"), values.bits("out_frac_bits"));
    let more = match (switches.faceted, whole + fraction) {
        (false, _) => 3,
        (true, 2..) => 1,
        (true, _) => 2,
    };
    number(whole + more, fraction)
}

/// Bounds on the rows and on what they map.
fn bounds(switches: Switches) -> Bounds {
    let mut bounds = vec![
        Bound::new("tangent", quantities("t"), |v, w| row_errors(v, w)[0]),
        Bound::new("binormal", quantities("b"), |v, w| row_errors(v, w)[1]),
        Bound::new("normal", quantities("n"), |v, w| row_errors(v, w)[2]),
    ];
    bounds.extend(mapped(switches.lights).map(|name| {
        let quantities = quantities(&format!("ts_{name}"));
        Bound::new(name, quantities, mapped_error)
    }));
    let flags: &[&str] = if switches.faceted {
        &["mirrored", "degenerate", "zero_uv", "zero_area"]
    } else {
        &["mirrored", "degenerate", "zero_uv", "zero_area", "parallel"]
    };
    bounds.push(Bound::new("flags", flags, |_, _| 0.0));
    Bounds::Stated(bounds)
}

/// Length of the error of each row, for any words.
///
/// A unit vector of exact words is off by `unit` ([`unit_error`]), and so is every row that is one. Of
/// others:
///
/// - orthonormal T of a vertex, `B x N`: `|N| unit` and a rounding;
/// - printed B of a vertex, `c/|T|` with c = N x T in words of T over a power of two, |T| ½ or more: c' is
///   rounded; the reciprocal length, up to 2, is off by the share `length` for narrowed words, whose length
///   is off by no more than their direction, as `direction_error` bounds their difference over the shorter;
/// - orthonormal B of a facet, `N x T`: `unit` for each factor, their product, and a rounding.
fn row_errors(values: &Values, worst: &dyn Fn(&str) -> f64) -> [f64; 3] {
    let switches = Switches::new(values);
    let (unit, rounding) = (unit_error(values, worst), vector_rounding(values));
    match (switches.faceted, switches.orthonormal) {
        (false, true) => [longest() * unit + rounding, unit, 0.0],
        (false, false) => {
            let length = length_error(values, worst);
            let share = (1.0 + length) * (1.0 + direction_error(values)) - 1.0;
            let b = longest() * share + 2.0 * (1.0 + share) * rounding + rounding;
            [unit, b, 0.0]
        }
        (true, true) => [unit, 2.0 * unit + unit * unit + rounding, unit],
        (true, false) => [unit; 3],
    }
}

/// Length of the error of a vector in texture space: the rows' times the longest vector, and a
/// rounding.
fn mapped_error(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let rows = row_errors(values, worst).iter().map(|error| error * error).sum::<f64>().sqrt();
    let longest = 3f64.sqrt() * libm::exp2(values.bits("vector_int_bits").into());
    let ulp = 2f64.powi(-cast::signed_count(values.bits("out_frac_bits")));
    rows * longest + 3f64.sqrt() * rounding_ulp(values) * ulp
}

/// `a b - c d` with one rounding or two, whatever cancels; 0 only where it is 0.
fn difference<F: Real>([a, b]: [F; 2], [c, d]: [F; 2]) -> F {
    let product = c * d;
    let lost = (-c).mul_add(d, product);
    a.mul_add(b, -product) + lost
}

/// `u x v`, likewise.
fn golden_cross<F: Real>(u: [F; 3], v: [F; 3]) -> [F; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference([u[i], v[j]], [u[j], v[i]]))
}

/// The golden model. In an `f64` differences of coordinates, and of two products of such, are exact for
/// words of up to 24 bits; N x T is good to two roundings.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let switches = Switches::new(values);
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let (zero, one) = (F::zero(), F::one());
        let flag = |holds: bool| if holds { one } else { zero };
        let is_zero = |v: [F; 3]| v.iter().all(|x| *x == zero);
        let times = |sign: F, v: [F; 3]| v.map(|x| sign * x);
        let first_vector = if switches.faceted { 15 } else { 18 };
        for i in 0..inputs[0].len() {
            let vector = |at: usize| [0, 1, 2].map(|axis| inputs[at + axis][i]);
            let minus = |to: [F; 3], from: [F; 3]| [0, 1, 2].map(|axis| to[axis] - from[axis]);
            let (e1, e2) = (minus(vector(3), vector(0)), minus(vector(6), vector(0)));
            let [du1, dv1] = [0, 1].map(|axis| inputs[11 + axis][i] - inputs[9 + axis][i]);
            let [du2, dv2] = [0, 1].map(|axis| inputs[13 + axis][i] - inputs[9 + axis][i]);
            let det = difference([du1, dv2], [du2, dv1]);
            // dP/du and dP/dv times det.
            let mut by_u = [0, 1, 2].map(|axis| difference([dv2, e1[axis]], [dv1, e2[axis]]));
            let mut by_v = [0, 1, 2].map(|axis| difference([du1, e2[axis]], [du2, e1[axis]]));
            let mut area = golden_cross(e1, e2);
            let (mirrored, zero_uv, zero_area) = (det < zero, det == zero, is_zero(area));
            let mut degenerate = zero_uv || zero_area;
            let mut parallel = false;
            let sign = |degenerate: bool| if mirrored && !degenerate { -one } else { one };
            let rows = if switches.faceted {
                if zero_area {
                    by_u = [one, zero, zero];
                    by_v = [zero, one, zero];
                    area = [zero, zero, one];
                } else if zero_uv {
                    (by_u, by_v) = (e1, e2);
                }
                let sign = sign(degenerate);
                let (outward, dp_du) = (golden_unit(area), times(sign, golden_unit(by_u)));
                // dP/dv, or what of it is at right angles to dP/du: outward x dP/du is on its side where
                // dP/du, dP/dv and outward are right-handed.
                let dp_dv = if switches.orthonormal {
                    times(sign, golden_cross(outward, dp_du))
                } else {
                    times(sign, golden_unit(by_v))
                };
                // dP/du x dP/dv is e1 x e2 over det.
                let product = times(sign, outward);
                match switches.mirror {
                    Mirror::Handed => [dp_du, dp_dv, times(sign, product)],
                    Mirror::Printed => [times(sign, dp_du), dp_dv, times(sign, product)],
                    Mirror::Off => [dp_du, dp_dv, product],
                }
            } else {
                let n = vector(15);
                let mut product = golden_cross(n, by_u);
                parallel = is_zero(product);
                degenerate |= parallel;
                if degenerate {
                    let along_x = n[0].abs() > n[1].abs();
                    by_u = if along_x { [zero, one, zero] } else { [one, zero, zero] };
                    product = golden_cross(n, by_u);
                }
                let sign = sign(degenerate);
                let (dp_du, n_cross) = if switches.orthonormal {
                    let unit = golden_unit(product);
                    (golden_cross(unit, n), unit)
                } else {
                    let length = by_u.iter().fold(zero, |sum, x| sum + *x * *x).sqrt();
                    (golden_unit(by_u), product.map(|x| x / length))
                };
                let (dp_du, n_cross) = (times(sign, dp_du), times(sign, n_cross)); // N x dP/du
                match switches.mirror {
                    Mirror::Handed => [dp_du, times(sign, n_cross), n],
                    Mirror::Printed => [times(sign, dp_du), times(sign, n_cross), n],
                    Mirror::Off => [dp_du, n_cross, n],
                }
            };
            let mut at = 0;
            let mut put = |x: F| {
                outputs[at][i] = x;
                at += 1;
            };
            rows.iter().flatten().for_each(|x| put(*x));
            for k in 0..=switches.lights {
                let v = vector(first_vector + 3 * k);
                rows.iter().for_each(|row| put(row[0] * v[0] + row[1] * v[1] + row[2] * v[2]));
            }
            [mirrored, degenerate, zero_uv, zero_area]
                .into_iter()
                .for_each(|holds| put(flag(holds)));
            if !switches.faceted {
                put(flag(parallel));
            }
        }
    })
}

/// A triangle and what goes with its vertex, as real numbers.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    p: [DVec3; 3],
    uv: [DVec2; 3],
    normal: DVec3,
    view: DVec3,
    lights: [DVec3; 8],
}

impl Triangle {
    /// All numbers, each at the place that [`Triangle::place`] tells.
    fn numbers(&self) -> [f64; 45] {
        let mut all = [0.0; 45];
        let vectors = self.p.iter().chain([&self.normal, &self.view]).chain(&self.lights);
        for (to, vector) in all.chunks_exact_mut(3).zip(vectors) {
            to.copy_from_slice(&vector.to_array());
        }
        for (to, uv) in all[39..].chunks_exact_mut(2).zip(&self.uv) {
            to.copy_from_slice(&uv.to_array());
        }
        all
    }

    /// Where the number of an input port is.
    fn place(port: &str) -> usize {
        let (name, axis) = port.rsplit_once('_').expect("bug: a component");
        let axis = ["x", "y", "z", "u", "v"].iter().position(|known| *known == axis);
        let axis = axis.expect("bug: an axis");
        let number = |prefix: &str| -> Option<usize> { name.strip_prefix(prefix)?.parse().ok() };
        if let Some(k) = number("uv") {
            return 39 + 2 * k + axis - 3;
        }
        let vector = match (name, number("p"), number("light")) {
            ("normal", ..) => 3,
            ("view", ..) => 4,
            (_, Some(k), _) => k,
            (_, _, Some(k)) => 5 + k,
            _ => panic!("bug: no port `{port}`"),
        };
        3 * vector + axis
    }

    /// A random one: positions and texture coordinates each over eight octaves of scale, anywhere that
    /// they fit; half of the textures are mirrored. With `lit` no angle is below 30°, in space and in the
    /// texture, the normal is no more than 45° off the face's, and view and lights are on its side, ⅛ to 1 of
    /// the longest along an axis; else corners and normal are anywhere, and so are view and lights, of any word.
    /// `limits` are those of positions, texture coordinates and vectors.
    fn random(limits: [f64; 3], lit: bool, uniform: &mut Uniform) -> Self {
        let mut sphere = || {
            let (z, turns) = (1.0 - 2.0 * uniform.draw(), uniform.draw());
            let (sin, cos) = sin_cos_turns(turns);
            let across = (1.0 - z * z).sqrt();
            DVec3::new(across * cos, across * sin, z)
        };
        let (axis, normal, aside) = (sphere(), sphere(), sphere());
        let (corners, directions) = ([(); 3].map(|()| sphere()), [(); 9].map(|()| sphere()));
        let mut within = |low: f64, high: f64| low + (high - low) * uniform.draw();
        // Corners on a circle, a third of a turn apart but for a twelfth: arcs are a sixth or more.
        let mut circle = |sign: f64| {
            let first = within(0.0, 1.0);
            [0.0, 1.0, 2.0].map(|k| {
                let turns = sign * (first + k / 3.0 + within(-1.0, 1.0) / 12.0);
                let (sin, cos) = sin_cos_turns(turns);
                DVec2::new(cos, sin)
            })
        };
        let (flat, regular) = (circle(1.0), circle(1.0));
        let mirror = if uniform.draw() < 0.5 { -1.0 } else { 1.0 };
        let mut within = |low: f64, high: f64| low + (high - low) * uniform.draw();
        // Half the range for the size, half for the place.
        let [size, uv_size] =
            [limits[0], limits[1]].map(|limit| 0.5 * limit * libm::exp2(within(-8.0, 0.0)));
        let mut place = |limit: f64| within(-0.5 * limit, 0.5 * limit);
        let center = DVec3::from_array([(); 3].map(|()| place(limits[0])));
        let uv_center = DVec2::from_array([(); 2].map(|()| place(limits[1])));
        let anywhere = [(); 3].map(|()| DVec2::new(place(2.0), place(2.0)));
        let (u, v) = axis.any_orthonormal_pair();
        let p = [0, 1, 2].map(|k| {
            let corner = if lit { u * flat[k].x + v * flat[k].y } else { corners[k] };
            center + corner * size
        });
        let uv = [0, 1, 2].map(|k| {
            let corner = if lit { regular[k] * DVec2::new(mirror, 1.0) } else { anywhere[k] };
            uv_center + corner * uv_size
        });
        let mut vectors = directions.map(|v| {
            // Without `lit` up to the corners of the words' cube, √3 of the longest along an axis away.
            let v = if lit { v } else { [(); 3].map(|()| within(-1.0, 1.0)).into() };
            v * limits[2] * libm::exp2(within(-3.0, 0.0))
        });
        let mut normal = normal;
        if lit {
            let face = (p[1] - p[0]).cross(p[2] - p[0]).normalize_or_zero();
            normal = (face + aside * within(0.0, 0.5f64.sqrt())).normalize_or(face);
            for v in &mut vectors {
                *v = if v.dot(normal) < 0.0 { -*v } else { *v };
            }
        }
        let [view, lights @ ..] = vectors;
        Self { p, uv, normal, view, lights }
    }
}

fn draw(values: &Values, ports: &InputPorts<'_>) -> Draw {
    let range = |name: &str| libm::exp2(values.bits(name).into());
    let limits = ["position_int_bits", "uv_int_bits", "vector_int_bits"].map(range);
    let places: Vec<usize> = ports.names().map(Triangle::place).collect();
    Draw::new(move |sampler, uniform, columns, count| {
        columns.iter_mut().for_each(Vec::clear);
        for _ in 0..count {
            let lit = sampler == Sampler::Lit;
            let numbers = Triangle::random(limits, lit, uniform).numbers();
            for (column, place) in columns.iter_mut().zip(&places) {
                column.push(numbers[*place]);
            }
        }
    })
}

fn hard_cases(netlist: &Netlist) -> Vec<HardCase> {
    let words = |triangle: &Triangle| -> Vec<i64> {
        let numbers = triangle.numbers();
        let word = |(port, id): (usize, &NodeId)| {
            let value = numbers[Triangle::place(netlist.input_name(port))];
            let format = netlist.node(*id).format;
            let word = quantize(value, format, Round::HalfEven, Overflow::Saturate);
            word.expect("bug: triangles are finite").0
        };
        netlist.inputs().iter().enumerate().map(word).collect()
    };
    let found = |name: &str| {
        let port = (0..netlist.inputs().len()).find(|port| netlist.input_name(*port) == name)?;
        Some(netlist.node(netlist.inputs()[port]).format)
    };
    let format = |name: &str| found(name).expect("bug: a port");
    let (position, uv) = (format("p0_x"), format("uv0_u"));
    let (lsb, uv_lsb) = (position.ulp(), uv.ulp());
    let (span, uv_span) = (-position.value(position.min_raw()), -uv.value(uv.min_raw()));
    let cases = |name, list: Vec<Triangle>| HardCase::new(name, list.iter().map(words).collect());
    let two = |u: f64, v: f64| DVec2::new(u, v);
    let corners = |e1: DVec3, e2: DVec3| {
        let p0 = DVec3::new(-0.25, 0.125, 0.0625) * span;
        [p0, p0 + e1, p0 + e2]
    };
    let unit = 0.25 * span; // a usual edge
    let (e1, e2) = (DVec3::new(0.96, 0.28, 0.0) * unit, DVec3::new(-0.28, 0.768, 0.576) * unit);
    let normal = e1.cross(e2).normalize();
    let usual = Triangle {
        p: corners(e1, e2),
        uv: [two(0.125, 0.25), two(0.625, 0.25), two(0.125, 0.75)].map(|at| at * uv_span),
        normal: (normal + DVec3::new(0.125, -0.25, 0.0625)).normalize(),
        view: DVec3::new(0.48, -0.36, 0.8),
        lights: [DVec3::new(0.6, 0.64, 0.48); 8],
    };
    let textures =
        |list: Vec<[DVec2; 3]>| list.into_iter().map(|uv| Triangle { uv, ..usual }).collect();
    let shapes = |list: Vec<(DVec3, DVec3)>| {
        list.into_iter().map(|(e1, e2)| Triangle { p: corners(e1, e2), ..usual }).collect()
    };
    let [uv0, uv1, uv2] = usual.uv;
    let mirror = |uv: [DVec2; 3], u: f64, v: f64| uv.map(|at| at * two(u, v));
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let normals = |list: Vec<DVec3>| -> Vec<Triangle> {
        list.into_iter().map(|normal| Triangle { normal, ..usual }).collect()
    };
    // dP/du along e1: exact in words where the edge is along an axis.
    let along = |axis: usize| Triangle {
        p: corners(axes[axis] * unit, axes[(axis + 1) % 3] * unit),
        normal: axes[(axis + 2) % 3],
        ..usual
    };
    let seam = |u: [f64; 3]| [two(u[0], 0.2), two(u[1], 0.2), two(u[2], 0.4)];
    let mut list = vec![
        cases("mirrored texture, along u, v, both, and turned", {
            let turned = usual.uv.map(|at| two(at.y, at.x));
            let list = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
            let mut list: Vec<[DVec2; 3]> = list.map(|(u, v)| mirror(usual.uv, u, v)).to_vec();
            list.extend([turned, [uv0, uv2, uv1], [uv1, uv0, uv2]]);
            textures(list)
        }),
        cases("determinant of the texture one LSB from 0, either side, and 0 there", {
            // (k, 1) and (k + 1, 1): -1; with the edges exchanged 1.
            let near = |k: f64| {
                let edges = [two(k, 1.0), two(k + 1.0, 1.0)].map(|edge| uv0 + edge * uv_lsb);
                [[uv0, edges[0], edges[1]], [uv0, edges[1], edges[0]], [uv0, edges[0], edges[0]]]
            };
            // (k, k - 1) and (k + 1, k): 1, both long.
            let long = |k: f64| {
                let edges = [two(k, k - 1.0), two(k + 1.0, k)].map(|edge| uv0 + edge * uv_lsb);
                [[uv0, edges[0], edges[1]], [uv0, edges[1], edges[0]]]
            };
            let most = (0.5 * uv_span / uv_lsb).floor();
            let mut list: Vec<[DVec2; 3]> =
                [0.0, 1.0, 100.0, most].into_iter().flat_map(near).collect();
            list.extend([2.0, 100.0, most].into_iter().flat_map(long));
            textures(list)
        }),
        cases("zero area of the texture", {
            textures(vec![
                [uv0; 3],
                [uv0, uv1, uv1],
                [uv0, uv0, uv1],
                [uv0, uv1, uv0],
                [uv0, uv1, uv0 * 2.0 - uv1],
                [two(0.0, 0.0), two(1.0, 1.0) * 0.25 * uv_span, two(1.0, 1.0) * 0.5 * uv_span],
            ])
        }),
        cases("a seam of the texture", {
            textures(vec![
                seam([0.99, 0.01, 0.99]),
                seam([0.01, 0.99, 0.01]),
                seam([0.99, 0.01, 0.01]),
                seam([0.99, 1.01, 0.99]),
            ])
        }),
        cases("slivers of aspect 1:10^4", {
            let thin = 1e-4 * 2.0;
            shapes(vec![
                (e1 * 2.0, e2 * thin),
                (e1 * thin, e2 * 2.0),
                (e1 * 2.0, e1 * 2.0 + e2 * thin),
                (e1 * 2.0, e1 * -1.0 + e2 * thin),
                (e1 * 2.0, DVec3::Z * lsb),
                (DVec3::X * span, DVec3::X * (span - lsb) + DVec3::Y * lsb),
            ])
        }),
        cases("repeated vertices and triangles without area", {
            shapes(vec![
                (DVec3::ZERO, DVec3::ZERO),
                (e1, e1),
                (DVec3::ZERO, e2),
                (e1, DVec3::ZERO),
                (DVec3::X * unit, DVec3::X * unit * -0.5),
                (DVec3::ONE * 4.0 * lsb, DVec3::ONE * 8.0 * lsb),
            ])
        }),
        cases("both without area", {
            vec![
                Triangle { p: corners(e1, e1), uv: [uv0, uv1, uv1], ..usual },
                Triangle { p: corners(DVec3::ZERO, DVec3::ZERO), uv: [uv0; 3], ..usual },
            ]
        }),
        cases("triangles of one LSB", {
            let p = usual.p[0];
            let small = axes.iter().flat_map(|e1| axes.iter().map(move |e2| (*e1, *e2)));
            small
                .flat_map(|(e1, e2)| {
                    let small = [uv0, uv0 + two(uv_lsb, 0.0), uv0 + two(0.0, uv_lsb)];
                    let p = [p, p + e1 * lsb, p + e2 * lsb];
                    [Triangle { p, ..usual }, Triangle { p, uv: small, ..usual }]
                })
                .collect()
        }),
        cases("the longest edges", {
            let far = 1e9; // past every position
            let ends = |bits: usize| {
                DVec3::from_array([0, 1, 2].map(|i| if bits >> i & 1 == 0 { -far } else { far }))
            };
            let uv_ends = |bits: usize| {
                two(if bits & 1 == 0 { -far } else { far }, if bits & 2 == 0 { -far } else { far })
            };
            [[0, 7, 1], [7, 0, 4], [0, 3, 5], [1, 6, 2], [5, 2, 0], [0, 1, 2]]
                .into_iter()
                .flat_map(|of| {
                    let p = of.map(ends);
                    [[0, 1, 2], [3, 0, 1], [0, 3, 2]].map(|uv| Triangle {
                        p,
                        uv: uv.map(uv_ends),
                        normal: DVec3::Z,
                        ..usual
                    })
                })
                .collect()
        }),
        cases("positions and textures over eight octaves of scale", {
            (0..=8)
                .flat_map(|octave| {
                    let scale = libm::exp2((-octave).into());
                    let uv = [uv0, uv0 + (uv1 - uv0) * scale, uv0 + (uv2 - uv0) * scale];
                    let p = corners(e1 * scale, e2 * scale);
                    [Triangle { p, ..usual }, Triangle { uv, ..usual }, Triangle { p, uv, ..usual }]
                })
                .collect()
        }),
        cases("view and light 0, of one LSB, and longest", {
            let lsb = format("view_x").ulp();
            let list = [DVec3::ZERO, DVec3::X * lsb, DVec3::ONE * 1e9, DVec3::ONE * -1e9];
            let list = list.into_iter().chain(axes.map(|axis| axis * -1e9));
            list.map(|v| Triangle { view: v, lights: [-v; 8], ..usual }).collect()
        }),
        cases("the longest view and light along T, B or N, and 0.47 of both others", {
            let corner = DVec3::ONE;
            (0..3)
                .flat_map(|row| [(row, 0.0), (row, 0.47f64)])
                .flat_map(|(row, aside)| {
                    // The mirror between the corner and what it is in texture space.
                    let mut mapped = DVec3::splat(aside);
                    mapped[row] = (3.0 - 2.0 * aside * aside).sqrt();
                    let across = (corner - mapped).normalize();
                    let [t, normal] = [DVec3::X, DVec3::Z].map(|v| v.reflect(across));
                    [1e9, -1e9].map(|far| Triangle {
                        p: corners(t * unit, normal.cross(t) * unit),
                        normal,
                        view: corner * far,
                        lights: [corner * -far; 8],
                        ..usual
                    })
                })
                .collect()
        }),
    ];
    let Some(normal_format) = found("normal_x") else { return list };
    let normal_lsb = normal_format.ulp();
    list.extend([
        cases("T parallel to N", {
            (0..3)
                .flat_map(|axis| {
                    [1.0, -1.0].map(|sign| Triangle { normal: axes[axis] * sign, ..along(axis) })
                })
                .collect()
        }),
        cases("T parallel to N but for one LSB", {
            (0..3)
                .flat_map(|axis| {
                    [1, 2].into_iter().flat_map(move |aside| {
                        [1.0, -1.0].map(|sign| Triangle {
                            normal: axes[axis] + axes[(axis + aside) % 3] * sign * normal_lsb,
                            ..along(axis)
                        })
                    })
                })
                .collect()
        }),
        cases("T parallel to N but for one LSB of an edge", {
            (0..3)
                .map(|axis| {
                    let aside = axes[(axis + 1) % 3] * lsb;
                    let p = corners(axes[axis] * unit + aside, axes[(axis + 2) % 3] * unit);
                    Triangle { p, normal: axes[axis], ..along(axis) }
                })
                .collect()
        }),
        cases("N 0, along axes, longest, inward, or at right angles to the face", {
            let mut list =
                normals(vec![DVec3::ZERO, DVec3::splat(1e9), DVec3::splat(-1e9), -normal]);
            list.extend(normals(axes.into_iter().flat_map(|axis| [axis, -axis]).collect()));
            list.extend(normals(vec![e1.normalize(), e2.normalize()]));
            list
        }),
        cases("N 0 or along axes without a frame", {
            let uv = [uv0; 3];
            let list =
                [DVec3::ZERO, DVec3::ONE, DVec3::new(1.0, -1.0, 0.0), DVec3::new(-1.0, 0.5, 0.0)];
            let list = list.into_iter().chain(axes.into_iter().flat_map(|axis| [axis, -axis]));
            list.map(|normal| Triangle { normal, uv, ..usual }).collect()
        }),
    ]);
    list
}
