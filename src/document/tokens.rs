//! The words of a scene's text, each with its range: what is coloured in the editor, and what the tree is made of.
//!
//! Any text has tokens: what JSON does not know is a token of its own kind, and reading goes on behind it.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// The name of a field.
    Key,
    /// A text in quotes.
    String,
    /// A number.
    Number,
    /// `true`, `false` or `null`.
    Keyword,
    /// A comment. Scene files may have none, but what stands there is kept and recognised.
    Comment,
    /// A bracket, comma or colon.
    Punctuation,
    /// What JSON does not know.
    Error,
}

/// A word of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands, in bytes.
    pub range: Range<usize>,
}

/// The tokens of a text in its order. Names of fields are still strings: only the tree knows them apart.
#[must_use]
pub(super) fn scan(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let (kind, length) = match first {
            '{' | '}' | '[' | ']' | ':' | ',' => (TokenKind::Punctuation, 1),
            '"' => string(rest),
            '/' if rest.starts_with("//") => (TokenKind::Comment, line(rest)),
            '/' if rest.starts_with("/*") => block_comment(rest),
            c if c.is_whitespace() || c == '\u{feff}' => {
                at += c.len_utf8();
                continue;
            }
            c if c.is_ascii_digit() || matches!(c, '-' | '+' | '.') => number(rest),
            c if c.is_alphabetic() || c == '_' => word(rest),
            c => (TokenKind::Error, c.len_utf8()),
        };
        tokens.push(Token { kind, range: at..at + length });
        at += length;
    }
    tokens
}

/// Up to the end of the line.
fn line(text: &str) -> usize {
    text.find(['\n', '\r']).unwrap_or(text.len())
}

/// A string ends at its quote. One that is not closed ends with its line and is an error.
fn string(text: &str) -> (TokenKind, usize) {
    let mut escaped = false;
    for (at, character) in text.char_indices().skip(1) {
        match character {
            '\n' | '\r' => return (TokenKind::Error, at),
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return (TokenKind::String, at + 1),
            _ => {}
        }
    }
    (TokenKind::Error, text.len())
}

fn block_comment(text: &str) -> (TokenKind, usize) {
    text[2..].find("*/").map_or((TokenKind::Error, text.len()), |end| (TokenKind::Comment, end + 4))
}

fn number(text: &str) -> (TokenKind, usize) {
    let belongs = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '+' | '.');
    let length = text.find(|c| !belongs(c)).unwrap_or(text.len());
    let is_number = serde_json::from_str::<serde_json::Number>(&text[..length]).is_ok();
    (if is_number { TokenKind::Number } else { TokenKind::Error }, length)
}

fn word(text: &str) -> (TokenKind, usize) {
    let length = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    let known = matches!(&text[..length], "true" | "false" | "null");
    (if known { TokenKind::Keyword } else { TokenKind::Error }, length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<(TokenKind, &str)> {
        scan(text).into_iter().map(|token| (token.kind, &text[token.range])).collect()
    }

    #[test]
    fn each_word_has_its_kind() {
        use TokenKind::{Comment, Keyword, Number, Punctuation, String};
        let text = "[\"a\\\"b\", -1.5e3, true] // end\n/* more */";
        let expected = [
            (Punctuation, "["),
            (String, "\"a\\\"b\""),
            (Punctuation, ","),
            (Number, "-1.5e3"),
            (Punctuation, ","),
            (Keyword, "true"),
            (Punctuation, "]"),
            (Comment, "// end"),
            (Comment, "/* more */"),
        ];
        assert_eq!(kinds(text), expected);
    }

    #[test]
    fn what_json_does_not_know_is_an_error_and_reading_goes_on() {
        let text = "{ \"open\n 01 .5 +1 tru § 'x' }";
        let errors: Vec<_> = kinds(text).into_iter().filter(|(kind, _)| *kind == TokenKind::Error).collect();
        let words: Vec<_> = errors.into_iter().map(|(_, word)| word).collect();
        assert_eq!(words, ["\"open", "01", ".5", "+1", "tru", "§", "'", "x", "'"]);
        assert_eq!(kinds(text).last(), Some(&(TokenKind::Punctuation, "}")));
    }
}
