//! The page that the program runs in: what it offers, as an object of functions, and what it is told.
//!
//! The page's side is `web/page/boot.js`; both sides and their messages are described in `web/README.md`.

use js_sys::{Array, Function, Object, Reflect, Uint8Array};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};

/// The name of the object among the page's globals.
const NAME: &str = "rayscopeHost";

/// The page's object; nothing in it where the program runs in a page that has none.
fn host() -> JsValue {
    Reflect::get(&js_sys::global(), &NAME.into())
        .ok()
        .filter(JsValue::is_object)
        .unwrap_or_else(|| Object::new().into())
}

/// Something that the page offers.
pub fn property(name: &str) -> JsValue {
    Reflect::get(&host(), &name.into()).unwrap_or(JsValue::UNDEFINED)
}

/// Offers the page a function that is called with one value.
pub fn offer(name: &str, function: impl FnMut(JsValue) -> JsValue + 'static) {
    let closure = Closure::<dyn FnMut(JsValue) -> JsValue>::new(function);
    // A page that cannot hold it does not call it.
    let _ = Reflect::set(&host(), &name.into(), &closure.into_js_value());
}

/// Calls a function of the page. A page that has none of this name does not want to know.
pub fn call(name: &str, arguments: &[&JsValue]) {
    if let Ok(function) = property(name).dyn_into::<Function>() {
        let list: Array = arguments.iter().copied().collect();
        // What goes wrong in the page is the page's to tell.
        let _ = function.apply(&JsValue::NULL, &list);
    }
}

/// The first frame with a picture was painted.
pub fn shown() {
    call("shown", &[]);
}

/// The program cannot go on.
pub fn failed(why: &str) {
    call("failed", &[&why.into()]);
}

/// Lets a person download a file.
pub fn save(name: &str, kind: &str, bytes: &[u8]) {
    call("save", &[&name.into(), &kind.into(), &Uint8Array::from(bytes).into()]);
}

/// Lets a person choose a file; `given` is called with its name and what is in it, or not at all.
pub fn open(accept: &str, given: impl FnOnce(String, Vec<u8>) + 'static) {
    let mut given = Some(given);
    let call_back = Closure::<dyn FnMut(JsValue, JsValue)>::new(move |name: JsValue, bytes: JsValue| {
        if let Some(given) = given.take() {
            given(name.as_string().unwrap_or_default(), Uint8Array::new(&bytes).to_vec());
        }
    });
    call("open", &[&accept.into(), &call_back.into_js_value()]);
}

/// What screen readers are told, as JSON.
pub fn mirror(json: &str) {
    call("mirror", &[&json.into()]);
}

/// What the page around an embedded workbench is told, as JSON.
pub fn tell(json: &str) {
    call("tell", &[&json.into()]);
}
