//! What is wrong with a scene's text, as ranges of the text: what is underlined in the editor.

use super::syntax::Syntax;
use crate::scene::Diagnostics;
use std::ops::Range;

/// Something wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flaw {
    /// Where, in bytes.
    pub range: Range<usize>,
    /// What is wrong and what to do.
    pub message: String,
    /// Line and column, counted from 1.
    pub at: [usize; 2],
}

/// The errors of the text that they were found in, in its order. Each covers the word that it begins at.
#[must_use]
pub fn flaws(text: &str, syntax: &Syntax, diagnostics: &Diagnostics) -> Vec<Flaw> {
    let flaw = |error: &crate::scene::Diagnostic| {
        let start = offset_of(text, error.line, error.column);
        let token = syntax.tokens.partition_point(|token| token.range.end <= start);
        let word = syntax.tokens.get(token).filter(|token| token.range.start <= start).map(|token| token.range.end);
        let message = std::iter::once(&error.message).chain(&error.help).cloned().collect::<Vec<_>>().join("; ");
        let next = text[start..].chars().next().map_or(start, |letter| start + letter.len_utf8());
        Flaw { range: start..word.unwrap_or(next), message, at: [error.line, error.column] }
    };
    diagnostics.errors.iter().map(flaw).collect()
}

/// Where line and column, counted from 1 in characters, stand in the text; its end where there is no such place.
fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let start = match line.saturating_sub(2) {
        _ if line <= 1 => 0,
        nth => text.match_indices('\n').nth(nth).map_or(text.len(), |(at, _)| at + 1),
    };
    let letters = text[start..].char_indices().map(|(at, _)| start + at);
    letters.chain([text.len()]).nth(column.saturating_sub(1)).unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;

    #[test]
    fn each_error_covers_the_word_that_is_wrong() {
        let text =
            "{ \"title\": \"é\",\n  \"objects\": [{ \"shape\": \"shpere\" }, { \"shape\": \"torus\", \"d\": -1 }] }";
        let found = flaws(text, &Syntax::of(text), &load(text, "x.json").unwrap_err());
        let words: Vec<_> = found.iter().map(|flaw| &text[flaw.range.clone()]).collect();
        assert!(words.contains(&"\"shpere\"") && words.contains(&"-1"), "{found:?}");
        assert!(found[0].message.contains("sphere") && found[0].at[0] == 2);
    }

    #[test]
    fn an_error_at_the_end_of_the_text_lies_at_its_end() {
        let text = "{ \"title\": ";
        let found = flaws(text, &Syntax::of(text), &load(text, "x.json").unwrap_err());
        assert!(found.iter().all(|flaw| flaw.range.end <= text.len()), "{found:?}");
    }
}
