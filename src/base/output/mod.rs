//! Writes files whole or not at all, and never over an input.

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

/// Removes files that are not yet in place. For the interrupt handler, which then ends the process.
pub(crate) fn abandon() {
    scratch::abandon();
    set::abandon();
}
