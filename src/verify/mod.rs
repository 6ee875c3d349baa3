//! Agreement with outside simulators.

pub mod vectors;
