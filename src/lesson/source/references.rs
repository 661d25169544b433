//! `{{expression:format}}`: found before Markdown is read, because the signs in them mean something else there.
//!
//! Each is replaced by one private character and as many others as keep every byte of the text in its place.

use crate::lesson::expression::{Expression, Format};
use crate::lesson::place::Findings;
use crate::lesson::prose::Reference;

/// The first of the private characters: the one of the first reference.
const FIRST: u32 = 0xE000;
/// How many there are: more references than any lesson has.
const MOST: u32 = 0x1900;
/// Fills the bytes that a reference has more than its character. Deleted again.
const FILLER: char = '\u{7f}';

/// A text without references, and the references.
#[derive(Debug)]
pub struct Masked {
    /// The text, as long as before.
    pub text: String,
    /// The references, in order; none where one could not be read.
    pub references: Vec<Option<Reference>>,
}

/// Takes the references out of a text. `base` is where it stands in the file.
pub fn mask(text: &str, base: usize, findings: &mut Findings) -> Masked {
    let mut masked = Masked { text: String::with_capacity(text.len()), references: Vec::new() };
    let mut rest = 0;
    while let Some(start) = text[rest..].find("{{").map(|at| rest + at) {
        masked.text.push_str(&text[rest..start]);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let Some(end) = text[start..line_end].find("}}").map(|at| start + at + 2) else {
            findings.add(base + start, "this `{{` has no `}}` on its line");
            masked.text.push_str(&text[start..start + 2]);
            rest = start + 2;
            continue;
        };
        let number = u32::try_from(masked.references.len()).unwrap_or(MOST);
        let character = char::from_u32(FIRST + number % MOST).unwrap_or(FILLER);
        masked.text.push(character);
        masked.text.extend(std::iter::repeat_n(FILLER, end - start - character.len_utf8()));
        masked.references.push(reference(&text[start + 2..end - 2], base + start, findings));
        rest = end;
    }
    masked.text.push_str(&text[rest..]);
    masked
}

fn reference(inner: &str, offset: usize, findings: &mut Findings) -> Option<Reference> {
    let (expression, format) = split(inner);
    let Some(format) = Format::parse(format) else {
        findings.add(offset, format!("`{format}` is no format: write digits, `.digits`, `°`, `%`, `words` or `full`"));
        return None;
    };
    match Expression::parse(expression.trim()) {
        Ok(expression) if !expression.refers() => {
            findings.add(offset, format!("`{inner}` is a typed number: say where it comes from"));
            None
        }
        Ok(expression) => Some(Reference { expression, format, place: findings.place(offset) }),
        Err(error) => {
            findings.add(offset + 2 + error.range.start, error.message);
            None
        }
    }
}

/// What is before and behind the last colon that is not in quotes.
fn split(inner: &str) -> (&str, &str) {
    let mut quote = None;
    let mut colon = None;
    for (at, c) in inner.char_indices() {
        match (quote, c) {
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if open == c => quote = None,
            (None, ':') => colon = Some(at),
            _ => {}
        }
    }
    colon.map_or((inner, ""), |at| (&inner[..at], &inner[at + 1..]))
}

impl Masked {
    /// A stretch of the masked text as texts and references: `Ok` a text, `Err` the number of a reference.
    pub fn pieces(stretch: &str) -> Vec<Result<String, usize>> {
        let mut pieces = Vec::new();
        let mut text = String::new();
        for c in stretch.chars().filter(|&c| c != FILLER) {
            let number = u32::from(c).wrapping_sub(FIRST);
            if number < MOST {
                if !text.is_empty() {
                    pieces.push(Ok(std::mem::take(&mut text)));
                }
                pieces.push(Err(number as usize));
            } else {
                text.push(c);
            }
        }
        if !text.is_empty() {
            pieces.push(Ok(text));
        }
        pieces
    }
}
