//! The sRGB transfer function, from codes to linear light. The other direction searches its
//! thresholds (see `picture`) and needs no inverse.

/// Linear light, 0 to 1, from an sRGB code value, 0 to 1 (IEC 61966-2-1).
#[must_use]
pub fn from_srgb(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { libm::pow((code + 0.055) / 1.055, 2.4) }
}

#[cfg(test)]
mod tests {
    use super::from_srgb;

    #[test]
    fn values_of_the_standard() {
        assert_eq!((from_srgb(0.0), from_srgb(1.0)), (0.0, 1.0));
        assert!((from_srgb(0.5) - 0.214_041_14).abs() < 1e-8);
        // The line and the curve meet up to the digits that the standard rounds.
        assert!((from_srgb(0.04045) - from_srgb(0.040_450_001)).abs() < 1e-7);
    }
}
