//! The hardware of a design: registers, clock cycles, waves, HDL text, verification with other
//! simulators, and cost.

pub mod cost;
pub mod cycle;
pub mod emit;
pub mod hdl;
mod pipeline;
pub mod rtl;
pub mod timetable;
pub mod verify;
pub mod wave;
