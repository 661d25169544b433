//! Starting the workbench on a desktop.

use super::window;
use crate::app::opening::first_scene;
use crate::app::window::Start;
use crate::folder::Outside;
use crate::lesson_folder::Lessons;
use crate::share::link::Link;

/// Opens the workbench on the text of a scene and stays until its window is closed.
///
/// `name` is the scene's name, or its file's; `outside` says whether it may name pictures outside its folder. A scene with errors is no reason not to open: the window shows them. A link is followed as soon as the window is there.
///
/// # Errors
///
/// One line that says why there is no window, and what to do without one.
pub fn run(name: &str, text: String, outside: Outside, link: Option<Link>) -> Result<(), String> {
    if !has_display() {
        return Err(without_display("there is no display"));
    }
    let start = Start { name: name.to_owned(), text, outside, link: link.map(Box::new), lessons: None };
    window::open(start).map_err(|error| without_display(&none_opened(&error.to_string())))
}

/// Opens the workbench on a lesson and stays until its window is closed.
///
/// # Errors
///
/// One line that says why there is no window, and what to do without one.
pub fn run_lesson(lessons: Lessons) -> Result<(), String> {
    if !has_display() {
        return Err(without_display("there is no display"));
    }
    let (name, text) = first_scene().map_or_else(Default::default, |scene| (scene.name, scene.text.to_owned()));
    let start = Start { name, text, outside: Outside::Refused, link: None, lessons: Some(lessons) };
    window::open(start).map_err(|error| without_display(&none_opened(&error.to_string())))
}

/// Elsewhere than on Unix desktops a display is taken for granted.
fn has_display() -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !cfg!(all(unix, not(target_os = "macos"))) || set("DISPLAY") || set("WAYLAND_DISPLAY") || set("WAYLAND_SOCKET")
}

fn without_display(why: &str) -> String {
    format!(
        "the workbench needs a window, and {why}; without one, `rayscope trace SCENE --pixel X,Y` tells the same story as text"
    )
}

/// What the system said, on one line and without the places in source files that libraries put before it.
fn none_opened(error: &str) -> String {
    let reason = error.rsplit(": ").next().unwrap_or(error);
    format!("none could be opened ({})", reason.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_display_one_line_names_the_way_out() {
        let message = without_display(&none_opened("os error at linux/mod.rs:788: cannot\n  connect"));
        assert!(!message.contains("mod.rs"));
        assert!(!message.contains('\n'));
        assert!(message.contains("cannot connect") && message.contains("rayscope trace"));
    }
}
