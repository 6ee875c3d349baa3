//! `fixpath render`: a scene by pipelines, its golden, differences and figures.

mod args;
mod figures;
mod files;
mod orbit;
mod run;
mod scenes;
mod still;

pub(super) use args::RenderArgs;
pub(super) use run::run;
pub(super) use scenes::{still_scene_of, view_of};
pub(super) use still::demo_rows;
