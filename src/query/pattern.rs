//! Names with wildcards: `glass*` is any name that begins with `glass`, in capitals or not.

use std::fmt;

/// A name in which `*` stands for anything.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pattern {
    pieces: Vec<Piece>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Piece {
    Exactly(char),
    Anything,
}

impl Pattern {
    /// A pattern in which `*` stands for anything.
    pub fn plain(text: &str) -> Self {
        Self { pieces: text.chars().map(|c| if c == '*' { Piece::Anything } else { Piece::Exactly(c) }).collect() }
    }

    /// This name and no other.
    pub fn exactly(name: &str) -> Self {
        Self { pieces: name.chars().map(Piece::Exactly).collect() }
    }

    /// What stood between quotation marks: likewise, but `\` makes the next character stand for itself.
    pub fn quoted(text: &str) -> Self {
        let (mut pieces, mut characters) = (Vec::new(), text.chars());
        while let Some(character) = characters.next() {
            pieces.push(match character {
                '*' => Piece::Anything,
                '\\' => Piece::Exactly(characters.next().unwrap_or('\\')),
                other => Piece::Exactly(other),
            });
        }
        Self { pieces }
    }

    /// Whether the name is one of those that are meant.
    pub fn matches(&self, name: &str) -> bool {
        let name: smallvec::SmallVec<[char; 32]> = name.chars().collect();
        // Goes on greedily and comes back to the last `*`, which then takes one character more.
        let (mut at, mut place, mut back) = (0, 0, None);
        loop {
            match self.pieces.get(place) {
                Some(Piece::Anything) => {
                    place += 1;
                    back = Some((place, at));
                }
                Some(Piece::Exactly(c)) if name.get(at).is_some_and(|other| same(*c, *other)) => {
                    (place, at) = (place + 1, at + 1);
                }
                None if at == name.len() => return true,
                _ => match back {
                    Some((after, from)) if from < name.len() => {
                        back = Some((after, from + 1));
                        (place, at) = (after, from + 1);
                    }
                    _ => return false,
                },
            }
        }
    }
}

fn same(a: char, b: char) -> bool {
    a == b || a.to_lowercase().eq(b.to_lowercase())
}

/// Whether a character may stand in a name without quotation marks.
pub(super) fn is_plain(character: char) -> bool {
    !character.is_whitespace() && !character.is_control() && !"&|!()=<>\"\\≤≥≠¬∧∨".contains(character)
}

/// Words that would be read as something else where a name is expected.
fn is_taken(text: &str) -> bool {
    ["and", "or", "not"].iter().any(|word| text.eq_ignore_ascii_case(word))
}

/// In quotation marks only where it needs them.
impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain: String =
            self.pieces.iter().map(|piece| if let Piece::Exactly(c) = piece { *c } else { '*' }).collect();
        let is_itself = self.pieces.iter().all(|piece| *piece != Piece::Exactly('*'));
        if is_itself && !plain.is_empty() && plain.chars().all(is_plain) && !is_taken(&plain) {
            return f.write_str(&plain);
        }
        f.write_str("\"")?;
        for piece in &self.pieces {
            match piece {
                Piece::Anything => f.write_str("*")?,
                Piece::Exactly(c @ ('*' | '"' | '\\')) => write!(f, "\\{c}")?,
                Piece::Exactly(c) => write!(f, "{c}")?,
            }
        }
        f.write_str("\"")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_anything_and_nothing() {
        for (pattern, name, expected) in [
            ("glass*", "glass ball", true),
            ("glass*", "glass", true),
            ("glass*", "a glass", false),
            ("*ball", "glass ball", true),
            ("*a*b*", "xxaxxabx", true),
            ("a*b*c", "abcbc", true),
            ("a*b*c", "abcb", false),
            ("*", "", true),
            ("", "", true),
            ("", "x", false),
            ("LENS", "lens", true),
            ("näpf", "NÄPF", true),
        ] {
            assert_eq!(Pattern::plain(pattern).matches(name), expected, "{pattern} and {name}");
        }
    }

    #[test]
    fn a_backslash_makes_a_star_stand_for_itself() {
        assert!(Pattern::quoted(r"a\*").matches("a*") && !Pattern::quoted(r"a\*").matches("ab"));
        assert_eq!(Pattern::quoted(r"a\*").to_string(), r#""a\*""#);
        assert_eq!(Pattern::quoted("two words").to_string(), "\"two words\"");
        assert_eq!(Pattern::quoted("plain").to_string(), "plain");
        assert_eq!(Pattern::quoted("or").to_string(), "\"or\"");
    }
}
