//! The part of a scene that the goldens and all pipelines share.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::shading::render::pipeline::Pipeline;
use crate::shading::scene::{
    Address, Filter, Light, LightSign, Place, Scene, Seen, Tessellation, Vertex,
};
use glam::{DMat3, DVec2, DVec3};

/// Distance of a directional light from the lit point.
pub const FAR_AWAY: f64 = 1024.0;

/// The 8-bit code of texels and channels that stands for 1.
pub(super) const TEXEL_MAX: f64 = 255.0;

/// Texture coordinates of every vertex, in texels: plain, and displaced by each light.
#[derive(Clone, Default)]
pub(super) struct Coordinates {
    pub(super) plain: Vec<DVec2>,
    pub(super) displaced: Vec<Vec<DVec2>>,
}

/// The direction in which a setting displaces, and so the sign of its difference of samples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Way {
    /// Towards the light.
    Toward,
    /// Away from the light.
    Away,
}

impl Way {
    pub(super) fn of(pipeline: &Pipeline) -> Self {
        let nv = pipeline.assignments.iter().any(|set| set == "setting=nv");
        if nv { Self::Away } else { Self::Toward }
    }

    /// The sign of displacements, and of the undisplaced height minus the displaced one.
    fn sign(self) -> f64 {
        match self {
            Self::Toward => 1.0,
            Self::Away => -1.0,
        }
    }

    /// The value of the combiner's parameter `difference`.
    pub(super) fn difference(self) -> &'static str {
        match self {
            Self::Toward => "undisplaced-displaced",
            Self::Away => "displaced-undisplaced",
        }
    }
}

/// The part of a scene that the goldens and all pipelines share.
pub(super) struct Front<'a> {
    pub(super) scene: &'a Scene,
    pub(super) mesh: Tessellation,
    /// From the world's axes to the camera's: the rows are its right, its up, and backwards.
    pub(super) turn: DMat3,
    /// Vertices in the order of the mesh, in camera space.
    pub(super) eye: Vec<Vertex>,
    /// The light of each vertex.
    pub(super) light: Vec<f64>,
    /// Texels of the height map, 0 to 255; the row of t = 0 first.
    pub(super) texels: Vec<u8>,
    /// Columns and rows.
    pub(super) size: [u32; 2],
    pub(super) toward: Coordinates,
    pub(super) away: Coordinates,
}

impl<'a> Front<'a> {
    pub(super) fn new(scene: &'a Scene) -> Result<Self> {
        let (width, height) = scene.bumps.size();
        let fits = |side: u32| side.is_power_of_two() && (2..=8192).contains(&side);
        if !fits(width) || !fits(height) {
            return Err(Error::usage(format!(
                "a height map of {width} x {height} texels: for an emboss, legal are sides of powers of two from 2 to 8192; give [height] such `width` and `height`, or scale its file"
            )));
        }
        let columns = cast::index_of_u32(width);
        let dents = scene.bumps.scale() < 0.0;
        let code = |height: &f64| {
            let height = if dents { 1.0 - height } else { *height };
            u8::try_from(cast::i64_of((height.clamp(0.0, 1.0) * TEXEL_MAX).round()))
                .expect("bug: heights are 0 to 1")
        };
        let rows = scene.bumps.heights().chunks(columns).rev();
        let texels: Vec<u8> = rows.flatten().map(code).collect();
        let mesh = scene.tessellate()?;
        let camera = &scene.camera;
        let back = (camera.eye - camera.target).normalize();
        let right = camera.up.normalize().cross(back).normalize();
        let turn = DMat3::from_cols(right, back.cross(right), back).transpose();
        let to_eye = |vertex: &Vertex| Vertex {
            position: turn * (vertex.position - camera.eye),
            normal: turn * vertex.normal,
            tangent: turn * vertex.tangent,
            binormal: turn * vertex.binormal,
            ..*vertex
        };
        let eye: Vec<Vertex> = mesh.vertices.iter().map(to_eye).collect();
        let size = [width, height];
        let mut front = Self {
            scene,
            mesh,
            turn,
            eye,
            light: Vec::new(),
            texels,
            size,
            toward: Coordinates::default(),
            away: Coordinates::default(),
        };
        front.light = front.mesh.vertices.iter().map(|vertex| gouraud(scene, vertex)).collect();
        front.toward = front.displaced(Way::Toward);
        front.away = front.displaced(Way::Away);
        Ok(front)
    }

    /// The golden coordinates.
    pub(super) fn golden(&self, way: Way) -> &Coordinates {
        match way {
            Way::Toward => &self.toward,
            Way::Away => &self.away,
        }
    }

    fn in_texels(&self, vertex: &Vertex) -> DVec2 {
        vertex.uv * DVec2::new(f64::from(self.size[0]), f64::from(self.size[1]))
    }

    /// The position of a light in camera space, seen from a vertex.
    pub(super) fn light_in_eye(&self, light: &Light, number: usize) -> DVec3 {
        match light.place {
            Place::Direction(direction) => {
                self.eye[number].position + FAR_AWAY * (self.turn * direction)
            }
            Place::Position(position) => self.turn * (position - self.scene.camera.eye),
        }
    }

    /// The golden displacements.
    fn displaced(&self, way: Way) -> Coordinates {
        let emboss = self.scene.emboss;
        let sign = match emboss.light_sign {
            LightSign::LightVertex => way.sign(),
            LightSign::VertexLight => -way.sign(),
        };
        let displaced = |light: &Light| -> Vec<DVec2> {
            let at = |(number, vertex): (usize, &Vertex)| {
                let to_light = self.light_in_eye(light, number) - vertex.position;
                let unit = to_light.try_normalize().unwrap_or(DVec3::ZERO);
                let along = DVec2::new(vertex.tangent.dot(unit), vertex.binormal.dot(unit));
                self.in_texels(vertex) + sign * emboss.strength * along
            };
            self.eye.iter().enumerate().map(at).collect()
        };
        Coordinates {
            plain: self.eye.iter().map(|vertex| self.in_texels(vertex)).collect(),
            displaced: self.scene.lights.iter().map(displaced).collect(),
        }
    }

    /// A texel, 0 to 255, at any coordinate.
    fn texel(&self, column: i64, row: i64) -> f64 {
        let at = |index: i64, axis: usize| {
            let side = i64::from(self.size[axis]);
            match self.scene.emboss.address[axis] {
                Address::Wrap => index.rem_euclid(side),
                Address::Clamp => index.clamp(0, side - 1),
            }
        };
        self.stored(at(column, 0), at(row, 1))
    }

    /// A texel inside the map.
    pub(super) fn stored(&self, column: i64, row: i64) -> f64 {
        let index = row * i64::from(self.size[0]) + column;
        f64::from(self.texels[cast::index_of(index)])
    }

    /// The golden height at a position in texels, 0 to 255.
    fn height(&self, at: DVec2) -> f64 {
        if self.scene.emboss.filter == Filter::Nearest {
            return self.texel(cast::i64_of(at.x.floor()), cast::i64_of(at.y.floor()));
        }
        let at = at - 0.5;
        let (first, part) = (at.floor(), at - at.floor());
        let (column, row) = (cast::i64_of(first.x), cast::i64_of(first.y));
        let mix = |p: f64, q: f64, x: f64| p * (1.0 - x) + q * x;
        let along = |row| mix(self.texel(column, row), self.texel(column + 1, row), part.x);
        mix(along(row), along(row + 1), part.y)
    }

    /// The largest difference of neighbouring texels along s and along t, in codes.
    pub(super) fn steepest(&self) -> [f64; 2] {
        let [width, height] = self.size.map(i64::from);
        let mut most = [0f64; 2];
        for row in 0..height {
            for column in 0..width {
                let here = self.texel(column, row);
                // A clamped border continues with itself.
                most[0] = most[0].max((self.texel(column + 1, row) - here).abs());
                most[1] = most[1].max((self.texel(column, row + 1) - here).abs());
            }
        }
        most
    }

    /// The diffuse colour of a pixel, 0 to 1.
    pub(super) fn colour(&self, seen: &Seen, i: usize) -> [f64; 3] {
        let light = seen.between(i, |vertex| self.light[vertex]);
        let [u, v] = [0, 1].map(|axis| seen.between(i, |vertex| self.eye[vertex].uv[axis]));
        let texture = &self.scene.texture;
        let texel = texture.texels()[cast::index_of_u32(texture.texel(u, v))];
        texel.map(|channel| light * f64::from(channel))
    }
}

/// Ambient and diffuse light of a vertex, clamped to 1.
fn gouraud(scene: &Scene, vertex: &Vertex) -> f64 {
    let material = &scene.materials[cast::index_of_u32(vertex.object)];
    let of_light = |light: &Light| {
        let to_light = light.towards(vertex.position, vertex.normal);
        light.intensity * material.diffuse * vertex.normal.dot(to_light).max(0.0)
    };
    let diffuse: f64 = scene.lights.iter().map(of_light).sum();
    (scene.ambient * material.ambient + diffuse).min(1.0)
}

/// Coordinates interpolated between a pixel's corners.
pub(super) fn between(seen: &Seen, i: usize, of: &[DVec2]) -> DVec2 {
    DVec2::new(seen.between(i, |vertex| of[vertex].x), seen.between(i, |vertex| of[vertex].y))
}

/// The golden colour of a pixel.
pub(super) fn golden(front: &Front<'_>, way: Way, seen: &Seen, i: usize) -> [f64; 3] {
    let height = |of: &[DVec2]| front.height(between(seen, i, of));
    let golden = front.golden(way);
    let here = height(&golden.plain);
    let relief: f64 = golden.displaced.iter().map(|there| here - height(there)).sum();
    let gain = way.sign() * 2f64.powi(front.scene.emboss.gain_log2) / TEXEL_MAX;
    front.colour(seen, i).map(|channel| (channel + gain * relief).clamp(0.0, 1.0))
}
