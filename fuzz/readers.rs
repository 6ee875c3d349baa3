//! Every reader of outside data, as a function of bytes that must not panic and that checks what it
//! has read. `fuzz/targets` has each as a fuzz target; the suite runs all of them over
//! `fuzz/seeds`.

use fixpath::cli;
use fixpath::cost;
use fixpath::format::Format;
use fixpath::measure::{Inputs, measure};
use fixpath::netlist::{Column, Netlist};
use fixpath::report::{self, record::Record};
use fixpath::samples::{AngleUnit, Block, SampleFile};
use fixpath::scene::{Fragments, Scene};
use fixpath::sweep::Axis;
use fixpath::texgen::Calls;
use fixpath::units::{Design, Sampler, Unit};
use std::fs;
use std::path::Path;
use std::sync::{Arc, OnceLock};
use tempfile::TempDir;

/// A reader with its name, which is also that of its target and its folder of seeds.
pub(crate) type Reader = (&'static str, fn(&[u8]));

/// All readers.
pub(crate) const READERS: &[Reader] = &[
    ("axis", axis),
    ("cells", cells),
    ("command_line", command_line),
    ("format", format),
    ("gltf", gltf),
    ("netlist", netlist),
    ("obj", obj),
    ("parameters", parameters),
    ("picture", picture),
    ("samples", samples),
    ("scene", scene),
    ("sweep", sweep),
    ("texgen", texgen),
];

thread_local! {
    /// The folder in which readers of files find theirs.
    static FOLDER: TempDir = tempfile::tempdir().unwrap();
}

/// Text only: other code refuses invalid UTF-8 before these readers.
fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}

/// The unit named in the first line, and the other lines.
fn unit(bytes: &[u8]) -> Option<(&'static Unit, &str)> {
    let (name, rest) = text(bytes)?.split_once('\n')?;
    Some((Unit::find(name).ok()?, rest))
}

/// A netlist file: what is parsed is written, parsed again to an equal netlist, and run.
pub(crate) fn netlist(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let path = Path::new("fuzzed.netlist");
    let Ok(netlist) = Netlist::parse(text, path) else { return };
    let written = netlist.to_file();
    let again = Netlist::parse(&written, path).expect("what is written is read");
    assert!(again == netlist, "{written}");
    let Some(netlist) = bound(netlist) else { return };
    let words: Vec<i64> =
        netlist.inputs().iter().map(|id| netlist.node(*id).format.max_raw()).collect();
    let (nodes, _) = netlist.eval(&words).expect("words of the ports' formats");
    assert!(netlist.nodes().iter().zip(nodes).all(|(node, word)| node.format.contains(word)));
    let unit = Unit::of_netlist(netlist);
    // Schedules that ask for too much are refused, and outputs of bits, which have no value on
    // reals.
    let Ok(design) = unit.defaults().build() else { return };
    let inputs = Inputs { sampler: Sampler::Sphere, samples: 10, seed: 1 };
    let _ = measure(&[&design], &inputs, &|_| ());
}

/// Binds some words to each memory, if the memories are small.
fn bound(netlist: Netlist) -> Option<Netlist> {
    let mut bound = netlist.clone();
    for memory in netlist.memories() {
        let rows = (memory.addr_bits <= 12).then_some(1i64 << memory.addr_bits)?;
        let words =
            |column: &Column| (0..rows).map(|row| column.format.wrap(row * 0x9e37)).collect();
        let columns: Vec<Arc<[i64]>> = memory.columns.iter().map(words).collect();
        bound = bound.bind(&memory.name, &columns).expect("words of their formats");
    }
    Some(bound)
}

/// A format: what is parsed prints as text that parses to the same format.
pub(crate) fn format(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Ok(format) = text.parse::<Format>() {
        assert_eq!(format.to_string().parse::<Format>().unwrap(), format);
        assert!(format.min_raw() <= 0 && format.max_raw() > format.min_raw());
    }
}

/// Lines `key=value` for a unit: legal values print as text that parses to the same values.
pub(crate) fn parameters(bytes: &[u8]) {
    let Some((unit, text)) = unit(bytes) else { return };
    let assignments: Vec<&str> = text.lines().collect();
    let Ok(values) = unit.values(&assignments) else { return };
    let written: Vec<String> =
        values.iter().map(|(name, value)| format!("{name}={value}")).collect();
    let again = unit.values(&written).unwrap();
    assert!(values.iter().eq(again.iter()), "{written:?}");
}

/// An axis of a sweep over a unit: all its values are legal.
pub(crate) fn axis(bytes: &[u8]) {
    let Some((unit, text)) = unit(bytes) else { return };
    let Ok(axis) = Axis::parse(text, unit) else { return };
    assert!(!axis.values().is_empty());
    for value in axis.values() {
        unit.values(&[format!("{}={value}", axis.key())]).unwrap();
    }
}

/// Words of a command line, one per line.
pub(crate) fn command_line(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let words = std::iter::once("fixpath").chain(text.lines());
    let _ = cli::command().try_get_matches_from(words);
}

/// Cell counts as printed by Yosys.
pub(crate) fn cells(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let _ = cost::cells_of(text);
}

/// A table of inputs of the rotation unit, from the second byte on: all words fit their ports.
pub(crate) fn samples(bytes: &[u8]) {
    static DESIGN: OnceLock<Design> = OnceLock::new();
    let design = DESIGN.get_or_init(|| {
        let unit = Unit::find("rotation").unwrap();
        unit.values(&["table_addr_bits=4"]).unwrap().build().unwrap()
    });
    let netlist = &design.netlist;
    let Some((first, table)) = bytes.split_first() else { return };
    let angle = [AngleUnit::Radians, AngleUnit::Degrees, AngleUnit::Turns][usize::from(first % 3)];
    let path = Path::new("samples.csv");
    let Ok(mut file) = SampleFile::open(table, path, design, angle, first & 4 != 0) else {
        return;
    };
    let mut block = Block::default();
    let mut outputs = Vec::new();
    while let Ok(count @ 1..) = file.read(&mut block) {
        for (node, words) in netlist.inputs().iter().zip(&block.words) {
            assert_eq!(words.len(), count);
            assert!(words.iter().all(|word| netlist.node(*node).format.contains(*word)));
        }
        let row: Vec<i64> = block.words.iter().map(|words| words[0]).collect();
        outputs = netlist.eval(&row).unwrap().0;
    }
    drop(outputs);
    let _ = file.clipped_note();
}

/// Calls of texture-coordinate generation: each resulting configuration is legal for the emboss
/// unit.
pub(crate) fn texgen(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Ok(calls) = Calls::parse(text, Path::new("calls.toml")) else { return };
    let outcome = calls.run();
    assert!(outcome.problems() <= outcome.events.len() + 1 + outcome.undefined.len());
    let unit = Unit::find("emboss").unwrap();
    for emboss in &outcome.emboss {
        let text = emboss.to_string();
        let assignments: Vec<&str> = text.split(' ').collect();
        unit.values(&assignments).unwrap();
    }
}

/// A scene, beside a mesh and a picture that it may name.
pub(crate) fn scene(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    FOLDER.with(|folder| {
        let mesh = folder.path().join("mesh.obj");
        if !mesh.exists() {
            fs::write(mesh, TRIANGLE).unwrap();
            fs::write(folder.path().join("picture.png"), PNG).unwrap();
        }
        if let Ok(scene) = Scene::parse(text, &folder.path().join("scene.toml")) {
            look(&scene);
        }
    });
}

/// A mesh as OBJ.
pub(crate) fn obj(bytes: &[u8]) {
    file(bytes, "mesh.obj", &mesh("mesh.obj"));
}

/// A mesh as glTF; the first bytes decide its form.
pub(crate) fn gltf(bytes: &[u8]) {
    let name = if bytes.starts_with(b"glTF") { "mesh.glb" } else { "mesh.gltf" };
    file(bytes, name, &mesh(name));
}

/// A picture used as texture and as height map, as JPEG or PNG.
pub(crate) fn picture(bytes: &[u8]) {
    let name = if bytes.starts_with(b"\x89PNG") { "map.png" } else { "map.jpg" };
    let object = "[[object]]\nshape = \"plane\"\n";
    file(bytes, name, &format!("{SMALL}[texture]\nfile = \"{name}\"\n{object}"));
    file(bytes, name, &format!("{SMALL}[height]\nfile = \"{name}\"\n{object}"));
}

/// The result of a sweep: it is reported, written, and read back unchanged.
pub(crate) fn sweep(bytes: &[u8]) {
    FOLDER.with(|folder| {
        let path = folder.path().join("sweep.json");
        fs::write(&path, bytes).unwrap();
        let Ok(Some(record)) = Record::load(&path) else { return };
        report::write(folder.path(), &record).unwrap();
        Record::write_json(&path, &record.header, record.points.iter()).unwrap();
        let again = Record::load(&path).unwrap().unwrap();
        let text = |record: &Record| serde_json::to_string(record).unwrap();
        assert_eq!(text(&again), text(&record));
    });
}

const SMALL: &str = "[image]\nwidth = 6\nheight = 6\n";
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
const PNG: &[u8] = include_bytes!("seeds/picture/gray.png");

fn mesh(name: &str) -> String {
    format!("{SMALL}[[object]]\nshape = \"mesh\"\nfile = \"{name}\"\n")
}

/// A scene that names a file with these bytes.
fn file(bytes: &[u8], name: &str, toml: &str) {
    FOLDER.with(|folder| {
        fs::write(folder.path().join(name), bytes).unwrap();
        if let Ok(scene) = Scene::parse(toml, &folder.path().join("scene.toml")) {
            look(&scene);
        }
    });
}

/// Checks that every face has finite corners and unit normals, and that the pixels of one row have
/// unit normals and tangents.
fn look(scene: &Scene) {
    for (_, corners) in scene.faces().take(1000) {
        for corner in corners {
            assert!(corner.position.is_finite() && corner.uv.is_finite());
            assert!((corner.normal.length() - 1.0).abs() < 1e-9, "{corner:?}");
        }
    }
    let middle = scene.image.height / 2;
    let mut fragments = Fragments::default();
    scene.trace(middle..(middle + 1).min(scene.image.height), &mut fragments);
    for i in 0..fragments.len() {
        for vectors in [&fragments.normal, &fragments.tangent] {
            let length = Fragments::vector(vectors, i).length();
            assert!((length - 1.0).abs() < 1e-9, "{length}");
        }
    }
    assert!(scene.notes().iter().all(|note| !note.is_empty()));
}
