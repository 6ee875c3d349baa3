//! sin and cos of columns of angles in turns, without branches, for golden models and
//! evaluations on reals.
//!
//! The reduction to the nearest quarter turn is exact; then come the polynomials of fdlibm on
//! ±45°. Largest error: 2 ulp of the result, or 2^-53 absolute where that is more (tested
//! against a high-precision evaluation). Tables don't use these: they are rounded from the
//! standard library and from the high-precision evaluation of [`crate::function`].

use crate::simd::{Body, vectorised};
use num_traits::{Float, FloatConst};

/// A float that golden models are written in.
pub trait Real: Float + FloatConst + Default {
    /// Sines and cosines of angles in turns below 2^40.
    ///
    /// # Panics
    /// If the columns differ in length.
    fn sin_cos_turns(turns: &[Self], sin: &mut [Self], cos: &mut [Self]);
}

impl Real for f32 {
    fn sin_cos_turns(turns: &[Self], sin: &mut [Self], cos: &mut [Self]) {
        assert!(turns.len() == sin.len() && turns.len() == cos.len(), "bug: columns differ");
        for ((turns, sin), cos) in turns.iter().zip(sin).zip(cos) {
            (*sin, *cos) = (turns * Self::TAU()).sin_cos();
        }
    }
}

impl Real for f64 {
    fn sin_cos_turns(turns: &[Self], sin: &mut [Self], cos: &mut [Self]) {
        assert!(turns.len() == sin.len() && turns.len() == cos.len(), "bug: columns differ");
        vectorised(SinCos { turns, sin, cos });
    }
}

struct SinCos<'a> {
    turns: &'a [f64],
    sin: &'a mut [f64],
    cos: &'a mut [f64],
}

impl Body for SinCos<'_> {
    #[inline(always)]
    fn run(self) {
        for ((turns, sin), cos) in self.turns.iter().zip(self.sin).zip(self.cos) {
            (*sin, *cos) = sin_cos(*turns);
        }
    }
}

/// Added and taken away again, it leaves the nearest whole number; its low bits are then that number.
pub(crate) const ROUNDER: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52

#[inline(always)]
fn sin_cos(turns: f64) -> (f64, f64) {
    let shifted = 4.0 * turns + ROUNDER;
    let quadrant = shifted.to_bits();
    let t = (turns - 0.25 * (shifted - ROUNDER)) * std::f64::consts::TAU; // |t| <= π/4
    let z = t * t;
    let sin_poly = -1.666_666_666_666_663_2e-1
        + z * (8.333_333_333_322_49e-3
            + z * (-1.984_126_982_985_795e-4
                + z * (2.755_731_370_707_006_8e-6
                    + z * (-2.505_076_025_340_686_3e-8 + z * 1.589_690_995_211_55e-10))));
    let cos_poly = 4.166_666_666_666_66e-2
        + z * (-1.388_888_888_887_411e-3
            + z * (2.480_158_728_947_673e-5
                + z * (-2.755_731_435_139_066_3e-7
                    + z * (2.087_572_321_298_175e-9 + z * -1.135_964_755_778_819_5e-11))));
    let s = t + t * z * sin_poly;
    let half = 0.5 * z;
    let w = 1.0 - half;
    let c = w + ((1.0 - w - half) + z * z * cos_poly);
    // Quadrants 1 and 3 swap; sin is negative in 2 and 3, cos in 1 and 2.
    let swap = 0u64.wrapping_sub(quadrant & 1);
    let pick = |a: f64, b: f64| f64::from_bits(a.to_bits() & swap | b.to_bits() & !swap);
    let negate = |x: f64, bit: u64| f64::from_bits(x.to_bits() ^ (bit << 63));
    let sin = negate(pick(c, s), quadrant >> 1 & 1);
    let cos = negate(pick(s, c), (quadrant >> 1 ^ quadrant) & 1);
    (sin, cos)
}

/// sin and cos of one angle in turns, as the columns have them.
#[must_use]
pub fn sin_cos_turns(turns: f64) -> (f64, f64) {
    sin_cos(turns)
}

/// Largest error of [`Real::sin_cos_turns`] for `f64`, relative to the larger of the result and 1/2.
pub const ERROR: f64 = 2.0 * f64::EPSILON;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::portable;
    use dashu_float::{FBig, round::mode::HalfEven};

    fn exact(turns: f64) -> (f64, f64) {
        let x = FBig::<HalfEven, 2>::try_from(turns).unwrap().with_precision(120).value();
        (x.sin_unit(1).to_f64().value(), x.cos_unit(1).to_f64().value())
    }

    fn angles() -> Vec<f64> {
        let mut angles: Vec<f64> = (-4096..=4096).map(|i| f64::from(i) / 2048.0).collect();
        angles.extend((0..20_000).map(|i| f64::from(i).mul_add(7.31e-5, -0.7)));
        angles.extend((1..60).map(|k| 0.125 - 2f64.powi(-k)));
        angles.extend((1..60).map(|k| 2f64.powi(-k)));
        angles
    }

    #[test]
    fn error_is_as_stated() {
        for x in angles() {
            let ((sin, cos), (exact_sin, exact_cos)) = (sin_cos(x), exact(x));
            for (is, should) in [(sin, exact_sin), (cos, exact_cos)] {
                let error = (is - should).abs();
                // ERROR is 2 ulp of numbers from ½ to 1; 2^-53 is a quarter of it.
                let bound = (ERROR * should.abs()).max(0.25 * ERROR);
                assert!(error <= bound, "{x}: {is} for {should}");
            }
        }
    }

    #[test]
    fn both_compilations_give_the_same_bits() {
        let turns = angles();
        let mut wide = (vec![0.0; turns.len()], vec![0.0; turns.len()]);
        let mut base = wide.clone();
        vectorised(SinCos { turns: &turns, sin: &mut wide.0, cos: &mut wide.1 });
        portable(SinCos { turns: &turns, sin: &mut base.0, cos: &mut base.1 });
        assert_eq!(wide, base);
    }
}
