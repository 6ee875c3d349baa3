//! Error measurement: bit-true words and real evaluations against the golden.
//!
//! An error is always told with its *basis*:
//!
//! - `total`: bit-true against the golden of the same quantised inputs;
//! - `arithmetic`: bit-true against the netlist on reals: what words and tables do;
//! - `algorithm`: the netlist on reals against the golden: what the method itself does;
//! - `end-to-end`: bit-true against the golden of the inputs before quantisation.
//!
//! Samples come in chunks, each with a random stream of its own; partial results are merged in
//! chunk order, so the figures don't depend on the number of threads. Designs measured together
//! share inputs and golden values.

mod bounds;
mod chunk;
mod cone;
pub mod eval;
mod golden;
mod inputs;
mod measurand;
mod report;
mod run;
pub mod samples;
mod stream;
#[cfg(test)]
mod tests;

pub use crate::table::figures::{TABLE_ARGUMENT_BITS, TableFigures, table_figures};
pub use bounds::{
    BoundCheck, HardResult, HardVerdict, StatedBound, case_columns, hard_columns, hard_results,
    hard_verdicts,
};
pub use cone::{Cone, ConeReport};
pub(crate) use golden::{as_golden, run_golden};
pub(crate) use inputs::values_of;
pub use inputs::{Inputs, quantize_inputs, sample_words};
pub(crate) use measurand::{angle_errors, angle_quantities};
pub(crate) use report::overflow_counts;
pub use report::{Basis, Figures, OverflowCount, Profile, Report, Speed, Witness};
pub use run::{measure, measure_on};
pub use stream::angle_between;
pub(crate) use stream::{BINS, Histograms, Stream};
