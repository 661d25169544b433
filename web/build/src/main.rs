//! Builds the pages of the rayscope workbench: a folder of static files that any web host can serve.
//!
//! `cargo run --release --manifest-path web/build/Cargo.toml -- -o dist` compiles the program to WebAssembly, makes its
//! bindings, gives every file but the first a name with a hash of its content, and writes what a browser may ask for
//! compressed beside each.

mod arguments;
mod bindings;
mod names;
mod pack;
mod program;
mod sizes;
mod sources;
mod write;

use arguments::{Asked, HELP};
use std::process::ExitCode;

fn main() -> ExitCode {
    let asked = match arguments::parse(std::env::args().skip(1)) {
        Ok(Some(asked)) => asked,
        Ok(None) => {
            print!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Err(error) => return failed(&error),
    };
    match build(&asked) {
        Ok(table) => {
            print!("{table}");
            ExitCode::SUCCESS
        }
        Err(error) => failed(&error),
    }
}

fn failed(error: &str) -> ExitCode {
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

/// Builds everything; the table of sizes is what there is to say afterwards.
fn build(asked: &Asked) -> Result<String, String> {
    let web = sources::web_folder();
    write::check(&asked.out)?;
    let wasm = match &asked.wasm {
        Some(file) => std::fs::read(file).map_err(|error| format!("{} cannot be read: {error}", file.display()))?,
        None => program::compile(&web)?,
    };
    let mut files = sources::page(&web)?;
    files.extend(bindings::make(wasm)?);
    let named = names::name(files)?;
    let packed = pack::pack(named, asked.is_compressed);
    write::write(&asked.out, &packed)?;
    let table = sizes::table(&packed);
    write::finish(&asked.out, &table)?;
    Ok(format!("{table}\n{} is ready to be served.\n", asked.out.display()))
}
