//! The page of the glossary.

use super::frame::Head;
use super::links;
use super::prose::words_of;
use super::search::{Entry, shown};
use super::{Book, BookFile};
use crate::lesson::prose::{Block, Inline, Line, Piece, Prose, Reference};
use crate::lesson::{Course, Term, Told};
use crate::view::escaped;

/// All terms with what they mean.
pub fn file(book: &mut Book) -> BookFile {
    let course = book.course;
    let mut page = book.page();
    page.put("<h1>Glossary</h1>\n<dl class=\"glossary\">\n");
    for term in by_name(course) {
        let name = shown(&term.name);
        page.put(format_args!("<dt id=\"{}\">{}", links::term(&term.name), escaped(&name)));
        if !term.also.is_empty() {
            page.put(format_args!(" <span class=\"also\">{}</span>", escaped(&term.also.join(", "))));
        }
        page.put("</dt>\n<dd>");
        let meaning = without_values(&term.meaning);
        page.prose(&meaning);
        page.put("</dd>\n");
        let path = format!("glossary.html#{}", links::term(&term.name));
        page.entries.push(Entry {
            title: format!("{name} (glossary)"),
            path,
            words: words_of(&meaning),
            terms: Vec::new(),
        });
    }
    page.put("</dl>\n");
    let head = Head {
        path: "glossary.html".to_owned(),
        title: "Glossary".to_owned(),
        about: "The terms of the course, and what they mean.".to_owned(),
        ..Head::default()
    };
    let file = page.finished(&head);
    // A term is spoken of in a step; that the glossary mentions it as well leads nowhere new.
    page.terms.clear();
    book.keep(&mut page);
    file
}

/// The terms as a reader looks for them: capital letters count as small ones.
pub fn by_name(course: &Course) -> Vec<&Term> {
    let mut terms: Vec<&Term> = course.glossary.terms.iter().collect();
    terms.sort_by_key(|term| term.name.to_lowercase());
    terms
}

/// A glossary belongs to no ray, so that it has no values: where one stands all the same, nothing is said.
pub fn without_values(prose: &[Block<Reference>]) -> Prose<Told> {
    prose.iter().map(block).collect()
}

fn block(block_of: &Block<Reference>) -> Block<Told> {
    match block_of {
        Block::Paragraph(text) => Block::Paragraph(line(text)),
        Block::Heading(text) => Block::Heading(line(text)),
        Block::List { numbered, items } => {
            Block::List { numbered: *numbered, items: items.iter().map(|item| without_values(item)).collect() }
        }
        Block::Quote(blocks) => Block::Quote(without_values(blocks)),
        Block::Code(parts) => Block::Code(pieces(parts)),
        Block::Formula(parts) => Block::Formula(pieces(parts)),
        Block::Table { head, rows } => {
            let cells = |cells: &Vec<Line<Reference>>| cells.iter().map(|cell| line(cell)).collect();
            Block::Table { head: cells(head), rows: rows.iter().map(cells).collect() }
        }
    }
}

fn line(text: &[Inline<Reference>]) -> Line<Told> {
    let inline = |inline: &Inline<Reference>| {
        Some(match inline {
            Inline::Text(text) => Inline::Text(text.clone()),
            Inline::Value(_) => return None,
            Inline::Emphasis(text) => Inline::Emphasis(line(text)),
            Inline::Strong(text) => Inline::Strong(line(text)),
            Inline::Code(parts) => Inline::Code(pieces(parts)),
            Inline::Formula(parts) => Inline::Formula(pieces(parts)),
            Inline::Link(target, text) => Inline::Link(target.clone(), line(text)),
            Inline::Break => Inline::Break,
        })
    };
    text.iter().filter_map(inline).collect()
}

fn pieces(parts: &[Piece<Reference>]) -> Vec<Piece<Told>> {
    let texts = parts.iter().filter_map(|piece| match piece {
        Piece::Text(text) => Some(Piece::Text(text.clone())),
        Piece::Value(_) => None,
    });
    texts.collect()
}
