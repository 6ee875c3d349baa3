//! Pictures by emboss pipelines.

use super::front::{Front, Way, golden};
use super::shader::Shader;
use crate::base::error::Result;
use crate::shading::render::block::{
    Block, BlockShot, Gathered, count, gather, median_rate, overflows,
};
use crate::shading::render::pipeline::Pipeline;
use crate::shading::render::shot::{Rendered, Shot};
use crate::shading::scene::{Scene, Seen};
use crate::sim::batch::Runner;
use std::ops::Range;
use std::sync::Arc;
use std::time::Instant;

/// State that a thread keeps from block to block.
struct Lanes {
    seen: Seen,
    /// Sampler and combiner of each pipeline.
    runners: Vec<[Runner; 2]>,
}

/// Renders a scene by emboss pipelines at once. `progress` receives the number of finished rows.
///
/// # Errors
/// If a unit can't be built with its parameters, the height map's sides aren't powers of two, a
/// value is out of the range of its words, or a `narrow` under overflow mode `error` overflowed.
pub fn render(
    scene: &Scene,
    pipelines: &[Pipeline],
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendered> {
    let start = Instant::now();
    let front = Front::new(scene)?;
    let shaders: Vec<Shader<'_>> =
        pipelines.iter().map(|pipeline| Shader::new(&front, pipeline)).collect::<Result<_>>()?;
    let nothing = |shader: &Shader<'_>| {
        BlockShot::of(shader.stages().into_iter().map(|stage| &stage.program))
    };
    // `Rendered` has the golden of the first pipeline.
    let first = shaders.first().map_or(Way::Toward, |shader| shader.way);
    let other = shaders.iter().map(|shader| shader.way).find(|way| *way != first);
    let lanes = || Lanes {
        seen: Seen::default(),
        runners: shaders
            .iter()
            .map(|shader| [shader.sampler.program.runner(), shader.combine.program.runner()])
            .collect(),
    };
    let shade = |lanes: &mut Lanes, rows: Range<u32>| {
        let Lanes { seen, runners } = lanes;
        front.mesh.trace(scene, rows, seen);
        let shots = shaders.iter().zip(runners).map(|(shader, runners)| {
            let mut shot = nothing(shader);
            shot.colours = shader.shade(&front, seen, runners, &mut shot)?;
            Ok(shot)
        });
        let golden = |way| -> Vec<[f64; 3]> {
            (0..seen.len()).map(|i| golden(&front, way, seen, i)).collect()
        };
        // The golden of the other direction is an additional picture.
        let other =
            other.map(|way| BlockShot { colours: golden(way), ..BlockShot::of([].into_iter()) });
        Ok(Block {
            pixels: seen.pixel.clone(),
            golden: golden(first),
            blinn: 0.0,
            shots: shots.chain(other.map(Ok)).collect::<Result<_>>()?,
        })
    };
    let other_total = other.map(|_| BlockShot::of([].into_iter()));
    let totals = shaders.iter().map(nothing).chain(other_total).collect();
    let Gathered { golden, covers, mut pictures, totals, mut rates, .. } =
        gather(scene, totals, lanes, shade, progress)?;
    let other_golden = other.and_then(|_| pictures.pop()).map(Arc::new);
    let mut shots = Vec::new();
    for (((shader, picture), mut total), rates) in
        shaders.iter().zip(pictures).zip(totals).zip(&mut rates)
    {
        total.overflows[0].clone_from(&shader.vertices.overflows[0]);
        let stages = shader.stages().map(|stage| (&stage.design, &stage.program));
        shots.push(Shot {
            pipeline: shader.pipeline.clone(),
            picture,
            golden: if shader.way == first { None } else { other_golden.clone() },
            design: Arc::clone(&shader.emboss.design),
            behind: [&shader.sampler, &shader.combine].map(|s| Arc::clone(&s.design)).to_vec(),
            emboss: Some(shader.known),
            setup: None,
            frames: None,
            engine: total.engine + shader.vertices.engine,
            samples_per_second: median_rate(rates),
            samples: total.samples,
            vectors: None,
            overflows: overflows(stages.into_iter(), &total.overflows)?,
        });
    }
    Ok(Rendered {
        golden,
        blinn: None,
        covered: count(&covers),
        covers,
        shots,
        elapsed: start.elapsed(),
    })
}
