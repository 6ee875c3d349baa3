//! Agreement with outside simulators: the emitted hardware runs in them on the batch engine's
//! vectors, and every bit of every output and the latency have to agree.

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
