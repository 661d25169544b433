//! Makes the JavaScript through which a page and the program talk.

use crate::sources::File;
use wasm_bindgen_cli_support::Bindgen;

/// The name of the program and of its bindings, without what follows the dot.
const NAME: &str = "rayscope";

/// The bindings as a module, what they import, and the program as they expect it.
pub fn make(wasm: Vec<u8>) -> Result<Vec<File>, String> {
    let mut bindgen = Bindgen::new();
    bindgen.input_bytes(NAME, wasm).typescript(false).remove_name_section(true).remove_producers_section(true);
    // The page hands the compiled module over, so the bindings need not know the file's name.
    bindgen.omit_default_module_path(true);
    let bindgen = bindgen.web(true).map_err(|error| told(&error))?;
    let mut output = bindgen.generate_output().map_err(|error| told(&error))?;
    let mut files = vec![
        File::new(format!("files/{NAME}.js"), output.js().as_bytes().to_vec()),
        File::new(format!("files/{NAME}.wasm"), output.wasm_mut().emit_wasm()),
    ];
    for (path, text) in output.local_modules() {
        files.push(File::new(format!("files/snippets/{path}"), text.as_bytes().to_vec()));
    }
    for (name, texts) in output.snippets() {
        let inline = |(i, text): (usize, &String)| {
            File::new(format!("files/snippets/{name}/inline{i}.js"), text.as_bytes().to_vec())
        };
        files.extend(texts.iter().enumerate().map(inline));
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

fn told(error: &impl std::fmt::Debug) -> String {
    format!("the bindings of the program cannot be made: {error:?}")
}
