//! A pipeline prepared for the pixels of a scene.

use super::front::{Coordinates, Front, TEXEL_MAX, Way, between};
use super::known::Known;
use super::vertices::displaced;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::measure::{BoundCheck, quantize_inputs};
use crate::shading::render::block::BlockShot;
use crate::shading::render::named::Stage;
use crate::shading::render::pipeline::Pipeline;
use crate::shading::scene::{Filter, Seen};
use crate::sim::batch::Runner;
use crate::units::built_in;
use glam::DVec2;
use std::collections::BTreeMap;

/// A pipeline prepared for the pixels of a scene: its designs, and the emboss unit's results for
/// the vertices.
pub(super) struct Shader<'a> {
    pub(super) pipeline: &'a Pipeline,
    pub(super) way: Way,
    pub(super) emboss: Stage,
    pub(super) sampler: Stage,
    pub(super) combine: Stage,
    pub(super) coordinates: Coordinates,
    /// Time and overflows of the vertices.
    pub(super) vertices: BlockShot,
    pub(super) known: Known,
}

impl<'a> Shader<'a> {
    pub(super) fn new(front: &Front<'_>, pipeline: &'a Pipeline) -> Result<Self> {
        let scene = front.scene;
        let settings = scene.emboss;
        let set = |key: &str, value: &dyn std::fmt::Display| format!("{key}={value}");
        let mut of_emboss = vec![set("l_sign", &settings.light_sign.name())];
        let way = Way::of(pipeline);
        if way == Way::Away {
            of_emboss.push(set("constants", &"ports"));
        }
        let emboss = Stage::new(&pipeline.unit, pipeline, &of_emboss)?;
        let of_combine = [
            set("filter", &settings.filter.name()),
            set("lights", &scene.lights.len()),
            set("gain_log2", &settings.gain_log2),
            set("difference", &way.difference()),
        ];
        let combine = Stage::new(built_in("combine"), pipeline, &of_combine)?;
        let mut vertices = BlockShot::of([&emboss.program].into_iter());
        let (coordinates, step_texels) = displaced(front, &emboss, &mut vertices)?;
        // Integer bits for the largest coordinate, in maps.
        let maps = DVec2::new(f64::from(front.size[0]), f64::from(front.size[1]));
        let all = coordinates.displaced.iter().flatten().chain(&coordinates.plain);
        let farthest = all.map(|at| (*at / maps).abs().max_element()).fold(0.0, f64::max);
        let int_bits = (0..=16).find(|bits| farthest < 2f64.powi(*bits)).ok_or_else(|| {
            Error::usage(format!(
                "a texture coordinate of {farthest} maps is beyond the sampler: legal is below 65536; give the object smaller ones"
            ))
        })?;
        let of_sampler = [
            set("filter", &settings.filter.name()),
            set("address_s", &settings.address[0].name()),
            set("address_t", &settings.address[1].name()),
            set("int_bits", &int_bits),
            set("log2_width", &front.size[0].trailing_zeros()),
            set("log2_height", &front.size[1].trailing_zeros()),
        ];
        let sampler = Stage::new(built_in("sampler"), pipeline, &of_sampler)?;
        let pairs = coordinates.displaced.iter().zip(&front.golden(way).displaced);
        let displacement_max_texels =
            pairs.map(|(is, should)| apart(is, should).max_element()).fold(0.0, f64::max);
        let known = Known { bound: None, displacement_max_texels, step_texels };
        let mut shader =
            Self { pipeline, way, emboss, sampler, combine, coordinates, vertices, known };
        shader.known.bound = shader.bounded(front)?;
        Ok(shader)
    }

    /// Bound on the error of any channel of its picture, in linear light.
    fn bounded(&self, front: &Front<'_>) -> Result<Option<f64>> {
        if front.scene.emboss.filter == Filter::Nearest {
            return Ok(None); // a position next to a border may be on its other side
        }
        let values = &self.sampler.design.values;
        let power = |bits: u32| 2f64.powi(-cast::signed_count(bits));
        // Rounded to a word of the sampler, then truncated by it.
        let rounded = 0.5 * power(values.bits("frac_bits"));
        let cut = power(values.bits("fraction_bits"));
        let steepest = front.steepest();
        let of_height = |apart: DVec2| -> f64 {
            let axis = |axis: usize| {
                let word = rounded * f64::from(front.size[axis]);
                steepest[axis] * (apart[axis] + word + cut)
            };
            axis(0) + axis(1)
        };
        let golden = front.golden(self.way);
        let plain = of_height(apart(&self.coordinates.plain, &golden.plain));
        let displaced = self.coordinates.displaced.iter().zip(&golden.displaced);
        let relief: f64 =
            displaced.map(|(is, should)| plain + of_height(apart(is, should))).sum::<f64>()
                / TEXEL_MAX;
        let most = self.max_code();
        // Texels are 8 bits wide: codes of another width are rounded to the nearest.
        let texel = if most == TEXEL_MAX { 0.0 } else { 0.5 / most };
        let lights = cast::f64_of_len(front.scene.lights.len());
        let gain = 2f64.powi(front.scene.emboss.gain_log2);
        let stated = BoundCheck::new(&self.combine.design)?;
        let combined = stated.stated.first().expect("bug: the combiner states a bound").bound;
        let floats = 1e-7; // pictures are f32
        let bound = gain * (relief + 2.0 * lights * texel) + (0.5 + combined) / most + floats;
        Ok(Some(bound.min(1.0))) // no channel is off by more
    }

    /// The code that stands for 1.
    fn max_code(&self) -> f64 {
        2f64.powi(cast::signed_count(self.combine.design.values.bits("channel_bits"))) - 1.0
    }

    pub(super) fn stages(&self) -> [&Stage; 3] {
        [&self.emboss, &self.sampler, &self.combine]
    }
}

impl Shader<'_> {
    /// Colours of pixels.
    pub(super) fn shade(
        &self,
        front: &Front<'_>,
        seen: &Seen,
        [sampler, combine]: &mut [Runner; 2],
        shot: &mut BlockShot,
    ) -> Result<Vec<[f64; 3]>> {
        let maps = DVec2::new(f64::from(front.size[0]), f64::from(front.size[1]));
        let most = self.max_code();
        let code = |texel: f64| cast::i64_of((texel / TEXEL_MAX * most).round());
        let mut inputs: BTreeMap<String, Vec<i64>> = BTreeMap::new();
        let samples = std::iter::once(("h".to_owned(), &self.coordinates.plain)).chain(
            self.coordinates.displaced.iter().enumerate().map(|(n, at)| (format!("d{n}"), at)),
        );
        let mut words = Vec::new();
        for (name, coordinates) in samples {
            let places: Vec<DVec2> =
                (0..seen.len()).map(|i| between(seen, i, coordinates) / maps).collect();
            let columns: BTreeMap<String, Vec<f64>> = [("s", 0), ("t", 1)]
                .map(|(name, axis)| (name.to_owned(), places.iter().map(|at| at[axis]).collect()))
                .into();
            let columns = self.sampler.inputs(columns);
            quantize_inputs(&self.sampler.design.netlist, &columns, &mut words)?;
            let out = self.sampler.run(sampler, &words, shot, 1);
            let texels = |i: &str, j: &str| -> Vec<i64> {
                let pairs = out[i].iter().zip(&out[j]);
                pairs.map(|(i, j)| code(front.stored(*i, *j))).collect()
            };
            if front.scene.emboss.filter == Filter::Nearest {
                inputs.insert(name, texels("i", "j"));
                continue;
            }
            for (corner, i, j) in
                [("00", "i0", "j0"), ("10", "i1", "j0"), ("01", "i0", "j1"), ("11", "i1", "j1")]
            {
                inputs.insert(format!("{name}_{corner}"), texels(i, j));
            }
            for fraction in ["a", "b"] {
                inputs.insert(format!("{name}_{fraction}"), out[fraction].clone());
            }
        }
        let colours: Vec<[f64; 3]> = (0..seen.len()).map(|i| front.colour(seen, i)).collect();
        for (name, channel) in [("r", 0), ("g", 1), ("b", 2)] {
            let word = |colour: &[f64; 3]| cast::i64_of((colour[channel] * most).round());
            inputs.insert(name.to_owned(), colours.iter().map(word).collect());
        }
        let out = self.combine.run(combine, &self.combine.inputs(inputs), shot, 2);
        shot.samples += cast::count_of(seen.len());
        let channels = ["out_r", "out_g", "out_b"].map(|name| &out[name]);
        let colour = |i: usize| channels.map(|words| cast::f64_of(words[i]) / most);
        Ok((0..seen.len()).map(colour).collect())
    }
}

/// The largest distances along both axes.
fn apart(is: &[DVec2], should: &[DVec2]) -> DVec2 {
    let apart = is.iter().zip(should).map(|(is, should)| (*is - *should).abs());
    apart.fold(DVec2::ZERO, DVec2::max)
}
