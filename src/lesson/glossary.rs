//! The glossary: terms with what they mean, and where they stand in a text.

use super::place::{Finding, Findings};
use super::prose::{Block, Inline, Line, Prose, Reference, Target, Told};
use super::source::read_prose;
use std::collections::BTreeSet;

/// A term.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The term, singular and in lower case.
    pub name: String,
    /// Other forms of it.
    pub also: Vec<String>,
    /// What it means.
    pub meaning: Prose<Reference>,
}

/// All terms, by name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Glossary {
    /// The terms.
    pub terms: Vec<Term>,
}

impl Glossary {
    /// Reads `glossary.md`: `## term`, perhaps a line `also: …`, and what it means.
    #[must_use]
    pub fn read(file: &str, text: &str) -> (Self, Vec<Finding>) {
        let mut findings = Findings::new(file, text);
        let mut terms: Vec<Term> = Vec::new();
        let mut offset = 0;
        let mut sections = Vec::new();
        for line in text.split_inclusive('\n') {
            if let Some(name) = line.strip_prefix("## ") {
                sections.push((name.trim().to_owned(), offset, offset + line.len(), text.len()));
                let count = sections.len();
                if count > 1 {
                    sections[count - 2].3 = offset;
                }
            }
            offset += line.len();
        }
        for (name, at, from, to) in sections {
            let body = &text[from..to];
            let (also, skipped) = match body.trim_start().strip_prefix("also:") {
                Some(rest) => {
                    let line = rest.lines().next().unwrap_or("");
                    (line.split(',').map(|form| form.trim().to_owned()).collect(), body.len() - rest.len() + line.len())
                }
                None => (Vec::new(), 0),
            };
            let meaning = read_prose(&body[skipped..], from + skipped, &mut findings);
            if meaning.is_empty() {
                findings.add(at, format!("`{name}` is not explained"));
            }
            if terms.iter().any(|term| term.name == name) {
                findings.add(at, format!("`{name}` is explained twice"));
            }
            terms.push(Term { name, also, meaning });
        }
        terms.sort_by(|a, b| a.name.cmp(&b.name));
        (Self { terms }, findings.sorted())
    }

    /// The term of that name, or with that other form.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Term> {
        // Links are written without spaces.
        let plain = |text: &str| text.replace(['-', '_'], " ").to_lowercase();
        let is_it = |form: &str| plain(form) == plain(name);
        self.terms.iter().find(|term| is_it(&term.name) || term.also.iter().any(|form| is_it(form)))
    }

    /// The term that is called most like this.
    #[must_use]
    pub fn nearest(&self, name: &str) -> Option<&str> {
        let distance = |term: &&Term| strsim::damerau_levenshtein(&term.name, &name.to_lowercase());
        self.terms.iter().min_by_key(distance).map(|term| term.name.as_str())
    }

    /// The text with each term linked where it first stands.
    #[must_use]
    pub fn linked(&self, prose: Prose<Told>) -> Prose<Told> {
        let mut linker = Linker { forms: self.forms(), seen: BTreeSet::new() };
        prose.into_iter().map(|block| linker.block(block)).collect()
    }

    /// All forms with their terms, the longest first: `inside interval` is not to be linked as `interval`.
    fn forms(&self) -> Vec<(String, String)> {
        let mut forms: Vec<(String, String)> = self
            .terms
            .iter()
            .flat_map(|term| {
                let all = std::iter::once(&term.name).chain(&term.also);
                all.map(|form| (form.to_lowercase(), term.name.clone())).collect::<Vec<_>>()
            })
            .filter(|(form, _)| !form.is_empty())
            .collect();
        forms.sort_by(|a, b| b.0.len().cmp(&a.0.len()).then_with(|| a.cmp(b)));
        forms
    }
}

struct Linker {
    forms: Vec<(String, String)>,
    seen: BTreeSet<String>,
}

impl Linker {
    fn block(&mut self, block: Block<Told>) -> Block<Told> {
        match block {
            Block::Paragraph(line) => Block::Paragraph(self.line(line)),
            Block::List { numbered, items } => {
                let items = items.into_iter().map(|item| item.into_iter().map(|block| self.block(block)).collect());
                Block::List { numbered, items: items.collect() }
            }
            Block::Quote(blocks) => Block::Quote(blocks.into_iter().map(|block| self.block(block)).collect()),
            block => block,
        }
    }

    fn line(&mut self, line: Line<Told>) -> Line<Told> {
        let mut linked = Vec::new();
        for inline in line {
            match inline {
                Inline::Text(text) => self.text(&text, &mut linked),
                Inline::Link(Target::Term(name), words) => {
                    self.seen.insert(name.clone());
                    linked.push(Inline::Link(Target::Term(name), words));
                }
                Inline::Emphasis(line) => linked.push(Inline::Emphasis(self.line(line))),
                Inline::Strong(line) => linked.push(Inline::Strong(self.line(line))),
                inline => linked.push(inline),
            }
        }
        linked
    }

    fn text(&mut self, text: &str, linked: &mut Line<Told>) {
        let Some((range, term)) = self.first_term(text) else {
            linked.push(Inline::Text(text.to_owned()));
            return;
        };
        self.seen.insert(term.clone());
        if range.start > 0 {
            self.text(&text[..range.start], linked);
        }
        linked.push(Inline::Link(Target::Term(term), vec![Inline::Text(text[range.clone()].to_owned())]));
        if range.end < text.len() {
            self.text(&text[range.end..], linked);
        }
    }

    /// The longest term in a text that was not linked yet, as a word of its own.
    fn first_term(&self, text: &str) -> Option<(std::ops::Range<usize>, String)> {
        let lower = text.to_lowercase();
        if lower.len() != text.len() {
            return None;
        }
        let is_end = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric() && c != '-');
        self.forms.iter().filter(|(_, term)| !self.seen.contains(term)).find_map(|(form, term)| {
            let found = lower.match_indices(form.as_str()).find(|(at, _)| {
                is_end(lower[..*at].chars().next_back()) && is_end(lower[at + form.len()..].chars().next())
            });
            found.map(|(at, _)| (at..at + form.len(), term.clone()))
        })
    }
}
