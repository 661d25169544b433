//! The workbench in a page.

use super::account::Account;
use super::address::Address;
use super::asked::carry_out;
use super::{Journals, host, worker};
use crate::app::frame::background::Background;
use crate::app::window::{Start, Window};
use crate::folder::Outside;
use crate::scene::embedded_scene;
use eframe::{CreationContext, Frame, Storage, WebOptions, WebRunner};
use egui::{Context, Ui};
use serde_json::json;
use std::cell::RefCell;
use std::rc::Rc;
use std::time::Duration;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlCanvasElement;

/// The scene of the first visit: that of the README.
const FIRST: &str = "csg/bowl";
/// What was done is kept this often: a page may go away without a word.
const KEEPING: Duration = Duration::from_secs(2);

/// Starts the workbench on the page's canvas; in a worker, waits for tasks.
pub fn run_in_browser() {
    if web_sys::window().is_none() {
        worker::listen();
        return;
    }
    // A second logger would be refused; the first one does as well.
    let _ = eframe::WebLogger::init(log::LevelFilter::Warn);
    let Ok(canvas) = host::property("canvas").dyn_into::<HtmlCanvasElement>() else {
        host::failed("the page has no canvas to draw on");
        return;
    };
    let runner = WebRunner::new();
    tell_panics();
    wasm_bindgen_futures::spawn_local(async move {
        let create = |creation: &CreationContext| Page::new(creation);
        let app =
            Box::new(move |creation: &CreationContext<'_>| Ok(Box::new(create(creation)) as Box<dyn eframe::App>));
        if let Err(error) = runner.start(canvas, WebOptions::default(), app).await {
            host::failed(&error.as_string().unwrap_or_else(|| format!("{error:?}")));
        }
    });
}

/// Lets the page say why the program ended. What was done before is done still: eframe's own hook stops its event loop.
fn tell_panics() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        host::failed(&info.to_string());
        before(info);
    }));
}

/// The workbench with what a page has besides: an address, and somebody who listens.
struct Page {
    window: Window,
    address: Address,
    account: Account,
    /// What the page has asked for since the last frame.
    asked: Rc<RefCell<Vec<String>>>,
    /// Digests that are being worked out.
    digests: Option<Background<Vec<String>>>,
}

impl Page {
    fn new(creation: &CreationContext) -> Self {
        let address = Address::default();
        let text = embedded_scene(FIRST).map_or_else(String::new, |scene| scene.text.to_owned());
        let link = address.link().map(Box::new);
        let shows_lesson = link.as_ref().is_some_and(|link| link.lesson.is_some());
        let start = Start { name: FIRST.to_owned(), text, outside: Outside::Refused, link, lessons: None };
        let mut window = Window::new(creation, start);
        if host::property("embed").is_string() {
            window.workbench.embed(shows_lesson);
        } else {
            window.workbench.keep_edits(Journals::in_browser());
        }
        Self { window, address, account: Account::offered(), asked: listen(&creation.egui_ctx), digests: None }
    }
}

/// Lets the page ask for something; it is done in the next frame.
fn listen(ctx: &Context) -> Rc<RefCell<Vec<String>>> {
    let asked = Rc::new(RefCell::new(Vec::new()));
    let (inbox, ctx) = (Rc::clone(&asked), ctx.clone());
    host::offer("receive", move |value| {
        inbox.borrow_mut().extend(value.as_string());
        ctx.request_repaint();
        JsValue::UNDEFINED
    });
    asked
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut Ui, frame: &mut Frame) {
        let workbench = &mut self.window.workbench;
        for text in self.asked.take() {
            self.digests = carry_out(workbench, &text).or(self.digests.take());
        }
        self.address.lead(workbench);
        self.window.ui(ui, frame);
        let workbench = &mut self.window.workbench;
        // The reader's way back leads through the page around a frame, not through what was looked at in it.
        if !workbench.is_embedded {
            self.address.follow(ui.ctx(), workbench);
        }
        self.account.give(ui.ctx(), workbench);
        if let Some(lines) = self.digests.as_ref().and_then(Background::take) {
            self.digests = None;
            host::tell(&json!({ "type": "digests", "lines": lines }).to_string());
        }
    }

    /// A frame in somebody's page keeps nothing: the reader's own workbench stays as it was left.
    fn save(&mut self, storage: &mut dyn Storage) {
        if !self.window.workbench.is_embedded {
            self.window.save(storage);
        }
    }

    fn auto_save_interval(&self) -> Duration {
        KEEPING
    }
}
