//! What the interface says, in one catalogue for each language.
//!
//! A message is written once in `assets/words/LANGUAGE/AREA.ftl`, in Fluent's syntax (<https://projectfluent.org>). English is complete;
//! what another language lacks is said in English.

mod catalogue;

use fluent_bundle::{FluentArgs, FluentValue};

/// A language of the interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// All languages.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// Its name in itself.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::German => "Deutsch",
        }
    }

    /// Its tag after BCP 47.
    #[must_use]
    pub const fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// The language with this tag.
    #[must_use]
    pub fn of_tag(tag: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.tag() == tag)
    }
}

/// What is put into a message: `{ $name }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Argument<'a> {
    /// A text.
    Text(&'a str),
    /// A number that a message may choose a plural by.
    Count(usize),
}

impl<'a> From<&'a str> for Argument<'a> {
    fn from(text: &'a str) -> Self {
        Self::Text(text)
    }
}

impl<'a> From<&'a String> for Argument<'a> {
    fn from(text: &'a String) -> Self {
        Self::Text(text)
    }
}

impl From<usize> for Argument<'_> {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<u32> for Argument<'_> {
    fn from(count: u32) -> Self {
        Self::Count(count as usize)
    }
}

/// A message. One that no catalogue has is said by its name, so that it is seen to be missing.
#[must_use]
pub fn say(language: Language, id: &str) -> String {
    say_with(language, id, &[])
}

/// A message with its arguments put in.
#[must_use]
pub fn say_with(language: Language, id: &str, arguments: &[(&str, Argument)]) -> String {
    let mut values = FluentArgs::with_capacity(arguments.len());
    for &(name, argument) in arguments {
        let value = match argument {
            Argument::Text(text) => FluentValue::from(text),
            Argument::Count(count) => FluentValue::from(count),
        };
        values.set(name, value);
    }
    let found =
        catalogue::message(language, id, &values).or_else(|| catalogue::message(Language::English, id, &values));
    found.unwrap_or_else(|| id.to_owned())
}

/// Every message that a language has of its own, in order.
#[must_use]
pub fn known(language: Language) -> Vec<&'static str> {
    catalogue::ids(language)
}

/// Whether a language has a message of its own.
#[must_use]
pub fn has(language: Language, id: &str) -> bool {
    catalogue::has(language, id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_said_in_each_language() {
        assert_eq!(say(Language::English, "menu-view"), "View");
        assert_eq!(say(Language::German, "menu-view"), "Ansicht");
    }

    #[test]
    fn arguments_are_put_in_and_choose_the_plural() {
        let said = |count: usize| say_with(Language::German, "share-text-copied", &[("lines", count.into())]);
        assert_ne!(said(1).replace('1', ""), said(2).replace('2', ""));
        assert!(said(2).contains('2') && !said(2).contains('\u{2068}'), "{}", said(2));
    }

    #[test]
    fn what_is_missing_is_said_by_its_name() {
        assert_eq!(say(Language::German, "no-such-message"), "no-such-message");
    }

    #[test]
    fn every_language_has_every_message_and_no_other() {
        let english = known(Language::English);
        for language in Language::ALL {
            let own = known(language);
            let missing: Vec<_> = english.iter().filter(|id| !own.contains(id)).collect();
            let extra: Vec<_> = own.iter().filter(|id| !english.contains(id)).collect();
            assert!(missing.is_empty() && extra.is_empty(), "{language:?} lacks {missing:?}, has of its own {extra:?}");
        }
    }

    #[test]
    fn every_message_asks_for_the_same_arguments_in_every_language() {
        for id in known(Language::English) {
            let asked = |language| catalogue::arguments(language, id);
            for language in Language::ALL {
                assert_eq!(asked(language), asked(Language::English), "{id} in {language:?}");
            }
        }
    }
}
