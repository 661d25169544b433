//! The words and signs of an expression.

use super::ExpressionError;
use std::ops::Range;

/// A word or sign, and its bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub range: Range<usize>,
}

/// What a token is.
#[derive(Clone, Debug, PartialEq)]
pub enum TokenKind {
    /// A number.
    Number(f64),
    /// A text in quotes of either kind.
    Text(String),
    /// A name, a function, `and`, `or`, `not`, `within`.
    Word(String),
    /// Anything else: `+`, `==`, `(`.
    Sign(&'static str),
}

/// The longer ones first, so that `<=` is not read as `<`.
const SIGNS: [&str; 20] =
    ["==", "!=", "<=", ">=", "<", ">", "~", "+", "-", "−", "*", "·", "/", "^", "(", ")", "[", "]", ",", "."];

/// Splits an expression.
pub fn tokens(text: &str) -> Result<Vec<Token>, ExpressionError> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        }
        let token = token(text, at, first)?;
        at = token.range.end;
        tokens.push(token);
    }
    Ok(tokens)
}

fn token(text: &str, at: usize, first: char) -> Result<Token, ExpressionError> {
    let rest = &text[at..];
    let (kind, length) = if first.is_ascii_digit() {
        number(rest, at)?
    } else if is_of_name(first) {
        let length = rest.find(|c| !is_of_name(c) && !c.is_ascii_digit()).unwrap_or(rest.len());
        (TokenKind::Word(rest[..length].to_owned()), length)
    } else if matches!(first, '"' | '\'') {
        let Some(length) = rest[1..].find(first) else {
            return Err(error("this text has no closing quote", at..text.len()));
        };
        (TokenKind::Text(rest[1..=length].to_owned()), length + 2)
    } else if let Some(sign) = SIGNS.iter().find(|sign| rest.starts_with(**sign)) {
        (TokenKind::Sign(plain(sign)), sign.len())
    } else {
        return Err(error(&format!("`{first}` means nothing in an expression"), at..at + first.len_utf8()));
    };
    Ok(Token { kind, range: at..at + length })
}

fn is_of_name(c: char) -> bool {
    c.is_alphabetic() || c == '_' || ('₀'..='₉').contains(&c)
}

fn number(rest: &str, at: usize) -> Result<(TokenKind, usize), ExpressionError> {
    let digits = |from: usize| rest[from..].find(|c: char| !c.is_ascii_digit()).map_or(rest.len(), |n| from + n);
    let mut end = digits(0);
    if rest[end..].starts_with('.') && rest[end + 1..].starts_with(|c: char| c.is_ascii_digit()) {
        end = digits(end + 1);
    }
    if rest[end..].starts_with(['e', 'E']) {
        let sign = usize::from(rest[end + 1..].starts_with(['-', '+']));
        if rest[end + 1 + sign..].starts_with(|c: char| c.is_ascii_digit()) {
            end = digits(end + 1 + sign);
        }
    }
    match rest[..end].parse() {
        Ok(number) => Ok((TokenKind::Number(number), end)),
        Err(_) => Err(error(&format!("`{}` is no number", &rest[..end]), at..at + end)),
    }
}

/// A sign as it is written most plainly.
fn plain(sign: &&'static str) -> &'static str {
    match *sign {
        "−" => "-",
        "·" => "*",
        sign => sign,
    }
}

fn error(message: &str, range: Range<usize>) -> ExpressionError {
    ExpressionError { message: message.to_owned(), range }
}
