//! What is wrong with a question, and where.

use std::fmt;

/// A place in a question that could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QueryError {
    /// The column, in characters counted from 1.
    pub column: usize,
    /// How many characters it is about, at least 1.
    pub length: usize,
    /// What is wrong, and what was expected.
    pub message: String,
    /// The nearest word that there is.
    pub nearest: Option<String>,
}

/// Words less alike than this are no help.
const LEAST_LIKENESS: f64 = 0.6;

impl QueryError {
    pub(super) fn new(column: usize, length: usize, message: impl Into<String>) -> Self {
        Self { column, length: length.max(1), message: message.into(), nearest: None }
    }

    /// Adds the word of a list that is most like the one that was read.
    pub(super) fn near<'a>(mut self, read: &str, known: impl Iterator<Item = &'a str>) -> Self {
        self.nearest = nearest(read, known);
        self
    }
}

/// The word of a list that is most like `read`, if any is; of several the first.
pub(super) fn nearest<'a>(read: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    let read = read.to_lowercase();
    let mut best: Option<(f64, &str)> = None;
    for word in known {
        let likeness = strsim::normalized_damerau_levenshtein(&read, &word.to_lowercase());
        if likeness > LEAST_LIKENESS && best.is_none_or(|(most, _)| likeness > most) {
            best = Some((likeness, word));
        }
    }
    best.map(|(_, word)| word.to_owned())
}

impl fmt::Display for QueryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "column {}: {}", self.column, self.message)?;
        match &self.nearest {
            Some(word) => write!(f, "; did you mean `{word}`?"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for QueryError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_word_is_named_and_a_far_one_is_not() {
        let known = || ["tir", "hit", "rejected"].into_iter();
        let error = QueryError::new(3, 3, "there is no word `tri`").near("tri", known());
        assert_eq!(error.to_string(), "column 3: there is no word `tri`; did you mean `tir`?");
        assert_eq!(nearest("Rejcted", known()), Some("rejected".to_owned()));
        assert_eq!(nearest("zzz", known()), None);
    }
}
