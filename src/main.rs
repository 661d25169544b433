//! The `rayscope` program: the workbench, or one of its commands. In a browser it is the workbench alone.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    rayscope::cli::run()
}

#[cfg(target_arch = "wasm32")]
fn main() {
    rayscope::app::run_in_browser();
}
