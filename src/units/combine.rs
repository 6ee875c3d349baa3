//! The texture combiner of the emboss family: a bump is the difference of two height map samples.
//!
//! `out = clamp(diffuse + Σ (h(S0, T0) - h(S1, T1)) · 2^gain_log2)`, for each channel, summed over
//! the lights (US 6,980,218: the undisplaced sample less the displaced one; each light has its own
//! displaced sample). `GL_NV_texgen_emboss` and the patents' own sign of L displace away from the
//! light. There the displaced sample less the undisplaced one is bright toward the light:
//! `difference=displaced-undisplaced`. Texels and channels are codes of `channel_bits`, 0 to
//! 2^channel_bits - 1. Differences and their sum are signed and as wide as needed; only the result
//! is clamped.
//!
//! A bilinear sample is three linear interpolations, top and bottom along a and then along b:
//! `p + x (q - p)`, each rounded to `guard_bits`. An interpolated value lies between its ends, so
//! the error of an earlier interpolation isn't amplified.

use super::parts::plan::rounding_ulp;
use super::sampler::{clamped, filter, fraction_bits};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Draw, Golden, HardCase, InputPorts, Param, Role, Unit, Values,
};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("combine", "diffuse light plus the differences of height samples: the emboss of one to eight lights")
        .source("US 6,980,218, the texture combination of the emboss; US 7,307,640 has the same text")
        .formula(
            "out = clamp(diffuse + sum over lights of (h - d) 2^gain_log2), for each channel\n\
         h: undisplaced sample, d: displaced one of each light\n\
         difference=displaced-undisplaced: d - h instead of h - d\n\
         bilinear: top = h_00 + a (h_10 - h_00), bottom = h_01 + a (h_11 - h_01), h = top + b (bottom - top)",
        )
        .params([
            filter(),
            Param::int("lights", 1..=MAX_LIGHTS)
                .role(Role::Count)
                .help("number of displaced samples, one for each light"),
            Param::choice("difference", ["undisplaced-displaced", "displaced-undisplaced"])
                .help("sign of the difference: undisplaced-displaced for displacements toward the light, the other for displacements away from it"),
            Param::bits("channel_bits", 1..=16)
                .default(8)
                .help("bits of texels and of the light's channels, in and out"),
            fraction_bits(),
            Param::bits("guard_bits", 0..=16)
                .default(4)
                .help("fraction bits of interpolated heights (bilinear)"),
            Param::int("gain_log2", -8..=8).default(0).help("differences are multiplied by 2^gain_log2"),
            Param::rounding("rounding"),
        ])
        .inputs("h and d0 … d7: texels of the undisplaced sample and of each light's displaced one (nearest); or h_00, h_10, h_01, h_11 (column 0 or 1, then row), h_a, h_b (fractions), and likewise d0_00 … d7_b (bilinear); r, g, b: diffuse light")
        .outputs("out_r, out_g, out_b: codes as for texels, clamped")
        .design(design)
}

/// Maximum number of lights: the patent's API counts them from 0 to 7.
const MAX_LIGHTS: i64 = 8;

/// Suffixes of the ports of a bilinear sample: its texels by column and row, and its fractions.
const CORNERS: [&str; 4] = ["00", "10", "01", "11"];
const FRACTIONS: [&str; 2] = ["a", "b"];
const CHANNELS: [&str; 3] = ["r", "g", "b"];
const OUTPUTS: [&str; 3] = ["out_r", "out_g", "out_b"];

/// True if the undisplaced sample is subtracted from the displaced ones.
fn is_reversed(values: &Values) -> bool {
    values.choice("difference") == "displaced-undisplaced"
}

/// Names of the samples: the undisplaced one, then one for each light.
fn samples(values: &Values) -> Vec<String> {
    let lights = values.bits("lights");
    std::iter::once("h".to_owned()).chain((0..lights).map(|light| format!("d{light}"))).collect()
}

fn design(values: &Values) -> Result<Design> {
    let bilinear = values.choice("filter") == "bilinear";
    let code = Format::integer(values.bits("channel_bits"))?;
    let round = values.rounding("rounding");
    let mut b = values.builder("combine");
    let fraction = Format::turns(values.bits("fraction_bits"))?;
    let port = |b: &mut Builder, name: &str, format| b.input(name, format, Quantity::Number);
    let ports: Vec<Vec<NodeId>> = samples(values)
        .iter()
        .map(|name| {
            if !bilinear {
                return vec![port(&mut b, name, code)];
            }
            let corners = CORNERS.map(|corner| port(&mut b, &format!("{name}_{corner}"), code));
            let fractions = FRACTIONS.map(|way| port(&mut b, &format!("{name}_{way}"), fraction));
            [&corners[..], &fractions[..]].concat()
        })
        .collect();
    let diffuse = CHANNELS.map(|channel| port(&mut b, channel, code));
    let heights = samples(values)
        .iter()
        .zip(&ports)
        .map(|(name, ports)| match ports[..] {
            [p, q, r, s, x, y] => b.scope(name, |b| -> Result<NodeId> {
                let top = lerp(b, values, [p, q], x)?;
                let bottom = lerp(b, values, [r, s], x)?;
                let height = lerp(b, values, [top, bottom], y)?;
                Ok(b.name(height, "height"))
            }),
            _ => Ok(ports[0]),
        })
        .collect::<Result<Vec<_>>>()?;
    let (undisplaced, displaced) = heights.split_first().expect("bug: h is there");
    let reversed = is_reversed(values);
    let difference = |d: &NodeId| {
        if reversed { b.sub(*d, *undisplaced) } else { b.sub(*undisplaced, *d) }
    };
    let differences: Vec<NodeId> = displaced.iter().map(difference).collect();
    let relief = differences.into_iter().reduce(|sum, next| b.add(sum, next));
    let relief = relief.expect("bug: a light is there");
    b.name(relief, "relief");
    let gain = i32::try_from(values.int("gain_log2").expect("bug: no auto here"));
    let relief = b.shift(relief, gain.expect("bug: a small number"));
    let last = b.constant(code.max_raw(), code);
    let out = diffuse.map(|channel| {
        let sum = b.add(channel, relief); // signed, as a difference of codes
        let format = b.format(sum);
        let whole = format.int_bits().unsigned_abs() + 2; // one for rounding up, one for the sign
        let format = Format::signed(whole, 0);
        let format = b.checked(format);
        let rounded = b.narrow(sum, format, round, Overflow::Wrap);
        let inside = clamped(&mut b, rounded, last);
        b.modulo(inside, code)
    });
    for (name, node) in OUTPUTS.iter().zip(out) {
        b.name(node, name);
        b.output(name, node);
    }
    Ok(Design::new(values, b.build()?)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(draw)
        .hard(hard_cases(values))
        .bounds(Bounds::Stated(vec![Bound::new("channel", OUTPUTS, channel_bound)])))
}

/// `p + x (q - p)`, rounded to `guard_bits` fraction bits if it has more.
fn lerp(b: &mut Builder, values: &Values, [p, q]: [NodeId; 2], x: NodeId) -> Result<NodeId> {
    let step = b.sub(q, p);
    let part = b.mul(step, x);
    let exact = b.add(p, part);
    // Between p and q, so not negative and below 2^channel_bits, even when rounded up.
    let frac = values.bits("guard_bits").min(b.format(exact).frac_bits().unsigned_abs());
    let between = Format::unsigned(values.bits("channel_bits") + frac, cast::signed_count(frac))?;
    Ok(b.narrow(exact, between, values.rounding("rounding"), Overflow::Wrap))
}

/// Bound in codes: up to two roundings of each sample, and the last one.
fn channel_bound(values: &Values, _: &dyn Fn(&str) -> f64) -> f64 {
    let gain_log2 = values.int("gain_log2").expect("bug: no auto here");
    let gain = 2f64.powi(i32::try_from(gain_log2).expect("bug: a small number"));
    let guard = values.bits("guard_bits");
    let (roundings, frac_bits) = match (values.choice("filter"), values.bits("fraction_bits")) {
        ("nearest", _) => (0, 0),
        // Along a, the exact result has the bits of the fraction; along b, those plus the bits kept
        // after a.
        (_, along) => {
            let both = along.min(guard) + along;
            (u8::from(along > guard) + u8::from(both > guard), both.min(guard))
        }
    };
    // A rounding is off by up to half an ulp to either side, or by up to one ulp to one side: the
    // errors of two samples differ by at most one ulp in either case.
    let ulp = 2f64.powi(-cast::signed_count(guard));
    let relief = f64::from(values.bits("lights")) * gain * f64::from(roundings) * ulp;
    let is_whole = i64::from(frac_bits) <= gain_log2;
    relief + if is_whole { 0.0 } else { rounding_ulp(values) }
}

/// The golden model: bilinear interpolation, differences, and a clamp, without any rounding.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let per_sample = if values.choice("filter") == "bilinear" { 6 } else { 1 };
    let reversed = is_reversed(values);
    let gain_log2 = values.int("gain_log2").expect("bug: no auto here");
    let gain = F::from(2).expect("bug: floats hold it").powi(i32::try_from(gain_log2).unwrap_or(0));
    let most = F::from((1u32 << values.bits("channel_bits")) - 1).expect("bug: floats hold it");
    Golden::new(move |inputs, outputs| {
        let (samples, diffuse) = inputs.split_at(inputs.len() - 3);
        for i in 0..diffuse[0].len() {
            let height = |columns: &[&[F]]| {
                if let [p, q, r, s, x, y] = columns {
                    let one = F::one();
                    p[i] * (one - x[i]) * (one - y[i])
                        + q[i] * x[i] * (one - y[i])
                        + r[i] * (one - x[i]) * y[i]
                        + s[i] * x[i] * y[i]
                } else {
                    columns[0][i]
                }
            };
            let heights: Vec<F> = samples.chunks(per_sample).map(height).collect();
            let relief = heights[1..].iter().fold(F::zero(), |sum, d| sum + (heights[0] - *d));
            let relief = if reversed { -relief } else { relief };
            for (output, channel) in outputs.iter_mut().zip(diffuse) {
                output[i] = (channel[i] + gain * relief).max(F::zero()).min(most);
            }
        }
    })
}

/// Uniform codes and fractions.
fn draw(_: &Values, ports: &InputPorts<'_>) -> Draw {
    let formats: Vec<Format> = (0..ports.len()).map(|at| ports.format(at)).collect();
    Draw::new(move |_, uniform, columns, count| {
        columns.iter_mut().for_each(Vec::clear);
        for _ in 0..count {
            for (column, format) in columns.iter_mut().zip(&formats) {
                let fraction = format.frac_bits() > 0;
                // Fractions are real numbers; codes are integers.
                let codes = cast::f64_of_count(format.words());
                column.push(if fraction {
                    uniform.draw()
                } else {
                    (uniform.draw() * codes).floor()
                });
            }
        }
    })
}

/// The named hard cases.
fn hard_cases(values: &Values) -> Vec<HardCase> {
    let bilinear = values.choice("filter") == "bilinear";
    let lights = usize::try_from(values.bits("lights")).expect("bug: a small number");
    let most = (1i64 << values.bits("channel_bits")) - 1;
    let last = (1i64 << values.bits("fraction_bits")) - 1;
    let (half, small) = ((last + 1) / 2, most.min(1));
    // Texels of the undisplaced sample, texels of the displaced ones, fractions of both, diffuse
    // light.
    type Case = ([i64; 4], [i64; 4], [i64; 2], [i64; 2], [i64; 3]);
    let words = |(h, d, fractions, others, diffuse): Case| -> Vec<i64> {
        let sample = |texels: [i64; 4], fractions: [i64; 2]| {
            if bilinear { [&texels[..], &fractions].concat() } else { texels[..1].to_vec() }
        };
        let mut words = sample(h, fractions);
        (0..lights).for_each(|_| words.extend(sample(d, others)));
        words.extend(diffuse);
        words
    };
    let cases = |name, list: Vec<Case>| HardCase::new(name, list.into_iter().map(words).collect());
    let channels = [0, small, most / 2, most - small, most];
    let ends = [0, half, last];
    let (mut flat, mut clamps, mut ties, mut cliffs) = (vec![], vec![], vec![], vec![]);
    for a in ends {
        for b in ends {
            for channel in channels {
                let diffuse = [channel, most - channel, channel / 2];
                for h in channels {
                    flat.push(([h; 4], [h; 4], [a, b], [b, a], diffuse));
                    for d in [0, most] {
                        clamps.push(([h; 4], [d; 4], [a, b], [b, a], diffuse));
                    }
                    // To the limit, one above it, and one below it.
                    let d = (h + channel).min(most);
                    for d in [d - small, d, d + small].map(|d| d.clamp(0, most)) {
                        clamps.push(([h; 4], [d; 4], [a, b], [a, b], [channel; 3]));
                    }
                }
                let step = [0, small, 0, small];
                for other in [[0; 4], [small; 4]] {
                    ties.push((step, other, [half, b], [a, b], diffuse));
                    ties.push((other, step, [a, b], [half, b], diffuse));
                }
                for corner in 0..4 {
                    let mut cliff = [0; 4];
                    cliff[corner] = most;
                    let pit = cliff.map(|texel| most - texel);
                    cliffs.push((cliff, pit, [a, b], [b, a], diffuse));
                    cliffs.push((pit, cliff, [b, a], [a, b], diffuse));
                }
            }
        }
    }
    vec![
        cases("equal heights: the diffuse light itself", flat),
        cases("the clamp: far past it, at it, and one code off", clamps),
        cases("rounding ties, both signs", ties),
        cases("one texel against three, at the ends of both fractions", cliffs),
    ]
}
