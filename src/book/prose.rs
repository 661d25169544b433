//! The text of lessons as HTML.

use super::page::{Page, escaped_lines};
use super::{lesson_path, links};
use crate::lesson::Told;
use crate::lesson::prose::{Block, Inline, Piece, Target, code, latex};
use crate::view::escaped;

/// Headings within a step stand below its own, which is of the second level.
const HEADING: &str = "h3";

impl Page<'_> {
    /// Paragraphs and the like.
    pub fn prose(&mut self, prose: &[Block<Told>]) {
        for block in prose {
            self.block(block);
        }
    }

    /// The same with the terms of the glossary linked where they first stand.
    pub fn prose_with_terms(&mut self, prose: Vec<Block<Told>>) {
        let linked = self.course.glossary.linked(prose);
        self.prose(&linked);
    }

    fn block(&mut self, block: &Block<Told>) {
        match block {
            Block::Paragraph(line) => {
                let line = self.line(line);
                self.put(format_args!("<p>{line}</p>\n"));
            }
            Block::Heading(line) => {
                let line = self.line(line);
                self.put(format_args!("<{HEADING}>{line}</{HEADING}>\n"));
            }
            Block::List { numbered, items } => {
                let tag = if *numbered { "ol" } else { "ul" };
                self.put(format_args!("<{tag}>\n"));
                for item in items {
                    self.item(item);
                }
                self.put(format_args!("</{tag}>\n"));
            }
            Block::Quote(blocks) => {
                self.put("<blockquote>\n");
                self.prose(blocks);
                self.put("</blockquote>\n");
            }
            Block::Code(pieces) => {
                let text = escaped_lines(code(pieces).trim_end());
                self.put(format_args!("<pre tabindex=\"0\"><code>{text}</code></pre>\n"));
            }
            Block::Formula(pieces) => {
                let formula = self.formula(&latex(pieces), true);
                self.put(formula);
            }
            Block::Table { head, rows } => self.table(head, rows),
        }
    }

    /// A paragraph that is all there is of an item is not set off from the others.
    fn item(&mut self, item: &[Block<Told>]) {
        self.put("<li>");
        match item {
            [Block::Paragraph(line), rest @ ..] => {
                let line = self.line(line);
                self.put(line);
                self.prose(rest);
            }
            blocks => self.prose(blocks),
        }
        self.put("</li>\n");
    }

    /// A table that may be wider than the page.
    pub fn table(&mut self, head: &[Vec<Inline<Told>>], rows: &[Vec<Vec<Inline<Told>>>]) {
        self.put("<div class=\"table\" tabindex=\"0\"><table>\n<thead><tr>");
        for cell in head {
            let cell = self.line(cell);
            self.put(format_args!("<th scope=\"col\">{cell}</th>"));
        }
        self.put("</tr></thead>\n<tbody>\n");
        for row in rows {
            self.put("<tr>");
            for cell in row {
                let text = self.line(cell);
                let class = if is_number(cell) { " class=\"number\"" } else { "" };
                self.put(format_args!("<td{class}>{text}</td>"));
            }
            self.put("</tr>\n");
        }
        self.put("</tbody></table></div>\n");
    }

    /// A run of words.
    pub fn line(&mut self, line: &[Inline<Told>]) -> String {
        line.iter().map(|inline| self.inline(inline)).collect()
    }

    fn inline(&mut self, inline: &Inline<Told>) -> String {
        match inline {
            Inline::Text(text) => escaped(text),
            Inline::Value(value) => {
                format!("<data class=\"value\" value=\"{}\">{}</data>", escaped(&value.from), escaped(&value.text))
            }
            Inline::Emphasis(line) => format!("<em>{}</em>", self.line(line)),
            Inline::Strong(line) => format!("<strong>{}</strong>", self.line(line)),
            Inline::Code(pieces) => format!("<code>{}</code>", escaped(&code(pieces))),
            Inline::Formula(pieces) => self.formula(&latex(pieces), false),
            Inline::Link(target, line) => self.link(target, line),
            Inline::Break => "<br>".to_owned(),
        }
    }

    fn link(&mut self, target: &Target, line: &[Inline<Told>]) -> String {
        let words = self.line(line);
        match target {
            Target::Term(name) => {
                let Some(term) = self.course.glossary.find(name) else { return words };
                self.terms.push(term.name.clone());
                format!("<a class=\"term\" href=\"{}glossary.html#{}\">{words}</a>", self.root, links::term(&term.name))
            }
            Target::Lesson(id) if self.course.lesson(id).is_some() => {
                format!("<a href=\"{}{}\">{words}</a>", self.root, lesson_path(id))
            }
            Target::Lesson(_) => words,
            // The source does not come with the book: its file is named.
            Target::Source(path) => format!("{words} (<code>{}</code>)", escaped(path)),
        }
    }
}

/// Whether a cell holds nothing but a number, so that it is set to the right.
fn is_number(cell: &[Inline<Told>]) -> bool {
    let is_numeric =
        |text: &str| text.starts_with(|c: char| c.is_ascii_digit() || c == '−') && !text.contains(char::is_alphabetic);
    match cell {
        [Inline::Value(value)] => is_numeric(&value.text),
        [Inline::Formula(pieces)] => {
            pieces.iter().all(|piece| matches!(piece, Piece::Value(told) if is_numeric(&told.text)))
        }
        _ => false,
    }
}

/// The words of a text, for the search: formulas and code left out.
pub fn words_of(prose: &[Block<Told>]) -> String {
    let mut words = String::new();
    for block in prose {
        block.for_each_line(&mut |line| {
            collect(line, &mut words);
            words.push(' ');
        });
    }
    words
}

fn collect(line: &[Inline<Told>], words: &mut String) {
    for inline in line {
        match inline {
            Inline::Text(text) => words.push_str(text),
            Inline::Value(value) => words.push_str(&value.text),
            Inline::Emphasis(line) | Inline::Strong(line) | Inline::Link(_, line) => collect(line, words),
            Inline::Code(_) | Inline::Formula(_) | Inline::Break => words.push(' '),
        }
    }
}
