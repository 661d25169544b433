//! Work on the page's only thread, each piece in a turn of its own, so that frames come between.

use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError};
use std::time::Duration;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Puts work off until the browser has nothing else to do; returns whether it will be done.
pub fn begin(_name: &str, work: impl FnOnce() + 'static) -> bool {
    let Some(window) = web_sys::window() else {
        // In a worker nobody is waited for.
        work();
        return true;
    };
    let callback = Closure::once_into_js(work);
    window.set_timeout_with_callback(callback.unchecked_ref()).is_ok()
}

/// Does work that somebody waits for: putting it off would cost a frame and save nothing.
pub fn begin_at_once(_name: &str, work: impl FnOnce()) -> bool {
    work();
    true
}

/// What was sent. There is no waiting here: nobody else could send meanwhile.
///
/// # Errors
/// If nothing came, or never will.
pub fn receive_within<T>(receiver: &Receiver<T>, _patience: Duration) -> Result<T, RecvTimeoutError> {
    receiver.try_recv().map_err(|error| match error {
        TryRecvError::Empty => RecvTimeoutError::Timeout,
        TryRecvError::Disconnected => RecvTimeoutError::Disconnected,
    })
}
