//! Hardware from a design: its registers, cycles, waves, text, agreement with other simulators, cost.

pub mod cost;
pub mod cycle;
pub mod emit;
pub mod hdl;
mod pipeline;
pub mod rtl;
pub mod timetable;
pub mod verify;
pub mod wave;
