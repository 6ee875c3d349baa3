//! Bump-mapping pipelines per pixel, beside the golden and Blinn's equation.

use super::block::{Block, BlockShot, Gathered, count, gather, median_rate, overflows};
use super::light::{colour, reflected};
use super::shader::{Shader, Stage};
use super::shot::{Rendered, Shot, VectorError};
use crate::base::cast;
use crate::base::error::Result;
use crate::measure::{
    BINS, Histograms, Stream, angle_between, as_golden, quantize_inputs, run_golden,
};
use crate::shading::scene::{Fragments, Light, Scene};
use crate::sim::batch::Runner;
use crate::units::fragment::{Fragment, Port};
use glam::DVec3;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use std::time::Instant;

impl BlockShot {
    fn new(shader: &Shader) -> Self {
        Self::of(shader.stages.iter().map(|stage| &stage.program))
    }
}

/// State that a thread keeps from block to block.
struct Lanes {
    fragments: Fragments,
    runners: Vec<Vec<Runner>>,
    /// Histograms of each pipeline's angle errors.
    histograms: Vec<u32>,
}

/// Renders a scene with prepared shaders, all at once: the golden is computed once for all of them.
/// `progress` receives the number of finished rows.
///
/// # Errors
/// If a `narrow` under overflow mode `error` overflowed.
pub fn shoot(
    scene: &Scene,
    shaders: &[&Shader],
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendered> {
    let start = Instant::now();
    let lanes = || Lanes {
        fragments: Fragments::default(),
        runners: shaders
            .iter()
            .map(|shader| shader.stages.iter().map(|stage| stage.program.runner()).collect())
            .collect(),
        histograms: vec![0; shaders.len() * BINS],
    };
    let histograms = Histograms::new(shaders.len());
    let shade_rows = |lanes: &mut Lanes, rows: Range<u32>| {
        let block = block(scene, shaders, rows, lanes);
        histograms.take(&mut lanes.histograms);
        block
    };
    let totals = shaders.iter().map(|shader| BlockShot::new(shader)).collect();
    let Gathered { golden, blinn, covers, pictures, totals, mut rates } =
        gather(scene, totals, lanes, shade_rows, progress)?;
    let mut shots = Vec::new();
    for (index, ((shader, picture), total)) in shaders.iter().zip(pictures).zip(totals).enumerate()
    {
        let vectors = shader.stages[0].vector.is_some();
        let stages = shader.stages.iter().map(|stage| (&stage.design, &stage.program));
        shots.push(Shot {
            pipeline: shader.pipeline.clone(),
            picture,
            golden: None,
            design: Arc::clone(shader.design()),
            behind: shader.frames.iter().map(|frames| Arc::clone(frames.design())).collect(),
            emboss: None,
            setup: None,
            frames: shader.frames.as_ref().map(|frames| Box::new(frames.known().clone())),
            engine: total.engine,
            samples_per_second: median_rate(&mut rates[index]),
            samples: total.samples,
            vectors: vectors.then(|| VectorError::of(&total.angles, &histograms.of(index))),
            overflows: overflows(stages, &total.overflows)?,
        });
    }
    Ok(Rendered {
        golden,
        blinn: Some(blinn),
        covered: count(&covers),
        covers,
        shots,
        elapsed: start.elapsed(),
    })
}

/// Fragments by material, so that each design gets its own columns.
pub(super) fn by_material(fragments: &Fragments) -> BTreeMap<usize, Vec<usize>> {
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for i in 0..fragments.len() {
        groups.entry(cast::index_of_u32(fragments.object[i])).or_default().push(i);
    }
    groups
}

/// The values of a port.
pub(super) fn port_column(port: Port, points: &[Fragment]) -> Vec<f64> {
    let mut column = Vec::new();
    port.column(points, &mut column);
    column
}

/// The shading point of a fragment under a light.
pub(super) fn shading_point(
    scene: &Scene,
    fragments: &Fragments,
    i: usize,
    light: &Light,
) -> Fragment {
    let vector = |columns| Fragments::vector(columns, i);
    let normal = vector(&fragments.normal);
    let to_light = light.towards(vector(&fragments.position), normal);
    let bump = scene.bumps.vector(fragments.bump[i]);
    Fragment {
        normal,
        tangent: vector(&fragments.tangent),
        light: to_light,
        half: crate::shading::scene::halfway(to_light, vector(&fragments.eye), normal),
        // For a mirrored texture, the second axis is reversed in the frame (T, N × T, N).
        perturbed: DVec3::new(bump.x, bump.y * fragments.handedness[i], bump.z),
    }
}

fn block(scene: &Scene, shaders: &[&Shader], rows: Range<u32>, lanes: &mut Lanes) -> Result<Block> {
    let Lanes { fragments, runners, histograms } = lanes;
    scene.trace(rows, fragments);
    let len = fragments.len();
    let material_of = |i: usize| cast::index_of_u32(fragments.object[i]);
    let texel_of = |i: usize| scene.texture.texels()[cast::index_of_u32(fragments.texel[i])];
    let by_material = by_material(fragments);
    let mut golden = vec![(0.0, 0.0); len];
    let mut blinn = vec![(0.0, 0.0); len];
    for i in 0..len {
        let ambient = scene.ambient * scene.materials[material_of(i)].ambient;
        (golden[i].0, blinn[i].0) = (ambient, ambient);
    }
    let mut sums: Vec<Vec<(f64, f64)>> = shaders.iter().map(|_| vec![(0.0, 0.0); len]).collect();
    let mut shots: Vec<BlockShot> = shaders.iter().map(|shader| BlockShot::new(shader)).collect();
    for (number, light) in scene.lights.iter().enumerate() {
        for (material_index, members) in &by_material {
            let material = &scene.materials[*material_index];
            let points: Vec<Fragment> =
                members.iter().map(|i| shading_point(scene, fragments, *i, light)).collect();
            for (point, i) in points.iter().zip(members) {
                let p = point.perturbed;
                let binormal = point.normal.cross(point.tangent);
                let perturbed = p.x * point.tangent + p.y * binormal + p.z * point.normal;
                let add = |sum: &mut (f64, f64), (diffuse, specular): (f64, f64)| {
                    sum.0 += diffuse;
                    sum.1 += specular;
                };
                add(&mut golden[*i], reflected(point, perturbed, light, material));
                let by_blinn = blinn_normal(scene, fragments, *i);
                add(&mut blinn[*i], reflected(point, by_blinn, light, material));
            }
            // Port values, shared by pipelines.
            let mut values: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
            for (((shader, runners), histogram), (sums, shot)) in shaders
                .iter()
                .zip(&mut *runners)
                .zip(histograms.chunks_mut(BINS))
                .zip(sums.iter_mut().zip(&mut shots))
            {
                let index = shader.of[*material_index][number];
                let stage = &shader.stages[index];
                let runner = &mut runners[index];
                let columns: Vec<Vec<f64>> = match &shader.frames {
                    None => {
                        let shared = |(at, port): (usize, &Port)| {
                            let name = stage.design.netlist.input_name(at);
                            values
                                .entry(name)
                                .or_insert_with(|| port_column(*port, &points))
                                .clone()
                        };
                        stage.ports.iter().enumerate().map(shared).collect()
                    }
                    Some(frames) => {
                        let framed = points.iter().zip(members).map(|(point, i)| {
                            frames.frame(scene, fragments, *i, point).unwrap_or(*point)
                        });
                        let framed: Vec<Fragment> = framed.collect();
                        stage.ports.iter().map(|port| port_column(*port, &framed)).collect()
                    }
                };
                let overflows = runner.overflows().to_vec();
                shade(stage, runner, &columns, members, sums, shot, histogram)?;
                for ((total, after), before) in
                    shot.overflows[index].iter_mut().zip(runner.overflows()).zip(overflows)
                {
                    *total += after - before;
                }
            }
        }
    }
    let finish = |sums: &[(f64, f64)]| -> Vec<[f64; 3]> {
        sums.iter().enumerate().map(|(i, (d, s))| colour(*d, *s, texel_of(i))).collect()
    };
    for (shot, sums) in shots.iter_mut().zip(&sums) {
        shot.colours = finish(sums);
    }
    let (golden, blinn) = (finish(&golden), finish(&blinn));
    let differences = golden.iter().flatten().zip(blinn.iter().flatten());
    Ok(Block {
        pixels: fragments.pixel.clone(),
        blinn: differences.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max),
        golden,
        shots,
    })
}

/// The perturbed normal by Blinn's equation, from the slopes along the texture's axes.
fn blinn_normal(scene: &Scene, fragments: &Fragments, i: usize) -> DVec3 {
    let (slope_u, slope_v) = slopes(scene, fragments.bump[i]);
    let normal = Fragments::vector(&fragments.normal, i);
    let (pu, pv) = (Fragments::vector(&fragments.tangent, i), fragments.bitangent(i));
    // The equation defines N as P_u × P_v; for a mirrored texture N is on the other side.
    let side = fragments.handedness[i];
    (normal + side * (slope_u * normal.cross(pv) - slope_v * normal.cross(pu))).normalize()
}

/// Slopes B_u, B_v of the height map at a texel, in texels of height per texel, by differences of
/// its neighbours: not from the bump vectors, which are checked against them.
fn slopes(scene: &Scene, texel: u32) -> (f64, f64) {
    let (width, height) = scene.bumps.size();
    let (column, row) = (texel % width, texel / width);
    let at = |column: u32, row: u32| {
        scene.bumps.heights()[cast::index_of_u32(row * width + column)] * scene.bumps.scale()
    };
    let (right, left) = ((column + 1) % width, (column + width - 1) % width);
    let (below, above) = ((row + 1) % height, (row + height - 1) % height);
    // v grows upwards.
    (0.5 * (at(right, row) - at(left, row)), 0.5 * (at(column, above) - at(column, below)))
}

/// Runs a design over fragments and adds up their light.
fn shade(
    stage: &Stage,
    runner: &mut Runner,
    columns: &[Vec<f64>],
    members: &[usize],
    sums: &mut [(f64, f64)],
    shot: &mut BlockShot,
    histogram: &mut [u32],
) -> Result<()> {
    let netlist = &stage.design.netlist;
    let mut words = Vec::new();
    quantize_inputs(netlist, columns, &mut words)?;
    let slices: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
    let judged = stage.vector.as_ref().map_or(0, Range::len);
    let mut out = vec![Vec::new(); 1 + usize::from(stage.has_specular) + judged];
    let start = Instant::now();
    runner.run(&stage.program, &slices, &mut out)?;
    shot.engine += start.elapsed();
    shot.samples += cast::count_of(members.len());
    let ulp = stage.light_format.ulp();
    for (at, i) in members.iter().enumerate() {
        // Words of a light are exact in f64, and so are sums of a few of them.
        sums[*i].0 += cast::f64_of(out[0][at]) * ulp;
        if stage.has_specular {
            sums[*i].1 += cast::f64_of(out[1][at]) * ulp;
        }
    }
    if let Some(range) = &stage.vector {
        let group = stage.design.groups.iter().position(|group| group.name == "lt");
        let group = group.expect("bug: it was found before");
        let first: usize =
            stage.design.groups[..group].iter().map(|g| g.shape.columns().len()).sum();
        let group = &stage.design.groups[group];
        let mut values: Vec<Vec<f64>> = group
            .nodes
            .iter()
            .zip(&out[range.clone()])
            .map(|(node, words)| {
                let ulp = netlist.node(*node).format.ulp();
                words.iter().map(|word| cast::f64_of(*word) * ulp).collect()
            })
            .collect();
        let (mut is, mut should) = (Vec::new(), Vec::new());
        as_golden(std::slice::from_ref(group), &mut values, &mut is);
        run_golden(&stage.design, columns, &mut should);
        let at = |columns: &[Vec<f64>], i: usize| [0, 1, 2].map(|axis| columns[axis][i]);
        let angles: Vec<f64> = (0..members.len())
            .map(|i| angle_between(at(&is, i), at(&should[first..], i)))
            .collect();
        shot.angles.merge(&Stream::of(&angles, 0, histogram));
    }
    Ok(())
}
