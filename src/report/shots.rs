//! Measures shots of a scene.

use super::record::Measured;
use crate::base::error::Result;
use crate::shading::render::{Shader, shoot};
use crate::shading::scene::Scene;
use rayon::prelude::*;

/// Renders a scene with shaders made for it, and measures every shot. `pixels_per_degree` is for
/// FLIP; `progress` receives the number of rows done.
///
/// # Errors
/// If a `narrow` under overflow mode `error` overflowed, no pixel sees an object, or
/// `pixels_per_degree` is outside FLIP's range (1 to 1000).
pub fn shots(
    scene: &Scene,
    shaders: &[&Shader],
    pixels_per_degree: f64,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Measured>> {
    let rendered = shoot(scene, shaders, progress)?;
    let measured = rendered.shots.par_iter().map(|shot| {
        let difference = rendered.difference(&shot.picture, &rendered.golden, pixels_per_degree)?;
        Ok(Measured::of_shot(&rendered, shot, &difference))
    });
    measured.collect()
}
