//! The page's workers, each with an instance of the program that shares no memory with this one.
//!
//! A worker that is at work hears nothing: whoever gives up its task ends it, and the next task gets a new one. No headers are needed
//! for that, as shared memory would ask for.

use super::host;
use crate::app::frame::background::{Background, Results};
use crate::app::frame::task::Task;
use crate::scene::Scene;
use egui::Context;
use js_sys::{Object, Reflect, Uint8Array};
use serde::de::DeserializeOwned;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

/// The most tasks that a picture is spread over: each worker compiles the scene for itself.
const MOST_SHARES: u32 = 8;
/// The most workers that are kept for the next task.
const MOST_IDLE: usize = 8;

thread_local! {
    static POOL: RefCell<Pool> = const { RefCell::new(Pool { idle: Vec::new(), busy: BTreeMap::new(), next: 0 }) };
}

struct Pool {
    idle: Vec<Worker>,
    busy: BTreeMap<u64, Busy>,
    next: u64,
}

/// A worker with its task.
struct Busy {
    worker: Worker,
    /// The task, until the worker is ready for it.
    waiting: Option<Object>,
    _hear: Closure<dyn FnMut(MessageEvent)>,
    _fail: Closure<dyn FnMut(JsValue)>,
}

/// Over how many tasks a picture is spread: one for each core but the page's own.
pub fn shares() -> u32 {
    let cores = web_sys::window().map_or(1.0, |window| window.navigator().hardware_concurrency());
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is a small whole number")]
    let others = (cores as u32).saturating_sub(1);
    others.clamp(1, MOST_SHARES)
}

/// Sends a task to a worker; where there are none, does it on the page's own thread.
pub fn begin_task<T: Task>(ctx: &Context, scene: &Arc<Scene>, task: T) -> Option<Background<T::News>> {
    let Some(order) = order(scene, &task) else { return here(ctx, scene, task) };
    let Some((worker, is_ready)) = take_idle().or_else(|| Some((new_worker()?, false))) else {
        return here(ctx, scene, task);
    };
    let (job, results) = Background::of(ctx);
    let id = POOL.with_borrow_mut(|pool| {
        pool.next += 1;
        pool.next
    });
    let hear = hearing(id, results);
    // The results go with the closures.
    let fail = Closure::new(move |_| end(id, false));
    worker.set_onmessage(Some(hear.as_ref().unchecked_ref()));
    worker.set_onerror(Some(fail.as_ref().unchecked_ref()));
    let waiting = if is_ready { send(&worker, &order) } else { Some(order) };
    POOL.with_borrow_mut(|pool| pool.busy.insert(id, Busy { worker, waiting, _hear: hear, _fail: fail }));
    Some(job.or_else(move || end(id, false)))
}

fn here<T: Task>(ctx: &Context, scene: &Arc<Scene>, task: T) -> Option<Background<T::News>> {
    let scene = Arc::clone(scene);
    Background::start(ctx, T::NAME, move |progress, publish| task.run(&scene, progress, publish))
}

/// What a worker is told.
fn order<T: Task>(scene: &Scene, task: &T) -> Option<Object> {
    let (scene, body) = (postcard::to_allocvec(&scene.recipe()).ok()?, postcard::to_allocvec(task).ok()?);
    let order = Object::new();
    let parts: [(&str, JsValue); 3] = [
        ("task", T::NAME.into()),
        ("scene", Uint8Array::from(scene.as_slice()).into()),
        ("body", Uint8Array::from(body.as_slice()).into()),
    ];
    parts.iter().all(|(name, value)| Reflect::set(&order, &(*name).into(), value).is_ok()).then_some(order)
}

/// Sends an order; returns it where it could not be sent, which only a worker that was ended makes.
fn send(worker: &Worker, order: &Object) -> Option<Object> {
    worker.post_message(order).is_err().then(|| order.clone())
}

fn take_idle() -> Option<(Worker, bool)> {
    POOL.with_borrow_mut(|pool| pool.idle.pop()).map(|worker| (worker, true))
}

/// A worker that begins to load the program; none where the browser lets a page have none.
fn new_worker() -> Option<Worker> {
    let (address, glue, module) =
        (host::property("worker").as_string()?, host::property("glue"), host::property("module"));
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    let worker = Worker::new_with_options(&address, &options).ok()?;
    let program = Object::new();
    Reflect::set(&program, &"glue".into(), &glue).ok()?;
    Reflect::set(&program, &"module".into(), &module).ok()?;
    worker.post_message(&program).ok()?;
    Some(worker)
}

/// What is done with a worker's messages.
fn hearing<N: DeserializeOwned + Send + 'static>(id: u64, results: Results<N>) -> Closure<dyn FnMut(MessageEvent)> {
    Closure::new(move |event: MessageEvent| {
        let data = event.data();
        let part = |name: &str| Reflect::get(&data, &name.into()).ok().filter(|part| !part.is_undefined());
        if part("ready").is_some() {
            begin_waiting(id);
        } else if let Some(done) = part("done").and_then(|done| done.as_f64()) {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of pixels")]
            results.progress().set_done(done as usize);
            results.look();
        } else if let Some(bytes) = part("news") {
            match postcard::from_bytes(&Uint8Array::new(&bytes).to_vec()) {
                Ok(news) => results.publish(news),
                Err(error) => log::error!("a worker's news make no sense: {error}"),
            }
        } else if let Some(why) = part("failed") {
            log::error!("a worker cannot do its task: {}", why.as_string().unwrap_or_default());
        } else if part("end").is_some() {
            end(id, true);
        }
    })
}

fn begin_waiting(id: u64) {
    POOL.with_borrow_mut(|pool| {
        if let Some(busy) = pool.busy.get_mut(&id)
            && let Some(order) = busy.waiting.take()
        {
            busy.waiting = send(&busy.worker, &order);
        }
    });
}

/// Ends a task: its worker is kept for the next one if it is done, and ended if not.
fn end(id: u64, is_done: bool) {
    let busy = POOL.with_borrow_mut(|pool| {
        let busy = pool.busy.remove(&id)?;
        if is_done && pool.idle.len() < MOST_IDLE {
            pool.idle.push(busy.worker.clone());
        } else {
            busy.worker.terminate();
        }
        Some(busy)
    });
    // Only now, outside the pool: with the closures the results go, which ask for a repaint.
    drop(busy);
}
