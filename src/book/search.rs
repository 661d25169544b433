//! The page to search on: with a script as one types, and without it by an index of terms.

use super::frame::{self, Head};
use super::glossary::by_name;
use super::{Book, BookFile};
use crate::view::escaped;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Something that can be found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// What it is called.
    pub title: String,
    /// Its path from the root of the book, with the place on the page.
    pub path: String,
    /// The words that it is found by, besides its title.
    pub words: String,
    /// Terms of the glossary that it speaks of.
    pub terms: Vec<String>,
}

/// The page and what its script searches in.
pub fn files(book: &mut Book) -> Vec<BookFile> {
    let mut page = book.page();
    page.put(
        "<h1>Search</h1>\n<form class=\"search\" role=\"search\" action=\"search.html\" method=\"get\">\n\
         <label for=\"query\">Words to look for</label>\n<input id=\"query\" name=\"q\" type=\"search\" autocomplete=\"off\">\n\
         <button>Search</button>\n</form>\n<p id=\"found\" role=\"status\"></p>\n<ol id=\"results\"></ol>\n\
         <noscript><p>The search needs JavaScript. The terms below lead to the same pages.</p></noscript>\n\
         <h2>Terms, and where they are spoken of</h2>\n",
    );
    page.put(terms(&book.entries, book));
    let head = Head {
        path: "search.html".to_owned(),
        title: "Search".to_owned(),
        about: "Words of the book, and all its terms with the steps that speak of them.".to_owned(),
        scripts: &["index.js", "search.js"],
        ..Head::default()
    };
    vec![page.finished(&head), frame::text("index.js", index(&book.entries))]
}

/// Each term with the steps that link to it.
fn terms(entries: &[Entry], book: &Book) -> String {
    let mut places: BTreeMap<&str, Vec<&Entry>> = BTreeMap::new();
    for entry in entries {
        for term in entry.terms.iter().collect::<BTreeSet<_>>() {
            places.entry(term.as_str()).or_default().push(entry);
        }
    }
    let mut out = "<dl class=\"terms\">\n".to_owned();
    for term in by_name(book.course) {
        let links: Vec<String> = places
            .get(term.name.as_str())
            .into_iter()
            .flatten()
            .map(|entry| format!("<li><a href=\"{}\">{}</a></li>", escaped(&entry.path), escaped(&entry.title)))
            .collect();
        let place = super::links::term(&term.name);
        let name = escaped(&shown(&term.name));
        let _ = write!(
            out,
            "<dt><a href=\"glossary.html#{place}\">{name}</a></dt>\n<dd><ul>{}</ul></dd>\n",
            links.concat()
        );
    }
    out + "</dl>\n"
}

/// A term as it is written: names of lessons' terms may have `_` for a space.
pub fn shown(term: &str) -> String {
    term.replace('_', " ")
}

/// The entries as a script, so that a page opened from a disk may read them.
fn index(entries: &[Entry]) -> String {
    let rows: Vec<String> = entries
        .iter()
        .map(|entry| {
            let words: BTreeSet<String> = words(&format!("{} {}", entry.words, entry.terms.join(" "))).collect();
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            format!("[{},{},{}]", quoted(&entry.title), quoted(&entry.path), quoted(&words.join(" ")))
        })
        .collect();
    format!("const INDEX = [\n{}\n];\n", rows.join(",\n"))
}

/// The words of a text, in lower case, without signs.
fn words(text: &str) -> impl Iterator<Item = String> {
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| word.len() > 1).map(str::to_lowercase)
}

/// A text as JavaScript writes it. `<` is written as an escape, since a script within a page would end at `</script>`.
fn quoted(text: &str) -> String {
    let mut out = "\"".to_owned();
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '<' | '\u{2028}' | '\u{2029}' => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out + "\""
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_is_a_script_that_no_text_breaks_out_of() {
        let entry = Entry {
            title: "\"</script>\\".to_owned(),
            path: "a.html#step-1".to_owned(),
            words: "Rays hit; rays miss.".to_owned(),
            terms: vec!["inside interval".to_owned()],
        };
        let text = index(&[entry]);
        assert_eq!(
            text,
            "const INDEX = [\n[\"\\\"\\u003c/script>\\\\\",\"a.html#step-1\",\"hit inside interval miss rays\"]\n];\n"
        );
    }
}
