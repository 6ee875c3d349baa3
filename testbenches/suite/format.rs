//! Formats, `narrow` and `quantize` against rounding of real numbers.
//!
//! The oracle rounds reals by comparing them with the middle of two integers; it shares nothing
//! with the crate. At these sizes all its numbers are exact in `f64`.

use fixed::types::{I4F4, I8F8, U4F4, U8F8};
use fixpath::format::{Format, Overflow, Round, addr_bits, bit_len, narrow, quantize};

/// `x` rounded to an integer.
pub(crate) fn rounded(x: f64, round: Round) -> f64 {
    let (below, above) = (x.floor(), x.ceil());
    let middle = below + 0.5;
    let nearest = |at_tie: f64| {
        if x < middle {
            below
        } else if x > middle {
            above
        } else {
            at_tie
        }
    };
    match round {
        Round::Floor => below,
        Round::TowardZero => x.trunc(),
        Round::HalfUp => nearest(above),
        Round::HalfAway => nearest(if x < 0.0 { below } else { above }),
        Round::HalfEven => nearest(if below % 2.0 == 0.0 { below } else { above }),
    }
}

/// Least and greatest integer of a format, from its printed form alone.
fn limits(to: Format) -> (f64, f64) {
    let span = 2f64.powi(to.bits() as i32);
    if to.is_signed() { (-span / 2.0, span / 2.0 - 1.0) } else { (0.0, span - 1.0) }
}

/// The word for an integer number of ulps, and whether it overflowed.
fn fitted(whole: f64, to: Format, overflow: Overflow) -> (i64, bool) {
    let (mut lo, hi) = limits(to);
    if overflow == Overflow::Symmetric && to.is_signed() {
        lo = -hi;
    }
    let overflowed = whole < lo || whole > hi;
    let word = match overflow {
        Overflow::Saturate | Overflow::Symmetric => whole.clamp(lo, hi),
        Overflow::Wrap | Overflow::Error => {
            let span = 2f64.powi(to.bits() as i32);
            let mut residue = whole.rem_euclid(span);
            if residue > hi {
                residue -= span;
            }
            residue
        }
    };
    (word as i64, overflowed)
}

fn oracle(value: f64, to: Format, round: Round, overflow: Overflow) -> (i64, bool) {
    fitted(rounded(value * 2f64.powi(to.frac_bits()), round), to, overflow)
}

fn formats(bits: std::ops::RangeInclusive<u32>, fracs: &[i32]) -> Vec<Format> {
    let mut formats = Vec::new();
    for signed in [false, true] {
        for bits in bits.clone() {
            formats.extend(fracs.iter().map(|frac| Format::new(signed, bits, *frac).unwrap()));
        }
    }
    formats
}

fn modes() -> impl Iterator<Item = (Round, Overflow)> {
    Round::ALL.iter().flat_map(|r| Overflow::ALL.iter().map(|o| (*r, *o)))
}

#[test]
fn narrow_is_rounding_of_the_real_number_on_every_small_word() {
    let sources = formats(1..=6, &[-2, -1, 0, 1, 2, 3, 4, 5, 6]);
    let targets = formats(1..=5, &[-3, -1, 0, 1, 2, 4, 7]);
    for from in sources {
        for raw in from.min_raw()..=from.max_raw() {
            let value = raw as f64 * 2f64.powi(-from.frac_bits());
            for to in &targets {
                for (round, overflow) in modes() {
                    assert_eq!(
                        narrow(raw, from.frac_bits(), *to, round, overflow),
                        oracle(value, *to, round, overflow),
                        "{raw} of {from} to {to} {round} {overflow}"
                    );
                }
            }
        }
    }
}

#[test]
fn narrow_at_the_ends_of_wide_words() {
    let raws = [i64::MIN, i64::MIN + 1, -(1 << 62), -1, 0, 1, 1 << 62, i64::MAX - 1, i64::MAX];
    for bits in [1, 2, 31, 32, 33, 62, 63] {
        for signed in [false, true] {
            for shift in -127i32..=127 {
                let to = Format::new(signed, bits, 0).unwrap();
                for raw in raws {
                    for (round, overflow) in modes() {
                        let (word, overflowed) = narrow(raw, shift, to, round, overflow);
                        assert!(to.contains(word));
                        let exact = wide_oracle(raw, shift, to, round, overflow);
                        assert_eq!(
                            (word, overflowed),
                            exact,
                            "{raw} >> {shift} to {to} {round} {overflow}"
                        );
                    }
                }
            }
        }
    }
}

/// Like [`oracle`], for words beyond 53 bits: Euclidean division by the step in `i128`.
fn wide_oracle(raw: i64, shift: i32, to: Format, round: Round, overflow: Overflow) -> (i64, bool) {
    let (lo, hi) = if to.is_signed() {
        (-(1i128 << (to.bits() - 1)), (1i128 << (to.bits() - 1)) - 1)
    } else {
        (0, (1i128 << to.bits()) - 1)
    };
    let lo = if overflow == Overflow::Symmetric && to.is_signed() { -hi } else { lo };
    // |raw| <= 2^63: a step of 2^70 gives the same quotient and side of the middle as any larger
    // step. From 2^64 ulps up, the low bits of the word are always 0.
    let whole = if shift > 0 {
        let step = 1i128 << shift.min(70);
        let (below, rest) = (i128::from(raw).div_euclid(step), i128::from(raw).rem_euclid(step));
        let above = if rest == 0 { below } else { below + 1 };
        match (round, (2 * rest).cmp(&step)) {
            (Round::Floor, _) => below,
            (Round::TowardZero, _) => i128::from(raw) / step,
            (_, std::cmp::Ordering::Less) => below,
            (_, std::cmp::Ordering::Greater) | (Round::HalfUp, _) => above,
            (Round::HalfAway, _) => {
                if raw < 0 {
                    below
                } else {
                    above
                }
            }
            (Round::HalfEven, _) => {
                if below % 2 == 0 {
                    below
                } else {
                    above
                }
            }
        }
    } else {
        i128::from(raw) * (1i128 << (-shift).min(63))
    };
    let overflowed = whole < lo || whole > hi;
    let word = match overflow {
        Overflow::Saturate | Overflow::Symmetric => whole.clamp(lo, hi),
        Overflow::Wrap | Overflow::Error => {
            let residue = whole.rem_euclid(1 << to.bits());
            if residue > hi { residue - (1 << to.bits()) } else { residue }
        }
    };
    (i64::try_from(word).unwrap(), overflowed)
}

fn check_quantize(value: f64, to: Format) {
    for (round, overflow) in modes() {
        let expected = oracle(value, to, round, overflow);
        let given = quantize(value, to, round, overflow);
        if overflow == Overflow::Error && expected.1 {
            let message = given.unwrap_err().to_string();
            assert!(message.contains("overflows format"), "{message}");
        } else {
            let given = given.unwrap();
            assert_eq!(given, expected, "{value:e} to {to} {round} {overflow}");
        }
    }
}

#[test]
fn quantize_is_rounding_of_the_real_number_on_a_fine_grid() {
    for to in formats(1..=5, &[-3, -1, 0, 1, 4]) {
        let ulp = 2f64.powi(-to.frac_bits());
        let (lo, hi) = limits(to);
        // 16 steps per ulp hit every tie; the range extends two ulps beyond each end.
        for step in (16 * (lo as i64 - 2))..=(16 * (hi as i64 + 2)) {
            let value = step as f64 / 16.0 * ulp;
            check_quantize(value, to);
            if step != 0 {
                check_quantize(value.next_up(), to);
                check_quantize(value.next_down(), to);
            }
        }
    }
}

#[test]
fn quantize_next_to_ties_and_far_away() {
    let formats = formats(1..=5, &[-3, 0, 4]);
    for to in &formats {
        for value in [0.0, -0.0, 1e-300, -1e-300, 1e-30, -1e-30] {
            check_quantize(value, *to);
        }
        for value in [1e300, -1e300, f64::MAX, f64::MIN, 2f64.powi(126), 2f64.powi(62)] {
            check_quantize(value, *to);
        }
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = quantize(value, *to, Round::Floor, Overflow::Wrap).unwrap_err();
            assert_eq!(
                error.to_string(),
                format!("{value} can't be written in format {to}: give a finite number")
            );
        }
    }
    // Wide formats: words around 2^53, above which every f64 is an integer, and the ends.
    let s63 = Format::signed(63, 0).unwrap();
    let mode = (Round::HalfEven, Overflow::Saturate);
    assert_eq!(quantize(2f64.powi(53), s63, mode.0, mode.1).unwrap(), (1 << 53, false));
    assert_eq!(quantize(2f64.powi(62), s63, mode.0, mode.1).unwrap(), (s63.max_raw(), true));
    assert_eq!(quantize(-(2f64.powi(62)), s63, mode.0, mode.1).unwrap(), (s63.min_raw(), false));
    let fine = Format::signed(63, 127).unwrap();
    for round in Round::ALL {
        assert_eq!(quantize(1e300, fine, *round, Overflow::Wrap).unwrap(), (0, true));
        let tiny = quantize(-5e-324, fine, *round, Overflow::Wrap).unwrap();
        assert_eq!(tiny, (if *round == Round::Floor { -1 } else { 0 }, false));
    }
    let coarse = Format::signed(8, -127).unwrap();
    for round in Round::ALL {
        let tiny = quantize(-5e-324, coarse, *round, Overflow::Wrap).unwrap();
        assert_eq!(tiny, (if *round == Round::Floor { -1 } else { 0 }, false), "{round}");
        let tiny = quantize(5e-324, coarse, *round, Overflow::Wrap).unwrap();
        assert_eq!(tiny, (0, false));
    }
}

#[test]
fn values_are_exact_or_refused() {
    for format in formats(1..=6, &[-2, 0, 3, 6]) {
        for raw in format.min_raw()..=format.max_raw() {
            let value = raw as f64 * 2f64.powi(-format.frac_bits());
            assert_eq!(format.exact_value(raw).unwrap(), value);
            assert_eq!(format.value(raw), value);
        }
        for outside in [format.min_raw() - 1, format.max_raw() + 1] {
            let message = format.exact_value(outside).unwrap_err().to_string();
            let (min, max) = (format.min_raw(), format.max_raw());
            assert_eq!(
                message,
                format!("word {outside} is outside format {format} ({min}..={max})")
            );
        }
    }
    let wide = Format::signed(63, 20).unwrap();
    let most = (1i64 << 53) - 1; // 53 significant bits
    assert_eq!(wide.exact_value(most).unwrap(), most as f64 / 1048576.0);
    assert_eq!(wide.exact_value(-(most << 9)).unwrap(), -(most as f64) / 2048.0);
    for raw in [(1i64 << 53) + 1, -(1 << 53) - 1] {
        assert_eq!(
            wide.exact_value(raw).unwrap_err().to_string(),
            format!(
                "word {raw} of format s63f20 needs 54 significant bits and an f64 holds 53: use the raw word"
            )
        );
    }
    assert_eq!(wide.exact_value(wide.min_raw()).unwrap(), -(2f64.powi(42)));
}

#[test]
fn wrapping_keeps_the_low_bits_at_every_width() {
    for signed in [false, true] {
        for bits in 1..=63 {
            let format = Format::new(signed, bits, 0).unwrap();
            let mut raws = vec![i64::MIN, i64::MAX, -1, 0, 1, 0x5555_5555_5555_5555];
            raws.extend([format.min_raw(), format.max_raw()]);
            raws.extend([format.min_raw().wrapping_sub(1), format.max_raw().wrapping_add(1)]);
            for raw in raws {
                let word = format.wrap(raw);
                assert!(format.contains(word), "{raw} in {format} is {word}");
                let difference = i128::from(word) - i128::from(raw);
                assert_eq!(difference % (1i128 << bits), 0, "{raw} in {format} is {word}");
                let pattern = i128::from(raw).rem_euclid(1 << bits);
                assert_eq!(i128::from(format.pattern(raw)), pattern);
            }
        }
    }
}

#[test]
fn every_format_prints_and_reads_back() {
    for signed in [false, true] {
        for bits in 1..=63 {
            for frac in -127..=127 {
                let format = Format::new(signed, bits, frac).unwrap();
                let text = format.to_string();
                assert_eq!(text.parse::<Format>().unwrap(), format, "{text}");
                let sign = if signed { "sfix" } else { "ufix" };
                let exponent = if frac > 0 { format!("n{frac}") } else { (-frac).to_string() };
                let other = format!("{sign}{bits}_E{exponent}");
                assert_eq!(other.parse::<Format>().unwrap(), format, "{other}");
            }
        }
    }
    for (text, signed, bits, frac) in [
        ("s16f14", true, 16, 14),
        ("u12f12", false, 12, 12),
        ("u8e2", false, 8, -2),
        ("sfix16_En14", true, 16, 14),
        ("ufix8_E2", false, 8, -2),
        ("sfix16", true, 16, 0),
    ] {
        let format = Format::new(signed, bits, frac).unwrap();
        assert_eq!(text.parse::<Format>().unwrap(), format, "{text}");
    }
    assert_eq!(format!("{:>8}|", Format::signed(4, 2).unwrap()), "    s4f2|");
}

#[test]
fn malformed_formats_are_refused() {
    for text in [
        "",
        "s",
        "u",
        "16",
        "f",
        "x16f14",
        "s16",
        "s16f",
        "sf14",
        "s16f-14",
        "s16f+1",
        "s+16f14",
        "s 16f14",
        "s16f14 ",
        " s16f14",
        "S16F14",
        "s16f14f2",
        "s16e",
        "s16e-2",
        "sfix",
        "sfix_En1",
        "sfix16_",
        "sfix16_E",
        "sfix16_En",
        "sfix16_En-1",
        "sfix16_e2",
        "s1６f2",
        "é8f2",
        "sfix16En14",
        "s99999999999f1",
        "s16f99999999999",
        "s1_6f2",
        "u0x8f1",
    ] {
        let message = text.parse::<Format>().unwrap_err().to_string();
        assert_eq!(
            message,
            format!("`{text}` is not a format: write s16f14, u12f12 or sfix16_En14")
        );
    }
    for (text, message) in [
        ("s0f0", "format of 0 bits: a format has 1 to 63 bits"),
        ("u64f0", "format of 64 bits: a format has 1 to 63 bits"),
        ("u300f0", "format of 300 bits: a format has 1 to 63 bits"),
        ("s8f128", "format with 128 fraction bits: fraction bits are from -127 to 127"),
        ("s8e128", "format with -128 fraction bits: fraction bits are from -127 to 127"),
    ] {
        assert_eq!(text.parse::<Format>().unwrap_err().to_string(), message);
    }
    for mode in Round::ALL {
        assert_eq!(mode.name().parse::<Round>().unwrap(), *mode);
    }
    for mode in Overflow::ALL {
        assert_eq!(mode.name().parse::<Overflow>().unwrap(), *mode);
    }
    let message = "up".parse::<Round>().unwrap_err().to_string();
    assert_eq!(
        message,
        "`up` is not of the form `floor` `toward-zero` `half-up` `half-away` `half-even`"
    );
}

#[test]
fn widths_at_powers_of_two() {
    assert_eq!((bit_len(0), bit_len(1), addr_bits(1), addr_bits(2)), (0, 1, 0, 1));
    assert_eq!(addr_bits(3), 2);
    for k in 2..=62u32 {
        let power = 1u64 << k;
        assert_eq!((bit_len(power - 1), bit_len(power), bit_len(power + 1)), (k, k + 1, k + 1));
        assert_eq!((addr_bits(power - 1), addr_bits(power), addr_bits(power + 1)), (k, k, k + 1));
    }
    assert_eq!((bit_len(u64::MAX), addr_bits(u64::MAX)), (64, 64));
}

#[test]
fn spanning_formats_hold_their_ends_and_are_the_smallest() {
    for lo in -40i128..=40 {
        for hi in lo..=40 {
            let format = Format::spanning(lo, hi, 3).unwrap();
            assert_eq!((format.is_signed(), format.frac_bits()), (lo < 0, 3));
            let holds = |f: Format| i128::from(f.min_raw()) <= lo && hi <= i128::from(f.max_raw());
            assert!(holds(format), "{lo}..={hi} in {format}");
            if format.bits() > 1 {
                let smaller = Format::new(lo < 0, format.bits() - 1, 3).unwrap();
                assert!(!holds(smaller), "{lo}..={hi} fits {smaller}");
            }
        }
    }
    assert_eq!(
        Format::spanning(0, i128::from(i64::MAX), 0),
        Format::unsigned(63, 0).map_err(|_| 0)
    );
    assert_eq!(Format::spanning(0, 1 << 63, 0), Err(64));
    assert_eq!(Format::spanning(-(1 << 62) - 1, 0, 0), Err(64));
}

/// The crate `fixed` rounds words whose types are known at compile time.
#[test]
fn narrow_agrees_with_crate_fixed_on_16_bit_words() {
    let to = Format::signed(8, 0).unwrap();
    let to_unsigned = Format::unsigned(8, 0).unwrap();
    for raw in i16::MIN..=i16::MAX {
        let x = I8F8::from_bits(raw);
        let whole = |x: I8F8| i64::from(x.to_bits() >> 8);
        let ours = |round, overflow| narrow(i64::from(raw), 8, to, round, overflow);
        for (round, (theirs, overflowed), saturated) in [
            (Round::Floor, x.overflowing_floor(), x.saturating_floor()),
            (Round::TowardZero, (x.round_to_zero(), false), x.round_to_zero()),
            (Round::HalfAway, x.overflowing_round(), x.saturating_round()),
            (Round::HalfEven, x.overflowing_round_ties_even(), x.saturating_round_ties_even()),
        ] {
            assert_eq!(ours(round, Overflow::Wrap), (whole(theirs), overflowed), "{raw} {round}");
            // Saturation in `fixed` keeps fraction bits; values that saturate there saturate here
            // too.
            let expected = if overflowed { i64::from(i8::MAX) } else { whole(saturated) };
            assert_eq!(ours(round, Overflow::Saturate), (expected, overflowed), "{raw} {round}");
        }
        let bits = raw as u16;
        let x = U8F8::from_bits(bits);
        let whole = |x: U8F8| i64::from(x.to_bits() >> 8);
        for (round, (theirs, overflowed)) in [
            (Round::Floor, x.overflowing_floor()),
            (Round::HalfUp, x.overflowing_round()),
            (Round::HalfEven, x.overflowing_round_ties_even()),
        ] {
            let ours = narrow(i64::from(bits), 8, to_unsigned, round, Overflow::Wrap);
            assert_eq!(ours, (whole(theirs), overflowed), "{bits} {round}");
        }
    }
}

#[test]
fn conversion_agrees_with_crate_fixed_on_16_bit_words() {
    let (s8f4, u8f4) = (Format::signed(8, 4).unwrap(), Format::unsigned(8, 4).unwrap());
    for raw in i16::MIN..=i16::MAX {
        let x = I8F8::from_bits(raw);
        let ours = |to, overflow| narrow(i64::from(raw), 8, to, Round::Floor, overflow);
        let (theirs, overflowed) = I4F4::overflowing_from_num(x);
        assert_eq!(ours(s8f4, Overflow::Wrap), (i64::from(theirs.to_bits()), overflowed));
        let theirs = I4F4::saturating_from_num(x);
        assert_eq!(ours(s8f4, Overflow::Saturate).0, i64::from(theirs.to_bits()));
        let (theirs, overflowed) = U4F4::overflowing_from_num(x);
        assert_eq!(ours(u8f4, Overflow::Wrap), (i64::from(theirs.to_bits()), overflowed));
        let theirs = U4F4::saturating_from_num(x);
        assert_eq!(ours(u8f4, Overflow::Saturate).0, i64::from(theirs.to_bits()));

        // From reals, `fixed` rounds half to even.
        let real = f64::from(raw) / 1024.0;
        let ours = |to, overflow| quantize(real, to, Round::HalfEven, overflow).unwrap();
        let (theirs, overflowed) = I4F4::overflowing_from_num(real);
        assert_eq!(ours(s8f4, Overflow::Wrap), (i64::from(theirs.to_bits()), overflowed), "{real}");
        let theirs = I4F4::saturating_from_num(real);
        assert_eq!(ours(s8f4, Overflow::Saturate).0, i64::from(theirs.to_bits()), "{real}");
        let (theirs, overflowed) = U4F4::overflowing_from_num(real);
        assert_eq!(ours(u8f4, Overflow::Wrap), (i64::from(theirs.to_bits()), overflowed), "{real}");
    }
}
