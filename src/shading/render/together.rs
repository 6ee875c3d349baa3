//! Renders pipelines of all kinds together.

use super::block::blocks;
use super::bumps::shoot;
use super::pipeline::{Frames, Pipeline, mixed};
use super::shader::Shader;
use super::shot::Rendered;
use super::tangent::frames::FaceFrames;
use super::{emboss, tangent};
use crate::base::error::Result;
use crate::shading::picture::nothing_in_view;
use crate::shading::scene::{Fragments, Scene};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use std::time::Instant;

/// The most pixels of all pictures that are rendered together.
const TOGETHER_PIXELS: u64 = 1 << 24;

/// Renders a scene by some pipelines at once; `vectors` also measures the rotated light vectors.
/// `progress` receives the number of finished rows.
///
/// # Errors
/// If a pipeline can't be built with its parameters, or lacks a port.
pub fn render(
    scene: &Scene,
    pipelines: &[Pipeline],
    vectors: bool,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendered> {
    let embosses = pipelines.iter().filter(|pipeline| pipeline.is_emboss()).count();
    if embosses > 0 && embosses == pipelines.len() {
        return emboss::shots::render(scene, pipelines, progress);
    }
    if embosses > 0 {
        return Err(mixed());
    }
    let (setups, others): (Vec<&Pipeline>, Vec<&Pipeline>) =
        pipelines.iter().partition(|pipeline| pipeline.is_tangent());
    // The golden then has facets too, and vertices aren't split.
    let facets = !pipelines.is_empty() && !pipelines.iter().any(Pipeline::takes_normals);
    let faceted = if facets { scene.faceted() } else { None };
    let scene = faceted.as_ref().unwrap_or(scene);
    let mut shaders: Vec<Shader> = Vec::new();
    for pipeline in others {
        let mut shader = Shader::with_stages(scene, pipeline, vectors, true, false)?;
        if pipeline.frames == Frames::Setup {
            // Computed once for all pipelines with the same parameters.
            let own = FaceFrames::parameters(pipeline);
            let same = |known: &&Shader| FaceFrames::parameters(&known.pipeline) == own;
            shader.frames = match shaders.iter().find(same) {
                Some(known) => known.frames.clone(),
                None => Some(Arc::new(FaceFrames::new(scene, pipeline)?)),
            };
        }
        shaders.push(shader);
    }
    let shaders: Vec<&Shader> = shaders.iter().collect();
    if setups.is_empty() {
        return shoot(scene, &shaders, progress);
    }
    let start = Instant::now();
    let height = u64::from(scene.image.height);
    // Two passes over the rows.
    let mut rendered = shoot(scene, &shaders, &|done| progress(done / 2))?;
    let setups = tangent::flow::shots(scene, &setups, &|done| progress((height + done) / 2))?;
    let (mut setups, mut others) = (setups.into_iter(), rendered.shots.into_iter());
    // In the order of the request.
    let shots = pipelines
        .iter()
        .filter_map(|pipeline| if pipeline.is_tangent() { setups.next() } else { others.next() });
    rendered.shots = shots.collect();
    rendered.elapsed = start.elapsed();
    Ok(rendered)
}

/// Number of pictures of a scene that should be rendered together, since all of them are in memory.
#[must_use]
pub fn shots_together(scene: &Scene) -> usize {
    usize::try_from(TOGETHER_PIXELS / scene.image.pixels()).unwrap_or(1).max(1)
}

/// Fails if no pixel of a scene sees an object; renders no picture.
///
/// # Errors
/// If no pixel sees an object.
pub fn check_view(scene: &Scene) -> Result<()> {
    let sees = |fragments: &mut Fragments, rows: Range<u32>| {
        scene.trace(rows, fragments);
        !fragments.is_empty()
    };
    let seen = blocks(scene.image.height).into_par_iter().map_init(Fragments::default, sees);
    if seen.any(|seen| seen) { Ok(()) } else { Err(nothing_in_view()) }
}
