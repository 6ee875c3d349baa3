//! From TOML text to a scene: legal values, and errors with their line.

use super::limits::MAX_TRIANGLES;
use super::limits::{FAR, shown};
use super::map::{Bumps, Texture};
use super::mesh::Files;
use super::normals::{CREASE_DEGREES, Normals};
use super::procedural::{Pattern, Samples};
use super::trace::{Placement, Shape, Surfaces, Unfit};
use super::{
    Address, Bare, Camera, Emboss, Filter, Image, Light, LightSign, Material, Orbit, Place,
    Projection, Scene, map, mesh, normals,
};
use crate::base::cast;
use crate::base::document::{Document, Exactly, Table};
use crate::base::error::{Error, Result};
use glam::DVec3;
use serde::Deserialize;
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;
/// The most objects of a scene.
const MAX_OBJECTS: usize = 1000;
/// The most lights of a scene.
const MAX_LIGHTS: usize = 8;
/// The most different materials: each is computed with each light.
const MAX_MATERIALS: usize = 64;

type Real = Option<Spanned<f64>>;
type Integer = Option<Spanned<i64>>;
type Triple = Option<Spanned<Exactly<f64, 3>>>;

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct SceneText {
    image: Table<ImageText>,
    camera: Option<Spanned<Table<CameraText>>>,
    light: Vec<Spanned<Table<LightText>>>,
    ambient: Table<AmbientText>,
    material: Table<MaterialText>,
    texture: Option<Spanned<Table<MapText>>>,
    height: Option<Spanned<Table<MapText>>>,
    object: Vec<Spanned<Table<ObjectText>>>,
    emboss: Option<Table<EmbossText>>,
    orbit: Option<Spanned<Table<OrbitText>>>,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct ImageText {
    width: Integer,
    height: Integer,
    background: Triple,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct CameraText {
    projection: ProjectionText,
    eye: Triple,
    target: Triple,
    up: Triple,
    fov_degrees: Real,
    height: Real,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum ProjectionText {
    #[default]
    Perspective,
    Orthographic,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct LightText {
    kind: LightKind,
    direction: Triple,
    position: Triple,
    intensity: Real,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum LightKind {
    #[default]
    Directional,
    Point,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct AmbientText {
    intensity: Real,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct MaterialText {
    ambient: Real,
    diffuse: Real,
    specular: Real,
    exponent: Integer,
}

/// `[texture]` and `[height]`; each rejects the key that only the other has.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct MapText {
    source: Option<Source>,
    file: Option<Spanned<PathBuf>>,
    width: Integer,
    height: Integer,
    color: Triple,
    scale: Real,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct EmbossText {
    strength: Real,
    filter: Filter,
    address_s: Address,
    address_t: Address,
    light_sign: LightSign,
    gain_log2: Integer,
    tessellation: Integer,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct OrbitText {
    frames: Integer,
    light: Integer,
    center: Triple,
    axis: Triple,
    turns: Real,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Source {
    Wood,
    Brick,
    Earth,
    Lettering,
    Constant,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ObjectText {
    shape: ShapeText,
    file: Option<Spanned<PathBuf>>,
    source: Option<Spanned<MeshSource>>,
    translate: Triple,
    rotate_degrees: Triple,
    scale: Option<Spanned<Scale>>,
    crease_degrees: Real,
    #[serde(default)]
    material: Table<MaterialText>,
}

#[derive(Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum ShapeText {
    Plane,
    Cube,
    Sphere,
    Mesh,
}

/// Generated meshes.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum MeshSource {
    Shell,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "scale is a number or three numbers in brackets")]
enum Scale {
    Uniform(f64),
    Axes(Exactly<f64, 3>),
}

/// Reads a scene; `path` is its name in messages, and file names are relative to its folder.
pub(super) fn read(text: &str, path: &Path) -> Result<Scene> {
    let document = Document { text, path };
    let reader = Reader { document };
    let scene: SceneText = document.parse()?;
    let image = reader.image(&scene.image)?;
    let camera = reader.camera(scene.camera.as_ref())?;
    let lights = reader.lights(&scene.light)?;
    let ambient = reader.real("intensity", &scene.ambient.intensity, 1.0, 0.0..=1.0)?;
    let material = reader.material(&scene.material, MATERIAL)?;
    let (texture, made) = reader.texture(scene.texture.as_ref())?;
    let bumps = reader.bumps(scene.height.as_ref(), made)?;
    let emboss = reader.emboss(scene.emboss.as_ref())?;
    let orbit = reader.orbit(scene.orbit.as_ref(), &lights)?;
    if scene.object.is_empty() || scene.object.len() > MAX_OBJECTS {
        let problem = format!(
            "{} objects: legal are 1 to {MAX_OBJECTS}; an object is `[[object]]` with `shape = \"sphere\"` below it",
            scene.object.len()
        );
        return Err(Error::file(path, problem));
    }
    let mut materials = Vec::new();
    let mut different: Vec<Material> = Vec::new();
    let mut objects = Vec::new();
    let mut files = Files::default();
    let (mut triangles, mut vertices) = (0, 0);
    for object in &scene.object {
        let material = reader.material(&object.get_ref().material, material)?;
        if !different.contains(&material) {
            different.push(material);
        }
        if different.len() > MAX_MATERIALS {
            let problem = format!(
                "more than {MAX_MATERIALS} different materials, the most that a scene may have: let some objects share one"
            );
            return Err(reader.fail(&object.span(), problem));
        }
        materials.push(material);
        let (shape, placement) = reader.object(object, &mut files)?;
        if let Shape::Mesh { mesh, .. } = &shape {
            triangles += mesh.triangles.len();
            vertices += mesh.vertices.len();
        }
        if triangles > MAX_TRIANGLES {
            let problem = format!(
                "more than {MAX_TRIANGLES} triangles in all objects together, the most that a scene may have: simplify the meshes or leave some out"
            );
            return Err(reader.fail(&object.span(), problem));
        }
        if vertices > 3 * MAX_TRIANGLES {
            let problem = format!(
                "more than {} vertices in all objects together, the most that a scene may have: simplify the meshes or leave some out",
                3 * MAX_TRIANGLES
            );
            return Err(reader.fail(&object.span(), problem));
        }
        objects.push((shape, placement));
    }
    let without_uv = objects.iter().find_map(|(shape, _)| match shape {
        Shape::Mesh { file, mesh, .. } => mesh.without_uv().map(|triangle| Bare {
            file: file.clone(),
            line: mesh.line(triangle),
            triangle,
        }),
        Shape::Plane | Shape::Cube | Shape::Sphere => None,
    });
    if let Some(bare) = &without_uv {
        for (varies, map) in [(!texture.is_even(), "texture"), (!bumps.is_flat(), "height")] {
            if varies {
                let needed = format!("which [{map}] needs: unwrap the mesh, or leave [{map}] out");
                return Err(bare.error(&needed));
            }
        }
    }
    let surfaces = Surfaces::new(&objects, !bumps.is_flat(), Normals::Means).map_err(|unfit| {
        let Unfit { object, line, problem } = unfit;
        match (&objects[object].0, line) {
            (Shape::Mesh { file, .. }, Some(line)) => Error::line(file, line, problem),
            (Shape::Mesh { file, .. }, None) => Error::file(file, problem),
            (Shape::Plane | Shape::Cube | Shape::Sphere, _) => {
                reader.fail(&scene.object[object].span(), problem)
            }
        }
    })?;
    surfaces.check_tries(&camera, &image).map_err(|problem| Error::file(path, problem))?;
    Ok(Scene {
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
        without_uv,
        notes: notes(&objects),
        objects: objects.into(),
    })
}

/// How the objects' meshes differ from their files, each note once.
fn notes(objects: &[(Shape, Placement)]) -> Vec<String> {
    let mut notes: Vec<String> = Vec::new();
    for (shape, _) in objects {
        let Shape::Mesh { file, mesh, crease_degrees } = shape else { continue };
        let mut told = mesh.told();
        let without = normals::corners_without(mesh);
        if without > 0 {
            let taken = match (*crease_degrees > 0.0, mesh.is_faceted) {
                (true, _) => format!(
                    "means of the triangles around each are used, up to edges of `crease_degrees` = {crease_degrees} (`tangent-faceted` alone uses the triangles' own)"
                ),
                (false, true) => "the triangles' own are used, as glTF requires; for means up to edges of 60 degrees, set `crease_degrees` = 60 in its [[object]]".to_owned(),
                (false, false) => {
                    "the triangles' own are used, due to `crease_degrees` = 0".to_owned()
                }
            };
            told.push(format!(
                "{without} of {} corners have no normal: {taken}",
                3 * mesh.triangles.len()
            ));
        }
        let told = told.into_iter().map(|note| format!("{}: {note}", file.display()));
        for note in told {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
    }
    notes
}

const MATERIAL: Material = Material { ambient: 0.1, diffuse: 0.7, specular: 0.2, exponent: 32 };

/// The file, for the line of an error.
struct Reader<'a> {
    document: Document<'a>,
}

impl Reader<'_> {
    fn fail(&self, span: &Range<usize>, problem: String) -> Error {
        self.document.fail(span, problem)
    }

    fn real(
        &self,
        key: &str,
        given: &Real,
        default: f64,
        legal: RangeInclusive<f64>,
    ) -> Result<f64> {
        let Some(given) = given else { return Ok(default) };
        self.check(key, given.span(), *given.get_ref(), &legal)
    }

    fn check(
        &self,
        key: &str,
        span: Range<usize>,
        value: f64,
        legal: &RangeInclusive<f64>,
    ) -> Result<f64> {
        if legal.contains(&value) {
            return Ok(value);
        }
        let problem =
            format!("`{key}` = {}: legal is {} to {}", shown(value), legal.start(), legal.end());
        Err(self.fail(&span, problem))
    }

    fn triple(
        &self,
        key: &str,
        given: &Triple,
        default: [f64; 3],
        legal: RangeInclusive<f64>,
    ) -> Result<[f64; 3]> {
        let Some(given) = given else { return Ok(default) };
        let Exactly(values) = *given.get_ref();
        for value in values {
            self.check(key, given.span(), value, &legal)?;
        }
        Ok(values)
    }

    fn vector(&self, key: &str, given: &Triple, default: [f64; 3]) -> Result<DVec3> {
        self.triple(key, given, default, -FAR..=FAR).map(DVec3::from_array)
    }

    fn integer(
        &self,
        key: &str,
        given: &Integer,
        default: u32,
        legal: RangeInclusive<u32>,
    ) -> Result<u32> {
        let Some(given) = given else { return Ok(default) };
        let value = u32::try_from(*given.get_ref()).ok().filter(|value| legal.contains(value));
        value.ok_or_else(|| {
            let problem = format!(
                "`{key}` = {}: legal are whole numbers {} to {}",
                given.get_ref(),
                legal.start(),
                legal.end()
            );
            self.fail(&given.span(), problem)
        })
    }

    /// Rejects a key that has no effect here.
    fn refuse<T>(&self, key: &str, given: &Option<Spanned<T>>, why: &str) -> Result<()> {
        given.as_ref().map_or(Ok(()), |given| {
            Err(self
                .fail(&given.span(), format!("`{key}` has no effect here: {why}; leave it out")))
        })
    }

    fn image(&self, image: &ImageText) -> Result<Image> {
        Ok(Image {
            width: self.integer("width", &image.width, 512, 1..=4096)?,
            height: self.integer("height", &image.height, 512, 1..=4096)?,
            background: self.triple("background", &image.background, [0.0; 3], 0.0..=1.0)?,
        })
    }

    fn camera(&self, given: Option<&Spanned<Table<CameraText>>>) -> Result<Camera> {
        let default = Table::default();
        let camera = given.map_or(&default, Spanned::get_ref);
        let projection = match camera.projection {
            ProjectionText::Perspective => {
                self.refuse("height", &camera.height, "it is for `projection = \"orthographic\"`")?;
                let fov_degrees =
                    self.real("fov_degrees", &camera.fov_degrees, 40.0, 0.01..=170.0)?;
                Projection::Perspective { fov_degrees }
            }
            ProjectionText::Orthographic => {
                let why = "it is for `projection = \"perspective\"`";
                self.refuse("fov_degrees", &camera.fov_degrees, why)?;
                let height = self.real("height", &camera.height, 4.0, 1e-6..=FAR)?;
                Projection::Orthographic { height }
            }
        };
        let eye = self.vector("eye", &camera.eye, [3.0, -4.0, 3.0])?;
        let target = self.vector("target", &camera.target, [0.0; 3])?;
        let up = self.vector("up", &camera.up, [0.0, 0.0, 1.0])?;
        let line = |key: &Triple| match (key, given) {
            (Some(key), _) => key.span(),
            (None, Some(camera)) => camera.span(),
            (None, None) => 0..0,
        };
        let Some(view) = (target - eye).try_normalize() else {
            let problem = "the camera's `eye` is its `target`: move one of them".to_owned();
            return Err(self.fail(&line(&camera.eye), problem));
        };
        // A millionth of a radian.
        if up.try_normalize().is_none_or(|up| view.cross(up).length() < 1e-6) {
            let mut legal = [0; 3];
            legal[view.abs().min_position()] = 1;
            let problem = format!(
                "the camera's `up` = [{}, {}, {}] is zero or along the view: choose another, such as {legal:?}",
                up.x, up.y, up.z
            );
            return Err(self.fail(&line(&camera.up), problem));
        }
        Ok(Camera { projection, eye, target, up })
    }

    fn lights(&self, given: &[Spanned<Table<LightText>>]) -> Result<Vec<Light>> {
        if given.len() > MAX_LIGHTS {
            let problem = format!("{} lights: legal are 1 to {MAX_LIGHTS}", given.len());
            return Err(self.fail(&given[MAX_LIGHTS].span(), problem));
        }
        if given.is_empty() {
            return Ok(vec![self.light(&LightText::default())?]);
        }
        given.iter().map(|light| self.light(light.get_ref())).collect()
    }

    fn light(&self, light: &LightText) -> Result<Light> {
        let place = match light.kind {
            LightKind::Directional => {
                self.refuse("position", &light.position, "it is for `kind = \"point\"`")?;
                let direction = self.vector("direction", &light.direction, [1.0, -2.0, 3.0])?;
                let unit = direction.try_normalize().ok_or_else(|| {
                    let span = light.direction.as_ref().map(Spanned::span).unwrap_or_default();
                    let problem =
                        "`direction` is zero: it must point from the surface towards the light";
                    self.fail(&span, problem.to_owned())
                })?;
                Place::Direction(unit)
            }
            LightKind::Point => {
                self.refuse("direction", &light.direction, "it is for `kind = \"directional\"`")?;
                Place::Position(self.vector("position", &light.position, [2.0, -4.0, 6.0])?)
            }
        };
        Ok(Light { place, intensity: self.real("intensity", &light.intensity, 1.0, 0.0..=1.0)? })
    }

    fn emboss(&self, given: Option<&Table<EmbossText>>) -> Result<Emboss> {
        let left_out = Table::default();
        let emboss = given.unwrap_or(&left_out);
        let gain_log2 = match &emboss.gain_log2 {
            None => 0,
            Some(given) => {
                let value = i32::try_from(*given.get_ref()).ok().filter(|g| (-8..=8).contains(g));
                value.ok_or_else(|| {
                    let text = "legal are whole numbers -8 to 8";
                    self.fail(&given.span(), format!("`gain_log2` = {}: {text}", given.get_ref()))
                })?
            }
        };
        Ok(Emboss {
            asked: given.is_some(),
            strength: self.real("strength", &emboss.strength, 1.5, 0.0..=64.0)?,
            filter: emboss.filter,
            address: [emboss.address_s, emboss.address_t],
            light_sign: emboss.light_sign,
            gain_log2,
            tessellation: self.integer("tessellation", &emboss.tessellation, 32, 1..=256)?,
        })
    }

    /// The orbit of a light.
    fn orbit(
        &self,
        given: Option<&Spanned<Table<OrbitText>>>,
        lights: &[Light],
    ) -> Result<Option<Orbit>> {
        let Some(given) = given else { return Ok(None) };
        let orbit = given.get_ref();
        let last = u32::try_from(lights.len() - 1).expect("bug: eight lights at most");
        let axis = self.vector("axis", &orbit.axis, [0.0, 0.0, 1.0])?;
        let axis = axis.try_normalize().ok_or_else(|| {
            let span = orbit.axis.as_ref().map_or(given.span(), Spanned::span);
            self.fail(
                &span,
                "`axis` is zero: give the direction about which the light rotates".to_owned(),
            )
        })?;
        let light = self.integer("light", &orbit.light, 0, 0..=last)?;
        if matches!(lights[cast::index_of_u32(light)].place, Place::Direction(_)) {
            self.refuse("center", &orbit.center, "the light is directional")?;
        }
        Ok(Some(Orbit {
            frames: self.integer("frames", &orbit.frames, 12, 1..=360)?,
            light: cast::index_of_u32(light),
            center: self.vector("center", &orbit.center, [0.0; 3])?,
            axis,
            turns: self.real("turns", &orbit.turns, 1.0, -100.0..=100.0)?,
        }))
    }

    /// A material; keys that aren't given have the values of `base`.
    fn material(&self, given: &MaterialText, base: Material) -> Result<Material> {
        Ok(Material {
            ambient: self.real("ambient", &given.ambient, base.ambient, 0.0..=1.0)?,
            diffuse: self.real("diffuse", &given.diffuse, base.diffuse, 0.0..=1.0)?,
            specular: self.real("specular", &given.specular, base.specular, 0.0..=1.0)?,
            exponent: self.integer("exponent", &given.exponent, base.exponent, 0..=255)?,
        })
    }

    /// The texture, and the samples that it was generated from.
    fn texture(
        &self,
        given: Option<&Spanned<Table<MapText>>>,
    ) -> Result<(Texture, Option<Samples>)> {
        let default = Table::default();
        let map = given.map_or(&default, Spanned::get_ref);
        self.refuse("scale", &map.scale, "it is for `[height]`")?;
        match self.origin(map, given)? {
            Origin::File(file) => {
                self.refuse("color", &map.color, "colours come from the file")?;
                Ok((self.opened(file, Texture::open)?, None))
            }
            Origin::Pattern(pattern, width, height) => {
                self.refuse("color", &map.color, "colours come from `source`")?;
                let made = pattern.over(width, height);
                Ok((Texture::made(&made), Some(made)))
            }
            Origin::Constant(width, height) => {
                let color = self.triple("color", &map.color, [1.0; 3], 0.0..=1.0)?;
                Ok((Texture::constant(color, width, height), None))
            }
        }
    }

    /// The bumps; samples generated for the texture are reused.
    fn bumps(
        &self,
        given: Option<&Spanned<Table<MapText>>>,
        made: Option<Samples>,
    ) -> Result<Bumps> {
        let default = Table::default();
        let map = given.map_or(&default, Spanned::get_ref);
        self.refuse("color", &map.color, "it is for `[texture]`")?;
        let scale = self.real("scale", &map.scale, 4.0, -FAR..=FAR)?;
        match self.origin(map, given)? {
            Origin::File(file) => self.opened(file, |path| Bumps::open(path, scale)),
            Origin::Pattern(pattern, width, height) => {
                let wanted = (pattern, width, height);
                let made = made.filter(|made| (made.pattern, made.width, made.height) == wanted);
                let made = made.unwrap_or_else(|| pattern.over(width, height));
                Ok(Bumps::made(&made, scale))
            }
            Origin::Constant(width, height) => Ok(Bumps::constant(width, height)),
        }
    }

    fn origin<'m>(
        &self,
        map: &'m MapText,
        given: Option<&Spanned<Table<MapText>>>,
    ) -> Result<Origin<'m>> {
        let span = given.map(Spanned::span).unwrap_or_default();
        if let Some(file) = &map.file {
            if map.source.is_some() {
                let problem = "`source` and `file` are both given: remove one of them";
                return Err(self.fail(&span, problem.to_owned()));
            }
            self.refuse("width", &map.width, "the size is that of the file")?;
            self.refuse("height", &map.height, "the size is that of the file")?;
            return Ok(Origin::File(file));
        }
        let pattern = match map.source {
            Some(Source::Wood) => Some(Pattern::Wood),
            Some(Source::Brick) => Some(Pattern::Brick),
            Some(Source::Earth) => Some(Pattern::Earth),
            Some(Source::Lettering) => Some(Pattern::Lettering),
            Some(Source::Constant) | None => None,
        };
        let default = pattern.map_or((1, 1), Pattern::default_size);
        let width = self.integer("width", &map.width, default.0, 1..=map::MAX_SIDE)?;
        let height = self.integer("height", &map.height, default.1, 1..=map::MAX_SIDE)?;
        map::check_size(width, height).map_err(|problem| self.fail(&span, problem))?;
        Ok(match pattern {
            Some(pattern) => Origin::Pattern(pattern, width, height),
            None => Origin::Constant(width, height),
        })
    }

    fn object(
        &self,
        given: &Spanned<Table<ObjectText>>,
        files: &mut Files,
    ) -> Result<(Shape, Placement)> {
        let object = given.get_ref();
        let scale = match &object.scale {
            None => [1.0; 3],
            Some(scale) => {
                let axes = match *scale.get_ref() {
                    Scale::Uniform(factor) => [factor; 3],
                    Scale::Axes(Exactly(axes)) => axes,
                };
                if let Some(wrong) = axes.iter().find(|x| !(1e-6..=FAR).contains(&x.abs())) {
                    let problem = format!(
                        "`scale` = {}: legal is 0.000001 to {FAR}, or the negative of that, which mirrors",
                        shown(*wrong)
                    );
                    return Err(self.fail(&scale.span(), problem));
                }
                axes
            }
        };
        let translate = self.vector("translate", &object.translate, [0.0; 3])?;
        let rotate = self.vector("rotate_degrees", &object.rotate_degrees, [0.0; 3])?;
        let placement = Placement::new(translate, rotate.to_array(), DVec3::from_array(scale));
        if object.shape != ShapeText::Mesh {
            self.refuse("file", &object.file, "it is for `shape = \"mesh\"`")?;
            self.refuse("source", &object.source, "it is for `shape = \"mesh\"`")?;
            self.refuse("crease_degrees", &object.crease_degrees, "it is for meshes from files")?;
        }
        let shape = match object.shape {
            ShapeText::Plane => Shape::Plane,
            ShapeText::Cube => Shape::Cube,
            ShapeText::Sphere => Shape::Sphere,
            ShapeText::Mesh => {
                if let Some(source) = &object.source {
                    let why = "the mesh comes from `source`";
                    self.refuse("file", &object.file, why)?;
                    let why = "that mesh has normals";
                    self.refuse("crease_degrees", &object.crease_degrees, why)?;
                    let MeshSource::Shell = source.get_ref();
                    let (file, mesh) = (PathBuf::from("shell"), Arc::new(mesh::shell()));
                    let crease_degrees = CREASE_DEGREES;
                    return Ok((Shape::Mesh { file, mesh, crease_degrees }, placement));
                }
                let file = object.file.as_ref().ok_or_else(|| {
                    let problem =
                        "a mesh needs `file`, an .obj, .gltf or .glb file, or `source = \"shell\"`"
                            .to_owned();
                    self.fail(&given.span(), problem)
                })?;
                let mesh = self.opened(file, |path| files.open(path))?;
                let file = self.beside(file.get_ref());
                let default = if mesh.is_faceted { 0.0 } else { CREASE_DEGREES };
                let crease_degrees = &object.crease_degrees;
                let crease_degrees =
                    self.real("crease_degrees", crease_degrees, default, 0.0..=180.0)?;
                Shape::Mesh { file, mesh, crease_degrees }
            }
        };
        Ok((shape, placement))
    }

    /// What is read from a file. An error about the file as a whole names the line that names it.
    fn opened<T>(
        &self,
        file: &Spanned<PathBuf>,
        open: impl FnOnce(&Path) -> Result<T>,
    ) -> Result<T> {
        open(&self.beside(file.get_ref())).map_err(|error| {
            if error.is_of_file() { self.fail(&file.span(), error.to_string()) } else { error }
        })
    }

    /// A path relative to the scene's folder.
    fn beside(&self, file: &Path) -> PathBuf {
        self.document.path.parent().unwrap_or(Path::new("")).join(file)
    }
}

/// Where a map comes from.
enum Origin<'m> {
    File(&'m Spanned<PathBuf>),
    Pattern(Pattern, u32, u32),
    Constant(u32, u32),
}
