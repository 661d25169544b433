//! Tells how much travels.

use crate::pack::Packed;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Bytes of a file as it is, as gzip, and as Brotli.
type Sizes = [usize; 3];

/// A table of all files, and what travels until the first picture is there.
pub fn table(files: &[Packed]) -> String {
    let needed = needed(files);
    let mut text = format!("{:>12} {:>12} {:>12}\n", "bytes", "gzip", "Brotli");
    for file in files {
        let mark = if needed.contains(file.named.source.as_str()) { "" } else { "  (later)" };
        line(&mut text, sizes(file), &format!("{}{mark}", file.named.file.path));
    }
    let first = files.iter().filter(|file| needed.contains(file.named.source.as_str()));
    line(&mut text, total(first), "to the first picture");
    line(&mut text, total(files.iter()), "all of it");
    text
}

fn line(text: &mut String, [raw, gzip, brotli]: Sizes, name: &str) {
    let _ = writeln!(text, "{raw:>12} {gzip:>12} {brotli:>12}  {name}");
}

fn sizes(file: &Packed) -> Sizes {
    let raw = file.named.file.bytes.len();
    let size = |variant: &Option<Vec<u8>>| variant.as_ref().map_or(raw, Vec::len);
    [raw, size(&file.gzip), size(&file.brotli)]
}

fn total<'a>(files: impl Iterator<Item = &'a Packed>) -> Sizes {
    files.map(sizes).fold([0; 3], |[a, b, c], [x, y, z]| [a + x, b + y, c + z])
}

/// The first page and all that it refers to, but for what a browser asks for only when the page is installed.
fn needed(files: &[Packed]) -> BTreeSet<&str> {
    let mut needed = BTreeSet::new();
    let mut waiting = vec!["index.html"];
    while let Some(source) = waiting.pop() {
        let Some(file) = files.iter().find(|file| file.named.source == source) else { continue };
        if !source.ends_with(".webmanifest") && needed.insert(source) {
            waiting.extend(file.named.refers_to.iter().map(String::as_str));
        }
    }
    needed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::names::Named;
    use crate::sources::File;

    fn file(path: &str, size: usize, refers_to: &[&str]) -> Packed {
        let refers_to = refers_to.iter().map(|&path| path.to_owned()).collect();
        let file = File::new(path.to_owned(), vec![0; size]);
        let named = Named { source: path.to_owned(), file, refers_to };
        Packed { named, gzip: Some(vec![0; size / 2]), brotli: None }
    }

    #[test]
    fn what_the_first_page_leads_to_is_added_up() {
        let files = [
            file("files/a.js", 100, &[]),
            file("files/b.webmanifest", 1000, &[]),
            file("index.html", 10, &["files/a.js", "files/b.webmanifest"]),
            file("sw.js", 10_000, &[]),
        ];
        let table = table(&files);
        let line = |name: &str| table.lines().find(|line| line.ends_with(name)).unwrap_or_default();
        let numbers = |name| line(name).split_whitespace().take(3).collect::<Vec<_>>().join(" ");
        assert_eq!(numbers("to the first picture"), "110 55 110");
        assert_eq!(numbers("all of it"), "11110 5555 11110");
    }
}
