//! What names are: one rule for all that is named, since all of it can get into hardware and waves.

/// The rule, as it stands after `a name is`.
pub(crate) const RULE: &str =
    "a to z first, then a to z, 0 to 9 and single _ between them, up to 64 in all";

/// The most characters.
const MAX_LEN: usize = 64;

/// True for names that are legal in Verilog, VHDL, C++ and VCD, but for their keywords.
pub(crate) fn is_legal(name: &str) -> bool {
    name.len() <= MAX_LEN
        && name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_')
        && !name.ends_with('_')
        && !name.contains("__")
}
