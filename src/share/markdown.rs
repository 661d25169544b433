//! A worked example as Markdown: the ray's story with its formulas, its numbers and its tables, and its drawings beside it.

use super::figures::{close_look, figures_of};
use super::{Account, Cancelled, Watch};
use crate::record::{EventId, What};
use crate::view::{DetailLine, Subject, View, beneath, detail, equated, row, svg};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Worked examples hold this many steps: longer ones are not read, and editors stall on them.
const MOST_STEPS: usize = 2000;

/// The size of drawings in points: the width of a printed page.
const SIZE: [f64; 2] = [640.0, 400.0];

/// Headings go no deeper than this in Markdown.
const DEEPEST: usize = 6;

/// A worked example and the files that it shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paper {
    /// The Markdown (CommonMark, with the tables of GitHub).
    pub text: String,
    /// The drawings' file names, and their SVG.
    pub figures: Vec<(String, String)>,
}

/// The worked example of a ray. `stem` is what the names of the drawings' files begin with; where there is none, the drawings
/// are told in words.
///
/// # Errors
/// If `watch` says that nobody waits any more.
pub fn markdown(account: &Account, stem: Option<&str>, watch: Watch) -> Result<Paper, Cancelled> {
    let steps = account.steps(MOST_STEPS);
    let mut writer = Writer { account, stem, paper: head(account), explained: BTreeSet::new(), shown: None };
    for (i, (&event, &depth)) in steps.events.iter().zip(&steps.depths).enumerate() {
        if !watch(i, steps.events.len()) {
            return Err(Cancelled);
        }
        writer.step(event, depth);
    }
    let mut paper = writer.paper;
    if let Some(words) = steps.left_out_in_words("worked examples") {
        let _ = writeln!(paper.text, "\n---\n\n{words}");
    }
    Ok(paper)
}

fn head(account: &Account) -> Paper {
    let mut text = format!("# {}\n\n", plain(account.title()));
    let _ = writeln!(text, "The story of {} of the scene `{}`.", plain(&account.aim()), account.name.replace('`', "'"));
    if let Some(link) = account.link {
        let _ = writeln!(text, "\n`rayscope open '{link}'` shows it in the workbench.");
    }
    Paper { text, figures: Vec::new() }
}

struct Writer<'a> {
    account: &'a Account<'a>,
    stem: Option<&'a str>,
    paper: Paper,
    explained: BTreeSet<&'static str>,
    /// The drawing that was shown last.
    shown: Option<String>,
}

impl Writer<'_> {
    fn step(&mut self, id: EventId, depth: usize) {
        let event = self.account.tree.event(id);
        let (row, detail) = (row(event), detail(event));
        let heading = "#".repeat((depth + 2).min(DEEPEST));
        let _ = writeln!(self.paper.text, "\n{heading} {} {}", row.icon, plain(&detail.title));
        if !row.numbers.is_empty() {
            let _ = writeln!(self.paper.text, "\n**{}**", plain(&row.numbers));
        }
        if self.explained.insert(detail.explanation) {
            let _ = writeln!(self.paper.text, "\n{}", plain(detail.explanation));
        }
        self.lines(&beneath(event));
        self.figures(id);
    }

    /// Pairs are a list, working is set as it stands, tables are tables.
    fn lines(&mut self, lines: &[DetailLine]) {
        for group in lines.chunk_by(|a, b| std::mem::discriminant(a) == std::mem::discriminant(b)) {
            self.paper.text.push('\n');
            match &group[0] {
                DetailLine::Working { .. } => self.working(group),
                _ => group.iter().for_each(|line| self.pair_or_table(line)),
            }
        }
    }

    fn working(&mut self, group: &[DetailLine]) {
        let text = &mut self.paper.text;
        text.push_str("```text\n");
        for line in group {
            if let DetailLine::Working { symbol, formula, numbers, result } = line {
                let parts = equated(symbol, [formula, numbers, result]);
                let indent = " ".repeat(symbol.chars().count());
                let _ = writeln!(text, "{}", parts[..parts.len().min(2)].join(" = "));
                for part in parts.iter().skip(2) {
                    let _ = writeln!(text, "{indent} = {part}");
                }
            }
        }
        text.push_str("```\n");
    }

    fn pair_or_table(&mut self, line: &DetailLine) {
        let text = &mut self.paper.text;
        match line {
            DetailLine::Pair { name, value } => {
                let _ = writeln!(text, "- {}: {}", plain(name), plain(value));
            }
            DetailLine::Table { title, headers, rows } => {
                let _ = writeln!(text, "{}:\n", plain(title));
                let cells = |cells: Vec<String>| format!("| {} |", cells.join(" | "));
                let _ = writeln!(text, "{}", cells(headers.iter().map(|header| plain(header)).collect()));
                let _ = writeln!(text, "{}", cells(vec!["---".to_owned(); headers.len()]));
                for row in rows {
                    let _ = writeln!(text, "{}", cells(row.iter().map(|cell| plain(cell)).collect()));
                }
                text.push('\n');
            }
            DetailLine::Working { .. } => {}
        }
    }

    /// The drawings that were asked for; else the scene where a ray ends, and what happened elsewhere.
    fn figures(&mut self, id: EventId) {
        let account = self.account;
        let subject = Subject { scene: account.scene, tree: account.tree, event: id, size: SIZE, theme: account.theme };
        let ends_here = matches!(account.tree.event(id).what, What::Hit { .. } | What::Nothing { .. });
        let chosen: Vec<&'static View> = match (account.views, ends_here) {
            ([], true) => View::named("side").into_iter().collect(),
            ([], false) => close_look(account, &subject).into_iter().collect(),
            (asked_for, _) => asked_for.to_vec(),
        };
        if chosen.is_empty() {
            return;
        }
        for figure in figures_of(&Account { views: &chosen, ..*account }, id, |_| SIZE) {
            let picture = svg(&figure.drawing);
            // The parts of a step are often drawn like the step itself.
            if self.shown.replace(picture.clone()).as_ref() == Some(&picture) {
                continue;
            }
            let words = plain(&figure.drawing.in_words());
            match self.stem {
                Some(stem) => {
                    let name = format!("{stem}-{id}-{}.svg", figure.name);
                    let _ = writeln!(self.paper.text, "\n![{words}]({name})");
                    self.paper.figures.push((name, picture));
                }
                None => {
                    let _ = writeln!(self.paper.text, "\n*Drawing:* {words}");
                }
            }
        }
    }
}

/// Text in which nothing means anything to Markdown.
fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '~' | '$' | '&' => {
                out.push('\\');
                out.push(character);
            }
            character if character.is_control() => out.push(' '),
            character => out.push(character),
        }
    }
    out
}
