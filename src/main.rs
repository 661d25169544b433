//! The `rayscope` program: the workbench, or one of its commands.

fn main() -> std::process::ExitCode {
    rayscope::cli::run()
}
