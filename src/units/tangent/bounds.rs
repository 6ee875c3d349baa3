//! Bounds on the rows of the map and on the mapped vectors.

use super::switches::{Switches, mapped};
use crate::base::cast;
use crate::design::{Bound, Bounds, Values};
use crate::units::basis::{longest, unit_error, vector_rounding};
use crate::units::normalise::direction_error;
use crate::units::parts::plan::rounding_ulp;
use crate::units::rsqrt::length_error;

/// Names of the quantities of a vector whose error is bounded.
fn quantities(name: &str) -> [String; 4] {
    ["x", "y", "z", "dot"].map(|part| format!("{name}_{part}"))
}

/// Bounds on the rows and on the mapped vectors.
pub(super) fn bounds(switches: Switches) -> Bounds {
    let mut bounds = vec![
        Bound::new("tangent", quantities("t"), |v, w| row_errors(v, w)[0]),
        Bound::new("binormal", quantities("b"), |v, w| row_errors(v, w)[1]),
        Bound::new("normal", quantities("n"), |v, w| row_errors(v, w)[2]),
    ];
    bounds.extend(mapped(switches.lights).map(|name| {
        let quantities = quantities(&format!("ts_{name}"));
        Bound::new(name, quantities, mapped_error)
    }));
    let flags: &[&str] = if switches.faceted {
        &["mirrored", "degenerate", "zero_uv", "zero_area"]
    } else {
        &["mirrored", "degenerate", "zero_uv", "zero_area", "parallel"]
    };
    bounds.push(Bound::new("flags", flags, |_, _| 0.0));
    Bounds::Stated(bounds)
}

/// Length of the error of each row, for any words.
///
/// A unit vector of exact words is off by `unit` ([`unit_error`]), and so is every row that is a
/// unit vector. The other rows:
///
/// - orthonormal T of a vertex, `B x N`: `|N| unit` and one rounding;
/// - printed B of a vertex, `c/|T|` with c = N x T. The words of T are over a power of two, with
///   |T| at least ½. c' is rounded. The reciprocal length is at most 2 and has the relative error
///   `length` for narrowed words. Their length is off by no more than their direction, since
///   `direction_error` bounds the difference over the shorter length;
/// - orthonormal B of a facet, `N x T`: `unit` for each factor, the product of both, and one
///   rounding.
fn row_errors(values: &Values, worst: &dyn Fn(&str) -> f64) -> [f64; 3] {
    let switches = Switches::new(values);
    let (unit, rounding) = (unit_error(values, worst), vector_rounding(values));
    match (switches.faceted, switches.orthonormal) {
        (false, true) => [longest() * unit + rounding, unit, 0.0],
        (false, false) => {
            let length = length_error(values, worst);
            let share = (1.0 + length) * (1.0 + direction_error(values)) - 1.0;
            let b = longest() * share + 2.0 * (1.0 + share) * rounding + rounding;
            [unit, b, 0.0]
        }
        (true, true) => [unit, 2.0 * unit + unit * unit + rounding, unit],
        (true, false) => [unit; 3],
    }
}

/// Length of the error of a vector in texture space: that of the rows times the longest vector, and
/// one rounding.
fn mapped_error(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let rows = row_errors(values, worst).iter().map(|error| error * error).sum::<f64>().sqrt();
    let longest = 3f64.sqrt() * libm::exp2(values.bits("vector_int_bits").into());
    let ulp = 2f64.powi(-cast::signed_count(values.bits("out_frac_bits")));
    rows * longest + 3f64.sqrt() * rounding_ulp(values) * ulp
}
