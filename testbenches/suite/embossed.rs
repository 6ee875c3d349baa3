//! Embossed scenes: raised shapes look raised, fixed point stays near the golden, and hostile
//! scenes are refused.

use crate::common;
use fixpath::picture::{Difference, PIXELS_PER_DEGREE, Picture};
use fixpath::render::{EMBOSS_PIPELINES, Pipeline, Rendered, Shot, render};
use fixpath::scene::{Address, Filter, Light, LightSign, Place, Scene, Seen};
use glam::DVec3;
use rayon::ThreadPoolBuilder;
use std::fs;
use std::path::Path;

fn pipelines(set: &[&str]) -> Vec<Pipeline> {
    common::pipelines(&EMBOSS_PIPELINES, set)
}

fn embossed(scene: &Scene, set: &[&str]) -> Rendered {
    render(scene, &pipelines(set), false, &|_| ()).unwrap()
}

fn small(name: &str) -> Scene {
    let mut scene = Scene::builtin(name).unwrap();
    scene.image.width = (scene.image.width / 4).max(64);
    scene.image.height = (scene.image.height / 4).max(32);
    scene
}

fn difference(shot: &Shot, rendered: &Rendered) -> f64 {
    let golden = rendered.golden_of(shot);
    Difference::between(&shot.picture, golden, PIXELS_PER_DEGREE).unwrap().max.difference
}

/// Checks that a picture is within its bound, and that the bound is not idle.
fn within_the_bound(scene: &Scene, set: &[&str], context: &str) {
    let rendered = embossed(scene, set);
    assert!(rendered.covered > 500, "{context}: {}", rendered.covered);
    for shot in &rendered.shots {
        let known = shot.emboss.unwrap();
        let (bound, off) = (known.bound.unwrap(), known.displacement_max_texels);
        // The bound holds for the displacements as computed; those have a limit of their own.
        let most = if set.is_empty() { 2e-3 } else { 0.3 };
        assert!(off < most, "{context} {}: {off} texels", shot.pipeline.name);
        let seen = difference(shot, &rendered);
        assert!(seen <= bound, "{context} {}: {seen} above {bound}", shot.pipeline.name);
        assert!(seen > 0.05 * bound, "{context} {}: {seen}, {bound}", shot.pipeline.name);
    }
}

/// Green of a picture minus that of another.
fn relief(picture: &Picture, flat: &Picture) -> Vec<f64> {
    let pairs = picture.pixels().iter().zip(flat.pixels());
    pairs.map(|(a, b)| f64::from(a[1]) - f64::from(b[1])).collect()
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let sum = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    sum(a, b) / (sum(a, a) * sum(b, b)).sqrt()
}

fn reliefs(scene: &Scene) -> Vec<Vec<f64>> {
    let mut flat = scene.clone();
    flat.emboss.strength = 0.0;
    let (bumped, flat) = (embossed(scene, &[]), embossed(&flat, &[]));
    // For each golden and each picture. Flat ones are equal, whichever way they displace.
    let goldens = bumped.shots.iter().map(|shot| bumped.golden_of(shot));
    let pictures = bumped.shots.iter().map(|shot| &shot.picture);
    goldens.chain(pictures).map(|picture| relief(picture, &flat.golden)).collect()
}

/// On the plate a pixel is a texel: slopes that rise away from the light are bright in every
/// pipeline's picture.
#[test]
fn raised_letters_are_bright_towards_the_light() {
    let raised = Scene::builtin("lettering-raised").unwrap();
    let lowered = Scene::builtin("lettering-lowered").unwrap();
    assert_eq!((raised.image.width, raised.image.height), raised.bumps.size());
    let (width, height) = (512usize, 256usize);
    let at = |x: usize, y: usize| raised.bumps.heights()[y * width + x];
    // From the middle of a pixel to the upper left, where the light is.
    let rises: Vec<f64> = (0..width * height)
        .map(|i| {
            let (x, y) = (i % width, i / width);
            let (left, right) = ((x + width - 1) % width, (x + 1) % width);
            let (above, below) = ((y + height - 1) % height, (y + 1) % height);
            (at(left, y) - at(right, y)) + (at(x, above) - at(x, below))
        })
        .collect();
    let (up, down) = (reliefs(&raised), reliefs(&lowered));
    for (up, down) in up.iter().zip(&down) {
        assert!(correlation(up, &rises) < -0.9, "{}", correlation(up, &rises));
        assert!(correlation(down, &rises) > 0.9);
    }
    // The shadings are mirror images, except for the clamp at 0.
    let (up, down) = (&up[0], &down[0]);
    let apart = up.iter().zip(down).filter(|(up, down)| (*up + *down).abs() > 1e-6).count();
    assert!(apart < up.len() / 100, "{apart} of {}", up.len());
    // The patent's sign swaps raised and sunken.
    let mut turned = raised.clone();
    turned.emboss.light_sign = LightSign::VertexLight;
    for relief in reliefs(&turned) {
        assert!(correlation(&relief, &rises) > 0.9);
    }
}

/// CT points along growing t, and Ks and Kt are positive except for a mirrored texture. By the
/// extension's own equations both displacements lead away from the light, so the displaced height
/// minus the undisplaced one is bright toward it.
#[test]
fn nv_displaces_away_from_the_light() {
    let scene = Scene::builtin("lettering-raised").unwrap();
    let rendered = embossed(&scene, &[]);
    let [toward, away] = &rendered.shots[..] else { panic!("two pipelines") };
    assert_eq!(
        (toward.pipeline.name.as_str(), away.pipeline.name.as_str()),
        ("emboss-gx", "emboss-nv")
    );
    assert!(toward.golden.is_none());
    // Alone, its golden is the only one.
    let alone = render(&scene, &pipelines(&[])[1..], false, &|_| ()).unwrap();
    assert_eq!(&alone.golden, rendered.golden_of(away));
    assert_ne!(alone.golden, rendered.golden);
    // From the map alone: the light is up, to the left, and toward the eye.
    let (width, height) = (512i64, 256i64);
    let light = DVec3::new(-1.0, 1.0, 1.0).normalize();
    let texel = |x: i64, y: i64| {
        let (x, y) = (x.rem_euclid(width), y.rem_euclid(height));
        (scene.bumps.heights()[(y * width + x) as usize] * 255.0).round() / 255.0
    };
    let sample = |x: f64, y: f64| {
        let (i, j) = (x.floor() as i64, y.floor() as i64);
        let (a, b) = (x - x.floor(), y - y.floor());
        let along = |j| (1.0 - a) * texel(i, j) + a * texel(i + 1, j);
        (1.0 - b) * along(j) + b * along(j + 1)
    };
    let (strength, gain) = (scene.emboss.strength, 2f64.powi(scene.emboss.gain_log2));
    for i in (0..width * height).step_by(61) {
        let (x, y) = ((i % width) as f64, (i / width) as f64);
        // Rows count downwards.
        let there = sample(x - strength * light.x, y + strength * light.y);
        let diffuse = (0.1 + 0.9 * light.z) * f64::from(scene.texture.texels()[i as usize][0]);
        let should = (diffuse + gain * (there - sample(x, y))).clamp(0.0, 1.0);
        let is = f64::from(alone.golden.pixels()[i as usize][0]);
        assert!((is - should).abs() < 1e-6, "{x} {y}: {is} for {should}");
    }
}

/// The golden derived again, from only the map and the light's direction.
#[test]
fn the_golden_is_the_formula() {
    for (address, filter) in [(Address::Wrap, Filter::Bilinear), (Address::Clamp, Filter::Nearest)]
    {
        let mut scene = Scene::builtin("lettering-raised").unwrap();
        scene.emboss.address = [address; 2];
        scene.emboss.filter = filter;
        scene.emboss.strength = 2.75;
        scene.emboss.gain_log2 = -1;
        let rendered = embossed(&scene, &[]);
        let (width, height) = (512i64, 256i64);
        let light = DVec3::new(-1.0, 1.0, 1.0).normalize();
        let texel = |x: i64, y: i64| {
            let (x, y) = match address {
                Address::Wrap => (x.rem_euclid(width), y.rem_euclid(height)),
                Address::Clamp => (x.clamp(0, width - 1), y.clamp(0, height - 1)),
            };
            (scene.bumps.heights()[(y * width + x) as usize] * 255.0).round() / 255.0
        };
        // x to the right, y downwards, pixel centres at integers.
        let sample = |x: f64, y: f64| {
            if filter == Filter::Nearest {
                return texel((x + 0.5).floor() as i64, (y + 0.5).floor() as i64);
            }
            let (i, j) = (x.floor(), y.floor());
            let (a, b) = (x - i, y - j);
            let (i, j) = (i as i64, j as i64);
            (1.0 - a) * (1.0 - b) * texel(i, j)
                + a * (1.0 - b) * texel(i + 1, j)
                + (1.0 - a) * b * texel(i, j + 1)
                + a * b * texel(i + 1, j + 1)
        };
        for i in (0..width * height).step_by(61) {
            let (x, y) = (i % width, i / width);
            let (sx, sy) = (x as f64, y as f64);
            let there = sample(sx + 2.75 * light.x, sy - 2.75 * light.y);
            let diffuse = 0.1 + 0.9 * light.z;
            let colour = f64::from(scene.texture.texels()[i as usize][0]);
            let should = (diffuse * colour + 0.5 * (sample(sx, sy) - there)).clamp(0.0, 1.0);
            let is = f64::from(rendered.golden.pixels()[i as usize][0]);
            assert!((is - should).abs() < 1e-6, "{filter:?} {x} {y}: {is} for {should}");
        }
    }
}

/// Every built-in scene with both pipelines, fine and coarse.
#[test]
fn pictures_are_within_their_bounds() {
    for name in
        ["lettering-raised", "lettering-lowered", "brick", "light-orbit", "plane", "cube", "sphere"]
    {
        let scene = small(name).frame(0);
        for set in [
            &[][..],
            &["component_bits=8", "root_addr_bits=3", "fraction_bits=3"],
            &["frac_bits=10", "rounding=floor", "fraction_bits=12"],
            &["channel_bits=10", "position_frac_bits=8"],
        ] {
            within_the_bound(&scene, set, &format!("{name} {set:?}"));
        }
    }
    for frame in [3, 6, 11] {
        within_the_bound(&small("light-orbit").frame(frame), &[], &format!("frame {frame}"));
    }
}

/// Eight lights, near and far, clamped maps, and every gain.
#[test]
fn many_lights_and_both_addresses_are_within_their_bounds() {
    let mut scene = small("sphere");
    for n in 1..8 {
        let angle = f64::from(n);
        let place = DVec3::new(3.0 * angle.cos(), 3.0 * angle.sin(), angle - 4.0);
        let place =
            if n % 2 == 0 { Place::Position(place) } else { Place::Direction(place.normalize()) };
        scene.lights.push(Light { place, intensity: 0.2 });
    }
    let one = embossed(&small("sphere"), &[]);
    for gain in [-3, 0, 2] {
        scene.emboss.gain_log2 = gain;
        for address in [[Address::Wrap, Address::Clamp], [Address::Clamp, Address::Wrap]] {
            scene.emboss.address = address;
            within_the_bound(&scene, &[], &format!("{gain} {address:?}"));
        }
    }
    assert_ne!(embossed(&scene, &[]).golden, one.golden);
}

/// Using the wrong vector for s is detected in either setting.
#[test]
fn tangent_and_binormal_are_told_apart() {
    let scene = small("brick");
    let right = embossed(&scene, &[]);
    let mut wrong = pipelines(&[]);
    wrong[0].assignments.push("s_vector=binormal".to_owned());
    wrong[1].assignments.push("s_vector=tangent".to_owned());
    let wrong = render(&scene, &wrong, false, &|_| ()).unwrap();
    assert_eq!(right.golden, wrong.golden);
    for (right_shot, wrong_shot) in right.shots.iter().zip(&wrong.shots) {
        let (near, far) = (difference(right_shot, &right), difference(wrong_shot, &wrong));
        assert!(far > 10.0 * near, "{near} {far}");
        let texels = wrong_shot.emboss.unwrap().displacement_max_texels;
        assert!(texels > 0.5, "{texels}");
    }
}

/// A plate turned over like a page, with the light on the other side, gives the mirrored picture.
#[test]
fn a_mirrored_plate_is_a_mirrored_picture() {
    let text = |mirrored: bool| {
        let side = if mirrored { -1.0 } else { 1.0 };
        let text = format!(
            "[image]\nwidth = 128\nheight = 64\n[camera]\nprojection = \"orthographic\"\neye = [0, 0, 4]\nup = [0, 1, 0]\nheight = 2\n\
             [[light]]\ndirection = [{}, 0.5, 1]\n[texture]\nsource = \"lettering\"\n[height]\nsource = \"lettering\"\n\
             [[object]]\nshape = \"plane\"\nscale = [{}, 1, 1]",
            -side,
            2.0 * side
        );
        Scene::parse(&text, Path::new("mirror.toml")).unwrap()
    };
    let (plain, mirrored) = (text(false), text(true));
    assert!(!mirrored.facts().right_handed);
    let (a, b) = (embossed(&plain, &[]), embossed(&mirrored, &[]));
    for (is, should) in a.shots.iter().zip(&b.shots) {
        let pixels = [a.golden_of(is), b.golden_of(should)].map(Picture::pixels);
        for (row, turned) in pixels[0].chunks(128).zip(pixels[1].chunks(128)) {
            for (is, should) in row.iter().zip(turned.iter().rev()) {
                for channel in 0..3 {
                    assert!((is[channel] - should[channel]).abs() < 1e-6, "{is:?} {should:?}");
                }
            }
        }
    }
    within_the_bound(&mirrored, &[], "mirrored");
}

/// Nearest texels: only pixels next to a texel border may differ from the golden.
#[test]
fn nearest_texels_are_nearly_all_the_goldens() {
    let mut scene = small("brick");
    scene.emboss.filter = Filter::Nearest;
    let rendered = embossed(&scene, &[]);
    for shot in &rendered.shots {
        assert_eq!(shot.emboss.unwrap().bound, None);
        let pairs = shot.picture.pixels().iter().zip(rendered.golden_of(shot).pixels());
        let off =
            pairs.filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| (a - b).abs() > 1.01 / 255.0));
        let off = off.count();
        assert!(off < shot.picture.pixels().len() / 100, "{off}");
    }
    assert_ne!(rendered.golden, embossed(&small("brick"), &[]).golden);
}

#[test]
fn pictures_do_not_depend_on_threads() {
    let scene = small("light-orbit").frame(2);
    let all = embossed(&scene, &[]);
    let one = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let one = one.install(|| embossed(&scene, &[]));
    assert_eq!(all.golden, one.golden);
    for (a, b) in all.shots.iter().zip(&one.shots) {
        assert_eq!((&a.picture, a.samples), (&b.picture, b.samples));
        assert_eq!(a.overflows, b.overflows);
    }
}

/// Vertices lie on the surface, frames are at right angles, and triangles cover the pixels that
/// rays hit.
#[test]
fn triangles_are_the_surfaces() {
    for name in ["plane", "cube", "sphere"] {
        for parts in [1, 2, 5, 64] {
            let mut scene = small(name);
            scene.emboss.tessellation = parts;
            let mesh = scene.tessellate().unwrap();
            for vertex in &mesh.vertices {
                let (n, t, b) = (vertex.normal, vertex.tangent, vertex.binormal);
                assert!(n.dot(t).abs() < 1e-12 && (n.cross(t) - b).length() < 1e-12);
                if name == "sphere" {
                    assert!((vertex.position.length() - 1.0).abs() < 1e-12);
                    assert!((vertex.position - n).length() < 1e-12);
                }
            }
            let mut seen = Seen::default();
            mesh.trace(&scene, 0..scene.image.height, &mut seen);
            let mut exact = fixpath::scene::Fragments::default();
            scene.trace(0..scene.image.height, &mut exact);
            for weights in &seen.weights {
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                assert!(weights.iter().all(|weight| *weight >= -1e-12));
            }
            if name != "sphere" {
                assert_eq!(seen.pixel, exact.pixel, "{name} {parts}");
                for i in 0..seen.len() {
                    let at = |axis| seen.between(i, |v| mesh.vertices[v].position[axis]);
                    let place = DVec3::new(at(0), at(1), at(2));
                    let should = fixpath::scene::Fragments::vector(&exact.position, i);
                    assert!((place - should).length() < 1e-9, "{place} {should}");
                }
            } else if parts == 64 {
                let missing = exact.len() - seen.len();
                assert!(missing < exact.len() / 50, "{missing}");
            }
        }
    }
}

#[test]
fn a_light_goes_around() {
    let scene = Scene::builtin("light-orbit").unwrap();
    assert_eq!(scene.frames(), 12);
    let place = |frame: u32| match scene.frame(frame).lights[0].place {
        Place::Position(position) => position,
        Place::Direction(direction) => panic!("{direction}"),
    };
    assert_eq!(place(0), DVec3::new(0.0, -2.5, 1.5));
    assert!((place(3) - DVec3::new(2.5, 0.0, 1.5)).length() < 1e-12, "{}", place(3));
    assert!((place(6) - DVec3::new(0.0, 2.5, 1.5)).length() < 1e-12);
    assert_eq!(scene.frame(3).frames(), 1);
    assert_ne!(scene.fingerprint(), scene.frame(0).fingerprint());
    assert_eq!(Scene::builtin("plane").unwrap().frames(), 1);
}

fn refused(text: &str) -> String {
    let text = format!("{text}\n[[object]]\nshape = \"plane\"");
    Scene::parse(&text, Path::new("bad.toml")).unwrap_err().to_string()
}

#[test]
fn wrong_keys_are_named_with_what_is_legal() {
    for (text, says) in [
        ("[emboss]\nstrength = -1", "bad.toml, line 2: `strength` = -1: legal is 0 to 64"),
        ("[emboss]\nstrength = 1e300", "`strength` = 1e300: legal is 0 to 64"),
        ("[emboss]\nstrength = nan", "`strength` = NaN: legal is 0 to 64"),
        (
            "[emboss]\ngain_log2 = 9",
            "bad.toml, line 2: `gain_log2` = 9: legal are whole numbers -8 to 8",
        ),
        (
            "[emboss]\ntessellation = 0",
            "bad.toml, line 2: `tessellation` = 0: legal are whole numbers 1 to 256",
        ),
        ("[emboss]\nfilter = \"cubic\"", "expected `nearest` or `bilinear`"),
        ("[emboss]\naddress_s = \"mirror\"", "expected `wrap` or `clamp`"),
        ("[emboss]\nlight_sign = \"up\"", "expected `light-vertex` or `vertex-light`"),
        ("[emboss]\nstrenght = 1", "unknown field `strenght`"),
        ("[orbit]\nframes = 0", "bad.toml, line 2: `frames` = 0: legal are whole numbers 1 to 360"),
        ("[orbit]\nlight = 1", "bad.toml, line 2: `light` = 1: legal are whole numbers 0 to 0"),
        ("[orbit]\naxis = [0, 0, 0]", "bad.toml, line 2: `axis` is zero"),
        (
            "[[light]]\ndirection = [1, 0, 1]\n[orbit]\ncenter = [0, 0, 1]",
            "bad.toml, line 4: `center` has no effect here: the light is directional; leave it out",
        ),
        ("[orbit]\nturns = 1e9", "`turns` = 1e9: legal is -100 to 100"),
    ] {
        let message = refused(text);
        assert!(message.contains(says), "{text}: {message}");
    }
}

#[test]
fn scenes_that_can_not_be_embossed_say_why() {
    let scene = |text: &str| Scene::parse(text, Path::new("s.toml")).unwrap();
    let refused = |scene: &Scene| render(scene, &pipelines(&[]), false, &|_| ()).unwrap_err();
    let plane = "[[object]]\nshape = \"plane\"\n";
    for (text, says) in [
        (
            plane.to_owned(),
            "a height map of 1 x 1 texels: for an emboss, legal are sides of powers of two",
        ),
        (
            format!("[height]\nsource = \"brick\"\nwidth = 100\n{plane}"),
            "a height map of 100 x 512 texels",
        ),
        (
            format!("[height]\nsource = \"brick\"\n{plane}translate = [0, 0, -5000]"),
            "from the camera along an axis, but the emboss unit's positions end at 4095.99",
        ),
        (
            format!(
                "[emboss]\ntessellation = 256\n[height]\nsource = \"brick\"\n{}",
                "[[object]]\nshape = \"cube\"\n".repeat(6)
            ),
            "the scene has 4718592 triangles at `tessellation` = 256: legal are at most 4194304",
        ),
    ] {
        let message = refused(&scene(&text)).to_string();
        assert!(message.contains(says), "{text}: {message}");
    }
    // At the exact position of a light nothing is displaced.
    let text = format!(
        "[height]\nsource = \"brick\"\n[camera]\neye = [0, -1, 3]\n[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\n{plane}"
    );
    within_the_bound(&scene(&text), &[], "a light on the surface");
}

/// Commands that take one picture of a moving light say so in every report of figures.
#[test]
fn a_light_that_is_taken_where_it_starts_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let text = "[image]\nwidth = 16\nheight = 12\n[height]\nsource = \"brick\"\n[orbit]\nframes = 3\n[material]\nspecular = 0.0\n[[object]]\nshape = \"sphere\"";
    fs::write(here.join("scene.toml"), text).unwrap();
    let note = "[orbit]: light 0 moves; its starting position is used";
    let run = |args: &[&str], notes: usize| -> String {
        let mut command = common::fixpath();
        let output = command.current_dir(here).args(args).output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{args:?}: {errors}");
        assert_eq!(errors.matches(&format!("note: {note}\n")).count(), notes, "{errors}");
        String::from_utf8(output.stdout).unwrap()
    };
    let read = |name: &str| fs::read_to_string(here.join(name)).unwrap();
    let of = |text: &str| -> serde_json::Value { serde_json::from_str(text).unwrap() };
    let in_markdown = "light 0 moves; its starting position is used";
    for (pipeline, scene) in [("emboss-gx", "/scene"), ("exact-cartesian", "/header/scene")] {
        run(&["render", "scene.toml", "--out", "l", "--pipelines", pipeline, "--ladder=8"], 1);
        let ladder = of(&read("l/ladder.json"));
        assert_eq!(ladder.pointer(scene).unwrap()["notes"], serde_json::json!([note]));
        assert!(read("l/ladder.md").contains(in_markdown));
    }
    run(&["sweep", "bump", "--axis", "frac_bits=8", "--scene", "scene.toml", "--out", "s"], 1);
    assert_eq!(of(&read("s/sweep.json"))["header"]["scene"]["notes"], serde_json::json!([note]));
    assert!(read("s/report.md").contains(in_markdown));
    let compare = ["compare", "--samples", "9", "--scenes", "scene.toml", "--out", "c.md"];
    let told = run(&[&compare[..], &["--json"]].concat(), 1);
    assert_eq!(of(&told)["scenes"][0]["notes"], serde_json::json!([note]));
    assert!(read("c.md").contains(in_markdown));
    // Every frame has its picture: there is nothing to note.
    run(&["render", "scene.toml", "--out", "f", "--pipelines", "emboss-gx"], 0);
    assert_eq!(of(&read("f/figures.json"))["frames"][2]["notes"], serde_json::json!([]));
}

#[test]
fn the_command_line_writes_frames_and_refuses() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.toml");
    let text = "[image]\nwidth = 40\nheight = 30\n[height]\nsource = \"brick\"\n[orbit]\nframes = 3\n[[object]]\nshape = \"sphere\"";
    fs::write(&file, text).unwrap();
    let out = folder.path().join("out");
    let run = |args: &[&str]| {
        let mut command = common::fixpath();
        command.arg("render").arg(&file).arg("--out").arg(&out).args(args);
        common::told(command.output().unwrap())
    };
    let (code, told, errors) = run(&["--pipelines", "emboss-gx"]);
    assert_eq!((code, errors.as_str()), (0, ""));
    assert!(told.contains("bound/255"), "{told}");
    for name in ["golden/frame_000.png", "emboss-gx/frame_002.png", "sheet.png", "figures.json"] {
        assert!(out.join(name).is_file(), "{name}");
    }
    let figures: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(out.join("figures.json")).unwrap()).unwrap();
    let frames = figures["frames"].as_array().unwrap();
    assert_eq!(frames.len(), 3);
    let shot = &frames[1]["pipelines"][0];
    assert!(
        shot["emboss"]["bound"].as_f64().unwrap()
            > shot["difference"]["max"]["difference"].as_f64().unwrap()
    );
    assert_eq!(shot["behind"][0]["unit"], "sampler");
    assert_eq!(shot["behind"][1]["parameters"]["filter"], "bilinear");
    for (args, says) in [
        (&["--pipelines", "emboss-gx,kim"][..], "emboss pipelines have their own golden"),
        (&["--pipelines", "emboss-gl"], "no pipeline `emboss-gl`, did you mean `emboss-gx`"),
        (&["--pipelines", "emboss-gx", "-p", "filter=nearest"], "parameter `filter` comes from"),
        (&["--pipelines", "emboss-gx", "-p", "setting=nv"], "parameter `setting` comes from"),
        (&["--pipelines", "emboss-gx", "-p", "angle_bits=8"], "no parameter `angle_bits` in any"),
        (
            &["--pipelines", "emboss-gx", "-p", "fraction_bits=0"],
            "`fraction_bits` = `0`: legal is 1 to 16",
        ),
        (&["--pipelines", "kim", "--specialise"], "leave [orbit] out"),
        (
            &["--pipelines", "emboss-gx", "-p", "matrix_bits=2"],
            "but its matrix has steps of 2.000e0: give the object smaller texture coordinates",
        ),
    ] {
        let (code, told, errors) = run(args);
        assert_eq!((code, told.as_str()), (2, ""), "{args:?}: {errors}");
        assert!(errors.contains(says), "{args:?}: {errors}");
    }
}

/// A scene with an [emboss] section is embossed if no pipelines are named.
#[test]
fn an_emboss_section_asks_for_emboss_pipelines() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.toml");
    let text = "[image]\nwidth = 16\nheight = 12\n[height]\nsource = \"brick\"\n[[object]]\nshape = \"plane\"\n";
    for (section, there, not) in
        [("", "exact-polar.png", "emboss-gx.png"), ("[emboss]\n", "emboss-nv.png", "printed.png")]
    {
        fs::write(&file, format!("{section}{text}")).unwrap();
        let out = folder.path().join(there);
        let mut command = common::fixpath();
        command.arg("render").arg(&file).arg("--out").arg(&out).assert().success();
        assert!(out.join(there).is_file() && !out.join(not).exists(), "{there}");
    }
}

/// The ladder of an emboss: finer fractions and larger tables have smaller errors, and every rung
/// is within its bound.
#[test]
fn a_ladder_shows_what_each_parameter_costs() {
    let folder = tempfile::tempdir().unwrap();
    let (out, file) = (folder.path().join("ladder"), folder.path().join("small.toml"));
    let text = "[image]\nwidth = 64\nheight = 48\n[height]\nsource = \"brick\"\nwidth = 256\nheight = 256\n[[object]]\nshape = \"sphere\"";
    fs::write(&file, text).unwrap();
    let run = |args: &[&str]| {
        let mut command = common::fixpath();
        command.arg("render").arg(&file).arg("--out").arg(&out).args(args);
        common::told(command.output().unwrap())
    };
    let (code, _, errors) =
        run(&["--pipelines", "emboss-gx", "--ladder=8,12", "-p", "channel_bits=10"]);
    assert_eq!((code, errors.as_str()), (0, ""));
    let record: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(out.join("ladder.json")).unwrap()).unwrap();
    assert_eq!(record["given"][0], "channel_bits=10");
    let rungs = record["rungs"].as_array().unwrap();
    for rung in rungs {
        let figures = &rung["measured"];
        let max = figures["difference"]["max"]["difference"].as_f64().unwrap();
        assert!(max <= figures["bound"].as_f64().unwrap(), "{rung:#}");
    }
    let of = |setting: &str, figure: &str| -> f64 {
        let rung = rungs.iter().find(|rung| rung["setting"] == setting).unwrap();
        match figure {
            "mean" => rung["measured"]["difference"]["mean"].as_f64().unwrap(),
            figure => rung["measured"][figure].as_f64().unwrap(),
        }
    };
    let falls = |settings: &[&str], figure: &str| {
        let values: Vec<f64> = settings.iter().map(|setting| of(setting, figure)).collect();
        assert!(values.is_sorted_by(|a, b| a > b), "{figure} of {settings:?}: {values:?}");
    };
    falls(&["fraction_bits=1", "fraction_bits=3", "fraction_bits=6"], "mean");
    falls(
        &["component_bits=8 matrix_bits=8", "component_bits=12 matrix_bits=12", "defaults"],
        "displacement_max_texels",
    );
    for scheme in ["direct", "linear", "newton"] {
        let at = |bits: u32| format!("root_scheme={scheme} root_addr_bits={bits}");
        falls(&[&at(2), &at(4)], "displacement_max_texels");
    }
    let csv = fs::read_to_string(out.join("ladder.csv")).unwrap();
    assert_eq!(csv.lines().count(), rungs.len() + 1);
    assert!(
        fs::read_to_string(out.join("ladder.md")).unwrap().contains("| emboss-gx | defaults |")
    );
    for (args, says) in [
        (&["--pipelines", "emboss-gx,kim", "--ladder"][..], "have their own golden"),
        (&["--pipelines", "emboss-nv", "--ladder", "--exponents", "8"], "no --exponents"),
        (
            &["--pipelines", "emboss-nv", "--ladder=3"],
            "width `3`: legal are whole numbers from 4 to 24",
        ),
        (
            &["--pipelines", "emboss-nv", "--specialise"],
            "--specialise is for pipelines that shade bumps",
        ),
    ] {
        let (code, told, errors) = run(args);
        assert_eq!((code, told.as_str()), (2, ""), "{args:?}: {errors}");
        assert!(errors.contains(says), "{args:?}: {errors}");
    }
}
