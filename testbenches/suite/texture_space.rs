//! Tangent-space set-up of whole scenes: bumps are the right way out on mirrored halves, errors are
//! separated, vertices are shared, frames feed other pipelines, and the standard tangent generator
//! serves as an independent reference.

use crate::common::fixpath;
use crate::readme::is_told;
use crate::scene::gltf_of;
use bevy_mikktspace::{Geometry, TangentSpace, generate_tangents};
use fixpath::measure::{BoundCheck, Inputs, quantize_inputs, sample_words};
use fixpath::picture::{Difference, PIXELS_PER_DEGREE, Picture};
use fixpath::render::{Frames, Pipeline, Rendered, render};
use fixpath::scene::{Light, Place, Scene, SharedVertex};
use fixpath::sim::batch::Program;
use fixpath::units::{Design, Sampler, Unit};
use glam::{DVec2, DVec3};
use serde_json::Map;
use std::collections::HashMap;
use std::fs;

fn pipelines(names: &[&str], frames: Frames, set: &[&str]) -> Vec<Pipeline> {
    let mut all: Vec<Pipeline> = names.iter().map(|name| Pipeline::named(name).unwrap()).collect();
    all.iter_mut().for_each(|pipeline| pipeline.frames = frames);
    let set: Vec<String> = set.iter().map(|&set| set.to_owned()).collect();
    Pipeline::set(&mut all, &set).unwrap();
    all
}

const BOTH: [&str; 2] = ["tangent-smooth", "tangent-faceted"];

fn set_up(scene: &Scene, names: &[&str], set: &[&str]) -> Rendered {
    render(scene, &pipelines(names, Frames::Float, set), false, &|_| ()).unwrap()
}

fn differ(a: &Picture, b: &Picture) -> Difference {
    Difference::between(a, b, PIXELS_PER_DEGREE).unwrap()
}

fn small(name: &str, side: u32) -> Scene {
    let mut scene = Scene::builtin(name).unwrap();
    (scene.image.width, scene.image.height) = (side, side);
    scene
}

/// The point of the scene `mirrored` that a pixel sees: orthographic from above, 2.1 high.
fn place(scene: &Scene, pixel: usize) -> Option<(f64, f64)> {
    let (width, height) = (scene.image.width as usize, scene.image.height as usize);
    let x = ((pixel % width) as f64 + 0.5) / width as f64 * 2.0 - 1.0;
    let y = 1.0 - ((pixel / width) as f64 + 0.5) / height as f64 * 2.0;
    let (x, y) = (1.05 * x, 1.05 * y);
    (x.abs() < 0.99 && y.abs() < 0.99).then_some((x, y))
}

/// Green light on the dome of `mirrored` at (x, y), from its formula and the height map, with the
/// surface's own derivatives along u and v; `relief` 0 leaves the bumps out.
fn on_dome(scene: &Scene, x: f64, y: f64, relief: f64) -> f64 {
    let (zx, zy) = (-1.2 * x * (1.0 - y * y), -1.2 * y * (1.0 - x * x));
    let normal = DVec3::new(-zx, -zy, 1.0).normalize();
    // u = |x| and v = 2 (y + 1).
    let along_u = (DVec3::new(1.0, 0.0, zx) * x.signum()).normalize();
    let along_v = DVec3::new(0.0, 1.0, zy);
    let along_v = (along_v - along_u * along_u.dot(along_v)).normalize();
    let (width, height) = scene.bumps.size();
    let (u, v) = (x.abs(), 2.0 * (y + 1.0));
    let column = (u * f64::from(width)).floor() as i64;
    let row = ((1.0 - v).rem_euclid(1.0) * f64::from(height)).floor() as i64;
    let at = |column: i64, row: i64| {
        let (column, row) =
            (column.rem_euclid(i64::from(width)), row.rem_euclid(i64::from(height)));
        scene.bumps.heights()[(row * i64::from(width) + column) as usize] * scene.bumps.scale()
    };
    let slope_u = 0.5 * (at(column + 1, row) - at(column - 1, row)) * relief;
    let slope_v = 0.5 * (at(column, row - 1) - at(column, row + 1)) * relief;
    let perturbed = (normal - along_u * slope_u - along_v * slope_v).normalize();
    let Place::Direction(light) = scene.lights[0].place else { panic!("a far light") };
    let half = (light + DVec3::Z).normalize();
    let material = &scene.materials[0];
    let texel = scene.texture.texels()[(row * i64::from(width) + column) as usize][1];
    let diffuse =
        scene.ambient * material.ambient + material.diffuse * perturbed.dot(light).max(0.0);
    let specular = material.specular * perturbed.dot(half).max(0.0).powi(material.exponent as i32);
    (diffuse.min(1.0) * f64::from(texel) + specular).min(1.0)
}

/// Correlation of a picture's relief with that of the heights, on the left half and on the right
/// one.
fn reliefs(scene: &Scene, picture: &Picture) -> [f64; 2] {
    let mut sums = [[0.0; 3]; 2];
    for (pixel, colour) in picture.pixels().iter().enumerate() {
        let Some((x, y)) = place(scene, pixel) else { continue };
        let flat = on_dome(scene, x, y, 0.0);
        let (is, should) = (f64::from(colour[1]) - flat, on_dome(scene, x, y, 1.0) - flat);
        let sums = &mut sums[usize::from(x > 0.0)];
        sums[0] += is * should;
        sums[1] += is * is;
        sums[2] += should * should;
    }
    sums.map(|[both, is, should]| both / (is * should).sqrt())
}

/// The fraction of pixels in which a picture, mirrored at x = 0, differs from another picture.
fn mirrored_apart(a: &Picture, b: &Picture) -> f64 {
    let width = a.width_px();
    let differ = |row: usize, column: usize| {
        let (a, b) =
            (a.pixels()[row * width + column], b.pixels()[row * width + width - 1 - column]);
        a.iter().zip(b).any(|(a, b)| (a - b).abs() > 2.0 / 255.0)
    };
    let rows = a.pixels().len() / width;
    let count = (0..rows).flat_map(|row| (0..width).map(move |column| (row, column)));
    count.filter(|(row, column)| differ(*row, *column)).count() as f64 / a.pixels().len() as f64
}

/// Both halves of the dome have the same texture, mirrored on the left. With `mirror=handed` its
/// bumps stand out on both halves, and the picture under a mirrored light is the mirrored picture.
/// With the patent's rule, and without any, the left half is wrong.
#[test]
fn bumps_stand_out_on_both_halves() {
    // At this size no pixel is on the border of a texel, where a picture and its mirror image see
    // different texels.
    let scene = small("mirrored", 194);
    let mut turned = scene.clone();
    let Place::Direction(light) = scene.lights[0].place else { panic!("a far light") };
    turned.lights[0].place = Place::Direction(DVec3::new(-light.x, light.y, light.z));
    for (mirror, right) in [("handed", true), ("printed", false), ("off", false)] {
        let set = format!("mirror={mirror}");
        let [a, b] = [&scene, &turned].map(|scene| set_up(scene, &BOTH, &[&set]));
        for (a, b) in a.shots.iter().zip(&b.shots) {
            let what = format!("{mirror} {}", a.pipeline.name);
            let setup = a.setup.as_ref().unwrap();
            assert_eq!((setup.mirrored * 2, setup.degenerate), (setup.sharing.primitives, 0));
            let [left, other] = reliefs(&scene, &a.picture);
            let apart = mirrored_apart(&a.picture, &b.picture);
            println!("{what}: {left:.4} {other:.4}, {apart:.5}");
            // Facets add shading of their own, which isn't relief.
            let least = if a.pipeline.name == "tangent-smooth" { 0.99 } else { 0.9 };
            assert!(other > least, "{what}: {other}");
            assert_eq!(left > least, right, "{what}: {left}");
            assert_eq!(apart < 0.002, right, "{what}: {apart}");
            assert!(right || apart > 0.02, "{what}: {apart}");
            assert!(right || left < 0.9, "{what}: {left}");
        }
    }
}

/// Arithmetic and algorithm errors are separate: word lengths change only the first, tessellation
/// only the second.
#[test]
fn arithmetic_and_algorithm_are_told_apart() {
    let fine = [
        "position_frac_bits=17",
        "uv_frac_bits=17",
        "component_bits=16",
        "vector_bits=20",
        "out_frac_bits=18",
        "norm_bits=20",
        "dot_frac_bits=22",
        "root_addr_bits=9",
        "root_frac_bits=20",
    ];
    let coarse = [
        "position_frac_bits=6",
        "uv_frac_bits=8",
        "component_bits=8",
        "vector_bits=8",
        "out_frac_bits=8",
    ];
    for name in ["plane", "cube", "sphere", "mirrored"] {
        let scene = small(name, 96);
        let [coarse, usual, fine] = [&coarse[..], &[], &fine].map(|set| set_up(&scene, &BOTH, set));
        for ((coarse, usual), fine) in coarse.shots.iter().zip(&usual.shots).zip(&fine.shots) {
            let what = format!("{name} {}", coarse.pipeline.name);
            let flows = [coarse, usual, fine].map(|shot| &shot.setup.as_ref().unwrap().flow);
            // Scales are powers of two, but different centres round differently.
            for flow in flows {
                assert!(differ(flow, flows[1]).mean < 1e-6, "{what}");
            }
            let [coarse, usual, fine] =
                [coarse, usual, fine].map(|shot| differ(&shot.picture, flows[1]).mean * 255.0);
            println!("{what}: {coarse:.5} {usual:.5} {fine:.5}");
            assert!(fine < usual && 4.0 * usual < coarse, "{what}: {coarse} {usual} {fine}");
            assert!(usual < 0.05, "{what}: {usual}");
        }
    }
    // With flat faces, distant light and a distant eye there is nothing to interpolate.
    let mut scene = small("cube", 96);
    scene.camera.projection = fixpath::scene::Projection::Orthographic { height: 4.0 };
    scene.lights =
        vec![Light { place: Place::Direction(DVec3::new(0.6, -0.64, 0.48)), intensity: 1.0 }];
    let rendered = set_up(&scene, &BOTH, &[]);
    for shot in &rendered.shots {
        let algorithm = differ(&shot.setup.as_ref().unwrap().flow, &rendered.golden);
        // A place on a texel's border may fall on its other side.
        assert!(algorithm.mean < 1e-5, "{}: {}", shot.pipeline.name, algorithm.mean);
    }
    // A lamp beside a plane: with twice as many squares to a side, the difference is a quarter.
    let mut scene = small("plane", 96);
    scene.lights =
        vec![Light { place: Place::Position(DVec3::new(0.3, -0.4, 0.9)), intensity: 1.0 }];
    let mean = |parts: u32| {
        let mut scene = scene.clone();
        scene.emboss.tessellation = parts;
        let rendered = set_up(&scene, &BOTH[..1], &[]);
        differ(&rendered.shots[0].setup.as_ref().unwrap().flow, &rendered.golden).mean
    };
    let means = [4, 8, 16].map(mean);
    println!("{means:?}");
    for pair in means.windows(2) {
        assert!((3.0..5.5).contains(&(pair[0] / pair[1])), "{means:?}");
    }
}

/// The meshes of the golden and of the flow compute texture coordinates with the same arithmetic:
/// where every other pixel is on a border of texels, both see the same texel.
#[test]
fn texels_on_borders_are_those_of_the_golden() {
    let rendered = set_up(&small("mirrored", 192), &BOTH[..1], &[]);
    let flow = &rendered.shots[0].setup.as_ref().unwrap().flow;
    let algorithm = differ(flow, &rendered.golden).max.difference * 255.0;
    println!("{algorithm}");
    assert!(algorithm < 1.0, "{algorithm}");
}

/// An object has words of its own scale: a small dome in front of a plane 20000 times as large is
/// as near to its flow as it is alone, and so are its frames.
#[test]
fn a_small_object_beside_a_large_one_keeps_its_digits() {
    let text = |large: &str| {
        format!(
            "[image]\nwidth = 96\nheight = 96\n[camera]\neye = [0, 0, 4]\nup = [0, 1, 0]\nfov_degrees = 30\n[[light]]\n\
             direction = [1, 1, 2]\n[height]\nsource = \"wood\"\nwidth = 64\nheight = 64\nscale = 2\n{large}\
             [[object]]\nshape = \"mesh\"\nsource = \"shell\"\n"
        )
    };
    let scene = |large: &str| Scene::parse(&text(large), "scene.toml".as_ref()).unwrap();
    let alone = scene("");
    let beside = scene("[[object]]\nshape = \"plane\"\ntranslate = [0, 0, -1]\nscale = 20000\n");
    let [alone, beside] = [alone, beside].map(|scene| {
        let [shot] = &set_up(&scene, &BOTH[..1], &[]).shots[..] else { panic!("one shot") };
        let setup = shot.setup.as_ref().unwrap();
        let arithmetic = differ(&shot.picture, &setup.flow).max.difference * 255.0;
        let framed = pipelines(&["exact-cartesian"], Frames::Setup, &[]);
        let framed = render(&scene, &framed, false, &|_| ()).unwrap();
        let frames = differ(&framed.shots[0].picture, &framed.golden).max.difference * 255.0;
        println!("{arithmetic} {frames} {} {}", setup.degenerate, setup.position_step);
        assert_eq!(setup.degenerate, 0);
        (arithmetic, frames, setup.position_step)
    });
    assert!(beside.0 < 1.0 && beside.1 < 2.0 * alone.1, "{alone:?} {beside:?}");
    // The report shows the coarsest step.
    assert!(beside.2 > 1e3 * alone.2, "{alone:?} {beside:?}");
}

/// A wavy sheet: points, normals, uv, and the indices of a list and of one stitched strip.
type Sheet = (Vec<(DVec3, DVec3, DVec2)>, Vec<u16>, Vec<u16>);

fn sheet() -> Sheet {
    let (columns, rows) = (10u16, 8u16);
    let mut vertices = Vec::new();
    for j in 0..=rows {
        for i in 0..=columns {
            let (x, y) = (f64::from(i) / 5.0 - 1.0, f64::from(j) / 4.0 - 1.0);
            let point = DVec3::new(x, y, 0.2 * (2.0 * x).sin() * y.cos());
            let (zx, zy) = (0.4 * (2.0 * x).cos() * y.cos(), -0.2 * (2.0 * x).sin() * y.sin());
            // A rotated and skewed texture.
            let uv = DVec2::new(0.3 * x + 0.2 * y, 0.1 * x - 0.4 * y) + 0.5;
            vertices.push((point, DVec3::new(-zx, -zy, 1.0).normalize(), uv));
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
    (vertices, list, strip)
}

const SHEET_SCENE: &str = "[image]\nwidth = 96\nheight = 96\n[camera]\neye = [1, -1.5, 3.5]\nfov_degrees = 36\n[[light]]\nkind = \"point\"\nposition = [-1, 1, 2]\n[texture]\nsource = \"wood\"\nwidth = 64\nheight = 64\n[height]\nsource = \"wood\"\nwidth = 64\nheight = 64\nscale = 3\n[[object]]\nshape = \"mesh\"\nfile = \"sheet.gltf\"\n";

/// Strips and fans give the picture of the list, with the vertex operations that sharing leaves.
#[test]
fn strips_and_fans_are_set_up_as_lists() {
    let folder = tempfile::tempdir().unwrap();
    let (vertices, list, strip) = sheet();
    let scene = |gltf: &str| {
        fs::write(folder.path().join("sheet.gltf"), gltf).unwrap();
        Scene::parse(SHEET_SCENE, &folder.path().join("scene.toml")).unwrap()
    };
    let by_list = set_up(&scene(&gltf_of(&vertices, &[(4, Some(&list))])), &BOTH, &[]);
    // A fan about the first vertex of the last row's first square, as one more draw: it repeats a
    // square of the strip.
    let fan = [0u16, 1, 12, 11];
    let strip_scene = scene(&gltf_of(&vertices, &[(5, Some(&strip)), (6, Some(&fan))]));
    let by_strip = set_up(&strip_scene, &BOTH, &[]);
    for (a, b) in by_list.shots.iter().zip(&by_strip.shots) {
        // Other corners come first, so words round differently.
        let apart = differ(&a.picture, &b.picture);
        assert!(apart.max.difference < 0.01, "{}: {}", a.pipeline.name, apart.max.difference);
        let algorithm = differ(&b.setup.as_ref().unwrap().flow, &by_strip.golden);
        assert!(algorithm.mean < 0.01, "{}", algorithm.mean);
        let sharing = b.setup.as_ref().unwrap().sharing;
        assert_eq!((sharing.vertices, sharing.primitives), (99, 162));
        assert_eq!((sharing.vertex_operations, sharing.replicated_operations), (99, 486));
        assert_eq!(sharing.indices, (strip.len() + fan.len()) as u64);
        assert_eq!((sharing.stitches, sharing.bytes), (28, 99 * 32 + 4 * sharing.indices));
    }
    // Reported as text and as JSON.
    fs::write(folder.path().join("scene.toml"), SHEET_SCENE).unwrap();
    let run = |more: &[&str]| {
        let mut command = fixpath();
        command.current_dir(folder.path()).args(["render", "scene.toml", "--out", "out"]);
        command.args(["--pipelines", "tangent-smooth,exact-polar"]).args(more);
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let told = run(&[]);
    assert!(told.contains("99 vertices, 162 triangles of 194 indices, 28 more that only stitch; with shared vertices the vertex stage works on 99 vertices, with separate ones on 486"), "{told}");
    let value: serde_json::Value = serde_json::from_str(&run(&["--json"])).unwrap();
    let first = &value["pipelines"][0];
    assert_eq!(first["setup"]["sharing"]["vertex_operations"], 99);
    assert!(first["setup"]["per_primitive"]["datapath"]["multipliers"].as_u64().unwrap() > 0);
    assert!(first["arithmetic"]["mean"].as_f64() < first["algorithm"]["mean"].as_f64());
    assert!(value["pipelines"][1]["setup"].is_null());
    for file in ["tangent-smooth_flow.png", "tangent-smooth_arithmetic.png", "sheet.png"] {
        assert!(folder.path().join("out").join(file).exists(), "{file}");
    }
    for (args, why) in [
        (&["-p", "frame=faceted"][..], "comes from the name of the tangent pipeline"),
        (&["-p", "lights=2"], "comes from the name of the tangent pipeline"),
        (&["--specialise"], "leave it out for an emboss or a tangent-space set-up"),
        (&["--ladder"], "leave tangent pipelines out"),
        (&["--frames", "setup"], "has frames of its own"),
    ] {
        let mut command = fixpath();
        command.args(["render", "plane", "--out", "none", "--pipelines", "tangent-smooth"]);
        let output = command.args(args).output().unwrap();
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {told}");
        assert!(told.contains(why), "{args:?}: {told}");
    }
}

/// An octahedron without normals, with texture coordinates on request.
fn octahedron(uvs: bool) -> (tempfile::TempDir, Result<Scene, fixpath::error::Error>) {
    let folder = tempfile::tempdir().unwrap();
    let mut text = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n".to_owned();
    text.push_str("vt 0 0\nvt 1 0\nvt 0 1\n");
    for (a, b) in [(1, 2), (2, 3), (3, 4), (4, 1)] {
        let faces = if uvs {
            format!("f {a}/1 {b}/2 5/3\nf {b}/1 {a}/2 6/3\n")
        } else {
            format!("f {a} {b} 5\nf {b} {a} 6\n")
        };
        text.push_str(&faces);
    }
    fs::write(folder.path().join("m.obj"), text).unwrap();
    let scene = "[image]\nwidth = 64\nheight = 64\n[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"\ncrease_degrees = 90";
    let scene = Scene::parse(scene, &folder.path().join("s.toml"));
    (folder, scene)
}

/// Without normals, `tangent-faceted` alone shows facets of shared vertices. If another pipeline
/// needs vertex normals, all are compared with the smooth surface.
#[test]
fn a_mesh_without_normals_is_faceted_where_nothing_needs_them() {
    let (_folder, scene) = octahedron(true);
    let scene = scene.unwrap();
    let alone = set_up(&scene, &["tangent-faceted"], &[]);
    let setup = alone.shots[0].setup.as_ref().unwrap();
    assert_eq!(
        setup.sharing.vertices,
        4 * 2 + 2,
        "each point with each of its texture coordinates"
    );
    // Three faces are visible, each lit evenly: except for the highlight, there are three colours.
    let mut codes = alone.golden.to_srgb8().codes().to_vec();
    codes.sort_unstable();
    codes.dedup();
    let faceted = codes.len();
    let both = set_up(&scene, &BOTH, &[]);
    let mut codes = both.golden.to_srgb8().codes().to_vec();
    codes.sort_unstable();
    codes.dedup();
    assert!(faceted < codes.len(), "{faceted} {}", codes.len());
    // The flow of facets is the same for either reference.
    assert_eq!(alone.shots[0].picture.pixels(), both.shots[1].picture.pixels());
    let algorithm = |shot: &fixpath::render::Shot, golden| {
        differ(&shot.setup.as_ref().unwrap().flow, golden).max.difference
    };
    assert!(algorithm(&both.shots[1], &both.golden) > 0.1);
    assert!(algorithm(&alone.shots[0], &alone.golden) < 0.02);
}

#[test]
fn a_set_up_without_texture_coordinates_is_refused() {
    let (_folder, scene) = octahedron(false);
    let scene = scene.unwrap();
    for (names, frames, by) in [
        (&["tangent-faceted"][..], Frames::Float, "`tangent-faceted`"),
        (&["corrected", "tangent-smooth"], Frames::Float, "`tangent-smooth`"),
        (&["corrected"], Frames::Setup, "the setup of frames"),
    ] {
        let refused = render(&scene, &pipelines(names, frames, &[]), false, &|_| ());
        let why = refused.unwrap_err().to_string();
        let expected = format!(
            "m.obj, line 10: triangle 0 (they count from 0) has no texture coordinates, from which {by} computes T: unwrap the mesh, or use a pipeline without it"
        );
        assert!(why.ends_with(&expected), "{why}");
    }
    let shaded = render(&scene, &pipelines(&["corrected"], Frames::Float, &[]), false, &|_| ());
    let shaded = shaded.unwrap();
    assert!(shaded.covered > 300);
    assert!(differ(&shaded.shots[0].picture, &shaded.golden).mean < 0.01);
}

/// The polar and the Cartesian pipeline on frames of the set-up are as near to the golden as on
/// floating-point frames, mirrored or not. The patent's rule for mirrored textures shows through.
#[test]
fn other_pipelines_take_frames_of_the_set_up() {
    let folder = tempfile::tempdir().unwrap();
    let (vertices, _, strip) = sheet();
    fs::write(folder.path().join("sheet.gltf"), gltf_of(&vertices, &[(5, Some(&strip))])).unwrap();
    let wavy = Scene::parse(SHEET_SCENE, &folder.path().join("scene.toml")).unwrap();
    assert!(!wavy.facts().right_handed);
    let names = ["exact-polar", "exact-cartesian"];
    let linear = ["scheme=linear", "light_scheme=linear"];
    for (what, scene) in
        [("mirrored", small("mirrored", 128)), ("wavy", wavy), ("cube", small("cube", 96))]
    {
        let by = |frames, set: &[&str]| {
            let set = [&linear[..], set].concat();
            let rendered = render(&scene, &pipelines(&names, frames, &set), true, &|_| ()).unwrap();
            let of = |shot: &fixpath::render::Shot| {
                (differ(&shot.picture, &rendered.golden).max.difference * 255.0, shot.behind.len())
            };
            rendered.shots.iter().map(of).collect::<Vec<_>>()
        };
        let float = by(Frames::Float, &[]);
        let setup = by(Frames::Setup, &[]);
        let coarse = by(Frames::Setup, &["component_bits=6"]);
        let printed = by(Frames::Setup, &["mirror=printed"]);
        println!("{what}: {float:?} {setup:?} {coarse:?} {printed:?}");
        for i in 0..names.len() {
            assert_eq!((float[i].1, setup[i].1), (0, 1));
            assert!(setup[i].0 < float[i].0 + 0.6, "{what} {}: {setup:?}", names[i]);
            // The cube's faces lie along the axes, and so do its frames in any width.
            assert!(what == "cube" || coarse[i].0 > 2.0 * setup[i].0, "{what}: {coarse:?}");
            assert_eq!(what != "cube", printed[i].0 > 20.0, "{what}: {printed:?}");
        }
    }
}

/// A mesh in the form that the standard generator reads.
struct Given<'a> {
    vertices: &'a [SharedVertex],
    triangles: &'a [[u32; 3]],
    tangents: Vec<[Option<TangentSpace>; 3]>,
}

impl Given<'_> {
    fn vertex(&self, face: usize, vert: usize) -> &SharedVertex {
        &self.vertices[self.triangles[face][vert] as usize]
    }
}

impl Geometry for Given<'_> {
    fn num_faces(&self) -> usize {
        self.triangles.len()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, vert: usize) -> [f32; 3] {
        self.vertex(face, vert).position.to_array().map(|x| x as f32)
    }

    fn normal(&self, face: usize, vert: usize) -> [f32; 3] {
        self.vertex(face, vert).normal.to_array().map(|x| x as f32)
    }

    fn tex_coord(&self, face: usize, vert: usize) -> [f32; 2] {
        self.vertex(face, vert).uv.to_array().map(|x| x as f32)
    }

    fn set_tangent(&mut self, space: Option<TangentSpace>, face: usize, vert: usize) {
        self.tangents[face][vert] = space;
    }
}

fn standard(vertices: &[SharedVertex], triangles: &[[u32; 3]]) -> Vec<[Option<TangentSpace>; 3]> {
    let tangents = vec![[None; 3]; triangles.len()];
    let mut given = Given { vertices, triangles, tangents };
    generate_tangents(&mut given).unwrap();
    given.tangents
}

/// The unit's result for a corner: T, whether N × T is B, and whether it has no frame.
#[derive(Clone, Copy)]
struct Corner {
    tangent: DVec3,
    handed: bool,
    degenerate: bool,
}

/// The unit's words for rows of input words.
fn bit_true(design: &Design, rows: &[Vec<i64>]) -> Vec<Corner> {
    let netlist = &design.netlist;
    let nodes: Vec<_> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(netlist, &nodes);
    let columns: Vec<Vec<i64>> = (0..netlist.inputs().len())
        .map(|port| rows.iter().map(|row| row[port]).collect())
        .collect();
    let slices: Vec<&[i64]> = columns.iter().map(Vec::as_slice).collect();
    let mut out = vec![Vec::new(); nodes.len()];
    program.runner().run(&program, &slices, &mut out).unwrap();
    let at = |name: &str, i: usize| {
        let port = netlist.outputs().iter().position(|output| output.name == name).unwrap();
        netlist.node(nodes[port]).format.value(out[port][i])
    };
    let vector = |name: &str, i: usize| {
        DVec3::from_array(["x", "y", "z"].map(|axis| at(&format!("{name}_{axis}"), i)))
    };
    let corner = |i: usize| {
        let (t, b, n) = (vector("t", i), vector("b", i), vector("n", i));
        let handed = n.cross(t).dot(b) > 0.0;
        let degenerate = at("degenerate", i) != 0.0;
        assert!(degenerate || handed == (at("mirrored", i) == 0.0));
        Corner { tangent: t, handed, degenerate }
    };
    (0..rows.len()).map(corner).collect()
}

fn value_of(design: &Design, row: &[i64], name: &str) -> f64 {
    let netlist = &design.netlist;
    let port = (0..row.len()).find(|port| netlist.input_name(*port) == name).unwrap();
    netlist.node(netlist.inputs()[port]).format.value(row[port])
}

/// The triangle in a row of words, with one normal for all corners.
fn triangle(design: &Design, row: &[i64]) -> [SharedVertex; 3] {
    let value = |name: String| value_of(design, row, &name);
    let vector =
        |name: &str| DVec3::from_array(["x", "y", "z"].map(|a| value(format!("{name}_{a}"))));
    [0, 1, 2].map(|k| SharedVertex {
        position: vector(&format!("p{k}")),
        normal: vector("normal"),
        uv: DVec2::new(value(format!("uv{k}_u")), value(format!("uv{k}_v"))),
    })
}

/// On a single triangle nothing is averaged. So the standard generator's tangent is the patent's,
/// at right angles to N as with `basis=orthonormal`, up to the words and its own `f32`. The unit
/// roundoff is u = 2^-24. Words are exact in `f32`, and so are edges. `dv2 e1 - dv1 e2` has two
/// rounded products and a rounded difference: an error of 2.1 u (|dv2| |e1| + |dv1| |e2|).
/// `T - N (N·T)` and three normalisations take 24 u of |T|. Both count more, the shorter the part
/// of T across N is. As its N, from words, doesn't have length 1, a part (1 - |N|²) (N·T) of T
/// along N remains. The unit's T is off by its stated bound.
#[test]
fn lone_triangles_have_the_standard_tangent() {
    let design = Unit::find("tangent").unwrap().values::<&str>(&[]).unwrap().build().unwrap();
    let check = BoundCheck::new(&design).unwrap();
    let stated = check.stated.iter().find(|bound| bound.quantity == "tangent").unwrap().bound;
    let u = 2f64.powi(-24);
    for sampler in [Sampler::Lit, Sampler::Sphere] {
        let rows = sample_words(&design, &Inputs { sampler, samples: 4096, seed: 9 }).unwrap();
        let corners = bit_true(&design, &rows);
        let (mut judged, mut mirrored, mut worst) = (0, 0, 0f64);
        for (row, corner) in rows.iter().zip(corners) {
            let given = triangle(&design, row);
            let [a, b, c] = given;
            let (e1, e2) = (b.position - a.position, c.position - a.position);
            let (d1, d2) = (b.uv - a.uv, c.uv - a.uv);
            let along = d2.y * e1 - d1.y * e2;
            let products = (d1.x * d2.y).abs() + (d2.x * d1.y).abs();
            if corner.degenerate || d1.perp_dot(d2).abs() <= 3.0 * u * products {
                continue; // no frame, or a sign that is lost in f32
            }
            let [Some(space), ..] = standard(&given, &[[0, 1, 2]])[0] else { panic!("no tangent") };
            assert_eq!(space.is_orientation_preserving(), corner.handed, "{given:?}");
            let normal = a.normal;
            let cos = normal.normalize().dot(along.normalize()).abs();
            let across = (1.0 - cos * cos).sqrt();
            let lost = 2.1 * u * (d2.y.abs() * e1.length() + d1.y.abs() * e2.length());
            let length = (1.0 - normal.length_squared()).abs() * cos;
            let theirs = (lost / along.length() + 24.0 * u + length) / across;
            let tolerance = 1.01 * (stated / normal.length() + theirs);
            if tolerance > 0.1 {
                continue; // nearly along N: a direction of noise in f32
            }
            let theirs = DVec3::from_array(space.tangent().map(f64::from));
            let off = (corner.tangent.normalize() - theirs).length();
            assert!(off <= tolerance, "{off:e} > {tolerance:e}: {given:?}");
            worst = worst.max(off / tolerance);
            judged += 1;
            mirrored += u32::from(!corner.handed);
        }
        println!("{judged} judged, {mirrored} mirrored, {worst}");
        assert!(judged > 3500 && (1000..3000).contains(&mirrored), "{judged} {mirrored}");
        assert!(worst > 0.01, "{worst}");
    }
}

/// On meshes, handedness equals that of the standard generator on every triangle. Its tangents are
/// averaged per corner over triangles that share vertex and handedness, each made orthogonal to N
/// and weighted by the corner's angle. The patent has one tangent per triangle. So its tangent is
/// no farther from ours than ours are from each other among those triangles: a cone of less than
/// half a turn contains every mean of vectors in it. On a plane there is only one tangent, and both
/// agree. On the sphere, triangles at a pole meet in a fan, each with its own tangent.
#[test]
fn meshes_have_the_standard_handedness() {
    let set = ["position_int_bits=2", "position_frac_bits=18", "uv_int_bits=3", "uv_frac_bits=17"];
    let design = Unit::find("tangent").unwrap().values(&set).unwrap().build().unwrap();
    let check = BoundCheck::new(&design).unwrap();
    let stated = check.stated.iter().find(|bound| bound.quantity == "tangent").unwrap().bound;
    let folder = tempfile::tempdir().unwrap();
    let (vertices, _, strip) = sheet();
    fs::write(folder.path().join("sheet.gltf"), gltf_of(&vertices, &[(5, Some(&strip))])).unwrap();
    let wavy = Scene::parse(SHEET_SCENE, &folder.path().join("scene.toml")).unwrap();
    let builtin = |name: &str| Scene::builtin(name).unwrap();
    let mut told = Map::new();
    for (name, scene) in [
        ("plane", builtin("plane")),
        ("cube", builtin("cube")),
        ("sphere", builtin("sphere")),
        ("mirrored", builtin("mirrored")),
        ("wavy", wavy),
    ] {
        let mesh = scene.assemble().unwrap();
        let triangles = mesh.primitives();
        let netlist = &design.netlist;
        // Corners as columns, then as words, and back, so that both see the same numbers.
        let value = |at: usize, port: &str| -> f64 {
            let (name, axis) = port.rsplit_once('_').unwrap();
            let axis = ["x", "y", "z", "u", "v"].iter().position(|a| *a == axis).unwrap();
            let of = |k: usize| &mesh.vertices[triangles[at / 3][k] as usize];
            match name {
                "normal" => of(at % 3).normal[axis],
                "p0" | "p1" | "p2" => of(name[1..].parse().unwrap()).position[axis],
                "uv0" | "uv1" | "uv2" => of(name[2..].parse().unwrap()).uv[axis - 3],
                _ => 0.0,
            }
        };
        let columns: Vec<Vec<f64>> = (0..netlist.inputs().len())
            .map(|port| {
                (0..3 * triangles.len()).map(|at| value(at, netlist.input_name(port))).collect()
            })
            .collect();
        let mut words = Vec::new();
        quantize_inputs(netlist, &columns, &mut words).unwrap();
        let rows: Vec<Vec<i64>> = (0..3 * triangles.len())
            .map(|at| words.iter().map(|column| column[at]).collect())
            .collect();
        let corners = bit_true(&design, &rows);
        let mut vertices = mesh.vertices.clone();
        for (at, row) in rows.iter().enumerate() {
            vertices[triangles[at / 3][at % 3] as usize] = triangle(&design, row)[at % 3];
        }
        let spaces = standard(&vertices, triangles);
        // Corners grouped as the generator welds them.
        let key = |at: usize| {
            let v = &vertices[triangles[at / 3][at % 3] as usize];
            let bits = |x: f64| (x as f32).to_bits();
            (
                v.position.to_array().map(bits),
                v.normal.to_array().map(bits),
                v.uv.to_array().map(bits),
                corners[at].handed,
            )
        };
        let mut around: HashMap<_, Vec<usize>> = HashMap::new();
        (0..rows.len()).for_each(|at| around.entry(key(at)).or_default().push(at));
        let (mut most, mut mirrored) = (0f64, 0);
        for (at, corner) in corners.iter().enumerate() {
            assert!(!corner.degenerate, "{name} {at}");
            let space = spaces[at / 3][at % 3].unwrap();
            assert_eq!(space.is_orientation_preserving(), corner.handed, "{name} {at}");
            mirrored += usize::from(!corner.handed);
            let theirs = DVec3::from_array(space.tangent().map(f64::from));
            let angle = corner.tangent.angle_between(theirs);
            let others = around[&key(at)].iter();
            let cone = others
                .map(|other| corner.tangent.angle_between(corners[*other].tangent))
                .fold(0.0, f64::max);
            // Both ends of the cone are words. f32 is finer, except for N from words, whose length
            // isn't 1.
            let tolerance = 3.0 * stated + 2f64.powi(-13);
            assert!(angle <= cone + tolerance, "{name} {at}: {angle} > {cone} + {tolerance}");
            if ["plane", "cube"].contains(&name) {
                assert!(cone <= 2.1 * stated && angle <= tolerance, "{name}: {angle} {cone}");
            }
            most = most.max(angle);
        }
        let expected = match name {
            "mirrored" => corners.len() / 2,
            "wavy" => corners.len(),
            _ => 0,
        };
        assert_eq!(mirrored, expected, "{name}");
        assert!(["plane", "cube"].contains(&name) || most > 2.0 * stated, "{name}: {most}");
        if ["sphere", "mirrored"].contains(&name) {
            told.insert(name.to_owned(), format!("{:.1}", most.to_degrees()).into());
        }
    }
    is_told("standard_tangents_degrees", &told.into());
}
