//! The golden model.

use super::switches::{Mirror, Switches};
use crate::design::{Golden, Values};
use crate::number::trig::Real;
use crate::units::basis::golden_unit;

/// `a b - c d` with one or two roundings, whatever cancels; the result is 0 only if the exact value
/// is.
fn difference<F: Real>([a, b]: [F; 2], [c, d]: [F; 2]) -> F {
    let product = c * d;
    let lost = (-c).mul_add(d, product);
    a.mul_add(b, -product) + lost
}

/// `u x v`, likewise.
fn golden_cross<F: Real>(u: [F; 3], v: [F; 3]) -> [F; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference([u[i], v[j]], [u[j], v[i]]))
}

/// The golden model. In an `f64`, differences of coordinates, and of two products of such
/// differences, are exact for words of up to 24 bits. N x T has at most two roundings.
pub(super) fn golden<F: Real>(values: &Values) -> Golden<F> {
    let switches = Switches::new(values);
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let (zero, one) = (F::zero(), F::one());
        let flag = |holds: bool| if holds { one } else { zero };
        let is_zero = |v: [F; 3]| v.iter().all(|x| *x == zero);
        let times = |sign: F, v: [F; 3]| v.map(|x| sign * x);
        let first_vector = if switches.faceted { 15 } else { 18 };
        for i in 0..inputs[0].len() {
            let vector = |at: usize| [0, 1, 2].map(|axis| inputs[at + axis][i]);
            let minus = |to: [F; 3], from: [F; 3]| [0, 1, 2].map(|axis| to[axis] - from[axis]);
            let (e1, e2) = (minus(vector(3), vector(0)), minus(vector(6), vector(0)));
            let [du1, dv1] = [0, 1].map(|axis| inputs[11 + axis][i] - inputs[9 + axis][i]);
            let [du2, dv2] = [0, 1].map(|axis| inputs[13 + axis][i] - inputs[9 + axis][i]);
            let det = difference([du1, dv2], [du2, dv1]);
            // dP/du and dP/dv times det.
            let mut by_u = [0, 1, 2].map(|axis| difference([dv2, e1[axis]], [dv1, e2[axis]]));
            let mut by_v = [0, 1, 2].map(|axis| difference([du1, e2[axis]], [du2, e1[axis]]));
            let mut area = golden_cross(e1, e2);
            let (mirrored, zero_uv, zero_area) = (det < zero, det == zero, is_zero(area));
            let mut degenerate = zero_uv || zero_area;
            let mut parallel = false;
            let sign = |degenerate: bool| if mirrored && !degenerate { -one } else { one };
            let rows = if switches.faceted {
                if zero_area {
                    by_u = [one, zero, zero];
                    by_v = [zero, one, zero];
                    area = [zero, zero, one];
                } else if zero_uv {
                    (by_u, by_v) = (e1, e2);
                }
                let sign = sign(degenerate);
                let (outward, dp_du) = (golden_unit(area), times(sign, golden_unit(by_u)));
                // dP/dv, or its part at right angles to dP/du. outward x dP/du is on the side of
                // dP/dv where dP/du, dP/dv and outward are right-handed.
                let dp_dv = if switches.orthonormal {
                    times(sign, golden_cross(outward, dp_du))
                } else {
                    times(sign, golden_unit(by_v))
                };
                // dP/du x dP/dv is e1 x e2 over det.
                let product = times(sign, outward);
                match switches.mirror {
                    Mirror::Handed => [dp_du, dp_dv, times(sign, product)],
                    Mirror::Printed => [times(sign, dp_du), dp_dv, times(sign, product)],
                    Mirror::Off => [dp_du, dp_dv, product],
                }
            } else {
                let n = vector(15);
                let mut product = golden_cross(n, by_u);
                parallel = is_zero(product);
                degenerate |= parallel;
                if degenerate {
                    let along_x = n[0].abs() > n[1].abs();
                    by_u = if along_x { [zero, one, zero] } else { [one, zero, zero] };
                    product = golden_cross(n, by_u);
                }
                let sign = sign(degenerate);
                let (dp_du, n_cross) = if switches.orthonormal {
                    let unit = golden_unit(product);
                    (golden_cross(unit, n), unit)
                } else {
                    let length = by_u.iter().fold(zero, |sum, x| sum + *x * *x).sqrt();
                    (golden_unit(by_u), product.map(|x| x / length))
                };
                let (dp_du, n_cross) = (times(sign, dp_du), times(sign, n_cross)); // N x dP/du
                match switches.mirror {
                    Mirror::Handed => [dp_du, times(sign, n_cross), n],
                    Mirror::Printed => [times(sign, dp_du), times(sign, n_cross), n],
                    Mirror::Off => [dp_du, n_cross, n],
                }
            };
            let mut at = 0;
            let mut put = |x: F| {
                outputs[at][i] = x;
                at += 1;
            };
            rows.iter().flatten().for_each(|x| put(*x));
            for k in 0..=switches.lights {
                let v = vector(first_vector + 3 * k);
                rows.iter().for_each(|row| put(row[0] * v[0] + row[1] * v[1] + row[2] * v[2]));
            }
            [mirrored, degenerate, zero_uv, zero_area]
                .into_iter()
                .for_each(|holds| put(flag(holds)));
            if !switches.faceted {
                put(flag(parallel));
            }
        }
    })
}
