//! A question taken apart into names, signs and values.

use super::error::QueryError;
use super::pattern::is_plain;

/// A piece of a question with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// The characters that it is made of, counted from 0.
    pub characters: std::ops::Range<usize>,
    /// The bytes that it is made of.
    pub bytes: std::ops::Range<usize>,
}

/// What a piece of a question is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum TokenKind {
    /// A word, a field's name, or a value without quotation marks.
    Plain(String),
    /// What stood between quotation marks, as it stood there.
    Quoted(String),
    /// A comparison.
    Sign(Sign),
    /// `&`, `&&` or `and`.
    And,
    /// `|`, `||` or `or`.
    Or,
    /// `!` or `not`.
    Not,
    /// `(`.
    Open,
    /// `)`.
    Close,
}

/// How a field is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Equal,
    Unequal,
    Less,
    AtMost,
    More,
    AtLeast,
}

impl Sign {
    /// As it is written.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::Unequal => "!=",
            Self::Less => "<",
            Self::AtMost => "<=",
            Self::More => ">",
            Self::AtLeast => ">=",
        }
    }

    /// Whether it asks only if two things are the same.
    pub const fn is_of_sameness(self) -> bool {
        matches!(self, Self::Equal | Self::Unequal)
    }
}

/// All signs, the longer ones first.
const SIGNS: [(&str, TokenKind); 20] = [
    ("&&", TokenKind::And),
    ("||", TokenKind::Or),
    ("!=", TokenKind::Sign(Sign::Unequal)),
    ("<=", TokenKind::Sign(Sign::AtMost)),
    (">=", TokenKind::Sign(Sign::AtLeast)),
    ("==", TokenKind::Sign(Sign::Equal)),
    ("≠", TokenKind::Sign(Sign::Unequal)),
    ("≤", TokenKind::Sign(Sign::AtMost)),
    ("≥", TokenKind::Sign(Sign::AtLeast)),
    ("=", TokenKind::Sign(Sign::Equal)),
    ("<", TokenKind::Sign(Sign::Less)),
    (">", TokenKind::Sign(Sign::More)),
    ("&", TokenKind::And),
    ("|", TokenKind::Or),
    ("!", TokenKind::Not),
    ("¬", TokenKind::Not),
    ("(", TokenKind::Open),
    (")", TokenKind::Close),
    ("∧", TokenKind::And),
    ("∨", TokenKind::Or),
];

/// Takes a text apart, up to the first place where that is not possible.
pub(super) fn tokens(text: &str) -> (Vec<Token>, Option<QueryError>) {
    let mut found = Vec::new();
    let (mut byte, mut character) = (0, 0);
    while let Some(next) = text[byte..].chars().next() {
        if next.is_whitespace() {
            (byte, character) = (byte + next.len_utf8(), character + 1);
            continue;
        }
        let (kind, bytes) = match one(&text[byte..]) {
            Ok(token) => token,
            Err(message) => {
                let length = text[byte..].chars().count();
                return (found, Some(QueryError::new(character + 1, length, message)));
            }
        };
        let count = text[byte..byte + bytes].chars().count();
        found.push(Token { kind, characters: character..character + count, bytes: byte..byte + bytes });
        (byte, character) = (byte + bytes, character + count);
    }
    (found, None)
}

/// The piece at the start of a text, and how many bytes it takes.
fn one(text: &str) -> Result<(TokenKind, usize), String> {
    if let Some((sign, kind)) = SIGNS.iter().find(|(sign, _)| text.starts_with(sign)) {
        return Ok((kind.clone(), sign.len()));
    }
    if let Some(after) = text.strip_prefix('"') {
        let end = end_of_quotation(after).ok_or("a quotation begins here and does not end; expected `\"`")?;
        return Ok((TokenKind::Quoted(after[..end].to_owned()), end + 2));
    }
    let end = text.find(|c| !is_plain(c)).unwrap_or(text.len());
    if end == 0 {
        let wrong = text.chars().next().unwrap_or(' ');
        return Err(format!("`{wrong}` has no meaning here; names that hold such characters stand in \"…\""));
    }
    let kind = match &text[..end] {
        word if word.eq_ignore_ascii_case("and") => TokenKind::And,
        word if word.eq_ignore_ascii_case("or") => TokenKind::Or,
        word if word.eq_ignore_ascii_case("not") => TokenKind::Not,
        word => TokenKind::Plain(word.to_owned()),
    };
    Ok((kind, end))
}

/// Where the quotation ends, passing over `\"`.
fn end_of_quotation(text: &str) -> Option<usize> {
    let mut is_escaped = false;
    for (place, character) in text.char_indices() {
        match character {
            '"' if !is_escaped => return Some(place),
            '\\' if !is_escaped => is_escaped = true,
            _ => is_escaped = false,
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        tokens(text).0.into_iter().map(|token| token.kind).collect()
    }

    #[test]
    fn signs_may_be_written_in_several_ways() {
        let at_least = TokenKind::Sign(Sign::AtLeast);
        let depth = TokenKind::Plain("depth".to_owned());
        let two = TokenKind::Plain("2".to_owned());
        assert_eq!(kinds("depth>=2"), [depth.clone(), at_least.clone(), two.clone()]);
        assert_eq!(kinds("depth ≥ 2"), [depth, at_least, two]);
        let tir = TokenKind::Plain("tir".to_owned());
        let expected = [TokenKind::Not, tir.clone(), TokenKind::And, tir];
        assert_eq!(kinds("!tir & tir"), expected);
        assert_eq!(kinds("NOT tir and tir"), expected);
        assert_eq!(kinds("¬tir && tir"), expected);
    }

    #[test]
    fn places_are_counted_in_characters_and_in_bytes() {
        let (found, error) = tokens("t≤3 & \"ä\"");
        assert_eq!(error, None);
        assert_eq!(found[2].characters, 2..3);
        assert_eq!(found[2].bytes, 4..5);
        assert_eq!((found[4].characters.clone(), found[4].bytes.clone()), (6..9, 8..12));
    }

    #[test]
    fn an_open_quotation_is_told_at_its_beginning() {
        let (found, error) = tokens(r#"object="a\" b"#);
        assert_eq!(found.len(), 2);
        assert_eq!(error.map(|error| (error.column, error.length)), Some((8, 6)));
    }
}
