//! A netlist as the bit-true model in a test of other code: here, of a Q15 product as firmware computes it.
//! `cargo test --example bit_true_model` runs the test, `cargo run --example bit_true_model` the same comparison.

use fixpath::error::Result;
use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Netlist, Quantity};
use fixpath::sim::batch::Program;

/// The code under test: the product of two Q15 words, rounded half up, saturated.
fn firmware(a: i16, b: i16) -> i16 {
    let rounded = (i32::from(a) * i32::from(b) + (1 << 14)) >> 15;
    i16::try_from(rounded).unwrap_or(i16::MAX) // only -1 · -1 is out of range
}

/// The model: the same product as a datapath.
fn model() -> Result<Netlist> {
    let q15 = Format::signed(16, 15)?;
    let mut b = Builder::new("q15_product");
    let [x, y] = ["a", "b"].map(|name| b.input(name, q15, Quantity::Number));
    let exact = b.mul(x, y);
    let product = b.narrow(exact, q15, Round::HalfUp, Overflow::Saturate);
    b.output("product", product);
    b.build()
}

/// Compares every `a` with some `b`; returns the number of products.
fn compare() -> Result<usize> {
    let netlist = model()?;
    let program = Program::compile(&netlist, &[netlist.outputs()[0].node]);
    let mut runner = program.runner();
    let a: Vec<i64> = (i16::MIN..=i16::MAX).map(i64::from).collect();
    let (mut products, mut compared) = (vec![Vec::new()], 0);
    for b in [i16::MIN, -12345, -1, 0, 1, 2, 16384, i16::MAX] {
        let column = vec![i64::from(b); a.len()];
        runner.run(&program, &[&a, &column], &mut products)?;
        for (a, product) in (i16::MIN..=i16::MAX).zip(&products[0]) {
            assert_eq!(i64::from(firmware(a, b)), *product, "{a} * {b}");
        }
        compared += a.len();
    }
    Ok(compared)
}

fn main() -> Result<()> {
    println!("{} products are equal", compare()?);
    Ok(())
}

#[test]
fn firmware_agrees_with_the_model() {
    assert_eq!(compare().unwrap(), 8 << 16);
}
