//! The integration suite, as one binary.
#![allow(
    missing_docs,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::disallowed_methods
)]

mod cli;
mod committed;
mod common;
mod cone;
mod cost;
mod covered;
mod cycle;
mod emboss;
mod embossed;
mod engines;
mod features;
mod files;
mod format;
mod formats;
mod fuzzed;
mod gltf;
mod hdl;
mod hdl_vhdl;
mod ladder;
mod layers;
mod lower;
mod machines;
mod netlist;
mod op;
mod own_units;
mod pages;
mod readers;
mod readme;
mod record;
mod render;
mod rivals;
mod rotation;
mod samples;
mod scene;
mod shading;
mod shared;
mod specialise;
mod specialised;
mod table;
mod tangent;
mod texgen;
mod texture;
mod texture_space;
mod units;
mod verify;
mod wave;
mod wires;
