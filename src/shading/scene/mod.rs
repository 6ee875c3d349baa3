//! Scenes: objects, lights, textures and a camera from a TOML file, and the pixels that they cover.
//!
//! [`Scene::open`] reads a file. [`Scene::builtin`] returns one of the scenes built into the
//! program. [`Scene::trace`]
//! computes, row by row, what each covered pixel sees:
//!
//! ```
//! use fixpath::scene::{Fragments, Scene};
//! use std::path::Path;
//!
//! let text = "[camera]\neye = [5, 0, 0]\n[[object]]\nshape = \"cube\"";
//! let scene = Scene::parse(text, Path::new("example.toml"))?;
//! let mut seen = Fragments::default();
//! scene.trace(256..257, &mut seen); // the row in the middle
//! assert!(seen.normal[0].iter().all(|x| *x == 1.0)); // of the face towards +x
//! # Ok::<(), fixpath::error::Error>(())
//! ```
//!
#![doc = include_str!("../../../docs/files/scene.md")]
#![doc = include_str!("../../../docs/rendering.md")]

mod assembly;
mod gltf;
mod jpeg;
mod limits;
mod map;
mod mesh;
mod normals;
mod obj;
mod polygon;
mod procedural;
mod tessellation;
mod text;
mod trace;

pub use crate::shading::srgb::from_srgb;
pub use assembly::{SharedVertex, Sharing, Topology};
pub use map::{Bumps, Texture};
pub use tessellation::{Assembly, Seen, Tessellation, Vertex};
pub use trace::{CURVED, Fragments};

use crate::base::error::{Error, Result};
use crate::base::input;
use crate::number::trig::rotation;
use glam::DVec3;
use normals::Normals;
use serde::Deserialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use trace::{Placement, Shape, Surfaces};

/// The built-in scenes, with their TOML text.
pub const BUILTIN: &[(&str, &str)] = &[
    ("plane", include_str!("builtin/plane.toml")),
    ("cube", include_str!("builtin/cube.toml")),
    ("sphere", include_str!("builtin/sphere.toml")),
    ("lettering-raised", include_str!("builtin/lettering-raised.toml")),
    ("lettering-lowered", include_str!("builtin/lettering-lowered.toml")),
    ("brick", include_str!("builtin/brick.toml")),
    ("light-orbit", include_str!("builtin/light-orbit.toml")),
    ("mirrored", include_str!("builtin/mirrored.toml")),
];

/// A scene, checked and ready to be traced. Camera, lights and materials may be changed; shapes and
/// their placement are fixed.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Size and background of the image.
    pub image: Image,
    /// The camera.
    pub camera: Camera,
    /// Its lights, 1 to 8.
    pub lights: Vec<Light>,
    /// Intensity of the ambient light, 0 to 1.
    pub ambient: f64,
    /// Colours of its surfaces.
    pub texture: Texture,
    /// Bump vectors of its surfaces.
    pub bumps: Bumps,
    /// Material of each object.
    pub materials: Vec<Material>,
    /// Settings of emboss pipelines.
    pub emboss: Emboss,
    /// The path of a light from frame to frame, if there is more than one picture.
    pub orbit: Option<Orbit>,
    surfaces: Surfaces,
    /// What the surfaces were built from.
    objects: Arc<[(Shape, Placement)]>,
    /// The first triangle without texture coordinates.
    without_uv: Option<Bare>,
    notes: Vec<String>,
}

/// A triangle of a file.
#[derive(Clone, Debug)]
struct Bare {
    file: PathBuf,
    line: Option<u64>,
    triangle: usize,
}

impl Bare {
    /// The error that it has no texture coordinates; `needed` says what for.
    fn error(&self, needed: &str) -> Error {
        let Self { file, line, triangle } = self;
        let problem =
            format!("triangle {triangle} (they count from 0) has no texture coordinates, {needed}");
        match line {
            Some(line) => Error::line(file, *line, problem),
            None => Error::file(file, problem),
        }
    }
}

/// Size and background of a scene's image.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Image {
    /// Columns, 1 to 4096.
    pub width: u32,
    /// Rows, 1 to 4096.
    pub height: u32,
    /// Linear RGB, each 0 to 1, where no object is.
    pub background: [f64; 3],
}

/// Where a scene is seen from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Camera {
    /// Its projection.
    pub projection: Projection,
    /// The position of the eye.
    pub eye: DVec3,
    /// The point that it looks at; not the eye.
    pub target: DVec3,
    /// The direction that is up in the image; not along the view.
    pub up: DVec3,
}

/// The projection of a camera.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Projection {
    /// Perspective: all rays start at the eye.
    Perspective {
        /// Vertical field of view, in degrees.
        fov_degrees: f64,
    },
    /// Orthographic: all rays are parallel.
    Orthographic {
        /// Height of the image in the world.
        height: f64,
    },
}

/// A light.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Light {
    /// Where it is.
    pub place: Place,
    /// Intensity, 0 to 1; the same at every distance.
    pub intensity: f64,
}

/// Where a light is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Place {
    /// Infinitely far: the unit vector from every surface towards it.
    Direction(DVec3),
    /// At a point.
    Position(DVec3),
}

/// How a surface reflects light: `Ia ka + Σ I (kd max(0, N·L) + ks max(0, N·H)^n)`, where the last
/// term is 0 unless N·H > 0, even for n = 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Material {
    /// ka, 0 to 1.
    pub ambient: f64,
    /// kd, 0 to 1.
    pub diffuse: f64,
    /// ks, 0 to 1.
    pub specular: f64,
    /// n, 0 to 255.
    pub exponent: u32,
}

/// The settings of an emboss: `[emboss]` of a scene file.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Emboss {
    /// True if the scene has the section: the scene is then embossed if no pipelines are named.
    pub asked: bool,
    /// The largest displacement, in texels: that of a light parallel to the surface. 0 to 64.
    pub strength: f64,
    /// How heights are looked up.
    pub filter: Filter,
    /// How the map continues beyond its border, along s and along t.
    pub address: [Address; 2],
    /// The direction of the vector between vertex and light.
    pub light_sign: LightSign,
    /// Height differences are multiplied by 2^gain_log2, -8 to 8.
    pub gain_log2: i32,
    /// Segments along the edge of a plane or of a cube's face, and along 180° of a sphere, 1 to
    /// 256.
    pub tessellation: u32,
}

/// The filter of a map.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Filter {
    /// The texel that contains the coordinate.
    Nearest,
    /// The four texels around it, weighted.
    #[default]
    Bilinear,
}

/// How a map continues beyond its border.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Address {
    /// It repeats.
    #[default]
    Wrap,
    /// Its border texels extend.
    Clamp,
}

/// The direction of L; the wrong one makes raised shapes look sunken.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LightSign {
    /// From the vertex to the light.
    #[default]
    LightVertex,
    /// From the light to the vertex, as the patent prints it.
    VertexLight,
}

impl Filter {
    /// Its name in scene files and parameters.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nearest => "nearest",
            Self::Bilinear => "bilinear",
        }
    }
}

impl Address {
    /// Its name in scene files and parameters.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Wrap => "wrap",
            Self::Clamp => "clamp",
        }
    }
}

impl LightSign {
    /// Its name in scene files and parameters.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::LightVertex => "light-vertex",
            Self::VertexLight => "vertex-light",
        }
    }
}

/// A light that rotates about an axis from frame to frame: `[orbit]` of a scene file.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Orbit {
    /// Number of pictures, 1 to 360.
    pub frames: u32,
    /// The light's number, counted from 0.
    pub light: usize,
    /// A point on the axis; used for a point light.
    pub center: DVec3,
    /// The axis, a unit vector; the light rotates counter-clockwise seen from its tip.
    pub axis: DVec3,
    /// Turns over all frames: frame k is rotated by k / frames of them.
    pub turns: f64,
}

/// Facts that hold for every pixel of a scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Facts {
    /// Some material has a specular part and some light has an intensity: H is needed.
    pub specular: bool,
    /// Every bump vector is (0, 0, 1).
    pub flat_bumps: bool,
    /// No texture is mirrored: handedness is +1 everywhere.
    pub right_handed: bool,
}

impl Scene {
    /// Reads a scene file; the paths in it are relative to its folder.
    ///
    /// # Errors
    /// If it or a file that it names can't be read, isn't TOML, has an unknown key or an illegal
    /// value (the error names the line), or a mesh can't be lit.
    pub fn open(path: &Path) -> Result<Self> {
        text::read(&input::text(path, map::MAX_BYTES)?, path)
    }

    /// A scene from TOML text; the paths in it are relative to the folder of `path`, and messages
    /// name `path`.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn parse(text: &str, path: &Path) -> Result<Self> {
        text::read(text, path)
    }

    /// One of [`BUILTIN`], by name.
    ///
    /// # Errors
    /// If there is no such scene.
    pub fn builtin(name: &str) -> Result<Self> {
        let Some((_, text)) = BUILTIN.iter().find(|(known, _)| *known == name) else {
            let known: Vec<&str> = BUILTIN.iter().map(|(known, _)| *known).collect();
            let problem = format!(
                "no built-in scene `{name}`: there are {}; or give the path of a scene file",
                known.join(", ")
            );
            return Err(Error::usage(problem));
        };
        text::read(text, Path::new(name))
    }

    /// The facts that hold for every pixel.
    #[must_use]
    pub fn facts(&self) -> Facts {
        let lit = self.lights.iter().any(|light| light.intensity > 0.0);
        Facts {
            specular: lit && self.materials.iter().any(|material| material.specular > 0.0),
            flat_bumps: self.bumps.is_flat(),
            right_handed: self.surfaces.is_right_handed(),
        }
    }

    /// What was left out of its files, ignored or generated, in words.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The same scene with each triangle's own normal, instead of a mean, where meshes lack
    /// normals: for pipelines that need none at vertices. `None` if no mesh lacks normals.
    ///
    /// # Panics
    /// Never: the surfaces were built before.
    #[must_use]
    pub fn faceted(&self) -> Option<Self> {
        let lacks = |(shape, _): &(Shape, Placement)| match shape {
            Shape::Mesh { mesh, .. } => normals::corners_without(mesh) > 0,
            Shape::Plane | Shape::Cube | Shape::Sphere => false,
        };
        if !self.objects.iter().any(lacks) {
            return None;
        }
        let surfaces = Surfaces::new(&self.objects, !self.bumps.is_flat(), Normals::Facets);
        Some(Self { surfaces: surfaces.expect("bug: surfaces made before"), ..self.clone() })
    }

    /// Rejects a scene that has triangles without texture coordinates, for users that derive T from
    /// them.
    pub(crate) fn demand_uv(&self, by: &str) -> Result<()> {
        let needed =
            format!("from which {by} computes T: unwrap the mesh, or use a pipeline without it");
        self.without_uv.as_ref().map_or(Ok(()), |bare| Err(bare.error(&needed)))
    }

    /// Number of pictures: 1, or the number of frames of its orbit.
    #[must_use]
    pub fn frames(&self) -> u32 {
        self.orbit.map_or(1, |orbit| orbit.frames)
    }

    /// The scene with a moving light fixed at its start, and a note that says so: for commands that
    /// render one picture.
    #[must_use]
    pub fn at_start(&self) -> Self {
        Self { notes: self.notes_at_start(), ..self.frame(0) }
    }

    /// The notes of [`Self::at_start`].
    pub(crate) fn notes_at_start(&self) -> Vec<String> {
        let moves = |orbit: Orbit| {
            format!("[orbit]: light {} moves; its starting position is used", orbit.light)
        };
        self.notes.iter().cloned().chain(self.orbit.map(moves)).collect()
    }

    /// The scene of a frame, counted from 0: the orbiting light is at its position for that frame,
    /// and the orbit is removed.
    #[must_use]
    pub fn frame(&self, number: u32) -> Self {
        let mut scene = self.clone();
        if let Some(orbit) = scene.orbit.take() {
            let part = f64::from(number) / f64::from(orbit.frames);
            let turned = rotation(orbit.axis, orbit.turns * part);
            let place = &mut scene.lights[orbit.light].place;
            *place = match *place {
                Place::Direction(direction) => Place::Direction((turned * direction).normalize()),
                Place::Position(position) => {
                    Place::Position(orbit.center + turned * (position - orbit.center))
                }
            };
        }
        scene
    }

    /// A digest of everything that an image depends on, wherever its files are and whatever else
    /// they contain: scenes that differ almost certainly have different digests. It is valid for
    /// one version of this program: another may print the fields differently and give the same
    /// scene another number.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let Self {
            image,
            camera,
            lights,
            ambient,
            texture,
            bumps,
            materials,
            emboss,
            orbit,
            surfaces,
            objects: _,
            without_uv: _,
            notes: _,
        } = self;
        let mut digest = Digest(0xcbf2_9ce4_8422_2325);
        let sizes = (texture.size(), bumps.size(), bumps.scale());
        let small = (image, camera, lights, ambient, sizes, materials, emboss, orbit, surfaces);
        // Debug text has floats to the last place.
        write!(digest, "{small:?}").expect("bug: a digest takes any text");
        for texel in texture.texels().as_flattened() {
            digest.add(&texel.to_bits().to_le_bytes());
        }
        for height in bumps.heights() {
            digest.add(&height.to_bits().to_le_bytes());
        }
        digest.0
    }
}

/// 64-bit FNV-1a: the same bytes give the same number on every machine, unlike the standard
/// library's hashers.
struct Digest(u64);

impl Digest {
    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

impl Write for Digest {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}

impl Image {
    /// Number of its pixels.
    #[must_use]
    pub fn pixels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }
}

impl Light {
    /// The unit vector L from a point of a surface with normal N towards the light; N if the point
    /// coincides with a point light.
    #[must_use]
    pub fn towards(&self, point: DVec3, normal: DVec3) -> DVec3 {
        match self.place {
            Place::Direction(direction) => direction,
            Place::Position(position) => (position - point).try_normalize().unwrap_or(normal),
        }
    }
}

/// The unit vector H halfway between L and V; -N where |L+V| < 1e-12, since the light is exactly
/// behind and must give no highlight.
#[must_use]
pub fn halfway(light: DVec3, eye: DVec3, normal: DVec3) -> DVec3 {
    let sum = light + eye;
    if sum.length_squared() < 1e-24 { -normal } else { sum.normalize() }
}
