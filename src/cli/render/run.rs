//! The command.

use super::args::{RenderArgs, pipelines_of};
use super::figures::{bounds_hold, figures, frames, parts, savings, setups, table};
use super::files::write_figures;
use super::orbit::run_frames;
use super::scenes::{name_of, notes, scene_of, still_scene_of};
use super::still::{Made, render_and_write};
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::cli::{ladder, text};
use crate::shading::render::{Pipeline, SpecialisedStage, mixed, specialise_to};
use serde_json::json;

/// Renders and writes; returns the text to print, and false if a bound is broken or a specialised
/// pipeline differs.
pub(in crate::cli) fn run(args: &RenderArgs) -> Result<(String, bool)> {
    let scene = match &args.ladder {
        Some(_) => still_scene_of(&args.scene)?,
        None => scene_of(&args.scene)?,
    };
    if let Some(widths) = &args.ladder {
        if args.frames == "setup" {
            let text = "--ladder needs frames in floating point: leave --frames out";
            return Err(Error::usage(text.to_owned()));
        }
        let exponents = args.exponents.as_deref();
        let pipelines = pipelines_of(args, &scene)?;
        if pipelines.iter().all(Pipeline::is_emboss) {
            if exponents.is_some() {
                let text = "an emboss has no highlight and no --exponents: leave them out";
                return Err(Error::usage(text.to_owned()));
            }
            return ladder::run_emboss(
                &pipelines,
                widths,
                args.pixels_per_degree,
                (&scene, &name_of(&args.scene)),
                (&args.out, args.json),
            );
        }
        if pipelines.iter().any(Pipeline::is_emboss) {
            return Err(mixed());
        }
        if pipelines.iter().any(Pipeline::is_tangent) {
            let text = "--ladder is for pipelines that shade bumps or emboss: leave tangent pipelines out, and set their widths by -p";
            return Err(Error::usage(text.to_owned()));
        }
        let ladder = ladder::ladder(pipelines, widths, exponents, args.pixels_per_degree)?;
        let told = ladder::run(&ladder, &scene, &name_of(&args.scene), &args.out, args.json)?;
        return Ok((told, true));
    }
    if args.specialise {
        let pipelines = pipelines_of(args, &scene)?;
        if args.frames == "setup" {
            let text = "--specialise needs frames in floating point: leave --frames out";
            return Err(Error::usage(text.to_owned()));
        }
        if pipelines.iter().any(|pipeline| pipeline.is_emboss() || pipeline.is_tangent()) {
            let text = "--specialise is for pipelines that shade bumps: leave it out for an emboss or a tangent-space set-up";
            return Err(Error::usage(text.to_owned()));
        }
    }
    if scene.orbit.is_some() {
        return run_frames(args, &scene);
    }
    let Made { scene, pipelines, rendered, differences, set } = render_and_write(args, scene)?;
    let parts = parts(&rendered, args)?;
    let mut value = figures(&scene, &rendered, &differences, &parts);
    let mut told = table(&rendered, &differences);
    told.push_str(&setups(&rendered, &differences, &parts));
    told.push_str(&frames(&rendered));
    let mut same = bounds_hold(&rendered, &differences);
    if !same {
        told.push_str(text::BROKEN);
    }
    if args.specialise {
        let reduced = pipelines
            .iter()
            .map(|pipeline| Ok((pipeline.name.as_str(), specialise_to(&scene, pipeline)?)))
            .collect::<Result<Vec<_>>>()?;
        same &= reduced.iter().flat_map(|(_, stages)| stages).all(|stage| stage.mismatches == 0);
        let fields = value.as_object_mut().expect("bug: an object");
        let stages = |(name, stages): &(&str, Vec<SpecialisedStage>)| json!({ "pipeline": name, "designs": stages });
        fields.insert("specialised".to_owned(), reduced.iter().map(stages).collect());
        told.push('\n');
        told.push_str(&savings(&reduced));
    }
    write_figures(set, &value, &(told.clone() + &notes(&scene)))?;
    Ok((if args.json { json::text(&value) } else { told }, same))
}
