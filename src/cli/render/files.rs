//! Files of pictures and figures.

use crate::base::error::Result;
use crate::base::json;
use crate::base::output::{self, Set};
use crate::shading::picture::{Amplify, Panel, Srgb8, absolute_map, sheet, signed_map};
use crate::shading::render::{Pipeline, Rendered};
use serde_json::Value;
use std::path::Path;

/// Largest number of pipelines side by side on a sheet.
const SHEET_PIPELINES: usize = 4;

/// Name of the output set of pictures.
pub(super) const SET: &str = "render";

/// Files of figures.
const FIGURES: [&str; 2] = ["figures.json", "figures.txt"];

/// Name endings of a pipeline's pictures.
fn pictures_of(pipeline: &Pipeline) -> Vec<&'static str> {
    let mut ends = vec!["", "_difference", "_signed"];
    if pipeline.is_emboss() {
        ends.push("_golden");
    }
    if pipeline.is_tangent() {
        ends.extend(["_flow", "_arithmetic", "_algorithm"]);
    }
    ends
}

/// Files of a scene with one picture.
pub(super) fn files_of(pipelines: &[Pipeline]) -> Vec<String> {
    let of = |pipeline: &Pipeline| -> Vec<String> {
        let name = |end: &&str| format!("{}{end}.png", pipeline.name);
        pictures_of(pipeline).iter().map(name).collect()
    };
    let others = ["golden.png", "sheet.png"].into_iter().chain(FIGURES).map(str::to_owned);
    others.chain(pipelines.iter().flat_map(of)).collect()
}

/// Files of a scene with a moving light.
pub(super) fn files_of_frames(pipelines: &[Pipeline], frames: u32) -> Vec<String> {
    let mut folders = vec!["golden".to_owned()];
    for pipeline in pipelines {
        folders.push(pipeline.name.clone());
        folders.extend(pipeline.is_emboss().then(|| format!("{}_golden", pipeline.name)));
    }
    let of = |folder: &String| -> Vec<String> {
        (0..frames).map(|number| format!("{folder}/{}", frame_file(number))).collect()
    };
    let others = ["sheet.png"].into_iter().chain(FIGURES).map(str::to_owned);
    others.chain(folders.iter().flat_map(of)).collect()
}

pub(super) fn frame_file(number: u32) -> String {
    format!("frame_{number:03}.png")
}

/// Writes the figures once the pictures are complete, and commits the set.
pub(super) fn write_figures(set: Set, value: &Value, told: &str) -> Result<()> {
    for (name, text) in FIGURES.into_iter().zip([&*json::text(value), told]) {
        output::write_text(&set.path().join(name), text)?;
    }
    set.commit()
}

pub(super) fn write_pictures(out: &Path, rendered: &Rendered) -> Result<()> {
    let golden = rendered.golden.to_srgb8();
    golden.save_png(&out.join("golden.png"))?;
    let (mut pictures, mut own_goldens) = (Vec::new(), Vec::new());
    for shot in &rendered.shots {
        let name = &shot.pipeline.name;
        let picture = shot.picture.to_srgb8();
        picture.save_png(&out.join(format!("{name}.png")))?;
        if let Some(golden) = &shot.golden {
            let golden = golden.to_srgb8();
            golden.save_png(&out.join(format!("{name}_golden.png")))?;
            own_goldens.push((format!("golden of {name}"), golden));
        }
        let difference = absolute_map(&shot.picture, rendered.golden_of(shot), Amplify::Fit)?;
        difference.save_png(&out.join(format!("{name}_difference.png")))?;
        signed_map(&shot.picture, rendered.golden_of(shot), Amplify::Fit)?
            .save_png(&out.join(format!("{name}_signed.png")))?;
        if let Some(setup) = &shot.setup {
            setup.flow.to_srgb8().save_png(&out.join(format!("{name}_flow.png")))?;
            absolute_map(&shot.picture, &setup.flow, Amplify::Fit)?
                .save_png(&out.join(format!("{name}_arithmetic.png")))?;
            absolute_map(&setup.flow, &rendered.golden, Amplify::Fit)?
                .save_png(&out.join(format!("{name}_algorithm.png")))?;
        }
        pictures.push((name.as_str(), picture, difference));
    }
    // Rows of pictures, the golden first, with their differences below.
    let nothing = Srgb8::new(1, 1, vec![[255; 3]])?;
    let blank = Panel { caption: "", picture: &nothing };
    let mut panels = Vec::new();
    let columns = pictures.len().min(SHEET_PIPELINES);
    for (row, some) in pictures.chunks(SHEET_PIPELINES).enumerate() {
        let first = Panel { caption: "golden", picture: &golden };
        panels.push(if row == 0 { first } else { blank });
        panels.extend(some.iter().map(|(name, picture, _)| Panel { caption: name, picture }));
        panels.resize((2 * row + 1) * (columns + 1), blank);
        // Below the golden, the one of a pipeline with its own.
        let own = own_goldens.get(row).map(|(caption, picture)| Panel { caption, picture });
        panels.push(own.unwrap_or(blank));
        let caption = "difference";
        panels.extend(some.iter().map(|(_, _, difference)| Panel { caption, picture: difference }));
        panels.resize((2 * row + 2) * (columns + 1), blank);
    }
    sheet(&panels, columns + 1)?.save_png(&out.join("sheet.png"))
}
