//! Lessons and questions as text.

use crate::lesson::model::{Part, Step};
use crate::lesson::prose::{Block, Inline, Line, Prose, Told, code, latex};
use crate::lesson::question::{Form, Reckoned, Spot, list_text, offered_lists};
use crate::lesson::{Lesson, Posed, Scenes, Shelf, Stage};
use crate::record::format_number;
use std::fmt::Write;

/// Whether answers are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answers {
    /// The questions alone.
    Hidden,
    /// With hints, the right answer, and what is said of wrong ones.
    Shown,
}

/// A whole lesson.
pub fn lesson_text(lesson: &Lesson, answers: Answers, scenes: &Scenes, shelf: &dyn Shelf) -> String {
    let header = &lesson.header;
    let mut text = format!(
        "# {}\n\n§ {}, {} minutes. {}\n\n",
        header.title, header.section.value, header.minutes.value, header.idea
    );
    let mut findings = Vec::new();
    for (number, step) in lesson.steps.iter().enumerate() {
        match Stage::new(lesson, step, scenes, shelf) {
            Ok(stage) => {
                if number == 0 {
                    text.push_str(&prose_text(&stage.tell(&lesson.opening, &mut findings)));
                }
                step_text(&mut text, number, step, &stage, answers);
            }
            Err(finding) => {
                let _ = writeln!(text, "## {}. {}\n\n{finding}\n", number + 1, step.title);
            }
        }
    }
    text
}

fn step_text(text: &mut String, number: usize, step: &Step, stage: &Stage, answers: Answers) {
    let _ = writeln!(text, "## {}. {}\n", number + 1, step.title);
    let views: Vec<_> = step.views.iter().map(|view| view.value.name).collect();
    let views = if views.is_empty() { String::new() } else { format!("; views: {}", views.join(", ")) };
    let _ = writeln!(text, "[{}{views}]\n", stage.aim_in_words());
    let mut findings = Vec::new();
    for part in &step.parts {
        match part {
            Part::Prose(prose) => text.push_str(&prose_text(&stage.tell(prose, &mut findings))),
            Part::Claims(claims) if answers == Answers::Shown => {
                for claim in claims {
                    let _ = writeln!(text, "  claim: {}", claim.value.text());
                }
                text.push('\n');
            }
            Part::Claims(_) => {}
            Part::Slip(slip) => {
                let printed = prose_text(&stage.tell(&slip.printed, &mut findings));
                let right = prose_text(&stage.tell(&slip.right, &mut findings));
                let _ = writeln!(text, "The notes slip here. Printed: {printed}Right: {right}");
            }
            Part::Table(table) => {
                let table = stage.table(table, &mut findings);
                text.push_str(&table_text(&table.head, &table.rows));
            }
            Part::Question(question) => match Posed::new(question, stage) {
                Ok(posed) => text.push_str(&question_text(&posed, answers)),
                Err(wrong) => findings.extend(wrong),
            },
        }
    }
    for finding in findings {
        let _ = writeln!(text, "!! {finding}");
    }
}

/// Prose as Markdown.
pub fn prose_text(prose: &Prose<Told>) -> String {
    let mut text = String::new();
    for block in prose {
        match block {
            Block::Paragraph(line) => text += &(line_text(line) + "\n\n"),
            Block::Heading(line) => text += &["### ", &line_text(line), "\n\n"].concat(),
            Block::List { numbered, items } => {
                for (number, item) in items.iter().enumerate() {
                    let sign = if *numbered { format!("{}. ", number + 1) } else { "- ".to_owned() };
                    text += &[&sign, prose_text(item).trim_end(), "\n"].concat();
                }
                text.push('\n');
            }
            Block::Quote(blocks) => {
                for line in prose_text(blocks).trim_end().lines() {
                    text += &["> ", line, "\n"].concat();
                }
                text.push('\n');
            }
            Block::Code(pieces) => text += &["    ", &code(pieces).trim_end().replace('\n', "\n    "), "\n\n"].concat(),
            Block::Formula(pieces) => text += &["    ", latex(pieces).trim(), "\n\n"].concat(),
            Block::Table { head, rows } => text += &table_text(head, rows),
        }
    }
    text
}

fn line_text(line: &Line<Told>) -> String {
    line.iter()
        .map(|inline| match inline {
            Inline::Text(text) => text.clone(),
            Inline::Value(value) => value.text.clone(),
            Inline::Emphasis(line) => format!("*{}*", line_text(line)),
            Inline::Strong(line) => format!("**{}**", line_text(line)),
            Inline::Link(_, line) => line_text(line),
            Inline::Code(pieces) => format!("`{}`", code(pieces)),
            Inline::Formula(pieces) => format!("${}$", latex(pieces)),
            Inline::Break => "\n".to_owned(),
        })
        .collect()
}

/// A table as Markdown.
pub fn table_text(head: &[Line<Told>], rows: &[Vec<Line<Told>>]) -> String {
    let row = |cells: &[Line<Told>]| {
        let cells: Vec<_> = cells.iter().map(line_text).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    let rows: String = rows.iter().map(|cells| row(cells)).collect();
    format!("{}{rule}{rows}\n", row(head))
}

/// A question.
pub fn question_text(posed: &Posed, answers: Answers) -> String {
    let mut text = format!("?  {}", prose_text(&posed.ask));
    match &posed.form {
        Form::Choice(choices) => {
            for (number, choice) in choices.iter().enumerate() {
                let _ = writeln!(text, "   ({}) {}", letter(number), line_text(&choice.text));
            }
        }
        Form::Order { items, offered, .. } => {
            for &number in offered {
                let _ = writeln!(text, "   [ ] {}", line_text(&items[number]));
            }
        }
        Form::Intervals(reckoned) => {
            for list in offered_lists(reckoned) {
                let _ = writeln!(text, "   [ ] {}", list_text(list));
            }
        }
        Form::Number(_) | Form::Place(..) | Form::Time(_) | Form::Edit(_) => {}
    }
    text.push('\n');
    if answers == Answers::Shown {
        answer_text(&mut text, posed);
    }
    text
}

fn letter(number: usize) -> char {
    char::from_u32('a' as u32 + u32::try_from(number).unwrap_or(0)).unwrap_or('?')
}

fn answer_text(text: &mut String, posed: &Posed) {
    for hint in &posed.hints {
        let _ = writeln!(text, "   hint: {}", prose_text(hint).trim());
    }
    match &posed.form {
        Form::Number(reckoned) | Form::Time(reckoned) => {
            let number = |x: &f64| format!("{} {}", format_number(*x), reckoned.unit).trim_end().to_owned();
            reckoned_text(text, reckoned, number);
        }
        Form::Intervals(reckoned) => reckoned_text(text, reckoned, |list| list_text(list)),
        Form::Place(_, reckoned) => reckoned_text(text, reckoned, spot_text),
        Form::Choice(choices) => {
            for (number, choice) in choices.iter().enumerate() {
                let sign = if choice.is_right { "right" } else { "wrong" };
                let _ = writeln!(text, "   ({}) {sign}: {}", letter(number), prose_text(&choice.because).trim());
            }
        }
        Form::Order { items, right, wrong, .. } => {
            let order = |order: &[usize]| order.iter().map(|&n| line_text(&items[n])).collect::<Vec<_>>().join(" → ");
            let _ = writeln!(text, "   right: {}", order(right));
            for (wrong, because) in wrong {
                let _ = writeln!(text, "   wrong: {}: {}", order(wrong), prose_text(because).trim());
            }
        }
        Form::Edit(edit) => {
            for change in &edit.edit.solution {
                let _ = writeln!(text, "   does it: {} = {}", change.at, change.to);
            }
            for (wrong, because) in edit.edit.wrong.iter().zip(&edit.because) {
                for change in &wrong.change {
                    let _ =
                        writeln!(text, "   does not: {} = {}: {}", change.at, change.to, prose_text(because).trim());
                }
            }
        }
    }
    if let Some(explain) = &posed.explain {
        let _ = writeln!(text, "   {}", prose_text(explain).trim());
    }
    text.push('\n');
}

fn reckoned_text<T>(text: &mut String, reckoned: &Reckoned<T>, written: impl Fn(&T) -> String) {
    let tolerance =
        if reckoned.tolerance > 0.0 { format!(" ± {}", format_number(reckoned.tolerance)) } else { String::new() };
    let _ = writeln!(text, "   right: {}{tolerance}", written(&reckoned.answer));
    for (wrong, because) in &reckoned.wrong {
        let _ = writeln!(text, "   wrong: {}: {}", written(wrong), prose_text(because).trim());
    }
}

fn spot_text(spot: &Spot) -> String {
    let numbers: Vec<_> = match spot {
        Spot::World(point) => point.iter().map(|x| format_number(*x)).collect(),
        Spot::Pixel(pixel) => pixel.iter().map(|x| format_number(*x)).collect(),
    };
    format!("({})", numbers.join(", "))
}
