//! Whole numbers as people write them: `1000000`, `1_000_000`, `1e6`, `2^20`.

/// The number that a text denotes; `None` if it has another form or doesn't fit in 64 bits.
pub(crate) fn parse(text: &str) -> Option<u64> {
    if let Some((base, exponent)) = text.split_once('^') {
        return digits(base)?.checked_pow(digits(exponent)?.try_into().ok()?);
    }
    let Some((mantissa, exponent)) = text.split_once(['e', 'E']) else { return digits(text) };
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let part = part.trim_end_matches('0');
    let exponent: u32 = digits(exponent.strip_prefix('+').unwrap_or(exponent))?.try_into().ok()?;
    // 1.5e6 is 15 times 10^5.
    let exponent = exponent.checked_sub(part.len().try_into().ok()?)?;
    match digits(&format!("{whole}{part}"))? {
        0 => Some(0),
        number => number.checked_mul(10u64.checked_pow(exponent)?),
    }
}

/// Digits with single `_` between them.
fn digits(text: &str) -> Option<u64> {
    let groups = || text.split('_');
    let legal = |group: &str| !group.is_empty() && group.bytes().all(|byte| byte.is_ascii_digit());
    groups().all(legal).then(|| groups().collect::<String>().parse().ok())?
}

/// [`parse`] with an optional sign.
pub(crate) fn signed(text: &str) -> Option<i64> {
    match text.strip_prefix('-') {
        Some(magnitude) => 0i64.checked_sub_unsigned(parse(magnitude)?),
        None => parse(text.strip_prefix('+').unwrap_or(text))?.try_into().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_of_one_number() {
        for text in ["1000000", "1_000_000", "1e6", "1E6", "1e+6", "1.0e6", "10_0e4", "10^6"] {
            assert_eq!(parse(text), Some(1_000_000), "{text}");
        }
        assert_eq!(parse("2^20"), Some(1 << 20));
        assert_eq!(parse("1.25e2"), Some(125));
        assert_eq!(parse("0e99"), Some(0));
        assert_eq!(parse("18446744073709551615"), Some(u64::MAX));
        assert_eq!((signed("-1e3"), signed("+7")), (Some(-1000), Some(7)));
        assert_eq!(signed("-9223372036854775808"), Some(i64::MIN));
        for text in ["--1", "-", "-1.5", "9223372036854775808", "-9223372036854775809"] {
            assert_eq!(signed(text), None, "{text}");
        }
        for text in [
            "",
            "-1",
            "+1",
            "1.5",
            "1.25e1",
            "1e-3",
            "1e20",
            "2^64",
            "_1",
            "1_",
            "1__0",
            "1e",
            "e6",
            "1e6e1",
            "2^",
            "^2",
            "2^2^2",
            "1 000",
            "0x10",
            "１",
            "inf",
            "18446744073709551616",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
