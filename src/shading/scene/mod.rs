//! Scenes: objects, lights, textures and a camera from a TOML file, and the pixels that they cover.
//!
//! [`Scene::open`] reads a file, [`Scene::builtin`] one of the scenes that come with the program
//! (their TOML text in `src/shading/scene/builtin/` shows the format), and [`Scene::trace`] gives, row
//! by row, what each covered pixel sees:
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
//! What follows is all that it takes to do the same elsewhere.
//!
//! # Space
//! The world is right-handed and z is up. A point of an object goes to
//! `translate + Rz Ry Rx (scale * point)`: scaled along its own axes, then turned about x, then
//! y, then z, counter-clockwise seen from the tip of the axis. Normals go by the inverse transpose.
//!
//! - *plane*: the square [-1, 1]^2 in z = 0, facing +z; u = (x+1)/2, v = (y+1)/2.
//! - *cube*: [-1, 1]^3. Faces 0 to 5 are +x, -x, +y, -y, +z, -z; u runs from 0 to 1 along T and v
//!   along B, which are (+y, +z), (-y, +z), (-x, +z), (+x, +z), (+x, +y), (+x, -y).
//! - *sphere*: of radius 1 about the origin, poles on z; with az the azimuth from +x towards +y
//!   and θ the angle from +z, u = az/turn in [0, 1) and v = 1 - θ/(half a turn). It is no mesh:
//!   rays meet it exactly and normals are exact. On the pole itself az is 0.
//! - *mesh*: triangles of an `.obj`, `.gltf` or `.glb` file, coordinates as in the file (glTF's y is up:
//!   `rotate_degrees = [90, 0, 0]` stands it upright): lists, strips, fans and polygons.
//!   A glTF file is read as it is at rest: with its nodes, default weights of morph targets, and skins. Texture
//!   coordinates are those of the material's colour texture (else its normal map's), by KHR_texture_transform. Nodes
//!   that mirror turn triangles over, as `scale` does.
//!   Triangles count from 0 in the file's order, without those that have no area, which are left out.
//!   Where it has no normals, they are means of those of the triangles around a point, weighted by their angles there,
//!   up to edges sharper than `crease_degrees`; if that isn't given, 60 for `.obj`, and 0 for glTF, whose specification asks
//!   for flat normals: each triangle has its own. Both are in the file's own space, before `scale`. A triangle's own side
//!   is that of the normals that it has, else that from which its corners turn counter-clockwise.
//!   Texture coordinates are needed only where `[texture]` or `[height]` differ from place to place, and
//!   for a tangent-space set-up.
//!   With `source = "shell"` instead of a file it is a dome over [-1, 1]^2 whose halves left and right of x = 0 share a
//!   texture: u = |x|, v = 2 (y + 1), z = 0.6 (1 - x²) (1 - y²), in 48 x 48 squares, each cut
//!   in two from its lower corner nearer to x = 0 to its upper one farther from it.
//!
//! # Texture frames
//! `T = normalise(dP/du - N (N·dP/du))` and `B = h (N x T)`, with handedness h = +1, or -1 where
//! the texture is mirrored: h is the sign of the determinant of (u, v) over the face, whose
//! normal points to the side that the sum of its unit vertex normals is on (where that sum is square to
//! the face, to the side from which the corners turn counter-clockwise). Each triangle has its own
//! dP/du; normals of a mesh are interpolated with barycentric weights and made unit again, and a
//! face whose three normals are equal is flat. Where dP/du lies along N, `T = normalise(h (dP/dv x N))`.
//! On the sphere, before the object is placed, T = (-sin az, cos az, 0), at its poles too.
//! A face without area in (u, v) is refused, unless every bump vector is (0, 0, 1), where T says
//! nothing; then T is along any of its edges, and h = +1.
//!
//! # Maps
//! u goes right and v goes up, as in OBJ files (glTF's v goes down and is flipped on reading).
//! The texel of (u, v) is column `floor(u w)` and row `floor((1-v) h)`, both modulo the map's size:
//! maps repeat, nearest texel, row 0 on top. A texel's index is `row * w + column`.
//! Texture files hold sRGB and are decoded to linear light ([`from_srgb`]); colours in a scene file are
//! linear. Whoever writes an image encodes it ([`to_srgb8`](crate::shading::picture::Picture::to_srgb8)).
//! Heights are 0 to 1: the grey values of a file as they are, not decoded; of channels that differ by no more than
//! 16/255, 0.2126 R + 0.7152 G + 0.0722 B, and other colours are refused. Transparency is passed over; a picture whose
//! EXIF data ask for it is turned before anything else. The bump vector of a texel is
//! `normalise(-s (h[x+1] - h[x-1])/2, -s (h[y-1] - h[y+1])/2, 1)` along (T, B, N), where y counts rows
//! downwards, neighbours wrap around, and the scale s is the height, in texels, of a difference of 1.
//!
//! # Camera and light
//! With f the direction from eye to target, right = normalise(f x up) and top = right x f, pixel
//! (x, y) of a w x h image has a = (2 (x+½)/w - 1) w/h and b = 1 - 2 (y+½)/h; y counts rows downwards.
//! In perspective its ray leaves the eye along `f + tan(fov/2) (a right + b top)`; orthographic, it leaves
//! `eye + (height/2) (a right + b top)` along f. The nearest face that is met from in front (by
//! the face's own normal, not the interpolated one) is seen; faces are closed, with 1e-9 of an edge to spare,
//! so that there is no crack between them. Nothing casts a shadow, and light doesn't fade with distance.
//!
//! V is the unit vector to the eye (orthographic: -f). L is the unit vector to the light, which for a
//! directional light is its `direction`; on the very spot of a point light, L = N. H =
//! normalise(L+V), and H = -N where |L+V| < 1e-12: from right behind there is no highlight.
//!
//! A material answers with `Ia ka + Σ I kd max(0, N'·L)` times the texture's colour, plus
//! `Σ I ks (N'·H)^n` over the lights where N'·H > 0 (with n = 0 too: 0^0 is 0 here), whichever side of the
//! surface a light is on. N' is the bump vector along (T, B, N). The two sums, and then the colour, end at 1.
//!
//! # Emboss
//! `[emboss]` says how the same scene is embossed instead, which [`crate::shading::render::emboss`] does; a scene with
//! the section is so where no pipelines are named. Light is ambient and
//! diffuse, with N in place of N', computed per vertex of the [`Tessellation`], ended at 1 and interpolated;
//! times the texture's colour. Texture coordinates in texels, (u w, v h), are displaced per vertex and light by
//! `strength` times (T·L, B·L), L as above and (0, 0) on the very
//! spot of a point light, turned round with `light_sign = "vertex-light"`; these too are interpolated. The height at
//! (x, y) in texels is that of the texel that they are in, or with `filter = "bilinear"` between those
//! whose centres, at halves, are around; heights are k/255, rounded, of 1 - h where `[height]` has a negative
//! scale. Beyond the map it repeats or its border goes on, by axis. To each channel comes
//! `2^gain_log2 Σ (height - displaced height)` over the lights, and it ends at 0 and 1.
//!
//! # In texture space
//! Pipelines of the tangent-space set-up ([`crate::shading::render::tangent`]) light the same triangles, with vertices shared
//! ([`Scene::assemble`]) and as fine as `tessellation` in `[emboss]` says, in texture space instead.
//!
//! # Frames
//! With `[orbit]` a scene has several pictures: in frame k of n the light is turned about the axis by
//! `turns k/n`, counter-clockwise seen from the axis's tip.

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

/// The scenes that come with the program, with their TOML text.
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
/// their places are fixed.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Size and background of its image.
    pub image: Image,
    /// Where it is seen from.
    pub camera: Camera,
    /// Its lights, 1 to 8.
    pub lights: Vec<Light>,
    /// Intensity of the light from everywhere, 0 to 1.
    pub ambient: f64,
    /// Colours of its surfaces.
    pub texture: Texture,
    /// Bump vectors of its surfaces.
    pub bumps: Bumps,
    /// Material of each object.
    pub materials: Vec<Material>,
    /// What emboss pipelines ask of it.
    pub emboss: Emboss,
    /// The path of a light from frame to frame, if there is more than one picture.
    pub orbit: Option<Orbit>,
    surfaces: Surfaces,
    /// What the surfaces were made from.
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
    /// That it has no texture coordinates, which something needs.
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
    /// How its rays run.
    pub projection: Projection,
    /// Where it stands.
    pub eye: DVec3,
    /// What it looks at; not the eye.
    pub target: DVec3,
    /// What is upwards in the image; not along the view.
    pub up: DVec3,
}

/// How the rays of a camera run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Projection {
    /// From the eye, through an image this many degrees high.
    Perspective {
        /// Vertical field of view, in degrees.
        fov_degrees: f64,
    },
    /// Side by side, through an image this high.
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
    /// Far away: the unit vector from every surface towards it.
    Direction(DVec3),
    /// At a point.
    Position(DVec3),
}

/// How a surface answers light: `Ia ka + Σ I (kd max(0, N·L) + ks max(0, N·H)^n)`, where the last term
/// is 0 unless N·H > 0, even for n = 0.
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

/// How an emboss looks: `[emboss]` of a scene file.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Emboss {
    /// True if the scene has the section: then it is embossed, if no pipelines are named.
    pub asked: bool,
    /// The longest displacement, in texels: that of a light along the surface. 0 to 64.
    pub strength: f64,
    /// How heights are looked up.
    pub filter: Filter,
    /// What is beyond the map, along s and along t.
    pub address: [Address; 2],
    /// Which way the vector between vertex and light runs.
    pub light_sign: LightSign,
    /// Differences of heights count 2^gain_log2 times, -8 to 8.
    pub gain_log2: i32,
    /// Parts that the edge of a plane, of a cube's face and half a turn of a sphere have, 1 to 256.
    pub tessellation: u32,
}

/// How a map is looked up.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Filter {
    /// The texel that the coordinate lies in.
    Nearest,
    /// The four texels around, weighted.
    #[default]
    Bilinear,
}

/// What is beyond a map.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Address {
    /// The map again.
    #[default]
    Wrap,
    /// Its border.
    Clamp,
}

/// Which way L runs; the wrong one turns what looks raised.
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

/// A light that turns about an axis from frame to frame: `[orbit]` of a scene file.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Orbit {
    /// Number of pictures, 1 to 360.
    pub frames: u32,
    /// The light, counted from 0.
    pub light: usize,
    /// A point of the axis, for a light at a point.
    pub center: DVec3,
    /// The axis, a unit vector; the light turns counter-clockwise seen from its tip.
    pub axis: DVec3,
    /// Turns over all frames: frame k has k / frames of them behind it.
    pub turns: f64,
}

/// What holds for every pixel of a scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Facts {
    /// Some material has a specular part and some light an intensity: H is needed.
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
    /// If it or a file that it names can't be read, isn't TOML, has a key that scenes don't
    /// have or a value that isn't legal (which names the line), or a mesh can't be lit.
    pub fn open(path: &Path) -> Result<Self> {
        text::read(&input::text(path, map::MAX_BYTES)?, path)
    }

    /// A scene from TOML text; the paths in it are relative to the folder of `path`, which is
    /// also its name in messages.
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

    /// What holds for every pixel.
    #[must_use]
    pub fn facts(&self) -> Facts {
        let lit = self.lights.iter().any(|light| light.intensity > 0.0);
        Facts {
            specular: lit && self.materials.iter().any(|material| material.specular > 0.0),
            flat_bumps: self.bumps.is_flat(),
            right_handed: self.surfaces.is_right_handed(),
        }
    }

    /// What of its files was left out, passed over or made up, in words.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The same where normals that meshes lack are those of their triangles, and not means of them: for what needs
    /// none at vertices. `None` if meshes lack none.
    ///
    /// # Panics
    /// Never: the surfaces were made before.
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

    /// Refuses a scene with triangles without texture coordinates, for what takes T from them.
    pub(crate) fn demand_uv(&self, by: &str) -> Result<()> {
        let needed = format!("from which {by} takes T: unwrap it, or take a pipeline without");
        self.without_uv.as_ref().map_or(Ok(()), |bare| Err(bare.error(&needed)))
    }

    /// Number of pictures: 1, or as many as its orbit has frames.
    #[must_use]
    pub fn frames(&self) -> u32 {
        self.orbit.map_or(1, |orbit| orbit.frames)
    }

    /// The scene where a light that moves stands still, at its start, with a note of that: for what takes one picture.
    #[must_use]
    pub fn at_start(&self) -> Self {
        Self { notes: self.notes_at_start(), ..self.frame(0) }
    }

    /// The notes of [`Self::at_start`].
    pub(crate) fn notes_at_start(&self) -> Vec<String> {
        let moves = |orbit: Orbit| {
            format!("[orbit]: light {} moves, and is taken where it starts", orbit.light)
        };
        self.notes.iter().cloned().chain(self.orbit.map(moves)).collect()
    }

    /// The scene of a frame, counted from 0: the orbiting light at its place, and no orbit left.
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

    /// A digest of all that an image depends on, wherever its files are and whatever else is in
    /// them: scenes that differ have, in all likelihood, different ones. It is for one version of
    /// this program: another may print the fields in another way, and so give the same scene
    /// another number.
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
        // Debug text has floats to the last place; a digest takes any text.
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

/// FNV-1a of 64 bits: the same bytes give the same number on every machine, unlike the standard
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
    /// The unit vector L from a point of a surface with normal N towards the light; N on the very
    /// spot of a point light.
    #[must_use]
    pub fn towards(&self, point: DVec3, normal: DVec3) -> DVec3 {
        match self.place {
            Place::Direction(direction) => direction,
            Place::Position(position) => (position - point).try_normalize().unwrap_or(normal),
        }
    }
}

/// The unit vector H halfway between L and V; -N where |L+V| < 1e-12, since the light is right behind
/// and must give no highlight.
#[must_use]
pub fn halfway(light: DVec3, eye: DVec3, normal: DVec3) -> DVec3 {
    let sum = light + eye;
    if sum.length_squared() < 1e-24 { -normal } else { sum.normalize() }
}
