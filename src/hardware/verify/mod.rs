//! Verification with outside simulators: they run the emitted hardware on the batch engine's
//! vectors, and every bit of every output and the latency must agree.

mod mismatch;
mod request;
mod row;
mod run;
mod simulators;

pub use mismatch::{Decoded, Mismatch};
pub use request::{FAST_VECTORS, Request, SLOW_VECTORS, Simulator, simulators_of};
pub use row::{Row, Verdict};
pub use run::verify;
pub use simulators::Proof;
