//! The golden model.

use super::bounds::LEAST;
use super::switches::{Constants, Frame, Switches, is_vector};
use crate::base::cast;
use crate::design::{Golden, Values};
use crate::number::trig::Real;
use crate::units::basis::{golden_frame, golden_unit};
use crate::units::dot::ended_at;

/// The golden model. Its scales are the products of |v| and |k|, each taken as at least ¼.
pub(super) fn golden<F: Real>(values: &Values) -> Golden<F> {
    let switches = Switches::new(values);
    let mut first = Vec::new();
    let mut at = 0;
    for name in switches.ports() {
        first.push((name, at));
        at += if is_vector(name) { 3 } else { 1 };
    }
    let real = |x: f64| F::from(x).expect("bug: a float");
    let least = real(LEAST);
    let [ks, kt] = ["ks", "kt"].map(|name| real(values.real(name)));
    let int_bits = cast::signed_count(values.bits("texture_int_bits"));
    let frac_bits = cast::signed_count(values.bits("texture_frac_bits"));
    let overflow = values.overflow("overflow");
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let port = |name: &str| first.iter().find(|(known, _)| *known == name).map(|(_, at)| *at);
        let number = |name: &str, i: usize| inputs[port(name).expect("bug: a port")][i];
        let vector = |name: &str, i: usize| {
            let at = port(name).expect("bug: a port");
            [inputs[at][i], inputs[at + 1][i], inputs[at + 2][i]]
        };
        let dot = |u: [F; 3], v: [F; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        let mut row = vec![F::zero(); outputs.len()];
        let scales = row.len() - 2;
        for i in 0..inputs[0].len() {
            let is_zero = |v: [F; 3]| v.iter().all(|x| *x == F::zero());
            let mut degenerate = false;
            let (t, b) = match switches.frame {
                Frame::Normal => {
                    let (n, ct) = (vector("normal", i), vector("ct", i));
                    let (t, bn, zero) = golden_frame(n, ct, switches.normalise);
                    degenerate |= switches.normalise && zero;
                    (t, bn)
                }
                Frame::Matrix | Frame::Given => {
                    let [t, b] = ["tangent", "binormal"].map(|name| {
                        let mut v = vector(name, i);
                        if switches.frame == Frame::Matrix {
                            v = ["m0", "m1", "m2"].map(|row| dot(vector(row, i), v));
                        }
                        if switches.normalise {
                            degenerate |= is_zero(v);
                            v = golden_unit(v);
                        }
                        v
                    });
                    (t, b)
                }
            };
            let (light, vertex) = (vector("light", i), vector("vertex", i));
            let mut l = [0, 1, 2].map(|axis| light[axis] - vertex[axis]);
            degenerate |= is_zero(l);
            if switches.vertex_light {
                l = l.map(|x| -x);
            }
            let l = golden_unit(l);
            let (of_s, of_t) = if switches.s_is_binormal { (b, t) } else { (t, b) };
            let q = if switches.q { number("q0", i) } else { F::one() };
            let [ks, kt] = match switches.constants {
                Constants::Off => [F::one(); 2],
                Constants::Parameters => [ks, kt],
                Constants::Ports => [number("ks", i), number("kt", i)],
            };
            let sign = if switches.minus_t { -F::one() } else { F::one() };
            for (at, (v, k, name)) in
                [(of_s, ks * q, "s0"), (of_t, sign * kt * q, "t0")].into_iter().enumerate()
            {
                let displacement = k * dot(v, l);
                row[at] = displacement;
                let sum = number(name, i) + displacement;
                row[at + 2] = ended_at(overflow, int_bits, frac_bits, sum);
                let size = dot(v, v).sqrt().max(least);
                let factor = if switches.has_factor() { k.abs().max(least) } else { F::one() };
                row[scales + at] = size * factor;
            }
            row[4] = if degenerate { F::one() } else { F::zero() };
            if switches.q {
                row[5] = q;
                row[6] = number("r0", i);
            }
            for (column, x) in outputs.iter_mut().zip(&row) {
                column[i] = *x;
            }
        }
    })
}
