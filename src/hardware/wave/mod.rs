//! Waves of the pipelined hardware: a VCD file and a GTKWave save file beside it.
//!
//! Words are declared with the binary point as a negative least index, so `[1:-14]` is a
//! 16-bit word with 14 fraction bits. Beside each named word stand three reals: its value, the
//! netlist evaluated on reals for the same sample (`ideal`), and the difference (`arith_error`);
//! beside each output port also the golden, and the difference to that (`total_error`). Words that are exact, such as sums of inputs, have
//! only their value. Angles are in degrees there, and their errors are
//! taken modulo a turn. Each direction has the angle between it and its golden (`angle_error_deg`), which reports
//! rank by. GTKWave cuts long numbers, and with them the exponent of a small error, so errors also stand in ulp of
//! their word, to 1/256 (`arith_error_ulp`, `total_error_ulp`): short, and without exponent. In stage s, cycle t shows the sample that entered at cycle t - s;
//! what no data has reached yet is `x`.
//!
//! With a time-shared schedule, a word in its own stage is shown in its phase only and is `x` in
//! the others; the hold register of a word, `name_sN`, shows it for the whole interval. A node inside a
//! unit has only that. Phase and units stand beside them.
//!
//! # Speed
//!
//! Every word comes from the cycle simulator, flat or shared, and only what changed is written. For flat
//! pipelines the batch engine could give the words too; but of a wave of the rotation unit's
//! words, stepping takes a quarter of the time, text a fifth, and the system's
//! copying of the file half, so one way is kept, and the wave shows what registers really hold.
//! `cargo bench --bench engine` compares it with Verilator's tracing.
//!
//! # Why there is no FST
//!
//! Tried with `fst-writer` 0.3 on a wave of 10^5 cycles of the rotation unit with all signals: files are a
//! sixth of the VCD's size (25 MB of 159) and with reals a quarter (120 of 483), but writing takes several times as
//! long and holds all changes of a block in memory, and it has no strings of varying length,
//! which time-shared units are shown by. `vcd2fst`, which comes with GTKWave, makes the same files of
//! a finished VCD, strings included.

mod choice;
mod dump;
mod gtkw;
mod shown;
mod text;
mod trace;
mod twins;
mod units;

pub use choice::{Options, Wave};
