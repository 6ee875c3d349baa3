//! Scenes by emboss: displaced texture coordinates per vertex, texels and a combiner per pixel.
//!
//! The scene's surfaces are tessellated ([`Scene::tessellate`](crate::shading::scene::Scene::tessellate)). Per vertex and light the unit `emboss` displaces
//! the texture coordinates; rays interpolate the plain and the displaced ones in floating point; per pixel the
//! units `sampler` and `combine` look the height map up and add the differences to the diffuse light, which is the
//! texture's colour times light computed per vertex (Gouraud). There is no specular light.
//!
//! Each setting keeps the convention of its seed, and what looks raised in one does in the other:
//!
//! - `emboss-gx` displaces toward the light, and adds h(undisplaced) - h(displaced). The sign of L departs from that of
//!   the patents, which is `light_sign = "vertex-light"` in `[emboss]` and turns what looks raised.
//! - `emboss-nv` displaces away from the light, as the extension's CT points along growing t, and adds
//!   h(displaced) - h(undisplaced).
//!
//! These are two pictures of one relief, a displacement apart, so each has its golden: the same in `f64` without any
//! rounding: displacements `± strength (T·L)/|L|` and
//! `± strength (B·L)/|L|`, in texels, and interpolation between exact texels. What a picture and its golden share is the front end (surfaces,
//! rays and their weights, light per vertex, the texture's colour) and the texels of the height map, which have 8
//! bits. Of `scale` in `[height]` only the sign counts: a negative one makes dents of bumps.
//!
//! # Where binary points are
//! The unit `emboss` counts texture coordinates in steps of 2^k texels, the same along both axes: then the
//! matrix and displacements use the range of their words, and the map's size is a power of two away.
//! k is the least that gives room to every coordinate of the scene.
//!
//! - `emboss-gx`: the matrix is the camera's times the strength in those steps, so its scale is the strength, and T
//!   and B are unit vectors.
//! - `emboss-nv`: Ks and Kt are the strength in those steps. The extension's current texture coordinate CT is B, along
//!   which t grows, so that its BN is -T and its T is B. As N × CT knows nothing of mirrored textures, Ks is
//!   negative where one is.
//!
//! A directional light stands [`FAR_AWAY`] from the vertex, in both models.
//!
//! # Bound
//! Where heights are looked up bilinearly the largest difference to the golden is bounded: a position that is off by
//! d texels is off by at most d times the largest difference of neighbouring texels. Positions of vertices
//! are compared with the golden's; interpolation makes no error larger.

mod front;
pub(super) mod known;
mod shader;
pub(super) mod shots;
mod vertices;

pub use front::FAR_AWAY;
pub use known::Known;
pub use shots::render;
