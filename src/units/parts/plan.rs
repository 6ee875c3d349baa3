//! Shared by the units of a bump-mapping pipeline: parameters, and the plan of the netlist derived
//! from them.

use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Param, Role, Values};
use crate::netlist::{Builder, NodeId};
use crate::number::format::{Format, Overflow, Round};
use crate::number::function::Function;
use crate::table::{self, Scheme, Tabulated};

pub(crate) fn angle_bits() -> Param {
    Param::bits("angle_bits", 2..=24)
        .default(16)
        .help("bits of every angle port; a word counts 2^-angle_bits turns")
}

pub(crate) fn table_addr_bits() -> Param {
    Param::bits("table_addr_bits", 2..=20)
        .role(Role::TableSize)
        .default(10)
        .help("address bits of every table without its own parameter")
}

pub(crate) fn quarter_wave() -> Param {
    Param::flag("quarter_wave")
        .help("store only a quarter turn of sin, cos and their reciprocals, and fold the angle")
}

pub(crate) fn frac_bits() -> Param {
    Param::bits("frac_bits", 2..=32).default(16).help("fraction bits of the components x, y, z")
}

pub(crate) fn guard_bits() -> Param {
    Param::bits("guard_bits", 0..=8).default(2).help("extra fraction bits of intermediate results")
}

pub(crate) fn overflow() -> Param {
    Param::overflow("overflow")
        .help("overflow of the components x, y, z (cartesian); intermediate results saturate")
}

pub(crate) fn sincos_addr_bits() -> Param {
    Param::bits("sincos_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of the sin & cos table")
}

pub(crate) fn asin_addr_bits() -> Param {
    Param::bits("asin_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of the asin table (printed, corrected)")
}

pub(crate) fn recip_addr_bits() -> Param {
    Param::bits("recip_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of the reciprocal tables")
}

pub(crate) fn atan_addr_bits() -> Param {
    Param::bits("atan_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of the atan table")
}

pub(crate) fn prop_addr_bits() -> Param {
    Param::bits("prop_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of T_prop (printed, corrected)")
}

pub(crate) fn recip_int_bits() -> Param {
    Param::bits("recip_int_bits", 1..=16)
        .default(8)
        .help("1/(2 sin Z) and 1/(2 cos Z) saturate at 2^recip_int_bits (printed, corrected)")
}

pub(crate) fn atan_int_bits() -> Param {
    Param::bits("atan_int_bits", 1..=14).auto("balances the errors of its cells and of its ends, for its size and scheme").help("the index of the atan table, tan phi', saturates at 2^atan_int_bits (printed, corrected)")
}

pub(crate) fn quadrants() -> Param {
    Param::choice("quadrants", ["full", "half"])
        .help("phi' over the full circle, or plain atan as eq (9) is printed (printed, corrected)")
}

pub(crate) fn cordic_iterations() -> Param {
    Param::int("cordic_iterations", 1..=40)
        .role(Role::Iterations)
        .auto("frac_bits + guard_bits")
        .help("steps of each CORDIC (polar-cordic)")
}

/// The parameters in the form that building the netlist needs.
pub(crate) struct Plan<'a> {
    pub(crate) values: &'a Values,
    pub(crate) angle_bits: u32,
    /// Fraction bits of intermediate components.
    pub(crate) work_bits: u32,
    /// Fraction bits of intermediate angles.
    pub(crate) work_angle_bits: u32,
    pub(crate) frac_bits: u32,
    pub(crate) scheme: Scheme,
    pub(crate) quarter_wave: bool,
    pub(crate) round: Round,
    pub(crate) tabulated: Vec<Tabulated>,
}

/// Format of signed numbers below 2^int_bits with `frac_bits` fraction bits.
pub(crate) fn number(int_bits: u32, frac_bits: u32) -> Result<Format> {
    Format::signed(int_bits + frac_bits + 1, cast::signed_count(frac_bits))
}

impl<'a> Plan<'a> {
    /// The plan of parameters that include all of this file except the tables' sizes. A unit
    /// without angles may lack those of angles too.
    pub(crate) fn new(values: &'a Values) -> Self {
        let angles = values.has("angle_bits");
        let angle_bits = if angles { values.bits("angle_bits") } else { 0 };
        let guard_bits = values.bits("guard_bits");
        Self {
            values,
            angle_bits,
            work_bits: values.bits("frac_bits") + guard_bits,
            work_angle_bits: angle_bits + guard_bits,
            frac_bits: values.bits("frac_bits"),
            scheme: values.scheme("scheme"),
            quarter_wave: angles && values.flag("quarter_wave"),
            round: values.rounding("rounding"),
            tabulated: Vec::new(),
        }
    }

    /// Tabulates functions of `argument`; the table's size comes from `<size>_addr_bits`.
    pub(crate) fn table(
        &mut self,
        b: &mut Builder,
        name: &str,
        size: &str,
        functions: &[Function],
        argument: NodeId,
        output: Format,
    ) -> Vec<NodeId> {
        let format = b.format(argument);
        let tabulated = self.tabulate(b, name, size, functions, 0.0, output, format);
        table::emit(b, &tabulated.spec(), argument)
    }

    #[expect(clippy::too_many_arguments, reason = "what a table is made from")]
    pub(crate) fn tabulate(
        &mut self,
        b: &mut Builder,
        name: &str,
        size: &str,
        functions: &[Function],
        origin: f64,
        output: Format,
        argument: Format,
    ) -> Tabulated {
        let output = b.table_format(name, output);
        let addr_bits = match self.values.int(size) {
            Some(bits) => u32::try_from(bits).expect("bug: counts of bits are small"),
            None => self.values.bits("table_addr_bits"),
        };
        let tabulated = Tabulated {
            name: name.to_owned(),
            functions: functions.to_vec(),
            scheme: table::chosen(b, name, self.scheme),
            addr_bits,
            quarter_wave: self.quarter_wave,
            origin,
            output,
            round: self.round,
            argument,
        };
        if self.tabulated.iter().all(|known| known.name != name) {
            self.tabulated.push(tabulated.clone());
        }
        tabulated
    }

    /// sin and cos of an angle.
    pub(crate) fn sincos(&mut self, b: &mut Builder, angle: NodeId) -> Result<(NodeId, NodeId)> {
        let output = number(1, self.work_bits)?; // -2 to 2: 1.0 is representable
        let functions = &[Function::sin(), Function::cos()];
        let pair = self.table(b, "sincos", "sincos_addr_bits", functions, angle, output);
        Ok((pair[0], pair[1]))
    }

    /// An intermediate angle, rounded to the port's bits, modulo a turn.
    pub(crate) fn angle_word(&self, b: &mut Builder, name: &str, angle: NodeId) -> Result<NodeId> {
        let format = b.format(angle);
        let int_bits = u32::try_from(format.int_bits().max(0)).expect("bug: not negative");
        // One more integer bit, so that rounding up past the top wraps to the next turn and doesn't
        // overflow.
        let wide = Format::new(
            format.is_signed(),
            int_bits + 1 + u32::from(format.is_signed()) + self.angle_bits,
            cast::signed_count(self.angle_bits),
        )?;
        let rounded = b.narrow(angle, wide, self.round, Overflow::Saturate);
        let word = b.modulo(rounded, Format::turns(self.angle_bits)?);
        b.turns(word);
        Ok(b.name(word, name))
    }
}

/// Sum or difference of angles, modulo a turn.
pub(crate) fn angle(b: &mut Builder, name: &str, exact: NodeId, format: Format) -> NodeId {
    let word = b.modulo(exact, format);
    b.turns(word);
    b.name(word, name)
}

/// Largest error of one rounding in ulp.
pub(crate) fn rounding_ulp(values: &Values) -> f64 {
    values.rounding("rounding").error_ulp()
}
