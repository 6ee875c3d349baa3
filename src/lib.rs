//! A generator and bit-true simulator of fixed-point datapaths.
//!
//! A datapath is described once, as a [`netlist`] of exact operations ([`op`]) and of the one
//! operation that rounds ([`format::narrow`]); formats and tables ([`lut`]) are run-time values. From
//! it come fast bit-true simulation ([`sim::batch`]), pipelined hardware ([`schedule`], [`rtl`]) with
//! its clock cycles ([`sim::cycle`]) and waves ([`wave`]), and error figures ([`measure`]) over
//! parameter sweeps ([`sweep`]). [`units`] holds the datapaths with their golden models.
//!
//! A unit from its parameters to its error:
//!
//! ```
//! use fixpath::measure::{Basis, Inputs, measure};
//! use fixpath::units::{Sampler, Unit};
//!
//! let unit = Unit::find("rotation")?;
//! let design = unit.values(&["scheme=linear", "frac_bits=12"])?.build()?;
//! let inputs = Inputs { sampler: Sampler::Lit, samples: 10_000, seed: 1 };
//! let reports = measure(&[&design], &inputs, &|_done| ())?;
//! let angle = reports[0].figures("angle", Basis::Total);
//! assert!(angle.max < 3e-4, "{} rad at {:?}", angle.max, angle.witness);
//! # Ok::<(), fixpath::error::Error>(())
//! ```
//!
//! A datapath of one's own, `y = x * x` rounded to eight bits:
//!
//! ```
//! use fixpath::format::{Format, Overflow, Round};
//! use fixpath::netlist::{Builder, Quantity};
//!
//! let mut b = Builder::new("square");
//! let x = b.input("x", "s8f6".parse()?, Quantity::Number); // -2 <= x < 2
//! let exact = b.mul(x, x); // 0 <= exact <= 4, 12 fraction bits
//! let y = b.narrow(exact, Format::unsigned(8, 6)?, Round::HalfEven, Overflow::Saturate);
//! b.output("y", y);
//! let square = b.build()?;
//!
//! let (words, overflowed) = square.eval(&[-96]); // -1.5
//! assert_eq!(words[y_index(&square)], 144); // 2.25
//! assert!(!overflowed.contains(&true));
//! # fn y_index(n: &fixpath::netlist::Netlist) -> usize { n.outputs()[0].node.index() }
//! # Ok::<(), fixpath::error::Error>(())
//! ```
#![deny(unsafe_code)]
#![cfg_attr(
    test,
    allow(clippy::disallowed_methods, reason = "goldens of tests may round otherwise")
)]

mod cast;
pub mod cli;
pub mod columns;
pub mod compare;
pub mod cost;
mod document;
pub mod emit;
pub mod error;
pub mod escape;
pub mod eval;
pub mod format;
pub mod function;
pub mod hdl;
mod input;
pub mod json;
pub mod ladder;
pub mod lut;
pub mod measure;
pub mod netlist;
pub mod op;
pub mod output;
pub mod outside;
pub mod picture;
pub mod render;
pub mod report;
pub mod rtl;
pub mod samples;
pub mod scene;
pub mod schedule;
pub mod sim;
mod simd;
pub mod specialise;
mod srgb;
pub mod sweep;
pub mod texgen;
pub mod timetable;
pub mod trig;
pub mod units;
pub mod verify;
pub mod wave;
mod whole;
