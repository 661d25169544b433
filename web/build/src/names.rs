//! Gives files names that hold a hash of their content, and puts these names where files refer to each other.
//!
//! What has such a name never changes, so a browser may keep it for ever, and two versions of the page never share a file
//! by mistake. Only what people and browsers find by name keeps it: `index.html`, `sw.js`, and the examples.
//!
//! A reference is a path in quotes that begins with `./`, relative to the file that it is in: `"./files/boot.js"` in
//! `index.html`, `from "./mirror.js"` in `files/boot.js`. In `index.html`, `{bytes of NAME}` becomes a file's size.
//! In `sw.js`, `/* {files} */` becomes the list of all files, `{page}` the name of a copy of `index.html`
//! that goes with them, and `{version}` a hash over all of it.

use crate::sources::File;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;

/// A file with the name that it is served under.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// The path in the repository.
    pub source: String,
    /// The file as it is served.
    pub file: File,
    /// The paths in the repository of what it refers to.
    pub refers_to: Vec<String>,
}

/// The copy of the first page that the service worker keeps: the first page's own name may already mean another version.
const PAGE_COPY: &str = "files/page.html";
const FIRST: &str = "index.html";
const WORKER: &str = "sw.js";

/// Names all files.
pub fn name(sources: Vec<File>) -> Result<Vec<Named>, String> {
    let (mut waiting, last): (Vec<File>, Vec<File>) = sources.into_iter().partition(|file| file.path != WORKER);
    let mut named: Vec<Named> = Vec::new();
    while !waiting.is_empty() {
        let paths: Vec<String> = waiting.iter().map(|file| file.path.clone()).collect();
        let is_ready = |file: &File| paths.iter().all(|path| *path == file.path || !refers(file, path));
        let (ready, rest): (Vec<File>, Vec<File>) = waiting.into_iter().partition(is_ready);
        if ready.is_empty() {
            return Err(format!(
                "these files refer to each other in a ring, so none can be named: {}",
                paths.join(", ")
            ));
        }
        named.extend(ready.into_iter().map(|file| filled(file, &named)).collect::<Vec<_>>());
        waiting = rest;
    }
    let first =
        named.iter().find(|named| named.source == FIRST).ok_or_else(|| format!("web/page/{FIRST} is missing"))?;
    let copy = File::new(PAGE_COPY.to_owned(), first.file.bytes.clone());
    named.push(filled(copy, &[]));
    for worker in last {
        named.push(with_list(worker, &named));
    }
    named.sort_by(|a, b| a.file.path.cmp(&b.file.path));
    Ok(named)
}

/// The path of `to` as the file `from` writes it, if it lies where it can be written so.
fn relative(from: &str, to: &str) -> Option<String> {
    let folder = from.rfind('/').map_or("", |at| &from[..=at]);
    to.strip_prefix(folder).map(|rest| format!("./{rest}"))
}

fn is_text(path: &str) -> bool {
    let end = path.rsplit('.').next().unwrap_or_default();
    ["html", "css", "js", "svg", "webmanifest"].contains(&end)
}

fn refers(file: &File, path: &str) -> bool {
    let Some(reference) = relative(&file.path, path).filter(|_| is_text(&file.path)) else { return false };
    let text = String::from_utf8_lossy(&file.bytes);
    written(&file.path, &reference).iter().any(|written| text.contains(written))
        || text.contains(&format!("{{bytes of {reference}}}"))
}

/// The ways in which a file writes a reference. In a script only what is imported is one: the bindings name the same file a
/// second time, as what the program calls it by.
fn written(from: &str, reference: &str) -> Vec<String> {
    let before: &[&str] = if is_script(from) { &["from ", "import "] } else { &[""] };
    let quoted = |quote: char| before.iter().map(move |before| format!("{before}{quote}{reference}{quote}"));
    ['"', '\''].into_iter().flat_map(quoted).collect()
}

fn is_script(path: &str) -> bool {
    path.rsplit('.').next() == Some("js")
}

/// The file with the names of all that it refers to, under its own name.
fn filled(file: File, named: &[Named]) -> Named {
    let source = file.path.clone();
    let wanted: Vec<&Named> = named.iter().filter(|other| refers(&file, &other.source)).collect();
    let refers_to = wanted.iter().map(|other| other.source.clone()).collect();
    let mut bytes = file.bytes;
    if !wanted.is_empty() {
        let mut text = String::from_utf8_lossy(&bytes).into_owned();
        for other in wanted {
            text = replaced(&text, &source, other);
        }
        bytes = text.into_bytes();
    }
    let path = if source.starts_with("files/") { hashed(&source, &bytes) } else { source.clone() };
    Named { source, file: File::new(path, bytes), refers_to }
}

fn replaced(text: &str, from: &str, other: &Named) -> String {
    let (Some(before), Some(after)) = (relative(from, &other.source), relative(from, &other.file.path)) else {
        return text.to_owned();
    };
    let pairs = written(from, &before).into_iter().zip(written(from, &after));
    let text = pairs.fold(text.to_owned(), |text, (before, after)| text.replace(&before, &after));
    text.replace(&format!("{{bytes of {before}}}"), &other.file.bytes.len().to_string())
}

/// `files/boot.js` as `files/boot.1f2e3d4c5b6a7988.js`.
fn hashed(path: &str, bytes: &[u8]) -> String {
    let (stem, end) = path.rsplit_once('.').unwrap_or((path, ""));
    format!("{stem}.{}.{end}", hash(bytes))
}

fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().take(8).fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// The service worker with the list of what it keeps.
fn with_list(worker: File, named: &[Named]) -> Named {
    let kept = |named: &&Named| named.source != FIRST && named.source != PAGE_COPY;
    let list: Vec<String> = named.iter().filter(kept).map(|named| format!("\"./{}\"", named.file.path)).collect();
    let copy = named.iter().find(|named| named.source == PAGE_COPY).map(|named| format!("./{}", named.file.path));
    let contents: Vec<u8> = named.iter().flat_map(|named| hash(&named.file.bytes).into_bytes()).collect();
    let text = String::from_utf8_lossy(&worker.bytes)
        .replace("/* {files} */", &list.join(", "))
        .replace("{page}", &copy.unwrap_or_default())
        .replace("{version}", &hash(&contents));
    Named { source: worker.path.clone(), file: File::new(worker.path, text.into_bytes()), refers_to: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(path: &str, text: &str) -> File {
        File::new(path.to_owned(), text.as_bytes().to_vec())
    }

    fn site(boot: &str) -> Vec<File> {
        vec![
            file("index.html", r#"<script src="./files/boot.js" data-size="{bytes of ./files/boot.js}"></script>"#),
            file("files/boot.js", boot),
            file("files/part.js", "export const part = 1;"),
            file("sw.js", r#"const FILES = [/* {files} */], PAGE = "{page}", VERSION = "{version}";"#),
            file("examples/embed.html", "<p>as it is</p>"),
        ]
    }

    fn named(boot: &str) -> Vec<Named> {
        name(site(boot)).expect("the files refer to each other in no ring")
    }

    fn text<'a>(named: &'a [Named], source: &str) -> &'a str {
        let of = |named: &'a Named| std::str::from_utf8(&named.file.bytes).expect("only texts are in this test");
        named.iter().find(|named| named.source == source).map_or("", of)
    }

    fn path<'a>(named: &'a [Named], source: &str) -> &'a str {
        named.iter().find(|named| named.source == source).map_or("", |named| &named.file.path)
    }

    #[test]
    fn a_reference_is_to_the_hashed_name_and_sizes_are_filled_in() {
        let boot = r#"import { part } from "./part.js";"#;
        let named = named(boot);
        assert!(text(&named, "files/boot.js").contains(&path(&named, "files/part.js").replace("files/", "./")));
        assert!(text(&named, "index.html").contains(&format!("\"./{}\"", path(&named, "files/boot.js"))));
        let size = text(&named, "files/boot.js").len();
        assert!(text(&named, "index.html").contains(&format!("data-size=\"{size}\"")));
    }

    #[test]
    fn only_what_is_found_by_name_keeps_its_name() {
        let named = named("");
        for kept in ["index.html", "sw.js", "examples/embed.html"] {
            assert_eq!(path(&named, kept), kept);
        }
        assert_eq!(path(&named, "files/part.js").len(), "files/part.js".len() + 17);
    }

    #[test]
    fn a_change_in_a_part_changes_the_names_of_all_that_refer_to_it() {
        let before = named(r#"import "./part.js";"#);
        let mut sources = site(r#"import "./part.js";"#);
        sources[2].bytes.push(b'\n');
        let after = name(sources).expect("the files refer to each other in no ring");
        for source in ["files/part.js", "files/boot.js", PAGE_COPY] {
            assert_ne!(path(&before, source), path(&after, source), "{source}");
        }
        assert_ne!(text(&before, "sw.js"), text(&after, "sw.js"));
    }

    #[test]
    fn the_service_worker_knows_all_files_and_the_page_that_goes_with_them() {
        let named = named("");
        let worker = text(&named, "sw.js");
        for source in ["files/boot.js", "files/part.js", "examples/embed.html", PAGE_COPY] {
            assert!(worker.contains(&format!("\"./{}\"", path(&named, source))), "{source}");
        }
        assert!(!worker.contains("index.html"));
        assert!(!worker.contains('{'), "a placeholder is left: {worker}");
    }

    #[test]
    fn what_a_script_says_without_importing_it_stays() {
        let boot = r#"import * as part from "./part.js"; const imports = { "./part.js": part };"#;
        let named = named(boot);
        assert!(text(&named, "files/boot.js").ends_with(r#"{ "./part.js": part };"#));
        assert!(!text(&named, "files/boot.js").contains(r#"from "./part.js""#));
    }

    #[test]
    fn files_that_refer_to_each_other_in_a_ring_are_named_in_the_error() {
        let mut sources = site(r#"import "./part.js";"#);
        sources[2] = file("files/part.js", r#"import "./boot.js";"#);
        assert!(name(sources).is_err_and(|error| error.contains("files/boot.js, files/part.js")));
    }
}
