//! Pipelines specialised for a scene: equal on every pixel, and without hardware that the scene
//! doesn't need.

use fixpath::render::{Pipeline, SpecialisedStage, specialise_to};
use fixpath::scene::Scene;
use std::path::Path;

fn scene(text: &str) -> Scene {
    let small = "[image]\nwidth = 48\nheight = 40\n";
    let maps = "[texture]\nsource = \"brick\"\nwidth = 32\nheight = 32\n\
                [height]\nsource = \"brick\"\nwidth = 32\nheight = 32\nscale = 4.0\n";
    Scene::parse(&format!("{small}{maps}{text}"), Path::new("test.toml")).unwrap()
}

fn specialised(text: &str, pipeline: &str) -> Vec<SpecialisedStage> {
    let stages = specialise_to(&scene(text), &Pipeline::named(pipeline).unwrap()).unwrap();
    for stage in &stages {
        assert_eq!(stage.mismatches, 0, "{pipeline}: {text}");
        assert!(stage.samples > 100, "{pipeline}: {} samples", stage.samples);
        let (before, after) = (&stage.report.before, &stage.report.pixel.counts);
        assert!(after.rom_bits_dual_port <= before.rom_bits_dual_port);
        assert!(after.datapath.multipliers <= before.datapath.multipliers);
    }
    stages
}

const ORTHOGRAPHIC: &str = "[camera]\nprojection = \"orthographic\"\neye = [0.3, -0.5, 3.0]\ntarget = [0.0, 0.0, 0.0]\nup = [0.0, 1.0, 0.0]\n";
const DIRECTIONAL: &str = "[[light]]\ndirection = [0.4, 0.3, 0.8]\n";
const POINT: &str = "[[light]]\nkind = \"point\"\nposition = [0.4, 0.3, 1.5]\n";

const PIPELINES: [&str; 4] = ["printed", "corrected", "exact-polar", "exact-cartesian"];

#[test]
fn every_kind_of_scene_keeps_every_word() {
    let dull = "[material]\nspecular = 0.0\n";
    let two = "[[light]]\ndirection = [0.4, 0.3, 0.8]\n[[light]]\nkind = \"point\"\nposition = [2.0, -1.0, 1.5]\nintensity = 0.5\n";
    for shape in ["plane", "cube", "sphere"] {
        let object =
            format!("[[object]]\nshape = \"{shape}\"\nrotate_degrees = [10.0, 20.0, 30.0]\n");
        for parts in [
            ORTHOGRAPHIC.to_owned() + DIRECTIONAL,
            ORTHOGRAPHIC.to_owned() + POINT + dull,
            "[camera]\neye = [0.3, -2.0, 3.0]\n".to_owned() + DIRECTIONAL,
            ORTHOGRAPHIC.to_owned() + two,
        ] {
            let text = parts + &object;
            for pipeline in PIPELINES {
                specialised(&text, pipeline);
            }
        }
    }
}

/// One plane, light and eye far away: L, H and N are constants, and so are the operations that
/// rotate them.
#[test]
fn constant_vectors_leave_the_dot_products() {
    let text = format!("{ORTHOGRAPHIC}{DIRECTIONAL}[[object]]\nshape = \"plane\"\n");
    for pipeline in PIPELINES {
        let stage = specialised(&text, pipeline).remove(0);
        let constant = stage.inputs.iter().filter(|port| port.rate == "scene").count();
        assert_eq!(constant, 7, "{:?}", stage.inputs);
        let counts = &stage.report.pixel.counts;
        let (multipliers, adders) = if pipeline == "exact-cartesian" {
            (10, 6) // two dot products, and the rotation by psi, whose constants remain factors
        } else {
            (2, 12)
        };
        assert!(counts.datapath.multipliers <= multipliers, "{pipeline}: {counts:?}");
        assert!(counts.datapath.adders <= adders, "{pipeline}: {counts:?}");
        let names: Vec<&str> =
            stage.report.pixel.tables.iter().map(|table| table.table.as_str()).collect();
        assert!(!names.iter().any(|name| ["sincos", "asin", "recip", "prop"].contains(name)));
    }
}

#[test]
fn without_specular_light_there_is_no_halfway_path() {
    let text = format!(
        "{ORTHOGRAPHIC}{POINT}[material]\nspecular = 0.0\n[[object]]\nshape = \"sphere\"\n"
    );
    for pipeline in PIPELINES {
        let stage = specialised(&text, pipeline).remove(0);
        let report = &stage.report;
        assert!(report.removed_outputs.contains(&"specular".to_owned()), "{pipeline}");
        assert!(report.removed_inputs.contains(&"phi_h".to_owned()), "{pipeline}");
        assert!(report.pixel.tables.iter().all(|table| table.table != "specular"), "{pipeline}");
        assert!(
            2 * report.pixel.counts.datapath.multipliers <= report.before.datapath.multipliers + 4,
            "{pipeline}"
        );
    }
}

/// Each face of a cube has one N and psi, and for a distant light and eye one L and H.
#[test]
fn flat_faces_are_rotated_once_each() {
    let camera = "[camera]\nprojection = \"orthographic\"\neye = [3.0, -3.5, 3.0]\nheight = 4.0\n";
    let text = format!(
        "{camera}{DIRECTIONAL}[[object]]\nshape = \"cube\"\nrotate_degrees = [5.0, 10.0, 15.0]\n"
    );
    for pipeline in PIPELINES {
        let stage = specialised(&text, pipeline).remove(0);
        assert_eq!(stage.faces, 3, "{pipeline}: three faces are in sight");
        let rate = |name: &str| stage.inputs.iter().find(|p| p.port == name).unwrap().rate;
        assert_eq!((rate("phi_l"), rate("phi_n"), rate("psi")), ("scene", "face", "face"));
        let face = stage.report.face.as_ref().unwrap();
        assert!(face.counts.reads > 0, "{pipeline}");
        let before = stage.report.before.datapath.adders;
        assert!(stage.report.pixel.counts.datapath.adders <= before / 2, "{pipeline}");
    }
}

#[test]
fn rivals_keep_every_word() {
    let text = format!(
        "{ORTHOGRAPHIC}{POINT}[[object]]\nshape = \"cube\"\nrotate_degrees = [10.0, 20.0, 30.0]\n"
    );
    for pipeline in ["kim", "ernst", "kugler"] {
        assert_eq!(specialised(&text, pipeline).len(), 1, "{pipeline}");
    }
}

/// Lights that could share a design are analysed one by one: each is as constant as it is alone.
#[test]
fn two_equal_lights_cost_what_each_does_alone() {
    let other = "[[light]]\ndirection = [-0.5, 0.2, 0.9]\n";
    let counts = |lights: &str, pipeline: &str| {
        let text = format!(
            "{ORTHOGRAPHIC}{lights}[ambient]\nintensity = 0\n[[object]]\nshape = \"plane\"\n"
        );
        let stages = specialised(&text, pipeline);
        let count = |stage: &SpecialisedStage| {
            let datapath = &stage.report.pixel.counts.datapath;
            ((stage.material, stage.light), datapath.multipliers, datapath.adders)
        };
        stages.iter().map(count).collect::<Vec<_>>()
    };
    for pipeline in PIPELINES {
        let both = counts(&[DIRECTIONAL, other].concat(), pipeline);
        assert_eq!(both.len(), 2, "{pipeline}: one stage for each light");
        for (number, light) in [DIRECTIONAL, other].into_iter().enumerate() {
            let alone = counts(light, pipeline)[0];
            let stage = both.iter().find(|stage| stage.0 == (0, number)).unwrap();
            assert_eq!((stage.1, stage.2), (alone.1, alone.2), "{pipeline} {number}");
        }
    }
}
