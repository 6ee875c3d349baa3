//! Waves of the pipelined hardware: a VCD file, and a GTKWave save file next to it.
//!
//! Words are declared with the binary point as a negative least index, so `[1:-14]` is a 16-bit
//! word with 14 fraction bits. Next to each named word are three reals: its value, the netlist
//! evaluated on reals for the same sample (`ideal`), and the difference (`arith_error`). An output
//! port also has the golden model, which is the same function in double precision (`golden`), and
//! the difference to it (`total_error`). Words that are exact, such as sums of inputs, have only
//! their value. Angles are in degrees in these reals, and their errors are taken modulo a turn.
//! Each direction has the angle between it and its golden model (`angle_error_deg`), by which
//! reports rank. GTKWave cuts long numbers, and with them the exponent of a small error. So errors
//! also appear in ulp of their word, to 1/256 (`arith_error_ulp`, `total_error_ulp`): short, and
//! without an exponent. In stage s, cycle t shows the sample that entered at cycle t - s; a word
//! that no data has reached yet is `x`.
//!
//! With a time-shared schedule, a word in its own stage is shown only in its phase and is `x` in
//! the others. Its hold register, `name_sN`, shows it for the whole interval. A node inside a unit
//! has only the hold register. Phase and units are shown as well.
//!
//! # Speed
//!
//! Every word comes from the cycle simulator, for flat and shared hardware, and only changes are
//! written. For flat pipelines the batch engine could also compute the words. But in a wave of the
//! rotation unit's words, stepping takes a quarter of the time, text a fifth, and the system's
//! copying of the file half. So there is only one path, and the wave shows what the registers
//! really hold. `cargo bench --bench engine` compares it with Verilator's tracing.
//!
//! # Why there is no FST
//!
//! FST was tried with `fst-writer` 0.3 on a wave of 10^5 cycles of the rotation unit with all
//! signals. Files are a sixth of the VCD's size (25 MB instead of 159 MB), with reals a quarter
//! (120 MB instead of 483 MB). But writing takes several times as long and keeps all changes of a
//! block in memory, and `fst-writer` has no strings of varying length, which time-shared units
//! need. `vcd2fst`, which comes with GTKWave, makes the same files from a finished VCD, including
//! strings.

mod choice;
mod dump;
mod gtkw;
mod shown;
mod text;
mod trace;
mod twins;
mod units;

pub use choice::{Options, Wave};
