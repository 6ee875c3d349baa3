//! Meshes from glTF 2.0: as much as shapes need, every number checked before it is used.
//!
//! A reader of our own, since a file may name any offset, count and stride: each must lead to
//! a message and none to a panic. Materials, skins, animations and cameras are passed over.

use super::assembly::{Mesh, SharedVertex, Topology};
use super::map;
use super::mesh::{MAX_TRIANGLES, check_coordinates, check_normal, too_many};
use crate::cast;
use crate::error::{Error, Result};
use glam::{DMat3, DMat4, DQuat, DVec2, DVec3};
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::path::Path;

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
    accessors: Vec<Accessor>,
    #[serde(default)]
    buffer_views: Vec<View>,
    #[serde(default)]
    buffers: Vec<Buffer>,
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
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
struct MeshNode {
    primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
struct Primitive {
    attributes: Attributes,
    indices: Option<usize>,
    mode: Option<u32>,
}

#[derive(Deserialize)]
struct Attributes {
    #[serde(rename = "POSITION")]
    points: Option<usize>,
    #[serde(rename = "NORMAL")]
    normals: Option<usize>,
    #[serde(rename = "TEXCOORD_0")]
    uvs: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Accessor {
    buffer_view: Option<usize>,
    #[serde(default)]
    byte_offset: usize,
    component_type: u32,
    #[serde(default)]
    normalized: bool,
    count: usize,
    #[serde(rename = "type")]
    kind: String,
    sparse: Option<serde_json::Value>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct View {
    buffer: usize,
    #[serde(default)]
    byte_offset: usize,
    byte_length: usize,
    byte_stride: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Buffer {
    uri: Option<String>,
    byte_length: usize,
}

/// Reads a `.gltf` or `.glb` file of which these are the bytes.
pub(super) fn read(bytes: &[u8], path: &Path) -> Result<Mesh> {
    read_within(bytes, path, map::MAX_BYTES)
}

/// As [`read`], with so many bytes in all buffers together.
fn read_within(bytes: &[u8], path: &Path, max_bytes: u64) -> Result<Mesh> {
    let fail = |problem| Error::file(path, problem);
    let (json, binary) =
        if bytes.starts_with(b"glTF") { chunks(bytes).map_err(fail)? } else { (bytes, None) };
    let document: Document =
        serde_json::from_slice(json).map_err(|why| fail(format!("no glTF 2.0: {why}")))?;
    if let Some(extension) = document.extensions_required.first() {
        let problem = format!("needs the extension `{extension}`: export without it");
        return Err(fail(problem));
    }
    let mut data: Vec<Cow<[u8]>> = Vec::new();
    // Which of the data a buffer has: one URI may be that of many buffers, and is read once.
    let mut buffers = Vec::new();
    let mut known = HashMap::new();
    let mut left = max_bytes;
    for (i, buffer) in document.buffers.iter().enumerate() {
        let place = match buffer.uri.as_ref().and_then(|uri| known.get(uri)) {
            Some(place) => *place,
            None => {
                let bytes = match (&buffer.uri, binary) {
                    (Some(uri), _) if uri.starts_with("data:") => {
                        let bytes = base64(uri).ok_or_else(|| {
                            fail(format!("buffer {i}: its data URI is no base64"))
                        })?;
                        Some(Cow::Owned(bytes))
                    }
                    (Some(uri), _) => {
                        let folder = path.parent().unwrap_or(Path::new(""));
                        map::read_up_to(&folder.join(unescaped(uri)), left)?.map(Cow::Owned)
                    }
                    (None, Some(binary)) if i == 0 => Some(Cow::Borrowed(binary)),
                    (None, _) => return Err(fail(format!("buffer {i} has no data"))),
                };
                let fits = |bytes: &Cow<[u8]>| cast::count_of(bytes.len()) <= left;
                let bytes = bytes.filter(fits).ok_or_else(|| {
                    fail(format!(
                        "its buffers have more than {max_bytes} bytes together, the most that is read: simplify it"
                    ))
                })?;
                left -= cast::count_of(bytes.len());
                if let Some(uri) = &buffer.uri {
                    known.insert(uri, data.len());
                }
                data.push(bytes);
                data.len() - 1
            }
        };
        let (has, needs) = (data[place].len(), buffer.byte_length);
        if has < needs {
            return Err(fail(format!(
                "buffer {i} has {has} bytes of {needs}: the file is cut off"
            )));
        }
        buffers.push(place);
    }
    let buffers: Vec<&[u8]> = buffers.into_iter().map(|place| &*data[place]).collect();
    File { document: &document, buffers: &buffers }.mesh().map_err(fail)
}

/// JSON and binary chunk of a `.glb` file.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let cut = || "the file is cut off in a chunk of its .glb container".to_owned();
    let word = |at: usize| -> Result<u32, String> {
        let word = bytes.get(at..at + 4).and_then(|word| word.try_into().ok());
        word.map(u32::from_le_bytes).ok_or_else(cut)
    };
    if word(4)? != 2 {
        return Err(format!("is .glb of version {}: only 2 is read", word(4)?));
    }
    let (mut json, mut binary) = (None, None);
    let mut at = 12;
    while at < bytes.len() {
        let (len, kind) = (cast::index_of_u32(word(at)?), word(at + 4)?);
        let data = bytes.get(at + 8..at + 8 + len).ok_or_else(cut)?;
        match kind {
            0x4e4f_534a => json = json.or(Some(data)),
            0x004e_4942 => binary = binary.or(Some(data)),
            _ => {}
        }
        at += 8 + len;
    }
    Ok((json.ok_or("has no JSON chunk in its .glb container")?, binary))
}

struct File<'a> {
    document: &'a Document,
    buffers: &'a [&'a [u8]],
}

fn get<'a, T>(list: &'a [T], what: &str, index: usize) -> Result<&'a T, String> {
    let len = list.len();
    list.get(index).ok_or_else(|| format!("{what} {index} is named, and there are {len}"))
}

impl File<'_> {
    fn mesh(&self) -> Result<Mesh, String> {
        let document = self.document;
        let roots: Vec<usize> = if document.scenes.is_empty() {
            let children = document.nodes.iter().flat_map(|node| &node.children);
            let children: HashSet<&usize> = children.collect();
            (0..document.nodes.len()).filter(|i| !children.contains(i)).collect()
        } else {
            get(&document.scenes, "scene", document.scene.unwrap_or(0))?.nodes.clone()
        };
        let mut whole = Mesh::default();
        let mut seen = vec![false; document.nodes.len()];
        let mut stack: Vec<_> = roots.into_iter().rev().map(|i| (i, DMat4::IDENTITY)).collect();
        while let Some((i, above)) = stack.pop() {
            let node = get(&document.nodes, "node", i)?;
            if std::mem::replace(&mut seen[i], true) {
                return Err(format!("node {i} has two parents"));
            }
            let to_world = above * transform(node);
            if let Some(mesh) = node.mesh {
                // Vertices that several of its primitives name are there once.
                let mut known = HashMap::new();
                for (j, primitive) in
                    get(&document.meshes, "mesh", mesh)?.primitives.iter().enumerate()
                {
                    self.primitive(primitive, to_world, &mut known, &mut whole)
                        .map_err(|why| format!("mesh {mesh}, primitive {j}: {why}"))?;
                }
            }
            stack.extend(node.children.iter().rev().map(|child| (*child, to_world)));
        }
        Ok(whole)
    }

    fn primitive(
        &self,
        primitive: &Primitive,
        to_world: DMat4,
        known: &mut HashMap<[usize; 3], (u32, usize)>,
        mesh: &mut Mesh,
    ) -> Result<(), String> {
        let topology = match primitive.mode {
            None | Some(4) => Topology::List,
            Some(5) => Topology::Strip,
            Some(6) => Topology::Fan,
            Some(mode) => {
                return Err(format!(
                    "its mode is {mode}: only triangles are read, as lists (4), strips (5) and fans (6)"
                ));
            }
        };
        let Attributes { points, normals, uvs } = primitive.attributes;
        let without =
            |what: &str| format!("has no {what}: export with texture coordinates and normals");
        let points = points.ok_or_else(|| without("points (POSITION)"))?;
        let normals = normals.ok_or_else(|| without("normals (NORMAL)"))?;
        let uvs = uvs.ok_or_else(|| without("uv (TEXCOORD_0)"))?;
        let accessors = [points, normals, uvs];
        let (first, vertices) = match known.get(&accessors) {
            Some(buffer) => *buffer,
            None => {
                let first = cast::id_of(mesh.vertices.len());
                self.vertices(accessors, to_world, &mut mesh.vertices)?;
                let count = mesh.vertices.len() - cast::index_of_u32(first);
                known.insert(accessors, (first, count));
                (first, count)
            }
        };
        let corners: Vec<u32> = match primitive.indices {
            Some(accessor) => {
                let indices = self.indices(accessor)?;
                if let Some(index) = indices.iter().find(|index| **index >= vertices) {
                    return Err(format!("vertex {index} is named, and there are {vertices}"));
                }
                mesh.indices += cast::count_of(indices.len());
                indices.into_iter().map(|index| first + cast::id_of(index)).collect()
            }
            None => (0..cast::id_of(vertices)).map(|i| first + i).collect(),
        };
        mesh.assemble(topology, &corners)
    }

    /// Adds the vertices of accessors of points, normals and uv.
    fn vertices(
        &self,
        [points, normals, uvs]: [usize; 3],
        to_world: DMat4,
        to: &mut Vec<SharedVertex>,
    ) -> Result<(), String> {
        let points = self.floats(points, 3)?;
        let normals = self.floats(normals, 3)?;
        let uvs = self.floats(uvs, 2)?;
        let vertices = points.len() / 3;
        if normals.len() / 3 != vertices || uvs.len() / 2 != vertices {
            return Err("points, normals and uv differ in number".to_owned());
        }
        let linear = DMat3::from_mat4(to_world);
        let normal_matrix = linear.inverse().transpose();
        if !normal_matrix.is_finite() {
            return Err("the matrix of its node can't be inverted".to_owned());
        }
        // Each node that shows a mesh has vertices of its own.
        if to.len() + vertices > 3 * MAX_TRIANGLES {
            return Err(format!(
                "more than {} vertices, the most that a mesh may have: simplify it, or show it fewer times",
                3 * MAX_TRIANGLES
            ));
        }
        to.reserve(vertices);
        for i in 0..vertices {
            let given = DVec3::from_slice(&points[3 * i..]);
            let position = to_world.transform_point3(given);
            check_coordinates(
                &format!("vertex {i}"),
                &[given.to_array(), position.to_array()].concat(),
            )?;
            let what = format!("the normal of vertex {i}");
            let given = DVec3::from_slice(&normals[3 * i..]);
            check_normal(&what, given)?;
            // Only its direction counts.
            let normal = (normal_matrix * given.normalize()).normalize_or_zero();
            check_normal(&what, normal)?;
            let uv = DVec2::new(uvs[2 * i], 1.0 - uvs[2 * i + 1]);
            check_coordinates(&format!("the uv of vertex {i}"), &uv.to_array())?;
            to.push(SharedVertex { position, normal, uv });
        }
        Ok(())
    }

    fn floats(&self, index: usize, components: usize) -> Result<Vec<f64>, String> {
        let accessor = get(&self.document.accessors, "accessor", index)?;
        let unit = |value: f64, most: f64| {
            accessor.normalized.then_some(value / most).ok_or_else(|| {
                format!("accessor {index}: whole numbers that aren't normalized are no coordinates")
            })
        };
        self.components(index, components, |bytes| match *bytes {
            [a, b, c, d] if accessor.component_type == 5126 => {
                Ok(f64::from(f32::from_le_bytes([a, b, c, d])))
            }
            [a] if accessor.component_type == 5121 => unit(f64::from(a), 255.0),
            [a, b] if accessor.component_type == 5123 => {
                unit(f64::from(u16::from_le_bytes([a, b])), 65535.0)
            }
            _ => Err(format!(
                "accessor {index}: component type {} can't be read as coordinates: export as float",
                accessor.component_type
            )),
        })
    }

    fn indices(&self, index: usize) -> Result<Vec<usize>, String> {
        let accessor = get(&self.document.accessors, "accessor", index)?;
        let kind = accessor.component_type;
        if ![5121, 5123, 5125].contains(&kind) {
            return Err(format!(
                "accessor {index}: indices of component type {kind}: legal are 5121, 5123 and 5125, without sign"
            ));
        }
        self.components(index, 1, |bytes| match *bytes {
            [a] => Ok(usize::from(a)),
            [a, b] => Ok(usize::from(u16::from_le_bytes([a, b]))),
            [a, b, c, d] => Ok(cast::index_of_u32(u32::from_le_bytes([a, b, c, d]))),
            _ => Err(format!("accessor {index}: no indices")),
        })
    }

    /// Every component of an accessor, in order.
    fn components<T>(
        &self,
        index: usize,
        components: usize,
        decode: impl Fn(&[u8]) -> Result<T, String>,
    ) -> Result<Vec<T>, String> {
        let accessor = get(&self.document.accessors, "accessor", index)?;
        let fail = |problem: &str| format!("accessor {index}: {problem}");
        if accessor.sparse.is_some() {
            return Err(fail("sparse data isn't read: export without it"));
        }
        let kind = ["SCALAR", "VEC2", "VEC3"][components - 1];
        if accessor.kind != kind {
            return Err(fail(&format!("is {} where {kind} is needed", accessor.kind)));
        }
        let size = match accessor.component_type {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            5125 | 5126 => 4,
            other => return Err(fail(&format!("there is no component type {other}"))),
        };
        let view = accessor.buffer_view.ok_or_else(|| fail("has no buffer view"))?;
        let view = get(&self.document.buffer_views, "buffer view", view)?;
        let buffer = get(self.buffers, "buffer", view.buffer)?;
        let beyond = || fail("reaches beyond its buffer");
        let bytes = view.byte_offset.checked_add(view.byte_length);
        let bytes = bytes.and_then(|end| buffer.get(view.byte_offset..end)).ok_or_else(beyond)?;
        let stride = view.byte_stride.unwrap_or(size * components);
        // So that the count below can't ask for more memory than the file has bytes.
        if stride < size * components || accessor.count > bytes.len() {
            return Err(beyond());
        }
        if accessor.count > 3 * MAX_TRIANGLES {
            return Err(too_many());
        }
        let mut values = Vec::with_capacity(accessor.count * components);
        for i in 0..accessor.count {
            let start = i.checked_mul(stride).and_then(|at| at.checked_add(accessor.byte_offset));
            let element =
                start.and_then(|start| bytes.get(start..start.checked_add(size * components)?));
            for component in element.ok_or_else(beyond)?.chunks_exact(size) {
                values.push(decode(component)?);
            }
        }
        Ok(values)
    }
}

fn transform(node: &Node) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix);
    }
    let rotation = DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
    // Files hold unit quaternions to seven digits.
    let rotation =
        if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(
        DVec3::from_array(node.scale.unwrap_or([1.0; 3])),
        rotation,
        DVec3::from_array(node.translation.unwrap_or([0.0; 3])),
    )
}

/// The bytes of a base64 data URI.
fn base64(uri: &str) -> Option<Vec<u8>> {
    let text = uri.split_once(";base64,")?.1.trim_end_matches('=');
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 2);
    let (mut bits, mut count) = (0u32, 0);
    for c in text.bytes() {
        let six = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        bits = bits << 6 & 0xffff | u32::from(six);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push(u8::try_from(bits >> count & 0xff).ok()?);
        }
    }
    Some(bytes)
}

/// A relative URI with its `%20` and the like replaced.
fn unescaped(uri: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let code = after.get(..2).and_then(|hex| std::str::from_utf8(hex).ok());
        match code.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            Some(byte) if *first == b'%' => {
                bytes.push(byte);
                rest = &after[2..];
            }
            _ => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
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
            let text = format!("{{\"buffers\": [{}]}}", buffers.join(", "));
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
                "x.gltf: its buffers have more than {max_bytes} bytes together, the most that is read: simplify it"
            );
            assert!(why.ends_with(&expected), "{why}");
        }
    }

    #[test]
    fn base64_and_escapes() {
        let decoded = |text: &str| base64(&format!("data:application/octet-stream;base64,{text}"));
        assert_eq!(decoded("").unwrap(), b"");
        assert_eq!(decoded("TQ==").unwrap(), b"M");
        assert_eq!(decoded("TWE=").unwrap(), b"Ma");
        assert_eq!(decoded("TWFuAP/+").unwrap(), b"Man\x00\xff\xfe");
        assert!(decoded("TW!u").is_none() && base64("data:,x").is_none());
        assert_eq!(unescaped("a%20b%2"), "a b%2");
        assert_eq!(unescaped("%"), "%");
    }
}
