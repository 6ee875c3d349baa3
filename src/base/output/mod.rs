//! Writing files whole or not at all, and never over what is read.

mod file;
mod folder;
mod place;
mod scratch;
mod set;

pub use file::{Draft, check, write_file, write_text};
pub use folder::{copy_folder, make_folder};
pub(crate) use place::{at, csv_at};
pub use scratch::Scratch;
pub use set::Set;

/// Removes what is not in its place yet; for a handler of interrupts, which ends the process next.
pub(crate) fn abandon() {
    scratch::abandon();
    set::abandon();
}
