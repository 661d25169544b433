//! The page's address: a link behind its `#` says what is seen, so that it can be copied, kept as a bookmark, and gone back to.

use crate::app::workbench::Workbench;
use crate::share::link::Link;
use egui::Context;
use std::time::Duration;
use wasm_bindgen::JsValue;
use web_time::Instant;

/// How long what is seen has to rest before it is written into the address: browsers refuse more than a hundred changes in half a minute.
const REST: Duration = Duration::from_millis(400);

/// What the address says, as far as we know.
#[derive(Default)]
pub struct Address {
    /// What stands behind the `#`.
    written: String,
    /// What is to be written, and since when it has been so.
    due: Option<(String, Instant)>,
    /// The scene, the pixel and the lesson's step that the last entry of the history has.
    place: Option<Place>,
    /// A link is being followed: until that is done, what is seen is not what the address means.
    is_led: bool,
}

/// What one goes back to: a change of anything else changes the address, but makes no entry in the history.
#[derive(Clone, Debug, PartialEq)]
struct Place {
    scene: String,
    pixel: Option<[u32; 2]>,
    step: Option<(String, usize)>,
}

impl Place {
    fn of(workbench: &Workbench) -> Option<Self> {
        Some(Self {
            scene: workbench.scene()?.name.clone(),
            pixel: workbench.recording().map(|recording| recording.pixel),
            step: workbench.lesson().place().map(|(lesson, step)| (lesson.to_owned(), step)),
        })
    }
}

impl Address {
    /// The link that the page was opened with; none if there is none, or it makes no sense.
    pub fn link(&self) -> Option<Link> {
        behind_the_sign().parse().ok()
    }

    /// Follows the address where a person has changed it, or gone back or forward.
    pub fn lead(&mut self, workbench: &mut Workbench) {
        let now = behind_the_sign();
        if now == self.written {
            return;
        }
        self.written.clone_from(&now);
        self.due = None;
        match now.parse::<Link>() {
            Ok(link) if self.place.is_some() => {
                let ctx = workbench.ctx();
                workbench.follow(&ctx, &link);
                self.is_led = true;
            }
            // The link of the start is followed by the workbench itself.
            Ok(_) => self.is_led = true,
            Err(_) if now.is_empty() => {}
            Err(error) => workbench.refuse(&now, error.to_string()),
        }
    }

    /// Writes what is seen into the address once it rests.
    pub fn follow(&mut self, ctx: &Context, workbench: &Workbench) {
        if workbench.is_opening() || workbench.stepping().is_recording() {
            return;
        }
        let Ok(link) = workbench.link() else { return };
        if link == self.written {
            (self.due, self.is_led) = (None, false);
            self.place = Place::of(workbench);
            return;
        }
        match &self.due {
            Some((due, since)) if *due == link && since.elapsed() >= REST => self.write(workbench, link),
            Some((due, _)) if *due == link => ctx.request_repaint_after(REST),
            _ => {
                self.due = Some((link, Instant::now()));
                ctx.request_repaint_after(REST);
            }
        }
    }

    fn write(&mut self, workbench: &Workbench, link: String) {
        let place = Place::of(workbench);
        let is_elsewhere = self.place.is_some() && self.place != place && !self.is_led;
        if let Some(history) = web_sys::window().and_then(|window| window.history().ok()) {
            let address = format!("#{link}");
            // A browser that refuses leaves the address as it is; nothing else depends on it.
            let _ = if is_elsewhere {
                history.push_state_with_url(&JsValue::NULL, "", Some(&address))
            } else {
                history.replace_state_with_url(&JsValue::NULL, "", Some(&address))
            };
        }
        // The browser may write some signs otherwise.
        self.written = behind_the_sign();
        (self.due, self.place, self.is_led) = (None, place, false);
    }
}

/// What stands behind the `#` of the page's address.
fn behind_the_sign() -> String {
    let hash = web_sys::window().and_then(|window| window.location().hash().ok()).unwrap_or_default();
    hash.strip_prefix('#').unwrap_or(&hash).to_owned()
}
