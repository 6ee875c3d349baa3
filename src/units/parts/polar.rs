//! Shared parts: conversion from Cartesian to polar form, by CORDIC and by tables.

use crate::base::cast;
use crate::base::error::Error;
use crate::netlist::{Builder, NodeId};
use crate::number::format::{Format, Overflow, Round, bit_len};
use crate::table::{self, Spec};
use std::f64::consts::TAU;

/// Angle and length of a vector, as nodes; the caller states their meaning on real numbers.
pub(crate) struct Polar {
    /// Angle in turns, unsigned, modulo one.
    pub(crate) angle: NodeId,
    /// Length, times [`gain`] for CORDIC.
    pub(crate) length: NodeId,
}

/// The factor by which CORDIC vectoring multiplies the length.
pub(crate) fn gain(iterations: u32) -> f64 {
    (0..cast::signed_count(iterations)).map(|i| (1.0 + 4f64.powi(-i)).sqrt()).product()
}

/// Fraction bits of CORDIC's words, so that the bits dropped by all steps together stay below
/// `2^-frac_bits`.
pub(crate) fn cordic_frac_bits(frac_bits: u32, iterations: u32) -> u32 {
    frac_bits + bit_len(u64::from(iterations)) + 1
}

/// The angle half a turn on: the word's top bit is inverted.
pub(crate) fn opposite(b: &mut Builder, angle: NodeId) -> NodeId {
    let format = b.format(angle);
    let top = b.constant(1 << (format.bits() - 1), format);
    let turned = b.xor(angle, top);
    b.turns(turned);
    b.means(turned, [angle], |[angle]| angle + 0.5)
}

/// Angle and length of (x, y) by CORDIC in vectoring mode: adders and wires only.
///
/// |x|, |y| < 2 with |(x, y)| * gain < 4; steps drop bits toward minus infinity. Uses `work_bits`
/// fraction bits for x and y, and `angle_bits` for the angle. (0, 0) gives angle 0.
pub(crate) fn cordic(
    b: &mut Builder,
    y: NodeId,
    x: NodeId,
    iterations: u32,
    work_bits: u32,
    angle_bits: u32,
) -> Polar {
    let work = Format::signed(work_bits + 3, cast::signed_count(work_bits));
    let work = b.checked(work); // -4 <= word < 4
    let fit = |b: &mut Builder, node| b.narrow(node, work, Round::Floor, Overflow::Saturate);
    let (mut cx, mut cy) = (fit(b, x), fit(b, y));
    let zero = b.constant(0, Format::FLAG);
    let (no_x, no_y) = (b.equal(cx, zero), b.equal(cy, zero));
    let nowhere = b.and(no_x, no_y);
    let behind = b.negative(cx);
    let (minus_x, minus_y) = (b.neg(cx), b.neg(cy));
    cx = b.mux(behind, minus_x, cx);
    cy = b.mux(behind, minus_y, cy);
    cx = fit(b, cx);
    cy = fit(b, cy);

    // -½ <= angle < ½; the sum of all steps is below 0.28.
    let turns = b.checked(Format::signed_turns(angle_bits));
    let one = b.constant(1, Format::FLAG);
    let step_of = |i: i32| {
        let turns = libm::atan(2f64.powi(-i)) / TAU;
        cast::i64_of((turns * 2f64.powi(cast::signed_count(angle_bits))).round())
    };
    // No step can turn the zero vector, but each adds its angle. So the zero vector starts at minus
    // the sum of all steps.
    let all_steps: i64 = (0..cast::signed_count(iterations)).map(step_of).sum();
    let (back, start) = (b.constant(-all_steps, turns), b.constant(0, turns));
    let mut angle = b.mux(nowhere, back, start);
    for i in 0..cast::signed_count(iterations) {
        let below = b.negative(cy);
        let above = b.xor(below, one);
        let (dx, dy) = (b.shift(cy, -i), b.shift(cx, -i));
        let (next_x, next_y) = (b.addsub(below, cx, dx), b.addsub(above, cy, dy));
        let step = b.constant(step_of(i), turns);
        let sum = b.addsub(below, angle, step);
        angle = b.narrow(sum, turns, Round::Floor, Overflow::Saturate);
        cx = fit(b, next_x);
        cy = fit(b, next_y);
    }
    let whole = b.checked(Format::turns(angle_bits));
    let ahead = b.modulo(angle, whole);
    let turned = opposite(b, ahead);
    let angle = b.mux(behind, turned, ahead);
    Polar { angle: b.turns(angle), length: cx }
}

/// `x * factor` with the factor rounded to `frac_bits` bits, as additions of shifted words
/// (canonical signed digits): no multiplier.
pub(crate) fn scale(b: &mut Builder, x: NodeId, factor: f64, frac_bits: u32) -> NodeId {
    let frac = cast::signed_count(frac_bits);
    let mut digits = cast::i64_of((factor * 2f64.powi(frac)).round());
    let mut sum: Option<NodeId> = None;
    let mut place = -frac;
    while digits != 0 {
        if digits & 1 == 1 {
            let negative = digits & 3 == 3;
            let term = b.shift(x, place);
            sum = Some(match (sum, negative) {
                (None, false) => term,
                (None, true) => b.neg(term),
                (Some(sum), false) => b.add(sum, term),
                (Some(sum), true) => b.sub(sum, term),
            });
            digits += if negative { 1 } else { -1 };
        }
        digits >>= 1;
        place += 1;
    }
    sum.expect("bug: the factor is not 0")
}

/// Table specifications of [`table`].
pub(crate) struct PolarTables<'a> {
    /// 1/x of a mantissa from ½ up; the argument is the mantissa without its top bit.
    pub(crate) recip: Spec<'a>,
    /// atan and secant of a ratio from 0 to 1.
    pub(crate) atan: Spec<'a>,
    /// Fraction bits of the ratio.
    pub(crate) ratio_bits: u32,
}

/// Format of the reciprocal table's argument for components of format `component`.
pub(crate) fn mantissa_argument(component: Format) -> crate::base::error::Result<Format> {
    // |component| has as many bits as the component; without its top bit, one fewer.
    Format::unsigned(component.bits() - 1, cast::signed_count(component.bits()))
}

/// Components, which must have this format; any other is an error in formats given by name.
pub(crate) fn in_one_format<const N: usize>(
    b: &mut Builder,
    format: Format,
    components: [NodeId; N],
) -> [NodeId; N] {
    components.map(|component| {
        let other = b.format(component);
        if other != format {
            b.fail(Error::usage(format!(
                "components have formats {format} and {other}: give all of them one format"
            )));
        }
        b.narrow(component, format, Round::Floor, Overflow::Wrap)
    })
}

/// Angle and length of (x, y), both of one signed format: octant fold, normalised reciprocal table,
/// one product for the ratio, a table of atan and secant, one product for the length. (0, 0) gives
/// angle 0.
pub(crate) fn table(b: &mut Builder, y: NodeId, x: NodeId, tables: &PolarTables<'_>) -> Polar {
    let component = b.format(x);
    let [y] = in_one_format(b, component, [y]);
    let bits = component.bits(); // of |x|, since -2^(bits-1) has the magnitude 2^(bits-1)
    let (ax, ay) = (b.abs(x), b.abs(y));
    let steep = b.less(ax, ay);
    let (major, minor) = (b.mux(steep, ay, ax), b.mux(steep, ax, ay));
    // Shift both so that the larger has its top bit set; no bit is lost at the top.
    let places = b.leading_zeros(major);
    let mantissa = |b: &mut Builder, node| {
        let shifted = b.shift_left(node, places, bits);
        b.slice(shifted, 0, bits)
    };
    let (major_mantissa, minor_mantissa) = (mantissa(b, major), mantissa(b, minor));
    let argument = b.slice(major_mantissa, 0, bits - 1);
    let argument = b.shift(argument, -cast::signed_count(bits));
    let recip = table::emit(b, &tables.recip, argument)[0]; // 1 < recip <= 2
    let numerator = b.shift(minor_mantissa, -cast::signed_count(bits)); // 0 <= numerator < 1
    let quotient = b.mul(numerator, recip);
    let ratio = b.checked(Format::turns(tables.ratio_bits)); // 0 <= ratio < 1
    let ratio = b.narrow(quotient, ratio, tables.recip.round, Overflow::Saturate);
    b.name(ratio, "ratio");
    let [octant, secant] = table::emit(b, &tables.atan, ratio)[..] else {
        panic!("bug: two functions were asked for")
    };

    // Unfold: ¼ - angle in the steep octants, ½ - angle for x < 0, -angle for y < 0.
    let out = tables.atan.output;
    let fold = |b: &mut Builder, flag, angle, from: Option<f64>| {
        let folded = match from {
            None => b.neg(angle),
            Some(turns) => {
                let raw = cast::i64_of(turns / out.ulp());
                let from = b.constant(raw, out);
                b.sub(from, angle)
            }
        };
        b.mux(flag, folded, angle)
    };
    let angle = fold(b, steep, octant, Some(0.25));
    let behind = b.negative(x);
    let angle = fold(b, behind, angle, Some(0.5));
    let below = b.negative(y);
    let angle = fold(b, below, angle, None);
    let whole = b.checked(Format::turns(out.frac_bits().unsigned_abs()));
    let angle = b.modulo(angle, whole);
    let length = b.mul(major, secant);
    let length_format = Format::signed(bits + 1, component.frac_bits());
    let length_format = b.checked(length_format);
    let length = b.narrow(length, length_format, tables.atan.round, Overflow::Saturate);
    Polar { angle: b.turns(angle), length }
}
