//! In a worker: tasks are done one by one as they come, and their news posted back.

use super::digest::Digests;
use crate::app::accuracy::chart::MapAccuracy;
use crate::app::accuracy::image::MeasureAccuracy;
use crate::app::compare::pictures::RenderWhole;
use crate::app::effects::job::MeasureEffects;
use crate::app::frame::task::Task;
use crate::app::picture::renderer::Render;
use crate::app::search::found::Find;
use crate::app::search::maps::Map;
use crate::app::story::until::Until;
use crate::folder::{Outside, files_of_scene};
use crate::scene::{Recipe, Scene};
use crate::trace::Progress;
use js_sys::{Object, Reflect, Uint8Array};
use std::cell::RefCell;
use std::sync::Arc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

thread_local! {
    /// The scene of the last task, with what it was made from: the next one is likely to be about it, too.
    static SCENE: RefCell<Option<(Vec<u8>, Arc<Scene>)>> = const { RefCell::new(None) };
}

/// Begins to listen.
pub fn listen() {
    let hear = Closure::<dyn FnMut(MessageEvent)>::new(|event: MessageEvent| {
        if let Err(why) = carry_out(&event.data()) {
            post("failed", &why.into());
        }
        post("end", &JsValue::TRUE);
    });
    scope().set_onmessage(Some(hear.into_js_value().unchecked_ref()));
    post("ready", &JsValue::TRUE);
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}

fn post(name: &str, value: &JsValue) {
    let message = Object::new();
    // A plain object takes any property, and a worker may always post.
    let _ = Reflect::set(&message, &name.into(), value);
    let _ = scope().post_message(&message);
}

fn carry_out(message: &JsValue) -> Result<(), String> {
    let part = |name: &str| Reflect::get(message, &name.into()).unwrap_or_default();
    let scene = scene(Uint8Array::new(&part("scene")).to_vec())?;
    let body = Uint8Array::new(&part("body")).to_vec();
    let name = part("task").as_string().unwrap_or_default();
    match name.as_str() {
        Render::NAME => run::<Render>(&scene, &body),
        RenderWhole::NAME => run::<RenderWhole>(&scene, &body),
        Find::NAME => run::<Find>(&scene, &body),
        Map::NAME => run::<Map>(&scene, &body),
        Until::NAME => run::<Until>(&scene, &body),
        MeasureEffects::NAME => run::<MeasureEffects>(&scene, &body),
        MeasureAccuracy::NAME => run::<MeasureAccuracy>(&scene, &body),
        MapAccuracy::NAME => run::<MapAccuracy>(&scene, &body),
        Digests::NAME => run::<Digests>(&scene, &body),
        other => Err(format!("no worker knows the task {other}")),
    }
}

fn run<T: Task>(scene: &Arc<Scene>, body: &[u8]) -> Result<(), String> {
    let task: T = postcard::from_bytes(body).map_err(|error| error.to_string())?;
    let progress = Progress::told_to(|done| post("done", &(done as f64).into()));
    task.run(scene, &progress, &mut |news| {
        if let Ok(bytes) = postcard::to_allocvec(&news) {
            post("news", &Uint8Array::from(bytes.as_slice()).into());
        }
    });
    Ok(())
}

fn scene(recipe: Vec<u8>) -> Result<Arc<Scene>, String> {
    let known =
        SCENE.with_borrow(|known| known.as_ref().filter(|(of, _)| *of == recipe).map(|(_, scene)| Arc::clone(scene)));
    if let Some(scene) = known {
        return Ok(scene);
    }
    let told: Recipe = postcard::from_bytes(&recipe).map_err(|error| error.to_string())?;
    let made = told.make(files_of_scene(&told.name, Outside::Refused).as_ref());
    let scene = Arc::new(made.map_err(|diagnostics| diagnostics.to_string())?);
    SCENE.replace(Some((recipe, Arc::clone(&scene))));
    Ok(scene)
}
