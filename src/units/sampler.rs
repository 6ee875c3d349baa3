//! The sampler of the emboss family: from texture coordinates to texels.
//!
//! A map of 2^log2_width by 2^log2_height texels covers coordinates 0 to 1 along each axis. Texel i
//! of a row covers i / width to (i + 1) / width, so its centre is at (i + ½) / width, as in OpenGL.
//! `nearest` gives the texel that contains the coordinate. `bilinear` gives the two columns and the
//! two rows whose centres enclose it, and the fraction of the way from the first to the second:
//! with u = s · width - ½, i0 = ⌊u⌋, i1 = i0 + 1, a = u - ⌊u⌋.
//!
//! Texels outside the map follow `wrap` (the map repeats) or `clamp` (its border continues), for
//! each axis separately. The position u is truncated to `fraction_bits`, never rounded up, so
//! texels are always those of the exact position. The truncation takes less than an ulp of the
//! fractions off every sample's position, in the same direction, so their differences hardly
//! change.

use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Draw, Golden, HardCase, InputPorts, Param, Role, Unit, Values,
};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("sampler", "texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped")
        .source("US 6,980,218, texture look-ups of the emboss; texel centres as in OpenGL")
        .formula(
            "i = floor(s 2^log2_width), j = floor(t 2^log2_height) (nearest)\n\
         u = s 2^log2_width - 1/2, i0 = floor(u), i1 = i0 + 1, a = u - i0; j0, j1, b from t likewise (bilinear)\n\
         columns and rows then wrap around the map or are clamped to it (address_s, address_t)",
        )
        .params([
            filter(),
            Param::choice("address_s", ["wrap", "clamp"])
                .help("beyond the map along s: the map repeats (wrap), or its border continues (clamp)"),
            Param::choice("address_t", ["wrap", "clamp"]).help("beyond the map along t, likewise"),
            Param::bits("int_bits", 0..=16)
                .default(4)
                .help("integer bits of the coordinates, without the sign"),
            Param::bits("frac_bits", 1..=30).default(20).help("fraction bits of the coordinates"),
            Param::int("log2_width", 1..=13)
                .role(Role::MapSize)
                .default(9)
                .help("the map has 2^log2_width columns"),
            Param::int("log2_height", 1..=13)
                .role(Role::MapSize)
                .default(9)
                .help("the map has 2^log2_height rows"),
            fraction_bits(),
        ])
        .inputs("s, t: texture coordinates, 0 to 1 over the map")
        .outputs("i, j: column and row (nearest); or i0, i1, a and j0, j1, b: enclosing columns and rows, and the sample's fraction of the way from the first to the second, 0 to 1 (bilinear)")
        .design(design)
}

pub(super) fn filter() -> Param {
    Param::choice("filter", ["nearest", "bilinear"])
        .default("bilinear")
        .help("one texel per sample, or four and their weights")
}

pub(super) fn fraction_bits() -> Param {
    Param::bits("fraction_bits", 1..=16)
        .default(8)
        .help("bits of the fractions between texels (bilinear)")
}

/// Coordinate, parameters of its axis, and names of the position and of the outputs.
const AXES: [(&str, &str, &str, &str, [&str; 4]); 2] = [
    ("s", "address_s", "log2_width", "u", ["i", "i0", "i1", "a"]),
    ("t", "address_t", "log2_height", "v", ["j", "j0", "j1", "b"]),
];

fn design(values: &Values) -> Result<Design> {
    let bilinear = values.choice("filter") == "bilinear";
    let fraction_bits = values.bits("fraction_bits");
    let frac_bits = values.bits("frac_bits");
    let coordinate =
        Format::signed(values.bits("int_bits") + frac_bits + 1, cast::signed_count(frac_bits))?;
    let mut b = values.builder("sampler");
    let coordinates = AXES.map(|(name, ..)| b.input(name, coordinate, Quantity::Number));
    let mut outputs = Vec::new();
    for ((_, address, log2, position, names), coordinate) in AXES.into_iter().zip(coordinates) {
        let side_bits = values.bits(log2);
        let clamp = values.choice(address) == "clamp";
        let found = b.scope(position, |b| -> Result<Vec<NodeId>> {
            let scaled = b.shift(coordinate, cast::signed_count(side_bits));
            let exact = if bilinear {
                let half = b.checked(Format::unsigned(1, 1));
                let half = b.constant(1, half);
                b.sub(scaled, half)
            } else {
                scaled
            };
            // As many integer bits as the exact position: nothing overflows.
            let whole = b.format(exact).int_bits().unsigned_abs() + 1;
            let first = b.narrow(exact, Format::signed(whole, 0)?, Round::Floor, Overflow::Wrap);
            if first != exact {
                b.means(first, [exact], |[exact]| exact.floor());
            }
            let texel = |b: &mut Builder, index| -> Result<NodeId> {
                let address = Format::integer(side_bits)?;
                if !clamp {
                    return Ok(b.modulo(index, address));
                }
                let last = b.constant(address.max_raw(), address);
                let inside = clamped(b, index, last);
                Ok(b.modulo(inside, address))
            };
            if !bilinear {
                return Ok(vec![texel(b, first)?]);
            }
            let one = b.constant(1, Format::FLAG);
            let second = b.add(first, one);
            let kept = Format::signed(whole + fraction_bits, cast::signed_count(fraction_bits))?;
            let position = b.narrow(exact, kept, Round::Floor, Overflow::Wrap);
            b.name(position, "position");
            let fraction = b.modulo(position, Format::turns(fraction_bits)?); // 0 to 1
            Ok(vec![texel(b, first)?, texel(b, second)?, fraction])
        })?;
        let names = if bilinear { &names[1..] } else { &names[..1] };
        outputs.extend(names.iter().copied().zip(found));
    }
    for (name, node) in &outputs {
        b.name(*node, name);
        b.output(name, *node);
    }
    let bounds = if bilinear {
        vec![
            Bound::new("texel", ["i0", "i1", "j0", "j1"], |_, _| 0.0),
            Bound::new("fraction", ["a", "b"], fraction_bound),
        ]
    } else {
        vec![Bound::new("texel", ["i", "j"], |_, _| 0.0)]
    };
    Ok(Design::new(values, b.build()?)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(draw)
        .hard(hard_cases(values, coordinate))
        .bounds(Bounds::Stated(bounds)))
}

/// A word clamped to 0 to `last`, by a comparator and two multiplexers.
pub(super) fn clamped(b: &mut Builder, word: NodeId, last: NodeId) -> NodeId {
    let zero = b.constant(0, Format::FLAG);
    let above = b.less(last, word);
    let below = b.negative(word);
    let most = b.mux(above, last, word);
    b.mux(below, zero, most)
}

/// The truncated part of the position: less than an ulp, and nothing if the coordinate has no more
/// bits.
fn fraction_bound(values: &Values, _: &dyn Fn(&str) -> f64) -> f64 {
    let ulp = |bits: i64| 2f64.powi(-i32::try_from(bits).expect("bug: counts are small"));
    let bits = |name| i64::from(values.bits(name));
    let kept = bits("fraction_bits");
    // Fraction bits of the position; at least one, for the half texel.
    let side = bits("log2_width").min(bits("log2_height"));
    let exact = (bits("frac_bits") - side).max(1);
    if exact <= kept { 0.0 } else { ulp(kept) - ulp(exact) }
}

/// The golden model: floors and remainders of the exact position.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let bilinear = values.choice("filter") == "bilinear";
    let axes = AXES.map(|(_, address, log2, ..)| {
        let side = F::from(1u32 << values.bits(log2)).expect("bug: floats hold it");
        (values.choice(address) == "clamp", side)
    });
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let per_axis = outputs.len() / 2;
        for ((coordinates, columns), (clamp, side)) in
            inputs.iter().zip(outputs.chunks_mut(per_axis)).zip(axes)
        {
            let texel = |index: F| {
                if clamp {
                    index.max(F::zero()).min(side - F::one())
                } else {
                    index - side * (index / side).floor()
                }
            };
            for (i, s) in coordinates.iter().enumerate() {
                if !bilinear {
                    columns[0][i] = texel((*s * side).floor());
                    continue;
                }
                let position = *s * side - F::from(0.5).expect("bug: floats hold it");
                columns[0][i] = texel(position.floor());
                columns[1][i] = texel(position.floor() + F::one());
                columns[2][i] = position - position.floor();
            }
        }
    })
}

/// Coordinates uniform over their range.
fn draw(values: &Values, _: &InputPorts<'_>) -> Draw {
    let reach = 2f64.powi(cast::signed_count(values.bits("int_bits")));
    Draw::new(move |_, uniform, columns, count| {
        columns.iter_mut().for_each(Vec::clear);
        for _ in 0..count {
            for column in &mut *columns {
                column.push(reach * (2.0 * uniform.draw() - 1.0));
            }
        }
    })
}

/// The named hard cases.
fn hard_cases(values: &Values, coordinate: Format) -> Vec<HardCase> {
    let (min, max) = (coordinate.min_raw(), coordinate.max_raw());
    let one = 1i64 << values.bits("frac_bits");
    let near = |word: i64| [word - 2, word - 1, word, word + 1, word + 2];
    // Each word on both axes, and on one axis with another value on the other.
    let cases = |name, words: Vec<i64>| {
        let words = words.into_iter().filter(|word| (min..=max).contains(word));
        let both = words.flat_map(|word| [vec![word, word], vec![word, 0], vec![max / 3, word]]);
        HardCase::new(name, both.collect())
    };
    let texels = |halves: i64| -> Vec<i64> {
        let sides = ["log2_width", "log2_height"].map(|log2| values.bits(log2));
        let at = |log2: u32| {
            [0, 1, 2, 3, (1i64 << log2) - 2, (1i64 << log2) - 1].map(|texel| {
                let halves = i128::from(2 * texel + halves) * i128::from(one);
                cast::low_i64(halves >> (log2 + 1))
            })
        };
        sides.into_iter().flat_map(at).flat_map(|word| [word, word - one]).flat_map(near).collect()
    };
    vec![
        cases("centres of texels, and a word or two off", texels(1)),
        cases("borders between texels, and a word or two off", texels(0)),
        cases(
            "ends of the map: 0 and ±1, and a word or two off",
            [0, one, -one].into_iter().flat_map(near).collect(),
        ),
        cases(
            "the first and the last word, and a word or two off",
            [min, max].into_iter().flat_map(near).collect(),
        ),
        cases(
            "far outside, on both sides",
            [min / 2, max / 2, -3 * one, 3 * one].into_iter().flat_map(near).collect(),
        ),
    ]
}
