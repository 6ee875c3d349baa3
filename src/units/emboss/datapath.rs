//! The datapath: ports, the basis, and the displacements.

use super::bounds::bounds;
use super::formats::{UNIT_GUARD_BITS, constant, texture};
use super::golden::golden;
use super::printed::figure_8;
use super::switches::{Constants, Frame, Switches, is_vector};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Design, Group, HardCase, Scale, Shape, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::units::basis::{component, frame, rounded, vector_frac_bits};
use crate::units::dot::{dot, signed, vector_ports};
use crate::units::normalise::{Block, block, narrowed, unit_vector};
use crate::units::rsqrt::Root;
use crate::units::vertex::{draw, hard_cases};

/// Input ports by name.
struct Ports(Vec<(&'static str, Vec<NodeId>)>);

impl Ports {
    fn new(b: &mut Builder, values: &Values, switches: Switches) -> Result<Self> {
        let short = if values.flag("input20") { Quantity::Float20 } else { Quantity::Number };
        let component = component(values)?;
        let position = signed(values, "position_bits", "position_frac_bits")?;
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

pub(super) fn design(values: &Values) -> Result<Design> {
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
        let what = "the vector's length times its factor, each at least 1/4";
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

/// T and B in eye space, with a zero-vector flag for each that is normalised.
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
            // -2 to 2: 1 is representable.
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

/// The operands of a displacement.
struct Factors {
    axis: char,
    dot: NodeId,
    reciprocal: NodeId,
    /// Integer bits of the vector's components.
    vector_int: i32,
    minus: bool,
}

/// A displacement: the dot product times 1/|L|, times the factor if there is one.
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
    // At most the vector's length, which is below twice the limit of its largest component.
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
