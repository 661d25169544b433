//! Finding words and matching brackets.

use super::syntax::Syntax;
use std::ops::Range;

/// Where a text stands in another, capitals and small letters alike; none for an empty one.
#[must_use]
pub fn find_all(text: &str, wanted: &str) -> Vec<Range<usize>> {
    let wanted: Vec<char> = wanted.chars().flat_map(char::to_lowercase).collect();
    if wanted.is_empty() {
        return Vec::new();
    }
    let mut found: Vec<Range<usize>> = Vec::new();
    for (start, _) in text.char_indices() {
        if found.last().is_some_and(|last| start < last.end) {
            continue;
        }
        if let Some(length) = begins_with(&text[start..], &wanted) {
            found.push(start..start + length);
        }
    }
    found
}

/// How many bytes of the text are the wanted letters; none if it does not begin with them.
fn begins_with(text: &str, wanted: &[char]) -> Option<usize> {
    let mut letters =
        text.char_indices().flat_map(|(at, c)| c.to_lowercase().map(move |small| (at + c.len_utf8(), small)));
    let mut end = 0;
    for wanted in wanted {
        let (behind, letter) = letters.next()?;
        if letter != *wanted {
            return None;
        }
        end = behind;
    }
    Some(end)
}

/// The bracket at or before the cursor and the one that belongs to it; none where there is no such pair.
#[must_use]
pub fn bracket_pair(text: &str, syntax: &Syntax, offset: usize) -> Option<[usize; 2]> {
    let is_bracket = |at: &usize| text.as_bytes().get(*at).is_some_and(|byte| b"{}[]".contains(byte));
    [Some(offset), offset.checked_sub(1)].into_iter().flatten().filter(is_bracket).find_map(|at| {
        let is_own = |range: &Range<usize>| range.start == at || range.end == at + 1;
        let pair = syntax
            .nodes
            .iter()
            .find(|node| node.closed && node.range.len() > 1 && is_own(&node.range) && is_bracket(&node.range.start))?;
        Some([pair.range.start, pair.range.end - 1])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_whatever_their_capitals_and_not_over_each_other() {
        assert_eq!(find_all("Aaaa ÄÖ äö", "aa"), [0..2, 2..4]);
        assert_eq!(find_all("Aaaa ÄÖ äö", "äö"), [5..9, 10..14]);
        assert!(find_all("abc", "").is_empty());
    }

    #[test]
    fn a_bracket_belongs_to_the_one_that_closes_it() {
        let text = "{ \"a\": [1, \"]\"] }";
        let syntax = Syntax::of(text);
        assert_eq!(bracket_pair(text, &syntax, 0), Some([0, 16]));
        assert_eq!(bracket_pair(text, &syntax, 15), Some([7, 14]));
        assert_eq!(bracket_pair(text, &syntax, 12), None, "a bracket within quotes is a letter");
    }
}
