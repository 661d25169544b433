//! Questions as they stand on paper: what is asked, and folded away below it hints, the answer, and what wrong answers come from.

use super::page::Page;
use crate::lesson::model::Change;
use crate::lesson::prose::{Block, Inline};
use crate::lesson::question::{Form, PosedEdit, Reckoned, Spot, list_text, offered_lists};
use crate::lesson::{Posed, Told};
use crate::record::format_number;
use crate::view::escaped;

/// What a reader is to do, by the kind of question.
pub fn kind_in_words(form: &Form) -> &'static str {
    match form {
        Form::Number(_) => "work out a number",
        Form::Choice(_) => "choose one",
        Form::Order { .. } => "put in order",
        Form::Place(..) => "find the place",
        Form::Time(_) => "find the time",
        Form::Intervals(_) => "choose the intervals",
        Form::Edit(_) => "change the scene",
    }
}

impl Page<'_> {
    /// A question; `number` is how it is called on the page, such as `2.1`.
    pub fn question(&mut self, posed: &Posed, number: &str) {
        let id = format!("question-{}", number.replace('.', "-"));
        self.put(format_args!(
            "<section class=\"question\" aria-labelledby=\"{id}\">\n<h3 id=\"{id}\">Question {number} \
             <span class=\"kind\">{}</span></h3>\n",
            kind_in_words(&posed.form)
        ));
        self.prose(&posed.ask);
        self.offered(&posed.form);
        for (place, hint) in posed.hints.iter().enumerate() {
            let name = if posed.hints.len() == 1 { "Hint".to_owned() } else { format!("Hint {}", place + 1) };
            self.folded(&name, |page| page.prose(hint));
        }
        self.folded("Answer", |page| {
            page.answer(&posed.form);
            if let Some(explain) = &posed.explain {
                page.prose(explain);
            }
        });
        if has_wrong_answers(&posed.form) {
            self.folded("Wrong answers, and what they come from", |page| page.wrong_answers(&posed.form));
        }
        self.put("</section>\n");
    }

    /// Something that is opened to be read.
    pub fn folded(&mut self, name: &str, inside: impl FnOnce(&mut Self)) {
        self.put(format_args!("<details><summary>{}</summary>\n", escaped(name)));
        inside(self);
        self.put("</details>\n");
    }

    /// What a reader chooses from.
    fn offered(&mut self, form: &Form) {
        let lines: Vec<String> = match form {
            Form::Choice(choices) => choices.iter().map(|choice| self.line(&choice.text)).collect(),
            Form::Order { items, offered, .. } => offered.iter().map(|&place| self.line(&items[place])).collect(),
            Form::Intervals(reckoned) => {
                offered_lists(reckoned).into_iter().map(|list| escaped(&list_text(list))).collect()
            }
            Form::Number(_) | Form::Place(..) | Form::Time(_) | Form::Edit(_) => return,
        };
        let tag = if matches!(form, Form::Order { .. }) { "ul" } else { "ol" };
        self.put(format_args!("<{tag} class=\"choices\">\n"));
        for line in lines {
            self.put(format_args!("<li>{line}</li>\n"));
        }
        self.put(format_args!("</{tag}>\n"));
    }

    fn answer(&mut self, form: &Form) {
        match form {
            Form::Number(reckoned) | Form::Time(reckoned) => self.right(&with_unit(reckoned, reckoned.answer)),
            Form::Place(_, reckoned) => self.right(&spot(&reckoned.answer)),
            Form::Intervals(reckoned) => self.right(&list_text(&reckoned.answer)),
            Form::Choice(choices) => {
                for (place, choice) in choices.iter().enumerate().filter(|(_, choice)| choice.is_right) {
                    let line = self.line(&choice.text);
                    self.put(format_args!("<p class=\"right\">({}) {line}</p>\n", letter(place)));
                    self.prose(&choice.because);
                }
            }
            Form::Order { items, right, .. } => {
                let order = self.order(items, right);
                self.put(format_args!("<p class=\"right\">{order}</p>\n"));
            }
            Form::Edit(posed) => {
                self.put("<p class=\"right\">For example:</p>\n");
                self.changes(&posed.edit.solution);
            }
        }
    }

    fn right(&mut self, text: &str) {
        self.put(format_args!("<p class=\"right\">{}</p>\n", escaped(text)));
    }

    fn wrong_answers(&mut self, form: &Form) {
        self.put("<dl class=\"wrong\">\n");
        match form {
            Form::Number(reckoned) | Form::Time(reckoned) => {
                self.wrong(&reckoned.wrong, |value| with_unit(reckoned, *value));
            }
            Form::Place(_, reckoned) => self.wrong(&reckoned.wrong, spot),
            Form::Intervals(reckoned) => self.wrong(&reckoned.wrong, |list| list_text(list)),
            Form::Choice(choices) => {
                for (place, choice) in choices.iter().enumerate().filter(|(_, choice)| !choice.is_right) {
                    let line = self.line(&choice.text);
                    self.cause(&format!("({}) {line}", letter(place)), &choice.because);
                }
            }
            Form::Order { items, wrong, .. } => {
                for (order, because) in wrong {
                    let order = self.order(items, order);
                    self.cause(&order, because);
                }
            }
            Form::Edit(posed) => self.wrong_changes(posed),
        }
        self.put("</dl>\n");
    }

    fn wrong<T>(&mut self, wrong: &[(T, Vec<Block<Told>>)], written: impl Fn(&T) -> String) {
        for (value, because) in wrong {
            self.cause(&escaped(&written(value)), because);
        }
    }

    fn wrong_changes(&mut self, posed: &PosedEdit) {
        for (wrong, because) in posed.edit.wrong.iter().zip(&posed.because) {
            let changes: Vec<String> =
                wrong.change.iter().map(|change| format!("<code>{}</code>", change_text(change))).collect();
            self.cause(&changes.join(", "), because);
        }
    }

    fn cause(&mut self, answer: &str, because: &[Block<Told>]) {
        self.put(format_args!("<dt>{answer}</dt>\n<dd>"));
        self.prose(because);
        self.put("</dd>\n");
    }

    fn changes(&mut self, changes: &[Change]) {
        self.put("<ul>\n");
        for change in changes {
            self.put(format_args!("<li><code>{}</code></li>\n", change_text(change)));
        }
        self.put("</ul>\n");
    }

    fn order(&mut self, items: &[Vec<Inline<Told>>], order: &[usize]) -> String {
        let items: Vec<String> =
            order.iter().filter_map(|&place| items.get(place)).map(|item| self.line(item)).collect();
        items.join(" → ")
    }
}

fn change_text(change: &Change) -> String {
    escaped(&format!("{} = {}", change.at, change.to))
}

fn has_wrong_answers(form: &Form) -> bool {
    match form {
        Form::Number(reckoned) | Form::Time(reckoned) => !reckoned.wrong.is_empty(),
        Form::Place(_, reckoned) => !reckoned.wrong.is_empty(),
        Form::Intervals(reckoned) => !reckoned.wrong.is_empty(),
        Form::Choice(choices) => choices.iter().any(|choice| !choice.is_right),
        Form::Order { wrong, .. } => !wrong.is_empty(),
        Form::Edit(posed) => !posed.because.is_empty(),
    }
}

/// A number with its unit.
pub fn with_unit(reckoned: &Reckoned<f64>, value: f64) -> String {
    format!("{} {}", format_number(value), reckoned.unit).trim_end().to_owned()
}

/// A place in words.
pub fn spot(spot: &Spot) -> String {
    let (what, numbers) = match spot {
        Spot::World(point) => ("the point", point.to_vec()),
        Spot::Pixel(pixel) => ("the pixel", pixel.to_vec()),
    };
    let numbers: Vec<String> = numbers.into_iter().map(format_number).collect();
    format!("{what} ({})", numbers.join(", "))
}

/// The letter of a choice.
pub fn letter(place: usize) -> char {
    u8::try_from(place).ok().filter(|place| *place < 26).map_or('?', |place| char::from(b'a' + place))
}
