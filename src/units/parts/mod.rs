//! Parts shared by the units.

pub(super) mod divide;
pub mod fragment;
pub(super) mod plan;
pub(super) mod polar;
pub(super) mod root;
pub(super) mod setup;
