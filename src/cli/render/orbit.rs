//! A scene with a moving light.

use super::args::{RenderArgs, pipelines_of};
use super::figures::{bound_of, bounds_hold, covered, figures, parts};
use super::files::{SET, files_of_frames, frame_file, write_figures};
use super::scenes::notes;
use super::still::rendered;
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::base::output::{self, Set};
use crate::cli::progress::progress_bar;
use crate::cli::text;
use crate::shading::picture::{Amplify, Panel, Srgb8, absolute_map, sheet};
use crate::shading::scene::Scene;
use serde_json::json;

/// Largest number of frames side by side on a sheet.
const SHEET_FRAMES: usize = 12;

/// Renders every frame of a scene with a moving light. Writes `frame_000.png` and so on into a
/// folder for the golden and for each pipeline, a sheet of all, and figures of every frame. Returns
/// the text to print, and false if a bound is broken.
pub(super) fn run_frames(args: &RenderArgs, scene: &Scene) -> Result<(String, bool)> {
    if args.specialise {
        let text = "--specialise needs a scene with one picture: leave [orbit] out";
        return Err(Error::usage(text.to_owned()));
    }
    let pipelines = pipelines_of(args, scene)?;
    let names: Vec<&str> =
        ["golden"].into_iter().chain(pipelines.iter().map(|p| p.name.as_str())).collect();
    let mut set = Set::open(&args.out, SET)?;
    set.expect(files_of_frames(&pipelines, scene.frames()))?;
    let out = set.path();
    for name in &names {
        output::make_folder(&out.join(name))?;
    }
    let height = u64::from(scene.image.height);
    let bar = progress_bar(u64::from(scene.frames()) * height, "rows");
    // One sheet row per picture; below each pipeline's row, one of its differences.
    let mut rows: Vec<Vec<Srgb8>> = vec![Vec::new(); 2 * names.len() - 1];
    let (mut values, mut told, mut held) = (Vec::new(), Vec::new(), true);
    let mut view = String::new();
    for number in 0..scene.frames() {
        let before = u64::from(number) * height;
        let (rendered, differences) = rendered(&scene.frame(number), &pipelines, args, &|done| {
            bar.set_position(before + done)
        })?;
        let file = frame_file(number);
        let golden = rendered.golden.to_srgb8();
        golden.save_png(&out.join("golden").join(&file))?;
        rows[0].push(golden);
        for (i, shot) in rendered.shots.iter().enumerate() {
            let picture = shot.picture.to_srgb8();
            picture.save_png(&out.join(&shot.pipeline.name).join(&file))?;
            if let Some(golden) = &shot.golden {
                let folder = out.join(format!("{}_golden", shot.pipeline.name));
                output::make_folder(&folder)?;
                golden.to_srgb8().save_png(&folder.join(&file))?;
            }
            rows[1 + 2 * i].push(picture);
            rows[2 + 2 * i].push(absolute_map(
                &shot.picture,
                rendered.golden_of(shot),
                Amplify::Fit,
            )?);
        }
        // The camera doesn't move: each frame covers the same pixels.
        view = covered(&rendered);
        held &= bounds_hold(&rendered, &differences);
        values.push(figures(scene, &rendered, &differences, &parts(&rendered, args)?));
        for (shot, difference) in rendered.shots.iter().zip(&differences) {
            told.push(vec![
                number.to_string(),
                shot.pipeline.name.clone(),
                text::number(difference.max.difference * 255.0),
                bound_of(shot).map(|bound| text::number(bound * 255.0)).unwrap_or_default(),
                text::number(difference.mean * 255.0),
                format!("{:.4}", difference.ssim),
                format!("{:.4}", difference.flip),
            ]);
        }
    }
    bar.finish_and_clear();
    // As many frames as fit a sheet well.
    let step = rows[0].len().div_ceil(SHEET_FRAMES);
    let mut panels = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let caption = if i > 0 && i % 2 == 0 { "difference" } else { names[i.div_ceil(2)] };
        panels.extend(row.iter().step_by(step).map(|picture| Panel { caption, picture }));
    }
    let columns = rows[0].len().div_ceil(step);
    sheet(&panels, columns)?.save_png(&out.join("sheet.png"))?;
    let value = json::document("render-frames", json!({ "frames": values }));
    let headings = [">frame", "pipeline", ">max/255", ">bound/255", ">mean/255", ">SSIM", ">FLIP"];
    let mut told = format!("{view}\n{}", text::table(&headings, &told));
    if !held {
        told.push_str(text::BROKEN);
    }
    write_figures(set, &value, &(told.clone() + &notes(scene)))?;
    Ok((if args.json { json::text(&value) } else { told }, held))
}
