//! What is handed to other people says what was recorded, and can be read by programs that know nothing of this one.

use super::*;
use crate::scene::{Scene, embedded_scene, load};
use crate::story::Level;
use crate::trace::{RayTree, record_pixel};
use crate::view::{Drawing, Theme, View, row};
use image::AnimationDecoder;
use image::codecs::gif::GifDecoder;
use image::codecs::png::PngDecoder;
use std::io::Cursor;
use std::time::Duration;

struct Recorded {
    scene: Scene,
    tree: RayTree,
}

impl Recorded {
    fn of(name: &str) -> Self {
        let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        let tree = record_pixel(&scene, scene.pixels[0][0], scene.pixels[0][1]);
        Self { scene, tree }
    }

    fn account(&self, level: Level) -> Account<'_> {
        let (scene, tree) = (&self.scene, &self.tree);
        Account {
            scene,
            name: "csg/bowl",
            tree,
            level,
            views: &[],
            theme: Theme::Light,
            link: Some("rayscope:csg/bowl"),
        }
    }
}

const PATIENT: Watch = &|_, _| true;

#[test]
fn steps_are_those_of_the_level_and_what_is_left_out_is_said() {
    let bowl = Recorded::of("csg/bowl");
    let count = |level| bowl.account(level).steps(usize::MAX).events.len();
    assert!(count(Level::Story) < count(Level::Working) && count(Level::Working) < count(Level::Everything));
    assert_eq!(count(Level::Everything), bowl.tree.events.len());
    let few = bowl.account(Level::Everything).steps(10);
    assert_eq!(few.left_out, bowl.tree.events.len() - 10);
    let words = few.left_out_in_words("slides").unwrap();
    assert!(words.contains(&few.left_out.to_string()) && words.contains("hold 10 at most"), "{words}");
    assert_eq!(bowl.account(Level::Story).steps(usize::MAX).left_out_in_words("slides"), None);
}

#[test]
fn a_worked_example_tells_every_step_in_order_and_names_its_drawings() {
    let bowl = Recorded::of("csg/bowl");
    let account = bowl.account(Level::Working);
    let paper = markdown(&account, Some("bowl"), PATIENT).unwrap();
    assert!(paper.text.starts_with("# ") && paper.text.contains("rayscope open 'rayscope:csg/bowl'"));
    let headings: Vec<&str> = paper.text.lines().filter(|line| line.starts_with("##")).collect();
    let steps = account.steps(usize::MAX);
    assert_eq!(headings.len(), steps.events.len());
    for (heading, &id) in headings.iter().zip(&steps.events) {
        assert!(heading.contains(row(bowl.tree.event(id)).icon), "{heading}");
    }
    assert!(!paper.figures.is_empty());
    for (name, svg) in &paper.figures {
        assert!(paper.text.contains(&format!("]({name})")), "{name}");
        assert!(svg.starts_with("<svg "));
    }
    let hit = paper.text.find("```text").unwrap();
    assert!(paper.text[hit..].contains(" = "));
}

#[test]
fn without_files_beside_it_a_worked_example_tells_its_drawings_in_words() {
    let paper = markdown(&Recorded::of("csg/bowl").account(Level::Story), None, PATIENT).unwrap();
    assert!(paper.figures.is_empty() && paper.text.contains("*Drawing:*") && !paper.text.contains("!["));
}

#[test]
fn every_row_of_a_table_has_as_many_cells_as_its_head() {
    let paper = markdown(&Recorded::of("csg/bowl").account(Level::Everything), None, PATIENT).unwrap();
    let cells = |line: &str| line.replace("\\|", "").matches('|').count();
    let tables: Vec<Vec<&str>> = paper
        .text
        .split("\n\n")
        .map(|block| block.lines().filter(|line| line.starts_with("| ")).collect())
        .filter(|lines: &Vec<&str>| !lines.is_empty())
        .collect();
    assert!(tables.len() > 2);
    for table in tables {
        assert!(table[1].starts_with("| --- ") && table.iter().all(|line| cells(line) == cells(table[0])), "{table:?}");
    }
}

#[test]
fn slides_ask_for_nothing_from_outside_and_hold_a_section_for_each_step() {
    let bowl = Recorded::of("csg/bowl");
    let account = bowl.account(Level::Story);
    let page = slides(&account, PATIENT).unwrap();
    assert_eq!(page.matches("<section ").count(), account.steps(usize::MAX).events.len());
    assert_eq!(page.matches("<section ").count(), page.matches("</section>").count());
    for outside in [" src=", "<link", "@import", "url(", "fetch("] {
        assert!(!page.contains(outside), "{outside}");
    }
    let addresses = page.matches("http").count();
    let harmless = page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count() + page.matches("http-equiv").count();
    assert_eq!(addresses, harmless);
    assert!(page.contains("class=\"light\"") && page.contains("class=\"dark\"") && page.contains("@media print"));
}

#[test]
fn names_with_markup_in_them_do_no_harm() {
    let mut bowl = Recorded::of("csg/bowl");
    bowl.scene.title = "<script>alert(1)</script> | *a*".to_owned();
    let account = bowl.account(Level::Story);
    assert!(!slides(&account, PATIENT).unwrap().contains("<script>alert"));
    let title = markdown(&account, None, PATIENT).unwrap().text.lines().next().unwrap().to_owned();
    assert_eq!(title, "# \\<script\\>alert(1)\\</script\\> \\| \\*a\\*");
}

#[test]
fn slides_as_pdf_have_a_page_for_each_step() {
    let bowl = Recorded::of("hello/sphere");
    let account = bowl.account(Level::Story);
    let file = slides_pdf(&account, PATIENT).unwrap();
    let count = format!("/Count {}", account.steps(usize::MAX).events.len());
    assert!(file.windows(count.len()).any(|at| at == count.as_bytes()));
}

#[test]
fn nothing_on_a_sheet_is_cut_off() {
    for name in ["csg/bowl", "hello/sphere"] {
        let recorded = Recorded::of(name);
        let account = recorded.account(Level::Working);
        let steps = account.steps(usize::MAX);
        for place in 0..steps.events.len() {
            for drawing in [sheet::Sheet::slide(&account, &steps, place), sheet::Sheet::frame(&account, &steps, place)]
            {
                assert_within(&drawing, name, place);
            }
        }
    }
}

fn assert_within(drawing: &Drawing, name: &str, place: usize) {
    for text in drawing.texts() {
        let frame = text.frame();
        assert!(drawing.frame().grown(1.0).holds(&frame), "{name}, step {place}: {} at {frame:?}", text.text);
    }
    assert!(drawing.description.starts_with(&format!("Step {} of ", place + 1)));
}

#[test]
fn a_moving_picture_has_a_frame_for_each_step_and_shows_the_last_for_longer() {
    let recorded = Recorded::of("hello/sphere");
    let views = [View::named("side").unwrap()];
    let account = Account { views: &views, ..recorded.account(Level::Story) };
    let count = account.steps(usize::MAX).events.len();
    let gif = animation(&account, Moving::Gif, 0.5, PATIENT).unwrap();
    let apng = animation(&account, Moving::Apng, 0.5, PATIENT).unwrap();
    let gif = GifDecoder::new(Cursor::new(gif)).unwrap().into_frames().collect_frames().unwrap();
    let apng = PngDecoder::new(Cursor::new(apng)).unwrap().apng().unwrap().into_frames().collect_frames().unwrap();
    assert_eq!((gif.len(), apng.len()), (count, count));
    let steps = account.steps(usize::MAX);
    for place in 0..count {
        let shown = Duration::from_millis(if place + 1 == count { 1000 } else { 500 });
        for frame in [&gif[place], &apng[place]] {
            assert_eq!(frame.buffer().dimensions(), (FRAME[0], FRAME[1]));
            assert_eq!(Duration::from(frame.delay()), shown);
        }
        let painted = crate::view::paint(&sheet::Sheet::frame(&account, &steps, place), 1.0).rgba;
        assert!(apng[place].buffer().as_raw().iter().zip(&painted).all(|(a, b)| a == b), "step {place}");
        let error: u64 =
            gif[place].buffer().as_raw().iter().zip(&painted).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        // On average over all pixels a GIF is off by less than a quarter of a level of 255.
        assert!((error as f64) < 0.25 * painted.len() as f64, "step {place}: {error}");
    }
}

#[test]
fn work_that_nobody_waits_for_is_given_up() {
    let bowl = Recorded::of("csg/bowl");
    let account = bowl.account(Level::Story);
    let impatient: Watch = &|done, _| done < 2;
    assert_eq!(markdown(&account, None, impatient), Err(Cancelled));
    assert_eq!(slides(&account, impatient), Err(Cancelled));
    assert_eq!(slides_pdf(&account, impatient), Err(Cancelled));
    assert_eq!(animation(&account, Moving::Gif, 1.0, impatient), Err(AnimationError::Cancelled));
}
