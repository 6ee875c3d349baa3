//! User-defined units beside the built-in ones, with the whole command line:
//! `cargo run --release --example own_units -- sim complex_product --hard`.
//!
//! A sigmoid from one table, a product of complex numbers, and one step of a filter.
#![allow(
    clippy::disallowed_methods,
    reason = "these goldens may round as the system's functions do"
)]

use fixpath::format::{Format, Overflow, Round, quantize};
use fixpath::function::Function;
use fixpath::netlist::Quantity;
use fixpath::table::{self, Scheme, Tabulated};
use fixpath::trig::Real;
use fixpath::units::{Bound, Bounds, Design, Golden, Param, Role, Unit, Values};
use std::f64::consts::LOG2_E;
use std::process::ExitCode;

/// 1 / (1 + e^-x), for x from -8 to 8.
fn sigmoid() -> Unit {
    Unit::new("sigmoid", "1 / (1 + e^-x), by one table")
        .param(
            Param::bits("x_bits", 4..=24)
                .default(16)
                .help("bits of x, signed, three of them whole"),
        )
        .param(
            Param::bits("addr_bits", 2..=16).role(Role::TableSize).default(8).help("address bits"),
        )
        .param(Param::scheme("scheme").default(Scheme::Linear))
        .param(Param::rounding("rounding"))
        .design(|p| {
            let mut b = p.builder("sigmoid");
            let format = Format::signed(p.bits("x_bits"), p.bits("x_bits").cast_signed() - 4)?;
            let x = b.input("x", format, Quantity::Number);
            let function = Function::new("sigmoid", |x| 1.0 / (1.0 + (x * -LOG2_E).exp2()));
            let table = Tabulated {
                name: "sigmoid".to_owned(),
                functions: vec![function],
                scheme: table::chosen(&mut b, "sigmoid", p.scheme("scheme")),
                addr_bits: p.bits("addr_bits"),
                quarter_wave: false,
                origin: 0.0,
                output: Format::unsigned(16, 16)?, // 0 <= y < 1
                round: p.rounding("rounding"),
                argument: format,
            };
            let y = table::emit(&mut b, &table.spec(), x)[0];
            b.output("y", y);
            Ok(Design::new(p, b.build()?)
                .golden(|_| Golden::each(|[x]: [f64; 1]| [1.0 / (1.0 + (-x).exp())]))
                // The golden model may round differently from the function that the table is judged
                // by.
                .bounds(Bounds::Stated(vec![Bound::new("y", ["y"], |_, worst| {
                    worst("sigmoid") + 2.0 * f64::EPSILON
                })]))
                .tabulated(vec![table]))
        })
}

/// Exact products and sums with a single rounding.
fn complex_product() -> Unit {
    fn golden<F: Real>(_: &Values) -> Golden<F> {
        Golden::each(|[ar, ai, br, bi]: [F; 4]| [ar * br - ai * bi, ar * bi + ai * br])
    }
    Unit::new("complex_product", "product of two complex numbers")
        .param(Param::bits("frac_bits", 2..=24).default(15).help("fraction bits of all parts"))
        .param(Param::rounding("rounding"))
        .design(|p| {
            let mut b = p.builder("complex_product");
            let frac_bits = p.bits("frac_bits").cast_signed();
            let part = Format::signed(p.bits("frac_bits") + 1, frac_bits)?; // -1 <= a, b < 1
            let result = Format::signed(p.bits("frac_bits") + 3, frac_bits)?; // -2 <= re, im <= 2
            let [ar, ai, br, bi] =
                ["a_re", "a_im", "b_re", "b_im"].map(|name| b.input(name, part, Quantity::Number));
            let (rr, ii, ri, ir) = (b.mul(ar, br), b.mul(ai, bi), b.mul(ar, bi), b.mul(ai, br));
            for (name, exact) in [("re", b.sub(rr, ii)), ("im", b.add(ri, ir))] {
                let word = b.narrow(exact, result, p.rounding("rounding"), Overflow::Saturate);
                b.output(name, word);
            }
            Ok(Design::new(p, b.build()?)
                .goldens(golden::<f64>, golden::<f32>)
                .bounds(Bounds::Stated(vec![Bound::new("part", ["re", "im"], rounding)])))
        })
}

/// The error of one rounding to `frac_bits`.
fn rounding(p: &Values, _: &dyn Fn(&str) -> f64) -> f64 {
    p.rounding("rounding").error_ulp() * 2f64.powi(-p.bits("frac_bits").cast_signed())
}

/// Terms of `y = Σ coefficient · port`, a low-pass filter.
const TERMS: [(&str, &str, f64); 5] = [
    ("x0", "b0", 0.2066),
    ("x1", "b1", 0.4132),
    ("x2", "b2", 0.2066),
    ("y1", "a1", 0.3695),
    ("y2", "a2", -0.1958),
];

/// Coefficients are rounded to nearest; samples are from -2 to 2.
fn biquad_step() -> Unit {
    let coefficient = |(port, name, default): (&str, &str, f64)| {
        Param::real(name, -1.5..=1.5).default(default).help(format!("coefficient of {port}"))
    };
    Unit::new("biquad_step", "one step of a filter of second order, direct form I")
        .params(TERMS.map(coefficient))
        .param(
            Param::bits("frac_bits", 2..=24)
                .default(14)
                .help("fraction bits of samples and coefficients"),
        )
        .param(Param::rounding("rounding"))
        .design(|p| {
            let mut b = p.builder("biquad_step");
            let format =
                Format::signed(p.bits("frac_bits") + 2, p.bits("frac_bits").cast_signed())?;
            let mut terms = Vec::new();
            for (port, coefficient, _) in TERMS {
                let x = b.input(port, format, Quantity::Number);
                let (word, _) =
                    quantize(p.real(coefficient), format, Round::HalfEven, Overflow::Error)?;
                let coefficient = b.constant(word, format);
                terms.push(b.mul(coefficient, x));
            }
            let y = terms.into_iter().reduce(|sum, term| b.add(sum, term)).expect("five terms");
            let wide = Format::signed(p.bits("frac_bits") + 5, p.bits("frac_bits").cast_signed())?;
            let y = b.narrow(y, wide, p.rounding("rounding"), Overflow::Saturate); // -15 <= y <= 15
            b.output("y0", y);
            let bound = |p: &Values, w: &dyn Fn(&str) -> f64| {
                rounding(p, w) + 5.0 * 2.0 * 0.5 * 2f64.powi(-p.bits("frac_bits").cast_signed())
            };
            Ok(Design::new(p, b.build()?)
                .golden(|p| {
                    let of = TERMS.map(|(_, coefficient, _)| p.real(coefficient));
                    Golden::each(move |x: [f64; 5]| [(0..5).map(|i| of[i] * x[i]).sum()])
                })
                .bounds(Bounds::Stated(vec![Bound::new("y0", ["y0"], bound)])))
        })
}

fn main() -> ExitCode {
    fixpath::main(&[sigmoid(), complex_product(), biquad_step()])
}
