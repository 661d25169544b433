//! The page of a worked example: a picture, drawings, and the ray's whole story as text.

use super::drawings::Drawn;
use super::examples::Example;
use super::frame::Head;
use super::page::{Page, escaped_lines};
use super::picture::Shown;
use super::search::Entry;
use super::{Book, BookFile};
use crate::scene::{Scene, embedded_scene, load};
use crate::share::link;
use crate::trace::{RayTree, record_pixel};
use crate::view::{View, escaped, tree_text};

/// Drawings that tell what is special about a ray, the most special first.
const TELLING: [&str; 10] =
    ["planes", "wavelengths", "medium", "lens", "texture", "snell", "csg", "signs", "shading", "generic"];

/// Besides the scene from the side, so many drawings are shown: more say the same again.
const MOST_DRAWINGS: usize = 3;

/// A page of more lines is slow to open, and is not read; the command line tells all.
const MOST_LINES: usize = 2500;

/// The page, and its picture where it is the first of its scene.
pub fn files(book: &mut Book, place: usize) -> Vec<BookFile> {
    let example = book.examples[place].clone();
    let embedded = embedded_scene(&example.scene);
    let read = embedded.and_then(|embedded| Some((embedded.text, load(embedded.text, &embedded.name).ok()?)));
    let Some((text, scene)) = read else { return Vec::new() };
    let tree = record_pixel(&scene, example.pixel[0], example.pixel[1]);
    let mut page = book.page_in_folder();
    let (picture, file) = book.pictures.of(&scene, text);
    heading(&example, &scene, &picture, &mut page);
    drawings(&scene, &tree, &mut page);
    page.put(format_args!(
        "<section class=\"tree\"><h2>The ray's whole story</h2>\n<pre tabindex=\"0\">{}</pre></section>\n",
        escaped_lines(&told_tree(&tree))
    ));
    page.entries.push(Entry {
        title: format!("{} (worked example)", example.title()),
        path: example.path(),
        words: scene.title.clone(),
        terms: Vec::new(),
    });
    let neighbour = |place: Option<usize>| {
        place.and_then(|place| book.examples.get(place)).map(|example| (example.path(), example.title()))
    };
    let head = Head {
        path: example.path(),
        title: example.title(),
        about: format!("The whole story of a ray: {}", scene.title),
        before: neighbour(place.checked_sub(1)),
        after: neighbour(Some(place + 1)),
        scripts: &[],
    };
    let written = page.finished(&head);
    book.keep(&mut page);
    page.files.extend(file.into_iter().chain([written]));
    page.files
}

fn heading(example: &Example, scene: &Scene, picture: &str, page: &mut Page) {
    let [x, y] = example.pixel;
    let sections: Vec<String> = example
        .sections
        .iter()
        .map(|section| {
            format!("<a href=\"../sections.html#{}\">§ {}</a>", super::sections::anchor(section), escaped(section))
        })
        .collect();
    let link = link::Link { aim: Some(link::Aim::Pixel(example.pixel)), ..link::Link::to_scene(&example.scene) };
    let address = page.workbench.address(page.root, &link.to_string());
    let words = format!("{}, with pixel {x}, {y} marked", scene.title);
    let size = [scene.image.width, scene.image.height];
    let shown = Shown { path: format!("{}{picture}", page.root), size, pixel: Some(example.pixel), words: &words };
    page.put(format_args!(
        "<header>\n<p class=\"kicker\">Worked example · {}</p>\n<h1>{}</h1>\n<p class=\"idea\">{}</p>\n</header>\n\
         <div class=\"drawings\">\n<div><figure class=\"scene\">{}<figcaption>{}</figcaption></figure>\n\
         <div class=\"aim\"><p><a class=\"workbench\" href=\"{}\">Open in the workbench</a></p>\n\
         <p>On the command line: <code>rayscope trace {} --pixel {x},{y}</code></p></div></div>\n",
        sections.join(", "),
        escaped(&example.title()),
        escaped(&scene.title),
        shown.html(),
        escaped(&words),
        escaped(&address),
        escaped(&example.scene),
    ));
}

/// The drawings beside the picture, in what the heading opened for them.
fn drawings(scene: &Scene, tree: &RayTree, page: &mut Page) {
    // No event in particular: each drawing is about what tells most.
    let drawn = Drawn { scene, tree, event: tree.end() };
    if let Some(side) = View::named("side") {
        drawn.figure(page, side);
    }
    let mut shown = 0;
    for view in TELLING.into_iter().filter_map(View::named) {
        if shown < MOST_DRAWINGS && drawn.figure(page, view) {
            shown += 1;
        }
    }
    page.put("</div>\n");
}

/// A ray's story as text: of many samples the first two, of a very long one the beginning.
pub fn told_tree(tree: &RayTree) -> String {
    let text = with_two_samples(&tree_text(tree));
    let lines = text.lines().count();
    if lines <= MOST_LINES {
        return text;
    }
    let kept: Vec<&str> = text.lines().take(MOST_LINES).collect();
    format!("{}\n… {} more lines: `rayscope trace` prints them all\n", kept.join("\n"), lines - MOST_LINES)
}

/// The text with two samples of a pixel told as a whole, and of the others what they are.
fn with_two_samples(text: &str) -> String {
    let mut is_told = true;
    let mut told = String::new();
    for line in text.lines() {
        let sample = line.strip_prefix("  ⊙ sample ");
        if let Some(rest) = sample {
            is_told = matches!(rest.split_whitespace().next(), Some("1" | "2"));
        } else {
            is_told |= !line.starts_with("   ");
        }
        if is_told || sample.is_some() {
            told += line;
            told.push('\n');
        }
    }
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_samples_two_are_told_and_the_others_named() {
        let sample = |number: u32| format!("  ⊙ sample {number} of 4\n      → ray\n");
        let text = format!("▣ Pixel\n{}  ⑥ Place\n      colour\n", (1..=4).map(sample).collect::<String>());
        let told = with_two_samples(&text);
        assert_eq!(told.matches("→ ray").count(), 2);
        assert_eq!(told.matches("⊙ sample").count(), 4);
        assert!(told.ends_with("  ⑥ Place\n      colour\n"));
    }
}
