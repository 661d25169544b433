//! The peer scenes in a folder.

use crate::cli::failure::{Failure, reason};
use crate::cli::scene_argument::SizeArguments;
use crate::peer::import;
use crate::scene::{Scene, load};
use std::fs;
use std::path::{Path, PathBuf};

/// A scene for both programs.
pub struct PeerScene {
    pub name: String,
    /// The file for POV-Ray.
    pub sdl: PathBuf,
    pub scene: Scene,
}

/// The scenes of the folder, or those that are named, in the order of their names.
pub fn read(folder: &Path, wanted: &[String], size: SizeArguments) -> Result<Vec<PeerScene>, Failure> {
    let names = names(folder)?;
    if let Some(unknown) = wanted.iter().find(|name| !names.contains(name)) {
        let known = names.join(", ");
        return Err(Failure::usage(format!("there is no scene `{unknown}` in {}; it has {known}", folder.display())));
    }
    let chosen = names.into_iter().filter(|name| wanted.is_empty() || wanted.contains(name));
    chosen.map(|name| read_one(folder, name, size)).collect()
}

/// The names that have both files.
fn names(folder: &Path) -> Result<Vec<String>, Failure> {
    let cannot_read = |error| {
        let (place, why) = (folder.display(), reason(&error));
        Failure::usage(format!("cannot read the peer scenes in {place}: {why}; name their folder with --scenes"))
    };
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(cannot_read)? {
        let path = entry.map_err(cannot_read)?.path();
        let is_scene = path.extension().is_some_and(|ending| ending == "json") && path.with_extension("pov").is_file();
        names.extend(path.file_stem().filter(|_| is_scene).and_then(|name| name.to_str()).map(str::to_owned));
    }
    names.sort();
    if names.is_empty() {
        return Err(Failure::usage(format!("{} holds no scene as NAME.json and NAME.pov", folder.display())));
    }
    Ok(names)
}

fn read_one(folder: &Path, name: String, size: SizeArguments) -> Result<PeerScene, Failure> {
    let path = folder.join(&name).with_extension("json");
    let at_fault = |message: String| Failure::usage(format!("{}: {message}", path.display()));
    let text = fs::read_to_string(&path).map_err(|error| at_fault(reason(&error)))?;
    let text = import(&text).map_err(at_fault)?;
    let mut scene = load(&text, &name).map_err(|errors| at_fault(errors.to_string()))?;
    scene.image = size.apply(scene.image)?;
    Ok(PeerScene { name, sdl: path.with_extension("pov"), scene })
}
