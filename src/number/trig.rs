//! sin, cos and their inverses of angles in turns. They have no branches, so that loops over
//! columns vectorise. Used by golden models, evaluation on reals, samplers and angle errors.
//!
//! The polynomials are fdlibm's. For sin and cos the reduction to the nearest quarter turn is
//! exact, and the largest error is 2 ulp of the result, or 2^-53 absolute where that is more. The
//! inverses are within 4 ulp. Both are tested against a high-precision evaluation. Tables don't use
//! these functions: their words are rounded from `libm` and from the high-precision evaluation of
//! [`crate::number::function`].
//!
//! No figure may depend on the processor. The system's math library rounds differently where it has
//! fused multiply-add, so this crate never calls it: all other functions come from the crate
//! `libm`.

use crate::base::simd::{Body, vectorised};
use glam::{DQuat, DVec3};
use num_traits::{Float, FloatConst};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// A float type for golden models.
pub trait Real: Float + FloatConst + Default + Send + Sync + 'static {
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
            (*sin, *cos) = libm::sincosf(turns * Self::TAU());
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

/// Adding and then subtracting it rounds to the nearest whole number. After the addition, the low
/// bits hold that number.
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
    // Quadrants 1 and 3 swap sin and cos; sin is negative in 2 and 3, cos in 1 and 2.
    let swap = 0u64.wrapping_sub(quadrant & 1);
    let pick = |a: f64, b: f64| f64::from_bits(a.to_bits() & swap | b.to_bits() & !swap);
    let negate = |x: f64, bit: u64| f64::from_bits(x.to_bits() ^ (bit << 63));
    let sin = negate(pick(c, s), quadrant >> 1 & 1);
    let cos = negate(pick(s, c), (quadrant >> 1 ^ quadrant) & 1);
    (sin, cos)
}

/// sin and cos of one angle in turns, identical to those of columns.
#[inline(always)]
#[must_use]
pub fn sin_cos_turns(turns: f64) -> (f64, f64) {
    sin_cos(turns)
}

/// The rotation about a unit vector by an angle in turns.
#[must_use]
pub fn rotation(axis: DVec3, turns: f64) -> DQuat {
    let (sin, cos) = sin_cos(0.5 * turns);
    DQuat::from_vec4((axis * sin).extend(cos))
}

/// Largest error of [`Real::sin_cos_turns`] for `f64`, relative to the larger of the result and
/// 1/2.
pub const ERROR: f64 = 2.0 * f64::EPSILON;

/// Turns per radian.
const TURNS: f64 = 1.0 / TAU;

/// asin and acos in rad; arguments beyond ±1 are clamped to ±1.
#[inline(always)]
fn asin_acos(x: f64) -> (f64, f64) {
    let size = x.abs();
    let size = if size > 1.0 { 1.0 } else { size };
    // Below ½ in x², otherwise in (1 - |x|) / 2, the sin² of half of π/2 - asin |x|.
    let small = size < 0.5;
    let z = if small { size * size } else { 0.5 * (1.0 - size) };
    let t = if small { size } else { z.sqrt() };
    let p = z
        * (1.666_666_666_666_666_6e-1
            + z * (-3.255_658_186_224_009e-1
                + z * (2.012_125_321_348_629_3e-1
                    + z * (-4.005_553_450_067_941e-2
                        + z * (7.915_349_942_898_145e-4 + z * 3.479_331_075_960_212e-5)))));
    let q = 1.0
        + z * (-2.403_394_911_734_414
            + z * (2.020_945_760_233_505_7
                + z * (-6.882_839_716_054_533e-1 + z * 7.703_815_055_590_194e-2)));
    let arc = t + t * (p / q);
    let asin = if small { arc } else { FRAC_PI_2 - 2.0 * arc };
    let signed = asin.copysign(x);
    let ends = if x < 0.0 { PI - 2.0 * arc } else { 2.0 * arc };
    (signed, if small { FRAC_PI_2 - signed } else { ends })
}

/// asin in turns, -¼ to ¼; arguments beyond ±1 are clamped.
#[inline(always)]
#[must_use]
pub fn asin_turns(x: f64) -> f64 {
    asin_acos(x).0 * TURNS
}

/// acos in turns, 0 to ½; arguments beyond ±1 are clamped.
#[inline(always)]
#[must_use]
pub fn acos_turns(x: f64) -> f64 {
    asin_acos(x).1 * TURNS
}

/// Direction of (x, y) in rad, -π to π; 0 for (0, 0). Only the sign of a zero y matters.
#[inline(always)]
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    let (ax, ay) = (x.abs(), y.abs());
    // Infinities become the largest number; NaNs stay.
    let finite = |a: f64| if a > f64::MAX { f64::MAX } else { a };
    let steep = ay > ax;
    let least = 0.5 * finite(if steep { ax } else { ay });
    let most = 0.5 * finite(if steep { ay } else { ax });
    // The arc of least/most is up to π/4; above π/8 it is computed relative to π/4.
    let large = least > most * 0.414_213_562_373_095_03;
    let over = if large { least - most } else { least };
    let under = if large { least + most } else { most };
    let t = over / under;
    let t = if least == 0.0 && most == 0.0 { 0.0 } else { t };
    let z = t * t;
    let w = z * z;
    let odd = z
        * (3.333_333_333_333_293e-1
            + w * (1.428_571_427_250_346_6e-1
                + w * (9.090_887_133_436_507e-2
                    + w * (6.661_073_137_387_531e-2
                        + w * (4.976_877_994_615_932_4e-2 + w * 1.628_582_011_536_578_2e-2)))));
    let even = w
        * (-1.999_999_999_987_648_3e-1
            + w * (-1.111_111_040_546_235_6e-1
                + w * (-7.691_876_205_044_83e-2
                    + w * (-5.833_570_133_790_573_5e-2 + w * -3.653_157_274_421_691_6e-2))));
    let arc = t - t * (odd + even);
    let arc = if large { FRAC_PI_4 + arc } else { arc };
    let arc = if steep { FRAC_PI_2 - arc } else { arc };
    let arc = if x < 0.0 { PI - arc } else { arc };
    arc.copysign(y)
}

/// Direction of (x, y) in turns, -½ to ½; see [`atan2`].
#[inline(always)]
#[must_use]
pub fn atan2_turns(y: f64, x: f64) -> f64 {
    atan2(y, x) * TURNS
}

/// atan in turns, -¼ to ¼.
#[inline(always)]
#[must_use]
pub fn atan_turns(x: f64) -> f64 {
    atan2(x, 1.0) * TURNS
}

/// Angle between (x, y, z) and the z axis in turns, 0 to ½. The squares of the numbers must not
/// overflow or be subnormal.
#[inline(always)]
#[must_use]
pub fn inclination_turns(x: f64, y: f64, z: f64) -> f64 {
    atan2((x * x + y * y).sqrt(), z) * TURNS
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::simd::portable;
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

    /// Within 3 ulp of the nearest `f64`, so within 4 of the arc.
    fn check(is: f64, should: &FBig<HalfEven, 2>, what: &str) {
        let nearest = should.to_f64().value();
        let ulp = nearest.abs().next_up() - nearest.abs();
        assert!((is - nearest).abs() <= 3.0 * ulp, "{what}: {is} for {nearest}");
    }

    fn big(x: f64) -> FBig<HalfEven, 2> {
        FBig::<HalfEven, 2>::try_from(x).unwrap().with_precision(160).value()
    }

    /// Numbers from 0 to 1, dense at both ends, at ½ and at tan π/8.
    fn shares() -> Vec<f64> {
        let mut all: Vec<f64> = (0..=3000).map(|i| f64::from(i) / 3000.0).collect();
        for k in 1..70 {
            let tiny = 2f64.powi(-k);
            all.extend([tiny, 1.0 - tiny, 0.5 - 0.5 * tiny, 0.5 + 0.5 * tiny]);
            all.extend([0.414_213_562_373_095 - tiny / 4.0, 0.414_213_562_373_095 + tiny / 4.0]);
        }
        all
    }

    #[test]
    fn arcs_of_sines_are_within_4_ulp() {
        for size in shares() {
            for x in [size, -size] {
                let asin = big(x).asin_unit(1);
                check(asin_turns(x), &asin, "asin");
                check(acos_turns(x), &(big(0.25) - asin), "acos");
            }
        }
        assert_eq!((asin_turns(1.5), acos_turns(1.5)), (0.25, 0.0));
        assert_eq!((asin_turns(-1.5), acos_turns(-1.5)), (-0.25, 0.5));
        assert_eq!(asin_turns(-0.0).to_bits(), (-0.0f64).to_bits());
        assert!(asin_turns(f64::NAN).is_nan());
    }

    #[test]
    fn directions_are_within_4_ulp() {
        for share in shares() {
            for scale in [1.0, 1.0 / 3.0, 1e-150, 1e150] {
                let (a, b) = (share * scale, scale);
                if a == 0.0 || a / b < 1e-300 {
                    continue;
                }
                let arc = (big(a) / big(b)).atan_unit(1);
                check(atan2_turns(a, b), &arc, "first octant");
                check(atan2_turns(b, a), &(big(0.25) - &arc), "second octant");
                check(atan2_turns(b, -a), &(big(0.25) + &arc), "third octant");
                check(atan2_turns(a, -b), &(big(0.5) - &arc), "fourth octant");
                assert_eq!(atan2(-a, b).to_bits(), (-atan2(a, b)).to_bits());
                assert_eq!(atan2(-a, -b).to_bits(), (-atan2(a, -b)).to_bits());
                if a * a >= f64::MIN_POSITIVE && (a * a).is_finite() {
                    check(inclination_turns(0.0, a, b), &arc, "inclination");
                }
            }
            check(atan_turns(share), &big(share).atan_unit(1), "atan");
        }
        assert_eq!(atan2(0.0, 0.0).to_bits(), 0);
        assert_eq!(atan2(0.0, 1.0).to_bits(), 0);
        assert_eq!([atan2(0.0, -1.0), atan2(-0.0, -1.0)], [PI, -PI]);
        assert_eq!([atan2(1.0, 0.0), atan2(-1.0, 0.0)], [FRAC_PI_2, -FRAC_PI_2]);
        let far = f64::INFINITY;
        assert_eq!(
            [atan2(far, 1.0), atan2(far, far), atan2(1.0, -far)],
            [FRAC_PI_2, FRAC_PI_4, PI]
        );
        for (y, x) in [(f64::NAN, 1.0), (1.0, f64::NAN), (0.0, f64::NAN), (f64::NAN, 0.0)] {
            assert!(atan2(y, x).is_nan(), "{y} {x}");
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
