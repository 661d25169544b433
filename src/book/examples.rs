//! The worked examples: every telling pixel of every scene that comes with the program.

use super::frame::Head;
use super::links::slug;
use super::{Book, BookFile};
use crate::scene::{embedded_scenes, load};
use crate::view::escaped;

/// A pixel of a scene whose ray is told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// The scene's name.
    pub scene: String,
    /// The scene's title.
    pub scene_title: String,
    /// The sections that the scene shows.
    pub sections: Vec<String>,
    /// The pixel.
    pub pixel: [u32; 2],
}

/// All of them, scene by scene.
pub fn all_examples() -> Vec<Example> {
    let of_scene = |embedded: crate::scene::EmbeddedScene| -> Vec<Example> {
        // That every scene of the program can be read is seen to by a test.
        let Ok(scene) = load(embedded.text, &embedded.name) else { return Vec::new() };
        let example = |&pixel: &[u32; 2]| Example {
            scene: embedded.name.clone(),
            scene_title: scene.title.clone(),
            sections: scene.sections.clone(),
            pixel,
        };
        scene.pixels.iter().map(example).collect()
    };
    embedded_scenes().into_iter().flat_map(of_scene).collect()
}

impl Example {
    /// Its path from the root of the book.
    pub fn path(&self) -> String {
        let [x, y] = self.pixel;
        format!("examples/{}-{x}-{y}.html", slug(&self.scene))
    }

    /// What it is called.
    pub fn title(&self) -> String {
        let [x, y] = self.pixel;
        format!("{}, pixel {x}, {y}", self.scene)
    }

    /// A link to it.
    pub fn link(&self, root: &str) -> String {
        format!("<a href=\"{root}{}\">{}</a>", self.path(), escaped(&self.title()))
    }
}

/// The page that lists them.
pub fn list(book: &mut Book) -> BookFile {
    let mut page = book.page();
    page.put(
        "<h1>Worked examples</h1>\n<p>The whole story of one ray each, as <code>rayscope trace</code> tells it, with drawings.</p>\n\
         <dl class=\"examples\">\n",
    );
    for scene in book.examples.chunk_by(|a, b| a.scene == b.scene) {
        page.put(format_args!("<dt>{}</dt>\n<dd>{}: ", escaped(&scene[0].scene), escaped(&scene[0].scene_title)));
        let links: Vec<String> = scene
            .iter()
            .map(|example| {
                let [x, y] = example.pixel;
                format!("<a href=\"{}\">pixel {x}, {y}</a>", example.path())
            })
            .collect();
        page.put(format_args!("{}</dd>\n", links.join(", ")));
    }
    page.put("</dl>\n");
    page.finished(&Head {
        path: "examples.html".to_owned(),
        title: "Worked examples".to_owned(),
        about: "Recorded rays of every scene, told in full.".to_owned(),
        ..Head::default()
    })
}
