//! Reports: the result of a sweep or a ladder as Markdown and plots.
//!
//! The report of a sweep is made from a [`record::Record`] alone, so a sweep that was stopped and
//! resumed gives the same report as one that ran through.

mod chart;
pub mod ladder;
mod markdown;
mod pareto;
mod plot;
pub mod record;
mod rows;
mod shots;
mod sweep;
mod table;

pub use pareto::pareto;
pub use shots::shots;
pub use sweep::{FILES, write};
pub use table::Table;

#[cfg(test)]
mod tests;
