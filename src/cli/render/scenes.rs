//! Scenes by their names or files.

use crate::base::error::Result;
use crate::base::escape;
use crate::report::record::RankBy;
use crate::shading::scene::Scene;
use crate::sweep::View;
use std::io::{self, Write as _};
use std::path::Path;

/// The scene of a name or a file; what isn't as its files have it goes to standard error.
pub(in crate::cli) fn scene_of(path: &Path) -> Result<Scene> {
    Ok(noted(named_scene(path)?))
}

/// The same for what takes one picture: a light that moves stands still.
pub(in crate::cli) fn still_scene_of(path: &Path) -> Result<Scene> {
    Ok(noted(named_scene(path)?.at_start()))
}

fn noted(scene: Scene) -> Scene {
    // A lost note changes nothing.
    let _ = write!(io::stderr(), "{}", notes(&scene));
    scene
}

/// A line for each of a scene's notes.
pub(super) fn notes(scene: &Scene) -> String {
    let told = |note: &String| format!("note: {}\n", escape::message(note));
    scene.notes().iter().map(told).collect()
}

fn named_scene(path: &Path) -> Result<Scene> {
    // A bare word that is no file is meant as a name, though there may be no such scene. A folder of
    // that name may be what an earlier run wrote.
    match path.to_str().filter(|name| !name.contains(['.', '/', '\\'])) {
        Some(name) if !path.exists() || path.is_dir() => Scene::builtin(name),
        Some(_) | None => Scene::open(path),
    }
}

/// The scene of a name or a file, to sweep over.
pub(in crate::cli) fn view_of(path: &Path, error: RankBy) -> Result<View> {
    Ok(View { scene: still_scene_of(path)?, name: name_of(path), error })
}

/// The name of a scene in reports.
pub(super) fn name_of(path: &Path) -> String {
    // A file's name can be anything; in reports it stays on its line.
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    escape::short(&name)
}
