//! The emboss unit: displaced texture coordinates of a vertex, as two published designs have them.
//!
//! - `setting=gx`, seeds 000 and 003 (US 6,980,218 and 7,307,640): T and B of the model by a 3×3
//!   matrix, L from the vertex to the light, `(S1, T1) = (S0, T0) + (T·L, B·L)/|L|`. This sign of L departs from the
//!   patents: their table prints L = V - L_p, from the light to the vertex (`l_sign=vertex-light`), which displaces
//!   away from the light, so that the displaced height less the undisplaced one is bright toward the light. Here the
//!   default displaces toward it, and the difference is the other way round. The matrix may
//!   scale, which sets the strength, so T and B are not normalised. The normal isn't used. Here s goes
//!   with T and t with B; in that console's own API the vector of s is the *second* of a vertex's
//!   N, B, T, so that one is what port `tangent` takes.
//! - `setting=nv`, seed 002 (`GL_NV_texgen_emboss`): T and BN of [`super::basis`],
//!   `Es = PCTs + Ks (L·BN)/|L| PCTq, Et = PCTt - Kt (L·T)/|L| PCTq`; r and q pass. L points to the light, and CT
//!   along growing t; then BN = N × CT points against growing s, and both displacements lead away from the light.
//!
//! Parameters `light`, `source` and `destination` say which light and which coordinates the ports stand for, as
//! `fixpath texgen` tells a configuration; no word depends on them.
//!
//! Every difference between them is a switch that a setting sets and a user may set otherwise.
//!
//! L is a difference of positions, exact, and then block-normalised: its largest component is shifted
//! up to the top of its word, the others with it, and the shift is never undone, as the result
//! doesn't depend on it. So the direction of a light 2^-6 away keeps as many bits as one 2^10 away.
//! Where L is 0, nothing is displaced; a vector of length 0 that is normalised displaces nothing. Either sets
//! `degenerate`.

use super::basis::{
    component, component_bits, dot_frac_bits, frame, golden_frame, golden_unit, guard_bits,
    longest, rounded, unit_error, vector_frac_bits, vector_rounding,
};
use super::dot::{dot, ended_at, ending_overflow, ends, vector_ports};
use super::normalise::{Block, block, direction_error, narrowed, norm_bits, unit_vector};
use super::parts::plan::{number, rounding_ulp};
use super::rsqrt::{Root, length_error, root_addr_bits, root_frac_bits, root_scheme};
use super::vertex::{draw, hard_cases};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Golden, Group, HardCase, Param, Role, Scale, Shape, Unit, Values,
};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::number::trig::Real;
use crate::schedule::{Binding, BoundOperation, BoundUnit, Kind as Shared};

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("emboss", "texture coordinates displaced by the direction of a light, for embossing")
        .source("seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)")
        .params([
            Param::choice("setting", ["gx", "nv"])
                .role(Role::Pipeline)
                .help("what every switch that is auto stands at"),
            Param::choice("frame", ["auto", "matrix", "normal", "given"])
                .help("T and B by the matrix (gx), from N and CT (nv), or as they are"),
            Param::choice("normalise_basis", ["auto", "off", "on"])
                .help("T and B (of N x CT: B) over their lengths (gx: off; nv: on)"),
            Param::choice("s_vector", ["auto", "tangent", "binormal"])
                .help("the vector that displaces s (gx: tangent; nv: binormal); the other one displaces t"),
            Param::choice("l_sign", ["light-vertex", "vertex-light"])
                .help("L = light - vertex, or as the patents print it (from the light to the vertex), from which the default departs; turns what looks raised"),
            Param::choice("t_sign", ["auto", "plus", "minus"])
                .help("sign of the displacement of t (gx: plus; nv: minus)"),
            Param::choice("scale_q", ["auto", "off", "on"])
                .help("displacements times q (gx: off; nv: on)"),
            Param::choice("constants", ["auto", "off", "parameters", "ports"])
                .help("displacements times Ks and Kt (gx: off; nv: parameters)"),
            Param::real("ks", -MAX_CONSTANT..=MAX_CONSTANT)
                .default(1)
                .help("Ks, any number that its format holds (constants=parameters)"),
            Param::real("kt", -MAX_CONSTANT..=MAX_CONSTANT)
                .default(1)
                .help("Kt, any number that its format holds (constants=parameters)"),
            Param::flag("input20")
                .help("light and matrix come as floats of 20 bits: 12 significant bits, toward zero"),
            component_bits(),
            Param::bits("matrix_bits", 2..=24)
                .default(16)
                .help("bits of the matrix, signed (frame=matrix)"),
            Param::bits("matrix_int_bits", 0..=6)
                .default(2)
                .help("it is from -2^matrix_int_bits to 2^matrix_int_bits (frame=matrix)"),
            Param::bits("position_bits", 2..=30).default(28).help("bits of positions, signed"),
            Param::bits("position_frac_bits", 0..=28)
                .default(15)
                .help("fraction bits of positions"),
            guard_bits(),
            norm_bits(),
            dot_frac_bits(),
            root_scheme(),
            root_addr_bits(),
            root_frac_bits(),
            Param::bits("constant_int_bits", 0..=MAX_CONSTANT_INT_BITS)
                .auto("as many as ks and kt ask for, each of them, 1 at least")
                .help("Ks and Kt are from -2^constant_int_bits to 2^constant_int_bits"),
            Param::bits("constant_frac_bits", 2..=24)
                .auto("20, and fewer with more than 6 whole bits, 26 of both")
                .help("fraction bits of Ks and Kt, and of their products with q"),
            Param::bits("texture_int_bits", 0..=8)
                .default(6)
                .help("texture coordinates are from -2^texture_int_bits to 2^texture_int_bits"),
            Param::bits("texture_frac_bits", 2..=24)
                .default(18)
                .help("fraction bits of texture coordinates and displacements"),
            ending_overflow().help("overflow of s1 and t1; with the first two the golden ends where they do"),
            Param::rounding("rounding"),
            Param::int("texture_size", 1..=65_536)
                .role(Role::MapSize)
                .default(256)
                .help("texels along the texture: only for errors in texels"),
            Param::int("light", 0..=31)
                .role(Role::Label)
                .help("the light that port `light` is the place of: only told"),
            Param::int("source", 0..=31)
                .role(Role::Label)
                .help("the coordinate (gx) or texture unit (nv) that s0 and t0 are of: only told"),
            Param::int("destination", 0..=31)
                .role(Role::Label)
                .default(1)
                .help("the coordinate (gx) or texture unit (nv) that s1 and t1 are of: only told"),
        ])
        .inputs("light_x … light_z, vertex_x … vertex_z: light and vertex in eye space; s0, t0: texture coordinates; \
             with frame=matrix m0_x … m2_z: rows of the model-view matrix, tangent_x … binormal_z: T and B of the model; \
             with frame=normal normal_x … ct_z: N and CT in eye space; with frame=given tangent_x … binormal_z there; \
             with scale_q=on q0, r0; with constants=ports ks, kt")
        .outputs("ds, dt: displacements; s1, t1: displaced coordinates; degenerate: 1 where L (or a vector that is normalised) \
              is 0, which displaces nothing; with scale_q=on q1, r1, passed")
        .design(design)
}

/// Most whole bits of Ks and Kt.
const MAX_CONSTANT_INT_BITS: u32 = 17;
/// Ks and Kt are this at most, so that each of them has a format that holds it.
const MAX_CONSTANT: f64 = 65_536.0;
/// Fraction bits of Ks and Kt with few whole bits, and the most that both kinds are together: then products with q
/// and with a displacement fit words.
const CONSTANT_FRAC_BITS: u32 = 20;
const CONSTANT_BITS: u32 = 26;

/// Where T and B come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Frame {
    Matrix,
    Normal,
    Given,
}

/// Where Ks and Kt come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Constants {
    Off,
    Parameters,
    Ports,
}

/// The switches, with what the setting says for those that are `auto`.
#[derive(Clone, Copy, Debug)]
struct Switches {
    frame: Frame,
    normalise: bool,
    s_is_binormal: bool,
    vertex_light: bool,
    minus_t: bool,
    q: bool,
    constants: Constants,
}

impl Switches {
    fn new(values: &Values) -> Self {
        let nv = values.choice("setting") == "nv";
        let of = |name, gx, of_nv| match values.choice(name) {
            "auto" if nv => of_nv,
            "auto" => gx,
            given => given,
        };
        Self {
            frame: match of("frame", "matrix", "normal") {
                "matrix" => Frame::Matrix,
                "normal" => Frame::Normal,
                _ => Frame::Given,
            },
            normalise: of("normalise_basis", "off", "on") == "on",
            s_is_binormal: of("s_vector", "tangent", "binormal") == "binormal",
            vertex_light: values.choice("l_sign") == "vertex-light",
            minus_t: of("t_sign", "plus", "minus") == "minus",
            q: of("scale_q", "off", "on") == "on",
            constants: match of("constants", "off", "parameters") {
                "off" => Constants::Off,
                "parameters" => Constants::Parameters,
                _ => Constants::Ports,
            },
        }
    }

    /// True if the datapath is that of seed 000, whose schedule is printed.
    fn is_printed(self) -> bool {
        let as_printed = self.frame == Frame::Matrix && !self.normalise && !self.s_is_binormal;
        as_printed && !self.minus_t && !self.has_factor()
    }

    /// True if displacements have a factor.
    fn has_factor(self) -> bool {
        self.q || self.constants != Constants::Off
    }

    /// Names of the input ports in order, those of a vector by their common part.
    fn ports(self) -> Vec<&'static str> {
        let mut names = match self.frame {
            Frame::Matrix => vec!["m0", "m1", "m2", "tangent", "binormal"],
            Frame::Normal => vec!["normal", "ct"],
            Frame::Given => vec!["tangent", "binormal"],
        };
        names.extend(["light", "vertex", "s0", "t0"]);
        if self.q {
            names.extend(["q0", "r0"]);
        }
        if self.constants == Constants::Ports {
            names.extend(["ks", "kt"]);
        }
        names
    }
}

/// True if the port of this name is a vector.
fn is_vector(name: &str) -> bool {
    !["s0", "t0", "q0", "r0", "ks", "kt"].contains(&name)
}

/// Input ports by name.
struct Ports(Vec<(&'static str, Vec<NodeId>)>);

impl Ports {
    fn new(b: &mut Builder, values: &Values, switches: Switches) -> Result<Self> {
        let short = if values.flag("input20") { Quantity::Float20 } else { Quantity::Number };
        let component = component(values)?;
        let position = super::dot::signed(values, "position_bits", "position_frac_bits")?;
        let (matrix_bits, matrix_int) =
            (values.bits("matrix_bits"), values.bits("matrix_int_bits"));
        let matrix_frac = cast::signed_count(matrix_bits) - cast::signed_count(matrix_int) - 1;
        let matrix = Format::signed(matrix_bits, matrix_frac)?;
        let texture = texture(values)?;
        let [ks, kt] = [constant(values, switches, "ks")?, constant(values, switches, "kt")?];
        let port = |name: &'static str| {
            let (format, quantity) = match name {
                "m0" | "m1" | "m2" => (matrix, short),
                "light" => (position, short),
                "vertex" => (position, Quantity::Number),
                "s0" | "t0" | "q0" | "r0" => (texture, Quantity::Number),
                "ks" => (ks, Quantity::Number),
                "kt" => (kt, Quantity::Number),
                _ => (component, Quantity::Number),
            };
            let nodes = if is_vector(name) {
                vector_ports(b, name, format, quantity).to_vec()
            } else {
                vec![b.input(name, format, quantity)]
            };
            (name, nodes)
        };
        Ok(Self(switches.ports().into_iter().map(port).collect()))
    }

    fn nodes(&self, name: &str) -> &[NodeId] {
        &self.0.iter().find(|(known, _)| *known == name).expect("bug: a port of this setting").1
    }

    fn vector(&self, name: &str) -> [NodeId; 3] {
        self.nodes(name).try_into().expect("bug: a vector")
    }

    fn number(&self, name: &str) -> NodeId {
        self.nodes(name)[0]
    }
}

/// Format of texture coordinates.
fn texture(values: &Values) -> Result<Format> {
    number(values.bits("texture_int_bits"), values.bits("texture_frac_bits"))
}

/// Format of Ks or Kt, by its name: each has whole bits, and so fraction bits, of its own where that is `auto`.
///
/// # Errors
/// If it doesn't hold the constant; the message names the one that does.
fn constant(values: &Values, switches: Switches, name: &str) -> Result<Format> {
    let format = |int_bits: u32| {
        let few = CONSTANT_FRAC_BITS.min(CONSTANT_BITS.saturating_sub(int_bits));
        let frac_bits = values.int("constant_frac_bits");
        let frac_bits = frac_bits.map_or(few, |_| values.bits("constant_frac_bits"));
        number(int_bits, frac_bits)
    };
    let is_held = |format: Format| {
        switches.constants != Constants::Parameters
            || quantize(values.real(name), format, Round::HalfEven, Overflow::Error).is_ok()
    };
    let enough = |bits: &u32| format(*bits).is_ok_and(is_held);
    let asked = (1..=MAX_CONSTANT_INT_BITS).find(enough).unwrap_or(MAX_CONSTANT_INT_BITS);
    let int_bits = match values.int("constant_int_bits") {
        Some(_) => values.bits("constant_int_bits"),
        None => asked,
    };
    let format = format(int_bits)?;
    if !is_held(format) {
        return Err(values.refuse(
            name,
            &format!(
                "{} to {} in format {format} of constant_int_bits={int_bits}; constant_int_bits={asked} holds it",
                cast::f64_of(format.min_raw()) * format.ulp(),
                cast::f64_of(format.max_raw()) * format.ulp(),
            ),
        ));
    }
    Ok(format)
}

fn design(values: &Values) -> Result<Design> {
    let switches = Switches::new(values);
    let mut b = values.builder("emboss");
    let ports = Ports::new(&mut b, values, switches)?;
    let mut root = Root::new(values);
    let round = root.round;
    let (t, binormal, flags) = basis(&mut b, &mut root, &ports, switches)?;

    let (to, from) = if switches.vertex_light { ("vertex", "light") } else { ("light", "vertex") };
    let (to, from) = (ports.vector(to), ports.vector(from));
    let l = [0, 1, 2].map(|i| {
        let difference = b.sub(to[i], from[i]);
        b.name(difference, ["l_x", "l_y", "l_z"][i])
    });
    let Block { words, zero, .. } = block(&mut b, "l_block", l);
    let l = narrowed(&mut b, "l_norm", words, root.norm_bits, round);

    let frac_bits = cast::signed_count(values.bits("dot_frac_bits"));
    let t_dot_l = dot(&mut b, "t_dot_l", t, l);
    let t_dot_l = rounded(&mut b, t_dot_l, frac_bits, round);
    b.name(t_dot_l, "t_l");
    let l_dot_l = dot(&mut b, "l_dot_l", l, l);
    let reciprocal = root.of_square(&mut b, "reciprocal_length", l_dot_l)?;
    let b_dot_l = dot(&mut b, "b_dot_l", binormal, l);
    let b_dot_l = rounded(&mut b, b_dot_l, frac_bits, round);
    b.name(b_dot_l, "b_l");

    let (of_s, of_t) = if switches.s_is_binormal {
        ((b_dot_l, binormal), (t_dot_l, t))
    } else {
        ((t_dot_l, t), (b_dot_l, binormal))
    };
    let overflow = values.overflow("overflow");
    let mut sums = Vec::new();
    for (axis, (dot, vector), minus) in [('s', of_s, false), ('t', of_t, switches.minus_t)] {
        let vector_int = b.format(vector[0]).int_bits();
        let displacement = displacement(
            &mut b,
            values,
            switches,
            &ports,
            Factors { axis, dot, reciprocal, vector_int, minus },
        )?;
        b.output(&format!("d{axis}"), displacement);
        let sum = b.add(ports.number(&format!("{axis}0")), displacement);
        b.name(sum, &format!("{axis}1_sum"));
        let name = format!("{axis}1");
        let coordinate = b.narrow(sum, texture(values)?, round, overflow);
        b.name(coordinate, &name);
        sums.push((name, coordinate));
    }
    for (name, sum) in sums {
        b.output(&name, sum);
    }
    let degenerate = flags.into_iter().fold(zero, |any, flag| b.or(any, flag));
    b.output("degenerate", degenerate);
    if switches.q {
        b.output("q1", ports.number("q0"));
        b.output("r1", ports.number("r0"));
    }
    let tabulated = root.tabulated;
    let netlist = b.build()?;
    let mut names = vec!["ds", "dt", "s1", "t1", "degenerate"];
    if switches.q {
        names.extend(["q1", "r1"]);
    }
    let mut groups = Group::ports(&netlist, &names)?;
    for group in &mut groups[..2] {
        let what = "the vector's length times its factor, each 1/4 where it is less";
        let scales = vec![Scale::new("relative", what)];
        group.shape = Shape::Scaled { scales, texels: Some(values.bits("texture_size")) };
    }
    let mut hard = hard_cases(&netlist);
    hard.extend(HardCase::extremes(&netlist));
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(draw)
        .hard(hard)
        .bounds(bounds(values, switches))
        .tabulated(tabulated)
        .binding(switches.is_printed().then(|| figure_8(switches))))
}

/// T and B in eye space, with a flag for each that is normalised: of a vector 0.
fn basis(
    b: &mut Builder,
    root: &mut Root<'_>,
    ports: &Ports,
    switches: Switches,
) -> Result<([NodeId; 3], [NodeId; 3], Vec<NodeId>)> {
    if switches.frame == Frame::Normal {
        let vectors = [ports.vector("normal"), ports.vector("ct")];
        let (t, bn, zero) = frame(b, root, vectors, switches.normalise)?;
        return Ok((t, bn, zero.into_iter().collect()));
    }
    let frac_bits = vector_frac_bits(root.values);
    let mut flags = Vec::new();
    let mut vectors = Vec::new();
    for (port, name) in [("tangent", "t"), ("binormal", "b")] {
        let v = ports.vector(port);
        let exact = if switches.frame == Frame::Matrix {
            let rows = [("m0", "x"), ("m1", "y"), ("m2", "z")];
            rows.map(|(row, axis)| dot(b, &format!("{name}_{axis}"), ports.vector(row), v))
        } else {
            v
        };
        let vector = if switches.normalise {
            // -2 to 2: 1 has a code.
            let format = Format::signed((frac_bits + 2).unsigned_abs(), frac_bits)?;
            let (unit, zero) = unit_vector(b, root, name, exact, format)?;
            flags.push(zero);
            unit
        } else {
            exact.map(|x| rounded(b, x, frac_bits, root.round))
        };
        if switches.frame == Frame::Matrix {
            for (word, axis) in vector.iter().zip(["x", "y", "z"]) {
                b.name(*word, &format!("{name}_eye_{axis}"));
            }
        }
        vectors.push(vector);
    }
    Ok((vectors[0], vectors[1], flags))
}

/// The schedule that seed 000 prints for the hardware of its figure 8: cycles 1 to 19 are the
/// seed's, what follows them comes as early as it can.
fn figure_8(switches: Switches) -> Binding {
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

/// What a displacement is made of.
struct Factors {
    axis: char,
    dot: NodeId,
    reciprocal: NodeId,
    /// Whole bits of the vector's components.
    vector_int: i32,
    minus: bool,
}

/// A displacement: the dot product over |L|, times what else there is.
fn displacement(
    b: &mut Builder,
    values: &Values,
    switches: Switches,
    ports: &Ports,
    factors: Factors,
) -> Result<NodeId> {
    let Factors { axis, dot, reciprocal, vector_int, minus } = factors;
    let round = values.rounding("rounding");
    let frac_bits = cast::signed_count(values.bits("texture_frac_bits"));
    let mut exact = b.mul(dot, reciprocal);
    b.name(exact, &format!("d{axis}_product"));
    // No more than the vector is long, which is below twice its largest component's limit.
    let mut int_bits = vector_int + 1;
    if switches.has_factor() {
        let wide = Format::signed(
            (int_bits + 1 + frac_bits + UNIT_GUARD_BITS).unsigned_abs(),
            frac_bits + UNIT_GUARD_BITS,
        )?;
        let unit = b.narrow(exact, wide, round, Overflow::Saturate);
        b.name(unit, &format!("d{axis}_unit"));
        let factor = factor(b, values, switches, ports, axis)?;
        int_bits += b.format(factor).int_bits();
        exact = b.mul(unit, factor);
    }
    if minus {
        exact = b.neg(exact);
    }
    let format = Format::signed((int_bits + 1 + frac_bits).unsigned_abs(), frac_bits)?;
    let word = b.narrow(exact, format, round, Overflow::Saturate);
    Ok(b.name(word, &format!("d{axis}")))
}

/// Extra fraction bits of a displacement before its factor.
const UNIT_GUARD_BITS: i32 = 2;

/// Ks or Kt, q, or their product.
fn factor(
    b: &mut Builder,
    values: &Values,
    switches: Switches,
    ports: &Ports,
    axis: char,
) -> Result<NodeId> {
    let name = if axis == 's' { "ks" } else { "kt" };
    let format = constant(values, switches, name)?;
    let constant = match switches.constants {
        Constants::Off => None,
        Constants::Ports => Some(ports.number(name)),
        Constants::Parameters => {
            let word = quantize(values.real(name), format, Round::HalfEven, Overflow::Saturate)?;
            Some(b.constant(word.0, format))
        }
    };
    let q = switches.q.then(|| ports.number("q0"));
    Ok(match (constant, q) {
        (Some(constant), Some(q)) => {
            let product = b.mul(constant, q);
            let round = values.rounding("rounding");
            let product = rounded(b, product, format.frac_bits(), round);
            b.name(product, &format!("{name}_q"))
        }
        (Some(only), None) | (None, Some(only)) => only,
        (None, None) => panic!("bug: no factor"),
    })
}

/// Bounds on displacements: see [`Errors`].
fn bounds(values: &Values, switches: Switches) -> Bounds {
    let mut bounds = vec![
        Bound::new("relative displacement", ["ds_relative", "dt_relative"], |v, w| {
            Errors::both(v, w, Errors::relative)
        }),
        Bound::new("displacement", ["ds", "dt"], |v, w| Errors::both(v, w, Errors::absolute)),
        Bound::new("displacement in texels", ["ds_texels", "dt_texels"], |v, w| {
            f64::from(v.bits("texture_size")) * Errors::both(v, w, Errors::absolute)
        }),
    ];
    if ends(values.overflow("overflow")) {
        bounds.push(Bound::new("coordinate", ["s1", "t1"], |v, w| {
            Errors::both(v, w, Errors::absolute)
        }));
    }
    let exact: &[&str] = if switches.q { &["degenerate", "q1", "r1"] } else { &["degenerate"] };
    bounds.push(Bound::new("flag and what is passed", exact, |_, _| 0.0));
    Bounds::Stated(bounds)
}

/// The least vector, and the least factor, that a relative error is told of; below, it is told of
/// this.
const LEAST: f64 = 0.25;

/// How far a displacement can be off.
///
/// With v the exact vector, u the direction of L and k the factor, the displacement is k v·u. In
/// words: v' is off by `vector` and `vector_share |v|`; the block-normalised w', ½ long or longer,
/// points along u' with |u' - u| <= `direction`; its reciprocal length is off by the share `length`
/// and at most 2; the dot product is off by `dot`. So
/// `d' - d = (1 + length)((v' - v)·u' + v·(u' - u)) + length v·u + 2 (1 + length) dot`.
struct Errors {
    /// The most that v can be long.
    longest: f64,
    /// Error of the displacement before its factor: a share of |v|, and what is left for v = 0.
    share: f64,
    rest: f64,
    /// The factor, if there is one: its largest value, its error, and the rounding before it.
    factor: Option<[f64; 3]>,
    /// The last rounding.
    last: f64,
}

impl Errors {
    fn new(values: &Values, worst: &dyn Fn(&str) -> f64, axis: char) -> Self {
        let switches = Switches::new(values);
        let binormal = (axis == 's') == switches.s_is_binormal;
        let rounding = rounding_ulp(values);
        let ulp = |name: &str| 2f64.powi(-cast::signed_count(values.bits(name)));
        // A share of |v|, the rest, the longest v.
        let unit = |v: &Values| (unit_error(v, worst), 0.0, 1.0);
        let (vector_share, vector, longest) = match (switches.frame, switches.normalise) {
            (Frame::Matrix | Frame::Given, true) => unit(values),
            (Frame::Normal, true) if binormal => unit(values),
            // T = BN x N, as long as N.
            (Frame::Normal, true) => {
                (unit_error(values, worst), vector_rounding(values), longest())
            }
            (Frame::Matrix, false) => {
                let limit = 2.0 * libm::exp2(values.bits("matrix_int_bits").into());
                (0.0, vector_rounding(values), 3.0 * 3f64.sqrt() * limit)
            }
            (Frame::Given, false) => (0.0, 0.0, longest()),
            (Frame::Normal, false) if binormal => {
                (0.0, vector_rounding(values), longest() * longest())
            }
            (Frame::Normal, false) => {
                (0.0, (longest() + 1.0) * vector_rounding(values), longest().powi(3))
            }
        };
        let length = length_error(values, worst);
        let dot = rounding * ulp("dot_frac_bits");
        let name = if axis == 's' { "ks" } else { "kt" };
        let format = constant(values, switches, name).expect("bug: the unit was built with it");
        let factor = switches.has_factor().then(|| {
            let q = if switches.q { texture_limit(values) } else { 1.0 };
            let (constant, error) = match switches.constants {
                Constants::Off => (1.0, 0.0),
                Constants::Parameters => {
                    let real = values.real(name);
                    let ulp = format.ulp();
                    (real.abs(), ((real / ulp).round() * ulp - real).abs())
                }
                Constants::Ports => (2f64.powi(format.int_bits()), 0.0),
            };
            let product = switches.q && switches.constants != Constants::Off;
            let product = if product { rounding * format.ulp() } else { 0.0 };
            let before = 2f64.powi(-UNIT_GUARD_BITS) * ulp("texture_frac_bits") * rounding;
            [constant * q, error * q + product, before]
        });
        Self {
            longest,
            share: (1.0 + length) * (direction_error(values) + vector_share) + length,
            rest: (1.0 + length) * (vector + 2.0 * dot),
            factor,
            last: rounding * ulp("texture_frac_bits"),
        }
    }

    /// The larger one of both axes.
    fn both(values: &Values, worst: &dyn Fn(&str) -> f64, of: fn(&Self) -> f64) -> f64 {
        let [s, t] = ['s', 't'].map(|axis| of(&Self::new(values, worst, axis)));
        s.max(t)
    }

    fn absolute(&self) -> f64 {
        let unit = self.share * self.longest + self.rest;
        match self.factor {
            None => unit + self.last,
            Some([most, error, before]) => {
                (most + error) * (unit + before) + self.longest * error + self.last
            }
        }
    }

    /// Over |v| and the factor, each no less than [`LEAST`].
    fn relative(&self) -> f64 {
        let unit = self.share + self.rest / LEAST;
        match self.factor {
            None => unit + self.last / LEAST,
            Some([_, error, before]) => {
                (1.0 + error / LEAST) * (unit + before / LEAST)
                    + error / LEAST
                    + self.last / (LEAST * LEAST)
            }
        }
    }
}

/// Texture coordinates are below this in magnitude.
fn texture_limit(values: &Values) -> f64 {
    libm::exp2(values.bits("texture_int_bits").into())
}

/// The golden model. Scales are |v| and |k|, each no less than ¼, in product.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let switches = Switches::new(values);
    let mut first = Vec::new();
    let mut at = 0;
    for name in switches.ports() {
        first.push((name, at));
        at += if is_vector(name) { 3 } else { 1 };
    }
    let real = |x: f64| F::from(x).expect("bug: a float");
    let least = real(LEAST);
    let [ks, kt] = ["ks", "kt"].map(|name| real(values.real(name)));
    let int_bits = cast::signed_count(values.bits("texture_int_bits"));
    let frac_bits = cast::signed_count(values.bits("texture_frac_bits"));
    let overflow = values.overflow("overflow");
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let port = |name: &str| first.iter().find(|(known, _)| *known == name).map(|(_, at)| *at);
        let number = |name: &str, i: usize| inputs[port(name).expect("bug: a port")][i];
        let vector = |name: &str, i: usize| {
            let at = port(name).expect("bug: a port");
            [inputs[at][i], inputs[at + 1][i], inputs[at + 2][i]]
        };
        let dot = |u: [F; 3], v: [F; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        let mut row = vec![F::zero(); outputs.len()];
        let scales = row.len() - 2;
        for i in 0..inputs[0].len() {
            let is_zero = |v: [F; 3]| v.iter().all(|x| *x == F::zero());
            let mut degenerate = false;
            let (t, b) = match switches.frame {
                Frame::Normal => {
                    let (n, ct) = (vector("normal", i), vector("ct", i));
                    let (t, bn, zero) = golden_frame(n, ct, switches.normalise);
                    degenerate |= switches.normalise && zero;
                    (t, bn)
                }
                Frame::Matrix | Frame::Given => {
                    let [t, b] = ["tangent", "binormal"].map(|name| {
                        let mut v = vector(name, i);
                        if switches.frame == Frame::Matrix {
                            v = ["m0", "m1", "m2"].map(|row| dot(vector(row, i), v));
                        }
                        if switches.normalise {
                            degenerate |= is_zero(v);
                            v = golden_unit(v);
                        }
                        v
                    });
                    (t, b)
                }
            };
            let (light, vertex) = (vector("light", i), vector("vertex", i));
            let mut l = [0, 1, 2].map(|axis| light[axis] - vertex[axis]);
            degenerate |= is_zero(l);
            if switches.vertex_light {
                l = l.map(|x| -x);
            }
            let l = golden_unit(l);
            let (of_s, of_t) = if switches.s_is_binormal { (b, t) } else { (t, b) };
            let q = if switches.q { number("q0", i) } else { F::one() };
            let [ks, kt] = match switches.constants {
                Constants::Off => [F::one(); 2],
                Constants::Parameters => [ks, kt],
                Constants::Ports => [number("ks", i), number("kt", i)],
            };
            let sign = if switches.minus_t { -F::one() } else { F::one() };
            for (at, (v, k, name)) in
                [(of_s, ks * q, "s0"), (of_t, sign * kt * q, "t0")].into_iter().enumerate()
            {
                let displacement = k * dot(v, l);
                row[at] = displacement;
                let sum = number(name, i) + displacement;
                row[at + 2] = ended_at(overflow, int_bits, frac_bits, sum);
                let size = dot(v, v).sqrt().max(least);
                let factor = if switches.has_factor() { k.abs().max(least) } else { F::one() };
                row[scales + at] = size * factor;
            }
            row[4] = if degenerate { F::one() } else { F::zero() };
            if switches.q {
                row[5] = q;
                row[6] = number("r0", i);
            }
            for (column, x) in outputs.iter_mut().zip(&row) {
                column[i] = *x;
            }
        }
    })
}
