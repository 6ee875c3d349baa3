//! glTF files of one square, each written in another way that the format allows: all give one
//! picture. Files that the format doesn't allow, or that contradict themselves, are each refused
//! with the reason.

use crate::common;
use crate::scene::{base64, glb};
use fixpath::scene::{Fragments, Scene};
use serde_json::{Value, json};
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;
use std::fs;

/// Two triangles in the plane z = 0, with u and v (downwards, as in glTF) over a part of the
/// texture.
const POINTS: [f64; 12] = [-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0];
const NORMALS: [f64; 12] = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
const UVS: [f64; 8] = [0.0, 1.0, 0.75, 1.0, 0.75, 0.25, 0.0, 0.25];
const CORNERS: [f64; 6] = [0.0, 1.0, 2.0, 0.0, 2.0, 3.0];

const BYTE: u32 = 5120;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const FLOAT: u32 = 5126;

/// A file under construction: its document, and the buffer to which accessors are added.
struct File {
    document: Value,
    bytes: Vec<u8>,
}

fn push(list: &mut Value, value: Value) -> usize {
    let list = list.as_array_mut().unwrap();
    list.push(value);
    list.len() - 1
}

impl File {
    fn empty() -> Self {
        let document = json!({
            "asset": { "version": "2.0" },
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
            "nodes": [{ "mesh": 0 }],
            "meshes": [{ "primitives": [] }],
            "accessors": [],
            "bufferViews": [],
        });
        Self { document, bytes: Vec::new() }
    }

    /// The square, with all attributes as plain floats.
    fn square() -> Self {
        let mut file = Self::empty();
        file.primitive(&POINTS, &UVS);
        file
    }

    fn primitive(&mut self, points: &[f64], uvs: &[f64]) -> &mut Value {
        let points = self.accessor("VEC3", FLOAT, points);
        let normals = self.accessor("VEC3", FLOAT, &NORMALS);
        let uvs = self.accessor("VEC2", FLOAT, uvs);
        let corners = self.accessor("SCALAR", UNSIGNED_SHORT, &CORNERS);
        let attributes = json!({ "POSITION": points, "NORMAL": normals, "TEXCOORD_0": uvs });
        let primitives = &mut self.document["meshes"][0]["primitives"];
        let i = push(primitives, json!({ "attributes": attributes, "indices": corners }));
        &mut primitives[i]
    }

    fn view(&mut self, component: u32, values: &[f64]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let start = self.bytes.len();
        for value in values {
            match component {
                BYTE => self.bytes.extend_from_slice(&(*value as i8).to_le_bytes()),
                SHORT => self.bytes.extend_from_slice(&(*value as i16).to_le_bytes()),
                UNSIGNED_SHORT => self.bytes.extend_from_slice(&(*value as u16).to_le_bytes()),
                _ => self.bytes.extend_from_slice(&(*value as f32).to_le_bytes()),
            }
        }
        let len = self.bytes.len() - start;
        let view = json!({ "buffer": 0, "byteOffset": start, "byteLength": len });
        push(&mut self.document["bufferViews"], view)
    }

    fn accessor(&mut self, kind: &str, component: u32, values: &[f64]) -> usize {
        let view = self.view(component, values);
        let size = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let count = values.len() / size;
        let accessor =
            json!({ "bufferView": view, "componentType": component, "count": count, "type": kind });
        push(&mut self.document["accessors"], accessor)
    }

    /// As text, with its buffer under a URI.
    fn text(mut self, uri: impl Fn(&[u8]) -> String) -> Vec<u8> {
        let buffer = json!({ "byteLength": self.bytes.len(), "uri": uri(&self.bytes) });
        self.document["buffers"] = json!([buffer]);
        self.document.to_string().into_bytes()
    }

    fn gltf(self) -> Vec<u8> {
        self.text(|bytes| format!("data:application/octet-stream;base64,{}", base64(bytes)))
    }

    fn glb(mut self) -> Vec<u8> {
        self.document["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        glb(&self.document.to_string(), &self.bytes)
    }
}

fn scene(file: &[u8], extension: &str) -> Result<Scene, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("m").with_extension(extension), file).unwrap();
    let text = format!(
        "[image]\nwidth = 24\nheight = 24\n[camera]\neye = [0.5, -1, 4]\n[texture]\nsource = \"wood\"\nwidth = 64\nheight = 64\n[height]\nsource = \"brick\"\nwidth = 32\nheight = 32\n[[object]]\nshape = \"mesh\"\nfile = \"m.{extension}\""
    );
    Scene::parse(&text, &folder.path().join("s.toml"))
        .map_err(|why| why.to_string().replace(&format!("{}/", folder.path().display()), ""))
}

fn traced(file: &[u8], extension: &str) -> Fragments {
    common::traced(&scene(file, extension).unwrap())
}

fn extended(name: &str) -> File {
    let mut file = File::square();
    file.document["extensionsUsed"] = json!([name]);
    file.document["extensionsRequired"] = json!([name]);
    file
}

/// The square, whose texture coordinates undo the texture transform of its material.
fn transformed(transform: Value, texture: &str, uv_name: &str, uvs: &[f64]) -> File {
    let mut file = File::empty();
    let primitive = file.primitive(&POINTS, uvs);
    primitive["material"] = json!(0);
    let set = primitive["attributes"]["TEXCOORD_0"].take();
    primitive["attributes"].as_object_mut().unwrap().remove("TEXCOORD_0");
    primitive["attributes"][uv_name] = set;
    let info = json!({ "index": 0, "extensions": { "KHR_texture_transform": transform } });
    file.document["materials"] = match texture {
        "baseColorTexture" => json!([{ "pbrMetallicRoughness": { texture: info } }]),
        "diffuseTexture" => {
            let extension = "KHR_materials_pbrSpecularGlossiness";
            json!([{ "extensions": { extension: { texture: info } } }])
        }
        _ => json!([{ texture: info }]),
    };
    file.document["extensionsRequired"] = json!(["KHR_texture_transform"]);
    file
}

/// The square, placed by a skin of two joints. One is turned by a quarter turn about z, which its
/// bind matrix undoes.
fn skinned() -> File {
    let mut file = File::empty();
    file.primitive(&POINTS, &UVS);
    let joints = file.accessor("VEC4", UNSIGNED_SHORT, &[0.0, 1.0, 0.0, 0.0].repeat(4));
    let weights = file.accessor("VEC4", FLOAT, &[0.25, 0.75, 0.0, 0.0].repeat(4));
    let attributes = &mut file.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = json!(joints);
    attributes["WEIGHTS_0"] = json!(weights);
    let mut bind = [0.0; 32];
    for i in [0, 5, 10, 15, 26, 31] {
        bind[i] = 1.0;
    }
    // Columns of a quarter turn back, after a shift by (-2, 0, 0): (x, y) goes to (y, 2 - x).
    (bind[17], bind[20], bind[29]) = (-1.0, 1.0, 2.0);
    let binds = file.accessor("MAT4", FLOAT, &bind);
    let half = 0.5f64.sqrt();
    // The mesh's own node doesn't move it.
    // The two joints place the square at x = 3 and at x = -1; the weights give its original place.
    file.document["nodes"] = json!([
        { "mesh": 0, "skin": 0, "translation": [100, 0, 0] },
        { "children": [2], "translation": [3, 0, 0] },
        { "translation": [-2, 0, 0], "rotation": [0, 0, half, half] },
    ]);
    file.document["scenes"][0]["nodes"] = json!([0, 1]);
    file.document["skins"] = json!([{ "joints": [1, 2], "inverseBindMatrices": binds }]);
    file
}

/// The square, half by its own points and half by a morph target, which also corrects normals and
/// texture coordinates.
fn morphed() -> File {
    let mut file = File::empty();
    let base: Vec<f64> = POINTS.iter().map(|x| 0.5 * x).collect();
    file.primitive(&base, &UVS.map(|x| x - 1.0));
    let unused = file.accessor("VEC3", FLOAT, &[9.0; 12]);
    let more = file.accessor("VEC3", FLOAT, &POINTS.map(|x| 2.0 * x));
    let leaning = file.accessor("VEC3", FLOAT, &[1.0, 0.5, 1.0].repeat(4));
    let upright = file.accessor("VEC3", FLOAT, &[-4.0, -2.0, 0.0].repeat(4));
    let moved = file.accessor("VEC2", FLOAT, &[4.0; 8]);
    let mesh = &mut file.document["meshes"][0];
    mesh["primitives"][0]["attributes"]["NORMAL"] = json!(leaning);
    mesh["primitives"][0]["targets"] = json!([
        { "POSITION": unused, "NORMAL": unused },
        { "POSITION": more, "NORMAL": upright, "TEXCOORD_0": moved },
    ]);
    mesh["weights"] = json!([0.0, 0.25]);
    file
}

/// The square without normals, mirrored; its placement by a node or by the joint of a skin undoes
/// that.
fn mirrored(by_skin: bool) -> File {
    let mut file = File::empty();
    let points: Vec<f64> = POINTS.chunks(3).flat_map(|p| [-p[0], p[1], p[2]]).collect();
    let primitive = file.primitive(&points, &UVS);
    primitive["attributes"].as_object_mut().unwrap().remove("NORMAL");
    file.document["nodes"] = json!([{ "mesh": 0, "scale": [-1, 1, 1] }]);
    let corners = file.accessor("SCALAR", UNSIGNED_SHORT, &[0.0, 2.0, 1.0, 0.0, 3.0, 2.0]);
    file.document["meshes"][0]["primitives"][0]["indices"] = json!(corners);
    if by_skin {
        let joints = file.accessor("VEC4", UNSIGNED_SHORT, &[0.0; 16]);
        let weights = file.accessor("VEC4", FLOAT, &[1.0, 0.0, 0.0, 0.0].repeat(4));
        let attributes = &mut file.document["meshes"][0]["primitives"][0]["attributes"];
        (attributes["JOINTS_0"], attributes["WEIGHTS_0"]) = (json!(joints), json!(weights));
        file.document["nodes"] = json!([{ "mesh": 0, "skin": 0 }, { "scale": [-1, 1, 1] }]);
        file.document["scenes"][0]["nodes"] = json!([0, 1]);
        file.document["skins"] = json!([{ "joints": [1] }]);
    }
    file
}

/// Points, some of which come from a sparse accessor.
fn sparse(base: Option<&[f64]>) -> File {
    let mut file = File::square();
    let (indices, values): (Vec<f64>, Vec<f64>) = match base {
        Some(_) => (vec![1.0, 3.0], [&POINTS[3..6], &POINTS[9..12]].concat()),
        None => (vec![0.0, 1.0, 2.0, 3.0], POINTS.to_vec()),
    };
    let points = file.accessor("VEC3", FLOAT, base.unwrap_or(&POINTS));
    let indices_view = file.view(UNSIGNED_SHORT, &indices);
    let values_view = file.view(FLOAT, &values);
    let accessor = &mut file.document["accessors"][points];
    if base.is_none() {
        accessor.as_object_mut().unwrap().remove("bufferView");
    }
    accessor["sparse"] = json!({
        "count": indices.len(),
        "indices": { "bufferView": indices_view, "componentType": UNSIGNED_SHORT },
        "values": { "bufferView": values_view },
    });
    file.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(points);
    file
}

#[test]
fn one_square_in_many_ways() {
    let expected = traced(&File::square().gltf(), "gltf");
    assert!(expected.len() > 100);
    let text = |file: File| ("gltf", file.gltf());
    let mut cases: Vec<(&str, (&str, Vec<u8>))> = Vec::new();

    let percent =
        |bytes: &[u8]| bytes.iter().map(|byte| format!("%{byte:02x}")).collect::<String>();
    let raw =
        File::square().text(|bytes| format!("data:application/octet-stream,{}", percent(bytes)));
    cases.push(("percent", ("gltf", raw)));
    let escaped = |bytes: &[u8]| {
        let text = base64(bytes).replace('+', "%2B").replace('/', "%2F").replace('=', "%3D");
        format!("data:application/octet-stream;base64,{text}")
    };
    cases.push(("percent and base64", ("gltf", File::square().text(escaped))));
    cases.push(("container", ("glb", File::square().glb())));
    cases.push(("bytes after a container", ("glb", [&File::square().glb()[..], b"more"].concat())));
    cases.push((
        "byte order mark",
        ("gltf", [b"\xef\xbb\xbf", &File::square().gltf()[..]].concat()),
    ));

    let mut later = File::square();
    later.document["asset"] = json!({ "version": "2.7", "minVersion": "2.0" });
    cases.push(("a later version", text(later)));
    for name in [
        "KHR_materials_unlit",
        "KHR_materials_transmission",
        "KHR_lights_punctual",
        "KHR_texture_transform",
        "KHR_texture_basisu",
        "EXT_texture_webp",
    ] {
        cases.push((name, text(extended(name))));
    }

    let wrong = [5.0; 12];
    let mut base = POINTS;
    base[3..6].copy_from_slice(&wrong[..3]);
    base[9..12].copy_from_slice(&wrong[..3]);
    cases.push(("sparse", text(sparse(Some(&base)))));
    cases.push(("sparse over zeros", text(sparse(None))));

    let mut lines = File::square();
    for mode in 0..=3 {
        let line = json!({ "attributes": { "POSITION": 0 }, "mode": mode });
        push(&mut lines.document["meshes"][0]["primitives"], line);
    }
    cases.push(("lines and points", text(lines)));

    cases.push(("morph targets", text(morphed())));
    let mut by_node = morphed();
    by_node.document["meshes"][0]["weights"] = json!([1.0, 1.0]);
    by_node.document["nodes"][0]["weights"] = json!([0.0, 0.25]);
    cases.push(("morph targets by a node", text(by_node)));
    cases.push(("skin", text(skinned())));
    cases.push(("a node that mirrors", text(mirrored(false))));
    cases.push(("a joint that mirrors", text(mirrored(true))));
    let mut flat = File::square();
    flat.document["nodes"][0]["scale"] = json!([1, 1, 0]);
    cases.push(("a node that makes flat", text(flat)));
    let mut hidden = File::square();
    hidden.document["nodes"] = json!([{ "mesh": 0 }, { "mesh": 0, "scale": [0, 0, 0] }]);
    hidden.document["scenes"][0]["nodes"] = json!([0, 1]);
    cases.push(("a part that is hidden", text(hidden)));
    let capital = |bytes: &[u8]| format!("DATA:application/gltf-buffer;base64,{}", base64(bytes));
    cases.push(("capital letters", ("gltf", File::square().text(capital))));

    let halves: Vec<f64> = UVS.iter().map(|x| 2.0 * x - 0.5).collect();
    let transform = json!({ "scale": [0.5, 0.5], "offset": [0.25, 0.25] });
    cases.push((
        "texture transform",
        text(transformed(transform.clone(), "baseColorTexture", "TEXCOORD_0", &halves)),
    ));
    let mut other_set = transform;
    other_set["texCoord"] = json!(1);
    cases.push((
        "texture transform of a normal map and another set",
        text(transformed(other_set, "normalTexture", "TEXCOORD_1", &halves)),
    ));
    // The extension's own example: it shows the lower left quadrant of the image, rotated. The two
    // scales differ, so the order matters.
    let example = json!({ "offset": [0, 1], "rotation": FRAC_PI_2, "scale": [0.5, 0.25] });
    let turned: Vec<f64> =
        UVS.chunks(2).flat_map(|uv| [2.0 * (1.0 - uv[1]), 4.0 * uv[0]]).collect();
    for texture in ["baseColorTexture", "emissiveTexture", "diffuseTexture"] {
        let file = transformed(example.clone(), texture, "TEXCOORD_0", &turned);
        cases.push(("texture transform with a turn", text(file)));
    }

    let mut quantized = extended("KHR_mesh_quantization");
    let points = quantized.accessor("VEC3", SHORT, &POINTS.map(|x| 32767.0 * x));
    quantized.document["accessors"][points]["normalized"] = json!(true);
    // Padded to 4 bytes each, as alignment requires.
    let normals: Vec<f64> =
        NORMALS.chunks(3).flat_map(|n| [127.0 * n[0], 127.0 * n[1], 127.0 * n[2], 0.0]).collect();
    let normals_view = quantized.view(BYTE, &normals);
    quantized.document["bufferViews"][normals_view]["byteStride"] = json!(4);
    let normals = json!({ "bufferView": normals_view, "componentType": BYTE, "count": 4, "type": "VEC3", "normalized": true });
    let normals = push(&mut quantized.document["accessors"], normals);
    let attributes = &mut quantized.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["POSITION"] = json!(points);
    attributes["NORMAL"] = json!(normals);
    cases.push(("quantized", text(quantized)));

    for (name, (extension, file)) in cases {
        let found = traced(&file, extension);
        assert_eq!(found.pixel, expected.pixel, "{name}");
        assert_eq!(found.face, expected.face, "{name}");
        // Rounding may choose only at the border of a texel.
        let differ = (0..found.len()).filter(|i| found.texel[*i] != expected.texel[*i]).count();
        assert!(differ <= 2, "{name}: {differ}");
        for i in 0..found.len() {
            let [a, b] = [&found, &expected].map(|f| Fragments::vector(&f.normal, i));
            assert!((a - b).length() < 1e-7, "{name}: {a} {b}");
            let [a, b] = [&found, &expected].map(|f| Fragments::vector(&f.tangent, i));
            assert!((a - b).length() < 1e-6, "{name}: {a} {b}");
        }
    }
}

#[test]
fn vertices_are_shared_whatever_the_material() {
    let mut file = File::square();
    file.document["materials"] = json!([{}, { "normalTexture": { "index": 0 } }]);
    let primitive = file.document["meshes"][0]["primitives"][0].clone();
    for material in [0, 1] {
        let mut more = primitive.clone();
        more["material"] = json!(material);
        push(&mut file.document["meshes"][0]["primitives"], more);
    }
    let sharing = scene(&file.gltf(), "gltf").unwrap().assemble().unwrap().sharing();
    assert_eq!((sharing.vertices, sharing.primitives), (4, 6));
}

/// An extension that is used but not read may change a shape.
#[test]
fn extensions_that_are_not_read_are_told() {
    let mut file = File::square();
    let used = ["KHR_node_visibility", "KHR_texture_transform", "KHR_materials_unlit"];
    file.document["extensionsUsed"] = json!(used);
    let notes = scene(&file.gltf(), "gltf").unwrap().notes().to_vec();
    assert_eq!(notes.len(), 1, "{notes:?}");
    assert!(notes[0].ends_with("m.gltf: the extension `KHR_node_visibility` is ignored"));
}

#[test]
fn what_is_wrong_is_said() {
    let mut seen = String::new();
    let mut refused = |name: &str, file: &[u8]| {
        let extension = if file.starts_with(b"glTF") { "glb" } else { "gltf" };
        writeln!(seen, "{name}: {}", scene(file, extension).unwrap_err()).unwrap();
    };
    for (name, asset) in [
        ("none", json!(null)),
        ("empty", json!({})),
        ("old", json!({ "version": "1.0" })),
        ("number", json!({ "version": 2.0 })),
        ("new", json!({ "version": "2.1", "minVersion": "2.1" })),
        ("word", json!({ "version": "2.0", "minVersion": "two" })),
    ] {
        let mut file = File::square();
        if asset.is_null() {
            file.document.as_object_mut().unwrap().remove("asset");
        } else {
            file.document["asset"] = asset;
        }
        refused(name, &file.gltf());
    }
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"]
    {
        refused("extension", &extended(name).gltf());
    }
    let mut draco = File::square();
    let primitive = &mut draco.document["meshes"][0]["primitives"][0];
    primitive["extensions"] = json!({ "KHR_draco_mesh_compression": {} });
    draco.document["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    refused("compressed", &draco.gltf());

    let mut lines = File::square();
    lines.document["meshes"][0]["primitives"][0]["mode"] = json!(1);
    refused("lines", &lines.gltf());
    let mut mode = File::square();
    mode.document["meshes"][0]["primitives"][0]["mode"] = json!(7);
    refused("mode", &mode.gltf());
    let mut weights = morphed();
    weights.document["meshes"][0]["weights"] = json!([1.0]);
    refused("weights", &weights.gltf());
    let mut short = morphed();
    short.document["accessors"][5]["count"] = json!(3);
    refused("target", &short.gltf());
    let mut beyond = sparse(Some(&POINTS));
    beyond.document["accessors"][4]["count"] = json!(3);
    refused("sparse", &beyond.gltf());
    let mut joint = skinned();
    joint.document["skins"][0]["joints"] = json!([1]);
    refused("joint", &joint.gltf());
    let mut away = skinned();
    away.document["scenes"][0]["nodes"] = json!([0]);
    refused("skin", &away.gltf());
    let mut set = File::square();
    set.document["materials"] = json!([{ "normalTexture": { "index": 0, "texCoord": 3 } }]);
    set.document["meshes"][0]["primitives"][0]["material"] = json!(0);
    refused("set", &set.gltf());
    let mut matrix = File::square();
    matrix.document["nodes"][0]["matrix"] = json!(vec![1.0; 17]);
    refused("matrix", &matrix.gltf());
    let identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    let mut both = File::square();
    both.document["nodes"][0] = json!({ "mesh": 0, "matrix": identity, "scale": [1, 1, 1] });
    refused("matrix", &both.gltf());
    let mut perspective = File::square();
    let mut matrix = identity.map(f64::from);
    matrix[3] = 0.5;
    perspective.document["nodes"][0]["matrix"] = json!(matrix);
    refused("matrix", &perspective.gltf());
    // Indices must have an unsigned integer type.
    let mut joints = skinned();
    let wrong = joints.accessor("VEC4", BYTE, &[0.0, -1.0, 0.0, 0.0].repeat(4));
    joints.document["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = json!(wrong);
    refused("joints", &joints.gltf());
    let mut elements = sparse(Some(&POINTS));
    elements.document["accessors"][4]["sparse"]["indices"]["componentType"] = json!(FLOAT);
    refused("elements", &elements.gltf());
    let mut corners = File::square();
    let wrong = corners.accessor("SCALAR", SHORT, &CORNERS);
    corners.document["meshes"][0]["primitives"][0]["indices"] = json!(wrong);
    refused("corners", &corners.gltf());
    let mut normalized = File::square();
    normalized.document["accessors"][3]["normalized"] = json!(true);
    refused("corners", &normalized.gltf());
    let mut stride = File::square();
    stride.document["bufferViews"][0]["byteStride"] = json!(8);
    refused("stride", &stride.gltf());

    let whole = File::square().glb();
    refused("cut", &whole[..whole.len() - 1]);
    let mut chunk = whole.clone();
    chunk[12] ^= 0x80;
    refused("chunk", &chunk);
    let utf_16: Vec<u8> = "\u{feff}{}".encode_utf16().flat_map(u16::to_le_bytes).collect();
    refused("encoding", &utf_16);
    refused("raw", &File::square().text(|_| "data:no comma".to_owned()));
    expect_test::expect![[r#"
        none: s.toml, line 16: m.gltf: has no `asset.version`, which every glTF file has: export it again as glTF 2.0
        empty: s.toml, line 16: m.gltf: has no `asset.version`, which every glTF file has: export it again as glTF 2.0
        old: s.toml, line 16: m.gltf: its `asset.version` is "1.0": only "2.0" is supported; export it as that
        number: s.toml, line 16: m.gltf: its `asset.version` is 2.0: only "2.0" is supported; export it as that
        new: s.toml, line 16: m.gltf: needs a reader of glTF "2.1" (`asset.minVersion`), but this one supports "2.0": export it as that
        word: s.toml, line 16: m.gltf: needs a reader of glTF "two" (`asset.minVersion`), but this one supports "2.0": export it as that
        extension: s.toml, line 16: m.gltf: needs the extension `KHR_draco_mesh_compression`: export without it
        extension: s.toml, line 16: m.gltf: needs the extension `EXT_meshopt_compression`: export without it
        extension: s.toml, line 16: m.gltf: needs the extension `EXT_mesh_gpu_instancing`: export without it
        compressed: s.toml, line 16: m.gltf: mesh 0, primitive 0: its data is compressed with `KHR_draco_mesh_compression`: export without it
        lines: s.toml, line 16: m.gltf: has no triangles, only 1 primitives of lines or points: export a surface
        mode: s.toml, line 16: m.gltf: mesh 0, primitive 0: its mode is 7: legal are 0 to 6, of which lists (4), strips (5) and fans (6) of triangles are supported
        weights: s.toml, line 16: m.gltf: mesh 0, primitive 0: 2 morph targets but 1 weights
        target: s.toml, line 16: m.gltf: mesh 0, primitive 0: points and those of a morph target differ in number
        sparse: s.toml, line 16: m.gltf: mesh 0, primitive 0: accessor 4: refers to sparse element 3, but there are 3 (they count from 0)
        joint: s.toml, line 16: m.gltf: mesh 0, primitive 0: vertex 0 refers to joint 1, but there are 1 (they count from 0)
        skin: s.toml, line 16: m.gltf: skin 0: joint 1 isn't in the scene
        set: m.gltf: triangle 0 (they count from 0) has no texture coordinates, which [texture] needs: unwrap the mesh, or leave [texture] out
        matrix: s.toml, line 16: m.gltf: isn't glTF 2.0: trailing characters at line 1 column 156
        matrix: s.toml, line 16: m.gltf: node 0: has both a `matrix` and `translation`, `rotation` or `scale`: remove one of them
        matrix: s.toml, line 16: m.gltf: node 0: the last row of its `matrix` is [0.5, 0, 0, 1]: legal is [0, 0, 0, 1], without perspective
        joints: s.toml, line 16: m.gltf: mesh 0, primitive 0: accessor 7: indices have component type 5120: legal are 5121, 5123 and 5125, unsigned integers
        elements: s.toml, line 16: m.gltf: mesh 0, primitive 0: accessor 4: indices have component type 5126: legal are 5121, 5123 and 5125, unsigned integers
        corners: s.toml, line 16: m.gltf: mesh 0, primitive 0: accessor 4: indices have component type 5122: legal are 5121, 5123 and 5125, unsigned integers
        corners: s.toml, line 16: m.gltf: mesh 0, primitive 0: accessor 3: holds indices, which can't be normalized
        stride: s.toml, line 16: m.gltf: mesh 0, primitive 0: accessor 0: buffer view 0 has `byteStride` 8, less than the 12 bytes of its elements
        cut: s.toml, line 16: m.glb: its .glb container has 839 of 840 bytes: the file is truncated; export or copy it again
        chunk: s.toml, line 16: m.glb: the chunk at byte 572 of its .glb container has 2066513208 bytes and extends beyond the container's 840: the file is damaged
        encoding: s.toml, line 16: m.gltf: the text is UTF-16: save it as UTF-8
        raw: s.toml, line 16: m.gltf: buffer 0: its data URI can't be decoded: legal are `data:;base64,` with base64, and `data:,` with bytes as %00 to %ff
    "#]].assert_eq(&seen);
}

/// By the specification, meshes without normals are flat. They are smoothed if the scene asks for
/// it.
#[test]
fn a_mesh_without_normals_is_faceted() {
    let folder = tempfile::tempdir().unwrap();
    let mut file = File::empty();
    // Folded along its diagonal.
    let mut points = POINTS;
    points[5] = 0.5;
    let primitive = file.primitive(&points, &UVS);
    primitive["attributes"].as_object_mut().unwrap().remove("NORMAL");
    fs::write(folder.path().join("m.glb"), file.glb()).unwrap();
    let read = |crease: &str| {
        let text = format!(
            "[image]\nwidth = 24\nheight = 24\n[camera]\neye = [0, 0, 4]\nup = [0, 1, 0]\n[[object]]\nshape = \"mesh\"\nfile = \"m.glb\"\n{crease}"
        );
        let scene = Scene::parse(&text, &folder.path().join("s.toml")).unwrap();
        let fragments = common::traced(&scene);
        let normals = (0..fragments.len()).map(|i| [0, 1, 2].map(|k| fragments.normal[k][i]));
        let mut normals: Vec<[f64; 3]> = normals.collect();
        normals.sort_by(|a, b| a.partial_cmp(b).unwrap());
        normals.dedup();
        (normals, scene.notes()[0].rsplit_once("m.glb: ").unwrap().1.to_owned())
    };
    let (flat, told) = read("");
    // The corner (1, -1, 1/2) is raised: the facets have the slopes (1/4, -1/4) and none.
    let [tilted, up] = flat[..] else { panic!("{flat:?}") };
    assert_eq!(up, [0.0, 0.0, 1.0]);
    for (got, want) in tilted.iter().zip([-0.25, 0.25, 1.0]) {
        assert!((got - want / 1.125f64.sqrt()).abs() < 1e-12, "{tilted:?}");
    }
    let expected = "6 of 6 corners have no normal: the triangles' own are used, as glTF requires; for means up to edges of 60 degrees, set `crease_degrees` = 60 in its [[object]]";
    assert_eq!(told, expected);
    let (round, told) = read("crease_degrees = 60");
    assert!(round.len() > 50, "smoothed normals differ from point to point");
    assert!(told.contains("up to edges of `crease_degrees` = 60 (`tangent-faceted`"), "{told}");
}

/// Many primitives read one accessor of triangles without area: no triangle results, and the work
/// is limited.
#[test]
fn work_has_a_limit() {
    let mut file = File::square();
    let many = 1_500_000;
    let corners = file.accessor("SCALAR", UNSIGNED_SHORT, &vec![0.0; many]);
    let primitive = &mut file.document["meshes"][0]["primitives"][0];
    (primitive["indices"], primitive["mode"]) = (json!(corners), json!(5));
    let primitive = primitive.clone();
    for _ in 1..100 {
        push(&mut file.document["meshes"][0]["primitives"], primitive.clone());
    }
    assert_eq!(
        scene(&file.glb(), "glb").unwrap_err(),
        "s.toml, line 16: m.glb: mesh 0, primitive 22: accessor 4: its primitives read more than 33554432 numbers together (those of a shared accessor count each time), the most that is supported: simplify it"
    );
}

/// A file of few triangles but many vertices, shown by many objects.
#[test]
fn vertices_of_all_objects_have_a_limit() {
    let folder = tempfile::tempdir().unwrap();
    let mut file = File::square();
    let many = 50_000;
    for (name, kind, values) in [
        ("POSITION", "VEC3", POINTS.repeat(many)),
        ("NORMAL", "VEC3", NORMALS.repeat(many)),
        ("TEXCOORD_0", "VEC2", UVS.repeat(many)),
    ] {
        let accessor = file.accessor(kind, FLOAT, &values);
        file.document["meshes"][0]["primitives"][0]["attributes"][name] = json!(accessor);
    }
    fs::write(folder.path().join("m.glb"), file.glb()).unwrap();
    let read = |objects: usize| {
        let text = "[[object]]\nshape = \"mesh\"\nfile = \"m.glb\"\n".repeat(objects);
        Scene::parse(&text, &folder.path().join("s.toml"))
            .map(|_| ())
            .map_err(|why| why.to_string())
    };
    assert_eq!(read(2), Ok(()));
    let why = read(16).unwrap_err();
    let expected = "s.toml, line 46: more than 3000000 vertices in all objects together, the most that a scene may have: simplify the meshes or leave some out";
    assert!(why.ends_with(expected), "{why}");
}
