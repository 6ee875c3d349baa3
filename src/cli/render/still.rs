//! A scene with one picture.

use super::args::{RenderArgs, pipelines_of};
use super::figures::{bounds_hold, figures, parts};
use super::files::{SET, files_of, write_pictures};
use super::scenes::scene_of;
use crate::base::error::Result;
use crate::base::json;
use crate::base::output::{self, Set};
use crate::cli::progress::progress_bar;
use crate::cli::text;
use crate::shading::picture::Difference;
use crate::shading::render::{Pipeline, Rendered, Shot, render};
use crate::shading::scene::Scene;

/// A scene, its rendered pictures, and how far each pipeline is from the golden.
pub(super) struct Made {
    pub(super) scene: Scene,
    pub(super) pipelines: Vec<Pipeline>,
    pub(super) rendered: Rendered,
    pub(super) differences: Vec<Difference>,
    /// The pictures; their figures aren't written yet.
    pub(super) set: Set,
}

/// Renders and writes the pictures.
pub(super) fn render_and_write(args: &RenderArgs, scene: Scene) -> Result<Made> {
    let pipelines = pipelines_of(args, &scene)?;
    let mut set = Set::open(&args.out, SET)?;
    set.expect(files_of(&pipelines))?;
    let bar = progress_bar(u64::from(scene.image.height), "rows");
    let (rendered, differences) =
        rendered(&scene, &pipelines, args, &|done| bar.set_position(done))?;
    bar.finish_and_clear();
    write_pictures(&set.path(), &rendered)?;
    Ok(Made { scene, pipelines, rendered, differences, set })
}

/// Renders a picture with each pipeline, and measures how far each is from the golden.
pub(super) fn rendered(
    scene: &Scene,
    pipelines: &[Pipeline],
    args: &RenderArgs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<(Rendered, Vec<Difference>)> {
    let rendered = render(scene, pipelines, true, progress)?;
    let differences = rendered
        .shots
        .iter()
        .map(|shot| {
            let golden = rendered.golden_of(shot);
            rendered.difference(&shot.picture, golden, args.pixels_per_degree)
        })
        .collect::<Result<Vec<_>>>()?;
    Ok((rendered, differences))
}

/// Renders and writes; returns one row of the demo's table per pipeline, and false if a bound is
/// broken.
pub(in crate::cli) fn demo_rows(args: &RenderArgs) -> Result<(Vec<String>, bool)> {
    let made = render_and_write(args, scene_of(&args.scene)?)?;
    let value =
        figures(&made.scene, &made.rendered, &made.differences, &parts(&made.rendered, args)?);
    output::write_text(&made.set.path().join("figures.json"), &json::text(&value))?;
    made.set.commit()?;
    let row = |(shot, d): (&Shot, &Difference)| {
        format!(
            "{} | {} | {} | {:.1} % | {} of {}",
            shot.pipeline.name,
            text::number(d.max.difference * 255.0),
            text::number(d.mean * 255.0),
            d.srgb8_differing * 100.0,
            d.covered_px,
            d.covered_px + d.background_px
        )
    };
    let rows = made.rendered.shots.iter().zip(&made.differences).map(row).collect();
    Ok((rows, bounds_hold(&made.rendered, &made.differences)))
}
