//! Scenes against independently derived conventions, and all the ways in which their files can be
//! wrong.

use crate::common::traced;
use expect_test::expect;
use fixpath::scene::{BUILTIN, CURVED, Fragments, Light, Place, Scene, halfway};
use glam::{DMat3, DVec2, DVec3};
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

fn parse(text: &str) -> Scene {
    Scene::parse(text, Path::new("scene.toml")).unwrap()
}

fn normal(f: &Fragments, i: usize) -> DVec3 {
    Fragments::vector(&f.normal, i)
}

fn tangent(f: &Fragments, i: usize) -> DVec3 {
    Fragments::vector(&f.tangent, i)
}

#[test]
fn builtin_scenes_are_whole() {
    for (name, _) in BUILTIN {
        let scene = Scene::builtin(name).unwrap();
        let f = traced(&scene);
        let pixels = scene.image.width * scene.image.height;
        assert!(f.len() > pixels as usize / 3, "{name}: {}", f.len());
        assert!(f.pixel.is_sorted_by(|a, b| a < b) && *f.pixel.last().unwrap() < pixels);
        let facts = scene.facts();
        assert!(facts.specular && !facts.flat_bumps);
        assert_eq!(facts.right_handed, *name != "mirrored");
        let mut faces = HashMap::new();
        for i in 0..f.len() {
            let (n, t, v) = (normal(&f, i), tangent(&f, i), Fragments::vector(&f.eye, i));
            for unit in [n, t, v] {
                assert!((unit.length() - 1.0).abs() < 1e-12, "{name} {i} {unit}");
            }
            assert!(n.dot(t).abs() < 1e-12 && n.dot(v) > 0.0, "{name} {i}");
            assert_eq!(f.face[i] == CURVED, ["sphere", "light-orbit", "mirrored"].contains(name));
            // Equal to the last bit, so that a datapath may keep them per face.
            let of_face = faces.entry(f.face[i]).or_insert((n, t));
            assert!(f.face[i] == CURVED || (n, t) == *of_face);
            assert!(f.bump[i] < scene.bumps.len());
            assert!((f.texel[i] as usize) < scene.texture.texels().len());
        }
    }
    assert_eq!(
        Scene::builtin("teapot").unwrap_err().to_string(),
        "no built-in scene `teapot`: there are plane, cube, sphere, lettering-raised, lettering-lowered, brick, light-orbit, mirrored; or give the path of a scene file"
    );
    let sphere = Scene::builtin("sphere").unwrap();
    assert_eq!(sphere.bumps.size(), (512, 256));
    assert_eq!((sphere.image.width, sphere.image.height), (512, 512));
}

#[test]
fn rows_are_independent_and_memory_is_reused() {
    let scene = parse("[image]\nwidth = 40\nheight = 30\n[[object]]\nshape = \"cube\"");
    let whole = traced(&scene);
    let (mut pixels, mut z) = (Vec::new(), Vec::new());
    let mut part = Fragments::default();
    scene.trace(0..30, &mut part);
    let room = part.pixel.capacity();
    for rows in [0..7, 7..8, 8..30, 30..99] {
        scene.trace(rows, &mut part);
        pixels.extend_from_slice(&part.pixel);
        z.extend_from_slice(&part.position[2]);
    }
    assert_eq!((pixels, z), (whole.pixel, whole.position[2].clone()));
    assert_eq!(part.pixel.capacity(), room);
    fn shared<T: Sync>(_: &T) {}
    shared(&scene);
}

/// A point of a shape from (u, v) before placement, and the inverse; faces are numbered as in the
/// docs.
fn surface(shape: &str, face: u32, uv: DVec2) -> DVec3 {
    let (a, b) = (2.0 * uv.x - 1.0, 2.0 * uv.y - 1.0);
    match (shape, face) {
        ("sphere", _) => {
            let (theta, az) = (PI * (1.0 - uv.y), TAU * uv.x);
            DVec3::new(theta.sin() * az.cos(), theta.sin() * az.sin(), theta.cos())
        }
        ("plane", _) => DVec3::new(a, b, 0.0),
        (_, 0) => DVec3::new(1.0, a, b),
        (_, 1) => DVec3::new(-1.0, -a, b),
        (_, 2) => DVec3::new(-a, 1.0, b),
        (_, 3) => DVec3::new(a, -1.0, b),
        (_, 4) => DVec3::new(a, b, 1.0),
        (_, _) => DVec3::new(a, -b, -1.0),
    }
}

fn uv_of(shape: &str, face: u32, p: DVec3) -> DVec2 {
    let half = |a: f64, b: f64| DVec2::new((a + 1.0) / 2.0, (b + 1.0) / 2.0);
    match (shape, face) {
        ("sphere", _) => DVec2::new(
            (p.y.atan2(p.x) / TAU).rem_euclid(1.0),
            1.0 - p.z.clamp(-1.0, 1.0).acos() / PI,
        ),
        ("plane", _) => half(p.x, p.y),
        (_, 0) => half(p.y, p.z),
        (_, 1) => half(-p.y, p.z),
        (_, 2) => half(-p.x, p.z),
        (_, 3) => half(p.x, p.z),
        (_, 4) => half(p.x, p.y),
        (_, _) => half(p.x, -p.y),
    }
}

/// Rays, frames and texels of placed shapes, derived from the text of the module's documentation.
#[test]
fn conventions_from_finite_differences() {
    let cameras = [
        "eye = [3.0, -4.0, 3.0]\nfov_degrees = 50.0",
        "eye = [-4.0, 2.0, -3.0]\nprojection = \"orthographic\"\nheight = 5.0\nup = [0.3, 1.0, 0.0]",
    ];
    let placements = [
        (DVec3::ZERO, [0.0, 0.0, 0.0], DVec3::ONE),
        (DVec3::new(0.2, -0.1, 0.3), [20.0, -35.0, 50.0], DVec3::new(1.0, 0.6, 1.3)),
        (DVec3::new(-0.2, 0.1, 0.0), [200.0, 10.0, -80.0], DVec3::new(-1.1, 0.9, 0.8)),
    ];
    for camera in cameras {
        for (translate, rotate, scale) in placements {
            for shape in ["plane", "cube", "sphere"] {
                let text = format!(
                    "[image]\nwidth = 33\nheight = 24\n[camera]\n{camera}\n[texture]\nwidth = 64\nheight = 32\n[height]\nwidth = 16\nheight = 8\n\
                     [[object]]\nshape = \"{shape}\"\ntranslate = {:?}\nrotate_degrees = {rotate:?}\nscale = {:?}",
                    translate.to_array(),
                    scale.to_array()
                );
                let scene = parse(&text);
                let f = traced(&scene);
                let [x, y, z] = rotate.map(f64::to_radians);
                let linear = DMat3::from_rotation_z(z)
                    * DMat3::from_rotation_y(y)
                    * DMat3::from_rotation_x(x)
                    * DMat3::from_diagonal(scale);
                if shape != "plane" {
                    assert!(f.len() > 40, "{text}");
                }
                for i in 0..f.len() {
                    let position = Fragments::vector(&f.position, i);
                    let local = linear.inverse() * (position - translate);
                    let uv = uv_of(shape, f.face[i], local);
                    let place = |uv| linear * surface(shape, f.face[i], uv) + translate;
                    assert!((place(uv) - position).length() < 1e-9, "{shape} {i}");
                    let step = 1e-6;
                    let along =
                        |d: DVec2| (place(uv + d * step) - place(uv - d * step)) / (2.0 * step);
                    let (dpdu, dpdv) = (along(DVec2::X), along(DVec2::Y));
                    // Outward, like the shape's own normal; a mirrored scale turns it inside out.
                    let mirrored = linear.determinant() < 0.0;
                    let h = if mirrored { -1.0 } else { 1.0 };
                    let n = h * dpdu.cross(dpdv).normalize();
                    assert!((normal(&f, i) - n).length() < 1e-7, "{shape} {i} {n}");
                    let t = (dpdu - n * n.dot(dpdu)).normalize();
                    assert!((tangent(&f, i) - t).length() < 1e-6, "{shape} {i} {t}");
                    assert_eq!(f.handedness[i], h);
                    assert!(f.bitangent(i).dot(dpdv) > 0.0);
                    let texel = |w: f64, h: f64| {
                        let (x, y) = (uv.x * w, (1.0 - uv.y) * h);
                        let safe = [x, y].iter().all(|x| (x - x.round()).abs() > 1e-6);
                        safe.then(|| (y.floor() * w + x.floor()) as u32)
                    };
                    assert!(texel(64.0, 32.0).is_none_or(|texel| texel == f.texel[i]));
                    assert!(texel(16.0, 8.0).is_none_or(|texel| texel == f.bump[i]));

                    // The pixel's ray passes through the point, and starts at the eye.
                    let (px, py) = (f.pixel[i] % 33, f.pixel[i] / 33);
                    let a = (2.0 * (f64::from(px) + 0.5) / 33.0 - 1.0) * 33.0 / 24.0;
                    let b = 1.0 - 2.0 * (f64::from(py) + 0.5) / 24.0;
                    let eye = scene.camera.eye;
                    let forward = -eye.normalize();
                    let right = forward.cross(scene.camera.up).normalize();
                    let top = right.cross(forward);
                    let v = if camera.contains("fov") {
                        let ray = forward + 25f64.to_radians().tan() * (a * right + b * top);
                        assert!((position - eye).cross(ray).length() < 1e-9);
                        (eye - position).normalize()
                    } else {
                        let from = eye + 2.5 * (a * right + b * top);
                        assert!((position - from).cross(forward).length() < 1e-9);
                        -forward
                    };
                    assert!((Fragments::vector(&f.eye, i) - v).length() < 1e-12);
                }
            }
        }
    }
}

#[test]
fn a_pole_has_the_frame_of_azimuth_0() {
    for (side, row) in [("1.0", 0), ("-1.0", 0)] {
        let scene = parse(&format!(
            "[image]\nwidth = 5\nheight = 5\n[camera]\neye = [0, 0, {side}]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nprojection = \"orthographic\"\nheight = 0.5\n\
             [texture]\nwidth = 8\nheight = 4\n[[object]]\nshape = \"sphere\"\nscale = 0.5"
        ));
        let f = traced(&scene);
        assert_eq!(f.len(), 25);
        let pole: f64 = side.parse().unwrap();
        assert_eq!((normal(&f, 12), tangent(&f, 12)), (DVec3::new(0.0, 0.0, pole), DVec3::Y));
        // The lower edge of the map wraps to its upper one.
        assert_eq!(f.texel[12], 8 * row);
    }
}

#[test]
fn lights_and_halfway_vectors() {
    let lamp = Light { place: Place::Position(DVec3::new(0.0, 0.0, 3.0)), intensity: 1.0 };
    let l = lamp.towards(DVec3::new(0.0, 4.0, 0.0), DVec3::X);
    assert!((l - DVec3::new(0.0, -0.8, 0.6)).length() < 1e-15);
    assert_eq!(lamp.towards(DVec3::new(0.0, 0.0, 3.0), DVec3::X), DVec3::X);
    assert_eq!(halfway(DVec3::X, DVec3::X, DVec3::Z), DVec3::X);
    assert_eq!(halfway(DVec3::X, DVec3::NEG_X, DVec3::Z), DVec3::NEG_Z);
    let scene = parse("[[light]]\ndirection = [0, 0, 9]\n[[object]]\nshape = \"sphere\"");
    assert_eq!(scene.lights[0].place, Place::Direction(DVec3::Z));
    let f = traced(&scene);
    assert!(!f.is_empty());
    for i in 0..f.len() {
        let l = scene.lights[0].towards(Fragments::vector(&f.position, i), normal(&f, i));
        assert_eq!(l, DVec3::Z);
        let eye = Fragments::vector(&f.eye, i);
        let half = (eye + DVec3::Z).normalize();
        assert!((halfway(l, eye, normal(&f, i)) - half).length() < 1e-15);
    }
}

#[test]
fn a_shape_alone_is_a_scene_and_materials_inherit() {
    let scene = parse(
        "[material]\nspecular = 0\nexponent = 7\n[[object]]\nshape = \"sphere\"\n\
         [[object]]\nshape = \"plane\"\nmaterial = { diffuse = 0.25 }",
    );
    assert_eq!(scene.materials[0].exponent, 7);
    assert_eq!((scene.materials[1].exponent, scene.materials[1].diffuse), (7, 0.25));
    let facts = scene.facts();
    assert!(!facts.specular && facts.flat_bumps);
    assert_eq!((scene.texture.size(), scene.bumps.size()), ((1, 1), (1, 1)));
    let f = traced(&scene);
    assert!(f.texel.iter().chain(&f.bump).all(|texel| *texel == 0));
    assert_eq!(scene.bumps.vector(0), DVec3::Z);
    let both = f.object.contains(&0) && f.object.contains(&1);
    assert!(both, "the sphere stands out of the plane");

    let dark = parse("[[light]]\nintensity = 0\n[[object]]\nshape = \"plane\"").facts();
    assert!(!dark.specular);
    let faraway = parse("[camera]\ntarget = [9, -9, 3]\n[[object]]\nshape = \"sphere\"");
    assert!(traced(&faraway).is_empty());
}

/// Eight points, 24 corners of a cube with its frames: point, normal, uv per corner, 12 triangles.
fn cube_corners() -> Vec<(DVec3, DVec3, DVec2)> {
    let mut corners = Vec::new();
    for face in 0..6 {
        let at = |u: f64, v: f64| surface("cube", face, DVec2::new(u, v));
        let n = (at(0.0, 0.0) + at(1.0, 1.0)) / 2.0;
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            corners.push((at(u, v), n, DVec2::new(u, v)));
        }
    }
    corners
}

fn cube_obj() -> String {
    let mut text = String::from("# a cube\nmtllib none.mtl\no cube\n");
    for (p, n, uv) in cube_corners() {
        writeln!(
            text,
            "v {} {} {}\nvn {} {} {}\nvt {} {}",
            p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y
        )
        .unwrap();
    }
    for i in 0..12 {
        let (a, b, c) = (3 * i + 1, 3 * i + 2, 3 * i + 3);
        // Indices counted from the start, and from the end.
        if i % 2 == 0 {
            writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}").unwrap();
        } else {
            let (a, b, c) = (a - 37, b - 37, c - 37);
            writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}").unwrap();
        }
    }
    text
}

/// A glTF document of the cube and its buffer; `uri` goes into the document.
fn cube_gltf(uri: &str) -> (String, Vec<u8>) {
    let corners = cube_corners();
    let mut bytes = Vec::new();
    let mut put = |values: &[f64]| {
        values.iter().for_each(|x| bytes.extend_from_slice(&(*x as f32).to_le_bytes()));
    };
    corners.iter().for_each(|(p, ..)| put(&p.to_array()));
    corners.iter().for_each(|(_, n, _)| put(&n.to_array()));
    corners.iter().for_each(|(.., uv)| put(&[uv.x, 1.0 - uv.y]));
    (0..36u16).for_each(|i| bytes.extend_from_slice(&i.to_le_bytes()));
    // Scaled to the same size by its node, from a buffer of half the size.
    let document = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
"nodes": [{{"children": [1], "translation": [0, 0, 0]}}, {{"mesh": 0, "rotation": [0, 0, 0, 1]}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}, "indices": 3}}]}}],
"accessors": [
{{"bufferView": 0, "componentType": 5126, "count": 36, "type": "VEC3"}},
{{"bufferView": 0, "byteOffset": 432, "componentType": 5126, "count": 36, "type": "VEC3"}},
{{"bufferView": 1, "componentType": 5126, "count": 36, "type": "VEC2"}},
{{"bufferView": 2, "componentType": 5123, "count": 36, "type": "SCALAR"}}],
"bufferViews": [{{"buffer": 0, "byteLength": 864}}, {{"buffer": 0, "byteOffset": 864, "byteLength": 288}},
{{"buffer": 0, "byteOffset": 1152, "byteLength": 72}}],
"buffers": [{{{uri}"byteLength": 1224}}]}}"#
    );
    (document, bytes)
}

pub(crate) fn glb(document: &str, binary: &[u8]) -> Vec<u8> {
    let mut json = document.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend_from_slice(&((12 + 8 + json.len() + 8 + binary.len()) as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &json[..]), (b"BIN\0", binary)] {
        bytes.extend_from_slice(&(chunk.len() as u32).to_le_bytes());
        bytes.extend_from_slice(kind);
        bytes.extend_from_slice(chunk);
    }
    bytes
}

pub(crate) fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digits = bytes.chunks(3).flat_map(|three| {
        let word = three
            .iter()
            .chain([&0, &0])
            .take(3)
            .fold(0u32, |word, byte| word << 8 | u32::from(*byte));
        (0..4).map(move |i| DIGITS[(word >> (18 - 6 * i) & 63) as usize] as char)
    });
    digits.collect()
}

#[test]
fn one_cube_in_every_format_is_the_cube() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).unwrap();
    write("cube.obj", cube_obj().as_bytes());
    let (document, binary) = cube_gltf("\"uri\": \"the%20cube.bin\", ");
    write("cube.gltf", document.as_bytes());
    write("the cube.bin", &binary);
    write("cube.glb", &glb(&cube_gltf("").0, &binary));
    let data = format!("\"uri\": \"data:application/octet-stream;base64,{}\", ", base64(&binary));
    write("data.gltf", cube_gltf(&data).0.as_bytes());

    let scene = |object: &str| {
        let text = format!(
            "[image]\nwidth = 64\nheight = 48\n[texture]\nwidth = 7\nheight = 5\n[height]\nsource = \"brick\"\n[[object]]\n{object}\nrotate_degrees = [10, 20, 30]"
        );
        Scene::parse(&text, &folder.path().join("scene.toml")).unwrap()
    };
    let expected = traced(&scene("shape = \"cube\""));
    // Without normals, and with normals of length 0: the cube's edges are sharp enough to get those
    // of its faces.
    let bare = cube_gltf("").0.replace("\"NORMAL\": 1, ", "");
    write("bare.glb", &glb(&bare, &binary));
    let mut zeros = binary.clone();
    zeros[432..864].fill(0);
    write("zeros.glb", &glb(&cube_gltf("").0, &zeros));
    for name in ["cube.obj", "cube.gltf", "cube.glb", "data.gltf", "bare.glb", "zeros.glb"] {
        let scene = scene(&format!("shape = \"mesh\"\nfile = \"{name}\""));
        assert!(scene.facts().right_handed);
        let f = traced(&scene);
        assert!(!f.face.contains(&CURVED));
        assert_eq!(f.pixel, expected.pixel, "{name}");
        for i in 0..f.len() {
            assert_eq!(f.face[i] / 2, expected.face[i], "two triangles to the face");
            for (a, b) in [
                (&f.position, &expected.position),
                (&f.normal, &expected.normal),
                (&f.tangent, &expected.tangent),
            ] {
                assert!((Fragments::vector(a, i) - Fragments::vector(b, i)).length() < 1e-12);
            }
        }
        let differ = (0..f.len()).filter(|i| f.texel[*i] != expected.texel[*i]).count();
        assert!(differ <= 2, "{name}: rounding may choose only on the border of a texel");
    }
}

/// A glTF file of vertices (point, normal, uv with v up), drawn as modes with indices.
pub(crate) fn gltf_of(
    vertices: &[(DVec3, DVec3, DVec2)],
    draws: &[(u32, Option<&[u16]>)],
) -> String {
    let mut bytes = Vec::new();
    let mut put = |values: &[f64]| {
        values.iter().for_each(|x| bytes.extend_from_slice(&(*x as f32).to_le_bytes()));
    };
    vertices.iter().for_each(|(p, ..)| put(&p.to_array()));
    vertices.iter().for_each(|(_, n, _)| put(&n.to_array()));
    vertices.iter().for_each(|(.., uv)| put(&[uv.x, 1.0 - uv.y]));
    let count = vertices.len();
    let accessor = |view: usize, component: u32, count: usize, kind: &str| {
        format!(
            "{{\"bufferView\": {view}, \"componentType\": {component}, \"count\": {count}, \"type\": \"{kind}\"}}"
        )
    };
    let view = |at: usize, len: usize| {
        format!("{{\"buffer\": 0, \"byteOffset\": {at}, \"byteLength\": {len}}}")
    };
    let mut accessors: Vec<String> = [(0, "VEC3"), (1, "VEC3"), (2, "VEC2")]
        .map(|(at, kind)| accessor(at, 5126, count, kind))
        .into();
    let mut views =
        vec![view(0, 12 * count), view(12 * count, 12 * count), view(24 * count, 8 * count)];
    let mut primitives = Vec::new();
    for (mode, indices) in draws {
        let mut more = String::new();
        if let Some(indices) = indices {
            more = format!(", \"indices\": {}", accessors.len());
            accessors.push(accessor(views.len(), 5123, indices.len(), "SCALAR"));
            views.push(view(bytes.len(), 2 * indices.len()));
            indices.iter().for_each(|i| bytes.extend_from_slice(&i.to_le_bytes()));
            bytes.resize(bytes.len().next_multiple_of(4), 0);
        }
        primitives.push(format!(
            "{{\"attributes\": {{\"POSITION\": 0, \"NORMAL\": 1, \"TEXCOORD_0\": 2}}, \"mode\": {mode}{more}}}"
        ));
    }
    format!(
        "{{\"asset\": {{\"version\": \"2.0\"}}, \"nodes\": [{{\"mesh\": 0}}], \"meshes\": [{{\"primitives\": [{}]}}], \"accessors\": [{}], \"bufferViews\": [{}], \"buffers\": [{{\"byteLength\": {}, \"uri\": \"data:;base64,{}\"}}]}}",
        primitives.join(", "),
        accessors.join(", "),
        views.join(", "),
        bytes.len(),
        base64(&bytes)
    )
}

/// A wavy sheet as a list, as strips stitched into one, and as strips of vertices without indices;
/// and a hexagon as a list and as a fan. The pictures are equal, and vertices shared by triangles
/// exist once.
#[test]
fn lists_strips_and_fans_are_one_shape() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |gltf: &str| {
        fs::write(folder.path().join("m.gltf"), gltf).unwrap();
        let text = "[image]\nwidth = 60\nheight = 60\n[camera]\neye = [1, -2, 5]\n[height]\nsource = \"wood\"\n[[object]]\nshape = \"mesh\"\nfile = \"m.gltf\"";
        Scene::parse(text, &folder.path().join("s.toml")).unwrap()
    };
    let vertex = |p: DVec3, n: DVec3| (p, n, DVec2::new(p.x, p.y) / 4.0 + 0.5);
    let (columns, rows) = (7u16, 5u16);
    let mut sheet = Vec::new();
    for j in 0..=rows {
        for i in 0..=columns {
            let (x, y) = (f64::from(i) / 2.0 - 1.75, f64::from(j) / 2.0 - 1.25);
            let n = DVec3::new(-0.3 * x.cos(), 0.2 * y.sin(), 1.0);
            sheet.push(vertex(DVec3::new(x, y, 0.3 * x.sin() + 0.2 * y.cos()), n));
        }
    }
    let id = |i: u16, j: u16| j * (columns + 1) + i;
    let (mut list, mut strip) = (Vec::new(), Vec::new());
    for j in 0..rows {
        for i in 0..columns {
            let [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
            list.extend([d, a, c, a, b, c]);
        }
        if j > 0 {
            strip.extend([id(columns, j - 1), id(0, j + 1)]);
        }
        strip.extend((0..=columns).flat_map(|i| [id(i, j + 1), id(i, j)]));
    }
    let whole: Vec<_> = strip.iter().map(|i| sheet[usize::from(*i)]).collect();
    let hexagon: Vec<_> = (0..6)
        .map(|i| {
            let (sin, cos) = (TAU * f64::from(i) / 6.0).sin_cos();
            vertex(DVec3::new(1.5 * cos, 1.2 * sin, 0.0), DVec3::new(0.2 * cos, 0.2 * sin, 1.0))
        })
        .collect();
    let fan = [0, 1, 2, 3, 4, 5];
    let triangles = u64::from(2 * columns * rows);
    let shared = u64::from((columns + 1) * (rows + 1));
    let corners = strip.len() as u64;
    let stitches = 4 * u64::from(rows - 1);
    let cases = [
        (gltf_of(&sheet, &[(4, Some(&list))]), [shared, triangles, 3 * triangles, 0]),
        (gltf_of(&sheet, &[(5, Some(&strip))]), [shared, triangles, corners, stitches]),
        (gltf_of(&whole, &[(5, None)]), [corners, triangles, 0, stitches]),
        (gltf_of(&hexagon, &[(4, Some(&[0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5]))]), [6, 4, 12, 0]),
        (gltf_of(&hexagon, &[(6, Some(&fan))]), [6, 4, 6, 0]),
        (gltf_of(&hexagon, &[(6, None)]), [6, 4, 0, 0]),
    ];
    let mut first: Option<Fragments> = None;
    for (number, (gltf, [vertices, primitives, indices, stitches])) in cases.iter().enumerate() {
        let scene = scene(gltf);
        let sharing = scene.assemble().unwrap().sharing();
        assert_eq!(
            [sharing.vertices, sharing.primitives, sharing.indices, sharing.stitches],
            [*vertices, *primitives, *indices, *stitches],
            "{number}"
        );
        // Without indices a stitch has vertices of its own, which belong to no triangle.
        let idle = if *indices == 0 { stitches / 2 } else { 0 };
        assert_eq!(sharing.vertex_operations, vertices - idle, "{number}");
        assert_eq!(sharing.replicated_operations, 3 * primitives);
        let f = traced(&scene);
        assert!(f.len() > 400, "{number}: {}", f.len());
        if number == 3 {
            first = None;
        }
        let expected = first.get_or_insert_with(|| f.clone());
        assert_eq!(f.pixel, expected.pixel, "{number}");
        assert_eq!(f.face, expected.face, "{number}");
        for i in 0..f.len() {
            assert!((normal(&f, i) - normal(expected, i)).length() < 1e-12, "{number} {i}");
            assert!((tangent(&f, i) - tangent(expected, i)).length() < 1e-12, "{number} {i}");
        }
    }
}

const SQUARE: &str =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

#[test]
fn mirrored_and_smooth_meshes() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.obj");
    let scene = || {
        let text = "[image]\nwidth = 20\nheight = 20\n[camera]\neye = [0, 0, 5]\nup = [0, 1, 0]\n[height]\nsource = \"wood\"\n[[object]]\nshape = \"mesh\"\nfile = \"a.obj\"";
        Scene::parse(text, &folder.path().join("scene.toml")).unwrap()
    };
    // A square as one polygon: with the texture of the plane, then with u to the left.
    fs::write(&file, format!("{SQUARE}f 1/1/1 2/2/1 3/3/1 4/4/1")).unwrap();
    let f = traced(&scene());
    assert!(!f.is_empty() && f.handedness.iter().all(|h| *h == 1.0));
    assert_eq!(tangent(&f, 0), DVec3::X);
    fs::write(&file, format!("{SQUARE}f 1/2/1 2/1/1 3/4/1 4/3/1")).unwrap();
    let mirrored = scene();
    assert!(!mirrored.facts().right_handed);
    let f = traced(&mirrored);
    assert!(f.handedness.iter().all(|h| *h == -1.0));
    assert_eq!((tangent(&f, 0), f.bitangent(0)), (DVec3::NEG_X, DVec3::Y));
    // With reversed corners but normals towards the viewer, the normals determine the front.
    fs::write(&file, format!("{SQUARE}f 4/4/1 3/3/1 2/2/1 1/1/1")).unwrap();
    let turned = traced(&scene());
    assert_eq!(turned.pixel, f.pixel);
    assert!(turned.handedness.iter().all(|h| *h == 1.0));
    // Differing normals are interpolated and normalised, and there is no flat face.
    fs::write(&file, format!("{SQUARE}vn 1 0 1\nvn -2 0 2\nf 1/1/3 2/2/2 3/3/2 4/4/3")).unwrap();
    let smooth = scene();
    let f = traced(&smooth);
    for i in 0..f.len() {
        let n = DVec3::new(f.position[0][i], 0.0, 1.0).normalize();
        assert!((normal(&f, i) - n).length() < 1e-12, "{i}");
        let t = (DVec3::X - n * n.x).normalize();
        assert!((tangent(&f, i) - t).length() < 1e-12, "{i}");
        assert_eq!(f.face[i], CURVED);
    }
}

#[test]
fn there_is_no_crack_between_triangles() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::new();
    // A wavy sheet of 2 x 30 x 30 triangles that extends beyond all borders of the image.
    for i in 0..=30 {
        for j in 0..=30 {
            let (x, y) = (f64::from(i) / 3.0 - 5.0, f64::from(j) / 3.0 - 5.0);
            writeln!(text, "v {x} {y} {}\nvt {x} {y}", 0.2 * (3.0 * x).sin() * (2.0 * y).cos())
                .unwrap();
        }
    }
    text.push_str("vn 0 0 1\n");
    for i in 0..30 {
        for j in 0..30 {
            let a = 31 * i + j + 1;
            let corner = |k| format!("{k}/{k}/1");
            writeln!(
                text,
                "f {} {} {} {}",
                corner(a),
                corner(a + 31),
                corner(a + 32),
                corner(a + 1)
            )
            .unwrap();
        }
    }
    fs::write(folder.path().join("sheet.obj"), text).unwrap();
    // The middle of the image and of many pixels lie exactly on edges.
    for camera in ["eye = [0, 0, 6]\nprojection = \"orthographic\"\nheight = 4", "eye = [0, 0, 6]"]
    {
        let text = format!(
            "[image]\nwidth = 144\nheight = 144\n[camera]\n{camera}\nup = [0, 1, 0]\n[[object]]\nshape = \"mesh\"\nfile = \"sheet.obj\""
        );
        let scene = Scene::parse(&text, &folder.path().join("x.toml")).unwrap();
        assert_eq!(traced(&scene).len(), 144 * 144);
    }
}

#[test]
fn maps_from_files() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    image::RgbImage::from_fn(3, 2, |x, y| image::Rgb([(x * 100) as u8, (y * 255) as u8, 128]))
        .save(at("t.png"))
        .unwrap();
    let grey = image::ImageBuffer::<image::Luma<u16>, _>::from_fn(3, 3, |x, _| {
        image::Luma([x as u16 * 20_000])
    });
    grey.save(at("h.png")).unwrap();
    image::RgbImage::from_pixel(8, 8, image::Rgb([90, 90, 90])).save(at("g.jpg")).unwrap();
    let read = |text: &str| {
        Scene::parse(&format!("{text}\n[[object]]\nshape = \"plane\""), &at("s.toml")).unwrap()
    };
    let scene = read("[texture]\nfile = \"t.png\"\n[height]\nfile = \"h.png\"\nscale = -3");
    assert_eq!(scene.texture.size(), (3, 2));
    let texel = scene.texture.texels()[4];
    let curve = |code: f64| ((code / 255.0 + 0.055) / 1.055).powf(2.4);
    assert!((f64::from(texel[0]) - curve(100.0)).abs() < 1e-7 && texel[1] == 1.0);
    assert!((f64::from(texel[2]) - curve(128.0)).abs() < 1e-7);
    assert_eq!(scene.bumps.heights()[1], 20_000.0 / 65_535.0);
    let n = scene.bumps.vector(4);
    let slope = -3.0 * (40_000.0 / 65_535.0) / 2.0;
    assert!((n.x / n.z + slope).abs() < 1e-14 && n.y == 0.0, "{n}");
    let scene = read("[texture]\nfile = \"g.jpg\"\n[height]\nfile = \"g.jpg\"");
    assert!(scene.facts().flat_bumps && scene.texture.size() == (8, 8));
}

/// A JPEG file whose EXIF data give its orientation.
fn turned(jpeg: &[u8], orientation: u8) -> Vec<u8> {
    let mut exif = b"Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0".to_vec();
    exif.extend_from_slice(&[orientation, 0, 0, 0, 0, 0, 0, 0]);
    let len = (exif.len() as u16 + 2).to_be_bytes();
    [&jpeg[..2], b"\xff\xe1", &len, &exif, &jpeg[2..]].concat()
}

#[test]
fn pictures_are_turned_as_their_exif_data_ask() {
    let folder = tempfile::tempdir().unwrap();
    let mut jpeg = Vec::new();
    let (w, h) = (20, 12);
    let picture = image::GrayImage::from_fn(w, h, |x, y| image::Luma([(9 * x + 5 * y) as u8]));
    picture.write_to(&mut std::io::Cursor::new(&mut jpeg), image::ImageFormat::Jpeg).unwrap();
    let read = |file: &[u8]| {
        fs::write(folder.path().join("t.jpg"), file).unwrap();
        let text = "[texture]\nfile = \"t.jpg\"\n[height]\nfile = \"t.jpg\"\n[[object]]\nshape = \"plane\"";
        Scene::parse(text, &folder.path().join("s.toml")).unwrap()
    };
    let stored = read(&jpeg);
    for orientation in 1..=8 {
        let scene = read(&turned(&jpeg, orientation));
        let (width, height) = if orientation < 5 { (w, h) } else { (h, w) };
        assert_eq!(scene.texture.size(), (width, height));
        assert_eq!(scene.bumps.size(), (width, height));
        for y in 0..height {
            for x in 0..width {
                // The places of the first stored row and column in the shown picture (Exif 2.3,
                // 4.6.4).
                let (from_x, from_y) = match orientation {
                    1 => (x, y),
                    2 => (w - 1 - x, y),
                    3 => (w - 1 - x, h - 1 - y),
                    4 => (x, h - 1 - y),
                    5 => (y, x),
                    6 => (y, h - 1 - x),
                    7 => (w - 1 - y, h - 1 - x),
                    _ => (w - 1 - y, x),
                };
                let (to, from) = ((y * width + x) as usize, (from_y * w + from_x) as usize);
                assert_eq!(scene.texture.texels()[to], stored.texture.texels()[from]);
                assert_eq!(scene.bumps.heights()[to], stored.bumps.heights()[from]);
            }
        }
    }
}

/// With one bit flipped in each byte of a PNG file, or its end cut off, no other picture results.
#[test]
fn damaged_pictures_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let read = |bytes: &[u8]| {
        fs::write(folder.path().join("t"), bytes).unwrap();
        let text = "[texture]\nfile = \"t\"\n[[object]]\nshape = \"plane\"";
        let scene = Scene::parse(text, &folder.path().join("s.toml"));
        scene.map(|scene| scene.texture.texels().to_vec()).map_err(|why| why.to_string())
    };
    let picture = image::RgbImage::from_fn(12, 9, |x, y| {
        image::Rgb([(x * y) as u8, (37 * x * x) as u8, (59 * y + x) as u8])
    });
    let encoded = |format| {
        let mut bytes = Vec::new();
        picture.write_to(&mut std::io::Cursor::new(&mut bytes), format).unwrap();
        bytes
    };
    let png = encoded(image::ImageFormat::Png);
    let whole = read(&png).unwrap();
    let other = |bytes: &[u8]| read(bytes).is_ok_and(|texels| texels != whole);
    for at in 0..png.len() {
        let mut damaged = png.clone();
        damaged[at] ^= 1 << (at % 8);
        assert!(!other(&damaged), "byte {at}");
        assert!(!other(&png[..at]), "cut at {at}");
    }
    let jpeg = encoded(image::ImageFormat::Jpeg);
    assert!(read(&jpeg).is_ok());
    for len in 0..jpeg.len() {
        assert!(read(&jpeg[..len]).is_err(), "{len}");
    }
    let why = read(&jpeg[..jpeg.len() - 10]).unwrap_err();
    let expected = format!(
        "is cut off or damaged at byte {end} of {end}: the data end too early, in unit 3 of 4 of scan 1; copy or export it again",
        end = jpeg.len() - 10
    );
    assert!(why.ends_with(&expected), "{why}");
}

#[test]
fn heights_are_grey() {
    let folder = tempfile::tempdir().unwrap();
    let read = |picture: image::RgbImage, name: &str| {
        picture.save(folder.path().join(name)).unwrap();
        let text = format!("[height]\nfile = \"{name}\"\n[[object]]\nshape = \"plane\"");
        let scene = Scene::parse(&text, &folder.path().join("s.toml"));
        scene.map_err(|why| why.to_string().replace(&format!("{}/", folder.path().display()), ""))
    };
    let grey = |x: u32, y: u32| 7 * x as u8 + 3 * y as u8;
    let picture = |of: &dyn Fn(u32, u32) -> [u8; 3]| {
        image::RgbImage::from_fn(16, 16, |x, y| image::Rgb(of(x, y)))
    };
    // Grey, then with small differences as from conversions and JPEG, then with the largest legal
    // ones.
    for name in ["g.png", "g.jpg"] {
        assert!(read(picture(&|x, y| [grey(x, y); 3]), name).is_ok());
        let noisy = |x: u32, y: u32| {
            let g = grey(x, y);
            [g + (x % 3) as u8, g, g + (y % 4) as u8]
        };
        assert!(read(picture(&noisy), name).is_ok(), "{name}");
    }
    let tinted = read(picture(&|_, _| [84, 100, 100]), "t.png").unwrap();
    assert!((tinted.bumps.heights()[0] - (100.0 - 0.2126 * 16.0) / 255.0).abs() < 1e-12);
    let one = |x: u32, y: u32| if (x, y) == (5, 2) { [100, 117, 100] } else { [grey(x, y); 3] };
    let normals = |x: u32, y: u32| {
        let (a, b) = (f64::from(x) / 20.0 - 0.4, f64::from(y) / 20.0 - 0.4);
        let c = (1.0 - a * a - b * b).sqrt();
        [a, b, c].map(|c| (127.5 * (c + 1.0)).round() as u8)
    };
    let refused = |of: &dyn Fn(u32, u32) -> [u8; 3], name| read(picture(of), name).unwrap_err();
    assert_eq!(
        refused(&one, "one.png"),
        "s.toml, line 2: one.png: has colours (texel (5, 2) is [100, 117, 100] of 255), but [height] needs heights: grey values whose channels differ by at most 16. Give a height map, or save it as greyscale if bright means high"
    );
    assert_eq!(
        refused(&normals, "normals.png"),
        "s.toml, line 2: normals.png: is a tangent-space normal map (texel (0, 10) is [77, 140, 244] of 255), but [height] needs heights: give the height or displacement map from which it was baked"
    );
    let why = refused(&|x, y| [(16 * x) as u8, 40, (16 * y) as u8], "colours.jpg");
    assert!(why.starts_with("s.toml, line 2: colours.jpg: has colours (texel ("), "{why}");
}

/// Messages of wrong scenes, one line each.
#[test]
fn wrong_scenes_are_refused() {
    let mut seen = String::new();
    let object = "[[object]]\nshape = \"cube\"\n";
    for text in [
        "[image]\nwidht = 3",
        "[image]\nwidth = 4097",
        "[image]\n\nheight = 0",
        "[image]\nwidth = \"wide\"",
        "[image]\nwidth = 1.5",
        "[image]\nbackground = [0.0, 2.0, 0.0]",
        "[image]\nbackground = [0.0, 0.5]",
        "[image]\nbackground = [0.5, 0, 0, 1]",
        "[camera]\n\neye = [0.3, -3.0, 1, 1]",
        "[[light]]\ndirection = [0, -1, 1, 5]",
        "[texture]\ncolor = [1, 0, 0, 0.5]",
        "[image",
        "[camera]\neye = [nan, 0, 0]",
        "[camera]\ntarget = [0, inf, 0]",
        "[camera]\neye = [0, 0, 1e7]",
        "[camera]\neye = [0, 0, 0]",
        "[camera]\neye = [0, 0, 5]",
        "[camera]\nup = [0, 0, 0]",
        "[camera]\nfov_degrees = 180",
        "[camera]\nprojection = \"orthographic\"\nfov_degrees = 30",
        "[camera]\nheight = 3",
        "[camera]\nprojection = \"fisheye\"",
        "[[light]]\nintensity = 1.5",
        "[[light]]\ncolour = 1",
        "[[light]]\nkind = \"spot\"",
        "[[light]]\ndirection = [0, 0, 0]",
        "[[light]]\nposition = [0, 0, 1]",
        "[[light]]\nkind = \"point\"\ndirection = [0, 0, 1]",
        &"[[light]]\n".repeat(9),
        "[ambient]\nintensity = -0.1",
        "[material]\ndiffuse = 1.01",
        "[material]\nexponent = 256",
        "[material]\nexponent = -1",
        "[texture]\nsource = \"marble\"",
        "[texture]\nsource = \"wood\"\nfile = \"wood.png\"",
        "[texture]\nsource = \"wood\"\ncolor = [1, 1, 1]",
        "[texture]\nscale = 3",
        "[texture]\ncolor = [1, 1, -1]",
        "[texture]\nfile = \"none.png\"\nwidth = 3",
        "[texture]\nfile = \"none.png\"",
        "[height]\ncolor = [1, 1, 1]",
        "[height]\nscale = inf",
        "[height]\nwidth = 8193",
        "[height]\nwidth = 8000\nheight = 8000",
        // Arrays, in the order of the keys.
        "ambient = [0.5, \"more\", [1, 2]]",
        "image = [8, 8, [0, 0, 0], 99]",
        "material = [0.1, 0.7, 0.2, 32]",
        "camera = [\"perspective\"]",
        "light = [[\"directional\", [1, 2, 3]]]",
        "texture = [\"wood\"]",
        "emboss = [1.5, \"nearest\"]",
        "orbit = [12]",
    ] {
        let error = Scene::parse(&format!("{text}\n{object}"), Path::new("s.toml")).unwrap_err();
        assert!(!error.is_failed_check());
        writeln!(seen, "{error}").unwrap();
    }
    for text in [
        "",
        "[[object]]",
        "[[object]]\nshape = \"torus\"",
        "[[object]]\nshape = \"mesh\"",
        "[[object]]\nshape = \"cube\"\nfile = \"a.obj\"",
        "[[object]]\nshape = \"cube\"\nsource = \"shell\"",
        "[[object]]\nshape = \"mesh\"\nsource = \"shell\"\nfile = \"a.obj\"",
        "[[object]]\nshape = \"mesh\"\nfile = \"none.obj\"",
        "[[object]]\nshape = \"cube\"\nscale = 0",
        "[[object]]\nshape = \"cube\"\nscale = [1, nan, 1]",
        "[[object]]\nshape = \"cube\"\nscale = \"big\"",
        "[[object]]\nshape = \"cube\"\nscale = [1, 1, 1, 1]",
        "[[object]]\nshape = \"cube\"\ntranslate = [\n0,\n0,\n0,\n1]",
        "[[object]]\nshape = \"cube\"\ncolor = 1",
        "[[object]]\nshape = \"cube\"\nrotate_degrees = [0, inf, 0]",
        "[[object]]\nshape = \"cube\"\n\nmaterial = { specular = 2 }",
        "[[object]]\nshape = \"cube\"\n\nmaterial = [0.1]",
        "object = [[\"cube\"]]",
    ] {
        let error = Scene::parse(text, Path::new("s.toml")).unwrap_err();
        writeln!(seen, "{error}").unwrap();
    }
    expect![[r#"
        s.toml, line 2: unknown field `widht`, expected one of `width`, `height`, `background` in `widht = 3`
        s.toml, line 2: `width` = 4097: legal are whole numbers 1 to 4096
        s.toml, line 3: `height` = 0: legal are whole numbers 1 to 4096
        s.toml, line 2: invalid type: string "wide", expected a whole number in `width = "wide"`
        s.toml, line 2: invalid type: floating point `1.5`, expected a whole number in `width = 1.5`
        s.toml, line 2: `background` = 2: legal is 0 to 1
        s.toml, line 2: invalid length 2, expected three numbers in `background = [0.0, 0.5]`
        s.toml, line 2: invalid length 4, expected three numbers in `background = [0.5, 0, 0, 1]`
        s.toml, line 3: invalid length 4, expected three numbers in `eye = [0.3, -3.0, 1, 1]`
        s.toml, line 2: invalid length 4, expected three numbers in `direction = [0, -1, 1, 5]`
        s.toml, line 2: invalid length 4, expected three numbers in `color = [1, 0, 0, 0.5]`
        s.toml, line 1: unclosed table, expected `]` in `[image`
        s.toml, line 2: `eye` = NaN: legal is -1000000 to 1000000
        s.toml, line 2: `target` = inf: legal is -1000000 to 1000000
        s.toml, line 2: `eye` = 10000000: legal is -1000000 to 1000000
        s.toml, line 2: the camera's `eye` is its `target`: move one of them
        s.toml, line 1: the camera's `up` = [0, 0, 1] is zero or along the view: choose another, such as [1, 0, 0]
        s.toml, line 2: the camera's `up` = [0, 0, 0] is zero or along the view: choose another, such as [1, 0, 0]
        s.toml, line 2: `fov_degrees` = 180: legal is 0.01 to 170
        s.toml, line 3: `fov_degrees` has no effect here: it is for `projection = "perspective"`; leave it out
        s.toml, line 2: `height` has no effect here: it is for `projection = "orthographic"`; leave it out
        s.toml, line 2: unknown variant `fisheye`, expected `perspective` or `orthographic` in `projection = "fisheye"`
        s.toml, line 2: `intensity` = 1.5: legal is 0 to 1
        s.toml, line 2: unknown field `colour`, expected one of `kind`, `direction`, `position`, `intensity` in `colour = 1`
        s.toml, line 2: unknown variant `spot`, expected `directional` or `point` in `kind = "spot"`
        s.toml, line 2: `direction` is zero: it must point from the surface towards the light
        s.toml, line 2: `position` has no effect here: it is for `kind = "point"`; leave it out
        s.toml, line 3: `direction` has no effect here: it is for `kind = "directional"`; leave it out
        s.toml, line 9: 9 lights: legal are 1 to 8
        s.toml, line 2: `intensity` = -0.1: legal is 0 to 1
        s.toml, line 2: `diffuse` = 1.01: legal is 0 to 1
        s.toml, line 2: `exponent` = 256: legal are whole numbers 0 to 255
        s.toml, line 2: `exponent` = -1: legal are whole numbers 0 to 255
        s.toml, line 2: unknown variant `marble`, expected one of `wood`, `brick`, `earth`, `lettering`, `constant` in `source = "marble"`
        s.toml, line 1: `source` and `file` are both given: remove one of them
        s.toml, line 3: `color` has no effect here: colours come from `source`; leave it out
        s.toml, line 2: `scale` has no effect here: it is for `[height]`; leave it out
        s.toml, line 2: `color` = -1: legal is 0 to 1
        s.toml, line 3: `width` has no effect here: the size is that of the file; leave it out
        s.toml, line 2: none.png: can't read: No such file or directory (os error 2)
        s.toml, line 2: `color` has no effect here: it is for `[texture]`; leave it out
        s.toml, line 2: `scale` = inf: legal is -1000000 to 1000000
        s.toml, line 2: `width` = 8193: legal are whole numbers 1 to 8192
        s.toml, line 1: the map has 8000 x 8000 texels: legal are sides of 1 to 8192 and at most 33554432 texels; scale it down
        s.toml, line 1: invalid type: sequence, expected a table in `ambient = [0.5, "more", [1, 2]]`
        s.toml, line 1: invalid type: sequence, expected a table in `image = [8, 8, [0, 0, 0], 99]`
        s.toml, line 1: invalid type: sequence, expected a table in `material = [0.1, 0.7, 0.2, 32]`
        s.toml, line 1: invalid type: sequence, expected a table in `camera = ["perspective"]`
        s.toml, line 1: invalid type: sequence, expected a table in `light = [["directional", [1, 2, 3]]]`
        s.toml, line 1: invalid type: sequence, expected a table in `texture = ["wood"]`
        s.toml, line 1: invalid type: sequence, expected a table in `emboss = [1.5, "nearest"]`
        s.toml, line 1: invalid type: sequence, expected a table in `orbit = [12]`
        s.toml: 0 objects: legal are 1 to 1000; an object is `[[object]]` with `shape = "sphere"` below it
        s.toml, line 1: missing field `shape` in `[[object]]`
        s.toml, line 2: unknown variant `torus`, expected one of `plane`, `cube`, `sphere`, `mesh` in `shape = "torus"`
        s.toml, line 1: a mesh needs `file`, an .obj, .gltf or .glb file, or `source = "shell"`
        s.toml, line 3: `file` has no effect here: it is for `shape = "mesh"`; leave it out
        s.toml, line 3: `source` has no effect here: it is for `shape = "mesh"`; leave it out
        s.toml, line 4: `file` has no effect here: the mesh comes from `source`; leave it out
        s.toml, line 3: none.obj: can't read: No such file or directory (os error 2)
        s.toml, line 3: `scale` = 0: legal is 0.000001 to 1000000, or the negative of that, which mirrors
        s.toml, line 3: `scale` = NaN: legal is 0.000001 to 1000000, or the negative of that, which mirrors
        s.toml, line 3: scale is a number or three numbers in brackets in `scale = "big"`
        s.toml, line 3: scale is a number or three numbers in brackets in `scale = [1, 1, 1, 1]`
        s.toml, line 3: invalid length 4, expected three numbers in `translate = [`
        s.toml, line 3: unknown field `color`, expected one of `shape`, `file`, `source`, `translate`, `rotate_degrees`, `scale`, `crease_degrees`, `material` in `color = 1`
        s.toml, line 3: `rotate_degrees` = inf: legal is -1000000 to 1000000
        s.toml, line 4: `specular` = 2: legal is 0 to 1
        s.toml, line 4: invalid type: sequence, expected a table in `material = [0.1]`
        s.toml, line 1: invalid type: sequence, expected a table in `object = [["cube"]]`
    "#]].assert_eq(&seen);
    assert!(Scene::open(Path::new("/nowhere/scene.toml")).is_err());
}

/// The PNG header of a grey image this large, with nothing after it.
fn png_header(width: u32, height: u32) -> Vec<u8> {
    let mut chunk = b"IHDR".to_vec();
    chunk.extend_from_slice(&width.to_be_bytes());
    chunk.extend_from_slice(&height.to_be_bytes());
    chunk.extend_from_slice(&[8, 0, 0, 0, 0]);
    let crc = !chunk.iter().fold(!0u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            crc >> 1 ^ (0xedb8_8320 & 0u32.wrapping_sub(crc & 1))
        })
    });
    let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
    png.extend_from_slice(&chunk);
    png.extend_from_slice(&crc.to_be_bytes());
    png
}

/// Messages of wrong files, one line each.
#[test]
fn wrong_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut seen = String::new();
    let mut refused = |text: &str, name: &str, bytes: &[u8]| {
        fs::write(folder.path().join(name), bytes).unwrap();
        let text = format!("{text}\nfile = \"{name}\"\n");
        let text =
            if text.contains("[[object]]") { text } else { text + "[[object]]\nshape = \"plane\"" };
        let error = Scene::parse(&text, &folder.path().join("s.toml")).unwrap_err().to_string();
        let error = error.replace(&format!("{}/", folder.path().display()), "");
        writeln!(seen, "{error}").unwrap();
    };
    let mut good = Vec::new();
    let picture = image::RgbImage::from_fn(40, 40, |x, y| image::Rgb([(x * y) as u8, x as u8, 3]));
    picture.write_to(&mut std::io::Cursor::new(&mut good), image::ImageFormat::Png).unwrap();
    refused("[texture]", "text.png", b"this is no picture");
    refused("[texture]", "empty.png", b"");
    refused("[texture]", "cut.png", &good[..good.len() / 2]);
    let mut flipped = good.clone();
    flipped[60] ^= 0x55;
    refused("[height]", "flipped.png", &flipped);
    refused("[texture]", "huge.png", &png_header(100_000, 100_000));
    refused("[height]", "wide.png", &png_header(8193, 1));
    refused("[height]", "many.png", &png_header(8000, 8000));
    refused("[texture]", "header.png", &png_header(8000, 4000));
    refused("[texture]", "cut.jpg", b"\xff\xd8\xff\xe0\0\x10JFIF\0");

    let bumpy = "[height]\nsource = \"brick\"\nwidth = 8\nheight = 8\n[[object]]\nshape = \"mesh\"";
    for (name, faces) in [
        ("no_uv.obj", "f 1//1 2//1 3//1"),
        ("points.obj", "f 1 2 3"),
        ("nan.obj", "v 0 -1.#IND 0\nf 5/1/1 2/2/1 3/3/1"),
        ("inf.obj", "vn 0 0 -inf\nf 1/1/2 2/2/1 3/3/1"),
        ("uv.obj", "vt 1e300 0\nf 1/1/1 2/2/1 3/5/1"),
        ("word.obj", "v 0 zero 0"),
        ("few.obj", "vn 0 1"),
        ("no_vt.obj", "vt"),
        ("nine.obj", "f 1/1/1 2/2/1 9/3/1"),
        ("zero.obj", "f 1/1/1 2/2/1 0/3/1"),
        ("back.obj", "f 1/1/1 2/2/1 3/-5/1"),
        ("letters.obj", "f 1/1/1 2/2/1 c/3/1"),
        ("many.obj", "f 1/1/1/1 2/2/1 3/3/1"),
        ("slash.obj", "f /1/1 2/2/1 3/3/1"),
        (
            "two.obj",
            "f 1/1/1 2/2/1\n\nf 1/1/1 1/2/1 1/3/1\nl 1 2\np 1\nsurf 0 1 0 1 1 2\nCall a.obj\ncall b.obj",
        ),
        ("crossing.obj", "f 1/1/1 3/3/1 2/2/1 4/4/1"),
        ("nul.obj", "f 1/1/1 2/2/1 3/3/1\0"),
        ("empty.obj", ""),
        ("flat_uv.obj", "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/1/1 4/2/1"),
        ("mesh.stl", ""),
    ] {
        refused(bumpy, name, format!("{SQUARE}{faces}").as_bytes());
    }
    refused(bumpy, "late.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\nvn 0 0 1");
    // An index that refers to no list must still be a valid index.
    refused(bumpy, "no_index.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1/x 2/1/y 3/1/z");
    refused(bumpy, "no_zero.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/0 2/0 3/0");
    let wide = |bytes: fn(u16) -> [u8; 2]| -> Vec<u8> {
        "\u{feff}v 0 0 0\n".encode_utf16().flat_map(bytes).collect()
    };
    refused(bumpy, "little.obj", &wide(u16::to_le_bytes));
    refused(bumpy, "big.obj", &wide(u16::to_be_bytes));
    let painted =
        "[texture]\nsource = \"brick\"\nwidth = 8\nheight = 8\n[[object]]\nshape = \"mesh\"";
    refused(painted, "painted.obj", format!("{SQUARE}f 1/1 2/2 3/3\nf 1 3 4").as_bytes());

    let (document, binary) = cube_gltf("");
    let mesh = "[[object]]\nshape = \"mesh\"";
    for (name, from, to) in [
        ("accessor.glb", "\"NORMAL\": 1", "\"NORMAL\": 9"),
        ("kind.glb", "\"NORMAL\": 1", "\"NORMAL\": 2"),
        (
            "count.glb",
            "\"componentType\": 5123, \"count\": 36",
            "\"componentType\": 5123, \"count\": 35",
        ),
        ("beyond.glb", "\"byteOffset\": 432", "\"byteOffset\": 436"),
        ("overflow.glb", "\"byteOffset\": 432", "\"byteOffset\": 18446744073709551615"),
        ("stride.glb", "\"byteLength\": 288", "\"byteLength\": 288, \"byteStride\": 4"),
        ("memory.glb", "\"type\": \"VEC2\"", "\"type\": \"VEC2\", \"sparse\": {}"),
        ("lines.glb", "\"indices\": 3", "\"indices\": 3, \"mode\": 1"),
        ("strip.glb", "\"count\": 36, \"type\": \"SCALAR\"", "\"count\": 2, \"type\": \"SCALAR\""),
        ("loop.glb", "\"mesh\": 0", "\"mesh\": 0, \"children\": [0]"),
        ("hidden.glb", "\"rotation\": [0, 0, 0, 1]", "\"scale\": [0, 0, 0]"),
        ("huge.glb", "\"rotation\": [0, 0, 0, 1]", "\"scale\": [1e9, 1e9, 1e9]"),
        (
            "draco.glb",
            "\"scene\": 0",
            "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"scene\": 0",
        ),
        ("json.glb", "\"scene\": 0", "\"scene\": zero"),
        ("scene.glb", "\"scene\": 0", "\"scene\": 1"),
        ("buffer.glb", "\"byteLength\": 1224", "\"byteLength\": 1228"),
        ("none.glb", "\"mesh\": 0, ", ""),
    ] {
        assert!(document.contains(from), "{name}");
        let mut document = document.replace(from, to);
        if name == "strip.glb" {
            document = document.replace("\"indices\": 3", "\"indices\": 3, \"mode\": 5");
        }
        refused(mesh, name, &glb(&document, &binary));
    }
    let mut wrong = binary.clone();
    wrong[0..4].copy_from_slice(&f32::NAN.to_le_bytes());
    refused(mesh, "nan.glb", &glb(&document, &wrong));
    let mut wrong = binary.clone();
    wrong[1222..1224].copy_from_slice(&36u16.to_le_bytes());
    refused(mesh, "index.glb", &glb(&document, &wrong));
    let whole = glb(&document, &binary);
    refused(mesh, "cut.glb", &whole[..whole.len() - 100]);
    refused(mesh, "head.glb", &whole[..9]);
    let mut old = whole.clone();
    old[4] = 1;
    refused(mesh, "old.glb", &old);
    refused(mesh, "away.gltf", cube_gltf("\"uri\": \"away.bin\", ").0.as_bytes());
    refused(mesh, "base.gltf", cube_gltf("\"uri\": \"data:;base64,!\", ").0.as_bytes());

    // Without bumps, a face needs no area in the texture.
    let text = "[[object]]\nshape = \"mesh\"\nfile = \"flat_uv.obj\"";
    let scene = Scene::parse(text, &folder.path().join("s.toml")).unwrap();
    let f = traced(&scene);
    assert!((0..f.len()).all(|i| tangent(&f, i).dot(normal(&f, i)).abs() < 1e-12));
    expect![[r#"
        s.toml, line 2: text.png: can't be decoded as PNG or JPEG: The image format could not be determined
        s.toml, line 2: empty.png: can't be decoded as PNG or JPEG: The image format could not be determined
        s.toml, line 2: cut.png: can't be decoded as PNG or JPEG: unexpected end of file
        s.toml, line 2: flipped.png: can't be decoded as PNG or JPEG: Format error decoding Png: Corrupt deflate stream. InvalidCodeLengthRepeat
        s.toml, line 2: huge.png: the map has 100000 x 100000 texels: legal are sides of 1 to 8192 and at most 33554432 texels; scale it down
        s.toml, line 2: wide.png: the map has 8193 x 1 texels: legal are sides of 1 to 8192 and at most 33554432 texels; scale it down
        s.toml, line 2: many.png: the map has 8000 x 8000 texels: legal are sides of 1 to 8192 and at most 33554432 texels; scale it down
        s.toml, line 2: header.png: can't be decoded as PNG or JPEG: unexpected end of file
        s.toml, line 2: cut.jpg: can't be decoded as PNG or JPEG: Format error decoding Jpeg: I/O errors Not enough bytes, expected 1 but found 0
        no_uv.obj, line 10: triangle 0 (they count from 0) has no texture coordinates, which [height] needs: unwrap the mesh, or leave [height] out
        points.obj, line 10: triangle 0 (they count from 0) has no texture coordinates, which [height] needs: unwrap the mesh, or leave [height] out
        nan.obj, line 11: point 5 has NaN: legal is -1000000 to 1000000
        inf.obj, line 11: normal 2 has -inf: legal is -1000000 to 1000000
        uv.obj, line 11: texture coordinate 5 has 1e300: legal is -1000000 to 1000000
        word.obj, line 10: the point has `zero`, which isn't a number
        few.obj, line 10: the normal has 2 numbers: it needs at least 3
        no_vt.obj, line 10: the texture coordinate has 0 numbers: it needs at least 1
        nine.obj, line 10: corner `9/3/1` refers to point 9, but up to here there are 4 (they count from 1)
        zero.obj, line 10: corner `0/3/1` refers to point 0, but up to here there are 4 (they count from 1)
        back.obj, line 10: corner `3/-5/1` refers to texture coordinate -5, but up to here there are 4 (they count from 1)
        letters.obj, line 10: corner `c/3/1` refers to point c, but up to here there are 4 (they count from 1)
        many.obj, line 10: corner `1/1/1/1` has more than three indices (v/vt/vn)
        slash.obj, line 10: corner `/1/1` names no point
        s.toml, line 7: two.obj: has no triangles; triangles without area left out: 1, the first in line 12; faces of fewer than 3 corners left out: 1, the first in line 10; lines (`l`) ignored: 1, the first in line 13; points (`p`) ignored: 1, the first in line 14; statements of free-form curves and surfaces ignored: 1, the first in line 15; unknown statements ignored, such as `Call`: 2, the first in line 16
        crossing.obj, line 10: the polygon crosses itself, so it has no inside: cut it into polygons that don't
        s.toml, line 7: nul.obj: isn't text: it is binary, or UTF-16 without a byte order mark; save it as UTF-8
        s.toml, line 7: empty.obj: has no triangles
        flat_uv.obj, line 11: triangle 1 (they count from 0) has no area in the texture, so bumps have no direction: unwrap the mesh, or leave [height] out
        s.toml, line 7: mesh.stl: isn't a mesh: legal extensions are .obj, .gltf and .glb
        late.obj, line 6: the first `vn` comes after line 5, whose corners refer to one: move it before that line
        no_index.obj, line 5: corner `1/1/x` refers to normal x, but up to here there are 0 (they count from 1)
        no_zero.obj, line 4: corner `1/0` refers to texture coordinate 0, but up to here there are 0 (they count from 1)
        s.toml, line 7: little.obj: the text is UTF-16: save it as UTF-8
        s.toml, line 7: big.obj: the text is UTF-16: save it as UTF-8
        painted.obj, line 11: triangle 1 (they count from 0) has no texture coordinates, which [texture] needs: unwrap the mesh, or leave [texture] out
        s.toml, line 3: accessor.glb: mesh 0, primitive 0: refers to accessor 9, but there are 4 (they count from 0)
        s.toml, line 3: kind.glb: mesh 0, primitive 0: accessor 2: is VEC2 where VEC3 is needed
        s.toml, line 3: count.glb: mesh 0, primitive 0: 35 corners in a list of triangles: legal is a multiple of 3
        s.toml, line 3: beyond.glb: mesh 0, primitive 0: accessor 1: extends beyond its buffer
        s.toml, line 3: overflow.glb: mesh 0, primitive 0: accessor 1: extends beyond its buffer
        s.toml, line 3: stride.glb: mesh 0, primitive 0: accessor 2: buffer view 1 has `byteStride` 4, less than the 8 bytes of its elements
        s.toml, line 3: memory.glb: isn't glTF 2.0: missing field `count` at line 7 column 82
        s.toml, line 3: lines.glb: has no triangles, only 1 primitives of lines or points: export a surface
        s.toml, line 3: strip.glb: mesh 0, primitive 0: a strip of 2 corners: it needs 3 or more
        s.toml, line 3: loop.glb: node 0 has two parents
        s.toml, line 3: hidden.glb: has no triangles; triangles without area left out: 12
        s.toml, line 3: huge.glb: mesh 0, primitive 0: vertex 0 has 1e9: legal is -1000000 to 1000000
        s.toml, line 3: draco.glb: needs the extension `KHR_draco_mesh_compression`: export without it
        s.toml, line 3: json.glb: isn't glTF 2.0: expected value at line 1 column 40
        s.toml, line 3: scene.glb: refers to scene 1, but there are 1 (they count from 0)
        s.toml, line 3: buffer.glb: buffer 0 has 1224 of 1228 bytes: the file is truncated
        s.toml, line 3: none.glb: has no triangles
        s.toml, line 3: nan.glb: mesh 0, primitive 0: vertex 0 has NaN: legal is -1000000 to 1000000
        s.toml, line 3: index.glb: mesh 0, primitive 0: refers to vertex 36, but there are 36 (they count from 0)
        s.toml, line 3: cut.glb: its .glb container has 1936 of 2036 bytes: the file is truncated; export or copy it again
        s.toml, line 3: head.glb: its .glb container has 9 of 12 bytes: the file is truncated; export or copy it again
        s.toml, line 3: old.glb: is a .glb file of version 1: only version 2 is supported
        s.toml, line 3: away.bin: can't read: No such file or directory (os error 2)
        s.toml, line 3: base.gltf: buffer 0: its data URI can't be decoded: legal are `data:;base64,` with base64, and `data:,` with bytes as %00 to %ff
    "#]].assert_eq(&seen);
}

/// A square in x and z that faces -y, as in typical OBJ files.
const UPRIGHT: [&str; 4] = [
    "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\n",
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n",
    "vn 0 -1 0\n",
    "f 1/1/1 2/2/1 3/3/1 4/4/1\n",
];

/// The picture of an OBJ file with bumps on it, and the notes without the file's path.
fn seen_of(bytes: &[u8]) -> (Fragments, Vec<String>) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("m.obj"), bytes).unwrap();
    let text = "[image]\nwidth = 48\nheight = 48\n[camera]\neye = [0.3, -4, 1.2]\n[height]\nsource = \"brick\"\nwidth = 64\nheight = 64\n[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"";
    let scene = Scene::parse(text, &folder.path().join("s.toml")).unwrap();
    let notes = scene.notes().iter().map(|note| note.rsplit_once("m.obj: ").unwrap().1.to_owned());
    (traced(&scene), notes.collect())
}

/// Files as found in practice: the picture is that of the plain file, and ignored content is
/// reported.
#[test]
fn one_square_as_many_obj_files() {
    let [v, vt, vn, f] = UPRIGHT;
    let plain = [v, vt, vn, f].concat();
    let (expected, notes) = seen_of(plain.as_bytes());
    assert!(expected.len() > 400 && notes.is_empty());
    let made = "means of the triangles around each are used, up to edges of `crease_degrees` = 60 (`tangent-faceted` alone uses the triangles' own)";
    let normals = format!("6 of 6 corners have no normal: {made}");
    let passed = "unknown statements ignored, such as `vw`: 2, the first in line 11";
    for (name, text, expected_notes) in [
        ("mark", format!("\u{feff}{plain}"), vec![]),
        ("two marks", format!("\u{feff}{v}\u{feff}{vt}{vn}{f}"), vec![]),
        ("CR", plain.replace('\n', "\r"), vec![]),
        ("CRLF", plain.replace('\n', "\r\n"), vec![]),
        ("goes on", plain.replace(" 3/3", " \\\n 3/3"), vec![]),
        ("comments", plain.replace('\n', " # C:\\meshes\\\n"), vec![]),
        ("colours and weights", plain.replace("-1\n", "-1 0.5 nan 1\n"), vec![]),
        ("three texture coordinates", plain.replace("vt 0 0", "vt 0 0 7"), vec![]),
        ("one texture coordinate", plain.replace("vt 1 0", "vt 1"), vec![]),
        ("names", format!("mtllib a b.mtl\no \ng f 1\nusemtl m#1\ns off\n{plain}"), vec![]),
        ("names of folders", format!("g C:\\dir\\\n{v}usemtl \\\n{vt}{vn}o a\\ \n{f}"), vec![]),
        (
            "out and back",
            format!("{plain}f 1 2 3 2\n"),
            vec!["triangles without area left out: 2, the first in line 11"],
        ),
        ("old", plain.replace("f ", "fo "), vec![]),
        ("from behind", [v, vt, vn, "f -4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1"].concat(), vec![]),
        (
            "unused",
            format!("{plain}vn 0 0 0\nv nan 1.#QNAN -1.#IND\nvt inf 0\nv 7e10 0 0\n"),
            vec![],
        ),
        ("without normals", [v, vt, "f 1/1 2/2 3/3 4/4"].concat(), vec![&*normals]),
        ("slashes", [v, vt, "f 1/1/ 2/2/ 3/3/ 4/4/"].concat(), vec![&*normals]),
        ("no length", plain.replace("0 -1 0\n", "0 0 0\n"), vec![&*normals]),
        (
            "normals not there",
            [v, vt, f].concat(),
            vec![
                "corners that refer to a normal, but the file has none: 4, the first in line 9",
                &*normals,
            ],
        ),
        (
            "one corner twice",
            [v, vt, vn, "f 1/1/1 2/2/1 3/3/1 4/4/1 4/4/1"].concat(),
            vec!["triangles without area left out: 1, the first in line 10"],
        ),
        (
            "a face that is a line",
            format!("{plain}f 1/1/1 3/3/1 1/1/1\nf 1/1/1 1/1/1 1/1/1 1/1/1\nf 1/1/1 2/2/1"),
            vec![
                "triangles without area left out: 3, the first in line 11",
                "faces of fewer than 3 corners left out: 1, the first in line 13",
            ],
        ),
        (
            "lines and points",
            format!("{plain}l 1 2 3\np 1\nl 1 2\ncurv 0 1 1 2\n"),
            vec![
                "lines (`l`) ignored: 2, the first in line 11",
                "points (`p`) ignored: 1, the first in line 12",
                "statements of free-form curves and surfaces ignored: 1, the first in line 14",
            ],
        ),
        ("unknown", format!("{plain}vw 0 0 1\nF 1 2 3\n"), vec![passed]),
    ] {
        let (seen, notes) = seen_of(text.as_bytes());
        assert_eq!(notes, expected_notes, "{name}");
        assert_eq!((&seen.pixel, &seen.bump), (&expected.pixel, &expected.bump), "{name}");
        assert_eq!((&seen.normal, &seen.tangent), (&expected.normal, &expected.tangent), "{name}");
    }
}

/// The picture is the same for every first corner of a concave polygon, and the notch stays open.
#[test]
fn concave_polygons_are_cut_inside() {
    let notched = "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv 0 0 -0.5\nv -1 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.25\nvt 0 1\nvn 0 -1 0\n";
    let mut corners = ["1/1/1", "2/2/1", "3/3/1", "4/4/1", "5/5/1"];
    // The view of the whole square, without the notch.
    let (square, _) = seen_of(UPRIGHT.concat().as_bytes());
    let below = |i: &usize| square.position[2][*i] < 1.5 * square.position[0][*i].abs() - 0.5;
    let expected: Vec<u32> = (0..square.len()).filter(below).map(|i| square.pixel[i]).collect();
    assert!(expected.len() > 400 && expected.len() < square.len() - 200);
    let mut bumps: Option<Vec<u32>> = None;
    for _ in 0..corners.len() {
        corners.rotate_left(1);
        let (seen, _) = seen_of(format!("{notched}f {}\n", corners.join(" ")).as_bytes());
        assert_eq!(seen.pixel, expected, "{corners:?}");
        assert_eq!(&seen.bump, bumps.get_or_insert_with(|| seen.bump.clone()), "{corners:?}");
    }
}

/// Texture coordinates aren't required if nothing uses them.
#[test]
fn texture_coordinates_only_where_something_needs_them() {
    let scene = |mesh: &str| {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("m.obj"), mesh).unwrap();
        let text = "[image]\nwidth = 20\nheight = 20\n[camera]\neye = [0, 0, 5]\nup = [0, 1, 0]\n[texture]\ncolor = [1, 0.5, 0]\n[height]\nwidth = 4\nheight = 4\n[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"";
        Scene::parse(text, &folder.path().join("s.toml")).unwrap()
    };
    let with = traced(&scene(&format!("{SQUARE}f 1/1/1 2/2/1 3/3/1 4/4/1")));
    for faces in ["f 1//1 2//1 3//1 4//1", "f 1 2 3 4", "f 1/1/1 2/2/1 3/3/1\nf 1//1 3/3/1 4/4/1"] {
        let without = traced(&scene(&format!("{SQUARE}{faces}")));
        assert_eq!((&without.pixel, &without.normal), (&with.pixel, &with.normal), "{faces}");
        let t = |i| tangent(&without, i).dot(normal(&without, i));
        assert!((0..without.len()).all(|i| t(i) == 0.0));
    }
}

/// Missing or ignored content of a file is reported while the program runs, and in the report
/// beside the pictures.
#[test]
fn notes_go_to_standard_error_and_into_the_report() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("m.obj"), ROOF.to_owned() + "l 1 2\n").unwrap();
    let text = "[image]\nwidth = 8\nheight = 8\n[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"\n";
    fs::write(folder.path().join("s.toml"), text).unwrap();
    let mut program = crate::common::fixpath();
    program.current_dir(folder.path()).args(["render", "s.toml", "--out", "o"]);
    let outcome = program.args(["--pipelines", "exact-cartesian"]).output().unwrap();
    assert!(outcome.status.success());
    let told = String::from_utf8(outcome.stderr).unwrap();
    let passed = "note: m.obj: lines (`l`) ignored: 1, the first in line 13\n";
    assert!(told.contains(passed) && told.contains("note: m.obj: 15 of 15 corners"), "{told}");
    let report = fs::read_to_string(folder.path().join("o/figures.txt")).unwrap();
    assert!(report.ends_with(&told[told.find("note").unwrap()..]), "{report}");
}

/// Normals computed for a mesh without them, seen from above.
fn made_normals(mesh: &str, crease: &str, extra: &str) -> (Scene, Fragments) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("m.obj"), mesh).unwrap();
    let text = format!(
        "[image]\nwidth = 64\nheight = 64\n[camera]\neye = [0, 0, 5]\nup = [0, 1, 0]\n{extra}\n[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"\n{crease}"
    );
    let scene = Scene::parse(&text, &folder.path().join("s.toml")).unwrap();
    let f = traced(&scene);
    (scene, f)
}

/// A roof of two slopes of 45° with the ridge on the y axis. The left slope is cut into two
/// triangles, the right one into three of different sizes.
const ROOF: &str = "v -1 -1 -1\nv 0 -1 0\nv 0 1 0\nv -1 1 -1\nv 1 -1 -1\nv 1 1 -1\nv 0.25 -1 -0.25\nf 1 2 3\nf 1 3 4\nf 2 7 3\nf 7 5 3\nf 5 6 3\n";

#[test]
fn normals_are_made_by_angle_up_to_creases() {
    let slope = |x: f64| DVec3::new(x.signum(), 0.0, 1.0).normalize();
    // The ridge turns by 90°, which is above a crease of 89° but not above 90°.
    let (scene, sharp) = made_normals(ROOF, "crease_degrees = 89", "");
    assert!(!sharp.is_empty() && !sharp.face.contains(&CURVED), "planes stay flat");
    for i in 0..sharp.len() {
        let x = sharp.position[0][i];
        assert!((normal(&sharp, i) - slope(x)).length() < 1e-15, "{x}");
    }
    let mut notes = scene.notes()[0].clone();
    notes.replace_range(..notes.find("m.obj").unwrap(), "");
    expect!["m.obj: 15 of 15 corners have no normal: means of the triangles around each are used, up to edges of `crease_degrees` = 89 (`tangent-faceted` alone uses the triangles' own)"].assert_eq(&notes);

    // On the ridge each side contributes 90° at both ends, however it is cut: the normal is
    // straight up.
    let (_, round) = made_normals(ROOF, "crease_degrees = 90", "");
    for i in 0..round.len() {
        let [x, y, _] = [0, 1, 2].map(|axis| round.position[axis][i]);
        let n = normal(&round, i);
        assert!(n.y.abs() < 1e-15, "{x} {y}: {n}");
        if x < 0.0 {
            // Between the ridge (up) and the eaves (the slope's own normal).
            let expected = (DVec3::Z * (1.0 + x) - slope(x) * x).normalize();
            assert!((n - expected).length() < 1e-12, "{x} {y}: {n}");
        }
    }
}

/// If some corners of a triangle have normals, its side is theirs, also for computed normals at the
/// other corners.
#[test]
fn made_normals_are_on_the_side_of_those_given() {
    let square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 0.1\n";
    // The first has reversed corners; the cases lack normals at different corners.
    for (faces, lacks) in [
        ("f 4 3//1 2//1\nf 4//1 2//1 1//1\n", 1),
        ("f 4//1 3 2\nf 1 2 4//1\n", 4),
        ("f 4//1 3 2\nf 1 2 4\n", 5),
    ] {
        let (scene, f) = made_normals(&format!("{square}{faces}"), "", "");
        assert!(scene.notes()[0].contains(&format!("{lacks} of 6 corners")), "{faces}");
        assert!(f.len() > 400, "{faces}");
        assert!((0..f.len()).all(|i| normal(&f, i) == DVec3::Z), "{faces}");
        let faceted = traced(&scene.faceted().unwrap());
        assert_eq!((&faceted.pixel, &faceted.normal), (&f.pixel, &f.normal), "{faces}");
    }
}

#[test]
fn facets_leave_vertices_shared() {
    let (scene, _) = made_normals(ROOF, "crease_degrees = 30", "");
    assert_eq!(scene.assemble().unwrap().vertices.len(), 9, "two on each side of the ridge");
    let faceted = scene.faceted().unwrap();
    assert_eq!(faceted.assemble().unwrap().vertices.len(), 7);
    assert!(!traced(&faceted).face.contains(&CURVED));
    // The same seen from the other side of a mirror, where corners have the reverse order.
    let mirrored = "crease_degrees = 30\nscale = [-1, 1, 1]";
    let (scene, right) = made_normals(ROOF, mirrored, "");
    let left = traced(&scene.faceted().unwrap());
    assert!(left.len() > 500 && left.pixel == right.pixel);
    assert!((0..left.len()).all(|i| (normal(&left, i) - normal(&right, i)).length() < 1e-15));
    assert_eq!(scene.faceted().unwrap().assemble().unwrap().primitives().len(), 5);
    assert!(parse("[[object]]\nshape = \"cube\"").faceted().is_none());
}

#[test]
fn a_scene_has_limits_as_a_whole() {
    let folder = tempfile::tempdir().unwrap();
    // 1001 triangles, which in 1000 objects are 1 001 000.
    let triangles = "f 1/1/1 2/2/1 3/3/1\n".repeat(1001);
    fs::write(folder.path().join("m.obj"), format!("{SQUARE}{triangles}")).unwrap();
    let refused = |text: &str| {
        Scene::parse(text, &folder.path().join("s.toml")).map(|_| ()).unwrap_err().to_string()
    };
    let why = refused(&"[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"\n".repeat(1000));
    let expected = "s.toml, line 2998: more than 1000000 triangles in all objects together, the most that a scene may have: simplify the meshes or leave some out";
    assert!(why.ends_with(expected), "{why}");

    let objects = |materials: u32| -> String {
        let object = |i| {
            format!("[[object]]\nshape = \"cube\"\nmaterial = {{ exponent = {} }}\n", i % materials)
        };
        (0..200).map(object).collect()
    };
    assert_eq!(parse(&objects(64)).materials.len(), 200);
    let why = refused(&objects(65));
    let expected = "s.toml, line 193: more than 64 different materials, the most that a scene may have: let some objects share one";
    assert!(why.ends_with(expected), "{why}");
}

/// One face, repeated 50 000 times, gives the picture of one; faces that would all be tested by
/// every ray are refused before.
#[test]
fn faces_upon_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |mesh: &str, image: u32, eye: &str| {
        fs::write(folder.path().join("m.obj"), mesh).unwrap();
        let text = format!(
            "[image]\nwidth = {image}\nheight = {image}\n[camera]\neye = {eye}\nup = [0, 1, 0]\n[[object]]\nshape = \"mesh\"\nfile = \"m.obj\""
        );
        Scene::parse(&text, &folder.path().join("s.toml"))
    };
    let face = "f 1/1/1 2/2/1 3/3/1\n";
    let one = traced(&scene(&format!("{SQUARE}{face}"), 40, "[0, 0, 4]").unwrap());
    let many =
        traced(&scene(&format!("{SQUARE}{}", face.repeat(50_000)), 40, "[0, 0, 4]").unwrap());
    assert_eq!((many.pixel, many.face), (one.pixel, one.face));

    // Each slightly above the previous one, and seen from behind, where no ray is stopped.
    let mut pile = SQUARE.to_owned();
    for i in 1..=2000 {
        let z = f64::from(i) * 1e-6;
        writeln!(pile, "v -1 -1 {z}\nv 1 -1 {z}\nv 1 1 {z}\nf -3/1/1 -2/2/1 -1/3/1").unwrap();
    }
    assert!(scene(&pile, 40, "[0, 0, -4]").is_ok() && scene(&pile, 4096, "[0, 0, 4]").is_ok());
    let why = scene(&pile, 4096, "[0, 0, -2]").unwrap_err().to_string();
    let expected = "s.toml: faces lie so close together that the rays of a picture would test more than 8589934592 of them, the most that a picture may take: remove duplicates, or make the picture smaller than 4096 x 4096";
    assert!(why.ends_with(expected), "{why}");
}
