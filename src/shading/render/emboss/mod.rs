//! Scenes by emboss: displaced texture coordinates per vertex, texels and a combiner per pixel.
//!
//! The scene's surfaces are tessellated
//! ([`Scene::tessellate`](crate::shading::scene::Scene::tessellate)). Per vertex and light, the
//! unit `emboss` displaces the texture coordinates. Rays interpolate the plain and the displaced
//! ones in floating point. Per pixel, the units `sampler` and `combine` look up the height map and
//! add the differences to the diffuse light, which is the texture's colour times light computed per
//! vertex (Gouraud). There is no specular light.
//!
//! Each setting keeps the convention of its source, and both show the same shapes as raised:
//!
//! - `emboss-gx` displaces towards the light, and adds h(undisplaced) - h(displaced). The sign of L
//!   is the opposite of the patents'; `light_sign = "vertex-light"` in `[emboss]` selects the
//!   patents' sign and makes raised shapes look sunken.
//! - `emboss-nv` displaces away from the light, since the extension's CT points along growing t,
//!   and adds h(displaced) - h(undisplaced).
//!
//! These are two pictures of one relief, shifted by a displacement, so each has its own golden: the
//! same computation in `f64` without rounding, with displacements `± strength (T·L)/|L|` and
//! `± strength (B·L)/|L|` in texels, and interpolation between exact texels. A picture and its
//! golden share the front end (surfaces, rays and their weights, light per vertex, the texture's
//! colour) and the texels of the height map, which have 8 bits. Only the sign of `scale` in
//! `[height]` matters: a negative one turns bumps into dents.
//!
//! # Binary points
//! The unit `emboss` counts texture coordinates in units of 2^k texels, the same along both axes.
//! This lets the matrix and the displacements use the range of their words; the map's size is a
//! power of two away. k is the smallest that leaves room for every coordinate of the scene.
//!
//! - `emboss-gx`: the matrix is the camera's times the strength in those units. So its scale is the
//!   strength, and T and B are unit vectors.
//! - `emboss-nv`: Ks and Kt are the strength in those units. The extension's current texture
//!   coordinate CT is B, along which t grows, so that its BN is -T and its T is B. N × CT doesn't
//!   depend on mirroring, so Ks is negative where a texture is mirrored.
//!
//! A directional light is placed at a distance of [`FAR_AWAY`] from the vertex, in both models.
//!
//! # Bound
//! With bilinear lookup of heights, the largest difference to the golden is bounded: a position
//! error of d texels causes an error of at most d times the largest difference of neighbouring
//! texels. Vertex positions are compared with the golden's; interpolation doesn't increase the
//! error.

mod front;
pub(super) mod known;
mod shader;
pub(super) mod shots;
mod vertices;

pub use front::FAR_AWAY;
pub use known::Known;
pub use shots::render;
