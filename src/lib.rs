//! A generator and bit-true simulator of fixed-point datapaths.
//!
//! A datapath is described once, as a [`netlist`] of exact operations ([`op`]) and one operation
//! that rounds ([`format::narrow`]). Formats and tables ([`table`]) are run-time values. The
//! netlist yields fast bit-true simulation ([`sim::batch`]), pipelined hardware ([`schedule`],
//! [`rtl`]) with its clock cycles ([`cycle`]) and waves ([`wave`]), and error figures ([`measure`])
//! over parameter sweeps ([`sweep`]). [`units`] holds the datapaths with their golden models: the
//! same functions in double precision.
//!
//! A unit, from its parameters to its error:
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
//! A user-defined datapath, `y = x * x` rounded to eight bits:
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
//! let (words, overflowed) = square.eval(&[-96])?; // -1.5
//! assert_eq!(words[y_index(&square)], 144); // 2.25
//! assert!(!overflowed.contains(&true));
//! # fn y_index(n: &fixpath::netlist::Netlist) -> usize { n.outputs()[0].node.index() }
//! # Ok::<(), fixpath::error::Error>(())
//! ```
//!
//! [`netlist::Wires`] writes the same with operators: `(&x * &x).narrow(…)`. With parameters, a
//! golden model and a bound, such a datapath is a [`units::Unit`], and [`main`] gives it the whole
//! command line: see `examples/own_units.rs`.
//!
//! The source folders are layers, from `base` up to `cli`. Each layer names only those below it,
//! and a path inside the crate starts with the folder. Outside the crate, modules have short paths
//! that omit the folder: `fixpath::format`, not `fixpath::number::format`.
//!
//! # Features
//!
//! | feature | adds |
//! |---|---|
//! | none | numbers, netlists, schedules, simulation, tables, units, errors, hardware text, waves, runs of outside tools |
//! | `pictures` | scenes, pictures, texture-coordinate calls, specialisation to a scene |
//! | `sweeps` | sweeps, ladders, reports and plots; needs `pictures`, since a point may be a picture |
//! | `cli` (default) | the command line, [`main`]; needs `sweeps` |
#![deny(unsafe_code)]
// Some private helpers serve the upper layers only.
#![cfg_attr(not(feature = "cli"), allow(dead_code, unreachable_pub, unused_imports))]
#![cfg_attr(
    test,
    allow(clippy::disallowed_methods, reason = "goldens of tests may round otherwise")
)]

mod base;
#[cfg(feature = "cli")]
pub mod cli;
mod design;
mod hardware;
pub mod measure;
pub mod netlist;
mod number;
#[cfg(feature = "sweeps")]
pub mod report;
pub mod schedule;
#[cfg(feature = "pictures")]
mod shading;
pub mod sim;
#[cfg(feature = "sweeps")]
pub mod sweep;
pub mod table;
pub mod units;

#[cfg(feature = "cli")]
pub use cli::main;

pub use base::{columns, error, escape, json, output, outside};
pub use hardware::{cost, cycle, emit, hdl, rtl, timetable, verify, wave};
pub use measure::{eval, samples};
pub use netlist::op;
pub use number::{format, function, real, trig};
#[cfg(feature = "pictures")]
pub use shading::{picture, render, scene, specialise, texgen};
#[cfg(feature = "sweeps")]
pub use sweep::{compare, ladder};

/// Runs the code of the page as tests.
#[cfg(doctest)]
#[doc = include_str!("../docs/library.md")]
struct LibraryPage;
