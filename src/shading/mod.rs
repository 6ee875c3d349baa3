//! Scenes, and the pipelines that shade them.

pub mod picture;
pub mod render;
pub mod scene;
pub mod specialise;
pub(crate) mod srgb;
pub mod texgen;
