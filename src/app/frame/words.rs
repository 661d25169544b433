//! The words of the interface in the language that is set.
//!
//! A context asks for what a widget says while it is locked, and the language is looked up in the context: so words are said before
//! `widget_info`, not within.

use crate::words::{self, Argument, Language};
use egui::{Context, Id};

fn place() -> Id {
    Id::unique("language")
}

/// Sets the language.
pub fn set_language(ctx: &Context, language: Language) {
    let tag = language.tag();
    ctx.data_mut(|data| data.insert_temp(place(), tag));
}

/// The language that is set.
#[must_use]
pub fn language(ctx: &Context) -> Language {
    ctx.data(|data| data.get_temp(place())).and_then(Language::of_tag).unwrap_or_default()
}

/// A message of the catalogue.
#[must_use]
pub fn say(ctx: &Context, id: &str) -> String {
    words::say(language(ctx), id)
}

/// A message of the catalogue with its arguments put in.
#[must_use]
pub fn say_with(ctx: &Context, id: &str, arguments: &[(&str, Argument)]) -> String {
    words::say_with(language(ctx), id, arguments)
}
