//! Hands for the workbench: opening it, pressing keys, clicking, and finding things by the names that a screen reader reads out.
#![allow(dead_code, reason = "each test file uses some of them")]

pub mod editing;

use egui::accesskit::Role;
use egui::{Event, Key, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use rayscope::app::{Command, Pane, Workbench};
use rayscope::folder::Outside;
use rayscope::record::What;
use rayscope::scene::embedded_scene;
use rayscope::story::Level;
use std::time::{Duration, Instant};

pub type Bench<'a> = Harness<'a, Option<Workbench>>;

/// Long enough for the slowest machine; a test that waits this long has failed.
pub const PATIENCE: Duration = Duration::from_mins(3);

pub fn open_at<'a>(scene: &str, size: Vec2) -> Bench<'a> {
    let text = embedded_scene(scene).expect("the scene is embedded").text;
    open_text(scene, text, size)
}

/// Opens the text of a scene.
pub fn open_text<'a>(name: &str, text: &str, size: Vec2) -> Bench<'a> {
    let (name, text) = (name.to_owned(), text.to_owned());
    let show = move |ui: &mut egui::Ui, workbench: &mut Option<Workbench>| {
        workbench.get_or_insert_with(|| Workbench::new(ui.ctx(), &name, &text, Outside::Refused)).ui(ui);
    };
    let mut bench = Harness::builder().with_size(size).build_ui_state(show, None);
    settle(&mut bench);
    bench
}

pub fn open<'a>(scene: &str) -> Bench<'a> {
    open_at(scene, Vec2::new(1280.0, 800.0))
}

/// A few frames: for layout, focus and events to arrive, and for what is being opened or recorded to be shown.
pub fn settle(bench: &mut Bench) {
    for _ in 0..4 {
        bench.step();
    }
    let is_waiting = |bench: &Bench| {
        bench.state().as_ref().is_some_and(|bench| bench.is_opening() || bench.stepping().is_recording())
    };
    if is_waiting(bench) {
        wait_until(bench, "the scene and the recording", |bench| !is_waiting(bench));
        settle(bench);
    }
}

/// Tells the story at another level.
pub fn tell(bench: &mut Bench, level: Level) {
    workbench_mut(bench).set_level(level);
    settle(bench);
}

pub fn workbench<'b>(bench: &'b Bench) -> &'b Workbench {
    bench.state().as_ref().expect("the workbench was shown")
}

pub fn workbench_mut<'b>(bench: &'b mut Bench) -> &'b mut Workbench {
    bench.state_mut().as_mut().expect("the workbench was shown")
}

/// Brings a panel to the front.
pub fn reveal(bench: &mut Bench, pane: Pane) {
    workbench_mut(bench).reveal(pane);
    settle(bench);
}

/// Runs a command, as its menu or key does.
pub fn run(bench: &mut Bench, command: impl Into<Command>) {
    workbench_mut(bench).run(command.into());
    settle(bench);
}

pub fn wait_until(bench: &mut Bench, what: &str, done: impl Fn(&Bench) -> bool) {
    let begin = Instant::now();
    while !done(bench) {
        assert!(begin.elapsed() < PATIENCE, "waited in vain for {what}");
        std::thread::sleep(Duration::from_millis(5));
        bench.step();
    }
}

pub fn selected(bench: &Bench) -> u32 {
    workbench(bench).recording().expect("a pixel is recorded").selected()
}

pub fn pixel(bench: &Bench) -> [u32; 2] {
    workbench(bench).recording().expect("a pixel is recorded").pixel
}

pub fn press(bench: &mut Bench, key: Key) {
    bench.key_press(key);
    settle(bench);
}

pub fn click(bench: &mut Bench, at: Pos2) {
    bench.event(Event::PointerMoved(at));
    for pressed in [true, false] {
        bench.event(Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: egui::Modifiers::default(),
        });
    }
    settle(bench);
}

/// The middle of a pixel on screen.
pub fn place_of(bench: &Bench, [x, y]: [u32; 2]) -> Pos2 {
    let image = workbench(bench).scene().expect("a scene is open").scene.image;
    let rect = bench.get_by_label("Rendered image").rect();
    let share = Vec2::new((x as f32 + 0.5) / image.width as f32, (y as f32 + 0.5) / image.height as f32);
    rect.min + share * rect.size()
}

pub fn rows(bench: &Bench) -> Vec<String> {
    bench.query_all_by_role(Role::TreeItem).filter_map(|row| row.accesskit_node().label()).collect()
}

pub fn row_of(bench: &Bench, part: &str) -> String {
    rows(bench).into_iter().find(|row| row.contains(part)).unwrap_or_else(|| panic!("no row says `{part}`"))
}

/// The first event of a kind.
pub fn find(bench: &Bench, kind: impl Fn(&What) -> bool) -> u32 {
    let recording = workbench(bench).recording().expect("a pixel is recorded");
    recording.tree.events.iter().find(|event| kind(&event.what)).expect("such an event happened").id
}
