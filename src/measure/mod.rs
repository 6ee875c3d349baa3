//! Error measurement: bit-true words and evaluations on reals against the golden model, which is
//! the same function in double precision.
//!
//! Every error is reported with its *basis*:
//!
//! - `total`: bit-true against the golden of the same quantised inputs;
//! - `arithmetic`: bit-true against the netlist on reals: the effect of words and tables;
//! - `algorithm`: the netlist on reals against the golden: the effect of the method itself;
//! - `end-to-end`: bit-true against the golden of the inputs before quantisation.
//!
//! Samples come in chunks, each with its own random stream. Partial results are merged in chunk
//! order, so the figures don't depend on the number of threads. Designs that are measured together
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
