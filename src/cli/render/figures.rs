//! Reports on pictures, as text and as JSON.

use super::args::RenderArgs;
use crate::base::cast;
use crate::base::error::Result;
use crate::base::json;
use crate::cli::text;
use crate::design::Design;
use crate::netlist::Counts;
use crate::shading::picture::{Difference, Picture, coverage};
use crate::shading::render::{Rendered, Shot, SpecialisedStage};
use crate::shading::scene::{Scene, Sharing};
use serde_json::{Value, json};
use std::fmt::Write as _;

/// The parts of a set-up's difference from the golden: arithmetic (from its own flow with the
/// golden of the set-up) and algorithm (of that flow from the golden).
type Parts = Option<[Difference; 2]>;

pub(super) fn parts(rendered: &Rendered, args: &RenderArgs) -> Result<Vec<Parts>> {
    let between = |a: &Picture, b: &Picture| rendered.difference(a, b, args.pixels_per_degree);
    let of = |shot: &Shot| match &shot.setup {
        None => Ok(None),
        Some(setup) => Ok(Some([
            between(&shot.picture, &setup.flow)?,
            between(&setup.flow, &rendered.golden)?,
        ])),
    };
    rendered.shots.iter().map(of).collect()
}

/// How many pixels the means are over, in words.
pub(super) fn covered(rendered: &Rendered) -> String {
    coverage(rendered.covered, rendered.background())
}

/// Bound on the largest difference, in linear light.
pub(super) fn bound_of(shot: &Shot) -> Option<f64> {
    shot.emboss.and_then(|known| known.bound)
}

/// False if a picture differs from the golden by more than its bound.
pub(super) fn bounds_hold(rendered: &Rendered, differences: &[Difference]) -> bool {
    let holds = |(shot, difference): (&Shot, &Difference)| {
        bound_of(shot).is_none_or(|bound| difference.max.difference <= bound) // false for NaN
    };
    rendered.shots.iter().zip(differences).all(holds)
}

pub(super) fn table(rendered: &Rendered, differences: &[Difference]) -> String {
    let rows: Vec<Vec<String>> = rendered
        .shots
        .iter()
        .zip(differences)
        .map(|(shot, d)| {
            let angle = |rad: f64| format!("{}°", text::number(rad.to_degrees()));
            vec![
                shot.pipeline.name.clone(),
                text::number(d.max.difference * 255.0),
                text::number(d.mean * 255.0),
                format!("{:.1}", d.psnr_db),
                format!("{:.4}", d.ssim),
                format!("{:.4}", d.flip),
                format!("{:.2} %", d.srgb8_differing * 100.0),
                d.srgb8_max_codes.to_string(),
                shot.vectors.map(|v| angle(v.max_rad)).unwrap_or_default(),
                shot.vectors.map(|v| angle(v.mean_rad)).unwrap_or_default(),
                bound_of(shot).map(|bound| text::number(bound * 255.0)).unwrap_or_default(),
                format!("{:.1}", shot.samples_per_second / 1e6),
            ]
        })
        .collect();
    let mut told = format!(
        "{} x {} pixels: {}; differences from the golden, in linear light\n",
        rendered.golden.width_px(),
        rendered.golden.height_px(),
        covered(rendered)
    );
    let headings = [
        "pipeline",
        ">max/255",
        ">mean/255",
        ">PSNR dB",
        ">SSIM",
        ">FLIP",
        ">sRGB codes differ",
        ">by at most",
        ">L' angle max",
        ">mean",
        ">bound/255",
        ">M samples/s a thread",
    ];
    // Drop empty columns.
    let kept: Vec<usize> =
        (0..headings.len()).filter(|i| rows.iter().any(|row| !row[*i].is_empty())).collect();
    let headings: Vec<&str> = kept.iter().map(|i| headings[*i]).collect();
    let keep = |row: &Vec<String>| kept.iter().map(|i| row[*i].clone()).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(keep).collect();
    told.push_str(&text::table(&headings, &rows));
    told.push_str("  sRGB codes: the 8-bit values of PNG files; in dark pixels 1/255 of linear light is up to 13 codes\n");
    for shot in rendered.shots.iter().filter(|shot| shot.overflowed() > 0) {
        let worst = shot.overflows.iter().max_by_key(|overflow| overflow.count);
        let worst = worst.map(|o| format!("{} of them at {}", o.count, o.node)).unwrap_or_default();
        let _ =
            writeln!(told, "  {}: {} overflows, {worst}", shot.pipeline.name, shot.overflowed());
    }
    let pixels = cast::f64_of_len(rendered.golden.pixels().len());
    let _ = writeln!(
        told,
        "  {:.2} M pixels/s for rays, golden and all pipelines together{}",
        pixels / rendered.elapsed.as_secs_f64() / 1e6,
        rendered.blinn.map_or(String::new(), |blinn| format!(
            "; Blinn's equation differs from the golden by at most {}",
            text::number(blinn)
        ))
    );
    told
}

/// A line on the set-up frames of each pipeline; equal lines are printed once.
pub(super) fn frames(rendered: &Rendered) -> String {
    let mut lines: Vec<String> = Vec::new();
    for known in rendered.shots.iter().filter_map(|shot| shot.frames.as_ref()) {
        let overflows: u64 = known.overflows.iter().map(|overflow| overflow.count).sum();
        let line = format!(
            "frames by the set-up: {} of {} faces mirrored, {} of {} corners without a frame of their own, {overflows} overflows; the coarsest step of positions is {} and of texture coordinates {}\n",
            known.mirrored,
            known.faces,
            known.degenerate,
            3 * known.faces,
            text::number(known.position_step),
            text::number(known.uv_step)
        );
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines.concat()
}

/// The cost and savings of set-ups, and the parts of their differences.
pub(super) fn setups(rendered: &Rendered, differences: &[Difference], parts: &[Parts]) -> String {
    let mut told = String::new();
    let shots = rendered.shots.iter().zip(differences).zip(parts);
    let mut rows = Vec::new();
    let mut work = Vec::new();
    let mut sharing = None;
    for ((shot, total), parts) in shots {
        let (Some(setup), Some([arithmetic, algorithm])) = (&shot.setup, parts) else { continue };
        let of = |what: &str, d: &Difference| {
            vec![
                shot.pipeline.name.clone(),
                what.to_owned(),
                text::number(d.max.difference * 255.0),
                text::number(d.mean * 255.0),
                format!("{:.1}", d.psnr_db),
                format!("{:.4}", d.ssim),
                format!("{:.4}", d.flip),
                format!("{:.2} %", d.srgb8_differing * 100.0),
            ]
        };
        rows.extend([of("arithmetic", arithmetic), of("algorithm", algorithm), of("total", total)]);
        let operations = |counts: &Counts| {
            let all = [&counts.datapath, &counts.schemes, &counts.parts];
            [
                all.iter().map(|operators| operators.multipliers).sum::<u64>(),
                all.iter().map(|operators| operators.adders).sum::<u64>(),
                counts.reads,
            ]
        };
        let primitive = setup.per_primitive.as_ref().map_or([0; 3], operations);
        let vertex = operations(&setup.per_vertex);
        let [triangles, corners] = [setup.sharing.primitives, setup.sharing.replicated_operations];
        for (rate, operations, times) in
            [("per triangle", primitive, triangles), ("per vertex of a triangle", vertex, corners)]
        {
            let mut row = vec![shot.pipeline.name.clone(), rate.to_owned(), times.to_string()];
            row.extend(operations.map(|count| count.to_string()));
            work.push(row);
        }
        let _ = writeln!(
            told,
            "{}: {} of {triangles} triangles mirrored, {} of {corners} corners without a frame of their own; the coarsest step of positions is {} and of texture coordinates {}",
            shot.pipeline.name,
            setup.mirrored,
            setup.degenerate,
            text::number(setup.position_step),
            text::number(setup.uv_step)
        );
        sharing = Some(setup.sharing);
    }
    let Some(sharing) = sharing else { return told };
    let Sharing {
        vertices,
        primitives,
        indices,
        stitches,
        vertex_operations,
        replicated_operations,
        bytes,
        replicated_bytes,
    } = sharing;
    let saved = |less: u64, more: u64| {
        format!("{:.2} x", cast::f64_of_count(more) / cast::f64_of_count(less.max(1)))
    };
    format!(
        "\nset-up per triangle: arithmetic is the difference from the same flow with a floating-point set-up, algorithm that of this flow from the golden\n{}{told}\
         {vertices} vertices, {primitives} triangles of {indices} indices, {stitches} more that only stitch; with shared vertices the vertex stage works on {vertex_operations} vertices, \
         with separate ones on {replicated_operations} ({}); shared buffers have {bytes} bytes, separate ones {replicated_bytes} ({})\n{}",
        text::table(
            &[
                "pipeline",
                "difference",
                ">max/255",
                ">mean/255",
                ">PSNR dB",
                ">SSIM",
                ">FLIP",
                ">sRGB codes differ"
            ],
            &rows
        ),
        saved(vertex_operations, replicated_operations),
        saved(bytes, replicated_bytes),
        text::table(
            &["pipeline", "set-up", ">times", ">multipliers", ">adders", ">table reads"],
            &work
        )
    )
}

/// Savings of specialised pipelines, one row per design.
pub(super) fn savings(reduced: &[(&str, Vec<SpecialisedStage>)]) -> String {
    let mut rows = Vec::new();
    for (name, stages) in reduced {
        for stage in stages {
            let report = &stage.report;
            let face = report.face.as_ref().map(|face| &face.counts);
            let multipliers = |counts: &Counts| {
                counts.datapath.multipliers + counts.schemes.multipliers + counts.parts.multipliers
            };
            let adders = |c: &Counts| c.datapath.adders + c.schemes.adders + c.parts.adders;
            let change = |count: &dyn Fn(&Counts) -> u64| {
                let (before, pixel) = (count(&report.before), count(&report.pixel.counts));
                let face = face.map(|face| format!(" + {}", count(face))).unwrap_or_default();
                format!("{before} to {pixel}{face}")
            };
            let per = |seconds: f64| seconds / cast::f64_of_count(stage.samples.max(1)) * 1e9;
            let inputs = |rate: &str| {
                let ports = stage.inputs.iter().filter(|port| port.rate == rate);
                ports.count().to_string()
            };
            rows.push(vec![
                (*name).to_owned(),
                stage.material.to_string(),
                stage.light.to_string(),
                inputs("scene"),
                inputs("face"),
                inputs("pixel"),
                change(&|counts| counts.tables),
                change(&|counts| counts.rom_bits),
                change(&|counts| counts.rom_bits_dual_port),
                change(&multipliers),
                change(&adders),
                if face.is_some() { stage.faces.to_string() } else { "-".to_owned() },
                format!(
                    "{:.1} to {:.1}",
                    per(stage.general_seconds),
                    per(stage.specialised_seconds)
                ),
                if stage.mismatches == 0 {
                    format!("all {} words", stage.samples)
                } else {
                    format!("{} DIFFER", stage.mismatches)
                },
            ]);
        }
    }
    let mut told = String::from(
        "specialised to the scene: before to after per pixel + after per flat face;\n\
         each design is compared with the general one on every pixel\n",
    );
    told.push_str(&text::table(
        &[
            "pipeline",
            ">material",
            ">light",
            ">scene ports",
            ">face ports",
            ">pixel ports",
            "tables",
            "ROM bits",
            "with copies",
            "multipliers",
            "adders",
            "faces",
            "ns a sample",
            "equal",
        ],
        &rows,
    ));
    told
}

pub(super) fn figures(
    scene: &Scene,
    rendered: &Rendered,
    differences: &[Difference],
    parts: &[Parts],
) -> Value {
    let parameters = |design: &Design| text::parameters(&design.values);
    let shot = |((shot, difference), parts): ((&Shot, &Difference), &Parts)| {
        json!({
            "pipeline": shot.pipeline.name,
            "unit": shot.pipeline.unit.name,
            "parameters": parameters(&shot.design),
            "behind": shot.behind.iter().map(|design| json!({
                "unit": design.values.unit().name,
                "parameters": parameters(design),
            })).collect::<Vec<_>>(),
            "difference": difference,
            "emboss": shot.emboss,
            "setup": shot.setup,
            "frames": shot.frames,
            "arithmetic": parts.as_ref().map(|[arithmetic, _]| arithmetic),
            "algorithm": parts.as_ref().map(|[_, algorithm]| algorithm),
            "vectors": shot.vectors,
            "overflows": shot.overflowed(),
            "samples": shot.samples,
            "engine_samples_per_second_per_thread": shot.samples_per_second,
        })
    };
    json::document(
        "render",
        json!({
            "width_px": rendered.golden.width_px(),
            "height_px": rendered.golden.height_px(),
            "covered_px": rendered.covered,
            "background_px": rendered.background(),
            "notes": scene.notes(),
            "blinn_max": rendered.blinn,
            "pixels_per_second":
                cast::f64_of_len(rendered.golden.pixels().len()) / rendered.elapsed.as_secs_f64(),
            "pipelines": rendered.shots.iter().zip(differences).zip(parts).map(shot).collect::<Vec<_>>(),
        }),
    )
}
