//! Formats of texture coordinates and of Ks and Kt.

use super::switches::{Constants, Switches};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::Values;
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::units::parts::plan::number;

/// Maximum integer bits of Ks and Kt.
pub(super) const MAX_CONSTANT_INT_BITS: u32 = 17;

/// Maximum magnitude of Ks and Kt, so that each fits some format.
pub(super) const MAX_CONSTANT: f64 = 65_536.0;

/// Fraction bits of Ks and Kt if they have few integer bits, and the maximum of integer and
/// fraction bits together. With these limits, the products with q and with a displacement fit into
/// words.
const CONSTANT_FRAC_BITS: u32 = 20;

const CONSTANT_BITS: u32 = 26;

/// Extra fraction bits of a displacement before its factor.
pub(super) const UNIT_GUARD_BITS: i32 = 2;

/// Format of texture coordinates.
pub(super) fn texture(values: &Values) -> Result<Format> {
    number(values.bits("texture_int_bits"), values.bits("texture_frac_bits"))
}

/// Format of Ks or Kt, by name. With `constant_int_bits=auto` each gets its own integer bits, and
/// so its own fraction bits.
///
/// # Errors
/// If it doesn't hold the constant; the message names one that does.
pub(super) fn constant(values: &Values, switches: Switches, name: &str) -> Result<Format> {
    let format = |int_bits: u32| {
        let few = CONSTANT_FRAC_BITS.min(CONSTANT_BITS.saturating_sub(int_bits));
        let frac_bits = values.int("constant_frac_bits");
        let frac_bits = frac_bits.map_or(few, |_| values.bits("constant_frac_bits"));
        number(int_bits, frac_bits)
    };
    let is_held = |format: Format| {
        switches.constants != Constants::Parameters
            || quantize(values.real(name), format, Round::HalfEven, Overflow::Error).is_ok()
    };
    let enough = |bits: &u32| format(*bits).is_ok_and(is_held);
    let asked = (1..=MAX_CONSTANT_INT_BITS).find(enough).unwrap_or(MAX_CONSTANT_INT_BITS);
    let int_bits = match values.int("constant_int_bits") {
        Some(_) => values.bits("constant_int_bits"),
        None => asked,
    };
    let format = format(int_bits)?;
    if !is_held(format) {
        return Err(values.refuse(
            name,
            &format!(
                "{} to {} in format {format} of constant_int_bits={int_bits}; constant_int_bits={asked} holds it",
                cast::f64_of(format.min_raw()) * format.ulp(),
                cast::f64_of(format.max_raw()) * format.ulp(),
            ),
        ));
    }
    Ok(format)
}

/// Texture coordinates are below this in magnitude.
pub(super) fn texture_limit(values: &Values) -> f64 {
    libm::exp2(values.bits("texture_int_bits").into())
}
