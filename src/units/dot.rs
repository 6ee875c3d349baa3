//! The dot product of three, and what units of vectors in words share.

use super::parts::plan::{self, rounding_ulp};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, BoundFn, Bounds, Design, Group, HardCase, Kind, Param, Role, Sampler, Shading, Uniform,
    Unit, Values,
};
use crate::netlist::{Builder, Netlist, NodeId, Part, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::trig::Real;
use std::sync::Arc;

// Products of words of 26 bits, and sums of three, are exact in an f64, and so is the golden.

/// The unit.
pub static DOT: Unit = Unit {
    name: "dot",
    summary: "dot product of three: exact products and sums, one rounding",
    source: "the vector dot units of seed 000 (US 6,980,218, FIG. 8), in formats of any width",
    params: &PARAMS,
    golden_params: &PARAM_NAMES,
    inputs: "v_x, v_y, v_z, w_x, w_y, w_z: two vectors",
    outputs: "dot_product: v·w, rounded; past its format as overflow says",
    shades: Shading::None,
    build,
};

pub(super) const V_BITS: Param = Param {
    name: "v_bits",
    role: Role::Width,
    kind: Kind::Int { min: 2, max: 26, auto: None },
    default: "16",
    help: "bits of the components of v, signed",
};

pub(super) const V_FRAC_BITS: Param = Param {
    name: "v_frac_bits",
    role: Role::Width,
    kind: Kind::Int { min: 0, max: 28, auto: None },
    default: "14",
    help: "fraction bits of those",
};

pub(super) const W_BITS: Param = Param {
    name: "w_bits",
    role: Role::Width,
    kind: Kind::Int { min: 2, max: 26, auto: None },
    default: "16",
    help: "bits of the components of w, signed",
};

pub(super) const W_FRAC_BITS: Param = Param {
    name: "w_frac_bits",
    role: Role::Width,
    kind: Kind::Int { min: 0, max: 28, auto: None },
    default: "14",
    help: "fraction bits of those",
};

pub(super) const OUT_BITS: Param = Param {
    name: "out_bits",
    role: Role::Width,
    kind: Kind::Int { min: 2, max: 63, auto: None },
    default: "24",
    help: "bits of each result, signed",
};

pub(super) const OUT_FRAC_BITS: Param = Param {
    name: "out_frac_bits",
    role: Role::Width,
    kind: Kind::Int { min: 0, max: 56, auto: None },
    default: "18",
    help: "fraction bits of those",
};

pub(super) const OUT_OVERFLOW: Param = Param {
    name: "overflow",
    role: Role::Overflow,
    kind: Kind::Choice(&["saturate", "symmetric", "wrap", "error"]),
    default: "saturate",
    help: "overflow of results; with the first two the golden ends where the format does",
};

/// Parameters of two vectors and results.
pub(super) const PARAMS: [Param; 8] = [
    V_BITS,
    V_FRAC_BITS,
    W_BITS,
    W_FRAC_BITS,
    OUT_BITS,
    OUT_FRAC_BITS,
    OUT_OVERFLOW,
    plan::ROUNDING,
];

/// Their names: inputs are drawn over the ranges of their formats, and the golden ends where the
/// result's does.
pub(super) const PARAM_NAMES: [&str; 7] =
    ["v_bits", "v_frac_bits", "w_bits", "w_frac_bits", "out_bits", "out_frac_bits", "overflow"];

/// `v_x w_x + v_y w_y + v_z w_z`, exact: three multipliers and two adders in a part of that name.
/// Every dot product of the emboss family is built here, so that schedules can share them.
pub(super) fn dot(b: &mut Builder, name: &str, v: [NodeId; 3], w: [NodeId; 3]) -> NodeId {
    b.part(Part::Dot, name, |b| {
        let [x, y, z] = [0, 1, 2].map(|i| b.mul(v[i], w[i]));
        let sum = b.add(x, y);
        b.add(sum, z)
    })
}

/// The components of a vector as input ports.
pub(super) fn vector_ports(
    b: &mut Builder,
    name: &str,
    format: Format,
    quantity: Quantity,
) -> [NodeId; 3] {
    ["x", "y", "z"].map(|axis| b.input(&format!("{name}_{axis}"), format, quantity))
}

/// A signed format from two parameters.
pub(super) fn signed(values: &Values, bits: &str, frac_bits: &str) -> Result<Format> {
    Format::signed(values.bits(bits), cast::signed_count(values.bits(frac_bits)))
}

/// Format, rounding and overflow of results.
pub(super) fn result(values: &Values) -> Result<(Format, Round, Overflow)> {
    Ok((
        signed(values, "out_bits", "out_frac_bits")?,
        values.choice("rounding").parse()?,
        values.choice("overflow").parse()?,
    ))
}

/// The golden value where the format of results ends, if it saturates.
pub(super) fn ended<F: Real>(values: &Values, exact: F) -> F {
    let bits = cast::signed_count(values.bits("out_bits"));
    let frac_bits = cast::signed_count(values.bits("out_frac_bits"));
    ended_at(values.choice("overflow"), bits - 1 - frac_bits, frac_bits, exact)
}

/// A value where a signed format of so many whole and fraction bits ends, if it saturates.
pub(super) fn ended_at<F: Real>(overflow: &str, int_bits: i32, frac_bits: i32, exact: F) -> F {
    let two = F::one() + F::one();
    let (limit, ulp) = (two.powi(int_bits), two.powi(-frac_bits));
    match overflow {
        "saturate" => exact.max(-limit).min(limit - ulp),
        "symmetric" => exact.max(ulp - limit).min(limit - ulp),
        _ => exact,
    }
}

/// One rounding of results, or why none is stated.
pub(super) fn rounding_bounds(values: &Values, quantities: &'static [&'static str]) -> Bounds {
    if !ends(values.choice("overflow")) {
        return Bounds::Unstated(UNENDED);
    }
    Bounds::Stated(vec![Bound { what: "result", quantities, bound: rounding_bound as BoundFn }])
}

/// True for overflow modes that the golden has too.
pub(super) fn ends(overflow: &str) -> bool {
    matches!(overflow, "saturate" | "symmetric")
}

const UNENDED: &str =
    "with this overflow mode results past the format are elsewhere, not near the golden";

fn rounding_bound(values: &Values, _: &dyn Fn(&str) -> f64) -> f64 {
    rounding_ulp(values) * 2f64.powi(-cast::signed_count(values.bits("out_frac_bits")))
}

fn build(values: &Values) -> Result<Design> {
    let mut b = Builder::new("dot");
    let v = signed(values, "v_bits", "v_frac_bits")?;
    let v = vector_ports(&mut b, "v", v, Quantity::Number);
    let w = signed(values, "w_bits", "w_frac_bits")?;
    let w = vector_ports(&mut b, "w", w, Quantity::Number);
    let (format, round, overflow) = result(values)?;
    let exact = dot(&mut b, "v_dot_w", v, w);
    let word = b.narrow(exact, format, round, overflow);
    b.output("dot_product", word);
    let netlist = b.build()?;
    Ok(Design {
        values: values.clone(),
        groups: Group::ports(&netlist, &["dot_product"]),
        hard: extremes(&netlist),
        netlist: Arc::new(netlist),
        golden: golden::<f64>,
        golden_f32: golden::<f32>,
        bounds: rounding_bounds(values, &["dot_product"]),
        tabulated: Vec::new(),
        draw: draw_words,
        binding: None,
    })
}

fn golden<F: Real>(values: &Values, inputs: &[&[F]], outputs: &mut [Vec<F>]) {
    for (i, to) in outputs[0].iter_mut().enumerate() {
        let sum = (0..3).fold(F::zero(), |sum, axis| sum + inputs[axis][i] * inputs[axis + 3][i]);
        *to = ended(values, sum);
    }
}

/// Fills ports with numbers of both signs and all sizes: the exponent is uniform over the port's
/// bits for half of the rows, as the value is for the others.
pub(super) fn draw_words(
    design: &Design,
    _: Sampler,
    uniform: &mut Uniform,
    columns: &mut [Vec<f64>],
    count: usize,
) {
    columns.iter_mut().for_each(Vec::clear);
    let netlist = &design.netlist;
    for _ in 0..count {
        let evenly = uniform.draw() < 0.5;
        for (column, id) in columns.iter_mut().zip(netlist.inputs()) {
            let format = netlist.node(*id).format;
            let (low, high) = (format.value(format.min_raw()), format.value(format.max_raw()));
            let value = if evenly {
                low + (high - low) * uniform.draw()
            } else {
                let size = high * libm::exp2(-uniform.draw() * f64::from(format.bits()));
                if uniform.draw() < 0.5 && format.is_signed() { -size } else { size }
            };
            column.push(value);
        }
    }
}

/// Words at and beside the ends of formats, in every port and turn about.
pub(super) fn extremes(netlist: &Netlist) -> Vec<HardCase> {
    let formats: Vec<Format> = netlist.inputs().iter().map(|id| netlist.node(*id).format).collect();
    let each = |word: &dyn Fn(usize, Format) -> i64| -> Vec<i64> {
        let fit = |(port, format): (usize, &Format)| {
            word(port, *format).clamp(format.min_raw(), format.max_raw())
        };
        formats.iter().enumerate().map(fit).collect()
    };
    let alone = |word: &dyn Fn(Format) -> i64| -> Vec<Vec<i64>> {
        (0..formats.len()).map(|at| each(&|port, f| if port == at { word(f) } else { 0 })).collect()
    };
    let case = |name, words| HardCase { name, words };
    vec![
        case("all words 0", vec![each(&|_, _| 0)]),
        case("one word, of one LSB", [alone(&|_| 1), alone(&|_| -1)].concat()),
        case("the most negative words", vec![each(&|_, f| f.min_raw())]),
        case("the largest words, and both ends turn about", {
            let turn = |of: usize| {
                each(&move |port, f| if port % of == 0 { f.min_raw() } else { f.max_raw() })
            };
            vec![each(&|_, f| f.max_raw()), turn(2), turn(3), turn(4), turn(6)]
        }),
        case("one word alone at an end", {
            [alone(&|f: Format| f.min_raw()), alone(&|f: Format| f.max_raw())].concat()
        }),
        case("one huge word beside words of one LSB", {
            let huge = |at: usize| each(&|port, f| if port % 3 == at { f.max_raw() } else { 1 });
            let least = |at: usize| each(&|port, f| if port % 3 == at { f.min_raw() } else { -1 });
            (0..3).flat_map(|at| [huge(at), least(at)]).collect()
        }),
    ]
}
