//! Scenes rendered by fixed-point pipelines, beside the golden picture in plain floating point.
//!
//! The front end ([`Scene::trace`](crate::shading::scene::Scene::trace)) is floating point and gives what each pixel sees. A pipeline is a
//! unit whose input ports are those of a [`Fragment`](crate::units::fragment::Fragment) and that has an output port `diffuse`, and
//! `specular` if it has highlights: one pass for each light. What goes on from there is the same for
//! the pipelines and for the golden: over all lights, diffuse light (with the ambient light, which the
//! first light brings) times the texture's colour, plus specular light, each sum and the colour saturated
//! at 1. All of it is linear light.
//!
//! The golden is tangent-space bump mapping: N' = p_x T + p_y B + p_z N and the reflection formula. Blinn's
//! equation, N' = N + B_u (N × P_v) - B_v (N × P_u) normalised, is evaluated beside it: with an
//! orthonormal frame (scales are in texels) both are one.
//!
//! Emboss pipelines are another family, with a golden of their own: see [`emboss`]. Those of the tangent-space
//! set-up have this golden and one more, of their own flow: see [`tangent`].

mod block;
mod bumps;
pub mod emboss;
mod light;
mod named;
mod pipeline;
mod shader;
mod shot;
mod specialised;
pub mod tangent;
mod together;

pub use bumps::shoot;
pub use pipeline::{EMBOSS_PIPELINES, Frames, Pipeline, TANGENT_PIPELINES, set_material};
pub(crate) use pipeline::{mixed, pipeline_units};
pub use shader::Shader;
pub use shot::{Rendered, Shot, VectorError};
pub use specialised::{SeenPort, SpecialisedStage, specialise_to};
pub use together::{check_view, render, shots_together};
