//! From a text to a question.
//!
//! ```text
//! question = every { "|" every }
//! every    = one { "&" one }
//! one      = "!" one | "(" question ")" | "has" "(" question ")" | word | field sign value
//! ```

use super::error::QueryError;
use super::expression::{Comparison, Expression, Place, Value};
use super::pattern::Pattern;
use super::term::{Names, Term, Test, field, terms, word};
use super::token::{Sign, Token, TokenKind, tokens};

/// Deeper nesting is refused: it would be nobody's question, and each level takes room on the stack.
const DEEPEST: usize = 100;

/// Reads a whole text.
pub(super) fn parse(text: &str) -> Result<Expression, QueryError> {
    let (tokens, unreadable) = tokens(text);
    let mut parser = Parser { tokens: &tokens, next: 0, end: text.chars().count(), depth: 0 };
    let question = parser.question().and_then(|question| parser.ended().map(|()| question));
    match (question, unreadable) {
        // What cannot be taken apart stands behind everything that can, and is the reason if something is missing there.
        (Ok(_), Some(error)) => Err(error),
        (Err(missing), Some(error)) if missing.column > parser.end_of_tokens() => Err(error),
        (question, _) => question,
    }
}

struct Parser<'a> {
    tokens: &'a [Token],
    next: usize,
    /// Characters of the text.
    end: usize,
    depth: usize,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next)
    }

    fn takes(&mut self, kind: &TokenKind) -> bool {
        let is_next = self.peek().is_some_and(|token| token.kind == *kind);
        self.next += usize::from(is_next);
        is_next
    }

    fn end_of_tokens(&self) -> usize {
        self.tokens.last().map_or(0, |token| token.characters.end)
    }

    /// Nothing may follow a whole question.
    fn ended(&self) -> Result<(), QueryError> {
        match self.peek() {
            None => Ok(()),
            Some(Token { kind: TokenKind::Close, .. }) => Err(self.error_here("this `)` has no `(` before it")),
            Some(_) => Err(self.error_here("expected `&` or `|` between two terms")),
        }
    }

    /// A complaint about the next token, or about the end.
    fn error_here(&self, message: impl Into<String>) -> QueryError {
        let place = self.peek().map_or(self.end..self.end + 1, |token| token.characters.clone());
        QueryError::new(place.start + 1, place.len(), message)
    }

    fn question(&mut self) -> Result<Expression, QueryError> {
        let mut terms = vec![self.every()?];
        while self.takes(&TokenKind::Or) {
            terms.push(self.every()?);
        }
        Ok(Expression::any(terms))
    }

    fn every(&mut self) -> Result<Expression, QueryError> {
        let mut terms = vec![self.one()?];
        while self.takes(&TokenKind::And) {
            terms.push(self.one()?);
        }
        Ok(Expression::all(terms))
    }

    fn one(&mut self) -> Result<Expression, QueryError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.error_here(format!("more than {DEEPEST} parentheses and negations within each other")));
        }
        let one = match self.peek().map(|token| token.kind.clone()) {
            Some(TokenKind::Not) => {
                self.next += 1;
                self.one().map(|inner| Expression::Not(Box::new(inner)))
            }
            Some(TokenKind::Open) => self.in_parentheses(),
            Some(TokenKind::Plain(name)) => self.term(&name),
            Some(TokenKind::Quoted(_)) => {
                Err(self.error_here("a name in \"…\" needs a field before it, as in object=\"…\""))
            }
            Some(TokenKind::Sign(sign)) => {
                Err(self.error_here(format!("`{}` needs a field before it, as in depth>=2", sign.text())))
            }
            Some(TokenKind::And | TokenKind::Or | TokenKind::Close) => {
                Err(self.error_here("expected a word such as `tir`, a comparison such as `depth>=2`, `!` or `(`"))
            }
            None => Err(self.error_here(
                "the question ends here; expected a word such as `tir` or a comparison such as `depth>=2`",
            )),
        };
        self.depth -= 1;
        one
    }

    fn in_parentheses(&mut self) -> Result<Expression, QueryError> {
        let opened = self.peek().map_or(0, |token| token.characters.start);
        self.next += 1;
        let inner = self.question()?;
        if self.takes(&TokenKind::Close) {
            return Ok(inner);
        }
        Err(self.error_here(format!("expected `)` for the `(` in column {}", opened + 1)))
    }

    /// A word, or a comparison with what follows.
    fn term(&mut self, name: &str) -> Result<Expression, QueryError> {
        let after = self.tokens.get(self.next + 1).map(|token| &token.kind);
        match after {
            Some(TokenKind::Sign(sign)) => self.comparison(name, *sign),
            Some(TokenKind::Open) if name.eq_ignore_ascii_case("has") => {
                self.next += 1;
                self.in_parentheses().map(|inner| Expression::Has(Box::new(inner)))
            }
            _ => self.word(name),
        }
    }

    fn word(&mut self, name: &str) -> Result<Expression, QueryError> {
        if let Some(word) = word(name) {
            self.next += 1;
            return Ok(Expression::Word(word));
        }
        if let Some(field) = field(name) {
            let message = format!("`{}` has to be compared with something, as in {}", field.name, field.example);
            return Err(self.error_here(message));
        }
        if name.eq_ignore_ascii_case("has") {
            return Err(self.error_here("`has` needs a question in parentheses, as in has(tir)"));
        }
        let known = terms().map(|term| term.name);
        Err(self.error_here(format!("there is no word `{name}`")).near(name, known))
    }

    fn comparison(&mut self, name: &str, sign: Sign) -> Result<Expression, QueryError> {
        let Some(field) = field(name) else {
            if let Some(word) = word(name) {
                self.next += 1;
                return Err(self.error_here(format!("`{}` stands alone; it has no value to compare", word.name)));
            }
            let known = terms().filter(|term| term.is_field()).map(|term| term.name);
            return Err(self.error_here(format!("there is no field `{name}`")).near(name, known));
        };
        self.next += 1;
        if matches!(field.test, Test::Names(..)) && !sign.is_of_sameness() {
            let message = format!("`{}` is a name: compare it with `=` or `!=`", field.name);
            return Err(self.error_here(message));
        }
        self.next += 1;
        let place = Place(self.peek().map_or(self.end..self.end, |token| token.characters.clone()));
        let value = self.value(field)?;
        self.next += 1;
        Ok(Expression::Comparison(Comparison { field, sign, value, place }))
    }

    fn value(&self, field: &'static Term) -> Result<Value, QueryError> {
        let expected = || self.error_here(format!("expected {}, as in {}", field.expects(), field.example));
        let Some(TokenKind::Plain(text) | TokenKind::Quoted(text)) = self.peek().map(|token| &token.kind) else {
            return Err(expected());
        };
        let Test::Names(_, names) = field.test else {
            return number(text).map(Value::Number).ok_or_else(expected);
        };
        let is_quoted = self.peek().is_some_and(|token| matches!(token.kind, TokenKind::Quoted(_)));
        let pattern = if is_quoted { Pattern::quoted(text) } else { Pattern::plain(text) };
        if let Names::Listed(known) = names
            && !known().iter().any(|name| pattern.matches(name))
        {
            let list = known().join(", ");
            let message = format!("`{}` is none of the values of `{}`: {list}", text, field.name);
            return Err(self.error_here(message).near(text, known().iter().copied()));
        }
        Ok(Value::Name(pattern))
    }
}

/// A finite number; a minus may be written as in texts.
fn number(text: &str) -> Option<f64> {
    text.replace('−', "-").parse::<f64>().ok().filter(|number| number.is_finite())
}
