//! What may stand where a person is typing.

use super::error::nearest;
use super::pattern::{Pattern, is_plain};
use super::term::{Names, Term, TermKind, Test, field, terms, word};
use super::token::{Token, TokenKind, tokens};
use super::vocabulary::Vocabulary;
use std::ops::Range;

/// A text that may stand at the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// The bytes of the question that it takes the place of.
    pub replaces: Range<usize>,
    /// The text.
    pub text: String,
    /// What it means.
    pub meaning: String,
}

impl Completion {
    /// The question with it, and the byte where the cursor then stands.
    #[must_use]
    pub fn applied(&self, question: &str) -> (String, usize) {
        let (before, after) = (&question[..self.replaces.start], &question[self.replaces.end..]);
        (format!("{before}{}{after}", self.text), self.replaces.start + self.text.len())
    }
}

/// Fewer characters are like too many words.
const LEAST_TO_GUESS: usize = 3;

/// All that may stand at the cursor, which is counted in bytes: first what begins with what is there, then what holds it.
#[must_use]
pub fn complete(text: &str, cursor: usize, vocabulary: &Vocabulary) -> Vec<Completion> {
    let cursor = text.floor_char_boundary(cursor);
    let (found, _) = tokens(&text[..cursor]);
    if let Some((field, start, typed)) = open_quotation(text, cursor, &found) {
        return values(field, &typed, start..cursor, vocabulary);
    }
    let (whole, last) = match found.split_last() {
        Some((last, before)) if last.bytes.end == cursor && matches!(last.kind, TokenKind::Plain(_)) => {
            (before, Some(last))
        }
        _ => (found.as_slice(), None),
    };
    let end = cursor + text[cursor..].find(|c| !is_plain(c)).unwrap_or(text.len() - cursor);
    let replaces = last.map_or(cursor..cursor, |last| last.bytes.start..end);
    let typed = last.map_or("", |last| &text[last.bytes.clone()]);
    match whole {
        [.., Token { kind: TokenKind::Plain(name), .. }, Token { kind: TokenKind::Sign(_), .. }] => {
            field(name).map_or_else(Vec::new, |field| values(field, typed, replaces, vocabulary))
        }
        [.., Token { kind: TokenKind::Plain(_) | TokenKind::Quoted(_) | TokenKind::Close, .. }] if last.is_none() => {
            connections(whole, cursor)
        }
        _ => words(typed, &replaces),
    }
}

/// The field, the first byte and the beginning of a value whose quotation has no end yet.
fn open_quotation(text: &str, cursor: usize, found: &[Token]) -> Option<(&'static Term, usize, String)> {
    let after = found.last().map_or(0, |token| token.bytes.end);
    let start = after + text[after..cursor].find(|c: char| !c.is_whitespace())?;
    let typed = text[start..cursor].strip_prefix('"')?;
    match found {
        [.., Token { kind: TokenKind::Plain(name), .. }, Token { kind: TokenKind::Sign(_), .. }] => {
            Some((field(name)?, start, typed.to_owned()))
        }
        _ => None,
    }
}

/// Words, fields and groups.
fn words(typed: &str, replaces: &Range<usize>) -> Vec<Completion> {
    let all: Vec<(String, Completion)> = terms()
        .map(|term| {
            let text = match (term.kind(), term.name) {
                (TermKind::Word, name) => name.to_owned(),
                (TermKind::Names, name) => format!("{name}="),
                (TermKind::Numbers, name) => format!("{name}>="),
                (TermKind::Group, name) => format!("{name}("),
            };
            (term.name.to_owned(), Completion { replaces: replaces.clone(), text, meaning: term.meaning.to_owned() })
        })
        .collect();
    ranked(typed, all)
}

/// The values of a field.
fn values(field: &'static Term, typed: &str, replaces: Range<usize>, vocabulary: &Vocabulary) -> Vec<Completion> {
    let names: Vec<String> = match field.test {
        Test::Names(_, Names::Listed(known)) => known().iter().map(|&name| name.to_owned()).collect(),
        Test::Names(_, Names::OfScene(names)) => names(vocabulary).to_vec(),
        _ => Vec::new(),
    };
    let completion = |name: String| {
        let (text, meaning) = (Pattern::exactly(&name).to_string(), field.meaning.to_owned());
        (name, Completion { replaces: replaces.clone(), text, meaning })
    };
    ranked(typed, names.into_iter().map(completion).collect())
}

/// What may follow a whole term; a comparison may follow a field.
fn connections(whole: &[Token], cursor: usize) -> Vec<Completion> {
    let is_value = matches!(whole, [.., Token { kind: TokenKind::Sign(_), .. }, _]);
    let name = match whole.last().map(|token| &token.kind) {
        Some(TokenKind::Plain(name)) if !is_value => name.as_str(),
        _ => "",
    };
    let signs: &[(&str, &str)] = match field(name).map(Term::kind) {
        Some(TermKind::Names) => &[("=", "is"), ("!=", "is none of")],
        Some(_) => &[(">=", "at least"), ("<=", "at most"), ("=", "exactly"), (">", "more than"), ("<", "less than")],
        None => &[],
    };
    let both: &[(&str, &str)] = &[("& ", "and: both hold of one event"), ("| ", "or: one of them holds")];
    let joins = if signs.is_empty() || word(name).is_some() { both } else { &[] };
    let completion = |&(text, meaning): &(&str, &str)| Completion {
        replaces: cursor..cursor,
        text: text.to_owned(),
        meaning: meaning.to_owned(),
    };
    signs.iter().chain(joins).map(completion).collect()
}

/// Those that begin with what was typed, then those one of whose words does, then those that hold it; if there are none, the
/// nearest.
fn ranked(typed: &str, all: Vec<(String, Completion)>) -> Vec<Completion> {
    let wanted = typed.to_lowercase();
    let is_long = wanted.chars().count() >= LEAST_TO_GUESS;
    let rank = |name: &str| {
        let name = name.to_lowercase();
        let begins = |part: &str| part.starts_with(&wanted);
        match &name {
            name if begins(name) => Some(0),
            name if name.split(['.', '_', ' ', '-']).any(begins) => Some(1),
            name if is_long && name.contains(&wanted) => Some(2),
            _ => None,
        }
    };
    let mut found: Vec<_> =
        all.iter().filter_map(|(name, completion)| Some((rank(name)?, completion.clone()))).collect();
    if found.is_empty() && is_long {
        let near = nearest(&wanted, all.iter().map(|(name, _)| name.as_str()));
        found.extend(all.into_iter().filter(|(name, _)| Some(name) == near.as_ref()).map(|(_, it)| (3, it)));
    }
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, completion)| completion).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> Vocabulary {
        Vocabulary { objects: ["glass ball", "ground", "lens"].map(str::to_owned).to_vec(), ..Vocabulary::default() }
    }

    fn texts(question: &str) -> Vec<String> {
        complete(question, question.len(), &names()).into_iter().map(|completion| completion.text).collect()
    }

    #[test]
    fn a_word_is_completed_by_what_begins_with_it_and_then_by_what_holds_it() {
        assert_eq!(texts("ti"), ["tir"]);
        assert_eq!(texts("tersec"), ["csg.intersection"]);
        assert_eq!(texts("early"), ["csg.early_out"]);
        assert_eq!(texts("tir & dep")[0], "depth>=");
        assert_eq!(texts("has(undec"), ["undecidable"]);
    }

    #[test]
    fn a_misspelt_word_is_completed_by_the_nearest_one() {
        assert_eq!(texts("undecideable"), ["undecidable"]);
    }

    #[test]
    fn values_are_those_of_the_scene_in_quotation_marks_where_they_need_them() {
        assert_eq!(texts("object="), ["\"glass ball\"", "ground", "lens"]);
        assert_eq!(texts("object = g"), ["\"glass ball\"", "ground"]);
        assert_eq!(texts("object=\"gla"), ["\"glass ball\""]);
        assert_eq!(texts("kind=ref"), ["reflected", "refracted"]);
        assert_eq!(texts("depth>="), [""; 0]);
    }

    #[test]
    fn after_a_whole_term_comes_a_connection() {
        assert_eq!(texts("tir "), ["& ", "| "]);
        assert_eq!(texts("object=lens "), ["& ", "| "]);
        assert_eq!(texts("depth "), [">=", "<=", "=", ">", "<"]);
        assert_eq!(texts("(tir) "), ["& ", "| "]);
    }

    #[test]
    fn a_completion_takes_the_place_of_the_word_around_the_cursor() {
        let completions = complete("tir & refr | hit", 8, &names());
        let refracted = completions.iter().find(|completion| completion.text == "refracted").unwrap();
        assert_eq!(refracted.applied("tir & refr | hit"), ("tir & refracted | hit".to_owned(), 15));
    }

    #[test]
    fn no_place_in_any_text_makes_it_panic() {
        let text = "object=\"ä\" & (t≤3 | !¬tir) \"";
        for cursor in 0..text.len() + 3 {
            let _ = complete(text, cursor, &names());
        }
    }
}
