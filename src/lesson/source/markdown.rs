//! Markdown as a lesson has it: paragraphs, lists, quotes, tables, formulas, links within the course.

use super::references::{Masked, mask};
use super::typed_numbers;
use crate::lesson::place::Findings;
use crate::lesson::prose::{Block, Inline, Line, Piece, Prose, Reference, Target};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, LinkType, Options, Parser, Tag, TagEnd};
use std::iter::Peekable;
use std::ops::Range;

/// A part of the file between its headings and fenced blocks.
#[derive(Debug)]
pub enum Part {
    /// Text.
    Block(Block<Reference>),
    /// A heading that begins a step.
    Step {
        /// Its words.
        title: String,
        /// Its byte.
        offset: usize,
    },
    /// A fenced block with a word after the fence.
    Fenced {
        /// The word.
        word: String,
        /// The bytes of what is in it.
        range: Range<usize>,
        /// Its byte.
        offset: usize,
    },
}

/// Reads a whole file's text, from `base` on.
pub fn parts(text: &str, base: usize, findings: &mut Findings) -> Vec<Part> {
    Reader::new(text, base, findings).parts()
}

/// Reads a piece of Markdown within a block: it has neither steps nor fenced blocks.
pub fn read_prose(text: &str, base: usize, findings: &mut Findings) -> Prose<Reference> {
    let parts = Reader::new(text, base, findings).parts();
    let mut prose = Vec::new();
    for part in parts {
        match part {
            Part::Block(block) => prose.push(block),
            Part::Step { offset, .. } | Part::Fenced { offset, .. } => {
                findings.add(offset, "a heading or a fenced block has no place here");
            }
        }
    }
    prose
}

struct Reader<'r, 'f> {
    findings: &'r mut Findings<'f>,
    references: Vec<Option<Reference>>,
    base: usize,
    masked: String,
}

type Events<'a> = Peekable<pulldown_cmark::OffsetIter<'a>>;

impl<'r, 'f> Reader<'r, 'f> {
    fn new(text: &str, base: usize, findings: &'r mut Findings<'f>) -> Self {
        let fenced = outside_of_fences(text);
        let Masked { text: masked, references } = mask(&fenced, base, findings);
        Self { findings, references, base, masked }
    }

    fn parts(mut self) -> Vec<Part> {
        let masked = std::mem::take(&mut self.masked);
        let options = Options::ENABLE_TABLES | Options::ENABLE_MATH | Options::ENABLE_STRIKETHROUGH;
        let mut events = Parser::new_ext(&masked, options).into_offset_iter().peekable();
        let mut parts = Vec::new();
        while let Some((event, range)) = events.next() {
            if let Some(part) = self.part(event, range, &mut events) {
                parts.push(part);
            }
        }
        parts
    }

    fn part(&mut self, event: Event, range: Range<usize>, events: &mut Events) -> Option<Part> {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H2, .. }) => {
                let line = self.line(events, TagEnd::Heading(HeadingLevel::H2));
                let title = line.iter().map(|inline| if let Inline::Text(text) = inline { text.as_str() } else { "" });
                Some(Part::Step { title: title.collect(), offset: self.base + range.start })
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(word))) if !word.is_empty() => {
                let mut inner: Option<Range<usize>> = None;
                for (event, range) in events.by_ref() {
                    match event {
                        Event::Text(_) => inner = Some(inner.map_or(range.clone(), |inner| inner.start..range.end)),
                        Event::End(TagEnd::CodeBlock) => break,
                        _ => {}
                    }
                }
                let range_in_file = inner.unwrap_or(range.end..range.end);
                let range_in_file = self.base + range_in_file.start..self.base + range_in_file.end;
                Some(Part::Fenced { word: word.to_string(), range: range_in_file, offset: self.base + range.start })
            }
            event => self.block(&event, range.start, events).map(Part::Block),
        }
    }

    fn block(&mut self, event: &Event, start: usize, events: &mut Events) -> Option<Block<Reference>> {
        match event {
            Event::Start(Tag::Paragraph) => Some(self.paragraph(events)),
            Event::Start(Tag::Heading { level, .. }) => {
                if *level == HeadingLevel::H1 {
                    self.findings.add(self.base + start, "the title stands in the header: begin steps with `##`");
                }
                Some(Block::Heading(self.line(events, TagEnd::Heading(*level))))
            }
            Event::Start(Tag::BlockQuote(kind)) => Some(Block::Quote(self.blocks(events, TagEnd::BlockQuote(*kind)))),
            Event::Start(Tag::List(start)) => {
                let numbered = start.is_some();
                let mut items = Vec::new();
                while let Some((event, _)) = events.next() {
                    match event {
                        Event::Start(Tag::Item) => items.push(self.item(events)),
                        Event::End(TagEnd::List(_)) => break,
                        _ => {}
                    }
                }
                Some(Block::List { numbered, items })
            }
            Event::Start(Tag::CodeBlock(_)) => {
                let mut pieces = Vec::new();
                for (event, _) in events.by_ref() {
                    match event {
                        Event::Text(text) => pieces.extend(self.pieces(&text)),
                        Event::End(TagEnd::CodeBlock) => break,
                        _ => {}
                    }
                }
                Some(Block::Code(pieces))
            }
            Event::Start(Tag::Table(_)) => Some(self.table(events)),
            Event::Start(_) | Event::Html(_) | Event::Rule => {
                self.findings.add(self.base + start, "this kind of Markdown is not told in lessons");
                None
            }
            _ => None,
        }
    }

    fn blocks(&mut self, events: &mut Events, end: TagEnd) -> Prose<Reference> {
        let mut blocks = Vec::new();
        while let Some((event, range)) = events.next() {
            if event == Event::End(end) {
                break;
            }
            blocks.extend(self.block(&event, range.start, events));
        }
        blocks
    }

    /// An item of a list: blocks, or where it is tight, a line and what is below it.
    fn item(&mut self, events: &mut Events) -> Prose<Reference> {
        let mut blocks = Vec::new();
        let mut line = Vec::new();
        while let Some((event, range)) = events.next() {
            match event {
                Event::End(TagEnd::Item) => break,
                Event::Start(
                    Tag::Paragraph
                    | Tag::List(_)
                    | Tag::BlockQuote(_)
                    | Tag::CodeBlock(_)
                    | Tag::Table(_)
                    | Tag::Heading { .. },
                ) => {
                    if !line.is_empty() {
                        blocks.push(Block::Paragraph(std::mem::take(&mut line)));
                    }
                    blocks.extend(self.block(&event, range.start, events));
                }
                event => self.inline(event, &range, events, &mut line),
            }
        }
        if !line.is_empty() {
            blocks.push(Block::Paragraph(line));
        }
        blocks
    }

    /// A formula that is alone in its paragraph stands on a line of its own.
    fn paragraph(&mut self, events: &mut Events) -> Block<Reference> {
        let mut line = Vec::new();
        let mut display = None;
        while let Some((event, range)) = events.next() {
            match event {
                Event::End(TagEnd::Paragraph) => break,
                Event::DisplayMath(latex) => {
                    let pieces = self.formula(&latex, range.start);
                    display = Some(pieces.clone());
                    line.push(Inline::Formula(pieces));
                }
                event => self.inline(event, &range, events, &mut line),
            }
        }
        match display {
            Some(pieces) if line.len() == 1 => Block::Formula(pieces),
            _ => Block::Paragraph(line),
        }
    }

    fn line(&mut self, events: &mut Events, end: TagEnd) -> Line<Reference> {
        let mut line = Vec::new();
        while let Some((event, range)) = events.next() {
            if event == Event::End(end) {
                break;
            }
            self.inline(event, &range, events, &mut line);
        }
        line
    }

    fn inline(&mut self, event: Event, range: &Range<usize>, events: &mut Events, line: &mut Line<Reference>) {
        match event {
            Event::Text(text) => self.text(&text, range.start, line),
            Event::Code(code) => line.push(Inline::Code(self.formula(&code, range.start))),
            Event::InlineMath(latex) | Event::DisplayMath(latex) => {
                line.push(Inline::Formula(self.formula(&latex, range.start)));
            }
            Event::SoftBreak => self.text(" ", range.start, line),
            Event::HardBreak => line.push(Inline::Break),
            Event::Start(Tag::Emphasis) => line.push(Inline::Emphasis(self.line(events, TagEnd::Emphasis))),
            Event::Start(Tag::Strong) => line.push(Inline::Strong(self.line(events, TagEnd::Strong))),
            Event::Start(Tag::Link { link_type, dest_url, .. }) => {
                let words = self.line(events, TagEnd::Link);
                match target(&dest_url) {
                    Some(target) if link_type == LinkType::Inline => {
                        self.findings.keep_link(self.base + range.start, target.clone());
                        line.push(Inline::Link(target, words));
                    }
                    _ => {
                        let message =
                            format!("`{dest_url}` leads nowhere: links begin with `term:`, `lesson:` or `source:`");
                        self.findings.add(self.base + range.start, message);
                        line.extend(words);
                    }
                }
            }
            Event::Start(_) | Event::InlineHtml(_) => {
                self.findings.add(self.base + range.start, "this kind of Markdown is not told in lessons");
            }
            _ => {}
        }
    }

    /// Words and values, joined to the words before them.
    fn text(&mut self, text: &str, offset: usize, line: &mut Line<Reference>) {
        if let Some((at, number)) = typed_numbers::in_text(&lettered(text)) {
            let message = format!(
                "`{number}` is a typed number: say where it comes from, as in {{{{hit.t}}}}, or write it in words"
            );
            self.findings.add(self.base + offset + at.min(text.len()), message);
        }
        if let Some(at) = text.find('$') {
            self.findings
                .add(self.base + offset + at, "this `$` begins no formula: it is not closed, or a space follows it");
        }
        for piece in Masked::pieces(text) {
            match (piece, line.last_mut()) {
                (Ok(text), Some(Inline::Text(last))) => last.push_str(&text),
                (Ok(text), _) => line.push(Inline::Text(text)),
                (Err(number), _) => line.extend(self.reference(number).map(Inline::Value)),
            }
        }
    }

    fn formula(&mut self, text: &str, offset: usize) -> Vec<Piece<Reference>> {
        if let Some((at, number)) = typed_numbers::in_formula(text) {
            let message = format!("`{number}` is a typed number: formulas and code have whole numbers alone");
            self.findings.add(self.base + offset + at, message);
        }
        self.pieces(text)
    }

    fn pieces(&self, text: &str) -> Vec<Piece<Reference>> {
        let pieces = Masked::pieces(text).into_iter();
        pieces
            .filter_map(|piece| match piece {
                Ok(text) => Some(Piece::Text(text)),
                Err(number) => self.reference(number).map(Piece::Value),
            })
            .collect()
    }

    fn reference(&self, number: usize) -> Option<Reference> {
        self.references.get(number).cloned().flatten()
    }

    fn table(&mut self, events: &mut Events) -> Block<Reference> {
        let (mut head, mut rows) = (Vec::new(), Vec::new());
        let mut cells = Vec::new();
        while let Some((event, _)) = events.next() {
            match event {
                Event::Start(Tag::TableCell) => cells.push(self.line(events, TagEnd::TableCell)),
                Event::End(TagEnd::TableHead) => head = std::mem::take(&mut cells),
                Event::End(TagEnd::TableRow) => rows.push(std::mem::take(&mut cells)),
                Event::End(TagEnd::Table) => break,
                _ => {}
            }
        }
        Block::Table { head, rows }
    }
}

/// The text with letters in place of what stands for values, as long as before.
fn lettered(text: &str) -> String {
    let is_private = |c: char| ('\u{e000}'..='\u{f8ff}').contains(&c) || c == '\u{7f}';
    text.chars().flat_map(|c| if is_private(c) { ['a'].repeat(c.len_utf8()) } else { vec![c] }).collect()
}

fn target(url: &str) -> Option<Target> {
    let (scheme, to) = url.split_once(':')?;
    let to = to.replace("%20", " ").replace('_', if scheme == "term" { " " } else { "_" });
    match scheme {
        "term" => Some(Target::Term(to)),
        "lesson" => Some(Target::Lesson(to)),
        "source" => Some(Target::Source(to)),
        _ => None,
    }
}

/// The text with `{{` in fenced blocks put out of sight: their values are read with the blocks. As long as before.
fn outside_of_fences(text: &str) -> String {
    let mut seen = String::with_capacity(text.len());
    let mut in_fence = false;
    for line in text.split_inclusive('\n') {
        let is_fence = line.trim_start().starts_with("```");
        in_fence ^= is_fence;
        let hides = in_fence || is_fence;
        if hides { seen.push_str(&line.replace("{{", "((").replace("}}", "))")) } else { seen.push_str(line) }
    }
    seen
}
