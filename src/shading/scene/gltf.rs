//! Meshes from glTF 2.0: the part that shapes need, with every number checked before use.
//!
//! A file is read in its rest pose: nodes, morph targets by their default weights, skins by the
//! joints' own transforms, and texture coordinates of the material's colour texture (otherwise of
//! its normal map, and so on) with KHR_texture_transform. Images, colours, animations and cameras
//! are ignored, and so are lines and points beside triangles. A node that mirrors reverses the
//! winding of its triangles (3.7.4 of the specification). The specification doesn't say this for
//! skins: here a triangle's winding is reversed if the joints mirror most of its corners, so that
//! its front stays its front.
//!
//! This is a reader of our own. The crate `gltf` (1.4) panics on damaged files: on a component type
//! that an attribute can't have, more sparse indices than values, an accessor without elements, a
//! URI that isn't UTF-8. It reads a buffer as often as it is named, has no limits, and decodes only
//! data URIs of plain base64. It leaves skins, morph targets, strips and every check of a count to
//! its caller. JSON, base64 and %XX are decoded by other crates here too.

mod data;

use super::assembly::{Mesh, MeshVertex, Topology};
use super::limits::{MAX_TRIANGLES, check_coordinates, checked_normal};
use super::map;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::input::check_encoding;
use data::{Accessor, Buffer, Buffers, Data, View, get};
use glam::{DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::Path;

/// The file's version information, readable in any version.
#[derive(Deserialize)]
struct Head {
    #[serde(default)]
    asset: Asset,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Asset {
    version: Option<serde_json::Value>,
    min_version: Option<serde_json::Value>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Document {
    scene: Option<usize>,
    #[serde(default)]
    scenes: Vec<SceneNode>,
    #[serde(default)]
    nodes: Vec<Node>,
    #[serde(default)]
    meshes: Vec<MeshNode>,
    #[serde(default)]
    materials: Vec<Material>,
    #[serde(default)]
    skins: Vec<Skin>,
    #[serde(default)]
    accessors: Vec<Accessor>,
    #[serde(default)]
    buffer_views: Vec<View>,
    #[serde(default)]
    buffers: Vec<Buffer>,
    #[serde(default)]
    extensions_used: Vec<String>,
    #[serde(default)]
    extensions_required: Vec<String>,
}

#[derive(Deserialize)]
struct SceneNode {
    #[serde(default)]
    nodes: Vec<usize>,
}

#[derive(Deserialize)]
struct Node {
    #[serde(default)]
    children: Vec<usize>,
    mesh: Option<usize>,
    skin: Option<usize>,
    weights: Option<Vec<f64>>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
struct MeshNode {
    primitives: Vec<Primitive>,
    /// Morph-target weights, used if the node has none.
    weights: Option<Vec<f64>>,
}

/// Accessors by vertex attribute: `POSITION`, `NORMAL`, `TEXCOORD_0`, …
type Attributes = BTreeMap<String, usize>;

#[derive(Deserialize)]
struct Primitive {
    attributes: Attributes,
    indices: Option<usize>,
    material: Option<usize>,
    mode: Option<u32>,
    /// What morph targets add to the attributes.
    #[serde(default)]
    targets: Vec<Attributes>,
    #[serde(default)]
    extensions: HashMap<String, IgnoredAny>,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Material {
    pbr_metallic_roughness: Colours,
    normal_texture: Option<TextureInfo>,
    occlusion_texture: Option<TextureInfo>,
    emissive_texture: Option<TextureInfo>,
    extensions: MaterialExtensions,
}

#[derive(Default, Deserialize)]
#[serde(default)]
struct MaterialExtensions {
    /// Colours that replace the others.
    #[serde(rename = "KHR_materials_pbrSpecularGlossiness")]
    specular_glossiness: Diffuse,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Diffuse {
    diffuse_texture: Option<TextureInfo>,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Colours {
    base_color_texture: Option<TextureInfo>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct TextureInfo {
    #[serde(default)]
    tex_coord: usize,
    #[serde(default)]
    extensions: TextureExtensions,
}

#[derive(Default, Deserialize)]
struct TextureExtensions {
    #[serde(rename = "KHR_texture_transform")]
    transform: Option<TextureTransform>,
}

#[derive(Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct TextureTransform {
    offset: [f64; 2],
    rotation: f64,
    scale: [f64; 2],
    tex_coord: Option<usize>,
}

impl Default for TextureTransform {
    fn default() -> Self {
        Self { offset: [0.0; 2], rotation: 0.0, scale: [1.0; 2], tex_coord: None }
    }
}

impl TextureTransform {
    /// Transforms (u, v), v down: scale, rotate, then translate. The matrix printed in the
    /// extension's text rotates the other way than its words, its example and every viewer
    /// (KhronosGroup/glTF issue 1563).
    fn apply(&self, uv: DVec2) -> DVec2 {
        let (sin, cos) = libm::sincos(self.rotation);
        let turn = DMat2::from_cols_array(&[cos, -sin, sin, cos]);
        turn * (DVec2::from_array(self.scale) * uv) + DVec2::from_array(self.offset)
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Skin {
    inverse_bind_matrices: Option<usize>,
    joints: Vec<usize>,
}

/// True for extensions that are supported or don't change shapes: a file may require them.
fn is_known(extension: &str) -> bool {
    let read = ["KHR_texture_transform", "KHR_mesh_quantization"];
    let no_shape = [
        "KHR_animation_pointer",
        "KHR_lights_punctual",
        "KHR_texture_basisu",
        "KHR_xmp",
        "KHR_xmp_json_ld",
        "EXT_lights_ies",
        "EXT_lights_image_based",
        "EXT_texture_avif",
        "EXT_texture_webp",
        "MSFT_texture_dds",
    ];
    extension.starts_with("KHR_materials_")
        || read.contains(&extension)
        || no_shape.contains(&extension)
}

/// The most extensions that are reported.
const MAX_NOTES: usize = 8;

/// Reads a `.gltf` or `.glb` file from its bytes.
pub(super) fn read(bytes: &[u8], path: &Path) -> Result<Mesh> {
    read_within(bytes, path, map::MAX_BYTES)
}

/// As [`read`], with a limit for the bytes of all buffers together.
fn read_within(bytes: &[u8], path: &Path, max_bytes: u64) -> Result<Mesh> {
    let fail = |problem| Error::file(path, problem);
    let (json, binary) =
        if bytes.starts_with(b"glTF") { data::chunks(bytes).map_err(fail)? } else { (bytes, None) };
    // A byte order mark: the specification forbids it, but editors write it.
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    check_encoding(json).map_err(fail)?;
    let not_json = |why| fail(format!("isn't glTF 2.0: {why}"));
    let head: Head = serde_json::from_slice(json).map_err(not_json)?;
    head.asset.check().map_err(fail)?;
    let document: Document = serde_json::from_slice(json).map_err(not_json)?;
    if let Some(extension) = document.extensions_required.iter().find(|name| !is_known(name)) {
        let problem = format!("needs the extension `{extension}`: export without it");
        return Err(fail(problem));
    }
    let buffers = Buffers::read(&document.buffers, binary, path, max_bytes)?;
    let data = Data::new(&document.accessors, &document.buffer_views, buffers);
    let mut mesh = File { document: &document, data }.mesh().map_err(fail)?;
    let unread = document.extensions_used.iter().filter(|name| !is_known(name));
    let unread = unread.map(|name| format!("the extension `{name}` is ignored"));
    mesh.notes.extend(unread.take(MAX_NOTES));
    Ok(mesh)
}

impl Asset {
    /// Accepts 2.0, and any later 2.x that doesn't require a newer reader.
    fn check(&self) -> Result<(), String> {
        let parsed = |value: &serde_json::Value| -> Option<[u32; 2]> {
            let (major, minor) = value.as_str()?.split_once('.')?;
            Some([major.parse().ok()?, minor.parse().ok()?])
        };
        let Some(version) = &self.version else {
            let problem =
                "has no `asset.version`, which every glTF file has: export it again as glTF 2.0";
            return Err(problem.to_owned());
        };
        if parsed(version).is_none_or(|[major, _]| major != 2) {
            return Err(format!(
                "its `asset.version` is {version}: only \"2.0\" is supported; export it as that"
            ));
        }
        match &self.min_version {
            Some(least) if parsed(least).is_none_or(|least| least > [2, 0]) => Err(format!(
                "needs a reader of glTF {least} (`asset.minVersion`), but this one supports \"2.0\": export it as that"
            )),
            Some(_) | None => Ok(()),
        }
    }
}

struct File<'a> {
    document: &'a Document,
    data: Data<'a>,
}

/// How the vertices of a mesh are transformed to the world.
enum Pose {
    /// All by one matrix.
    Rigid(DMat4),
    /// Each by the matrices of its joints.
    Skinned(Vec<DMat4>),
}

/// What determines vertices; primitives with the same source share them.
#[derive(PartialEq, Eq, Hash)]
struct VertexSource<'a> {
    attributes: &'a Attributes,
    targets: &'a [Attributes],
    /// The set of texture coordinates.
    uv_set: usize,
    /// The material whose texture transforms them, if any.
    transformed_by: Option<usize>,
}

impl File<'_> {
    fn mesh(&self) -> Result<Mesh, String> {
        let nodes = self.placed_nodes()?;
        let to_worlds: HashMap<usize, DMat4> = nodes.iter().copied().collect();
        let mut whole = Mesh { is_faceted: true, ..Mesh::default() };
        let mut passed_over = 0;
        for (i, to_world) in nodes {
            let node = &self.document.nodes[i];
            let Some(number) = node.mesh else { continue };
            let pose = match node.skin {
                None => Pose::Rigid(to_world),
                Some(skin) => self
                    .joints(get(&self.document.skins, "skin", skin)?, &to_worlds)
                    .map_err(|why| format!("skin {skin}: {why}"))?,
            };
            let mesh = get(&self.document.meshes, "mesh", number)?;
            let weights = node.weights.as_ref().or(mesh.weights.as_ref());
            // Vertices used by several of its primitives are stored once.
            let mut known = HashMap::new();
            for (j, primitive) in mesh.primitives.iter().enumerate() {
                let weights = weights.map_or(&[][..], Vec::as_slice);
                let fail = |why| format!("mesh {number}, primitive {j}: {why}");
                match primitive.topology().map_err(fail)? {
                    Some(topology) => self
                        .primitive(primitive, topology, weights, &pose, &mut known, &mut whole)
                        .map_err(fail)?,
                    None => passed_over += 1,
                }
            }
        }
        if whole.triangles.is_empty() && passed_over > 0 {
            return Err(format!(
                "has no triangles, only {passed_over} primitives of lines or points: export a surface"
            ));
        }
        if passed_over > 0 {
            whole.notes.push(format!("primitives of lines or points ignored: {passed_over}"));
        }
        Ok(whole)
    }

    /// All nodes of the scene with their matrices to the world, parents before children.
    fn placed_nodes(&self) -> Result<Vec<(usize, DMat4)>, String> {
        let document = self.document;
        let roots: Vec<usize> = if document.scenes.is_empty() {
            let children = document.nodes.iter().flat_map(|node| &node.children);
            let children: HashSet<&usize> = children.collect();
            (0..document.nodes.len()).filter(|i| !children.contains(i)).collect()
        } else {
            get(&document.scenes, "scene", document.scene.unwrap_or(0))?.nodes.clone()
        };
        let mut placed = Vec::new();
        let mut seen = vec![false; document.nodes.len()];
        let mut stack: Vec<_> = roots.into_iter().rev().map(|i| (i, DMat4::IDENTITY)).collect();
        while let Some((i, above)) = stack.pop() {
            let node = get(&document.nodes, "node", i)?;
            if std::mem::replace(&mut seen[i], true) {
                return Err(format!("node {i} has two parents"));
            }
            let own = transform(node).map_err(|why| format!("node {i}: {why}"))?;
            let to_world = above * own;
            placed.push((i, to_world));
            stack.extend(node.children.iter().rev().map(|child| (*child, to_world)));
        }
        Ok(placed)
    }

    /// The matrices of a skin's joints, from the mesh's own space. The node that shows the mesh
    /// doesn't transform it.
    fn joints(&self, skin: &Skin, to_worlds: &HashMap<usize, DMat4>) -> Result<Pose, String> {
        // Many nodes may show one skin.
        self.data.spend(skin.joints.len())?;
        let binds = match skin.inverse_bind_matrices {
            Some(accessor) => self.data.reals(accessor, 16)?,
            None => DMat4::IDENTITY.to_cols_array().repeat(skin.joints.len()),
        };
        if binds.len() < 16 * skin.joints.len() {
            return Err(format!(
                "{} joints but {} inverse bind matrices",
                skin.joints.len(),
                binds.len() / 16
            ));
        }
        let matrix = |(joint, bind): (&usize, &[f64])| {
            let to_world = to_worlds.get(joint);
            let to_world = to_world.ok_or_else(|| format!("joint {joint} isn't in the scene"))?;
            Ok(*to_world * DMat4::from_cols_slice(bind))
        };
        let matrices = skin.joints.iter().zip(binds.chunks_exact(16)).map(matrix);
        Ok(Pose::Skinned(matrices.collect::<Result<_, String>>()?))
    }

    fn primitive<'b>(
        &self,
        primitive: &'b Primitive,
        topology: Topology,
        weights: &[f64],
        pose: &Pose,
        known: &mut HashMap<VertexSource<'b>, (u32, Vec<bool>)>,
        mesh: &mut Mesh,
    ) -> Result<(), String> {
        let Primitive { attributes, targets, .. } = primitive;
        let draco = "KHR_draco_mesh_compression";
        if primitive.extensions.contains_key(draco)
            && attributes.values().any(|accessor| !self.data.has_view(*accessor))
        {
            return Err(format!("its data is compressed with `{draco}`: export without it"));
        }
        let (uv_set, transformed_by) = self.uv_set(primitive.material)?;
        let source = VertexSource { attributes, targets, uv_set, transformed_by };
        let (first, mirrored) = match known.entry(source) {
            Entry::Occupied(buffer) => &*buffer.into_mut(),
            Entry::Vacant(buffer) => {
                let first = cast::id_of(mesh.vertices.len());
                let mirrored = self.vertices(buffer.key(), weights, pose, &mut mesh.vertices)?;
                &*buffer.insert((first, mirrored))
            }
        };
        let (first, vertices) = (*first, mirrored.len());
        let corners: Vec<u32> = match primitive.indices {
            Some(accessor) => {
                let indices = self.data.wholes(accessor, 1)?;
                if let Some(index) = indices.iter().find(|index| **index >= vertices) {
                    return Err(format!(
                        "refers to vertex {index}, but there are {vertices} (they count from 0)"
                    ));
                }
                mesh.indices += cast::count_of(indices.len());
                indices.into_iter().map(|index| first + cast::id_of(index)).collect()
            }
            None => {
                self.data.spend(vertices)?;
                (0..cast::id_of(vertices)).map(|i| first + i).collect()
            }
        };
        let before = mesh.triangles.len();
        mesh.assemble(topology, &corners, None)?;
        for triangle in &mut mesh.triangles[before..] {
            let turned = |corner: &&u32| mirrored[cast::index_of_u32(**corner - first)];
            if triangle.iter().filter(turned).count() > 1 {
                triangle.swap(1, 2);
            }
        }
        Ok(())
    }

    /// The set of texture coordinates that a material's texture uses, and the material if it
    /// transforms them.
    fn uv_set(&self, material: Option<usize>) -> Result<(usize, Option<usize>), String> {
        let Some(number) = material else { return Ok((0, None)) };
        let material = get(&self.document.materials, "material", number)?;
        let Some(texture) = material.texture() else { return Ok((0, None)) };
        Ok(match &texture.extensions.transform {
            None => (texture.tex_coord, None),
            Some(transform) => (transform.tex_coord.unwrap_or(texture.tex_coord), Some(number)),
        })
    }

    /// Adds the vertices of attributes and morph targets; returns for each vertex whether its
    /// transform mirrors it.
    fn vertices(
        &self,
        source: &VertexSource,
        weights: &[f64],
        pose: &Pose,
        to: &mut Vec<MeshVertex>,
    ) -> Result<Vec<bool>, String> {
        let (targets, uv_name) = (source.targets, format!("TEXCOORD_{}", source.uv_set));
        // Without weights, morph targets have weight 0.
        if !weights.is_empty() && weights.len() != targets.len() {
            return Err(format!("{} morph targets but {} weights", targets.len(), weights.len()));
        }
        let attribute = |what: &str, name: &str, components: usize| {
            let Some(accessor) = source.attributes.get(name) else { return Ok(None) };
            let mut values = self.data.reals(*accessor, components)?;
            for (weight, target) in
                weights.iter().zip(targets).filter(|(weight, _)| **weight != 0.0)
            {
                let Some(accessor) = target.get(name) else { continue };
                let more = self.data.reals(*accessor, components)?;
                if more.len() != values.len() {
                    return Err(format!("{what} and those of a morph target differ in number"));
                }
                values.iter_mut().zip(more).for_each(|(value, more)| *value += weight * more);
            }
            Ok(Some(values))
        };
        let points = attribute("points", "POSITION", 3)?.ok_or("has no points (POSITION)")?;
        let normals = attribute("normals", "NORMAL", 3)?;
        let uvs = attribute("uv", &uv_name, 2)?;
        let vertices = points.len() / 3;
        let differ =
            |of: &Option<Vec<f64>>, n| of.as_ref().is_some_and(|of| of.len() / n != vertices);
        if differ(&normals, 3) || differ(&uvs, 2) {
            return Err("points, normals and uv differ in number".to_owned());
        }
        let bones = match pose {
            Pose::Rigid(_) => Vec::new(),
            Pose::Skinned(_) => self.bones(source.attributes, vertices)?,
        };
        let material = source.transformed_by.map(|i| &self.document.materials[i]);
        let texture = material.and_then(Material::texture);
        let transform = texture.and_then(|texture| texture.extensions.transform.as_ref());
        // Each node that shows a mesh has its own copy of the vertices.
        if to.len() + vertices > 3 * MAX_TRIANGLES {
            return Err(format!(
                "more than {} vertices, the most that a mesh may have: simplify it, or use it in fewer nodes",
                3 * MAX_TRIANGLES
            ));
        }
        to.reserve(vertices);
        let mut mirrored = Vec::with_capacity(vertices);
        for i in 0..vertices {
            let to_world = match pose {
                Pose::Rigid(to_world) => *to_world,
                Pose::Skinned(joints) => {
                    blended(joints, &bones, i).map_err(|why| format!("vertex {i} {why}"))?
                }
            };
            let DMat3 { x_axis: x, y_axis: y, z_axis: z } = DMat3::from_mat4(to_world);
            mirrored.push(x.dot(y.cross(z)) < 0.0);
            // The inverse transpose up to a positive factor; it also exists for a singular matrix.
            let side = if mirrored[i] { -1.0 } else { 1.0 };
            let normal_matrix = side * DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
            let given = DVec3::from_slice(&points[3 * i..]);
            let position = to_world.transform_point3(given);
            check_coordinates(
                &format!("vertex {i}"),
                &[given.to_array(), position.to_array()].concat(),
            )?;
            let normal = normals.as_ref().map(|normals| DVec3::from_slice(&normals[3 * i..]));
            let normal = normal.map_or(Ok(None), |given| {
                let what = format!("the normal of vertex {i}");
                let Some(given) = checked_normal(&what, given)? else { return Ok(None) };
                // Only its direction counts.
                checked_normal(&what, (normal_matrix * given.normalize()).normalize_or_zero())
            })?;
            let uv = uvs.as_ref().map(|uvs| {
                let uv = DVec2::from_slice(&uvs[2 * i..]);
                let uv = transform.map_or(uv, |transform| transform.apply(uv));
                DVec2::new(uv.x, 1.0 - uv.y)
            });
            if let Some(uv) = uv {
                check_coordinates(&format!("the uv of vertex {i}"), &uv.to_array())?;
            }
            to.push(MeshVertex { position, normal, uv });
        }
        Ok(mirrored)
    }

    /// Sets of four joints per vertex, and their weights.
    fn bones(&self, attributes: &Attributes, vertices: usize) -> Result<Vec<Bones>, String> {
        let mut sets = Vec::new();
        while let Some(joints) = attributes.get(&format!("JOINTS_{}", sets.len())) {
            let weights = format!("WEIGHTS_{}", sets.len());
            let weights = attributes.get(&weights).ok_or_else(|| format!("has no {weights}"))?;
            let bones = Bones {
                joints: self.data.wholes(*joints, 4)?,
                weights: self.data.reals(*weights, 4)?,
            };
            if bones.joints.len() != 4 * vertices || bones.weights.len() != 4 * vertices {
                return Err("points, joints and their weights differ in number".to_owned());
            }
            sets.push(bones);
        }
        if sets.is_empty() {
            return Err("has no joints (JOINTS_0), but its node has a skin".to_owned());
        }
        Ok(sets)
    }
}

/// Joints of vertices, four each.
struct Bones {
    joints: Vec<usize>,
    weights: Vec<f64>,
}

/// The weighted mean of the matrices of a vertex's joints.
fn blended(joints: &[DMat4], bones: &[Bones], vertex: usize) -> Result<DMat4, String> {
    let (mut sum, mut total) = (DMat4::ZERO, 0.0);
    for set in bones {
        let four = 4 * vertex..4 * vertex + 4;
        for (joint, weight) in set.joints[four.clone()].iter().zip(&set.weights[four]) {
            let matrix = get(joints, "joint", *joint)?;
            if !(0.0..=f64::MAX).contains(weight) {
                return Err(format!(
                    "has a joint with weight {weight}: legal are finite weights of 0 or more"
                ));
            }
            sum += *weight * *matrix;
            total += weight;
        }
    }
    if total > 0.0 {
        Ok(sum * total.recip())
    } else {
        Err("has no joint with a weight above 0".to_owned())
    }
}

impl Primitive {
    /// The topology of its corners; `None` for points (0) and lines (1 to 3).
    fn topology(&self) -> Result<Option<Topology>, String> {
        Ok(match self.mode {
            Some(0..=3) => None,
            None | Some(4) => Some(Topology::List),
            Some(5) => Some(Topology::Strip),
            Some(6) => Some(Topology::Fan),
            Some(mode) => {
                return Err(format!(
                    "its mode is {mode}: legal are 0 to 6, of which lists (4), strips (5) and fans (6) of triangles are supported"
                ));
            }
        })
    }
}

impl Material {
    /// The texture whose texture coordinates the surface uses.
    fn texture(&self) -> Option<&TextureInfo> {
        let color = &self.pbr_metallic_roughness.base_color_texture;
        let given = [
            &self.extensions.specular_glossiness.diffuse_texture,
            color,
            &self.normal_texture,
            &self.emissive_texture,
            &self.occlusion_texture,
        ];
        given.into_iter().find_map(Option::as_ref)
    }
}

fn transform(node: &Node) -> Result<DMat4, String> {
    if let Some(matrix) = node.matrix {
        if node.translation.is_some() || node.rotation.is_some() || node.scale.is_some() {
            let problem =
                "has both a `matrix` and `translation`, `rotation` or `scale`: remove one of them";
            return Err(problem.to_owned());
        }
        let matrix = DMat4::from_cols_array(&matrix);
        if !matrix.row(3).abs_diff_eq(DVec4::W, 1e-6) {
            let row = matrix.row(3);
            return Err(format!(
                "the last row of its `matrix` is {row}: legal is {}, without perspective",
                DVec4::W
            ));
        }
        return Ok(matrix);
    }
    let rotation = DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
    // Files hold unit quaternions to seven digits.
    let rotation =
        if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    Ok(DMat4::from_scale_rotation_translation(
        DVec3::from_array(node.scale.unwrap_or([1.0; 3])),
        rotation,
        DVec3::from_array(node.translation.unwrap_or([0.0; 3])),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn buffers_share_a_limit_and_each_uri_is_read_once() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.bin"), [0; 10]).unwrap();
        std::fs::write(folder.path().join("b.bin"), [0; 10]).unwrap();
        let read = |uris: &[&str], max_bytes| {
            let buffer = |uri: &&str| format!("{{\"uri\": \"{uri}\", \"byteLength\": 3}}");
            let buffers: Vec<String> = uris.iter().map(buffer).collect();
            let text = format!(
                "{{\"asset\": {{\"version\": \"2.0\"}}, \"buffers\": [{}]}}",
                buffers.join(", ")
            );
            let read = read_within(text.as_bytes(), &folder.path().join("x.gltf"), max_bytes);
            read.map(|mesh| mesh.triangles.len()).map_err(|why| why.to_string())
        };
        assert_eq!(read(&["a.bin"; 200], 10), Ok(0));
        assert_eq!(read(&["a.bin", "b.bin", "a.bin"], 20), Ok(0));
        assert_eq!(read(&["data:;base64,AAAA", "a.bin"], 13), Ok(0));
        for (uris, max_bytes) in [
            (["a.bin", "b.bin"], 19),
            (["a.bin", "./a.bin"], 19),
            (["a.bin", "a.bin"], 9),
            (["a.bin", "data:;base64,AAAA"], 12),
        ] {
            let why = read(&uris, max_bytes).unwrap_err();
            let expected = format!(
                "x.gltf: its buffers have more than {max_bytes} bytes together, the most that is supported: simplify it"
            );
            assert!(why.ends_with(&expected), "{why}");
        }
    }
}
