//! The scenes that come with the program.

use include_dir::{Dir, include_dir};

static SCENES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/scenes");

/// A scene file inside the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmbeddedScene {
    /// Its path without the ending, such as `csg/bowl`.
    pub name: String,
    /// The file.
    pub text: &'static str,
}

impl EmbeddedScene {
    /// What it is called, or its name. It is read without compiling the scene, so that a list of all of them is there at once.
    #[must_use]
    pub fn title(&self) -> String {
        let whole: Option<serde_json::Value> = serde_json::from_str(self.text).ok();
        let title = whole.as_ref().and_then(|whole| whole.get("title")?.as_str());
        title.unwrap_or(&self.name).to_owned()
    }
}

/// All embedded scenes, by name.
#[must_use]
pub fn embedded_scenes() -> Vec<EmbeddedScene> {
    let mut scenes: Vec<_> = SCENES.dirs().flat_map(Dir::files).filter_map(scene).collect();
    scenes.sort_by(|a, b| a.name.cmp(&b.name));
    scenes
}

/// The embedded scene of this name.
#[must_use]
pub fn embedded_scene(name: &str) -> Option<EmbeddedScene> {
    SCENES.get_file(format!("{name}.json")).and_then(scene).filter(|scene| scene.name.contains('/'))
}

/// The bytes of an embedded file, by its path below `scenes/`.
pub(super) fn embedded_file(path: &str) -> Option<&'static [u8]> {
    SCENES.get_file(path).map(include_dir::File::contents)
}

fn scene(file: &'static include_dir::File<'static>) -> Option<EmbeddedScene> {
    let path = file.path().to_str()?.replace('\\', "/");
    Some(EmbeddedScene { name: path.strip_suffix(".json")?.to_owned(), text: file.contents_utf8()? })
}
