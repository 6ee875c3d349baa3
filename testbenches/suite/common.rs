//! Helpers shared by the tests: designs, runs of the program, vectors, scenes, files.

use assert_cmd::Command;
use fixpath::render::Pipeline;
use fixpath::scene::{Fragments, Scene};
use fixpath::units::{Design, Unit};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

/// The design of a unit with some parameters set.
pub(crate) fn design(unit: &str, assignments: &[&str]) -> Design {
    let values = Unit::find(unit).unwrap().values(assignments).unwrap();
    values.build().unwrap_or_else(|why| panic!("{unit} {assignments:?}: {why}"))
}

pub(crate) fn fixpath() -> Command {
    Command::cargo_bin("fixpath").unwrap()
}

/// Exit code, standard output and standard error.
pub(crate) fn told(output: Output) -> (i32, String, String) {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// Runs and gives exit code, standard output and standard error.
pub(crate) fn run(args: &[&str]) -> (i32, String, String) {
    told(fixpath().args(args).output().unwrap())
}

/// Standard output of a run whose standard error is empty.
pub(crate) fn done(args: &[&str]) -> String {
    let (code, stdout, stderr) = run(args);
    assert_eq!((code, stderr.as_str()), (0, ""), "{args:?}");
    stdout
}

/// Expects a usage error: exit code 2, nothing on standard output, and one line that contains
/// `message`, followed by tips at most.
pub(crate) fn refused(args: &[&str], message: &str) {
    let (code, stdout, stderr) = run(args);
    assert_eq!((code, stdout.as_str()), (2, ""), "{args:?}: {stderr}");
    let lines = stderr.lines().filter(|line| !line.starts_with("  tip: "));
    assert_eq!(lines.count(), 1, "{args:?}: {stderr}");
    assert!(stderr.contains(message), "{args:?}: {stderr}");
}

pub(crate) fn json(path: &Path) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

pub(crate) fn written(folder: &Path, name: &str, text: &str) -> PathBuf {
    fs::write(folder.join(name), text).unwrap();
    folder.join(name)
}

pub(crate) type Vector = [f64; 3];

pub(crate) fn dot(u: Vector, v: Vector) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

pub(crate) fn cross(u: Vector, v: Vector) -> Vector {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// The pixels' views of a scene.
pub(crate) fn traced(scene: &Scene) -> Fragments {
    let mut fragments = Fragments::default();
    scene.trace(0..scene.image.height, &mut fragments);
    fragments
}

/// Pipelines by their names, with some parameters set.
pub(crate) fn pipelines(names: &[&str], assignments: &[&str]) -> Vec<Pipeline> {
    let mut all: Vec<Pipeline> = names.iter().map(|name| Pipeline::named(name).unwrap()).collect();
    let assignments: Vec<String> = assignments.iter().map(|text| (*text).to_owned()).collect();
    Pipeline::set(&mut all, &assignments).unwrap();
    all
}
