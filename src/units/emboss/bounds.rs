//! Bounds on displacements.

use super::formats::{UNIT_GUARD_BITS, constant, texture_limit};
use super::switches::{Constants, Frame, Switches};
use crate::base::cast;
use crate::design::{Bound, Bounds, Values};
use crate::units::basis::{longest, unit_error, vector_rounding};
use crate::units::dot::ends;
use crate::units::normalise::direction_error;
use crate::units::parts::plan::rounding_ulp;
use crate::units::rsqrt::length_error;

/// Bounds on displacements: see [`Errors`].
pub(super) fn bounds(values: &Values, switches: Switches) -> Bounds {
    let mut bounds = vec![
        Bound::new("relative displacement", ["ds_relative", "dt_relative"], |v, w| {
            Errors::both(v, w, Errors::relative)
        }),
        Bound::new("displacement", ["ds", "dt"], |v, w| Errors::both(v, w, Errors::absolute)),
        Bound::new("displacement in texels", ["ds_texels", "dt_texels"], |v, w| {
            f64::from(v.bits("texture_size")) * Errors::both(v, w, Errors::absolute)
        }),
    ];
    if ends(values.overflow("overflow")) {
        bounds.push(Bound::new("coordinate", ["s1", "t1"], |v, w| {
            Errors::both(v, w, Errors::absolute)
        }));
    }
    let exact: &[&str] = if switches.q { &["degenerate", "q1", "r1"] } else { &["degenerate"] };
    bounds.push(Bound::new("flag and what is passed", exact, |_, _| 0.0));
    Bounds::Stated(bounds)
}

/// Lower limit of the vector's length, and of the factor, as the reference of a relative error.
pub(super) const LEAST: f64 = 0.25;

/// Error of a displacement.
///
/// With v the exact vector, u the direction of L and k the factor, the displacement is k v·u. In
/// words, v' is off by `vector` + `vector_share |v|`. The block-normalised w', at least ½ long,
/// points along u' with |u' - u| <= `direction`. Its reciprocal length is at most 2 and has the
/// relative error `length`. The dot product is off by `dot`. So
/// `d' - d = (1 + length)((v' - v)·u' + v·(u' - u)) + length v·u + 2 (1 + length) dot`.
struct Errors {
    /// Maximum length of v.
    longest: f64,
    /// Error of the displacement before its factor: the part proportional to |v|, and the rest.
    share: f64,
    rest: f64,
    /// The factor, if any: its largest value, its error, and the rounding before it.
    factor: Option<[f64; 3]>,
    /// The last rounding.
    last: f64,
}

impl Errors {
    fn new(values: &Values, worst: &dyn Fn(&str) -> f64, axis: char) -> Self {
        let switches = Switches::new(values);
        let binormal = (axis == 's') == switches.s_is_binormal;
        let rounding = rounding_ulp(values);
        let ulp = |name: &str| 2f64.powi(-cast::signed_count(values.bits(name)));
        // Error proportional to |v|, the rest, and the longest v.
        let unit = |v: &Values| (unit_error(v, worst), 0.0, 1.0);
        let (vector_share, vector, longest) = match (switches.frame, switches.normalise) {
            (Frame::Matrix | Frame::Given, true) => unit(values),
            (Frame::Normal, true) if binormal => unit(values),
            // T = BN x N, as long as N.
            (Frame::Normal, true) => {
                (unit_error(values, worst), vector_rounding(values), longest())
            }
            (Frame::Matrix, false) => {
                let limit = 2.0 * libm::exp2(values.bits("matrix_int_bits").into());
                (0.0, vector_rounding(values), 3.0 * 3f64.sqrt() * limit)
            }
            (Frame::Given, false) => (0.0, 0.0, longest()),
            (Frame::Normal, false) if binormal => {
                (0.0, vector_rounding(values), longest() * longest())
            }
            (Frame::Normal, false) => {
                (0.0, (longest() + 1.0) * vector_rounding(values), longest().powi(3))
            }
        };
        let length = length_error(values, worst);
        let dot = rounding * ulp("dot_frac_bits");
        let name = if axis == 's' { "ks" } else { "kt" };
        let format = constant(values, switches, name).expect("bug: the unit was built with it");
        let factor = switches.has_factor().then(|| {
            let q = if switches.q { texture_limit(values) } else { 1.0 };
            let (constant, error) = match switches.constants {
                Constants::Off => (1.0, 0.0),
                Constants::Parameters => {
                    let real = values.real(name);
                    let ulp = format.ulp();
                    (real.abs(), ((real / ulp).round() * ulp - real).abs())
                }
                Constants::Ports => (2f64.powi(format.int_bits()), 0.0),
            };
            let product = switches.q && switches.constants != Constants::Off;
            let product = if product { rounding * format.ulp() } else { 0.0 };
            let before = 2f64.powi(-UNIT_GUARD_BITS) * ulp("texture_frac_bits") * rounding;
            [constant * q, error * q + product, before]
        });
        Self {
            longest,
            share: (1.0 + length) * (direction_error(values) + vector_share) + length,
            rest: (1.0 + length) * (vector + 2.0 * dot),
            factor,
            last: rounding * ulp("texture_frac_bits"),
        }
    }

    /// The larger error of the two axes.
    fn both(values: &Values, worst: &dyn Fn(&str) -> f64, of: fn(&Self) -> f64) -> f64 {
        let [s, t] = ['s', 't'].map(|axis| of(&Self::new(values, worst, axis)));
        s.max(t)
    }

    fn absolute(&self) -> f64 {
        let unit = self.share * self.longest + self.rest;
        match self.factor {
            None => unit + self.last,
            Some([most, error, before]) => {
                (most + error) * (unit + before) + self.longest * error + self.last
            }
        }
    }

    /// Relative to |v| and the factor, each at least [`LEAST`].
    fn relative(&self) -> f64 {
        let unit = self.share + self.rest / LEAST;
        match self.factor {
            None => unit + self.last / LEAST,
            Some([_, error, before]) => {
                (1.0 + error / LEAST) * (unit + before / LEAST)
                    + error / LEAST
                    + self.last / (LEAST * LEAST)
            }
        }
    }
}
