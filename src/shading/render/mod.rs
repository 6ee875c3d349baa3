//! Scenes rendered by fixed-point pipelines, beside the golden picture. The *golden model* of a
//! pipeline is the same function in double precision.
//!
//! The front end ([`Scene::trace`](crate::shading::scene::Scene::trace)) is floating point and
//! returns what each pixel sees. A pipeline is a unit whose input ports are those of a
//! [`Fragment`](crate::units::fragment::Fragment). It has an output port `diffuse`, and `specular`
//! if it has highlights; it runs once per light. The rest is the same for the pipelines and the
//! golden: the sum over all lights of diffuse light (the first light includes the ambient light),
//! times the texture's colour, plus the sum of specular light. Each sum and the colour saturate at
//! 1. All light is linear.
//!
//! The golden is tangent-space bump mapping: N' = p_x T + p_y B + p_z N, with the reflection
//! formula. Blinn's equation, N' = N + B_u (N × P_v) - B_v (N × P_u) normalised, is evaluated
//! beside it: for an orthonormal frame (with scales in texels) both are the same.
//!
//! Emboss pipelines are a separate family with their own golden: see [`emboss`]. Pipelines of the
//! tangent-space setup have this golden, and another one of their own flow: see [`tangent`].

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
