//! What every page has around its text, and the files that all pages share.

use super::BookFile;
use super::page::Page;
use crate::view::{FontRole, escaped, fonts};
use std::fmt::Write as _;

const STYLE: &str = include_str!("../../assets/book/book.css");
const SCRIPT: &str = include_str!("../../assets/book/search.js");
const LICENCE: &str = include_str!("../../assets/fonts/OFL.txt");

/// The pages that every page leads to.
const PLACES: [(&str, &str); 5] = [
    ("index.html", "Contents"),
    ("sections.html", "Sections"),
    ("glossary.html", "Glossary"),
    ("examples.html", "Worked examples"),
    ("search.html", "Search"),
];

/// What a page is called, and what lies around it.
#[derive(Clone, Debug, Default)]
pub struct Head {
    /// Its path from the root of the book.
    pub path: String,
    /// What it is called.
    pub title: String,
    /// What it is about, in a sentence.
    pub about: String,
    /// The page before: its path from the root and its title.
    pub before: Option<(String, String)>,
    /// The page after it.
    pub after: Option<(String, String)>,
    /// Scripts that it runs, by their paths from the root.
    pub scripts: &'static [&'static str],
}

/// The style, the script and the fonts.
pub fn files() -> Vec<BookFile> {
    let mut css = String::new();
    let mut files = Vec::new();
    for font in fonts() {
        let path = format!("fonts/{}.ttf", font.name);
        let (family, weight) = match font.role {
            FontRole::Sans => ("Noto Sans", "400"),
            FontRole::Bold => ("Noto Sans", "700"),
            FontRole::Mono => ("Noto Sans Mono", "400"),
            FontRole::Fallback => ("Noto Sans Math", "400"),
        };
        let range = range(font.role, font.name);
        let _ = writeln!(
            css,
            "@font-face{{font-family:\"{family}\";font-weight:{weight};src:url(\"{path}\");font-display:swap{range}}}"
        );
        files.push(BookFile { path, bytes: font.bytes.to_vec() });
    }
    files.push(text("book.css", css + STYLE));
    files.push(text("search.js", SCRIPT.to_owned()));
    files.push(text("fonts/OFL.txt", LICENCE.to_owned()));
    files
}

/// Fonts of the same family are asked for what they have.
fn range(role: FontRole, name: &str) -> &'static str {
    match (role, name) {
        (FontRole::Fallback, "NotoSansSymbols2-Regular") => ";unicode-range:U+2300-27BF,U+2B00-2BFF",
        (FontRole::Fallback, "NotoSansSymbols-Regular") => ";unicode-range:U+2460-24FF",
        _ => "",
    }
}

/// A file of text.
pub fn text(path: &str, text: String) -> BookFile {
    BookFile { path: path.to_owned(), bytes: text.into_bytes() }
}

impl Page<'_> {
    /// The whole page.
    pub fn finished(&self, head: &Head) -> BookFile {
        let root = self.root;
        let mut scripts = String::new();
        for path in head.scripts {
            let _ = writeln!(scripts, "<script src=\"{root}{path}\" defer></script>");
        }
        let html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<title>{} · rayscope</title>\n\
             <meta name=\"description\" content=\"{}\">\n<link rel=\"stylesheet\" href=\"{root}book.css\">\n\
             <style>{}</style>\n{scripts}</head>\n<body>\n<a class=\"skip\" href=\"#content\">Skip to the text</a>\n{}{}\
             <main id=\"content\">\n{}</main>\n{}<footer><p>Every number in this book comes out of a recorded ray. \
             Made by <code>rayscope book</code>.</p></footer>\n</body>\n</html>\n",
            escaped(&head.title),
            escaped(&head.about),
            self.colours.css(),
            self.letters.definitions(),
            self.header(head),
            self.body,
            self.neighbours(head),
        );
        text(&head.path, html)
    }

    fn header(&self, head: &Head) -> String {
        let root = self.root;
        let link = |(path, name): &(&str, &str)| {
            let here = if *path == head.path { " aria-current=\"page\"" } else { "" };
            format!("<li><a href=\"{root}{path}\"{here}>{name}</a></li>")
        };
        let links: String = PLACES.iter().map(link).collect();
        format!(
            "<header class=\"site\"><p class=\"book\"><a href=\"{root}index.html\">rayscope</a></p>\
             <nav aria-label=\"Book\"><ul>{links}</ul></nav></header>\n"
        )
    }

    fn neighbours(&self, head: &Head) -> String {
        let link = |neighbour: &Option<(String, String)>, rel: &str, word: &str| {
            neighbour.as_ref().map_or_else(String::new, |(path, title)| {
                let (path, title) = (escaped(path), escaped(title));
                format!("<a rel=\"{rel}\" href=\"{}{path}\"><span>{word}</span> {title}</a>", self.root)
            })
        };
        let links = link(&head.before, "prev", "Before") + &link(&head.after, "next", "Next");
        if links.is_empty() {
            return links;
        }
        format!("<nav class=\"neighbours\" aria-label=\"Before and next\">{links}</nav>\n")
    }
}
