//! Scenes by name or file.

use crate::base::error::Result;
use crate::base::escape;
use crate::report::record::RankBy;
use crate::shading::scene::Scene;
use crate::sweep::View;
use std::io::{self, Write as _};
use std::path::Path;

/// The scene of a name or a file. Notes on how it deviates from its files go to standard error.
pub(in crate::cli) fn scene_of(path: &Path) -> Result<Scene> {
    Ok(noted(named_scene(path)?))
}

/// The same for commands that need one picture: a moving light stays at its start.
pub(in crate::cli) fn still_scene_of(path: &Path) -> Result<Scene> {
    Ok(noted(named_scene(path)?.at_start()))
}

fn noted(scene: Scene) -> Scene {
    // A failed write to stderr is ignored.
    let _ = write!(io::stderr(), "{}", notes(&scene));
    scene
}

/// A line for each of a scene's notes.
pub(super) fn notes(scene: &Scene) -> String {
    let told = |note: &String| format!("note: {}\n", escape::message(note));
    scene.notes().iter().map(told).collect()
}

fn named_scene(path: &Path) -> Result<Scene> {
    // A bare word that is not a file is taken as a scene's name, even if there is no such scene. A
    // folder of that name may be the output of an earlier run.
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
    // A file name can contain anything; escaped, it stays on one line in reports.
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    escape::short(&name)
}
