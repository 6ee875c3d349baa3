//! The one rule for all names, since any of them can end up in hardware and waves.

/// The rule, phrased to follow `a name is`.
pub(crate) const RULE: &str =
    "a letter a to z, then a to z, 0 to 9 and single _ between them, at most 64 characters";

/// Maximum characters.
const MAX_LEN: usize = 64;

/// True for names that are legal in Verilog, VHDL, C++ and VCD, but for their keywords.
pub(crate) fn is_legal(name: &str) -> bool {
    name.len() <= MAX_LEN
        && name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_')
        && !name.ends_with('_')
        && !name.contains("__")
}

/// A name with something appended, which takes the place of its end where both are too long.
pub(crate) fn with_suffix(name: &str, suffix: &str) -> String {
    let kept = name.get(..MAX_LEN - suffix.len()).unwrap_or(name);
    format!("{}{suffix}", kept.trim_end_matches('_'))
}

/// The first of a name, `name_2`, `name_3` and so on that `is_free`.
pub(crate) fn numbered(name: &str, mut is_free: impl FnMut(&str) -> bool) -> String {
    let numbers = (2..).map(|n| with_suffix(name, &format!("_{n}")));
    std::iter::once(with_suffix(name, ""))
        .chain(numbers)
        .find(|name| is_free(name))
        .expect("bug: there is no end of numbers")
}
