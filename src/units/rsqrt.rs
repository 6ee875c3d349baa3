//! The reciprocal square root as a unit, and the one shared by the units of vectors.

use super::parts::plan::rounding_ulp;
use super::parts::root::{self, newton_error, reciprocal_root};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Golden, Group, HardCase, Param, Role, Scale, Shape, Unit, Values,
};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::function::Function;
use crate::number::trig::Real;
use crate::table::Tabulated;
use crate::table::{self, Scheme};

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new(
        "rsqrt",
        "1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step",
    )
    .source("the inverse square root unit of US 6,980,218, FIG. 8")
    .formula(
        "r = 1/sqrt(a), 0 for a = 0, saturated at 2^root_int_bits\n\
     root_scheme=newton: r = y (3 - a y^2)/2 with y from the table",
    )
    .params([
        Param::bits("input_bits", 2..=32).default(20).help("bits of a, unsigned"),
        Param::bits("input_frac_bits", 0..=32).default(18).help("fraction bits of a"),
        Param::bits("root_int_bits", 1..=17)
            .default(9)
            .help("the result and the golden saturate at 2^root_int_bits"),
        root_scheme(),
        root_addr_bits(),
        root_frac_bits(),
        Param::rounding("rounding"),
    ])
    .inputs("a: a number, 0 or more")
    .outputs("r: 1/sqrt(a), or 0 for 0; degenerate: 1 for 0")
    .design(design)
}

pub(super) fn root_scheme() -> Param {
    Param::choice("root_scheme", [Scheme::Linear.name(), Scheme::Direct.name(), NEWTON])
        .role(Role::Scheme)
        .help("reciprocal root: table with interpolation, table alone, or table and a Newton step")
}

/// Table and a Newton step.
const NEWTON: &str = "newton";

pub(super) fn root_addr_bits() -> Param {
    Param::bits("root_addr_bits", 2..=16)
        .role(Role::TableSize)
        .default(9)
        .help("address bits of the reciprocal root's table")
}

pub(super) fn root_frac_bits() -> Param {
    Param::bits("root_frac_bits", 2..=22).default(18).help("fraction bits of the reciprocal root")
}

/// Guard bits of a Newton step and of the operand's mantissa.
const GUARD_BITS: u32 = 2;

/// The reciprocal root as set by the parameters.
pub(super) struct Root<'a> {
    pub(super) values: &'a Values,
    pub(super) round: Round,
    /// Bits of its block-normalised operands, if the unit has any.
    pub(super) norm_bits: u32,
    /// Its table, once a root is built.
    pub(super) tabulated: Vec<Tabulated>,
}

impl<'a> Root<'a> {
    pub(super) fn new(values: &'a Values) -> Self {
        Self {
            values,
            round: values.rounding("rounding"),
            norm_bits: if values.has("norm_bits") { values.bits("norm_bits") } else { 0 },
            tabulated: Vec::new(),
        }
    }

    /// 1/sqrt of an unsigned word, below 2^int_bits; larger results saturate, including 1/sqrt(0).
    pub(super) fn emit(
        &mut self,
        b: &mut Builder,
        name: &str,
        a: NodeId,
        int_bits: u32,
    ) -> Result<NodeId> {
        let frac_bits = self.values.bits("root_frac_bits");
        let output = Format::unsigned(int_bits + frac_bits, cast::signed_count(frac_bits))?;
        let scheme = self.values.choice("root_scheme");
        let addr_bits = self.values.bits("root_addr_bits");
        let newton = (scheme == NEWTON).then_some(frac_bits + GUARD_BITS);
        // A Newton step doubles the number of correct bits, so the table's words hold only as many
        // bits as a table of this size gets right.
        let most = frac_bits + GUARD_BITS;
        let table_bits = if newton.is_some() { most.min(addr_bits + 3) } else { most };
        let kept_bits = kept_bits(self.values);
        let table_output = Format::unsigned(table_bits + 2, cast::signed_count(table_bits))?; // to 2
        let tabulated = Tabulated {
            name: "recip_root".to_owned(),
            functions: vec![Function::recip_sqrt()],
            scheme: {
                let linear = scheme == Scheme::Linear.name();
                let own = if linear { Scheme::Linear } else { Scheme::Direct };
                table::chosen(b, "recip_root", own)
            },
            addr_bits,
            quarter_wave: false,
            origin: 0.25,
            output: b.table_format("recip_root", table_output),
            round: self.round,
            argument: root::argument(b.format(a), kept_bits)?,
        };
        let table = root::Table { spec: tabulated.spec(), kept_bits };
        let root = reciprocal_root(b, name, a, output, self.round, &table, newton);
        if self.tabulated.is_empty() {
            self.tabulated.push(tabulated);
        }
        Ok(root)
    }

    /// 1/sqrt of the exact square of a block-normalised vector. The square, ¼ to 3, is rounded to
    /// `dot_frac_bits`.
    pub(super) fn of_square(
        &mut self,
        b: &mut Builder,
        name: &str,
        square: NodeId,
    ) -> Result<NodeId> {
        let frac_bits = self.values.bits("dot_frac_bits");
        // ¼ is representable, so a rounded square stays at least ¼.
        let format = Format::unsigned(2 + frac_bits, cast::signed_count(frac_bits))?;
        let square = b.narrow(square, format, self.round, Overflow::Saturate);
        b.name(square, &format!("{name}_square"));
        let root = self.emit(b, name, square, 2)?; // up to 2
        Ok(b.name(root, name))
    }
}

/// Bits kept of the operand's mantissa.
fn kept_bits(values: &Values) -> u32 {
    (values.bits("root_frac_bits") + GUARD_BITS).max(4)
}

/// Largest relative error of the reciprocal root before its one rounding.
pub(super) fn root_error(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let dropped = 4.0 * 2f64.powi(-cast::signed_count(kept_bits(values)));
    let table = match values.choice("root_scheme") {
        NEWTON => {
            let frac_bits = values.bits("root_frac_bits") + GUARD_BITS;
            newton_error(worst("recip_root"), frac_bits, rounding_ulp(values))
        }
        _ => worst("recip_root"),
    };
    // The relative error from the mantissa's dropped bits compounds with that of the table.
    (1.0 + table) * (1.0 + dropped) - 1.0
}

/// Largest relative error of [`Root::of_square`] as the reciprocal of the length of its words.
pub(super) fn length_error(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let ulp = |name| rounding_ulp(values) * 2f64.powi(-cast::signed_count(values.bits(name)));
    // The square is at least ¼ before and after its rounding. Its root is rounded, and that error
    // is multiplied by the length, which is below sqrt(3).
    (1.0 + 4.0 * ulp("dot_frac_bits")).sqrt() * (1.0 + root_error(values, worst)) - 1.0
        + 3f64.sqrt() * ulp("root_frac_bits")
}

fn design(values: &Values) -> Result<Design> {
    let mut b = values.builder("rsqrt");
    let frac_bits = cast::signed_count(values.bits("input_frac_bits"));
    let a = Format::unsigned(values.bits("input_bits"), frac_bits)?;
    let a = b.input("a", a, Quantity::Number);
    let mut root = Root::new(values);
    let r = root.emit(&mut b, "reciprocal_root", a, values.bits("root_int_bits"))?;
    let zero = b.constant(0, Format::FLAG);
    let degenerate = b.equal(a, zero);
    let r = b.mux(degenerate, zero, r);
    b.output("r", r);
    b.output("degenerate", degenerate);
    let tabulated = root.tabulated;
    let netlist = b.build()?;
    let mut groups = Group::ports(&netlist, ["r", "degenerate"])?;
    groups[0].shape = Shape::Scaled {
        scales: vec![
            Scale::new("relative", "the result"),
            Scale::new("scaled", "the result, at least 1"),
        ],
        texels: None,
    };
    let hard = hard_cases(netlist.node(netlist.inputs()[0]).format);
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .hard(hard)
        .bounds(Bounds::Stated(vec![
            Bound::new("relative", ["r_relative"], |v, w| root_error(v, w) + last(v) / least(v)),
            Bound::new("scaled", ["r_scaled"], |v, w| root_error(v, w) + last(v)),
            Bound::new("absolute", ["r"], |v, w| root_error(v, w) * largest(v) + last(v)),
            Bound::new("flag", ["degenerate"], |_, _| 0.0),
        ]))
        .tabulated(tabulated))
}

/// The last rounding.
fn last(values: &Values) -> f64 {
    rounding_ulp(values) * 2f64.powi(-cast::signed_count(values.bits("root_frac_bits")))
}

/// The largest result.
fn largest(values: &Values) -> f64 {
    let of_one_lsb = 0.5 * f64::from(values.bits("input_frac_bits"));
    libm::exp2(of_one_lsb.min(values.bits("root_int_bits").into()))
}

/// Lower limit of all results except that of 0.
fn least(values: &Values) -> f64 {
    let whole_bits =
        f64::from(values.bits("input_bits")) - f64::from(values.bits("input_frac_bits"));
    libm::exp2(-0.5 * whole_bits)
}

/// The golden and its scales. A result of 0 has the relative error 0.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let two = F::one() + F::one();
    let int_bits = cast::signed_count(values.bits("root_int_bits"));
    let frac_bits = cast::signed_count(values.bits("root_frac_bits"));
    let most = two.powi(int_bits) - two.powi(-frac_bits);
    Golden::each(move |[a]: [F; 1]| {
        let zero = a == F::zero();
        let r = if zero { F::zero() } else { (F::one() / a.sqrt()).min(most) };
        [r, if zero { F::one() } else { F::zero() }, r, r.max(F::one())]
    })
}

fn hard_cases(format: Format) -> Vec<HardCase> {
    let rows = |words: Vec<i64>| -> Vec<Vec<i64>> {
        words.into_iter().filter(|word| format.contains(*word)).map(|word| vec![word]).collect()
    };
    let powers = (0..format.bits()).flat_map(|k| [(1 << k) - 1, 1i64 << k, (1 << k) + 1]);
    vec![
        HardCase::new("zero", rows(vec![0])),
        HardCase::new("powers of two, and one word off", rows(powers.collect())),
        HardCase::new("the largest words", rows(vec![format.max_raw() - 1, format.max_raw()])),
    ]
}
