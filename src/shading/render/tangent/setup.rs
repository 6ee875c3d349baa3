//! The setup of corners by the unit.

use crate::base::cast;
use crate::base::error::Result;
use crate::measure::{quantize_inputs, run_golden};
use crate::netlist::Counts;
use crate::netlist::words::Words;
use crate::number::format::Format;
use crate::shading::render::block::BlockShot;
use crate::shading::render::named::Stage;
use crate::shading::render::pipeline::Pipeline;
use crate::shading::scene::SharedVertex;
use crate::shading::specialise::{Known as KnownWords, Rate, specialise};
use crate::units::built_in;
use glam::{DVec2, DVec3};
use rayon::prelude::*;

/// Corners that a thread sets up at a time.
const TOGETHER: usize = 3 << 10;

/// Number of flags that are set.
pub(super) fn flagged<'a>(flags: impl Iterator<Item = &'a f64>) -> u64 {
    cast::count_of(flags.filter(|flag| **flag != 0.0).count())
}

/// Inputs of the setup for one corner of a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Index of its object.
    pub(super) object: u32,
    pub(super) positions: [DVec3; 3],
    pub(super) uvs: [DVec2; 3],
    pub(super) normal: DVec3,
    pub(super) view: DVec3,
    pub(super) lights: [DVec3; 8],
}

/// The value that an input port of the setup gets.
#[derive(Clone, Copy, Debug)]
enum Source {
    Position(usize, usize),
    Uv(usize, usize),
    Normal(usize),
    View(usize),
    Light(usize, usize),
}

impl Source {
    /// The source of a port, by its name.
    fn of(port: &str) -> Option<Self> {
        let (name, axis) = port.rsplit_once('_')?;
        let axis = ["x", "y", "z", "u", "v"].iter().position(|known| *known == axis)?;
        let number = |prefix: &str| -> Option<usize> { name.strip_prefix(prefix)?.parse().ok() };
        if let Some(k) = number("uv") {
            return Some(Self::Uv(k, axis.checked_sub(3)?));
        }
        match name {
            "normal" => Some(Self::Normal(axis)),
            "view" => Some(Self::View(axis)),
            _ => match (number("p"), number("light")) {
                (Some(k), _) => Some(Self::Position(k, axis)),
                (_, Some(k)) => Some(Self::Light(k, axis)),
                (None, None) => None,
            },
        }
    }
}

impl Corner {
    fn value(&self, source: Source) -> f64 {
        match source {
            Source::Position(k, axis) => self.positions[k][axis],
            Source::Uv(k, axis) => self.uvs[k][axis],
            Source::Normal(axis) => self.normal[axis],
            Source::View(axis) => self.view[axis],
            Source::Light(k, axis) => self.lights[k][axis],
        }
    }
}

/// The middle and the scale of a setup's words.
#[derive(Clone, Copy, Debug)]
struct Place<V> {
    middle: V,
    scale: f64,
}

/// The places of an object's words.
#[derive(Clone, Copy, Debug)]
struct Places {
    position: Place<DVec3>,
    uv: Place<DVec2>,
}

/// The setup of a scene's triangles by the unit.
pub(super) struct Setup {
    pub(super) stage: Stage,
    /// By object; `None` if it has no corners.
    places: Vec<Option<Places>>,
}

/// Output values for corners, by column; of the words and of the golden.
#[derive(Default)]
pub(super) struct Outputs {
    pub(super) fixed: Vec<Vec<f64>>,
    pub(super) golden: Vec<Vec<f64>>,
}

/// Columns of some corners: slices of those of [`Outputs`].
#[derive(Default)]
struct Part<'a> {
    fixed: Vec<&'a mut [f64]>,
    golden: Vec<&'a mut [f64]>,
}

impl Setup {
    /// Prepares the setup for corners of these objects.
    pub(super) fn new(
        pipeline: &Pipeline,
        lights: usize,
        corners: impl Iterator<Item = (u32, SharedVertex)>,
    ) -> Result<Self> {
        let stage = Stage::new(built_in("tangent"), pipeline, &[format!("lights={lights}")])?;
        // Smallest and largest position and uv.
        let mut bounds: Vec<Option<[[DVec3; 2]; 2]>> = Vec::new();
        for (object, SharedVertex { position, uv, .. }) in corners {
            let object = cast::index_of_u32(object);
            bounds.resize(bounds.len().max(object + 1), None);
            let at = [position, uv.extend(0.0)];
            let bounds = bounds[object].get_or_insert(at.map(|at| [at, at]));
            for (bounds, at) in bounds.iter_mut().zip(at) {
                *bounds = [bounds[0].min(at), bounds[1].max(at)];
            }
        }
        let place = |[low, high]: [DVec3; 2], port: &str| {
            // Coinciding points still need a scale.
            let half = (0.5 * (high - low)).max_element().max(1e-18);
            // A power of two, so that scaling is exact.
            let scale = libm::exp2(libm::log2(stage.reach(port) / half).floor());
            Place { middle: 0.5 * (low + high), scale }
        };
        let places = |[positions, uvs]: [[DVec3; 2]; 2]| {
            let Place { middle, scale } = place(uvs, "uv0_u");
            let uv = Place { middle: middle.truncate(), scale };
            Places { position: place(positions, "p0_x"), uv }
        };
        let places = bounds.into_iter().map(|bounds| bounds.map(places)).collect();
        Ok(Self { places, stage })
    }

    /// The largest ulps of positions and of texture coordinates in the scene; 0 without corners.
    pub(super) fn steps(&self) -> [f64; 2] {
        let step = |port, scale: fn(&Places) -> f64| {
            let ulp = self.stage.port(port).map_or(0.0, Format::ulp);
            self.places.iter().flatten().map(|places| ulp / scale(places)).fold(0.0, f64::max)
        };
        [step("p0_x", |places| places.position.scale), step("uv0_u", |places| places.uv.scale)]
    }

    /// Some outputs for all corners, from the words and, if `with_golden`, from the golden.
    pub(super) fn run(
        &self,
        count: usize,
        corner: impl Fn(usize) -> Corner + Sync,
        names: &[&str],
        with_golden: bool,
        shot: &mut BlockShot,
    ) -> Result<Outputs> {
        let (stage, netlist) = (&self.stage, &self.stage.design.netlist);
        let source = |at| {
            let port = netlist.input_name(at);
            Source::of(port).unwrap_or_else(|| panic!("bug: nothing for `{port}`"))
        };
        let sources: Vec<Source> = (0..netlist.inputs().len()).map(source).collect();
        let columns: Vec<String> =
            stage.design.groups.iter().flat_map(|group| group.columns()).collect();
        let of_golden = |name: &&str| {
            columns.iter().position(|column| column == name).expect("bug: a golden of this name")
        };
        let of_golden: Vec<usize> = names.iter().map(of_golden).collect();
        // The columns of a part are slices of the columns of all corners.
        let chunk = |first: usize, part: Part<'_>| -> Result<BlockShot> {
            let corners: Vec<Corner> = (first..(first + TOGETHER).min(count))
                .map(|at| {
                    let mut corner = corner(at);
                    let object = self.places[cast::index_of_u32(corner.object)];
                    let Places { position, uv } = object.expect("bug: an object with corners");
                    let Place { middle, scale } = position;
                    corner.positions = corner.positions.map(|at| (at - middle) * scale);
                    let Place { middle, scale } = uv;
                    corner.uvs = corner.uvs.map(|at| (at - middle) * scale);
                    corner
                })
                .collect();
            let column = |source: &Source| corners.iter().map(|c| c.value(*source)).collect();
            let inputs: Vec<Vec<f64>> = sources.iter().map(column).collect();
            let mut words = Vec::new();
            quantize_inputs(netlist, &inputs, &mut words)?;
            let mut shot = BlockShot::of([&stage.program].into_iter());
            let out = stage.run(&mut stage.program.runner(), &words, &mut shot, 0);
            for (name, to) in names.iter().zip(part.fixed) {
                let ulp = stage.ulp(name);
                for (to, word) in to.iter_mut().zip(&out[name]) {
                    *to = cast::f64_of(*word) * ulp;
                }
            }
            if with_golden {
                let mut golden = Vec::new();
                run_golden(&stage.design, &inputs, &mut golden);
                for (at, to) in of_golden.iter().zip(part.golden) {
                    to.copy_from_slice(&golden[*at]);
                }
            }
            Ok(shot)
        };
        let golden = if with_golden { names.len() } else { 0 };
        let mut all = Outputs {
            fixed: vec![vec![0.0; count]; names.len()],
            golden: vec![vec![0.0; count]; golden],
        };
        let mut parts: Vec<Part<'_>> = Vec::new();
        parts.resize_with(count.div_ceil(TOGETHER), Part::default);
        for column in &mut all.fixed {
            parts.iter_mut().zip(column.chunks_mut(TOGETHER)).for_each(|(p, c)| p.fixed.push(c));
        }
        for column in &mut all.golden {
            parts.iter_mut().zip(column.chunks_mut(TOGETHER)).for_each(|(p, c)| p.golden.push(c));
        }
        let run = |(number, part)| chunk(number * TOGETHER, part);
        let shots: Vec<BlockShot> =
            parts.into_par_iter().enumerate().map(run).collect::<Result<_>>()?;
        shots.iter().for_each(|part| shot.merge(part));
        shot.samples += cast::count_of(count);
        Ok(all)
    }

    /// Operations per triangle, and further ones per vertex of it.
    pub(super) fn counts(&self) -> (Option<Counts>, Counts) {
        let netlist = &self.stage.design.netlist;
        let known = |(at, id): (usize, &crate::netlist::NodeId)| {
            let of_triangle = |prefix: &str| {
                let number = netlist.input_name(at).strip_prefix(prefix);
                number.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
            };
            let rate = if of_triangle("p") || of_triangle("uv") { Rate::Face } else { Rate::Pixel };
            KnownWords { words: Words::all(netlist.node(*id).format), rate }
        };
        let known: Vec<KnownWords> = netlist.inputs().iter().enumerate().map(known).collect();
        let names: Vec<&str> =
            netlist.outputs().iter().map(|output| output.name.as_str()).collect();
        let report = specialise(netlist, &known, &names).report;
        (report.face.map(|face| face.counts), report.pixel.counts)
    }
}
